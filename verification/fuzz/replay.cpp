/// Runs one fuzz target over files that are there already: what was found once is tried in every test run, with any
/// compiler. `replay FILE|FOLDER…`; exit status 1 where there is nothing to try.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "verification/fuzz/try_bytes.hpp"

namespace {

int tried = 0;

void replay(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  ++tried;
}

}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) replay(arguments[i]);
    if (std::filesystem::is_directory(arguments[i]))
      for (const auto& entry : std::filesystem::recursive_directory_iterator(arguments[i]))
        if (entry.is_regular_file()) replay(entry.path());
  }
  std::printf("%d inputs\n", tried);
  return tried > 0 ? 0 : 1;
}
