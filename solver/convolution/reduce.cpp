// From weights to a state space: balanced truncation of their Hankel matrix, and the error that is left.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

#include "solver/convolution/hankel_product.hpp"
#include "solver/convolution/state_space.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::convolution {
namespace {

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

/// The dominant eigenvectors of the Hankel matrix, a block of them more where they do not suffice: each block is found
/// from a random start, outside the span of those before, by one step of the power method [Halko, Martinsson & Tropp
/// 2011].
class DominantVectors {
 public:
  explicit DominantVectors(const HankelProduct& hankel) : hankel_(&hankel), basis_(hankel.rows(), 0) {}

  void extend(int count);

  const Eigen::VectorXd& values() const { return values_; }  ///< (q) eigenvalues, largest modulus first
  /// VᵀV shifted by one block, and the first block of V, of the first `states` vectors.
  Eigen::MatrixXd shifted(int states);
  Eigen::MatrixXd first_block(int states) const;

 private:
  Eigen::MatrixXd outside(const Eigen::MatrixXd& columns) const;

  const HankelProduct* hankel_;
  std::mt19937_64 generator_{1};  // its bits are the same everywhere; the distributions of <random> are not
  Eigen::MatrixXd basis_;         // (rows, q), orthonormal
  Eigen::MatrixXd projected_;     // (q, q) basisᵀ H basis
  Eigen::MatrixXd shifted_;       // (q, q) basisᵀ basis shifted by one block; empty until asked for
  Eigen::VectorXd values_;
  Eigen::MatrixXd turn_;  // (q, q): V = basis · turn
};

/// An orthonormal basis of the part of `columns` outside the basis.
Eigen::MatrixXd DominantVectors::outside(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd rest = columns;
  for (int time = 0; time < 2; ++time) {  // the second time takes off what rounding has left
    if (basis_.cols() > 0) rest.noalias() -= basis_ * (basis_.transpose() * rest).eval();
    rest = orthonormal(rest);
  }
  return rest;
}

void DominantVectors::extend(int count) {
  const Eigen::Index old = basis_.cols(), all = old + count;
  Eigen::MatrixXd start(hankel_->rows(), count);
  for (double& x : start.reshaped()) x = static_cast<double>(generator_() >> 11) * 0x1p-52 - 1.0;
  const Eigen::MatrixXd block = outside(*hankel_ * outside(*hankel_ * start));
  const Eigen::MatrixXd image = *hankel_ * block;
  Eigen::MatrixXd basis(hankel_->rows(), all), projected(all, all);
  basis << basis_, block;
  basis_ = std::move(basis);
  projected.topLeftCorner(old, old) = projected_;
  projected.rightCols(count) = basis_.transpose() * image;
  projected.bottomLeftCorner(count, old) = projected.topRightCorner(old, count).transpose();
  projected_ = 0.5 * (projected + projected.transpose());
  shifted_.resize(0, 0);

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(projected_);
  std::vector<int> order(static_cast<std::size_t>(all));
  std::iota(order.begin(), order.end(), 0);
  const Eigen::VectorXd& values = solver.eigenvalues();
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return std::abs(values[a]) > std::abs(values[b]); });
  values_ = values(order);
  turn_ = solver.eigenvectors()(Eigen::all, order);
}

Eigen::MatrixXd DominantVectors::shifted(int states) {
  const int blocks = hankel_->blocks();
  if (shifted_.size() == 0) {
    // degree of freedom by degree of freedom
    Eigen::MatrixXd up = Eigen::MatrixXd::Zero(basis_.rows(), basis_.cols());
    for (Eigen::Index first = 0; first < basis_.rows(); first += blocks)
      up.middleRows(first, blocks - 1) = basis_.middleRows(first + 1, blocks - 1);
    shifted_.noalias() = basis_.transpose() * up;
  }
  const auto turn = turn_.leftCols(states);
  return turn.transpose() * (shifted_ * turn).eval();
}

Eigen::MatrixXd DominantVectors::first_block(int states) const {
  const int blocks = hankel_->blocks();
  Eigen::MatrixXd first(basis_.rows() / blocks, basis_.cols());
  for (Eigen::Index d = 0; d < first.rows(); ++d) first.row(d) = basis_.row(d * blocks);
  return first * turn_.leftCols(states);
}

