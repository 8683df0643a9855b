#pragma once
/// The catalogue of cases as a page: claim, source, tolerance, last figures. verification/README.md is made from it.

#include <string>
#include <vector>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"

namespace sunder::verification {

/// What the gating checks rest on; pins tell change and count for nothing here.
struct Evidence {
  int gating = 0;
  int with_reference = 0;  ///< compared with a stated answer, by value or by its order
  int independent = 0;     ///< of these: exact, high-precision or cross-code
  int by_law = 0;          ///< an invariant, or the order that a theory gives
  int bounds = 0;
  int refusals = 0;
  int orders = 0;  ///< of all: orders of accuracy

  /// Part of the checks with a reference whose reference is exact, high-precision or another code's, 0 … 1.
  double share() const { return with_reference > 0 ? static_cast<double>(independent) / with_reference : 0.0; }
};
[[nodiscard]] Evidence evidence_of(const std::vector<Case>& cases);

constexpr double least_independent_share = 0.8;  ///< that the catalogue is held to

/// A table a family. `results` fill the last column; those of cases that are not listed are left out.
[[nodiscard]] std::string catalogue_page(const std::vector<Case>& cases, const std::vector<CaseResult>& results);

/// The page without the column of figures, which vary: what must agree with the cases.
[[nodiscard]] std::string claims_of(const std::string& page);

}  // namespace sunder::verification
