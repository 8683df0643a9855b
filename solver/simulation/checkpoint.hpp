#pragma once
/// A dynamic run on disk, to go on with: after an interruption it gives the same bits as a run without one.
///
/// Kept is what a step leaves for the next: the motion, what the media have felt since the start (their memory is made
/// again by replay, so that no convolution needs to know of disks), the energy account and the rows of the history. The
/// body, rest and factors are computed again. Cracks add what is between their faces, and where each tip has grown to:
/// the body of that moment follows by growing it again, step for step, which takes no solution.
///
/// Layout, in the machine's byte order: "sunderCP", 1 as the order's witness, the format's version, 32 letters that
/// tell the run (`RunIdentity`), the values, and 32 letters that tell all bytes before them. Written whole or not at
/// all.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/results/quantity.hpp"
#include "solver/simulation/dynamic_step.hpp"
#include "solver/simulation/energy_account.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

/// A growth event: tip `crack` went straight to (x, y) [m].
struct GrownTip {
  int crack = 0;
  double x = 0.0, y = 0.0;
};

/// What cracks carry from step to step.
struct CrackMemory {
  std::vector<GrownTip> growths;  ///< since the start, in their order
  StepMemory step;
  std::vector<crackwater::MarchMemory> waters;  ///< of the cracks in which water moves
  Eigen::VectorXd released;                     ///< what held new faces together in the last event, empty without one
  std::vector<double> allowances;               ///< of the tips' speed [m], one a crack
  results::Quantity events, profiles;           ///< noted so far
  double face_residual = 0.0;                   ///< the largest so far
};

struct Checkpoint {
  long long number = 0;                        ///< of the last accepted step
  MotionState state;                           ///< at its end; the time follows from the number
  std::vector<Eigen::VectorXd> medium_forces;  ///< one a medium
  std::vector<double> felt;                    ///< accelerations [m/s²]: step by step, medium by medium
  EnergyMemory energy;
  std::vector<double> history;  ///< row by row
  bool cracked = false;
  CrackMemory cracks;  ///< where `cracked`
};

/// 32 letters for equations and loads: two runs share them where every number that steers their steps is the same.
/// `load_samples` (k, steps + 1): whatever drives the run, step by step; `laws`: numbers of whatever else decides.
[[nodiscard]] std::string run_identity(const StepEquations& equations, const Eigen::VectorXd& dead_load,
                                       const Eigen::MatrixXd& load_samples, const Eigen::VectorXd& laws);

[[nodiscard]] std::filesystem::path checkpoint_file(const std::filesystem::path& folder);

/// Throws std::filesystem::filesystem_error where the folder cannot be written.
void write_checkpoint(const std::filesystem::path& folder, const std::string& identity, const Checkpoint& checkpoint);

struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::string fault;  ///< what is wrong with the file; empty where nothing is
};
[[nodiscard]] FoundCheckpoint read_checkpoint(const std::filesystem::path& folder, const std::string& identity);

}  // namespace sunder::simulation
