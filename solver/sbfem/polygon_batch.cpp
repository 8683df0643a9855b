#include "solver/sbfem/polygon_batch.hpp"

#include <algorithm>

#include "solver/numerics/lanes.hpp"
#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/batch_kernels.hpp"
#include "solver/sbfem/ring_doubling.hpp"

namespace sunder::sbfem {
namespace {

using numerics::any;
using numerics::choose;
using numerics::greater;
using numerics::Lanes;
using numerics::square_root;

template <class S>
struct Block {
  S xx, xy, yx, yy;
};

/// L(v)ᵀ D L(w) with L(v) = [v_x 0; 0 v_y; v_y v_x].
template <class S>
Block<S> strain_product(const BatchMaterial<S>& D, S vx, S vy, S wx, S wy) {
  return {D.direct * vx * wx + D.shear * vy * wy, D.coupled * vx * wy + D.shear * vy * wx,
          D.coupled * vy * wx + D.shear * vx * wy, D.direct * vy * wy + D.shear * vx * wx};
}

/// X ← H X H with H = I - Σ v vᵀ, v_x on the even and v_y on the odd components (both in `v`).
template <class S>
void reflect_both(S* X, int N, const S* v, S* work) {
  std::fill_n(work, 2 * N, S(0.0));
  for (int i = 0; i < N; ++i) {
    S* sum = work + (i % 2) * N;
    for (int j = 0; j < N; ++j) sum[j] += v[i] * X[i * N + j];
  }
  for (int i = 0; i < N; ++i) {
    S* row = X + i * N;
    const S* sum = work + (i % 2) * N;
    S even(0.0), odd(0.0);
    for (int j = 0; j < N; j += 2) {
      row[j] -= v[i] * sum[j];
      row[j + 1] -= v[i] * sum[j + 1];
      even += row[j] * v[j];
      odd += row[j + 1] * v[j + 1];
    }
    for (int j = 0; j < N; j += 2) {
      row[j] -= even * v[j];
      row[j + 1] -= odd * v[j + 1];
    }
  }
}

/// Scales E0, F, E2 in place and leaves the reduced polygon in e0, f, e2 (reduced_polygon.hpp).
template <class S>
void reduce(PolygonBatch<S>& b) {
  const int N = b.size, m = N - 2;
  for (int i = 0; i < N; ++i) b.scale[i] = S(1.0) / square_root(b.E0[i * N + i]);
  S norm[2] = {S(0.0), S(0.0)};
  const bool unscaled = numerics::planted_fault("sbfem/translation-deflated-unscaled");
  for (int i = 0; i < N; ++i) {
    b.mirror[i] = unscaled ? S(1.0) : S(1.0) / b.scale[i];
    norm[i % 2] += b.mirror[i] * b.mirror[i];
  }
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const S product = b.scale[i] * b.scale[j];
      b.E0[i * N + j] *= product;
      b.F[i * N + j] *= product;
      b.E2[i * N + j] *= product;
    }
  }
  // v = t + e₀ scaled to ‖v‖² = 2, with the unit vector t: ‖t + e₀‖² = 2 (1 + t₀).
  for (int axis = 0; axis < 2; ++axis) {
    const S unit = S(1.0) / square_root(norm[axis]);
    const S length = S(1.0) / square_root(S(1.0) + b.mirror[axis] * unit);
    for (int i = axis; i < N; i += 2) b.mirror[i] = b.mirror[i] * unit * length;
    b.mirror[axis] += length;
  }
  std::copy_n(b.E0.data(), N * N, b.A.data());
  std::copy_n(b.F.data(), N * N, b.B.data());
  std::copy_n(b.E2.data(), N * N, b.C.data());
  for (S* X : {b.A.data(), b.B.data(), b.C.data()}) reflect_both(X, N, b.mirror.data(), b.vector.data());

