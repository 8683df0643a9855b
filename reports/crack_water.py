"""The seed paper's 45 m crack: pressure along it while it opens, rests and closes, and the printed uplift beside ours."""
import json
from dataclasses import dataclass

from reports import figures, words
from reports.scenes import Scene
from reports.studies import LayoutError


@dataclass(frozen=True)
class Curve:
    name: str
    positions: list  # m from the upstream mouth
    pressures: list  # MPa


def _run(folder, name):
    path = folder / name / "summary.json"
    if not path.is_file():
        raise LayoutError(f"layout: crack_water: {path} is not there; ci/report makes it")
    run = json.loads(path.read_text(encoding="utf-8"))
    if run["status"] != "completed":
        raise LayoutError(f"layout: crack_water: {name}: {run['status']}")
    return run["quantities"]


def read(folder, layout):
    """The section of layout's [crack_water] as a list of one scene, from <run>/summary.json in `folder`; empty without."""
    wanted = layout.get("crack_water")
    if wanted is None:
        return []
    length, runs = wanted["length"], {entry["name"]: _run(folder, entry["run"]) for entry in wanted["curve"]}
    curves, rows, uplift = [], [], {}
    for entry in wanted["curve"]:
        name, found = entry["name"], runs[entry["name"]]
        pressures = found["pressure"]
        curves.append(Curve(name, [length * i / (len(pressures) - 1) for i in range(len(pressures))], [p / 1e6 for p in pressures]))
        uplift[name] = found["uplift_force"] / 1e6
        rows.append((f"uplift, {name}", f"{words.number(uplift[name], 6)} MN/m; printed {entry['printed']}"))
    for entry in wanted["ratio"]:
        ratio = 100 * uplift[entry["of"]] / uplift[entry["to"]]
        printed = f"; printed {entry['printed']}" if "printed" in entry else ""
        rows.append((f"{entry['of']} / {entry['to']}", f"{words.number(ratio, 3)} %{printed}"))
    figure = figures.pressure_along_crack("crack-water-pressure", curves, wanted["caption"])
    return [Scene(wanted["title"], wanted["words"], figure.svg, wanted["caption"], rows)]
