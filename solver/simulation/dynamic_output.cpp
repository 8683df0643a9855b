// What a dynamic run shows besides its history: pressure along the cracks at chosen times, and fields for pictures.

#include <cmath>

#include "solver/simulation/dynamic_run.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;
using results::Quantity;

std::vector<double> list_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

/// Along crack `crack` from its mouth: the water's own nodes where it flows, else the pairs of faces and the tip.
Quantity DynamicRun::profile_of(std::size_t crack, Index first_pair) const {
  const CrackFaceLoads& faces = body_.cracks[crack];
  const auto opening = step_->memory().opening.segment(first_pair, faces.pairs.count());
  Quantity::Table profile{{"time", state_.time}, {"crack", static_cast<int>(crack)}};
  const bool moving = waters_[crack] != nullptr && scene_.crack_water->model == scene::CrackWaterModel::moving;
  if (moving) {
    const auto& water = static_cast<const MovingWater&>(*waters_[crack]);
    profile.emplace_back("position", Quantity(water.nodes().position));
    profile.emplace_back("pressure", Quantity(water.profile().pressure));
    profile.emplace_back("aperture", Quantity(water.apertures()));
  } else {
    const double pressure = waters_[crack] == nullptr ? 0.0 : now_.cracks[crack].peak_pressure;
    profile.emplace_back("position", Quantity(std::vector<double>{0.0, faces.pairs.tip_position}));
    profile.emplace_back("pressure", Quantity(std::vector<double>{pressure, pressure}));
  }
  profile.emplace_back("pair_position", Quantity(list_of(faces.pairs.position)));
  profile.emplace_back("opening", Quantity(list_of(opening)));
  return profile;
}

void DynamicRun::note_profiles() {
  if (!scene_.output) return;
  for (const double time : scene_.output->profile_times) {
    if (std::abs(state_.time - time) > 0.5 * step_options_.time_step * (1.0 - 1e-9)) continue;
    Index pair = 0;
    for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
      profiles_.push_back(profile_of(c, pair));
      pair += body_.cracks[c].pairs.count();
    }
  }
}

void DynamicRun::write_fields() {
  if (!wants_fields(scene_) || number_ % scene_.output->fields_every != 0) return;
  Ledger::Visit visit(ledger_, "results", "fields");
  if (fields_ == nullptr) fields_ = std::make_unique<results::FieldFile>(options_.output / field_file_name);
  if (!drawn_) {
    drawn_ = field_geometry(body_.body);
    fields_->begin_mesh(drawn_->mesh);
  }
  fields_->append(state_.time, {.point_data = {vector_field(*drawn_, "displacement", state_.displacement),
                                               vector_field(*drawn_, "velocity", state_.velocity)},
                                .cell_data = {stress_field(*drawn_, state_.displacement)}});
  visit.add_entries(6 * drawn_->mesh.point_count() + 6 * drawn_->mesh.polygon_count());
}

}  // namespace sunder::simulation
