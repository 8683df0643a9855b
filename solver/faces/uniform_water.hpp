#pragma once
/// The pressure at the mouth all along the crack (the seed paper's models 1 and 2): f = p · share, nothing where p < 0.

#include <utility>

#include "solver/faces/face_water.hpp"

namespace sunder::faces {

class UniformWater final : public FaceWater {
 public:
  /// `share` (m) [m]: force a unit of pressure; the first `pairs` of them on pairs.
  UniformWater(Eigen::Index pairs, Eigen::VectorXd share) : pairs_(pairs), share_(std::move(share)) {}

  Eigen::Index pairs() const override { return pairs_; }
  Eigen::Index forces() const override { return share_.size(); }
  bool trial(std::span<const double> /*openings*/, double mouth_pressure, double /*time_step*/,
             WaterForces& result) override {
    const bool wet = mouth_pressure > 0.0;
    result.force = (wet ? mouth_pressure : 0.0) * share_;
    result.by_mouth = (wet ? 1.0 : 0.0) * share_;
    result.by_opening.setZero();
    return true;
  }
  void accept() override {}

 private:
  Eigen::Index pairs_;
  Eigen::VectorXd share_;
};

}  // namespace sunder::faces
