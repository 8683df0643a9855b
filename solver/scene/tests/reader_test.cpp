// Well-formed scenes: every table arrives in its member.
#include "solver/scene/reader.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "solver/scene/tests/scenes.hpp"

namespace sunder::scene {
namespace {

TEST(Reader, ReadsAStaticScene) {
  const Scene scene = read_scene_text(static_scene, "dam.toml");
  EXPECT_EQ(scene.name, "block");
  EXPECT_EQ(scene.analysis, Analysis::static_);
  EXPECT_EQ(scene.file, "dam.toml");
  ASSERT_TRUE(scene.geometry);
  ASSERT_EQ(scene.geometry->outline.size(), 4u);
  EXPECT_EQ(scene.geometry->outline[2], Point(2, 3));
  EXPECT_EQ(scene.geometry->boundaries.at("base"), std::vector<int>{0});
  EXPECT_EQ(scene.mesh.size, 0.5);
  EXPECT_EQ(scene.mesh.order, 2);
  ASSERT_TRUE(scene.material);
  EXPECT_EQ(scene.material->youngs_modulus, 25e9);
  EXPECT_EQ(scene.material->poisson_ratio, 0.2);
  EXPECT_EQ(scene.material->plane, material::Plane::strain);
  ASSERT_EQ(scene.supports.size(), 1u);
  EXPECT_EQ(scene.supports[0].boundary, "base");
  EXPECT_EQ(scene.supports[0].fix, (std::array{true, true}));
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].traction, (std::array{0.0, 1e6}));
  EXPECT_FALSE(scene.gravity);
  EXPECT_FALSE(scene.modal);
  EXPECT_FALSE(scene.reservoir);
  EXPECT_TRUE(scene.cracks.empty());
}

TEST(Reader, ReadsEveryKeyOfTheBody) {
  const Scene scene = read_scene_text(R"(
name = "all keys"
analysis = "static"
[geometry]
outline = [[0, 0], [4, 0], [4, 4], [0, 4]]
holes = [[[1, 1], [2, 1], [1, 2]]]
boundaries = { base = [0], hole = [4, 5, 6] }
[mesh]
cells = "triangles"
size = 0.5
order = 3
tip_order = 8
tip_edges = 16
edge_size = 0.25
max_polygons = 1000
refine = [{ centre = [3, 3], radius = 1, size = 0.1 }]
[material]
youngs_modulus = 1
poisson_ratio = 0
density = 1
plane = "stress"
[[region]]
outline = [[0, 0], [1, 0], [1, 1]]
youngs_modulus = 2
poisson_ratio = 0.4999999999
density = 3
[[crack]]
path = [[4, 3], [3.5, 3], [3, 2.5]]
pressure = 7
[[crack]]
path = [[2, 3], [3, 3]]
inner = true
pressure = [1, 2, 3]
[[support]]
boundary = "base"
fix = ["y"]
displacement = [0, -0.25]
[[support]]
point = [0, 0]
fix = ["x", "y"]
[[load]]
boundary = "hole"
pressure = -5
[gravity]
acceleration = 1.62
)",
                                      "all.toml");
  EXPECT_EQ(scene.geometry->holes.at(0).at(2), Point(1, 2));
  EXPECT_EQ(scene.geometry->boundaries.at("hole"), (std::vector{4, 5, 6}));
  EXPECT_EQ(scene.mesh.cells, Cells::triangles);
  EXPECT_EQ(scene.mesh.order, 3);
  EXPECT_EQ(scene.mesh.tip_order, 8);
  EXPECT_EQ(scene.mesh.tip_edges, 16);
  EXPECT_EQ(scene.mesh.edge_size, 0.25);
  EXPECT_EQ(scene.mesh.max_polygons, 1000);
  ASSERT_EQ(scene.mesh.refine.size(), 1u);
  EXPECT_EQ(scene.mesh.refine[0].centre, Point(3, 3));
  EXPECT_EQ(scene.mesh.refine[0].radius, 1.0);
  EXPECT_EQ(scene.mesh.refine[0].size, 0.1);
  ASSERT_EQ(scene.regions.size(), 1u);
  EXPECT_EQ(scene.regions[0].outline.size(), 3u);
  EXPECT_EQ(scene.regions[0].material.youngs_modulus, 2.0);
  EXPECT_EQ(scene.regions[0].material.poisson_ratio, 0.4999999999);
  EXPECT_EQ(scene.regions[0].material.density, 3.0);
  EXPECT_EQ(scene.regions[0].material.plane, material::Plane::stress) << "regions share the plane state";
  ASSERT_EQ(scene.cracks.size(), 2u);
  EXPECT_EQ(scene.cracks[0].path.size(), 3u);
  EXPECT_FALSE(scene.cracks[0].inner);
  EXPECT_EQ(scene.cracks[0].pressure, std::vector<double>{7});
  EXPECT_TRUE(scene.cracks[1].inner);
  EXPECT_EQ(scene.cracks[1].pressure, (std::vector<double>{1, 2, 3}));
  ASSERT_EQ(scene.supports.size(), 2u);
  EXPECT_EQ(scene.supports[0].fix, (std::array{false, true}));
  EXPECT_EQ(scene.supports[0].displacement, (std::array{0.0, -0.25}));
  EXPECT_EQ(scene.supports[1].point, Point(0, 0));
  EXPECT_EQ(scene.loads[0].pressure, -5.0);
  EXPECT_EQ(scene.gravity->acceleration, 1.62);
}

