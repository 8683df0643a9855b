"""The bibliography as a person reads it."""
import pathlib
import tempfile
import unittest

from reports import bibliography

TEXT = """% A comment with @article{no, title = {x}}
@article{kaya-erdogan-1987, author = {Kaya, A. C. and Erdogan, F.}, title = {On {S}ingular Kernels}, journal = {Quarterly},
  volume = {45}, pages = {105--122}, year = {1987}}
@book{song-2018, author = {Song, C.}, title = {The Method}, publisher = {Wiley}, year = {2018}}
@article{ooi-2012, author = {Ooi, E. T. and Song, C. and Yang, Z.}, title = {Polygons}, year = {2012}}
@misc{nparc, author = {{NPARC Alliance}}, title = {Grid Convergence}}
@misc{own, title = {Separate computations}, note = {a folder}, year = {2026}}
"""


class Bibliography(unittest.TestCase):
    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "bibliography.bib"
            path.write_text(TEXT)
            self.works = bibliography.read(path)

    def test_every_entry_and_no_comment(self):
        self.assertEqual(sorted(self.works), ["kaya-erdogan-1987", "nparc", "ooi-2012", "own", "song-2018"])

    def test_short_form(self):
        self.assertEqual([self.works[k].short for k in ("song-2018", "kaya-erdogan-1987", "ooi-2012", "nparc", "own")],
                         ["Song 2018", "Kaya and Erdogan 1987", "Ooi and others 2012", "NPARC Alliance", "Separate computations"])

    def test_full_form(self):
        self.assertEqual(self.works["kaya-erdogan-1987"].full, "Kaya and Erdogan, On Singular Kernels, Quarterly 45, 1987")

    def test_the_project_s_own_bibliography_can_be_read(self):
        own = bibliography.read(pathlib.Path(__file__).parents[2] / "reference-data/bibliography.bib")
        self.assertIn("song-2018", own)
        self.assertTrue(all(work.short and work.full for work in own.values()))


if __name__ == "__main__":
    unittest.main()
