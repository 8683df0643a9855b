"""The page: what it says, that it is the same bytes for the same records, and how it behaves in a real browser."""
import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

from reports import crack_water, evidence, figures, page, pdf, records, scenes
from reports.bibliography import Work
from reports.browser import Browser
from reports.front import Point
from reports.page import LayoutError
from reports.tests import synthetic

LAYOUT = pathlib.Path(__file__).parent / "synthetic_layout.toml"
WORKS = {"isida-1971": Work("Isida 1971", "Isida, Effect of width and length, 1971")}
ROOT = pathlib.Path(__file__).parent.parent.parent

# What is wider than the screen without a scroll box of its own, by tag and class.
OVERFLOWING = """[...document.querySelectorAll('main *')].filter(e => {
    const r = e.getBoundingClientRect();
    return r.width > 0 && r.right > innerWidth + 1 && !e.closest('.scroll, svg');
}).map(e => e.tagName + '.' + e.className)"""
# Words that run out of their own box onto what stands beside them.
COVERED = "[...document.querySelectorAll('.badge, summary > *')].filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0).map(e => e.textContent)"
# Figures without a size or without a drawn line; links into the page that lead nowhere; identifiers used twice.
FIGURES = "[...document.querySelectorAll('svg.figure')].map(s => [s.getBoundingClientRect().width, s.querySelectorAll('path').length])"
DEAD_LINKS = "[...document.querySelectorAll('a[href^=\"#\"]')].map(a => a.getAttribute('href').slice(1)).filter(i => !document.getElementById(i))"
REPEATED = "(() => { const all = [...document.querySelectorAll('[id]')].map(e => e.id); return all.filter((v, i) => all.indexOf(v) !== i); })()"
SHOWN = "[...document.querySelectorAll('details.case')].filter(c => !c.hidden).map(c => c.id)"


@functools.cache
def view(good=True):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        synthetic.write(folder, good=good)
        layout = page.read_layout(LAYOUT)
        return page.view(records.read(folder, folder / "cases"), layout, WORKS, scenes.read(folder / "scenes", layout))


