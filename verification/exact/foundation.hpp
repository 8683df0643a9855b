#pragma once
/// What the unbounded plane does to a rigid disc that moves in it, e^{iωt}, per shear modulus.

#include <complex>

namespace sunder::exact {

/// Force per displacement over G of a rigid disc of radius r in the full plane, plane strain: the plane-strain case of
/// Baranov and Novak [Novak, Nogami & Aboul-Ella 1978]. With a = i a0, b = a c_s/c_p and modified Bessel functions
///     π a² (4 K1(b) K1(a) + a K1(b) K0(a) + b K0(b) K1(a)) / (b K0(b) K1(a) + a K1(b) K0(a) + a b K0(b) K0(a)).
/// a0 = ω r/c_s > 0, 0 <= nu < 0.5.
std::complex<double> rigid_disc_translation(double poisson_ratio, double a0);

/// Moment per rotation over G r²: 2π a0 H2(a0)/H1(a0), H of the second kind, from u_θ = H1(ω r/c_s).
std::complex<double> rigid_disc_rotation(double a0);

}  // namespace sunder::exact
