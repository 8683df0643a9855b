#include "solver/sbfem/small_stack.hpp"

#include <cmath>

#include "solver/sbfem/batch_kernels.hpp"

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;
using numerics::Lanes;
constexpr int lanes = Lanes::count;
constexpr int tile_width = 3;  // vectors; 4 rows × 3 vectors are 12 sums in flight, of 16 registers

const double* numbers(const Lanes* row) {
  return reinterpret_cast<const double*>(row);
}

/// row i, column j of a matrix of `width` vectors a row
double at(const std::vector<Lanes>& M, int width, Eigen::Index i, Eigen::Index j) {
  return M[static_cast<std::size_t>(i * width + j / lanes)][static_cast<int>(j % lanes)];
}
void put(std::vector<Lanes>& M, int width, Eigen::Index i, Eigen::Index j, double value) {
  M[static_cast<std::size_t>(i * width + j / lanes)].set(static_cast<int>(j % lanes), value);
}

/// Calls body<C>(j) for consecutive groups of C vectors from `begin` to `end`.
template <class Body>
void for_tiles(int begin, int end, const Body& body) {
  int j = begin;
  for (; j + tile_width <= end; j += tile_width) body.template operator()<tile_width>(j);
  if (end - j == 2) body.template operator()<2>(j);
  if (end - j == 1) body.template operator()<1>(j);
}

}  // namespace

SmallStack::SmallStack(const MatrixXd& E0, const MatrixXd& F, const MatrixXd& E2, double h)
    : order_(static_cast<int>(E0.rows())), width_((order_ + lanes - 1) / lanes) {
  const auto square = static_cast<std::size_t>(lanes * width_) * static_cast<std::size_t>(width_);
  A_.assign(square, Lanes(0.0));
  B_ = C_ = A_;
  work_.assign(3 * square, Lanes(0.0));
  for (Eigen::Index i = 0; i < lanes * width_; ++i) {
    for (Eigen::Index j = 0; j < lanes * width_; ++j) {
      // Beyond the order: S = 1 on the diagonal, which touches nothing.
      if (i >= order_ || j >= order_) {
        put(A_, width_, i, j, i == j ? 1.0 : 0.0);
        continue;
      }
      const double e0 = E0(i, j) / h, e2 = (h / 4.0) * E2(i, j), f = 0.5 * F(i, j), transposed = 0.5 * F(j, i);
      put(A_, width_, i, j, e0 + e2 - f - transposed);
      put(B_, width_, i, j, e0 + e2 + f + transposed);
      put(C_, width_, i, j, e2 - e0 + transposed - f);
    }
  }
}

double SmallStack::coupling() const {
  Lanes sum(0.0);
  for (const Lanes& c : C_) sum += c * c;
  return std::sqrt(sum[0] + sum[1] + sum[2] + sum[3]);
}

double SmallStack::size() const {
  double sum = 0.0;
  for (int i = 0; i < order_; ++i) sum += at(B_, width_, i, i) * at(B_, width_, i, i);
  return std::sqrt(sum);
}

MatrixXd SmallStack::stiffness() const {
  MatrixXd B(order_, order_);
  for (Eigen::Index i = 0; i < order_; ++i) {
    for (Eigen::Index j = i; j < order_; ++j) B(i, j) = B(j, i) = at(B_, width_, i, j);
  }
  return B;
}

