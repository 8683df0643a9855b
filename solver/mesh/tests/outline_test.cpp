#include "solver/mesh/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

struct RefusedOutline {
  const char* description;
  Outline outline;
  const char* words;
};

Outline with_hole(std::vector<std::vector<Point>> holes) {
  Outline outline = rectangle(4, 4);
  outline.holes = std::move(holes);
  return outline;
}

TEST(CheckOutline, RefusesWithVertexEdgeAndPlace) {
  Outline clockwise = rectangle(2, 1);
  std::reverse(clockwise.vertices.begin(), clockwise.vertices.end());
  Outline twice = rectangle(2, 1);
  twice.boundaries["again"] = {1};
  Outline beyond = rectangle(2, 1);
  beyond.boundaries["far"] = {4};
  const RefusedOutline cases[] = {
      {"two vertices", {.vertices = {{0, 0}, {1, 0}}}, "the outline has 2 vertices; at least 3"},
      {"none", {}, "the outline has 0 vertices"},
      {"NaN", {.vertices = {{0, 0}, {1, std::nan("")}, {1, 1}}}, "vertex 1 of the outline is (1, nan)"},
      {"infinite", {.vertices = {{0, 0}, {1, 0}, {HUGE_VAL, 1}}}, "vertex 2 of the outline is (inf, 1)"},
      {"repeated",
       {.vertices = {{0, 0}, {1, 0}, {1, 0}, {1, 1}}},
       "vertices 1 and 2 of the outline are both at (1, 0)"},
      {"closed twice", {.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 0}}}, "the line closes by itself"},
      {"bow tie",
       {.vertices = {{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
       "edge 0 of the outline, (0, 0) to (2, 2), meets edge 2"},
      {"touching", {.vertices = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, "meets edge"},
      {"folded back", {.vertices = {{0, 0}, {2, 0}, {1, 0}, {1, 1}}}, "meets edge 1"},
      {"clockwise", clockwise, "runs clockwise from (0, 1)"},
      {"hole outside", with_hole({{{5, 5}, {6, 5}, {6, 6}}}), "hole 0 at (5, 5) lies outside"},
      {"hole crosses", with_hole({{{3, 3}, {5, 3}, {3, 3.5}}}), "of hole 0"},
      {"holes nested", with_hole({{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{2, 1.5}, {2.5, 1.5}, {2, 2}}}),
       "lies inside hole 0"},
      {"hole of two", with_hole({{{1, 1}, {2, 1}}}), "hole 0 has 2 vertices"},
      {"two names", twice, "edge 1 belongs to boundaries \"again\" and \"right\""},
      {"no such edge", beyond, "boundary \"far\" names edge 4; the outline and its holes have edges 0 to 3"},
  };
  for (const RefusedOutline& c : cases) {
    SCOPED_TRACE(c.description);
    expect_words(mesh_error([&] { check_outline(c.outline); }), c.words);
  }
}

TEST(CheckOutline, AcceptsStraightVerticesHolesOfEitherSenseAndAnyUnit) {
  for (const double unit : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (const double shift : {0.0, 1e6}) {
      Outline outline;
      for (const Point& p : {Point(0, 0), Point(2, 0), Point(4, 0), Point(4, 4), Point(0, 4)}) {
        outline.vertices.push_back(unit * (p + Point(shift, shift)));
      }
      outline.holes = {
          {unit * Point(1 + shift, 1 + shift), unit * Point(2 + shift, 1 + shift), unit * Point(1 + shift, 2 + shift)},
          {unit * Point(3 + shift, 3 + shift), unit * Point(2 + shift, 3 + shift), unit * Point(3 + shift, 2 + shift)}};
      EXPECT_NO_THROW(check_outline(outline)) << unit << ", " << shift;
    }
  }
}

TEST(CheckOutline, AcceptsASlotAThousandthOfTheBodyWide) {
  EXPECT_NO_THROW(check_outline({.vertices = {{0, 0}, {1, 0}, {1, 1}, {0.5005, 1}, {0.5, 0.2}, {0.4995, 1}, {0, 1}}}));
}

}  // namespace
}  // namespace sunder::mesh
