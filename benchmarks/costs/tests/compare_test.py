"""The order of runs, and judging by a timer that is told what to say."""
import math
import random
import unittest

from benchmarks.costs import compare
from benchmarks.costs.statistics import SAME, SLOWER


class Clock:
    """A machine whose speed drifts, on which program b is slower by `step`."""

    def __init__(self, step, drift=0.0, seed=5):
        self.generator, self.step, self.drift, self.order = random.Random(seed), step, drift, []

    def __call__(self, command):
        self.order.append(command[0])
        speed = 1.0 + self.drift * len(self.order)
        return speed * (1.0 + (self.step if command[0] == "b" else 0.0)) * math.exp(self.generator.gauss(0.0, 0.002)), 0


class Judge(unittest.TestCase):
    def test_takes_control_and_batches_in_turn(self):
        clock = Clock(0.0)
        compare.judge(["a"], ["b"], 1, clock)
        self.assertEqual("".join(clock.order), "aaaa" + "abba" + "abba")

    def test_sees_a_step_on_a_drifting_machine(self):
        # the machine slows by 0.1 % a run, 10 % in all; the step of 3 % is seen at its size, the standard error is 0.05 %
        word, interval = compare.judge(["a"], ["b"], 12, Clock(0.03, drift=0.001))
        self.assertEqual(word, SLOWER)
        self.assertAlmostEqual(interval.median, math.log(1.03), delta=0.002)

    def test_sees_none_where_there_is_none(self):
        self.assertEqual(compare.judge(["a"], ["b"], 12, Clock(0.0, drift=0.001))[0], SAME)

    def test_a_run_that_fails_is_no_time(self):
        with self.assertRaises(compare.CompareError):
            compare.judge(["a"], ["b"], 1, lambda command: (1.0, 1))

    def test_reads_the_cpu_time_of_a_child(self):
        seconds, status = compare.cpu_seconds(["/bin/sh", "-c", "i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done; exit 3"])
        self.assertEqual(status, 3)
        self.assertTrue(0.0 < seconds < 10.0)


if __name__ == "__main__":
    unittest.main()
