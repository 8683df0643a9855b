#include "solver/fracture/stress_intensity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/fracture/tests/cracked_plate.hpp"
#include "solver/fracture/williams.hpp"

namespace sunder::fracture {
namespace {

using testing::divided;
using testing::edge_cracked_plate;
using testing::make_plate;
using testing::open_boundary;
using testing::Plate;
using testing::state;

constexpr double pi = std::numbers::pi;
constexpr material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
constexpr Extraction all_extractions[] = {Extraction::reciprocity, Extraction::energy_projection,
                                          Extraction::crack_opening_displacement, Extraction::m_integral,
                                          Extraction::pointwise_stress};
constexpr Extraction order_2p_extractions[] = {Extraction::reciprocity, Extraction::energy_projection,
                                               Extraction::crack_opening_displacement, Extraction::m_integral};

// Edge crack a/W = ½, half height H/W = 1 in tension: F = K_I / (σ √(π a)) and T / σ, self-converged to 2e-10 and 2e-8.
constexpr double F_tension = 2.8254653223, T_tension = -0.41019754;

Plate reference_plate(int order, const material::Isotropic& material = solid) {
  return make_plate(open_boundary(edge_cracked_plate(0.5, 1.0, {2, 2, 4, 2, 2}), order), material);
}

Plate square(int order, double angle, const material::Isotropic& material = solid) {
  std::vector<Eigen::Vector2d> corners{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}};
  for (Eigen::Vector2d& corner : corners) corner = Eigen::Rotation2Dd(angle) * corner;
  return make_plate(open_boundary(corners, order), material);
}

struct WilliamsCase {
  int order;
  double bar,
      pointwise_bar;  // ten times the prototype's error of the slowest extraction of order 2p, and of the stress
};

TEST(StressIntensity, OfWilliamsFieldsOnAPolygonIsOne) {
  const WilliamsCase cases[] = {
      {1, 0.6, 3.0}, {2, 3.3e-2, 0.35}, {4, 3e-4, 4.8e-2}, {8, 3e-9, 5e-4}, {12, 1e-11, 1e-6}};
  for (const auto plane : {material::Plane::strain, material::Plane::stress}) {
    const material::Isotropic concrete{.youngs_modulus = 30e9, .poisson_ratio = 0.2, .plane = plane};
    for (const WilliamsCase& c : cases) {
      for (const double angle : {0.0, -1.1}) {
        const Plate plate = square(c.order, angle, concrete);
        const TipFrame frame = tip_frame(plate.boundary);
        const Eigen::VectorXd u = 2.0 * nodal_displacement({1, Mode::I}, plate.material, plate.boundary, frame) -
                                  3.0 * nodal_displacement({1, Mode::II}, plate.material, plate.boundary, frame) +
                                  0.7 * nodal_displacement({2, Mode::I}, plate.material, plate.boundary, frame) +
                                  1e-9 * nodal_displacement({2, Mode::II}, plate.material, plate.boundary, frame);
        for (const Extraction extraction : all_extractions) {
          const TipState at_tip = state(plate, u, {}, extraction);
          const double bar = extraction == Extraction::pointwise_stress ? c.pointwise_bar : c.bar;
          EXPECT_NEAR(at_tip.factors.K_I, 2.0, 2.0 * bar)
              << "order " << c.order << ", " << static_cast<int>(extraction);
          EXPECT_NEAR(at_tip.factors.K_II, -3.0, 3.0 * bar)
              << "order " << c.order << ", " << static_cast<int>(extraction);
        }
        // A uniform σ_xx and a rotation are exact at any order; the singular fields leak into T by the discretisation.
        EXPECT_NEAR(state(plate, u).T_stress, 0.7, 2.0 * c.bar) << "order " << c.order;
      }
    }
  }
}

TEST(StressIntensity, OfTheEdgeCrackedPlateMeetsTheConvergedFigures) {
  struct Case {
    int order;
    double bar, T_bar;
  };
  for (const Case& c : {Case{4, 1e-4, 1e-3}, Case{6, 1e-6, 1e-4}, Case{8, 1e-8, 1e-6}, Case{10, 1e-9, 1e-6}}) {
    const Plate plate = reference_plate(c.order);
    const Eigen::VectorXd u = testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0));
    for (const Extraction extraction : order_2p_extractions) {
      const TipState at_tip = state(plate, u, {}, extraction);
      EXPECT_NEAR(at_tip.factors.K_I / std::sqrt(pi * 0.5) / F_tension, 1.0, c.bar) << "order " << c.order;
      EXPECT_NEAR(at_tip.factors.K_II, 0.0, 1e-10) << "order " << c.order;
      EXPECT_NEAR(at_tip.T_stress / T_tension, 1.0, c.T_bar) << "order " << c.order;
    }
  }
}

