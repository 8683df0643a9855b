"""Sweeps, ladders and benchmarks: their figures, and what the figures say in words and tables."""
from __future__ import annotations

import itertools
import math
import re
from dataclasses import replace

from reports import figures, words
from reports.front import ACCEPTED_FACTOR, LEVELS, Point, default_factor, dominance_front, time_to


# A rung that ends like this was declined: right, where the case accepts the words.
DECLINED = ("refused", "not converged")


class LayoutError(ValueError):
    """The layout names a case, a check or a benchmark that the records do not hold."""


def _series(case, telling=None):
    """The name of each setting's curve: the values of the keys that tell curves apart. Curves of a single point are joined
    with those that share their first key, since a line says more than its points in eight colours."""
    telling = case.sweep.series if telling is None else telling
    names = [words.setting((k, v) for k, v in s.keys if k in telling) for s in case.settings]
    first = [words.setting((k, v) for k, v in s.keys if k in telling[:1]) for s in case.settings]
    return [joint if names.count(name) == 1 else name for name, joint in zip(names, first)]


def points_of(case, telling=None):
    """(points with an error and a time, CPU times of the settings that gave no answer). `telling`: the keys that tell curves
    apart, instead of the case's own."""
    points, failed = [], []
    for s, series in zip(case.settings, _series(case, telling)):
        error = s.errors.get(case.sweep.error, math.nan)
        if s.status == "pass" and not math.isnan(error) and s.cpu_seconds > 0:
            points.append(Point(s.cpu_seconds, error, series, words.setting(s.keys), s.standard))
        elif s.cpu_seconds > 0:
            failed.append(s.cpu_seconds)
    return points, failed


def known_to(case):
    """The relative uncertainty of the reference of the check whose error a case's sweep shows; 0 where it is exact or a law."""
    check = next((c for c in case.checks if c.name == case.sweep.error), None)
    reference = next((r for r in case.references if check and r.name == check.reference_name), None)
    if reference is None or not reference.uncertainty > 0:
        return 0.0
    if reference.relative:
        return reference.uncertainty
    return reference.uncertainty / abs(check.reference) if abs(check.reference) > 0 else 0.0


def describe(points, failed, quantity, key, known=0.0):
    """Figure, sentence and times of the settings of one problem whose answer is known to `known`."""
    figure = figures.error_against_time(key, points, failed, quantity)
    front = dominance_front(points)
    factor = default_factor(points, known)
    best = front[-1]
    text = f"The smallest error is {words.error(best.error)}, in {words.seconds(best.seconds)} ({best.label})."
    if factor is None:
        text += " No setting of this sweep is the program's default."
    else:
        default = next(p for p in points if p.standard)
        text += (f" The default ({default.label}) reaches {words.error(default.error)} in {words.seconds(default.seconds)}: "
                 + ("it is on the front." if factor <= 1.0 + 1e-12 else
                    f"{words.factor(factor)} the time of the fastest setting that is as good"
                    + ("." if factor <= ACCEPTED_FACTOR else f", more than the {ACCEPTED_FACTOR:g} × that a default may cost unexplained.")))
    if failed:
        text += f" {words.count(len(failed), 'setting')} gave no answer."
    if best.error < known:
        text += f" The reference is known to {words.error(known)}: errors below that say no more."
    times = [time_to(points, level) for level, _ in LEVELS]
    return {"figure": figure, "words": text, "best": f"{words.error(best.error)} in {words.seconds(best.seconds)} ({best.label})",
            "factor": "no default" if factor is None else words.factor(factor),
            "times": [{"seconds": words.seconds(t.seconds) if t else "not reached", "setting": t.label if t else ""} for t in times]}


def sweep(case):
    """Figure, sentence and times of one case's sweep."""
    points, failed = points_of(case)
    return {"case": case, **describe(points, failed, case.sweep.error, f"sweep-{case.anchor}")}


def joint_points(named_cases):
    """Points and failed times of several cases that ask the same of one problem; `named_cases`: [(name, case, keys that tell
    its curves apart or None for its own)]. The default is that of the first."""
    joint, without_answer = [], []
    for i, (name, case, telling) in enumerate(named_cases):
        points, failed = points_of(case, telling)
        joint += [replace(p, standard=p.standard and i == 0, series=", ".join(filter(None, (name, p.series))),
                          label=", ".join(filter(None, (name, p.label)))) for p in points]
        without_answer += failed
    return joint, without_answer


def sweeps(cases):
    return [sweep(c) for c in cases if c.sweep.error and not c.ladder]


def convergence(case):
    """The figure behind the first order check of a case: the errors of its sweep over the size that is refined. None where
    the sweep keeps no error, or where fewer than two levels of a curve have one."""
    check = next((c for c in case.checks if c.kind == "order" and c.over), None)
    if check is None or not case.sweep.error:
        return None
    series = {}
    telling = [k for k in case.sweep.series if k != check.over]
    for s in case.settings:
        error, size = s.errors.get(case.sweep.error, math.nan), dict(s.keys).get(check.over)
        if s.status == "pass" and size is not None and error > 0:
            h = 1.0 / float(size) if check.over_counts else float(size)
            series.setdefault(words.setting([(k, v) for k, v in s.keys if k in telling]), []).append((h, error))
    series = {name: line for name, line in series.items() if len({h for h, _ in line}) > 1}
    if not series:
        return None
    over = words.key(check.over)
    return figures.convergence(f"order-{case.anchor}", series, case.sweep.error, f"1 / {over}" if check.over_counts else over)


