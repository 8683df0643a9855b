/// One polygon against everything that is known of it: equilibrium polynomials, rigid motions, exponents, moments of
/// mass, and itself by other routes.

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>

#include "solver/mesh/nodal_mesh.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/sbfem/modes.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/exact_fields.hpp"
#include "verification/harness/studies/free_body.hpp"
#include "verification/harness/studies/interior_stress.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using results::Quantity;

const std::pair<const char*, sbfem::Route> routes[] = {{"ring doubling", sbfem::Route::ring_doubling},
                                                       {"matrix sign", sbfem::Route::matrix_sign},
                                                       {"ordered Schur", sbfem::Route::ordered_schur}};

sbfem::Route route_of(const StudyInput& input) {
  const std::string wanted = text_parameter(input, "route", "ring doubling");
  for (const auto& [name, route] : routes)
    if (wanted == name) return route;
  throw CaseError(input.verification_case.id + ": parameters.route: there is no route \"" + wanted + "\"");
}

/// Empty where the solution is to be used.
std::string reason_to_stop(sbfem::PolygonStatus status, const std::string& what) {
  if (status == sbfem::PolygonStatus::converged) return "";
  return "stopped: " + what +
         (status == sbfem::PolygonStatus::not_converged ? " has not converged"
                                                        : " is not positive definite by round-off");
}

double relative_difference(const MatrixXd& a, const MatrixXd& b) {
  return (a - b).norm() / b.norm();
}

VectorXd nodal_forces(const PlacedField& field, const sbfem::Boundary& boundary) {
  const Eigen::Index n = boundary.nodes.cols();
  VectorXd f = VectorXd::Zero(2 * n);
  Eigen::Index start = 0;
  for (const int p : boundary.orders) {
    const VectorXd edge = edge_force(field, boundary.nodes.col(start), boundary.nodes.col((start + p) % n), p);
    for (int i = 0; i <= p; ++i) f.segment<2>(2 * ((start + i) % n)) += edge.segment<2>(2 * i);
    start += p;
  }
  return f;
}

/// The largest over all equilibrium polynomials up to the order of ‖K u - f‖ / ‖f‖, ‖K u - f‖ / (‖K‖ ‖u‖) and, where
/// `stress` is asked for, of the difference of stress inside over the largest stress.
void add_patch_errors(const StudyInput& input, const ShapedPolygon& polygon, const sbfem::Boundary& boundary,
                      const sbfem::Coefficients& coefficients, const sbfem::PolygonSolution& solution,
                      Quantity& quantities) {
  const bool with_stress = number_parameter(input, "stress", 0.0) != 0.0;
  const MatrixXd& K = solution.K;
  double force = 0.0, backward = 0.0, stress = 0.0;
  const Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  const auto fields = polynomial_fields(polygon.material, polygon.order, centre, polygon.size);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i == 1) continue;  // the rotation has neither force nor stress to compare with
    const VectorXd u = displacements(fields[i], boundary.nodes), f = nodal_forces(fields[i], boundary);
    const double residual = (K * u - f).norm();
    force = std::fmax(force, residual / f.norm());
    backward = std::fmax(backward, residual / (K.norm() * u.norm()));
    if (!with_stress) continue;
    const StressDifference inside =
        interior_stress_difference(boundary, coefficients, solution, u, polygon.material, centre, fields[i]);
    stress = std::fmax(stress, inside.difference / inside.exact);
  }
  quantities["force_error"] = force;
  quantities["backward_error"] = backward;
  if (with_stress) quantities["stress_error"] = stress;
}

/// Rigid motions carry no force; in the scale of the diagonal exactly three eigenvalues are zero.
void add_rigid_motions(const sbfem::Boundary& boundary, const MatrixXd& K, Quantity& quantities) {
  const MatrixXd rigid = rigid_motions(boundary.nodes, Eigen::Vector2d::Zero());
  quantities["rigid_error"] = (K * rigid).colwise().norm().maxCoeff() / K.norm();
  const VectorXd spectrum = scaled_spectrum(K);
  const double largest = spectrum[spectrum.size() - 1];
  quantities["largest_rigid"] = spectrum.head(3).cwiseAbs().maxCoeff() / largest;
  quantities["smallest_elastic"] = spectrum[3] / largest;
}

