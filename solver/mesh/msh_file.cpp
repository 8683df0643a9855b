#include "solver/mesh/msh_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <unordered_map>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/dual.hpp"
#include "solver/mesh/edge_table.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/msh_content.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

std::string file_text(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw MeshError(file.string() + ": there is no such file");
  if (!std::filesystem::is_regular_file(file, error)) throw MeshError(file.string() + ": not a file");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw MeshError(file.string() + ": cannot be read");
  return text.str();
}

std::string where(const std::string& name, long line) {
  return line > 0 ? name + ":" + std::to_string(line) : name;
}

/// Index of each node tag among the nodes of the file.
std::unordered_map<long, int> node_indices(const MshContent& content, const std::string& name) {
  std::unordered_map<long, int> index;
  index.reserve(content.nodes.size());
  for (std::size_t i = 0; i < content.nodes.size(); ++i) {
    if (!index.emplace(content.nodes[i].tag, static_cast<int>(i)).second) {
      throw MeshError(name + ": node " + std::to_string(content.nodes[i].tag) + " stands twice in $Nodes");
    }
  }
  return index;
}

/// Vertices that cells use, in the order of the file, and the cells on them.
PolygonMesh cells_of(const MshContent& content, const std::unordered_map<long, int>& index, const std::string& name,
                     std::vector<int>& vertex) {
  PolygonMesh mesh;
  vertex.assign(content.nodes.size(), -1);
  for (const MshContent::Cell& cell : content.cells) {
    Polygon polygon;
    for (int k = 0; k < cell.count; ++k) {
      const auto at = index.find(cell.nodes[k]);
      if (at == index.end()) {
        throw MeshError(where(name, cell.line) + ": node " + std::to_string(cell.nodes[k]) + " is not in $Nodes");
      }
      polygon.vertices.push_back(at->second);
      vertex[at->second] = 0;
    }
    mesh.polygons.push_back(std::move(polygon));
  }
  const MshContent::Node* plane = nullptr;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    if (vertex[i] < 0) continue;
    const MshContent::Node& node = content.nodes[i];
    vertex[i] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(node.x, node.y);
    if (plane == nullptr) plane = &node;
    if (std::abs(node.z - plane->z) > 1e-9 * (std::abs(node.x - plane->x) + std::abs(node.y - plane->y))) {
      throw MeshError(name + ": nodes " + std::to_string(plane->tag) + " and " + std::to_string(node.tag) +
                      " lie at z = " + number(plane->z) + " and " + number(node.z) +
                      "; the mesh must lie in a plane z = constant");
    }
  }
  for (Polygon& polygon : mesh.polygons) {
    for (int& v : polygon.vertices) v = vertex[v];
  }
  return mesh;
}

/// Named edges: the lines of physical curves that lie on the outer boundary.
void name_boundaries(PolygonMesh& mesh, const MshContent& content, const std::unordered_map<long, int>& index,
                     const std::vector<int>& vertex, const std::string& name) {
  const EdgeTable table = edge_table(mesh);
  std::vector<std::pair<Edge, int>> uses;  // by lower and upper vertex
  for (int e = 0; e < table.count(); ++e) {
    const auto [a, b] = table.ends[e];
    uses.push_back({{std::min(a, b), std::max(a, b)}, table.uses[e]});
  }
  std::sort(uses.begin(), uses.end());
  for (const MshContent::Line& line : content.lines) {
    Edge edge{};
    for (int k = 0; k < 2; ++k) {
      const auto at = index.find(line.nodes[k]);
      if (at == index.end()) {
        throw MeshError(where(name, line.line) + ": node " + std::to_string(line.nodes[k]) + " is not in $Nodes");
      }
      edge[k] = vertex[at->second];
    }
    const Edge key{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
    const auto at = std::lower_bound(uses.begin(), uses.end(), std::pair{key, 0});
    if (at == uses.end() || at->first != key) {
      throw MeshError(where(name, line.line) + ": the line from node " + std::to_string(line.nodes[0]) + " to " +
                      std::to_string(line.nodes[1]) + " of the physical curve \"" + line.name +
                      "\" is no edge of a cell");
    }
    std::vector<Edge>& edges = mesh.boundaries[line.name];
    if (at->second == 1) edges.push_back(edge);
  }
  orient_boundaries(mesh);
}

}  // namespace

PolygonMesh read_msh(const std::filesystem::path& file, const MshOptions& options) {
  const std::string name = file.string(), text = file_text(file);
  const MshContent content = binary_msh(text) ? read_binary_msh(file) : parse_msh(text, name);
  const std::size_t count = options.dual ? content.nodes.size() : content.cells.size();
  if (count > static_cast<std::size_t>(std::max(0L, options.max_polygons))) {
    throw MeshError(name + ": " + std::to_string(count) +
                    " polygons exceed max_polygons = " + std::to_string(options.max_polygons));
  }
  const std::unordered_map<long, int> index = node_indices(content, name);
  std::vector<int> vertex;
  PolygonMesh mesh = cells_of(content, index, name, vertex);
  try {
    for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
      std::vector<int>& v = mesh.polygons[i].vertices;
      if (moments(closed_line(mesh, i)).area < 0.0) std::reverse(v.begin() + 1, v.end());
      mesh.polygons[i].scaling_centre = chosen_centre(mesh, i);
    }
    check_topology(mesh);
    name_boundaries(mesh, content, index, vertex, name);
    if (options.dual) {
      check_mesh(mesh);  // a fault of the file should be named in its own cells, not in their dual
      mesh = dual(mesh);
    }
    check_mesh(mesh);
  } catch (const MeshError& error) {
    const std::string words = error.what();
    throw MeshError(words.compare(0, name.size(), name) == 0 ? words : name + ": " + words);
  }
  return mesh;
}

}  // namespace sunder::mesh
