"""The chapter "Koyna": the seed paper's section 5 beside ours, what each open choice moves, and the energy account."""
import bisect
import csv
import json
import pathlib
import tomllib
from dataclasses import dataclass

from reports import koyna_figures, koyna_slider, scenes, words
from reports.koyna_runs import SCENES, change_name
from reports.studies import LayoutError

DATA = pathlib.Path(__file__).parent.parent / "reference-data"

# What the table of printed numbers may hold: column of the history, unit, factor from SI.
QUANTITIES = {
    "crack_length": ("crack length", "m", 1.0), "uplift_force": ("uplift", "kN/m", 1e-3),
    "mouth_pressure": ("pressure at the mouth", "kPa", 1e-3), "wet_length": ("length under pressure", "m", 1.0),
}

# Works of the account with their sign; what they sum up to is stored in the body.
WORKS = (("ground shaking", "input_energy", 1), ("standing water and weight", "load_energy", 1), ("water in the crack", "water_energy", 1),
         ("contact", "contact_energy", 1), ("growth", "growth_energy", 1), ("damping", "damped_energy", -1), ("waves in the water", "radiated_energy", -1))
STORED = ("kinetic_energy", "strain_energy")


@dataclass(frozen=True)
class Run:
    name: str
    status: str
    quantities: dict
    history: dict   # column without its unit -> values

    def at(self, column, time):
        """The value at the step nearest to `time`; None where the run did not come so far."""
        times = self.history["time"]
        if time > times[-1] + 1e-9:
            return None
        i = bisect.bisect_left(times, time)
        near = min(range(max(0, i - 1), min(len(times), i + 2)), key=lambda k: abs(times[k] - time))
        return self.history[column][near]

    def column(self, name, scale=1.0):
        return [scale * v for v in self.history[name]]


def read_run(folder, name):
    summary, history = folder / name / "summary.json", folder / name / "history.csv"
    for path in (summary, history):
        if not path.is_file():
            raise LayoutError(f"layout: koyna: {path} is not there; reports.koyna_runs makes it")
    found = json.loads(summary.read_text(encoding="utf-8"))
    with history.open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    if not rows:
        raise LayoutError(f"layout: koyna: {history} holds no step")
    columns = [[float(v) for v in column] for column in zip(*rows)]
    return Run(name, found["status"], found["quantities"], {h.split(" [")[0]: c for h, c in zip(head, columns)})


def _table(path):
    """Rows of a CSV file of reference-data, its comments left away."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def _metres(value):
    return "–" if value is None else f"{value:.1f}"


def _whole(value):
    return "–" if value is None else f"{value:.0f}".replace("-", "−")


def _printed(wanted, runs, independent):
    """Every printed number, ours, the difference and the other program's."""
    rows = []
    for entry in wanted["printed"]:
        name, unit, scale = QUANTITIES[entry["quantity"]]
        value = runs[entry["model"]].at(entry["quantity"], entry["time"])
        if value is None:
            raise LayoutError(f"layout: koyna: model {entry['model']} did not reach {entry['time']} s")
        value *= scale
        written = _metres if unit == "m" else _whole
        other = independent[str(entry["model"])][entry["independent"]] if "independent" in entry else ""
        rows.append({"what": f"{name}, model {entry['model']}, {entry['time']:g} s", "unit": unit, "printed": written(entry["printed"]),
                     "ours": written(value), "difference": f"{100 * (value / entry['printed'] - 1):+.0f} %".replace("-", "−"),
                     "independent": other or "–", "why": entry["why"]})
    return rows


