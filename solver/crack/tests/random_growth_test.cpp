#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "solver/crack/advance_tip.hpp"
#include "solver/crack/insert_crack.hpp"
#include "solver/crack/tests/crack_meshes.hpp"

namespace sunder::crack {
namespace {

using testing::Point;

/// Mouth on one of the four sides of a square and a direction into it.
struct Start {
  Point mouth, inwards;
};

Start random_start(std::mt19937& random, double side) {
  std::uniform_real_distribution<double> along(0.05 * side, 0.95 * side);
  const double s = along(random);
  switch (random() % 4) {
    case 0:
      return {{s, 0}, {0, 1}};
    case 1:
      return {{side, s}, {-1, 0}};
    case 2:
      return {{s, side}, {0, -1}};
    default:
      return {{0, s}, {1, 0}};
  }
}

Point turned(const Point& p, double angle) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

TEST(RandomGrowth, KeepsAllInvariantsOver200PathsOf20Advances) {
  constexpr double side = 10.0;
  std::mt19937 random(20260711);
  const mesh::PolygonMesh body = testing::brick_mesh(10, 10, 0.25, 7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int inserted = 0, advanced = 0, ended = 0, refused = 0, rejected = 0;
  for (int trial = 0; trial < 200; ++trial) {
    mesh::PolygonMesh mesh = body;
    const Start start = random_start(random, side);
    CrackPath path{{start.mouth}};
    double angle = (unit(random) - 0.5) * 2.0;
    const int legs = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < legs; ++k) {
      const double length = std::pow(10.0, -1.5 + 2.0 * unit(random));
      path.points.push_back(path.points.back() + length * turned(start.inwards, angle));
      angle += (unit(random) - 0.5) * 2.0;
    }
    try {
      insert_crack(mesh, path, 0);
      ++inserted;
    } catch (const CrackError& error) {
      // A random path may leave the body; it must not be one that cannot be cut.
      EXPECT_EQ(std::string(error.what()).find("cannot be cut"), std::string::npos) << error.what();
      ++rejected;
      continue;
    }
    ASSERT_TRUE(testing::is_sound(mesh, body)) << "path " << trial;
    ASSERT_EQ(testing::tip_of(mesh, 0), path.points.back());
    for (int step = 0; step < 20 && mesh.cracks[0].tip_polygon >= 0; ++step) {
      const Point tip = testing::tip_of(mesh, 0);
      const Point back = (tip - mesh.vertices[mesh.cracks[0].lower.back()]).normalized();
      const double turn = (unit(random) - 0.5) * std::numbers::pi * (random() % 3 == 0 ? 1.0 : 0.2);
      const double length = std::pow(10.0, -3.0 + 4.0 * std::pow(unit(random), 1.5));
      const Advance a = advance_tip(mesh, 0, tip + length * turned(back, turn));
      ASSERT_TRUE(testing::is_sound(mesh, body)) << "path " << trial << " step " << step;
      if (a.event == TipEvent::advanced) ++advanced;
      if (a.event == TipEvent::reached_boundary || a.event == TipEvent::reached_crack) ++ended;
      if (a.event == TipEvent::refused) {
        ++refused;
        ADD_FAILURE() << a.reason;
      }
    }
  }
  // No segment here turns by more than 90 degrees, so there is nothing to refuse.
  EXPECT_GE(inserted, 150);
  EXPECT_EQ(inserted + rejected, 200);
  EXPECT_EQ(refused, 0);
  EXPECT_GT(ended, 0);
}

}  // namespace
}  // namespace sunder::crack
