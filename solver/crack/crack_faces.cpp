#include "solver/crack/crack_faces.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "solver/numerics/quadrature.hpp"

namespace sunder::crack {
namespace {

struct Place {
  int polygon = -1, edge = -1;
};

/// Polygon and edge number of each of the face's edges.
std::map<mesh::Edge, Place> places_of(const mesh::PolygonMesh& mesh, const mesh::CrackFaces& faces) {
  std::map<mesh::Edge, Place> places;
  for (std::size_t i = 0; i + 1 < faces.lower.size(); ++i) {
    places[{faces.lower[i + 1], faces.lower[i]}] = {};
    places[{faces.upper[i], faces.upper[i + 1]}] = {};
  }
  if (places.empty()) return places;
  for (int p = 0; p < static_cast<int>(mesh.polygons.size()); ++p) {
    const mesh::Polygon& polygon = mesh.polygons[p];
    for (int e = 0; e < polygon.edge_count(); ++e) {
      const auto found = places.find(polygon.edge(e));
      if (found != places.end()) found->second = {p, e};
    }
  }
  return places;
}

}  // namespace

CrackPairs crack_pairs(const mesh::PolygonMesh& mesh, const mesh::NodalMesh& nodes, int crack) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("crack_pairs: crack " + std::to_string(crack) + ": " + what);
  };
  if (crack < 0 || crack >= static_cast<int>(mesh.cracks.size())) {
    refuse("there are " + std::to_string(mesh.cracks.size()));
  }
  const mesh::CrackFaces& faces = mesh.cracks[crack];
  const std::map<mesh::Edge, Place> places = places_of(mesh, faces);
  CrackPairs pairs;
  pairs.lower = {faces.lower.front()};
  pairs.upper = {faces.upper.front()};
  std::vector<double> position{0.0}, tributary{0.0};
  std::vector<mesh::Point> normal{mesh::Point::Zero()};  // ∫ N n ds
  double along = 0.0;
  const auto normal_of = [](const mesh::Point& d) { return mesh::Point(-d.y(), d.x()); };

  for (std::size_t i = 0; i + 1 < faces.lower.size(); ++i) {
    const mesh::Point d = mesh.vertices[faces.lower[i + 1]] - mesh.vertices[faces.lower[i]];
    const double length = d.norm();
    if (length == 0.0) {  // another crack's end parts this face: two pairs at one place
      pairs.lower.push_back(faces.lower[i + 1]);
      pairs.upper.push_back(faces.upper[i + 1]);
      position.push_back(along);
      tributary.push_back(0.0);
      normal.push_back(mesh::Point::Zero());
      continue;
    }
    const Place below = places.at({faces.lower[i + 1], faces.lower[i]}),
                above = places.at({faces.upper[i], faces.upper[i + 1]});
    if (below.polygon < 0 || above.polygon < 0) refuse("its faces are no edges of the mesh");
    std::vector<int> lower = nodes.edge_nodes(below.polygon, below.edge);
    const std::vector<int> upper = nodes.edge_nodes(above.polygon, above.edge);
    std::reverse(lower.begin(), lower.end());
    if (lower.size() != upper.size()) {
      refuse("its faces have edges of order " + std::to_string(lower.size() - 1) + " and " +
             std::to_string(upper.size() - 1) + " opposite each other; they must be equal");
    }
    // Gauss-Lobatto nodes: the rule of p + 1 points is exact to degree 2p - 1 >= p, so ∫ N_i ds is its weight.
    const numerics::QuadratureRule rule = numerics::gauss_lobatto(static_cast<int>(lower.size()));
    for (std::size_t k = 0; k < lower.size(); ++k) {
      const double share = 0.5 * length * rule.weights[static_cast<Eigen::Index>(k)];
      if (k > 0) {
        pairs.lower.push_back(lower[k]);
        pairs.upper.push_back(upper[k]);
        position.push_back(along + 0.5 * length * (1.0 + rule.points[static_cast<Eigen::Index>(k)]));
        tributary.push_back(0.0);
        normal.push_back(mesh::Point::Zero());
      }
      tributary.back() += share;
      normal.back() += share / length * normal_of(d);
    }
    along += length;
    position.back() = along;
  }
  if (faces.tip_polygon >= 0) {
    const mesh::Point d = mesh.polygons[faces.tip_polygon].scaling_centre - mesh.vertices[faces.lower.back()];
    tributary.back() += 0.5 * d.norm();
    normal.back() += 0.5 * normal_of(d);
    along += d.norm();
  }
  pairs.tip_position = along;
  const auto n = static_cast<Eigen::Index>(position.size());
  pairs.position = Eigen::Map<const Eigen::VectorXd>(position.data(), n);
  pairs.tributary_length = Eigen::Map<const Eigen::VectorXd>(tributary.data(), n);
  pairs.normals.resize(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    // A pair at a parted face may have no length of its own; it takes the direction of its neighbour.
    mesh::Point m = normal[i];
    if (m.norm() == 0.0 && i > 0) m = normal[i - 1];
    if (m.norm() == 0.0 && i + 1 < n) m = normal[i + 1];
    pairs.normals.col(i) = m.normalized();
  }
  return pairs;
}

CrackMotion crack_motion(const CrackPairs& pairs, const Eigen::Ref<const Eigen::VectorXd>& displacement) {
  CrackMotion motion{Eigen::VectorXd(pairs.count()), Eigen::VectorXd(pairs.count())};
  for (int i = 0; i < pairs.count(); ++i) {
    const Eigen::Vector2d jump =
        displacement.segment<2>(2 * pairs.upper[i]) - displacement.segment<2>(2 * pairs.lower[i]);
    const Eigen::Vector2d n = pairs.normals.col(i);
    motion.opening[i] = n.dot(jump);
    motion.sliding[i] = n.y() * jump.x() - n.x() * jump.y();
  }
  return motion;
}

}  // namespace sunder::crack
