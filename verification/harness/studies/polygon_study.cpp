#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/nodal_mesh.hpp"
#include "solver/sbfem/interior_field.hpp"
#include "solver/sbfem/polygon_solution.hpp"
#include "verification/exact/polygon.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using exact::Complex;
using results::Quantity;

std::vector<Complex> outline_of(const StudyInput& input) {
  const std::string shape = text_parameter(input, "shape");
  std::vector<Complex> outline;
  if (shape == "regular" || shape == "star") {
    const int corners = static_cast<int>(number_parameter(input, "corners"));
    const double inner = shape == "star" ? number_parameter(input, "inner_radius") : 1.0;
    for (int i = 0; i < corners; ++i)
      outline.push_back(std::polar(i % 2 == 1 ? inner : 1.0, 2.0 * std::numbers::pi * i / corners));
  } else if (shape == "rectangle") {
    const double a = number_parameter(input, "aspect");  // width over height
    outline = {{-0.5 * a, -0.5}, {0.5 * a, -0.5}, {0.5 * a, 0.5}, {-0.5 * a, 0.5}};
  } else if (shape == "short-edge") {  // a square with one corner cut off
    const double cut = number_parameter(input, "edge") / std::sqrt(2.0);
    outline = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5 - cut}, {0.5 - cut, 0.5}, {-0.5, 0.5}};
  } else {
    throw CaseError(input.verification_case.id +
                    ": parameters.shape: \"regular\", \"star\", \"rectangle\" or \"short-edge\" is needed");
  }
  const Complex turn = std::polar(number_parameter(input, "scale", 1.0), number_parameter(input, "rotation", 0.0));
  const Complex shift{number_parameter(input, "shift", 0.0), number_parameter(input, "shift", 0.0)};
  for (Complex& corner : outline) corner = corner * turn + shift;
  return outline;
}

/// The polygon with its scaling centre at the mean of its corners, or at `centre_distance` (in units of the half
/// height) from the middle of its first edge.
mesh::PolygonMesh mesh_of(const StudyInput& input, const std::vector<Complex>& outline) {
  mesh::PolygonMesh mesh;
  mesh::Polygon polygon;
  Complex centre{};
  for (const Complex corner : outline) {
    polygon.vertices.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.vertices.emplace_back(corner.real(), corner.imag());
    centre += corner / static_cast<double>(outline.size());
  }
  const Complex middle = 0.5 * (outline[0] + outline[1]);
  centre = middle + number_parameter(input, "centre_distance", 1.0) * (centre - middle);
  polygon.scaling_centre = {centre.real(), centre.imag()};
  mesh.polygons.push_back(std::move(polygon));
  return mesh;
}

/// One polygon and what the exact fields say about it.
struct Trial {
  mesh::NodalMesh nodes;
  sbfem::Boundary boundary;
  material::Isotropic material;
  exact::PlaneBody body;
  sbfem::Coefficients coefficients;
  sbfem::PolygonSolution solution;

  Complex node(int i) const { return {nodes.coordinates()(0, i), nodes.coordinates()(1, i)}; }
  int count() const { return static_cast<int>(boundary.nodes.cols()); }
};

Eigen::VectorXd at_nodes(const Trial& trial, const std::function<Complex(Complex)>& field) {
  const auto polygon = trial.nodes.polygon(0);
  Eigen::VectorXd values(2 * trial.count());
  for (int i = 0; i < trial.count(); ++i) {
    const Complex value = field(trial.node(polygon.nodes[static_cast<std::size_t>(i)]));
    values[2 * i] = value.real();
    values[2 * i + 1] = value.imag();
  }
  return values;
}

/// The field about the middle of the polygon, so that far-away bodies do not lose digits in the exact answer itself.
struct CentredField {
  exact::PolynomialField field;
  Complex middle;
  double size;
  Complex local(Complex z) const { return (z - middle) / size; }
};

Eigen::VectorXd exact_forces(const Trial& trial, const CentredField& field, int degree) {
  const auto polygon = trial.nodes.polygon(0);
  const int n = trial.count();
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * n);
  int start = 0;
  for (const int order : polygon.orders) {
    std::vector<Complex> on_edge;
    for (int k = 0; k <= order; ++k)
      on_edge.push_back(trial.node(polygon.nodes[static_cast<std::size_t>((start + k) % n)]));
    const Complex along = on_edge.back() - on_edge.front();
    const Complex normal = Complex(0.0, -1.0) * along / std::abs(along);  // outward of a counter-clockwise boundary
    const auto traction = [&](Complex z) {
      return exact::traction(exact::stress(field.field, field.local(z)), normal) / field.size;
    };
    const auto on_nodes = exact::edge_forces(on_edge, traction, (order + degree) / 2 + 1);
    for (int k = 0; k <= order; ++k) {
      const int i = (start + k) % n;
      forces[2 * i] += on_nodes[static_cast<std::size_t>(k)].real();
      forces[2 * i + 1] += on_nodes[static_cast<std::size_t>(k)].imag();
    }
    start += order;
  }
  return forces;
}

