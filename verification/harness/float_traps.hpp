#pragma once
/// Floating-point traps: what makes a NaN or an infinity ends the program where it happens.

namespace sunder::verification {

/// While it lives, an invalid operation, a division by zero or an overflow in this thread, or in one that it starts,
/// raises SIGFPE after a line on standard error that names which. Compilers must not invent operations for that:
/// meaningful with -ftrapping-math, gcc's default. Foreign libraries are let off by
/// numerics::UntrappedFloats.
class FloatTraps {
 public:
  explicit FloatTraps(bool set);
  ~FloatTraps();
  FloatTraps(const FloatTraps&) = delete;
  FloatTraps& operator=(const FloatTraps&) = delete;

 private:
  bool set_;
};

}  // namespace sunder::verification
