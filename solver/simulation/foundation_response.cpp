#include "solver/simulation/foundation_response.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <complex>
#include <numeric>
#include <span>

#include "solver/foundation/curved_line.hpp"
#include "solver/foundation/dynamic_stiffness.hpp"
#include "solver/foundation/impulse_response.hpp"
#include "solver/mesh/ground_block.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/foundation_line.hpp"

namespace sunder::simulation {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using results::Quantity;

/// Forces and moment on a rigid body for unit displacements in x and y and a unit rotation about the origin.
using Impedance = Eigen::Matrix3cd;

/// Rigid motions (2 n, 3) of the nodes.
MatrixXd rigid_motions(const Eigen::Matrix2Xd& nodes) {
  MatrixXd motions = MatrixXd::Zero(2 * nodes.cols(), 3);
  for (Index i = 0; i < nodes.cols(); ++i) {
    motions(2 * i, 0) = motions(2 * i + 1, 1) = 1.0;
    motions(2 * i, 2) = -nodes(1, i);
    motions(2 * i + 1, 2) = nodes(0, i);
  }
  return motions;
}

/// The near field of a strip, ready for any frequency.
struct StripBlock {
  Body body;
  FoundationLine line;
  Eigen::SparseMatrix<double> stiffness, mass;  // lower
  std::vector<int> strip_dofs;
  MatrixXd strip_motions;
};

StripBlock strip_block(const scene::Scene& scene, const material::Isotropic& rock, numerics::ThreadPool& pool) {
  const double b = *scene.foundation->half_width;
  const scene::NearField given = scene.foundation->near_field.value_or(scene::NearField{});
  const double size = b / scene.response->face_elements.value_or(10);
  StripBlock block;
  block.body.polygons = mesh::block_below_strip(
      b,
      {.width = given.width.value_or(0.5 * b), .depth = given.depth.value_or(b), .size = given.size.value_or(5 * size)},
      size, size / 16);
  block.body.nodes = mesh::place_nodes(block.body.polygons, [&](int, int) { return scene.response->face_order; });
  block.body.materials = {rock};
  block.body.rock = 0;
  block.line = foundation_line(block.body);
  const sbfem::Formation formation =
      sbfem::form(block.body.nodes, block.body.materials, {.with_mass = true, .pool = &pool});
  block.stiffness = sbfem::assemble_stiffness(block.body.nodes, formation, &pool);
  block.mass = sbfem::assemble_mass(block.body.nodes, formation, &pool);
  const std::vector<int> nodes = boundary_nodes(block.body, "strip");
  for (const int node : nodes) block.strip_dofs.insert(block.strip_dofs.end(), {2 * node, 2 * node + 1});
  block.strip_motions = rigid_motions(block.body.nodes.coordinates()(Eigen::all, nodes));
  return block;
}

/// K - ω² M + S with the strip moved as one: its reactions are the impedance.
Impedance strip_impedance(const StripBlock& block, double omega, const MatrixXcd& S) {
  const Index dofs = block.body.dofs();
  std::vector<Index> number(dofs, 0);  // of the free unknowns; -1 - i for number i on the strip
  for (std::size_t i = 0; i < block.strip_dofs.size(); ++i) number[block.strip_dofs[i]] = -1 - static_cast<Index>(i);
  Index unknowns = 0;
  for (Index& value : number) {
    if (value == 0) value = unknowns++;
  }
  const Index held = std::ssize(block.strip_dofs);
  std::vector<Eigen::Triplet<Complex>> entries;
  MatrixXcd strip = MatrixXcd::Zero(held, held), right = MatrixXcd::Zero(unknowns, held);
  const auto add = [&](Index row, Index column, Complex value) {
    const Index i = number[row], j = number[column];
    if (i >= 0 && j >= 0) entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
    if (i >= 0 && j < 0) right(i, -1 - j) += value;
    if (i < 0 && j < 0) strip(-1 - i, -1 - j) += value;
  };
  const auto add_lower = [&](const Eigen::SparseMatrix<double>& matrix, double factor) {
    for (Index column = 0; column < matrix.outerSize(); ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
        add(entry.row(), column, factor * entry.value());
        if (entry.row() != column) add(column, entry.row(), factor * entry.value());
      }
    }
  };
  add_lower(block.stiffness, 1.0);
  add_lower(block.mass, -omega * omega);
  for (Index j = 0; j < S.cols(); ++j) {
    for (Index i = 0; i < S.rows(); ++i) add(block.line.dofs[i], block.line.dofs[j], S(i, j));
  }
  Eigen::SparseMatrix<Complex> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<Complex>> factor(matrix);
  const MatrixXcd motion = block.strip_motions.cast<Complex>(), pull = right * motion;
  const MatrixXcd interior = factor.solve(pull);
  // Symmetric matrices: the strip's row of the eliminated unknowns is the transpose of its column.
  return motion.transpose() * strip * motion - pull.transpose() * interior;
}

