#include "solver/scene/reader.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "solver/scene/checks.hpp"
#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

std::vector<std::string> top_names() {
  std::vector<std::string> names = head_table().key_names();
  for (const Part& part : parts()) names.push_back(part.name);
  return names;
}

const Part* part_named(std::string_view name) {
  for (const Part& part : parts())
    if (part.name == name) return &part;
  return nullptr;
}

/// The keys above the first table, as a table of their own.
Node head_of(const Node& document) {
  Node head;
  head.origin = document.origin;
  for (const auto& [name, value] : document.table)
    for (const std::string& known : head_table().key_names())
      if (name == known) head.table.emplace_back(name, value);
  return head;
}

void read_tables(const Node& document, Scene& scene, Findings& findings) {
  const Node head = head_of(document);
  read_table(head, head_table(), scene, "", findings);
  for (const auto& [name, value] : document.table) {
    if (const Part* part = part_named(name))
      part->read(value, scene, findings);
    else if (!head.has(name))
      refuse_unknown_key(value, name, "", top_names(), findings);
  }
}

/// What the tables leave to each other.
void complete(Scene& scene) {
  if (scene.mesh.file && scene.mesh.file->is_relative()) scene.mesh.file = scene.file.parent_path() / *scene.mesh.file;
  if (scene.material)
    for (Region& region : scene.regions) region.material.plane = scene.material->plane;
  if (scene.analysis == Analysis::modal && !scene.modal) scene.modal.emplace();
}

}  // namespace

Scene read_scene_text(std::string_view text, const std::filesystem::path& name, std::span<const Override> overrides,
                      const NumberFilter& filter) {
  Node document = parse_document(text, name.string());
  apply_overrides(document, overrides);
  Findings findings(name.string(), overrides, filter);
  Scene scene;
  scene.file = name;
  read_tables(document, scene, findings);
  findings.throw_if_any();
  complete(scene);
  check_together(document, scene, findings);
  findings.throw_if_any();
  return scene;
}

Scene read_scene(const std::filesystem::path& file, std::span<const Override> overrides, const NumberFilter& filter) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw SceneError(file.string() + ": is a folder, not a scene");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw SceneError(file.string() + ": cannot be opened; accepted: a scene, one TOML file");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw SceneError(file.string() + ": cannot be read");
  return read_scene_text(text, file, overrides, filter);
}

Override parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto trimmed = [](std::string_view word) {
    const std::size_t first = word.find_first_not_of(" \t"), last = word.find_last_not_of(" \t");
    return first == std::string_view::npos ? std::string() : std::string(word.substr(first, last - first + 1));
  };
  if (equals == std::string_view::npos || trimmed(text.substr(0, equals)).empty())
    throw std::invalid_argument("\"" + std::string(text) + "\" is not of the form KEY=VALUE");
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

std::string place_of(const Scene& scene, const std::string& table) {
  const auto found = scene.locations.find(table);
  const bool known = found != scene.locations.end() && found->second.line > 0;
  const std::string heading =
      table.find('[') == std::string::npos ? "[" + table + "] " : "[[" + table.substr(0, table.find('[')) + "]] ";
  return scene.file.string() + (known ? ":" + std::to_string(found->second.line) : "") + ": " + heading;
}

}  // namespace sunder::scene
