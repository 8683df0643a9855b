#pragma once
/// A polygon mesh while it is being cut: which polygon lies on each side of an edge, kept up to date by every step.
///
/// While a crack is being cut its end is a *spike*: the polygon that holds the tip runs along the upper face to the tip
/// vertex and back along the lower face. Such a polygon is closed by its vertex indices though not star-shaped;
/// finish() demands that every spike has been turned into an open polygon.

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "solver/crack/cut_options.hpp"
#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::crack {

using mesh::Point;

/// The cut cannot be made; caught inside this module.
class CutFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Polygons round a vertex, counter-clockwise.
struct Fan {
  std::vector<int> polygons;
  bool closed = false;  ///< all round: the vertex lies inside the body and on no crack
};

class Cutter {
 public:
  Cutter(mesh::PolygonMesh& mesh, const CutOptions& options);

  const CutOptions& options() const { return options_; }
  const mesh::PolygonMesh& mesh() const { return mesh_; }
  const Point& at(int vertex) const { return mesh_.vertices[vertex]; }
  const std::vector<int>& loop(int polygon) const { return mesh_.polygons[polygon].vertices; }
  mesh::CrackFaces& faces(int crack) { return mesh_.cracks[crack]; }
  bool alive(int polygon) const { return !dead_[polygon]; }
  bool reshaped(int polygon) const { return reshaped_[polygon]; }
  bool has_spike(int polygon) const;

  /// Polygon that has the edge a → b in its counter-clockwise sense; -1 where there is none.
  int owner(int a, int b) const;
  int index_of(int polygon, int vertex) const;
  int next(int polygon, int vertex) const;
  int previous(int polygon, int vertex) const;
  Fan fan(int vertex, int polygon) const;
  double shortest_edge(int vertex, int polygon) const;
  std::vector<Point> points(int polygon) const;
  double area(int polygon) const;
  /// Index of the crack whose face (or spike) has the edge a → b; -1 where it is no crack's.
  int crack_of_edge(int a, int b) const;
  int tip_vertex(int crack) const { return tip_vertices_[crack]; }
  /// The polygon that holds the spike of a crack.
  int spike_polygon(int crack) const;

  int add_crack();
  /// Divides an edge on both its sides; on a crack's face also the opposite face, which gives a new pair.
  int split_edge(int a, int b, const Point& point);
  /// Divides a polygon by the chord f → x; the part on the left gets a new index, which is returned.
  int split_polygon(int polygon, int f, int x);
  /// Joined outline of two polygons that share one chain of edges, from the second's view of the chain's end on.
  std::optional<std::vector<int>> joined_loop(int polygon, int other) const;
  /// Joins `other` to `polygon`; false where they do not share exactly one chain of edges or their materials differ.
  bool merge(int polygon, int other);
  /// Moves an inner vertex where all polygons round it stay well shaped; `except` is not looked at.
  bool try_move(int vertex, const Point& to, int polygon, int except);
  /// Moves a vertex of the boundary along it.
  void slide(int vertex, const Point& to, int polygon);
  /// Gives `polygons` a vertex of their own at the place of `vertex`.
  int double_vertex(int vertex, const std::vector<int>& polygons);
  /// Starts or lengthens a crack inside a polygon: at `vertex` the outline goes to `to` and back; returns the new
  /// vertex. `upper` and `lower` are what `vertex` becomes on the two faces.
  int add_spike(int polygon, int vertex, const Point& to, int upper, int lower);
  void set_tip(int crack, int vertex) { tip_vertices_[crack] = vertex; }
  void move_tip(int vertex, const Point& to);
  /// Takes a vertex out of a polygon's outline.
  void remove_vertex(int polygon, int vertex);
  /// Turns the open polygon of a crack into one with a spike again.
  void reopen(int crack);
  /// Turns the spike of a crack into the open polygon's end.
  void close_spike(int crack);
  void choose_centre(int polygon, const Point& centre);

  /// Closes the gaps in the numbering and says what is unchanged.
  CutReport finish();

 private:
  static std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
  }
  void link(int polygon);
  void unlink(int polygon);
  void set_loop(int polygon, std::vector<int> vertices);
  int new_vertex(const Point& point, int from);
  int new_polygon(int like);
  void insert_after(int polygon, int a, int x);
  void rename_boundary_edge(mesh::Edge from, const std::vector<mesh::Edge>& to);
  void repair_pairs(int vertex, int twin);
  void drop_if_needless(int vertex, int polygon);

  mesh::PolygonMesh& mesh_;
  CutOptions options_;
  std::unordered_map<std::uint64_t, int> owner_;
  std::vector<char> dead_, touched_, reshaped_;
  std::vector<int> vertex_from_, tip_vertices_;
};

}  // namespace sunder::crack
