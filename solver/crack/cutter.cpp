#include "solver/crack/cutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/mesh/polygon_geometry.hpp"

namespace sunder::crack {

Cutter::Cutter(mesh::PolygonMesh& mesh, const CutOptions& options)
    : mesh_(mesh),
      options_(options),
      dead_(mesh.polygons.size(), 0),
      touched_(mesh.polygons.size(), 0),
      reshaped_(mesh.polygons.size(), 0),
      vertex_from_(mesh.vertices.size()),
      tip_vertices_(mesh.cracks.size(), -1) {
  for (std::size_t v = 0; v < vertex_from_.size(); ++v) vertex_from_[v] = static_cast<int>(v);
  std::size_t edges = 0;
  for (const mesh::Polygon& p : mesh_.polygons) edges += p.vertices.size();
  owner_.reserve(edges + edges / 4);
  for (int p = 0; p < static_cast<int>(mesh_.polygons.size()); ++p) link(p);
}

void Cutter::link(int polygon) {
  const mesh::Polygon& p = mesh_.polygons[polygon];
  for (int i = 0; i < p.edge_count(); ++i) owner_[key(p.edge(i)[0], p.edge(i)[1])] = polygon;
}

void Cutter::unlink(int polygon) {
  const mesh::Polygon& p = mesh_.polygons[polygon];
  for (int i = 0; i < p.edge_count(); ++i) {
    const auto found = owner_.find(key(p.edge(i)[0], p.edge(i)[1]));
    if (found != owner_.end() && found->second == polygon) owner_.erase(found);
  }
}

void Cutter::set_loop(int polygon, std::vector<int> vertices) {
  unlink(polygon);
  mesh_.polygons[polygon].vertices = std::move(vertices);
  link(polygon);
  touched_[polygon] = 1;
}

int Cutter::owner(int a, int b) const {
  const auto found = owner_.find(key(a, b));
  return found == owner_.end() ? -1 : found->second;
}

int Cutter::index_of(int polygon, int vertex) const {
  const std::vector<int>& v = loop(polygon);
  const auto found = std::find(v.begin(), v.end(), vertex);
  if (found == v.end()) throw CutFailure("the polygons round the crack do not fit together");
  return static_cast<int>(found - v.begin());
}

int Cutter::next(int polygon, int vertex) const {
  const std::vector<int>& v = loop(polygon);
  return v[(index_of(polygon, vertex) + 1) % v.size()];
}

int Cutter::previous(int polygon, int vertex) const {
  const std::vector<int>& v = loop(polygon);
  return v[(index_of(polygon, vertex) + v.size() - 1) % v.size()];
}

Fan Cutter::fan(int vertex, int polygon) const {
  Fan f;
  f.polygons.push_back(polygon);
  const auto limit = mesh_.polygons.size() + 1;
  for (int p = owner(vertex, previous(polygon, vertex)); p >= 0; p = owner(vertex, previous(p, vertex))) {
    if (p == polygon) {
      f.closed = true;
      return f;
    }
    f.polygons.push_back(p);
    if (f.polygons.size() > limit) throw CutFailure("the polygons round the crack do not fit together");
  }
  for (int p = owner(next(polygon, vertex), vertex); p >= 0; p = owner(next(p, vertex), vertex)) {
    f.polygons.insert(f.polygons.begin(), p);
    if (f.polygons.size() > limit) throw CutFailure("the polygons round the crack do not fit together");
  }
  return f;
}

double Cutter::shortest_edge(int vertex, int polygon) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int p : fan(vertex, polygon).polygons) {
    least = std::min({least, (at(next(p, vertex)) - at(vertex)).norm(), (at(previous(p, vertex)) - at(vertex)).norm()});
  }
  return least;
}

std::vector<Point> Cutter::points(int polygon) const {
  std::vector<Point> result;
  result.reserve(loop(polygon).size());
  for (const int v : loop(polygon)) result.push_back(at(v));
  return result;
}

double Cutter::area(int polygon) const {
  return mesh::moments(points(polygon)).area;
}

