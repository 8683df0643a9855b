#include "solver/foundation/dynamic_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/foundation/curved_line.hpp"
#include "solver/foundation/tests/lines.hpp"

namespace sunder::foundation {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;

/// H_n⁽²⁾(x): waves that leave with e^{iωt}.
Complex hankel(int n, double x) {
  return {std::cyl_bessel_j(n, x), -std::cyl_neumann(n, x)};
}

std::vector<MatrixXcd> at(const UnboundedDomain& domain, const std::vector<Complex>& s) {
  std::vector<MatrixXcd> values;
  const StiffnessPath path =
      dynamic_stiffness(domain, s, [&](std::size_t, const MatrixXcd& S) { values.push_back(S); });
  EXPECT_EQ(path.status, StiffnessStatus::converged);
  EXPECT_EQ(values.size(), s.size());
  return values;
}

TEST(DynamicStiffness, OfASemicircleOutOfThePlaneIsThatOfHankelFunctions) {
  const sbfem::Boundary line = circle(1.0, 4, 4, true);
  const UnboundedDomain domain = unbounded_domain(curved_antiplane_coefficients(line, unit_rock));
  const std::vector<double> a0{5.0, 2.0, 1.0, 0.5, 0.2};
  std::vector<Complex> s;
  for (const double a : a0) s.emplace_back(0.0, a);
  const std::vector<MatrixXcd> S = at(domain, s);
  // Ten times the errors of an independent program on the same line; cos(nθ) is met ever worse by order 4.
  constexpr double bound[] = {1e-8, 1e-7, 1e-5, 3e-4};
  for (int n = 0; n < 4; ++n) {
    Eigen::VectorXd shape(line.nodes.cols());
    for (Eigen::Index i = 0; i < shape.size(); ++i)
      shape[i] = std::cos(n * std::atan2(line.nodes(1, i), line.nodes(0, i)));
    for (std::size_t i = 0; i < a0.size(); ++i) {
      const double a = a0[i];
      const Complex derivative = hankel(n + 1, a) - (n / a) * hankel(n, a);  // -H_n'
      const double norm = n == 0 ? std::numbers::pi : 0.5 * std::numbers::pi;
      const Complex exact = norm * a * derivative / hankel(n, a);
      const Complex found = shape.dot(S[i] * shape);
      EXPECT_LT(std::abs(found - exact), bound[n] * std::abs(exact)) << n << " at " << a;
    }
  }
}

TEST(DynamicStiffness, OfARigidDiscInTheFullPlaneIsTheClosedForm) {
  const sbfem::Boundary line = circle(1.0, 8, 6, false);
  const UnboundedDomain domain = unbounded_domain(curved_coefficients(line, unit_rock));
  const std::vector<double> a0{5.0, 2.0, 1.0, 0.5, 0.2};
  std::vector<Complex> s;
  for (const double a : a0) s.emplace_back(0.0, a);
  const std::vector<MatrixXcd> S = at(domain, s);
  const double eta = std::sqrt(3.0);
  for (std::size_t i = 0; i < a0.size(); ++i) {
    // K_n(i x) = -(π i / 2) (-i)^n H_n⁽²⁾(x)
    const auto K = [](int n, double x) {
      return -Complex(0, 0.5 * std::numbers::pi) * (n == 0 ? Complex(1) : Complex(0, -1)) * hankel(n, x);
    };
    const double a = a0[i];
    const Complex A(0, a), B = A / eta;
    const Complex K0a = K(0, a), K1a = K(1, a), K0b = K(0, a / eta), K1b = K(1, a / eta);
    const Complex exact = std::numbers::pi * A * A * (4.0 * K1b * K1a + A * K1b * K0a + B * K0b * K1a) /
                          (B * K0b * K1a + A * K1b * K0a + A * B * K0b * K0a);
    // order 6 on an eighth of a circle: (π/8)^7/7!/2^6 is 4e-9, squared; what is left is the integrator's 1e-10
    EXPECT_LT(std::abs(translation(S[i], 0) - exact), 1e-9 * std::abs(exact)) << a;
  }
}

/// S is analytic for Re s > 0: the way there does not matter.
TEST(DynamicStiffness, DoesNotDependOnThePath) {
  const UnboundedDomain domain = unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 4), unit_rock));
  const Complex place(0.6, 0.5);
  const MatrixXcd direct = at(domain, {place}).back();
  for (const std::vector<Complex>& path : {std::vector<Complex>{{0.0, 9.0}, {0.0, 1.0}, place},
                                           std::vector<Complex>{{500.0, 0.0}, {7.0, -3.0}, {0.1, -1.0}, place}}) {
    // On the imaginary axis nothing dies out at high frequency: at most 1e-10 for each of less than 2000 steps.
    EXPECT_LT((at(domain, path).back() - direct).norm(), 2e-7 * direct.norm());
  }
  const MatrixXcd conjugate = at(domain, {std::conj(place)}).back();
  EXPECT_LT((conjugate - direct.conjugate()).norm(), 1e-12 * direct.norm());
}

