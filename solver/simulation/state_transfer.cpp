#include "solver/simulation/state_transfer.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/interior_values.hpp"

namespace sunder::simulation {
namespace {

using Eigen::MatrixXd;
using mesh::Point;

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Where a node stands, and a place close to it that lies inside a polygon of the new body which has this node: on the
/// faces of a crack it tells the node's side.
struct Target {
  int node = -1;
  Point place, inwards;
};

/// A place in a sector of an old polygon, and how far outside it lies, over the polygon's size.
struct InSector {
  double xi = 0.0, position = 0.0, excess = 0.0;
};

InSector in_sector(const Point& a, const Point& b, const Point& from_centre, double size) {
  const Point along = b - a;
  const double twice_area = cross(a, along);
  const double xi = cross(from_centre, along) / twice_area, s_xi = cross(a, from_centre) / twice_area;
  const double beyond = (xi - 1.0) * twice_area / along.norm();
  const double beside = std::max(-s_xi, s_xi - xi) * along.norm();
  InSector in{.xi = std::clamp(xi, 0.0, 1.0), .excess = std::max({0.0, beyond, beside, -xi * size}) / size};
  in.position = xi > 0.0 ? std::clamp(s_xi / xi, 0.0, 1.0) : 0.0;
  return in;
}

/// The polygons of the old body that are no more, searched by place: a new node lies in none of those that stay, or
/// they would have changed.
class OldBody {
 public:
  OldBody(const Body& body, const sbfem::Formation& formation, const std::vector<char>& stays,
          const Eigen::Ref<const MatrixXd>& values)
      : body_(body), formation_(formation), values_(values) {
    for (int i = 0; i < body.nodes.polygon_count(); ++i) {
      if (stays[static_cast<std::size_t>(i)] != 0) continue;
      const mesh::NodalPolygon polygon = body.nodes.polygon(i);
      Point low = polygon.scaling_centre, high = low;
      for (const int node : polygon.nodes) {
        low = low.cwiseMin(body.nodes.coordinates().col(node));
        high = high.cwiseMax(body.nodes.coordinates().col(node));
      }
      boxes_.push_back({.polygon = i, .low = low, .high = high});
    }
  }

  /// (2, m)
  Eigen::Matrix2Xd at(const Target& target) {
    const Place place = find(target);
    return field(place.polygon).at({.edge = place.edge, .position = place.position, .xi = place.xi});
  }

 private:
  struct Box {
    int polygon = -1;
    Point low, high;
  };
  struct Place {
    int polygon = -1, edge = -1;
    double position = 0.0, xi = 0.0;
    double excess = std::numeric_limits<double>::infinity();   // of the node, nothing where it is round-off
    double inwards = std::numeric_limits<double>::infinity();  // of the place inside, decides among those
  };

  Place find(const Target& target) const {
    constexpr double touching = 1e-9;
    Place best;
    for (const Box& box : boxes_) {
      const double size = (box.high - box.low).maxCoeff(), reach = touching * size;
      if (((target.place - box.low).array() < -reach).any() || ((target.place - box.high).array() > reach).any())
        continue;
      look_into(box.polygon, size, touching, target, best);
    }
    if (best.polygon >= 0) return best;
    // Round-off has put the node outside every polygon: the nearest takes it.
    for (const Box& box : boxes_) {
      look_into(box.polygon, (box.high - box.low).maxCoeff(), std::numeric_limits<double>::infinity(), target, best);
    }
    return best;
  }

