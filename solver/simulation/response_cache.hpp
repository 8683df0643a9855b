#pragma once
/// The weights of an unbounded domain on disk: computed once, read by every later run that asks for the same.
///
/// A file is named by a hash of everything the weights depend on, and holds all of that again, so that two keys with
/// one hash are told apart. Layout, in the machine's byte order: "sunderRW", the number 1 as the order's witness, the
/// format's version, the key's length, n, N + 1 (six of 8 bytes), the key, the lower triangles of W_0 … W_N, and a
/// checksum of all that stands before it. Written whole or not at all (atomic_file.hpp).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "solver/convolution/weight_sequence.hpp"

namespace sunder::simulation {

/// 32 hexadecimal digits for bytes: two hashes of them.
[[nodiscard]] std::string fingerprint(std::string_view bytes);

/// Gathers the bytes of a key, each value to its last bit.
class CacheKey {
 public:
  explicit CacheKey(std::string_view what) : bytes_(what) {}
  void add(double value);
  void add(long long value);
  void add(const Eigen::Ref<const Eigen::MatrixXd>& values);

  const std::string& bytes() const { return bytes_; }
  std::string file_name() const;  ///< fingerprint and ".weights"

 private:
  std::string bytes_;
};

struct CachedWeights {
  std::optional<convolution::WeightSequence> weights;  ///< absent where there is no sound file for the key
  std::string fault;  ///< what is wrong with the file, where there is one that cannot be used; else empty
};

/// Never throws for what a file holds.
[[nodiscard]] CachedWeights read_weights(const std::filesystem::path& folder, const CacheKey& key);

/// Makes the folder where it does not exist. Dense weights. Returns what went wrong, or nothing: a cache that cannot be
/// written is no reason to lose a run.
[[nodiscard]] std::string write_weights(const std::filesystem::path& folder, const CacheKey& key,
                                        const convolution::WeightSequence& weights);

}  // namespace sunder::simulation
