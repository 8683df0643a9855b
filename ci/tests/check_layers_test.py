"""ci/check-layers must notice each kind of breach, in a tree written for the purpose."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).parent.parent / "check-layers"
LAYERS = "numerics 0 \nmesh 1 numerics\nsbfem 2 numerics mesh\nsimulation 5 numerics mesh sbfem\napp 6 simulation\n"
CLEAN = {
    "solver/numerics/root.hpp": "#pragma once\n#include <vector>\n",
    "solver/mesh/polygon.hpp": '#pragma once\n#include "solver/numerics/root.hpp"\n',
    "solver/sbfem/stiffness.hpp": '#include "solver/mesh/polygon.hpp"\n',
    "solver/simulation/run.hpp": '#include "solver/sbfem/stiffness.hpp"\n',
    "verification/exact/beam.hpp": "#include <cmath>\n",
    "verification/harness/runner.cpp": '#include "solver/simulation/run.hpp"\n#include "verification/exact/beam.hpp"\n',
    "benchmarks/sbfem_benchmark.cpp": '#include "solver/sbfem/stiffness.hpp"\n',
}


class CheckLayers(unittest.TestCase):
    def check(self, changes, layers=LAYERS):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**CLEAN, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            (root / "layers.txt").write_text(layers)
            done = subprocess.run([sys.executable, CHECK, root / "layers.txt", root], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def assert_noticed(self, changes, *words):
        status, output = self.check(changes)
        self.assertEqual(status, 1, output)
        for word in words:
            self.assertIn(word, output)

    def test_clean_tree_obeys(self):
        status, output = self.check({})
        self.assertEqual(status, 0, output)

    def test_upward_include(self):
        self.assert_noticed({"solver/mesh/dual.cpp": '\n#include "solver/sbfem/stiffness.hpp"\n'}, "solver/mesh/dual.cpp:2")

    def test_downward_include_that_is_not_declared(self):
        changes = {"solver/app/main.cpp": '#include "solver/numerics/root.hpp"\n'}
        self.assert_noticed(changes, "solver/app/main.cpp:1", "app may include app, simulation")

    def test_tests_of_a_module_obey_too(self):
        self.assert_noticed({"solver/mesh/tests/dual_test.cpp": '#include "solver/sbfem/stiffness.hpp"\n'}, "dual_test.cpp:1")

    def test_solver_never_includes_verification(self):
        self.assert_noticed({"solver/mesh/dual.cpp": '#include "verification/exact/beam.hpp"\n'}, "dual.cpp:1")

    def test_exact_answers_include_nothing_of_the_solver(self):
        changes = {"verification/exact/beam.hpp": '#include "solver/numerics/root.hpp"\n'}
        self.assert_noticed(changes, "verification/exact/beam.hpp:1", "shares no code")

    def test_unknown_module(self):
        self.assert_noticed({"solver/extra/a.hpp": '#include "solver/extra/b.hpp"\n', "solver/extra/b.hpp": ""}, "not in the table")

    def test_relative_path(self):
        self.assert_noticed({"solver/mesh/dual.cpp": '#include "polygon.hpp"\n'}, "no such file")

    def test_own_header_in_angle_brackets(self):
        self.assert_noticed({"solver/mesh/dual.cpp": "#include <solver/sbfem/stiffness.hpp>\n"}, "with quotes")

    def test_heavy_library_in_a_header(self):
        self.assert_noticed({"solver/numerics/root.hpp": "#include <toml++/toml.h>\n"}, "toml++ in a header")

    def test_heavy_library_in_too_many_sources(self):
        changes = {f"solver/mesh/{n}.cpp": "#include <nlohmann/json.hpp>\n" for n in "abc"}
        self.assert_noticed(changes, "nlohmann-json in 3 sources")

    def test_empty_table_is_an_error(self):
        status, output = self.check({}, layers="")
        self.assertEqual(status, 2, output)


if __name__ == "__main__":
    unittest.main()
