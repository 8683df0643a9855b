#include "solver/mesh/check_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

PolygonMesh grid() {
  return square_grid(rectangle(3, 3), 1.0);
}

struct Fault {
  const char* description;
  PolygonMesh mesh;
  std::function<void(PolygonMesh&)> plant;
  const char* words;
};

TEST(CheckMesh, NamesEveryFaultWithItsPlace) {
  const Fault faults[] = {
      {"empty", {}, [](auto&) {}, "the mesh has no polygons"},
      {"NaN", grid(), [](auto& m) { m.vertices[5].x() = std::nan(""); }, "vertex 5 at (nan, 1); finite"},
      {"no such vertex", grid(), [](auto& m) { m.polygons[2].vertices[0] = 99; },
       "polygon 2 names vertex 99; there are vertices 0 to 15"},
      {"two vertices", grid(), [](auto& m) { m.polygons[2].vertices.resize(2); },
       "polygon 2 with vertex 2 at (2, 0) has 2 vertices"},
      {"vertex twice", grid(), [](auto& m) { m.polygons[2].vertices.push_back(2); },
       "polygon 2 names vertex 2 at (2, 0) twice"},
      {"unused vertex", grid(), [](auto& m) { m.vertices.emplace_back(7, 7); },
       "vertex 16 at (7, 7) belongs to no polygon"},
      {"clockwise", grid(), [](auto& m) { std::reverse(m.polygons[4].vertices.begin(), m.polygons[4].vertices.end()); },
       "in the same sense"},
      {"all clockwise", cracked_square(),
       [](auto& m) {
         m.cracks.clear();
         m.polygons = {{.vertices = {0, 3, 2, 1}, .scaling_centre = {1, 1}}};
         m.vertices.resize(4);
       },
       "polygon 0 with vertex 0 at (0, 0) runs clockwise"},
      {"three on an edge", grid(),
       [](auto& m) {
         m.polygons.push_back({.vertices = {5, 6, 15}});
       },
       "edge 6-5 from (2, 1) to (1, 1) belongs to 3 polygons"},
      {"no area", grid(),
       [](auto& m) {
         m.vertices[0] = {1, 1};
       },
       "polygon 0"},
      {"edge without length", grid(), [](auto& m) { m.vertices[5] = m.vertices[6]; },
       "polygon 1: edge 6-5 from (2, 1) to (2, 1) has no length"},
      {"centre outside", grid(),
       [](auto& m) {
         m.polygons[3].scaling_centre = {1.5, 1.5};
       },
       "polygon 3 with vertex 4 at (0, 1): its scaling centre (1.5, 1.5) does not see its whole boundary"},
      {"centre on an edge", grid(),
       [](auto& m) {
         m.polygons[3].scaling_centre = {1, 1.5};
       },
       "scaling centre (1, 1.5)"},
      {"named edge inside", grid(),
       [](auto& m) {
         m.boundaries["left"].push_back({5, 6});
       },
       "boundary \"left\": edge 5-6 from (1, 1) to (2, 1) is not an edge of the outer boundary"},
      {"named edge turned", grid(), [](auto& m) { std::swap(m.boundaries["left"][0][0], m.boundaries["left"][0][1]); },
       "runs against the sense of its polygon"},
      {"duplicate vertex", grid(),
       [](auto& m) {
         m.vertices.push_back(m.vertices[6]);
         m.polygons[4].vertices[1] = 16;
       },
       "vertices 6 at (2, 1) and 16 at (2, 1) lie at one place"},
      {"hanging vertex", grid(),
       [](auto& m) {
         m.vertices.emplace_back(1.5, 1.0);
         m.polygons[4].vertices.insert(m.polygons[4].vertices.begin() + 1, 16);
       },
       "vertex 16 at (1.5, 1) hangs on edge"},
      {"crossing parts", grid(),
       [](auto& m) {
         m.vertices.insert(m.vertices.end(), {{2.5, 2.5}, {5, 2.5}, {5, 2.7}, {2.5, 2.7}});
         m.polygons.push_back({.vertices = {16, 17, 18, 19}, .scaling_centre = {3, 2.6}});
       },
       "cross; polygons overlap there"},
      {"crack not paired", cracked_square(), [](auto& m) { m.cracks[0].lower.clear(); },
       "crack 0 has 0 lower and 1 upper vertices"},
      {"crack without tip", cracked_square(), [](auto& m) { m.cracks[0].tip_polygon = 3; },
       "its tip polygon 3 is not an open polygon"},
      {"open without crack", cracked_square(), [](auto& m) { m.cracks.clear(); }, "is the tip polygon of 0 cracks"},
      {"faces end elsewhere", cracked_square(), [](auto& m) { m.cracks[0].lower[0] = 0; },
       "do not end at the ends of its tip polygon 0"},
      {"tip outside", cracked_square(),
       [](auto& m) {
         m.polygons[0].scaling_centre = {2.5, 1};
       },
       "(the crack tip) does not see"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.description);
    PolygonMesh mesh = fault.mesh;
    expect_words(mesh_error([&] {
                   fault.plant(mesh);
                   check_mesh(mesh);
                 }),
                 fault.words);
  }
}