/// A closed homogeneous polygon of order p holds four polynomials of each degree 1 … p: four exponents at each.
double exponent_error(const VectorXd& exponents, int order) {
  double worst = exponents.head(2).cwiseAbs().maxCoeff();
  for (int k = 1; k <= order; ++k) {
    VectorXd distance = (exponents.array() - k).abs();
    std::sort(distance.begin(), distance.end());
    worst = std::fmax(worst, distance[3]);
  }
  return worst;
}

void add_modes(const ShapedPolygon& polygon, const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
               Quantity& quantities, std::string& status) {
  const sbfem::ModalSolution all = sbfem::modes(coefficients);
  status = reason_to_stop(all.status, "the Schur form");
  if (!status.empty()) return;
  const Eigen::VectorXcd lambda = -all.S.eigenvalues();
  VectorXd exponents = lambda.real();
  std::sort(exponents.begin(), exponents.end());
  if (boundary.open) {
    const Eigen::Index count = std::min<Eigen::Index>(10, exponents.size());
    quantities["exponents"] = Quantity(std::vector<double>(exponents.begin(), exponents.begin() + count));
  } else {
    quantities["exponent_error"] = exponent_error(exponents, polygon.order);
  }
  const VectorXd scale = coefficients.E0.diagonal().cwiseSqrt();
  const VectorXd singular = Eigen::JacobiSVD<MatrixXd>(scale.asDiagonal() * all.Vu).singularValues();
  quantities["condition_of_modes"] = singular[0] / singular[singular.size() - 1];
}

/// (I + A)ᵀ M + M (I + A) = M0 on the complex Schur form of I + A, entry by entry [Bartels & Stewart 1972].
MatrixXd mass_by_schur_form(const sbfem::Coefficients& coefficients, const MatrixXd& A) {
  const Eigen::Index n = A.rows();
  const VectorXd stretch = coefficients.E0.diagonal().cwiseSqrt(), scale = stretch.cwiseInverse();
  const MatrixXd loop = MatrixXd::Identity(n, n) + MatrixXd(stretch.asDiagonal() * A * scale.asDiagonal());
  const Eigen::ComplexSchur<MatrixXd> schur(loop);
  const Eigen::MatrixXcd& T = schur.matrixT();
  const Eigen::MatrixXcd& U = schur.matrixU();
  const MatrixXd M0 = scale.asDiagonal() * coefficients.M0 * scale.asDiagonal();
  const Eigen::MatrixXcd right = U.adjoint() * M0 * U;
  Eigen::MatrixXcd X = Eigen::MatrixXcd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXcd column = right.col(j) - X.leftCols(j) * T.col(j).head(j);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::complex<double> above = T.col(i).head(i).dot(X.col(j).head(i));
      X(i, j) = (column[i] - above) / (std::conj(T(i, i)) + T(j, j));
    }
  }
  const MatrixXd M = (U * X * U.adjoint()).real();
  return stretch.asDiagonal() * M * stretch.asDiagonal();
}

/// ρ ∫ {1, x, y}ᵀ {1, x, y} dA from the triangles between the scaling centre and the edges, lengths in `size`.
Eigen::Matrix3d exact_moments(const ShapedPolygon& polygon) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  const mesh::Polygon& only = polygon.mesh.polygons.front();
  for (int e = 0; e < only.edge_count(); ++e) {
    const Eigen::Vector2d a = polygon.mesh.vertices[only.edge(e)[0]] - only.scaling_centre;
    const Eigen::Vector2d b = polygon.mesh.vertices[only.edge(e)[1]] - only.scaling_centre;
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    const Eigen::Vector3d p(1.0, a.x() / polygon.size, a.y() / polygon.size);
    const Eigen::Vector3d q(1.0, b.x() / polygon.size, b.y() / polygon.size);
    const Eigen::Vector3d centre(1.0, 0.0, 0.0), sum = p + q + centre;
    moments +=
        area / 12.0 * (p * p.transpose() + q * q.transpose() + centre * centre.transpose() + sum * sum.transpose());
  }
  return polygon.material.density * moments;
}

