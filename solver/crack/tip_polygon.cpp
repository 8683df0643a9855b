#include "solver/crack/tip_polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/crack/body.hpp"
#include "solver/crack/chord.hpp"

namespace sunder::crack {
namespace {

/// Faces behind a kink are cut off already where it turns by less than asin of this, 17 degrees: as edges of the tip
/// polygon they would lie along the singular field's own faces.
constexpr double flat_face = 0.3;

/// Distance of the tip from the line of an edge, positive on the edge's left, over its distance from the edge itself: 1
/// where it stands over the edge, 0 where it looks along it.
double steepness(const Point& tip, const Point& a, const Point& b) {
  const double height = cross(a - tip, b - tip) / (b - a).norm(), distance = distance_to_segment(tip, a, b);
  return distance > 0.0 ? height / distance : 0.0;
}

/// How well a chord bounds a tip polygon: distance of its line from the tip over the distance of its nearer end, which
/// is the sine of its angle with the crack where it starts at the crack's last kink.
double chord_quality(const Point& tip, const Point& from, const Point& to, bool tip_on_left) {
  const double height = (tip_on_left ? 1.0 : -1.0) * cross(from - tip, to - tip) / (to - from).norm();
  return height / std::min((from - tip).norm(), (to - tip).norm());
}

struct Tip {
  Cutter& cutter;
  int crack;

  Point place() const { return cutter.at(cutter.tip_vertex(crack)); }
  int polygon() const { return cutter.spike_polygon(crack); }
  int lower() const { return cutter.faces(crack).lower.back(); }
  int upper() const { return cutter.faces(crack).upper.back(); }
  double stretch() const { return (place() - cutter.at(lower())).norm(); }
  double size() const { return std::sqrt(cutter.area(polygon())); }
};

bool joinable(const Tip& tip, int polygon) {
  const Cutter& c = tip.cutter;
  const mesh::Polygon& p = c.mesh().polygons[polygon];
  return !p.open && !c.has_spike(polygon) && p.material == c.mesh().polygons[tip.polygon()].material;
}

/// True where the polygon runs along the last stretch of face that is already cut, behind the tip polygon.
bool along_own_face(const Tip& tip, int polygon) {
  const mesh::CrackFaces& f = tip.cutter.faces(tip.crack);
  for (std::size_t i = 0; i + 1 < f.lower.size(); ++i) {
    if (tip.cutter.owner(f.lower[i + 1], f.lower[i]) == polygon ||
        tip.cutter.owner(f.upper[i], f.upper[i + 1]) == polygon) {
      return true;
    }
  }
  return false;
}

/// Takes the last cut stretch of a straight crack into the tip polygon, so that its faces begin one pair earlier.
bool take_in_last_pair(const Tip& tip) {
  Cutter& c = tip.cutter;
  mesh::CrackFaces& f = c.faces(tip.crack);
  const std::size_t n = f.lower.size();
  if (n < 2) return false;
  const Point back = c.at(f.lower[n - 1]) - c.at(f.lower[n - 2]), ahead = tip.place() - c.at(f.lower[n - 1]);
  // Shorter than round-off of the coordinates, the stretch has no direction of its own.
  const double reach = back.norm() + ahead.norm();
  if (std::abs(cross(back, ahead)) > 1e-9 * back.norm() * std::max(ahead.norm(), 1e-3 * back.norm())) return false;
  if (back.dot(ahead) < 0.0 && ahead.norm() > 1e-9 * reach) return false;
  std::vector<int> others = c.fan(f.lower[n - 1], tip.polygon()).polygons;
  const std::vector<int> above = c.fan(f.upper[n - 1], tip.polygon()).polygons;
  others.insert(others.end(), above.begin(), above.end());
  for (const int p : others) {
    if (p != tip.polygon() && !joinable(tip, p)) return false;
  }
  // All or nothing: the joins are tried on the numbers of the polygons that are left after each.
  for (bool more = true; more;) {
    more = false;
    for (const int p : others) {
      if (p == tip.polygon() || !c.alive(p)) continue;
      if (c.merge(tip.polygon(), p)) more = true;
    }
  }
  for (const int p : others) {
    if (p != tip.polygon() && c.alive(p)) return false;
  }
  const int polygon = tip.polygon(), low = tip.lower(), up = tip.upper();
  if (c.next(polygon, low) != f.lower[n - 2] || c.previous(polygon, up) != f.upper[n - 2]) return false;
  c.remove_vertex(polygon, low);
  c.remove_vertex(polygon, up);
  f.lower.pop_back();
  f.upper.pop_back();
  return true;
}

/// Joins what lies closer to the tip than tip_clearance, measured by the polygons there: a tip polygon is as large as
/// they are, also where a kinked crack has left slivers beside itself. `near` [m].
void join_near_polygons(const Tip& tip, double near) {
  Cutter& c = tip.cutter;
  while (tip.stretch() < near && take_in_last_pair(tip)) {
  }
  for (bool more = true; more;) {
    more = false;
    const int polygon = tip.polygon();
    const std::vector<int> loop = c.loop(polygon);
    const Point place = tip.place();
    for (std::size_t k = 0; k < loop.size() && !more; ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (a == c.tip_vertex(tip.crack) || b == c.tip_vertex(tip.crack)) continue;
      if (distance_to_segment(place, c.at(a), c.at(b)) >= near) continue;
      const int other = c.owner(b, a);
      if (other < 0 || !joinable(tip, other)) continue;
      // With the face behind it in its outline the tip would see that face along its length: a straight stretch goes.
      more = (along_own_face(tip, other) && take_in_last_pair(tip)) || c.merge(polygon, other);
    }
  }
}

double near_distance(const Tip& tip) {
  const Cutter& c = tip.cutter;
  const int polygon = tip.polygon();
  const std::vector<int>& loop = c.loop(polygon);
  double largest = c.area(polygon);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int other = c.owner(loop[(k + 1) % loop.size()], loop[k]);
    if (other >= 0 && joinable(tip, other)) largest = std::max(largest, c.area(other));
  }
  return c.options().tip_clearance * std::sqrt(largest);
}

/// Edges of the open outline seen too flatly, as positions in the loop.
std::vector<int> flat_edges(const Tip& tip) {
  const Cutter& c = tip.cutter;
  const std::vector<int>& loop = c.loop(tip.polygon());
  std::vector<int> edges;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int a = loop[k], b = loop[(k + 1) % loop.size()];
    if (a == c.tip_vertex(tip.crack) || b == c.tip_vertex(tip.crack)) continue;
    if (steepness(tip.place(), c.at(a), c.at(b)) < c.options().flattest_edge) edges.push_back(static_cast<int>(k));
  }
  return edges;
}

