#pragma once
/// How a [[check]] is written. Private to the reader of cases.

#include "verification/harness/case.hpp"
#include "verification/harness/case_table.hpp"

namespace sunder::verification {

/// `so_far` is the case with its references and its sweep. Throws CaseError.
[[nodiscard]] Check read_check(CaseTable table, const Case& so_far);

}  // namespace sunder::verification