TEST(Reader, ReadsGradedEdges) {
  const Override changes[] = {
      {"mesh.cells", "\"one\""},
      {"mesh.grade", "[{ corner = [2, 0], layers = 4 }, { corner = [0, 0], layers = 1, ratio = 0.5 }]"}};
  const Scene scene = read_scene_text(static_scene, "dam.toml", changes);
  ASSERT_EQ(scene.mesh.grade.size(), 2u);
  EXPECT_EQ(scene.mesh.grade[0].corner, Point(2, 0));
  EXPECT_EQ(scene.mesh.grade[0].layers, 4);
  EXPECT_EQ(scene.mesh.grade[0].ratio, Grading{}.ratio);
  EXPECT_EQ(scene.mesh.grade[1].ratio, 0.5);
}

TEST(Reader, ReadsPolygonsWrittenOut) {
  const Scene scene = read_scene_text(R"(
name = "two squares"
analysis = "modal"
[mesh]
vertices = [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1]]
polygons = [[0, 1, 4, 5], [1, 2, 3, 4]]
boundaries = { left = [[5, 0]] }
[material]
youngs_modulus = 1
poisson_ratio = 0.3
density = 1
[[support]]
boundary = "left"
fix = ["x", "y"]
[modal]
count = 7
interior_order = 2
)",
                                      "list.toml");
  ASSERT_TRUE(scene.mesh.list);
  EXPECT_EQ(scene.mesh.list->vertices.size(), 6u);
  EXPECT_EQ(scene.mesh.list->polygons.at(1), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(scene.mesh.list->boundaries.at("left").at(0), (mesh::Edge{5, 0}));
  EXPECT_EQ(scene.modal->count, 7);
  EXPECT_EQ(scene.modal->interior_order, 2);
}

TEST(Reader, GivesAModalSceneTheDefaultCount) {
  const Override changes[] = {{"analysis", "\"modal\""}, {"material.density", "2450"}};
  std::string text(static_scene);
  text.erase(text.find("[[load]]"));
  const Scene scene = read_scene_text(text, "dam.toml", changes);
  ASSERT_TRUE(scene.modal);
  EXPECT_EQ(scene.modal->count, Modal{}.count);
}