struct PatchErrors {
  double force = 0.0, backward = 0.0, stress = 0.0;
};

double stress_error(const Trial& trial, const CentredField& field, const Eigen::VectorXd& displacement) {
  const sbfem::InteriorField interior(trial.boundary, trial.coefficients, trial.solution, trial.material, displacement);
  const auto polygon = trial.nodes.polygon(0);
  double largest = 0.0, error = 0.0;
  for (const double xi : {0.3, 0.8}) {
    const auto ring = interior.ring(xi);
    for (int edge = 0; edge < static_cast<int>(trial.boundary.orders.size()); ++edge) {
      const auto on_edge = trial.nodes.edge_nodes(0, edge);
      const Complex start = trial.node(on_edge.front()), end = trial.node(on_edge.back());
      const Complex centre{polygon.scaling_centre.x(), polygon.scaling_centre.y()};
      for (const double s : {0.2, 0.7}) {
        const Complex z = centre + xi * (start + s * (end - start) - centre);
        const exact::PlaneStress expected = exact::stress(field.field, field.local(z));
        const Eigen::Vector3d wanted = Eigen::Vector3d(expected.xx, expected.yy, expected.xy) / field.size;
        largest = std::max(largest, wanted.norm());
        error = std::max(error, (interior.stress(ring, edge, s) - wanted).norm());
      }
    }
  }
  return error / largest;
}

/// The worst errors over the four fields of every degree up to `greatest`.
PatchErrors patch_errors(const Trial& trial, const exact::AreaMoments& moments, int greatest) {
  PatchErrors worst;
  const Complex middle = moments.first / moments.area;
  const double size = std::sqrt(moments.area), stiffness = trial.solution.K.norm();
  for (int degree = 1; degree <= greatest; ++degree)
    for (int part = 0; part < 4; ++part) {
      if (degree == 1 && part == 1) continue;  // the rotation
      const CentredField field{exact::polynomial_field(degree, part, trial.body.shear_modulus), middle, size};
      const Eigen::VectorXd u =
          at_nodes(trial, [&](Complex z) { return exact::displacement(field.field, trial.body, field.local(z)); });
      const Eigen::VectorXd f = exact_forces(trial, field, degree);
      const double residual = (trial.solution.K * u - f).norm();
      worst.force = std::max(worst.force, residual / f.norm());
      worst.backward = std::max(worst.backward, residual / (stiffness * u.norm()));
      worst.stress = std::max(worst.stress, stress_error(trial, field, u));
    }
  return worst;
}

double rigid_motion_error(const Trial& trial, Complex middle) {
  double worst = 0.0;
  const std::function<Complex(Complex)> motions[] = {[](Complex) { return Complex(1.0, 0.0); },
                                                     [](Complex) { return Complex(0.0, 1.0); },
                                                     [&](Complex z) { return Complex(0.0, 1.0) * (z - middle); }};
  for (const auto& motion : motions) {
    const Eigen::VectorXd u = at_nodes(trial, motion);
    worst = std::max(worst, (trial.solution.K * u).norm() / (trial.solution.K.norm() * u.norm()));
  }
  return worst;
}

/// uᵀ M u against ρ ∫ |u|² dA for the four linear fields z, i z, conj z, i conj z about the middle and two
/// translations.
double mass_error(const Trial& trial, std::span<const Complex> outline, Complex middle) {
  std::vector<Complex> about_middle;
  for (const Complex corner : outline) about_middle.push_back(corner - middle);
  const exact::AreaMoments moments = exact::area_moments(about_middle);
  const Eigen::MatrixXd M = sbfem::mass(trial.coefficients, trial.solution);
  const double rho = trial.material.density;
  double worst = 0.0;
  const std::function<Complex(Complex)> linear[] = {[](Complex z) { return z; },
                                                    [](Complex z) { return Complex(0.0, 1.0) * z; },
                                                    [](Complex z) { return std::conj(z); }};
  for (const auto& field : linear) {
    const Eigen::VectorXd u = at_nodes(trial, [&](Complex z) { return field(z - middle); });
    worst = std::max(worst, std::abs(u.dot(M * u) / (rho * moments.polar) - 1.0));
  }
  for (const Complex direction : {Complex(1.0, 0.0), Complex(0.0, 1.0)}) {
    const Eigen::VectorXd u = at_nodes(trial, [&](Complex) { return direction; });
    worst = std::max(worst, std::abs(u.dot(M * u) / (rho * moments.area) - 1.0));
  }
  return worst;
}

