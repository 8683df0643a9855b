#pragma once
/// The functions of numbers that formulas in case files may call: elementary ones, and the answers of
/// verification/exact.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::verification {

struct NumberFunction {
  std::string name;
  std::size_t arguments;
  double (*call)(std::span<const double>);
};

/// nullptr where there is none of this name and number of arguments.
const NumberFunction* find_number_function(std::string_view name, std::size_t arguments);

const std::vector<NumberFunction>& number_functions();

}  // namespace sunder::verification
