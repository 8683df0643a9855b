#pragma once
/// Dense kernels on row-major matrices of even order, templated on the scalar (double, or four lanes at once).
///
/// A value is one register, so a tile of 4 × 2 results keeps 8 independent sums in flight and needs 6 loads for 8
/// multiply-adds: that fills both multiply-add ports of an AVX2 core without any packing.

#include "solver/numerics/lanes.hpp"

namespace sunder::sbfem::kernels {

/// sums[r][c] += Σ_k X[k][r] Y[k][c], k < depth. X may be single numbers that are spread over the lanes of Y.
template <int R, int C, class T, class S>
inline void accumulate(const T* X, int stride_x, const S* Y, int stride_y, int depth, S (&sums)[R][C]) {
  for (int k = 0; k < depth; ++k, X += stride_x, Y += stride_y) {
#pragma GCC unroll 8
    for (int r = 0; r < R; ++r) {
#pragma GCC unroll 8
      for (int c = 0; c < C; ++c) sums[r][c] += X[r] * Y[c];
    }
  }
}

template <int R, int C, class S, class Store>
inline void product_tile(const S* X, int stride_x, const S* Y, int stride_y, int depth, int i, int j,
                         const Store& store) {
  S sums[R][C] = {};
  accumulate<R, C>(X + i, stride_x, Y + j, stride_y, depth, sums);
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r) {
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) store(i + r, j + c, sums[r][c]);
  }
}

/// store(i, j, (Xᵀ Y)_ij) for i < rows, j < columns (both even); X (depth, rows), Y (depth, columns). With `lower` only
/// tiles that touch i >= j are visited, some of their entries lie above the diagonal.
template <class S, class Store>
inline void transposed_product(const S* X, int stride_x, int rows, const S* Y, int stride_y, int columns, int depth,
                               bool lower, const Store& store) {
  int i = 0;
  for (; i + 4 <= rows; i += 4) {
    const int end = lower ? i + 4 : columns;
    for (int j = 0; j < end; j += 2) product_tile<4, 2>(X, stride_x, Y, stride_y, depth, i, j, store);
  }
  if (i < rows) {
    const int end = lower ? i + 2 : columns;
    int j = 0;
    for (; j + 4 <= end; j += 4) product_tile<2, 4>(X, stride_x, Y, stride_y, depth, i, j, store);
    if (j < end) product_tile<2, 2>(X, stride_x, Y, stride_y, depth, i, j, store);
  }
}

/// Rows i … i + R - 1 of two columns of the factor: what the columns before them leave, then the 2 × 2 triangle.
template <int R, class S>
inline void cholesky_rows(S* L, int stride, const S* inverse, int i, int j) {
  S sums[R][2];
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r) {
    sums[r][0] = L[(i + r) * stride + j];
    sums[r][1] = L[(i + r) * stride + j + 1];
  }
  for (int k = 0; k < j; ++k) {
    const S first = L[j * stride + k], second = L[(j + 1) * stride + k];
#pragma GCC unroll 8
    for (int r = 0; r < R; ++r) {
      const S left = L[(i + r) * stride + k];
      sums[r][0] -= left * first;
      sums[r][1] -= left * second;
    }
  }
  const S corner = L[(j + 1) * stride + j];
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r) {
    const S left = sums[r][0] * inverse[j];
    L[(i + r) * stride + j] = left;
    L[(i + r) * stride + j + 1] = (sums[r][1] - left * corner) * inverse[j + 1];
  }
}

