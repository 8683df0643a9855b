"""The chapter "Koyna": numbers beside the paper's, what is missing fails, the film's pictures and its keys."""
import json
import math
import pathlib
import re
import tempfile
import unittest
import unittest.mock

from reports import koyna, koyna_runs, koyna_slider, page, records, scenes
from reports.bibliography import Work
from reports.browser import Browser
from reports.studies import LayoutError
from reports.tests import koyna_synthetic, synthetic

LAYOUT = koyna_synthetic.LAYOUT


def changed(**more):
    return {"koyna": {**LAYOUT["koyna"], **more}}


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        koyna_synthetic.write(self.folder)


class Numbers(Folder):
    def test_printed_number_beside_ours_and_the_other_program(self):
        length, uplift = koyna.read(self.folder, LAYOUT)["printed"]
        self.assertEqual((length["what"], length["printed"], length["ours"], length["difference"], length["independent"]),
                         ("crack length, model 2, 4.05 s", "10.0", "12.2", "+22 %", "23.5"))  # 1 + 12 · 2.05 / 2.2
        self.assertEqual((uplift["ours"], uplift["difference"], uplift["independent"]), ("2250", "+5 %", "–"))

    def test_conclusions_are_tested_and_not_repeated(self):
        told = {d["words"]: d["holds"] for d in koyna.read(self.folder, LAYOUT)["directions"]}
        self.assertTrue(told["model 1 ends shortest"])
        self.assertTrue(told["at 4.45 s it presses more"])
        self.assertFalse(told["model 1 follows the others to 4.05 s"])

    def test_energy_account_closes_and_a_dropped_work_shows(self):
        run = koyna.read_run(self.folder, "model-3")
        self.assertLess(koyna.account(run)[3], 1e-12)
        run.history["damped_energy"] = [0.0] * len(run.history["time"])
        self.assertGreater(koyna.account(run)[3], 0.1)

    def test_run_that_ended_early_has_no_numbers_after_its_end(self):
        koyna_synthetic.write_run(self.folder, "model-2-rock", 2, until=4.2, status="stopped: the crack cuts the dam through")
        row = next(r for r in koyna.read(self.folder, LAYOUT)["sensitivity"] if r["words"] == "rock")["runs"][0]
        self.assertEqual(row["lengths"][1], "–")
        self.assertEqual(row["ending"], "stopped: the crack cuts the dam through, at 4.20 s")

    def test_run_that_cut_the_dam_through_says_so_and_the_other_program_stands_beside(self):
        path = self.folder / "model-3-level-103/summary.json"
        run = json.loads(path.read_text())
        run["quantities"]["events"] = [{"time": 3.5, "event": "reached downstream"}, {"time": 3.5, "event": "cut through"}]
        path.write_text(json.dumps(run))
        base, level = koyna.read(self.folder, LAYOUT)["sensitivity"][:2]
        self.assertEqual([r["ending"] for r in level["runs"]], ["", "the crack cut the dam through at 3.50 s"])
        self.assertEqual([r["other"] for r in base["runs"] + level["runs"]], ["23.5 / 23.5", "25.5 / 28.5", "–", "–"])

    def test_fixed_crack_is_set_beside_the_other_program(self):
        row = koyna.read(self.folder, LAYOUT)["stationary"][0]
        self.assertEqual((row["largest"], row["other"], row["difference"], row["first"]), ("8", "8.06", "−0.7 %", "0.26"))
        self.assertEqual(row["other_first"], "2.27")


class Missing(Folder):
    def fails(self, words, layout=LAYOUT):
        with self.assertRaisesRegex(LayoutError, words):
            koyna.read(self.folder, layout)

    def test_run_is_absent(self):
        (self.folder / "model-3-gap/summary.json").unlink()
        self.fails("model-3-gap/summary.json is not there")

    def test_model_did_not_finish(self):
        koyna_synthetic.write_run(self.folder, "model-1", 1, status="stopped: no")
        self.fails("model-1: stopped: no")

    def test_profile_is_absent(self):
        self.fails("model 2 has no profile at 4.2 s", changed(times=[4.05, 4.2]))

    def test_fields_or_mesh_are_absent(self):
        (self.folder / "model-3/results.h5").unlink()
        self.fails("results.h5 is not there")
        (self.folder / "mesh.svg").unlink()
        self.fails("mesh.svg is not there")

    def test_no_chapter_without_its_table(self):
        self.assertIsNone(koyna.read(self.folder, {}))


