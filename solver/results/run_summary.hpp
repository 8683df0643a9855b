#pragma once
/// What a run leaves behind, as a value: summary.json and, where there is a course of time, history.csv.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/results/history.hpp"
#include "solver/results/quantity.hpp"

namespace sunder::results {

struct MeshSize {
  long polygons = 0, nodes = 0, dofs = 0;
};

/// What one part cost: the contract that a scene does not pay for what it does not have.
struct PartCost {
  std::string part = {};         ///< module name: "mesh", "sbfem", "fracture", …
  long calls = 0;                ///< how often the part was entered
  long long matrix_entries = 0;  ///< coefficients it formed or stored
  double seconds = 0.0;          ///< CPU seconds, without those of parts that it called
  long long bytes = 0;           ///< of memory that it took and still held when it was left, likewise
};

struct RunSummary {
  std::string name, analysis;
  std::string status = "completed";  ///< "completed" or "stopped: <why, where, what was reached>"
  std::vector<PartCost> parts = {};  ///< the parts that were constructed, in order
  MeshSize mesh;
  Quantity quantities;                                    ///< a table; keys per analysis as documented in the README
  std::vector<std::pair<std::string, long long>> counts;  ///< factorisations, steps, …
  std::vector<std::pair<std::string, double>> seconds;    ///< wall seconds a phase, and `total`
  int threads = 1;
  std::vector<std::string> warnings = {};
  std::optional<History> history = {};  ///< history.csv; absent where an instant is all there is

  bool completed() const { return status == "completed"; }
};

}  // namespace sunder::results
