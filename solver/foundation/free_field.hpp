#pragma once
/// What a plane wave that rises vertically does to the line of an unbounded domain when no dam stands there.
///
/// Horizontal motion is a shear wave (c = c_s), vertical motion a pressure wave (c = c_p). The free surface y = 0
/// doubles it, so from the surface's acceleration a(t) the rock at depth d moves with
///     ü(d, t) = ½ (a(t - d/c) + a(t + d/c)),
///     τ_xy(d, t) = -ρ c/2 (v(t + d/c) - v(t - d/c)),  v = ∫ a,   or σ_yy alike, and σ_xx = ν/(1 - ν) σ_yy.
/// The rock at depth is there before the surface: time is shifted by a whole number of steps, `delay()`, so that all is
/// at rest at t = 0 and the surface record begins at t = delay().
///
/// Between its samples a is linear and v quadratic: the free field is exact for that record, at any d/c.

#include <Eigen/Core>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/sbfem/coefficients.hpp"

namespace sunder::foundation {

/// An acceleration [m/s²] sampled at equal steps; zero before the first sample and after the last.
class SampledMotion {
 public:
  /// `step` [s] > 0, finite samples; else std::invalid_argument.
  SampledMotion(std::vector<double> acceleration, double step);

  double acceleration(double t) const;
  double velocity(double t) const;  ///< ∫ a from the first sample on [m/s]

 private:
  std::vector<double> acceleration_, velocity_;
  double step_;
};

class FreeField {
 public:
  /// `line`: straight edges, open, relative to a centre on the free surface, y <= 0. `time_step` [s] is the run's.
  /// Rock of plane strain, density > 0. Throws std::invalid_argument otherwise.
  FreeField(const sbfem::Boundary& line, const material::Isotropic& rock, SampledMotion horizontal,
            SampledMotion vertical, double time_step);

  int delay() const { return delay_; }  ///< whole steps between the run's start and the surface record's

  /// The surface's acceleration (x, y) at the end of step n >= 0 [m/s²].
  Eigen::Vector2d surface(int n) const;

  /// At the end of step n: the accelerations of the line's degrees of freedom (2 nodes) [m/s²], and the forces (2
  /// nodes) [N/m] with which the rock outside acts on the rock inside. Allocates nothing.
  void at(int n, Eigen::Ref<Eigen::VectorXd> acceleration, Eigen::Ref<Eigen::VectorXd> force) const;

 private:
  /// A Gauss point of the line: its depth and what a stress there is in nodal forces.
  struct Point {
    double depth = 0.0;
    std::vector<int> nodes;
    Eigen::VectorXd normal_x, normal_y;  ///< ∫ N n_x ds, ∫ N n_y ds, n out of the rock inside [m]
  };

  Eigen::VectorXd depths_;
  std::vector<Point> points_;
  SampledMotion horizontal_, vertical_;
  double c_s_, c_p_, impedance_s_, impedance_p_, lateral_, time_step_;
  int delay_ = 0;
};

}  // namespace sunder::foundation
