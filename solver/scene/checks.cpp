#include "solver/scene/checks.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <set>
#include <system_error>

#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

struct AnalysisNeeds {
  Analysis analysis;
  std::string_view word;
  std::vector<std::string> needed;  ///< tables without which it cannot be
  std::vector<std::string> usable;  ///< further tables that it can use; any other would be silently without effect
};

const std::vector<AnalysisNeeds>& analyses() {
  static const std::vector<AnalysisNeeds> all = {
      {Analysis::static_,
       "static",
       {"material"},
       {"geometry", "mesh", "region", "crack", "fracture", "support", "load", "gravity", "reservoir", "foundation",
        "contact", "crack_water", "propagation", "output"}},
      {Analysis::modal,
       "modal",
       {"material"},
       {"geometry", "mesh", "region", "crack", "support", "modal", "reservoir", "foundation", "output"}},
      {Analysis::dynamic,
       "dynamic",
       {"material", "dynamics"},
       {"geometry", "mesh", "region", "crack", "fracture", "support", "load", "gravity", "reservoir", "foundation",
        "contact", "crack_water", "propagation", "ground_motion", "output"}},
      {Analysis::crack_water, "crack-water", {"crack_line", "crack_water"}, {}},
      {Analysis::response, "response", {"response"}, {"reservoir", "foundation"}},
  };
  return all;
}

const AnalysisNeeds& needs_of(Analysis analysis) {
  return *std::find_if(analyses().begin(), analyses().end(),
                       [analysis](const AnalysisNeeds& needs) { return needs.analysis == analysis; });
}

bool has_body(Analysis analysis) {
  return analysis != Analysis::crack_water && analysis != Analysis::response;
}

/// A table's node; where a list of them, the first.
Origin place(const Node& document, std::string_view table) {
  const Node* node = document.find(table);
  if (node == nullptr) return {};
  return node->kind == Node::Kind::list && !node->list.empty() ? node->list.front().origin : node->origin;
}

const Node& element(const Node& document, std::string_view table, std::size_t i) {
  return document.find(table)->list[i];
}

void check_tables(const Node& document, const Scene& scene, Findings& findings) {
  const AnalysisNeeds& needs = needs_of(scene.analysis);
  const std::string analysis = "analysis = \"" + std::string(needs.word) + "\"";
  for (const std::string& table : needs.needed)
    if (!document.has(table))
      findings.add(document.find("analysis")->origin, "[" + table + "]", "is missing; " + analysis + " needs it");
  for (const Part& part : parts()) {
    const auto in = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), part.name) != names.end();
    };
    if (document.has(part.name) && !in(needs.needed) && !in(needs.usable))
      findings.add(place(document, part.name), part.references.front().heading, "has no effect in " + analysis);
  }
  if (scene.analysis == Analysis::response && !scene.reservoir && !scene.foundation)
    findings.add(document.find("analysis")->origin, "analysis", "\"response\" needs [reservoir] or [foundation]");
}

void check_shape(const Node& document, const Scene& scene, Findings& findings) {
  const int sources = (scene.geometry ? 1 : 0) + (scene.mesh.file ? 1 : 0) + (scene.mesh.list ? 1 : 0);
  if (sources == 0)
    findings.add(document.find("analysis")->origin, "[geometry]",
                 "is missing; accepted: [geometry] with an outline, mesh.file, or mesh.polygons");
  if (sources > 1)
    findings.add(place(document, "mesh"), "[mesh]",
                 std::string("the body is given twice; accepted: one of [geometry], mesh.file and mesh.polygons"));
  if (scene.geometry && !scene.mesh.size && scene.mesh.cells != Cells::one && sources == 1)
    findings.add(place(document, "mesh"), "mesh.size",
                 "is missing; accepted: a number > 0 [m], the polygons' target size");
  if (scene.mesh.file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(*scene.mesh.file, ignored))
      findings.add(document.find("mesh")->find("file")->origin, "mesh.file",
                   "there is no file \"" + scene.mesh.file->string() + "\" (sought from the scene's folder)");
  }
}

