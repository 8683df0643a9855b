"""Error against run time: the front, the default's factor and the times to an error, on points laid out by hand."""
import unittest

from reports.front import Point, default_factor, dominance_front, time_to


def point(seconds, error, standard=False):
    return Point(seconds, error, "", f"{seconds} s", standard)


class Front(unittest.TestCase):
    def test_only_points_that_nothing_beats_are_on_the_front(self):
        a, b, c = point(1, 1e-1), point(2, 1e-3), point(4, 1e-6)
        beaten = [point(1.5, 2e-1), point(3, 1e-3), point(5, 1e-5)]
        self.assertEqual(dominance_front([c, *beaten, a, b]), [a, b, c])

    def test_of_equal_times_the_smaller_error_counts(self):
        self.assertEqual(dominance_front([point(1, 1e-2), point(1, 1e-3)]), [point(1, 1e-3)])

    def test_of_equal_points_one_counts(self):
        self.assertEqual(len(dominance_front([point(1, 1e-2), point(1, 1e-2)])), 1)

    def test_single_point_is_its_own_front(self):
        self.assertEqual(dominance_front([point(3, 0.5)]), [point(3, 0.5)])

    def test_no_point_no_front(self):
        self.assertEqual(dominance_front([]), [])

    def test_slow_default_is_compared_with_the_fastest_that_is_as_good(self):
        self.assertEqual(default_factor([point(1, 1e-1), point(2, 1e-5), point(6, 1e-4, True), point(9, 1e-9)]), 3.0)

    def test_default_on_the_front_costs_nothing(self):
        self.assertEqual(default_factor([point(1, 1e-1), point(2, 1e-5, True), point(9, 1e-9)]), 1.0)

    def test_without_a_default_there_is_no_factor(self):
        self.assertIsNone(default_factor([point(1, 1e-1)]))

    def test_time_to_an_error_includes_the_error_itself(self):
        points = [point(1, 1e-1), point(2, 1e-3), point(4, 1e-6)]
        self.assertEqual(time_to(points, 1e-3).seconds, 2)
        self.assertEqual(time_to(points, 9.9e-4).seconds, 4)
        self.assertIsNone(time_to(points, 1e-7))


if __name__ == "__main__":
    unittest.main()
