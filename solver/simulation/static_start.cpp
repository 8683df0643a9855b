#include "solver/simulation/static_start.hpp"

#include "solver/numerics/planted_fault.hpp"

namespace sunder::simulation {

StaticStart static_start(const DynamicBody& body, const Constraints& constraints, std::span<const Mouth> mouths,
                         const CrackWaters& waters, const faces::FaceStepOptions& options) {
  StaticStart start;
  Eigen::SparseMatrix<double> matrix = body.stiffness;
  Eigen::VectorXd u = body.dead_load;
  eliminate(constraints, matrix.diagonal().cwiseAbs().mean(), matrix, u);
  const numerics::SymmetricFactor factor(matrix, {.block = 2});
  start.status = factor.status();
  start.displacement = constraints.displacement;
  if (start.status != numerics::FactorStatus::factorised) return start;
  factor.solve_in_place(u);
  if (numerics::planted_fault("simulation/starts-out-of-equilibrium")) u *= 0.9;
  start.displacement = u;
  const auto find_reaction = [&] {
    start.reaction = body.stiffness.selfadjointView<Eigen::Lower>() * start.displacement;
    start.reaction -= body.dead_load;
    if (body.cracked()) start.reaction -= body.loads * start.faces.force;
    for (Eigen::Index dof = 0; dof < start.reaction.size(); ++dof) {
      if (!constraints.fixed[static_cast<std::size_t>(dof)]) start.reaction[dof] = 0.0;
    }
  };
  if (!body.cracked()) {
    find_reaction();
    return start;
  }

  Eigen::MatrixXd X = body.loads;
  for (Eigen::Index dof = 0; dof < X.rows(); ++dof) {
    if (constraints.fixed[static_cast<std::size_t>(dof)]) X.row(dof).setZero();
  }
  factor.solve_in_place(X);
  faces::FaceStep step(face_structure(body, X, Eigen::MatrixXd::Zero(std::ssize(body.cracks), X.cols()), waters),
                       options);
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(std::ssize(body.cracks));
  for (std::size_t c = 0; c < mouths.size(); ++c)
    pressure[static_cast<Eigen::Index>(c)] = mouths[c].wet ? mouths[c].resting : 0.0;
  constexpr double any_time = 1.0;  // nothing of what rests asks for it
  const faces::FaceStepResult& result = step.solve(body.loads.transpose() * u, pressure, any_time);
  start.faces_found = result.status == faces::FaceStatus::solved;
  start.displacement += X * result.force;
  start.faces = {
      .force = result.force, .opening = result.opening, .contact = result.contact_force, .stiffness = result.stiffness};
  find_reaction();
  return start;
}

}  // namespace sunder::simulation
