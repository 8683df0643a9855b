#pragma once
/// One growth event of one crack tip: from a body and what was formed of it to the grown body and what is formed of
/// that.
///
/// Polygons away from the new piece of crack keep their matrices, bit for bit; the nodes are placed anew. Fields go
/// over by state_transfer.hpp. What depends on nodes (supports, loads, pairs of faces) is asked for again from the
/// grown body.

#include <string>
#include <vector>

#include "solver/crack/advance_tip.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

struct Growth {
  crack::TipEvent event = crack::TipEvent::refused;
  std::string reason;                     ///< empty unless refused
  mesh::Point tip = mesh::Point::Zero();  ///< where the crack ends now [m]
  Body body;                              ///< empty where refused
  sbfem::Formation formation;             ///< likewise
  crack::CutReport report;                ///< likewise
  std::vector<int> same;  ///< for each polygon the old one that it is, -1 where it was formed (sbfem::same_polygons)
};

/// Lengthens tip `tip` (index into body.polygons.cracks) straight to `to` [m]. `formation` is of the body. Never throws
/// for geometry: what cannot be cut is refused with a reason.
[[nodiscard]] Growth grow(const Body& body, const sbfem::Formation& formation, int tip, const mesh::Point& to,
                          numerics::ThreadPool* pool = nullptr);

/// Parts of the body that hang together: 1, and one more for each time that a crack has cut it through.
[[nodiscard]] int part_count(const mesh::NodalMesh& mesh);

/// The named boundary on which a place lies that is a vertex of it; empty where there is none.
[[nodiscard]] std::string boundary_at(const mesh::PolygonMesh& mesh, const mesh::Point& place);

/// Length of a crack from its mouth (inner: from the pair in its middle) to the tip or the end [m].
[[nodiscard]] double crack_length(const mesh::PolygonMesh& mesh, int tip);

/// Direction of a crack at its tip, from global x, counter-clockwise [rad]. The tip must not have ended.
[[nodiscard]] double tip_direction(const mesh::PolygonMesh& mesh, int tip);

}  // namespace sunder::simulation
