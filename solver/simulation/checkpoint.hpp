#pragma once
/// What a dynamic run without cracks needs to go on after an interruption as if there had been none, to the last bit.
///
/// Matrices, loads and weights are formed again from the scene; the key tells whether they are the same. The memory of
/// an attached medium is every acceleration it was given: a convolution that is given them again is in the same state.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/convolution/convolution.hpp"
#include "solver/simulation/energy_account.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

/// A checkpoint cannot be used: the file and why.
class CheckpointError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

struct Checkpoint {
  std::uint64_t key = 0;  ///< of the equations and loads, by checkpoint_key
  long long step = 0;     ///< steps done
  MotionState state;
  std::vector<std::vector<double>> medium_forces;         ///< one a medium (n) [N/m]
  std::vector<std::vector<double>> medium_accelerations;  ///< one a medium (n · appended) [m/s²], step by step
  std::vector<double> rows;                               ///< history table, row by row
  EnergyTally energy;
};

/// Fingerprint of numbers that must be the same bits when a run goes on: 64-bit FNV-1a over them, begun with `key`.
[[nodiscard]] std::uint64_t fingerprint(std::span<const double> numbers, std::uint64_t key = 0xcbf29ce484222325u);

/// Whole or not at all. Throws std::filesystem::filesystem_error where the system refuses.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws CheckpointError where there is none, it is damaged, or of another key.
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& file, std::uint64_t key);

/// Keeps all accelerations that pass through it.
class Remembering final : public convolution::Convolution {
 public:
  /// Room for `steps` of them, so that `append` allocates nothing.
  Remembering(std::unique_ptr<convolution::Convolution> inner, std::size_t steps);

  int size() const override { return inner_->size(); }
  const Eigen::MatrixXd& instantaneous_mass() const override { return inner_->instantaneous_mass(); }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override { inner_->history_force(force); }
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

  const std::vector<double>& accelerations() const { return accelerations_; }
  /// Gives the medium what it was given before. Precondition: nothing has been appended yet.
  void replay(std::span<const double> accelerations);

 private:
  std::unique_ptr<convolution::Convolution> inner_;
  std::vector<double> accelerations_;
};

}  // namespace sunder::simulation
