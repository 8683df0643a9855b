#include "solver/crack/repair.hpp"

#include <algorithm>

#include "solver/crack/chord.hpp"
#include "solver/mesh/polygon_geometry.hpp"

namespace sunder::crack {
namespace {

/// A piece whose best point sees less than this (clearance, mesh/polygon_geometry.hpp) is divided.
constexpr double enough = 0.05;

bool is_piece(const Cutter& cutter, int polygon) {
  return cutter.alive(polygon) && cutter.reshaped(polygon) && !cutter.mesh().polygons[polygon].open &&
         !cutter.has_spike(polygon);
}

/// Chords from reflex corners. Of polygons with many vertices (a crack that grew in short steps leaves them) only those
/// that leave two thick parts: to look at the kernels of all parts would cost vertices⁴.
std::vector<Chord> promising_chords(const std::vector<Point>& points) {
  constexpr std::size_t most = 64;
  const int n = static_cast<int>(points.size());
  std::vector<std::pair<double, Chord>> ranked;
  for (int k = 0; k < n; ++k) {
    const Point after = points[(k + 1) % n] - points[k], before = points[(k + n - 1) % n] - points[k];
    if (cross(after, before) >= 0.0) continue;
    for (const Chord& chord : chords_from(points, k)) ranked.emplace_back(0.0, chord);
  }
  if (ranked.size() > most) {
    for (auto& [rank, chord] : ranked) {
      const auto two = parts(points, chord);
      rank = std::min(thickness(two[0]), thickness(two[1]));
    }
    std::partial_sort(ranked.begin(), ranked.begin() + most, ranked.end(),
                      [](const auto& x, const auto& y) { return x.first > y.first; });
    ranked.resize(most);
  }
  std::vector<Chord> chords;
  for (const auto& [rank, chord] : ranked) chords.push_back(chord);
  return chords;
}

/// Divides a polygon that is not star-shaped, by the chord from one of its reflex corners that leaves the best parts.
void divide(Cutter& cutter, int polygon, int depth) {
  const std::vector<Point> points = cutter.points(polygon);
  const double clearance = mesh::scaling_centre(points).clearance;
  if (clearance >= enough) return;
  constexpr int deepest = 12;
  double best = clearance;
  Chord chosen;
  if (depth < deepest) {
    for (const Chord& chord : promising_chords(points)) {
      const auto two = parts(points, chord);
      // Where no chord makes both parts star-shaped, the one with the better part goes first.
      const double a = shape_quality(two[0], best - 1e-3), b = shape_quality(two[1], best - 1e-3);
      const double quality = std::min(a, b) + 1e-3 * std::max(a, b);
      if (quality > best) {
        best = quality;
        chosen = chord;
      }
    }
  }
  if (chosen.from < 0) {
    if (clearance > mesh::smallest_clearance) return;  // poor, but it can be used
    throw CutFailure("a piece beside the crack cannot be divided into star-shaped polygons");
  }
  const int added = cut(cutter, polygon, chosen);
  divide(cutter, polygon, depth + 1);
  divide(cutter, added, depth + 1);
}

/// Joins a sliver to the neighbour that gives the best union.
bool join_sliver(Cutter& cutter, int polygon) {
  const std::vector<int> loop = cutter.loop(polygon);
  const double own = thickness(cutter.points(polygon));
  double best = 0.0;
  int chosen = -1;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int other = cutter.owner(loop[(k + 1) % loop.size()], loop[k]);
    if (other < 0 || other == polygon || cutter.mesh().polygons[other].open || cutter.has_spike(other)) continue;
    if (cutter.mesh().polygons[other].material != cutter.mesh().polygons[polygon].material) continue;
    const std::vector<Point> neighbour = cutter.points(other);
    if (own >= cutter.options().sliver * thickness(neighbour)) continue;
    const auto both = cutter.joined_loop(other, polygon);
    if (!both) continue;
    std::vector<Point> line;
    for (const int v : *both) line.push_back(cutter.at(v));
    const double quality = shape_quality(line, best);
    // The union may be somewhat worse than the neighbour alone, not more.
    if (quality > best && quality > 0.4 * shape_quality(neighbour)) {
      best = quality;
      chosen = other;
    }
  }
  return chosen >= 0 && cutter.merge(chosen, polygon);
}

}  // namespace

void repair_pieces(Cutter& cutter) {
  const auto count = [&] { return static_cast<int>(cutter.mesh().polygons.size()); };
  for (int p = 0, n = count(); p < n; ++p) {
    if (is_piece(cutter, p)) divide(cutter, p, 0);
  }
  for (bool more = true; more;) {
    more = false;
    for (int p = 0; p < count(); ++p) {
      if (is_piece(cutter, p) && join_sliver(cutter, p)) more = true;
    }
  }
  for (int p = 0; p < count(); ++p) {
    if (!is_piece(cutter, p)) continue;
    const mesh::ScalingCentre centre = mesh::scaling_centre(cutter.points(p));
    if (!(centre.clearance > mesh::smallest_clearance)) {
      throw CutFailure("a piece beside the crack is not star-shaped");
    }
    cutter.choose_centre(p, centre.point);
  }
}

}  // namespace sunder::crack
