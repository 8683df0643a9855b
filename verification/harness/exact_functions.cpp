#include "verification/harness/exact_functions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/exact/bodies.hpp"
#include "verification/exact/crack_water.hpp"
#include "verification/exact/cracks.hpp"
#include "verification/exact/foundation.hpp"
#include "verification/exact/oscillator.hpp"
#include "verification/exact/reservoir.hpp"
#include "verification/exact/vibration.hpp"

namespace sunder::verification {
namespace {

/// The natural number that a function of natural numbers was given; but for the round-off of a quotient.
int natural(double x) {
  constexpr double round_off = 1e-9;
  if (!(x >= 0.0 && x <= 1e6) || std::abs(x - std::round(x)) > round_off * (1.0 + x))
    throw std::invalid_argument("a natural number is needed");
  return static_cast<int>(std::lround(x));
}

exact::MovingCrack moving_crack(std::span<const double> x) {
  return {.pressure = x[0], .aperture = x[1], .length = x[2], .rate = x[3], .viscosity = x[4]};
}

}  // namespace

const std::vector<NumberFunction>& number_functions() {
  using Numbers = std::span<const double>;
  static const std::vector<NumberFunction> all{
      {"sqrt", 1, [](Numbers x) { return std::sqrt(x[0]); }},
      {"abs", 1, [](Numbers x) { return std::abs(x[0]); }},
      {"sin", 1, [](Numbers x) { return std::sin(x[0]); }},
      {"cos", 1, [](Numbers x) { return std::cos(x[0]); }},
      {"tan", 1, [](Numbers x) { return std::tan(x[0]); }},
      {"atan", 1, [](Numbers x) { return std::atan(x[0]); }},
      {"atan2", 2, [](Numbers x) { return std::atan2(x[0], x[1]); }},
      {"exp", 1, [](Numbers x) { return std::exp(x[0]); }},
      {"log", 1, [](Numbers x) { return std::log(x[0]); }},
      {"log10", 1, [](Numbers x) { return std::log10(x[0]); }},
      {"hypot", 2, [](Numbers x) { return std::hypot(x[0], x[1]); }},
      {"min", 2, [](Numbers x) { return std::min(x[0], x[1]); }},
      {"max", 2, [](Numbers x) { return std::max(x[0], x[1]); }},
      // handbook factors F(a / W)
      {"edge_tension_tada", 1, [](Numbers x) { return exact::edge_tension_tada(x[0]); }},
      {"edge_tension_gross_brown", 1, [](Numbers x) { return exact::edge_tension_gross_brown(x[0]); }},
      {"edge_bending_tada", 1, [](Numbers x) { return exact::edge_bending_tada(x[0]); }},
      {"centre_secant_tada", 1, [](Numbers x) { return exact::centre_secant_tada(x[0]); }},
      {"centre_secant_feddersen", 1, [](Numbers x) { return exact::centre_secant_feddersen(x[0]); }},
      {"centre_koiter", 1, [](Numbers x) { return exact::centre_koiter(x[0]); }},
      {"double_edge_tada", 1, [](Numbers x) { return exact::double_edge_tada(x[0]); }},
      {"compact_tension", 1, [](Numbers x) { return exact::compact_tension(x[0]); }},
      {"three_point_bending", 1, [](Numbers x) { return exact::three_point_bending(x[0]); }},
      // infinite plate: tension, half-length or radius [m], angle [rad]
      {"inclined_crack_K_I", 3, [](Numbers x) { return exact::inclined_crack(x[0], x[1], x[2]).K_I; }},
      {"inclined_crack_K_II", 3, [](Numbers x) { return exact::inclined_crack(x[0], x[1], x[2]).K_II; }},
      {"arc_crack_biaxial_K_I", 3, [](Numbers x) { return exact::arc_crack_biaxial(x[0], x[1], x[2]).K_I; }},
      {"arc_crack_biaxial_K_II", 3, [](Numbers x) { return exact::arc_crack_biaxial(x[0], x[1], x[2]).K_II; }},
      {"arc_crack_uniaxial_K_I", 3, [](Numbers x) { return exact::arc_crack_uniaxial(x[0], x[1], x[2]).K_I; }},
      {"arc_crack_uniaxial_K_II", 3, [](Numbers x) { return exact::arc_crack_uniaxial(x[0], x[1], x[2]).K_II; }},
      // reservoir with a rigid bottom: kappa; mass over that of still water, dry frequency; T
      {"reservoir_force", 1, [](Numbers x) { return exact::reservoir_force(x[0]); }},
      {"coupled_frequency", 2, [](Numbers x) { return exact::coupled_frequency(x[0], x[1]); }},
      {"reservoir_impulse_before_echo", 1, [](Numbers x) { return exact::reservoir_impulse_before_echo(x[0]); }},
      {"kink_angle", 2, [](Numbers x) { return exact::kink_angle(x[0], x[1]); }},
      // E [Pa], nu, rho [kg/m³], side [m], index from 0 [rad/s]
      {"roller_square_plane_strain", 5,
       [](Numbers x) {
         return exact::roller_square_frequency(exact::plane_strain(x[0], x[1]), x[2], x[3], natural(x[4]));
       }},
      {"roller_square_plane_stress", 5,
       [](Numbers x) {
         return exact::roller_square_frequency(exact::plane_stress(x[0], x[1]), x[2], x[3], natural(x[4]));
       }},
      // omega [1/s], damping ratio, time [s], of an oscillator let go at 1
      {"free_oscillator", 3,
       [](Numbers x) {
         return exact::free_oscillator(x[0], x[1], {1.0, 0.0}, x[2]).displacement;
       }},
      // … time step [s], number of steps
      {"trapezoidal_oscillator", 4,
       [](Numbers x) {
         return exact::trapezoidal_oscillator(x[0], x[1], {1.0, 0.0}, x[2], x[3]).displacement;
       }},
      {"trapezoidal_oscillator_velocity", 4,
       [](Numbers x) {
         return exact::trapezoidal_oscillator(x[0], x[1], {1.0, 0.0}, x[2], x[3]).velocity;
       }},
      // omega, damping ratio, p [m/s²], forcing [1/s], time
      {"forced_oscillator", 5,
       [](Numbers x) { return exact::forced_oscillator(x[0], x[1], x[2], x[3], x[4]).displacement; }},
      {"forced_oscillator_velocity", 5,
       [](Numbers x) { return exact::forced_oscillator(x[0], x[1], x[2], x[3], x[4]).velocity; }},
      // omega, damping ratio, p [m/s²], its slope [m/s³], time
      {"ramped_oscillator", 5,
       [](Numbers x) { return exact::ramped_oscillator(x[0], x[1], x[2], x[3], x[4]).displacement; }},
      // amplitude [m] and duration [s] of the base's pulse, length [m], wave speed [m/s], time [s]
      {"rod_free_end", 5, [](Numbers x) { return exact::rod_free_end(x[0], x[1], x[2], x[3], x[4]); }},
      // transit [s], forcing [1/s], time [s]
      {"shaken_rod_free_end", 3, [](Numbers x) { return exact::shaken_rod_free_end(x[0], x[1], x[2]); }},
      // spectral radius, omega dt, damping ratio, steps
      {"hht_alpha_step_response", 4,
       [](Numbers x) { return exact::hht_alpha_step_response(x[0], x[1], x[2], natural(x[3])); }},
      {"generalised_alpha_step_response", 4,
       [](Numbers x) { return exact::generalised_alpha_step_response(x[0], x[1], x[2], natural(x[3])); }},
      // rigid disc in the plane: Poisson's ratio, omega r / c_s
      {"rigid_disc_translation_re", 2, [](Numbers x) { return exact::rigid_disc_translation(x[0], x[1]).real(); }},
      {"rigid_disc_translation_im", 2, [](Numbers x) { return exact::rigid_disc_translation(x[0], x[1]).imag(); }},
      {"rigid_disc_rotation_re", 1, [](Numbers x) { return exact::rigid_disc_rotation(x[0]).real(); }},
      {"rigid_disc_rotation_im", 1, [](Numbers x) { return exact::rigid_disc_rotation(x[0]).imag(); }},
      // water in a uniform crack: pressure [Pa], aperture [m], length [m] (or time [s]), viscosity [Pa s]
      {"resting_crack_flux", 4, [](Numbers x) { return exact::resting_crack_flux(x[0], x[1], x[2], x[3]); }},
      {"filling_front", 4, [](Numbers x) { return exact::filling_front(x[0], x[1], x[2], x[3]); }},
      // the same while it moves: pressure, aperture, length, rate [m/s], viscosity
      {"moving_crack_front", 5, [](Numbers x) { return exact::moving_crack_front(moving_crack(x)); }},
      {"moving_crack_tip_pressure", 5, [](Numbers x) { return exact::moving_crack_tip_pressure(moving_crack(x)); }},
      {"moving_crack_uplift", 5, [](Numbers x) { return exact::moving_crack_uplift(moving_crack(x)); }},
  };
  return all;
}

const NumberFunction* find_number_function(std::string_view name, std::size_t arguments) {
  for (const NumberFunction& function : number_functions())
    if (function.name == name && function.arguments == arguments) return &function;
  return nullptr;
}

}  // namespace sunder::verification
