#include "solver/reservoir/added_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::reservoir {
namespace {

void check_density(double density) {
  if (!(density > 0.0) || !std::isfinite(density))
    throw std::invalid_argument("water: density = " + std::to_string(density) + " must be finite and > 0 kg/m³");
}

const std::vector<int>& nodes_of(const Face& face, const WetElement& wet) {
  return face.elements[static_cast<std::size_t>(wet.element)];
}

/// Cosine and sine of λ (y - bottom) at some heights while λ grows by equal steps: rotated from one to the next, and
/// begun anew often enough that round-off stays at a few tens of eps.
class Phases {
 public:
  Phases(Eigen::ArrayXd distances, double step)
      : distances_(std::move(distances)), turn_cos_((step * distances_).cos()), turn_sin_((step * distances_).sin()) {}

  void begin(double lambda) {
    cosines = (lambda * distances_).cos();
    sines = (lambda * distances_).sin();
  }
  void turn() {
    before_ = cosines;
    cosines = cosines * turn_cos_ - sines * turn_sin_;
    sines = sines * turn_cos_ + before_ * turn_sin_;
  }

  Eigen::ArrayXd cosines, sines;

 private:
  Eigen::ArrayXd distances_, turn_cos_, turn_sin_, before_;
};

constexpr int turns = 32;  ///< from one beginning to the next

/// ∫ N_i cos(λ_k (y - bottom)) dy over the wet part of one element, for λ_k = (k + ½) step, k = 0, 1, … in turn.
class CosineIntegrals {
 public:
  CosineIntegrals(int order, const WetElement& wet, double bottom, double step)
      : order_(order),
        length_(wet.surface - wet.lower),
        step_(step),
        rule_(numerics::gauss_legendre(gauss_points(order))),
        shapes_(order + 1, rule_.points.size()),
        at_lower_(order + 1, order + 1),
        at_surface_(order + 1, order + 1),
        inside_(wet.lower - bottom + 0.5 * length_ * (1.0 + rule_.points.array()), step),
        ends_(Eigen::Array2d(wet.lower - bottom, wet.surface - bottom), step),
        integrals_(order + 1) {
    const numerics::LagrangeBasis basis = numerics::lagrange_basis(numerics::gauss_lobatto(order + 1).points);
    const double share = length_ / (wet.upper - wet.lower);
    for (Eigen::Index g = 0; g < rule_.points.size(); ++g)
      shapes_.col(g) =
          0.5 * length_ * rule_.weights[g] * numerics::values(basis, (1.0 + rule_.points[g]) * share - 1.0);
    // column k: k-th derivatives with respect to y at both ends
    Eigen::RowVectorXd lower = Eigen::RowVectorXd::Unit(order + 1, 0);
    Eigen::RowVectorXd surface = numerics::values(basis, 2.0 * share - 1.0).transpose();
    for (int k = 0; k <= order; ++k) {
      at_lower_.col(k) = lower.transpose();
      at_surface_.col(k) = surface.transpose();
      lower = (lower * basis.derivative * (2.0 / (wet.upper - wet.lower))).eval();
      surface = (surface * basis.derivative * (2.0 / (wet.upper - wet.lower))).eval();
    }
  }

  /// Of the next λ. Allocates nothing after the first.
  const Eigen::VectorXd& next() {
    const double lambda = (number_ + 0.5) * step_;
    const bool smooth = lambda * length_ <= largest_phase(order_);
    Phases& phases = smooth ? inside_ : ends_;
    if (number_ % turns == 0 || smooth != smooth_) {
      phases.begin(lambda);
    } else {
      phases.turn();
    }
    smooth_ = smooth;
    ++number_;
    if (smooth) {
      integrals_.noalias() = shapes_ * inside_.cosines.matrix();
    } else {
      by_parts(lambda);
    }
    return integrals_;
  }

 private:
  /// Beyond it integration by parts loses nothing: its terms fall by 2 p² / phase.
  static double largest_phase(int order) { return 4.0 * order * order + 60.0; }
  /// A cosine over a phase φ is a polynomial of degree φ/2 and a few more, to round-off.
  static int gauss_points(int order) {
    return std::min(128, static_cast<int>(0.5 * (0.5 * largest_phase(order) + order)) + 16);
  }

  /// [N sin/λ + N' cos/λ² - N'' sin/λ³ - …] between the ends.
  void by_parts(double lambda) {
    integrals_.setZero();
    double power = 1.0;
    for (int k = 0; k <= order_; ++k) {
      power /= lambda;
      const double sign = k % 4 < 2 ? power : -power;
      const Eigen::ArrayXd& wave = k % 2 == 0 ? ends_.sines : ends_.cosines;
      integrals_ += (sign * wave[1]) * at_surface_.col(k) - (sign * wave[0]) * at_lower_.col(k);
    }
  }

