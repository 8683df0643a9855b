"""The section "Costs": what is there is shown, what is not is named with the command that makes it."""
import pathlib
import tempfile
import unittest

from reports import costs

LIMITS = """
[[region]]
name = "direct-convolution"
instructions = 12345678
allocations = 0
peak_bytes = 2000000
reason = "half of the products"
[[region]]
name = "not-counted-yet"
instructions = 0
allocations = 0
peak_bytes = 0
reason = "-"
"""


# As `sunder ablate` prints it.
ABLATION = """Koyna: what each part costs and changes

left out                 CPU [s]  its share  K_I [MPa√m]
nothing                     12.1                     4.2
ground motion: vertical       11        9 %     4 (−5 %)
gravity                      0.1                       –

without gravity: refused: no
"""


class CostSection(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_names_what_is_missing_and_its_command(self):
        found = costs.read(self.folder, self.folder, self.folder / "none.toml")
        self.assertEqual([m.split(":")[0] for m in found["missing"]],
                         ["counted instructions", "a history of counts", "the profile on two cores", "what each part of a scene costs"])
        self.assertIn("ci/history append", found["missing"][1])

    def test_counts_and_the_table_of_parts(self):
        (self.folder / "limits.toml").write_text(LIMITS)
        (self.folder / "ablation").mkdir()
        (self.folder / "ablation/koyna.txt").write_text(ABLATION)
        found = costs.read(self.folder, self.folder, self.folder / "limits.toml")
        self.assertEqual([(r["name"], r["instructions"], r["peak"]) for r in found["counts"]], [("direct convolution", "12\u202f345\u202f678", "2 MB")])
        self.assertEqual(found["ablations"], [{
            "name": "Koyna", "head": ["left out", "CPU [s]", "its share", "K_I [MPa√m]"],
            "rows": [["nothing", "12.1", "", "4.2"], ["ground motion: vertical", "11", "9 %", "4 (−5 %)"], ["gravity", "0.1", "", "–"]],
            "notes": ["without gravity: refused: no"]}])


if __name__ == "__main__":
    unittest.main()
