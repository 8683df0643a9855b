#pragma once
/// The one exception of this module: a mesh or an outline that cannot be used.

#include <stdexcept>
#include <string>

namespace sunder::mesh {

/// what() names the polygon or vertex with its coordinates, or the file and line, and says what is accepted.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sunder::mesh
