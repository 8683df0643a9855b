#pragma once
/// Four numbers that are calculated with as one: the same dense kernel solves four small problems at a time.
///
/// A kernel is written once as a template on its scalar; with `Lanes` it runs on one AVX2 register a value (GCC's
/// vector extension, split by the compiler on narrower machines). A lane never sees its neighbours: NaN stays in its
/// lane, and a lane's result has the same bits whatever the other lanes hold. Decisions are numbers, 1 for yes and 0
/// for no.

#include <cmath>

namespace sunder::numerics {

struct Lanes {
  static constexpr int count = 4;
  using Vector = double __attribute__((vector_size(32)));
  Vector v;

  Lanes() = default;
  Lanes(Vector values) : v(values) {}
  Lanes(double value) : v{value, value, value, value} {}

  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double value) { v[lane] = value; }

  Lanes& operator+=(Lanes b) { return v += b.v, *this; }
  Lanes& operator-=(Lanes b) { return v -= b.v, *this; }
  Lanes& operator*=(Lanes b) { return v *= b.v, *this; }
  friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  friend Lanes operator-(Lanes a) { return -a.v; }
};

inline Lanes square_root(Lanes a) {
  return Lanes::Vector{std::sqrt(a.v[0]), std::sqrt(a.v[1]), std::sqrt(a.v[2]), std::sqrt(a.v[3])};
}
/// `yes` where flag != 0, otherwise `no`; what is not chosen may be NaN.
inline Lanes choose(Lanes flag, Lanes yes, Lanes no) {
  return flag.v != 0.0 ? yes.v : no.v;
}
/// 1 where a > b, 0 elsewhere and where either is NaN.
inline Lanes greater(Lanes a, Lanes b) {
  return a.v > b.v ? Lanes(1.0).v : Lanes(0.0).v;
}
inline bool any(Lanes flag) {
  return flag.v[0] != 0.0 || flag.v[1] != 0.0 || flag.v[2] != 0.0 || flag.v[3] != 0.0;
}

inline double square_root(double a) {
  return std::sqrt(a);
}
inline double choose(double flag, double yes, double no) {
  return flag != 0.0 ? yes : no;
}
inline double greater(double a, double b) {
  return a > b ? 1.0 : 0.0;
}
inline bool any(double flag) {
  return flag != 0.0;
}

}  // namespace sunder::numerics