LONGEST_LABEL = 12  # letters of a rung's label on an axis; with longer ones the rungs are numbered


def _climbing_key(case):
    """The key that makes the rungs harder: of those that do not tell curves apart, the one with the most values."""
    values = {}
    for s in case.settings:
        for key, value in s.keys:
            if key not in case.sweep.series:
                values.setdefault(key, set()).add(value)
    return max(values, key=lambda k: len(values[k]))


def _rungs(case, name):
    """(axis label, rungs) of a ladder with the errors of the check `name`."""
    key, check = _climbing_key(case), next((c for c in case.checks if c.name == name), None)
    labels = [words.written(dict(s.keys).get(key, "")) for s in case.settings]
    series = [words.setting((k, v) for k, v in s.keys if k in case.sweep.series) for s in case.settings]
    axis = words.key(key)
    in_order = len(list(itertools.groupby(labels))) == len(set(labels))
    if max(map(len, labels)) > LONGEST_LABEL or not in_order or len(set(labels)) < 3:
        axis, labels = "rung", [str(i + 1) for i in range(len(labels))]
    written = check.tolerances if check else ()
    tolerances = written * len(labels) if len(written) == 1 else written or (0.0,) * len(labels)
    declined_is_right = not any(c.kind == "ladder" and c.status in DECLINED for c in case.checks)
    rungs = []
    for s, label, curve, tolerance in zip(case.settings, labels, series, tolerances):
        error = s.errors.get(name, math.nan)
        outcome = ("declined" if declined_is_right else "wrong") if s.status in DECLINED else \
            "wrong" if s.status != "pass" or error > tolerance > 0 else "right"
        rungs.append(figures.Rung(label, error, tolerance, outcome, curve))
    return axis, rungs


def ladder(case):
    name = case.sweep.error or next((n for s in case.settings for n in s.errors), "")
    axis, rungs = _rungs(case, name)
    failing = case.ladder.first_failing
    climbed = [r.tolerance / r.error for r in rungs[:failing] if r.error > 0 and r.tolerance > 0]
    status = case.settings[failing].status if failing < len(rungs) else "pass"
    # Declined in words that the case does not accept is as bad as a wrong answer; the ladder's own check says so.
    declined = status in DECLINED and not any(c.kind == "ladder" and c.status in DECLINED for c in case.checks)
    shown = words.setting(case.settings[failing].keys) if failing < len(rungs) else ""
    return {
        "case": case, "key": words.key(_climbing_key(case)), "count": len(rungs),
        "failing": f"{shown}: {'wrong value' if status == 'pass' else status}" if failing < len(rungs) else "",
        "failing_is_wrong": failing < len(rungs) and not declined, "refused": sum(s.status in DECLINED for s in case.settings),
        "climbed": f"{failing} of {len(rungs)}", "slack": words.number(min(climbed), 2) if climbed else "–",
        # A ladder of laws alone keeps no error a rung; its checks stand in the case.
        "figure": figures.ladder(f"ladder-{case.anchor}", rungs, name, axis) if any(r.error >= 0 for r in rungs) else None,
    }


def ladders(cases):
    return [ladder(c) for c in cases if c.ladder]


def benchmark_figures(layout, benchmarks):
    """One figure a [[benchmark_figure]] of the layout: `pattern` has the groups `size` and `series`; `time = "wall"` shows wall
    time where threads share the work, `error = "counter"` that error over CPU time."""
    found = []
    for i, wanted in enumerate(layout.get("benchmark_figure", [])):
        series, points, wall, error = {}, [], wanted.get("time") == "wall", wanted.get("error")
        for b in benchmarks:
            match = re.fullmatch(wanted["pattern"], b.name)
            if match:
                groups = match.groupdict()
                name = (groups.get("series") or wanted.get("series", "")).replace("_", " ")
                if error:
                    points.append(Point(b.cpu_seconds, b.counters[error], name, b.name))
                    continue
                series.setdefault(name, []).append((float(groups["size"]), b.wall_seconds if wall else b.cpu_seconds))
        if not series and not points:
            raise LayoutError(f"layout: benchmark_figure {wanted['title']!r}: no benchmark fits {wanted['pattern']!r}")
        figure = (figures.error_against_time(f"cost-{i}", points, [], wanted["quantity"]) if points else
                  figures.cost(f"cost-{i}", series, wanted["x"], "wall time" if wall else "CPU time", wanted["caption"]))
        found.append({"title": wanted["title"], "figure": figure})
    return found


def benchmark_tables(benchmarks):
    tables = []
    for program in sorted({b.program for b in benchmarks}):
        rows = [b for b in benchmarks if b.program == program]
        counters = list(dict.fromkeys(k for b in rows for k in b.counters))
        tables.append({"name": program.removesuffix("_benchmark").replace("_", " "), "counters": [c.replace("_", " ") for c in counters],
                       "rows": [{"name": b.name, "cpu": words.seconds(b.cpu_seconds), "wall": words.seconds(b.wall_seconds),
                                 "counters": [words.number(b.counters[c]) if c in b.counters else "" for c in counters]} for b in rows]})
    return tables