/// How far the lowest exponents of A are from 0, 0 and each of 1 … order four times.
double exponent_error(const Trial& trial, int order) {
  std::vector<Complex> exponents;
  const Eigen::VectorXcd values = trial.solution.A.eigenvalues();
  exponents.assign(values.begin(), values.end());
  std::sort(exponents.begin(), exponents.end(), [](Complex a, Complex b) { return a.real() < b.real(); });
  double worst = std::max(std::abs(exponents[0]), std::abs(exponents[1]));
  for (std::size_t i = 2; i < exponents.size() && i < 2 + 4 * static_cast<std::size_t>(order); ++i)
    worst = std::max(worst, std::abs(exponents[i] - static_cast<double>(1 + (i - 2) / 4)));
  return worst;
}

int zero_stiffness_modes(const Eigen::MatrixXd& K) {
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  const double round_off =
      1e-10 * values.cwiseAbs().maxCoeff();  // between eps · cond of K's arithmetic and its smallest stiffness
  return static_cast<int>((values.array().abs() < round_off).count());
}

double route_difference(const Trial& trial, sbfem::Route route) {
  const sbfem::PolygonSolution other = sbfem::solve_polygon(trial.coefficients, route);
  return (other.K - trial.solution.K).norm() / trial.solution.K.norm();
}

sbfem::Route route_of(const StudyInput& input) {
  const std::string name = text_parameter(input, "route", "ring-doubling");
  if (name == "ring-doubling") return sbfem::Route::ring_doubling;
  if (name == "matrix-sign") return sbfem::Route::matrix_sign;
  if (name == "ordered-schur") return sbfem::Route::ordered_schur;
  throw CaseError(input.verification_case.id +
                  ": parameters.route: \"ring-doubling\", \"matrix-sign\" or \"ordered-schur\" is needed");
}

}  // namespace

StudyOutput run_polygon(const StudyInput& input) {
  const std::vector<Complex> outline = outline_of(input);
  const exact::AreaMoments moments = exact::area_moments(outline);
  const int order = static_cast<int>(number_parameter(input, "order", 1.0));
  const double E = number_parameter(input, "youngs_modulus", 1.0), nu = number_parameter(input, "poisson_ratio", 0.2);
  const bool stress = text_parameter(input, "plane", "strain") == "stress";
  const material::Isotropic material{E, nu, 1.0, stress ? material::Plane::stress : material::Plane::strain};
  const mesh::NodalMesh nodes = mesh::place_nodes(mesh_of(input, outline), [&](int, int) { return order; });
  const sbfem::Boundary boundary = sbfem::boundary_of(nodes, 0);
  const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, material);
  const Trial trial{nodes,        boundary,
                    material,     stress ? exact::plane_stress(E, nu) : exact::plane_strain(E, nu),
                    coefficients, sbfem::solve_polygon(coefficients, route_of(input))};

  StudyOutput output;
  output.summary.mesh = {1, trial.count(), 2 * trial.count()};
  if (trial.solution.status != sbfem::PolygonStatus::converged) {
    output.summary.status = trial.solution.status == sbfem::PolygonStatus::not_converged
                                ? "stopped: the polygon's stiffness did not converge"
                                : "stopped: the polygon's stiffness is not positive definite";
    return output;
  }
  const Complex middle = moments.first / moments.area;
  const PatchErrors patch = patch_errors(trial, moments, static_cast<int>(number_parameter(input, "degree", order)));
  output.summary.quantities = Quantity(Quantity::Table{
      {"force_error", patch.force},
      {"backward_error", patch.backward},
      {"stress_error", patch.stress},
      {"rigid_motion_error", rigid_motion_error(trial, middle)},
      {"zero_stiffness_modes", zero_stiffness_modes(trial.solution.K)},
      {"asymmetry", trial.solution.asymmetry},
      {"mass_error", mass_error(trial, outline, middle)},
      {"exponent_error", exponent_error(trial, order)},
      {"sign_difference", route_difference(trial, sbfem::Route::matrix_sign)},
      {"schur_difference", route_difference(trial, sbfem::Route::ordered_schur)},
      {"iterations", trial.solution.iterations},
  });
  return output;
}

}  // namespace sunder::verification
