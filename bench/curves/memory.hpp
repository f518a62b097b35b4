#pragma once
// What this process takes from the heap. The program that links memory.cpp has its operator new
// counted, so the figures are exact where the system's own (resident pages, sampled) are not.

#include <cstdint>

namespace tuberia::bench {

/// Bytes from operator new that are in use.
std::int64_t heap_bytes() noexcept;

/// The most that was in use since the last call of restart_heap_peak, or since the start.
std::int64_t heap_peak_bytes() noexcept;
void restart_heap_peak() noexcept;

/// Resident pages that are nobody else's: heap, stacks; not mapped files. 0 if the system does not say.
std::int64_t private_resident_bytes();

/// What the system would give without swapping; 0 if it does not say.
std::int64_t available_bytes();

}  // namespace tuberia::bench