int Cutter::crack_of_edge(int a, int b) const {
  for (std::size_t c = 0; c < mesh_.cracks.size(); ++c) {
    const auto& [lower, upper, tip_polygon] = mesh_.cracks[c];
    for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
      if ((lower[i + 1] == a && lower[i] == b) || (upper[i] == a && upper[i + 1] == b)) return static_cast<int>(c);
    }
    const int tip = tip_vertices_[c];
    if (tip >= 0 && ((tip == a && lower.back() == b) || (upper.back() == a && tip == b))) return static_cast<int>(c);
  }
  return -1;
}

int Cutter::add_crack() {
  mesh_.cracks.emplace_back();
  tip_vertices_.push_back(-1);
  return static_cast<int>(mesh_.cracks.size()) - 1;
}

int Cutter::new_vertex(const Point& point, int from) {
  mesh_.vertices.push_back(point);
  vertex_from_.push_back(from);
  return static_cast<int>(mesh_.vertices.size()) - 1;
}

int Cutter::new_polygon(int like) {
  mesh::Polygon p;
  p.material = mesh_.polygons[like].material;
  p.scaling_centre = Point::Zero();
  mesh_.polygons.push_back(std::move(p));
  dead_.push_back(0);
  touched_.push_back(1);
  reshaped_.push_back(1);
  return static_cast<int>(mesh_.polygons.size()) - 1;
}

void Cutter::insert_after(int polygon, int a, int x) {
  std::vector<int> v = loop(polygon);
  v.insert(v.begin() + index_of(polygon, a) + 1, x);
  set_loop(polygon, std::move(v));
}

void Cutter::rename_boundary_edge(mesh::Edge from, const std::vector<mesh::Edge>& to) {
  for (auto& [name, edges] : mesh_.boundaries) {
    const auto found = std::find(edges.begin(), edges.end(), from);
    if (found == edges.end()) continue;
    const auto place = edges.erase(found);
    edges.insert(place, to.begin(), to.end());
  }
}

int Cutter::split_edge(int a, int b, const Point& point) {
  const int x = new_vertex(point, -1);
  // A face's edge: the opposite face is divided too, and the two vertices are a pair.
  for (std::size_t c = 0; c < mesh_.cracks.size(); ++c) {
    auto& [lower, upper, tip_polygon] = mesh_.cracks[c];
    const int tip = tip_vertices_[c];
    for (std::size_t i = 0; i < lower.size(); ++i) {
      const bool last = i + 1 == lower.size();
      if (last && tip < 0) break;
      const int lower_next = last ? tip : lower[i + 1], upper_next = last ? tip : upper[i + 1];
      const bool on_lower = lower_next == a && lower[i] == b;
      if (!on_lower && !(upper[i] == a && upper_next == b)) continue;
      const int twin = new_vertex(point, -1);
      if (on_lower) {
        insert_after(owner(upper[i], upper_next), upper[i], twin);
      } else {
        insert_after(owner(lower_next, lower[i]), lower_next, twin);
      }
      lower.insert(lower.begin() + i + 1, on_lower ? x : twin);
      upper.insert(upper.begin() + i + 1, on_lower ? twin : x);
      break;
    }
  }
  const int left = owner(a, b), right = owner(b, a);
  if (left >= 0) insert_after(left, a, x);
  if (right >= 0) insert_after(right, b, x);
  if (left < 0 || right < 0)
    rename_boundary_edge(left >= 0 ? mesh::Edge{a, b} : mesh::Edge{b, a},
                         left >= 0 ? std::vector<mesh::Edge>{{a, x}, {x, b}} : std::vector<mesh::Edge>{{b, x}, {x, a}});
  return x;
}

int Cutter::split_polygon(int polygon, int f, int x) {
  const std::vector<int> whole = loop(polygon);
  const int n = static_cast<int>(whole.size());
  const int i = index_of(polygon, f), j = index_of(polygon, x);
  if (i == j || (i + 1) % n == j || (j + 1) % n == i) throw CutFailure("a chord of a polygon coincides with its edge");
  std::vector<int> left{f}, right{x};
  for (int k = j; k != i; k = (k + 1) % n) left.push_back(whole[k]);
  for (int k = i; k != j; k = (k + 1) % n) right.push_back(whole[k]);
  set_loop(polygon, std::move(right));
  const int added = new_polygon(polygon);
  set_loop(added, std::move(left));
  reshaped_[polygon] = 1;
  return added;
}

