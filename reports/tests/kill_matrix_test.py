"""The measured kill matrix as a table."""
import json
import pathlib
import tempfile
import unittest

from reports import kill_matrix
from reports.records import RecordError


def record(identity, faults, checks=("K_I",)):
    return {"kill_matrix": 1, "id": identity, "version": 1, "family": identity.split("/")[0], "tier": "quick", "commit": "", "baseline": "pass",
            "cpu_seconds": 0.1, "gating_checks": {c: "value" for c in checks},
            "faults": [{"fault": f, "red": {c: "wrong value" for c in red}, "cpu_seconds": 0.1} for f, red in faults.items()]}


class KillMatrix(unittest.TestCase):
    def read(self, *records):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "kill-matrix.jsonl"
            path.write_text("".join(json.dumps(r) + "\n" for r in records))
            return kill_matrix.read(path)

    def test_counts_by_part_and_names_idle_checks(self):
        found = self.read(record("sif/a", {"f": ["K_I"], "g": []}, ("K_I", "T")), record("modal/b", {"f": ["omega"]}, ("omega",)))
        self.assertEqual(found["families"], ["Stress intensity", "Free vibration"])
        self.assertEqual([(r["fault"], r["cells"], r["red"]) for r in found["rows"]], [("f", [1, 1], 2), ("g", [0, ""], 0)])
        self.assertEqual(found["idle"], ["sif/a: T"])
        self.assertIn("2 of 3 gating checks notice", found["words"])

    def test_another_schema_or_no_file(self):
        with self.assertRaisesRegex(RecordError, "kill-matrix.jsonl:1: kill_matrix: 2"):
            self.read({**record("sif/a", {}), "kill_matrix": 2})
        self.assertIsNone(kill_matrix.read(pathlib.Path("no-such-file")))


if __name__ == "__main__":
    unittest.main()
