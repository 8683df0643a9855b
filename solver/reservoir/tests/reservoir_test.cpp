/// Water on a vertical face against series, closed forms and independent numbers.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "solver/reservoir/added_mass.hpp"
#include "solver/reservoir/face.hpp"
#include "solver/reservoir/face_water.hpp"
#include "solver/reservoir/rank_one_root.hpp"
#include "solver/reservoir/rigid_face.hpp"

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double incompressible_force = 0.5427545144;  // 14 ζ(3)/π³
constexpr double base_pressure = 0.7424537454;         // 8 G/π²

double total(const Eigen::MatrixXd& mass) {
  return mass.sum();
}

/// Nodes where no two elements are alike.
Face uneven_face(double height, int order) {
  Face face = uniform_face(height, 7, order);
  for (double& y : face.heights) y = height * (0.7 * y / height + 0.3 * (y / height) * (y / height));
  // back to Gauss-Lobatto points inside each element
  const Face unit = uniform_face(1.0, 1, order);
  for (const std::vector<int>& nodes : face.elements) {
    const double low = face.heights[nodes.front()], high = face.heights[nodes.back()];
    for (int i = 1; i < order; ++i) face.heights[nodes[i]] = low + (high - low) * unit.heights[i];
  }
  return face;
}

TEST(RigidFace, HasTheForceOfTheIndependentSeries) {
  struct Sample {
    double r;
    Complex twice_force;
  };
  // 2F/(ρ a H²), computed before this program with numpy by two routes that agree to 1e-8
  const double damping = 1.0 / 7.0;
  for (const Sample& s : {Sample{0.5, {1.23828747, -0.06619627}}, Sample{0.9, {1.98367110, -0.67646857}},
                          Sample{1.1, {0.82450675, -1.79093472}}, Sample{2.0, {0.11695921, -0.61098814}},
                          Sample{3.5, {0.02003133, -0.37031091}}}) {
    const RigidFaceResponse response = rigid_face_response(s.r * pi / 2.0, damping);
    ASSERT_EQ(response.status, SeriesStatus::converged);
    EXPECT_LE(std::abs(2.0 * response.force - s.twice_force), 3e-8) << s.r;
  }
  for (const Sample& s : {Sample{0.5, 1.24576285}, Sample{0.9, 2.42316308}, Sample{1.1, {0.05658495, -2.25211578}},
                          Sample{2.0, {0.06746356, -0.59585383}}, Sample{3.5, {0.01920859, -0.37130624}}})
    EXPECT_LE(std::abs(2.0 * rigid_face_response(s.r * pi / 2.0, 0.0).force - s.twice_force), 3e-8) << s.r;
  const RigidFaceResponse still = rigid_face_response(0.0, damping);
  EXPECT_NEAR(still.force.real(), incompressible_force, 1e-9);
  EXPECT_NEAR(still.base_pressure.real(), base_pressure, 1e-9);
}

TEST(RigidFace, IsInfiniteAtItsNaturalFrequenciesAndSaysSo) {
  for (const double r : {1.0, 3.0, 5.0}) {
    EXPECT_EQ(rigid_face_response(r * pi / 2.0, 0.0).status, SeriesStatus::infinite);
    EXPECT_EQ(rigid_face_response(r * pi / 2.0, 1e-6).status, SeriesStatus::converged);
  }
  EXPECT_THROW((void)rigid_face_response(-1.0, 0.0), std::invalid_argument);
  EXPECT_THROW((void)rigid_face_response(NAN, 0.0), std::invalid_argument);
}

TEST(RigidFace, AnswersToAnImpulse) {
  EXPECT_NEAR(rigid_face_impulse(1.0), 0.36338023, 1e-8);
  EXPECT_NEAR(rigid_face_impulse(2.0 + 1e-9), -0.27323954, 1e-8);  // series where the closed form ends
  EXPECT_NEAR(rigid_face_impulse(5.0), 0.15714237, 1e-8);
  EXPECT_NEAR(rigid_face_impulse(10.0), -0.12645253, 1e-8);
  EXPECT_NEAR(rigid_face_impulse(20.0), 0.08976500, 1e-8);
  EXPECT_NEAR(rigid_face_impulse(40.0), 0.06359431, 1e-8);
  EXPECT_NEAR(absorbing_face_impulse(1.0, 1.0 / 7.0), 1.0 - 2.0 / pi * 1.1001152891, 1e-10);
  EXPECT_THROW((void)absorbing_face_impulse(1.5, 0.1), std::invalid_argument);
}