TEST(StressIntensity, IncludesThePressureOnTheFaces) {
  // Uniform pressure is remote tension by superposition; the other two are self-converged to 1e-10.
  const double F[] = {F_tension, 1.4977681872, 1.0519108385}, T[] = {T_tension, 0.4052391, 0.3114611};
  const Plate plate = reference_plate(10);
  for (int k = 0; k < 3; ++k) {
    std::vector<double> pressure(k + 1, 0.0);
    pressure[k] = 1.0;
    const std::vector<sbfem::RadialLoad> loads = sbfem::crack_face_pressure(plate.boundary, pressure);
    const Eigen::VectorXd u = testing::free_displacement(plate, sbfem::load_vector(plate.solution, loads));
    for (const Extraction extraction : order_2p_extractions) {
      const TipState at_tip = state(plate, u, loads, extraction);
      EXPECT_NEAR(at_tip.factors.K_I / std::sqrt(pi * 0.5) / F[k], 1.0, 1e-9) << "power " << k;
      EXPECT_NEAR(at_tip.factors.K_II, 0.0, 1e-10);
      EXPECT_NEAR(at_tip.T_stress / T[k], 1.0, 1e-6) << "power " << k;  // T is given to seven digits
    }
  }
}

TEST(StressIntensity, OfUniformFacePressureEqualsRemoteTensionAtEveryOrder) {
  // The uncracked plate under tension is a linear field, exact at order 1 and without singular modes: by modes the
  // superposition holds at any order, to the round-off of two solutions with a stiffness of condition 1e5. Reciprocity
  // weighs that field with interpolated exterior fields and keeps an error of the order 2p of everything else.
  struct Case {
    Extraction extraction;
    int order;
    double bar, T_bar;
  };
  for (const Case& c :
       {Case{Extraction::energy_projection, 1, 1e-9, 1e-9}, Case{Extraction::energy_projection, 5, 1e-9, 1e-9},
        Case{Extraction::m_integral, 2, 1e-9, 1e-9}, Case{Extraction::reciprocity, 1, 0.15, 0.15},
        Case{Extraction::reciprocity, 2, 8e-3, 3e-2}, Case{Extraction::reciprocity, 4, 3e-5, 3e-4}}) {
    const Plate plate = reference_plate(c.order);
    const TipState remote =
        state(plate, testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0)), {},
              c.extraction);
    const double pressure[] = {1.0};
    const std::vector<sbfem::RadialLoad> loads = sbfem::crack_face_pressure(plate.boundary, pressure);
    const TipState faces =
        state(plate, testing::free_displacement(plate, sbfem::load_vector(plate.solution, loads)), loads, c.extraction);
    EXPECT_NEAR(faces.factors.K_I / remote.factors.K_I, 1.0, c.bar) << "order " << c.order;
    EXPECT_NEAR(faces.T_stress / remote.T_stress, 1.0, c.T_bar) << "order " << c.order;
  }
}

TEST(StressIntensity, OfTheClampedPlateInShear) {
  // W = 7, L = 16, a = 3.5, unit shear on top, base held, plane strain ν = .25; sides graded towards the held corners,
  // where stresses are weakly singular. Self-converged to 1e-6.
  const double K_I = 34.04254, K_II = 4.53694;
  std::vector<Eigen::Vector2d> v{{-3.5, 0}, {-3.5, -4}, {-3.5, -6.8}, {-3.5, -7.76}, {-3.5, -7.952}, {-3.5, -8}};
  for (const double x : {-3.46, -3.3, -2.5, 0.0, 2.5, 3.3, 3.46}) v.emplace_back(x, -8);
  for (const double y : {-8.0, -7.952, -7.76, -6.8, -4.0, 0.0, 4.0, 8.0}) v.emplace_back(3.5, y);
  for (const auto& corner : {Eigen::Vector2d(0, 8), {-3.5, 8}, {-3.5, 4}, {-3.5, 0}}) v.push_back(corner);
  const Plate plate = make_plate(open_boundary(v, 6), {.youngs_modulus = 1.0, .poisson_ratio = 0.25});
  Eigen::VectorXd load = Eigen::VectorXd::Zero(plate.boundary.nodes.size());
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < plate.boundary.orders.size(); ++e) {
    const Eigen::Vector2d a = plate.boundary.nodes.col(start), b = plate.boundary.nodes.col(start + 6);
    if (a.y() == 8.0 && b.y() == 8.0)
      load += sbfem::edge_traction(plate.boundary, static_cast<int>(e), Eigen::Matrix2Xd(Eigen::Vector2d(1, 0)));
    start += 6;
  }
  const Eigen::VectorXd u =
      testing::clamped_displacement(plate, load, [](const Eigen::Vector2d& x) { return x.y() < -8.0 + 1e-9; });
  for (const Extraction extraction : order_2p_extractions) {
    const TipState at_tip = state(plate, u, {}, extraction);
    EXPECT_NEAR(at_tip.factors.K_I / K_I, 1.0, 1e-5);
    EXPECT_NEAR(at_tip.factors.K_II / K_II, 1.0, 1e-5);
    EXPECT_NEAR(at_tip.T_stress / 2.72542, 1.0, 1e-4);
  }
}

