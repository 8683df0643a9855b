/// How many digits of a polygon's stiffness and mass survive when its vertices move by one unit in the last place.

#include <cmath>
#include <random>

#include "solver/sbfem/polygon_solution.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/digits_trusted.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

struct Matrices {
  Eigen::MatrixXd K, M;
  bool sound = false;
};

Matrices matrices_of(const ShapedPolygon& polygon) {
  const sbfem::Coefficients coefficients = sbfem::coefficients(boundary_of(polygon), polygon.material);
  const sbfem::PolygonSolution solution = sbfem::solve_polygon(coefficients);
  if (solution.status != sbfem::PolygonStatus::converged) return {};
  Matrices result{solution.K, sbfem::mass(coefficients, solution), true};
  result.sound = result.M.allFinite();
  return result;
}

void jitter(mesh::PolygonMesh& mesh, std::mt19937_64& generator) {
  for (mesh::Point& vertex : mesh.vertices) {
    for (double& coordinate : vertex) coordinate = jittered(coordinate, generator);
  }
}

}  // namespace

StudyOutput run_jitter(const StudyInput& input) {
  const ShapedPolygon polygon = shaped_polygon(input);
  const int runs = whole_parameter(input, "runs", 30);
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "sbfem", "polygons");
    const Matrices plain = matrices_of(polygon);
    if (!plain.sound) output.summary.status = "stopped: the polygon has not converged";
    double spread_K = 0.0, spread_M = 0.0;
    std::mt19937_64 generator(1);
    for (int run = 0; run < runs && plain.sound; ++run) {
      ShapedPolygon moved = polygon;
      jitter(moved.mesh, generator);
      const Matrices other = matrices_of(moved);
      if (!other.sound) output.summary.status = "stopped: a jittered polygon has not converged";
      if (!other.sound) break;
      spread_K = std::fmax(spread_K, (other.K - plain.K).norm() / plain.K.norm());
      spread_M = std::fmax(spread_M, (other.M - plain.M).norm() / plain.M.norm());
    }
    output.summary.quantities["spread_stiffness"] = spread_K;
    output.summary.quantities["spread_mass"] = spread_M;
    output.summary.quantities["digits_stiffness"] = decimal_digits(spread_K);
    output.summary.quantities["digits_mass"] = decimal_digits(spread_M);
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
