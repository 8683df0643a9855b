#include "solver/simulation/checkpoint.hpp"

#include <bit>
#include <cstring>
#include <fstream>
#include <sstream>

#include "solver/results/atomic_file.hpp"

namespace sunder::simulation {
namespace {

constexpr std::string_view first_line = "sunder checkpoint 1\n";

std::uint64_t hash(std::string_view bytes, std::uint64_t key) {
  for (const char byte : bytes) key = (key ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return key;
}

std::string_view bytes_of(std::span<const double> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

std::span<const double> view(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}

void put(std::string& text, std::uint64_t number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put(std::string& text, std::span<const double> numbers) {
  put(text, numbers.size());
  text += bytes_of(numbers);
}

/// What is left of a file to read; every member throws where it ends too early.
class Rest {
 public:
  Rest(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::vector<double> numbers() {
    const std::uint64_t count = number();
    if (count > text_.size() / sizeof(double)) refuse();
    std::vector<double> values(count);
    if (count > 0) std::memcpy(values.data(), take(count * sizeof(double)).data(), count * sizeof(double));
    return values;
  }

 private:
  [[noreturn]] void refuse() const { throw CheckpointError(file_.string() + ": the checkpoint ends too early"); }
  std::string_view take(std::size_t count) {
    if (count > text_.size()) refuse();
    const std::string_view taken = text_.substr(0, count);
    text_.remove_prefix(count);
    return taken;
  }

  std::string_view text_;
  const std::filesystem::path& file_;
};

}  // namespace

std::uint64_t fingerprint(std::span<const double> numbers, std::uint64_t key) {
  return hash(bytes_of(numbers), key);
}

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  std::string text(first_line);
  put(text, checkpoint.key);
  put(text, static_cast<std::uint64_t>(checkpoint.step));
  const Energies& e = checkpoint.energy.energies;
  const double single[] = {checkpoint.state.time,
                           checkpoint.energy.begun_with,
                           checkpoint.energy.worst_error,
                           checkpoint.energy.largest,
                           e.kinetic,
                           e.strain,
                           e.damped,
                           e.radiated,
                           e.input,
                           e.load,
                           e.contact,
                           e.water,
                           e.growth};
  put(text, single);
  put(text, view(checkpoint.state.displacement));
  put(text, view(checkpoint.state.velocity));
  put(text, view(checkpoint.state.acceleration));
  put(text, checkpoint.rows);
  put(text, checkpoint.medium_forces.size());
  for (const std::vector<double>& forces : checkpoint.medium_forces) put(text, forces);
  for (const std::vector<double>& accelerations : checkpoint.medium_accelerations) put(text, accelerations);
  put(text, hash(text, fingerprint({})));
  results::write_atomically(file, text);
}

Checkpoint read_checkpoint(const std::filesystem::path& file, std::uint64_t key) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw CheckpointError(file.string() + ": there is no checkpoint to go on from");
  std::ostringstream gathered;
  gathered << stream.rdbuf();
  const std::string text = std::move(gathered).str();
  if (!text.starts_with(first_line)) throw CheckpointError(file.string() + ": is no checkpoint of this program");
  const std::size_t body = text.size() - std::min(text.size(), sizeof(std::uint64_t));
  const std::string_view hashed = std::string_view(text).substr(0, body);
  if (Rest(std::string_view(text).substr(body), file).number() != hash(hashed, fingerprint({})))
    throw CheckpointError(file.string() + ": the checkpoint is damaged");

  Rest rest(hashed.substr(first_line.size()), file);
  Checkpoint result;
  result.key = rest.number();
  if (result.key != key) {
    throw CheckpointError(file.string() +
                          ": the checkpoint is of another scene, or of another build of the program; accepted: the "
                          "scene that it was written for");
  }
  result.step = static_cast<long long>(rest.number());
  const std::vector<double> single = rest.numbers();
  if (single.size() != 13) throw CheckpointError(file.string() + ": is no checkpoint of this program");
  result.energy = {.energies = {.kinetic = single[4],
                                .strain = single[5],
                                .damped = single[6],
                                .radiated = single[7],
                                .input = single[8],
                                .load = single[9],
                                .contact = single[10],
                                .water = single[11],
                                .growth = single[12]},
                   .begun_with = single[1],
                   .worst_error = single[2],
                   .largest = single[3]};
  result.state = {.time = single[0],
                  .displacement = vector_of(rest.numbers()),
                  .velocity = vector_of(rest.numbers()),
                  .acceleration = vector_of(rest.numbers())};
  result.rows = rest.numbers();
  const std::uint64_t media = rest.number();
  for (std::uint64_t m = 0; m < media; ++m) result.medium_forces.push_back(rest.numbers());
  for (std::uint64_t m = 0; m < media; ++m) result.medium_accelerations.push_back(rest.numbers());
  return result;
}

Remembering::Remembering(std::unique_ptr<convolution::Convolution> inner, std::size_t steps)
    : inner_(std::move(inner)) {
  accelerations_.reserve(steps * static_cast<std::size_t>(inner_->size()));
}

void Remembering::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  accelerations_.insert(accelerations_.end(), acceleration.data(), acceleration.data() + acceleration.size());
  inner_->append(acceleration);
}

void Remembering::replay(std::span<const double> accelerations) {
  const Eigen::Index n = size();
  Eigen::VectorXd force(n);
  for (std::size_t at = 0; at + static_cast<std::size_t>(n) <= accelerations.size();
       at += static_cast<std::size_t>(n)) {
    inner_->history_force(force);  // as the run did: what a convolution prepares there must not depend on it
    append(Eigen::Map<const Eigen::VectorXd>(accelerations.data() + at, n));
  }
}

}  // namespace sunder::simulation
