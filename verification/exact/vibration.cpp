#include "verification/exact/vibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace sunder::exact {
namespace {

using std::numbers::pi;

}  // namespace

double shear_wave_speed(const PlaneBody& body, double density) {
  return std::sqrt(body.shear_modulus / density);
}

double longitudinal_wave_speed(const PlaneBody& body, double density) {
  return shear_wave_speed(body, density) * std::sqrt((body.kolosov + 1.0) / (body.kolosov - 1.0));
}

double roller_square_frequency(const PlaneBody& body, double density, double side, int index) {
  if (index < 0) throw std::invalid_argument("roller_square_frequency: index must be >= 0");
  const double c_s = shear_wave_speed(body, density), c_p = longitudinal_wave_speed(body, density);
  std::vector<double> speeds;
  const int most = index + 2;  // the index + 1 lowest have i, j <= index + 1
  for (int i = 0; i <= most; ++i)
    for (int j = 0; j <= most; ++j) {
      if (i >= 1 && j >= 1) speeds.push_back(c_s * std::hypot(i, j));
      if (i + j >= 1) speeds.push_back(c_p * std::hypot(i, j));
    }
  std::sort(speeds.begin(), speeds.end());
  return pi / side * speeds[static_cast<std::size_t>(index)];
}

double slender_cantilever_frequency(double effective, double density, double length, double height, int n) {
  if (n < 1) throw std::invalid_argument("slender_cantilever_frequency: n must be >= 1");
  // cos λ + 1 / cosh λ changes its sign once in ((n - 1) π, n π).
  double low = (n - 1) * pi, high = n * pi;
  const auto f = [](double lambda) { return std::cos(lambda) + 1.0 / std::cosh(lambda); };
  const bool rising = f(low) < f(high);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) < 0.0) == rising ? low : high) = middle;
  }
  return low * low * std::sqrt(effective * height * height / (12.0 * density)) / (length * length);
}

}  // namespace sunder::exact
