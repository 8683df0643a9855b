"""Reading records: what is there arrives, and everything that is not as the schema says is named with its place."""
import json
import math
import pathlib
import tempfile
import unittest

from reports import records
from reports.records import RecordError
from reports.tests import synthetic


class Records(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, **more):
        synthetic.write(self.folder, **more)
        return records.read(self.folder, self.folder / "cases")

    def refused(self, change, *expected):
        """Applies `change` to the first line's record and expects an error with these words."""
        synthetic.write(self.folder)
        path = self.folder / "catalogue.jsonl"
        first, rest = path.read_text().split("\n", 1)
        record = json.loads(first)
        change(record)
        path.write_text(json.dumps(record) + "\n" + rest)
        with self.assertRaises(RecordError) as caught:
            records.read(self.folder, self.folder / "cases")
        for words in expected:
            self.assertIn(words, str(caught.exception))

    def test_everything_arrives(self):
        read = self.read()
        self.assertEqual(len(read.cases), len(synthetic.catalogue()))
        edge = next(c for c in read.cases if c.id == "sif/edge-crack")
        self.assertEqual([len(edge.checks), len(edge.settings), len(edge.negatives)], [1, 17, 1])
        self.assertEqual(edge.settings[4].errors, {"K_I": 3e-8})
        self.assertTrue(edge.settings[4].standard)
        self.assertEqual(edge.checks[0].reference_name, "answer")
        self.assertIn("rounding", edge.checks[0].reason)
        self.assertEqual(dict(read.environment.facts)["commit"], "0123abc")

    def test_null_is_not_a_number(self):
        kinked = next(c for c in self.read(good=False).cases if c.id == "sif/kinked-crack")
        self.assertTrue(math.isnan(kinked.checks[0].error))

    def test_messages_lose_the_folders_of_the_machine(self):
        made = synthetic.case("patch/a", message="/srv/someone/sunder/a.scene.toml:3: size: 1 m/s is not 2 m")
        self.assertEqual(self.read(cases=[made]).cases[0].message, "a.scene.toml:3: size: 1 m/s is not 2 m")

    def test_slack_words(self):
        def slack(error, **more):
            made = synthetic.case("patch/a", checks=[synthetic.check("a", error, 1e-9, **more)])
            return self.read(cases=[made]).cases[0].checks[0].slack_word
        self.assertEqual([slack(1e-10), slack(4e-11), slack(9.9e-10), slack(2e-9), slack(0.0)], ["", "loose", "tight", "", ""])

    def test_unknown_schema_version(self):
        self.refused(lambda r: r.update(record=2), "catalogue.jsonl:1", "version 2", "reads version 1")

    def test_missing_key(self):
        self.refused(lambda r: r.pop("requirement"), "catalogue.jsonl:1: requirement: missing")

    def test_wrong_type(self):
        self.refused(lambda r: r["checks"][0].update(error="small"), "checks[0]: error: expected a number, found text")

    def test_truth_is_no_number(self):
        self.refused(lambda r: r.update(version=True), "version: expected a whole number")

    def test_unknown_status(self):
        self.refused(lambda r: r.update(status="fine"), "status: 'fine' is not one of pass")

    def test_unknown_class(self):
        self.refused(lambda r: r["references"][0].update({"class": "hearsay"}), "references[0]: class: 'hearsay'")

    def test_pass_without_a_check(self):
        self.refused(lambda r: r.update(checks=[]), "checked nothing")

    def test_another_run_mixed_in(self):
        self.refused(lambda r: r["environment"].update(commit="other"), "environment: differs")

    def test_case_of_another_version(self):
        self.refused(lambda r: r.update(version=2), "version 1, the record is of version 2")

    def test_check_that_the_case_file_does_not_have(self):
        self.refused(lambda r: r["checks"][0].update(name="other"), "'other' is in the record but not in the file")

    def test_record_without_a_case_file(self):
        self.refused(lambda _: (self.folder / "cases/sif/edge-crack.case.toml").unlink(), "sif/edge-crack.case.toml", "no such file")

    def test_same_case_twice(self):
        self.refused(lambda r: r.update(id="patch/polynomial-order-2"), "stands twice")

    def test_no_json(self):
        synthetic.write(self.folder)
        (self.folder / "catalogue.jsonl").write_text('{"record": 1,\n')
        with self.assertRaisesRegex(RecordError, "catalogue.jsonl:1: not JSON"):
            records.read(self.folder, self.folder / "cases")

    def test_no_record_at_all(self):
        synthetic.write(self.folder)
        for name in ("catalogue.jsonl", "faults.jsonl"):
            (self.folder / name).write_text("")
        with self.assertRaisesRegex(RecordError, "no record"):
            records.read(self.folder, self.folder / "cases")

    def test_no_file(self):
        with self.assertRaisesRegex(RecordError, "catalogue.jsonl: no such file"):
            records.read(self.folder, self.folder / "cases")

    def test_medians_of_repeated_benchmarks_replace_single_runs(self):
        rows = [{"name": "K", "run_name": "K", "run_type": "iteration", "cpu_time": t, "real_time": t, "time_unit": "ms", "threads": 1}
                for t in (3.0, 1.0, 2.0)]
        rows.append({**rows[0], "name": "K_median", "run_type": "aggregate", "aggregate_name": "median", "cpu_time": 2.0})
        (self.folder / "a_benchmark.json").write_text(json.dumps({"benchmarks": rows}))
        self.assertEqual([(b.name, b.cpu_seconds) for b in records.read_benchmarks(self.folder)], [("K", 2e-3)])

    def test_benchmark_with_a_wrong_answer(self):
        row = {"name": "K", "run_type": "iteration", "error_occurred": True, "error_message": "K_I is off by 3 %"}
        (self.folder / "a_benchmark.json").write_text(json.dumps({"benchmarks": [row]}))
        with self.assertRaisesRegex(RecordError, "a_benchmark.json: K: K_I is off by 3 %"):
            records.read_benchmarks(self.folder)

    def test_no_benchmark(self):
        with self.assertRaisesRegex(RecordError, "no benchmark result"):
            records.read_benchmarks(self.folder)


if __name__ == "__main__":
    unittest.main()
