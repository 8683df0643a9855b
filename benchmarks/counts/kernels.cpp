// Convolution, crack water, polygons, assembly, contact: each with an answer that is known.

#include <cmath>
#include <memory>
#include <numbers>

#include "benchmarks/counts/region.hpp"
#include "solver/contact/contact_solver.hpp"
#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/crackwater/pressure_profile.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/sources.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::counts {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const material::Isotropic concrete{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0};

/// W_j = r^j W_0: the history force under unit accelerations is W_0 1 (r + r² + …), a geometric series.
constexpr double ratio = 0.999;

convolution::WeightSequence fading_weights(int n, long steps) {
  convolution::WeightSequence weights{n, false, MatrixXd(Index{n} * n, steps + 1)};
  MatrixXd first = MatrixXd::Constant(n, n, 1.0);
  first.diagonal().array() += n;
  for (long j = 0; j <= steps; ++j) weights.values.col(j) = std::pow(ratio, j) * first.reshaped();
  return weights;
}

/// All steps of a run; `size`: how many.
Work convolved(std::shared_ptr<convolution::Convolution> water, int n, long steps) {
  auto force = std::make_shared<VectorXd>(VectorXd::Zero(n));
  const VectorXd ones = VectorXd::Ones(n);
  return whole(
      [=] {
        for (long k = 0; k <= steps; ++k) {
          water->history_force(*force);
          water->append(ones);
        }
      },
      [=] {
        const double series = ratio * (1.0 - std::pow(ratio, steps)) / (1.0 - ratio);
        return std::abs((*force)[0] / (2.0 * n * series) - 1.0) < 1e-11;
      });
}

Work direct_convolution(long steps) {
  return convolved(std::make_shared<convolution::DirectSum>(fading_weights(4, steps), steps), 4, steps);
}

Work fast_convolution(long steps) {
  return convolved(std::make_shared<convolution::BlockFft>(fading_weights(4, steps), steps), 4, steps);
}

/// The seed paper's crack of 45 m with faces that close at 0.1 m/s at the mouth.
Work water_solve(long segments) {
  auto solver = std::make_shared<crackwater::PressureSolver>(
      crackwater::straight_crack(45.0, static_cast<int>(segments)), crackwater::Water{}, crackwater::ProfileOptions{});
  std::vector<double> apertures, rates;
  for (long i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(segments);
    apertures.push_back(0.10 - 0.05 * x);
    rates.push_back(-0.10 * (1.0 - x));
  }
  auto uplift = std::make_shared<double>(0.0);
  return whole(
      [=] {
        *uplift = solver->solve(apertures, rates, {490500.0, 0.0}).uplift_force;
      },
      [=] { return std::abs(*uplift / 146995198.365368616 - 1.0) < 1e-12; });  // closed form
}

/// An ellipse-like polygon of eight edges.
sbfem::Boundary polygon_of(long nodes) {
  const int edges = 8, order = static_cast<int>(nodes) / edges;
  sbfem::Boundary boundary{.nodes = Eigen::Matrix2Xd(2, nodes), .orders = std::vector<int>(edges, order)};
  const auto vertex = [](int e) -> Eigen::Vector2d {
    const double angle = 2.0 * std::numbers::pi * (e + 0.3) / edges;
    return {1.1 * std::cos(angle), 0.9 * std::sin(angle)};
  };
  for (int e = 0; e < edges; ++e) {
    for (int i = 0; i < order; ++i) {
      const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * i / order);
      boundary.nodes.col(e * order + i) = (1.0 - share) * vertex(e) + share * vertex(e + 1);
    }
  }
  return boundary;
}

Work polygon_stiffness(long nodes) {
  const sbfem::Boundary polygon = polygon_of(nodes);
  auto K = std::make_shared<MatrixXd>();
  return whole([=] { *K = sbfem::solve_polygon(sbfem::coefficients(polygon, concrete)).K; },
               [=] {
                 VectorXd shift(K->cols());
                 for (Index i = 0; i < shift.size(); ++i) shift[i] = i % 2 == 0 ? 1.0 : -0.5;
                 return (*K * shift).norm() < 1e-10 * K->norm() * shift.norm();
               });
}

