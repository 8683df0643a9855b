#include "verification/exact/polygon.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sunder::exact {

AreaMoments area_moments(std::span<const Complex> vertices) {
  AreaMoments moments{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Complex a = vertices[i], b = vertices[(i + 1) % vertices.size()];
    const double twice = a.real() * b.imag() - a.imag() * b.real();  // of the triangle 0, a, b
    moments.area += twice / 2.0;
    moments.first += twice / 6.0 * (a + b);
    moments.second += twice / 12.0 * (a * a + a * b + b * b);
    moments.polar += twice / 12.0 * (std::norm(a) + (a * std::conj(b)).real() + std::norm(b));
  }
  return moments;
}

std::vector<std::pair<double, double>> gauss_rule(int count) {
  if (count < 1) throw std::invalid_argument("gauss_rule: at least one point is needed");
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double p = 1.0, previous = 0.0;
      for (int n = 1; n <= count; ++n) {
        const double next = ((2.0 * n - 1.0) * x * p - (n - 1.0) * previous) / n;
        previous = p;
        p = next;
      }
      slope = count * (x * p - previous) / (x * x - 1.0);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    rule.emplace_back(x, 2.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

std::vector<Complex> edge_forces(std::span<const Complex> nodes, const std::function<Complex(Complex)>& traction,
                                 int points) {
  const Complex start = nodes.front(), along = nodes.back() - nodes.front();
  const double length = std::abs(along);
  std::vector<double> places;  // of the nodes, 0 … 1
  for (const Complex node : nodes) places.push_back(((node - start) * std::conj(along)).real() / (length * length));
  std::vector<Complex> forces(nodes.size());
  for (const auto& [x, weight] : gauss_rule(points)) {
    const double s = 0.5 * (1.0 + x);
    const Complex t = traction(start + s * along) * (0.5 * weight * length);
    for (std::size_t i = 0; i < places.size(); ++i) {
      double N = 1.0;
      for (std::size_t j = 0; j < places.size(); ++j)
        if (j != i) N *= (s - places[j]) / (places[i] - places[j]);
      forces[i] += N * t;
    }
  }
  return forces;
}

}  // namespace sunder::exact
