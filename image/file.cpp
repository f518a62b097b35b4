#include "image/file.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <system_error>

namespace tuberia {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Error file_error(const char* deed, const fs::path& path, const std::string& reason) {
  return {std::string("cannot ") + deed + " " + quoted_path(path) + ": " + reason};
}

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number != 0 ? error_number : EIO);
}

/// Why the path cannot be read as a file of bytes; empty if it can.
std::string why_not_readable(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) return "no such file";
  if (code) return code.message();
  if (fs::is_directory(status)) return "it is a folder";
  if (!fs::is_regular_file(status)) return "it is not a regular file";
  return {};
}

/// Why the path cannot become a file; empty if nothing speaks against it yet.
std::string why_not_writable(const fs::path& path) {
  if (path.filename().empty()) return "the path has no file name";
  std::error_code code;
  const fs::file_status folder = fs::status(path.parent_path().empty() ? "." : path.parent_path(), code);
  if (folder.type() == fs::file_type::not_found)
    return "no such folder " + quoted_path(path.parent_path());
  if (code) return code.message();
  if (!fs::is_directory(folder)) return quoted_path(path.parent_path()) + " is not a folder";

  const fs::file_status target = fs::status(path, code);
  if (target.type() == fs::file_type::not_found) return {};
  if (code) return code.message();
  if (fs::is_directory(target)) return "it is a folder";
  if (!fs::is_regular_file(target)) return "it is not a regular file";
  return {};
}

/// A short name that no other writer chooses, whatever the length of the target's name.
fs::path temporary_beside(const fs::path& path) {
  std::random_device device;
  char name[40];
  std::snprintf(name, sizeof name, ".tuberia-%08x%08x.part", device(), device());
  return path.parent_path() / name;
}

/// Writes and closes; the error number of what failed, or 0.
int write_all(std::FILE* file, std::span<const std::byte> bytes) {
  errno = 0;
  bool done = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int error_number = done ? 0 : errno;
  // A full disk may show only when the last buffer is flushed.
  if (std::fclose(file) != 0 && done) {
    done = false;
    error_number = errno;
  }
  return done ? 0 : (error_number != 0 ? error_number : EIO);
}

}  // namespace

std::string quoted_path(const fs::path& path) {
  std::string text = path.string();
  for (char& letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20 || code == 0x7f) letter = '?';
  }
  return "'" + text + "'";
}

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return extension;
}

Result<std::vector<std::byte>> read_file(const fs::path& path) {
  if (const std::string reason = why_not_readable(path); !reason.empty()) {
    return file_error("read", path, reason);
  }
  std::error_code code;
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) return file_error("read", path, code.message());

  errno = 0;
  const File file(std::fopen(path.string().c_str(), "rb"));
  if (!file) return file_error("read", path, reason_of(errno));
  if (size == 0) return file_error("read", path, "the file is empty");

  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  errno = 0;
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    return file_error("read", path,
                      std::ferror(file.get()) ? reason_of(errno) : "the file shrank meanwhile");
  }
  return bytes;
}

namespace {

/// What a link points to, not the link; what nothing speaks against yet.
Result<fs::path> target_of(const fs::path& path) {
  std::error_code code;
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(path, code))) {
    const fs::path linked = fs::canonical(path, code);
    if (code) return file_error("write", path, "it is a link to nowhere");
    target = linked;
  }
  if (const std::string reason = why_not_writable(target); !reason.empty()) return file_error("write", path, reason);
  return target;
}

}  // namespace

Result<Nothing> check_writable(const fs::path& path) {
  const auto target = target_of(path);
  if (!target) return target.error();
  return Nothing{};
}

Result<Nothing> write_file(const fs::path& path, std::span<const std::byte> bytes) {
  const auto found = target_of(path);
  if (!found) return found.error();
  const fs::path& target = *found;
  std::error_code code;

  const fs::path temporary = temporary_beside(target);
  errno = 0;
  std::FILE* file = std::fopen(temporary.string().c_str(), "wbx");
  if (file == nullptr) return file_error("write", path, reason_of(errno));
  if (const int error_number = write_all(file, bytes); error_number != 0) {
    fs::remove(temporary, code);
    return file_error("write", path, reason_of(error_number));
  }

  fs::rename(temporary, target, code);
  if (code) {
    const std::string reason = code.message();
    fs::remove(temporary, code);
    return file_error("write", path, reason);
  }
  return Nothing{};
}

}  // namespace tuberia
