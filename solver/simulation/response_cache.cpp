#include "solver/simulation/response_cache.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "solver/results/atomic_file.hpp"

namespace sunder::simulation {
namespace {

constexpr std::string_view magic = "sunderRW";
constexpr std::uint64_t version = 1;
constexpr std::uint64_t order_witness = 1;
constexpr std::size_t header_bytes = 48, checksum_bytes = 8;

/// FNV-1a in 64 bits [Fowler, Noll & Vo]; a second start gives a second, independent enough, hash.
std::uint64_t hash(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325ULL) {
  for (const char byte : bytes) start = (start ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  return start;
}

template <class Value>
void append_bytes(std::string& bytes, const Value& value) {
  std::array<char, sizeof(Value)> raw;
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.append(raw.data(), raw.size());
}

std::uint64_t number_at(const std::string& bytes, std::size_t place) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + place, sizeof(value));
  return value;
}

std::string hexadecimal(std::uint64_t value) {
  std::string digits(16, '0');
  for (std::size_t i = 16; i-- > 0; value >>= 4) digits[i] = "0123456789abcdef"[value & 15];
  return digits;
}

std::string header(const CacheKey& key, std::uint64_t size, std::uint64_t count) {
  std::string bytes(magic);
  for (const std::uint64_t value : {order_witness, version, std::uint64_t{key.bytes().size()}, size, count})
    append_bytes(bytes, value);
  return bytes;
}

/// What is wrong with the file's bytes for this key; empty where nothing is.
std::string fault_of(const std::string& bytes, const CacheKey& key) {
  if (bytes.size() < header_bytes + checksum_bytes || bytes.compare(0, magic.size(), magic) != 0)
    return "is not a file of weights";
  if (number_at(bytes, 8) != order_witness) return "was written by a machine of another byte order";
  if (number_at(bytes, 16) != version) return "has another version";
  if (number_at(bytes, bytes.size() - checksum_bytes) !=
      hash(std::string_view(bytes).substr(0, bytes.size() - checksum_bytes)))
    return "is damaged: its checksum does not agree";
  if (number_at(bytes, 24) != key.bytes().size() || bytes.compare(header_bytes, key.bytes().size(), key.bytes()) != 0)
    return "belongs to another domain";
  const std::uint64_t size = number_at(bytes, 32), count = number_at(bytes, 40);
  if (size == 0 || count == 0 ||
      bytes.size() != header_bytes + key.bytes().size() + size * (size + 1) / 2 * count * 8 + checksum_bytes)
    return "has the wrong length";
  return {};
}

}  // namespace

std::string fingerprint(std::string_view bytes) {
  return hexadecimal(hash(bytes)) + hexadecimal(hash(bytes, 0x9e3779b97f4a7c15ULL));
}

void CacheKey::add(double value) {
  append_bytes(bytes_, value);
}

void CacheKey::add(long long value) {
  append_bytes(bytes_, value);
}

void CacheKey::add(const Eigen::Ref<const Eigen::MatrixXd>& values) {
  add(static_cast<long long>(values.rows()));
  add(static_cast<long long>(values.cols()));
  for (const double value : values.reshaped()) add(value);
}

std::string CacheKey::file_name() const {
  return fingerprint(bytes_) + ".weights";
}

CachedWeights read_weights(const std::filesystem::path& folder, const CacheKey& key) {
  const std::filesystem::path file = folder / key.file_name();
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string fault = fault_of(bytes, key);
  if (!fault.empty()) return {.weights = {}, .fault = file.string() + " " + fault};

  const auto size = static_cast<Eigen::Index>(number_at(bytes, 32)),
             count = static_cast<Eigen::Index>(number_at(bytes, 40));
  convolution::WeightSequence weights{static_cast<int>(size), false, Eigen::MatrixXd(size * size, count)};
  const char* at = bytes.data() + header_bytes + key.bytes().size();
  for (Eigen::Index j = 0; j < count; ++j) {
    for (Eigen::Index c = 0; c < size; ++c) {
      for (Eigen::Index r = c; r < size; ++r, at += sizeof(double)) {
        double value = 0.0;
        std::memcpy(&value, at, sizeof(double));
        weights.values(c * size + r, j) = weights.values(r * size + c, j) = value;
      }
    }
  }
  return {.weights = std::move(weights), .fault = {}};
}

std::string write_weights(const std::filesystem::path& folder, const CacheKey& key,
                          const convolution::WeightSequence& weights) {
  const Eigen::Index size = weights.size;
  std::string bytes =
      header(key, static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(weights.values.cols())) + key.bytes();
  bytes.reserve(bytes.size() + static_cast<std::size_t>(size * (size + 1) / 2 * weights.values.cols() * 8) + 8);
  for (Eigen::Index j = 0; j < weights.values.cols(); ++j) {
    for (Eigen::Index c = 0; c < size; ++c) {
      for (Eigen::Index r = c; r < size; ++r) append_bytes(bytes, weights.values(c * size + r, j));
    }
  }
  append_bytes(bytes, hash(bytes));
  try {
    results::write_atomically(folder / key.file_name(), bytes);
  } catch (const std::filesystem::filesystem_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace sunder::simulation
