#include "solver/fracture/stress_intensity.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/fracture/singular_modes.hpp"
#include "solver/fracture/williams.hpp"
#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/edge_element.hpp"
#include "solver/sbfem/particular.hpp"

namespace sunder::fracture {
namespace {

/// Williams' fields are no polynomials along an edge: 12 points beyond the order's own bring their integrals to
/// round-off where the edge is not much longer than its distance from the tip.
constexpr int extra_points = 13;

/// E' [Pa] of the plane state.
double modulus_of(const material::Isotropic& material) {
  return numerics::planted_fault("fracture/plane-stress-modulus") ? material.youngs_modulus
                                                                  : material::effective_modulus(material);
}

/// A crack polygon and its singular displacements: columns u (2n, 2) in global axes with ξ u,ξ = A u beside them.
struct SingularField {
  const sbfem::Boundary& boundary;
  const material::Isotropic& material;
  const TipFrame& frame;
  Eigen::MatrixX2d u, slope;
};

Eigen::Vector2d turned(const TipFrame& frame, const Eigen::Vector2d& global) {
  return frame.to_global.transpose() * global;
}

/// {σ_xx, σ_yy, τ_xy} as a symmetric tensor in the tip's axes.
Eigen::Matrix2d local_stress(const TipFrame& frame, const Eigen::Vector3d& global) {
  Eigen::Matrix2d tensor;
  tensor << global[0], global[2], global[2], global[1];
  return frame.to_global.transpose() * tensor * frame.to_global;
}

/// The edge and its η where the ray θ = 0 leaves the polygon.
struct Ahead {
  std::size_t edge = 0;
  double eta = 0.0;
};
Ahead ahead_of(const std::vector<sbfem::EdgeElement>& edges, const TipFrame& frame) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Eigen::Vector2d a = turned(frame, edges[e].first), b = turned(frame, edges[e].last);
    if (a.y() <= 0.0 && b.y() > 0.0 && a.x() * b.y() - a.y() * b.x() > 0.0 && (a.x() > 0.0 || b.x() > 0.0)) {
      return {e, (-a.y() - b.y()) / (b.y() - a.y())};
    }
  }
  return {};
}

/// [u] = upper minus lower at the mouth: K_I = (E'/8) √(2π/r) [u_y], K_II likewise with [u_x].
Eigen::Matrix2d by_opening(const SingularField& field) {
  const Eigen::Index last = field.u.rows() - 2;
  const double factor = numerics::planted_fault("fracture/cod-factor-two") ? 2.0 : 1.0;
  const double scale =
      factor * modulus_of(field.material) / 8.0 * std::sqrt(2.0 * std::numbers::pi / field.frame.face_length);
  Eigen::Matrix2d K;
  for (int j = 0; j < 2; ++j) {
    const Eigen::Vector2d jump = turned(field.frame, field.u.col(j).segment<2>(last) - field.u.col(j).head<2>());
    K.col(j) << scale * jump.y(), scale * jump.x();
  }
  return K;
}

/// (Uᵀ K U)⁻¹ Uᵀ K u with Williams' r^½ fields U: the closest in energy.
Eigen::Matrix2d by_projection(const SingularField& field, const Eigen::MatrixXd& stiffness) {
  Eigen::MatrixX2d exact(field.u.rows(), 2);
  exact << nodal_displacement({1, Mode::I}, field.material, field.boundary, field.frame),
      nodal_displacement({1, Mode::II}, field.material, field.boundary, field.frame);
  const Eigen::MatrixX2d weighted = stiffness * exact;
  const Eigen::Matrix2d energy = exact.transpose() * weighted;
  return energy.ldlt().solve(weighted.transpose() * field.u);
}

