"""python3 -m reports compare OLD NEW

What changed between two sets of records: cases and checks added or removed, statuses, errors, costs, ladders, pins. OLD and NEW
are folders of records (build/records) or single files of JSON lines. Exit status 0 where nothing became worse, 1 where
something did, 2 where the records cannot be read.
"""
from __future__ import annotations

import argparse
import pathlib
import sys

from reports import words
from reports.records import HARMLESS, RecordError, read_catalogue

# An error that moves by less is not news; nor one below a thousandth of its tolerance, which is round-off.
ERROR_FACTOR = 1.5
NEGLIGIBLE = 1e-3
# CPU time on a shared machine moves by a third without a reason.
TIME_FACTOR = 1.5
LEAST_SECONDS = 0.05

KINDS = (("added", "added"), ("removed", "removed"), ("worse", "worse"), ("better", "better"), ("pin", "changed pins"))


def read(path):
    """Cases by their id, from a folder of records or a file of JSON lines, and the facts of their environment."""
    files = sorted(path.glob("*.jsonl")) if path.is_dir() else [path]
    environment, cases = read_catalogue(*files or [path / "catalogue.jsonl"])
    return {case.id: case for case in cases}, dict(environment.facts)


def _change(kind, case, words_, what):
    return {"kind": kind, "id": case.id, "title": case.title, "anchor": case.anchor, "what": what, "words": words_}


def _moved(what, old, new, write=words.number):
    return f"{what} {write(old)} → {write(new)}, {words.factor(new / old)}"


def _checks(old, new):
    was = {c.name: c for c in old.checks}
    now = {c.name: c for c in new.checks}
    for name in now.keys() - was.keys():
        yield _change("added", new, f"check {name}", name)
    for name in was.keys() - now.keys():
        yield _change("removed", new, f"check {name}", name)
    for name in was.keys() & now.keys():
        a, b = was[name], now[name]
        if a.status != b.status:
            better = b.status in HARMLESS and a.status not in HARMLESS or b.status == "pass"
            yield _change("pin" if b.status == "changed pin" else "better" if better else "worse", new, f"{name}: {a.status} → {b.status}", name)
        elif a.kind == "pin" and a.value != b.value:
            yield _change("pin", new, f"{name}: {words.number(a.value, 6)} → {words.number(b.value, 6)}", name)
        elif a.tolerance != b.tolerance and a.kind == b.kind and b.gates:
            yield _change("worse" if b.tolerance > a.tolerance else "better", new,
                          f"{name}: tolerance {words.error(a.tolerance)} → {words.error(b.tolerance)}", name)
        elif max(a.error, b.error) > NEGLIGIBLE * b.tolerance and min(a.error, b.error) > 0 and b.kind in ("value", "invariant"):
            factor = b.error / a.error
            if factor > ERROR_FACTOR or factor < 1 / ERROR_FACTOR:
                yield _change("worse" if factor > 1 else "better", new, _moved(f"error of {name}", a.error, b.error, words.error), name)


def _case(old, new):
    yield from _checks(old, new)
    if old.version != new.version:
        yield _change("added", new, f"version {old.version} → {new.version}: a new claim, its history begins", "version")
        return
    if old.ladder and new.ladder and old.ladder.first_failing != new.ladder.first_failing:
        kind = "better" if new.ladder.first_failing > old.ladder.first_failing else "worse"
        yield _change(kind, new, f"first failing rung {old.ladder.first_failing} → {new.ladder.first_failing}", "ladder")
    if max(old.cpu_seconds, new.cpu_seconds) > LEAST_SECONDS and min(old.cpu_seconds, new.cpu_seconds) > 0:
        factor = new.cpu_seconds / old.cpu_seconds
        if factor > TIME_FACTOR or factor < 1 / TIME_FACTOR:
            yield _change("worse" if factor > 1 else "better", new, _moved("CPU time", old.cpu_seconds, new.cpu_seconds, words.seconds), "time")


def compare(old, new):
    """Changes from `old` to `new` (id -> case), in the order of KINDS and then of the ids."""
    found = [_change("added", new[i], "case", "case") for i in new.keys() - old.keys()]
    found += [_change("removed", old[i], "case", "case") for i in old.keys() - new.keys()]
    for identity in old.keys() & new.keys():
        found += _case(old[identity], new[identity])
    order = [kind for kind, _ in KINDS]
    return sorted(found, key=lambda c: (order.index(c["kind"]), c["id"], c["what"]))


def section(old_path, new_cases, new_facts):
    """The section of the report: changes since the records at `old_path`."""
    old, facts = read(old_path)
    changes = compare(old, {c.id: c for c in new_cases})
    groups = [{"name": name, "changes": [c for c in changes if c["kind"] == kind]} for kind, name in KINDS]
    told = " · ".join(f"{len(g['changes'])} {g['name']}" for g in groups)
    return {"words": f"Since {facts.get('commit', 'the earlier records')}: {told}. An error or a CPU time counts as changed from a factor of "
                     f"{ERROR_FACTOR:g} on; times are of a shared machine.", "groups": [g for g in groups if g["changes"]],
            "same_machine": facts.get("machine") == new_facts.get("machine")}


def main(arguments):
    parser = argparse.ArgumentParser(prog="python3 -m reports compare", description="What changed between two sets of records.",
                                     epilog="Exit status: 0 nothing became worse, 1 something did, 2 the records cannot be read.")
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    options = parser.parse_args(arguments)
    try:
        (old, was), (new, now) = read(options.old), read(options.new)
    except RecordError as error:
        print(f"compare: {error}", file=sys.stderr)
        return 2
    changes = compare(old, new)
    print(f"{was.get('commit', options.old)} → {now.get('commit', options.new)}: {len(old)} → {len(new)} cases")
    for kind, name in KINDS:
        own = [c for c in changes if c["kind"] == kind]
        print(f"{name}: {len(own)}")
        for change in own:
            print(f"  {change['id']}: {change['words']}")
    return 1 if any(c["kind"] == "worse" for c in changes) else 0
