#pragma once
/// The bytes of one try as a file, for readers that take a path. The file goes with the program.

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace sunder::fuzz {

class InputFile {
 public:
  /// `name` decides how readers that look at the ending take the bytes.
  explicit InputFile(const std::string& name) {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("sunder-fuzz-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    path_ = folder_ / name;
    std::filesystem::create_directories(path_.parent_path());
  }
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& write(std::span<const std::uint8_t> bytes) const {
    std::ofstream stream(path_, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path_;
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace sunder::fuzz
