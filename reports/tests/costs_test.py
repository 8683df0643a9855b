"""Figures of costs: the history's trend and the profile on two cores."""
import json
import tempfile
import unittest
from pathlib import Path

from reports import history, two_cores
from reports.figures import FigureError


def record(name, commit, instructions, machine="callgrind"):
    return {"schema": 1, "kind": "counts", "name": name, "commit": commit, "date": "2026-01-01", "machine": machine,
            "values": {"instructions": instructions}}


RECORDS = [record("a", "aaaaaaaaaa", 100), record("b", "aaaaaaaaaa", 50), record("a", "bbbbbbbbbb", 110),
           record("b", "bbbbbbbbbb", 50), record("a", "bbbbbbbbbb", 70, machine="another")]


class History(unittest.TestCase):
    def test_other_machines_are_other_courses(self):
        self.assertEqual(history.courses(RECORDS, "counts", "instructions")[("a", "callgrind")],
                         [("aaaaaaaaaa", 100), ("bbbbbbbbbb", 110)])
        self.assertEqual(len(history.courses(RECORDS, "counts", "instructions")), 3)

    def test_tells_the_steps(self):
        self.assertEqual(history.steps(RECORDS, "counts", "instructions"), [("a", "aaaaaaaaaa", "bbbbbbbbbb", 1.1)])

    def test_draws_the_same_bytes_and_nothing_from_nothing(self):
        drawn = history.trend("trend", RECORDS, "counts", "instructions", "Instructions over the commits.")
        again = history.trend("trend", RECORDS, "counts", "instructions", "Instructions over the commits.")
        self.assertEqual(drawn.svg, again.svg)
        self.assertIn("aaaaaaa", drawn.svg)
        with self.assertRaises(FigureError):
            history.trend("trend", [], "counts", "instructions", "-")

    def test_reads_no_file_as_no_record(self):
        self.assertEqual(history.read(Path("no-such-file.jsonl")), [])


def entry(name, threads, wall, cpu):
    return {"name": f"{name}/threads:{threads}/real_time", "transforms_wall": wall, "transforms_cpu": cpu,
            "steps_wall": 2 * wall, "steps_cpu": 2 * cpu}


class TwoCores(unittest.TestCase):
    def profiles(self, entries):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "two_cores_benchmark.json"
            path.write_text(json.dumps({"benchmarks": entries}))
            return two_cores.read(path)

    def test_speed_up_efficiency_and_useful_share(self):
        profiles = self.profiles([entry("convolution_phases", 1, 0.3, 0.3), entry("convolution_phases", 2, 0.2, 0.32)])
        whole = two_cores.rows(profiles)[-1]
        self.assertEqual(whole[:2], ("convolution", "all"))
        for found, expected in zip(whole[2:], (0.9, 0.6, 1.5, 0.75, 0.9375)):
            self.assertAlmostEqual(found, expected, places=12)
        drawn = two_cores.phase_chart("two-cores", profiles, "Phases.")
        self.assertIn("× 1.50", drawn.svg)
        self.assertEqual(drawn.svg, two_cores.phase_chart("two-cores", profiles, "Phases.").svg)

    def test_refuses_wrong_answers_and_half_a_record(self):
        with self.assertRaises(FigureError):
            self.profiles([{"name": "x/threads:1", "error_occurred": True, "error_message": "other bits"}])
        with self.assertRaises(FigureError):
            two_cores.rows(self.profiles([entry("convolution_phases", 1, 0.3, 0.3)]))


if __name__ == "__main__":
    unittest.main()
