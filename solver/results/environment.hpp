#pragma once
/// With what a result was made: enough to make it again, nothing about whose machine it was.

#include <string>

namespace sunder::results {

struct Environment {
  std::string version;   ///< of Sunder
  std::string compiler;  ///< name and version
  std::string flags;     ///< that decide about the numbers; no paths
};

[[nodiscard]] Environment environment();

}  // namespace sunder::results