/// Σ of what flat edges lack; 0 where all are seen well.
double lack(const Point& tip, std::span<const Point> open_line, double flat) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < open_line.size(); ++k) {
    sum += std::max(0.0, flat - steepness(tip, open_line[k], open_line[k + 1]));
  }
  return sum;
}

/// Joins the polygon behind a flat edge where that makes the tip see better.
bool join_behind_flat_edge(const Tip& tip) {
  Cutter& c = tip.cutter;
  const int polygon = tip.polygon();
  const auto open_line = [&](std::vector<int> loop) {
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), c.tip_vertex(tip.crack)), loop.end());
    std::vector<Point> line;
    for (std::size_t k = 1; k < loop.size(); ++k) line.push_back(c.at(loop[k]));
    return line;
  };
  const double flat = c.options().flattest_edge;
  double best = lack(tip.place(), open_line(c.loop(polygon)), flat) * (1.0 - 1e-6);
  int chosen = -1;
  for (const int k : flat_edges(tip)) {
    const std::vector<int>& loop = c.loop(polygon);
    const int other = c.owner(loop[(k + 1) % loop.size()], loop[k]);
    if (other < 0 || !joinable(tip, other) || along_own_face(tip, other)) continue;
    const auto both = c.joined_loop(polygon, other);
    if (!both) continue;
    const double after = lack(tip.place(), open_line(*both), flat);
    if (after < best) {
      best = after;
      chosen = other;
    }
  }
  return chosen >= 0 && c.merge(polygon, chosen);
}