/// Names of the boundaries that the scene tells.
std::vector<std::string> boundary_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.geometry)
    for (const auto& [name, edges] : scene.geometry->boundaries) names.push_back(name);
  if (scene.mesh.list)
    for (const auto& [name, edges] : scene.mesh.list->boundaries) names.push_back(name);
  return names;
}

void check_boundaries(const Node& document, const Scene& scene, Findings& findings) {
  if (!scene.geometry && !scene.mesh.list) return;  // a mesh file brings its own names
  const std::vector<std::string> names = boundary_names(scene);
  const auto check = [&](const Node& table, const std::string& path) {
    const Node* given = table.find("boundary");
    if (given == nullptr || std::find(names.begin(), names.end(), given->text) != names.end()) return;
    const std::string suggestion = nearest(given->text, names);
    findings.add(given->origin, path + ".boundary",
                 "there is no boundary " + shown(*given) +
                     (suggestion.empty() ? "" : ", did you mean \"" + suggestion + "\"?") +
                     "; accepted: " + (names.empty() ? "none, geometry.boundaries names no edges" : listed(names)));
  };
  for (std::size_t i = 0; i < scene.supports.size(); ++i)
    check(element(document, "support", i), "support[" + std::to_string(i) + "]");
  for (std::size_t i = 0; i < scene.loads.size(); ++i)
    check(element(document, "load", i), "load[" + std::to_string(i) + "]");
  if (scene.reservoir) check(*document.find("reservoir"), "reservoir");
  if (scene.foundation) check(*document.find("foundation"), "foundation");
}

/// The points that support `support` holds; empty where only the mesh can tell.
std::vector<Point> held_points(const Scene& scene, const Support& support) {
  if (support.point) return {*support.point};
  std::vector<Point> points;
  if (scene.geometry) {
    std::vector<std::array<Point, 2>> edges;
    const auto add_ring = [&edges](const std::vector<Point>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    add_ring(scene.geometry->outline);
    for (const std::vector<Point>& hole : scene.geometry->holes) add_ring(hole);
    for (int edge : scene.geometry->boundaries.at(support.boundary))
      points.insert(points.end(), edges[static_cast<std::size_t>(edge)].begin(),
                    edges[static_cast<std::size_t>(edge)].end());
  } else if (scene.mesh.list) {
    for (const mesh::Edge& edge : scene.mesh.list->boundaries.at(support.boundary))
      for (int vertex : edge) points.push_back(scene.mesh.list->vertices[static_cast<std::size_t>(vertex)]);
  }
  return points;
}

/// A static body must be held against both translations and the rotation: rows (1, 0, -y) and (0, 1, x) of the held
/// directions, about the held points' middle and in units of their spread, must have rank 3.
void check_held(const Node& document, const Scene& scene, Findings& findings) {
  if (scene.foundation) return;
  if (scene.supports.empty())
    return findings.add(document.find("analysis")->origin, "[[support]]",
                        "is missing; a static body needs supports against every rigid motion");
  std::vector<std::pair<Point, const Support*>> held;
  for (const Support& support : scene.supports) {
    const std::vector<Point> points = held_points(scene, support);
    if (points.empty()) return;  // a mesh file: the solver sees its boundaries
    for (const Point& point : points) held.emplace_back(point, &support);
  }
  Point middle = Point::Zero();
  for (const auto& [point, support] : held) middle += point / static_cast<double>(held.size());
  double spread = 0.0;
  for (const auto& [point, support] : held) spread = std::max(spread, (point - middle).norm());
  if (spread == 0.0) spread = 1.0;
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const auto& [point, support] : held) {
    const Point r = (point - middle) / spread;
    const Eigen::Vector3d rows[2] = {{1.0, 0.0, -r.y()}, {0.0, 1.0, r.x()}};
    for (int i = 0; i < 2; ++i)
      if (support->fix[i]) gram += rows[i] * rows[i].transpose();
  }
  // A free motion's eigenvalue is round-off of the largest, about 1e-16 each row; a held one is at least about 1 /
  // rows.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gram);
  constexpr double round_off = 1e-12;
  if (solver.eigenvalues()[0] > round_off * solver.eigenvalues()[2]) return;
  const Eigen::Vector3d free = solver.eigenvectors().col(0);
  std::string motion = "a rotation";
  if (std::abs(free[2]) < 1e-6)
    motion = std::abs(free[0]) > std::abs(free[1]) ? "a translation in x" : "a translation in y";
  if (std::abs(free[2]) < 1e-6 && std::min(std::abs(free[0]), std::abs(free[1])) > 1e-6) motion = "a translation";
  findings.add(place(document, "support"), "[[support]]",
               "the supports leave " + motion + " free; accepted: supports against every rigid motion");
}