  S *R0 = b.rate.data(), *R1 = R0 + N, *S0 = R1 + N, *S1 = S0 + N;
  const S* E0 = b.A.data();
  const S root0 = S(1.0) / square_root(E0[0]), side = E0[N] * root0;
  const S root1 = S(1.0) / square_root(E0[N + 1] - side * side);
  for (int j = 0; j < m; ++j) {
    R0[j] = E0[j + 2] * root0;
    R1[j] = (E0[N + j + 2] - side * R0[j]) * root1;
    S0[j] = b.B[j + 2] * root0;
    S1[j] = (b.B[N + j + 2] - side * S0[j]) * root1;
  }
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) {
      const int from = (i + 2) * N + j + 2, to = i * m + j;
      b.e0[to] = E0[from] - R0[i] * R0[j] - R1[i] * R1[j];
      b.f[to] = b.B[from] - R0[i] * S0[j] - R1[i] * S1[j];
      b.e2[to] = b.C[from] - S0[i] * S0[j] - S1[i] * S1[j];
    }
  }
}

/// λ_max by power steps on Ẽ0⁻¹ Ẽ2, as in ring_doubling.cpp.
template <class S>
S largest_exponent(PolygonBatch<S>& b) {
  constexpr int power_steps = 5;
  const int m = b.size - 2;
  std::copy_n(b.e0.data(), m * m, b.factor.data());
  kernels::cholesky(b.factor.data(), m, m, b.inverse.data());
  S *x = b.vector.data(), *next = x + m;
  for (int i = 0; i < m; ++i) x[i] = S((i % 2 == 0 ? 1.0 : -1.0) * (1.0 + static_cast<double>(i) / (m - 1)));
  S growth(1.0);
  for (int step = 0; step < power_steps; ++step) {
    S before(0.0), after(0.0);
    for (int i = 0; i < m; ++i) {
      S sum(0.0);
      for (int j = 0; j < m; ++j) sum += b.e2[i * m + j] * x[j];
      next[i] = sum;
    }
    kernels::solve_vector(b.factor.data(), m, b.inverse.data(), m, next);
    for (int i = 0; i < m; ++i) {
      before += x[i] * x[i];
      after += next[i] * next[i];
    }
    growth = square_root(after / before);
    const S inverse = S(1.0) / square_root(after);
    for (int i = 0; i < m; ++i) x[i] = next[i] * inverse;
  }
  return square_root(growth);
}

/// A, B and Z = [Cᵀ C] of one ring of thickness h.
template <class S>
void first_ring(PolygonBatch<S>& b, S h) {
  const int m = b.size - 2;
  const S thin = S(1.0) / h, thick = h * S(0.25), half(0.5);
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) {
      const S e0 = b.e0[i * m + j] * thin, e2 = b.e2[i * m + j] * thick;
      const S f = b.f[i * m + j] * half, ft = b.f[j * m + i] * half;
      b.A[i * m + j] = e0 + e2 - f - ft;
      b.B[i * m + j] = e0 + e2 + f + ft;
      b.Z[i * 2 * m + j] = e2 - e0 + f - ft;
      b.Z[i * 2 * m + m + j] = e2 - e0 + ft - f;
    }
  }
}

