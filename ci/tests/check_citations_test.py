"""ci/check-citations must notice a work without an entry, also across lines of a comment and as second in a bracket."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).parent.parent / "check-citations"
BIBLIOGRAPHY = "@book{song-2018, author = {Song, C.}, year = {2018}}\n@article{kaya, author = {Kaya, A. and Erdogan, F.}, year = {1987}}\n"


class CheckCitations(unittest.TestCase):
    def check(self, text):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for path, content in (("reference-data/bibliography.bib", BIBLIOGRAPHY), ("solver/mesh/a.hpp", text)):
                (root / path).parent.mkdir(parents=True)
                (root / path).write_text(content)
            done = subprocess.run([sys.executable, CHECK, root], capture_output=True, text=True)
            return done.returncode, done.stdout

    def test_known_works(self):
        self.assertEqual(self.check("/// as in [Song 2018, Eq. (2.1)] and [Kaya & Erdogan 1987; Song 2018]")[0], 0)

    def test_unknown_author_or_year(self):
        for text in ("[Tada 2000]", "[Song 2004]", "[Song 2018; Byers 1987]", "[Chu, Fan & Lin 2005]"):
            status, output = self.check(f"line\n/// {text}")
            self.assertEqual(status, 1, text)
            self.assertIn("solver/mesh/a.hpp:2", output)

    def test_citation_over_two_lines_of_a_comment(self):
        self.assertEqual(self.check("/// as [Kaya and\n/// Erdogan 1987]")[0], 0)
        self.assertIn("[Tada … 2000]", self.check("/// as [Tada\n/// 2000]")[1])

    def test_no_citation_at_all_is_suspicious(self):
        self.assertEqual(self.check("nothing")[0], 1)


if __name__ == "__main__":
    unittest.main()
