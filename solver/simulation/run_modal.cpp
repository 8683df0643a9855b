#include <numbers>
#include <vector>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/sbfem/radial_bubbles.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/attached_medium.hpp"
#include "solver/simulation/field_snapshot.hpp"
#include "solver/simulation/free_vibration.hpp"
#include "solver/simulation/static_loads.hpp"

namespace sunder::simulation {
namespace {

/// Bubbles of all polygons, numbered polygon by polygon.
void add_bubbles(const Body& body, const sbfem::Formation& formation, int interior_order, numerics::ThreadPool& pool,
                 VibratingBody& vibrating) {
  std::vector<sbfem::RadialBubbles> bubbles(body.nodes.polygon_count());
  pool.parallel_for(body.nodes.polygon_count(), [&](int index) {
    if (body.materials[body.nodes.polygon(index).material].density == 0.0) return;  // massless rock
    const sbfem::Coefficients coefficients =
        sbfem::coefficients(sbfem::boundary_of(body.nodes, index), body.materials[body.nodes.polygon(index).material]);
    const sbfem::PolygonSolution solution = sbfem::solution_of_stiffness(coefficients, formation.stiffness(index));
    bubbles[index] = sbfem::radial_bubbles(coefficients, solution, formation.mass(index), interior_order);
  });
  std::vector<Eigen::Triplet<double>> coupling;
  std::vector<double> omega_squared;
  for (int i = 0; i < body.nodes.polygon_count(); ++i) {
    const mesh::NodalPolygon polygon = body.nodes.polygon(i);
    for (Eigen::Index b = 0; b < bubbles[i].omega_squared.size(); ++b) {
      const int column = static_cast<int>(omega_squared.size());
      for (Eigen::Index row = 0; row < bubbles[i].coupling.rows(); ++row) {
        coupling.emplace_back(2 * polygon.nodes[row / 2] + row % 2, column, bubbles[i].coupling(row, b));
      }
      omega_squared.push_back(bubbles[i].omega_squared[b]);
    }
  }
  vibrating.bubble_omega_squared = Eigen::Map<const Eigen::VectorXd>(omega_squared.data(), std::ssize(omega_squared));
  vibrating.bubble_coupling.resize(body.dofs(), vibrating.bubble_omega_squared.size());
  vibrating.bubble_coupling.setFromTriplets(coupling.begin(), coupling.end());
}

std::string status_of(const FreeVibration& vibration) {
  switch (vibration.status) {
    case VibrationStatus::converged:
      return "completed";
    case VibrationStatus::not_converged:
      return "stopped: the Lanczos iteration did not converge for every mode; those found are listed";
    case VibrationStatus::not_positive_definite:
      return "stopped: the stiffness matrix is not positive definite; a part of the body hangs by round-off only";
    case VibrationStatus::mode_missed:
      return "stopped: a mode below the last one listed was missed; ask for more modes (modal.count)";
  }
  return "stopped";
}

/// One snapshot a mode, at its number from 1: frequencies may coincide, and an instant must not.
void write_fields(const Body& body, const RunOptions& options, const Eigen::MatrixXd& shapes, Ledger& ledger) {
  Ledger::Visit visit(ledger, "results", "fields");
  const FieldGeometry geometry = field_geometry(body);
  results::FieldFile file(options.output / field_file_name);
  file.begin_mesh(geometry.mesh);
  for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
    file.append(static_cast<double>(mode + 1),
                {.point_data = {vector_field(geometry, "mode_shape", shapes.col(mode))}, .cell_data = {}});
  }
  file.commit();
  visit.add_entries(3 * geometry.mesh.point_count() * shapes.cols());
}

/// Adds the mass of water that moves with the body.
void add_reservoir(const scene::Scene& scene, const Body& body, numerics::ThreadPool& pool, Ledger& ledger,
                   VibratingBody& vibrating, results::RunSummary& summary) {
  if (scene.reservoir->model == scene::ReservoirModel::compressible &&
      !numerics::planted_fault("simulation/modes-of-compressible-water"))
    throw scene::SceneError(scene::place_of(scene, "reservoir") +
                            "model: the mass of \"compressible\" water depends on the frequency, so there are no "
                            "natural frequencies of this kind; accepted: westergaard, incompressible, hydrostatic");
  const std::unique_ptr<AttachedMedium> medium = attach_reservoir(scene, body, {}, pool, ledger);
  if (medium == nullptr) {
    summary.warnings.push_back(
        "[reservoir] model = \"hydrostatic\" has no mass: the frequencies are those of the "
        "empty body");
    return;
  }
  const Eigen::MatrixXd& added = medium->convolution->instantaneous_mass();
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index j = 0; j < added.cols(); ++j)  // ascending dofs: the lower triangle stays the lower triangle
    for (Eigen::Index i = j; i < added.rows(); ++i)
      entries.emplace_back(medium->dofs[static_cast<std::size_t>(i)], medium->dofs[static_cast<std::size_t>(j)],
                           added(i, j));
  Eigen::SparseMatrix<double> water(body.dofs(), body.dofs());
  water.setFromTriplets(entries.begin(), entries.end());
  vibrating.mass += water;
}

}  // namespace

void run_modal(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
               Ledger& ledger, results::RunSummary& summary) {
  const auto report = [&](std::string_view phase, double fraction) {
    if (options.progress) options.progress(phase, fraction);
  };
  const Supports supports = supports_of(scene, body, true);
  const bool floating = !free_motions(body.nodes, supports.constraints).empty();
  const scene::Modal modal = scene.modal.value_or(scene::Modal{});

  report("polygons", 0.2);
  VibratingBody vibrating;
  {
    Ledger::Visit visit(ledger, "sbfem", "polygons");
    const sbfem::Formation formation = sbfem::form(body.nodes, body.materials, {.with_mass = true, .pool = &pool});
    vibrating.stiffness = sbfem::assemble_stiffness(body.nodes, formation, &pool);
    vibrating.mass = sbfem::assemble_mass(body.nodes, formation, &pool);
    if (modal.interior_order > 0) add_bubbles(body, formation, modal.interior_order, pool, vibrating);
    visit.add_entries(vibrating.stiffness.nonZeros() + vibrating.mass.nonZeros() +
                      vibrating.bubble_coupling.nonZeros());
  }

  if (scene.reservoir) add_reservoir(scene, body, pool, ledger, vibrating, summary);

  report("modes", 0.5);
  const FreeVibration vibration = [&] {
    Ledger::Visit visit(ledger, "numerics", "modes");
    FreeVibration result = free_vibration(vibrating, supports.constraints, modal.count, floating);
    visit.add_entries(result.factor_entries);
    return result;
  }();
  ledger.count("factorisations");
  ledger.count("back_substitutions", vibration.solves);
  summary.status = status_of(vibration);
  if (vibration.omega.size() == 0) return;
  if (!vibration.counted) {
    summary.warnings.push_back("whether a mode was missed was not counted: the body has too many degrees of freedom");
  }

  const Eigen::VectorXd hertz = vibration.omega / (2.0 * std::numbers::pi);
  summary.quantities["frequencies"] = results::Quantity(std::vector<double>(hertz.begin(), hertz.end()));
  results::Quantity::List participation;
  for (Eigen::Index i = 0; i < vibration.participation.cols(); ++i) {
    participation.emplace_back(results::Quantity::List{vibration.participation(0, i), vibration.participation(1, i)});
  }
  summary.quantities["participation"] = std::move(participation);
  if (wants_fields(scene)) {
    report("fields", 0.95);
    write_fields(body, options, vibration.shapes, ledger);
  }
}

}  // namespace sunder::simulation
