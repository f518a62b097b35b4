#include "tests/witness/cases.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/random.hpp"

namespace tuberia::witness {
namespace {

using rational::ClipVertex;
using test::Random;

constexpr std::array<std::string_view, kClasses> kNames{
    "slivers", "shared_edges", "lattice", "small", "guard_band", "far", "w_ratios", "near_zero_w", "behind", "planes", "cut",
    "denormals", "powers_of_two", "bit_patterns"};

bool one_in(Random& random, std::int64_t n) { return random.below(n) == 0; }
double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random.u64() >> 11) * 0x1p-53);
}
double power_between(Random& random, double base, double low, double high) { return std::pow(base, between(random, low, high)); }
float sign(Random& random) { return one_in(random, 2) ? 1.0f : -1.0f; }

struct Pixels {
  double x, y;
};

/// The clip position that the viewport sends there: z in ndc, rounded to floats.
ClipVertex placed(const Case& c, const Pixels& p, double z, double w) {
  const rational::Viewport& v = c.view.viewport;
  const double x_ndc = (p.x - v.x) * 2 / v.width - 1, y_ndc = 1 - (p.y - v.y) * 2 / v.height;
  return {static_cast<float>(x_ndc * w), static_cast<float>(y_ndc * w), static_cast<float>(z * w), static_cast<float>(w)};
}

double random_z(Random& random, const Case& c) { return between(random, c.view.lowest_z, 1); }
Pixels on_target(Random& random, const Case& c, double margin) {
  return {between(random, -margin, c.width + margin), between(random, -margin, c.height + margin)};
}
Pixels in_guard_band(Random& random) { return {between(random, -32760, 32760), between(random, -32760, 32760)}; }
double everyday_w(Random& random) { return one_in(random, 3) ? 1 : between(random, 0.05, 10); }

/// The other end of a sliver: along rows of centres, in the guard band, nearly level, or near.
Pixels other_end(Random& random, const Case& c, const Pixels& a) {
  if (one_in(random, 2)) {
    const double length = static_cast<double>(random.below(one_in(random, 2) ? 8000 : 30));
    return {a.x + length * static_cast<double>(random.below(9) - 4), a.y + length * static_cast<double>(random.below(9) - 4)};
  }
  if (one_in(random, 3)) return in_guard_band(random);
  if (one_in(random, 3)) return {a.x + between(random, -32000, 32000), a.y + between(random, -1, 1)};
  return on_target(random, c, 40);
}

void add_slivers(Random& random, Case& c) {
  const Pixels a{static_cast<double>(random.below(c.width)) + 0.5, static_cast<double>(random.below(c.height)) + 0.5};
  const Pixels b = other_end(random, c, a);
  const double t = between(random, -0.1, 1.1);
  const bool has_w = one_in(random, 3);
  const auto beside = [&](double x, double y) {
    constexpr double kStep = 1.0 / 256;
    const Pixels p{x + kStep * static_cast<double>(random.below(5) - 2), y + kStep * static_cast<double>(random.below(5) - 2)};
    return placed(c, p, random_z(random, c), has_w ? everyday_w(random) : 1);
  };
  c.vertices = {beside(a.x, a.y), beside(b.x, b.y), beside(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))};
}

/// One edge twice, in both directions as in a mesh, or in the same.
void add_shared_edges(Random& random, Case& c) {
  const bool is_cut = one_in(random, 3);
  const auto any = [&] {
    if (is_cut) return ClipVertex{random.between(-3, 3), random.between(-3, 3), random.between(-2, 2), random.between(-1, 2)};
    return placed(c, on_target(random, c, one_in(random, 4) ? 20000 : 10), random_z(random, c), everyday_w(random));
  };
  const ClipVertex a = any(), b = any();
  c.vertices = {a, b, any(), b, a, any()};
  if (one_in(random, 4)) std::swap(c.vertices[3], c.vertices[4]);
}

void add_lattice(Random& random, Case& c) {
  // Sizes that are powers of two and w that is one make every place exact.
  c.width = 8 << random.below(3);
  c.height = 8 << random.below(3);
  c.view.viewport = {0, 0, c.width, c.height};
  constexpr std::array<double, 6> kSteps{1, 0.5, 1.0 / 16, 1.0 / 256, 1.0 / 512, 1.0 / 1024};
  const double step = kSteps[static_cast<std::size_t>(random.below(6))];
  const double scale = std::exp2(static_cast<double>(random.below(9)) - 4);
  const double corner = one_in(random, 2) ? 3 : 3.5;
  for (int k = 0; k < 3; ++k) {
    const auto place = [&](int size) {
      return step >= 0.5 ? step * static_cast<double>(random.below(2 * size)) - 2 : corner + step * static_cast<double>(random.below(64) - 16);
    };
    const Pixels p{place(c.width), place(c.height)};
    const double z = c.view.lowest_z + static_cast<double>(random.below(9)) / 8 * (1 - c.view.lowest_z);
    c.vertices.push_back(placed(c, p, z, one_in(random, 4) ? scale : 1));
  }
}

