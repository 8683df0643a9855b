"""The problems of the chapter "Error against run time": sweeps of cases that ask the same of one problem in one figure, and the
reason where the program's default costs more than it may."""
from __future__ import annotations

from reports import studies, words
from reports.front import ACCEPTED_FACTOR, default_factor
from reports.studies import LayoutError


def _problem(wanted, cases, key):
    """Figure, sentences and times of one problem of the layout. The default is that of its first case."""
    named = []
    for entry in wanted["cases"]:
        case = next((c for c in cases if c.id == entry["case"]), None)
        if case is None:
            raise LayoutError(f"layout: problem {wanted['title']!r}: no record of the case {entry['case']!r}")
        if not case.sweep.error:
            raise LayoutError(f"layout: problem {wanted['title']!r}: {case.id} has no sweep with an error")
        named.append((entry.get("name", ""), case, entry.get("series")))
    points, failed = studies.joint_points(named)
    known = max(studies.known_to(case) for _, case, _ in named)
    shown = studies.describe(points, failed, wanted["quantity"], key, known)
    factor = default_factor(points, known)
    among = [p for p in points if any(p.series.startswith(name) for name in wanted["among"])] if "among" in wanted else []
    if among and factor is not None and factor > ACCEPTED_FACTOR:
        shown["words"] += f" Among {wanted['among_words']} alone it is {words.factor(default_factor(among, known))}."
    explained = wanted.get("explained", "")
    return {"title": wanted["title"], "cases": [case for _, case, _ in named], **shown, "lead": wanted.get("words", ""),
            "explained": explained if factor is not None and factor > ACCEPTED_FACTOR else "",
            "unexplained": factor is not None and factor > ACCEPTED_FACTOR and not explained}


def problems(layout, cases):
    return [_problem(wanted, cases, f"problem-{i}") for i, wanted in enumerate(layout.get("problem", []))]


def first(layout, cases):
    """The problem that the first screen shows."""
    wanted = layout.get("problem", [])
    if not wanted:
        raise LayoutError("layout: problem: there is none; the first screen would have no figure")
    return _problem(wanted[0], cases, "first-problem")
