#include "examples/tuberia/witness/comparison.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace tuberia::witness {
namespace {

std::string line(std::string_view name, std::int64_t count, double share) {
  char text[200];
  std::snprintf(text, sizeof text, "%-48.*s %9lld  %7.3f %%\n", static_cast<int>(name.size()), name.data(), static_cast<long long>(count), 100 * share);
  return text;
}

}  // namespace

int difference(const Rgba8& a, const Rgba8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

Counts counts_of(const Comparison& comparison) {
  Counts counts;
  counts.pixels = static_cast<std::int64_t>(comparison.verdicts.pixels().size());
  for (std::size_t i = 0; i < comparison.verdicts.pixels().size(); ++i) {
    const PixelVerdict& verdict = comparison.verdicts.pixels()[i];
    ++counts.of_class[static_cast<std::size_t>(class_of(verdict))];
    if (verdict.differs && verdict.explained) ++counts.of_causes[verdict.causes.bits()];
    if (comparison.drawn_objects.pixels()[i] != comparison.traced_objects.pixels()[i]) ++counts.other_objects;
    counts.largest_difference = std::max(counts.largest_difference, difference(comparison.drawn.pixels()[i], comparison.traced.pixels()[i]));
  }
  return counts;
}

bool is_confirmed(const Counts& counts) { return counts.of(PixelClass::unexplained) == 0 && counts.same_objects() > kLeastSameObjects; }

std::string summary_of(const Comparison& comparison) {
  const Counts counts = counts_of(comparison);
  const auto share = [&](std::int64_t count) { return static_cast<double>(count) / static_cast<double>(std::max<std::int64_t>(counts.pixels, 1)); };
  std::string text = comparison.title + "\n" + line("  pixels", counts.pixels, 1);
  text += line("  showing the same object", counts.pixels - counts.other_objects, counts.same_objects());
  text += line("  that differ", counts.differing(), share(counts.differing()));
  for (const auto& [bits, count] : counts.of_causes) text += line("    " + name_of(Causes(bits)), count, share(count));
  text += line("    unexplained", counts.of(PixelClass::unexplained), share(counts.of(PixelClass::unexplained)));
  for (const std::string& remark : comparison.remarks) text += "  note: " + remark + "\n";
  return text + (is_confirmed(counts) ? "  confirmed\n" : "  NOT confirmed\n");
}

}  // namespace tuberia::witness
