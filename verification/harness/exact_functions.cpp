#include "verification/harness/exact_functions.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::verification {

const std::vector<NumberFunction>& number_functions() {
  using Numbers = std::span<const double>;
  static const std::vector<NumberFunction> all{
      {"sqrt", 1, [](Numbers x) { return std::sqrt(x[0]); }},
      {"abs", 1, [](Numbers x) { return std::abs(x[0]); }},
      {"sin", 1, [](Numbers x) { return std::sin(x[0]); }},
      {"cos", 1, [](Numbers x) { return std::cos(x[0]); }},
      {"tan", 1, [](Numbers x) { return std::tan(x[0]); }},
      {"atan", 1, [](Numbers x) { return std::atan(x[0]); }},
      {"atan2", 2, [](Numbers x) { return std::atan2(x[0], x[1]); }},
      {"exp", 1, [](Numbers x) { return std::exp(x[0]); }},
      {"log", 1, [](Numbers x) { return std::log(x[0]); }},
      {"log10", 1, [](Numbers x) { return std::log10(x[0]); }},
      {"hypot", 2, [](Numbers x) { return std::hypot(x[0], x[1]); }},
      {"min", 2, [](Numbers x) { return std::min(x[0], x[1]); }},
      {"max", 2, [](Numbers x) { return std::max(x[0], x[1]); }},
  };
  return all;
}

const NumberFunction* find_number_function(std::string_view name, std::size_t arguments) {
  for (const NumberFunction& function : number_functions())
    if (function.name == name && function.arguments == arguments) return &function;
  return nullptr;
}

}  // namespace sunder::verification
