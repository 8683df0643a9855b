/// Any text is a .msh file, or refused with MeshError; so is its dual. Binary files are gmsh's own to read.

#include <string>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/msh_content.hpp"
#include "solver/mesh/msh_file.hpp"
#include "verification/fuzz/input_file.hpp"
#include "verification/fuzz/try_bytes.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sunder;
  static const fuzz::InputFile input("body.msh");
  try {
    if (mesh::binary_msh({reinterpret_cast<const char*>(data), size})) return 0;
  } catch (const mesh::MeshError&) {  // neither: the reader shall say so too
  }
  const std::filesystem::path& file = input.write({data, size});
  for (const bool dual : {false, true}) {
    try {
      static_cast<void>(mesh::read_msh(file, {.dual = dual}));
    } catch (const mesh::MeshError&) {
    }
  }
  return 0;
}
