#pragma once
/// Pictures of a body: from its displacement to points, polygons and fields for results::FieldFile.
///
///     results::FieldFile file(options.output / field_file_name);
///     const FieldGeometry geometry = field_geometry(body);              // again where a crack has grown
///     file.begin_mesh(geometry.mesh);
///     file.append(time, {.point_data = {vector_field(geometry, "displacement", u), vector_field(geometry, "velocity",
///     v)},
///                        .cell_data = {stress_field(geometry, u)}});
///     file.commit();
///
/// A scene that asks for no fields builds nothing of this.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

#include "solver/results/field_file.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

inline constexpr const char* field_file_name = "results.h5";

/// Whether the scene asks for fields.
[[nodiscard]] bool wants_fields(const scene::Scene& scene);

/// A body as polygons to be drawn, and what its fields are made of. The points are the nodes of the body, two at each
/// place of a crack's faces, and then the tip of every crack polygon, which is the last corner of that polygon.
struct FieldGeometry {
  results::FieldMesh mesh;
  Eigen::SparseMatrix<double, Eigen::RowMajor> mean_strain;  ///< (3 polygons, dofs) [1/m]: ε_xx, ε_yy, γ_xy of each
  Eigen::SparseMatrix<double, Eigen::RowMajor> tips;         ///< (2 tips, dofs) [-]: from the dofs to the tips
  Eigen::VectorXd mean_strain_of_loads;                      ///< (3 polygons) [-], beside that of the dofs
  Eigen::VectorXd tips_of_loads;                             ///< (2 tips) [m], likewise
  std::vector<material::Isotropic> materials;                ///< (polygons)
};

/// The radial loads that a crack polygon carries (simulation/polygon_loads.hpp).
using TipLoads = std::function<std::vector<sbfem::RadialLoad>(int polygon, const sbfem::Boundary& boundary)>;

/// `tip_loads` may be empty. They matter inside the crack polygons alone: without them the mean stress there is that of
/// the same boundary displacement with dry, weightless faces.
[[nodiscard]] FieldGeometry field_geometry(const Body& body, const TipLoads& tip_loads = {});

/// A field of the nodes, `nodal` (dofs): the vector {x, y, 0} at each point. At a tip that of the crack polygon's own
/// field; "displacement" has that of the tip loads added.
[[nodiscard]] results::Field vector_field(const FieldGeometry& geometry, const std::string& name,
                                          const Eigen::VectorXd& nodal);

/// "stress" [Pa]: the mean over each polygon as {σ_xx, σ_yy, σ_zz, τ_xy, 0, 0}, from the displacement (dofs) [m]. σ_zz
/// = ν (σ_xx + σ_yy) in plane strain. At a crack tip, where stress is infinite, its mean is finite: it grows as the tip
/// polygon shrinks, about as size^-½, and is no measure of the crack; K_I and K_II are.
[[nodiscard]] results::Field stress_field(const FieldGeometry& geometry, const Eigen::VectorXd& displacement);

}  // namespace sunder::simulation