/// Keeps of each pair of conjugates the one with a positive imaginary part, doubled.
void pair_conjugates(const Eigen::VectorXcd& decay, const Eigen::MatrixXcd& input, const Eigen::MatrixXcd& output,
                     StateSpaceModel& model) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < decay.size(); ++k)
    if (decay[k].imag() >= 0.0 && std::abs(decay[k]) < 1.0) kept.push_back(k);
  const auto count = static_cast<Eigen::Index>(kept.size());
  model.decay.resize(count);
  model.input.resize(count, input.cols());
  model.output.resize(output.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index k = kept[static_cast<std::size_t>(i)];
    model.decay[i] = decay[k];
    model.input.row(i) = input.row(k);
    model.output.col(i) = (decay[k].imag() > 0.0 ? 2.0 : 1.0) * output.col(k);
  }
}

/// The model of the first `states` dominant vectors V: O = V root, A = O⁺ (O shifted up by one block).
void realise(DominantVectors& found, int states, StateSpaceModel& model) {
  const Eigen::VectorXd values = found.values().head(states), root = values.cwiseAbs().cwiseSqrt();
  const Eigen::MatrixXd first = found.first_block(states) * root.asDiagonal();
  const Eigen::MatrixXd A = root.cwiseInverse().asDiagonal() * found.shifted(states) * root.asDiagonal();
  const Eigen::MatrixXd B = values.cwiseSign().asDiagonal() * first.transpose();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  const Eigen::MatrixXcd T = solver.eigenvectors();
  const Eigen::MatrixXcd input = T.partialPivLu().solve(B.cast<std::complex<double>>());
  pair_conjugates(solver.eigenvalues(), input, first * T, model);
}

/// Diagonal weights: one model a degree of freedom, side by side.
StateSpaceModel reduce_each(const WeightSequence& weights, ReductionOptions options) {
  const int n = weights.size, direct = options.direct_lags;
  options.most_states = std::max(options.most_states / n, 1);
  std::vector<StateSpaceModel> alone;
  Eigen::Index states = 0;
  for (int d = 0; d < n; ++d) {
    alone.push_back(reduce({1, false, weights.values.row(d)}, options));
    states += alone.back().decay.size();
  }
  StateSpaceModel model;
  model.decay.resize(states);
  model.input.setZero(states, n);
  model.output.setZero(n, states);
  model.direct.resize(n, n * (direct + 1));
  for (int j = 0; j <= direct; ++j) model.direct.middleCols(j * n, n) = weights.weight(j);
  model.certified_lags = weights.last();
  Eigen::Index first = 0;
  for (int d = 0; d < n; ++d) {
    const StateSpaceModel& one = alone[static_cast<std::size_t>(d)];
    const Eigen::Index count = one.decay.size();
    model.decay.segment(first, count) = one.decay;
    model.input.col(d).segment(first, count) = one.input;
    model.output.row(d).segment(first, count) = one.output;
    first += count;
  }
  model.error = certify(model, weights, options.pool);
  model.within_tolerance = model.error.relative <= options.tolerance;
  return model;
}

void refuse(const std::string& what) {
  throw std::invalid_argument("reduce: " + what);
}

}  // namespace

