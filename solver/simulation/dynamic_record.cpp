#include "solver/simulation/dynamic_record.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::simulation {
namespace {

using results::Column;
using results::Quantity;

std::vector<Column> columns_of(const RecordedParts& parts) {
  std::vector<Column> columns{{"time", "s"}, {"crest_displacement_x", "m"}, {"crest_displacement_y", "m"}};
  if (parts.media) columns.push_back({"hydrodynamic_force", "N/m"});
  for (std::size_t i = 0; i < parts.cracks; ++i) {
    const std::string number = parts.cracks > 1 ? "_" + std::to_string(i) : "";
    const auto add = [&](const char* name, const char* unit) { columns.push_back({name + number, unit}); };
    add("crack_mouth_opening", "m");
    add("K_I", "Pa sqrt(m)");
    add("K_II", "Pa sqrt(m)");
    if (parts.propagation) add("crack_length", "m");
    if (parts.water) {
      add("mouth_pressure", "Pa");
      add("uplift_force", "N/m");
      add("peak_pressure", "Pa");
      add("wet_length", "m");
      add("water_content", "m2");
    }
    if (parts.contact) add("contact_force", "N/m");
    add("penetration", "m");
  }
  for (const char* energy : {"kinetic_energy", "strain_energy", "damped_energy", "input_energy", "load_energy"}) {
    columns.push_back({energy, "J/m"});
  }
  if (parts.media) columns.push_back({"radiated_energy", "J/m"});
  if (parts.contact) columns.push_back({"contact_energy", "J/m"});
  if (parts.water) columns.push_back({"water_energy", "J/m"});
  if (parts.propagation) columns.push_back({"growth_energy", "J/m"});
  if (parts.contact || parts.water) columns.push_back({"face_iterations", "-"});
  return columns;
}

Quantity one_or_list(const std::vector<double>& values) {
  return values.size() == 1 ? Quantity(values.front()) : Quantity(values);
}

}  // namespace

DynamicRecord::DynamicRecord(const RecordedParts& parts, std::size_t steps)
    : parts_(parts),
      history_(columns_of(parts)),
      widest_mouth_(parts.cracks, -INFINITY),
      highest_K_I_(parts.cracks, -INFINITY),
      highest_K_I_time_(parts.cracks, 0.0) {
  row_.reserve(history_.columns().size());
  history_.reserve(steps + 1);
}

void DynamicRecord::add(const StepRecord& step, const Energies& energies) {
  row_.clear();
  const auto put = [this](double value) { row_.push_back(value); };
  put(step.time);
  put(step.crest.x());
  put(step.crest.y());
  if (parts_.media) put(step.hydrodynamic_force);
  for (const CrackRecord& crack : step.cracks) {
    put(crack.mouth_opening);
    put(crack.K_I);
    put(crack.K_II);
    if (parts_.propagation) put(crack.length);
    if (parts_.water) {
      put(crack.mouth_pressure);
      put(crack.uplift_force);
      put(crack.peak_pressure);
      put(crack.wet_length);
      put(crack.water_content);
    }
    if (parts_.contact) put(crack.contact_force);
    put(crack.penetration);
  }
  put(energies.kinetic);
  put(energies.strain);
  put(energies.damped);
  put(energies.input);
  put(energies.load);
  if (parts_.media) put(energies.radiated);
  if (parts_.contact) put(energies.contact);
  if (parts_.water) put(energies.water);
  if (parts_.propagation) put(energies.growth);
  if (parts_.contact || parts_.water) put(step.face_iterations);
  history_.add_row(row_);

  if (!begun_) rest_crest_ = step.crest.x();
  const double moved = step.crest.x() - rest_crest_;
  if (std::abs(moved) > std::abs(peak_crest_)) {
    peak_crest_ = moved;
    peak_crest_time_ = step.time;
  }
  crest_low_ = std::fmin(crest_low_, moved);
  crest_high_ = std::fmax(crest_high_, moved);
  begun_ = true;
  peak_force_ = std::fmax(peak_force_, std::abs(step.hydrodynamic_force));
  face_residual_ = std::fmax(face_residual_, step.face_residual);
  for (std::size_t i = 0; i < step.cracks.size(); ++i) {
    widest_mouth_[i] = std::fmax(widest_mouth_[i], step.cracks[i].mouth_opening);
    penetration_ = std::fmax(penetration_, step.cracks[i].penetration);
    if (step.cracks[i].K_I > highest_K_I_[i]) {
      highest_K_I_[i] = step.cracks[i].K_I;
      highest_K_I_time_[i] = step.time;
    }
  }
}

void DynamicRecord::read_rows(std::span<const double> rows, double largest_face_residual) {
  face_residual_ = largest_face_residual;
  const std::size_t width = history_.columns().size();
  for (; rows.size() >= width; rows = rows.subspan(width)) {
    std::size_t next = 0;
    StepRecord step;
    Energies energies;
    for (double* value : {&step.time, &step.crest.x(), &step.crest.y()}) *value = rows[next++];
    if (parts_.media) step.hydrodynamic_force = rows[next++];
    step.cracks.resize(parts_.cracks);
    for (CrackRecord& crack : step.cracks) {
      for (double* value : {&crack.mouth_opening, &crack.K_I, &crack.K_II}) *value = rows[next++];
      if (parts_.propagation) crack.length = rows[next++];
      if (parts_.water) {
        for (double* value : {&crack.mouth_pressure, &crack.uplift_force, &crack.peak_pressure, &crack.wet_length,
                              &crack.water_content})
          *value = rows[next++];
      }
      if (parts_.contact) crack.contact_force = rows[next++];
      crack.penetration = rows[next++];
    }
    for (double* value : {&energies.kinetic, &energies.strain, &energies.damped, &energies.input, &energies.load})
      *value = rows[next++];
    if (parts_.media) energies.radiated = rows[next++];
    if (parts_.contact) energies.contact = rows[next++];
    if (parts_.water) energies.water = rows[next++];
    if (parts_.propagation) energies.growth = rows[next++];
    if (parts_.contact || parts_.water) step.face_iterations = static_cast<int>(rows[next++]);
    add(step, energies);
  }
}

void DynamicRecord::write(Quantity& quantities) const {
  if (!begun_) return;
  quantities["peak_crest_displacement"] = std::abs(peak_crest_);
  quantities["peak_crest_displacement_time"] = peak_crest_time_;
  quantities["crest_displacement_range"] = Quantity::List{crest_low_, crest_high_};
  quantities["static_crest_displacement"] = rest_crest_;
  if (parts_.media) quantities["peak_hydrodynamic_force"] = peak_force_;
  if (parts_.cracks == 0) return;
  quantities["max_crack_mouth_opening"] = one_or_list(widest_mouth_);
  quantities["max_penetration"] = penetration_;
  quantities["max_face_residual"] = face_residual_;
  quantities["max_K_I"] = one_or_list(highest_K_I_);
  quantities["max_K_I_time"] = one_or_list(highest_K_I_time_);
}

}  // namespace sunder::simulation