/// The dam's base becomes a line inside the body: nothing else can act on it.
void check_founded_boundary(const Node& document, const Scene& scene, Findings& findings) {
  const std::string& base = scene.foundation->boundary;
  const auto refuse = [&](const Node& table, const std::string& path, const std::string& given, const char* what) {
    if (given != base) return;
    findings.add(table.find("boundary")->origin, path + ".boundary",
                 "\"" + base + "\" stands on [foundation], so it cannot also be " + what +
                     "; accepted: another boundary, or no [foundation]");
  };
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Node& table = element(document, "support", i);
    if (table.has("boundary"))
      refuse(table, "support[" + std::to_string(i) + "]", scene.supports[i].boundary, "supported");
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i)
    refuse(element(document, "load", i), "load[" + std::to_string(i) + "]", scene.loads[i].boundary, "loaded");
  if (scene.reservoir && document.find("reservoir")->has("boundary"))
    refuse(*document.find("reservoir"), "reservoir", scene.reservoir->boundary, "a wet face");
}

/// Reservoir and foundation have a boundary of the body, or, alone, a size of their own.
void check_unbounded(const Node& document, const Scene& scene, Findings& findings) {
  const bool alone = scene.analysis == Analysis::response;
  const auto need = [&](const std::string& table, const std::string& wanted, const std::string& unwanted) {
    const Node& node = *document.find(table);
    const std::string analysis = "analysis = \"" + std::string(word_of(scene.analysis)) + "\"";
    if (!node.has(wanted)) findings.add(node.origin, table + "." + wanted, "is missing; " + analysis + " needs it");
    if (const Node* given = node.find(unwanted))
      findings.add(given->key_origin, table + "." + unwanted, "has no effect in " + analysis);
  };
  if (scene.reservoir) alone ? need("reservoir", "depth", "boundary") : need("reservoir", "boundary", "depth");
  if (scene.foundation)
    alone ? need("foundation", "half_width", "boundary") : need("foundation", "boundary", "half_width");
}

void check_density(const Node& document, const Scene& scene, Findings& findings) {
  std::string reason;
  if (scene.gravity) reason = "[gravity] is present";
  if (scene.analysis == Analysis::modal || scene.analysis == Analysis::dynamic)
    reason = "analysis = \"" + std::string(word_of(scene.analysis)) + "\" has inertia";
  if (reason.empty()) return;
  const auto refuse = [&](const Node& table, const std::string& key) {
    const Node* given = table.find("density");
    findings.add(
        given != nullptr ? given->origin : table.origin, key,
        std::string(given != nullptr ? "is 0" : "is missing") + ", but " + reason + "; accepted: a number > 0 [kg/m³]");
  };
  if (scene.material && scene.material->density == 0.0) refuse(*document.find("material"), "material.density");
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    if (scene.regions[i].material.density == 0.0)
      refuse(element(document, "region", i), "region[" + std::to_string(i) + "].density");
}

