#pragma once
/// Exact displacement and stress fields of plane elasticity without body force, from Kolosov's and Muskhelishvili's two
/// analytic functions. Points are complex numbers z = x + iy [m]; unit thickness.

#include <array>
#include <complex>
#include <vector>

namespace sunder::exact {

using Complex = std::complex<double>;

/// The two constants of an isotropic plane body.
struct PlaneBody {
  double shear_modulus;  ///< G [Pa], > 0
  double kolosov;        ///< κ [-]: 3 - 4ν in plane strain, (3 - ν) / (1 + ν) in plane stress
};
PlaneBody plane_strain(double youngs_modulus, double poisson_ratio);
PlaneBody plane_stress(double youngs_modulus, double poisson_ratio);

/// E' = 8 G / (κ + 1) [Pa]: E in plane stress, E / (1 - ν²) in plane strain.
double effective_modulus(const PlaneBody& body);

struct PlaneStress {
  double xx, yy, xy;  ///< σ_xx, σ_yy, τ_xy [Pa]
};

/// σ n: the traction on a face with the unit normal n [Pa].
Complex traction(const PlaneStress& stress, Complex normal);

/// Two polynomials φ(z) = Σ a_k z^k, ψ(z) = Σ b_k z^k [Muskhelishvili 1953]. With a of degree n and b of degree n the
/// displacement is a polynomial of degree n in x and y that is in equilibrium without body force; all of them are so
/// made.
struct PolynomialField {
  std::vector<Complex> phi, psi;  ///< coefficients a_k, b_k from k = 0 on [Pa m^(1-k)], [Pa m^(1-k)]
};

/// 2 G (u + i v) = κ φ(z) - z conj(φ'(z)) - conj(ψ(z)); u + i v [m].
Complex displacement(const PolynomialField& field, const PlaneBody& body, Complex z);

/// σ_xx + σ_yy = 4 Re φ'(z), σ_yy - σ_xx + 2 i τ_xy = 2 (conj(z) φ''(z) + ψ'(z)).
PlaneStress stress(const PolynomialField& field, Complex z);

/// One of the four independent fields of each degree >= 1: part 0, 1: φ = z^n, i z^n; part 2, 3: ψ = z^n, i z^n, all
/// times `magnitude`. At n = 1 part 1 is the rotation: no stress.
PolynomialField polynomial_field(int degree, int part, double magnitude = 1.0);

}  // namespace sunder::exact
