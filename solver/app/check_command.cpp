#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "solver/app/commands.hpp"
#include "solver/app/memory_estimate.hpp"
#include "solver/app/scene_place.hpp"
#include "solver/mesh/picture.hpp"
#include "solver/results/atomic_file.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/shaking.hpp"

namespace sunder::app {
namespace {

/// The tables of the scene, with their number where there may be several.
std::string parts_of(const scene::Scene& scene) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  const auto count = [&add](std::size_t number, const std::string& part) {
    if (number > 0) add(std::to_string(number) + " " + part + (number > 1 ? "s" : ""));
  };
  if (scene.mesh.file) add("mesh from " + scene.mesh.file->filename().string());
  if (scene.mesh.list) add("polygons written out");
  if (scene.geometry) add("mesh of an outline with " + std::to_string(scene.geometry->outline.size()) + " vertices");
  count(scene.regions.size(), "region");
  count(scene.cracks.size(), "crack");
  count(scene.supports.size(), "support");
  count(scene.loads.size(), "load");
  if (scene.gravity) add("gravity");
  if (scene.reservoir) add("reservoir");
  if (scene.foundation) add("foundation");
  if (scene.contact) add("contact");
  if (scene.crack_water) add("crack water");
  if (scene.propagation) add("growth");
  if (scene.ground_motion) add("ground motion");
  if (scene.modal) add(std::to_string(scene.modal->count) + " natural frequencies");
  if (scene.output && scene.output->fields_every > 0) add("fields");
  return text;
}

/// One line a component; throws scene::SceneError where a record cannot be used.
std::string records_of(const scene::Scene& scene) {
  const simulation::Shaking shaking = simulation::shaking_of(scene);
  std::string text;
  const auto add = [&text](const char* component, const std::optional<dynamics::GroundMotion>& motion, double scale) {
    if (!motion) return;
    double peak = 0.0;
    for (const double value : motion->acceleration) peak = std::max(peak, std::abs(scale * value));
    char line[128];
    std::snprintf(line, sizeof line, "  %-11s %zu samples, %g ... %g s, peak %.4g m/s2\n", component,
                  motion->acceleration.size(), motion->start, motion->end(), peak);
    text += line;
  };
  add("horizontal", shaking.horizontal, shaking.horizontal_scale);
  add("vertical", shaking.vertical, shaking.vertical_scale);
  return text;
}

std::string megabytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 1e7 ? "%.1f MB" : "%.0f MB", bytes / 1e6);
  return text;
}

}  // namespace

int check_command(const Arguments& arguments, const Console& console, const Solver& solver) {
  const scene::Scene scene = scene::read_scene(arguments.scene, arguments.overrides);
  simulation::refuse_absent_parts(scene);
  if (scene.analysis == scene::Analysis::crack_water) {
    simulation::check_crack_water(scene);
    if (arguments.picture) throw scene::SceneError(scene.file.string() + ": a crack alone has no mesh to draw");
    console.out << scene.name << "\n  parts       crack of " << scene.crack_line->segments
                << " segments, no mesh\nusable; nothing was run" << std::endl;
    return completed;
  }
  const std::string records = records_of(scene);
  Plan plan;
  at_its_place(scene, [&] { plan = solver.plan(scene); });
  if (arguments.picture) {
    mesh::PictureOptions options{.title = scene.name, .materials = {"material"}, .nodes = &plan.nodes};
    for (std::size_t i = 0; i < scene.regions.size(); ++i) options.materials.push_back("region " + std::to_string(i));
    results::write_atomically(*arguments.picture, mesh::picture(plan.polygons, options));
  }

  console.out << scene.name << "\n  parts       " << parts_of(scene) << "\n  mesh        " << plan.nodes.polygon_count()
              << " polygons, " << plan.nodes.node_count() << " nodes, " << 2 * plan.nodes.node_count()
              << " unknowns\n  stiffness   " << stiffness_entries(plan.nodes)
              << " entries in the lower triangle\n  memory      about " << megabytes(memory_estimate(plan.nodes))
              << '\n';
  for (const auto& [name, edges] : plan.polygons.boundaries)
    console.out << "  boundary    " << name << ": " << edges.size() << " edges\n";
  console.out << records;
  if (arguments.picture) console.out << "  picture     " << arguments.picture->string() << '\n';
  console.out << "usable; nothing was run" << std::endl;
  return completed;
}

}  // namespace sunder::app
