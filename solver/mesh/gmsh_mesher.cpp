#include "solver/mesh/gmsh_mesher.hpp"

#include <gmsh.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <mutex>
#include <string>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/msh_content.hpp"
#include "solver/numerics/untrapped_floats.hpp"

namespace sunder::mesh {
namespace {

/// gmsh from its start to its end, whatever happens between.
class Session {
 public:
  Session() : lock_(mutex()) {
    struct sigaction interrupt {};
    sigaction(SIGINT, nullptr, &interrupt);
    gmsh::initialize(0, nullptr, false);  // false: no configuration file of the user may change a mesh
    sigaction(SIGINT, &interrupt, nullptr);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::model::add("sunder");
  }
  ~Session() {
    try {
      gmsh::finalize();
    } catch (...) {  // nothing is left to end
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  std::lock_guard<std::mutex> lock_;
  numerics::UntrappedFloats untrapped_;
};

/// Runs the action in a session; anything gmsh throws comes out as MeshError "<what>: <gmsh's words>".
template <class Action>
void guarded(const std::string& what, const Action& action) {
  try {
    const Session session;
    action();
  } catch (const MeshError&) {
    throw;
  } catch (const std::exception& error) {
    throw MeshError(what + ": " + error.what());
  } catch (const std::string& words) {  // gmsh 4.8 throws bare strings
    throw MeshError(what + ": " + words);
  } catch (...) {
    throw MeshError(what + ": gmsh stopped without a word");
  }
}

/// Points and curves get the tags index + 1, the surface tag 1.
void build(const PlaneModel& model) {
  namespace geo = gmsh::model::geo;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    geo::addPoint(model.points[i].x(), model.points[i].y(), 0.0, 0.0, static_cast<int>(i) + 1);
  }
  std::vector<int> embedded_curves, embedded_points;
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    geo::addLine(model.curves[c].from + 1, model.curves[c].to + 1, static_cast<int>(c) + 1);
    if (model.curves[c].embedded) embedded_curves.push_back(static_cast<int>(c) + 1);
  }
  std::vector<int> loops;
  for (const auto& loop : model.loops) {
    std::vector<int> tags;
    for (const int c : loop) tags.push_back(c + 1);
    loops.push_back(geo::addCurveLoop(tags));
  }
  geo::addPlaneSurface(loops, 1);
  geo::synchronize();
  for (const int p : model.inner_points) embedded_points.push_back(p + 1);
  if (!embedded_curves.empty()) gmsh::model::mesh::embed(1, embedded_curves, 2, 1);
  if (!embedded_points.empty()) gmsh::model::mesh::embed(0, embedded_points, 2, 1);
}

void generate(const std::function<double(const Point&)>& size) {
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MaxNumThreads2D", 1);
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) { return size({x, y}); });
  gmsh::model::mesh::generate(2);
  gmsh::model::mesh::removeSizeCallback();
}

/// Node tags of all elements of one type on one entity (-1: all), one element after another.
std::vector<std::size_t> element_nodes(int type, int entity = -1) {
  std::vector<std::size_t> elements, nodes;  // gmsh takes vectors that are not empty for storage of the right size
  gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
  return nodes;
}

/// Node tags inside one entity.
std::vector<std::size_t> inner_nodes(int dimension, int entity) {
  std::vector<std::size_t> tags;
  std::vector<double> xyz, parameters;
  gmsh::model::mesh::getNodes(tags, xyz, parameters, dimension, entity, false, false);
  return tags;
}

PlaneTriangles read(const PlaneModel& model) {
  PlaneTriangles mesh;
  std::vector<std::size_t> tags;
  std::vector<double> xyz, parameters;
  gmsh::model::mesh::getNodes(tags, xyz, parameters, -1, -1, false, false);
  std::vector<std::size_t> order(tags.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
  std::vector<int> node(tags.empty() ? 0 : tags[order.back()] + 1, -1);  // by tag
  for (const std::size_t i : order) {
    node[tags[i]] = static_cast<int>(mesh.places.size());
    mesh.places.emplace_back(xyz[3 * i], xyz[3 * i + 1]);
  }
  const auto nodes_of = [&](const std::vector<std::size_t>& some) {
    std::vector<int> nodes;
    for (const std::size_t tag : some) nodes.push_back(node[tag]);
    return nodes;
  };
  const std::vector<std::size_t> corners = element_nodes(2, 1);
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
    mesh.triangles.push_back({node[corners[k]], node[corners[k + 1]], node[corners[k + 2]]});
  }
  for (int c = 1; c <= static_cast<int>(model.curves.size()); ++c) {
    const std::vector<std::size_t> ends = element_nodes(1, c);
    mesh.curve_edges.emplace_back();
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
      mesh.curve_edges.back().push_back({node[ends[k]], node[ends[k + 1]]});
    mesh.curve_nodes.push_back(nodes_of(inner_nodes(1, c)));
  }
  for (int p = 1; p <= static_cast<int>(model.points.size()); ++p)
    mesh.point_nodes.push_back(nodes_of(inner_nodes(0, p)));
  return mesh;
}

}  // namespace

PlaneTriangles triangulate_plane(const PlaneModel& model, const std::function<double(const Point&)>& size) {
  PlaneTriangles mesh;
  guarded("meshing the outline", [&] {
    build(model);
    generate(size);
    mesh = read(model);
  });
  return mesh;
}

MshContent read_binary_msh(const std::filesystem::path& file) {
  MshContent content;
  guarded(file.string(), [&] {
    gmsh::merge(file.string());
    std::vector<std::size_t> tags;
    std::vector<double> xyz, parameters;
    gmsh::model::mesh::getNodes(tags, xyz, parameters);
    for (std::size_t i = 0; i < tags.size(); ++i) {
      content.nodes.push_back({static_cast<long>(tags[i]), xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
    }
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types);
    for (const int type : types) {
      if (type != 1 && type != 2 && type != 3 && type != 15) {
        throw MeshError(file.string() + ": element type " + std::to_string(type) +
                        "; lines (1), triangles (2), quadrilaterals (3) of first order and points (15) are accepted");
      }
      if (type != 2 && type != 3) continue;
      const std::vector<std::size_t> nodes = element_nodes(type);
      for (std::size_t k = 0; k < nodes.size(); k += type + 1) {
        MshContent::Cell cell{{}, type + 1, 0};
        for (int j = 0; j <= type; ++j) cell.nodes[j] = static_cast<long>(nodes[k + j]);
        content.cells.push_back(cell);
      }
    }
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, 1);
    for (const auto& [dimension, group] : groups) {
      std::string name;
      gmsh::model::getPhysicalName(dimension, group, name);
      if (name.empty()) name = std::to_string(group);
      std::vector<int> curves;
      gmsh::model::getEntitiesForPhysicalGroup(dimension, group, curves);
      for (const int curve : curves) {
        const std::vector<std::size_t> nodes = element_nodes(1, curve);
        for (std::size_t k = 0; k + 1 < nodes.size(); k += 2) {
          content.lines.push_back({{static_cast<long>(nodes[k]), static_cast<long>(nodes[k + 1])}, name, 0});
        }
      }
    }
  });
  if (content.cells.empty()) throw MeshError(file.string() + ": the file has no triangles or quadrilaterals");
  return content;
}

}  // namespace sunder::mesh
