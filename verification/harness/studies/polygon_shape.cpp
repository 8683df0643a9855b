#include "verification/harness/studies/polygon_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::verification {
namespace {

using mesh::Point;
using Points = std::vector<Point>;

Points circle(int count, double from, double to) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return points;
}

Points rectangle(double width, double height) {
  return {{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
}

Points star(int points, double inner) {
  Points vertices = circle(2 * points, 0.0, 2.0 * std::numbers::pi);
  for (std::size_t i = 1; i < vertices.size(); i += 2) vertices[i] *= inner;
  return vertices;
}

Points notch(int edges, double opening) {
  const double half = 0.5 * opening * std::numbers::pi / 180.0;
  Points vertices = circle(edges, -half, half);
  vertices.emplace_back(std::cos(half), std::sin(half));
  return vertices;
}

/// The vertices relative to the scaling centre.
Points vertices_of(const StudyInput& input, const std::string& shape) {
  constexpr double width = 1.6, height = 1.2;
  if (shape == "irregular") return {{-0.9, -0.6}, {0.4, -0.8}, {1.1, -0.2}, {0.9, 0.7}, {-0.1, 1.0}, {-0.8, 0.5}};
  if (shape == "regular") return circle(whole_parameter(input, "edges", 6), 0.3, 0.3 + 2.0 * std::numbers::pi);
  if (shape == "rectangle") return rectangle(1.0, 1.0 / number_parameter(input, "ratio"));
  if (shape == "star") return star(whole_parameter(input, "points", 8), number_parameter(input, "inner"));
  if (shape == "notch") return notch(whole_parameter(input, "edges", 12), number_parameter(input, "opening"));
  Points points = rectangle(width, height);
  if (shape == "short edge") {
    points.insert(points.begin() + 2, Point(width / 2, height / 2 - number_parameter(input, "length")));
    return points;
  }
  if (shape == "centre near edge") {
    const double distance = number_parameter(input, "distance");
    for (Point& point : points) point.y() = point.y() < 0.0 ? -distance : height - distance;
    return points;
  }
  throw CaseError(input.verification_case.id + ": parameters.shape: there is no shape \"" + shape + "\"");
}

material::Isotropic material_of(const StudyInput& input) {
  const std::string plane = text_parameter(input, "plane", "strain");
  if (plane != "strain" && plane != "stress")
    throw CaseError(input.verification_case.id + ": parameters.plane: \"strain\" or \"stress\" is needed");
  return {.youngs_modulus = number_parameter(input, "youngs_modulus", 1.0),
          .poisson_ratio = number_parameter(input, "poisson_ratio", 0.2),
          .density = number_parameter(input, "density", 1.0),
          .plane = plane == "strain" ? material::Plane::strain : material::Plane::stress};
}

}  // namespace

int whole_parameter(const StudyInput& input, std::string_view name, int otherwise) {
  const double value = number_parameter(input, name, otherwise);
  if (value != std::floor(value) || std::abs(value) > 1e6)
    throw CaseError(input.verification_case.id + ": parameters." + std::string(name) + ": a whole number is needed");
  return static_cast<int>(value);
}

ShapedPolygon shaped_polygon(const StudyInput& input) {
  const std::string shape = text_parameter(input, "shape");
  ShapedPolygon result{.mesh = {},
                       .material = material_of(input),
                       .order = whole_parameter(input, "order", 1),
                       .size = number_parameter(input, "scale", 1.0)};
  const double angle = number_parameter(input, "rotation", 0.0) * std::numbers::pi / 180.0;
  const double shift = number_parameter(input, "shift", 0.0);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  if (angle == 0.0) turn.setIdentity();

  Points& vertices = result.mesh.vertices = vertices_of(input, shape);
  const int first = whole_parameter(input, "first", 0);
  if (first != 0)
    std::rotate(vertices.begin(), vertices.begin() + first % static_cast<int>(vertices.size()), vertices.end());
  for (Point& vertex : vertices) vertex = (result.size * turn * vertex + Point(shift, shift)).eval();
  mesh::Polygon polygon{.vertices = {}, .scaling_centre = Point(shift, shift), .open = shape == "notch"};
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) polygon.vertices.push_back(i);
  result.mesh.polygons.push_back(polygon);
  return result;
}

sbfem::Boundary boundary_of(const ShapedPolygon& polygon) {
  return sbfem::boundary_of(mesh::place_nodes(polygon.mesh, [&](int, int) { return polygon.order; }), 0);
}

}  // namespace sunder::verification
