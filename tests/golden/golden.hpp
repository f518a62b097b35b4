#pragma once
// Golden pictures: the bits that a scene must have, kept as PNG files.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "image/compare.hpp"
#include "image/read_image.hpp"
#include "image/write_image.hpp"

namespace tuberia::test {

/// Where golden files are and where evidence of a difference is left; relative to the project's root.
struct GoldenFolders {
  std::filesystem::path golden = "tests/golden", evidence = "out/golden";
  bool update = std::getenv("TUBERIA_UPDATE_GOLDEN") != nullptr && std::string(std::getenv("TUBERIA_UPDATE_GOLDEN")) == "1";
};

/// Compares bit for bit. "" when equal; otherwise what differs and where to look: <name>.actual.png,
/// <name>.expected.png and <name>.difference.png lie side by side. With `update` the golden file is
/// rewritten instead.
inline std::string golden_difference(const std::string& name, const Image<Rgba8>& actual, const GoldenFolders& folders = {}) {
  const std::filesystem::path file = folders.golden / (name + ".png");
  if (folders.update) {
    const auto written = write_image(file, actual);
    return written ? "" : written.error().message;
  }
  const Result<Image<Rgba8>> expected = read_image(file);
  if (expected && *expected == actual) return "";

  std::filesystem::create_directories(folders.evidence);
  const auto leave = [&](const char* what, const Image<Rgba8>& image) {
    (void)write_image(folders.evidence / (name + "." + what + ".png"), image);
  };
  leave("actual", actual);
  const std::string where = "see " + (folders.evidence / name).generic_string() + ".{actual,expected,difference}.png";
  if (!expected) return expected.error().message + "; " + where;
  leave("expected", *expected);
  leave("difference", difference_image(actual, *expected));
  const Result<Comparison> comparison = compare(actual, *expected);
  if (!comparison) return "'" + name + "': " + comparison.error().message + "; " + where;
  return "'" + name + "' differs in " + std::to_string(comparison->differing_pixels) + " pixels by up to " +
         std::to_string(comparison->largest_difference) + " codes; " + where +
         "; if it is meant to, rewrite with TUBERIA_UPDATE_GOLDEN=1 and say why in the commit";
}

}  // namespace tuberia::test
