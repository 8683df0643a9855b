// Steps and growth of Koyna dam with all its parts.

#include <cmath>
#include <memory>

#include "benchmarks/counts/region.hpp"
#include "solver/scene/reader.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/run.hpp"
#include "solver/simulation/state_transfer.hpp"

namespace sunder::counts {
namespace {

scene::Scene koyna(const std::vector<scene::Override>& overrides) {
  return scene::read_scene(std::string(SUNDER_CASES) + "/koyna/model-3.scene.toml", overrides);
}

/// Sixteen coupled steps: the run tells its progress every sixteenth step, and the count goes from one call to the
/// next. 0.4 s into the record the ground moves and the faces meet.
Work koyna_steps(long steps) {
  const double duration = 0.02 * static_cast<double>(steps);
  auto scene = std::make_shared<scene::Scene>(koyna(
      {scene::parse_override("mesh.size=8"), scene::parse_override("dynamics.duration=" + std::to_string(duration)),
       scene::parse_override("propagation.fracture_toughness=1e9")}));
  auto summary = std::make_shared<results::RunSummary>();
  const long first = steps - steps % 16 - 16;
  const auto run = [=](const auto& start, const auto& stop) {
    long told = 0;
    const simulation::RunOptions options{.progress = [&](std::string_view phase, double) {
      if (phase != "steps") return;
      told += 16;
      if (told == first) start();
      if (told == first + 16) stop();
    }};
    *summary = simulation::run(*scene, options);
  };
  const auto is_right = [=] {
    const results::Quantity* overlap = summary->quantities.find("max_penetration");
    return summary->completed() && overlap != nullptr && *overlap->number() <= 1e-4;  // the seed paper's gate
  };
  return {run, is_right};
}

/// One growth event: the tip moves on, what changed is formed again, displacement, velocity and acceleration come over.
Work growth_event(long earlier) {
  struct Dam {
    simulation::Body body;
    sbfem::Formation formation;
    mesh::Point next;
    Eigen::MatrixXd fields;
    double carried = 0.0;
  };
  auto dam = std::make_shared<Dam>();
  simulation::Ledger ledger;
  dam->body = simulation::build_body(koyna({scene::parse_override("mesh.size=4")}), ledger);
  dam->formation = sbfem::form(dam->body.nodes, dam->body.materials, {.with_mass = true});
  const auto tip_after = [](long i) {
    return mesh::Point(1.0 + 0.5 * static_cast<double>(i), 60.0 - 0.01 * static_cast<double>(i * i));
  };
  for (long i = 1; i <= earlier; ++i) {
    simulation::Growth growth = simulation::grow(dam->body, dam->formation, 0, tip_after(i));
    dam->body = std::move(growth.body);
    dam->formation = std::move(growth.formation);
  }
  dam->next = tip_after(earlier + 1);
  dam->fields = Eigen::MatrixXd::Zero(dam->body.dofs(), 3);
  for (Eigen::Index i = 0; i < dam->fields.rows(); i += 2) dam->fields(i, 0) = 1.0;  // a translation
  return whole(
      [=] {
        const simulation::Growth growth = simulation::grow(dam->body, dam->formation, 0, dam->next);
        const Eigen::MatrixXd moved = simulation::transfer_fields(dam->body, dam->formation, growth.body,
                                                                  growth.formation, growth.report, dam->fields)
                                          .values;
        dam->carried = moved.col(0).sum() / (0.5 * static_cast<double>(growth.body.dofs()));
      },
      [=] { return std::abs(dam->carried - 1.0) < 1e-10; });
}

}  // namespace

std::vector<Region> dam_regions() {
  return {
      {"koyna-steps", "16 steps of Koyna with contact, moving water and compressible reservoir; size: steps of the run",
       47, koyna_steps},
      {"growth-event", "cutting, forming again and carrying the fields over; size: growth events before it", 3,
       growth_event},
  };
}

}  // namespace sunder::counts
