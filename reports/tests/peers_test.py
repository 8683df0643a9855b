"""Records of other programs become one figure and one table a problem."""
import json
import pathlib
import tempfile
import unittest

from reports import peers
from reports.studies import LayoutError


def row(series, seconds, error):
    return {"series": series, "setting": "fine", "error": error, "answer": [1.0], "dofs": 10, "cpu_seconds": seconds, "mesh_seconds": 0.0}


def record(**changes):
    return {"problem": "plate", "title": "Plate", "quantity": "K_I", "rounds": 3, "machine": "x86-64, 2 cores", "versions": {"Other": "1.2"},
            "rows": [row("Other, order 2", 0.1, 1e-2), row("Other, order 4", 0.2, 1e-4), row("Sunder, mesh", 0.1, 1e-3)],
            "failed": [{"series": "Other, order 3", "setting": "fine", "message": "no"}], **changes}


class Peers(unittest.TestCase):
    def read(self, *records):
        with tempfile.TemporaryDirectory() as name:
            for r in records:
                (pathlib.Path(name) / f"{r['problem']}.json").write_text(json.dumps(r))
            return peers.read(pathlib.Path(name))

    def test_orders_of_a_program_are_settings_of_one_curve(self):
        problem = self.read(record())["problems"][0]
        self.assertEqual([(r["program"], r["count"], r["times"]) for r in problem["rows"]],
                         [("Other", 2, ["100 ms", "200 ms", "not reached"]), ("Sunder, mesh", 1, ["100 ms", "100 ms", "not reached"])])
        self.assertIn("Other", problem["figure"].svg)
        self.assertEqual(problem["failed"], ["Other, order 3 (fine)"])

    def test_missing_or_broken_records_fail_the_build(self):
        with self.assertRaisesRegex(LayoutError, "ci/peers writes them"):
            self.read()
        with self.assertRaisesRegex(LayoutError, "no time or no error"):
            self.read(record(rows=[row("Other, order 2", 0.0, 1.0)]))


if __name__ == "__main__":
    unittest.main()
