"""What the verification and the benchmarks left behind, read strictly into plain values.

`verification/harness/record.schema.json` describes the lines that `sunder-verify` writes, the same from the program with
planted faults; Google Benchmark writes the rest. A case's prose (why, reasons) comes from its case file. A line of another
schema version, a missing key, a wrong type or a word that is not in the schema is a RecordError that names file, line and
key: a report is never made from records that are only half understood.
"""
from __future__ import annotations

import json
import math
import re
import tomllib
from dataclasses import dataclass, field, replace

SCHEMA = 1

STATUSES = ("pass", "known limit", "skipped", "changed pin", "refused", "not converged", "broken invariant", "wrong order",
            "wrong value", "checked nothing", "timeout", "memory", "crash")
HARMLESS = ("pass", "known limit", "skipped")
CLASSES = ("exact", "high-precision", "cross-code", "published", "self")
KINDS = ("value", "order", "invariant", "bound", "pin", "refused", "contract", "ladder")
# Checks that the harness adds to a case, kinds `contract` and `ladder`: they stand in no case file.
OWN_REASONS = {"parts": "no part is entered but those the case lists", "repeatability": "every repeat gives the same bits",
               "ladder": "every rung is right or refused by name, and the first failing rung is no lower than before"}


class RecordError(ValueError):
    """Records that cannot be used; says file, line, key, what is wrong and what is accepted."""


@dataclass(frozen=True)
class Reference:
    name: str
    kind: str              # class: exact, high-precision, cross-code, published, self
    unit: str
    source: str
    locator: str
    uncertainty: float
    relative: bool         # whether the uncertainty is a fraction of the value


@dataclass(frozen=True)
class Order:
    convergence: str       # monotone, oscillatory, divergent, at round-off floor
    order: float
    pairwise: tuple
    extrapolated: float
    convergence_index: float
    levels_used: int


@dataclass(frozen=True)
class Check:
    name: str
    kind: str              # value, order, invariant, bound, pin, refused
    gates: bool
    status: str
    evidence: str          # class of the reference; law, bound, refusal where there is none
    basis: str
    reason: str
    reference_name: str
    value: float
    reference: float
    error: float
    tolerance: float
    compared: int
    message: str
    orders: tuple
    tolerances: tuple = ()  # as written: one, or one a setting
    over: str = ""         # order: the key that is refined
    over_counts: bool = False  # order: `over` is a number of divisions, h = 1 / value

    @property
    def slack(self):
        """tolerance / error; infinite where the error is 0."""
        return self.tolerance / self.error if self.error > 0 else math.inf

    @property
    def slack_word(self):
        """`loose` above 20, `tight` below 1.2; only a passing check that compares numbers has slack."""
        if self.status != "pass" or self.kind in ("refused", "bound") or not self.error > 0 or not self.tolerance > 0:
            return ""
        return "loose" if self.slack > 20 else "tight" if self.slack < 1.2 else ""


@dataclass(frozen=True)
class Setting:
    keys: tuple            # (key, value as written)
    standard: bool         # the program's default: `default` in the record
    status: str
    message: str
    errors: dict           # check name -> error
    cpu_seconds: float     # nan where the run gave none
    cpu_spread: float
    repeats: int
    dofs: int
    peak_bytes: int


@dataclass(frozen=True)
class Negative:
    fault: str
    checks: tuple          # that should turn red
    red: tuple             # that did
    verdict: str           # killed, survived, never reached, no baseline


@dataclass(frozen=True)
class Sweep:
    error: str             # the check whose error is shown over CPU time; may be empty
    series: tuple          # keys that tell the curves apart


@dataclass(frozen=True)
class Ladder:
    first_failing: int     # index of the first rung that was not right; the number of rungs where all were


@dataclass(frozen=True)
class Case:
    id: str
    version: int
    title: str
    requirement: str
    why: str
    family: str
    tier: str
    modules: tuple
    status: str
    message: str
    references: tuple
    checks: tuple
    settings: tuple
    negatives: tuple
    sweep: Sweep
    ladder: Ladder | None
    cpu_seconds: float
    peak_bytes: int

    @property
    def anchor(self):
        return "case-" + self.id.replace("/", "-")


@dataclass(frozen=True)
class Environment:
    facts: tuple           # (name, value) in the order of the record


@dataclass(frozen=True)
class Benchmark:
    program: str
    name: str
    cpu_seconds: float
    wall_seconds: float
    threads: int
    counters: dict
    label: str


@dataclass
class Records:
    environment: Environment
    cases: list
    benchmarks: list = field(default_factory=list)


