#pragma once
/// How large polygons and edges should be at each place of the body.

#include <limits>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Inside the circle the size is `size`; outside it grows with the distance until it meets the size of the
/// surroundings.
struct Refinement {
  Point centre;         ///< [m]
  double radius = 0.0;  ///< [m], >= 0
  double size = 0.0;    ///< [m], > 0
};

/// As a Refinement, round a line of points (a crack path).
struct LineRefinement {
  std::vector<Point> path;  ///< >= 1 points [m]
  double radius = 0.0;      ///< [m], >= 0
  double size = 0.0;        ///< [m], > 0
};

struct SizeField {
  double size = std::numeric_limits<double>::infinity();  ///< away from all refinements [m], > 0
  std::vector<Refinement> refinements = {};
  std::vector<LineRefinement> lines = {};
  double growth = 0.3;  ///< increase of the size per distance, > 0

  /// min(size, refinement size + growth · max(0, distance - radius)) over all refinements [m]. Within `reach` of x the
  /// size lies between at(x, -reach) and at(x, reach).
  double at(const Point& x, double reach = 0.0) const;

  /// Throws std::invalid_argument unless all sizes and `growth` are positive and the radii >= 0.
  void check() const;
};

/// All sizes times the factor, > 0; radii, places and growth stay.
SizeField scaled(SizeField field, double factor);

/// ∫ ds / size along the segment a b: the number of pieces it wants [-].
double pieces(const Point& a, const Point& b, const SizeField& field);

/// Parameters 0 < t_1 < … < 1 that divide the segment a b into pieces that follow the field: equal parts of ∫ ds /
/// size, as few as keep every piece's part <= 1. Dividing b a gives the same places to round-off. Close to a refinement
/// of radius and size h the pieces grow like a geometric series of ratio about e^growth. Throws MeshError where they
/// would be more than 10000.
std::vector<double> division(const Point& a, const Point& b, const SizeField& field);

}  // namespace sunder::mesh