/// U of the 4 × 4 block on the diagonal, in place; its diagonal holds 1 / U_rr.
bool SmallStack::factor_diagonal(int block) {
  Lanes* rows[lanes];
  for (int r = 0; r < lanes; ++r) rows[r] = &work_[static_cast<std::size_t>((lanes * block + r) * 3 * width_ + block)];
  for (int r = 0; r < lanes; ++r) {
    const double pivot = (*rows[r])[r];
    if (!(pivot > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(pivot);
    *rows[r] *= Lanes(inverse);
    for (int s = r + 1; s < lanes; ++s) *rows[s] -= Lanes((*rows[r])[s]) * *rows[r];
    rows[r]->set(r, inverse);
  }
  return true;
}

/// Rows 4 block … 4 block + 3 of the vectors behind the diagonal block: what the rows above leave, then U⁻ᵀ.
void SmallStack::eliminate_block(int block, int last_column) {
  const int stride = 3 * width_, above = lanes * block;
  const Lanes* top = work_.data();
  Lanes* own = work_.data() + above * stride;
  double factor[lanes][lanes];
  for (int r = 0; r < lanes; ++r) {
    for (int s = 0; s < lanes; ++s) factor[r][s] = own[r * stride + block][s];
  }
  for_tiles(block + 1, last_column, [&]<int C>(int j) {
    Lanes sums[lanes][C] = {};
    kernels::accumulate<lanes, C>(numbers(top) + above, lanes * stride, top + j, stride, above, sums);
#pragma GCC unroll 4
    for (int r = 0; r < lanes; ++r) {
#pragma GCC unroll 4
      for (int c = 0; c < C; ++c) {
        Lanes value = own[r * stride + j + c] - sums[r][c];
#pragma GCC unroll 4
        for (int s = 0; s < r; ++s) value -= Lanes(factor[s][r]) * sums[s][c];
        sums[r][c] = value * Lanes(factor[r][r]);
        own[r * stride + j + c] = sums[r][c];
      }
    }
  });
}

/// B -= Yᵀ Y and, unless outer_only, A -= Xᵀ X, C = -Xᵀ Y.
void SmallStack::store_products(bool outer_only) {
  const int stride = 3 * width_, depth = lanes * width_;
  const Lanes *Y = work_.data() + width_, *X = Y + width_;
  for (int block = 0; block < width_; ++block) {
    const auto product = [&](const Lanes* left, const Lanes* right, int begin, const auto& store) {
      for_tiles(begin, width_, [&]<int C>(int j) {
        Lanes sums[lanes][C] = {};
        kernels::accumulate<lanes, C>(numbers(left) + lanes * block, lanes * stride, right + j, stride, depth, sums);
        for (int r = 0; r < lanes; ++r) {
          for (int c = 0; c < C; ++c) store(static_cast<std::size_t>((lanes * block + r) * width_ + j + c), sums[r][c]);
        }
      });
    };
    product(Y, Y, block, [this](std::size_t k, Lanes value) { B_[k] -= value; });
    if (outer_only) continue;
    product(X, X, block, [this](std::size_t k, Lanes value) { A_[k] -= value; });
    product(X, Y, 0, [this](std::size_t k, Lanes value) { C_[k] = -value; });
  }
}

bool SmallStack::merge(bool outer_only) {
  const int stride = 3 * width_, rows = lanes * width_;
  for (int i = 0; i < rows; ++i) {
    Lanes* row = work_.data() + i * stride;
    const std::size_t from = static_cast<std::size_t>(i * width_);
    for (int j = i / lanes; j < width_; ++j) row[j] = A_[from + j] + B_[from + j];
    for (int j = 0; j < width_; ++j) row[width_ + j] = C_[from + j];
    if (outer_only) continue;
    for (int j = 0; j < rows; ++j) row[2 * width_ + j / lanes].set(j % lanes, at(C_, width_, j, i));
  }
  const int last_column = outer_only ? 2 * width_ : 3 * width_;
  for (int block = 0; block < width_; ++block) {
    // The diagonal block first, then everything behind it with its factor.
    Lanes* own = work_.data() + lanes * block * stride;
    Lanes sums[lanes][1] = {};
    kernels::accumulate<lanes, 1>(numbers(work_.data()) + lanes * block, lanes * stride, work_.data() + block, stride,
                                  lanes * block, sums);
    for (int r = 0; r < lanes; ++r) own[r * stride + block] -= sums[r][0];
    if (!factor_diagonal(block)) return false;
    eliminate_block(block, last_column);
  }
  store_products(outer_only);
  return true;
}

}  // namespace sunder::sbfem
