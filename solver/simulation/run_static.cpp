#include "solver/sbfem/formation.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/field_snapshot.hpp"
#include "solver/simulation/static_state.hpp"

namespace sunder::simulation {
namespace {

void write_fields(const scene::Scene& scene, const Body& body, const RunOptions& options,
                  const Eigen::VectorXd& displacement, Ledger& ledger) {
  Ledger::Visit visit(ledger, "results", "fields");
  const FieldGeometry geometry = field_geometry(body, [&](int polygon, const sbfem::Boundary& boundary) {
    return polygon_loads(scene, body, polygon, boundary);
  });
  results::FieldFile file(options.output / field_file_name);
  file.begin_mesh(geometry.mesh);
  file.append(0.0, {.point_data = {vector_field(geometry, "displacement", displacement)},
                    .cell_data = {stress_field(geometry, displacement)}});
  file.commit();
  visit.add_entries(3 * geometry.mesh.point_count() + 6 * geometry.mesh.polygon_count());
}

}  // namespace

void run_static(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                Ledger& ledger, results::RunSummary& summary) {
  const auto report = [&](std::string_view phase, double fraction) {
    if (options.progress) options.progress(phase, fraction);
  };
  const Supports supports = supports_of(scene, body, false);

  report("polygons", 0.2);
  sbfem::Formation formation;
  {
    const Ledger::Visit visit(ledger, "sbfem", "polygons");
    formation = sbfem::form(body.nodes, body.materials, {.pool = &pool});
  }
  report("solution", 0.5);
  const StaticState state = static_state(scene, body, formation, supports, pool, ledger);
  if (state.solution.status != numerics::FactorStatus::factorised) {
    summary.status = stopping_reason(body, state.solution);
    return;
  }
  report("quantities", 0.9);
  add_static_quantities(scene, body, formation, supports, state, ledger, summary);
  if (wants_fields(scene)) {
    report("fields", 0.95);
    write_fields(scene, body, options, state.solution.displacement, ledger);
  }
}

}  // namespace sunder::simulation
