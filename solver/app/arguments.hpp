#pragma once
/// What a person typed after `sunder`.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/scene/reader.hpp"

namespace sunder::app {

enum class Command { run, check, ablate, keys };

struct Arguments {
  Command command = Command::run;
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;  ///< --set KEY=VALUE, in their order
  std::optional<std::filesystem::path>
      output;  ///< absent: `<scene's name without .toml>-results` in the current folder
  std::optional<std::filesystem::path> picture;  ///< check: where to draw the mesh (SVG)
  std::optional<std::filesystem::path>
      cache;        ///< run, ablate: folder for responses of unbounded rock; absent: none kept
  int threads = 1;  ///< >= 1; absent on the line: one a core
  bool quiet = false;
  bool resume = false;    ///< run: from the checkpoint in the output folder
  bool markdown = false;  ///< keys: as the documentation has them
};

/// Either arguments, or a text to print with the exit status to end with: help and version 0, a wrong line 2.
struct CommandLine {
  std::optional<Arguments> arguments;
  std::string text;
  int status = 0;
};

/// `words` without the program's name.
[[nodiscard]] CommandLine parse_command_line(std::span<const std::string> words);

}  // namespace sunder::app