/// ω → ∞: only plane waves leave, S → iω C, and the first correction k is that of the asymptotic series.
TEST(DynamicStiffness, MeetsItsAsymptoteWhereTheSeriesTakesOver) {
  const UnboundedDomain domain = unbounded_domain(sbfem::coefficients(block_line(1, 1, 4, 2, 2), unit_rock));
  StiffnessPath path;
  const std::vector<Complex> first{{0.0, 1.0}};
  path = dynamic_stiffness(domain, first, [](std::size_t, const MatrixXcd&) {});
  const Complex above(0.0, 1.0001 * path.start), below(0.0, 0.5 * path.start);
  MatrixXcd series, integrated;
  // The series itself at `below` is poor; integrated from above it must still be smooth: a second, looser path agrees.
  const std::vector<Complex> places{above, below};
  const auto keep = [&](std::size_t i, const MatrixXcd& S) { (i == 0 ? series : integrated) = S; };
  ASSERT_EQ(dynamic_stiffness(domain, places, keep).status, StiffnessStatus::converged);
  MatrixXcd looser;
  const std::vector<Complex> again{below};
  ASSERT_EQ(dynamic_stiffness(domain, again, [&](std::size_t, const MatrixXcd& S) { looser = S; }, {.tolerance = 1e-7})
                .status,
            StiffnessStatus::converged);
  EXPECT_LT((integrated - looser).norm(), 1e-6 * integrated.norm());
  const MatrixXcd radiation = above * (domain.F * (domain.time * domain.c).asDiagonal() * domain.F.transpose());
  EXPECT_LT((series - radiation).norm(), 0.3 * radiation.norm());
}

TEST(DynamicStiffness, RefusesPathsThatLeadOutwardsAndStopsAtItsLimit) {
  const UnboundedDomain domain = unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 1), unit_rock));
  const auto ignore = [](std::size_t, const MatrixXcd&) {};
  for (const std::vector<Complex>& s : {std::vector<Complex>{{0.0, 1.0}, {0.0, 2.0}}, std::vector<Complex>{{0.0, 0.0}},
                                        std::vector<Complex>{{-0.1, 1.0}}, std::vector<Complex>{{0.0, NAN}}}) {
    EXPECT_THROW((void)dynamic_stiffness(domain, s, ignore), std::invalid_argument);
  }
  const std::vector<Complex> one{{0.0, 1.0}};
  const StiffnessPath path = dynamic_stiffness(domain, one, ignore, {.max_steps = 10});
  EXPECT_EQ(path.status, StiffnessStatus::too_many_steps);
  EXPECT_EQ(path.reached, 0u);
}

TEST(UnboundedDomain, NeedsInertia) {
  material::Isotropic massless = unit_rock;
  massless.density = 0.0;
  EXPECT_THROW(unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 1), massless)), std::invalid_argument);
}

TEST(CurvedLine, OnStraightEdgesIsTheStraightOne) {
  const sbfem::Boundary line = block_line(1.2, 0.7, 3, 2, 3);
  const sbfem::Coefficients straight = sbfem::coefficients(line, unit_rock);
  const sbfem::Coefficients curved = curved_coefficients(line, unit_rock);
  EXPECT_LT((straight.E0 - curved.E0).norm(), 1e-13 * straight.E0.norm());
  EXPECT_LT((straight.E1 - curved.E1).norm(), 1e-13 * straight.E1.norm());
  EXPECT_LT((straight.E2 - curved.E2).norm(), 1e-13 * straight.E2.norm());
  EXPECT_LT((straight.M0 - curved.M0).norm(), 1e-13 * straight.M0.norm());
}

}  // namespace
}  // namespace sunder::foundation
