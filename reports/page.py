"""From records to the page: every view of the template, and the checks that nothing is missing."""
from __future__ import annotations

import pathlib
import tomllib

import jinja2

from reports import bibliography, evidence, problems, studies, words
from reports.front import LEVELS
from reports.records import HARMLESS, STATUSES
from reports.studies import LayoutError

HERE = pathlib.Path(__file__).parent
LARGEST_PAGE = 10_000_000  # bytes

CONTENTS = (("verdict", "Verdict"), ("trust", "Trust matrix"), ("numbers", "Ten numbers"), ("scenes", "Scenes"), ("koyna", "Koyna"), ("run-time", "Error against run time"),
            ("peers", "Other programs"), ("ladders", "Stability"), ("faults", "Planted faults"), ("costs", "Costs"), ("changes", "Changes"), ("cases", "Cases"), ("limits", "Known limits"),
            ("environment", "Environment"))


def read_layout(path=HERE / "layout.toml"):
    """The layout; its ten numbers stand in a file that `sunder-verify doctor` reads too."""
    layout = tomllib.loads(path.read_text(encoding="utf-8"))
    if "numbers" in layout:
        layout["number"] = tomllib.loads((HERE.parent / layout["numbers"]).read_text(encoding="utf-8"))["number"]
    return layout


def _find(cases, identity, where):
    for case in cases:
        if case.id == identity:
            return case
    raise LayoutError(f"layout: {where}: no record of the case {identity!r}")


def _number(wanted, cases, works):
    case = _find(cases, wanted["case"], "number")
    check = next((c for c in case.checks if c.name == wanted["check"]), None)
    if check is None:
        raise LayoutError(f"layout: number: {case.id} has no check {wanted['check']!r}; it has {', '.join(c.name for c in case.checks)}")
    reference = next((r for r in case.references if r.name == check.reference_name), None)
    source = f"{reference.kind}: {_source(reference, works).short}" if reference else check.evidence
    digits = wanted.get("digits", 6)
    return {"case": case, "words": wanted["words"], "value": words.number(check.value, digits),
            "reference": words.number(check.reference, digits), "error": words.error(check.error),
            "tolerance": words.error(check.tolerance), "source": source}


def _check_view(check):
    compares = check.kind in ("value", "order", "pin", "invariant")
    reason = ": ".join(part for part in (check.basis, check.reason) if part)
    message = f". {check.message}" if check.message else ""
    # Without a verdict a difference is no failure.
    status = check.status if check.gates or check.status == "pass" else "differs"
    return {"name": check.name, "status": status, "gates": check.gates,
            "evidence": check.evidence + (f" ({check.reference_name})" if check.reference_name else ""),
            "value": words.number(check.value, 6) if check.kind not in ("refused", "contract") else "",
            "reference": words.number(check.reference, 6) if compares else "", "error": words.error(check.error) if compares else "",
            "tolerance": words.error(check.tolerance) if compares else "",
            "slack": words.number(check.slack, 2) if compares and check.error > 0 else "", "mark": check.slack_word,
            "reason": reason + message}


def _source(reference, works):
    """A source is a key of the bibliography, or words."""
    return works.get(reference.source, bibliography.Work(reference.source, reference.source))


def _reference_view(r, works):
    source = _source(r, works).full
    text = f"{source}; {r.locator}" if r.locator else source
    if r.uncertainty > 0:
        text += f"; uncertainty {words.error(r.uncertainty)}" + (" of the value" if r.relative else f" {r.unit}")
    return {"kind": r.kind, "name": r.name, "words": text}


