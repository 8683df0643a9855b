#include "solver/mesh/words.hpp"

#include <array>
#include <cstdio>

namespace sunder::mesh {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::string place(const Point& p) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "(%.10g, %.10g)", p.x(), p.y());
  return text.data();
}

}  // namespace sunder::mesh
