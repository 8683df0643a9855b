/// The friction loss over many segments for one flux: the loop in which a search spends its time.

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/crackwater/inverse_cube_moments.hpp"
#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/crackwater/segment_table.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

bool SegmentTable::is_split(int i, double c) const {
  const std::size_t k = static_cast<std::size_t>(i);
  return std::abs(std::abs(c - middle_[k]) - law_.critical_flux) < spread_[k];
}

bool SegmentTable::may_turn(int i, double c) const {
  return std::abs(c - middle_[static_cast<std::size_t>(i)]) < spread_[static_cast<std::size_t>(i)] || is_split(i, c);
}

bool SegmentTable::may_turn_within(int first, int last, double c) const {
  for (int block = first / block_size; block * block_size < last; ++block) {
    const double low = c - block_high_[static_cast<std::size_t>(block)];
    const double high = c - block_low_[static_cast<std::size_t>(block)];
    if (!(low > law_.critical_flux || high < -law_.critical_flux)) return true;
  }
  return false;
}

double SegmentTable::single_loss(int i, double c) const {
  const std::size_t k = static_cast<std::size_t>(i);
  const double d = c - middle_[k];
  if (std::abs(d) > law_.critical_flux) {
    const double sign = planted_fault("crackwater/unsigned-flux") ? 1.0 : std::copysign(1.0, d);
    return sign * law_.turbulent * ((a0_[k] * d - a1_[k]) * d - (a1_[k] * d - a2_[k]));
  }
  return law_.laminar * (a0_[k] * d - a1_[k]);
}

Loss SegmentTable::cut_loss(int i, double c) const {
  return loss_between(segment(i), law_, c, -1.0, 1.0);
}

namespace {

struct SweepArrays {
  const double *middle, *spread, *a0, *a1, *a2;
};

/// Whole lanes of a stretch that flows one way in the turbulent regime, without the factor ± b: ∫ q² w⁻³ ds, and ∫ q
/// w⁻³ ds.
template <bool wants_slope>
inline void turbulent_sweep(const SweepArrays& at, double c, int first, int last, double& squares, double& once) {
  Lanes square_sum = broadcast(0.0), once_sum = square_sum;
  for (int i = first; i < last; i += lane_count) {
    const Lanes d = c - load(at.middle + i), a1 = load(at.a1 + i);
    const Lanes product = load(at.a0 + i) * d - a1;
    square_sum += product * d - (a1 * d - load(at.a2 + i));
    if constexpr (wants_slope) once_sum += product;
  }
  squares = sum(square_sum);
  once = sum(once_sum);
}

struct LaneSums {
  Lanes value, slope, magnitude;
  std::array<int, block_size / lane_count> split;  ///< first segments of the lanes that hold one to be cut
  int split_count = 0;
};

/// Whole lanes of any stretch of at most a block. Segments that must be cut add nothing and are listed.
template <bool wants_slope>
inline LaneSums mixed_sweep(const SweepArrays& at, const FlowLaw& law, double c, int first, int last) {
  LaneSums sums{broadcast(0.0), broadcast(0.0), broadcast(0.0), {}, 0};
  const Lanes critical = broadcast(law.critical_flux);
  const bool is_signed = !planted_fault("crackwater/unsigned-flux");
  for (int i = first; i < last; i += lane_count) {
    const Lanes d = c - load(at.middle + i), a0 = load(at.a0 + i), a1 = load(at.a1 + i), a2 = load(at.a2 + i);
    const Lanes size = magnitude(d);
    const LaneMask turbulent = size > critical;
    const LaneMask split = magnitude(size - critical) < load(at.spread + i);
    const Lanes once = a0 * d - a1;
    const Lanes square = law.turbulent * (once * d - (a1 * d - a2));
    const Lanes signed_square = is_signed ? negated_with(square, d) : square;
    const Lanes value = cleared(turbulent ? signed_square : law.laminar * once, split);
    sums.value += value;
    sums.magnitude += magnitude(value);
    if (any(split)) [[unlikely]]
      sums.split[static_cast<std::size_t>(sums.split_count++)] = i;
    if constexpr (wants_slope) {
      const Lanes twice = 2.0 * law.turbulent * once;
      sums.slope += cleared(turbulent ? negated_with(twice, d) : law.laminar * a0, split);
    }
  }
  return sums;
}

}  // namespace

