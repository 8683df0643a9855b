"""ci/compare-records must notice each way in which two sets of records can differ."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPARE = pathlib.Path(__file__).parent.parent / "compare-records"


def record(error=1e-3, basis="discretisation", status="pass", rung=None, tolerance=1e-2):
    made = {
        "id": "sif/edge-crack", "status": status, "message": "",
        "checks": [{"name": "K_I", "kind": "value", "basis": basis, "tolerance": tolerance},
                   {"name": "parts", "kind": "contract", "basis": "specification", "tolerance": 0}],
        "settings": [{"errors": {"K_I": 2e-3}}, {"errors": {"K_I": error}}],
    }
    if rung is not None:
        made["first_failing_rung"] = rung
    return made


class CompareRecords(unittest.TestCase):
    def compare(self, reference, other):
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for name, made in (("reference", reference), ("other", other)):
                files.append(pathlib.Path(folder) / name)
                files[-1].write_text(json.dumps(made) + "\n")
            done = subprocess.run([sys.executable, COMPARE, *files], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def test_same_records_agree(self):
        self.assertEqual(self.compare(record(), record())[0], 0)

    def test_round_off_is_no_difference(self):
        self.assertEqual(self.compare(record(), record(error=1e-3 + 1e-12))[0], 0)

    def test_a_difference_in_the_eighth_digit_is_noticed(self):
        status, output = self.compare(record(), record(error=1e-3 + 1e-7))
        self.assertEqual(status, 1, output)
        self.assertIn("K_I: differs by 1.0e-07", output)

    def test_round_off_checks_may_differ_by_their_tolerance(self):
        one, other = record(error=1e-7, basis="round-off", tolerance=1e-6), record(error=5e-7, basis="round-off")
        other["checks"][0]["tolerance"] = 1e-6
        self.assertEqual(self.compare(one, other)[0], 0)

    def test_another_status_is_noticed(self):
        self.assertEqual(self.compare(record(), record(status="crash"))[0], 1)

    def test_another_rung_is_noticed(self):
        self.assertEqual(self.compare(record(rung=5), record(rung=4))[0], 1)

    def test_an_error_that_is_not_a_number_is_noticed(self):
        self.assertEqual(self.compare(record(), record(error=None))[0], 1)

    def test_no_common_case_is_no_agreement(self):
        self.assertEqual(self.compare(record(), {**record(), "id": "sif/other"})[0], 1)


if __name__ == "__main__":
    unittest.main()
