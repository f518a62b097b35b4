// Lesson 11: sampling. A picture asks for light at points and never sees what lies between them. Finer detail comes back as
// something else (aliasing); more points, random points or points chosen where they matter make it better [B 5.8]. No scene is
// needed to see that: anything that tells a colour for a point of the picture will do.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>

#include "image/write_image.hpp"
#include "math/colour.hpp"
#include "reference/ray_tracer/sampling.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using description::Sampling;

// A white polygon over black, whose edge crosses three by two pixels.
glm::dvec3 polygon(const glm::dvec2& point, int /*worker*/) { return glm::dvec3(2 * point.y > 1.03 + point.x ? 1 : 0); }

// Rings that get finer outwards: at 128 pixels from the centre each pixel holds a whole one.
glm::dvec3 zone_plate(const glm::dvec2& point, int /*worker*/) {
  const glm::dvec2 from_centre = point - 128.0;
  return glm::dvec3(0.5 + 0.5 * std::cos(3.14159265358979 / 128 * glm::dot(from_centre, from_centre)));
}

int main() {
  Workers workers;

  // Figure 47: nine samples a pixel, and the box filter counts how many of them see the polygon.
  const SampledPicture nine = sample_picture(polygon, 3, 2, {.per_pixel = 9}, workers);
  std::printf("covered, in ninths:\n");
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) std::printf(" %ld/9", std::lround(9 * nine.light.at(x, y).r));
    std::printf("\n");
  }

  // Figure 48: corners that differ cut an area in four, twice at most. Or everywhere, which is the full grid of 13 x 9 corners.
  Sampling adaptive{.per_pixel = 16, .adaptive = true};
  const SampledPicture some = sample_picture(polygon, 3, 2, adaptive, workers);
  adaptive.contrast = glm::dvec3(-1);
  const SampledPicture all = sample_picture(polygon, 3, 2, adaptive, workers);
  std::printf("%ld rays where contrast asks for them, %ld everywhere, %s\n", static_cast<long>(some.questions), static_cast<long>(all.questions),
              some.light == all.light ? "same picture" : "another picture");

  // Four pictures of the same rings: one sample, sixteen, one at random, and sixteen at random through a Gaussian.
  const auto random = Sampling::Pattern::jittered;
  const Sampling samplings[] = {{}, {.per_pixel = 16}, {.pattern = random}, {.pattern = random, .per_pixel = 16, .filter = Sampling::Filter::gaussian}};
  Image<Rgba8> picture(4 * 256, 256);
  for (int i = 0; i < 4; ++i) {
    const Image<Rgba32F> rings = sample_picture(zone_plate, 256, 256, samplings[i], workers).light;
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const std::uint8_t code = srgb_code_from_linear(rings.at(x, y).r);
        picture.at(256 * i + x, y) = {code, code, code};
      }
  }
  std::filesystem::create_directories("out");
  return write_image("out/samples_of_a_pixel.png", picture) ? 0 : 1;
}
