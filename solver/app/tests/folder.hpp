#pragma once
/// A folder of its own for each test, and what a test finds in it.

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace sunder::app {

class TestFolder {
 public:
  TestFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sunder-app-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      found.push_back(entry.path().lexically_relative(path_).string());
    return found;
  }

 private:
  std::filesystem::path path_;
};

inline constexpr const char* block_scene = R"(name = "block"
analysis = "static"
[geometry]
outline = [[0, 0], [2, 0], [2, 3], [0, 3]]
boundaries = { base = [0], crest = [2] }
[mesh]
size = 0.5
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
[[support]]
boundary = "base"
fix = ["x", "y"]
[[load]]
boundary = "crest"
traction = [0, 1e6]
)";

}  // namespace sunder::app
