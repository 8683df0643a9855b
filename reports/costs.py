"""What the section "Costs" shows beside the benchmarks: instruction counts, their course, two cores, and what each part of a scene
costs. Each of them may be missing; then the page says so and names the command that makes it."""
from __future__ import annotations

import pathlib
import re
import tomllib

from reports import history, page, two_cores, words

ROOT = page.HERE.parent


def _count(value):
    return f"{value:,}".replace(",", "\u202f")


def counts(path):
    """Rows of the counts that benchmarks/counts/limits.toml holds; regions that nobody has counted yet are left out."""
    if not path.is_file():
        return []
    regions = tomllib.loads(path.read_text(encoding="utf-8")).get("region", [])
    return [{"name": r["name"].replace("-", " "), "instructions": _count(r["instructions"]), "allocations": _count(r["allocations"]),
             "peak": words.size(r["peak_bytes"]), "reason": r["reason"]} for r in regions if r["instructions"] > 0]


def ablation(path):
    """The table that `sunder ablate` prints: a title, a line of headings, rows whose cells end below their heading, remarks."""
    title, _, rest = path.read_text(encoding="utf-8").partition("\n\n")
    table, _, remarks = rest.partition("\n\n")
    head, *rows = table.splitlines()
    ends = [m.end() for m in re.finditer(r"\S+(?: \S+)*", head)]
    ends[0] = max(len(re.match(r"\S*(?: \S+)*", row).group()) for row in [head, *rows])  # the first column stands to the left
    cells = [[line[begin:end].strip() for begin, end in zip([0, *ends], ends)] for line in [head, *rows]]
    return {"name": title.split(":")[0], "head": cells[0], "rows": cells[1:], "notes": [line for line in remarks.splitlines() if line]}


def _two_cores(path):
    profiles = two_cores.read(path)
    return {"figure": two_cores.phase_chart("two-cores", profiles, "Convolution and flux search on one and two threads, phase by phase"),
            "rows": [{"name": name, "phase": phase, "one": words.seconds(one), "two": words.seconds(two), "speed_up": words.factor(speed_up),
                      "efficiency": f"{100 * efficiency:.0f} %", "useful": f"{100 * min(useful, 1.0):.0f} %"}
                     for name, phase, one, two, speed_up, efficiency, useful in two_cores.rows(profiles)]}


def read(records, history_folder=ROOT / "benchmarks/history", limits=ROOT / "benchmarks/counts/limits.toml"):
    """The section for the template, from the folder of records and what the repository keeps."""
    course, cores = history.read(history_folder / "counts.jsonl"), records / "benchmarks/two_cores_benchmark.json"
    found = {
        "counts": counts(limits),
        "trend": history.trend("cost-trend", course, "counts", "instructions", "Instructions of each marked region over the commits, of the first record") if course else None,
        "steps": [f"{name}: {words.factor(factor)} from {before} to {commit}" for name, before, commit, factor in history.steps(course, "counts", "instructions")],
        "two_cores": _two_cores(cores) if cores.is_file() else None,
        "ablations": [ablation(path) for path in sorted((records / "ablation").glob("*.txt"))],
    }
    missing = (("counts", "counted instructions", "ci/counts --update"), ("trend", "a history of counts", "ci/history append"),
               ("two_cores", "the profile on two cores", "ci/benchmark"), ("ablations", "what each part of a scene costs", "ci/report"))
    found["missing"] = [f"{what}: {command} makes it" for key, what, command in missing if not found[key]]
    return found
