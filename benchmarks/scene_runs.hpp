#pragma once
/// What benchmarks that run whole scenes share.

#include <cmath>

#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::benchmarks {

/// NaN, which no comparison passes, where there is no such number.
inline double number(const results::RunSummary& summary, const char* path) {
  const results::Quantity* quantity = summary.quantities.find(path);
  return quantity != nullptr && quantity->number() != nullptr ? *quantity->number() : NAN;
}

/// The scene on rock as stiff and heavy as Koyna's concrete in place of its supports.
inline void put_on_rock(scene::Scene& scene) {
  scene.supports.clear();
  scene.foundation = scene::Foundation{.boundary = "base",
                                       .youngs_modulus = 25e9,
                                       .poisson_ratio = 0.2,
                                       .density = 2450.0,
                                       .half_width = {},
                                       .near_field = {}};
}

}  // namespace sunder::benchmarks