/// K_j = (E'/2) ∮ [(σ : ε_aux) n₁ - t · u_aux,₁ - t_aux · u,₁] ds on ξ = 1 with K_j = 1 in the auxiliary field.
Eigen::Matrix2d by_m_integral(const SingularField& field) {
  const Eigen::Matrix3d D = material::elasticity_matrix(field.material);
  const Eigen::Matrix3d compliance = D.inverse();
  const auto in_tip_axes = [&](const Eigen::Vector2d& v) { return turned(field.frame, v); };
  Eigen::Matrix2d K = Eigen::Matrix2d::Zero();
  for (const sbfem::EdgeElement& edge : sbfem::edge_elements(field.boundary)) {
    const numerics::QuadratureRule gauss = numerics::gauss_legendre(edge.order() + extra_points);
    for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
      const sbfem::EdgePoint point = sbfem::at(edge, gauss.points[g]);
      const Eigen::Vector2d x = in_tip_axes(point.position);
      const double r = x.norm(), theta = std::atan2(x.y(), x.x());
      const Eigen::Vector2d normal = in_tip_axes({point.tangent.y(), -point.tangent.x()});  // outward, times ds/dη
      // ∇ = g1 ∂/∂ξ + g2 ∂/∂η
      const Eigen::Vector2d g1 = in_tip_axes({point.tangent.y(), -point.tangent.x()}) / point.jacobian;
      const Eigen::Vector2d g2 = in_tip_axes({-point.position.y(), point.position.x()}) / point.jacobian;
      for (int j = 0; j < 2; ++j) {
        const Eigen::Vector2d radial = sbfem::interpolate(edge, point.shape, field.slope.col(j));
        const Eigen::Vector2d along = sbfem::interpolate(edge, point.derivative, field.u.col(j));
        const Eigen::Matrix2d sigma = local_stress(field.frame, D * (point.b1 * radial + point.b2 * along));
        const Eigen::Vector3d s(sigma(0, 0), sigma(1, 1), sigma(0, 1));
        const Eigen::Vector2d u_1 = in_tip_axes(g1.x() * radial + g2.x() * along);
        for (int i = 0; i < 2; ++i) {
          const WilliamsField auxiliary{1, i == 0 ? Mode::I : Mode::II};
          const Eigen::Vector3d s_aux = stress(auxiliary, r, theta);
          Eigen::Matrix2d sigma_aux;
          sigma_aux << s_aux[0], s_aux[2], s_aux[2], s_aux[1];
          const Eigen::Vector2d u_aux_1 = displacement_slope(auxiliary, field.material, r, theta);
          K(i, j) += gauss.weights[g] * (s.dot(compliance * s_aux) * normal.x() - (sigma * normal).dot(u_aux_1) -
                                         (sigma_aux * normal).dot(u_1));
        }
      }
    }
  }
  return 0.5 * modulus_of(field.material) * K;
}

/// {K_I, K_II} = √(2π r) {σ_yy, τ_xy} at θ = 0 on the boundary.
Eigen::Matrix2d by_pointwise_stress(const SingularField& field) {
  const Eigen::Matrix3d D = material::elasticity_matrix(field.material);
  const std::vector<sbfem::EdgeElement> edges = sbfem::edge_elements(field.boundary);
  const Ahead ahead = ahead_of(edges, field.frame);
  const sbfem::EdgePoint point = sbfem::at(edges[ahead.edge], ahead.eta);
  const double scale = std::sqrt(2.0 * std::numbers::pi * point.position.norm());
  Eigen::Matrix2d K;
  for (int j = 0; j < 2; ++j) {
    const Eigen::Vector2d radial = sbfem::interpolate(edges[ahead.edge], point.shape, field.slope.col(j));
    const Eigen::Vector2d along = sbfem::interpolate(edges[ahead.edge], point.derivative, field.u.col(j));
    const Eigen::Matrix2d sigma = local_stress(field.frame, D * (point.b1 * radial + point.b2 * along));
    K.col(j) << scale * sigma(1, 1), scale * sigma(0, 1);
  }
  return K;
}

