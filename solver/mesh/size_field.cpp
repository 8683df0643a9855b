#include "solver/mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/mesh/mesh_error.hpp"
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

/// Calls add(s1, part) for successive pieces of the segment, on each of which the size changes by a tenth at most; part
/// is ∫ ds / size over the piece, by the trapezoidal rule.
template <class Function>
void integrate(const Point& a, const Point& b, const SizeField& field, double s0, double s1, const Function& add) {
  const double length = (b - a).norm() * (s1 - s0), middle = 0.5 * (s0 + s1);
  const auto at = [&](double s) -> Point { return (1.0 - s) * a + s * b; };
  const Point centre = at(middle);
  if (field.at(centre, 0.5 * length) > 1.1 * field.at(centre, -0.5 * length) && s0 < middle && middle < s1) {
    integrate(a, b, field, s0, middle, add);
    integrate(a, b, field, middle, s1, add);
  } else {
    add(s1, 0.5 * length * (1.0 / field.at(at(s0)) + 1.0 / field.at(at(s1))));
  }
}

}  // namespace

double SizeField::at(const Point& x, double reach) const {
  double least = size;
  for (const Refinement& r : refinements) {
    least = std::min(least, r.size + growth * std::max(0.0, (x - r.centre).norm() + reach - r.radius));
  }
  for (const LineRefinement& l : lines) {
    least = std::min(least, l.size + growth * std::max(0.0, distance_to_path(x, l.path) + reach - l.radius));
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

SizeField scaled(SizeField field, double factor) {
  field.size *= factor;
  for (Refinement& r : field.refinements) r.size *= factor;
  for (LineRefinement& l : field.lines) l.size *= factor;
  return field;
}

double pieces(const Point& a, const Point& b, const SizeField& field) {
  double sum = 0.0;
  integrate(a, b, field, 0.0, 1.0, [&](double, double part) { sum += part; });
  return sum;
}

std::vector<double> division(const Point& a, const Point& b, const SizeField& field) {
  std::vector<double> knots{0.0}, weight{0.0};  // ∫ ds / size up to each knot
  integrate(a, b, field, 0.0, 1.0, [&](double s, double part) {
    knots.push_back(s);
    weight.push_back(weight.back() + part);
  });
  // The equations of a polygon are dense: an edge of so many pieces alone would take gigabytes.
  constexpr double most_pieces = 10'000.0;
  if (!(weight.back() <= most_pieces)) {
    throw MeshError("the edge from " + place(a) + " to " + place(b) + " would be divided into " +
                    number(weight.back()) + " pieces; accepted: at most 10000, a larger size of the edges");
  }
  const int count = std::max(1, static_cast<int>(std::ceil(weight.back() - 1e-9)));
  std::vector<double> t;
  std::size_t i = 0;
  for (int k = 1; k < count; ++k) {
    const double target = weight.back() * k / count;
    while (i + 2 < weight.size() && weight[i + 1] < target) ++i;
    t.push_back(knots[i] + (knots[i + 1] - knots[i]) * (target - weight[i]) / (weight[i + 1] - weight[i]));
  }
  return t;
}

}  // namespace sunder::mesh
