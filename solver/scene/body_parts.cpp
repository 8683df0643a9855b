// The tables of the body itself: shape, mesh, material, cracks, supports and loads.
#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

constexpr int highest_order = 64;

void check_ring(const Node& node, const std::vector<Point>& ring, const std::string& path, Findings& findings) {
  if (ring.size() < 3)
    return findings.add(node.origin, path, "has " + std::to_string(ring.size()) + " points; accepted: at least 3");
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ring[(i + 1) % ring.size()])
      findings.add(node.origin, path,
                   "points " + std::to_string(i) + " and " + std::to_string((i + 1) % ring.size()) +
                       " are the same; accepted: each point once (the last side closes by itself)");
}

double signed_area(const std::vector<Point>& ring) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

void check_outline(const Node& node, const std::vector<Point>& outline, const std::string& path, Findings& findings) {
  const std::size_t before = findings.count();
  check_ring(node, outline, path, findings);
  // An outline that crosses itself may have either sign: the mesh finds the crossing, with its coordinates.
  if (findings.count() == before && signed_area(outline) < 0.0)
    findings.add(node.origin, path, "runs clockwise; accepted: counter-clockwise");
}

void check_geometry(const Node& node, Geometry& geometry, const std::string& path, Findings& findings) {
  const std::size_t before = findings.count();
  check_outline(*node.find("outline"), geometry.outline, path + ".outline", findings);
  for (std::size_t i = 0; i < geometry.holes.size(); ++i)
    check_ring(node.find("holes")->list[i], geometry.holes[i], path + ".holes[" + std::to_string(i) + "]", findings);
  if (findings.count() > before) return;  // the edges are not known
  std::size_t edges = geometry.outline.size();
  for (const std::vector<Point>& hole : geometry.holes) edges += hole.size();
  for (const auto& [name, indices] : geometry.boundaries) {
    const Node& list = *node.find("boundaries")->find(name);
    const std::string key = path + ".boundaries." + name;
    if (indices.empty()) findings.add(list.origin, key, "has no edges; accepted: a list of edges");
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < 0 || static_cast<std::size_t>(indices[i]) >= edges)
        findings.add(list.list[i].origin, key,
                     "there is no edge " + std::to_string(indices[i]) + "; accepted: 0 … " + std::to_string(edges - 1) +
                         " (edge i runs from vertex i to i + 1, holes count on)");
      for (std::size_t k = 0; k < i; ++k)
        if (indices[k] == indices[i])
          findings.add(list.list[i].origin, key, "edge " + std::to_string(indices[i]) + " is named twice");
    }
  }
}

Table<Geometry> geometry_table() {
  return {"geometry",
          "[geometry]",
          "the body's outline, from which the mesh is made",
          {key(&Geometry::outline, {.name = "outline",
                                    .unit = "m",
                                    .required = true,
                                    .meaning = "straight-edged, counter-clockwise, each vertex once"}),
           key(&Geometry::holes, {.name = "holes", .unit = "m", .meaning = "outlines of holes, either sense"}),
           key(&Geometry::boundaries,
               {.name = "boundaries",
                .range = at_least(0),
                .meaning = "names for edges; edge i runs from vertex i to i + 1, the holes' edges count on"})},
          check_geometry};
}

std::shared_ptr<const Table<Refinement>> refinement_table() {
  return std::make_shared<const Table<Refinement>>(Table<Refinement>{
      "mesh.refine",
      "mesh.refine = [{ centre = …, radius = …, size = … }, …]",
      "discs in which the polygons are smaller",
      {key(&Refinement::centre, {.name = "centre", .unit = "m", .required = true, .meaning = "centre of the disc"}),
       key(&Refinement::radius,
           {.name = "radius", .unit = "m", .range = positive(), .required = true, .meaning = "radius of the disc"}),
       key(&Refinement::size, {.name = "size",
                               .unit = "m",
                               .range = positive(),
                               .required = true,
                               .meaning = "target polygon size inside it"})}});
}

std::shared_ptr<const Table<Grading>> grading_table() {
  return std::make_shared<const Table<Grading>>(Table<Grading>{
      "mesh.grade",
      "mesh.grade = [{ corner = …, layers = …, ratio = … }, …]",
      "ever shorter edges towards a corner of a body that is one polygon",
      {key(&Grading::corner, {.name = "corner", .unit = "m", .required = true, .meaning = "a vertex of the outline"}),
       key(&Grading::layers,
           {.name = "layers", .range = between(1, 40), .required = true, .meaning = "how many edges"}),
       key(&Grading::ratio, {.name = "ratio",
                             .range = {.low = 0.0, .high = 1.0, .low_open = true, .high_open = true},
                             .meaning = "of each distance to the one before"})}});
}

