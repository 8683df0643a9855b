#include "solver/foundation/impulse_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/foundation/curved_line.hpp"
#include "solver/foundation/tests/lines.hpp"

namespace sunder::foundation {
namespace {

/// The plane-strain closed form, inverted by an independent program (uncertainty 5e-8, its last digit).
TEST(ImpulseResponse, OfARigidDiscInTheFullPlaneIsTheExactOne) {
  const UnboundedDomain domain = unbounded_domain(curved_coefficients(circle(1.0, 6, 6, false), unit_rock));
  const std::vector<double> times{0.1, 0.5, 1.0, 2.0, 5.0, 10.0};
  const std::vector<double> exact{9.0318017, 10.6762960, 12.5620005, 16.0763695, 25.3203945, 38.4740437};
  const ImpulseSamples samples = impulse_response(domain, times);
  ASSERT_EQ(samples.status, StiffnessStatus::converged);
  // The header's 1e-8 of the largest M, twice for the reference's last digit.
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(translation(samples.M[i], 0), exact[i], 2e-8 * exact.back()) << times[i];
}

TEST(ImpulseResponse, BeginsWithTheRadiationOfPlaneWaves) {
  const sbfem::Boundary line = block_line(1.0, 0.5, 8, 2, 4);
  const std::vector<double> begin{0.0};
  const Eigen::MatrixXd C = impulse_response(unbounded_domain(sbfem::coefficients(line, unit_rock)), begin).M.front();
  // Σ_xx = 2 d ρ c_p + 2 b ρ c_s; corners, where the normal jumps, are met to 1 %.
  EXPECT_NEAR(translation(C, 0), 2 * 0.5 * std::sqrt(3.0) + 2.0, 0.01 * 3.73);
  EXPECT_NEAR(translation(C, 1), 2 * 0.5 + 2.0 * std::sqrt(3.0), 0.01 * 4.46);
}

/// The second route knows no frequency: it must approach the first with the square of its step.
TEST(ImpulseResponse, OfABlockIsWhatTheMarchConvergesTo) {
  const UnboundedDomain domain = unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 4), unit_rock));
  const std::vector<double> times{1.0, 2.0, 4.0};
  const ImpulseSamples exact = impulse_response(domain, times);
  ASSERT_EQ(exact.status, StiffnessStatus::converged);
  std::vector<double> errors;
  for (const double dt : {0.2, 0.1, 0.05}) {
    const ImpulseSamples march = march_impulse_response(domain, dt, static_cast<int>(std::lround(4.0 / dt)));
    ASSERT_EQ(march.status, StiffnessStatus::converged);
    errors.push_back((march.M[static_cast<std::size_t>(std::lround(4.0 / dt))] - exact.M[2]).norm() /
                     exact.M[2].norm());
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.3);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.15);
  EXPECT_LT(errors[2], 1e-4);
}

TEST(ImpulseResponse, RefusesNegativeTimesAndEmptyMarches) {
  const UnboundedDomain domain = unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 1), unit_rock));
  const std::vector<double> negative{-1.0}, nan{NAN};
  EXPECT_THROW((void)impulse_response(domain, negative), std::invalid_argument);
  EXPECT_THROW((void)impulse_response(domain, nan), std::invalid_argument);
  EXPECT_THROW((void)march_impulse_response(domain, 0.0, 3), std::invalid_argument);
  EXPECT_THROW((void)march_impulse_response(domain, 0.1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::foundation
