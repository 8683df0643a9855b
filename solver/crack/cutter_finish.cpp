#include <algorithm>
#include <unordered_map>

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

CutReport Cutter::finish() {
  // Holes in the numbering are filled from the end, so that the numbers of untouched parts stay where they can.
  const auto fill = [](std::vector<char> used, auto&& move_to) {
    int last = static_cast<int>(used.size()) - 1;
    for (int hole = 0; hole <= last; ++hole) {
      if (used[hole]) continue;
      while (last > hole && !used[last]) --last;
      if (last <= hole) return hole;
      move_to(last, hole);
      used[last--] = 0;
      used[hole] = 1;
    }
    return last + 1;
  };
  CutReport report;
  report.polygon_from.resize(mesh_.polygons.size());
  std::vector<char> used_polygon(mesh_.polygons.size()), used_vertex(mesh_.vertices.size());
  for (std::size_t p = 0; p < used_polygon.size(); ++p) {
    used_polygon[p] = !dead_[p];
    report.polygon_from[p] = touched_[p] ? -1 : static_cast<int>(p);
    for (const int v : mesh_.polygons[p].vertices) used_vertex[v] = 1;
  }
  const int polygons = fill(used_polygon, [&](int from, int to) {
    mesh_.polygons[to] = std::move(mesh_.polygons[from]);
    report.polygon_from[to] = report.polygon_from[from];
    for (mesh::CrackFaces& c : mesh_.cracks) {
      if (c.tip_polygon == from) c.tip_polygon = to;
    }
  });
  mesh_.polygons.resize(polygons);
  report.polygon_from.resize(polygons);

  std::unordered_map<int, int> renamed;
  const int vertices = fill(used_vertex, [&](int from, int to) {
    mesh_.vertices[to] = mesh_.vertices[from];
    vertex_from_[to] = vertex_from_[from];
    renamed[from] = to;
  });
  mesh_.vertices.resize(vertices);
  vertex_from_.resize(vertices);
  if (!renamed.empty()) {
    const auto rename = [&](int& v) {
      if (v < vertices) return;
      const auto found = renamed.find(v);
      if (found != renamed.end()) v = found->second;
    };
    for (mesh::Polygon& p : mesh_.polygons) std::for_each(p.vertices.begin(), p.vertices.end(), rename);
    for (auto& [name, edges] : mesh_.boundaries) {
      for (mesh::Edge& e : edges) std::for_each(e.begin(), e.end(), rename);
    }
    for (mesh::CrackFaces& c : mesh_.cracks) {
      std::for_each(c.lower.begin(), c.lower.end(), rename);
      std::for_each(c.upper.begin(), c.upper.end(), rename);
    }
  }
  report.vertex_from = std::move(vertex_from_);
  for (int p = 0; p < polygons; ++p) {
    if (report.polygon_from[p] < 0) report.changed.push_back(p);
  }
  return report;
}

}  // namespace sunder::crack
