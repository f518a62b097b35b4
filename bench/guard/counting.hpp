#pragma once
// Counting the instructions of a frame with valgrind's callgrind.

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.hpp"

namespace tuberia::bench {

/// Draws a small workload twice; the second frame, which finds threads and memory ready, goes
/// through a function that callgrind knows by its name. Error for an unknown workload.
Result<Nothing> draw_counted_frame(const std::string& workload);

/// Runs `program --draw WORKLOAD` under callgrind. Error when there is no valgrind, or when it or
/// the program fails. scratch: an existing folder for its files.
Result<std::int64_t> count_instructions(const std::filesystem::path& program, const std::string& workload,
                                        const std::filesystem::path& scratch);

}  // namespace tuberia::bench
