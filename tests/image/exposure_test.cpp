#include "image/exposure.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace tuberia {

// notes 15.8: the other two ways to handle overflow are the target's clamp and the surface program's.
TEST_CASE("exposure: the whole image is scaled by its maximum", "[image][B16]") {
  Image<Rgba32F> image(2, 1);
  image.at(0, 0) = {1.6f, 0.8f, 0.4f, 0.5f};
  image.at(1, 0) = {0.1f, 2, 0, 1};
  CHECK(scale_to_range(image) == 2);
  CHECK(image.at(0, 0) == Rgba32F{0.8f, 0.4f, 0.2f, 0.5f});
  CHECK(image.at(1, 0) == Rgba32F{0.05f, 1, 0, 1});
  const Image<Rgba32F> in_range = image;
  CHECK(scale_to_range(image) == 1);
  CHECK(image == in_range);
}

TEST_CASE("exposure: what is not finite is no maximum", "[image]") {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  Image<Rgba32F> image(2, 1);
  image.at(0, 0) = {infinity, nan, 4, 1};
  image.at(1, 0) = {-8, 1, 0, 99};
  CHECK(largest_channel(image) == 4);
  CHECK(scale_to_range(image) == 4);
  CHECK(image.at(0, 0).r == infinity);
  CHECK(image.at(0, 0).b == 1);
  CHECK(image.at(1, 0) == Rgba32F{-2, 0.25f, 0, 99});
  CHECK(largest_channel(Image<Rgba32F>{}) == 0);
}

TEST_CASE("exposure: a factor for all intensities", "[image][C07]") {
  Image<Rgba32F> image(1, 1, {0.25f, 1, 2, 0.5f});
  expose(image, 2);
  CHECK(image.at(0, 0) == Rgba32F{0.5f, 2, 4, 0.5f});
  expose(image, 0);
  CHECK(image.at(0, 0) == Rgba32F{0, 0, 0, 0.5f});
}

}  // namespace tuberia
