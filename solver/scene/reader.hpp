#pragma once
/// Reads a scene: from the file that a person wrote to a checked value. The only code that knows TOML.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::scene {

/// A value that replaces or adds one of the file's: `--set mesh.order=3`, or one point of a sweep.
struct Override {
  std::string key;    ///< dotted, lists by index: "mesh.order", "crack[0].path"; an index one past the end appends
  std::string value;  ///< as TOML writes it: "3", "[[0, 1], [2, 1]]", "\"stress\""
};

/// What stands for a real number of the scene in the run, e.g. the number moved by its uncertainty. Asked once for
/// each, in the order of reading, after its type and range were checked; empty: the number itself.
using NumberFilter = std::function<double(double)>;

/// Reads and checks the scene in `file`; files that it names are sought relative to its folder. Throws SceneError with
/// everything that is wrong where it cannot be used: syntax, unknown or missing keys, types, ranges, contradictions
/// between tables. What needs the
/// geometry computed (crossing outlines, cracks outside the body) is left to modules mesh and crack.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, std::span<const Override> overrides = {},
                               const NumberFilter& filter = {});

/// The same from a text; `name` stands for the file's path in messages and for its folder in what it names.
[[nodiscard]] Scene read_scene_text(std::string_view text, const std::filesystem::path& name,
                                    std::span<const Override> overrides = {}, const NumberFilter& filter = {});

/// Splits "mesh.order=3" at the first '='. Throws std::invalid_argument where there is none or nothing before it.
[[nodiscard]] Override parse_override(std::string_view text);

}  // namespace sunder::scene