def _case_view(case, works):
    keys = list(dict.fromkeys(k for s in case.settings for k, _ in s.keys))
    errors = list(dict.fromkeys(n for s in case.settings for n in s.errors))
    # One setting without a key says no more than the checks do.
    shown = case.settings if keys else ()
    orders = [{"name": c.name, "convergence": o.convergence, "order": words.number(o.order),
               "pairwise": ", ".join(words.number(p) for p in o.pairwise), "extrapolated": words.number(o.extrapolated, 8) if not c.reference_name else "answer known",
               "index": words.error(o.convergence_index) if not c.reference_name else "", "levels": o.levels_used} for c in case.checks for o in c.orders]
    text = " ".join([case.id, case.title, case.requirement, case.why, case.family, case.tier, case.status]
                    + [c.name for c in case.checks] + [f"{r.kind} {r.source} {_source(r, works).full} {r.locator}" for r in case.references]
                    + [n.fault for n in case.negatives]).lower()
    footer = f"Version {case.version} · tier {case.tier} · {words.seconds(case.cpu_seconds)} CPU"
    if case.peak_bytes:
        footer += f" · {words.size(case.peak_bytes)} peak memory"
    footer += f" · parts: {', '.join(case.modules)}" if case.modules else ""
    return {
        "case": case, "text": " ".join(text.split()), "checks": [_check_view(c) for c in case.checks],
        "references": [_reference_view(r, works) for r in case.references], "orders": orders,
        "order_figure": studies.convergence(case), "footer": footer,
        "setting_keys": [words.key(k) for k in keys], "error_names": errors,
        "settings": [{"cells": [words.written(dict(s.keys).get(k, "")) for k in keys], "standard": s.standard, "status": s.status,
                      "message": s.message, "errors": [words.error(s.errors[n]) if n in s.errors else "" for n in errors],
                      "cpu": words.seconds(s.cpu_seconds), "repeats": s.repeats, "dofs": s.dofs or "",
                      "memory": words.size(s.peak_bytes) if s.peak_bytes else ""} for s in shown],
    }


def _families(cases, works):
    names = {row["family"]: row["name"] for row in evidence.trust_matrix(cases)["rows"]}
    return [{"family": family, "name": name, "cases": [_case_view(c, works) for c in cases if c.family == family]}
            for family, name in names.items() if any(c.family == family for c in cases)]


def view(records, layout, works, scenes, koyna=None, peers=None, changes=None, costs=None, kill_matrix=None):
    """Everything the template shows, as plain values. `works`: the bibliography; `scenes`: of scenes.read; `koyna`: of koyna.read;
    `peers`: of peers.read; `changes`: of compare.section; `costs`: of costs.read; `kill_matrix`: of kill_matrix.read."""
    cases = records.cases
    hero, numbers = problems.first(layout, cases), [_number(n, cases, works) for n in layout["number"]]
    benchmark_figures = studies.benchmark_figures(layout, records.benchmarks)
    shown = problems.problems(layout, cases)
    told = {case.id for problem in shown for case in problem["cases"]}
    sweeps = studies.sweeps([c for c in cases if c.id not in told])
    ladders = studies.ladders(cases)
    for name, found in (("ladder", ladders), ("planted fault", [n for c in cases for n in c.negatives])):
        if not found:
            raise LayoutError(f"records: no {name}; the report would have an empty section")
    facts = dict(records.environment.facts)
    headline = " · ".join(f"{name} {facts[name]}" for name in ("version", "commit") if name in facts)
    return {
        "contents": [entry for entry in CONTENTS if (koyna or entry[0] != "koyna") and (peers or entry[0] != "peers")], "koyna": koyna, "headline": headline, "verdict": evidence.verdict(cases), "facts": evidence.facts(cases),
        "matrix": evidence.trust_matrix(cases), "hero": hero, "command": layout["command"],
        "numbers": numbers, "scenes": scenes, "problems": shown, "sweeps": sweeps, "peers": peers, "peers_words": layout.get("peers", {}).get("words", ""), "changes": changes, "costs": costs, "kill_matrix": kill_matrix, "levels": [w for _, w in LEVELS],
        "ladders": ladders, "kills": evidence.kills(cases),
        "benchmark_figures": benchmark_figures, "benchmark_tables": studies.benchmark_tables(records.benchmarks), "families": _families(cases, works),
        "statuses": [s for s in STATUSES if any(c.status == s for c in cases)],
        "limits": [{"case": case, "check": c.name, "message": c.message} for case in cases for c in case.checks
                   if c.status == "known limit"],
        "standing_limits": layout.get("limits", []), "environment": records.environment.facts,
    }


def render(view_, printed=False):
    """The page as one HTML text that asks nothing of any other file; `printed` opens every case."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.globals.update(
        status_class=lambda s: "good" if s == "pass" else "warn" if s in (*HARMLESS, "differs") else "bad",
        status_mark=lambda s: "✓" if s == "pass" else "○" if s in (*HARMLESS, "differs") else "✗")
    page = environment.get_template("page.html.j2").render(
        **view_, printed=printed, style=(HERE / "templates/style.css").read_text(encoding="utf-8"),
        script="".join((HERE / "templates" / name).read_text(encoding="utf-8") for name in ("script.js", "film.js")))
    if len(page.encode()) > LARGEST_PAGE:
        raise LayoutError(f"the page has {len(page.encode())} bytes, more than {LARGEST_PAGE}")
    return page