std::optional<std::vector<int>> Cutter::joined_loop(int polygon, int other) const {
  const std::vector<int>&q = loop(polygon), &p = loop(other);
  const int n = static_cast<int>(q.size()), m = static_cast<int>(p.size());
  std::vector<char> shared(n);
  int count = 0, start = -1;
  for (int k = 0; k < n; ++k) {
    shared[k] = owner(q[(k + 1) % n], q[k]) == other;
    count += shared[k];
  }
  for (int k = 0; k < n; ++k) {
    if (shared[k] && !shared[(k + n - 1) % n]) start = k;
  }
  if (start < 0 || count >= m) return std::nullopt;
  for (int k = 0; k < count; ++k) {
    if (!shared[(start + k) % n]) return std::nullopt;  // more than one chain: the union would have a hole
  }
  std::vector<int> loop_of_both;
  for (int k = start + count; k <= start + n; ++k) loop_of_both.push_back(q[k % n]);
  const int entry = index_of(other, q[start]);
  const auto own = loop_of_both.size();
  for (int k = 1; k < m - count; ++k) {
    const int v = p[(entry + k) % m];
    if (std::find(loop_of_both.begin(), loop_of_both.begin() + own, v) != loop_of_both.begin() + own)
      return std::nullopt;
    loop_of_both.push_back(v);
  }
  return loop_of_both;
}

bool Cutter::merge(int polygon, int other) {
  if (polygon == other || mesh_.polygons[polygon].open || mesh_.polygons[other].open) return false;
  if (mesh_.polygons[polygon].material != mesh_.polygons[other].material) return false;
  auto both = joined_loop(polygon, other);
  if (!both) return false;
  const int n = static_cast<int>(loop(polygon).size());
  int first = -1, last = -1;  // ends of the shared chain
  for (int k = 0; k < n; ++k) {
    const int a = loop(polygon)[k], b = loop(polygon)[(k + 1) % n];
    if (owner(b, a) != other) continue;
    if (owner(a, loop(polygon)[(k + n - 1) % n]) != other) first = a;
    if (owner(loop(polygon)[(k + 2) % n], b) != other) last = b;
  }
  unlink(other);
  mesh_.polygons[other].vertices.clear();
  dead_[other] = 1;
  set_loop(polygon, std::move(*both));
  reshaped_[polygon] = 1;
  drop_if_needless(first, polygon);
  if (last != first) drop_if_needless(last, polygon);
  return true;
}

/// After a merge, the end of the shared chain may be left between two collinear edges of the same two polygons.
void Cutter::drop_if_needless(int vertex, int polygon) {
  const Fan f = fan(vertex, polygon);
  if (!f.closed || f.polygons.size() != 2) return;
  const int other = f.polygons[1];
  if (mesh_.polygons[other].open || has_spike(other) || loop(other).size() <= 3 || loop(polygon).size() <= 3) return;
  const Point a = at(previous(polygon, vertex)) - at(vertex), b = at(next(polygon, vertex)) - at(vertex);
  if (a.dot(b) >= 0.0 || std::abs(cross(a, b)) > 1e-9 * a.norm() * b.norm()) return;
  remove_vertex(polygon, vertex);
  remove_vertex(other, vertex);
}

