#include "solver/simulation/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>

#include "solver/results/atomic_file.hpp"
#include "solver/simulation/response_cache.hpp"

namespace sunder::simulation {
namespace {

constexpr std::string_view magic = "sunderCP";
constexpr std::uint64_t version = 1, order_witness = 1;
constexpr std::size_t name_letters = 32, head = 24 + name_letters;

template <class Value>
void put(std::string& bytes, const Value& value) {
  std::array<char, sizeof(Value)> raw;
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.append(raw.data(), raw.size());
}

void put_all(std::string& bytes, std::span<const double> values) {
  put(bytes, std::uint64_t{values.size()});
  for (const double value : values) put(bytes, value);
}

std::span<const double> all_of(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Takes values from the front; more than is left gives zeros and `short_of`.
class Taker {
 public:
  explicit Taker(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  Value take() {
    Value value{};
    if (bytes_.size() < sizeof(Value)) {
      short_of_ = true;
      return value;
    }
    std::memcpy(&value, bytes_.data(), sizeof(Value));
    bytes_.remove_prefix(sizeof(Value));
    return value;
  }
  std::vector<double> take_all() {
    const auto count = take<std::uint64_t>();
    if (count > bytes_.size() / sizeof(double)) short_of_ = true;
    std::vector<double> values;
    for (std::uint64_t i = 0; !short_of_ && i < count; ++i) values.push_back(take<double>());
    return values;
  }
  Eigen::VectorXd take_vector() {
    const std::vector<double> values = take_all();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
  }
  bool whole() const { return !short_of_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool short_of_ = false;
};

std::string head_of(const std::string& identity) {
  std::string bytes(magic);
  put(bytes, order_witness);
  put(bytes, version);
  return bytes + identity;
}

}  // namespace

std::string run_identity(const StepEquations& equations, const Eigen::VectorXd& dead_load,
                         const Eigen::MatrixXd& load_samples) {
  CacheKey key("run");
  const auto& [scheme, time_step, damping] = equations.options();
  for (const double value :
       {scheme.alpha_m, scheme.alpha_f, scheme.beta, scheme.gamma, time_step, damping.of_mass, damping.of_stiffness})
    key.add(value);
  for (const Eigen::SparseMatrix<double>* matrix : {&equations.stiffness(), &equations.mass()})
    key.add(Eigen::VectorXd::Map(matrix->valuePtr(), matrix->nonZeros()));
  key.add(dead_load);
  key.add(load_samples);
  for (const AttachedMedium* medium : equations.media()) key.add(medium->convolution->instantaneous_mass());
  return fingerprint(key.bytes());
}

std::filesystem::path checkpoint_file(const std::filesystem::path& folder) {
  return folder / "checkpoint.bin";
}

void write_checkpoint(const std::filesystem::path& folder, const std::string& identity, const Checkpoint& checkpoint) {
  std::string bytes = head_of(identity);
  put(bytes, static_cast<std::int64_t>(checkpoint.number));
  for (const Eigen::VectorXd* values :
       {&checkpoint.state.displacement, &checkpoint.state.velocity, &checkpoint.state.acceleration})
    put_all(bytes, all_of(*values));
  put(bytes, std::uint64_t{checkpoint.medium_forces.size()});
  for (const Eigen::VectorXd& force : checkpoint.medium_forces) put_all(bytes, all_of(force));
  put_all(bytes, checkpoint.felt);
  put(bytes, checkpoint.energy);
  put_all(bytes, checkpoint.history);
  bytes += fingerprint(bytes);
  results::write_atomically(checkpoint_file(folder), bytes);
}

FoundCheckpoint read_checkpoint(const std::filesystem::path& folder, const std::string& identity) {
  FoundCheckpoint found;
  const auto faulty = [&found](const char* what) {
    found.fault = what;
    return found;
  };
  std::ifstream stream(checkpoint_file(folder), std::ios::binary);
  if (!stream) return faulty("is not there or cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string_view all = bytes, before = all.substr(0, all.size() - std::min(all.size(), name_letters));
  if (before.size() < head || all.compare(0, magic.size(), magic) != 0) return faulty("is no checkpoint");
  if (fingerprint(before) != all.substr(before.size())) return faulty("is damaged: its checksum does not agree");
  if (all.substr(0, 24) != std::string_view(head_of({}))) return faulty("is of another version or byte order");
  if (all.substr(24, name_letters) != identity)
    return faulty("belongs to another run: body, loads, steps or surroundings differ");

  Taker taker(before.substr(head));
  Checkpoint& checkpoint = found.checkpoint;
  checkpoint.number = taker.take<std::int64_t>();
  for (Eigen::VectorXd* values :
       {&checkpoint.state.displacement, &checkpoint.state.velocity, &checkpoint.state.acceleration})
    *values = taker.take_vector();
  checkpoint.medium_forces.resize(std::min<std::uint64_t>(taker.take<std::uint64_t>(), before.size()));
  for (Eigen::VectorXd& force : checkpoint.medium_forces) force = taker.take_vector();
  checkpoint.felt = taker.take_all();
  checkpoint.energy = taker.take<EnergyMemory>();
  checkpoint.history = taker.take_all();
  if (!taker.whole()) return faulty("has the wrong length");
  return found;
}

}  // namespace sunder::simulation
