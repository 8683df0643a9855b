#include "solver/numerics/bracketed_root.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace sunder::numerics {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The bracket of one search, narrowed by every call.
class Search {
 public:
  Search(RootFunction function, double lower, double upper, const RootOptions& options)
      : function_(function), options_(options) {
    result_.lower = lower;
    result_.upper = upper;
    result_.root = 0.5 * lower + 0.5 * upper;
    result_.residual = result_.residual_lower = result_.residual_upper = nan;
    absolute_tolerance_ = options.absolute_tolerance >= 0.0
                              ? options.absolute_tolerance
                              : std::numeric_limits<double>::epsilon() / 16.0 * (upper - lower);
  }

  /// Calls F, narrows the bracket; true where the search is over.
  bool visit(double x, bool wants_slope = false) {
    last_ = function_(x, wants_slope);
    ++result_.evaluations;
    if (std::isnan(last_.value)) {
      result_.status = RootStatus::not_finite;
      return true;
    }
    if (!std::islessequal(std::abs(result_.residual), std::abs(last_.value))) {  // quiet: not a number before the first
      result_.root = x;
      result_.residual = last_.value;
    }
    if ((last_.value > 0.0) == falling_) {
      result_.lower = x;
      result_.residual_lower = last_.value;
    } else {
      result_.upper = x;
      result_.residual_upper = last_.value;
    }
    if (std::abs(last_.value) <= std::max(last_.floor, options_.residual_tolerance)) {
      result_.root = x;
      result_.residual = last_.value;
      result_.status = RootStatus::residual_within_tolerance;
      return true;
    }
    return narrow_enough() || exhausted();
  }

  /// Calls both bounds; true where the search is over.
  bool visit_bounds(bool wants_slope = false) {
    const double lower = result_.lower, upper = result_.upper;
    if (visit_bound(lower, result_.residual_lower, wants_slope) ||
        visit_bound(upper, result_.residual_upper, wants_slope)) {
      return true;
    }
    if ((result_.residual_lower > 0.0) == (result_.residual_upper > 0.0)) {
      result_.status = RootStatus::no_sign_change;
      return true;
    }
    falling_ = result_.residual_lower > 0.0;
    return narrow_enough();
  }

  /// Of the width of the bracket, as it stands.
  double tolerance() const {
    return options_.relative_tolerance * std::max(std::abs(result_.lower), std::abs(result_.upper)) +
           absolute_tolerance_;
  }
  double middle() const { return 0.5 * result_.lower + 0.5 * result_.upper; }
  double absolute_tolerance() const { return absolute_tolerance_; }
  const Residual& last() const { return last_; }
  BracketedRoot& result() { return result_; }

 private:
  bool visit_bound(double x, double& residual, bool wants_slope) {
    last_ = function_(x, wants_slope);
    ++result_.evaluations;
    residual = last_.value;
    if (std::isnan(last_.value)) {
      result_.status = RootStatus::not_finite;
      return true;
    }
    if (!std::islessequal(std::abs(result_.residual), std::abs(last_.value))) {  // quiet: not a number before the first
      result_.root = x;
      result_.residual = last_.value;
    }
    if (std::abs(last_.value) <= std::max(last_.floor, options_.residual_tolerance)) {
      result_.status = RootStatus::residual_within_tolerance;
      return true;
    }
    return false;
  }

  bool narrow_enough() {
    const double m = middle();
    if (result_.upper - result_.lower <= tolerance() || m <= result_.lower || m >= result_.upper) {
      result_.status = RootStatus::bracket_within_tolerance;
      return true;
    }
    return false;
  }

  bool exhausted() {
    if (result_.evaluations < options_.max_evaluations) return false;
    result_.status = RootStatus::evaluation_limit;
    return true;
  }

  RootFunction function_;
  const RootOptions& options_;
  BracketedRoot result_;
  Residual last_;
  double absolute_tolerance_ = 0.0;
  bool falling_ = true;
};

void bisect(Search& search) {
  while (!search.visit(search.middle())) {
  }
}