/// The vertices of the crack's own face that follow each other in the tip polygon's outline, from the last pair
/// backwards.
std::vector<int> face_behind(const Tip& tip, bool lower_side) {
  const Cutter& c = tip.cutter;
  const mesh::CrackFaces& f = tip.cutter.faces(tip.crack);
  const std::vector<int>& face = lower_side ? f.lower : f.upper;
  const int polygon = tip.polygon();
  std::vector<int> chain{face.back()};
  for (std::size_t i = face.size() - 1; i > 0; --i) {
    if ((lower_side ? c.owner(face[i], face[i - 1]) : c.owner(face[i - 1], face[i])) != polygon) break;
    chain.push_back(face[i - 1]);
  }
  return chain;
}

/// Where the crack has a kink behind its tip, the tip polygon begins at the kink: what lies beside the faces behind it
/// is cut off by a chord from the kink, on each side where the tip would see those faces too flatly.
void cut_off_behind(const Tip& tip, bool lower_side) {
  Cutter& c = tip.cutter;
  const std::vector<int> chain = face_behind(tip, lower_side);
  const Point place = tip.place();
  bool flatly = false;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Point &near = c.at(chain[i]), &far = c.at(chain[i + 1]);
    flatly = flatly || (lower_side ? steepness(place, near, far) : steepness(place, far, near)) < flat_face;
  }
  if (!flatly) return;
  const int polygon = tip.polygon();
  const std::vector<int> loop = c.loop(polygon);
  const std::vector<Point> points = c.points(polygon);
  const std::vector<int> others = face_behind(tip, !lower_side);
  const auto is_in = [](const std::vector<int>& list, int v) {
    return std::find(list.begin(), list.end(), v) != list.end();
  };
  double best = 0.0;
  Chord chosen;
  const int start = c.index_of(polygon, chain[0]);
  // Besides the vertices, straight across the crack and up to 60 degrees to either side.
  std::vector<Point> across;
  const Point ahead = place - points[start];
  for (const double angle : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const double turn = angle + (lower_side ? -0.5 : 0.5) * std::numbers::pi;
    across.push_back(Eigen::Rotation2Dd(turn) * ahead);
  }
  std::vector<Chord> chords = chords_from(points, start);
  for (const Chord& chord : chords_along(points, start, across)) chords.push_back(chord);
  for (const Chord& chord : chords) {
    const int to = loop[chord.to], after = loop[(chord.to + 1) % loop.size()];
    if (is_in(chain, to) || is_in(others, to) || to == c.tip_vertex(tip.crack)) continue;
    if (chord.along > 0.0 && (is_in(chain, after) || is_in(others, after))) continue;
    const auto two = parts(points, chord);
    const std::vector<Point>& mine = two[lower_side ? 0 : 1];
    double quality = 1.0;
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const Point &a = mine[k], &b = mine[(k + 1) % mine.size()];
      const bool of_other_face =
          std::any_of(others.begin(), others.end(), [&](int v) { return c.at(v) == a || c.at(v) == b; });
      if (a == place || b == place || of_other_face) continue;
      quality = std::min(quality, steepness(place, a, b));
    }
    const Point end = end_of(points, chord);
    quality = std::min(quality, chord_quality(place, points[start], end, lower_side));
    if (quality <= best) continue;
    // The part beside the faces is divided or joined later where need be, so its shape weighs less.
    quality *= 0.6 + 0.4 * shape_quality(two[lower_side ? 1 : 0]);
    if (quality > best) {
      best = quality;
      chosen = chord;
    }
  }
  if (chosen.from >= 0) cut(c, polygon, chosen);
}

