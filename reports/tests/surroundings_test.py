"""The figures of water and rock from invented runs: what they show, and that nothing missing or wrong passes."""
import json
import math
import pathlib
import tempfile
import unittest

from reports import page, surroundings, surroundings_runs
from reports.figures import FigureError
from reports.records import Benchmark
from reports.studies import LayoutError
from reports.surroundings import Sources

CASE = '[[reference]]\nname = "extremes"\nvalue = [-0.02, 0.03]\n[[check]]\nname = "real"\ntolerance = {tolerance}\n'


def benchmark(method, steps, seconds, error=1e-15, stated=0.0):
    return Benchmark("convolution_benchmark", f"{method}/n:20/N:{steps}/threads:1/iterations:1", seconds, seconds, 1,
                     {"error": error, "stated": stated, "plain_seconds": 1e-7 * steps**2}, "")


def write(folder):
    """Runs and cases below `folder` as surroundings_runs and the catalogue have them; none of it was computed."""
    def summary(name, quantities):
        (folder / "runs" / name).mkdir(parents=True, exist_ok=True)
        (folder / "runs" / name / "summary.json").write_text(json.dumps({"status": "completed", "quantities": quantities}))

    table = surroundings_runs.reference(surroundings_runs.SPECTRUM)
    for bottom in ("rigid", "absorbing"):
        known = dict(zip(table["r"], zip(table[f"{bottom}_real"], table[f"{bottom}_imaginary"])))
        exact = [[0.5 * v for v in known.get(r, (1.2, 0.0))] for r in surroundings_runs.frequency_ratios()]
        summary(f"spectrum-{bottom}", {"force": exact})
        summary(f"spectrum-{bottom}-face", {"force": [[a + 1e-4, b] for a, b in exact]})
        for name, latest in ((f"impulse-{bottom}", 20.0 if bottom == "rigid" else 1.0), (f"impulse-{bottom}-face", 20.0)):
            summary(name, {"impulse_force": [math.exp(-t) for t in surroundings_runs.impulse_times(latest)]})
    summary("strip", {"impedance": [{letter: [1.0, a] for letter in "HVR"} for a in surroundings_runs.strip_frequencies()]})
    for dam in surroundings.DAMS:
        summary(f"koyna-{dam}", {"energy_balance_error": 1e-12})
        rows = ["time [s],crest_displacement_x [m],kinetic_energy [J/m],strain_energy [J/m],damped_energy [J/m],input_energy [J/m],load_energy [J/m],radiated_energy [J/m]"]
        rows += [f"{0.1 * i!r},{0.01 + 0.03 * math.sin(0.5 * i)!r},{1e6 * i},7e5,{2e6 * i},{4.5e6 * i},{-0.5e6 * i},{1e6 * i}" for i in range(20)]
        (folder / "runs" / f"koyna-{dam}" / "history.csv").write_text("\n".join(rows) + "\n")
    for identity in ("reservoir/spectrum-rigid", "reservoir/spectrum-absorbing", "reservoir/face-rigid", "reservoir/face-absorbing",
                     *surroundings.DAM_CASES.values()):
        path = folder / "cases" / f"{identity}.case.toml"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(CASE.format(tolerance=4e-4 if "face" in identity else 1e-6))
    methods = [benchmark("blocked_direct", 1000, 0.02), benchmark("block_fft", 100000, 2.0), benchmark("block_fft", 1000, 0.01),
               benchmark("state_space", 1000, 4.0, 2e-5, 3e-3)]
    return Sources(folder / "runs", folder / "cases", methods)


class Surroundings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.sources = write(pathlib.Path(folder.name))

    def shown(self, figure, **changes):
        layout = {"surroundings": [{"figure": figure, "title": "a", "words": "b", "caption": "c"}]}
        return surroundings.read(Sources(**{**vars(self.sources), **changes}), layout)[0]

    def test_every_figure_of_the_layout_draws_and_follows_the_page_colours(self):
        layout = page.read_layout()
        found = surroundings.read(self.sources, layout)
        self.assertEqual([w["figure"] for w in layout["surroundings"]], list(surroundings.SECTIONS))
        for scene in found:
            self.assertIn("var(--s1)", scene.picture, scene.title)
            self.assertTrue(scene.words and scene.rows, scene.title)
        self.assertEqual(surroundings.read(self.sources, {}), [])

    def test_spectrum_states_its_error_beside_the_bar_of_the_case(self):
        rows = dict(self.shown("spectrum").rows)
        self.assertEqual(rows["rigid bottom, α = 1: 10 elements"], "10⁻⁴; bar 2·10⁻⁴")
        self.assertEqual(rows["absorbing bottom, α = 0.75: formula, off by at most"], "0; bar 5·10⁻⁷")

    def test_crest_moves_from_where_it_stood_and_stands_beside_the_independent_extremes(self):
        rows = self.shown("crest").rows
        self.assertEqual(rows[0][0], "empty reservoir, rigid rock")
        self.assertRegex(rows[0][1], r"^−29\.\d+ … 29\.\d+ mm$")
        self.assertEqual(rows[1], ("the same, independent program", "−20 … 30 mm"))
        self.assertEqual(len(rows), len(surroundings.DAMS) + len(surroundings.DAM_CASES))

    def test_convolution_is_compared_with_the_plain_sum_of_the_same_length(self):
        rows = dict(self.shown("convolution").rows)
        self.assertEqual(rows["block FFT, 100000 steps"], "2 s, 1/500 of the plain sum")

    def test_energies_that_do_not_add_up_fail(self):
        path = self.sources.runs / "koyna-compressible/history.csv"
        *rows, last = path.read_text().splitlines()
        path.write_text("\n".join([*rows, last.replace("38000000.0", "38000200.0")]) + "\n")
        with self.assertRaisesRegex(FigureError, "surroundings-energy: at 1.9 s the parts are"):
            self.shown("energy")

    def test_what_is_missing_or_did_not_finish_fails_by_name(self):
        with self.assertRaisesRegex(LayoutError, "no figure 'tide'; there are spectrum, "):
            self.shown("tide")
        with self.assertRaisesRegex(LayoutError, "no convolution_benchmark of all three methods"):
            self.shown("convolution", benchmarks=self.sources.benchmarks[:2])
        (self.sources.runs / "koyna-rock/history.csv").unlink()
        with self.assertRaisesRegex(LayoutError, "koyna-rock/history.csv is not there; ci/report makes it"):
            self.shown("crest")
        (self.sources.runs / "strip/summary.json").write_text('{"status": "stopped: no"}')
        with self.assertRaisesRegex(LayoutError, "strip: stopped: no"):
            self.shown("impedance")
        (self.sources.runs / "strip/summary.json").write_text('{"status": "completed", "quantities": {"impedance": []}}')
        with self.assertRaisesRegex(LayoutError, "strip: 0 values for 20 places"):
            self.shown("impedance")
        (self.sources.runs / "impulse-rigid/summary.json").unlink()
        with self.assertRaisesRegex(LayoutError, "impulse-rigid/summary.json is not there"):
            self.shown("impulse")
        (self.sources.cases / "reservoir/face-rigid.case.toml").unlink()
        with self.assertRaisesRegex(LayoutError, "no case 'reservoir/face-rigid'"):
            self.shown("spectrum")

    def test_runs_have_names_of_their_own_and_scenes_that_are_there(self):
        runs = surroundings_runs.runs()
        self.assertEqual(len({run.name for run in runs}), len(runs))
        for run in runs:
            self.assertTrue((surroundings_runs.CASES / f"{run.scene}.scene.toml").is_file(), run.scene)


if __name__ == "__main__":
    unittest.main()
