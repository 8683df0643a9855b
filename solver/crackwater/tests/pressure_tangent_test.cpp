#include "solver/crackwater/pressure_tangent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/crackwater/tests/reference_crack.hpp"

namespace sunder::crackwater {
namespace {

using tests::linear_motion;
using tests::Motion;
using tests::reference_head;
using tests::reference_motion;

struct Case {
  const char* description;
  Motion motion;
  MouthPressures mouths;
  Quadrature quadrature = Quadrature::exact;
  double rise = 0.0;  ///< of each segment [m]
};

Motion wavy(int n, double phase) {
  Motion motion;
  for (int i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / n;
    motion.apertures.push_back(0.04 + 0.02 * std::sin(5.0 * x));
    motion.rates.push_back(0.05 * std::sin(9.0 * x + phase));
  }
  return motion;
}

/// All inputs of a profile in the order of the tangent's columns.
Eigen::VectorXd inputs(const Motion& motion, const MouthPressures& mouths) {
  const Eigen::Index nodes = static_cast<Eigen::Index>(motion.apertures.size());
  Eigen::VectorXd x(2 * nodes + 2);
  x.head(nodes) = Eigen::Map<const Eigen::VectorXd>(motion.apertures.data(), nodes);
  x.segment(nodes, nodes) = Eigen::Map<const Eigen::VectorXd>(motion.rates.data(), nodes);
  x[2 * nodes] = mouths.upstream;
  x[2 * nodes + 1] = mouths.downstream.value_or(0.0);
  return x;
}

/// Nodal pressures above, nodal forces below.
Eigen::VectorXd answer(PressureSolver& solver, const Eigen::VectorXd& x, bool open) {
  const Eigen::Index nodes = (x.size() - 2) / 2;
  MouthPressures mouths{x[2 * nodes], {}};
  if (open) mouths.downstream = x[2 * nodes + 1];
  const std::span<const double> w(x.data(), static_cast<std::size_t>(nodes));
  const std::span<const double> v(x.data() + nodes, static_cast<std::size_t>(nodes));
  const PressureProfile& p = solver.solve(w, v, mouths);
  Eigen::VectorXd y(2 * nodes);
  y.head(nodes) = Eigen::Map<const Eigen::VectorXd>(p.pressure.data(), nodes);
  y.tail(nodes) = Eigen::Map<const Eigen::VectorXd>(p.nodal_force.data(), nodes);
  return y;
}

TEST(PressureTangent, AgreesWithDifferences) {
  const int n = 12;
  const Case cases[] = {
      {"opening, with a front", reference_motion(n, 0.10), {reference_head, 0.0}},
      {"through flow at rest", reference_motion(n, 0.0), {reference_head, 0.0}},
      {"closing, flux turns inside", reference_motion(n, -0.10), {reference_head, 1e5}},
      {"closed tip, full", reference_motion(n, -0.10), {reference_head, {}}},
      {"closed tip, opening", reference_motion(n, 0.10), {reference_head, {}}},
      {"two wet regions", linear_motion(n, 0.10, 0.05, 0.10, 0.08), {reference_head, 0.4 * reference_head}},
      {"an island", wavy(n, 0.7), {3e5, 1e5}},
      {"an island, closed tip", wavy(n, 2.0), {3e5, {}}},
      {"strong taper", linear_motion(n, 0.10, 0.001, -0.01, 0.0), {reference_head, 0.0}},
      {"midpoint, opening", reference_motion(n, 0.10), {reference_head, 0.0}, Quadrature::midpoint},
      {"midpoint, closing", reference_motion(n, -0.10), {reference_head, 1e5}, Quadrature::midpoint},
      {"rising, opening with a front", reference_motion(n, 0.10), {reference_head, 0.0}, Quadrature::exact, 0.75},
      {"falling, closing", reference_motion(n, -0.10), {reference_head, 0.0}, Quadrature::exact, -0.75},
      {"rising, closing, closed tip", reference_motion(n, -0.10), {reference_head, {}}, Quadrature::exact, 0.75},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.description);
    CrackLine line = straight_crack(45.0, n);
    if (c.rise != 0.0) line.rises.assign(n, c.rise);
    PressureSolver solver(line, {}, {.quadrature = c.quadrature});
    const bool open = c.mouths.downstream.has_value();
    const Eigen::VectorXd x = inputs(c.motion, c.mouths);
    const Eigen::VectorXd at = answer(solver, x, open);
    ASSERT_EQ(solver.profile().status, ProfileStatus::converged);
    PressureTangent tangent(n);
    differentiate(solver, tangent);
    const Eigen::Index nodes = n + 1;
    for (Eigen::Index column = 0; column < x.size(); ++column) {
      if (column == 2 * nodes + 1 && !(open && *c.mouths.downstream > 0.0)) continue;  // a dry mouth stays dry
      // Central differences: h³ of the third derivative and ε/h of round-off meet near h = 1e-5 of the input's scale.
      const double scale = column < nodes ? x[column] : (column < 2 * nodes ? 0.1 : reference_head);
      const double h = 1e-5 * scale;
      Eigen::VectorXd there = x;
      there[column] += h;
      Eigen::VectorXd difference = answer(solver, there, open);
      there[column] = x[column] - h;
      difference = (difference - answer(solver, there, open)) / (2.0 * h);
      // (1e-5)² of a response that is not smoother than its size, and 1e-12 · p/h of the solver's own round-off
      const double peak = at.head(nodes).maxCoeff();
      const double tolerance = 1e-6 * difference.head(nodes).lpNorm<Eigen::Infinity>() + 1e-12 * peak / h;
      for (Eigen::Index node = 0; node < nodes; ++node) {
        EXPECT_NEAR(tangent.pressure(node, column), difference[node], tolerance) << "p " << node << " " << column;
        EXPECT_NEAR(tangent.nodal_force(node, column), difference[nodes + node], 3.75 * tolerance)
            << "f " << node << " " << column;  // a segment is 3.75 m long
      }
    }
  }
}

TEST(PressureTangent, IsContinuousWhereAFrontPassesANode) {
  // The opening reference crack with nodes so placed that the front comes within 1e-k of one from either side.
  const double front = 9.92930673144195245;
  PressureTangent before(3), after(3);
  for (int k = 2; k <= 12; k += 2) {
    for (const bool behind : {true, false}) {
      const double node = front * (1.0 + (behind ? -1.0 : 1.0) * std::pow(10.0, -k));
      const CrackLine line{{5.0, node - 5.0, 45.0 - node}, {}};
      PressureSolver solver(line, {});
      Motion motion;
      for (const double s : {0.0, 5.0, node, 45.0}) {
        motion.apertures.push_back(0.10 - 0.05 * s / 45.0);
        motion.rates.push_back(0.10 * (1.0 - s / 45.0));
      }
      const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
      EXPECT_NEAR(p.front_position, front, 1e-12 * front);
      EXPECT_NEAR(p.uplift_force, 1233201.40063765116, 1e-12 * 1233201.4);
      EXPECT_GE(p.pressure[2], 0.0);
      differentiate(solver, behind ? before : after);
    }
    // both one-sided derivatives tend to the same, at least as fast as the distance
    const double scale = before.pressure.lpNorm<Eigen::Infinity>();
    EXPECT_LE((before.pressure - after.pressure).lpNorm<Eigen::Infinity>(),
              20.0 * std::pow(10.0, -k) * scale + 1e-10 * scale);
  }
}

/// A march over segments of unequal lengths, ready for a trial.
struct MarchCase {
  const char* description;
  bool full;
  MouthPressures mouths;
  double rate, phase;  ///< of the apertures' motion [m/s]; pattern along the crack, 0: uniform
  int steps;           ///< accepted before the trial
};

TEST(PressureTangent, OfATrialAgreesWithDifferences) {
  const int n = 12;
  const double dt = 0.01;
  const MarchCase cases[] = {
      {"filling front", false, {reference_head, {}}, 0.02, 0.0, 8},
      {"full, closing, open", true, {reference_head, 1e5}, -0.1, 0.0, 2},
      {"full, closing, closed tip", true, {reference_head, {}}, -0.1, 0.0, 2},
      {"full at first, opens a void", true, {reference_head, 0.0}, 0.2, 0.0, 4},
      {"two mouths, void between", false, {reference_head, 2e5}, 0.02, 0.0, 5},
      {"islands", true, {3e5, 1e5}, 0.1, 0.7, 3},
      {"islands, closed tip", true, {3e5, {}}, 0.1, 2.0, 3},
      {"dry mouth upstream", true, {0.0, 2e5}, 0.05, 0.0, 2},
  };
  CrackLine line;
  double length = 0.0;
  for (int i = 0; i < n; ++i) length += line.lengths.emplace_back(3.0 * (1.0 + 0.5 * std::sin(1.7 * i)));
  for (const MarchCase& c : cases) {
    SCOPED_TRACE(c.description);
    const auto apertures = [&](double t) {
      Eigen::VectorXd w(n + 1);
      double s = 0.0;
      for (int i = 0; i <= n; ++i) {
        const double x = s / length;
        w[i] = 0.04 - 0.02 * x + t * c.rate * (c.phase == 0.0 ? 1.0 - 0.4 * x : std::sin(9.0 * x + c.phase));
        if (i < n) s += line.lengths[static_cast<std::size_t>(i)];
      }
      return w;
    };
    const auto span = [](const Eigen::VectorXd& w) {
      return std::span<const double>(w.data(), static_cast<std::size_t>(w.size()));
    };
    const Eigen::VectorXd start = apertures(0.0);
    FillingMarch march(line, {}, span(start), {.initially_full = c.full});
    for (int k = 1; k <= c.steps; ++k) {
      const Eigen::VectorXd w = apertures(dt * k);
      ASSERT_EQ(march.step(span(w), c.mouths, dt).status, ProfileStatus::converged);
    }
    Eigen::VectorXd x(n + 3);
    x << apertures(dt * (c.steps + 1)), c.mouths.upstream, c.mouths.downstream.value_or(0.0);
    const auto answer_at = [&](const Eigen::VectorXd& at) {
      MouthPressures mouths{at[n + 1], {}};
      if (c.mouths.downstream) mouths.downstream = at[n + 2];
      const Eigen::VectorXd w = at.head(n + 1);
      const PressureProfile& p = march.trial(span(w), mouths, dt);
      Eigen::VectorXd y(2 * n + 2);
      y << Eigen::Map<const Eigen::VectorXd>(p.pressure.data(), n + 1),
          Eigen::Map<const Eigen::VectorXd>(p.nodal_force.data(), n + 1);
      return y;
    };
    const Eigen::VectorXd at = answer_at(x);
    ASSERT_EQ(march.profile().status, ProfileStatus::converged);
    PressureTangent tangent(n);
    differentiate(march, tangent);
    EXPECT_EQ(tangent.pressure.middleCols(n + 1, n + 1).lpNorm<Eigen::Infinity>(), 0.0) << "rates";
    const double peak = at.head(n + 1).maxCoeff();
    for (Eigen::Index column = 0; column < x.size(); ++column) {
      const bool dry = column == n + 1 ? c.mouths.upstream <= 0.0 : c.mouths.downstream.value_or(0.0) <= 0.0;
      if (column > n && dry) continue;  // a dry mouth stays dry on one side
      // smaller than for a profile: a change of aperture moves water by Δw/Δt, which is the scale that counts
      const double h = 1e-6 * (column <= n ? x[column] : reference_head);
      Eigen::VectorXd there = x;
      there[column] += h;
      Eigen::VectorXd difference = answer_at(there);
      there[column] = x[column] - h;
      difference = (difference - answer_at(there)) / (2.0 * h);
      const double tolerance = 1e-6 * difference.head(n + 1).lpNorm<Eigen::Infinity>() + 1e-12 * peak / h;
      const Eigen::Index of = column <= n ? column : column + n + 1;
      for (Eigen::Index node = 0; node <= n; ++node) {
        EXPECT_NEAR(tangent.pressure(node, of), difference[node], tolerance) << "p " << node << " " << column;
        EXPECT_NEAR(tangent.nodal_force(node, of), difference[n + 1 + node], 4.5 * tolerance)
            << "f " << node << " " << column;  // a node owns at most 4.5 m
      }
    }
    EXPECT_EQ(answer_at(x), at) << "a trial leaves no trace";
  }
}

// A march has one flux a segment, so that one of them can stand at the critical flux with a mixture of both regimes.
// There the flux of the whole region follows the water that goes beyond that segment.
TEST(PressureTangent, OfATrialInTheBandWithoutARootAgreesWithDifferences) {
  constexpr int nodes = 10;
  CrackLine line;
  line.lengths.assign(nodes - 1, 0.5);
  line.rises.assign(nodes - 1, 0.0);
  constexpr double rest = 0.01, step = 0.005, length = 4.5;
  const auto apertures_at = [&](double speed, int end) {
    std::vector<double> apertures;
    for (int i = 0; i < nodes; ++i) apertures.push_back(rest + speed * step * end * (1.0 - 0.5 * i / length));
    return apertures;
  };
  int in_band = 0;
  for (int trial = 0; trial < 2000;
       ++trial) {  // a wedge that opens, ever faster: now and then a segment is in the band
    const double speed = 0.005 + 4e-5 * trial;
    FillingMarch march(line, {}, apertures_at(speed, 0), {});
    const MouthPressures mouths{1e5, {}};
    march.step(apertures_at(speed, 1), mouths, step);
    std::vector<double> apertures = apertures_at(speed, 2);
    ASSERT_EQ(march.trial(apertures, mouths, step).status, ProfileStatus::converged);
    if (march.solver().regions().empty() || !(march.solver().regions().front().share > 0.0)) continue;
    ++in_band;
    PressureTangent tangent(nodes - 1);
    differentiate(march, tangent);
    const double scale = tangent.pressure.leftCols(nodes).cwiseAbs().maxCoeff();
    constexpr double shift = 1e-12;  // m: the band is some 1e-8 m wide
    for (std::size_t j = 0; j < nodes; ++j) {
      const double middle = apertures[j];
      apertures[j] = middle + shift;
      const std::vector<double> above = march.trial(apertures, mouths, step).pressure;
      apertures[j] = middle - shift;
      const std::vector<double> below = march.trial(apertures, mouths, step).pressure;
      apertures[j] = middle;
      for (std::size_t i = 0; i < nodes; ++i) {
        // round-off of 1e5 Pa over 2e-12 m is 1e-5 of the scale, 1e8 Pa/m and more
        EXPECT_NEAR((above[i] - below[i]) / (2.0 * shift),
                    tangent.pressure(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)), 1e-3 * scale)
            << "speed " << speed << " p " << i << " w " << j;
      }
    }
  }
  EXPECT_GE(in_band, 1);  // else nothing was tested
}

TEST(PressureTangent, KnowsThatAMouthBelowZeroCountsAsZero) {
  PressureSolver solver(straight_crack(45.0, 6), {});
  const Motion motion = reference_motion(6, -0.10);
  const PressureProfile& profile = solver.solve(motion.apertures, motion.rates, {-1e5, 1e5});
  ASSERT_EQ(profile.status, ProfileStatus::converged);
  EXPECT_TRUE(profile.mouth_below_zero);
  PressureTangent tangent(6);
  differentiate(solver, tangent);
  EXPECT_EQ(tangent.pressure.col(14).lpNorm<Eigen::Infinity>(), 0.0);
  EXPECT_GT(tangent.pressure.col(15).lpNorm<Eigen::Infinity>(), 0.1);
}

TEST(PressureTangent, VanishesForTheUniformModel) {
  PressureSolver solver(straight_crack(10.0, 4), {});
  (void)solver.uniform(1e5);
  PressureTangent tangent(4);
  tangent.pressure.setOnes();
  differentiate(solver, tangent);
  EXPECT_EQ(tangent.pressure.lpNorm<Eigen::Infinity>(), 0.0);
}

}  // namespace
}  // namespace sunder::crackwater
