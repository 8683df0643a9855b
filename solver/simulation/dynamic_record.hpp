#pragma once
/// What a dynamic run remembers of each step: the columns of history.csv and the extremes of the summary.

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "solver/results/history.hpp"
#include "solver/results/quantity.hpp"
#include "solver/simulation/energy_account.hpp"

namespace sunder::simulation {

/// One crack at the end of a step.
struct CrackRecord {
  double mouth_opening = 0.0;    ///< [m], negative: overlap
  double length = 0.0;           ///< [m]
  double K_I = 0.0, K_II = 0.0;  ///< [Pa √m]; 0 where the crack has no tip any more
  double mouth_pressure = 0.0;   ///< [Pa]
  double uplift_force = 0.0;     ///< ∫ p ds on one face [N/m]
  double wet_length = 0.0;       ///< from the mouth [m]
  double water_content = 0.0;    ///< [m²]
  double peak_pressure = 0.0;    ///< [Pa]
  double contact_force = 0.0;    ///< sum over its pairs [N/m]
  double penetration = 0.0;      ///< largest [m]
};

struct StepRecord {
  double time = 0.0;
  Eigen::Vector2d crest =
      Eigen::Vector2d::Zero();      ///< displacement relative to the ground, the static one included [m]
  double hydrodynamic_force = 0.0;  ///< on the body, horizontal [N/m]
  std::vector<CrackRecord> cracks;
  int face_iterations = 0;
  double face_residual = 0.0;  ///< of the faces' equations, over their bounds: at most 1 in a step that was accepted
};

/// Which parts the scene has: a part that is absent has no columns.
struct RecordedParts {
  std::size_t cracks = 0;
  bool media = false, contact = false, water = false, growth = false, propagation = false;
};

class DynamicRecord {
 public:
  DynamicRecord(const RecordedParts& parts, std::size_t steps);

  void add(const StepRecord& step, const Energies& energies);
  /// Peaks over all steps so far, by the names that scenes define.
  void write(results::Quantity& quantities) const;
  const results::History& history() const { return history_; }
  /// Goes on after the rows that another record of the same run had in its history, and its largest residual, which is
  /// in none.
  void read_rows(std::span<const double> rows, double largest_face_residual);
  double largest_face_residual() const { return face_residual_; }
  results::History take_history() { return std::move(history_); }

 private:
  RecordedParts parts_;
  results::History history_;
  std::vector<double> row_;
  double peak_crest_ = 0.0, peak_crest_time_ = 0.0, crest_low_ = 0.0, crest_high_ = 0.0, peak_force_ = 0.0,
         penetration_ = 0.0, face_residual_ = 0.0;
  double rest_crest_ = 0.0;
  std::vector<double> widest_mouth_, highest_K_I_, highest_K_I_time_;
  bool begun_ = false;
};

}  // namespace sunder::simulation
