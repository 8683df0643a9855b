#pragma once
/// An HDF5 file of tables that grow row by row. Private to this module, and with its source the one place that knows
/// HDF5. Rows go to the disk chunk by chunk: what is held in memory is one chunk a table.

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "solver/results/atomic_file.hpp"

namespace sunder::results {

/// An HDF5 object with the function that closes it.
class Hdf5Object {
 public:
  Hdf5Object() = default;
  Hdf5Object(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  Hdf5Object(Hdf5Object&& other) noexcept { *this = std::move(other); }
  Hdf5Object& operator=(Hdf5Object&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Object() { static_cast<void>(close()); }

  operator hid_t() const { return id_; }
  herr_t close() { return id_ < 0 ? 0 : close_(std::exchange(id_, H5I_INVALID_HID)); }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

/// Every member throws std::filesystem::filesystem_error with the system's reason where the file cannot be written. The
/// bytes depend on what is written alone.
///
/// HDF5 1.10 does not survive a full disk: it crashes when it closes the file. So disk is reserved before each write,
/// for the most that it can come to, and what was not needed is given back in the end.
class Hdf5File {
 public:
  explicit Hdf5File(AtomicFile& file);  ///< outlives this; nothing else writes to it
  ~Hdf5File();                          ///< closes; without `close()` the content is lost
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void make_group(const std::string& path);

  /// Attributes of a group, replaced where they exist: a text of fixed length in ASCII, one number, a pair.
  void set(const std::string& group, const char* name, std::string_view text);
  void set(const std::string& group, const char* name, std::int64_t number);
  void set(const std::string& group, const char* name, std::array<std::int64_t, 2> pair);

  /// Appends `values`, `components` >= 1 a row, to the table at `path`, which is made where there is none: (rows) with
  /// one component, (rows, components) with several. Chunks are as long as the first append, and of 32 rows at least
  /// where that is a single row.
  void append(const std::string& path, std::span<const double> values, int components = 1);
  void append(const std::string& path, std::span<const std::int64_t> values, int components = 1);
  void append(const std::string& path, std::span<const std::uint8_t> values, int components = 1);

  void close();  ///< once, and nothing is written after it

 private:
  struct Type {
    hid_t stored, memory;
    hsize_t bytes;
  };
  void check(long long status) const;
  void set(const std::string& group, const char* name, Type type, std::span<const hsize_t> shape, const void* values);
  void append(const std::string& path, Type type, const void* values, hsize_t rows, hsize_t components);
  void reserve(std::uint64_t bytes);
  hid_t table(const std::string& path, Type type, hsize_t rows, hsize_t components);

  AtomicFile* disk_;
  Hdf5Object file_;
  std::map<std::string, Hdf5Object> tables_;
  std::uint64_t in_memory_ = 0, reserved_ = 0;  // bytes: at most, of chunks not on the disk yet; on the disk
};

}  // namespace sunder::results
