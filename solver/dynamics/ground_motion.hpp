#pragma once
/// One component of a recorded ground acceleration.
///
/// Two kinds of file: a table of time [s] and acceleration [m/s²], one sample a line, separated by comma or white
/// space, a first line of words allowed, `#` begins a comment; and PEER's .at2 (four lines of heading, the last with
/// NPTS and DT, samples in g = 9.80665 m/s²). Between samples the acceleration is linear; before the first and after
/// the last it is 0.

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace sunder::dynamics {

/// A record cannot be used: file, line, what is wrong, what is accepted.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct GroundMotion {
  double start = 0.0;                ///< time of the first sample [s]
  double sample_step = 0.0;          ///< [s], > 0
  std::vector<double> acceleration;  ///< [m/s²], at least two samples

  double end() const { return start + sample_step * static_cast<double>(acceleration.size() - 1); }  ///< [s]
  double at(double time) const;                                                                      ///< [m/s²]
};

/// Throws RecordError where the file cannot be read, a sample is not a finite number, a line has not two numbers, or
/// the time step changes by more than 1e-3 of itself.
GroundMotion read_ground_motion(const std::filesystem::path& file);

/// The record less the parabola c_0 + c_1 t + c_2 t² that leaves the least Σ v² of the ground's velocity over its
/// samples, the ground at rest before the first: takes off a drift that an instrument or the digitising has added.
/// Motion relative to the ground hardly feels it; displacements of the ground itself mean nothing without it. Throws
/// std::invalid_argument where the record has fewer than four samples: as many coefficients as velocities.
GroundMotion baseline_corrected(GroundMotion motion);

}  // namespace sunder::dynamics
