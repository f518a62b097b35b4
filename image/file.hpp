#pragma once
// Whole files in and out of memory, with errors that name the file.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace tuberia {

/// The path between quotation marks, control characters as '?', so that it fits a one-line error.
std::string quoted_path(const std::filesystem::path& path);

/// The extension with its dot, in lower case: ".png" for "A.PNG"; "" if there is none.
std::string lower_case_extension(const std::filesystem::path& path);

/// All bytes of a regular file; at least one.
/// Errors: the file is missing, a folder, a device, empty, or cannot be read.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

/// The errors of write_file that can be known before there is anything to write: for those who work long for it.
Result<Nothing> check_writable(const std::filesystem::path& path);

/// Makes or replaces a file whole or not at all: the bytes go to a temporary file in the same
/// folder, which then takes the target's name. A symbolic link keeps pointing where it did.
/// Errors: the folder is missing or not writable, the target is a folder or a device, the disk
/// fails or is full; the target is then as it was before and the temporary file is gone.
Result<Nothing> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace tuberia
