"""What changed between two sets of records, and the exit status that says whether something became worse."""
import contextlib
import io
import pathlib
import tempfile
import unittest

from reports import compare
from reports.tests import synthetic


def cases(**changes):
    """Three cases; `changes` are those of the second's check, or of the case itself (cpu_seconds, version)."""
    own = {k: changes.pop(k) for k in ("cpu_seconds", "version") if k in changes}
    check = synthetic.check("K_I", 1e-4, 1e-3)
    check.update(changes)
    return [synthetic.case("patch/a"), {**synthetic.case("sif/b", checks=[check]), "cpu_seconds": 1.0, **own}, synthetic.ladder_case("stability/c", 7)]


class Compare(unittest.TestCase):
    def written(self, records):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        synthetic.write(pathlib.Path(folder.name), cases=records)
        return pathlib.Path(folder.name)

    def changes(self, old, new):
        (was, _), (now, _) = compare.read(self.written(old)), compare.read(self.written(new))
        return [(c["kind"], c["id"], c["words"]) for c in compare.compare(was, now)]

    def test_equal_records_have_no_change(self):
        self.assertEqual(self.changes(cases(), cases()), [])

    def test_cases_and_checks_come_and_go(self):
        self.assertEqual(self.changes(cases()[1:], cases()[:2]), [("added", "patch/a", "case"), ("removed", "stability/c", "case")])
        self.assertEqual(self.changes(cases(), cases(name="K_II")),
                         [("added", "sif/b", "check K_II"), ("removed", "sif/b", "check K_I")])

    def test_errors_move_by_a_factor_and_are_named(self):
        self.assertEqual(self.changes(cases(), cases(error=4e-4)), [("worse", "sif/b", "error of K_I 10⁻⁴ → 4·10⁻⁴, 4 ×")])
        self.assertEqual(self.changes(cases(), cases(error=2e-5)), [("better", "sif/b", "error of K_I 10⁻⁴ → 2·10⁻⁵, 0.2 ×")])
        self.assertEqual(self.changes(cases(), cases(error=1.2e-4)), [])
        self.assertEqual(self.changes(cases(error=1e-9), cases(error=9e-8)), [])  # far below the tolerance: round-off

    def test_a_check_that_fails_or_whose_tolerance_is_loosened_is_worse(self):
        self.assertEqual(self.changes(cases(), cases(status="wrong value")), [("worse", "sif/b", "K_I: pass → wrong value")])
        self.assertEqual(self.changes(cases(status="wrong value"), cases()), [("better", "sif/b", "K_I: wrong value → pass")])
        self.assertEqual(self.changes(cases(), cases(status="changed pin")), [("pin", "sif/b", "K_I: pass → changed pin")])
        self.assertEqual(self.changes(cases(), cases(tolerance=1e-2)), [("worse", "sif/b", "K_I: tolerance 0.001 → 0.01")])

    def test_costs_and_versions(self):
        self.assertEqual(self.changes(cases(), cases(cpu_seconds=3.0)), [("worse", "sif/b", "CPU time 1 s → 3 s, 3 ×")])
        self.assertEqual(self.changes(cases(), cases(cpu_seconds=1.3)), [])
        self.assertEqual(self.changes(cases(), cases(version=2, cpu_seconds=9.0)),
                         [("added", "sif/b", "version 1 → 2: a new claim, its history begins")])

    def test_a_ladder_that_breaks_earlier_is_worse(self):
        lower = [*cases()[:2], synthetic.ladder_case("stability/c", 5)]
        self.assertEqual(self.changes(cases(), lower), [("worse", "stability/c", "first failing rung 7 → 5")])

    def test_exit_status(self):
        old, worse = self.written(cases()), self.written(cases(error=9e-4))
        for arguments, status, said in (((old, old), 0, "worse: 0"), ((old, worse), 1, "sif/b: error of K_I"), ((worse, old), 0, "better: 1"),
                                        ((old, old / "none"), 2, "no such file")):
            with self.subTest(status=status), contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(out):
                self.assertEqual(compare.main([str(a) for a in arguments]), status)
            self.assertIn(said, out.getvalue())

    def test_section_counts_what_changed_since_the_old_commit(self):
        new, facts = compare.read(self.written(cases(error=4e-4)))
        section = compare.section(self.written(cases()), list(new.values()), facts)
        self.assertTrue(section["words"].startswith("Since 0123abc: 0 added · 0 removed · 1 worse · 0 better · 0 changed pins."), section["words"])
        self.assertEqual([g["name"] for g in section["groups"]], ["worse"])
        self.assertTrue(section["same_machine"])


if __name__ == "__main__":
    unittest.main()
