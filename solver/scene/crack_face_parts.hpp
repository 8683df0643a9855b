#pragma once
/// The parts of a scene that act on the faces of cracks: contact, crack water, propagation, and the crack with a given
/// motion that has no solid at all. All numbers SI. Defaults are the values of the paper (README), where it states
/// them.

#include <optional>
#include <vector>

#include "solver/fracture/propagation.hpp"

namespace sunder::scene {

enum class ContactModel {
  penalty,  ///< springs across the faces, enlarged until the penetration is within its tolerance
  exact,    ///< complementarity on the condensed faces
};

struct Contact {
  ContactModel model = ContactModel::penalty;
  double initial_stiffness = 1e8;       ///< [N/m³], > 0
  double growth_factor = 10.0;          ///< [-], > 1
  double penetration_tolerance = 1e-4;  ///< [m], > 0
  double friction_coefficient = 0.0;    ///< [-], >= 0
};

enum class CrackWaterModel {
  uniform,  ///< the pressure at the mouth along the whole crack
  moving,   ///< flow with continuity and cavitation
};

enum class ApertureRule {
  larger,  ///< of opening and minimum_aperture
  sum,     ///< minimum_aperture is a roughness layer that the opening adds to
};

struct CrackWater {
  CrackWaterModel model = CrackWaterModel::moving;
  double minimum_aperture = 0.03;  ///< [m], > 0
  ApertureRule aperture = ApertureRule::larger;
  double relative_roughness = 0.5;  ///< k / (2w) [-], > 0, <= 0.5
  double density = 1000.0;          ///< [kg/m³], > 0
  double dynamic_viscosity = 1e-3;  ///< [Pa s], > 0
};

enum class PropagationCriterion { max_hoop_stress };

struct Propagation {
  double fracture_toughness;  ///< [Pa √m], > 0
  double increment = 0.5;     ///< [m], > 0
  PropagationCriterion criterion = PropagationCriterion::max_hoop_stress;
  // In time (analysis = "dynamic"):
  fracture::GrowthPerStep per_step = fracture::GrowthPerStep::one_increment;
  std::optional<double> max_speed;  ///< of a tip [m/s], > 0; absent: no limit but increment / time step
  // At rest (analysis = "static"): the loads are scaled so that the crack just grows.
  bool notches = false;  ///< the scene's cracks are sawn: a negative K_I does not hold them until they have grown
  int steps = 100;       ///< growths at most, >= 1
  std::optional<double> until_length;  ///< stop once a crack is as long [m], > 0
  double together = 0.95;  ///< tips with at least this share of the largest K_eq grow in the same step, > 0, <= 1
};

enum class Filling { full, empty };

struct March {
  double time_step;  ///< [s], > 0
  double duration;   ///< [s], > 0
  Filling initially = Filling::full;
  int history_every = 1;  ///< steps from one row of the history to the next, >= 1
};

enum class Tip { open, closed };
enum class WaterQuadrature { exact, midpoint };

enum class WaterSearch {
  bisection,  ///< the seed paper's
  itp,
  toms748,
  newton,
  prefix,  ///< Newton's method on sums worked out beforehand
};

/// A crack with given motion: `analysis = "crack-water"`.
struct CrackLine {
  double length;                 ///< [m], > 0
  int segments;                  ///< >= 1
  std::vector<double> aperture;  ///< opening [m], > 0; at both ends (linear between) or at each of segments + 1 nodes
  std::vector<double> opening_rate{0.0};  ///< [m/s]; one value everywhere, both ends, or each node
  double rise = 0.0;           ///< height gained from the upstream mouth to the far end, evenly [m], |rise| <= length
  double upstream_head = 0.0;  ///< [m of water], >= 0
  std::optional<double> downstream_head;  ///< [m of water], >= 0; absent where the tip is closed
  Tip tip = Tip::open;
  std::optional<March> march;  ///< absent: the profile of one instant
  WaterQuadrature quadrature = WaterQuadrature::exact;
  WaterSearch search = WaterSearch::prefix;  ///< how the flux is found
  double tolerance = 0.0;                    ///< of the flux, relative to its bracket, >= 0, < 1; 0: to round-off
};

}  // namespace sunder::scene
