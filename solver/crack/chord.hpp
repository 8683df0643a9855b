#pragma once
/// Chords of a polygon: straight cuts from a vertex to another vertex or to the middle of an edge.

#include <span>
#include <vector>

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

struct Chord {
  int from = -1;       ///< index in the loop
  int to = -1;         ///< index in the loop, or of the first vertex of the edge it ends on
  double along = 0.0;  ///< 0: ends at vertex `to`; 0 … 1: at this fraction of the edge from there
};

/// Every chord from vertex `from` that lies inside the polygon and meets its outline at its ends only: to the vertices
/// and to the middles of the edges.
std::vector<Chord> chords_from(std::span<const Point> loop, int from);

/// Chords from vertex `from` straight on in the given directions, each to where it first meets the outline.
std::vector<Chord> chords_along(std::span<const Point> loop, int from, std::span<const Point> directions);

/// Where a chord ends [m].
Point end_of(std::span<const Point> loop, const Chord& chord);

/// The two parts of the outline, each counter-clockwise; the first lies on the left of the chord.
std::array<std::vector<Point>, 2> parts(std::span<const Point> loop, const Chord& chord);

/// How good a polygon of this shape is, 0 … 1: the lesser of the clearance of a scaling centre
/// (mesh/polygon_geometry.hpp) and twice its area over the square of its diameter (a square: 1). 0 where that is not
/// more than `at_least`: the clearance costs much more and is then not asked for.
double shape_quality(std::span<const Point> loop, double at_least = 0.0);

/// Area over diameter [m]: half the thickness of a long strip.
double thickness(std::span<const Point> loop);

/// Divides the polygon along the chord; returns the new polygon on its left.
int cut(Cutter& cutter, int polygon, const Chord& chord);

}  // namespace sunder::crack
