// In place of static_contact.cpp in a build without contact: no scene that asks for it comes here.
#include <cassert>

#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/static_contact.hpp"

namespace sunder::simulation {

const bool built::contact = false;

StaticContact solve_with_contact(const scene::Contact& /*wanted*/, const Body& /*body*/,
                                 const StaticEquations& /*equations*/, const Eigen::VectorXd& /*force*/) {
  assert(!"refuse_absent_parts");
  return {};
}

double StaticContact::penetration() const {
  return 0.0;
}

bool StaticContact::holds() const {
  return true;
}

std::string StaticContact::reason() const {
  return {};
}

results::Quantity contact_quantity(const StaticContact& /*solved*/) {
  return {};
}

}  // namespace sunder::simulation
