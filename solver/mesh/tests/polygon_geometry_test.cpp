#include "solver/mesh/polygon_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

std::vector<Point> box(double a, double b) {
  return {{0, 0}, {a, 0}, {a, b}, {0, b}};
}

/// n points in turn on circles of radius 1 and `inner`.
std::vector<Point> star(int n, double inner) {
  std::vector<Point> points;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n, radius = i % 2 == 0 ? 1.0 : inner;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TEST(Moments, OfARectangleAreExact) {
  const Moments m = moments(box(3, 2));
  EXPECT_DOUBLE_EQ(m.area, 6.0);
  EXPECT_DOUBLE_EQ(m.centroid.x(), 1.5);
  EXPECT_DOUBLE_EQ(m.second(0, 0), 2.0 * 27.0 / 12.0);
  EXPECT_DOUBLE_EQ(m.second(1, 1), 3.0 * 8.0 / 12.0);
  EXPECT_NEAR(m.second(0, 1), 0.0, 1e-15);
}

TEST(Moments, AreNegativeClockwiseAndKeepTheirDigitsFarAway) {
  std::vector<Point> line = box(3, 2);
  for (Point& p : line) p += Point(1048576, -1048576);  // exact in binary
  EXPECT_DOUBLE_EQ(moments(line).area, 6.0);
  EXPECT_DOUBLE_EQ(moments(line).second(0, 0), 4.5);
  EXPECT_DOUBLE_EQ(moments(line).centroid.x(), 1048577.5);
  EXPECT_DOUBLE_EQ(moments(std::vector<Point>(line.rbegin(), line.rend())).area, -6.0);
}

TEST(Clearance, OfASquareIsTheSameForEveryParallelogram) {
  // Square of side a: distance a/2, unit-disc radius of gyration frame 2 a/√12: √3/2.
  const double square = std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(clearance(box(1, 1), {0.5, 0.5}), square, 1e-14);
  EXPECT_NEAR(clearance(box(1000, 1), {500, 0.5}), square, 1e-12);
  EXPECT_NEAR(clearance(std::vector<Point>{{0, 0}, {1, 0}, {11, 1}, {10, 1}}, {5.5, 0.5}), square, 1e-12);
  EXPECT_LT(clearance(box(1, 1), {1.5, 0.5}), 0.0);
  EXPECT_NEAR(clearance(box(1, 1), {1.0, 0.5}), 0.0, 1e-15);
}

struct SliverCase {
  const char* description;
  double thickness;
  double angle;
};

TEST(ScalingCentre, OfASliverIsItsMiddleDownToAThicknessOfOneInAHundredMillion) {
  const SliverCase cases[] = {{"flat 1:1e2", 1e-2, 0.0},  {"flat 1:1e4", 1e-4, 0.0},   {"flat 1:1e6", 1e-6, 0.0},
                              {"flat 1:1e8", 1e-8, 0.0},  {"turned 1:1e4", 1e-4, 0.7}, {"turned 1:1e6", 1e-6, 0.7},
                              {"turned 1:1e8", 1e-8, 0.7}};
  for (const SliverCase& c : cases) {
    const Point along(std::cos(c.angle), std::sin(c.angle)), across(-along.y(), along.x());
    const std::vector<Point> line{Point::Zero(), along, along + c.thickness * across, c.thickness * across};
    const ScalingCentre centre = scaling_centre(line);
    // Corners are rounded to 1e-16, which is 1e-16 / thickness of the sliver's width and moves its middle along by
    // that.
    EXPECT_NEAR((centre.point - 0.5 * along - 0.5 * c.thickness * across).norm(), 0.0, 1e-15 + 1e-16 / c.thickness)
        << c.description;
    EXPECT_NEAR(centre.clearance, std::sqrt(3.0) / 2.0, 1e-13 + 1e-15 / c.thickness) << c.description;
  }
}

TEST(ScalingCentre, LeavesTheCentroidWhereThatDoesNotSeeTheBoundary) {
  const std::vector<Point> angle{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  EXPECT_LT(clearance(angle, moments(angle).centroid), 0.0);
  const ScalingCentre centre = scaling_centre(angle);
  EXPECT_GT(centre.clearance, 0.05);
  EXPECT_NEAR(centre.point.x(), 0.5, 1e-6);  // the kernel is the square of the corner
  EXPECT_NEAR(centre.point.y(), 0.5, 1e-6);
}

TEST(ScalingCentre, OfAConcaveStarIsItsMiddle) {
  for (const double inner : {0.5, 0.15, 0.03}) {
    const ScalingCentre centre = scaling_centre(star(8, inner));
    EXPECT_NEAR(centre.point.norm(), 0.0, 1e-9) << inner;
    EXPECT_GT(centre.clearance, 0.0) << inner;
  }
}

TEST(ScalingCentre, OfALongTrapeziumMiddlesItsBestPoints) {
  const ScalingCentre centre = scaling_centre(box(100, 1), 2.0);  // 2: never content with the centroid
  EXPECT_NEAR(centre.point.x(), 50.0, 1e-6);
  EXPECT_NEAR(centre.point.y(), 0.5, 1e-8);
}

TEST(ScalingCentre, IsTheSamePlaceInEveryUnitAndFarFromTheOrigin) {
  const std::vector<Point> angle{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  const ScalingCentre here = scaling_centre(angle);
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6}) {
    std::vector<Point> line;
    for (const Point& p : angle) line.push_back(unit * p);
    EXPECT_NEAR((scaling_centre(line).point / unit - here.point).norm(), 0.0, 1e-12);
  }
  std::vector<Point> far;
  for (const Point& p : angle) far.push_back(p + Point(1e6, 1e6));
  EXPECT_NEAR((scaling_centre(far).point - Point(1e6, 1e6) - here.point).norm(), 0.0, 1e-9);  // ulp of 1e6 is 1e-10
}

TEST(Kernel, OfAConvexPolygonIsThePolygonAndOfACombIsEmpty) {
  EXPECT_NEAR(moments(kernel(box(3, 2))).area, 6.0, 1e-12);
  EXPECT_TRUE(kernel(std::vector<Point>{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}).empty());
  const std::vector<Point> angle{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  EXPECT_NEAR(moments(kernel(angle)).area, 1.0, 1e-12);
}

TEST(Clearance, OfAnOpenPolygonIgnoresItsFaces) {
  const std::vector<Point> line{{0, 1}, {0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}};
  EXPECT_NEAR(clearance(line, {1, 1}, true), std::sqrt(3.0) / 2.0, 1e-14);
  // A quarter opening: the notch is part of the outline, no edge.
  const std::vector<Point> notch{{0, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  EXPECT_GT(clearance(notch, {0, 0}, true), 0.5);
  EXPECT_LT(clearance(notch, {1.2, 0}, true), 0.0);
}

TEST(ChosenCentre, NamesThePolygonThatCannotHaveOne) {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {2, 0}};
  mesh.polygons = {{.vertices = {0, 2, 1}}, {.vertices = {0, 1, 3}}};
  expect_words(mesh_error([&] { chosen_centre(mesh, 0); }), "polygon 0 with vertex 0 at (0, 0) runs clockwise");
  expect_words(mesh_error([&] { chosen_centre(mesh, 1); }), "polygon 1 with vertex 0 at (0, 0) has the area 0");
}

}  // namespace
}  // namespace sunder::mesh
