#include "solver/mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

double distance_to_path(const Point& x, const std::vector<Point>& path) {
  double least = path.size() == 1 ? (x - path[0]).norm() : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Point along = path[i + 1] - path[i];
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((x - path[i]).dot(along) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, (x - path[i] - t * along).norm());
  }
  return least;
}

/// Knots of a piecewise-linear model of s -> ∫ ds / size. The field changes by at most growth per distance, so between
/// knots it changes by a tenth at most and no refinement falls through.
void sample(const Point& a, const Point& b, const SizeField& field, double s0, double s1, std::vector<double>& knots) {
  const double length = (b - a).norm() * (s1 - s0), middle = 0.5 * (s0 + s1);
  if (length * field.growth > 0.1 * field.at((1.0 - middle) * a + middle * b) && s0 < middle && middle < s1) {
    sample(a, b, field, s0, middle, knots);
    sample(a, b, field, middle, s1, knots);
  } else {
    knots.push_back(s1);
  }
}

}  // namespace

double SizeField::at(const Point& x) const {
  double least = size;
  for (const Refinement& r : refinements) {
    least = std::min(least, r.size + growth * std::max(0.0, (x - r.centre).norm() - r.radius));
  }
  for (const LineRefinement& l : lines) {
    least = std::min(least, l.size + growth * std::max(0.0, distance_to_path(x, l.path) - l.radius));
  }
  return least;
}

void SizeField::check() const {
  const auto positive = [](double value, const char* name) {
    if (!(value > 0.0)) throw std::invalid_argument(std::string(name) + " is " + number(value) + ", must be > 0");
  };
  const auto not_negative = [](double value, const char* name) {
    if (!(value >= 0.0)) throw std::invalid_argument(std::string(name) + " is " + number(value) + ", must be >= 0");
  };
  positive(size, "size");
  positive(growth, "growth");
  for (const Refinement& r : refinements) {
    positive(r.size, "refinement size");
    not_negative(r.radius, "refinement radius");
  }
  for (const LineRefinement& l : lines) {
    positive(l.size, "line refinement size");
    not_negative(l.radius, "line refinement radius");
  }
}

std::vector<double> division(const Point& a, const Point& b, const SizeField& field) {
  const double length = (b - a).norm();
  if (field.refinements.empty() && field.lines.empty()) {
    const int pieces =
        std::isfinite(field.size) ? std::max(1, static_cast<int>(std::ceil(length / field.size - 1e-9))) : 1;
    std::vector<double> t;
    for (int k = 1; k < pieces; ++k) t.push_back(static_cast<double>(k) / pieces);
    return t;
  }
  std::vector<double> knots{0.0};
  sample(a, b, field, 0.0, 1.0, knots);
  std::vector<double> weight{0.0};  // ∫ ds / size up to each knot, trapezoidal rule
  const auto density = [&](double s) { return length / field.at((1.0 - s) * a + s * b); };
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    weight.push_back(weight.back() + (knots[i + 1] - knots[i]) * 0.5 * (density(knots[i]) + density(knots[i + 1])));
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(weight.back() - 1e-9)));
  std::vector<double> t;
  std::size_t i = 0;
  for (int k = 1; k < pieces; ++k) {
    const double target = weight.back() * k / pieces;
    while (weight[i + 1] < target) ++i;
    t.push_back(knots[i] + (knots[i + 1] - knots[i]) * (target - weight[i]) / (weight[i + 1] - weight[i]));
  }
  return t;
}

}  // namespace sunder::mesh
