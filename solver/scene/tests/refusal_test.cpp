// Scenes that cannot be used: what the reader says, and where.
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "solver/scene/reader.hpp"
#include "solver/scene/tests/scenes.hpp"

namespace sunder::scene {
namespace {

/// What the reader says about `text`; empty where it accepts it.
std::string refusal(const std::string& text, std::vector<Override> overrides = {}) {
  try {
    static_cast<void>(read_scene_text(text, "dam.toml", overrides));
    return {};
  } catch (const SceneError& error) {
    return error.what();
  }
}

/// `text` with its first `from` replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

struct Spoilt {
  const char* description;
  const char* scene;
  const char* from;
  const char* to;
  const char* message;  ///< its beginning; to the end where no list of keys follows
};
void PrintTo(const Spoilt& spoilt, std::ostream* out) {
  *out << spoilt.description;
}

class Refusal : public testing::TestWithParam<Spoilt> {};

TEST_P(Refusal, SaysWhereWhatAndWhatIsAccepted) {
  const Spoilt& spoilt = GetParam();
  const std::string said = refusal(changed(spoilt.scene, spoilt.from, spoilt.to));
  EXPECT_EQ(said.substr(0, std::string(spoilt.message).size()), spoilt.message) << said;
}

const Spoilt values[] = {
    {"syntax", static_scene, "size = 0.5",
     "size = ", "dam.toml:9:8: not TOML: Error while parsing key-value pair: expected value, saw '\\n'"},
    {"duplicate key", static_scene, "order = 2", "order = 2\norder = 3",
     "dam.toml:11:9: not TOML: Error while parsing key-value pair: cannot redefine existing integer 'order'"},
    {"misspelt key", static_scene, "size = 0.5", "siez = 0.5",
     "dam.toml:9:1: mesh.siez: there is no such key, did you mean `size`?; accepted: "},
    {"key of another table", static_scene, "order = 2", "youngs_modulus = 2",
     "dam.toml:10:1: mesh.youngs_modulus: there is no such key; `youngs_modulus` belongs to [material]; accepted "
     "here: "},
    {"unknown key", static_scene, "order = 2", "colour = 2",
     "dam.toml:10:1: mesh.colour: there is no such key; accepted: "},
    {"misspelt table", static_scene, "[material]", "[materiel]",
     "dam.toml:12:2: materiel: there is no such table, did you mean `material`?; accepted: "},
    {"misspelt list", static_scene, "[[support]]", "[[suport]]",
     "dam.toml:16:3: suport: there is no such table, did you mean `support`?; accepted: "},
    {"misspelt head", static_scene, "analysis", "analisys",
     "dam.toml:1:1: analysis: is missing; accepted: \"static\" | \"modal\" | \"dynamic\" | \"crack-water\" | "
     "\"response\" (what is asked)\ndam.toml:2:1: analisys: there is no such key, did you mean `analysis`?; "
     "accepted: "},
    {"negative size", static_scene, "size = 0.5", "size = -1",
     "dam.toml:9:8: mesh.size: -1 is not accepted; accepted: a number > 0 [m] (target polygon size; needed with "
     "[geometry] unless cells = \"one\")"},
    {"zero size", static_scene, "size = 0.5", "size = 0",
     "dam.toml:9:8: mesh.size: 0 is not accepted; accepted: a number > 0 [m] (target polygon size; needed with "
     "[geometry] unless cells = \"one\")"},
    {"NaN", static_scene, "size = 0.5", "size = nan",
     "dam.toml:9:8: mesh.size: nan is not a finite number; accepted: a number > 0 [m] (target polygon size; needed "
     "with [geometry] unless cells = \"one\")"},
    {"infinity", static_scene, "25e9", "inf",
     "dam.toml:13:18: material.youngs_modulus: inf is not a finite number; accepted: a number > 0 [Pa] (Young's "
     "modulus E)"},
    {"NaN in a point", static_scene, "[2, 3]", "[2, nan]",
     "dam.toml:5:32: geometry.outline[2]: nan is not a finite number; accepted: a number [m] (straight-edged, "
     "counter-clockwise, each vertex once)"},
    {"text for number", static_scene, "size = 0.5", "size = \"0.5\"",
     "dam.toml:9:8: mesh.size: \"0.5\" is a text; accepted: a number > 0 [m] (target polygon size; needed with "
     "[geometry] unless cells = \"one\")"},
    {"number for text", static_scene, "\"block\"", "3",
     "dam.toml:1:8: name: 3 is a whole number; accepted: a text in quotes (of the scene, in every result)"},
    {"fraction for whole", static_scene, "order = 2", "order = 2.5",
     "dam.toml:10:9: mesh.order: 2.5 is not accepted; accepted: a whole number 1 … 64 (polynomial order of the "
     "elements on polygon edges)"},
    {"order 0", static_scene, "order = 2", "order = 0",
     "dam.toml:10:9: mesh.order: 0 is not accepted; accepted: a whole number 1 … 64 (polynomial order of the elements "
     "on polygon edges)"},
    {"order 65", static_scene, "order = 2", "order = 65",
     "dam.toml:10:9: mesh.order: 65 is not accepted; accepted: a whole number 1 … 64 (polynomial order of the elements "
     "on polygon edges)"},
    {"order beyond int", static_scene, "order = 2", "order = 9000000000",
     "dam.toml:10:9: mesh.order: 9000000000 is not accepted; accepted: a whole number 1 … 64 (polynomial order of the "
     "elements on polygon edges)"},
    {"date", static_scene, "order = 2", "order = 2020-01-01",
     "dam.toml:10:9: mesh.order: is a date or time; accepted: a whole number 1 … 64 (polynomial order of the elements "
     "on polygon edges)"},
    {"nu 0.5", static_scene, "poisson_ratio = 0.2", "poisson_ratio = 0.5",
     "dam.toml:14:17: material.poisson_ratio: 0.5 is not accepted; accepted: a number >= 0, < 0.5 (Poisson's ratio ν; "
     "0.5, incompressible, has no finite stiffness)"},
    {"negative nu", static_scene, "poisson_ratio = 0.2", "poisson_ratio = -0.1",
     "dam.toml:14:17: material.poisson_ratio: -0.1 is not accepted; accepted: a number >= 0, < 0.5 (Poisson's ratio ν; "
     "0.5, incompressible, has no finite stiffness)"},
    {"unknown analysis", static_scene, "\"static\"", "\"statik\"",
     "dam.toml:2:12: analysis: \"statik\" is not known, did you mean \"static\"?; accepted: \"static\" | \"modal\" | "
     "\"dynamic\" | \"crack-water\" | \"response\""},
    {"far analysis", static_scene, "\"static\"", "\"thermal\"",
     "dam.toml:2:12: analysis: \"thermal\" is not known; accepted: \"static\" | \"modal\" | \"dynamic\" | "
     "\"crack-water\" | \"response\""},
    {"missing key", static_scene, "youngs_modulus = 25e9\n", "",
     "dam.toml:12:1: material.youngs_modulus: is missing; accepted: number > 0 [Pa] (Young's modulus E)"},
    {"missing name", static_scene, "name = \"block\"\n", "",
     "dam.toml:1:1: name: is missing; accepted: text (of the scene, in every result)"},
    {"three coordinates", static_scene, "[2, 3]", "[2, 3, 4]",
     "dam.toml:5:28: geometry.outline[2]: [2, 3, 4] is a list of 3; accepted: a point [x, y] [m] (straight-edged, "
     "counter-clockwise, each vertex once)"},
    {"outline of two", static_scene, "[[0, 0], [2, 0], [2, 3], [0, 3]]", "[[0, 0], [2, 0]]",
     "dam.toml:5:11: geometry.outline: has 2 points; accepted: at least 3"},
    {"empty outline", static_scene, "[[0, 0], [2, 0], [2, 3], [0, 3]]", "[]",
     "dam.toml:5:11: geometry.outline: has 0 points; accepted: at least 3"},
    {"closed outline", static_scene, "[0, 3]]", "[0, 3], [0, 0]]",
     "dam.toml:5:11: geometry.outline: points 4 and 0 are the same; accepted: each point once (the last side closes by "
     "itself)"},
    {"clockwise", static_scene, "[[0, 0], [2, 0], [2, 3], [0, 3]]", "[[0, 0], [0, 3], [2, 3], [2, 0]]",
     "dam.toml:5:11: geometry.outline: runs clockwise; accepted: counter-clockwise"},
    {"edge 4", static_scene, "base = [0]", "base = [0, 4]",
     "dam.toml:6:27: geometry.boundaries.base: there is no edge 4; accepted: 0 … 3 (edge i runs from vertex i to i + "
     "1, holes count on)"},
    {"edge twice", static_scene, "base = [0]", "base = [0, 0]",
     "dam.toml:6:27: geometry.boundaries.base: edge 0 is named twice"},
    {"empty boundary", static_scene, "crest = [2]", "crest = []",
     "dam.toml:6:36: geometry.boundaries.crest: has no edges; accepted: a list of edges"},
    {"one bracket", static_scene, "[[support]]", "[support]",
     "dam.toml:16:1: support: is one table; accepted: [[support]] (two brackets), any number of them"},
    {"two brackets", static_scene, "[mesh]", "[[mesh]]",
     "dam.toml:8:1: mesh: is a list of tables; accepted: one table [mesh]"},
    {"fix z", static_scene, "[\"x\", \"y\"]", "[\"x\", \"z\"]",
     "dam.toml:18:13: support[0].fix: \"z\" is not a direction; accepted: a list of \"x\", \"y\", or both"},
    {"fix twice", static_scene, "[\"x\", \"y\"]", "[\"x\", \"x\"]",
     "dam.toml:18:13: support[0].fix: \"x\" is named twice"},
    {"fix nothing", static_scene, "[\"x\", \"y\"]", "[]",
     "dam.toml:18:7: support[0].fix: [] is a list of 0; accepted: a list of \"x\", \"y\", or both (the directions "
     "held)"},
    {"support of both", static_scene, "boundary = \"base\"", "boundary = \"base\"\npoint = [0, 0]",
     "dam.toml:16:1: support[0]: accepted: either `boundary` or `point`, one of them"},
    {"displacement unfixed", static_scene, "fix = [\"x\", \"y\"]", "fix = [\"x\"]\ndisplacement = [0, 1]",
     "dam.toml:19:16: support[0].displacement: prescribes y, which `fix` does not name"},
    {"load of neither", static_scene, "traction = [0.0, 1.0e6]", "",
     "dam.toml:20:1: load[0]: accepted: one of `traction`, `pressure` and `water_level`"},
    {"crack of one point", static_scene, "[material]", "[[crack]]\npath = [[0, 1]]\n[material]",
     "dam.toml:13:8: crack[0].path: has 1 points; accepted: at least 2, from the mouth to the tip"},
    {"crack standing still", static_scene, "[material]", "[[crack]]\npath = [[0, 1], [0, 1]]\n[material]",
     "dam.toml:13:17: crack[0].path[1]: repeats the point before it; accepted: different points"},
    {"tip order low", static_scene, "order = 2", "order = 3\ntip_order = 2",
     "dam.toml:11:13: mesh.tip_order: 2 is below the order 3; accepted: at least mesh.order"},
    {"grade of many", static_scene, "order = 2", "grade = [{ corner = [0, 0], layers = 3 }]",
     "dam.toml:10:1: mesh.grade: is for one polygon; accepted: with cells = \"one\""},
    {"grade ratio", static_scene, "order = 2", "grade = [{ corner = [0, 0], layers = 3, ratio = 1 }]",
     "dam.toml:10:49: mesh.grade[0].ratio: 1 is not accepted; accepted: a number > 0, < 1"},
    {"dual without file", static_scene, "order = 2", "dual = true",
     "dam.toml:10:8: mesh.dual: is for a mesh from a file; accepted: together with mesh.file"},
    {"unknown cells", static_scene, "order = 2", "cells = \"hexagons\"",
     "dam.toml:10:9: mesh.cells: \"hexagons\" is not known; accepted: \"dual\" | \"triangles\" | \"squares\" | "
     "\"one\""},
    {"refine radius", static_scene, "order = 2", "refine = [{ centre = [0, 0], radius = 0, size = 1 }]",
     "dam.toml:10:39: mesh.refine[0].radius: 0 is not accepted; accepted: a number > 0 [m] (radius of the disc)"},
    {"refine key", static_scene, "order = 2", "refine = [{ centre = [0, 0], radius = 1, sise = 1 }]",
     "dam.toml:10:11: mesh.refine[0].size: is missing; accepted: number > 0 [m] (target polygon size inside "
     "it)\ndam.toml:10:42: mesh.refine[0].sise: there is no such key, did you mean `size`?; accepted: centre, radius, "
     "size"},
    {"refine no list", static_scene, "order = 2", "refine = 3",
     "dam.toml:10:10: mesh.refine: 3 is a whole number; accepted: a list of tables mesh.refine = [{ centre = …, radius "
     "= …, size = … }, …] (discs with smaller polygons)"},
};
INSTANTIATE_TEST_SUITE_P(Values, Refusal, testing::ValuesIn(values));

// What tables must satisfy together.
const Spoilt together[] = {
    {"no support", static_scene, "[[support]]\nboundary = \"base\"\nfix = [\"x\", \"y\"]\n", "",
     "dam.toml:2:12: [[support]]: is missing; a static body needs supports against every rigid motion"},
    {"x free", static_scene, "[\"x\", \"y\"]", "[\"y\"]",
     "dam.toml:16:1: [[support]]: the supports leave a translation in x free; accepted: supports against every rigid "
     "motion"},
    {"y free", static_scene, "[\"x\", \"y\"]", "[\"x\"]",
     "dam.toml:16:1: [[support]]: the supports leave a translation in y free; accepted: supports against every rigid "
     "motion"},
    {"one point", static_scene, "boundary = \"base\"", "point = [0, 0]",
     "dam.toml:16:1: [[support]]: the supports leave a rotation free; accepted: supports against every rigid motion"},
    {"unknown boundary", static_scene, "boundary = \"base\"", "boundary = \"bsae\"",
     "dam.toml:17:12: support[0].boundary: there is no boundary \"bsae\", did you mean \"base\"?; accepted: base, "
     "crest, upstream"},
    {"far boundary", static_scene, "boundary = \"crest\"", "boundary = \"left\"",
     "dam.toml:21:12: load[0].boundary: there is no boundary \"left\"; accepted: base, crest, upstream"},
    {"no geometry", static_scene,
     "[geometry]\noutline = [[0, 0], [2, 0], [2, 3], [0, 3]]\nboundaries = { base = [0], crest = [2], upstream = [3] "
     "}\n",
     "", "dam.toml:2:12: [geometry]: is missing; accepted: [geometry] with an outline, mesh.file, or mesh.polygons"},
    {"no mesh", static_scene, "size = 0.5\n", "",
     "dam.toml:8:1: mesh.size: is missing; accepted: a number > 0 [m], the polygons' target size"},
    {"no material", static_scene, "[material]\nyoungs_modulus = 25e9\npoisson_ratio = 0.2\n", "",
     "dam.toml:2:12: [material]: is missing; analysis = \"static\" needs it"},
    {"geometry and polygons", static_scene, "size = 0.5\n",
     "vertices = [[0, 0], [1, 0], [0, 1]]\npolygons = [[0, 1, 2]]\n",
     "dam.toml:8:1: [mesh]: the body is given twice; accepted: one of [geometry], mesh.file and mesh.polygons"},
    {"missing mesh file", mesh_file_scene, "dam.msh", "dma.msh",
     "dam.toml:4:8: mesh.file: there is no file \"dma.msh\" (sought from the scene's folder)"},
    {"empty mesh", mesh_file_scene, "file = \"dam.msh\"\ndual = true", "vertices = []\npolygons = []",
     "dam.toml:5:12: mesh.polygons: is empty: no mesh"},
    {"polygon of 2", mesh_file_scene, "file = \"dam.msh\"\ndual = true",
     "vertices = [[0, 0], [1, 0]]\npolygons = [[0, 1]]",
     "dam.toml:5:13: mesh.polygons[0]: has fewer than 3 vertices; accepted: at least 3, counter-clockwise"},
    {"polygon beyond", mesh_file_scene, "file = \"dam.msh\"\ndual = true",
     "vertices = [[0, 0], [1, 0], [0, 1]]\npolygons = [[0, 1, 3]]",
     "dam.toml:5:13: mesh.polygons[0]: there is no vertex 3; accepted: 0 … 2"},
    {"polygons without vertices", mesh_file_scene, "file = \"dam.msh\"\ndual = true", "polygons = [[0, 1, 3]]",
     "dam.toml:3:1: mesh.vertices: is missing; polygons written out need it"},
    {"gravity without density", static_scene, "[[load]]", "[gravity]\n[[load]]",
     "dam.toml:12:1: material.density: is missing, but [gravity] is present; accepted: a number > 0 [kg/m³]"},
    {"gravity with density 0", static_scene, "[[load]]",
     "[[region]]\noutline = [[0, 0], [1, 0], [0, 1]]\nyoungs_modulus = 1\npoisson_ratio = 0\ndensity = "
     "0\n[gravity]\n[[load]]",
     "dam.toml:12:1: material.density: is missing, but [gravity] is present; accepted: a number > 0 "
     "[kg/m³]\ndam.toml:24:11: region[0].density: is 0, but [gravity] is present; accepted: a number > 0 [kg/m³]"},
    {"modal without density", static_scene, "\"static\"", "\"modal\"",
     "dam.toml:12:1: material.density: is missing, but analysis = \"modal\" has inertia; accepted: a number > 0 "
     "[kg/m³]\ndam.toml:20:1: [[load]]: has no effect in analysis = \"modal\""},
    {"modal table in static", static_scene, "[[load]]", "[modal]\n[[load]]",
     "dam.toml:20:1: [modal]: has no effect in analysis = \"static\""},
    {"modal count 0", static_scene, "[[load]]", "[modal]\ncount = 0\n[[load]]",
     "dam.toml:21:9: modal.count: 0 is not accepted; accepted: a whole number >= 1 (how many, from the lowest)"},
    {"contact without a crack", static_scene, "[[load]]", "[contact]\n[[load]]",
     "dam.toml:20:1: [contact]: has no effect without a crack; accepted: together with [[crack]]"},
    {"water in no crack", static_scene, "[[load]]",
     "[reservoir]\nboundary = \"upstream\"\nlevel = 2\n[crack_water]\n[[load]]",
     "dam.toml:23:1: [crack_water]: has no effect without a crack; accepted: together with [[crack]]"},
    {"water without a reservoir", static_scene, "[[load]]",
     "[[crack]]\npath = [[0, 1], [1, 1]]\n[crack_water]\n[[load]]",
     "dam.toml:22:1: [crack_water]: has no effect without a reservoir; accepted: together with [reservoir], or "
     "crack.pressure instead"},
    {"water and pressure", static_scene, "[[load]]",
     "[[crack]]\npath = [[0, 1], [1, 1]]\npressure = 1\n[reservoir]\nboundary = \"upstream\"\nlevel = "
     "2\n[crack_water]\n"
     "[[load]]",
     "dam.toml:22:12: crack[0].pressure: and [crack_water] both fill this crack; accepted: one of them"},
    {"inner and through", static_scene, "[[load]]",
     "[[crack]]\npath = [[0, 1], [1, 1]]\ninner = true\nthrough = true\n[[load]]",
     "dam.toml:20:1: crack[0]: is `inner` and `through`; accepted: one of them"},
    {"size of a file's mesh", mesh_file_scene, "dual = true", "size = 1",
     "dam.toml:5:1: mesh.size: belongs to a mesh made from [geometry]; this one is given by mesh.file"},
};
INSTANTIATE_TEST_SUITE_P(Together, Refusal, testing::ValuesIn(together));

// Parts that are checked before they are built.
const Spoilt later[] = {
    {"reservoir boundary", dynamic_scene, "boundary = \"upstream\"", "boundary = \"upstraem\"",
     "dam.toml:25:12: reservoir.boundary: there is no boundary \"upstraem\", did you mean \"upstream\"?; accepted: "
     "base, crest, downstream, upstream"},
    {"reservoir without level", dynamic_scene, "level = 96.5\n", "",
     "dam.toml:24:1: reservoir: accepted: `boundary` and `level`, or, with analysis = \"response\", `depth` alone"},
    {"reflection", dynamic_scene, "level = 96.5", "level = 96.5\nreflection_coefficient = 1.5",
     "dam.toml:27:26: reservoir.reflection_coefficient: 1.5 is not accepted; accepted: a number 0 … 1 (of the "
     "bottom; 1: rigid)"},
    {"sound speed", dynamic_scene, "level = 96.5", "level = 96.5\nsound_speed = 0",
     "dam.toml:27:15: reservoir.sound_speed: 0 is not accepted; accepted: a number > 0 [m/s] (in water)"},
    {"reservoir model", dynamic_scene, "westergaard", "westergard",
     "dam.toml:27:9: reservoir.model: \"westergard\" is not known, did you mean \"westergaard\"?; accepted: "
     "\"hydrostatic\" | \"westergaard\" | \"incompressible\" | \"compressible\""},
    {"foundation boundary", dynamic_scene, "[foundation]\nboundary = \"base\"", "[foundation]\nboundary = \"bas\"",
     "dam.toml:30:12: foundation.boundary: there is no boundary \"bas\", did you mean \"base\"?; accepted: base, "
     "crest, downstream, upstream"},
    {"foundation nowhere", dynamic_scene, "[foundation]\nboundary = \"base\"", "[foundation]",
     "dam.toml:29:1: foundation.boundary: is missing; analysis = \"dynamic\" needs it"},
    {"foundation density", dynamic_scene, "density = 0", "density = -1",
     "dam.toml:33:11: foundation.density: -1 is not accepted; accepted: a number >= 0 [kg/m³] (0: massless)"},
    {"contact growth", dynamic_scene, "growth_factor = 2", "growth_factor = 1",
     "dam.toml:38:17: contact.growth_factor: 1 is not accepted; accepted: a number > 1 (of the penalty, until the "
     "penetration is within its tolerance)"},
    {"friction in motion", dynamic_scene, "friction_coefficient = 0.0", "friction_coefficient = 0.6",
     "dam.toml:39:24: contact.friction_coefficient: 0.6 has no effect in analysis = \"dynamic\"; accepted: 0, faces "
     "that "
     "slide freely"},
    {"contact friction", dynamic_scene, "friction_coefficient = 0.0", "friction_coefficient = -0.6",
     "dam.toml:39:24: contact.friction_coefficient: -0.6 is not accepted; accepted: a number >= 0 (Coulomb, with the "
     "memory "
     "of where the faces stuck)"},
    {"contact model", dynamic_scene, "\"exact\"", "\"exat\"",
     "dam.toml:36:9: contact.model: \"exat\" is not known, did you mean \"exact\"?; accepted: \"penalty\" | \"exact\""},
    {"roughness", dynamic_scene, "relative_roughness = 0.25", "relative_roughness = 0.75",
     "dam.toml:43:22: crack_water.relative_roughness: 0.75 is not accepted; accepted: a number > 0, <= 0.5 (k / (2w))"},
    {"toughness", dynamic_scene, "fracture_toughness = 2e6", "fracture_toughness = 0",
     "dam.toml:46:22: propagation.fracture_toughness: 0 is not accepted; accepted: a number > 0 [Pa √m] (K_IC)"},
    {"criterion", dynamic_scene, "max-hoop-stress", "max-energy",
     "dam.toml:47:13: propagation.criterion: \"max-energy\" is not known; accepted: \"max-hoop-stress\""},
    {"record", dynamic_scene, "horizontal = \"koyna-1967/horizontal.csv\"", "horizontal = 3",
     "dam.toml:50:14: ground_motion.horizontal: 3 is a whole number; accepted: a text in quotes (table of time [s] and "
     "acceleration [m/s²], or a PEER .at2 record; relative to the scene)"},
    {"record missing", dynamic_scene, "horizontal = \"koyna-1967/horizontal.csv\"", "",
     "dam.toml:49:1: ground_motion.horizontal: is missing; accepted: path (table of time [s] and acceleration [m/s²], "
     "or a PEER .at2 record; relative to the scene)"},
    {"time step", dynamic_scene, "time_step = 0.01", "time_step = 0",
     "dam.toml:54:13: dynamics.time_step: 0 is not accepted; accepted: a number > 0 [s] (time step)"},
    {"duration", dynamic_scene, "duration = 10", "duration = 0.001",
     "dam.toml:55:12: dynamics.duration: 0.001 is shorter than one time step; accepted: at least time_step"},
    {"integrator", dynamic_scene, "generalised-alpha", "generalized-alpha",
     "dam.toml:56:14: dynamics.integrator: \"generalized-alpha\" is not known, did you mean \"generalised-alpha\"?; "
     "accepted: \"newmark\" | \"hht-alpha\" | \"generalised-alpha\""},
    {"radius missing", dynamic_scene, "spectral_radius = 0.8\n", "",
     "dam.toml:53:1: dynamics.spectral_radius: is missing; the generalised-alpha integrator needs it"},
    {"radius needless", dynamic_scene, "generalised-alpha", "newmark",
     "dam.toml:57:19: dynamics.spectral_radius: the newmark integrator has none"},
    {"damping modes", dynamic_scene, "[1, 3]", "[3, 1]",
     "dam.toml:58:17: dynamics.damping_modes: accepted: modes in ascending order"},
    {"damping modes count", dynamic_scene, "[1, 3]", "[1, 2, 3]",
     "dam.toml:58:17: dynamics.damping_modes: [1, 2, 3] is a list of 3; accepted: a whole number or a list of one or "
     "two >= 1 (counted from 1, ascending; one alone: damping proportional to the stiffness)"},
    {"radius of hht-alpha", dynamic_scene, "generalised-alpha\"\nspectral_radius = 0.8",
     "hht-alpha\"\nspectral_radius = 0.4",
     "dam.toml:57:19: dynamics.spectral_radius: 0.4 is not accepted; accepted: a number 0.5 … 1 with the hht-alpha "
     "integrator"},
    {"too many steps", dynamic_scene, "duration = 10\n", "duration = 1e6\n",
     "dam.toml:55:12: dynamics.duration: 1e+06 is 1e+08 steps; accepted: at most 1e+07 steps of time_step"},
    {"damping ratio", dynamic_scene, "damping_modes = [1, 3]", "damping_ratio = 1",
     "dam.toml:58:17: dynamics.damping_ratio: 1 is not accepted; accepted: a number >= 0, < 1 (Rayleigh damping, "
     "matched at damping_modes)"},
    {"output", dynamic_scene, "fields_every = 10", "fields_every = -1",
     "dam.toml:61:16: output.fields_every: -1 is not accepted; accepted: a whole number >= 0 (steps between field "
     "snapshots; 0: none)"},
    {"dynamics missing", dynamic_scene,
     "[dynamics]\ntime_step = 0.01\nduration = 10\nintegrator = \"generalised-alpha\"\nspectral_radius = "
     "0.8\ndamping_modes = [1, 3]\n",
     "", "dam.toml:2:12: [dynamics]: is missing; analysis = \"dynamic\" needs it"},
    {"line aperture", crack_water_scene, "[0.10, 0.05]", "[0.10, 0.05, 0.02]",
     "dam.toml:7:12: crack_line.aperture: has 3 values; accepted: 2 (at both ends) or 451 (segments + 1)"},
    {"line aperture zero", crack_water_scene, "[0.10, 0.05]", "[0.10, 0]",
     "dam.toml:7:19: crack_line.aperture[1]: 0 is not accepted; accepted: a number > 0 [m] (at both ends, linear "
     "between, or at each of segments + 1 nodes)"},
    {"line segments", crack_water_scene, "segments = 450", "segments = 0",
     "dam.toml:6:12: crack_line.segments: 0 is not accepted; accepted: a whole number >= 1 (line segments of equal "
     "length)"},
    {"line far end", crack_water_scene, "tip = \"closed\"", "tip = \"closed\"\ndownstream_head = 0",
     "dam.toml:4:1: crack_line: accepted: either `downstream_head` or `tip = \"closed\"`, one of them"},
    {"line no end", crack_water_scene, "tip = \"closed\"", "",
     "dam.toml:4:1: crack_line: accepted: either `downstream_head` or `tip = \"closed\"`, one of them"},
    {"line march", crack_water_scene, "duration = 1.0, ", "",
     "dam.toml:11:9: crack_line.march.duration: is missing; accepted: number > 0 [s] (of the history)"},
    {"line march word", crack_water_scene, "\"empty\"", "\"emtpy\"",
     "dam.toml:11:57: crack_line.march.initially: \"emtpy\" is not known, did you mean \"empty\"?; accepted: \"full\" "
     "| \"empty\""},
    {"line without water", crack_water_scene, "[crack_water]\n", "",
     "dam.toml:2:12: [crack_water]: is missing; analysis = \"crack-water\" needs it"},
    {"line with a mesh", crack_water_scene, "[crack_line]", "[mesh]\nsize = 1\n[crack_line]",
     "dam.toml:4:1: [mesh]: has no effect in analysis = \"crack-water\""},
    {"response of nothing", response_scene, "frequencies = [0.5, 0.9]\ntimes = [0.07]\n", "",
     "dam.toml:11:1: response: asks for nothing; accepted: `frequencies`, `times` or both"},
    {"response frequency", response_scene, "[0.5, 0.9]", "[0.5, -0.9]",
     "dam.toml:12:21: response.frequencies[1]: -0.9 is not accepted; accepted: a number >= 0 [rad/s] (samples in "
     "frequency)"},
    {"response without a domain", response_scene,
     "[reservoir]\ndepth = 100\n[foundation]\nyoungs_modulus = 1\npoisson_ratio = 0.25\ndensity = 1\nhalf_width = "
     "1\nshape = \"disc\"\n",
     "", "dam.toml:2:12: analysis: \"response\" needs [reservoir] or [foundation]"},
    {"response with level", response_scene, "depth = 100", "depth = 100\nlevel = 3",
     "dam.toml:3:1: reservoir: accepted: `boundary` and `level`, or, with analysis = \"response\", `depth` alone"},
    {"response strip", response_scene, "half_width = 1\nshape = \"disc\"", "",
     "dam.toml:5:1: foundation.half_width: is missing; analysis = \"response\" needs it"},
    {"reservoir depth in a dam", dynamic_scene, "boundary = \"upstream\"\nlevel = 96.5", "depth = 96.5",
     "dam.toml:24:1: reservoir.boundary: is missing; analysis = \"dynamic\" needs it\ndam.toml:25:1: reservoir.depth: "
     "has no effect in analysis = \"dynamic\""},
};
INSTANTIATE_TEST_SUITE_P(Later, Refusal, testing::ValuesIn(later));

TEST(Refusals, ReportEverythingThatIsWrongInTheOrderOfTheFile) {
  std::string text = changed(static_scene, "size = 0.5", "size = -1");
  text = changed(text, "poisson_ratio = 0.2", "poisson_ratio = 0.7");
  text = changed(text, "fix = ", "fixed = ");
  const std::string said = refusal(text);
  const std::size_t first = said.find("mesh.size"), second = said.find("\ndam.toml:14:17: material.poisson_ratio"),
                    third = said.find("\ndam.toml:16:1: support[0].fix: is missing"),
                    fourth = said.find("\ndam.toml:18:1: support[0].fixed");
  EXPECT_LT(first, second) << said;
  EXPECT_LT(second, third) << said;
  EXPECT_LT(third, fourth) << said;
  EXPECT_NE(fourth, std::string::npos) << said;
}

struct BadOverride {
  Override given;
  const char* message;
};

TEST(Refusals, NameTheOverride) {
  const BadOverride cases[] = {
      {{"mesh.ordr", "3"}, "dam.toml: override mesh.ordr = 3: mesh.ordr: there is no such key, did you mean `order`?"},
      {{"mesh.order", "0"},
       "dam.toml: override mesh.order = 0: mesh.order: 0 is not accepted; accepted: a whole number"},
      {{"mesh.order", "nan"}, "dam.toml: override mesh.order = nan: mesh.order: nan is not a finite number"},
      {{"mesh.order", ""}, "override mesh.order = : the value is not TOML"},
      {{"name", "dam"}, "override name = dam: the value is not TOML (a text needs quotes)"},
      {{"mesh.order", "3\nsize = 1"}, "override mesh.order = 3\nsize = 1: more than one value"},
      {{"mesh..order", "3"}, "override mesh..order = 3: the key is not of the form table.key or list[0].key"},
      {{"", "3"}, "override  = 3: the key is not of the form"},
      {{"[0]", "3"}, "override [0] = 3: the key is not of the form"},
      {{"crack[2].path", "[]"}, "override crack[2].path = []: the list has 0 elements, counted from 0"},
      {{"mesh[0].order", "3"}, "override mesh[0].order = 3: [0] asks for an element of a table"},
      {{"mesh.size.order", "3"}, "override mesh.size.order = 3: `order` asks for a key of a number"},
      {{"support.fix", "[\"x\"]"}, "override support.fix = [\"x\"]: `fix` asks for a key of a list"},
      {{"meshes.order", "3"},
       "dam.toml: override meshes.order = 3: meshes: there is no such table, did you mean `mesh`?"},
  };
  for (const BadOverride& one : cases) {
    const std::string said = refusal(static_scene, {one.given});
    EXPECT_EQ(said.substr(0, std::string(one.message).size()), one.message) << said;
  }
}

}  // namespace
}  // namespace sunder::scene