class _Object:
    """A JSON object with the place it came from, read key by key."""

    def __init__(self, value, where):
        if not isinstance(value, dict):
            raise RecordError(f"{where}: expected an object, found {_kind(value)}")
        self.value, self.where = value, where

    def take(self, key, kind, accepted=None):
        """The value of a required key; `kind` is a type. A number may be null: not a number."""
        if key not in self.value:
            raise RecordError(f"{self.where}: {key}: missing")
        value = self.value[key]
        if kind is float and value is None:
            return math.nan
        if kind is float and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise RecordError(f"{self.where}: {key}: expected {_WORDS[kind]}, found {_kind(value)}")
        if accepted and value not in accepted:
            raise RecordError(f"{self.where}: {key}: {value!r} is not one of {', '.join(accepted)}")
        return value

    def optional(self, key, kind):
        return None if self.value.get(key) is None else self.take(key, kind)

    def objects(self, key):
        return [_Object(v, f"{self.where}: {key}[{i}]") for i, v in enumerate(self.take(key, list))]

    def texts(self, key):
        return tuple(str(v) for v in self.take(key, list))

    def pairs(self, key):
        """A list of [name, value] or an object, in order."""
        value = self.value.get(key)
        if isinstance(value, dict):
            return list(value.items())
        value = self.take(key, list)
        if not all(isinstance(p, list) and len(p) == 2 for p in value):
            raise RecordError(f"{self.where}: {key}: expected [name, value] pairs")
        return [tuple(p) for p in value]


_WORDS = {str: "text", float: "a number", int: "a whole number", bool: "true or false", list: "a list", dict: "an object"}


def _kind(value):
    return "null" if value is None else _WORDS.get(type(value), type(value).__name__)


def _message(o):
    """A message without the folders of the machine on which it was written."""
    return re.sub(r"(?:/[^\s/:]+)+/", "", o.optional("message", str) or "")


def _reference(o):
    return Reference(o.take("name", str), o.take("class", str, CLASSES), o.take("unit", str), o.take("source", str),
                     o.take("locator", str), o.take("uncertainty", float), o.take("uncertainty_is_relative", bool))


def _order(o):
    return Order(o.take("convergence", str), o.take("order", float),
                 tuple(math.nan if p is None else float(p) for p in o.take("pairwise", list)), o.take("extrapolated", float),
                 o.take("convergence_index", float), o.take("levels_used", int))


def _check(o):
    return Check(o.take("name", str), o.take("kind", str, KINDS), o.take("gates", bool), o.take("status", str, STATUSES),
                 o.take("evidence", str), o.take("basis", str), "", "", o.take("value", float), o.take("reference", float),
                 o.take("error", float), o.take("tolerance", float), o.take("compared", int), _message(o),
                 tuple(_order(e) for e in o.objects("orders")) if "orders" in o.value else ())


def _setting(o):
    return Setting(tuple((k, str(v)) for k, v in o.pairs("keys")), o.take("default", bool), o.take("status", str, STATUSES),
                   _message(o), {k: math.nan if e is None else float(e) for k, e in o.pairs("errors")},
                   o.take("cpu_seconds", float), o.take("cpu_spread", float), o.take("repeats", int), o.take("dofs", int),
                   o.take("peak_bytes", int))


def _negative(o):
    return Negative(o.take("fault", str), o.texts("checks"), o.texts("red"),
                    o.take("verdict", str, ("killed", "survived", "never reached", "no baseline")))


def _case(o):
    settings = tuple(map(_setting, o.objects("settings")))
    sweep = _Object(o.take("sweep", dict), f"{o.where}: sweep")
    rung = o.optional("first_failing_rung", int)
    identity = o.take("id", str)
    case = Case(identity, o.take("version", int), o.take("title", str) or identity, o.take("requirement", str), "",
                o.take("family", str), o.take("tier", str), (), o.take("status", str, STATUSES), _message(o),
                tuple(map(_reference, o.objects("references"))), tuple(map(_check, o.objects("checks"))), settings,
                tuple(map(_negative, o.objects("negatives"))), Sweep(sweep.take("error", str), sweep.texts("series")),
                None if rung is None else Ladder(rung), o.take("cpu_seconds", float), o.take("peak_bytes", int))
    if not case.checks and case.status == "pass":
        raise RecordError(f"{o.where}: checks: empty; a case that checked nothing is no evidence")
    if case.ladder and not case.settings:
        raise RecordError(f"{o.where}: settings: empty; a ladder has rungs")
    return case


def _lines(path):
    if not path.is_file():
        raise RecordError(f"{path}: no such file; ci/verify writes it")
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        where = f"{path.name}:{number}"
        try:
            record = _Object(json.loads(line), where)
        except json.JSONDecodeError as error:
            raise RecordError(f"{where}: not JSON: {error.msg} in column {error.colno}") from None
        schema = record.take("record", int)
        if schema != SCHEMA:
            raise RecordError(f"{where}: record: version {schema}; this report reads version {SCHEMA}")
        yield record