/// Growth needs a crack, and an increment that fits into the body where the scene tells how large that is.
void check_propagation(const Node& document, const Scene& scene, Findings& findings) {
  if (!scene.propagation) return;
  const Node& node = *document.find("propagation");
  if (scene.cracks.empty())
    findings.add(node.origin, "[propagation]", "has no effect without [[crack]]; a crack must be there to grow");
  const std::vector<Point>* points = nullptr;
  if (scene.geometry) points = &scene.geometry->outline;
  if (scene.mesh.list) points = &scene.mesh.list->vertices;
  if (points == nullptr || points->empty()) return;
  Point low = points->front(), high = low;
  for (const Point& point : *points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).norm();
  if (scene.propagation->increment < size) return;
  const Node* given = node.find("increment");
  findings.add(given != nullptr ? given->origin : node.origin, "propagation.increment",
               shown(scene.propagation->increment) + " m is larger than the body; accepted: a number < " + shown(size) +
                   " [m], the diagonal of the body");
}

void check_checkpoints(const Node& document, const Scene& scene, Findings& findings) {
  if (!scene.output || scene.output->checkpoint_every == 0) return;
  const Origin origin = document.find("output")->find("checkpoint_every")->origin;
  if (scene.analysis != Analysis::dynamic)
    findings.add(origin, "output.checkpoint_every",
                 "has no effect in analysis = \"" + std::string(word_of(scene.analysis)) + "\"; accepted: 0");
  else if (scene.output->fields_every > 0)
    findings.add(origin, "output.checkpoint_every",
                 "fields cannot be taken up again; accepted: 0, or fields_every = 0");
}

/// What a crack that moves cannot have yet is refused, and not left away silently.
void check_moving_faces(const Node& document, const Scene& scene, Findings& findings) {
  if (scene.analysis != Analysis::dynamic) return;
  if (scene.contact && scene.contact->friction_coefficient > 0.0)
    findings.add(document.find("contact")->find("friction_coefficient")->origin, "contact.friction_coefficient",
                 shown(scene.contact->friction_coefficient) +
                     " has no effect in analysis = \"dynamic\"; accepted: 0, faces that slide freely");
  for (std::size_t i = 0; i < scene.cracks.size(); ++i)
    if (scene.cracks[i].inner && (scene.contact || scene.propagation))
      findings.add(
          element(document, "crack", i).find("inner")->origin, "crack[" + std::to_string(i) + "].inner",
          "with [contact] or [propagation] is not accepted in analysis = \"dynamic\"; accepted: a crack with a "
          "mouth, or analysis = \"static\"");
}

/// What acts on crack faces needs a crack; resting water in it comes from a reservoir.
void check_crack_faces(const Node& document, const Scene& scene, Findings& findings) {
  for (const char* table : {"contact", "crack_water"})
    if (document.has(table) && scene.cracks.empty())
      findings.add(place(document, table), "[" + std::string(table) + "]",
                   "has no effect without a crack; accepted: together with [[crack]]");
  if (scene.analysis != Analysis::static_ || !scene.crack_water) return;
  if (!scene.reservoir)
    findings.add(place(document, "crack_water"), "[crack_water]",
                 "has no effect without a reservoir; accepted: together with [reservoir], or crack.pressure instead");
  for (std::size_t i = 0; i < scene.cracks.size(); ++i)
    if (!scene.cracks[i].inner && !scene.cracks[i].pressure.empty())
      findings.add(element(document, "crack", i).find("pressure")->origin, "crack[" + std::to_string(i) + "].pressure",
                   "and [crack_water] both fill this crack; accepted: one of them");
}

}  // namespace

std::string_view word_of(Analysis analysis) {
  return needs_of(analysis).word;
}

void check_together(const Node& document, const Scene& scene, Findings& findings) {
  check_tables(document, scene, findings);
  check_unbounded(document, scene, findings);
  if (!has_body(scene.analysis)) return;
  const std::size_t before = findings.count();
  check_shape(document, scene, findings);
  check_boundaries(document, scene, findings);
  check_density(document, scene, findings);
  check_propagation(document, scene, findings);
  if (scene.foundation) check_founded_boundary(document, scene, findings);
  check_crack_faces(document, scene, findings);
  check_moving_faces(document, scene, findings);
  check_checkpoints(document, scene, findings);
  if (scene.analysis == Analysis::static_ && findings.count() == before) check_held(document, scene, findings);
}

}  // namespace sunder::scene
