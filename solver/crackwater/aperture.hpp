#pragma once
/// The gap that water finds between two rough crack faces, from their opening as the solid sees it.
///
/// Rough faces never close fully: a minimum aperture w0 stays. Two readings of it are offered:
///
///     larger   w = max(opening, w0)          the faces move w0 before the water notices
///     sum      w = w0 + max(opening, 0)      w0 is a roughness layer that the opening adds to
///
/// The capacity of the crack, and with it the water that must move, follows w and not the faces: a face that rests on
/// its roughness pumps nothing. So dw/dt is the opening rate where w follows the opening, and 0 where it rests on the
/// bound. On the bound itself the derivative is the one towards the future: max(opening rate, 0).

#include <span>

namespace sunder::crackwater {

enum class ApertureRule { larger, sum };

struct Aperture {
  double value;   ///< w [m], ≥ w0
  double rate;    ///< dw/dt [m/s]
  double factor;  ///< dw/d(opening), 0 or 1; also d(dw/dt)/d(opening rate)
};

/// `opening` [m] may be negative (penetration); minimum_aperture [m] > 0.
Aperture aperture(double opening, double opening_rate, double minimum_aperture, ApertureRule rule);

/// The same for every node; all spans have the length of `openings`.
void apertures(std::span<const double> openings, std::span<const double> opening_rates, double minimum_aperture,
               ApertureRule rule, std::span<double> values, std::span<double> rates, std::span<double> factors);

}  // namespace sunder::crackwater