/// Interpolate, truncate, project with κ1 = 0.2/(b - a), κ2 = 2, n0 = 4 [Oliveira & Takahashi 2021, Algorithm 1].
void interpolate_truncate_project(Search& search, double relative_tolerance) {
  if (search.visit_bounds()) return;
  BracketedRoot& bracket = search.result();
  const double width0 = bracket.upper - bracket.lower;
  // half the width at which the search stops anyway, so that the promise "bisection plus one" refers to the same goal
  const bool around_zero = bracket.lower < 0.0 && bracket.upper > 0.0;
  const double scale =
      around_zero ? 0.0 : std::min(std::abs(bracket.lower), std::abs(bracket.upper));  // at the root, at least
  const double goal = 0.5 * std::max(search.absolute_tolerance(), relative_tolerance * scale);
  const int halvings = static_cast<int>(std::ceil(std::log2(width0 / (2.0 * goal))));
  constexpr int slack = 4;  // n0
  for (int step = 0;; ++step) {
    const double a = bracket.lower, b = bracket.upper, middle = search.middle();
    const double radius = goal * std::exp2(std::max(0, halvings + slack - step)) - 0.5 * (b - a);
    const double fa = bracket.residual_lower, fb = bracket.residual_upper;
    const double secant = (fb * a - fa * b) / (fb - fa);
    const double side = middle >= secant ? 1.0 : -1.0;
    // at least half the tolerance, or rounding would keep the estimate on one side and the bracket open
    const double truncation = std::max(0.2 / width0 * (b - a) * (b - a), 0.5 * search.tolerance());
    const double truncated = truncation <= std::abs(middle - secant) ? secant + side * truncation : middle;
    double x = std::abs(truncated - middle) <= radius ? truncated : middle - side * std::max(radius, 0.0);
    if (!(x > a && x < b)) x = middle;
    if (search.visit(x)) return;
  }
}

/// Boost's algorithm has 14 calls, enough for a smooth function to round-off; where F jumps it would need up to three
/// times the calls of bisection, which then takes over.
void toms748(Search& search) {
  if (search.visit_bounds()) return;
  namespace math = boost::math;
  using Policy = math::policies::policy<math::policies::evaluation_error<math::policies::errno_on_error>,
                                        math::policies::domain_error<math::policies::errno_on_error>>;
  bool done = false;
  auto function = [&](double x) {
    if (done) return 0.0;  // an exact zero ends Boost's iteration
    done = search.visit(x);
    return done ? 0.0 : search.last().value;
  };
  const auto never = [](double, double) { return false; };
  const BracketedRoot start = search.result();
  std::uintmax_t calls = 14;
  math::tools::toms748_solve(function, start.lower, start.upper, start.residual_lower, start.residual_upper, never,
                             calls, Policy());
  if (!done) bisect(search);
}

/// Newton's steps; a step that leaves the bracket, or a third one in a row that does not halve |F|, is a bisection. A
/// step shorter than the tolerance is doubled until it lands on the other side, so that the bracket closes too.
void newton(Search& search, double guess) {
  if (search.visit_bounds()) return;
  BracketedRoot& bracket = search.result();
  const double a = bracket.lower, b = bracket.upper, fa = bracket.residual_lower, fb = bracket.residual_upper;
  const bool usable = std::isgreater(guess, a) && std::isless(guess, b);  // quiet: no guess is not a number
  double x = usable ? guess : (fb * a - fa * b) / (fb - fa);
  if (!(x > a && x < b)) x = search.middle();
  int slow = 0;
  double before = std::numeric_limits<double>::infinity(), probe = 0.0;
  while (!search.visit(x, true)) {
    const Residual& here = search.last();
    slow = std::abs(here.value) > 0.5 * before ? slow + 1 : 0;
    before = std::abs(here.value);
    double step = -here.value / here.slope;
    const double tolerance = search.tolerance();
    if (std::abs(step) < 0.5 * tolerance) {
      probe = std::max(2.0 * probe, 0.5 * tolerance);
      step = std::copysign(probe, step);
    } else {
      probe = 0.0;
    }
    double next = x + step;
    if (slow >= 3 || !(next > bracket.lower && next < bracket.upper)) {
      next = search.middle();
      if (slow >= 3) slow = 1;
    }
    x = next;
  }
}

}  // namespace

BracketedRoot bracketed_root(RootFunction function, double lower, double upper, const RootOptions& options) {
  Search search(function, std::min(lower, upper), std::max(lower, upper), options);
  if (!std::isfinite(lower) || !std::isfinite(upper)) return search.result();
  switch (options.method) {
    case RootMethod::bisection:
      bisect(search);
      break;
    case RootMethod::itp:
      interpolate_truncate_project(search, options.relative_tolerance);
      break;
    case RootMethod::toms748:
      toms748(search);
      break;
    case RootMethod::newton:
      newton(search, options.guess);
      break;
  }
  return search.result();
}

}  // namespace sunder::numerics
