"""The decision rules on series with planted steps, and the twin of the harness's interval."""
import math
import random
import unittest

from benchmarks.costs import statistics
from benchmarks.costs.statistics import FASTER, NOISY, SAME, SLOWER


def noisy(generator, pairs, step=0.0, sigma=0.005):
    """ln(B/A) of quadruples whose times vary by `sigma`, with outliers as a shared machine has them."""
    def time(factor):
        outlier = 1.3 if generator.random() < 0.03 else 1.0
        return factor * math.exp(generator.gauss(0.0, sigma)) * outlier
    slower = math.exp(step)
    return [statistics.log_ratio((time(1.0), time(slower), time(slower), time(1.0))) for _ in range(pairs)]


class MedianInterval(unittest.TestCase):
    def test_agrees_with_the_harness(self):
        # verification/harness/tests/statistics_test.cpp: ten values, 97.8 % between the second and the ninth
        interval = statistics.median_interval(list(range(1, 11)), 0.95)
        self.assertEqual((interval.median, interval.low, interval.high), (5.5, 2, 9))
        self.assertAlmostEqual(interval.confidence, 1.0 - 2.0 * 11.0 / 1024.0, places=12)

    def test_few_values_never_reach_the_confidence(self):
        for n in range(1, 8):  # 1 - 2/2^7 = 0.984 < 0.99
            self.assertLess(statistics.median_interval(range(n), 0.99).confidence, 0.99)
        self.assertGreaterEqual(statistics.median_interval(range(8), 0.99).confidence, 0.99)

    def test_covers_as_often_as_it_says(self):
        # 1000 normal samples of 11; the interval at 95 % holds 0 in all but a share whose standard error is 0.7 %
        generator = random.Random(3)
        held = 0
        for _ in range(1000):
            interval = statistics.median_interval([generator.gauss(0, 1) for _ in range(11)], 0.95)
            held += interval.low <= 0.0 <= interval.high
        self.assertGreater(held, 950 - 3 * 7)

    def test_empty_is_refused(self):
        with self.assertRaises(ValueError):
            statistics.median_interval([])


class LogRatio(unittest.TestCase):
    def test_a_steady_drift_cancels(self):
        # A B B A at times 0, 1, 2, 3 on a machine that slows by 1 % each time: 1st + 4th = 2nd + 3rd to first order
        self.assertAlmostEqual(statistics.log_ratio((1.00, 1.01, 1.02, 1.03)), 0.0, places=12)

    def test_tells_a_factor(self):
        self.assertAlmostEqual(statistics.log_ratio((1.0, 2.0, 2.0, 1.0)), math.log(2.0), places=12)
        with self.assertRaises(ValueError):
            statistics.log_ratio((1.0, 0.0, 1.0, 1.0))


class Verdict(unittest.TestCase):
    def test_200_unchanged_pairs_of_builds_raise_hardly_an_alarm(self):
        # one batch has a false alarm of at most 1 %; the second must repeat it on the same side: 0.5 % of that. The
        # expected number of alarms in 200 judgements is 0.01.
        generator = random.Random(11)
        words = [statistics.verdict(*(noisy(generator, 12) for _ in range(3)))[0] for _ in range(200)]
        self.assertEqual(words.count(SLOWER) + words.count(FASTER), 0)

    def test_planted_steps_are_seen(self):
        # noise of 0.5 % a time, 0.35 % a quadruple's log-ratio: a step of 2 % is six of these
        generator = random.Random(12)
        for step, word in ((0.02, SLOWER), (-0.02, FASTER), (0.10, SLOWER)):
            seen = [statistics.verdict(noisy(generator, 16), noisy(generator, 16, step), noisy(generator, 16, step))
                    for _ in range(40)]
            hits = [interval for found, interval in seen if found == word]
            self.assertGreaterEqual(len(hits), 20, word)
            self.assertFalse([found for found, _ in seen if found not in (word, SAME, NOISY)])
            self.assertAlmostEqual(hits[0].median, step, delta=0.01)

    def test_a_step_in_one_batch_alone_is_no_verdict(self):
        generator = random.Random(13)
        word, _ = statistics.verdict(noisy(generator, 12), noisy(generator, 12, 0.05), noisy(generator, 12))
        self.assertIn(word, (SAME, NOISY))

    def test_a_control_that_drifts_or_scatters_ends_the_judgement(self):
        generator = random.Random(14)
        fine = noisy(generator, 12, 0.05)
        self.assertEqual(statistics.verdict(noisy(generator, 12, 0.05), fine, fine)[0], NOISY)
        self.assertEqual(statistics.verdict(noisy(generator, 12, sigma=0.2), fine, fine)[0], NOISY)
        self.assertEqual(statistics.verdict([0.0] * 5, fine, fine)[0], NOISY)


class Exponent(unittest.TestCase):
    def test_of_powers(self):
        sizes = [10, 20, 40, 80]
        for power in (0.5, 1.0, 2.0, 3.0):
            self.assertAlmostEqual(statistics.exponent(sizes, [7.0 * n ** power for n in sizes]), power, places=12)

    def test_needs_three_sizes(self):
        with self.assertRaises(ValueError):
            statistics.exponent([1, 2], [1, 2])


if __name__ == "__main__":
    unittest.main()