TEST(Reader, ReadsADynamicSceneThatIsNotBuiltYet) {
  const Scene scene = read_scene_text(dynamic_scene, "koyna.toml");
  EXPECT_EQ(scene.analysis, Analysis::dynamic);
  EXPECT_EQ(scene.reservoir->boundary, "upstream");
  EXPECT_EQ(scene.reservoir->level, 96.5);
  EXPECT_EQ(scene.reservoir->sound_speed, 1440.0);
  EXPECT_EQ(scene.reservoir->model, ReservoirModel::westergaard);
  EXPECT_EQ(scene.foundation->boundary, "base");
  EXPECT_EQ(scene.foundation->density, 0.0);
  EXPECT_EQ(scene.contact->model, ContactModel::exact);
  EXPECT_EQ(scene.contact->initial_stiffness, 1e9);
  EXPECT_EQ(scene.contact->penetration_tolerance, 1e-4);
  EXPECT_EQ(scene.crack_water->model, CrackWaterModel::uniform);
  EXPECT_EQ(scene.crack_water->relative_roughness, 0.25);
  EXPECT_EQ(scene.propagation->fracture_toughness, 2e6);
  EXPECT_EQ(scene.propagation->increment, 0.5);
  EXPECT_EQ(scene.ground_motion->horizontal, "koyna-1967/horizontal.csv");
  EXPECT_FALSE(scene.ground_motion->vertical);
  EXPECT_EQ(scene.ground_motion->horizontal_scale, -1.0);
  EXPECT_EQ(scene.dynamics->time_step, 0.01);
  EXPECT_EQ(scene.dynamics->integrator, Integrator::generalised_alpha);
  EXPECT_EQ(scene.dynamics->spectral_radius, 0.8);
  EXPECT_EQ(scene.dynamics->damping_modes, (std::array{1, 3}));
  EXPECT_EQ(scene.output->fields_every, 10);
}

TEST(Reader, ReadsCrackWaterAlone) {
  const Scene scene = read_scene_text(crack_water_scene, "pekau.toml");
  EXPECT_EQ(scene.crack_line->length, 45.0);
  EXPECT_EQ(scene.crack_line->segments, 450);
  EXPECT_EQ(scene.crack_line->aperture, (std::vector{0.10, 0.05}));
  EXPECT_EQ(scene.crack_line->opening_rate, (std::vector{-0.10, 0.0}));
  EXPECT_EQ(scene.crack_line->upstream_head, 50.0);
  EXPECT_FALSE(scene.crack_line->downstream_head);
  EXPECT_EQ(scene.crack_line->tip, Tip::closed);
  ASSERT_TRUE(scene.crack_line->march);
  EXPECT_EQ(scene.crack_line->march->time_step, 1e-3);
  EXPECT_EQ(scene.crack_line->march->initially, Filling::empty);
  EXPECT_EQ(scene.crack_line->quadrature, WaterQuadrature::midpoint);
  EXPECT_EQ(scene.crack_water->minimum_aperture, 0.03);
}

TEST(Reader, ReadsTheResponseOfAnUnboundedDomain) {
  const Scene scene = read_scene_text(response_scene, "response.toml");
  EXPECT_EQ(scene.reservoir->depth, 100.0);
  EXPECT_EQ(scene.foundation->half_width, 1.0);
  EXPECT_EQ(scene.foundation->shape, FoundationShape::disc);
  EXPECT_EQ(scene.response->frequencies, (std::vector{0.5, 0.9}));
  EXPECT_EQ(scene.response->times, (std::vector{0.07}));
  EXPECT_EQ(scene.response->face_elements, 10);
  EXPECT_EQ(scene.response->face_order, 3);
}

