"""Records, appending and what must be refused."""
import json
import tempfile
import unittest
from pathlib import Path

from benchmarks.costs import history
from benchmarks.costs.history import HistoryError, Record

FIRST = Record("counts", "water-solve", "0123456789", "2026-01-02", "callgrind 3.19, g++ 12, x86-64-v3", {"instructions": 5})


class History(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name) / "counts.jsonl"

    def test_appends_each_record_once(self):
        later = Record(FIRST.kind, FIRST.name, "abcdef0123", "2026-01-03", FIRST.machine, {"instructions": 6})
        self.assertEqual(history.append(self.path, [FIRST]), 1)
        before = self.path.read_text()
        self.assertEqual(history.append(self.path, [FIRST, later]), 1)
        self.assertEqual(history.read(self.path), [FIRST, later])
        self.assertTrue(history.only_appended(before, self.path.read_text()))

    def test_tells_what_is_no_appending(self):
        self.assertFalse(history.only_appended("a\nb\n", "a\nc\n"))
        self.assertFalse(history.only_appended("a\nb\n", "a\n"))
        self.assertTrue(history.only_appended("", "a\n"))

    def test_refuses_paths_and_what_is_no_record(self):
        fine = json.loads(FIRST.line())
        for change in ({"machine": "/home/somebody"}, {"commit": "HEAD"}, {"values": {}}, {"values": {"a": "x"}},
                       {"date": "yesterday"}, {"host": "here"}, {"schema": 2}, {"kind": "guess"}):
            with self.assertRaises(HistoryError, msg=change):
                history.record_of(json.dumps(fine | change), "here")
        with self.assertRaises(HistoryError):
            history.record_of("{", "here")

    def test_refuses_a_record_twice(self):
        self.path.write_text(FIRST.line() + "\n" + FIRST.line() + "\n")
        with self.assertRaises(HistoryError):
            history.read(self.path)

    def test_takes_cases_from_the_records_of_the_catalogue(self):
        record = {"id": "sif/edge-crack", "cpu_seconds": 0.5, "environment": {"commit": "0123456789", "faulted": False},
                  "settings": [{"standard": False, "errors": {"K": 1e-3}}, {"standard": True, "errors": {"K": 1e-5}}]}
        path = Path(self.folder.name) / "catalogue.jsonl"
        path.write_text(json.dumps(record) + "\n" + json.dumps(record | {"environment": {"commit": "0", "faulted": True}}) + "\n")
        found = history.case_records(path, "2026-01-02", cores=2)
        self.assertEqual([(r.name, r.commit, r.machine, r.values) for r in found],
                         [("sif/edge-crack", "0123456789", "2 cores, x86-64", {"cpu_seconds": 0.5, "error: K": 1e-5})])

    def test_the_files_of_the_repository_are_whole(self):
        for path in Path(history.__file__).resolve().parents[1].glob("history/*.jsonl"):
            history.read(path)


if __name__ == "__main__":
    unittest.main()
