#pragma once
/// Nodal fields carried over from a body to the one into which it has grown.
///
/// A node that stands where one stood keeps its value. Any other takes the value that the old polygons' own field,
/// u(ξ) = ξ^A u_b, has at its place; on the old faces of a crack, the value of its own side. Both faces of a new piece
/// of crack get the same value: it opens from closed. Rigid motions go over exactly, to round-off, and so does a
/// uniform strain, but for the polygons of tips, whose own field has faces free of traction: there it is exact where it
/// puts none on the faces (tension along the crack), and any other opens them. The particular part of loads that act
/// inside a polygon is not looked at: it is of the order of the polygon's size squared and the next solution restores
/// it.

#include <Eigen/Core>
#include <span>

#include "solver/crack/cut_options.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

struct TransferredFields {
  Eigen::MatrixXd values;  ///< (new dofs, m)
  int interpolated_nodes = 0;
};

/// `values` (old dofs, m): any number of fields. `before`, `earlier` and `after` are the body, its formation, and the
/// body after the growth that `report` describes; `same` is Growth::same. Only the polygons that have changed are
/// searched. Throws std::invalid_argument where the number of rows is not that of the old body's degrees of freedom.
[[nodiscard]] TransferredFields transfer_fields(const Body& before, const sbfem::Formation& earlier, const Body& after,
                                                std::span<const int> same, const crack::CutReport& report,
                                                const Eigen::Ref<const Eigen::MatrixXd>& values);

/// A body, what is formed of it, and fields of its nodes (dofs, m).
struct FieldsOnBody {
  const Body& body;
  const sbfem::Formation& formation;
  const Eigen::Ref<const Eigen::MatrixXd>& values;
};

/// What a transfer does to the energies of each field; those of the polygons that stay are not even looked at.
struct TransferredEnergies {
  Eigen::VectorXd strain_energy_change;  ///< (m) of ½ fᵀ K f, [J/m] where the column is a displacement [m]
  Eigen::VectorXd strain_energy;         ///< (m) ½ fᵀ K f before
  /// (m) of ½ fᵀ M f, [J/m] where the column is a velocity [m/s]; empty where the formations have no mass.
  Eigen::VectorXd kinetic_energy_change;
  Eigen::VectorXd kinetic_energy;  ///< (m) ½ fᵀ M f before
};

[[nodiscard]] TransferredEnergies transferred_energies(const FieldsOnBody& before, const FieldsOnBody& after,
                                                       std::span<const int> same);

}  // namespace sunder::simulation
