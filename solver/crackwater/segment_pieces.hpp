#pragma once
/// A segment cut where its flux turns or changes regime, and the exact losses of the pieces.

#include <array>
#include <span>

#include "solver/crackwater/segment_table.hpp"

namespace sunder::crackwater {

/// Losses over a stretch of one regime and one sign of the flux.
struct Piece {
  double start, end;         ///< y within the segment
  double loss;               ///< ∫ φ w⁻³ ds [Pa]
  double slope;              ///< d loss/dc, without what the moving cuts add [Pa s/m²]
  double to_first, to_last;  ///< as in SegmentTable::losses, for the piece as a segment of its own [Pa m]
};

struct Pieces {
  std::array<Piece, 9> piece;
  int count = 0;
  double cut_slope = 0.0;  ///< what the cuts at |q| = q_c add to d loss/dc: jump of φ / (w³ |v|) each
};

/// The stretch [start, end] of a segment for the constant c, cut at q = 0 and |q| = q_c and at `extra` (NaN: nowhere).
Pieces cut(const Segment& segment, const FlowLaw& law, double c, double start, double end, double extra);

/// The same cuts alone: borders[0] = start < … < borders[count] = end; returns the number of stretches between them.
int cut_borders(const Segment& segment, const FlowLaw& law, double c, double start, double end, double extra,
                std::array<double, 10>& borders);

/// What a cut at y where |q| = q_c adds to d loss/dc as it moves: jump of φ / (w³ |v|).
double cut_slope(const Segment& segment, const FlowLaw& law, double y);

/// The whole segment as one piece, in the regime that its middle has.
Piece whole_piece(const Segment& segment, const FlowLaw& law, double c);

/// The friction loss of the stretch alone, where neither turning points nor forces are asked for.
Loss loss_between(const Segment& segment, const FlowLaw& law, double c, double start, double end);

/// y of the points in (start, end) with V(y) = c, in ascending order; returns how many (0 … 2).
int crossings(const Segment& segment, double c, double start, double end, std::array<double, 2>& y);

inline double flux(const Segment& segment, double c, double y) {
  return c - segment.middle - y * (segment.linear + y * segment.quadratic);
}
inline double aperture(const Segment& segment, double y) {
  return 0.5 * ((1.0 - y) * segment.first + (1.0 + y) * segment.last);
}

}  // namespace sunder::crackwater
