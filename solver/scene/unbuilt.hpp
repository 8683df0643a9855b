#pragma once
/// What the reader checks and the program cannot run yet. Whoever builds a part removes its line here, and nothing
/// else. Private to this module.

#include <array>
#include <string_view>

#include "solver/scene/scene.hpp"

namespace sunder::scene {

inline constexpr std::array unbuilt_tables = {
    std::string_view("reservoir"),    //
    std::string_view("propagation"),  //
};

inline constexpr std::array<Analysis, 0> unbuilt_analyses = {};

/// A table of the list above that is built in this one analysis.
constexpr bool built_in(std::string_view table, Analysis analysis) {
  return (table == "propagation" || table == "reservoir") &&
         (analysis == Analysis::static_ || analysis == Analysis::dynamic);
}

}  // namespace sunder::scene