TEST(StressIntensity, TurnsWithThePlate) {
  const Plate straight = reference_plate(5);
  const Eigen::VectorXd u =
      testing::free_displacement(straight, testing::remote_tension(straight.boundary, {0, 1}, 1.0));
  const TipState expected = state(straight, u);
  for (const double angle : {0.4, -2.5, pi / 2, pi}) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    std::vector<Eigen::Vector2d> corners = edge_cracked_plate(0.5, 1.0, {2, 2, 4, 2, 2});
    for (Eigen::Vector2d& corner : corners) corner = turn * corner;
    const Plate turned = make_plate(open_boundary(corners, 5), solid);
    const Eigen::VectorXd v =
        testing::free_displacement(turned, testing::remote_tension(turned.boundary, turn.col(1), 1.0));
    for (const Extraction extraction : all_extractions) {
      const TipState original = state(straight, u, {}, extraction);
      const TipState at_tip = state(turned, v, {}, extraction);
      // Another orientation rounds differently everywhere; the discretisation is the same.
      EXPECT_NEAR(at_tip.factors.K_I, original.factors.K_I, 1e-10);
      EXPECT_NEAR(at_tip.factors.K_II, original.factors.K_II, 1e-10);
      EXPECT_NEAR(at_tip.T_stress, expected.T_stress, 1e-3);
    }
    const CrackTip tip = crack_tip(turned.boundary, turned.coefficients, turned.solution, solid);
    EXPECT_NEAR(std::remainder(tip.direction - angle, 2.0 * pi), 0.0, 1e-14);
    EXPECT_NEAR(tip.face_length, 0.5, 1e-14);
  }
}

TEST(StressIntensity, IsNegativeWhereTheFacesOverlap) {
  const Plate plate = reference_plate(3);
  const Eigen::VectorXd u = testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, -1.0));
  for (const Extraction extraction : all_extractions) EXPECT_LT(state(plate, u, {}, extraction).factors.K_I, -1.0);
}

TEST(StressIntensity, IsTheSameInPlaneStressAndStrainUnderForces) {
  // Under given tractions on a simply connected body the stresses do not depend on the elastic constants [Michell
  // 1899].
  const auto factors = [](const material::Isotropic& material) {
    const Plate plate = reference_plate(8, material);
    return state(plate, testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0)), {},
                 Extraction::crack_opening_displacement);
  };
  const TipState strain = factors({.youngs_modulus = 7.0, .poisson_ratio = 0.35});
  const TipState stress = factors({.youngs_modulus = 7.0, .poisson_ratio = 0.35, .plane = material::Plane::stress});
  EXPECT_NEAR(strain.factors.K_I / stress.factors.K_I, 1.0, 1e-8);
  EXPECT_NEAR(strain.T_stress / stress.T_stress, 1.0, 1e-6);
}

TEST(StressIntensity, IncludesOwnWeight) {
  // The plate hangs from its top: the uncracked field σ_yy = γ (y + H) opens the crack. By superposition K_I is that of
  // face pressure γ H, and the load is radial in one description and a boundary load in the other.
  const Plate plate = reference_plate(8);
  const double gamma = 0.6, H = 1.0;
  const std::vector<sbfem::RadialLoad> weight{sbfem::body_force(plate.boundary, {0.0, -gamma})};
  Eigen::VectorXd load = sbfem::load_vector(plate.solution, weight);
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < plate.boundary.orders.size(); ++e) {
    const Eigen::Vector2d a = plate.boundary.nodes.col(start);
    const Eigen::Vector2d b = plate.boundary.nodes.col(start + plate.boundary.orders[e]);
    if (a.y() == H && b.y() == H) {
      load += sbfem::edge_traction(plate.boundary, static_cast<int>(e),
                                   Eigen::Matrix2Xd(Eigen::Vector2d(0, 2.0 * gamma * H)));
    }
    start += plate.boundary.orders[e];
  }
  const Eigen::VectorXd u = testing::free_displacement(plate, load);
  for (const Extraction extraction : order_2p_extractions) {
    const TipState at_tip = state(plate, u, weight, extraction);
    EXPECT_NEAR(at_tip.factors.K_I / (gamma * H * F_tension * std::sqrt(pi * 0.5)), 1.0, 1e-8);
    EXPECT_NEAR(at_tip.T_stress / (gamma * H * T_tension), 1.0, 1e-6);
  }
}

TEST(CrackTip, SaysThatAPolygonIsNoCrack) {
  Plate plate = square(2, 0.0);
  plate.solution.A *= 1.4;
  const CrackTip tip = crack_tip(plate.boundary, plate.coefficients, plate.solution, solid);
  EXPECT_EQ(tip.status, TipStatus::not_a_crack);
  EXPECT_EQ(tip.of_displacement.norm(), 0.0);
}

TEST(CrackTip, WorksWithoutExponentsByReciprocity) {
  const Plate plate = square(4, 0.0);
  const CrackTip with = crack_tip(plate.boundary, plate.coefficients, plate.solution, solid);
  const CrackTip without = crack_tip(plate.boundary, plate.coefficients, plate.solution, solid, {.exponents = false});
  EXPECT_EQ(with.of_displacement, without.of_displacement);
  EXPECT_NEAR(with.exponents[0].real(), 0.5, 1e-5);  // 3e-6 at order 4
  EXPECT_EQ(without.exponents[0], 0.0);
}

}  // namespace
}  // namespace sunder::fracture
