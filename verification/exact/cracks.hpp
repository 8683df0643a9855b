#pragma once
/// Stress intensity factors with a formula: exact ones in the infinite plate, and handbook ones with their stated
/// accuracy.
///
/// Handbook functions give F = K / (σ √(π a)), σ the remote stress of the uncracked section, x = a / W the crack's
/// share of the width (half of it each for centre and double-edge cracks), 0 < x < 1.

#include "verification/exact/plane_elasticity.hpp"

namespace sunder::exact {

struct IntensityFactors {
  double K_I, K_II;  ///< [Pa √m]
};

/// Crack of length 2 a [m] in an infinite plate under remote tension σ [Pa]; `angle` between the crack and the
/// direction of the tension [rad]: K_I = σ √(π a) sin²β, K_II = σ √(π a) sin β cos β [Tada 2000]. Exact.
IntensityFactors inclined_crack(double tension, double half_length, double angle);

/// Crack along an arc of a circle of radius R, half-angle A, under remote biaxial tension σ [Muskhelishvili 1953].
/// Exact.
IntensityFactors arc_crack_biaxial(double tension, double radius, double half_angle);

/// The same under tension normal to the chord [Cotterell 1980]. Exact.
IntensityFactors arc_crack_uniaxial(double tension, double radius, double half_angle);

double edge_tension_tada(double x);         ///< 0.5 % for any x (stated) [Tada 2000]; 0.55 % high at x = 0.1
double edge_tension_gross_brown(double x);  ///< 0.5 % for x <= 0.6 [Brown 1966]; 6 % low at 0.7
double edge_bending_tada(double x);         ///< stated 0.5 % [Tada 2000]; 1 … 2.4 % low in 0.2 <= x <= 0.5
double centre_secant_tada(double x);        ///< 0.1 % for any x [Tada 2000]
double centre_secant_feddersen(double x);   ///< 0.3 % for x <= 0.7 [Feddersen 1966]
double centre_koiter(double x);             ///< 0.4 % [Koiter 1965]
double double_edge_tada(double x);          ///< 0.5 % for any x [Tada 2000]

/// K_I B √W / P of the compact specimen, 0.5 % for 0.2 <= x <= 1 [Srawley 1976].
double compact_tension(double x);

/// K_I B √W / P of the beam in three-point bending with span 4 W, 0.5 % for any x [Srawley 1976].
double three_point_bending(double x);

/// F of an edge crack in the half-plane: 1.12152226 [Koiter 1965].
inline constexpr double half_plane_edge = 1.12152226;

/// The field of a straight crack's tip along the negative x axis, faces at θ = ±π, free of traction [Williams 1957]:
/// K_I, K_II [Pa √m] and the stress T parallel to the crack [Pa].
struct TipField {
  double K_I = 0.0, K_II = 0.0, T = 0.0;
};
/// u + i v [m] at distance r [m] from the tip under the angle θ in [-π, π]; rigid motion left out.
Complex tip_displacement(const TipField& field, const PlaneBody& body, double r, double theta);
PlaneStress tip_stress(const TipField& field, double r, double theta);

/// The direction of the largest hoop stress ahead of the tip [rad], found by bisection of its derivative in extended
/// precision: K_I sin θ + K_II (3 cos θ - 1) = 0 [Erdogan 1963]. 0 where K_II = 0; K_I >= 0.
double kink_angle(double K_I, double K_II);

/// K at the tip of an infinitesimal kink: k_i = C_ij(θ) K_j, to first order in θ [Cotterell 1980]: a few per cent up
/// to 40 … 60°.
IntensityFactors kinked_cotterell_rice(const IntensityFactors& before, double theta);

/// The same by the expansion in m = θ / π up to the powers 6, 3, 3, 4 of F11, F12, F21, F22 [Amestoy 1992]; the next
/// power of F12 is the fifth.
IntensityFactors kinked_amestoy_leblond(const IntensityFactors& before, double theta);

}  // namespace sunder::exact