/// Polygons written out: the keys `vertices`, `polygons` and `boundaries` of [mesh].
PolygonList& list_of(Mesh& mesh) {
  return mesh.list ? *mesh.list : mesh.list.emplace();
}

void check_polygon_list(const Node& node, const PolygonList& list, const std::string& path, Findings& findings) {
  const int count = static_cast<int>(list.vertices.size());
  const auto refuse = [&](const Node& at, const std::string& key, int vertex) {
    findings.add(at.origin, key,
                 "there is no vertex " + std::to_string(vertex) + "; accepted: 0 … " + std::to_string(count - 1));
  };
  for (const char* name : {"vertices", "polygons"})
    if (!node.has(name)) findings.add(node.origin, path + "." + name, "is missing; polygons written out need it");
  if (!node.has("vertices") || !node.has("polygons")) return;
  if (list.polygons.empty()) findings.add(node.find("polygons")->origin, path + ".polygons", "is empty: no mesh");
  for (std::size_t i = 0; i < list.polygons.size(); ++i) {
    const Node& at = node.find("polygons")->list[i];
    const std::string key = path + ".polygons[" + std::to_string(i) + "]";
    if (list.polygons[i].size() < 3)
      findings.add(at.origin, key, "has fewer than 3 vertices; accepted: at least 3, counter-clockwise");
    for (int vertex : list.polygons[i])
      if (vertex < 0 || vertex >= count) refuse(at, key, vertex);
  }
  for (const auto& [name, edges] : list.boundaries)
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (int vertex : edges[i])
        if (vertex < 0 || vertex >= count)
          refuse(node.find("boundaries")->find(name)->list[i], path + ".boundaries." + name, vertex);
}

void check_mesh(const Node& node, Mesh& mesh, const std::string& path, Findings& findings) {
  if (mesh.tip_order && *mesh.tip_order < mesh.order)
    findings.add(node.find("tip_order")->origin, path + ".tip_order",
                 std::to_string(*mesh.tip_order) + " is below the order " + std::to_string(mesh.order) +
                     "; accepted: at least mesh.order");
  if (mesh.dual && !mesh.file)
    findings.add(node.find("dual")->origin, path + ".dual",
                 "is for a mesh from a file; accepted: together with mesh.file");
  if (mesh.list) check_polygon_list(node, *mesh.list, path, findings);
  if (!mesh.grade.empty() && mesh.cells != Cells::one)
    findings.add(node.find("grade")->key_origin, path + ".grade", "is for one polygon; accepted: with cells = \"one\"");
  for (const char* name : {"cells", "size", "refine"})
    if (node.has(name) && (mesh.file || mesh.list))
      findings.add(node.find(name)->key_origin, path + "." + name,
                   "belongs to a mesh made from [geometry]; this one is given by " +
                       std::string(mesh.file ? "mesh.file" : "mesh.polygons"));
}

std::vector<Key<Mesh>> polygon_list_keys() {
  return {
      key_at<Mesh>([](Mesh & mesh) -> auto& { return list_of(mesh).vertices; },
                   {.name = "vertices", .unit = "m", .meaning = "polygons written out, instead of [geometry]"}),
      key_at<Mesh>([](Mesh & mesh) -> auto& { return list_of(mesh).polygons; },
                   {.name = "polygons", .range = at_least(0), .meaning = "vertex indices, counter-clockwise"}),
      key_at<Mesh>([](Mesh & mesh) -> auto& { return list_of(mesh).boundaries; },
                   {.name = "boundaries", .range = at_least(0), .meaning = "names for edges, by their two vertices"})};
}

