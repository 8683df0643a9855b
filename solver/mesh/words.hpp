#pragma once
/// Numbers and places as they stand in messages.

#include <string>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

std::string number(double value);   ///< ten digits
std::string place(const Point& p);  ///< "(x, y)"

}  // namespace sunder::mesh