template <class S>
void double_rings(PolygonBatch<S>& b) {
  const int m = b.size - 2, wide = 2 * m;
  const S estimate = largest_exponent(b), cap(ring_doubling_largest_shift), finished(ring_doubling_finished);
  b.largest_exponent = choose(greater(estimate, S(1.0)), estimate, S(1.0));
  const S geometric = square_root(b.largest_exponent), nearly = S(ring_doubling_nearly) / b.largest_exponent;
  first_ring(b, S(2.0) / choose(greater(geometric, cap), cap, geometric));
  b.converged = b.iterations = S(0.0);
  S active(1.0);
  for (int merge = 0;; ++merge) {
    S coupling(0.0), size(0.0);
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < m; ++j) coupling += b.Z[i * wide + m + j] * b.Z[i * wide + m + j];
      size += b.B[i * m + i] * b.B[i * m + i];
    }
    // NaN is never small; it leaves `active` and keeps `converged` 0.
    const S small = greater(size * finished * finished, coupling);
    const S close = greater(size * nearly * nearly, coupling);
    const S defined = greater(size, coupling * S(1e-300));
    b.converged = choose(active * small, S(1.0), b.converged);
    active = active * defined * (S(1.0) - small);
    if (!any(active) || merge == ring_doubling_most_merges) break;
    const bool last = !any(active * (S(1.0) - close));

    for (int i = 0; i < m; ++i) {
      for (int j = 0; j <= i; ++j) b.factor[i * m + j] = b.A[i * m + j] + b.B[i * m + j];
    }
    kernels::cholesky(b.factor.data(), m, m, b.inverse.data());
    S *Z = b.Z.data(), *X = Z, *Y = Z + m;
    const int first = last ? m : 0;
    kernels::solve_lower(b.factor.data(), m, b.inverse.data(), m, Z + first, wide, wide - first);
    S *A = b.A.data(), *B = b.B.data(), *next = b.next.data();
    kernels::transposed_product(Y, wide, m, Y, wide, m, m, true,
                                [=](int i, int j, S value) { B[i * m + j] -= active * value; });
    if (!last) {
      kernels::transposed_product(X, wide, m, X, wide, m, m, true,
                                  [=](int i, int j, S value) { A[i * m + j] -= value; });
      kernels::transposed_product(X, wide, m, Y, wide, m, m, false, [=](int i, int j, S value) {
        next[i * wide + m + j] = -value;
        next[j * wide + i] = -value;
      });
      std::swap(b.Z, b.next);
    }
    b.iterations += active;
    b.converged = choose(active * close, S(1.0), b.converged);
    active = active * (S(1.0) - close);
    if (!any(active)) break;
  }
}

}  // namespace

template <class S>
PolygonBatch<S>::PolygonBatch(int largest_size) {
  const std::size_t N = static_cast<std::size_t>(largest_size), square = N * N;
  for (auto* coordinate : {&x, &y}) coordinate->resize(N / 2);
  for (auto* matrix : {&E0, &F, &E2, &K, &M, &e0, &f, &e2, &A, &B, &C, &factor}) matrix->resize(square);
  for (auto* matrix : {&Z, &next}) matrix->resize(2 * square);
  for (auto* row : {&scale, &mirror, &inverse}) row->resize(N);
  rate.resize(4 * N);
  vector.resize(2 * N);
}

template <class S>
void fill_coefficients(PolygonBatch<S>& b, std::span<const int> orders, std::span<const ReferenceEdge> references) {
  const int N = b.size, n = N / 2;
  const double sense = numerics::planted_fault("sbfem/edge-jacobian-sign") ? -1.0 : 1.0;
  for (auto* matrix : {&b.E0, &b.F, &b.E2}) std::fill_n(matrix->data(), N * N, S(0.0));
  int start = 0;
  for (const int p : orders) {
    const ReferenceEdge& edge = references[static_cast<std::size_t>(p)];
    const int end = (start + p) % n;
    const S half_x = (b.x[end] - b.x[start]) * S(0.5), half_y = (b.y[end] - b.y[start]) * S(0.5);
    const S middle_x = (b.x[end] + b.x[start]) * S(0.5), middle_y = (b.y[end] + b.y[start]) * S(0.5);
    const S inverse = S(1.0) / (b.x[start] * half_y - b.y[start] * half_x);
    // a = (y_b', -x_b') and c(η) = (-y_b, x_b) = c_m - η a, as in coefficients.cpp.
    const S ax = half_y, ay = -half_x, cx = -middle_y, cy = middle_x * S(sense);
    const auto scaled = [inverse](Block<S> q) {
      return Block<S>{q.xx * inverse, q.xy * inverse, q.yx * inverse, q.yy * inverse};
    };
    const Block<S> aa = scaled(strain_product(b.material, ax, ay, ax, ay));
    const Block<S> ca = scaled(strain_product(b.material, cx, cy, ax, ay));
    const Block<S> cc = scaled(strain_product(b.material, cx, cy, cx, cy));
    const S both_xx = ca.xx + ca.xx, both_xy = ca.xy + ca.yx, both_yy = ca.yy + ca.yy;
    for (int i = 0; i <= p; ++i) {
      const int row = 2 * ((start + i) % n);
      for (int j = 0; j <= p; ++j) {
        const int column = 2 * ((start + j) % n);
        const S NN(edge.NN(i, j)), D0(edge.dNdN[0](i, j)), D1(edge.dNdN[1](i, j)), D2(edge.dNdN[2](i, j));
        // E1 holds dNᵀ N in (i, j); its transpose F takes (j, i).
        const S H0(edge.dNN[0](j, i)), H1(edge.dNN[1](j, i));
        S* e0 = &b.E0[row * N + column];
        S* f = &b.F[row * N + column];
        S* e2 = &b.E2[row * N + column];
        e0[0] += NN * aa.xx;
        e0[1] += NN * aa.xy;
        e0[N] += NN * aa.yx;
        e0[N + 1] += NN * aa.yy;
        f[0] += H0 * ca.xx - H1 * aa.xx;
        f[1] += H0 * ca.yx - H1 * aa.xy;
        f[N] += H0 * ca.xy - H1 * aa.yx;
        f[N + 1] += H0 * ca.yy - H1 * aa.yy;
        e2[0] += D0 * cc.xx - D1 * both_xx + D2 * aa.xx;
        e2[1] += D0 * cc.xy - D1 * both_xy + D2 * aa.xy;
        e2[N] += D0 * cc.yx - D1 * both_xy + D2 * aa.yx;
        e2[N + 1] += D0 * cc.yy - D1 * both_yy + D2 * aa.yy;
      }
    }
    start += p;
  }
  if (numerics::planted_fault("sbfem/e1-transposed")) {
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < i; ++j) std::swap(b.F[i * N + j], b.F[j * N + i]);
    }
  }
}