def read_catalogue(*paths):
    """(environment, cases in the order of their ids) from files of JSON lines, one record a case and program: the plain
    program gives verdicts, the program with planted faults what became of the faults."""
    cases, negatives, environment = {}, {}, None
    for record in (line for path in paths for line in _lines(path)):
        facts = dict(record.pairs("environment"))
        faulted = facts.pop("faulted", False)
        case = _case(record)
        found = negatives if faulted else cases
        if case.id in found:
            raise RecordError(f"{record.where}: id: {case.id} stands twice")
        found[case.id] = case
        facts = tuple((key, str(value)) for key, value in facts.items())
        if environment not in (None, facts):
            raise RecordError(f"{record.where}: environment: differs from the first line's; one report shows one run")
        environment = facts
    if not cases:
        raise RecordError(f"{paths[0].name}: no record")
    for identity, case in negatives.items():
        if identity not in cases:
            raise RecordError(f"{identity}: faults were planted, but the case itself was not run")
        cases[identity] = replace(cases[identity], negatives=case.negatives)
    return Environment(environment), [cases[key] for key in sorted(cases)]


def _listed(value):
    return value if isinstance(value, (list, tuple)) else [value]


def with_prose(case, folder):
    """The case with why, parts and reasons from its file in `folder`; both must be of one version."""
    if not case.tier:  # the file does not follow the schema; the record says where, and fails
        return case
    path = folder / f"{case.id}.case.toml"
    try:
        text = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise RecordError(f"{path}: no such file, but a record of the case") from None
    except tomllib.TOMLDecodeError as error:
        raise RecordError(f"{path}: {error}") from None
    if text.get("version", 1) != case.version:
        raise RecordError(f"{path}: version {text.get('version', 1)}, the record is of version {case.version}; run ci/verify again")
    written = {c["name"]: c for c in text.get("check", [])}
    checks = []
    for check in case.checks:
        if check.kind in ("contract", "ladder"):
            checks.append(replace(check, reason=OWN_REASONS.get(check.name, "")))
            continue
        if check.name not in written:
            raise RecordError(f"{path}: check: {check.name!r} is in the record but not in the file; run ci/verify again")
        own = written[check.name]
        law = f"{own['law']}; " if "law" in own else ""
        checks.append(replace(check, reason=law + own["reason"], reference_name=own.get("reference", ""),
                              tolerances=tuple(_listed(own.get("tolerance", ()))), over=own.get("over", ""),
                              over_counts=own.get("counts", False)))
    return replace(case, why=text["why"], modules=tuple(text["modules"]), checks=tuple(checks))


_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# What Google Benchmark itself writes into a row; any other number is a counter of ours.
_OWN_KEYS = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations", "real_time",
             "cpu_time", "bytes_per_second", "items_per_second"}


def read_benchmarks(folder):
    """Every measurement in the *.json files of a folder: medians where repetitions were made, single runs otherwise."""
    found = []
    for path in sorted(folder.glob("*.json")):
        try:
            rows = _Object(json.loads(path.read_text(encoding="utf-8")), path.name).objects("benchmarks")
        except json.JSONDecodeError as error:
            raise RecordError(f"{path.name}:{error.lineno}: not JSON: {error.msg}") from None
        medians = [r for r in rows if r.value.get("aggregate_name") == "median"]
        repeated = {r.value["run_name"] for r in medians}
        for row in medians + [r for r in rows if r.value.get("run_type") == "iteration"
                              and r.value.get("run_name") not in repeated]:
            name = row.take("run_name", str) if "run_name" in row.value else row.take("name", str)
            if row.value.get("error_occurred"):
                raise RecordError(f"{path.name}: {name}: {row.value.get('error_message', 'failed')}")
            unit = row.take("time_unit", str, tuple(_SECONDS))
            counters = {k: float(v) for k, v in row.value.items()
                        if isinstance(v, (int, float)) and not isinstance(v, bool) and k not in _OWN_KEYS}
            found.append(Benchmark(path.stem, name, row.take("cpu_time", float) * _SECONDS[unit],
                                   row.take("real_time", float) * _SECONDS[unit], row.take("threads", int), counters,
                                   row.value.get("label", "")))
    if not found:
        raise RecordError(f"{folder.name}: no benchmark result; ci/benchmark writes them")
    return found


def read(folder, case_folder):
    """All records below a folder, with the prose of the case files (both pathlib.Path)."""
    environment, cases = read_catalogue(*sorted(folder.glob("*.jsonl")) or [folder / "catalogue.jsonl"])
    return Records(environment, [with_prose(c, case_folder) for c in cases], read_benchmarks(folder / "benchmarks"))