  int order_;
  double length_, step_;
  numerics::QuadratureRule rule_;
  Eigen::MatrixXd shapes_, at_lower_, at_surface_;  // (p + 1, points) with the weights; (p + 1, p + 1)
  Phases inside_, ends_;
  Eigen::VectorXd integrals_;
  int number_ = 0;
  bool smooth_ = true;
};

}  // namespace

double hydrostatic_pressure(double density, double gravity, double level, double height) {
  check_density(density);
  return density * gravity * std::fmax(level - height, 0.0);
}

Eigen::VectorXd hydrostatic_force(const Face& face, double level, double density, double gravity) {
  check_density(density);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(face.size());
  for (const WetElement& wet : wet_elements(face, level)) {
    const std::vector<int>& nodes = nodes_of(face, wet);
    const int order = static_cast<int>(nodes.size()) - 1;
    const numerics::QuadratureRule rule = numerics::gauss_legendre((order + 3) / 2);
    const double half = 0.5 * (wet.surface - wet.lower);
    for (Eigen::Index g = 0; g < rule.points.size(); ++g) {
      const double y = wet.lower + half * (1.0 + rule.points[g]);
      const double p = hydrostatic_pressure(density, gravity, level, y);
      const Eigen::VectorXd N = shape_functions(order, wet.lower, wet.upper, y);
      for (int i = 0; i <= order; ++i) force[nodes[i]] += rule.weights[g] * half * p * N[i];
    }
  }
  return force;
}

Eigen::MatrixXd westergaard_mass(const Face& face, double level, double density) {
  check_density(density);
  const std::vector<WetElement> wet_parts = wet_elements(face, level);
  const double depth = level - wet_parts.front().lower;
  const double factor = numerics::planted_fault("reservoir/westergaard-factor") ? 1.0 : 7.0 / 8.0;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(face.size(), face.size());
  for (const WetElement& wet : wet_parts) {
    const std::vector<int>& nodes = nodes_of(face, wet);
    const int order = static_cast<int>(nodes.size()) - 1;
    // in t = √(level - y) the integrand is a polynomial: dy = -2 t dt
    const double t0 = std::sqrt(std::fmax(level - wet.surface, 0.0)), t1 = std::sqrt(level - wet.lower);
    const numerics::QuadratureRule rule = numerics::gauss_legendre(2 * order + 2);
    for (Eigen::Index g = 0; g < rule.points.size(); ++g) {
      const double t = 0.5 * (t0 + t1) + 0.5 * (t1 - t0) * rule.points[g];
      const double weight = rule.weights[g] * 0.5 * (t1 - t0) * 2.0 * t * factor * density * std::sqrt(depth) * t;
      const Eigen::VectorXd N = shape_functions(order, wet.lower, wet.upper, level - t * t);
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) mass(nodes[i], nodes[j]) += weight * N[i] * N[j];
    }
  }
  return mass;
}

Eigen::MatrixXd incompressible_mass(const Face& face, double level, double density) {
  check_density(density);
  const std::vector<WetElement> wet_parts = wet_elements(face, level);
  const double bottom = wet_parts.front().lower, depth = level - bottom;
  double shortest = depth;
  std::vector<CosineIntegrals> integrals;
  for (const WetElement& wet : wet_parts) {
    integrals.emplace_back(static_cast<int>(nodes_of(face, wet).size()) - 1, wet, bottom, std::numbers::pi / depth);
    shortest = std::min(shortest, wet.surface - wet.lower);
  }
  const int terms = static_cast<int>(std::fmin(400.0 * depth / (std::numbers::pi * shortest) + 50.0, 20'000.0));
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(face.size(), terms);
  for (int k = 0; k < terms; ++k) {
    for (std::size_t e = 0; e < wet_parts.size(); ++e) {
      const Eigen::VectorXd& part = integrals[e].next();
      const std::vector<int>& nodes = nodes_of(face, wet_parts[e]);
      for (std::size_t i = 0; i < nodes.size(); ++i) columns(nodes[i], k) += part[static_cast<Eigen::Index>(i)];
    }
    columns.col(k) /= std::sqrt((k + 0.5) * std::numbers::pi / depth);
  }
  Eigen::MatrixXd mass = 2.0 * density / depth * columns * columns.transpose();

  const WetElement& last = wet_parts.back();
  const std::vector<int>& nodes = nodes_of(face, last);
  const Eigen::VectorXd N = shape_functions(static_cast<int>(nodes.size()) - 1, last.lower, last.upper, last.surface);
  // Σ_{k > terms} 1/λ_k³ = (H/π)³ Σ 1/(k - ½)³ ≈ (H/π)³ / (2 terms²)
  const double count = terms, rest = std::pow(depth / std::numbers::pi, 3) / (2.0 * count * count);
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      mass(nodes[i], nodes[j]) +=
          2.0 * density / depth * rest * N[static_cast<Eigen::Index>(i)] * N[static_cast<Eigen::Index>(j)];
  return mass;
}

}  // namespace sunder::reservoir
