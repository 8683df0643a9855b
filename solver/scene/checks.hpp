#pragma once
/// What a scene's tables must satisfy together. Private to this module.

#include "solver/scene/findings.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::scene {

/// "static", "crack-water", …: the word that a scene writes.
[[nodiscard]] std::string_view word_of(Analysis analysis);

/// Contradictions between tables: parts that the analysis needs or cannot use, names of boundaries, supports that leave
/// a rigid motion, weight without density, files that are missing. `document` gives the places.
void check_together(const Node& document, const Scene& scene, Findings& findings);

}  // namespace sunder::scene