TEST(AddedMass, HasTheTotalsOfTheClosedForms) {
  for (const int order : {1, 2, 3, 6})
    for (const Face& face : {uniform_face(50.0, 8, order), uneven_face(50.0, order)})
      for (const double level : {50.0, 47.3, 50.0 * (1.0 - 1e-7)}) {
        SCOPED_TRACE(100 * order + level);
        const double scale = 1000.0 * level * level;
        // round-off for the polynomial; the incompressible sum ends within 1e-8
        EXPECT_NEAR(total(westergaard_mass(face, level, 1000.0)) / scale, 7.0 / 12.0, 1e-13);
        EXPECT_NEAR(total(incompressible_mass(face, level, 1000.0)) / scale, incompressible_force, 2e-8);
        EXPECT_NEAR(hydrostatic_force(face, level, 1000.0, 9.81).sum() / (9.81 * scale), 0.5, 1e-13);
        const double moment = face.heights.dot(hydrostatic_force(face, level, 1000.0, 9.81));
        EXPECT_NEAR(moment / (9.81 * scale * level), 1.0 / 6.0, 1e-13);
      }
}

/// Largest relative error of the force over the spectrum.
double spectrum_error(const Face& face, double level, double alpha) {
  const Water water{.reflection_coefficient = alpha};
  const FaceModes modes = face_modes(pressure_mesh(face, level), water);
  double worst = 0.0;
  for (const double r : {0.0, 0.5, 0.9, 1.1, 2.0, 3.5}) {
    const double kappa = r * pi / 2.0;
    const FaceResponse response = face_response(modes, Complex(0.0, kappa * water.sound_speed / level));
    const Complex exact = rigid_face_response(kappa, bottom_damping(water)).force;
    worst = std::fmax(worst, std::abs(response.mass.sum() / (water.density * level * level) - exact) / std::abs(exact));
  }
  return worst;
}

TEST(FaceWater, ConvergesToTheRigidFace) {
  for (const double alpha : {0.0, 0.5, 0.75, 1.0}) {
    EXPECT_LE(spectrum_error(uniform_face(100.0, 10, 2), 100.0, alpha), 1e-3) << alpha;
    double before = 1.0;
    for (const int elements : {5, 10, 20, 40}) {
      const double error = spectrum_error(uniform_face(100.0, elements, 1), 100.0, alpha);
      if (before < 1.0) {
        EXPECT_NEAR(std::log2(before / error), 2.0, 0.35) << alpha << " " << elements;
      }
      before = error;
    }
  }
}

TEST(FaceWater, LevelMayLieAnywhere) {
  const Face face = uniform_face(100.0, 10, 2);
  for (const double level :
       {100.0, 97.0, 93.7, 90.0 + 1e-3, 90.0 + 1e-6, 90.0 + 1e-12, 90.0, 90.0 - 1e-12, 90.0 - 1e-6})
    for (const double alpha : {0.75, 1.0}) EXPECT_LE(spectrum_error(face, level, alpha), 2e-3) << level;
  EXPECT_THROW((void)pressure_mesh(face, 100.1), std::invalid_argument);
  EXPECT_THROW((void)pressure_mesh(face, 0.0), std::invalid_argument);
}

TEST(FaceWater, TwoNodesAtTheMouthOfACrackChangeNothing) {
  const Face whole = uniform_face(100.0, 10, 2);
  Face split = whole;
  split.heights.conservativeResize(whole.size() + 1);
  split.heights[whole.size()] = split.heights[split.elements[6].front()];
  split.elements[6].front() = whole.size();
  const Complex s(3.0, 20.0);
  const Eigen::MatrixXcd a = face_response(face_modes(pressure_mesh(whole, 95.0), {}), s).mass;
  const Eigen::MatrixXcd b = face_response(face_modes(pressure_mesh(split, 95.0), {}), s).mass;
  EXPECT_LE(std::abs(a.sum() - b.sum()), 1e-12 * std::abs(a.sum()));
}

