"""ci/history: the course of costs and errors over the commits, benchmarks/history/*.jsonl (README.md there)."""
import argparse
import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from benchmarks.costs import counting

FOLDER = Path("benchmarks/history")
SCHEMA = 1
KEYS = {"schema", "kind", "name", "commit", "date", "machine", "values"}
KINDS = ("counts", "case")


class HistoryError(ValueError):
    """A record or a file that is not what it should be."""


@dataclass(frozen=True)
class Record:
    kind: str      # "counts" of a region, or "case" of the catalogue
    name: str
    commit: str    # ten digits
    date: str      # of the commit, YYYY-MM-DD
    machine: str   # coarse: what decides about the figure, and nothing that tells whose machine it was
    values: dict   # name -> number

    @property
    def identity(self):
        return self.kind, self.name, self.commit, self.machine

    def line(self):
        return json.dumps({"schema": SCHEMA, "kind": self.kind, "name": self.name, "commit": self.commit, "date": self.date,
                           "machine": self.machine, "values": self.values}, ensure_ascii=False)


def record_of(line, where):
    """The record of one line; HistoryError with the place where it is none."""
    try:
        data = json.loads(line)
    except json.JSONDecodeError as error:
        raise HistoryError(f"{where}: {error}") from None
    if not isinstance(data, dict) or set(data) != KEYS:
        raise HistoryError(f"{where}: keys {sorted(data) if isinstance(data, dict) else data}, accepted: {sorted(KEYS)}")
    if data["schema"] != SCHEMA or data["kind"] not in KINDS:
        raise HistoryError(f"{where}: schema {data['schema']}, kind {data['kind']}")
    if not re.fullmatch(r"[0-9a-f]{10}", data["commit"]) or not re.fullmatch(r"\d{4}-\d\d-\d\d", data["date"]):
        raise HistoryError(f"{where}: commit {data['commit']}, date {data['date']}")
    if "/" in data["machine"] or not data["values"]:
        raise HistoryError(f"{where}: machine {data['machine']!r}, values {data['values']}")
    if not all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in data["values"].values()):
        raise HistoryError(f"{where}: a value is not a number")
    return Record(data["kind"], data["name"], data["commit"], data["date"], data["machine"], data["values"])


def read(path):
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    records = [record_of(line, f"{path.name}:{i + 1}") for i, line in enumerate(lines)]
    seen = set()
    for record in records:
        if record.identity in seen:
            raise HistoryError(f"{path.name}: {' '.join(record.identity)} stands twice")
        seen.add(record.identity)
    return records


def append(path, records):
    """Adds those records that are not there yet; returns how many."""
    known = {record.identity for record in read(path)}
    new = [record for record in records if record.identity not in known]
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "a", encoding="utf-8") as file:
        file.writelines(record.line() + "\n" for record in new)
    return len(new)


def only_appended(committed, present):
    """Whether the present text is the committed one with lines added at its end."""
    return present.startswith(committed) and (not committed or committed.endswith("\n"))


def git(*words):
    done = subprocess.run(["git", *words], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None


def counts_records(programs, commit, date):
    surroundings = counting.surroundings()
    machine = f"callgrind {surroundings['valgrind'].split(':')[-1]}, g++ {surroundings['g++']}, x86-64-v3"
    return [Record("counts", name, commit, date, machine, counting.whole(programs, name))
            for name in counting.regions(programs)]


def case_records(path, date, cores=None):
    """One record a case of a file of ci/verify: CPU seconds of the case, and the standard setting's errors."""
    records = []
    machine = f"{cores or os.cpu_count()} cores, x86-64"
    for line in path.read_text(encoding="utf-8").splitlines():
        data = json.loads(line)
        commit = data.get("environment", {}).get("commit", "")[:10]
        if not commit or data.get("environment", {}).get("faulted"):
            continue
        values = {"cpu_seconds": data["cpu_seconds"]}
        for row in data.get("settings", []):
            if row.get("standard") or len(data["settings"]) == 1:
                values |= {f"error: {name}": error for name, error in row["errors"].items()
                           if isinstance(error, (int, float))}
        records.append(Record("case", data["id"], commit, date, machine, values))
    return records


def main(words=None):
    parser = argparse.ArgumentParser(prog="ci/history", description=__doc__)
    parser.add_argument("action", choices=("append", "check"))
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--records", type=Path, required=True)
    arguments = parser.parse_args(words)
    try:
        if arguments.action == "append":
            if (git("status", "--porcelain", "--untracked-files=no") or "").strip():
                raise HistoryError("the tree has changes that are in no commit: what would the record belong to?")
            commit, date = git("log", "-1", "--format=%H").strip()[:10], git("log", "-1", "--format=%cs").strip()
            print(f"{append(FOLDER / 'counts.jsonl', counts_records(arguments.programs, commit, date))} regions")
            catalogue = arguments.records / "catalogue.jsonl"
            if catalogue.exists():
                print(f"{append(FOLDER / 'cases.jsonl', case_records(catalogue, date))} cases")
            return 0
        for path in sorted(FOLDER.glob("*.jsonl")):
            read(path)
            if not only_appended(git("show", f"HEAD:{path}") or "", path.read_text(encoding="utf-8")):
                raise HistoryError(f"{path}: lines of the last commit are changed or gone")
        return 0
    except (HistoryError, counting.CountError, OSError) as error:
        print(f"ci/history: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
