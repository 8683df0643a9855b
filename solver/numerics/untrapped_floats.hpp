#pragma once
/// Where floating-point traps are set, a library that was not written for them is let off.

#include <cfenv>

namespace sunder::numerics {

/// While it lives, this thread does not trap; then it does what it did before. Without traps it changes nothing.
class UntrappedFloats {
 public:
  UntrappedFloats() : trapped_(fegetexcept()) {
    if (trapped_ > 0) fedisableexcept(trapped_);
  }
  ~UntrappedFloats() {
    if (trapped_ <= 0) return;
    std::feclearexcept(FE_ALL_EXCEPT);  // what was raised meanwhile would trap at once
    feenableexcept(trapped_);
  }
  UntrappedFloats(const UntrappedFloats&) = delete;
  UntrappedFloats& operator=(const UntrappedFloats&) = delete;

 private:
  int trapped_;
};

}  // namespace sunder::numerics
