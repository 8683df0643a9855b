#pragma once
/// Gives a crack tip its polygon: open, around the tip, and of a shape in which the tip sees everything well.

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

/// Turns the spike of a crack into its open tip polygon. Polygons closer to the tip than tip_clearance are joined to
/// the one that holds it; the last stretch of a straight crack behind the tip is taken in with them. What the tip still
/// does not see (behind a kink, round a corner) is cut off; then edges are divided (CutOptions). Throws CutFailure
/// where no such polygon exists.
void shape_tip(Cutter& cutter, int crack);

}  // namespace sunder::crack
