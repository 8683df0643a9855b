#pragma once
/// Displacements at many places inside one polygon, of several boundary fields at once: what carries a state over to a
/// body whose polygons have changed.
///
///     u(ξ, s) = N(s) ξ^A u_b
/// as in interior_field.hpp, without loads. One matrix exponential serves all places: exp(-R t) at t = -ln ξ is the
/// product of those at t's binary digits, which come from squaring. The relative error is round-off times the number of
/// digits; linear and constant fields are exact to that.

#include <Eigen/Core>
#include <vector>

#include "solver/sbfem/edge_element.hpp"
#include "solver/sbfem/interior_field.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::sbfem {

class InteriorValues {
 public:
  /// `boundary_values` (2n, m): one column a field, degrees of freedom x0 y0 x1 y1 … of the boundary's nodes.
  InteriorValues(const Boundary& boundary, const Coefficients& coefficients, const PolygonSolution& solution,
                 const Eigen::Ref<const Eigen::MatrixXd>& boundary_values);

  /// (2, m): the fields at one place. ξ = 0 is the scaling centre.
  [[nodiscard]] Eigen::Matrix2Xd at(const RayPoint& point);

 private:
  std::vector<EdgeElement> edges_;
  // u = centre_ + to_displacement_ ξ^rate_ start_, on the complement of the translations, scaled.
  Eigen::MatrixXd rate_, to_displacement_, start_, centre_;
  double first_step_ = 0.0;              // t of the first power
  std::vector<Eigen::MatrixXd> powers_;  // exp(-rate_ first_step_ 2^j), made when asked for
};

}  // namespace sunder::sbfem
