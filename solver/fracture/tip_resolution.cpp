#include "solver/fracture/tip_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>
#include <stdexcept>

namespace sunder::fracture {
namespace {

constexpr double reserve = 10.0;      // for the unknown factor before ρ^-2p
constexpr double grading = 0.15;      // ratio of neighbouring edges towards a singular corner [Gui & Babuška 1986]
constexpr double corner_power = 1.5;  // 2λ, λ >= 0.75: a held side meeting a free one at a right angle, ν <= 0.3

// A corner's own field reaches K_I twice, through the solution and through what measures it. On the sheared plate
// weights from 0.01 to 1 change K_I by less than 2 % of the tolerance, from 1e-3 to 1e-6; 1 costs twice the unknowns of
// 0.01.
constexpr double corner_weight = 0.03;

/// ln ρ of the Bernstein ellipse of the edge through a point.
double log_radius(const Eigen::Vector2d& first, const Eigen::Vector2d& last, const Eigen::Vector2d& point) {
  const std::complex<double> a(first.x() - point.x(), first.y() - point.y());
  const std::complex<double> b(last.x() - point.x(), last.y() - point.y());
  const std::complex<double> z = (a + b) / (a - b);
  return std::abs(std::log(std::abs(z + std::sqrt(z * z - 1.0))));
}

/// Smallest p with weight · ρ^-2p <= tolerance.
int order_for(double weight, double tolerance, double log_rho) {
  const double p = std::ceil(std::log(weight / tolerance) / (2.0 * log_rho));
  return static_cast<int>(std::clamp(p, 0.0, 1e6));
}

class Divider {
 public:
  Divider(std::span<const Eigen::Vector2d> corners, const ResolutionOptions& options) : options_(options) {
    for (const int corner : options.singular_corners) singular_.push_back(corners[static_cast<std::size_t>(corner)]);
    for (const Eigen::Vector2d& corner : corners) size_ = std::max(size_, corner.norm());
    outline_.vertices.push_back(corners.front());
  }

  void add(const Eigen::Vector2d& first, const Eigen::Vector2d& last) {
    const bool at_first = is_singular(first), at_last = is_singular(last);
    const double length = (last - first).norm();
    if (at_first && at_last) {
      split(first, last, 0.5);
    } else if ((at_first || at_last) && corner_share(length) > options_.tolerance) {
      split(first, last, at_first ? grading : 1.0 - grading);
    } else {
      const int order = order_of(first, last);
      if (order > options_.largest_order) {
        split(first, last, 0.5);
      } else {
        outline_.vertices.push_back(last);
        outline_.orders.push_back(order);
      }
    }
  }

  ResolvedOutline outline() && { return std::move(outline_); }

 private:
  /// What a corner's field within `distance` weighs in K_I.
  double corner_share(double distance) const { return corner_weight * std::pow(distance / size_, corner_power); }

  bool is_singular(const Eigen::Vector2d& point) const {
    return std::any_of(singular_.begin(), singular_.end(), [&](const Eigen::Vector2d& s) { return s == point; });
  }

  void split(const Eigen::Vector2d& first, const Eigen::Vector2d& last, double fraction) {
    const Eigen::Vector2d middle = first + fraction * (last - first);
    add(first, middle);
    add(middle, last);
  }

  int order_of(const Eigen::Vector2d& first, const Eigen::Vector2d& last) const {
    int order = tip_edge_order(first, last, options_.tolerance);
    for (const Eigen::Vector2d& corner : singular_) {
      if (corner == first || corner == last) continue;
      const double farthest = std::max((first - corner).norm(), (last - corner).norm());
      order = std::max(order, order_for(corner_share(farthest), options_.tolerance, log_radius(first, last, corner)));
    }
    return order;
  }

  const ResolutionOptions& options_;
  std::vector<Eigen::Vector2d> singular_;
  double size_ = 0.0;
  ResolvedOutline outline_;
};

void check_tolerance(double tolerance) {
  if (!(tolerance >= 1e-12 && tolerance <= 0.1)) {
    std::ostringstream message;
    message << "tolerance = " << tolerance << ", accepted is 1e-12 <= tolerance <= 0.1";
    throw std::invalid_argument(message.str());
  }
}

}  // namespace

int tip_edge_order(const Eigen::Vector2d& first, const Eigen::Vector2d& last, double tolerance) {
  check_tolerance(tolerance);
  return std::max(2, 1 + order_for(reserve, tolerance, log_radius(first, last, Eigen::Vector2d::Zero())));
}

ResolvedOutline resolve_outline(std::span<const Eigen::Vector2d> corners, const ResolutionOptions& options) {
  check_tolerance(options.tolerance);
  if (options.largest_order < 2 || options.largest_order > 64) {
    throw std::invalid_argument("largest_order = " + std::to_string(options.largest_order) +
                                ", accepted is 2 <= largest_order <= 64");
  }
  if (corners.size() < 2) throw std::invalid_argument("resolve_outline: accepted is two corners or more");
  for (const int corner : options.singular_corners) {
    if (corner < 0 || static_cast<std::size_t>(corner) >= corners.size()) {
      throw std::invalid_argument("singular_corners: " + std::to_string(corner) + " is not a corner");
    }
  }
  Divider divider(corners, options);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) divider.add(corners[i], corners[i + 1]);
  return std::move(divider).outline();
}

}  // namespace sunder::fracture