Quantity complex_quantity(Complex value) {
  return Quantity::List{value.real(), value.imag()};
}

Quantity impedance_quantity(const Impedance& impedance, double G, double b) {
  return Quantity::Table{{"H", complex_quantity(impedance(0, 0) / G)},
                         {"V", complex_quantity(impedance(1, 1) / G)},
                         {"R", complex_quantity(impedance(2, 2) / (G * b * b))},
                         {"HR", complex_quantity(impedance(2, 0) / (G * b))}};
}

std::string words(foundation::StiffnessStatus status) {
  return status == foundation::StiffnessStatus::not_finite
             ? "stopped: the stiffness of the unbounded rock is not finite"
             : "stopped: the stiffness of the unbounded rock was not reached within the allowed steps; use larger or "
               "more even elements";
}

}  // namespace

void add_foundation_response(const scene::Scene& scene, numerics::ThreadPool& pool, Ledger& ledger,
                             results::RunSummary& summary) {
  const scene::Foundation& given = *scene.foundation;
  const material::Isotropic rock{
      .youngs_modulus = given.youngs_modulus, .poisson_ratio = given.poisson_ratio, .density = given.density};
  if (rock.density == 0.0) {
    throw scene::SceneError(scene::place_of(scene, "foundation") +
                            "density: is 0; analysis = \"response\" accepts a number > 0 [kg/m³]");
  }
  const std::vector<double>& frequencies = scene.response->frequencies;
  for (const double omega : frequencies) {
    if (omega > 0.0) continue;
    throw scene::SceneError(
        scene::place_of(scene, "response") +
        "frequencies: 0 with [foundation]; accepted: numbers > 0 [rad/s], for a plane has no static "
        "stiffness against translation");
  }
  const bool disc = given.shape == scene::FoundationShape::disc;
  const double b = *given.half_width, G = material::shear_modulus(rock);
  StripBlock block;
  sbfem::Boundary line;
  {
    Ledger::Visit visit(ledger, "sbfem", "near field");
    if (disc) {
      line = foundation::circle(b, scene.response->face_elements.value_or(8), scene.response->face_order, false);
    } else {
      block = strip_block(scene, rock, pool);
      line = block.line.boundary;
      visit.add_entries(block.stiffness.nonZeros() + block.mass.nonZeros());
    }
  }
  Ledger::Visit visit(ledger, "foundation", "response");
  visit.add_entries(4 * line.nodes.size() * line.nodes.size());
  const foundation::UnboundedDomain domain = foundation::unbounded_domain(
      disc ? foundation::curved_coefficients(line, rock) : sbfem::coefficients(line, rock));
  const MatrixXd motions = rigid_motions(line.nodes);

  std::vector<std::size_t> order(frequencies.size());  // from the highest to the lowest: the way of the integration
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return frequencies[i] > frequencies[j]; });
  std::vector<Complex> s;
  for (const std::size_t i : order) s.emplace_back(0.0, frequencies[i]);
  std::vector<Quantity> impedance(frequencies.size());
  const foundation::StiffnessPath path =
      foundation::dynamic_stiffness(domain, s,
                                    [&](std::size_t i, const MatrixXcd& S) {
                                      const Impedance value = disc ? Impedance(motions.transpose() * S * motions)
                                                                   : strip_impedance(block, frequencies[order[i]], S);
                                      impedance[order[i]] = impedance_quantity(value, G, b);
                                    },
                                    {.tolerance = 1e-8});
  ledger.count("stiffness_steps", path.steps + path.rejected);
  if (path.status != foundation::StiffnessStatus::converged) {
    summary.status = words(path.status);
    return;
  }
  if (!frequencies.empty()) summary.quantities["impedance"] = Quantity::List(impedance.begin(), impedance.end());
  if (scene.response->times.empty()) return;
  const foundation::ImpulseSamples samples = foundation::impulse_response(domain, scene.response->times);
  if (samples.status != foundation::StiffnessStatus::converged) {
    summary.status = words(samples.status);
    return;
  }
  std::vector<double> impulse;
  for (const MatrixXd& M : samples.M) {
    impulse.push_back(motions.col(0).dot(M * motions.col(0)) / (rock.density * material::shear_wave_speed(rock) * b));
  }
  summary.quantities["impulse"] = Quantity(impulse);
}

}  // namespace sunder::simulation