TEST(CheckMesh, AcceptsSoundMeshesWithAndWithoutCracks) {
  EXPECT_NO_THROW(check_mesh(grid()));
  EXPECT_NO_THROW(check_mesh(cracked_square()));
}

TEST(CheckMesh, FindsPolygonsThatLieTwiceRoundAVertex) {
  // Eight sectors of 90° round a vertex: two full turns, each polygon sound by itself.
  PolygonMesh mesh;
  mesh.vertices.emplace_back(0, 0);
  for (int k = 0; k < 8; ++k) {
    const double angle = 1.5707963267948966 * k, radius = 1.0 + 0.1 * k;
    mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  for (int k = 0; k < 8; ++k) {
    mesh.polygons.push_back({.vertices = {0, 1 + k, 1 + (k + 1) % 8}});
    mesh.polygons.back().scaling_centre = chosen_centre(mesh, k);
  }
  expect_words(mesh_error([&] { check_mesh(mesh); }),
               "the polygons round vertex 0 at (0, 0) overlap: their angles make 2 turns");
}

struct Rung {
  const char* description;
  double scale, shift, thickness;
};

TEST(CheckMesh, AcceptsSliversUnitsAndPlaces) {
  const Rung rungs[] = {{"m", 1, 0, 1},
                        {"mm", 1e-3, 0, 1},
                        {"km", 1e3, 0, 1},
                        {"µm", 1e-6, 0, 1},
                        {"1e6 m away", 1, 1e6, 1},
                        {"mm, 1 km away", 1e-3, 1e3, 1},
                        {"sliver 1e-4", 1, 0, 1e-4},
                        {"sliver 1e-6", 1, 0, 1e-6},
                        {"sliver 1e-8", 1, 0, 1e-8},
                        {"sliver 1e-4, 1e6 m away", 1, 1e6, 1e-4}};
  for (const Rung& r : rungs) {
    SCOPED_TRACE(r.description);
    EXPECT_NO_THROW(square_grid(rectangle(3 * r.scale, 3 * r.scale * r.thickness, {r.shift, r.shift}), r.scale));
  }
}

TEST(CheckMesh, RefusesASliverThatCoordinatesCannotHold) {
  // 1e-9 m wide at 1e6 m: neighbouring doubles are 1.2e-10 m apart there.
  expect_words(mesh_error([] {
                 listed_polygons({{1e6, 0}, {1e6 + 1e-9, 0}, {1e6 + 1e-9, 1}, {1e6, 1}}, {{0, 1, 2, 3}}, {});
               }),
               "has no length");
}

TEST(CheckMesh, AcceptsAShortEdge) {
  for (const double length : {1e-4, 1e-6, 1e-8}) {
    EXPECT_NO_THROW(listed_polygons({{0, 0}, {1, 0}, {1, 1}, {length, 1}, {0, 1 - length}}, {{0, 1, 2, 3, 4}}, {}))
        << length;
  }
}

}  // namespace
}  // namespace sunder::mesh