class Film(Folder):
    def test_pictures_change_mesh_and_move(self):
        times, meshes, mesh_of, moved = koyna_slider.pictures(self.folder / "model-3/results.h5")
        self.assertEqual([round(t, 9) for t in times], [0, 0.1, 0.2, 0.3, 0.4, 0.5])
        self.assertEqual(mesh_of, [0, 0, 0, 1, 1, 1])
        self.assertEqual([len(points) for points, _, _ in meshes], [4, 5])
        self.assertEqual((len(meshes[0][1]), len(meshes[0][2])), (4, 1))  # outline of two triangles and the edge between them
        self.assertEqual((moved[4] * koyna_slider.DISPLACEMENT).max(), 0.004)

    def test_displacement_beyond_the_film_is_refused(self):
        koyna_synthetic.write_fields(self.folder / "model-3/results.h5", displacement=0.1)
        with self.assertRaisesRegex(LayoutError, "beyond 0.328 m"):
            koyna.read(self.folder, LAYOUT)

    def test_film_that_is_too_large_is_refused(self):
        with unittest.mock.patch.object(koyna_slider, "LARGEST", 100), self.assertRaisesRegex(LayoutError, "more than 100"):
            koyna.read(self.folder, LAYOUT)


class Runs(unittest.TestCase):
    def test_every_run_of_the_layout_once_with_what_it_changes(self):
        found = {job.name: job for job in koyna_runs.jobs(LAYOUT)}
        self.assertEqual(len(found), 3 + 5 + 1)
        self.assertEqual(found["model-2-rock"].settings, ('crack_water.model="uniform"',))
        self.assertEqual((found["model-3-rock"].scene, found["model-3-rock"].settings), ("flexible", ()))
        self.assertEqual(found["model-3"].settings, ("output.fields_every=10", "output.profile_times=[0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 4.05, 4.45]"))
        self.assertEqual(found["model-2"].settings, ())

    def test_two_runs_of_one_name(self):
        with self.assertRaisesRegex(LayoutError, "two runs have the name"):
            koyna_runs.jobs(changed(change=LAYOUT["koyna"]["change"] * 2))

    def test_report_s_own_layout_names_scenes_that_exist_and_references_that_are_there(self):
        layout = page.read_layout()
        for job in koyna_runs.jobs(layout):
            self.assertTrue((koyna_runs.SCENES / f"{job.scene}.scene.toml").is_file(), job.scene)
        known = {row["case"] for row in koyna._table(koyna.DATA / "independent-koyna-2026/stationary.csv")}
        self.assertLessEqual({c["name"] for c in layout["koyna"]["stationary"]["case"]}, known)


class InTheBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        synthetic.write(folder)
        koyna_synthetic.write(folder / "koyna")
        layout = {**page.read_layout(pathlib.Path(__file__).parent / "synthetic_layout.toml"), **LAYOUT}
        works = {"isida-1971": Work("Isida 1971", "Isida 1971")}
        cls.text = page.render(page.view(records.read(folder, folder / "cases"), layout, works, scenes.read(folder / "scenes", layout),
                                         koyna.read(folder / "koyna", layout)))
        cls.page = folder / "page.html"
        cls.page.write_text(cls.text, encoding="utf-8")
        cls.browser = cls.enterClassContext(Browser())

    def film(self, expression):
        return self.browser.evaluate(f"(() => {{ const film = document.querySelector('.film'), slider = film.querySelector('input'); return {expression}; }})()")

    def test_fits_phone_and_desk_without_an_error(self):
        for width in (390, 1280):
            self.browser.open(self.page, width=width)
            self.assertEqual(self.browser.evaluate("document.documentElement.scrollWidth"), width)
            self.assertEqual(self.browser.console, [])

    def test_script_draws_the_first_picture_as_the_page_does(self):
        self.browser.open(self.page)
        drawn = "[...film.querySelectorAll('path')].map(p => p.getAttribute('d'))"
        before = self.film(drawn)
        self.assertEqual(len(before), 6)
        self.film("slider.dispatchEvent(new Event('input'))")
        after = self.film(drawn)
        for one, other in zip(before, after):
            numbers = [[float(v) for v in re.findall(r"-?[0-9.]+", text)] for text in (one, other)]
            self.assertEqual(len(numbers[0]), len(numbers[1]))
            self.assertTrue(all(math.isclose(a, b, abs_tol=0.11) for a, b in zip(*numbers)))  # a digit rounded the other way

    def test_arrow_key_moves_the_film(self):
        self.browser.open(self.page)
        self.film("slider.focus()")
        outer = "film.querySelector('.outer').getAttribute('d')"
        before = self.film(outer)
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key="ArrowRight", code="ArrowRight", windowsVirtualKeyCode=39)
        self.assertEqual(self.film("slider.value"), "4")
        self.assertNotEqual(self.film(outer), before)
        self.assertEqual(self.film("film.querySelector('output').textContent"), "0.40 s · crack 1.0 m")

    def test_play_runs_to_the_end_and_stops(self):
        self.browser.open(self.page)
        self.film("film.querySelector('.play').click()")
        self.browser.evaluate("new Promise(r => setTimeout(r, 1000))")
        self.assertEqual((self.film("slider.value"), self.film("film.querySelector('.play').textContent")), ("5", "Play"))

    def test_film_in_the_page_is_small_and_readable(self):
        data = json.loads(re.search(r'class="film-data">(.*?)</script>', self.text, re.S).group(1))
        self.assertEqual(data["mesh"], [0, 0, 0, 1, 1, 1])
        self.assertEqual(data["water"][0][0], [0.0, 300.0])


if __name__ == "__main__":
    unittest.main()
