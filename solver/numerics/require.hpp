#pragma once
/// Refusal of arguments out of range: std::invalid_argument with the name, the value and the bound.

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sunder::numerics {

[[noreturn]] inline void refuse(std::string_view name, double value, std::string_view bound) {
  std::ostringstream text;
  text.precision(17);
  text << name << " = " << value << " must be " << bound;
  throw std::invalid_argument(text.str());
}

inline void require_positive(std::string_view name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) refuse(name, value, "finite and > 0");
}

inline void require_not_negative(std::string_view name, double value) {
  if (!(value >= 0.0 && std::isfinite(value))) refuse(name, value, "finite and >= 0");
}

inline void require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) refuse(name, value, "finite");
}

}  // namespace sunder::numerics
