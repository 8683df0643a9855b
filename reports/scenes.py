"""Scenes of the main job: the mesh as the program draws it, and what the run found."""
import json
import re
from dataclasses import dataclass

from reports import words
from reports.studies import LayoutError

# The picture's own colours, by those of the page: it follows light and dark like the figures.
COLOURS = {"#fff": "paper", "#f4f4f4": "raised", "#555": "soft", "#999": "soft", "#000": "ink", "black": "ink", "#0072b2": "s1", "#d55e00": "s2",
           "#009e73": "s3", "#cc79a7": "s4", "#e69f00": "s5", "#56b4e9": "s6"}


@dataclass(frozen=True)
class Scene:
    title: str
    words: str
    picture: str   # an <svg> element
    caption: str
    rows: list     # (quantity, value)


def mesh_picture(text, where):
    svg = text[text.index("<svg"):] if "<svg" in text else ""
    if not re.search(r"<path|<polygon|<line", svg):
        raise LayoutError(f"{where}: draws nothing")
    svg = re.sub(r'<svg [^>]*?(viewBox="[^"]*")[^>]*>', r'<svg \1 class="figure mesh" role="img" fill="var(--ink)">', svg, count=1)
    for attribute in ("fill", "stroke"):
        svg = re.sub(rf'\b{attribute}="([^"]+)"', lambda m: f'{attribute}="var(--{COLOURS[m[1]]})"' if m[1] in COLOURS else m[0], svg)
    return svg


def read(folder, layout):
    """The scenes that the layout names, from <name>.svg and <name>/summary.json in `folder`."""
    found = []
    for wanted in layout.get("scene", []):
        picture, summary = folder / f"{wanted['name']}.svg", folder / wanted["name"] / "summary.json"
        for path in (picture, summary):
            if not path.is_file():
                raise LayoutError(f"layout: scene {wanted['name']}: {path} is not there; ci/report makes it")
        run = json.loads(summary.read_text(encoding="utf-8"))
        if run["status"] != "completed":
            raise LayoutError(f"layout: scene {wanted['name']}: {run['status']}")
        rows = [("polygons", str(run["mesh"]["polygons"])), ("nodes", str(run["mesh"]["nodes"]))]
        for shown in wanted["quantities"]:
            value = run["quantities"]
            for step in re.findall(r"\w+", shown["path"]):
                value = value[int(step)] if isinstance(value, list) else value[step]
            rows.append((shown["words"], f"{words.number(value, shown.get('digits', 4))} {shown.get('unit', '')}".strip()))
        found.append(Scene(wanted["title"], wanted["words"], mesh_picture(picture.read_text(encoding="utf-8"), picture.name),
                           wanted["caption"], rows))
    return found
