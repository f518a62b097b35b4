#include <bit>
#include <cmath>
#include <cstdio>

#include "tests/witness/comparison.hpp"

namespace tuberia::witness {
namespace {

bool is_wrong(const Case& c, Machines& machines) { return compare(c, machines).verdict != Verdict::agreed; }

/// Takes over a change that leaves the case wrong.
template <class Change>
void attempt(Case& c, Machines& machines, const Change& change) {
  Case changed = c;
  change(changed);
  if (is_wrong(changed, machines)) c = changed;
}

/// One triangle, an ordinary view, coordinates with few bits.
Case shrunk(Case c, Machines& machines) {
  for (std::size_t i = 0; i < c.triangle_count(); ++i)
    attempt(c, machines, [&](Case& one) { one.vertices = {c.vertices[3 * i], c.vertices[3 * i + 1], c.vertices[3 * i + 2]}; });
  attempt(c, machines, [](Case& one) { one.view.near_depth = 0, one.view.far_depth = 1; });
  attempt(c, machines, [](Case& one) { one.is_counting = true; });
  attempt(c, machines, [](Case& one) { one.format = DepthFormat::d24; });
  attempt(c, machines, [](Case& one) { one.instruction_set = InstructionSet::baseline; });
  for (std::size_t i = 0; i < c.vertices.size(); ++i)
    for (float rational::ClipVertex::*value : {&rational::ClipVertex::x, &rational::ClipVertex::y, &rational::ClipVertex::z, &rational::ClipVertex::w})
      for (const int bits : {23, 20, 16, 12, 8, 4})
        attempt(c, machines, [&](Case& one) {
          float& number = one.vertices[i].*value;
          number = std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) & ~((1u << bits) - 1));
        });
  return c;
}

std::string line(const char* format, auto... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::string explained(const Case& given, Machines& machines) {
  const Case c = shrunk(given, machines);
  const rational::Viewport& v = c.view.viewport;
  constexpr const char* kFormats[] = {"d16", "d24", "d32f"};
  std::string text = compare(c, machines).what + "\n";
  text += line("target %dx%d %s, viewport (%d, %d) %dx%d, lowest z %d, depth range %g to %g, %s, %s\n", c.width, c.height,
               kFormats[static_cast<std::size_t>(c.format)], v.x, v.y, v.width, v.height, c.view.lowest_z, static_cast<double>(c.view.near_depth),
               static_cast<double>(c.view.far_depth), c.is_counting ? "counting" : "nearest", std::string(name_of(c.instruction_set)).c_str());
  for (const rational::ClipVertex& p : c.vertices)
    text += line("  {0x%08x, 0x%08x, 0x%08x, 0x%08x},  // %.9g, %.9g, %.9g, %.9g\n", std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                 std::bit_cast<std::uint32_t>(p.z), std::bit_cast<std::uint32_t>(p.w), static_cast<double>(p.x), static_cast<double>(p.y),
                 static_cast<double>(p.z), static_cast<double>(p.w));
  return text;
}

}  // namespace tuberia::witness
