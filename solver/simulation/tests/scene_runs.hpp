#pragma once
/// Scenes written in the test itself: read, run, and asked for their numbers.

#include <cmath>
#include <string>
#include <vector>

#include "solver/scene/reader.hpp"
#include "solver/simulation/run.hpp"

namespace sunder::simulation::tests {

using Overrides = std::vector<scene::Override>;

inline scene::Scene scene_of(const std::string& text, const Overrides& overrides = {}) {
  return scene::read_scene_text(text, "test.scene.toml", overrides);
}

inline results::RunSummary run_text(const std::string& text, const Overrides& overrides = {}, int threads = 1) {
  return run(scene_of(text, overrides), {.threads = threads});
}

/// NaN, which no comparison passes, where there is no such number.
inline double number(const results::RunSummary& summary, const std::string& path) {
  const results::Quantity* quantity = summary.quantities.find(path);
  return quantity != nullptr && quantity->number() != nullptr ? *quantity->number() : NAN;
}

/// Empty where there is no such list.
inline std::vector<double> numbers(const results::RunSummary& summary, const std::string& path) {
  std::vector<double> values;
  const results::Quantity* quantity = summary.quantities.find(path);
  if (quantity == nullptr || quantity->list() == nullptr) return values;
  for (const results::Quantity& value : *quantity->list()) values.push_back(*value.number());
  return values;
}

}  // namespace sunder::simulation::tests
