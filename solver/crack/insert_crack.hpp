#pragma once
/// Puts a crack into a polygon mesh: polygons are split along its path, and the polygon around each tip is left open.
///
/// Vertices on the path are doubled, edges that it does not cross keep their neighbours, so the mesh stays conforming.
/// The path is kept exactly: mesh vertices close to it are moved onto it. A kink may lie inside a polygon. Polygons
/// that the path does not touch keep their data bit for bit.

#include "solver/crack/crack_path.hpp"
#include "solver/crack/cut_options.hpp"

namespace sunder::crack {

/// Checks the path (check_path) and cuts it in. mesh.cracks gets one entry a tip, behind those already there; the first
/// tip of an inner crack comes before its last, and the faces of both start at the pair in the middle of the crack.
/// Throws CrackError where the path cannot be used; the mesh is then as before. `number` counts the cracks of the scene
/// from 0.
CutReport insert_crack(mesh::PolygonMesh& mesh, const CrackPath& path, int number, const CutOptions& options = {});

}  // namespace sunder::crack
