#pragma once
/// Lengthens a crack by one straight segment.

#include <string>

#include "solver/crack/cut_options.hpp"
#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::crack {

enum class TipEvent {
  advanced,          ///< the tip is where it was asked to be
  reached_boundary,  ///< the crack came out at a face of the body and has no tip any more
  reached_crack,     ///< likewise at a face of a crack
  refused,           ///< nothing was done; `reason` says why
};

struct Advance {
  TipEvent event = TipEvent::refused;
  std::string reason;                     ///< empty unless refused
  mesh::Point tip = mesh::Point::Zero();  ///< where the crack ends now [m]
  CutReport report;                       ///< empty where refused
};

/// Moves the tip of mesh.cracks[crack] straight to `tip` [m]. The segment may be much shorter or longer than a polygon
/// and may turn by up to 90 degrees. It ends at the first face it meets, and also where it stops short of a face ahead
/// by less than tip_clearance · √(area of its polygon). A crack without tip (tip_polygon = -1, it has reached a face)
/// is refused. The mesh is changed only where the event is not `refused`. Never throws for geometry;
/// std::invalid_argument for a crack that does not exist.
[[nodiscard]] Advance advance_tip(mesh::PolygonMesh& mesh, int crack, const mesh::Point& tip,
                                  const CutOptions& options = {});

}  // namespace sunder::crack
