#pragma once
/// Makes sound polygons of the pieces that a cut has left.

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

/// Every reshaped closed polygon: divided until each part is star-shaped, joined to a neighbour where it is a sliver,
/// and given a scaling centre. Throws CutFailure where a piece cannot be divided into star-shaped parts.
void repair_pieces(Cutter& cutter);

}  // namespace sunder::crack
