#pragma once
/// What a person wrote: one plain value a table, absent where the table is absent. All numbers SI, angles in radians.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/fracture/extraction.hpp"
#include "solver/material/isotropic.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/scene/crack_face_parts.hpp"
#include "solver/scene/shaking_parts.hpp"

namespace sunder::scene {

using mesh::Point;

enum class Analysis { static_, modal, dynamic, crack_water, response };

/// A place in the scene's file; line 0: not in the file (an override made the table).
struct Location {
  int line = 0, column = 0;  ///< counted from 1
};

struct Geometry {
  std::vector<Point> outline;                          ///< straight-edged, counter-clockwise [m]
  std::vector<std::vector<Point>> holes;               ///< each clockwise or counter-clockwise [m]
  std::map<std::string, std::vector<int>> boundaries;  ///< edge i runs from vertex i to i + 1; holes' edges count on
};

struct Refinement {
  Point centre;   ///< [m]
  double radius;  ///< [m], > 0
  double size;    ///< [m], > 0
};

/// Ever shorter edges towards a corner of a one-polygon body: at length · ratio^k from it, k = 1 … layers.
struct Grading {
  Point corner;         ///< a vertex of the outline [m]
  int layers;           ///< 1 … 40
  double ratio = 0.15;  ///< > 0, < 1
};

enum class Cells {
  dual,       ///< polygons around the vertices of gmsh's triangles (default)
  triangles,  ///< gmsh's triangles themselves
  squares,    ///< a grid on a rectangular outline
  one,        ///< the whole outline is one polygon
};

/// Polygons written out by hand or by another program, instead of [geometry].
struct PolygonList {
  std::vector<Point> vertices;                                ///< [m]
  std::vector<std::vector<int>> polygons;                     ///< counter-clockwise vertex indices
  std::map<std::string, std::vector<mesh::Edge>> boundaries;  ///< vertex pairs
};

struct Mesh {
  Cells cells = Cells::dual;
  std::optional<double> size;       ///< target polygon size [m], > 0; needed with [geometry] unless cells = "one"
  int order = 1;                    ///< order p of the line elements on polygon edges, 1 … 64
  std::optional<int> tip_order;     ///< order on the crack polygon's edges, >= order; absent: chosen (see README)
  std::optional<int> tip_edges;     ///< least number of edges of a crack polygon; absent: chosen
  std::optional<double> edge_size;  ///< edges longer than this are divided [m]
  std::vector<Refinement> refine;
  std::vector<Grading> grade;  ///< only with cells = "one"
  long max_polygons = 2'000'000;
  std::optional<std::filesystem::path> file;  ///< gmsh .msh 2.2 or 4.1, resolved against the scene's folder
  bool dual = false;                          ///< with `file`: form the dual polygons
  std::optional<PolygonList> list;            ///< `vertices`, `polygons`, `boundaries`
};

struct Region {  ///< another material inside `outline`: a polygon belongs to it where its scaling centre lies inside
  std::vector<Point> outline;
  material::Isotropic material;
};

struct Crack {
  std::vector<Point> path;       ///< from the mouth to the tip [m]; at least two points
  bool inner = false;            ///< both ends are tips, inside the body
  bool through = false;          ///< ends on another face of the body: no tip, the body is cut in two
  std::vector<double> pressure;  ///< Σ p_k s^k: pressure on both faces over the distance from the tip as a fraction
                                 ///< of the crack's length [Pa]; a plain number is uniform; empty: dry
};

struct Support {
  std::string boundary;                  ///< empty where `point` is given
  std::optional<Point> point;            ///< the nearest node must lie within 1e-6 of the body's size
  std::array<bool, 2> fix{};             ///< x, y
  std::array<double, 2> displacement{};  ///< prescribed [m]
};

struct Load {
  std::string boundary;
  std::array<double, 2> traction{};   ///< [Pa], global axes
  double pressure = 0.0;              ///< [Pa], positive pushes into the body
  std::optional<double> water_level;  ///< y of a free surface [m]: pressure ρ g (level - y) below it
  double water_density = 1000.0;      ///< ρ [kg/m³], > 0; g is that of [gravity], 9.81 m/s² without it
};

struct Gravity {
  double acceleration = 9.81;  ///< [m/s²], in -y
};

/// How the numbers at crack tips are read.
struct Fracture {
  fracture::Extraction extraction = fracture::Extraction::reciprocity;
};

struct Modal {
  int count = 4;           ///< lowest natural frequencies
  int interior_order = 0;  ///< radial bubble functions inside each polygon; 0: mass of the static modes alone
};

struct Scene {
  std::string name;
  Analysis analysis = Analysis::static_;
  std::filesystem::path file;  ///< where it was read from
  std::optional<Geometry> geometry;
  Mesh mesh;
  std::optional<material::Isotropic> material;
  std::vector<Region> regions;
  std::vector<Crack> cracks;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::optional<Gravity> gravity;
  std::optional<Fracture> fracture;
  std::optional<Modal> modal;
  std::optional<Reservoir> reservoir;
  std::optional<Foundation> foundation;
  std::optional<Contact> contact;
  std::optional<CrackWater> crack_water;
  std::optional<Propagation> propagation;
  std::optional<GroundMotion> ground_motion;
  std::optional<Dynamics> dynamics;
  std::optional<CrackLine> crack_line;
  std::optional<Response> response;
  std::optional<Output> output;
  std::map<std::string, Location> locations;  ///< where each table stands: "mesh", "crack[0]", "support[1]", …
};

/// `file:line: [table] ` for a message about a table ("mesh", "crack[0]"); without the line where it is not known.
std::string place_of(const Scene& scene, const std::string& table);

}  // namespace sunder::scene
