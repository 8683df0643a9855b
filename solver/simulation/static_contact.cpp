#include "solver/simulation/static_contact.hpp"

#include <algorithm>
#include <string>

#include "solver/simulation/built_parts.hpp"

namespace sunder::simulation {

const bool built::contact = true;

namespace {

using results::Quantity;

std::string words(contact::ContactStatus status) {
  switch (status) {
    case contact::ContactStatus::converged:
      return "converged";
    case contact::ContactStatus::penetration_too_large:
      return "the penetration stays above its tolerance up to the largest stiffness";
    case contact::ContactStatus::no_solution:
      return "no pair forces can part the faces: prescribed motions press them together";
    case contact::ContactStatus::friction_not_converged:
      return "friction and pressure of the faces did not settle";
    case contact::ContactStatus::not_converged:
      return "round-off hides which pairs touch";
    case contact::ContactStatus::unusable_input:
      return "the motion without contact is not finite";
  }
  return "unknown";
}

/// What the pairs of each crack together do to the body on its left [N/m].
Quantity resultants(const StaticContact& solved) {
  Quantity::List list;
  const crack::CrackPairs& pairs = solved.faces.pairs;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < pairs.count(); ++i) {
    sum += solved.contact.pair_force[i] * pairs.normals.col(i);
    if (solved.contact.shear_force.size() > 0) {
      sum += solved.contact.shear_force[i] * Eigen::Vector2d(pairs.normals(1, i), -pairs.normals(0, i));
    }
    if (i + 1 < pairs.count() && solved.faces.crack[i + 1] == solved.faces.crack[i]) continue;
    list.emplace_back(Quantity::List{sum.x(), sum.y()});
    sum.setZero();
  }
  return list;
}

}  // namespace

contact::ContactOptions contact_options(const scene::Contact& wanted) {
  return {.model = wanted.model == scene::ContactModel::exact ? contact::ContactModel::exact
                                                              : contact::ContactModel::penalty,
          .initial_stiffness = wanted.initial_stiffness,
          .growth_factor = wanted.growth_factor,
          .maximum_stiffness = std::max(contact::ContactOptions{}.maximum_stiffness, wanted.initial_stiffness),
          .penetration_tolerance = wanted.penetration_tolerance,
          .friction_coefficient = wanted.friction_coefficient};
}

StaticContact solve_with_contact(const scene::Contact& wanted, const Body& body, const StaticEquations& equations,
                                 const Eigen::VectorXd& force) {
  StaticContact solved;
  solved.faces = face_pairs(body.polygons, body.nodes);
  const crack::CrackPairs& pairs = solved.faces.pairs;
  const bool rough = wanted.friction_coefficient > 0.0;
  const FaceCompliance faces =
      face_compliance(equations.factor(), pair_operator(pairs, body.dofs(), rough), equations.constraints().fixed);
  const StaticSolution parted = equations.solve(force);  // as if the faces could pass through each other
  const crack::CrackMotion free = crack::crack_motion(pairs, parted.displacement);

  contact::ContactSolver solver(contact_options(wanted));
  solver.set_faces(faces.F, pairs.tributary_length);
  solved.contact = solver.solve(free.opening, free.sliding);

  Eigen::VectorXd pair_forces(faces.B.cols());
  pair_forces << solved.contact.pair_force, solved.contact.shear_force;
  solved.force = faces.B * pair_forces;
  solved.solution = equations.refine(parted.displacement + faces.X * pair_forces, force + solved.force);
  solved.motion = crack::crack_motion(pairs, solved.solution.displacement);
  solved.tolerance = wanted.penetration_tolerance;
  solved.matrix_entries = faces.B.nonZeros() + faces.X.size() + faces.F.size();
  return solved;
}

double StaticContact::penetration() const {
  return motion.opening.size() > 0 ? std::max(0.0, -motion.opening.minCoeff()) : 0.0;
}

bool StaticContact::holds() const {
  return contact.status == contact::ContactStatus::converged && penetration() <= tolerance;
}

std::string StaticContact::reason() const {
  if (contact.status != contact::ContactStatus::converged) return words(contact.status);
  return "round-off of the body's equations exceeds the penetration tolerance";
}

Quantity contact_quantity(const StaticContact& solved) {
  const contact::ContactResult& result = solved.contact;
  const auto list = [](const Eigen::VectorXd& values) {
    return Quantity(Quantity::List(values.begin(), values.end()));
  };
  Quantity::Table table{{"status", words(result.status)},
                        {"stiffness", result.stiffness},
                        {"enlargements", result.enlargements},
                        {"iterations", result.iterations},
                        {"pairs", solved.faces.count()},
                        {"closed", result.closed},
                        {"max_penetration", solved.penetration()},
                        {"largest_tension", result.largest_tension},
                        {"complementarity", result.complementarity},
                        {"crack", Quantity::List(solved.faces.crack.begin(), solved.faces.crack.end())},
                        {"position", list(solved.faces.pairs.position)},
                        {"tributary_length", list(solved.faces.pairs.tributary_length)},
                        {"opening", list(solved.motion.opening)},
                        {"contact_force", list(result.pair_force)},
                        {"resultant", resultants(solved)}};
  if (result.shear_force.size() > 0) {
    table.emplace_back("friction_iterations", result.friction_iterations);
    table.emplace_back("sliding", list(solved.motion.sliding));
    table.emplace_back("shear_force", list(result.shear_force));
  }
  return table;
}

}  // namespace sunder::simulation
