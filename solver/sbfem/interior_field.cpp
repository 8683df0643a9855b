#include "solver/sbfem/interior_field.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

namespace sunder::sbfem {
namespace {

/// ½ ∫ ε : σ dV = ½ (u_bᵀ q + Σ ∫ uᵀ p_k ξᵏ dξ) with the boundary forces q = K u_b - Σ f_k [Clapeyron].
double energy(const Eigen::MatrixXd& K, const Eigen::VectorXd& u_b, const Eigen::VectorXd& homogeneous,
              const std::vector<Eigen::VectorXd>& load_vectors, std::span<const RadialLoad> loads,
              const std::vector<ParticularSolution>& particular) {
  double twice = u_b.dot(K * u_b);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    // ∫ (ξ^A c)ᵀ p ξᵏ dξ = cᵀ f_k, and c = u_b - Σ d_j.
    twice += (homogeneous - u_b).dot(load_vectors[k]);
    for (const ParticularSolution& other : particular) {
      twice += other.d.dot(loads[k].density) / (other.power + loads[k].power + 2.0);
    }
  }
  return 0.5 * twice;
}

}  // namespace

std::optional<RayPoint> locate(const Boundary& boundary, const Eigen::Vector2d& point) {
  const double size = boundary.nodes.colwise().norm().maxCoeff();
  constexpr double tolerance = 1e-9;
  if (point.norm() <= std::numeric_limits<double>::min()) return RayPoint{.edge = 0, .position = 0.0, .xi = 0.0};
  std::optional<RayPoint> best;
  double best_excess = tolerance;
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < boundary.orders.size(); ++e) {
    const Eigen::Vector2d a = boundary.nodes.col(start);
    start += boundary.orders[e];
    const Eigen::Vector2d t = boundary.nodes.col(start % boundary.nodes.cols()) - a;
    // point = ξ (a + s t)
    const double twice_area = a.x() * t.y() - a.y() * t.x();
    const double xi = (point.x() * t.y() - point.y() * t.x()) / twice_area;
    const double s_xi = (a.x() * point.y() - a.y() * point.x()) / twice_area;
    if (!(xi > 0.0)) continue;
    // How far outside, as a length over the polygon's size: beyond the edge, or beside the sector.
    const double beyond = (xi - 1.0) * (twice_area / t.norm()) / size;
    const double beside = std::max(-s_xi, s_xi - xi) * t.norm() / size;
    const double excess = std::max({0.0, beyond, beside});
    if (excess < best_excess || (!best && excess <= tolerance)) {
      best_excess = excess;
      best =
          RayPoint{.edge = static_cast<int>(e), .position = std::clamp(s_xi / xi, 0.0, 1.0), .xi = std::min(xi, 1.0)};
    }
    if (best && best_excess == 0.0) break;
  }
  return best;
}

InteriorField::InteriorField(const Boundary& boundary, const Coefficients& coefficients,
                             const PolygonSolution& solution, const material::Isotropic& material,
                             const Eigen::VectorXd& boundary_displacement, std::span<const RadialLoad> loads)
    : edges_(edge_elements(boundary)),
      elasticity_(material::elasticity_matrix(material)),
      particular_(particular_solutions(coefficients, solution, loads)) {
  const Eigen::Index n = 2 * boundary.nodes.cols();
  if (boundary_displacement.size() != n) {
    throw std::invalid_argument("boundary_displacement: " + std::to_string(boundary_displacement.size()) +
                                " entries, accepted is " + std::to_string(n));
  }
  Eigen::VectorXd homogeneous = boundary_displacement;
  for (const ParticularSolution& part : particular_) homogeneous -= part.d;
  std::vector<Eigen::VectorXd> load_vectors;
  for (const RadialLoad& load : loads) load_vectors.push_back(load_vector(solution, load));
  strain_energy_ = energy(solution.K, boundary_displacement, homogeneous, load_vectors, loads, particular_);

  // Scaled by P = diag(E0)^-1/2; in the orthonormal basis [T Q], T the two translations, A = [0 C; 0 R].
  const Eigen::VectorXd scale = coefficients.E0.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled_A = scale.cwiseInverse().asDiagonal() * solution.A * scale.asDiagonal();
  Eigen::MatrixX2d translations = Eigen::MatrixX2d::Zero(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) translations(i, i % 2) = 1.0 / scale[i];
  const Eigen::MatrixXd basis = translations.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd T = basis.leftCols(2), Q = basis.rightCols(n - 2);
  const Eigen::MatrixXd AQ = scaled_A * Q, C = T.transpose() * AQ;
  reduced_ = Q.transpose() * AQ;
  const Eigen::MatrixXd feed = reduced_.transpose().partialPivLu().solve(C.transpose()).transpose();  // C R⁻¹
  const Eigen::VectorXd scaled = scale.cwiseInverse().cwiseProduct(homogeneous);
  start_ = Q.transpose() * scaled;
  centre_ = scale.cwiseProduct(T * (T.transpose() * scaled - feed * start_));
  to_offset_ = scale.asDiagonal() * (T * feed + Q);
  to_slope_ = scale.asDiagonal() * (T * C + Q * reduced_);
}

InteriorField::Ring InteriorField::ring(double xi) const {
  if (!(xi >= 0.0 && xi <= 1.0)) {
    throw std::invalid_argument("xi = " + std::to_string(xi) + ", accepted is 0 <= xi <= 1");
  }
  Eigen::VectorXd v = start_;
  if (xi < 1.0) {
    const bool bounded = xi > 0.0 || reduced_.eigenvalues().real().minCoeff() > 1.0 - 1e-9;
    if (bounded) {
      // At ξ = 2^-60 whatever decays has gone: what is left is the limit at the centre.
      const double logarithm = std::log(xi > 0.0 ? xi : std::ldexp(1.0, -60));
      Eigen::MatrixXd exponent = logarithm * reduced_;
      exponent.diagonal().array() -= logarithm;
      v = exponent.exp() * start_;
    } else {
      v.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  Ring ring{.xi = xi, .displacement = centre_, .offset = to_offset_ * v, .slope = to_slope_ * v};
  for (const ParticularSolution& part : particular_) {
    const double power = std::pow(xi, part.power);  // 0⁰ = 1
    ring.offset += power * part.d;
    ring.slope += (part.power + 1.0) * power * part.d;
  }
  if (xi > 0.0) ring.displacement += xi * ring.offset;
  return ring;
}

Eigen::Vector2d InteriorField::displacement(const Ring& ring, int edge, double position) const {
  const EdgeElement& element = edges_.at(edge);
  return interpolate(element, numerics::values(element.basis, 2.0 * position - 1.0), ring.displacement);
}

Eigen::Vector3d InteriorField::strain(const Ring& ring, int edge, double position) const {
  const EdgeElement& element = edges_.at(edge);
  const EdgePoint point = at(element, 2.0 * position - 1.0);
  return point.b1 * interpolate(element, point.shape, ring.slope) +
         point.b2 * interpolate(element, point.derivative, ring.offset);
}

Eigen::Vector3d InteriorField::stress(const Ring& ring, int edge, double position) const {
  return elasticity_ * strain(ring, edge, position);
}

Eigen::Vector2d InteriorField::displacement(const RayPoint& point) const {
  return displacement(ring(point.xi), point.edge, point.position);
}

Eigen::Vector3d InteriorField::strain(const RayPoint& point) const {
  return strain(ring(point.xi), point.edge, point.position);
}

Eigen::Vector3d InteriorField::stress(const RayPoint& point) const {
  return stress(ring(point.xi), point.edge, point.position);
}

}  // namespace sunder::sbfem
