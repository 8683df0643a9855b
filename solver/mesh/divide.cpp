#include "solver/mesh/divide.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/mesh/edge_table.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

using Fractions = std::vector<double>;

/// Finds the number of an edge by its two vertices.
class EdgeFinder {
 public:
  explicit EdgeFinder(const EdgeTable& table) {
    for (int e = 0; e < table.count(); ++e) sorted_.push_back({key(table.ends[e]), e});
    std::sort(sorted_.begin(), sorted_.end());
  }
  int find(const Edge& ends) const {  ///< -1 where there is none
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{key(ends), -1});
    return at != sorted_.end() && at->first == key(ends) ? at->second : -1;
  }

 private:
  static Edge key(const Edge& e) { return {std::min(e[0], e[1]), std::max(e[0], e[1])}; }
  std::vector<std::pair<Edge, int>> sorted_;
};

Fractions turned(const Fractions& t) {
  Fractions other;
  for (auto it = t.rbegin(); it != t.rend(); ++it) other.push_back(1.0 - *it);
  return other;
}

/// Two edges that face each other across a crack, and whether table.ends turns them from mouth to tip.
struct FacingEdges {
  int below, above;
  bool below_forward, above_forward;
};

std::vector<FacingEdges> facing_edges(const PolygonMesh& mesh, const EdgeTable& table, const EdgeFinder& finder) {
  std::vector<FacingEdges> pairs;
  for (const CrackFaces& crack : mesh.cracks) {
    for (std::size_t i = 0; i + 1 < crack.lower.size(); ++i) {
      const int below = finder.find({crack.lower[i], crack.lower[i + 1]});
      const int above = finder.find({crack.upper[i], crack.upper[i + 1]});
      if (below < 0 || above < 0) continue;
      pairs.push_back({below, above, table.ends[below][0] == crack.lower[i], table.ends[above][0] == crack.upper[i]});
    }
  }
  return pairs;
}

/// Facing edges get the same division, the one with more pieces.
void match_faces(const std::vector<FacingEdges>& pairs, std::vector<Fractions>& fractions) {
  for (const FacingEdges& pair : pairs) {
    Fractions &below = fractions[pair.below], &above = fractions[pair.above];
    const bool same_sense = pair.below_forward == pair.above_forward;
    if (below.size() >= above.size()) {
      above = same_sense ? below : turned(below);
    } else {
      below = same_sense ? above : turned(above);
    }
  }
}

/// Where the new vertices of each edge stand in the mesh: first[e] … first[e + 1] - 1, in the sense of table.ends.
struct NewVertices {
  const EdgeTable& table;
  std::vector<int> first;

  /// Appends those of one edge in the sense that starts at `from`.
  void append(std::vector<int>& line, int edge, int from) const {
    const int count = first[edge + 1] - first[edge];
    for (int k = 0; k < count; ++k) {
      line.push_back(table.ends[edge][0] == from ? first[edge] + k : first[edge + 1] - 1 - k);
    }
  }
};

void insert(PolygonMesh& mesh, const EdgeTable& table, const EdgeFinder& finder, const NewVertices& added) {
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    std::vector<int> line;
    const std::vector<int>& old = mesh.polygons[i].vertices;
    for (int h = table.first[i]; h < table.first[i + 1]; ++h) {
      const int from = old[h - table.first[i]];
      line.push_back(from);
      added.append(line, table.edge[h], from);
    }
    if (mesh.polygons[i].open) line.push_back(old.back());
    mesh.polygons[i].vertices = std::move(line);
  }
  for (auto& [name, edges] : mesh.boundaries) {
    std::vector<Edge> pieces;
    for (const Edge& e : edges) {
      std::vector<int> line{e[0]};
      if (const int edge = finder.find(e); edge >= 0) added.append(line, edge, e[0]);
      line.push_back(e[1]);
      for (std::size_t k = 0; k + 1 < line.size(); ++k) pieces.push_back({line[k], line[k + 1]});
    }
    edges = std::move(pieces);
  }
  for (CrackFaces& crack : mesh.cracks) {
    for (std::vector<int>* face : {&crack.lower, &crack.upper}) {
      std::vector<int> line;
      for (std::size_t i = 0; i < face->size(); ++i) {
        line.push_back((*face)[i]);
        if (i + 1 == face->size()) break;
        if (const int edge = finder.find({(*face)[i], (*face)[i + 1]}); edge >= 0) added.append(line, edge, (*face)[i]);
      }
      *face = std::move(line);
    }
  }
}

