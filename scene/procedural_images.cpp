#include "scene/procedural_images.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/colour.hpp"
#include "math/lattice_noise.hpp"

namespace tuberia {

namespace {

Rgba8 srgb_codes(const glm::dvec3& linear) {
  return {srgb_code_from_linear(linear.x), srgb_code_from_linear(linear.y), srgb_code_from_linear(linear.z), 255};
}

Rgba8 grey(double height) {
  const auto code = static_cast<std::uint8_t>(std::lround(255 * std::clamp(height, 0.0, 1.0)));
  return {code, code, code, 255};
}

/// pixel_at: of (u, v) at the pixels' centres.
template <class PixelAt>
Image<Rgba8> image_of(int width, int height, const PixelAt& pixel_at) {
  Image<Rgba8> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = pixel_at((x + 0.5) / width, (y + 0.5) / height);
  return image;
}

double step_up(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Six octaves of noise, each half as high and twice as fine.
double fractal(const glm::dvec3& p, std::uint32_t seed) {
  double sum = 0, scale = 1;
  for (std::uint32_t octave = 0; octave < 6; ++octave, scale *= 2) sum += gradient_noise(p * scale, seed + octave) / scale;
  return sum;
}

struct PlanetPlace {
  double land;      // height above the sea, below 0 under it
  double ice;       // 0 to 1
  double dryness;   // 0 to 1
};

PlanetPlace planet_place(double u, double v, std::uint32_t seed) {
  const double longitude = 2 * std::numbers::pi * u, polar = std::numbers::pi * v;
  const glm::dvec3 p{std::sin(polar) * std::cos(longitude), std::cos(polar), -std::sin(polar) * std::sin(longitude)};
  const double rough = fractal(p * 6.0, seed + 20);
  const double ice_from = 0.93 + 0.08 * rough;  // sine of the latitude
  return {fractal(p * 1.7, seed) - 0.04, step_up(ice_from, ice_from + 0.03, std::abs(p.y)),
          step_up(-0.1, 0.25, fractal(p * 2.5, seed + 40) + 0.25 * (1 - 3 * std::abs(std::abs(p.y) - 0.4)))};
}

double mountain_height(const PlanetPlace& at) { return std::clamp(at.land * 1.6, 0.0, 1.0) * (1 - at.ice); }

/// Where a point of a brick wall lies: which brick, and how far within its rim, in courses; below 0 in mortar.
struct BrickPlace {
  std::int32_t column, course;
  double inside;
};

BrickPlace brick_place(double u, double v, int courses) {
  constexpr double kHalfMortar = 0.06;
  const double course = std::floor(v * courses), row = v * courses - course;
  const double along = u * courses / 2 + (static_cast<int>(course) % 2 == 0 ? 0.0 : 0.5), column = std::floor(along);
  const double across = 2 * (along - column);  // bricks are two courses long
  const double rim = std::min({row, 1 - row, across, 2 - across});
  return {static_cast<std::int32_t>(column) % std::max(courses / 2, 1), static_cast<std::int32_t>(course), rim - kHalfMortar};
}

}  // namespace

Image<Rgba8> pattern_image(const Pattern& pattern, int width, int height) {
  return image_of(width, height, [&](double u, double v) {
    return srgb_codes(pattern_colour(pattern, {.texcoord = {u, v}, .world = {u, 1 - v, 0}, .texcoord_width = {1.0 / width, 1.0 / height}}));
  });
}

Image<Rgba8> planet_image(int width, int height, std::uint32_t seed) {
  const glm::dvec3 deep(0.01, 0.05, 0.22), shallow(0.05, 0.25, 0.42), green(0.06, 0.22, 0.04), dry(0.48, 0.34, 0.14), high(0.32, 0.26, 0.2), ice(0.85, 0.9, 0.95);
  return image_of(width, height, [&](double u, double v) {
    const PlanetPlace at = planet_place(u, v, seed);
    const glm::dvec3 sea = glm::mix(deep, shallow, step_up(-0.15, 0, at.land));
    const glm::dvec3 land = glm::mix(glm::mix(green, dry, at.dryness), high, step_up(0.22, 0.45, at.land));
    return srgb_codes(glm::mix(at.land < 0 ? sea : land, ice, at.ice));
  });
}

Image<Rgba8> planet_height_image(int width, int height, std::uint32_t seed) {
  return image_of(width, height, [&](double u, double v) { return grey(mountain_height(planet_place(u, v, seed))); });
}

Image<Rgba8> brick_image(int width, int height, int courses, std::uint32_t seed) {
  const glm::dvec3 mortar(0.5, 0.48, 0.44), pale(0.42, 0.14, 0.07), dark(0.22, 0.05, 0.03);
  return image_of(width, height, [&](double u, double v) {
    const BrickPlace at = brick_place(u, v, courses);
    const double shade = (lattice_hash(at.column, at.course, 0, seed) & 1023) / 1023.0;
    const double grain = gradient_noise({u * courses * 6, v * courses * 6, 0}, seed);
    return srgb_codes((at.inside < 0 ? mortar : glm::mix(dark, pale, shade)) * (1 + 0.25 * grain));
  });
}

Image<Rgba8> brick_height_image(int width, int height, int courses) {
  return image_of(width, height, [&](double u, double v) { return grey(step_up(0, 0.12, brick_place(u, v, courses).inside)); });
}

Image<Rgba8> stud_height_image(int width, int height, int count) {
  return image_of(width, height, [&](double u, double v) {
    const double x = u * count - std::floor(u * count) - 0.5, y = v * count - std::floor(v * count) - 0.5;
    const double inside = std::max(0.0, 1 - (x * x + y * y) / (0.35 * 0.35));
    return grey(inside * (2 - inside));
  });
}

Image<Rgba8> normal_image(const Image<Rgba8>& heights, double relief) {
  Image<Rgba8> normals(heights.width(), heights.height());
  const auto height = [&](int x, int y) {
    return heights.at((x + heights.width()) % heights.width(), (y + heights.height()) % heights.height()).r / 255.0 * relief * heights.width();
  };
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x) {
      const glm::dvec3 n = glm::normalize(glm::dvec3((height(x - 1, y) - height(x + 1, y)) / 2, (height(x, y + 1) - height(x, y - 1)) / 2, 1));
      const auto code = [](double c) { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * c)); };
      normals.at(x, y) = {code(n.x), code(n.y), code(n.z), 255};
    }
  return normals;
}

}  // namespace tuberia
