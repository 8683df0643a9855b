#pragma once
/// Refusal of values out of range, by the names that this module calls them.

#include "solver/numerics/require.hpp"

namespace sunder::crackwater {

using numerics::refuse;
using numerics::require_finite;
using numerics::require_not_negative;
using numerics::require_positive;

}  // namespace sunder::crackwater
