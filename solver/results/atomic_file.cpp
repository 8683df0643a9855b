#include "solver/results/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace sunder::results {
namespace {

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

[[noreturn]] void refuse(const char* what, const std::filesystem::path& file) {
  throw std::filesystem::filesystem_error(what, file, std::error_code(errno, std::generic_category()));
}

/// The rename itself must outlive a power cut: the folder is flushed too. A file system that cannot do so is not an
/// error.
void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path file) : file_(std::move(file)) {
  temporary_ = (folder_of(file_) / ("." + file_.filename().string() + ".XXXXXX")).string();
  descriptor_ = ::mkostemp(temporary_.data(), O_CLOEXEC);
  if (descriptor_ < 0) refuse("cannot write beside", file_);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) refuse("cannot write", file_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::reserve(std::uint64_t bytes) {
  errno = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes));
  if (errno != 0 && errno != EOPNOTSUPP && errno != EINVAL) refuse("cannot write", file_);
}

void AtomicFile::resize(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) refuse("cannot write", file_);
}

void AtomicFile::commit() {
  // mkostemp makes files that only their owner may read; a result is as readable as any other file of this user.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor_, 0666 & ~mask) != 0 || ::fsync(descriptor_) != 0) refuse("cannot write", file_);
  if (::rename(temporary_.c_str(), file_.c_str()) != 0) refuse("cannot replace", file_);
  ::close(descriptor_);
  descriptor_ = -1;
  flush_folder(folder_of(file_));
}

void write_atomically(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::create_directories(folder_of(file));
  AtomicFile atomic(file);
  atomic.write(content);
  atomic.commit();
}

}  // namespace sunder::results
