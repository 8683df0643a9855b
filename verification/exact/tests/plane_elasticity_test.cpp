#include "verification/exact/plane_elasticity.hpp"

#include <gtest/gtest.h>

#include "verification/exact/bodies.hpp"
#include "verification/exact/tests/field_check.hpp"

namespace sunder::exact {
namespace {

TEST(PolynomialField, IsElasticUpToDegreeEight) {
  for (const PlaneBody& body : {plane_strain(25e9, 0.2), plane_strain(1.0, 0.4999), plane_stress(3.0, 0.3)})
    for (int degree = 1; degree <= 8; ++degree)
      for (int part = 0; part < 4; ++part) {
        const PolynomialField field = polynomial_field(degree, part, body.shear_modulus);
        expect_elastic(
            {[&](Complex z) { return displacement(field, body, z); }, [&](Complex z) { return stress(field, z); }},
            body, {0.7, -0.4}, 1.0);
      }
}

TEST(PolynomialField, HoldsTheRotationAndTheUniaxialState) {
  const PlaneBody body = plane_stress(200.0, 0.25);
  const PlaneStress none = stress(polynomial_field(1, 1), {0.3, 0.8});
  EXPECT_EQ(none.xx, 0.0);
  EXPECT_EQ(none.yy, 0.0);
  EXPECT_EQ(none.xy, 0.0);
  // φ = σ z / 4, ψ = -σ z / 2: σ_xx = σ, the rest 0; u = σ x / E, v = -ν σ y / E.
  const double sigma = 3.0;
  const PolynomialField tension{{0.0, 0.25 * sigma}, {0.0, -0.5 * sigma}};
  const Complex z{2.0, 1.5};
  EXPECT_NEAR(stress(tension, z).xx, sigma, 1e-15);
  EXPECT_NEAR(stress(tension, z).yy, 0.0, 1e-15);
  EXPECT_NEAR(displacement(tension, body, z).real(), sigma * 2.0 / 200.0, 1e-16);
  EXPECT_NEAR(displacement(tension, body, z).imag(), -0.25 * sigma * 1.5 / 200.0, 1e-16);
  EXPECT_THROW(static_cast<void>(polynomial_field(0, 0)), std::invalid_argument);
}

TEST(PlaneBody, EffectiveConstants) {
  EXPECT_NEAR(effective_modulus(plane_stress(7.0, 0.3)), 7.0, 1e-14);
  EXPECT_NEAR(effective_modulus(plane_strain(7.0, 0.3)), 7.0 / (1.0 - 0.09), 1e-14);
  EXPECT_NEAR(effective_poisson_ratio(plane_stress(7.0, 0.3)), 0.3, 1e-15);
  EXPECT_NEAR(effective_poisson_ratio(plane_strain(7.0, 0.3)), 0.3 / 0.7, 1e-15);
}

TEST(Bodies, AreElastic) {
  for (const PlaneBody& body : {plane_strain(10.0, 0.3), plane_stress(10.0, 0.3)}) {
    expect_elastic({[&](Complex z) { return pure_bending(2.0, body, z); },
                    [](Complex z) {
                      return PlaneStress{2.0 * z.imag(), 0.0, 0.0};
                    }},
                   body, {0.4, 0.3}, 1.0);
    expect_elastic({[&](Complex z) { return own_weight(3.0, 5.0, body, z); },
                    [](Complex z) { return own_weight_stress(3.0, 5.0, z); },
                    {0.0, -3.0}},
                   body, {0.4, 2.0}, 1.0);
    expect_elastic({[&](Complex z) { return end_loaded_cantilever(1.5, 8.0, 2.0, body, z); },
                    [](Complex z) { return end_loaded_cantilever_stress(1.5, 2.0, z); }},
                   body, {3.0, 0.4}, 1.0);
    const Ring ring{1.0, 3.0, 4.0, 0.5};
    const auto turned = [](Complex z, RingState state) {
      const double c = z.real() / std::abs(z), s = z.imag() / std::abs(z);
      return PlaneStress{c * c * state.radial_stress + s * s * state.hoop_stress,
                         s * s * state.radial_stress + c * c * state.hoop_stress,
                         c * s * (state.radial_stress - state.hoop_stress)};
    };
    expect_elastic(
        {[&](Complex z) { return z / std::abs(z) * ring_state(ring, body, std::abs(z)).radial_displacement; },
         [&](Complex z) { return turned(z, ring_state(ring, body, std::abs(z))); }},
        body, {1.2, 0.9}, 1.0);
    EXPECT_NEAR(ring_state(ring, body, 1.0).radial_stress, -4.0, 1e-14);
    EXPECT_NEAR(ring_state(ring, body, 3.0).radial_stress, -0.5, 1e-14);
  }
}

TEST(Bodies, CantileverIsClampedAndCarriesItsLoad) {
  const PlaneBody body = plane_stress(10.0, 0.3);
  const double P = 1.5, L = 8.0, h = 2.0;
  EXPECT_NEAR(std::abs(end_loaded_cantilever(P, L, h, body, {L, 0.0})), 0.0, 1e-13);
  double shear = 0.0;  // Simpson's rule is exact for the parabola
  const double tau[] = {end_loaded_cantilever_stress(P, h, {0.0, -1.0}).xy,
                        end_loaded_cantilever_stress(P, h, {0.0, 0.0}).xy,
                        end_loaded_cantilever_stress(P, h, {0.0, 1.0}).xy};
  shear = h / 6.0 * (tau[0] + 4.0 * tau[1] + tau[2]);
  EXPECT_NEAR(shear, -P, 1e-14);
  // The slender limit of the deflection: P L³ / (3 E I).
  EXPECT_NEAR(end_loaded_cantilever(P, L, h, body, {0.0, 0.0}).imag(), P * L * L * L / (3.0 * 10.0 * h * h * h / 12.0),
              1e-12);
}

}  // namespace
}  // namespace sunder::exact
