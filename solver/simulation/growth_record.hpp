#pragma once
/// What a run of growth at rest leaves behind: a row of history for each equilibrium, the path of each crack, events.

#include <span>
#include <string>
#include <vector>

#include "solver/fracture/propagation.hpp"
#include "solver/results/history.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/static_state.hpp"
#include "solver/simulation/tips.hpp"

namespace sunder::simulation {

class GrowthRecord {
 public:
  /// `body`: before any growth.
  GrowthRecord(const scene::Scene& scene, const Body& body);

  /// An equilibrium in which some tip is driven. `load_factor`: what the scene's loads are multiplied with to make the
  /// crack just grow.
  void add_state(const Body& body, const StaticState& state, std::span<const TipResult> tips,
                 std::span<const fracture::GrowthDecision> decisions, double load_factor);
  void add_growth(int tip, const Growth& growth);
  void add_cut_through();
  void refuse(int tip, const mesh::Point& from, const std::string& reason);

  const std::string& refusal() const { return refusal_; }

  /// `end`: why the run ended; empty where the status tells.
  void add_quantities(const std::string& end, results::RunSummary& summary) const;

 private:
  struct TipHistory {
    std::vector<double> length, K_I, K_II, kink_angle;  ///< one value an equilibrium in which the tip is there
    std::vector<mesh::Point> path;                      ///< from where it stood in the scene
    double release_rate = 0.0;                          ///< G = K²/E' in the last equilibrium [N/m]
    double grown = 0.0;                                 ///< since then [m]
  };

  const scene::Scene& scene_;
  results::History history_;
  std::vector<TipHistory> tips_;
  std::vector<double> load_factors_, energy_release_ratios_;
  results::Quantity::List events_;
  std::string refusal_;
  double potential_energy_ = 0.0;
  int growths_ = 0;
};

}  // namespace sunder::simulation
