#pragma once
/// Meshes made by gmsh elsewhere: `.msh` files of the versions 2.2 and 4.1.

#include <filesystem>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct MshOptions {
  bool dual = false;              ///< polygons round the vertices instead of the triangles and quadrilaterals
  long max_polygons = 2'000'000;  ///< refused above
};

/// Triangles and quadrilaterals of first order in a plane z = constant as polygons, or their dual, checked by
/// check_mesh(). Every physical curve names a boundary: by its physical name, or its number where it has none; its
/// lines inside the body name nothing, and a file without physical curves has no named boundaries. Nodes of no cell are
/// left out, the others keep their order; clockwise cells are turned. Points, and physical surfaces, mean nothing here.
/// Text files are read here, binary ones by gmsh. Throws MeshError with the file, and the line where there is one.
PolygonMesh read_msh(const std::filesystem::path& file, const MshOptions& options = {});

}  // namespace sunder::mesh
