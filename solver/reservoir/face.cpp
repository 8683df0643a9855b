#include "solver/reservoir/face.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::reservoir {
namespace {

constexpr double merged = 1e-9;  // of the depth: heights nearer than this are one

void refuse(const std::string& what) {
  throw std::invalid_argument("reservoir face: " + what);
}

numerics::LagrangeBasis basis_of(int order) {
  return numerics::lagrange_basis(numerics::gauss_lobatto(order + 1).points);
}

void check_elements(const Face& face) {
  if (face.elements.empty()) refuse("there must be at least one element");
  if (!face.heights.allFinite()) refuse("every height must be finite");
  for (const std::vector<int>& nodes : face.elements) {
    if (nodes.size() < 2 || nodes.size() > 33)
      refuse("order " + std::to_string(static_cast<int>(nodes.size()) - 1) + " must be 1 … 32");
    for (int node : nodes)
      if (node < 0 || node >= face.size()) refuse("there is no node " + std::to_string(node));
    if (!(face.heights[nodes.back()] > face.heights[nodes.front()])) refuse("elements must run upwards");
  }
  const double total = face.heights[face.elements.back().back()] - face.heights[face.elements.front().front()];
  for (std::size_t e = 1; e < face.elements.size(); ++e) {
    const double below = face.heights[face.elements[e - 1].back()], above = face.heights[face.elements[e].front()];
    if (!(std::abs(above - below) <= merged * total))
      refuse("a gap between the heights " + std::to_string(below) + " and " + std::to_string(above) +
             " m; each element must begin where the one below ends");
  }
}

/// Adds one wet element to mass, stiffness and load, all with the surface node still among the pressure's.
void add_element(const Face& face, const WetElement& wet, int first, Eigen::MatrixXd& mass, Eigen::MatrixXd& stiffness,
                 Eigen::MatrixXd& load) {
  const std::vector<int>& nodes = face.elements[static_cast<std::size_t>(wet.element)];
  const int order = static_cast<int>(nodes.size()) - 1;
  const numerics::LagrangeBasis basis = basis_of(order);
  const numerics::QuadratureRule rule = numerics::gauss_legendre(order + 1);  // exact for products
  const double half = 0.5 * (wet.surface - wet.lower), share = (wet.surface - wet.lower) / (wet.upper - wet.lower);
  for (Eigen::Index g = 0; g < rule.points.size(); ++g) {
    const double weight = rule.weights[g] * half, eta = rule.points[g];
    const Eigen::VectorXd N = numerics::values(basis, eta);
    const Eigen::VectorXd dN = numerics::derivatives(basis, eta) /
                               (numerics::planted_fault("reservoir/element-not-halved") ? 2.0 * half : half);
    // the same point in the whole element: from its lower end, so that a thin wet part keeps its digits
    const Eigen::VectorXd N_face = numerics::values(basis, (1.0 + eta) * share - 1.0);
    mass.block(first, first, order + 1, order + 1) += weight * N * N.transpose();
    stiffness.block(first, first, order + 1, order + 1) += weight * dN * dN.transpose();
    for (int i = 0; i <= order; ++i) load.col(nodes[i]).segment(first, order + 1) += weight * N_face[i] * N;
  }
}

}  // namespace