Eigen::Matrix2d factors_of(const SingularField& field, const Eigen::MatrixXd& stiffness, Extraction extraction) {
  switch (extraction) {
    case Extraction::reciprocity:  // needs no modes
    case Extraction::energy_projection:
      return by_projection(field, stiffness);
    case Extraction::crack_opening_displacement:
      return by_opening(field);
    case Extraction::m_integral:
      return by_m_integral(field);
    case Extraction::pointwise_stress:
      return by_pointwise_stress(field);
  }
  return Eigen::Matrix2d::Zero();
}

/// σ_xx in the tip's axes, straight ahead, of the displacement ξ d: a row (2n).
Eigen::RowVectorXd stress_along_crack(const sbfem::Boundary& boundary, const TipFrame& frame,
                                      const material::Isotropic& material) {
  const std::vector<sbfem::EdgeElement> edges = sbfem::edge_elements(boundary);
  const Ahead ahead = ahead_of(edges, frame);
  const sbfem::EdgeElement& edge = edges[ahead.edge];
  const sbfem::EdgePoint point = sbfem::at(edge, ahead.eta);
  const Eigen::Vector2d e = frame.to_global.col(0);
  // e · σ e as a row on {σ_xx, σ_yy, τ_xy}
  const Eigen::RowVector3d along(e.x() * e.x(), e.y() * e.y(), 2.0 * e.x() * e.y());
  const Eigen::RowVector3d of_strain = along * material::elasticity_matrix(material);
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(2 * boundary.nodes.cols());
  for (int i = 0; i <= edge.order(); ++i) {
    row.segment<2>(2 * edge.nodes[i]) += of_strain * (point.shape[i] * point.b1 + point.derivative[i] * point.b2);
  }
  return row;
}

/// F and what goes with it from the two groups of modes.
void read_modes(CrackTip& tip, const SingularModes& modes, const sbfem::Boundary& boundary,
                const sbfem::PolygonSolution& solution, const material::Isotropic& material, const TipFrame& frame) {
  const SingularField field{boundary, material, frame, modes.singular.right, solution.A * modes.singular.right};
  const Eigen::Matrix2d K_of_modes = factors_of(field, solution.K, tip.extraction);
  tip.of_displacement.topRows<2>() = K_of_modes * modes.singular.left.transpose();
  tip.singular_exponents = K_of_modes * modes.singular.matrix * K_of_modes.inverse();

  // A state of uniform σ_xx and a rotation leave the faces free and are linear in x: any order holds them exactly, so
  // they are the basis in which the unit group is read.
  Eigen::MatrixX2d exact(boundary.nodes.size(), 2);
  exact << nodal_displacement({2, Mode::I}, material, boundary, frame),
      nodal_displacement({2, Mode::II}, material, boundary, frame);
  if (numerics::planted_fault("fracture/t-stress-without-rotation-filter")) {
    // The group read as if σ_xx were all of it: least squares on one column.
    tip.of_displacement.row(2) = exact.col(0).transpose() / exact.col(0).squaredNorm();
    tip.unit_exponents.setIdentity();
    return;
  }
  const Eigen::PartialPivLU<Eigen::Matrix2d> share(modes.unit.left.transpose() * exact);
  const Eigen::Matrix2Xd rows = share.solve(modes.unit.left.transpose());
  tip.of_displacement.row(2) = rows.row(0);
  tip.rotation = rows.row(1);
  tip.unit_exponents = share.solve(modes.unit.matrix * (modes.unit.left.transpose() * exact));
}