template <class S>
void solve_stiffness(PolygonBatch<S>& b) {
  reduce(b);
  double_rings(b);
  // K̂ = H [0 0; 0 B] H in the scaled variables.
  const int N = b.size, m = N - 2;
  std::fill_n(b.K.data(), N * N, S(0.0));
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j <= i; ++j) b.K[(i + 2) * N + j + 2] = b.K[(j + 2) * N + i + 2] = b.B[i * m + j];
  }
  reflect_both(b.K.data(), N, b.mirror.data(), b.vector.data());
}

template <class S>
void solve_mass(PolygonBatch<S>& b, std::span<const int> orders, std::span<const ReferenceEdge> references) {
  // mass() in polygon_solution.cpp, with R = (I + A + γ)⁻¹ from one Cholesky factorisation: for σ = 1 + γ and X = K -
  // F, (Xᵀ + σ E0) E0⁻¹ (X + σ E0) = 2σ G with G = K + σ E0 / 2 + E2 / (2σ) - sym F, because Xᵀ E0⁻¹ X = E2; hence (σ +
  // A)⁻¹ = G⁻¹ (Xᵀ + σ E0) / (2σ). G is the polygon with one more ring around its scaled copy: positive definite.
  constexpr double negligible = 1e-10;  // increments of the sum fall as its square: the next one is below round-off
  constexpr int most_squarings = 60;
  const int N = b.size, n = N / 2;
  const S gamma = square_root(S(1.0) + b.largest_exponent), sigma = S(1.0) + gamma;
  const S half = sigma * S(0.5), quarter = S(0.5) / sigma;
  S *G = b.factor.data(), *R = b.Z.data(), *U = b.A.data(), *transposed = b.B.data(), *V = b.C.data(), *M = b.M.data();
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const int at = i * N + j, mirrored = j * N + i;
      G[at] = b.K[at] + half * b.E0[at] + quarter * b.E2[at] - S(0.5) * (b.F[at] + b.F[mirrored]);
      R[at] = (b.K[at] - b.F[mirrored] + sigma * b.E0[at]) * quarter;
    }
  }
  const bool boundary_mass = numerics::planted_fault("sbfem/mass-without-closed-loop");
  if (boundary_mass) {
    for (int i = 0; i < N * N; ++i) R[i] = S(i % (N + 1) == 0 ? 1.0 : 0.0);
  }
  kernels::cholesky(G, N, N, b.inverse.data());
  if (!boundary_mass) {
    kernels::solve_lower(G, N, b.inverse.data(), N, R, N, N);
    kernels::solve_upper(G, N, b.inverse.data(), N, R, N, N);
  }
  // V = M0 R edge by edge, in scaled variables; M = 2γ Rᵀ V, U = I - 2γ R.
  std::fill_n(V, N * N, S(0.0));
  S expected(0.0);  // density times area
  int start = 0;
  for (const int p : orders) {
    const ReferenceEdge& edge = references[static_cast<std::size_t>(p)];
    const int end = (start + p) % n;
    const S area = (b.x[start] * (b.y[end] - b.y[start]) - b.y[start] * (b.x[end] - b.x[start])) * S(0.5);
    expected += b.material.density * area;
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= p; ++j) {
        for (int component = 0; component < 2; ++component) {
          const int row = 2 * ((start + i) % n) + component, column = 2 * ((start + j) % n) + component;
          const S weight = b.material.density * area * S(edge.NN(i, j)) * b.scale[row] * b.scale[column];
          for (int k = 0; k < N; ++k) V[row * N + k] += weight * R[column * N + k];
        }
      }
    }
    start += p;
  }
  const S twice = boundary_mass ? S(0.5) : S(2.0) * gamma;
  const auto symmetric_store = [=](int i, int j, S value) {
    if (i >= j) M[i * N + j] = M[j * N + i] = twice * value;
  };
  kernels::transposed_product(R, N, N, V, N, N, N, true, symmetric_store);
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const S identity(i == j ? 1.0 : 0.0);
      U[i * N + j] = transposed[j * N + i] = identity - twice * R[i * N + j];
    }
  }
  S active(boundary_mass ? 0.0 : 1.0);
  for (int squaring = 0; squaring < most_squarings; ++squaring) {
    S before(0.0), after(0.0);
    for (int i = 0; i < N; ++i) before += M[i * N + i];
    kernels::transposed_product(M, N, N, U, N, N, N, false, [=](int i, int j, S value) { V[i * N + j] = value; });
    kernels::transposed_product(U, N, N, V, N, N, N, true, [=](int i, int j, S value) {
      if (i >= j) M[i * N + j] = M[j * N + i] = M[i * N + j] + active * value;
    });
    for (int i = 0; i < N; ++i) after += M[i * N + i];
    active = active * greater(after - before, S(negligible) * after);
    if (!any(active)) break;
    S* squared = R;
    kernels::transposed_product(transposed, N, N, U, N, N, N, false,
                                [=](int i, int j, S value) { squared[i * N + j] = value; });
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) U[i * N + j] = transposed[j * N + i] = squared[i * N + j];
    }
  }
  // The same check as in mass(); a lane that fails it is not converged.
  for (int i = 0; i < N; ++i) b.inverse[i] = S(1.0) / b.scale[i];
  S carried(0.0);
  for (int i = 0; i < N; i += 2) {
    for (int j = 0; j < N; j += 2) carried += M[i * N + j] * b.inverse[i] * b.inverse[j];
  }
  const S error = (carried - expected) * (carried - expected);
  b.converged = b.converged * (greater(S(1e-12) * expected * expected, error) + greater(S(1e-300), expected));
}

template struct PolygonBatch<double>;
template struct PolygonBatch<Lanes>;
template void fill_coefficients(PolygonBatch<double>&, std::span<const int>, std::span<const ReferenceEdge>);
template void fill_coefficients(PolygonBatch<Lanes>&, std::span<const int>, std::span<const ReferenceEdge>);
template void solve_stiffness(PolygonBatch<double>&);
template void solve_stiffness(PolygonBatch<Lanes>&);
template void solve_mass(PolygonBatch<double>&, std::span<const int>, std::span<const ReferenceEdge>);
template void solve_mass(PolygonBatch<Lanes>&, std::span<const int>, std::span<const ReferenceEdge>);

}  // namespace sunder::sbfem
