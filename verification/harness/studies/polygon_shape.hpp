#pragma once
/// One polygon from the parameters of a study: the shapes at which round-off tells, its place in space, its material.

#include "solver/material/isotropic.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/sbfem/coefficients.hpp"
#include "verification/harness/study.hpp"

namespace sunder::verification {

struct ShapedPolygon {
  mesh::PolygonMesh mesh;  ///< of this one polygon
  material::Isotropic material;
  int order = 1;      ///< of every edge
  double size = 1.0;  ///< [m]: the lengths of the shape are about one times this
};

/// Parameters: `shape`, with
///     "irregular"         a hexagon without symmetry
///     "regular"           `edges` equal ones on the unit circle
///     "rectangle"         1 × 1 / `ratio`
///     "star"              2 · `points` vertices on radii 1 and `inner` in turn: concave
///     "short edge"        a rectangle one side of which is divided at `length` from its end
///     "centre near edge"  a rectangle with its scaling centre at `distance` above its lower edge
///     "notch"             a disc of `edges` chords over `opening` degrees, open, its centre at the notch
/// and with defaults `order` 1, `youngs_modulus` 1, `poisson_ratio` 0.2, `density` 1, `plane` "strain", and the place:
/// `scale` 1, `rotation` 0 [degrees], `shift` 0 [m, along x and y], `first` 0 (the vertex that the numbering starts
/// at). Throws CaseError where a parameter is missing or unknown.
ShapedPolygon shaped_polygon(const StudyInput& input);

/// Its nodes, placed as in any mesh and seen from the scaling centre.
sbfem::Boundary boundary_of(const ShapedPolygon& polygon);

/// A whole number among the parameters. Throws CaseError where it is not one.
int whole_parameter(const StudyInput& input, std::string_view name, int otherwise);

}  // namespace sunder::verification