/// Tractions of Williams fields on the boundary as nodal forces ∮ Nᵀ t ds: one row (2n) a field, global axes.
Eigen::Matrix3Xd boundary_forces(const std::array<WilliamsField, 3>& fields, const sbfem::Boundary& boundary,
                                 const TipFrame& frame) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, boundary.nodes.size());
  // One rule for all edges: making a rule costs more than using it.
  const int largest = *std::max_element(boundary.orders.begin(), boundary.orders.end());
  const numerics::QuadratureRule gauss = numerics::gauss_legendre(largest + extra_points);
  std::map<int, Eigen::MatrixXd> shapes;  // (p + 1, points), by order
  for (const sbfem::EdgeElement& edge : sbfem::edge_elements(boundary)) {
    Eigen::MatrixXd& shape = shapes[edge.order()];
    if (shape.size() == 0) {
      shape.resize(edge.order() + 1, gauss.points.size());
      for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
        shape.col(g) = numerics::values(edge.basis, gauss.points[g]);
      }
    }
    const Eigen::Vector2d middle = turned(frame, 0.5 * (edge.first + edge.last));
    const Eigen::Vector2d half = turned(frame, 0.5 * (edge.last - edge.first));
    for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
      const Eigen::Vector2d x = middle + gauss.points[g] * half;
      const double r = x.norm(), theta = std::atan2(x.y(), x.x());
      for (int j = 0; j < 3; ++j) {
        // n ds = (dy, -dx)
        const Eigen::Vector3d s = stress(fields[static_cast<std::size_t>(j)], r, theta);
        const Eigen::Vector2d traction(s[0] * half.y() - s[2] * half.x(), s[2] * half.y() - s[1] * half.x());
        const Eigen::Vector2d weighted = gauss.weights[g] * (frame.to_global * traction);
        for (int i = 0; i <= edge.order(); ++i) {
          forces.block<1, 2>(j, 2 * edge.nodes[i]) += shape(i, g) * weighted;
        }
      }
    }
  }
  return forces;
}

/// ∮ (t_n · u_m - t_m · u_n) ds around the tip with m = -n: the same on every contour.
double pairing(const WilliamsField& exterior, const WilliamsField& field, const material::Isotropic& material) {
  // On the unit circle the integrand is a trigonometric polynomial of degree 6 at most; the trapezoidal rule on
  // 16 points of the full period is exact.
  constexpr int points = 16;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double theta = std::numbers::pi * (2.0 * (i + 0.5) / points - 1.0);
    const Eigen::Vector2d normal(std::cos(theta), std::sin(theta));
    const auto traction = [&](const WilliamsField& of) {
      const Eigen::Vector3d s = stress(of, 1.0, theta);
      return Eigen::Vector2d(s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y());
    };
    sum += traction(exterior).dot(displacement(field, material, 1.0, theta)) -
           traction(field).dot(displacement(exterior, material, 1.0, theta));
  }
  return sum * 2.0 * std::numbers::pi / points;
}

/// Betti's theorem between the polygon's field and the exterior fields ψ of power -λ: with q = K u_b the boundary
/// forces and t(ψ) the tractions, ∮ (t(ψ) · u - ψ · t) ds = amplitude × pairing. [Babuška & Miller 1984, contour
/// integral method]
void read_by_reciprocity(CrackTip& tip, const sbfem::Boundary& boundary, const sbfem::PolygonSolution& solution,
                         const material::Isotropic& material, const TipFrame& frame) {
  constexpr std::array<WilliamsField, 3> fields{{{1, Mode::I}, {1, Mode::II}, {2, Mode::I}}};
  constexpr std::array<WilliamsField, 3> exterior{{{-1, Mode::I}, {-1, Mode::II}, {-2, Mode::I}}};
  tip.dual.resize(3, boundary.nodes.size());
  tip.of_displacement = boundary_forces(exterior, boundary, frame);
  for (int j = 0; j < 3; ++j) {
    const double scale = 1.0 / pairing(exterior[j], fields[j], material);
    tip.dual.row(j) = scale * nodal_displacement(exterior[j], material, boundary, frame);
    tip.of_displacement.row(j) *= scale;
  }
  tip.of_displacement.noalias() -= tip.dual * solution.K;
}

}  // namespace

