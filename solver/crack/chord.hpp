#pragma once
/// Chords of a polygon: straight cuts from a vertex to another vertex or to the middle of an edge.

#include <span>
#include <vector>

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

struct Chord {
  int from = -1;        ///< index in the loop
  int to = -1;          ///< index in the loop, or of the edge's first vertex
  bool middle = false;  ///< ends at the middle of edge `to`
};

/// Every chord from vertex `from` that lies inside the polygon and meets its outline at its ends only.
std::vector<Chord> chords_from(std::span<const Point> loop, int from);

/// The two parts of the outline, each counter-clockwise; the first lies on the left of the chord.
std::array<std::vector<Point>, 2> parts(std::span<const Point> loop, const Chord& chord);

/// How good a polygon of this shape is, 0 … 1: the lesser of the clearance of its best scaling centre
/// (mesh/polygon_geometry.hpp) and twice its area over the square of its diameter (a square: 0.5 · 2).
double shape_quality(std::span<const Point> loop);

/// Area over diameter [m]: half the thickness of a long strip.
double thickness(std::span<const Point> loop);

/// Divides the polygon along the chord; returns the new polygon on its left.
int cut(Cutter& cutter, int polygon, const Chord& chord);

}  // namespace sunder::crack