StateSpaceModel reduce(const WeightSequence& weights, const ReductionOptions& options) {
  check(weights);
  if (weights.diagonal && weights.size > 1) return reduce_each(weights, options);
  if (!(options.tolerance > 0.0)) refuse("tolerance = " + std::to_string(options.tolerance) + " must be > 0");
  if (options.direct_lags < 0 || options.direct_lags > 64)
    refuse("direct_lags = " + std::to_string(options.direct_lags) + " must be 0 … 64");
  if (options.most_states < 1) refuse("most_states = " + std::to_string(options.most_states) + " must be >= 1");
  if (weights.last() <= options.direct_lags + 1)
    refuse("N = " + std::to_string(weights.last()) + " must be > direct_lags + 1");

  StateSpaceModel model;
  const int n = weights.size;
  model.direct.resize(n, n * (options.direct_lags + 1));
  for (int j = 0; j <= options.direct_lags; ++j) model.direct.middleCols(j * n, n) = weights.weight(j);
  model.certified_lags = weights.last();
  const HankelProduct hankel(weights, options.direct_lags + 1, options.pool);
  double total = 0.0;  // Σ ‖W_j‖_F, and with it the scale of what may be left out
  for (long long j = 0; j <= weights.last(); ++j) total += weights.values.col(j).norm();
  if (total == 0.0) total = 1.0;

  const int most = std::min(options.most_states, hankel.rows());
  // ‖W - W~‖ of the frequency response is at most twice the sum of the values left out [Glover 1984]; the sum over all
  // lags is larger, which the certificate then tells. Ever more states until it agrees or there are no more.
  constexpr int block = 48, spare = 10;  // the last vectors of a basis are not yet accurate
  DominantVectors found(hankel);
  int sought = 0;
  const auto extend = [&] {
    const int more = std::min({block, most - sought, hankel.rows() - sought});
    const int free = hankel.rows() - static_cast<int>(found.values().size());
    if (const int count = std::min(sought == 0 ? more + spare : more, free); count > 0) found.extend(count);
    sought += more;
  };
  extend();
  int states = 0, before = -1;
  for (double aim = 0.2 * options.tolerance * total; before < most; aim *= 0.3) {
    while (sought < most && std::abs(found.values()[sought - 1]) > aim) extend();
    while (states < sought && std::abs(found.values()[states]) > aim) ++states;
    states = std::max(states, 1);
    const double floor = 1e-14 * std::abs(found.values()[0]);  // below it the vectors are round-off
    while (states > 1 && !(std::abs(found.values()[states - 1]) > floor)) --states;
    if (states != before) {
      StateSpaceModel candidate = model;
      realise(found, states, candidate);
      candidate.error = certify(candidate, weights, options.pool);
      if (model.decay.size() == 0 || candidate.error.relative < model.error.relative) model = candidate;
      before = states;
    }
    if (model.error.relative <= options.tolerance || aim < floor) break;
  }
  model.within_tolerance = model.error.relative <= options.tolerance;
  return model;
}

KernelError certify(const StateSpaceModel& model, const WeightSequence& weights, numerics::ThreadPool* pool) {
  if (model.size() != weights.size) throw std::invalid_argument("certify: model and weights differ in size");
  const int n = model.size(), r = static_cast<int>(model.decay.size()), direct = model.direct_lags();
  constexpr int parts = 8;
  std::vector<double> error(parts, 0.0), total(parts, 0.0);
  // j = direct + 1 + m, m = 0 … lags - 1; after the last weight that is not zero the geometric sum takes over
  long long last = weights.last();
  while (last > direct && weights.values.col(last).isZero(0.0)) --last;
  const long long lags = last - direct;
  const auto share = [&](int part) {
    const auto p = static_cast<std::size_t>(part);
    const long long begin = lags * part / parts, end = lags * (part + 1) / parts;
    // λ^m as the recurrence makes it, started afresh in each part
    Eigen::VectorXcd power(r);
    for (int k = 0; k < r; ++k) power[k] = std::pow(model.decay[k], static_cast<double>(begin));
    Eigen::MatrixXcd turned(n, r);
    Eigen::MatrixXd difference(n, n);
    for (long long m = begin; m < end; ++m) {
      turned.noalias() = model.output * power.asDiagonal();
      difference.noalias() = turned.real() * model.input.real();
      difference.noalias() -= turned.imag() * model.input.imag();
      difference -= weights.weight(direct + 1 + m);
      error[p] += difference.norm();
      power = power.cwiseProduct(model.decay);
    }
  };
  if (pool != nullptr) {
    pool->parallel_for(parts, share);
  } else {
    for (int part = 0; part < parts; ++part) share(part);
  }
  KernelError result;
  for (double e : error) result.absolute += e;
  for (int k = 0; k < r; ++k) {
    const double modulus = std::abs(model.decay[k]);
    result.absolute += model.output.col(k).norm() * model.input.row(k).norm() *
                       std::pow(modulus, static_cast<double>(std::max<long long>(lags, 0))) / (1.0 - modulus);
  }
  double scale = 0.0;
  for (long long j = 0; j <= weights.last(); ++j) scale += weights.values.col(j).norm();
  result.relative = scale > 0.0 ? result.absolute / scale : (result.absolute > 0.0 ? 1.0 : 0.0);
  if (numerics::planted_fault("convolution/error-understated")) result.relative *= 1e-3, result.absolute *= 1e-3;
  return result;
}

}  // namespace sunder::convolution
