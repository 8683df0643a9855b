#pragma once
/// What lies around a shaken body: the ground's record, the water, the rock, and the loads they bring in each step.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "solver/numerics/thread_pool.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/attached_foundation.hpp"
#include "solver/simulation/attached_medium.hpp"
#include "solver/simulation/ledger.hpp"
#include "solver/simulation/shaking.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

/// Whether the line of the near field is held by an attached medium, and not fixed: rock with inertia.
[[nodiscard]] bool rock_moves(const scene::Scene& scene);

class Surroundings {
 public:
  /// Reads the record and makes the media for all steps of the scene. Throws scene::SceneError where a record or a face
  /// cannot be used. `cache`: folder for responses of the rock; empty: none.
  Surroundings(const scene::Scene& scene, const Body& body, const std::filesystem::path& cache,
               numerics::ThreadPool& pool, Ledger& ledger);

  const std::string& failure() const {
    return failure_;
  }  ///< why the response of the rock was not found; empty where it was
  std::vector<std::string> warnings() const;

  long long steps() const { return steps_; }  ///< of the run
  /// Time of the record at the end of step n [s]: negative while the wave rises through the rock to the surface.
  double time_at(long long step) const;

  std::span<AttachedMedium* const> media() const { return visited_; }
  std::vector<const AttachedMedium*> constant_media() const { return {visited_.begin(), visited_.end()}; }

  /// Forces that held the near field's line at rest (dofs) [N/m]; they stay.
  void hold_rock(const Eigen::VectorXd& reaction) { rock_reaction_ = reaction; }
  /// Loads at the end of step n, `dead_load` (dofs) [N/m] among them.
  void load_at(long long step, const Eigen::VectorXd& dead_load, StepLoad& load) const;

  /// Goes on with a grown body of `dofs`; `same`: its degree of freedom for each old one on a boundary. False, with the
  /// name of the medium in `lost`, where a face is no longer what it was.
  [[nodiscard]] bool keep(const std::vector<int>& same, int dofs, std::string& lost);

 private:
  void attach_rock(const Body& body, const std::filesystem::path& cache, numerics::ThreadPool& pool, Ledger& ledger);

  Shaking shaking_;
  double time_step_ = 0.0;
  bool rock_moves_ = false;
  std::vector<std::unique_ptr<AttachedMedium>> media_;
  std::vector<AttachedMedium*> visited_;
  RisingWave wave_;
  Eigen::VectorXd rock_reaction_;
  long long steps_ = 0;
  std::string failure_;
};

}  // namespace sunder::simulation
