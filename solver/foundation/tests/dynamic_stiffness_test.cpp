#include "solver/foundation/dynamic_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/foundation/curved_line.hpp"

namespace sunder::foundation {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;

constexpr material::Isotropic unit_rock{.youngs_modulus = 2.5, .poisson_ratio = 0.25, .density = 1.0};  // G = c_s = 1

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
      // order 4 elements of an eighth of a circle: interpolation of cos(nθ), squared in the energy
      std::printf("n %d a0 %g err %g\n", n, a, std::abs(found - exact) / std::abs(exact));
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
    Complex found = 0.0;
    for (Eigen::Index r = 0; r < domain.size(); r += 2)
      for (Eigen::Index q = 0; q < domain.size(); q += 2) found += S[i](r, q);
    std::printf("a0 %g found %g %g exact %g %g err %g\n", a, found.real(), found.imag(), exact.real(), exact.imag(),
                std::abs(found - exact) / std::abs(exact));
  }
}

}  // namespace
}  // namespace sunder::foundation
