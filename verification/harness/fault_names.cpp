#include "verification/harness/fault_names.hpp"

#include <fstream>
#include <set>
#include <sstream>

namespace sunder::verification {

std::vector<std::string> fault_names(const std::filesystem::path& folder) {
  const std::string call = "planted_fault(\"";
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::stringstream buffer;
    buffer << stream.rdbuf();
    const std::string text = buffer.str();
    for (auto at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
      const auto begin = at + call.size(), end = text.find('"', begin);
      if (end != std::string::npos) names.insert(text.substr(begin, end - begin));
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace sunder::verification
