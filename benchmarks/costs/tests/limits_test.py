"""The decision rule of the counts gate, and the file of limits itself."""
import unittest
from pathlib import Path

from benchmarks.costs import counting, limits

FILE = Path(limits.__file__).resolve().parents[1] / "counts" / "limits.toml"
COUNTS = {"instructions": 1_000_000, "d1_misses": 1000, "ll_misses": 100, "allocations": 0, "peak_bytes": 4096}
KNOWN = {"region": [{"name": "r", "reason": "-", **COUNTS}],
         "slack": {"instructions": 0.005, "d1_misses": 0.02, "ll_misses": 0.05, "allocations": 0, "peak_bytes": 0.01}}


class Limits(unittest.TestCase):
    def test_the_same_count_is_within_200_times(self):
        self.assertEqual([limits.excesses(KNOWN, "r", COUNTS) for _ in range(200)], [[]] * 200)

    def test_one_per_cent_more_instructions_are_beyond(self):
        beyond = limits.excesses(KNOWN, "r", COUNTS | {"instructions": 1_010_000})
        self.assertEqual([(e.region, e.kind, e.found) for e in beyond], [("r", "instructions", 1_010_000)])
        self.assertIn("limit 1005000, found 1010000", str(beyond[0]))

    def test_one_block_in_a_loop_that_allocates_nothing_is_beyond(self):
        beyond = limits.excesses(KNOWN, "r", COUNTS | {"allocations": 1})
        self.assertEqual([e.kind for e in beyond], ["allocations"])

    def test_a_limit_far_above_the_count_is_told(self):
        # at 99.5 % of the recorded count, 1 % more would still be within the limit
        self.assertEqual(limits.loose(KNOWN, "r", COUNTS), [])
        self.assertEqual(limits.loose(KNOWN, "r", COUNTS | {"instructions": 990_000}), ["instructions"])

    def test_an_unknown_region_is_refused(self):
        with self.assertRaises(limits.LimitError):
            limits.excesses(KNOWN, "other", COUNTS)

    def test_exponents(self):
        table = {"region": "r", "sizes": [1, 2, 4], "at_least": 0.9, "at_most": 1.1, "reason": "-"}
        self.assertIsNone(limits.exponent_fault(table, [10, 20, 40])[1])
        self.assertIn("exponent 2.000", limits.exponent_fault(table, [10, 40, 160])[1])

    def test_other_counts_keep_reasons_and_comments(self):
        text = '[slack]\ninstructions = 0.005 # why\n[[region]]\nname = "r"\ninstructions = 1\nreason = "-"\n'
        self.assertEqual(limits.with_counts(text, {"r": {"instructions": 2}}), text.replace("= 1\n", "= 2\n"))

    def test_the_file_has_a_reason_for_every_limit(self):
        known = limits.read(FILE)
        for table in known["region"] + known["exponent"]:
            self.assertGreater(len(table["reason"]), 10)
        self.assertGreaterEqual({t["region"] for t in known["exponent"]},
                                {"direct-convolution", "fast-convolution", "water-solve", "modal-solution"})
        self.assertTrue(all(table["instructions"] <= 1e8 for table in known["region"]))


class Counting(unittest.TestCase):
    def test_reads_the_totals_of_callgrind(self):
        text = "version: 1\nevents: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=a\n1 2\ntotals: 100 30 20 1 5 4 1 2\n"
        events = counting.events_of(text)
        self.assertEqual((events["Ir"], events["D1mr"] + events["D1mw"], events["DLmr"], events["DLmw"]), (100, 9, 2, 0))
        with self.assertRaises(counting.CountError):
            counting.events_of("events: Ir\n")


if __name__ == "__main__":
    unittest.main()
