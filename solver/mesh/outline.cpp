#include "solver/mesh/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/segments.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// One closed line of the outline with the number of its first edge, for messages.
struct Line {
  const std::vector<Point>& points;
  std::string name;
  int first_edge;
};

std::vector<Line> lines_of(const Outline& outline) {
  std::vector<Line> lines{{outline.vertices, "the outline", 0}};
  int edge = static_cast<int>(outline.vertices.size());
  for (std::size_t h = 0; h < outline.holes.size(); ++h) {
    lines.push_back({outline.holes[h], "hole " + std::to_string(h), edge});
    edge += static_cast<int>(outline.holes[h].size());
  }
  return lines;
}

void check_vertices(const Line& line, double tolerance) {
  const std::vector<Point>& p = line.points;
  const std::size_t n = p.size();
  if (n < 3) {
    throw MeshError(line.name + " has " + std::to_string(n) + " vertices; at least 3 are needed");
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if ((p[next] - p[i]).norm() <= tolerance) {
      throw MeshError("vertices " + std::to_string(i) + " and " + std::to_string(next) + " of " + line.name +
                      " are both at " + place(p[i]) +
                      (next == 0 ? "; the line closes by itself, leave the repeated vertex out"
                                 : "; every vertex must stand once"));
    }
  }
}

void check_finite(const Line& line) {
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (!line.points[i].allFinite()) {
      throw MeshError("vertex " + std::to_string(i) + " of " + line.name + " is " + place(line.points[i]) +
                      "; finite coordinates are needed");
    }
  }
}

/// Neighbouring edges share one vertex; they may not fold back onto each other. All other pairs keep apart.
void check_crossings(const std::vector<Line>& lines, double tolerance) {
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t m = l; m < lines.size(); ++m) {
      const std::vector<Point>&p = lines[l].points, &q = lines[m].points;
      const std::size_t n = p.size(), k = q.size();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = l == m ? i + 1 : 0; j < k; ++j) {
          const Point &a = p[i], &b = p[(i + 1) % n], &c = q[j], &d = q[(j + 1) % k];
          bool meet = false;
          if (l == m && j == i + 1) {
            meet = distance_to_segment(d, a, b) <= tolerance || distance_to_segment(a, c, d) <= tolerance;
          } else if (l == m && (j + 1) % k == i) {
            meet = distance_to_segment(c, a, b) <= tolerance || distance_to_segment(b, c, d) <= tolerance;
          } else {
            meet = segments_meet(a, b, c, d, tolerance);
          }
          if (meet) {
            throw MeshError("edge " + std::to_string(lines[l].first_edge + i) + " of " + lines[l].name + ", " +
                            place(a) + " to " + place(b) + ", meets edge " + std::to_string(lines[m].first_edge + j) +
                            (l == m ? "" : " of " + lines[m].name) + ", " + place(c) + " to " + place(d) +
                            "; the lines of an outline may not touch or cross");
          }
        }
      }
    }
  }
}

void check_senses(const Outline& outline, const std::vector<Line>& lines, double size) {
  for (const Line& line : lines) {
    const double area = moments(line.points).area;
    if (std::abs(area) <= 1e-14 * size * size) {
      throw MeshError(line.name + " encloses no area (" + number(area) + " m²)");
    }
  }
  if (moments(outline.vertices).area < 0.0) {
    throw MeshError("the outline runs clockwise from " + place(outline.vertices[0]) + " to " +
                    place(outline.vertices[1]) +
                    "; write its vertices counter-clockwise (and number the edges of the boundaries again)");
  }
  for (std::size_t h = 0; h < outline.holes.size(); ++h) {
    const Point& p = outline.holes[h][0];
    if (!inside(p, outline.vertices)) {
      throw MeshError("hole " + std::to_string(h) + " at " + place(p) + " lies outside the outline");
    }
    for (std::size_t g = 0; g < outline.holes.size(); ++g) {
      if (g != h && inside(p, outline.holes[g])) {
        throw MeshError("hole " + std::to_string(h) + " at " + place(p) + " lies inside hole " + std::to_string(g));
      }
    }
  }
}

void check_names(const Outline& outline) {
  std::vector<std::string> name(outline.edge_count());
  for (const auto& [boundary, edges] : outline.boundaries) {
    for (const int e : edges) {
      if (e < 0 || e >= outline.edge_count()) {
        throw MeshError("boundary \"" + boundary + "\" names edge " + std::to_string(e) +
                        "; the outline and its holes have edges 0 to " + std::to_string(outline.edge_count() - 1));
      }
      if (!name[e].empty()) {
        throw MeshError("edge " + std::to_string(e) + " belongs to boundaries \"" + name[e] + "\" and \"" + boundary +
                        "\"; every edge may have one name");
      }
      name[e] = boundary;
    }
  }
}

}  // namespace

int Outline::edge_count() const {
  std::size_t count = vertices.size();
  for (const auto& hole : holes) count += hole.size();
  return static_cast<int>(count);
}

std::array<Point, 2> Outline::edge(int i) const {
  const std::vector<Point>* line = &vertices;
  std::size_t e = static_cast<std::size_t>(i);
  for (std::size_t h = 0; e >= line->size(); ++h) {
    e -= line->size();
    line = &holes.at(h);
  }
  return {(*line)[e], (*line)[(e + 1) % line->size()]};
}

double extent(const std::vector<Point>& points) {
  if (points.empty()) return 0.0;
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

double place_tolerance(const std::vector<Point>& points) {
  double largest = 0.0;
  for (const Point& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::max(1e-12 * extent(points), 8.0 * std::numeric_limits<double>::epsilon() * largest);
}

void check_outline(const Outline& outline) {
  const std::vector<Line> lines = lines_of(outline);
  for (const Line& line : lines) check_finite(line);
  const double tolerance = place_tolerance(outline.vertices);
  for (const Line& line : lines) check_vertices(line, tolerance);
  check_crossings(lines, tolerance);
  check_senses(outline, lines, extent(outline.vertices));
  check_names(outline);
}

}  // namespace sunder::mesh