def _directions(runs, times):
    """What the paper concludes, as sentences that can be true or not."""
    one, two, three = (runs[m] for m in (1, 2, 3))
    end = {m: runs[m].history["crack_length"][-1] for m in (1, 2, 3)}
    overlap = {m: max(runs[m].history["penetration"]) for m in (1, 2, 3)}
    grows = {m: runs[m].at("crack_length", times[1]) > runs[m].at("crack_length", times[0]) + 1e-6 for m in (2, 3)}
    share = [three.at("uplift_force", t) / two.at("uplift_force", t) for t in times]
    return [
        {"words": "contact stops penetration; without it the faces overlap", "holds": overlap[1] > 1e-3 and max(overlap[2], overlap[3]) <= 1e-4,
         "found": f"largest overlap {words.number(1e3 * overlap[1], 3)}, {words.number(1e3 * overlap[2], 2)} and {words.number(1e3 * overlap[3], 2)} mm in models 1, 2 and 3"},
        {"words": "model 1 ends shortest", "holds": end[1] < min(end[2], end[3]),
         "found": f"{_metres(end[1])}, {_metres(end[2])} and {_metres(end[3])} m at the end"},
        {"words": "model 2 ends slightly longer than model 3", "holds": 0 < end[2] - end[3] < 3, "found": f"{_metres(end[2])} and {_metres(end[3])} m"},
        {"words": f"at {times[0]:g} s moving water presses less than uniform water", "holds": share[0] < 1, "found": f"{words.number(100 * share[0], 2)} % of model 2; printed 53 %"},
        {"words": f"at {times[1]:g} s it presses more", "holds": share[1] > 1, "found": f"{words.number(100 * share[1], 2)} % of model 2; printed 391 %"},
        {"words": "between the two times model 3 grows", "holds": grows[3], "found": f"from {_metres(three.at('crack_length', times[0]))} to {_metres(three.at('crack_length', times[1]))} m"},
        {"words": "between the two times model 2 grows, by 4.5 m", "holds": grows[2], "found": f"from {_metres(two.at('crack_length', times[0]))} to {_metres(two.at('crack_length', times[1]))} m"},
        {"words": "model 1 follows the others to 4.05 s", "holds": abs(one.at("crack_length", times[0]) - two.at("crack_length", times[0])) <= 0.5,
         "found": f"{_metres(one.at('crack_length', times[0]))} m; model 2 {_metres(two.at('crack_length', times[0]))} m, model 3 {_metres(three.at('crack_length', times[0]))} m"},
    ]


def _ending(run):
    """How a run ended that did not shake to its end; empty for one that did."""
    if run.status != "completed":
        return f"{run.status}, at {run.history['time'][-1]:.2f} s"
    cut = next((e for e in run.quantities.get("events", []) if e["event"] == "cut through"), None)
    return f"the crack cut the dam through at {cut['time']:.2f} s" if cut else ""


def _sensitivity(folder, wanted, runs, growth, level):
    """Each change in models 2 and 3: lengths, the other program's where it has them, uplifts and largest overlap."""
    early, late = wanted["times"]

    def cells(run, model, case):
        lengths = [run.at("crack_length", t) for t in (early, late)] + [run.history["crack_length"][-1]]
        uplifts = [run.at("uplift_force", t) for t in (early, late)]
        other = growth.get((case, str(model)))
        return {"model": model, "lengths": [_metres(v) for v in lengths],
                "other": f"{other['length_4.05']} / {other['length_4.45']}" if other else "–",
                "uplifts": [_whole(None if v is None else v / 1e3) for v in uplifts],
                "largest": _whole(max(run.history["uplift_force"]) / 1e3), "penetration": words.number(1e3 * max(run.column("penetration")), 2),
                "ending": _ending(run)}
    rows = [{"words": "as in the scenes", "runs": [cells(runs[m], m, level) for m in (2, 3)]}]
    for change in wanted["change"]:
        rows.append({"words": change["words"], "runs": [cells(read_run(folder, change_name(m, change)), m, change["name"])
                                                        for m in change.get("models", (2, 3))]})
    return rows


def _stationary(folder, wanted, data):
    known = {row["case"]: row for row in _table(data / "independent-koyna-2026/stationary.csv")}
    rows = []
    for case in wanted["stationary"]["case"]:
        run, other = read_run(folder, f"stationary-{case['name']}"), known[case["name"]]
        if run.status != "completed":
            raise LayoutError(f"layout: koyna: stationary-{case['name']}: {run.status}")
        intensity = run.column("K_I", 1e-6)
        first = next((t for t, k in zip(run.history["time"], intensity) if k >= 2), None)
        largest = float(other["largest_K_I"])
        rows.append({"words": case["words"], "largest": words.number(max(intensity), 3), "other": other["largest_K_I"],
                     "difference": f"{round(100 * (max(intensity) / largest - 1), 1) + 0.0:+.1f} %".replace("-", "−"),
                     "smallest": words.number(min(intensity), 3), "other_smallest": other["smallest_K_I"].replace("-", "−") or "–",
                     "first": "never" if first is None else f"{first:.2f}", "other_first": other["first_at_2"]})
    return rows


def account(run):
    """(times, works [MJ/m], stored [MJ/m], largest difference of stored and the sum of works over the largest work)."""
    works = [(name, run.column(column, sign * 1e-6)) for name, column, sign in WORKS if column in run.history and any(run.history[column])]
    stored = [sum(v) for v in zip(*(run.column(c, 1e-6) for c in STORED))]
    stored = [v - stored[0] for v in stored]
    left = max(abs(sum(all_) - s) for *all_, s in zip(*(v for _, v in works), stored))
    return run.history["time"], works, stored, left / max(max(map(abs, v)) for _, v in works)


