#pragma once
/// The one exception of this module: a scene that cannot be used.

#include <stdexcept>
#include <string>

namespace sunder::scene {

/// what() holds one finding a line, each `file:line:column: key: what is wrong, what is accepted`.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sunder::scene