Table<Mesh> mesh_table(const std::shared_ptr<const Table<Refinement>>& refinement,
                       const std::shared_ptr<const Table<Grading>>& grading) {
  const auto order = between(1, highest_order);
  Table<Mesh> table{
      "mesh",
      "[mesh]",
      "how the body is divided into polygons",
      {choice(&Mesh::cells,
              std::vector<std::pair<std::string, Cells>>{{"dual", Cells::dual},
                                                         {"triangles", Cells::triangles},
                                                         {"squares", Cells::squares},
                                                         {"one", Cells::one}},
              {.name = "cells",
               .meaning = "polygons around the vertices of gmsh's triangles, the triangles, a grid, or one polygon"}),
       key(&Mesh::size, {.name = "size",
                         .unit = "m",
                         .range = positive(),
                         .meaning = "target polygon size; needed with [geometry] unless cells = \"one\""}),
       key(&Mesh::order,
           {.name = "order", .range = order, .meaning = "polynomial order of the elements on polygon edges"}),
       key(&Mesh::tip_order, {.name = "tip_order", .range = order, .meaning = "order on a crack polygon's edges"}),
       key(&Mesh::tip_edges,
           {.name = "tip_edges", .range = at_least(3), .meaning = "least number of edges of a crack polygon"}),
       key(&Mesh::edge_size,
           {.name = "edge_size", .unit = "m", .range = positive(), .meaning = "longer polygon edges are divided"}),
       tables_key(&Mesh::refine, refinement, {.name = "refine", .meaning = "discs with smaller polygons"}),
       tables_key(&Mesh::grade, grading, {.name = "grade", .meaning = "graded edges; only with cells = \"one\""}),
       key(&Mesh::max_polygons,
           {.name = "max_polygons", .range = at_least(1), .meaning = "a mesh estimated to exceed it is refused"}),
       key(&Mesh::file,
           {.name = "file",
            .meaning = "gmsh mesh (.msh 2.2 or 4.1) instead of [geometry], relative to the scene's folder; "
                       "its physical curves name the boundaries"}),
       key(&Mesh::dual, {.name = "dual", .meaning = "with `file`: form the dual polygons"})},
      check_mesh};
  for (Key<Mesh>& extra : polygon_list_keys()) table.keys.push_back(std::move(extra));
  return table;
}

/// Elastic constants, the same for [material] and [[region]]; `of` leads to the material inside an owner.
template <class Owner, class Of>
std::vector<Key<Owner>> elastic_keys(Of of) {
  using material::Isotropic;
  return {key_at<Owner>([of](Owner& owner) -> double& { return of(owner).youngs_modulus; },
                        {.name = "youngs_modulus",
                         .unit = "Pa",
                         .range = positive(),
                         .required = true,
                         .meaning = "Young's modulus E"}),
          key_at<Owner>([of](Owner& owner) -> double& { return of(owner).poisson_ratio; },
                        {.name = "poisson_ratio",
                         .range = {.low = 0.0, .high = 0.5, .high_open = true},
                         .required = true,
                         .meaning = "Poisson's ratio ν; 0.5, incompressible, has no finite stiffness"}),
          key_at<Owner>([of](Owner& owner) -> double& { return of(owner).density; },
                        {.name = "density",
                         .unit = "kg/m³",
                         .range = at_least(0.0),
                         .meaning = "needed only where inertia or gravity is present"})};
}

Table<material::Isotropic> material_table() {
  using material::Isotropic;
  using material::Plane;
  Table<Isotropic> table{"material", "[material]", "the solid, isotropic and linear elastic",
                         elastic_keys<Isotropic>([](Isotropic& own) -> Isotropic& { return own; })};
  table.keys.push_back(
      choice(&Isotropic::plane,
             std::vector<std::pair<std::string, Plane>>{{"strain", Plane::strain}, {"stress", Plane::stress}},
             {.name = "plane", .meaning = "plane strain, or plane stress of unit thickness; regions share it"}));
  return table;
}

Table<Region> region_table() {
  Table<Region> table{"region", "[[region]]", "another material: polygons whose scaling centre lies inside `outline`",
                      elastic_keys<Region>([](Region& region) -> material::Isotropic& { return region.material; }),
                      [](const Node& node, Region& region, const std::string& path, Findings& findings) {
                        check_outline(*node.find("outline"), region.outline, path + ".outline", findings);
                      }};
  table.keys.insert(
      table.keys.begin(),
      key(&Region::outline,
          {.name = "outline", .unit = "m", .required = true, .meaning = "counter-clockwise, each vertex once"}));
  return table;
}

Table<Crack> crack_table() {
  return {
      "crack",
      "[[crack]]",
      "a crack, from its mouth on a boundary to its tip",
      {key(&Crack::path, {.name = "path",
                          .unit = "m",
                          .required = true,
                          .meaning = "from the mouth to the tip, at least two points"}),
       key(&Crack::inner, {.name = "inner", .meaning = "both ends are tips inside the body"}),
       key(&Crack::through, {.name = "through", .meaning = "the path ends on another face: no tip, two bodies"}),
       key(&Crack::pressure, {.name = "pressure",
                              .unit = "Pa",
                              .meaning = "on both faces; a list p_0, p_1, … is Σ p_k s^k over the distance from the "
                                         "tip as a fraction s of the length"})},
      [](const Node& node, Crack& crack, const std::string& path, Findings& findings) {
        const Node& points = *node.find("path");
        if (crack.path.size() < 2)
          findings.add(
              points.origin, path + ".path",
              "has " + std::to_string(crack.path.size()) + " points; accepted: at least 2, from the mouth to the tip");
        if (crack.inner && crack.through)
          findings.add(node.origin, path, "is `inner` and `through`; accepted: one of them");
        for (std::size_t i = 1; i < crack.path.size(); ++i)
          if (crack.path[i] == crack.path[i - 1])
            findings.add(points.list[i].origin, path + ".path[" + std::to_string(i) + "]",
                         "repeats the point before it; accepted: different points");
      }};
}

