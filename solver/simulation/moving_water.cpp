#include "solver/simulation/moving_water.hpp"

#include <cmath>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::simulation {
namespace {

mesh::Point middle_of(const crack::CrackPairs& pairs, const mesh::NodalMesh& nodes, int pair) {
  return 0.5 * (nodes.coordinates().col(pairs.lower[static_cast<std::size_t>(pair)]) +
                nodes.coordinates().col(pairs.upper[static_cast<std::size_t>(pair)]));
}

/// The march begins with the apertures at the start; they are needed before it is made.
std::vector<double> first_apertures(const WaterNodes& nodes, const MovingWaterOptions& options,
                                    std::span<const double> openings) {
  std::vector<double> apertures(nodes.position.size());
  for (std::size_t j = 0; j < apertures.size(); ++j) {
    const double opening = nodes.before[j] < 0
                               ? 0.0
                               : (1.0 - nodes.share[j]) * openings[static_cast<std::size_t>(nodes.before[j])] +
                                     nodes.share[j] * openings[static_cast<std::size_t>(nodes.after[j])];
    apertures[j] = crackwater::aperture(opening, 0.0, options.minimum_aperture, options.rule).value;
  }
  return apertures;
}

}  // namespace

WaterNodes water_nodes(const crack::CrackPairs& pairs, const mesh::NodalMesh& nodes, const mesh::Point* tip,
                       double longest_segment) {
  WaterNodes result;
  result.has_tip = tip != nullptr;
  const auto add = [&](double position, int before, int after, double share) {
    result.position.push_back(position);
    result.before.push_back(before);
    result.after.push_back(after);
    result.share.push_back(share);
  };
  add(0.0, 0, 0, 0.0);
  int from = 0;
  for (int pair = 1; pair < pairs.count(); ++pair) {
    const double length = pairs.position[pair] - pairs.position[from];
    if (length <= 0.0) continue;  // where another crack ends two pairs stand at one place; the first one counts
    const double rise = middle_of(pairs, nodes, pair).y() - middle_of(pairs, nodes, from).y();
    const int parts = static_cast<int>(std::ceil(length / longest_segment));
    for (int part = 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      add(pairs.position[from] + share * length, from, pair, share);
      result.line.lengths.push_back(length / parts);
      result.line.rises.push_back(rise / parts);
    }
    from = pair;
  }
  if (tip != nullptr) {
    result.line.lengths.push_back(pairs.tip_position - pairs.position[from]);
    result.line.rises.push_back(tip->y() - middle_of(pairs, nodes, from).y());
    add(pairs.tip_position, -1, -1, 0.0);
  }
  for (std::size_t i = 0; i < result.line.lengths.size(); ++i) {  // a rise may exceed its segment by round-off
    result.line.rises[i] = std::fmin(std::fmax(result.line.rises[i], -result.line.lengths[i]), result.line.lengths[i]);
  }
  return result;
}

MovingWater::MovingWater(WaterNodes nodes, Eigen::Index pairs, const MovingWaterOptions& options,
                         std::span<const double> openings)
    : nodes_(std::move(nodes)),
      pairs_(pairs),
      options_(options),
      march_(nodes_.line, options.water, first_apertures(nodes_, options, openings),
             {.initially_full = options.initially_full}),
      tangent_(static_cast<int>(nodes_.line.lengths.size())) {
  allocate();
  place(openings);
}

void MovingWater::allocate() {
  const std::size_t count = nodes_.position.size();
  for (std::vector<double>* values : {&openings_, &rates_, &apertures_, &aperture_rates_, &factors_})
    values->assign(count, 0.0);
  by_opening_.setZero(static_cast<Eigen::Index>(count), pairs_);
}

void MovingWater::grow(WaterNodes nodes, Eigen::Index pairs, std::span<const double> openings) {
  nodes_ = std::move(nodes);
  pairs_ = pairs;
  allocate();
  place(openings);
  march_.grow(nodes_.line, apertures_);
  tangent_ = crackwater::PressureTangent(static_cast<int>(nodes_.line.lengths.size()));
}

/// What the water finds between these faces.
void MovingWater::place(std::span<const double> openings) {
  for (std::size_t j = 0; j < openings_.size(); ++j) {
    if (nodes_.before[j] < 0) continue;  // the tip does not open
    const double share = nodes_.share[j];
    openings_[j] = (1.0 - share) * openings[static_cast<std::size_t>(nodes_.before[j])] +
                   share * openings[static_cast<std::size_t>(nodes_.after[j])];
  }
  crackwater::apertures(openings_, rates_, options_.minimum_aperture, options_.rule, apertures_, aperture_rates_,
                        factors_);
}

bool MovingWater::trial(std::span<const double> openings, double mouth_pressure, double time_step,
                        faces::WaterForces& result) {
  const numerics::Meter::Lap lap(work_);
  place(openings);
  crackwater::MouthPressures mouths{.upstream = mouth_pressure, .downstream = {}};
  if (!nodes_.has_tip) mouths.downstream = 0.0;  // the crack has come out at a dry face
  const crackwater::PressureProfile& profile = march_.trial(apertures_, mouths, time_step);
  result.force.setZero();
  result.by_opening.setZero();
  result.by_mouth.setZero();
  if (profile.status == crackwater::ProfileStatus::unusable_input) return false;
  crackwater::differentiate(march_, tangent_);

  const std::size_t count = nodes_.position.size();
  const Eigen::Index mouth_column = 2 * static_cast<Eigen::Index>(count);
  // pressures by the openings of the pairs: two pairs a node
  by_opening_.setZero();
  for (std::size_t j = 0; j < count; ++j) {
    if (nodes_.before[j] < 0 || factors_[j] == 0.0) continue;
    const auto column = factors_[j] * tangent_.pressure.col(static_cast<Eigen::Index>(j));
    by_opening_.col(nodes_.before[j]) += (1.0 - nodes_.share[j]) * column;
    by_opening_.col(nodes_.after[j]) += nodes_.share[j] * column;
  }
  const auto give = [&](Eigen::Index force, double weight, std::size_t node) {
    const auto row = static_cast<Eigen::Index>(node);
    result.force[force] += weight * profile.pressure[node];
    result.by_opening.row(force) += weight * by_opening_.row(row);
    result.by_mouth[force] += weight * tangent_.pressure(row, mouth_column);
  };
  const std::size_t on_edges = count - (nodes_.has_tip ? 1 : 0);
  for (std::size_t j = 0; j + 1 < on_edges; ++j) {
    // N of both pairs is linear along the segment from node j to j + 1, and so is p: ∫ N p ds
    const double sixth = nodes_.line.lengths[j] / 6.0;
    const int before = nodes_.before[j + 1], after = nodes_.after[j + 1];
    const double last = nodes_.share[j + 1],
                 first = nodes_.share[j] < 1.0 && nodes_.after[j] == after ? nodes_.share[j] : 0.0;
    give(before, sixth * (2.0 * (1.0 - first) + (1.0 - last)), j);
    give(before, sixth * ((1.0 - first) + 2.0 * (1.0 - last)), j + 1);
    give(after, sixth * (2.0 * first + last), j);
    give(after, sixth * (first + 2.0 * last), j + 1);
  }
  if (nodes_.has_tip && !numerics::planted_fault("simulation/moving-water-stops-at-last-pair")) {
    give(pairs_, 1.0, count - 1);
    give(pairs_ + 1, 1.0, count - 2);
    give(pairs_ + 1, -1.0, count - 1);
  }
  return profile.status == crackwater::ProfileStatus::converged;
}

}  // namespace sunder::simulation
