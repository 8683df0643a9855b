#pragma once
/// A mesh as a drawing (SVG): the polygons as they are, named boundaries, cracks, materials, and a legend.

#include <string>
#include <vector>

#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct PictureOptions {
  std::string title = {};                   ///< first line of the drawing
  std::vector<std::string> materials = {};  ///< name of each material; shown where there is more than one
  const NodalMesh* nodes = nullptr;         ///< nodes as dots, if there are at most `most_dots`
  int most_dots = 4000;                     ///< no dots for nodes or scaling centres beyond this number
};

/// The text of an SVG file, 400 units wide and as high as needed, so that it fills a phone's width and scales above.
/// Colours keep apart for colour-blind eyes [Okabe & Ito 2008], and boundaries differ in their dashes too. The same
/// bytes for the same mesh.
std::string picture(const PolygonMesh& mesh, const PictureOptions& options = {});

}  // namespace sunder::mesh