TEST(RankOneRoot, IsTheInverseRootOfTheFullMatrix) {
  const FaceModes modes = face_modes(pressure_mesh(uniform_face(100.0, 10, 2), 100.0), {});
  RankOneRoot root(modes.wavenumber_squared, modes.bottom);
  const Eigen::MatrixXd dyad = modes.bottom * modes.bottom.transpose();
  int rounds = 0, full = 0, count = 0;
  for (const double angle : {-1.57, -1.0, 0.0, 0.7, 1.5, 1.5707963})
    for (double size = 1e-9; size <= 1e6; size *= 10.0) {
      const Complex S = std::polar(size, angle), sigma = 0.3 * S;
      root.decompose(sigma, true);
      Eigen::MatrixXcd X = sigma * dyad.cast<Complex>();
      X.diagonal() += modes.wavenumber_squared.cast<Complex>();
      const Eigen::MatrixXcd& V = root.vectors();
      const Eigen::MatrixXcd back = V * root.values().asDiagonal() * V.transpose();
      EXPECT_LE((back - X).norm(), 1e-10 * X.norm()) << size << " " << angle;
      EXPECT_LE((V * V.transpose() - Eigen::MatrixXcd::Identity(V.rows(), V.cols())).norm(), 1e-8)
          << size << " " << angle;
      rounds += root.rounds();
      full += root.from_full_matrix() ? 1 : 0;
      ++count;
    }
  EXPECT_EQ(full, 0);
  EXPECT_LE(rounds, 25 * count);
}

TEST(FaceWeights, OverARigidBottomAreThoseOfTheModes) {
  const Water rigid{.reflection_coefficient = 1.0};
  const FaceModes modes = face_modes(pressure_mesh(uniform_face(100.0, 5, 2), 96.0), rigid);
  const convolution::WeightSequence dense = face_weights(modes, 0.01, 300), modal = modal_weights(modes, 0.01, 300);
  const double scale = dense.values.cwiseAbs().maxCoeff();
  for (int j = 0; j <= 300; ++j)
    EXPECT_LE((dense.dense(j) - modes.load.transpose() * modal.weight(j) * modes.load).norm(), 1e-9 * scale) << j;
}

TEST(FaceWeights, SumToTheMassOfIncompressibleWater) {
  const FaceModes modes = face_modes(pressure_mesh(uniform_face(100.0, 10, 2), 100.0), {});
  const convolution::WeightSequence weights = face_weights(modes, 0.01, 4000);  // T = 576: α^(T/2) = 1e-36
  double sum = 0.0;
  for (int j = 0; j <= 4000; ++j) sum += weights.dense(j).sum();
  const double still = face_response(modes, 0.0).mass.sum().real();
  EXPECT_NEAR(sum / still, 1.0, 1e-7);  // 4001 weights, each to 4e-11 of the largest
}

TEST(PressureFunctional, FindsThePressureFromTheForces) {
  const Face face = uniform_face(100.0, 10, 2);
  for (const double level : {100.0, 93.7, 90.0 + 1e-6}) {
    const PressureMesh mesh = pressure_mesh(face, level);
    const FaceModes modes = face_modes(mesh, {});
    const FaceResponse response = face_response(modes, Complex(1.0, 30.0));
    const Eigen::VectorXcd a = Eigen::VectorXd::LinSpaced(face.size(), 1.0, -2.0).cast<Complex>();
    for (const double height : {0.0, 41.0, 60.0, 89.9, 93.0}) {
      const Complex expected = mesh.values(height).cast<Complex>().dot(response.pressure * a);
      const Complex found = pressure_functional(mesh, height).cast<Complex>().dot(response.mass * a);
      EXPECT_LE(std::abs(found - expected), 1e-9 * (response.pressure * a).cwiseAbs().maxCoeff()) << level << height;
    }
  }
  EXPECT_EQ(pressure_functional(pressure_mesh(face, 93.7), 95.0).norm(), 0.0);
}

TEST(Water, RefusesWhatIsNoWater) {
  EXPECT_THROW(check({.density = 0.0}), std::invalid_argument);
  EXPECT_THROW(check({.sound_speed = -1.0}), std::invalid_argument);
  EXPECT_THROW(check({.reflection_coefficient = 1.01}), std::invalid_argument);
  EXPECT_THROW(check({.reflection_coefficient = -0.01}), std::invalid_argument);
  EXPECT_THROW(check({.reflection_coefficient = NAN}), std::invalid_argument);
  Face gap = uniform_face(10.0, 2, 1);
  gap.elements[1] = {2, 2};
  EXPECT_THROW((void)wet_elements(gap, 9.0), std::invalid_argument);
  EXPECT_THROW((void)uniform_face(10.0, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::reservoir