bool Cutter::try_move(int vertex, const Point& to, int polygon, int except) {
  const Fan f = fan(vertex, polygon);
  if (!f.closed) return false;
  if (at(vertex) == to) return true;
  std::vector<double> before;
  const auto clearance_of = [&](int p) {
    const mesh::Polygon& q = mesh_.polygons[p];
    return q.open ? mesh::clearance(points(p), q.scaling_centre, true) : mesh::scaling_centre(points(p)).clearance;
  };
  const auto looked_at = [&](int p) { return p != except && !has_spike(p); };
  for (const int p : f.polygons) {
    if (mesh_.polygons[p].material != mesh_.polygons[polygon].material) return false;
    before.push_back(looked_at(p) ? clearance_of(p) : 0.0);
  }
  const Point from = at(vertex);
  mesh_.vertices[vertex] = to;
  for (std::size_t k = 0; k < f.polygons.size(); ++k) {
    // A polygon whose best point sees half as well as it did is about to lose it.
    if (looked_at(f.polygons[k]) && clearance_of(f.polygons[k]) < 0.5 * before[k]) {
      mesh_.vertices[vertex] = from;
      return false;
    }
  }
  vertex_from_[vertex] = -1;
  for (const int p : f.polygons) touched_[p] = reshaped_[p] = 1;
  return true;
}

void Cutter::slide(int vertex, const Point& to, int polygon) {
  mesh_.vertices[vertex] = to;
  vertex_from_[vertex] = -1;
  for (const int p : fan(vertex, polygon).polygons) touched_[p] = reshaped_[p] = 1;
}

int Cutter::double_vertex(int vertex, const std::vector<int>& polygons) {
  const int twin = new_vertex(at(vertex), vertex_from_[vertex]);
  // Names of boundary edges are asked for before any neighbour is re-linked: an edge between two polygons of the list
  // has an owner on its other side until then.
  for (const int p : polygons) {
    const int before = previous(p, vertex), after = next(p, vertex);
    if (owner(vertex, before) < 0) rename_boundary_edge({before, vertex}, {{before, twin}});
    if (owner(after, vertex) < 0) rename_boundary_edge({vertex, after}, {{twin, after}});
  }
  for (const int p : polygons) {
    std::vector<int> v = loop(p);
    v[index_of(p, vertex)] = twin;
    const char touched = touched_[p];
    set_loop(p, std::move(v));
    touched_[p] = touched;  // another number at the same place: its modes stay
  }
  repair_pairs(vertex, twin);
  return twin;
}

/// Where the doubled vertex stood on another crack's face, that face is now in two parts: the pair becomes two pairs at
/// one place, the first on the mouth's side.
void Cutter::repair_pairs(int vertex, int twin) {
  for (std::size_t c = 0; c < mesh_.cracks.size(); ++c) {
    auto& [lower, upper, tip_polygon] = mesh_.cracks[c];
    for (std::size_t i = 0; i < lower.size(); ++i) {
      const bool on_lower = lower[i] == vertex;
      if (!on_lower && upper[i] != vertex) continue;
      const bool last = i + 1 == lower.size();
      int mouthwards = vertex, tipwards = vertex;
      if (on_lower) {
        if (i > 0 && owner(twin, lower[i - 1]) >= 0) mouthwards = twin;
        const int beyond = last ? tip_vertices_[c] : lower[i + 1];
        if (beyond >= 0 && owner(beyond, twin) >= 0) tipwards = twin;
      } else {
        if (i > 0 && owner(upper[i - 1], twin) >= 0) mouthwards = twin;
        const int beyond = last ? tip_vertices_[c] : upper[i + 1];
        if (beyond >= 0 && owner(twin, beyond) >= 0) tipwards = twin;
      }
      std::vector<int>& face = on_lower ? lower : upper;
      std::vector<int>& opposite = on_lower ? upper : lower;
      face[i] = mouthwards;
      if (tipwards != mouthwards) {
        face.insert(face.begin() + i + 1, tipwards);
        opposite.insert(opposite.begin() + i + 1, opposite[i]);
      }
      break;
    }
  }
}

void Cutter::remove_vertex(int polygon, int vertex) {
  std::vector<int> v = loop(polygon);
  v.erase(v.begin() + index_of(polygon, vertex));
  set_loop(polygon, std::move(v));
  reshaped_[polygon] = 1;
}

void Cutter::choose_centre(int polygon, const Point& centre) {
  mesh_.polygons[polygon].scaling_centre = centre;
  reshaped_[polygon] = 0;
}

}  // namespace sunder::crack
