#include "solver/material/isotropic.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::material {
namespace {

[[noreturn]] void refuse(const char* name, double value, const char* accepted) {
  std::ostringstream message;
  message << name << " = " << value << ", accepted is " << accepted;
  throw std::invalid_argument(message.str());
}

bool is_plane_strain(const Isotropic& material) {
  return (material.plane == Plane::strain) != numerics::planted_fault("material/plane-states-swapped");
}

double density_of_a_wave(const Isotropic& material) {
  if (!(material.density > 0.0)) refuse("density [kg/m³]", material.density, "density > 0 where waves are asked for");
  return material.density;
}

}  // namespace

void check(const Isotropic& material) {
  const auto [E, nu, rho, plane] = material;
  if (!std::isfinite(E) || E <= 0.0) refuse("youngs_modulus [Pa]", E, "youngs_modulus > 0");
  const bool possible = std::isfinite(nu) && nu >= 0.0 && nu < 0.5;
  if (!possible && !numerics::planted_fault("material/poisson-ratio-believed")) {
    refuse("poisson_ratio", nu, "0 <= poisson_ratio < 0.5");
  }
  if (!std::isfinite(rho) || rho < 0.0) refuse("density [kg/m³]", rho, "density >= 0");
}

Eigen::Matrix3d elasticity_matrix(const Isotropic& material) {
  // M = D_11 and λ = D_12: in plane strain M = E (1 - ν) / ((1 + ν)(1 - 2ν)), λ = E ν / ((1 + ν)(1 - 2ν));
  // in plane stress M = E / (1 - ν²), λ = ν M.
  const double nu = material.poisson_ratio;
  const bool strain = is_plane_strain(material);
  const double common = material.youngs_modulus / ((1.0 + nu) * (strain ? 1.0 - 2.0 * nu : 1.0 - nu));
  const double direct = strain ? common * (1.0 - nu) : common;
  const double coupled = common * nu;
  Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
  D(0, 0) = D(1, 1) = direct;
  D(0, 1) = D(1, 0) = coupled;
  D(2, 2) = shear_modulus(material);
  return D;
}

double shear_modulus(const Isotropic& material) {
  return material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
}

double effective_modulus(const Isotropic& material) {
  const double nu = material.poisson_ratio;
  return is_plane_strain(material) ? material.youngs_modulus / ((1.0 - nu) * (1.0 + nu)) : material.youngs_modulus;
}

double kolosov_constant(const Isotropic& material) {
  const double nu = material.poisson_ratio;
  return is_plane_strain(material) ? 3.0 - 4.0 * nu : (3.0 - nu) / (1.0 + nu);
}

double longitudinal_wave_speed(const Isotropic& material) {
  return std::sqrt(elasticity_matrix(material)(0, 0) / density_of_a_wave(material));
}

double shear_wave_speed(const Isotropic& material) {
  return std::sqrt(shear_modulus(material) / density_of_a_wave(material));
}

}  // namespace sunder::material
