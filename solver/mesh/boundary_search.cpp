#include "solver/mesh/boundary_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/outline.hpp"
#include "solver/mesh/segments.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// Square buckets over the box of the mesh; each segment is filed in the buckets it runs through.
class Buckets {
 public:
  Buckets(const PolygonMesh& mesh, const std::vector<Edge>& edges, double margin) : margin_(margin) {
    low_ = mesh.vertices[0];
    Point high = low_;
    for (const Point& p : mesh.vertices) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    per_side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(edges.size())) * 2.0), 1, 512);
    cell_ = std::max((high - low_).maxCoeff() / per_side_, 4.0 * margin);
    first_.assign(static_cast<std::size_t>(per_side_) * per_side_ + 1, 0);
    for (const Edge& e : edges) {
      visit(mesh.vertices[e[0]], mesh.vertices[e[1]], [&](int c) { ++first_[c + 1]; });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    filed_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
      visit(mesh.vertices[edges[i][0]], mesh.vertices[edges[i][1]], [&](int c) { filed_[next[c]++] = i; });
    }
  }

  /// All edges that come within the margin of the segment, some more than once.
  template <class Function>
  void near(const Point& a, const Point& b, const Function& function) const {
    visit(a, b, [&](int c) {
      for (int k = first_[c]; k < first_[c + 1]; ++k) function(filed_[k]);
    });
  }

 private:
  int index(double offset) const { return std::clamp(static_cast<int>(offset / cell_), 0, per_side_ - 1); }

  /// Column by column: only the buckets that the segment, widened by the margin, runs through.
  template <class Function>
  void visit(Point a, Point b, const Function& function) const {
    if (b.x() < a.x()) std::swap(a, b);
    a -= low_;
    b -= low_;
    const double width = b.x() - a.x();
    const auto height = [&](double x) {
      return width > 0.0 ? a.y() + (b.y() - a.y()) * std::clamp((x - a.x()) / width, 0.0, 1.0) : a.y();
    };
    for (int i = index(a.x() - margin_); i <= index(b.x() + margin_); ++i) {
      double y0 = height(i * cell_ - margin_), y1 = height((i + 1) * cell_ + margin_);
      if (width <= 2.0 * margin_) {
        y0 = a.y();
        y1 = b.y();
      }
      for (int j = index(std::min(y0, y1) - margin_); j <= index(std::max(y0, y1) + margin_); ++j) {
        function(j * per_side_ + i);
      }
    }
  }

  Point low_;
  double margin_, cell_ = 1.0;
  int per_side_ = 1;
  std::vector<int> first_, filed_;
};

/// For each vertex the least vertex that cracks pair it with, directly or over others.
std::vector<int> paired_places(const PolygonMesh& mesh) {
  std::vector<int> root(mesh.vertices.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const CrackFaces& crack : mesh.cracks) {
    for (std::size_t i = 0; i < crack.lower.size(); ++i) {
      const int a = find(crack.lower[i]), b = find(crack.upper[i]);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t v = 0; v < root.size(); ++v) root[v] = find(static_cast<int>(v));
  return root;
}

std::string words(const PolygonMesh& mesh, int v) {
  return std::to_string(v) + " at " + place(mesh.vertices[v]);
}

}  // namespace

void check_boundary_places(const PolygonMesh& mesh, const std::vector<Edge>& boundary) {
  const double tolerance = std::max(1e-10 * extent(mesh.vertices), place_tolerance(mesh.vertices));
  const Buckets buckets(mesh, boundary, tolerance);
  const std::vector<int> root = paired_places(mesh);
  const std::vector<Point>& x = mesh.vertices;

  for (const Edge& e : boundary) {
    const Point a = x[e[0]], b = x[e[1]];
    const double length = (b - a).norm();
    buckets.near(a, b, [&](int other) {
      const Edge& f = boundary[other];
      for (const int v : f) {
        if (root[v] == root[e[0]] || root[v] == root[e[1]]) continue;
        const bool joined = f[0] == e[0] || f[0] == e[1] || f[1] == e[0] || f[1] == e[1];
        for (const int w : e) {
          if ((x[v] - x[w]).norm() <= tolerance && !joined) {
            throw MeshError("vertices " + words(mesh, std::min(v, w)) + " and " + words(mesh, std::max(v, w)) +
                            " lie at one place, but are not joined by an edge or paired by a crack; merge them");
          }
        }
        const double along = (x[v] - a).dot(b - a) / length;
        if (along > tolerance && along < length - tolerance && std::abs(twice_area(a, b, x[v])) <= tolerance * length) {
          throw MeshError("vertex " + words(mesh, v) + " hangs on edge " + std::to_string(e[0]) + "-" +
                          std::to_string(e[1]) + " from " + place(a) + " to " + place(b) +
                          ", whose polygon does not list it; insert it there");
        }
      }
      const Point c = x[f[0]], d = x[f[1]];
      const double far = tolerance * length, far_f = tolerance * (d - c).norm();
      const double sc = twice_area(a, b, c), sd = twice_area(a, b, d), sa = twice_area(c, d, a),
                   sb = twice_area(c, d, b);
      if (std::min(std::abs(sc), std::abs(sd)) > far && std::min(std::abs(sa), std::abs(sb)) > far_f && sc * sd < 0.0 &&
          sa * sb < 0.0) {
        throw MeshError("boundary edges " + std::to_string(e[0]) + "-" + std::to_string(e[1]) + " from " + place(a) +
                        " to " + place(b) + " and " + std::to_string(f[0]) + "-" + std::to_string(f[1]) + " from " +
                        place(c) + " to " + place(d) + " cross; polygons overlap there");
      }
    });
  }
}

}  // namespace sunder::mesh
