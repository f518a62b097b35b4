#include "image/box_filter.hpp"

#include <catch2/catch.hpp>

namespace tuberia {

TEST_CASE("box filter: the mean of each square, in linear light", "[image]") {
  Image<Rgba32F> image(4, 2, {0, 0.25f, -1, 1});
  image.at(0, 0).r = 1;
  image.at(3, 1) = {8, 0.25f, 3, 0};
  const Image<Rgba32F> half = box_filtered(image, 2);
  REQUIRE((half.width() == 2 && half.height() == 1));
  CHECK(half.at(0, 0) == Rgba32F{0.25f, 0.25f, -1, 1});
  CHECK(half.at(1, 0) == Rgba32F{2, 0.25f, 0, 0.75f});
  CHECK(box_filtered(image, 1) == image);
}

TEST_CASE("box filter: a constant stays what it is", "[image]") {
  const Rgba32F constant{0.1f, 0.3f, 1e-20f, 0.7f};
  for (const int factor : {2, 3, 5, 16}) {
    const Image<Rgba32F> filtered = box_filtered(Image<Rgba32F>(factor * 2, factor * 3, constant), factor);
    for (const Rgba32F& pixel : filtered.pixels()) CHECK(pixel == constant);
  }
}

}  // namespace tuberia
