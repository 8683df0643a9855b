#pragma once
/// A file that appears under its name whole or not at all, however the program ends.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sunder::results {

/// Writes beside the final place under a temporary name (".<name>.XXXXXX"), and moves it there in `commit()` once the
/// bytes are on the disk. Without `commit()` the temporary file is removed; a killed program may leave it, never the
/// final name. Every member throws std::filesystem::filesystem_error where the system refuses, naming the path.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path file);  ///< the folder must exist
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const { return file_; }  ///< the final name
  void write(std::string_view bytes);

  /// For a library that writes files itself: the name under which the bytes gather until `commit()`, disk for the first
  /// `bytes` of them so that writing there cannot fail for want of it (where the file system can promise that), and in
  /// the end the size.
  const std::string& temporary() const { return temporary_; }
  void reserve(std::uint64_t bytes);
  void resize(std::uint64_t bytes);

  void commit();  ///< once, and nothing is written after it

 private:
  std::filesystem::path file_;
  std::string temporary_;
  int descriptor_ = -1;
};

/// The whole content at once. Makes the folder where it does not exist.
void write_atomically(const std::filesystem::path& file, std::string_view content);

}  // namespace sunder::results
