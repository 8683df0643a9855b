#include "solver/simulation/checkpoint.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "solver/results/atomic_file.hpp"
#include "solver/simulation/byte_stream.hpp"
#include "solver/simulation/response_cache.hpp"

namespace sunder::simulation {
namespace {

constexpr std::string_view magic = "sunderCP";
constexpr std::uint64_t version = 2, order_witness = 1;
constexpr std::size_t name_letters = 32, head = 24 + name_letters;

template <class Stream, class State>
void visit_water(Stream& stream, State& water) {
  auto& state = water.state;
  stream(state.status);
  for (auto* values : {&state.voids, &state.capacities}) stream(*values);
  for (auto* value : {&state.time, &state.content, &state.inflow, &state.outflow, &state.moved, &state.balance_error,
                      &state.front_position, &water.first_content, &water.upstream_flux, &water.downstream_flux})
    stream(*value);
  for (auto* count : {&state.residual_evaluations, &state.gradient_evaluations, &state.steps}) stream(*count);
  for (auto* sum : {&water.inflow, &water.outflow}) stream(*sum);
}

template <class Stream, class Memory>
void visit_cracks(Stream& stream, Memory& cracks) {
  stream(cracks.growths);
  auto &faces = cracks.step.faces, &solve = cracks.step.solve;
  for (auto* values : {&faces.force, &faces.opening, &faces.contact, &cracks.step.motion, &solve.force, &solve.motion,
                       &solve.opening, &solve.contact_force, &solve.mouth_pressure, &cracks.released})
    stream(*values);
  for (auto* value : {&faces.stiffness, &solve.stiffness, &cracks.face_residual}) stream(*value);
  stream(solve.touching);
  stream.resize(cracks.waters);
  for (auto& water : cracks.waters) visit_water(stream, water);
  stream(cracks.allowances);
  for (auto* noted : {&cracks.events, &cracks.profiles}) stream(*noted);
}

template <class Stream, class Values>
void visit(Stream& stream, Values& checkpoint) {
  stream(checkpoint.number);
  auto& state = checkpoint.state;
  for (auto* values : {&state.displacement, &state.velocity, &state.acceleration}) stream(*values);
  stream.resize(checkpoint.medium_forces);
  for (auto& force : checkpoint.medium_forces) stream(force);
  stream(checkpoint.felt);
  stream(checkpoint.energy);
  stream(checkpoint.history);
  stream(checkpoint.cracked);
  if (checkpoint.cracked) visit_cracks(stream, checkpoint.cracks);
}

std::string head_of(const std::string& identity) {
  std::string bytes(magic);
  ByteWriter write(bytes);
  write(order_witness);
  write(version);
  return bytes + identity;
}

}  // namespace

std::string run_identity(const StepEquations& equations, const Eigen::VectorXd& dead_load,
                         const Eigen::MatrixXd& load_samples, const Eigen::VectorXd& laws) {
  CacheKey key("run");
  const auto& [scheme, time_step, damping] = equations.options();
  for (const double value :
       {scheme.alpha_m, scheme.alpha_f, scheme.beta, scheme.gamma, time_step, damping.of_mass, damping.of_stiffness})
    key.add(value);
  for (const Eigen::SparseMatrix<double>* matrix : {&equations.stiffness(), &equations.mass()})
    key.add(Eigen::VectorXd::Map(matrix->valuePtr(), matrix->nonZeros()));
  key.add(dead_load);
  key.add(load_samples);
  key.add(laws);
  for (const AttachedMedium* medium : equations.media()) key.add(medium->convolution->instantaneous_mass());
  return fingerprint(key.bytes());
}

std::filesystem::path checkpoint_file(const std::filesystem::path& folder) {
  return folder / "checkpoint.bin";
}

void write_checkpoint(const std::filesystem::path& folder, const std::string& identity, const Checkpoint& checkpoint) {
  std::string bytes = head_of(identity);
  ByteWriter write(bytes);
  visit(write, checkpoint);
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

  ByteReader read(before.substr(head));
  visit(read, found.checkpoint);
  if (!read.whole()) return faulty("has the wrong length");
  return found;
}

}  // namespace sunder::simulation