def run_reports(folder, *arguments, hash_seed="0"):
    """The program on the records in `folder`, as ci/report calls it."""
    return subprocess.run([sys.executable, "-B", "-m", "reports", "--records", folder, "--cases", folder / "cases", "--layout", LAYOUT,
                           *arguments], cwd=ROOT, capture_output=True, text=True, env={**os.environ, "PYTHONHASHSEED": hash_seed})


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Contents(Folder):
    def test_verdict_of_a_good_day(self):
        verdict = view()["verdict"]
        self.assertTrue(verdict["good"])
        self.assertRegex(verdict["sentence"], r"^All 24 checks of 16 cases pass, \d+ % of them .*4 of 4 planted faults are noticed")

    def test_verdict_of_a_bad_day_names_the_cases(self):
        verdict = view(good=False)["verdict"]
        self.assertFalse(verdict["good"])
        self.assertEqual(verdict["sentence"], "4 of 20 cases fail: “Arc crack”, “Kinked crack” and 2 more; 2 of 28 checks are red; "
                         "3 of 4 planted faults are noticed.")

    def test_survived_fault_alone_spoils_the_verdict(self):
        synthetic.write(self.folder, cases=[synthetic.case("patch/a", negatives=[synthetic.negative("f", ["stress"], "survived")])])
        verdict = evidence.verdict(records.read(self.folder, self.folder / "cases").cases)
        self.assertEqual((verdict["good"], verdict["word"]), (False, "Not proven."))

    def test_trust_matrix_counts_checks_by_evidence(self):
        matrix = view(good=False)["matrix"]
        columns = [name for name, _ in matrix["columns"]]
        row = next(r for r in matrix["rows"] if r["family"] == "sif")
        cell = {name: (c.kind, c.text) for name, c in zip(columns, row["cells"])}
        self.assertEqual(cell["high-precision"], ("full", "1"))
        self.assertEqual(cell["refusal"], ("full", "1"))
        self.assertEqual(cell["exact"], ("part", "4/6"))
        self.assertEqual(cell["ladder"], ("none", ""))
        self.assertEqual(cell["published"], ("none", ""))  # its only check informs and does not gate
        self.assertEqual(next(r for r in matrix["rows"] if r["family"] == "koyna")["cells"], [])

    def test_kill_matrix_is_as_good_as_its_worst_case(self):
        row = next(r for r in view(good=False)["kills"]["rows"] if r["fault"] == "sbfem/mass-factor-two")
        self.assertFalse(row["killed"])
        self.assertEqual(row["verdict"], "survived")

    def test_time_to_an_error_is_the_fastest_setting_that_reaches_it(self):
        problem = view()["problems"][0]
        self.assertEqual([t["seconds"] for t in problem["times"]], ["1.1 ms", "1.5 ms", "6.2 ms"])
        self.assertEqual(problem["factor"], "1 ×")
        self.assertEqual([s["case"].id for s in view()["sweeps"]], ["modal/roller-square"])  # the others belong to a problem

    def test_default_that_costs_too_much_is_explained_or_marked(self):
        cases = synthetic.catalogue()
        for setting in next(c for c in cases if c["id"] == "sif/edge-crack")["settings"]:
            if setting["default"]:
                setting["cpu_seconds"] *= 10
        for explained in ("", "It holds a dam."):
            with self.subTest(explained=explained), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                synthetic.write(folder, cases=cases)
                layout = page.read_layout(LAYOUT)
                layout["problem"] = [{**layout["problem"][0], "explained": explained}]
                text = page.render(page.view(records.read(folder, folder / "cases"), layout, WORKS, []))
                self.assertEqual("✗ not explained" in text, not explained)
                self.assertEqual("It holds a dam." in text, bool(explained))

    def test_first_screen_joins_the_sweeps_of_several_cases(self):
        layout = page.read_layout(LAYOUT)
        layout["problem"].reverse()
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            synthetic.write(folder)
            hero = page.view(records.read(folder, folder / "cases"), layout, WORKS, [])["hero"]
        self.assertIn("32 settings", hero["figure"].caption)
        self.assertIn("tension, cells one", hero["figure"].svg)
        self.assertIn("shear, cells squares, degree 4", hero["figure"].svg)

    def test_difference_of_a_check_that_only_informs_is_no_failure(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            synthetic.write(folder, cases=[synthetic.case("sif/a", checks=[
                synthetic.check("K_I"), synthetic.check("printed", 1.0, 1e-3, gates=False, evidence="published")])])
            cases = records.read(folder, folder / "cases").cases
        self.assertTrue(evidence.verdict(cases)["good"])
        self.assertEqual([page._check_view(c)["status"] for c in cases[0].checks], ["pass", "differs"])

    def test_known_limits_are_listed(self):
        self.assertEqual([l["check"] for l in view(good=False)["limits"]], ["omega_9"])

    def test_first_failing_rung(self):
        ladders = {l["case"].id: l for l in view()["ladders"]}
        sliver = ladders["stability/slivers"]
        self.assertEqual((sliver["failing"], sliver["failing_is_wrong"], sliver["refused"]), ("aspect 10⁷: refused", False, 2))
        sliver = next(l for l in view(good=False)["ladders"] if l["case"].id == "stability/slivers")
        self.assertEqual((sliver["failing"], sliver["failing_is_wrong"], sliver["refused"]), ("aspect 10⁷: wrong value", True, 1))
        self.assertEqual(ladders["stability/short-edges"]["failing"], "")

    def test_sources_are_looked_up_in_the_bibliography(self):
        case = next(c for f in view()["families"] for c in f["cases"] if c["case"].id == "sif/centre-crack")
        self.assertEqual(case["references"][0]["words"], "Isida, Effect of width and length, 1971; Table 2; uncertainty 5·10⁻⁴ of the value")

    def test_text_of_records_cannot_become_markup(self):
        synthetic.write(self.folder, cases=[*synthetic.catalogue(), synthetic.case("patch/z", title="<script>alert(1)</script>")])
        text = page.render(page.view(records.read(self.folder, self.folder / "cases"), page.read_layout(LAYOUT), WORKS, []))
        self.assertNotIn("<script>alert", text)
        self.assertIn("&lt;script&gt;alert", text)


class Missing(Folder):
    """A missing figure or an unexpected empty record fails the build."""

    def fails(self, cases=None, **changes):
        synthetic.write(self.folder, cases=synthetic.catalogue() if cases is None else cases)
        page.view(records.read(self.folder, self.folder / "cases"), {**page.read_layout(LAYOUT), **changes}, WORKS, [])

    def test_first_screen_without_its_case(self):
        with self.assertRaisesRegex(LayoutError, "problem 'a': no record of the case 'sif/none'"):
            self.fails(problem=[{"cases": [{"case": "sif/none"}], "title": "a", "quantity": ""}])

    def test_number_without_its_check(self):
        with self.assertRaisesRegex(LayoutError, "sif/edge-crack has no check 'K_V'; it has K_I"):
            self.fails(number=[{"case": "sif/edge-crack", "check": "K_V", "words": ""}])

    def test_benchmark_figure_without_a_benchmark(self):
        figure = {"title": "a", "pattern": r"none:(?P<size>\d+)", "x": "", "caption": ""}
        with self.assertRaisesRegex(LayoutError, "no benchmark fits"):
            self.fails(benchmark_figure=[figure])

    def test_scene_that_was_not_run_or_did_not_finish(self):
        layout = page.read_layout(LAYOUT)
        with self.assertRaisesRegex(LayoutError, "scene dam: .*dam.svg is not there"):
            scenes.read(self.folder, layout)
        synthetic.write(self.folder)
        shown = scenes.read(self.folder / "scenes", layout)[0]
        self.assertEqual(shown.rows[-1], ("K_I of the dam", "−1.56·10⁶ Pa √m"))
        self.assertIn('stroke="var(--s1)"', shown.picture)
        (self.folder / "scenes/dam/summary.json").write_text('{"status": "stopped: no"}')
        with self.assertRaisesRegex(LayoutError, "stopped: no"):
            scenes.read(self.folder / "scenes", layout)

    def test_crack_water_shows_what_was_printed_beside_ours(self):
        layout = {"crack_water": {"title": "a", "words": "b", "caption": "c", "length": 4.0,
                                  "curve": [{"name": "opening", "run": "x", "printed": "1.2"}, {"name": "resting", "run": "y", "printed": "14.7"}],
                                  "ratio": [{"of": "opening", "to": "resting", "printed": "8.2 %"}]}}
        with self.assertRaisesRegex(LayoutError, "crack_water: .*x/summary.json is not there"):
            crack_water.read(self.folder, layout)
        for name, uplift, pressure in (("x", 1.2332014e6, [4e5, 1e5, 0.0]), ("y", 14.715e6, [4e5, 3e5, 0.0])):
            (self.folder / name).mkdir()
            (self.folder / name / "summary.json").write_text(
                json.dumps({"status": "completed", "quantities": {"uplift_force": uplift, "pressure": pressure}}))
        shown = crack_water.read(self.folder, layout)[0]
        self.assertEqual(shown.rows[0], ("uplift, opening", "1.2332 MN/m; printed 1.2"))
        self.assertEqual(shown.rows[2], ("opening / resting", "8.38 %; printed 8.2 %"))
        self.assertEqual(shown.picture.count('stroke: var(--s1)') > 0, True)
        self.assertEqual(crack_water.read(self.folder, {}), [])

    def test_no_ladder(self):
        with self.assertRaisesRegex(LayoutError, "no ladder"):
            self.fails([c for c in synthetic.catalogue() if c["family"] != "stability"])

    def test_sweep_without_a_single_answer(self):
        cases = synthetic.catalogue()
        for setting in next(c for c in cases if c["id"] == "modal/roller-square")["settings"]:
            setting.update(status="not converged", errors={})
        with self.assertRaisesRegex(figures.FigureError, "no setting has an error and a time"):
            self.fails(cases)

    def test_colour_outside_the_palette(self):
        with self.assertRaisesRegex(figures.FigureError, "not in the palette"):
            with unittest.mock.patch.object(figures, "VARIABLES", {}):
                figures.error_against_time("a", [Point(1, 1, "", "")], [], "x")


class Files(Folder):
    def test_same_records_same_bytes_in_another_process_and_a_pdf_with_text_and_no_date(self):
        synthetic.write(self.folder)
        for seed in ("1", "2"):
            done = run_reports(self.folder, "--output", self.folder / seed, hash_seed=seed)
            self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("index.html", "index.pdf"):
            one, other = ((self.folder / seed / name).read_bytes() for seed in ("1", "2"))
            self.assertEqual(one, other, name)
            self.assertLess(len(one), 10_000_000)
        self.assertIn(b"/CreationDate (D:20000101000000", one)
        text = subprocess.run(["pdftotext", self.folder / "1/index.pdf", "-"], check=True, capture_output=True, text=True).stdout
        for words in ("All 24 checks of 16 cases pass", "Error of K_I against CPU time", "The patch of polynomial order 8 shall agree"):
            self.assertIn(words, " ".join(text.split()))

    def test_pdf_forgets_the_moment_of_printing_and_keeps_its_length(self):
        one, other = (b"/CreationDate (D:2026112210255%d+00'00') /ID (node0000008%d) /ID (node00000009) /K (node0000008%d)" % (d, d, d)
                      for d in (2, 4))
        self.assertNotEqual(one, other)
        self.assertEqual(pdf.without_moment(one), pdf.without_moment(other))
        self.assertEqual(len(pdf.without_moment(one)), len(one))
        self.assertIn(b"(node00000001) /ID (node00000000) /K (node00000001)", pdf.without_moment(one))

    def test_standalone_figure_needs_no_style_sheet(self):
        svg = figures.standalone(figures.error_against_time("a", [Point(1e-3, 1e-2, "", ""), Point(1e-2, 1e-4, "", "")], [], "K_I"))
        self.assertNotIn("var(--", svg)
        self.assertIn('xmlns="http://www.w3.org/2000/svg"', svg)

    def test_unusable_records_end_with_status_one_and_a_named_reason(self):
        done = run_reports(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("catalogue.jsonl: no such file; ci/verify writes it", done.stderr)


class InTheBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        folder = pathlib.Path(cls.temporary.name)
        cls.page = folder / "page.html"
        cls.page.write_text(page.render(view(good=False)), encoding="utf-8")
        cls.browser = cls.enterClassContext(Browser())

    def opened(self, width, dark=False):
        self.browser.open(self.page, width=width, dark=dark)
        return self.browser

    def test_shows_everything_at_phone_and_desk_width_without_an_error_or_a_request(self):
        for width in (390, 1280):
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    browser = self.opened(width, dark)
                    self.assertEqual(browser.evaluate("innerWidth"), width)
                    self.assertEqual(browser.evaluate("document.documentElement.scrollWidth"), width)
                    browser.evaluate("document.getElementById('open-all').click()")
                    self.assertEqual(browser.evaluate("document.documentElement.scrollWidth"), width)
                    self.assertEqual(browser.evaluate(OVERFLOWING), [])
                    self.assertEqual(browser.evaluate(COVERED), [])
                    drawn = browser.evaluate(FIGURES)
                    self.assertEqual(len(drawn), 1 + 1 + 3 + 3 + 1 + 1)  # first screen, scene, sweeps, ladders, order, benchmarks
                    self.assertTrue(all(wide >= 300 and paths >= 1 for wide, paths in drawn), drawn)
                    self.assertEqual(browser.console, [])
                    self.assertEqual(browser.requests, [self.page.resolve().as_uri()])

    def test_every_link_leads_somewhere_and_no_identifier_is_used_twice(self):
        browser = self.opened(1280)
        self.assertEqual(browser.evaluate(DEAD_LINKS), [])
        self.assertEqual(browser.evaluate(REPEATED), [])

    def test_text_is_readable_on_a_phone(self):
        browser = self.opened(390)
        smallest = browser.evaluate("""Math.min(...[...document.querySelectorAll('svg.figure text')].map(t => {
            const box = t.ownerSVGElement; return parseFloat(getComputedStyle(t).fontSize) * box.getBoundingClientRect().width / box.viewBox.baseVal.width;
        }))""")
        self.assertGreaterEqual(smallest, 7.5)

    def test_figures_follow_the_dark_scheme(self):
        ink = "getComputedStyle(document.querySelector('svg.figure text')).fill"
        self.assertNotEqual(self.opened(1280).evaluate(ink), self.opened(1280, dark=True).evaluate(ink))

    def test_link_to_a_case_opens_it(self):
        browser = self.opened(1280)
        case = "document.getElementById('case-sif-edge-crack')"
        self.assertFalse(browser.evaluate(f"{case}.open"))
        browser.evaluate("document.querySelector('a[href=\"#case-sif-edge-crack\"]').click()")
        browser.evaluate("new Promise(r => setTimeout(r, 50))")
        self.assertTrue(browser.evaluate(f"{case}.open"))
        self.assertLess(abs(browser.evaluate(f"{case}.getBoundingClientRect().top")), 40)

    def search(self, words, family=""):
        return self.browser.evaluate(f"""(() => {{
            const search = document.getElementById('search'), family = document.getElementById('family');
            search.value = {words!r}; family.value = {family!r};
            search.dispatchEvent(new Event('input'));
            return {SHOWN}; }})()""")

    def test_search_and_filter(self):
        self.opened(390)
        every = self.search("")
        self.assertEqual(len(every), 20)
        self.assertEqual(self.search("edge shear"), ["case-sif-edge-crack-shear"])
        self.assertEqual(self.search("ISIDA"), ["case-sif-centre-crack"])
        self.assertEqual(len(self.search("", "stability")), 3)
        self.assertEqual(self.search("no such case"), [])
        self.assertEqual(self.browser.evaluate("getComputedStyle(document.getElementById('none-found')).display"), "block")

    def test_link_to_a_case_that_the_search_hides_shows_it(self):
        self.opened(1280)
        self.search("edge shear")
        self.browser.evaluate("location.hash = 'case-sif-arc-crack'")
        self.browser.evaluate("new Promise(r => setTimeout(r, 50))")
        self.assertTrue(self.browser.evaluate("document.getElementById('case-sif-arc-crack').open"))

    def test_browser_notices_what_the_checks_rely_on(self):
        bad = pathlib.Path(self.temporary.name) / "bad.html"
        bad.write_text("<main><p style='width: 4000px'>wide</p></main><script>console.error('told')</script><img src='absent.png'>")
        self.browser.open(bad, width=1280)
        self.assertTrue(any("told" in line for line in self.browser.console))
        self.assertEqual(len(self.browser.requests), 2)
        self.assertEqual(self.browser.evaluate(OVERFLOWING), ["P."])


if __name__ == "__main__":
    unittest.main()
