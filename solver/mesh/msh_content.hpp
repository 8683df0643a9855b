#pragma once
/// What a .msh file says, before it is a mesh. Used by the readers of text and of binary files.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace sunder::mesh {

struct MshContent {
  struct Node {
    long tag = 0;
    double x = 0.0, y = 0.0, z = 0.0;
  };
  struct Cell {
    std::array<long, 4> nodes{};  ///< tags
    int count = 0;                ///< 3 or 4
    long line = 0;                ///< in the file; 0: unknown
  };
  struct Line {
    std::array<long, 2> nodes{};
    std::string name;  ///< of its physical curve
    long line = 0;
  };
  std::vector<Node> nodes;
  std::vector<Cell> cells;
  std::vector<Line> lines;  ///< those of physical curves
};

/// Throws MeshError "<name>:<line>: …" where the text is no .msh file of version 2.2 or 4.1.
MshContent parse_msh(const std::string& text, const std::string& name);

/// True where the text starts like a binary .msh file.
bool binary_msh(const std::string& text);

/// A binary file, through gmsh. Throws MeshError with gmsh's words.
MshContent read_binary_msh(const std::filesystem::path& file);

}  // namespace sunder::mesh
