#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::run_text;

double frequency(const results::RunSummary& summary, int i) {
  const results::Quantity* quantity = summary.quantities.find("frequencies[" + std::to_string(i) + "]");
  return quantity != nullptr ? *quantity->number() : NAN;
}

/// Unit square on rollers, c_s = 1: ω² = π² (i² + j²) for shear (i, j >= 1), (8/3) π² (i² + j²) for pressure waves.
const char* const roller_square = R"(
name = "roller square"
analysis = "modal"
[geometry]
outline = [[0, 0], [1, 0], [1, 1], [0, 1]]
boundaries = { bottom = [0], right = [1], top = [2], left = [3] }
[mesh]
cells = "squares"
size = 0.25
order = 1
[material]
youngs_modulus = 2.4
poisson_ratio = 0.2
density = 1.0
[modal]
count = 3
[[support]]
boundary = "left"
fix = ["x"]
[[support]]
boundary = "right"
fix = ["x"]
[[support]]
boundary = "bottom"
fix = ["y"]
[[support]]
boundary = "top"
fix = ["y"]
)";

TEST(ModalRun, RollerSquareConvergesFromAbove) {
  double previous = INFINITY;
  for (const char* size : {"0.25", "0.125"}) {
    const results::RunSummary summary = run_text(roller_square, {{"mesh.size", size}});
    ASSERT_TRUE(summary.completed()) << summary.status;
    const double error = frequency(summary, 0) / (std::sqrt(2.0) / 2.0) - 1.0;
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, previous / 3.0);  // order 2: a quarter, less what the coarse mesh is off the law
    previous = error;
  }
}

TEST(ModalRun, BubblesBringTheOrderOfTheBoundary) {
  struct Row {
    const char* description;
    const char* order;
    const char* coarse;
    const char* fine;
    double expected;
  };
  // Order 2p of eigenvalues in polynomials of degree p; static modes alone have order 2 whatever p.
  for (const Row& row : {Row{"p = m = 2", "2", "0.25", "0.125", 4.0},
                         {"p = m = 3", "3", "0.25", "0.125", 6.0},
                         {"p = m = 4", "4", "0.5", "0.25", 8.0}}) {
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const results::RunSummary summary = run_text(roller_square, {{"mesh.size", level == 0 ? row.coarse : row.fine},
                                                                   {"mesh.order", row.order},
                                                                   {"modal.interior_order", row.order}});
      ASSERT_TRUE(summary.completed()) << summary.status;
      error[level] = frequency(summary, 0) / (std::sqrt(2.0) / 2.0) - 1.0;
    }
    EXPECT_GT(error[1], 0.0) << row.description;
    EXPECT_NEAR(std::log2(error[0] / error[1]), row.expected, 0.15) << row.description;
  }
}

TEST(ModalRun, AFreeBodyHasThreeModesAtRest) {
  std::string text = roller_square;
  text.erase(text.find("[[support]]"));
  for (const char* interior_order : {"0", "3"}) {
    const results::RunSummary summary =
        run_text(text, {{"modal.count", "5"}, {"mesh.order", "3"}, {"modal.interior_order", interior_order}});
    ASSERT_TRUE(summary.completed()) << summary.status;
    for (int i = 0; i < 3; ++i) EXPECT_LT(frequency(summary, i), 1e-4 * frequency(summary, 3)) << i;
    EXPECT_GT(frequency(summary, 3), 0.1);
    double moved[2] = {0.0, 0.0};  // the rigid motions carry the whole mass
    for (int i = 0; i < 3; ++i) {
      for (int c = 0; c < 2; ++c) {
        moved[c] +=
            *summary.quantities.find("participation[" + std::to_string(i) + "][" + std::to_string(c) + "]")->number();
      }
    }
    EXPECT_NEAR(moved[0], 1.0, 1e-8);  // square of the vectors' accuracy, 1e-6, with some room
    EXPECT_NEAR(moved[1], 1.0, 1e-8);
  }
}

}  // namespace
}  // namespace sunder::simulation
