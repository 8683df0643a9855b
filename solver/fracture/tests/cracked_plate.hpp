#pragma once
/// Test support: a cracked plate that is one polygon, its loads, its solution, and the factors at the tip.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <span>
#include <vector>

#include "solver/fracture/stress_intensity.hpp"
#include "solver/sbfem/coefficients.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/sbfem/polygon_solution.hpp"
#include "solver/sbfem/tests/polygons.hpp"

namespace sunder::fracture::testing {

/// The open boundary through `vertices` (2, m) relative to the tip, from the lower mouth to the upper one.
inline sbfem::Boundary open_boundary(const std::vector<Eigen::Vector2d>& vertices, int order) {
  return sbfem::testing::boundary(vertices, order, true);
}

/// Divides each side between corners into equal parts.
inline std::vector<Eigen::Vector2d> divided(const std::vector<Eigen::Vector2d>& corners,
                                            const std::vector<int>& parts) {
  std::vector<Eigen::Vector2d> vertices{corners.front()};
  for (std::size_t side = 0; side < parts.size(); ++side) {
    for (int i = 1; i <= parts[side]; ++i) {
      const double t = static_cast<double>(i) / parts[side];
      vertices.push_back((1.0 - t) * corners[side] + t * corners[side + 1]);
    }
  }
  return vertices;
}

/// Edge-cracked plate: width W = 1, crack a along -x to its mouth at x = -a, half height H; sides lower left, bottom,
/// right, top, upper left are divided into `parts`.
inline std::vector<Eigen::Vector2d> edge_cracked_plate(double a, double H, const std::vector<int>& parts) {
  return divided({{-a, 0}, {-a, -H}, {1 - a, -H}, {1 - a, H}, {-a, H}, {-a, 0}}, parts);
}

struct Plate {
  sbfem::Boundary boundary;
  material::Isotropic material;
  sbfem::Coefficients coefficients;
  sbfem::PolygonSolution solution;
};

inline Plate make_plate(sbfem::Boundary boundary, const material::Isotropic& material) {
  Plate plate{std::move(boundary), material, {}, {}};
  plate.coefficients = sbfem::coefficients(plate.boundary, material);
  plate.solution = sbfem::solve_polygon(plate.coefficients);
  return plate;
}

/// Tension `stress` along `axis` on every edge whose outward normal is ± that axis.
inline Eigen::VectorXd remote_tension(const sbfem::Boundary& boundary, const Eigen::Vector2d& axis, double stress) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * boundary.nodes.cols());
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < boundary.orders.size(); ++e) {
    const Eigen::Vector2d t = (boundary.nodes.col(start + boundary.orders[e]) - boundary.nodes.col(start)).normalized();
    const Eigen::Vector2d normal(t.y(), -t.x());
    if (std::abs(std::abs(normal.dot(axis)) - 1.0) < 1e-9) {
      load += sbfem::edge_traction(boundary, static_cast<int>(e), Eigen::Matrix2Xd(stress * normal));
    }
    start += boundary.orders[e];
  }
  return load;
}

/// K u = f for loads in equilibrium: rigid motions are held by springs that such loads do not stretch.
inline Eigen::VectorXd free_displacement(const Plate& plate, const Eigen::VectorXd& load) {
  const Eigen::Index n = plate.boundary.nodes.cols();
  Eigen::MatrixX3d rigid = Eigen::MatrixX3d::Zero(2 * n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1.0;
    rigid(2 * i, 2) = -plate.boundary.nodes(1, i);
    rigid(2 * i + 1, 2) = plate.boundary.nodes(0, i);
  }
  const Eigen::MatrixX3d basis = rigid.householderQr().householderQ() * Eigen::MatrixX3d::Identity(2 * n, 3);
  const Eigen::MatrixXd held = plate.solution.K + plate.material.youngs_modulus * basis * basis.transpose();
  return held.llt().solve(load);
}

/// K u = f with u = `admissible` v; columns that are zero are left out, and the one rigid motion that stays free is
/// held by a spring that the loads do not stretch.
inline Eigen::VectorXd constrained_displacement(const Plate& plate, const Eigen::VectorXd& load,
                                                const Eigen::MatrixXd& admissible, const Eigen::VectorXd& free_motion) {
  Eigen::MatrixXd K = admissible.transpose() * plate.solution.K * admissible;
  for (Eigen::Index k = 0; k < K.rows(); ++k) {
    if (admissible.col(k).isZero(0.0)) K(k, k) = plate.material.youngs_modulus;
  }
  const Eigen::VectorXd spring = (admissible.transpose() * free_motion).normalized();
  K += plate.material.youngs_modulus * spring * spring.transpose();
  return admissible * K.llt().solve(admissible.transpose() * load);
}

/// K u = f with the nodes where `fixed` is true held at 0.
template <typename Fixed>
Eigen::VectorXd clamped_displacement(const Plate& plate, const Eigen::VectorXd& load, const Fixed& fixed) {
  Eigen::MatrixXd K = plate.solution.K;
  Eigen::VectorXd f = load;
  for (Eigen::Index i = 0; i < plate.boundary.nodes.cols(); ++i) {
    if (!fixed(Eigen::Vector2d(plate.boundary.nodes.col(i)))) continue;
    for (Eigen::Index k = 2 * i; k < 2 * i + 2; ++k) {
      K.row(k).setZero();
      K.col(k).setZero();
      K(k, k) = plate.material.youngs_modulus;
      f[k] = 0.0;
    }
  }
  return K.llt().solve(f);
}

/// The state at the tip under boundary displacements and radial loads.
inline TipState state(const Plate& plate, const Eigen::VectorXd& u, std::span<const sbfem::RadialLoad> loads = {},
                      Extraction extraction = Extraction::reciprocity) {
  const CrackTip tip =
      crack_tip(plate.boundary, plate.coefficients, plate.solution, plate.material, {.extraction = extraction});
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();
  for (const sbfem::RadialLoad& load : loads) {
    shares += load_share(tip, plate.coefficients, plate.solution, load);
  }
  return tip_state(tip, u, shares);
}

}  // namespace sunder::fracture::testing
