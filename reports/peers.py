"""Other programs on the same problems: the records of benchmarks/peers, drawn whether the programs are installed or not."""
from __future__ import annotations

import json
import pathlib

from reports import figures, words
from reports.front import LEVELS, Point, dominance_front, time_to
from reports.studies import LayoutError

FOLDER = pathlib.Path(__file__).parent.parent / "benchmarks/peers/records"


def _points(record, where):
    """Name of a program -> its points; orders and meshes of one program are settings of it."""
    found = {}
    for row in record["rows"]:
        name = row["series"].split(", order")[0]
        seconds = row["cpu_seconds"] + row["mesh_seconds"]
        if not seconds > 0 or not row["error"] >= 0:
            raise LayoutError(f"{where}: {row['series']}, {row['setting']}: no time or no error")
        found.setdefault(name, []).append(Point(seconds, row["error"], name, f"{row['series'].partition(', ')[2]}; {row['setting']}".strip("; ")))
    return found


def _problem(record, where):
    points = _points(record, where)
    rows = [{"program": name, "count": len(own), "best": words.error(min(p.error for p in own)),
             "times": [words.seconds(t.seconds) if t else "not reached" for t in (time_to(own, level) for level, _ in LEVELS)]}
            for name, own in points.items()]
    caption = f"{record['title']}: error of {record['quantity']}; each curve is the front of one program, its other settings are pale"
    return {"title": record["title"], "rows": rows, "levels": [w for _, w in LEVELS],
            "figure": figures.peers(f"peers-{record['problem']}", {n: (dominance_front(p), p) for n, p in points.items()}, record["quantity"], caption),
            "failed": [f"{f['series']} ({f['setting']})" for f in record.get("failed", [])]}


def read(folder=FOLDER):
    """The section for the template, from every <problem>.json in `folder`."""
    found = sorted(folder.glob("*.json"))
    if not found:
        raise LayoutError(f"{folder.name}: no record of other programs; ci/peers writes them")
    records = [json.loads(path.read_text(encoding="utf-8")) for path in found]
    versions = dict(item for r in records for item in r["versions"].items())
    return {"problems": [_problem(r, p.name) for r, p in zip(records, found)],
            "versions": ", ".join(f"{name} {version}" for name, version in versions.items()),
            "rounds": min(r["rounds"] for r in records), "machine": records[0]["machine"]}
