#include "verification/exact/unilateral.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::exact {

Unilateral projected_gauss_seidel(const Eigen::MatrixXd& F, const Eigen::VectorXd& gap, const Eigen::VectorXd& start,
                                  double tolerance, int most_sweeps, double relaxation) {
  Unilateral answer{start};
  Eigen::VectorXd& force = answer.force;
  const double scale = gap.cwiseAbs().maxCoeff();
  for (; answer.sweeps < most_sweeps; ++answer.sweeps) {
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      const double open = gap[i] + F.col(i).dot(force);
      force[i] = std::max(0.0, force[i] - relaxation * open / F(i, i));
    }
    answer.residual = 0.0;
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      const double open = gap[i] + F.col(i).dot(force);
      answer.residual = std::max(answer.residual, std::abs(std::min(force[i] * F(i, i), open)) / scale);
    }
    if (answer.residual <= tolerance) break;
  }
  return answer;
}

}  // namespace sunder::exact