/// Cuts off what the tip does not see, by the chord that leaves both parts in the best shape.
void cut_off_flat_edge(const Tip& tip) {
  Cutter& c = tip.cutter;
  const int polygon = tip.polygon();
  const std::vector<int> loop = c.loop(polygon);
  const std::vector<Point> points = c.points(polygon);
  const int n = static_cast<int>(loop.size());
  const Point place = tip.place();
  const std::vector<int> bad = flat_edges(tip);
  const double flat = c.options().flattest_edge;
  double best = 0.0;
  Chord chosen;
  std::vector<int> starts;
  for (const int k : bad) {
    starts.push_back(k);
    starts.push_back((k + 1) % n);
  }
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  const int tip_index = c.index_of(polygon, c.tip_vertex(tip.crack));
  for (const int start : starts) {
    for (const Chord& chord : chords_from(points, start)) {
      if (start == tip_index || (chord.along == 0.0 && chord.to == tip_index)) continue;
      const auto two = parts(points, chord);
      const bool tip_on_left = std::find(two[0].begin(), two[0].end(), place) != two[0].end();
      const std::vector<Point>& mine = two[tip_on_left ? 0 : 1];
      const std::vector<Point>& off = two[tip_on_left ? 1 : 0];
      const Point from = points[chord.from], end = end_of(points, chord);
      double lowest = chord_quality(place, from, end, tip_on_left);
      if (lowest < flat) continue;
      int still_bad = 0;
      for (std::size_t k = 0; k < mine.size(); ++k) {
        const Point &a = mine[k], &b = mine[(k + 1) % mine.size()];
        if (a == place || b == place) continue;
        const double seen = steepness(place, a, b);
        if (seen < flat) {
          ++still_bad;
        } else {
          lowest = std::min(lowest, seen);
        }
      }
      if (still_bad >= static_cast<int>(bad.size())) continue;
      if (lowest <= best) continue;
      const double quality = std::min(lowest, shape_quality(off, best));
      if (quality > best) {
        best = quality;
        chosen = chord;
      }
    }
  }
  if (chosen.from < 0) throw CutFailure("no polygon around the tip sees its whole boundary");
  cut(c, polygon, chosen);
}

/// Divides the edges of the tip polygon.
void divide_edges(const Tip& tip) {
  Cutter& c = tip.cutter;
  const Point place = tip.place();
  const int tip_vertex = c.tip_vertex(tip.crack);
  const auto halve_where = [&](auto&& wanted) {
    const std::vector<int> loop = c.loop(tip.polygon());
    int count = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (a == tip_vertex || b == tip_vertex || !wanted(c.at(a), c.at(b))) continue;
      c.split_edge(a, b, 0.5 * (c.at(a) + c.at(b)));
      ++count;
    }
    return count;
  };
  const double ratio = c.options().tip_edge_ratio;
  constexpr int most_halvings = 60;
  for (int i = 0; i < most_halvings; ++i) {
    if (halve_where([&](const Point& a, const Point& b) {
          return (b - a).norm() > ratio * distance_to_segment(place, a, b);
        }) == 0) {
      break;
    }
  }
  const auto seen_angle = [&](const Point& a, const Point& b) {
    return std::atan2(cross(a - place, b - place), (a - place).dot(b - place));
  };
  while (static_cast<int>(c.loop(tip.polygon()).size()) - 2 < c.options().tip_edges) {
    const std::vector<int>& loop = c.loop(tip.polygon());
    double widest = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (a != tip_vertex && b != tip_vertex) widest = std::max(widest, seen_angle(c.at(a), c.at(b)));
    }
    // Edges that look alike are halved together, so that a symmetric polygon stays so.
    halve_where([&](const Point& a, const Point& b) { return seen_angle(a, b) > 0.95 * widest; });
  }
}

}  // namespace

void shape_tip(Cutter& cutter, int crack) {
  const Tip tip{cutter, crack};
  if (tip.polygon() < 0) throw CutFailure("the crack tip has no polygon");
  join_near_polygons(tip, near_distance(tip));
  const auto join_behind_flat_edges = [&] {
    constexpr int most_joins = 64;
    for (int i = 0; i < most_joins && !flat_edges(tip).empty(); ++i) {
      if (!join_behind_flat_edge(tip)) break;
    }
  };
  join_behind_flat_edges();  // the more the tip sees, the better the chords that can be chosen
  cut_off_behind(tip, true);
  cut_off_behind(tip, false);
  join_behind_flat_edges();
  constexpr int most_cuts = 16;
  for (int i = 0; i < most_cuts && !flat_edges(tip).empty(); ++i) cut_off_flat_edge(tip);
  if (!flat_edges(tip).empty()) throw CutFailure("no polygon around the tip sees its whole boundary");
  divide_edges(tip);
  cutter.close_spike(crack);
}

}  // namespace sunder::crack
