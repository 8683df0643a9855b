"""The course of costs over the commits: benchmarks/history/*.jsonl (README.md there) -> figures and rows of a table."""
import json

import matplotlib.pyplot as plt

from reports.figures import MARKERS, SERIES, SIZE, SOFT, STYLE, Figure, FigureError, element, legend


def read(path):
    """The file's records in their order; [] where there is none yet."""
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def courses(records, kind, value):
    """{(name, machine): [(commit, number)]} of one kind of record, in the order of the file. Other machines, other curves."""
    found = {}
    for record in records:
        if record["kind"] == kind and value in record["values"]:
            found.setdefault((record["name"], record["machine"]), []).append((record["commit"], record["values"][value]))
    return found


def steps(records, kind, value, share=0.01):
    """[(name, commit before, commit, factor)] wherever a value moved by more than `share` from one record to the next."""
    moved = []
    for (name, _), course in courses(records, kind, value).items():
        for (before, a), (commit, b) in zip(course, course[1:]):
            if a > 0 and abs(b / a - 1.0) > share:
                moved.append((name, before, commit, b / a))
    return moved


def trend(key, records, kind, value, caption):
    """Every course relative to its first record, over the commits in the order in which the file first names them."""
    found = courses(records, kind, value)
    commits = list(dict.fromkeys(record["commit"] for record in records if record["kind"] == kind))
    if not found:
        raise FigureError(f"{key}: no record of kind {kind} with a value {value}")
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=SIZE, layout="constrained")
        axes.axhline(1.0, color=SOFT, linewidth=0.6)
        for i, ((name, _), course) in enumerate(sorted(found.items())):
            first = course[0][1]
            if not first > 0:
                raise FigureError(f"{key}: the first {value} of {name} is {first}")
            axes.plot([commits.index(commit) for commit, _ in course], [number / first for _, number in course],
                      label=name, color=SERIES[i % len(SERIES)], marker=MARKERS[(i + i // len(SERIES)) % len(MARKERS)])
        axes.set_xticks(range(len(commits)), [commit[:7] for commit in commits], rotation=90 if len(commits) > 6 else 0)
        axes.set_xlim(-0.5, len(commits) - 0.5)
        axes.set_ylabel(f"{value.replace('_', ' ')}, of the first record")
        legend(axes, 2)
        return Figure(key, element(figure, key, caption), caption)
