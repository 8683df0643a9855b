"""The verdict, the trust matrix and the planted faults: what the records prove, and what they leave open."""
from __future__ import annotations

from dataclasses import dataclass

from reports import words
from reports.records import HARMLESS

# Every part the project is to cover, in the order of the report; a part without a case is shown as without evidence.
FAMILIES = {
    "patch": "Patch tests", "sif": "Stress intensity", "modal": "Free vibration", "stability": "Stability",
    "dynamics": "Dynamics", "contact": "Contact", "crack-water": "Water in cracks", "reservoir": "Reservoir",
    "foundation": "Foundation", "convolution": "Convolution", "propagation": "Crack growth", "koyna": "Koyna dam",
}

COLUMNS = (("exact", "exact"), ("high-precision", "high precision"), ("cross-code", "other code"), ("published", "pub­lished"),
           ("order", "order"), ("invariant", "in­variant"), ("refusal", "refusal"), ("ladder", "ladder"), ("fault", "planted fault"))

INDEPENDENT = ("exact", "high-precision", "cross-code")


@dataclass(frozen=True)
class Cell:
    kind: str    # full, part, limit, none
    text: str
    words: str


def column_of(check):
    """The kind of evidence a check is; None for a pin, which tells change and proves nothing, and for the harness's own."""
    if check.kind in ("pin", "contract", "ladder") or check.evidence == "self":
        return None
    return {"order": "order", "invariant": "invariant", "bound": "invariant", "refused": "refusal"}.get(check.kind, check.evidence)


def gating(cases):
    """The checks that people wrote and that can stop a build; the harness's own (parts, repeatability, ladder) not counted."""
    return [check for case in cases for check in case.checks if check.gates and check.kind not in ("contract", "ladder")]


def _cell(good, total, excused, what):
    if total == 0:
        return Cell("none", "", f"no {what}")
    if good == total:
        return Cell("full", str(total), f"{total} of {total} {what}")
    kind = "limit" if good + excused == total else "part"
    return Cell(kind, f"{good}/{total}", f"{good} of {total} {what}" + (f", {excused} known limit" if excused else ""))


def trust_matrix(cases):
    """Rows of cells (None for a part without a case), columns as COLUMNS."""
    rows = []
    known = dict(FAMILIES)
    for case in cases:
        known.setdefault(case.family, case.family.replace("-", " ").capitalize())
    for family, name in known.items():
        members = [c for c in cases if c.family == family]
        cells = []
        for column, head in COLUMNS if members else ():
            if column == "fault":
                verdicts = [n.verdict for c in members for n in c.negatives]
                cells.append(_cell(verdicts.count("killed"), len(verdicts), 0, "planted faults noticed"))
                continue
            if column == "ladder":
                ladders = [c.status for c in members if c.ladder]
                cells.append(_cell(ladders.count("pass"), len(ladders), ladders.count("known limit"), "ladders climbed as far as claimed"))
                continue
            own = [c for m in members for c in m.checks if column_of(c) == column]
            found = [c.status for c in own if c.gates]
            informing = len(own) - len(found)
            what = "checks: " + head.replace("­", "") + (f"; {informing} more inform without a verdict" if informing else "")
            cells.append(_cell(found.count("pass"), len(found), found.count("known limit"), what))
        rows.append({"family": family, "name": name, "cells": cells})
    return {"columns": COLUMNS, "rows": rows}


def faults(cases):
    """Every planted fault and its verdicts, one a case that names it. It counts as noticed where all of them notice it."""
    found = {}
    for case in cases:
        for n in case.negatives:
            found.setdefault(n.fault, []).append(n.verdict)
    return found


def noticed(verdicts):
    return all(v == "killed" for v in verdicts)


def verdict(cases):
    """One sentence: does it hold, how much of it is independent, would faults be noticed."""
    checks = gating(cases)
    broken = [c for c in cases if c.status not in HARMLESS]
    planted = faults(cases)
    seen = sum(map(noticed, planted.values()))
    every = words.count(len(checks), "check") + " of " + words.count(len(cases), "case")
    told = f"{seen} of {words.count(len(planted), 'planted fault')} {'is' if seen == 1 else 'are'} noticed"
    if broken:
        names = ", ".join(f"“{c.title}”" for c in broken[:2]) + (f" and {len(broken) - 2} more" if len(broken) > 2 else "")
        bad = [c for c in checks if c.status not in HARMLESS]
        return {"good": False, "word": "Does not hold.", "sentence": f"{len(broken)} of {words.count(len(cases), 'case')} "
                f"{'fails' if len(broken) == 1 else 'fail'}: {names}; {len(bad)} of {words.count(len(checks), 'check')} "
                f"{'is' if len(bad) == 1 else 'are'} red; {told}."}
    if seen < len(planted):
        return {"good": False, "word": "Not proven.", "sentence": f"All {every} pass, but only {told}."}
    independent = sum(c.evidence in INDEPENDENT for c in checks)
    return {"good": True, "word": "Holds.", "sentence": f"All {every} pass, {100 * independent // max(len(checks), 1)} % of them against "
            f"exact, high-precision or other codes’ answers" + (f"; {told}." if planted else ".")}


def facts(cases):
    checks = gating(cases)
    passing = [c for c in checks if c.status == "pass"]
    independent = sum(c.evidence in INDEPENDENT for c in checks)
    orders = [c for c in checks if c.kind == "order"]
    ladders = [c for c in cases if c.ladder]
    planted = faults(cases)
    loose, tight = (sum(c.slack_word == w for c in checks) for w in ("loose", "tight"))
    limits = sum(c.status == "known limit" for case in cases for c in case.checks)
    return [
        {"name": "cases", "value": len(cases), "note": f"{sum(c.status == 'pass' for c in cases)} pass"},
        {"name": "gating checks", "value": len(checks), "note": f"{len(passing)} pass"},
        {"name": "independent", "value": f"{100 * independent // len(checks) if checks else 0} %", "note": "of checks"},
        {"name": "order gates", "value": len(orders), "note": f"{sum(c.status == 'pass' for c in orders)} pass"},
        {"name": "ladders", "value": len(ladders), "note": f"{sum(c.ladder.first_failing >= len(c.settings) for c in ladders)} to the top"},
        {"name": "faults noticed", "value": sum(map(noticed, planted.values())), "note": f"of {len(planted)}"},
        {"name": "tolerances", "value": f"{loose}", "note": f"loose, {tight} tight"},
        {"name": "known limits", "value": limits, "note": "excused"},
    ]


def kills(cases):
    """The kill matrix: for each planted fault, the cases that planted it and the checks that turned red."""
    rows, killing = {}, set()
    for case in cases:
        for n in case.negatives:
            row = rows.setdefault(n.fault, {"fault": n.fault, "cases": [], "verdicts": []})
            row["verdicts"].append(n.verdict)
            row["cases"].append({"case": case, "red": ", ".join(n.red) or "none"})
            killing |= {(case.id, name) for name in n.red}
    for row in rows.values():
        row["killed"] = noticed(row["verdicts"])
        row["verdict"] = next((v for v in row["verdicts"] if v != "killed"), "killed")
    checks = {(case.id, c.name) for case in cases for c in gating([case])}
    seen = sum(r["killed"] for r in rows.values())
    sentence = (f"Each fault is one wrong sign, factor or dropped term, built only into a test program; the checks that its cases name "
                f"must turn red. Noticed: {seen} of {words.count(len(rows), 'fault')}. Of {len(checks)} gating checks "
                f"{len(killing & checks)} notice at least one.")
    return {"rows": sorted(rows.values(), key=lambda r: r["fault"]), "words": sentence}
