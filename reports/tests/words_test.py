"""Numbers in words for people."""
import math
import unittest

from reports import words


class Words(unittest.TestCase):
    def test_numbers(self):
        table = [(0.0, "0"), (1.0, "1"), (0.5, "0.5"), (2.8254653, "2.83"), (0.0123456, "0.0123"), (1234.5, "1234"), (123456.0, "1.23·10⁵"),
                 (1e-7, "10⁻⁷"), (3.2e-12, "3.2·10⁻¹²"), (-0.41, "−0.41"), (9.999e-8, "10⁻⁷"), (math.inf, "∞"), (math.nan, "not a number"),
                 (100.0, "100"), (20.0, "20")]
        for value, text in table:
            self.assertEqual(words.number(value), text, value)

    def test_durations_take_the_unit_that_fits(self):
        table = [(3.4, "3.4 s"), (0.0012, "1.2 ms"), (1.5e-5, "15 µs"), (2e-8, "20 ns"), (1e-3, "1 ms"), (0.9999, "1 s"), (math.nan, "–")]
        for value, text in table:
            self.assertEqual(words.seconds(value), text, value)

    def test_values_as_written_keep_every_digit(self):
        table = [("0.49999999000000001", "0.49999999"), ("0.5", "0.5"), ("4", "4"), ("1e8", "10⁸"), ("1e-08", "10⁻⁸"), ("1e+22", "10²²"),
                 ("-2.5e-09", "−2.5·10⁻⁹"), ('"squares"', "squares"), ("[1, 2]", "[1, 2]"), ("0.11764705882352941", "0.117647"), ("0.4999999999", "0.4999999999"),
                 ("1e5", "10⁵"), ("1500000", "1500000"), ("0", "0"),
                 ("[ [ 0, 9.9999999999999995e-07 ], [ 0.5, 1 ] ]", "[[0, 10⁻⁶], [0.5, 1]]")]
        for value, text in table:
            self.assertEqual(words.written(value), text, value)

    def test_settings_by_the_last_word_of_their_keys(self):
        self.assertEqual(words.setting([("mesh.cells", '"one"'), ("mesh.tip_order", "4")]), "cells one, tip order 4")


if __name__ == "__main__":
    unittest.main()