void add_mass(const ShapedPolygon& polygon, const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
              const MatrixXd& M, const MatrixXd& A, Quantity& quantities) {
  MatrixXd linear(boundary.nodes.cols(), 3);  // {1, x, y} at the nodes
  linear << VectorXd::Ones(boundary.nodes.cols()), boundary.nodes.transpose() / polygon.size;
  const auto component = [&](Eigen::Index row, Eigen::Index column) {
    const Eigen::Index n = linear.rows();
    MatrixXd part(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < n; ++i) part(i, j) = M(2 * i + row, 2 * j + column);
    return Eigen::Matrix3d(linear.transpose() * part * linear);
  };
  const Eigen::Matrix3d expected = exact_moments(polygon), xx = component(0, 0), yy = component(1, 1);
  quantities["area_error"] =
      std::fmax(std::abs(xx(0, 0) / expected(0, 0) - 1.0), std::abs(yy(0, 0) / expected(0, 0) - 1.0));
  if (!boundary.open) {
    const double error =
        std::sqrt((xx - expected).squaredNorm() + (yy - expected).squaredNorm() + 2.0 * component(0, 1).squaredNorm());
    quantities["moment_error"] = error / (std::sqrt(2.0) * expected.norm());
  }
  quantities["mass_difference"] = relative_difference(M, mass_by_schur_form(coefficients, A));
}

/// The other routes, and what a mesh of this polygon gets from the batches, against K and M.
std::string add_differences(const ShapedPolygon& polygon, const sbfem::Coefficients& coefficients,
                            const sbfem::PolygonSolution& solution, const MatrixXd& M, Quantity& quantities) {
  double difference = 0.0, asymmetry = 0.0;
  for (const auto& [name, route] : routes) {
    const sbfem::PolygonSolution other = sbfem::solve_polygon(coefficients, route);
    if (std::string reason = reason_to_stop(other.status, name); !reason.empty()) return reason;
    difference = std::fmax(difference, relative_difference(other.K, solution.K));
    asymmetry = std::fmax(asymmetry, other.asymmetry);
  }
  quantities["route_difference"] = difference;
  quantities["asymmetry"] = asymmetry;
  const mesh::NodalMesh nodes = mesh::place_nodes(polygon.mesh, [&](int, int) { return polygon.order; });
  const sbfem::Formation formed = sbfem::form(nodes, {&polygon.material, 1}, {.with_mass = true});
  if (std::string reason = reason_to_stop(formed.status(0), "the formation"); !reason.empty()) return reason;
  quantities["formation_difference"] = relative_difference(formed.stiffness(0), solution.K);
  quantities["formation_mass_difference"] = relative_difference(formed.mass(0), M);
  return "";
}

}  // namespace

StudyOutput run_one_polygon(const StudyInput& input) {
  const ShapedPolygon polygon = shaped_polygon(input);
  StudyOutput output;
  results::RunSummary& summary = output.summary;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "sbfem", "polygons");
    const sbfem::Boundary boundary = boundary_of(polygon);
    const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, polygon.material);
    const sbfem::PolygonSolution solution = sbfem::solve_polygon(coefficients, route_of(input));
    summary.mesh = {1, static_cast<long>(boundary.nodes.cols()), 2 * static_cast<long>(boundary.nodes.cols())};
    std::string stop = reason_to_stop(solution.status, "the polygon");
    const MatrixXd M = stop.empty() ? sbfem::mass(coefficients, solution) : MatrixXd();
    if (stop.empty() && !M.allFinite()) stop = "stopped: the mass does not carry its area";
    if (stop.empty()) {
      if (!boundary.open) add_patch_errors(input, polygon, boundary, coefficients, solution, summary.quantities);
      add_rigid_motions(boundary, solution.K, summary.quantities);
      add_mass(polygon, boundary, coefficients, M, solution.A, summary.quantities);
      summary.quantities["iterations"] = solution.iterations;
      if (number_parameter(input, "modes", 1.0) != 0.0)
        add_modes(polygon, boundary, coefficients, summary.quantities, stop);
      if (stop.empty() && number_parameter(input, "compare", 1.0) != 0.0)
        stop = add_differences(polygon, coefficients, solution, M, summary.quantities);
    }
    if (!stop.empty()) summary.status = stop;
  }
  ledger.close(summary);
  return output;
}

}  // namespace sunder::verification
