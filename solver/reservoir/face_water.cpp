#include "solver/reservoir/face_water.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/convolution/contour_weights.hpp"
#include "solver/numerics/planted_fault.hpp"
#include "solver/reservoir/rank_one_root.hpp"

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;

/// √ with Re > 0; on the imaginary axis of s, where Re = 0, the wave that runs away: +i for exp(iωt).
Complex outgoing_root(Complex x) {
  const Complex root = std::sqrt(x);
  const bool outwards = root.real() > 0.0 || (root.real() == 0.0 && root.imag() >= 0.0);
  if (numerics::planted_fault("reservoir/incoming-wave")) return x.real() < 0.0 ? std::conj(root) : root;
  return outwards ? root : -root;
}

void check_step(double time_step, long long last) {
  if (!(time_step > 0.0) || !std::isfinite(time_step))
    throw std::invalid_argument("reservoir: time_step = " + std::to_string(time_step) + " s must be finite and > 0");
  if (last < 0 || last > (1LL << 26))
    throw std::invalid_argument("reservoir: steps = " + std::to_string(last) + " must be 0 … 2^26");
}

}  // namespace

void check(const Water& water) {
  const auto need = [](bool good, const char* name, double value, const char* bound) {
    if (!good)
      throw std::invalid_argument(std::string("water: ") + name + " = " + std::to_string(value) + " must be " + bound);
  };
  need(water.density > 0.0 && std::isfinite(water.density), "density", water.density, "finite and > 0 kg/m³");
  need(water.sound_speed > 0.0 && std::isfinite(water.sound_speed), "sound_speed", water.sound_speed,
       "finite and > 0 m/s");
  need(water.reflection_coefficient >= 0.0 && water.reflection_coefficient <= 1.0, "reflection_coefficient",
       water.reflection_coefficient, "0 … 1");
}

double bottom_damping(const Water& water) {
  const double sign = numerics::planted_fault("reservoir/bottom-sign") ? -1.0 : 1.0;
  return sign * (1.0 - water.reflection_coefficient) / (1.0 + water.reflection_coefficient);
}

FaceModes face_modes(const PressureMesh& mesh, const Water& water) {
  check(water);
  // A φ = λ K φ with λ = 1/k²: the low modes are the large eigenvalues, exact to round-off even where a sliver of an
  // element below the surface makes the highest wave number 1e9 times the lowest.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(mesh.mass, mesh.stiffness);
  const Eigen::VectorXd flexibility =
      solver.eigenvalues().reverse().cwiseMax(std::numeric_limits<double>::epsilon() * solver.eigenvalues().maxCoeff());
  FaceModes modes{.water = water, .depth = mesh.depth(), .wavenumber_squared = flexibility.cwiseInverse()};
  modes.shapes = solver.eigenvectors().rowwise().reverse() * flexibility.cwiseSqrt().cwiseInverse().asDiagonal();
  modes.load = modes.shapes.transpose() * mesh.load;
  modes.bottom = modes.shapes.row(0).transpose();
  // distinct, as the roots need them: in a chain of elements they are, but for those that round-off made equal above
  for (Eigen::Index j = 1; j < modes.wavenumber_squared.size(); ++j)
    modes.wavenumber_squared[j] =
        std::fmax(modes.wavenumber_squared[j], modes.wavenumber_squared[j - 1] * (1.0 + 1e-9));
  return modes;
}

FaceResponse face_response(const FaceModes& modes, Complex s) {
  const Complex S = s / modes.water.sound_speed, S2 = S * S;
  const double damping = bottom_damping(modes.water);
  RankOneRoot root(modes.wavenumber_squared, modes.bottom);
  root.decompose(S * damping, true);
  FaceResponse response;
  Eigen::VectorXcd scale(root.values().size());
  for (Eigen::Index j = 0; j < scale.size(); ++j) {
    const Complex x = S2 + root.values()[j];
    if (std::abs(x) <= 8.0 * std::numeric_limits<double>::epsilon() * std::abs(S2)) {
      response.infinite = true;
      return response;
    }
    scale[j] = modes.water.density / outgoing_root(x);
  }
  const Eigen::MatrixXcd V = root.vectors();
  const Eigen::MatrixXcd along = V.transpose() * modes.load.cast<Complex>();  // (m, n)
  const Eigen::MatrixXcd amplitude = scale.asDiagonal() * along;
  response.mass = along.transpose() * amplitude;
  response.pressure = modes.shapes.cast<Complex>() * (V * amplitude);
  return response;
}

convolution::WeightSequence face_weights(const FaceModes& modes, double time_step, long long last,
                                         numerics::ThreadPool* pool) {
  check_step(time_step, last);
  const int n = modes.size();
  const Eigen::Index m = modes.load.rows();
  const double damping = bottom_damping(modes.water), density = modes.water.density, c = modes.water.sound_speed;
  struct Work {
    RankOneRoot root;
    Eigen::MatrixXd real, imaginary;  // parts of Vᵀ G, then scaled
    Eigen::MatrixXcd along, scaled;
  };
  std::vector<Work> work(convolution::contour_runs,
                         Work{RankOneRoot(modes.wavenumber_squared, modes.bottom), {}, {}, {}, {}});
  const convolution::LaplaceMass mass = [&](const convolution::ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> M) {
    Work& mine = work[static_cast<std::size_t>(at.run)];
    const Complex S = at.s / c;
    mine.root.decompose(S * damping, at.first);
    mine.real.noalias() = mine.root.vectors().real().transpose() * modes.load;
    mine.imaginary.noalias() = mine.root.vectors().imag().transpose() * modes.load;
    mine.along.resize(m, n);
    mine.along.real() = mine.real;
    mine.along.imag() = mine.imaginary;
    mine.scaled = mine.along;
    for (Eigen::Index j = 0; j < m; ++j) mine.scaled.row(j) *= density / outgoing_root(S * S + mine.root.values()[j]);
    M.triangularView<Eigen::Lower>() = mine.along.transpose() * mine.scaled;
  };
  return convolution::contour_weights(n, time_step, last, mass, {.pool = pool});
}

convolution::WeightSequence modal_weights(const FaceModes& modes, double time_step, long long last) {
  check_step(time_step, last);
  const Eigen::Index m = modes.load.rows();
  const double c = modes.water.sound_speed;
  convolution::WeightSequence weights{static_cast<int>(m), true, Eigen::MatrixXd(m, last + 1)};
  Eigen::ArrayXd x(m), front(m), now = Eigen::ArrayXd::Ones(m), before = Eigen::ArrayXd::Zero(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const double t = 0.5 * std::sqrt(modes.wavenumber_squared[k]) * c * time_step;
    x[k] = (1.0 - t) * (1.0 + t) / (1.0 + t * t);
    front[k] = 0.5 * modes.water.density * c * time_step / std::sqrt(1.0 + t * t);
  }
  for (long long j = 0; j <= last; ++j) {
    weights.values.col(j) = front * (now + before);
    const double order = static_cast<double>(j);
    const Eigen::ArrayXd next = ((2.0 * order + 1.0) * x * now - order * before) / (order + 1.0);
    before = now;
    now = next;
  }
  return weights;
}

}  // namespace sunder::reservoir