Loss SegmentTable::loss(double c, int first, int last, bool wants_slope) const {
  CompensatedSum value;
  Loss total;
  const auto add = [&](const Loss& part) {
    value.add(part.value);
    total.slope += part.slope;
    total.magnitude += part.magnitude;
  };
  const auto add_one = [&](int i) {
    if (is_split(i, c)) {
      add(cut_loss(i, c));
      return;
    }
    const std::size_t k = static_cast<std::size_t>(i);
    const double part = single_loss(i, c), d = c - middle_[k];
    const double slope = std::abs(d) > law_.critical_flux
                             ? 2.0 * law_.turbulent * std::copysign(1.0, d) * (a0_[k] * d - a1_[k])
                             : law_.laminar * a0_[k];
    add({part, slope, std::abs(part)});
  };
  const SweepArrays at{middle_.data(), spread_.data(), a0_.data(), a1_.data(), a2_.data()};
  const double is_signed = planted_fault("crackwater/unsigned-flux") ? 0.0 : 1.0;
  for (int from = first; from < last;) {
    const int block = from / block_size, to = std::min((block + 1) * block_size, last);
    const int lanes_end = from + (to - from) / lane_count * lane_count;
    const double low = c - block_high_[static_cast<std::size_t>(block)];
    const double high = c - block_low_[static_cast<std::size_t>(block)];
    if (low > law_.critical_flux || high < -law_.critical_flux) {
      const double sign = low > 0.0 ? 1.0 : 1.0 - 2.0 * is_signed;
      double squares = 0.0, once = 0.0;
      if (wants_slope) {
        turbulent_sweep<true>(at, c, from, lanes_end, squares, once);
      } else {
        turbulent_sweep<false>(at, c, from, lanes_end, squares, once);
      }
      add({sign * law_.turbulent * squares, 2.0 * law_.turbulent * std::abs(once), law_.turbulent * squares});
    } else {
      const LaneSums sums = wants_slope ? mixed_sweep<true>(at, law_, c, from, lanes_end)
                                        : mixed_sweep<false>(at, law_, c, from, lanes_end);
      add({sum(sums.value), sum(sums.slope), sum(sums.magnitude)});
      for (int k = 0; k < sums.split_count; ++k) {
        const int lanes = sums.split[static_cast<std::size_t>(k)];
        for (int i = lanes; i < lanes + lane_count; ++i) {
          if (is_split(i, c)) add_one(i);
        }
      }
    }
    for (int i = lanes_end; i < to; ++i) add_one(i);
    from = to;
  }
  total.value = value.value();
  return total;
}

namespace {

/// Losses of four segments and their parts in the nodal forces, from ∫ y^j φ w⁻³ ds = r_j.
struct LaneLosses {
  Lanes loss, to_first, to_last;
};

template <int terms>
inline LaneLosses tapered_losses(Lanes w0, Lanes w1, Lanes h, Lanes alpha, Lanes beta, Lanes d, const FlowLaw& law,
                                 bool is_signed) {
  const Taper<Lanes> taper = taper_of(w0, w1);
  const Lanes inverse = taper.inverse_sum, scale = 4.0 * h * (inverse * inverse * inverse);
  Lanes m[moment_count];
  moments_of_little_taper<terms>(taper, m);
  // φ = e_0 + e_1 y + … + e_4 y⁴
  const LaneMask turbulent = magnitude(d) > broadcast(law.critical_flux);
  const Lanes b = is_signed ? negated_with(broadcast(law.turbulent), d) : broadcast(law.turbulent);
  const Lanes a = broadcast(law.laminar), none = broadcast(0.0);
  const Lanes e0 = turbulent ? b * d * d : a * d;
  const Lanes e1 = turbulent ? -2.0 * b * d * alpha : -a * alpha;
  const Lanes e2 = turbulent ? b * (alpha * alpha - 2.0 * d * beta) : -a * beta;
  const Lanes e3 = turbulent ? 2.0 * b * alpha * beta : none;
  const Lanes e4 = turbulent ? b * beta * beta : none;
  Lanes r[3];
  for (int j = 0; j < 3; ++j) r[j] = e0 * m[j] + (e1 * m[j + 1] + (e2 * m[j + 2] + (e3 * m[j + 3] + e4 * m[j + 4])));
  const Lanes eighth = 0.125 * h * scale;
  // ∫ N_a from here to the end is h (1 - y)²/8, ∫ N_b is h (1 - y)(3 + y)/8
  return {scale * r[0], eighth * (r[0] - 2.0 * r[1] + r[2]), eighth * (3.0 * r[0] - 2.0 * r[1] - r[2])};
}

}  // namespace

void SegmentTable::losses(double c, int first, int last, std::span<double> loss, std::span<double> to_first,
                          std::span<double> to_last) const {
  const bool is_signed = !planted_fault("crackwater/unsigned-flux");
  if (flat()) {
    for (int i = first; i < last; ++i) loss[static_cast<std::size_t>(i)] = single_loss(i, c);
    return;
  }
  // Whole lanes: the arrays are padded, and what is written beyond `last` is overwritten or never read.
  for (int i = first; i < last; i += lane_count) {
    const std::size_t k = static_cast<std::size_t>(std::min(i, padded_ - lane_count));
    const Lanes w0 = load(&aperture_[k]), w1 = load(&aperture_[k + 1]), h = load(&length_[k]);
    const Lanes v0 = load(&rate_[k]), v1 = load(&rate_[k + 1]);
    const Lanes alpha = 0.25 * h * (v0 + v1), beta = 0.125 * h * (v1 - v0), d = c - load(&middle_[k]);
    const Lanes difference = magnitude(w1 - w0), total = w0 + w1;
    LaneLosses four;
    if (!any(difference > little_taper * total)) {
      four = tapered_losses<terms_for_little_taper>(w0, w1, h, alpha, beta, d, law_, is_signed);
    } else if (!any(difference > some_taper * total)) {
      four = tapered_losses<terms_for_some_taper>(w0, w1, h, alpha, beta, d, law_, is_signed);
    } else {
      for (int j = 0; j < lane_count && static_cast<int>(k) + j < count_; ++j) {
        const Piece piece = whole_piece(segment(static_cast<int>(k) + j), law_, c);
        four.loss[j] = piece.loss;
        four.to_first[j] = piece.to_first;
        four.to_last[j] = piece.to_last;
      }
    }
    store(&loss[k], four.loss);
    store(&to_first[k], four.to_first);
    store(&to_last[k], four.to_last);
  }
}

}  // namespace sunder::crackwater
