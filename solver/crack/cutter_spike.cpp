#include <algorithm>

#include "solver/crack/cutter.hpp"

namespace sunder::crack {

bool Cutter::has_spike(int polygon) const {
  for (std::size_t c = 0; c < mesh_.cracks.size(); ++c) {
    if (tip_vertices_[c] >= 0 && spike_polygon(static_cast<int>(c)) == polygon) return true;
  }
  return false;
}

int Cutter::spike_polygon(int crack) const {
  return owner(tip_vertices_[crack], mesh_.cracks[crack].lower.back());
}

int Cutter::add_spike(int polygon, int vertex, const Point& to, int upper, int lower) {
  const int tip = new_vertex(to, -1);
  const int before = previous(polygon, vertex), after = next(polygon, vertex);
  if (owner(vertex, before) < 0 && upper != vertex) rename_boundary_edge({before, vertex}, {{before, upper}});
  if (owner(after, vertex) < 0 && lower != vertex) rename_boundary_edge({vertex, after}, {{lower, after}});
  std::vector<int> v = loop(polygon);
  const int i = index_of(polygon, vertex);
  v[i] = upper;
  v.insert(v.begin() + i + 1, {tip, lower});
  set_loop(polygon, std::move(v));
  reshaped_[polygon] = 1;
  return tip;
}

void Cutter::move_tip(int vertex, const Point& to) {
  mesh_.vertices[vertex] = to;
  vertex_from_[vertex] = -1;
}

void Cutter::reopen(int crack) {
  mesh::CrackFaces& f = mesh_.cracks[crack];
  const int p = f.tip_polygon;
  const int tip = new_vertex(mesh_.polygons[p].scaling_centre, -1);
  unlink(p);
  mesh_.polygons[p].open = false;
  mesh_.polygons[p].vertices.push_back(tip);
  link(p);
  touched_[p] = reshaped_[p] = 1;
  tip_vertices_[crack] = tip;
  f.tip_polygon = -1;
}

void Cutter::close_spike(int crack) {
  const int tip = tip_vertices_[crack], p = spike_polygon(crack);
  std::vector<int> v = loop(p);
  std::rotate(v.begin(), v.begin() + index_of(p, tip), v.end());
  v.erase(v.begin());
  unlink(p);
  mesh_.polygons[p].open = true;
  mesh_.polygons[p].vertices = std::move(v);
  mesh_.polygons[p].scaling_centre = at(tip);
  link(p);
  touched_[p] = 1;
  reshaped_[p] = 0;  // its centre is chosen
  tip_vertices_[crack] = -1;
  mesh_.cracks[crack].tip_polygon = p;
}

}  // namespace sunder::crack