TEST(Reader, KnowsWhereTheTablesStand) {
  const Scene scene = read_scene_text(dynamic_scene, "koyna.toml");
  const auto line_of = [](std::string_view heading) {
    const std::string_view text(dynamic_scene);
    const auto at = text.find(heading);
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  };
  EXPECT_EQ(scene.locations.at("geometry").line, line_of("[geometry]"));
  EXPECT_EQ(scene.locations.at("crack[1]").line, line_of("[[crack]] # second"));
  EXPECT_EQ(place_of(scene, "crack[1]"),
            "koyna.toml:" + std::to_string(line_of("[[crack]] # second")) + ": [[crack]] ");
  EXPECT_EQ(place_of(scene, "geometry"), "koyna.toml:" + std::to_string(line_of("[geometry]")) + ": [geometry] ");
  EXPECT_EQ(place_of(scene, "load[3]"), "koyna.toml: [[load]] ");
}

TEST(Reader, ReadsAFileAndSeeksMeshesBesideIt) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "sunder-reader";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "dam.msh") << "$MeshFormat\n";
  std::ofstream(folder / "scene.toml") << mesh_file_scene;
  const Scene scene = read_scene(folder / "scene.toml");
  EXPECT_EQ(scene.mesh.file, folder / "dam.msh");
  EXPECT_TRUE(scene.mesh.dual);
  EXPECT_FALSE(scene.geometry);
  std::filesystem::remove_all(folder);
}

TEST(Reader, SaysThatAFileCannotBeOpened) {
  EXPECT_THROW(static_cast<void>(read_scene("no such scene.toml")), SceneError);
  EXPECT_THROW(static_cast<void>(read_scene(testing::TempDir())), SceneError);
}

TEST(Overrides, ReplaceAddAndAppend) {
  const Override changes[] = {{"mesh.order", "5"},
                              {"crack[0].path", "[[0, 1], [1, 1]]"},
                              {"crack[1].path", "[[2, 2], [1, 2]]"},
                              {"material.density", "2450"},
                              {"gravity.acceleration", "1.0"},
                              {"geometry.outline[2][1]", "4"},
                              {"mesh.refine", "[{ centre = [1, 1], radius = 0.5, size = 0.1 }]"},
                              {"mesh.refine[0].size", "0.05"}};
  const Scene scene = read_scene_text(static_scene, "dam.toml", changes);
  EXPECT_EQ(scene.mesh.order, 5);
  ASSERT_EQ(scene.cracks.size(), 2u);
  EXPECT_EQ(scene.cracks[1].path[0], Point(2, 2));
  EXPECT_EQ(scene.gravity->acceleration, 1.0);
  EXPECT_EQ(scene.geometry->outline[2].y(), 4.0);
  EXPECT_EQ(scene.mesh.refine[0].size, 0.05);
  EXPECT_EQ(place_of(scene, "crack[1]"), "dam.toml: [[crack]] ") << "an override has no line";
}

TEST(Overrides, AreSplitAtTheFirstEqualsSign) {
  const Override given = parse_override(" mesh.refine = [{ size = 1 }] ");
  EXPECT_EQ(given.key, "mesh.refine");
  EXPECT_EQ(given.value, "[{ size = 1 }]");
  EXPECT_THROW(static_cast<void>(parse_override("mesh.order")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(parse_override("=3")), std::invalid_argument);
}

TEST(Reader, PassesEveryRealNumberThroughTheFilterAndNothingElse) {
  int asked = 0;
  const Scene scene = read_scene_text(static_scene, "dam.toml", {}, [&](double value) {
    ++asked;
    return 2.0 * value;
  });
  EXPECT_EQ(scene.geometry->outline[2], Point(4, 6));
  EXPECT_EQ(scene.mesh.size, 1.0);
  EXPECT_EQ(scene.mesh.order, 2);  // a whole number
  EXPECT_EQ(scene.material->youngs_modulus, 50e9);
  EXPECT_EQ(scene.loads[0].traction, (std::array{0.0, 2e6}));
  EXPECT_EQ(asked, 8 + 1 + 2 + 2);  // outline, size, material, traction
}

}  // namespace
}  // namespace sunder::scene