  void look_into(int polygon, double size, double touching, const Target& target, Place& best) const {
    const mesh::NodalPolygon p = body_.nodes.polygon(polygon);
    const auto& x = body_.nodes.coordinates();
    std::size_t start = 0;
    for (std::size_t e = 0; e < p.orders.size(); ++e) {
      const Point a = x.col(p.nodes[start]) - p.scaling_centre;
      start += static_cast<std::size_t>(p.orders[e]);
      const Point b = x.col(p.nodes[start % p.nodes.size()]) - p.scaling_centre;
      const InSector node = in_sector(a, b, target.place - p.scaling_centre, size);
      if (node.excess > touching) continue;
      const double excess = node.excess > 1e-9 ? node.excess : 0.0;
      const double inwards = in_sector(a, b, target.inwards - p.scaling_centre, size).excess;
      if (excess > best.excess || (excess == best.excess && inwards >= best.inwards)) continue;
      best = {.polygon = polygon,
              .edge = static_cast<int>(e),
              .position = node.position,
              .xi = node.xi,
              .excess = excess,
              .inwards = inwards};
    }
  }

  sbfem::InteriorValues& field(int polygon) {
    std::unique_ptr<sbfem::InteriorValues>& made = fields_[polygon];
    if (made) return *made;
    const mesh::NodalPolygon p = body_.nodes.polygon(polygon);
    const sbfem::Boundary boundary = sbfem::boundary_of(body_.nodes, polygon);
    const sbfem::Coefficients coefficients =
        sbfem::coefficients(boundary, body_.materials[static_cast<std::size_t>(p.material)]);
    const sbfem::PolygonSolution solution = sbfem::solution_of_stiffness(coefficients, formation_.stiffness(polygon));
    MatrixXd on_boundary(2 * std::ssize(p.nodes), values_.cols());
    for (Eigen::Index i = 0; i < std::ssize(p.nodes); ++i) {
      on_boundary.middleRows<2>(2 * i) = values_.middleRows<2>(2 * p.nodes[static_cast<std::size_t>(i)]);
    }
    made = std::make_unique<sbfem::InteriorValues>(boundary, coefficients, solution, on_boundary);
    return *made;
  }

  const Body& body_;
  const sbfem::Formation& formation_;
  const Eigen::Ref<const MatrixXd>& values_;
  std::vector<Box> boxes_;
  std::map<int, std::unique_ptr<sbfem::InteriorValues>> fields_;
};

/// For each new node the old node at its place, -1 where there is none.
std::vector<int> kept_nodes(const Body& before, const Body& after, std::span<const int> same,
                            const crack::CutReport& report) {
  std::vector<int> from(static_cast<std::size_t>(after.nodes.node_count()), -1);
  std::copy(report.vertex_from.begin(), report.vertex_from.end(), from.begin());
  for (int i = 0; i < after.nodes.polygon_count(); ++i) {
    if (same[static_cast<std::size_t>(i)] < 0) continue;
    const mesh::NodalPolygon now = after.nodes.polygon(i),
                             old = before.nodes.polygon(same[static_cast<std::size_t>(i)]);
    for (std::size_t k = 0; k < now.nodes.size(); ++k) from[static_cast<std::size_t>(now.nodes[k])] = old.nodes[k];
  }
  return from;
}

/// The nodes without an old one, each once, in the order of the polygons.
std::vector<Target> moved_nodes(const Body& after, const std::vector<int>& from) {
  constexpr double step_inwards = 1e-6;
  std::vector<char> known(from.size());
  for (std::size_t node = 0; node < from.size(); ++node) known[node] = from[node] >= 0;
  const auto& x = after.nodes.coordinates();
  std::vector<Target> targets;
  for (int i = 0; i < after.nodes.polygon_count(); ++i) {
    const mesh::NodalPolygon p = after.nodes.polygon(i);
    std::size_t start = 0;
    for (const int order : p.orders) {
      const std::size_t end = start + static_cast<std::size_t>(order);
      const Point middle =
          (x.col(p.nodes[start]) + x.col(p.nodes[end % p.nodes.size()]) + p.scaling_centre) / 3.0;  // of the sector
      for (std::size_t k = start; k <= end; ++k) {
        const int node = p.nodes[k % p.nodes.size()];
        if (known[static_cast<std::size_t>(node)]) continue;
        known[static_cast<std::size_t>(node)] = 1;
        const Point place = x.col(node);
        const Point inwards = numerics::planted_fault("simulation/transfer-swaps-faces")
                                  ? Point(place - step_inwards * (middle - place))
                                  : Point(place + step_inwards * (middle - place));
        targets.push_back({.node = node, .place = place, .inwards = inwards});
      }
      start = end;
    }
  }
  return targets;
}

enum class Matrix { stiffness, mass };

/// ½ fᵀ K f (or M) of each column over the polygons with skip[i] < 0.
Eigen::VectorXd energies(const Body& body, const sbfem::Formation& formation, Matrix which,
                         const std::vector<char>& skip, const Eigen::Ref<const MatrixXd>& values) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.cols());
  MatrixXd local;
  for (int i = 0; i < body.nodes.polygon_count(); ++i) {
    if (!skip.empty() && skip[static_cast<std::size_t>(i)]) continue;
    const mesh::NodalPolygon p = body.nodes.polygon(i);
    local.resize(2 * std::ssize(p.nodes), values.cols());
    for (Eigen::Index k = 0; k < std::ssize(p.nodes); ++k) {
      local.middleRows<2>(2 * k) = values.middleRows<2>(2 * p.nodes[static_cast<std::size_t>(k)]);
    }
    const sbfem::Formation::ConstMap matrix = which == Matrix::stiffness ? formation.stiffness(i) : formation.mass(i);
    for (Eigen::Index m = 0; m < values.cols(); ++m) sum[m] += 0.5 * local.col(m).dot(matrix * local.col(m));
  }
  return sum;
}

