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

/// What pictures may differ by that are made with the library's powers and exponentials, which no two machines need to round alike.
struct GoldenTolerance {
  int codes = 0;              // of a component
  double share_of_pixels = 0;
};

/// Compares bit for bit unless told otherwise. "" when equal; otherwise what differs and where to look: <name>.actual.png,
/// <name>.expected.png and <name>.difference.png lie side by side. With `update` the golden file is
/// rewritten instead.
inline std::string golden_difference(const std::string& name, const Image<Rgba8>& actual, const GoldenFolders& folders = {},
                                     const GoldenTolerance& tolerance = {}) {
  const std::filesystem::path file = folders.golden / (name + ".png");
  if (folders.update) {
    const auto written = write_image(file, actual);
    return written ? "" : written.error().message;
  }
  const Result<Image<Rgba8>> expected = read_image(file);
  if (expected && *expected == actual) return "";
  const Result<Comparison> comparison = expected ? compare(actual, *expected) : expected.error();
  if (comparison && comparison->largest_difference <= tolerance.codes &&
      static_cast<double>(comparison->differing_pixels) <= tolerance.share_of_pixels * actual.width() * actual.height())
    return "";

  std::filesystem::create_directories(folders.evidence);
  const auto leave = [&](const char* what, const Image<Rgba8>& image) {
    (void)write_image(folders.evidence / (name + "." + what + ".png"), image);
  };
  leave("actual", actual);
  const std::string where = "see " + (folders.evidence / name).generic_string() + ".{actual,expected,difference}.png";
  if (!expected) return expected.error().message + "; " + where;
  leave("expected", *expected);
  leave("difference", difference_image(actual, *expected));
  if (!comparison) return "'" + name + "': " + comparison.error().message + "; " + where;
  return "'" + name + "' differs in " + std::to_string(comparison->differing_pixels) + " pixels by up to " +
         std::to_string(comparison->largest_difference) + " codes; " + where +
         "; if it is meant to, rewrite with TUBERIA_UPDATE_GOLDEN=1 and say why in the commit";
}

}  // namespace tuberia::test