void divide(PolygonMesh& mesh, const EdgeTable& table, std::vector<Fractions> fractions) {
  if (std::all_of(fractions.begin(), fractions.end(), [](const Fractions& t) { return t.empty(); })) return;
  const EdgeFinder finder(table);
  const std::vector<FacingEdges> facing = facing_edges(mesh, table, finder);
  match_faces(facing, fractions);
  NewVertices added{table, {static_cast<int>(mesh.vertices.size())}};
  for (int e = 0; e < table.count(); ++e) {
    const Point a = mesh.vertices[table.ends[e][0]], b = mesh.vertices[table.ends[e][1]];
    double before = 0.0;
    for (const double t : fractions[e]) {
      if (!(t > before && t < 1.0)) {
        throw std::invalid_argument("edge from " + place(a) + " to " + place(b) + ": fraction " + number(t) +
                                    " behind " + number(before) + "; fractions must ascend inside 0 … 1");
      }
      mesh.vertices.push_back((1.0 - t) * a + t * b);
      before = t;
    }
    added.first.push_back(static_cast<int>(mesh.vertices.size()));
  }
  for (const FacingEdges& pair : facing) {  // the two faces start at the same places, to the last bit
    for (int k = added.first[pair.below]; k < added.first[pair.below + 1]; ++k) {
      const int step = k - added.first[pair.below];
      const bool same_sense = pair.below_forward == pair.above_forward;
      const int opposite = same_sense ? added.first[pair.above] + step : added.first[pair.above + 1] - 1 - step;
      mesh.vertices[opposite] = mesh.vertices[k];
    }
  }
  insert(mesh, table, finder, added);
}

Fractions equal_pieces(int count) {
  Fractions t;
  for (int k = 1; k < count; ++k) t.push_back(static_cast<double>(k) / count);
  return t;
}

}  // namespace

void divide_edges(PolygonMesh& mesh, const EdgeDivision& division) {
  const EdgeTable table = edge_table(mesh);
  std::vector<Fractions> fractions(table.count());
  for (int e = 0; e < table.count(); ++e) {
    fractions[e] = division(mesh.vertices[table.ends[e][0]], mesh.vertices[table.ends[e][1]]);
  }
  divide(mesh, table, std::move(fractions));
}

void divide_long_edges(PolygonMesh& mesh, const SizeField& size) {
  size.check();
  divide_edges(mesh, [&](const Point& a, const Point& b) { return division(a, b, size); });
}

void divide_polygon(PolygonMesh& mesh, int polygon, int edges) {
  if (polygon < 0 || polygon >= static_cast<int>(mesh.polygons.size())) {
    throw std::invalid_argument("polygon " + std::to_string(polygon) + " is not in 0 … " +
                                std::to_string(mesh.polygons.size()) + " - 1");
  }
  const Polygon& p = mesh.polygons[polygon];
  const int count = p.edge_count();
  std::vector<double> angle(count);
  for (int e = 0; e < count; ++e) {
    const Point a = mesh.vertices[p.edge(e)[0]] - p.scaling_centre, b = mesh.vertices[p.edge(e)[1]] - p.scaling_centre;
    angle[e] = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  }
  std::vector<int> pieces_of(count, 1);
  for (int total = count; total < edges; ++total) {
    int widest = 0;
    for (int e = 1; e < count; ++e) {
      // The margin keeps edges of equal angle in turn whatever their round-off.
      if (angle[e] / pieces_of[e] > angle[widest] / pieces_of[widest] * (1.0 + 1e-9)) widest = e;
    }
    ++pieces_of[widest];
  }
  const EdgeTable table = edge_table(mesh);
  std::vector<Fractions> fractions(table.count());
  for (int e = 0; e < count; ++e) fractions[table.edge[table.first[polygon] + e]] = equal_pieces(pieces_of[e]);
  divide(mesh, table, std::move(fractions));
}

}  // namespace sunder::mesh