CrackTip crack_tip(const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
                   const sbfem::PolygonSolution& solution, const material::Isotropic& material,
                   const CrackTipOptions& options) {
  const TipFrame frame = tip_frame(boundary);
  const Eigen::Index dofs = 2 * boundary.nodes.cols();
  CrackTip tip{.direction = frame.direction,
               .face_length = frame.face_length,
               .exponents = {},
               .of_displacement = {},
               .extraction = options.extraction,
               .dual = {},
               .singular_exponents = {},
               .unit_exponents = {},
               .rotation = {},
               .T_of_linear_field = stress_along_crack(boundary, frame, material)};
  tip.of_displacement = Eigen::Matrix3Xd::Zero(3, dofs);
  const bool by_modes = options.extraction != Extraction::reciprocity;
  if (by_modes || options.exponents) {
    const SingularModes modes = singular_modes(boundary, material, coefficients, solution);
    if (modes.status == ModeStatus::not_a_crack) {
      tip.status = TipStatus::not_a_crack;
      return tip;
    }
    tip.exponents = modes.singular.exponents;
    if (by_modes) read_modes(tip, modes, boundary, solution, material, frame);
  }
  if (!by_modes) read_by_reciprocity(tip, boundary, solution, material, frame);
  return tip;
}

Eigen::Vector3d load_share(const CrackTip& tip, const sbfem::Coefficients& coefficients,
                           const sbfem::PolygonSolution& solution, const sbfem::RadialLoad& load) {
  Eigen::Vector3d share = Eigen::Vector3d::Zero();
  if (tip.status != TipStatus::ready || numerics::planted_fault("sbfem/particular-part-dropped")) return share;
  const double s = load.power + 1.0;
  const Eigen::VectorXd f = sbfem::load_vector(solution, load);
  const bool by_modes = tip.extraction != Extraction::reciprocity;
  if (by_modes) {
    // (s I - A) d = -E0⁻¹ f, so that the share Wᵀ(-d) of a group is (s I - S)⁻¹ Wᵀ E0⁻¹ f: no equation that is
    // singular, as s >= 1 is never an exponent of the singular group.
    const Eigen::VectorXd w = coefficients.E0.llt().solve(f);
    const Eigen::Matrix2d singular = s * Eigen::Matrix2d::Identity() - tip.singular_exponents;
    share.head<2>() = singular.partialPivLu().solve(tip.of_displacement.topRows<2>() * w);
    if (load.power > 0) {
      const Eigen::Matrix2d unit = s * Eigen::Matrix2d::Identity() - tip.unit_exponents;
      const Eigen::Vector2d shares(tip.of_displacement.row(2).dot(w), tip.rotation.dot(w));
      share[2] = unit.partialPivLu().solve(shares)[0];
    }
  } else {
    // The boundary forces are K u_b - f, and the load itself works along the rays on ξ^-λ ψ: ∫ ξ^(k-λ) dξ = 1/(s - λ).
    const double lambda = numerics::planted_fault("fracture/load-share-of-interior-power") ? -0.5 : 0.5;
    share.head<2>() = tip.dual.topRows<2>() * (f - load.density / (s - lambda));
    if (load.power > 0) share[2] = tip.dual.row(2).dot(f - load.density / (s - 1.0));
  }
  if (load.power == 0) {
    // s = 1 is an exponent of the unit group: the linear field itself is needed, with its own σ_xx.
    const Eigen::VectorXd d = sbfem::particular_solution(coefficients, solution, load).d;
    share[2] = tip.T_of_linear_field.dot(d) - tip.of_displacement.row(2).dot(d);
  }
  return share;
}

TipState tip_state(const CrackTip& tip, const Eigen::VectorXd& boundary_displacement,
                   const Eigen::Vector3d& load_shares) {
  const Eigen::Vector3d values = tip.of_displacement * boundary_displacement + load_shares;
  return {.factors = {.K_I = values[0], .K_II = values[1]}, .T_stress = values[2]};
}

}  // namespace sunder::fracture
