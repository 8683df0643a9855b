#include "solver/results/hdf5_file.hpp"

#include <algorithm>
#include <filesystem>

namespace sunder::results {
namespace {

namespace fs = std::filesystem;

constexpr hsize_t largest_chunk_bytes = 256 * 1024;  // also what is held of a table in memory
constexpr hsize_t rows_of_short_chunk = 32;          // of tables that get one row at a time
constexpr std::uint64_t bookkeeping = 16 * 1024;     // of HDF5 itself, for one table or group and one append
constexpr std::uint64_t reserve_step = 1024 * 1024;  // so that not every append has to ask the system

/// HDF5 prints its errors by itself; here they become exceptions. One of these lives in every member that calls it.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

herr_t keep_description(unsigned /*depth*/, const H5E_error2_t* error, void* text) {
  if (error->desc != nullptr && *error->desc != '\0') *static_cast<std::string*>(text) = error->desc;
  return 0;
}

/// What the innermost function that failed has to say; the system's own words where it was the system.
std::string reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &text);
  constexpr std::string_view marker = "error message = '";
  const std::size_t at = text.find(marker);
  if (at == std::string::npos) return text;
  const std::size_t start = at + marker.size();
  return text.substr(start, text.find('\'', start) - start);
}

}  // namespace

Hdf5File::Hdf5File(AtomicFile& file) : disk_(&file) {
  const Quiet quiet;
  file_ = Hdf5Object(H5Fcreate(file.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  check(file_);
  reserve(0);
}

Hdf5File::~Hdf5File() {
  const Quiet quiet;
  tables_.clear();
  static_cast<void>(file_.close());
}

void Hdf5File::check(long long status) const {
  if (status >= 0) return;
  throw fs::filesystem_error("cannot write fields: " + reason(), disk_->path(),
                             std::make_error_code(std::errc::io_error));
}

/// For `bytes` more, beside what is in the file and what waits in memory.
void Hdf5File::reserve(std::uint64_t bytes) {
  hsize_t size = 0;
  check(H5Fget_filesize(file_, &size));
  const std::uint64_t needed = size + in_memory_ + bytes + bytes / 100 + bookkeeping * (tables_.size() + 4);
  if (needed <= reserved_) return;
  disk_->reserve(needed + reserve_step);
  reserved_ = needed + reserve_step;
}

void Hdf5File::make_group(const std::string& path) {
  const Quiet quiet;
  const Hdf5Object made(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  check(made);
}

void Hdf5File::set(const std::string& group, const char* name, Type type, std::span<const hsize_t> shape,
                   const void* values) {
  if (H5Aexists_by_name(file_, group.c_str(), name, H5P_DEFAULT) > 0) {
    check(H5Adelete_by_name(file_, group.c_str(), name, H5P_DEFAULT));
  }
  const Hdf5Object space(
      shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
      H5Sclose);
  Hdf5Object made(
      H5Acreate_by_name(file_, group.c_str(), name, type.stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  check(made);
  check(H5Awrite(made, type.memory, values));
  check(made.close());
}

void Hdf5File::set(const std::string& group, const char* name, std::string_view text) {
  const Quiet quiet;
  const Hdf5Object type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, text.size()));
  check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  set(group, name, {type, type, text.size()}, {}, text.data());
}

void Hdf5File::set(const std::string& group, const char* name, std::int64_t number) {
  const Quiet quiet;
  set(group, name, {H5T_STD_I64LE, H5T_NATIVE_INT64, 8}, {}, &number);
}

void Hdf5File::set(const std::string& group, const char* name, std::array<std::int64_t, 2> pair) {
  const Quiet quiet;
  set(group, name, {H5T_STD_I64LE, H5T_NATIVE_INT64, 8}, std::array<hsize_t, 1>{2}, pair.data());
}

hid_t Hdf5File::table(const std::string& path, Type type, hsize_t rows, hsize_t components) {
  const auto known = tables_.find(path);
  if (known != tables_.end()) return known->second;
  const int rank = components == 1 ? 1 : 2;
  const hsize_t shape[] = {0, components}, limit[] = {H5S_UNLIMITED, components};
  const hsize_t most_rows = std::max<hsize_t>(1, largest_chunk_bytes / (type.bytes * components));
  const hsize_t chunk[] = {std::min(rows > 1 ? rows : rows_of_short_chunk, most_rows), components};
  const Hdf5Object space(H5Screate_simple(rank, shape, limit), H5Sclose);
  const Hdf5Object creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  // Not compressed: shuffled and deflated at level 1, a snapshot of a dam (benchmarks/results_benchmark.cpp) takes 0.38
  // of the disk and 1.8 ms of CPU time instead of 0.3 ms, as much as a whole step may cost.
  check(H5Pset_chunk(creation, rank, chunk));
  check(H5Pset_obj_track_times(creation, false));  // the same bytes each time
  check(H5Pset_chunk_cache(access, 11, chunk[0] * components * type.bytes, 1.0));
  Hdf5Object made(H5Dcreate2(file_, path.c_str(), type.stored, space, H5P_DEFAULT, creation, access), H5Dclose);
  check(made);
  in_memory_ += chunk[0] * components * type.bytes;
  return tables_.emplace(path, std::move(made)).first->second;
}

void Hdf5File::append(const std::string& path, Type type, const void* values, hsize_t rows, hsize_t components) {
  const Quiet quiet;
  reserve(rows * components * type.bytes);
  const hid_t data = table(path, type, rows, components);
  hsize_t shape[2] = {};
  {
    const Hdf5Object before(H5Dget_space(data), H5Sclose);
    check(H5Sget_simple_extent_dims(before, shape, nullptr));
  }
  const hsize_t start[] = {shape[0], 0}, block[] = {rows, components};
  shape[0] += rows;
  check(H5Dset_extent(data, shape));
  if (rows == 0) return;
  const Hdf5Object space(H5Dget_space(data), H5Sclose);
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, block, nullptr));
  const Hdf5Object memory(H5Screate_simple(components == 1 ? 1 : 2, block, nullptr), H5Sclose);
  check(H5Dwrite(data, type.memory, memory, space, H5P_DEFAULT, values));
}

void Hdf5File::append(const std::string& path, std::span<const double> values, int components) {
  const auto width = static_cast<hsize_t>(components);
  append(path, {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 8}, values.data(), values.size() / width, width);
}

void Hdf5File::append(const std::string& path, std::span<const std::int64_t> values, int components) {
  const auto width = static_cast<hsize_t>(components);
  append(path, {H5T_STD_I64LE, H5T_NATIVE_INT64, 8}, values.data(), values.size() / width, width);
}

void Hdf5File::append(const std::string& path, std::span<const std::uint8_t> values, int components) {
  const auto width = static_cast<hsize_t>(components);
  append(path, {H5T_STD_U8LE, H5T_NATIVE_UINT8, 1}, values.data(), values.size() / width, width);
}

void Hdf5File::close() {
  const Quiet quiet;
  for (auto& [path, table] : tables_) check(table.close());
  tables_.clear();
  check(H5Fflush(file_, H5F_SCOPE_GLOBAL));
  hsize_t size = 0;
  check(H5Fget_filesize(file_, &size));
  check(file_.close());
  disk_->resize(size);
}

}  // namespace sunder::results