Face uniform_face(double height, int elements, int order) {
  if (!(height > 0.0) || !std::isfinite(height)) refuse("height = " + std::to_string(height) + " m must be > 0");
  if (elements < 1 || elements > 100'000) refuse("elements = " + std::to_string(elements) + " must be 1 … 100000");
  if (order < 1 || order > 32) refuse("order " + std::to_string(order) + " must be 1 … 32");
  const Eigen::VectorXd points = numerics::gauss_lobatto(order + 1).points;
  Face face{Eigen::VectorXd(elements * order + 1), {}};
  for (int e = 0; e < elements; ++e) {
    std::vector<int>& nodes = face.elements.emplace_back();
    for (int i = 0; i <= order; ++i) {
      nodes.push_back(e * order + i);
      face.heights[nodes.back()] = height * (e + 0.5 * (1.0 + points[i])) / elements;
    }
  }
  return face;
}

std::vector<WetElement> wet_elements(const Face& face, double level) {
  check_elements(face);
  const double bottom = face.heights[face.elements.front().front()], top = face.heights[face.elements.back().back()];
  bool on_face = level > bottom && level <= top + merged * (top - bottom);
  if (!on_face && numerics::planted_fault("reservoir/level-moved-onto-the-face")) {
    level = top;
    on_face = true;
  }
  if (!on_face)
    refuse("level = " + std::to_string(level) + " m must be above the bottom, " + std::to_string(bottom) +
           " m, and at most at the top of the face, " + std::to_string(top) + " m");
  const double near = merged * (level - bottom);
  std::vector<WetElement> wet;
  for (std::size_t e = 0; e < face.elements.size(); ++e) {
    const double lower = face.heights[face.elements[e].front()], upper = face.heights[face.elements[e].back()];
    if (level <= lower + near) break;
    wet.push_back({static_cast<int>(e), lower, upper, level >= upper - near ? upper : level});
  }
  return wet;
}

Eigen::VectorXd shape_functions(int order, double lower, double upper, double y) {
  return numerics::values(basis_of(order), 2.0 * (y - lower) / (upper - lower) - 1.0);
}

PressureMesh pressure_mesh(const Face& face, double level) {
  PressureMesh mesh;
  mesh.wet = wet_elements(face, level);
  mesh.bottom = mesh.wet.front().lower;
  mesh.level = level;
  for (const WetElement& wet : mesh.wet) {
    mesh.first.push_back(mesh.size);
    mesh.orders.push_back(static_cast<int>(face.elements[static_cast<std::size_t>(wet.element)].size()) - 1);
    mesh.size += mesh.orders.back();
  }
  const int all = mesh.size + 1;  // with the surface node
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(all, all), stiffness = mass;
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(all, face.size());
  for (std::size_t i = 0; i < mesh.wet.size(); ++i)
    add_element(face, mesh.wet[i], mesh.first[i], mass, stiffness, load);
  mesh.mass = mass.topLeftCorner(mesh.size, mesh.size);
  mesh.stiffness = stiffness.topLeftCorner(mesh.size, mesh.size);
  mesh.load = load.topRows(mesh.size);
  // the surface has no pressure, but its acceleration is felt below it
  if (numerics::planted_fault("reservoir/no-surface-column"))
    mesh.load.col(face.elements[static_cast<std::size_t>(mesh.wet.back().element)].back()).setZero();
  return mesh;
}

Eigen::VectorXd PressureMesh::values(double height) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size);
  if (height < bottom || height >= level) return result;
  for (std::size_t i = 0; i < wet.size(); ++i) {
    if (height > wet[i].surface && i + 1 < wet.size()) continue;
    const Eigen::VectorXd N = shape_functions(orders[i], wet[i].lower, wet[i].surface, height);
    const int count = std::min(orders[i] + 1, size - first[i]);  // without the surface node
    result.segment(first[i], count) = N.head(count);
    break;
  }
  return result;
}

Eigen::VectorXd pressure_functional(const PressureMesh& mesh, double height) {
  // loadᵀ p = R has more rows than unknowns and one solution; columns scaled, since elements may be thin
  const Eigen::VectorXd scale = mesh.load.rowwise().norm().cwiseInverse();
  const Eigen::MatrixXd scaled = mesh.load.transpose() * scale.asDiagonal();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd inverse =
      scale.asDiagonal() * qr.solve(Eigen::MatrixXd::Identity(scaled.rows(), scaled.rows()));
  return inverse.transpose() * mesh.values(height);
}

}  // namespace sunder::reservoir