def _record(data, name):
    rows = _table(data / f"ground-motions/koyna-1967/{name}.csv")
    return name, [float(r["time [s]"]) for r in rows], [float(r["acceleration [m/s2]"]) for r in rows]


def _profiles(runs, wanted):
    """The pressures of models 2 and 3 at the paper's times."""
    names = {m["number"]: m["name"] for m in wanted["model"]}
    found = []
    for time in wanted["times"]:
        curves = []
        for model in (2, 3):
            profile = next((p for p in runs[model].quantities.get("profiles", []) if abs(p["time"] - time) < 1e-6 and p["crack"] == 0), None)
            if profile is None:
                raise LayoutError(f"layout: koyna: model {model} has no profile at {time:g} s")
            curves.append((names[model], model - 1, profile["position"], [p / 1e3 for p in profile["pressure"]]))
        found.append((time, curves))
    return found


def _figures(runs, wanted, section, data):
    named = [(m["name"], runs[m["number"]]) for m in wanted["model"]]
    outline = [tuple(p) for p in section["geometry"]["outline"]]
    mouth = [tuple(p) for p in section["crack"][0]["path"]]
    paths = [(name, mouth + [tuple(p) for p in run.quantities["crack_path"] if tuple(p) not in mouth]) for name, run in named]
    printed = [(e["model"] - 1, e["time"], e["printed"]) for e in wanted["printed"] if e["quantity"] == "crack_length"]
    times, works, stored, left = account(runs[3])
    early, late = wanted["times"]
    lengths = [(n, r.history["time"], r.history["crack_length"]) for n, r in named]
    return {
        "first": koyna_figures.lengths("first-koyna", lengths, printed,
                                       "Koyna dam, earthquake of 1967: length of the crack in the three models, and the lengths that the seed paper prints"),
        "record": koyna_figures.ground_motion("koyna-record", [_record(data, n) for n in ("horizontal", "vertical")],
                                              "The record of 11 December 1967 (the paper's figure 4); the scenes reverse the horizontal component"),
        "opening": koyna_figures.mouth_opening("koyna-opening", [(n, r.history["time"], r.column("crack_mouth_opening", 1e3)) for n, r in named],
                                               "Opening of the crack's mouth (figure 5); below, the range of the models with contact. Below 0 the faces overlap"),
        "paths": koyna_figures.crack_paths("koyna-paths", outline, paths, "Where the cracks went (figure 6), on the section and by themselves"),
        "lengths": koyna_figures.lengths("koyna-lengths", lengths, printed,
                                         "Length of the cracks, and the lengths that the paper prints"),
        "pressures": koyna_figures.pressures("koyna-pressures", _profiles(runs, wanted),
                                             f"Pressure of the water along the crack at {early:g} s and {late:g} s (figure 7)"),
        "energy": koyna_figures.energy("koyna-energy", times, works, stored,
                                       f"Energy account of model 3 through all growth: the sum of all works and what is stored differ by at most {words.error(left)} of the largest work"),
    }


def read(folder, layout, data=DATA, scene_folder=SCENES):
    """The chapter of layout's [koyna] for the template, from the runs in `folder`; None without."""
    wanted = layout.get("koyna")
    if wanted is None:
        return None
    runs = {m["number"]: read_run(folder, m["run"]) for m in wanted["model"]}
    for run in runs.values():
        if run.status != "completed":
            raise LayoutError(f"layout: koyna: {run.name}: {run.status}")
    picture = folder / "mesh.svg"
    if not picture.is_file():
        raise LayoutError(f"layout: koyna: {picture} is not there; ci/report makes it")
    section = tomllib.loads((scene_folder / f"{wanted['scene']}.scene.toml").read_text(encoding="utf-8"))
    level = f"level-{section['reservoir']['level']:g}"
    growth = {(row["case"], row["model"]): row for row in _table(data / "independent-koyna-2026/growth.csv")}
    independent = {model: row for (case, model), row in growth.items() if case == level}
    filmed = runs[wanted["film"]["model"]]
    return {
        "title": wanted["title"], "words": wanted["words"], "mesh": scenes.mesh_picture(picture.read_text(encoding="utf-8"), picture.name),
        "figures": _figures(runs, wanted, section, data), "printed": _printed(wanted, runs, independent),
        "directions": _directions(runs, wanted["times"]), "sensitivity": _sensitivity(folder, wanted, runs, growth, level),
        "times": [f"{t:g} s" for t in wanted["times"]], "stationary": _stationary(folder, wanted, data),
        "film": koyna_slider.film(folder / filmed.name / "results.h5", filmed.quantities.get("profiles", []),
                                  lambda t: filmed.at("crack_length", t), wanted["film"]),
    }