Work modal_solution(long nodes) {
  const sbfem::Coefficients c = sbfem::coefficients(polygon_of(nodes), concrete);
  auto all = std::make_shared<sbfem::ModalSolution>();
  return whole([=] { *all = sbfem::modes(c); },
               [=] { return (sbfem::solve_polygon(c).K * all->Vu - all->Vq).norm() < 1e-10 * all->Vq.norm(); });
}

/// Forming and assembling a square of `size` x `size` polygons, all unlike.
Work assembly(long size) {
  const double side = static_cast<double>(size);
  mesh::Outline outline{.vertices = {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}, .boundaries = {}};
  mesh::PolygonMesh polygons = mesh::square_grid(outline, 1.0, 1'000'000);
  for (std::size_t v = 0; v < polygons.vertices.size(); ++v) {
    polygons.vertices[v] +=
        0.05 * mesh::Point(std::sin(3.0 * static_cast<double>(v)), std::cos(5.0 * static_cast<double>(v)));
  }
  const mesh::NodalMesh nodes = mesh::place_nodes(polygons, [](int, int) { return 1; });
  auto K = std::make_shared<Eigen::SparseMatrix<double>>();
  return whole([=] { *K = sbfem::assemble_stiffness(nodes, sbfem::form(nodes, std::vector{concrete}, {})); },
               [=] {
                 VectorXd shift(K->rows());
                 for (Index i = 0; i < shift.size(); ++i) shift[i] = i % 2 == 0 ? 1.0 : -0.5;
                 const VectorXd force = K->selfadjointView<Eigen::Lower>() * shift;
                 return force.norm() < 1e-13 * K->norm() * shift.norm();
               });
}

/// Faces that wave by 5 mm, three times along the crack, in exact contact; from cold.
Work contact_solve(long pairs) {
  MatrixXd F(pairs, pairs);
  for (long j = 0; j < pairs; ++j) {
    for (long i = 0; i < pairs; ++i)
      F(i, j) = 1e-10 * std::log(2.0 * static_cast<double>(pairs) / std::hypot(i - j, 0.5));
  }
  VectorXd gap(pairs);
  for (long i = 0; i < pairs; ++i) {
    gap[i] = 5e-3 * std::cos(6.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(pairs) + 0.3);
  }
  auto solver =
      std::make_shared<contact::ContactSolver>(contact::ContactOptions{.model = contact::ContactModel::exact});
  solver->set_faces(F, VectorXd::Constant(pairs, 0.25));
  return whole([=] { (void)solver->solve(gap); },
               [=] {
                 const contact::ContactResult& found = solver->result();
                 const VectorXd opened = gap + F * found.pair_force;
                 const double round_off = 1e-13 * (gap.norm() + F.norm() * found.pair_force.norm());
                 return found.pair_force.minCoeff() >= 0.0 && opened.minCoeff() >= -round_off && found.closed > 0 &&
                        std::abs(opened.dot(found.pair_force)) <= round_off * found.pair_force.sum();
               });
}

}  // namespace

std::vector<Region> kernel_regions() {
  return {
      {"direct-convolution", "all steps of a plain convolution of 4 degrees of freedom; size: steps", 1000,
       direct_convolution},
      {"fast-convolution", "the same by blocks and fast Fourier transforms; size: steps", 4000, fast_convolution},
      {"water-solve", "flux search and pressures in the seed paper's crack while it closes; size: segments", 450,
       water_solve},
      {"polygon-stiffness", "coefficients and stiffness of one polygon; size: nodes", 32, polygon_stiffness},
      {"modal-solution", "all modes of one polygon; size: nodes", 32, modal_solution},
      {"assembly", "forming and assembling a square of polygons; size: polygons along a side", 12, assembly},
      {"contact-solve", "exact contact of two faces from cold; size: pairs", 60, contact_solve},
  };
}

}  // namespace sunder::counts