void read_fix(const Node& node, Support& support, const Reading& reading) {
  const std::string accepted = R"(a list of "x", "y", or both)";
  if (node.kind != Node::Kind::list || node.list.empty()) return reading.wrong(node, accepted);
  for (const Node& entry : node.list) {
    const bool known = entry.kind == Node::Kind::text && (entry.text == "x" || entry.text == "y");
    if (!known) {
      reading.complain(entry, shown(entry) + " is not a direction; accepted: " + accepted);
    } else {
      bool& fixed = support.fix[entry.text == "x" ? 0 : 1];
      if (fixed) reading.complain(entry, shown(entry) + " is named twice");
      fixed = true;
    }
  }
}

void check_support(const Node& node, Support& support, const std::string& path, Findings& findings) {
  if (node.has("boundary") == node.has("point"))
    findings.add(node.origin, path, "accepted: either `boundary` or `point`, one of them");
  for (int i = 0; i < 2; ++i)
    if (support.displacement[i] != 0.0 && !support.fix[i])
      findings.add(node.find("displacement")->origin, path + ".displacement",
                   std::string("prescribes ") + (i == 0 ? "x" : "y") + ", which `fix` does not name");
}

Table<Support> support_table() {
  Key<Support> fix{
      {.name = "fix", .required = true, .meaning = "the directions held"}, R"(list of "x", "y")", read_fix};
  return {"support",
          "[[support]]",
          "where the body is held",
          {key(&Support::boundary, {.name = "boundary", .meaning = "name of the boundary held"}),
           key(&Support::point, {.name = "point", .unit = "m", .meaning = "or the node there"}), std::move(fix),
           key(&Support::displacement, {.name = "displacement", .unit = "m", .meaning = "prescribed values"})},
          check_support};
}

Table<Load> load_table() {
  return {"load",
          "[[load]]",
          "a load on a boundary: a uniform `traction` or `pressure`, or standing water up to `water_level`",
          {key(&Load::boundary, {.name = "boundary", .required = true, .meaning = "name of the boundary loaded"}),
           key(&Load::traction, {.name = "traction", .unit = "Pa", .meaning = "in global axes"}),
           key(&Load::pressure, {.name = "pressure", .unit = "Pa", .meaning = "positive pushes into the body"}),
           key(&Load::water_level,
               {.name = "water_level", .unit = "m", .meaning = "y of the free surface of standing water"}),
           key(&Load::water_density,
               {.name = "water_density", .unit = "kg/m³", .range = positive(), .meaning = "with `water_level`"})},
          [](const Node& node, Load&, const std::string& path, Findings& findings) {
            if (node.has("traction") + node.has("pressure") + node.has("water_level") != 1)
              findings.add(node.origin, path, "accepted: one of `traction`, `pressure` and `water_level`");
          }};
}

Table<Gravity> gravity_table() {
  return {"gravity",
          "[gravity]",
          "the body's weight",
          {key(&Gravity::acceleration, {.name = "acceleration", .unit = "m/s²", .meaning = "acts in -y"})}};
}

Table<Modal> modal_table() {
  return {"modal",
          "[modal]",
          "analysis = \"modal\": natural frequencies",
          {key(&Modal::count, {.name = "count", .range = at_least(1), .meaning = "how many, from the lowest"}),
           key(&Modal::interior_order,
               {.name = "interior_order",
                .range = between(0, 10),
                .meaning = "radial bubble functions inside each polygon, 2 … 10; 0: mass of the static modes alone"})},
          [](const Node& node, Modal& modal, const std::string& path, Findings& findings) {
            if (modal.interior_order == 1)
              findings.add(node.find("interior_order")->origin, path + ".interior_order",
                           "1 adds nothing; accepted: 0 or 2 … 10");
          }};
}

}  // namespace

std::vector<Part> body_parts() {
  const auto refinement = refinement_table();
  const auto grading = grading_table();
  return {one_part<Geometry>(&Scene::geometry, geometry_table()),
          one_part<Mesh>(&Scene::mesh, mesh_table(refinement, grading),
                         {reference_of(*refinement), reference_of(*grading)}),
          one_part<material::Isotropic>(&Scene::material, material_table()),
          list_part(&Scene::regions, region_table()),
          list_part(&Scene::cracks, crack_table()),
          list_part(&Scene::supports, support_table()),
          list_part(&Scene::loads, load_table()),
          one_part<Gravity>(&Scene::gravity, gravity_table()),
          one_part<Modal>(&Scene::modal, modal_table())};
}

}  // namespace sunder::scene
