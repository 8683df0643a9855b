"""The measured kill matrix: `sunder-verify-faulted matrix` plants every fault that a case comes by and keeps the checks that turn red."""
from __future__ import annotations

import json

from reports import words
from reports.evidence import FAMILIES
from reports.records import RecordError

SCHEMA = 1


def _lines(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        try:
            record = json.loads(line)
        except json.JSONDecodeError as error:
            raise RecordError(f"{path.name}:{number}: not JSON: {error.msg} in column {error.colno}") from None
        if record.get("kill_matrix") != SCHEMA:
            raise RecordError(f"{path.name}:{number}: kill_matrix: {record.get('kill_matrix')!r}; this report reads version {SCHEMA}")
        yield record


def read(path):
    """Faults by families with the number of checks that each turns red, and the gating checks that none does. None without the file."""
    if not path.is_file():
        return None
    records = list(_lines(path))
    families = [f for f in FAMILIES if any(r["family"] == f for r in records)]
    families += sorted({r["family"] for r in records} - set(families))
    rows, idle, gating = {}, [], 0
    for record in records:
        noticed = set()
        for effect in record["faults"]:
            row = rows.setdefault(effect["fault"], {"fault": effect["fault"], "cells": dict.fromkeys(families, ""), "red": 0, "reached": 0})
            row["reached"] += 1
            row["red"] += len(effect["red"])
            row["cells"][record["family"]] = (row["cells"][record["family"]] or 0) + len(effect["red"])
            noticed |= set(effect["red"])
        gating += len(record["gating_checks"])
        idle += [f"{record['id']}: {name}" for name in record["gating_checks"] if name not in noticed]
    shown = sorted(rows.values(), key=lambda r: r["fault"])
    return {"families": [FAMILIES.get(f, f) for f in families], "idle": sorted(idle),
            "rows": [{**r, "cells": [r["cells"][f] for f in families]} for r in shown],
            "words": f"Measured on {words.count(len(records), 'case')}: every fault that a run comes by was planted alone. The numbers are gating "
                     f"checks that it turns red, by part; an empty cell was never reached, 0 was reached and not noticed. "
                     f"{gating - len(idle)} of {gating} gating checks notice at least one fault."}