void add_small(Random& random, Case& c) {
  const Pixels at = on_target(random, c, 1);
  const double size = power_between(random, 2, -6, 2);
  for (int k = 0; k < 3; ++k)
    c.vertices.push_back(placed(c, {at.x + between(random, -size, size), at.y + between(random, -size, size)}, random_z(random, c), everyday_w(random)));
}

void add_guard_band(Random& random, Case& c) {
  const rational::Volume volume = rational::volume_of(c.view.viewport, c.view.lowest_z);
  for (int k = 0; k < 3; ++k) {
    const auto end = [&] { return static_cast<double>(sign(random)) * (32767 + between(random, -2, 2)); };
    Pixels p = on_target(random, c, 2000);
    if (!one_in(random, 3)) p.x = end();
    if (!one_in(random, 3)) p.y = end();
    ClipVertex v = placed(c, p, random_z(random, c), everyday_w(random));
    const auto on_plane = [&](float guard) {
      const float exactly = guard * v.w * sign(random);
      return one_in(random, 2) ? exactly : std::nextafter(exactly, one_in(random, 2) ? 3e38f : -3e38f);
    };
    if (one_in(random, 4)) v.x = on_plane(volume.guard_x);
    if (one_in(random, 4)) v.y = on_plane(volume.guard_y);
    c.vertices.push_back(v);
  }
}

void add_far(Random& random, Case& c) {
  const double scale = power_between(random, 10, 5, 30);
  for (int k = 0; k < 3; ++k) {
    const double own = one_in(random, 3) ? power_between(random, 10, 0, 30) : scale;
    const auto far = [&](double size) { return static_cast<float>(size * between(random, -1, 1)); };
    c.vertices.push_back({far(own), far(own), one_in(random, 4) ? far(scale) : random.between(0, 1), one_in(random, 4) ? far(scale) : 1.0f});
  }
}

void add_w_ratios(Random& random, Case& c) {
  for (int k = 0; k < 3; ++k) {
    const double w = k == 0 ? 1e-4 : k == 1 ? 1e3 : power_between(random, 10, -4, 3);
    c.vertices.push_back(placed(c, on_target(random, c, one_in(random, 3) ? 3000 : 6), random_z(random, c), w * between(random, 1, 2)));
  }
}

void add_near_zero_w(Random& random, Case& c) {
  for (int k = 0; k < 3; ++k) {
    const float tiny = static_cast<float>(power_between(random, 10, -38, -2));
    const float w = one_in(random, 3) ? random.between(0.1f, 2) : one_in(random, 3) ? 0.0f : sign(random) * tiny;
    const float reach = one_in(random, 2) ? 1.0f : tiny;
    c.vertices.push_back({random.between(-2, 2) * reach, random.between(-2, 2) * reach, w * random.between(-1.5f, 1.5f), w});
  }
}

void add_behind(Random& random, Case& c) {
  for (int k = 0; k < 3; ++k) {
    const float w = k == 0 ? random.between(-3, 0) : one_in(random, 3) ? random.between(-3, 3) : random.between(0, 3);
    c.vertices.push_back({random.between(-3, 3), random.between(-3, 3), w * random.between(-2, 2), w});
  }
}

void add_planes(Random& random, Case& c) {
  const rational::Volume volume = rational::volume_of(c.view.viewport, c.view.lowest_z);
  const bool is_whole = one_in(random, 2);
  for (int k = 0; k < 3; ++k) {
    const auto number = [&](float reach) {
      return is_whole ? static_cast<float>(random.below(9) - 4) / 4 * reach : random.between(-reach, reach);
    };
    ClipVertex v{number(2), number(2), number(2), is_whole ? static_cast<float>(random.below(8) - 2) / 4 : random.between(-0.5f, 2)};
    if (one_in(random, 2)) v.z = one_in(random, 2) ? v.w : static_cast<float>(volume.lowest_z) * v.w;
    if (one_in(random, 3)) v.x = volume.guard_x * v.w * sign(random);
    if (one_in(random, 3)) v.y = volume.guard_y * v.w * sign(random);
    c.vertices.push_back(v);
  }
}

