#pragma once
/// CPU time and memory of this process, as the operating system counts them.

namespace sunder::verification {

/// CPU seconds of all threads of this process so far.
[[nodiscard]] double cpu_seconds();

/// Forgets the largest resident size so far, where the system can; the next `peak_resident_bytes` then speaks of what
/// came after.
void forget_peak_memory();

/// Largest resident size since the start, or since it was last forgotten [bytes].
[[nodiscard]] long peak_resident_bytes();

}  // namespace sunder::verification
