#pragma once
/// How the pressure lost over a segment follows its flux, its rates and its apertures.

#include <Eigen/Core>

#include "solver/crackwater/segment_table.hpp"

namespace sunder::crackwater {

/// Derivatives of the loss over a stretch, and of its parts in the two nodal forces.
struct StretchTangent {
  Eigen::Array3d by_flux = Eigen::Array3d::Zero();  ///< rows: loss, to_first, to_last
  Eigen::Array3d by_rate0 = Eigen::Array3d::Zero(), by_rate1 = Eigen::Array3d::Zero();
  Eigen::Array3d by_aperture0 = Eigen::Array3d::Zero(), by_aperture1 = Eigen::Array3d::Zero();
  Eigen::Array3d value = Eigen::Array3d::Zero();

  void add(const StretchTangent& other, double share) {
    by_flux += share * other.by_flux;
    by_rate0 += share * other.by_rate0;
    by_rate1 += share * other.by_rate1;
    by_aperture0 += share * other.by_aperture0;
    by_aperture1 += share * other.by_aperture1;
    value += share * other.value;
  }
};

/// The stretch [start, end] of a segment, y in -1 … 1, for the constant c, V counted from the segment's first node. By
/// Gauss-Legendre rules of eight points between the cuts; the cuts at |q| = q_c move with the flux.
StretchTangent stretch_tangent(const Segment& segment, const FlowLaw& law, double c, double start, double end);

/// Segment i of a flat table; its nodal forces follow from the nodal pressures.
StretchTangent flat_tangent(const SegmentTable& table, int i, double c);

}  // namespace sunder::crackwater
