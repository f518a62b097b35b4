#pragma once
// Text into files.

#include <string>

#include "base/result.hpp"

namespace tuberia::bench {

/// Writes the file anew, and the folders it lies in; nothing for the path "". Error naming the path.
Result<Nothing> write_text(const std::string& path, const std::string& text);

}  // namespace tuberia::bench
