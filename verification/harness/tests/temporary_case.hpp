#pragma once
/// A folder of cases that a test writes and that goes with it.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "verification/harness/case.hpp"

namespace sunder::verification {

/// The head that most cases of the tests share; `study = "fake"` needs no scene.
inline const std::string plain_head =
    "version = 1\n"                                     // line 1
    "title = \"A number\"\n"                            // 2
    "requirement = \"The study shall give two.\"\n"     // 3
    "why = \"So that the harness is seen to work.\"\n"  // 4
    "family = \"demo\"\n"                               // 5
    "tier = \"quick\"\n"                                // 6
    "modules = []\n"                                    // 7
    "study = \"fake\"\n";                               // 8

inline const std::string exact_two =
    "[[reference]]\n"
    "name = \"two\"\nclass = \"exact\"\nvalue = 2.0\nunit = \"-\"\nsource = \"arithmetic\"\nlocator = \"1 + 1\"\n"
    "uncertainty = 0\n";

inline const std::string check_two =
    "[[check]]\n"
    "name = \"answer\"\nquantity = \"answer\"\nreference = \"two\"\ntolerance = 1e-3\nbasis = \"round-off\"\n"
    "reason = \"the study adds once\"\n";

class TemporaryCases {
 public:
  TemporaryCases() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("sunder-cases-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_ / "cases");
    std::filesystem::create_directories(folder_ / "reference-data");
  }
  ~TemporaryCases() { std::filesystem::remove_all(folder_); }
  TemporaryCases(const TemporaryCases&) = delete;
  TemporaryCases& operator=(const TemporaryCases&) = delete;

  CaseFolders folders() const { return {folder_ / "cases", folder_ / "reference-data"}; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
  }
  Case read(const std::string& text) const { return read_case(write("cases/demo/number.case.toml", text), folders()); }

 private:
  std::filesystem::path folder_;
};

}  // namespace sunder::verification