void add_cut(Random& random, Case& c) {
  const float reach = one_in(random, 2) ? 3.0f : static_cast<float>(power_between(random, 10, 1, 7));
  for (int k = 0; k < 3; ++k)
    c.vertices.push_back({random.between(-reach, reach), random.between(-reach, reach), random.between(-3, 3), random.between(-1, 3)});
}

void add_denormals(Random& random, Case& c) {
  const double scale = std::exp2(-static_cast<double>(random.below(30)) - 118);
  for (int k = 0; k < 3; ++k) {
    const auto tiny = [&](double low, double high) { return static_cast<float>(scale * between(random, low, high)); };
    c.vertices.push_back(one_in(random, 4) ? placed(c, on_target(random, c, 9), random_z(random, c), everyday_w(random))
                                           : ClipVertex{tiny(-3, 3), tiny(-3, 3), tiny(-2, 2), tiny(-0.5, 3)});
  }
}

void add_powers_of_two(Random& random, Case& c) {
  const int exponent = static_cast<int>(random.below(121)) - 60;
  const bool is_cut = one_in(random, 2);
  for (int k = 0; k < 3; ++k) {
    ClipVertex v = is_cut ? ClipVertex{random.between(-3, 3), random.between(-3, 3), random.between(-2, 2), random.between(-1, 2)}
                          : placed(c, on_target(random, c, 20), random_z(random, c), everyday_w(random));
    for (float* value : {&v.x, &v.y, &v.z, &v.w}) *value = std::ldexp(*value, exponent);
    c.vertices.push_back(v);
  }
}

void add_bit_patterns(Random& random, Case& c) {
  // Half of them with exponents that meet; wholly random ones nearly always miss the screen.
  const auto around = static_cast<std::uint32_t>(random.below(254));
  const bool is_wild = one_in(random, 2);
  const auto any = [&] {
    const auto bits = static_cast<std::uint32_t>(random.u64());
    const std::uint32_t near = (around + static_cast<std::uint32_t>(random.below(4))) % 255;
    const std::uint32_t exponent = is_wild ? bits >> 23 & 0xffu : near;
    return std::bit_cast<float>((bits & 0x807fffffu) | (exponent == 255 ? 254u : exponent) << 23);
  };
  for (int k = 0; k < 3; ++k) {
    c.vertices.push_back({any(), any(), any(), any()});
    if (one_in(random, 2)) c.vertices.back().w = std::abs(c.vertices.back().w);
  }
}

void choose_view(Random& random, Case& c) {
  constexpr std::array<int, 8> kSizes{1, 5, 8, 13, 16, 24, 33, 67};
  c.width = kSizes[static_cast<std::size_t>(random.below(one_in(random, 4) ? 8 : 6))];
  c.height = kSizes[static_cast<std::size_t>(random.below(one_in(random, 4) ? 8 : 6))];
  c.view.viewport = {0, 0, c.width, c.height};
  if (one_in(random, 4)) {
    const auto within = [&](std::int64_t low, std::int64_t high) { return static_cast<int>(low + random.below(high - low + 1)); };
    c.view.viewport = {within(-9, c.width), within(-9, c.height), within(1, 40), within(1, one_in(random, 8) ? 16384 : 40)};
  }
  c.view.lowest_z = one_in(random, 2) ? -1 : 0;
  constexpr std::array<std::array<float, 2>, 6> kRanges{{{0, 1}, {0, 1}, {0, 1}, {1, 0}, {0.25f, 0.75f}, {0.9f, 0.1f}}};
  const auto& range = kRanges[static_cast<std::size_t>(random.below(6))];
  c.view.near_depth = range[0];
  c.view.far_depth = range[1];
  c.format = static_cast<DepthFormat>(random.below(3));
  c.is_counting = one_in(random, 2);
  const auto sets = supported_instruction_sets();
  c.instruction_set = one_in(random, 8) ? sets[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(sets.size())))] : sets.back();
}

}  // namespace

std::string_view name_of(Class c) noexcept { return kNames[static_cast<std::size_t>(c)]; }

std::optional<Class> class_named(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Class>(i);
  return std::nullopt;
}

Case random_case(Class kind, std::uint64_t seed, std::uint64_t number) {
  using Add = void (*)(Random&, Case&);
  constexpr std::array<Add, kClasses> kAdd{add_slivers, add_shared_edges, add_lattice, add_small, add_guard_band, add_far, add_w_ratios,
                                           add_near_zero_w, add_behind, add_planes, add_cut, add_denormals, add_powers_of_two, add_bit_patterns};
  Random random(Random::mixed(Random::mixed(seed) + number) + static_cast<std::uint64_t>(kind));
  Case c;
  choose_view(random, c);
  kAdd[static_cast<std::size_t>(kind)](random, c);
  return c;
}

}  // namespace tuberia::witness