/// A = L Lᵀ in place on the lower triangle; inverse[i] = 1 / L_ii. A pivot that is not positive makes its lane NaN.
template <class S>
inline void cholesky(S* A, int stride, int order, S* inverse) {
  using numerics::square_root;
  for (int j = 0; j < order; j += 2) {
    S d00 = A[j * stride + j], d10 = A[(j + 1) * stride + j], d11 = A[(j + 1) * stride + j + 1];
    for (int k = 0; k < j; ++k) {
      const S first = A[j * stride + k], second = A[(j + 1) * stride + k];
      d00 -= first * first;
      d10 -= second * first;
      d11 -= second * second;
    }
    const S root = square_root(d00);
    inverse[j] = S(1.0) / root;
    d10 *= inverse[j];
    const S last = square_root(d11 - d10 * d10);
    inverse[j + 1] = S(1.0) / last;
    A[j * stride + j] = root;
    A[(j + 1) * stride + j] = d10;
    A[(j + 1) * stride + j + 1] = last;
    int i = j + 2;
    for (; i + 4 <= order; i += 4) cholesky_rows<4>(A, stride, inverse, i, j);
    if (i < order) cholesky_rows<2>(A, stride, inverse, i, j);
  }
}

template <int C, class S>
inline void solve_lower_columns(const S* L, int stride_l, const S* inverse, int order, S* X, int stride) {
  for (int i = 0; i < order; i += 2) {
    S upper[C], lower[C];
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      upper[c] = X[i * stride + c];
      lower[c] = X[(i + 1) * stride + c];
    }
    for (int k = 0; k < i; ++k) {
      const S first = L[i * stride_l + k], second = L[(i + 1) * stride_l + k];
#pragma GCC unroll 8
      for (int c = 0; c < C; ++c) {
        upper[c] -= first * X[k * stride + c];
        lower[c] -= second * X[k * stride + c];
      }
    }
    const S corner = L[(i + 1) * stride_l + i];
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      upper[c] *= inverse[i];
      X[i * stride + c] = upper[c];
      X[(i + 1) * stride + c] = (lower[c] - corner * upper[c]) * inverse[i + 1];
    }
  }
}

/// X ← L⁻¹ X, X (order, columns), both even.
template <class S>
inline void solve_lower(const S* L, int stride_l, const S* inverse, int order, S* X, int stride, int columns) {
  int j = 0;
  for (; j + 4 <= columns; j += 4) solve_lower_columns<4>(L, stride_l, inverse, order, X + j, stride);
  if (j < columns) solve_lower_columns<2>(L, stride_l, inverse, order, X + j, stride);
}

template <int C, class S>
inline void solve_upper_columns(const S* L, int stride_l, const S* inverse, int order, S* X, int stride) {
  for (int i = order - 2; i >= 0; i -= 2) {
    S upper[C], lower[C];
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      upper[c] = X[i * stride + c];
      lower[c] = X[(i + 1) * stride + c];
    }
    for (int k = i + 2; k < order; ++k) {
      const S first = L[k * stride_l + i], second = L[k * stride_l + i + 1];
#pragma GCC unroll 8
      for (int c = 0; c < C; ++c) {
        upper[c] -= first * X[k * stride + c];
        lower[c] -= second * X[k * stride + c];
      }
    }
    const S corner = L[(i + 1) * stride_l + i];
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      lower[c] *= inverse[i + 1];
      X[(i + 1) * stride + c] = lower[c];
      X[i * stride + c] = (upper[c] - corner * lower[c]) * inverse[i];
    }
  }
}

/// X ← L⁻ᵀ X, X (order, columns), both even.
template <class S>
inline void solve_upper(const S* L, int stride_l, const S* inverse, int order, S* X, int stride, int columns) {
  int j = 0;
  for (; j + 4 <= columns; j += 4) solve_upper_columns<4>(L, stride_l, inverse, order, X + j, stride);
  if (j < columns) solve_upper_columns<2>(L, stride_l, inverse, order, X + j, stride);
}

/// x ← (L Lᵀ)⁻¹ x for one vector.
template <class S>
inline void solve_vector(const S* L, int stride, const S* inverse, int order, S* x) {
  for (int i = 0; i < order; ++i) {
    S sum = x[i];
    for (int k = 0; k < i; ++k) sum -= L[i * stride + k] * x[k];
    x[i] = sum * inverse[i];
  }
  for (int i = order - 1; i >= 0; --i) {
    x[i] *= inverse[i];
    for (int k = 0; k < i; ++k) x[k] -= L[i * stride + k] * x[i];
  }
}

}  // namespace sunder::sbfem::kernels