/// 1 for each of `count` polygons that `same` names.
std::vector<char> named_by(std::span<const int> same, int count) {
  std::vector<char> named(static_cast<std::size_t>(count), 0);
  for (const int polygon : same) {
    if (polygon >= 0) named[static_cast<std::size_t>(polygon)] = 1;
  }
  return named;
}

}  // namespace

TransferredFields transfer_fields(const Body& before, const sbfem::Formation& earlier, const Body& after,
                                  std::span<const int> same, const crack::CutReport& report,
                                  const Eigen::Ref<const MatrixXd>& values) {
  if (values.rows() != before.dofs()) {
    throw std::invalid_argument("transfer_fields: values has " + std::to_string(values.rows()) + " rows, accepted is " +
                                std::to_string(before.dofs()));
  }
  const std::vector<int> from = kept_nodes(before, after, same, report);
  TransferredFields result;
  result.values.resize(after.dofs(), values.cols());
  for (int node = 0; node < after.nodes.node_count(); ++node) {
    const int old = from[static_cast<std::size_t>(node)];
    if (old >= 0) result.values.middleRows<2>(2 * node) = values.middleRows<2>(2 * old);
  }
  OldBody old_body(before, earlier, named_by(same, before.nodes.polygon_count()), values);
  for (const Target& target : moved_nodes(after, from)) {
    result.values.middleRows<2>(2 * target.node) = old_body.at(target);
    ++result.interpolated_nodes;
  }
  return result;
}

TransferredEnergies transferred_energies(const FieldsOnBody& before, const FieldsOnBody& after,
                                         std::span<const int> same) {
  std::vector<char> stayed(same.size());
  std::ranges::transform(same, stayed.begin(), [](int polygon) { return polygon >= 0; });
  const std::vector<char> was_kept = named_by(same, before.body.nodes.polygon_count());
  const auto change = [&](Matrix which) -> Eigen::VectorXd {
    return energies(after.body, after.formation, which, stayed, after.values) -
           energies(before.body, before.formation, which, was_kept, before.values);
  };
  TransferredEnergies result;
  result.strain_energy = energies(before.body, before.formation, Matrix::stiffness, {}, before.values);
  result.strain_energy_change = change(Matrix::stiffness);
  if (before.formation.has_mass() && after.formation.has_mass()) {
    result.kinetic_energy = energies(before.body, before.formation, Matrix::mass, {}, before.values);
    result.kinetic_energy_change = change(Matrix::mass);
  }
  return result;
}

}  // namespace sunder::simulation
