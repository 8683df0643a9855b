#pragma once
/// The root of a monotone function between two bounds that are known to enclose it, by a method of choice.
///
/// All methods keep a bracket, so none can leave it; they differ in how many calls they need: bisection 53 to
/// round-off, the others about 10 on a smooth function and bisection's number where the function jumps across zero.
///
/// A search ends with the first of
///   1. |F(x)| ≤ floor(x), the round-off of F as the function itself reports it;
///   2. |F(x)| ≤ residual_tolerance;
///   3. upper - lower ≤ relative_tolerance · max(|lower|, |upper|) + absolute_tolerance, or no number left between
///   them;
///   4. max_evaluations calls.
/// F that jumps across zero ends at 3 with both ends of the bracket and their residuals: the caller decides what it
/// means.

#include <concepts>
#include <limits>
#include <memory>
#include <type_traits>

namespace sunder::numerics {

enum class RootMethod {
  bisection,
  itp,      ///< interpolate, truncate, project: never more calls than bisection plus six [Oliveira & Takahashi 2021]
  toms748,  ///< inverse cubic interpolation [Alefeld, Potra & Shi 1995], from Boost.Math
  newton,   ///< Newton steps inside the bracket, halved where they do not converge; the only one that asks for slopes
};

/// What the function says at one point.
struct Residual {
  double value = 0.0;
  double slope = std::numeric_limits<double>::quiet_NaN();  ///< dF/dx; only where it was asked for
  double floor = 0.0;                                       ///< |value| below this is round-off, >= 0
};

/// Refers to a callable `Residual (double x, bool wants_slope)` that lives longer than the search.
class RootFunction {
 public:
  template <class Callable>
  requires(!std::same_as<std::remove_cv_t<Callable>, RootFunction>) explicit RootFunction(Callable& callable)
      : object_(std::addressof(callable)), call_([](void* object, double x, bool wants_slope) -> Residual {
          return (*static_cast<Callable*>(object))(x, wants_slope);
        }) {}
  Residual operator()(double x, bool wants_slope) const { return call_(object_, x, wants_slope); }

 private:
  void* object_;
  Residual (*call_)(void*, double, bool);
};

struct RootOptions {
  RootMethod method = RootMethod::newton;
  double residual_tolerance = 0.0;                                           ///< of |F|
  double relative_tolerance = 2.0 * std::numeric_limits<double>::epsilon();  ///< of the bracket
  double absolute_tolerance = -1.0;  ///< of the bracket; negative: ε/16 of the first bracket, for a root that is zero
  int max_evaluations = 400;
  double guess = std::numeric_limits<double>::quiet_NaN();  ///< where Newton begins; NaN: a secant of the ends
};

enum class RootStatus {
  residual_within_tolerance,
  bracket_within_tolerance,
  evaluation_limit,
  no_sign_change,  ///< F has the same sign at both bounds: `root` is the bound with the smaller |F|
  not_finite,      ///< F or a bound is NaN, or a bound is infinite
};

struct BracketedRoot {
  double root = 0.0;      ///< the point with the smallest |F| met
  double residual = 0.0;  ///< F there
  double lower = 0.0, upper = 0.0;
  double residual_lower = 0.0, residual_upper = 0.0;  ///< NaN where bisection never called that bound
  int evaluations = 0;
  RootStatus status = RootStatus::not_finite;
};

/// Bisection trusts the caller that the bounds enclose the root of a non-increasing F (as the physical brackets do) and
/// does not call them; the other methods call both, accept either direction and report `no_sign_change`.
[[nodiscard]] BracketedRoot bracketed_root(RootFunction function, double lower, double upper,
                                           const RootOptions& options);

}  // namespace sunder::numerics
