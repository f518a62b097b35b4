#pragma once
// Giving both peers the same cores.

#include <string>

namespace tuberia::bench {

/// Keeps this process, and so every thread it starts from now on, to as many of the cores that it
/// may use. Returns a sentence for the table's heading. It cannot be one core a thread: llvmpipe
/// has one thread more than its rasterizers, and neither peer lets itself be told.
std::string keep_to_cores(int count);

}  // namespace tuberia::bench
