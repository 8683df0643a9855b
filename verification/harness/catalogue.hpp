#pragma once
/// The catalogue of cases as a page: claim, source, tolerance, last figures. verification/README.md is made from it.

#include <string>
#include <vector>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"

namespace sunder::verification {

/// A table a family. `results` fill the last column; those of cases that are not listed are left out.
[[nodiscard]] std::string catalogue_page(const std::vector<Case>& cases, const std::vector<CaseResult>& results);

/// The page without the column of figures, which vary: what must agree with the cases.
[[nodiscard]] std::string claims_of(const std::string& page);

}  // namespace sunder::verification
