#pragma once
/// Water that flows in a crack of the body (module crackwater), as a force law between its faces (module faces).
///
/// Between two pairs of faces the opening is linear; the water sees it at its own nodes, no farther apart than
/// `longest_segment`, and the pressures, linear between these, go to the pairs by the virtual work of the same linear
/// opening. From the last pair to the tip there is one segment: its aperture falls to the least one, its pressure is
/// what the tip polygon takes (crack_face_loads.hpp).

#include <vector>

#include "solver/crack/crack_faces.hpp"
#include "solver/crackwater/aperture.hpp"
#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/pressure_tangent.hpp"
#include "solver/faces/face_water.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/numerics/meter.hpp"

namespace sunder::simulation {

/// Where the water's nodes stand between the pairs.
struct WaterNodes {
  crackwater::CrackLine line;    ///< segments from the mouth
  std::vector<double> position;  ///< (nodes) [m] from the mouth
  /// Node j lies between pairs `before[j]` and `after[j]`, at the fraction `share[j]` of the way; the tip: before = -1.
  std::vector<int> before, after;
  std::vector<double> share;
  bool has_tip = false;  ///< the last node is the tip
};

/// `longest_segment` [m] > 0.
[[nodiscard]] WaterNodes water_nodes(const crack::CrackPairs& pairs, const mesh::NodalMesh& nodes,
                                     const mesh::Point* tip, double longest_segment);

struct MovingWaterOptions {
  crackwater::Water water;
  double minimum_aperture = 0.03;  ///< [m], > 0
  crackwater::ApertureRule rule = crackwater::ApertureRule::larger;
  bool initially_full = true;
};

class MovingWater final : public faces::FaceWater {
 public:
  /// `openings` (pairs) [m] are those at the start. Throws std::invalid_argument naming the value and its bound.
  MovingWater(WaterNodes nodes, Eigen::Index pairs, const MovingWaterOptions& options,
              std::span<const double> openings);

  Eigen::Index pairs() const override { return pairs_; }
  Eigen::Index forces() const override { return pairs_ + (nodes_.has_tip ? 2 : 0); }
  bool trial(std::span<const double> openings, double mouth_pressure, double time_step,
             faces::WaterForces& result) override;
  void accept() override { march_.accept(); }

  /// The crack has grown: its water stays where it is, the new part is dry.
  void grow(WaterNodes nodes, Eigen::Index pairs, std::span<const double> openings);

  crackwater::MarchMemory memory() const { return march_.memory(); }
  void go_on(const crackwater::MarchMemory& memory) { march_.go_on(memory); }

  const WaterNodes& nodes() const { return nodes_; }
  const crackwater::MarchState& state() const { return march_.state(); }
  const crackwater::PressureProfile& profile() const { return march_.profile(); }  ///< of the last trial
  const std::vector<double>& apertures() const { return apertures_; }              ///< (nodes) [m], of the last trial
  const numerics::Meter& work() const { return work_; }                            ///< of all trials

 private:
  void place(std::span<const double> openings);
  void allocate();

  WaterNodes nodes_;
  Eigen::Index pairs_;
  MovingWaterOptions options_;
  std::vector<double> openings_, rates_, apertures_, aperture_rates_, factors_;
  crackwater::FillingMarch march_;
  crackwater::PressureTangent tangent_;
  Eigen::MatrixXd by_opening_;  // (nodes, pairs) of the pressures
  numerics::Meter work_;
};

}  // namespace sunder::simulation
