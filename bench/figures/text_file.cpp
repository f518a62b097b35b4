#include "bench/figures/text_file.hpp"

#include <filesystem>
#include <fstream>

namespace tuberia::bench {

Result<Nothing> write_text(const std::string& path, const std::string& text) {
  if (path.empty()) return Nothing{};
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;  // the file's own failure says it, too
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
}

}  // namespace tuberia::bench
