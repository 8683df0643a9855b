#include "solver/crack/advance_tip.hpp"

#include <cmath>
#include <stdexcept>

#include "solver/crack/body.hpp"
#include "solver/crack/repair.hpp"
#include "solver/crack/tip_polygon.hpp"
#include "solver/crack/walk.hpp"

namespace sunder::crack {
namespace {

TipEvent event_of(LegEnd end) {
  switch (end) {
    case LegEnd::arrived:
      return TipEvent::advanced;
    case LegEnd::reached_boundary:
      return TipEvent::reached_boundary;
    case LegEnd::reached_crack:
      return TipEvent::reached_crack;
  }
  return TipEvent::refused;
}

Advance refused(const std::string& reason, const mesh::Point& where) {
  return {.event = TipEvent::refused, .reason = reason, .tip = where, .report = {}};
}

}  // namespace

Advance advance_tip(mesh::PolygonMesh& mesh, int crack, const mesh::Point& tip, const CutOptions& options) {
  if (crack < 0 || crack >= static_cast<int>(mesh.cracks.size())) {
    throw std::invalid_argument("advance_tip: crack " + std::to_string(crack) + "; there are " +
                                std::to_string(mesh.cracks.size()));
  }
  const mesh::CrackFaces& faces = mesh.cracks[crack];
  if (faces.tip_polygon < 0)
    return refused("the crack has reached a face and has no tip", mesh.vertices[faces.lower.back()]);
  const mesh::Point from = mesh.polygons[faces.tip_polygon].scaling_centre;
  if (!tip.allFinite()) return refused("the new tip is no finite place", from);
  const mesh::Point back = from - mesh.vertices[faces.lower.back()], way = tip - from;
  if (!(way.norm() > 1e-9 * body_size(mesh))) return refused("the new tip is where the old one is", from);
  // 90 degrees and round-off
  if (back.dot(way) < -1e-9 * back.norm() * way.norm())
    return refused("the crack would turn back by more than 90 degrees", from);

  std::string reason;
  for (const double factor : clearance_attempts) {
    mesh::PolygonMesh result = mesh;
    CutOptions attempt = options;
    attempt.tip_clearance *= factor;
    try {
      Cutter cutter(result, attempt);
      cutter.reopen(crack);
      Front front{cutter.tip_vertex(crack), cutter.spike_polygon(crack)};
      if (front.polygon < 0) return refused("the faces of the crack do not fit its tip polygon", from);
      cutter.set_tip(crack, -1);
      // How near to a face the crack ends does not depend on the attempt.
      const LegEnd end =
          run_leg(cutter, crack, front, {.target = tip, .tip = true, .end_clearance = options.tip_clearance});
      const mesh::Point reached = cutter.at(front.vertex);
      for (int c = 0; c < static_cast<int>(result.cracks.size()); ++c) {
        if (cutter.tip_vertex(c) >= 0) shape_tip(cutter, c);
      }
      repair_pieces(cutter);
      Advance advance{.event = event_of(end), .reason = "", .tip = reached, .report = cutter.finish()};
      mesh = std::move(result);
      return advance;
    } catch (const CutFailure& failure) {
      if (reason.empty()) reason = failure.what();
    }
  }
  return refused(reason, from);
}

}  // namespace sunder::crack
