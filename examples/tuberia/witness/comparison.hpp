#pragma once
// Two pictures of one scene beside each other, and what became of their differences.

#include <map>
#include <string>
#include <vector>

#include "examples/tuberia/witness/verdict.hpp"
#include "image/image.hpp"

namespace tuberia::witness {

/// All images have one size. Colours are sRGB codes as a screen shows them; objects are indices, -1 for none.
struct Comparison {
  std::string title, source, file;
  Image<Rgba8> drawn, traced;
  Image<int> drawn_objects, traced_objects;
  Image<PixelVerdict> verdicts;
  std::vector<std::string> object_names;
  std::vector<std::string> remarks{};  // what the scene has that cannot be confirmed, in words
  double drawing_seconds = 0, tracing_seconds = 0, explaining_seconds = 0;
};

struct Counts {
  std::int64_t pixels = 0, other_objects = 0;
  std::array<std::int64_t, kPixelClassCount> of_class{};
  std::map<unsigned, std::int64_t> of_causes;  // by Causes::bits, of what is explained
  int largest_difference = 0;                  // codes

  std::int64_t of(PixelClass pixel_class) const { return of_class[static_cast<std::size_t>(pixel_class)]; }
  std::int64_t differing() const { return pixels - of(PixelClass::same); }
  double same_objects() const { return pixels == 0 ? 1 : 1 - static_cast<double>(other_objects) / static_cast<double>(pixels); }  // a share
};

Counts counts_of(const Comparison& comparison);

/// Object ids equal on more than this share of the pixels, and nothing unexplained: what script/test asks for.
inline constexpr double kLeastSameObjects = 0.995;
bool is_confirmed(const Counts& counts);

/// The largest difference of a channel, in codes.
int difference(const Rgba8& a, const Rgba8& b);

/// Lines for a terminal.
std::string summary_of(const Comparison& comparison);

/// A page in one file: both pictures, their difference, the map of causes, counts, and some pixels close up.
std::string page_of(const Comparison& comparison);

}  // namespace tuberia::witness
