#include "solver/crackwater/pressure_profile.hpp"
#include <gtest/gtest.h>
#include <cstdio>
#include <cmath>
using namespace sunder::crackwater;
TEST(Scratch, Table) {
  for (int n : {9,45, 450}) for (double v : {0.1, 0.0, -0.1}) for (Search s : {Search::bisection, Search::itp, Search::toms748, Search::newton, Search::prefix_moments}) for (Quadrature q : {Quadrature::exact, Quadrature::midpoint}) {
    PressureSolver solver(straight_crack(45.0, n), {}, {.quadrature=q,.search = s});
    std::vector<double> w(n + 1), r(n + 1);
    for (int i = 0; i <= n; ++i) { double x = 1.0*i/n; w[i] = 0.1 - 0.05 * x; r[i] = v * (1 - x); }
    auto& p = solver.solve(w, r, {490500.0, 0.0});
    printf("%3d %+.1f s%d q%d  q0 %.17g xf %.17g U %.17g M %.17g pk %.17g at %.17g st %d ev %d g %lld res %g\n", n, v, int(s), int(q), p.upstream_flux, p.front_position, p.uplift_force, p.uplift_moment, p.peak_pressure, p.peak_position, int(p.status), p.residual_evaluations, p.gradient_evaluations, p.residual);
  }
}
