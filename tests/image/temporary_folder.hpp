#pragma once
// A fresh folder for a test's files, gone when the test ends.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace tuberia {

class TemporaryFolder {
 public:
  /// name_part: part of the folder's name, for tests of unusual paths.
  explicit TemporaryFolder(const std::string& name_part = "test") {
    std::random_device device;
    path_ = std::filesystem::temp_directory_path() /
            ("tuberia " + name_part + " " + std::to_string(device()) + std::to_string(device()));
    std::filesystem::create_directory(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Writes the content, exactly, and returns the file's path.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  std::ptrdiff_t file_count() const {
    return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
  }

 private:
  std::filesystem::path path_;
};

/// Whether an error is what a user should see: one line that names the culprit.
inline bool one_line_naming(const std::string& message, const std::string& culprit) {
  return message.find('\n') == std::string::npos && message.find('\r') == std::string::npos &&
         message.find(culprit) != std::string::npos;
}

}  // namespace tuberia
