#pragma once
/// Takes the end of a crack through the polygons, one straight leg at a time, opening it behind.

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

/// The end of the crack while it is cut: a vertex, and a polygon that has it.
struct Front {
  int vertex = -1;
  int polygon = -1;
};

struct Leg {
  Point target = Point::Zero();  ///< [m]
  bool tip = false;              ///< the crack ends there: stays a spike inside its polygon, for shape_tip()
  double end_clearance = 0.0;  ///< a leg to a tip that ends nearer to a face ahead than this · √(area) goes on to it
};

enum class LegEnd { arrived, reached_boundary, reached_crack };

/// The next piece of a leg: an edge of the mesh from the front to `vertex`, or a place inside `polygon`.
struct Step {
  int polygon = -1;
  int vertex = -1;  ///< -1: the target lies inside `polygon`
  bool at_target = false;
  bool on_face = false;  ///< `vertex` lies on a face of the body or of crack `face_crack`
  int face_crack = -1;   ///< -1: a face of the body
};

/// Finds the next piece; divides the polygon in the way where the piece crosses it. Nothing is opened yet. Throws
/// CutFailure where the leg leaves the body at once.
Step next_step(Cutter& cutter, const Front& front, const Leg& leg);

/// Runs along a leg and opens the crack behind. The front is at the target, or where the crack met a face (opened there
/// too; the last pair of its faces is then that place).
LegEnd run_leg(Cutter& cutter, int crack, Front& front, const Leg& leg);

}  // namespace sunder::crack
