// The oracle's textures against cases whose answers are known.             [rules 3] in docs/sources.md

#include <catch2/catch.hpp>

#include "reference/oracle/cube.hpp"
#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {
namespace {

/// Whether the bounds are narrow and hold the number, of codes.
bool is_code(Interval bounds, double code) {
  return 255 * bounds.low <= code + 1e-9 && 255 * bounds.high >= code - 1e-9 && 255 * (bounds.high - bounds.low) < 1e-2;
}

Texture grey_row(const std::vector<std::uint8_t>& codes, bool is_srgb = false, bool has_mipmaps = false) {
  Texture texture;
  texture.kind = TextureKind::one_dimensional;
  texture.width = static_cast<int>(codes.size());
  texture.is_srgb = is_srgb;
  texture.has_mipmaps = has_mipmaps;
  for (const std::uint8_t code : codes) texture.texels.push_back({code, code, code, 255});
  complete(texture);
  return texture;
}

Interval read_at(const Texture& texture, double u, TexelFilter filter, Wrap wrap) {
  Sampler sampler;
  sampler.texels = filter;
  sampler.wrap_u = wrap;
  return sample(texture, sampler, {u, 0.0, 0.0, 0.0})[0];
}

TEST_CASE("oracle: a ramp of four texels, filtered", "[reference]") {
  const Texture ramp = grey_row({0, 85, 170, 255});
  const auto at = [&](double u, Wrap wrap) { return read_at(ramp, u, TexelFilter::bilinear, wrap); };
  CHECK(is_code(at(1.0 / 4, Wrap::repeat), 42.5));
  CHECK(is_code(at(1.0 / 3, Wrap::repeat), 70.8333333333));
  CHECK(is_code(at(1.0 / 2, Wrap::repeat), 127.5));
  CHECK(is_code(at(-1.0 / 16, Wrap::repeat), 191.25));
  CHECK(is_code(at(-1.0 / 16, Wrap::clamp), 0));
  CHECK(is_code(at(17.0 / 16, Wrap::repeat), 63.75));
  CHECK(is_code(at(17.0 / 16, Wrap::clamp), 255));
  CHECK(is_code(at(3.0 / 2, Wrap::clamp), 255));
  CHECK(is_code(at(3.0 / 2, Wrap::mirror), 127.5));
  CHECK(is_code(at(0, Wrap::repeat), 127.5));
}

TEST_CASE("oracle: five texels, the nearest one", "[reference]") {
  const Texture row = grey_row({0, 1, 2, 3, 4});
  const auto reads = [&](double u, double repeat, double clamp, double mirror) {
    return is_code(read_at(row, u, TexelFilter::nearest, Wrap::repeat), repeat) &&
           is_code(read_at(row, u, TexelFilter::nearest, Wrap::clamp), clamp) &&
           is_code(read_at(row, u, TexelFilter::nearest, Wrap::mirror), mirror);
  };
  CHECK(reads(-0.1, 4, 0, 0));
  CHECK(reads(-0.999, 0, 0, 4));
  CHECK(reads(1.1, 0, 4, 4));
  CHECK(reads(-2.5, 2, 0, 2));
}

TEST_CASE("oracle: the bounds of a point between two texels hold both", "[reference]") {
  const Texture row = grey_row({10, 200});
  const Interval between = read_at(row, 0.5, TexelFilter::nearest, Wrap::clamp);
  CHECK(255 * between.low <= 10);
  CHECK(255 * between.high >= 200);
}

TEST_CASE("oracle: smaller levels are means of light, and lose no texel", "[reference]") {
  const auto smallest = [](const Texture& texture) { return texture.levels.back().texels[0][0]; };
  CHECK(is_code(smallest(grey_row({0, 254}, false, true)), 127));
  const double light = std::pow((188 / 255.0 + 0.055) / 1.055, 2.4);  // of the sRGB code nearest to the mean of black and white
  CHECK(is_code(smallest(grey_row({0, 255}, true, true)), 255 * light));
  CHECK(is_code(smallest(grey_row({0, 90, 30}, false, true)), 40));
}

TEST_CASE("oracle: directions and the faces of a cube", "[reference]") {
  const auto meets = [](double x, double y, double z, int face, double s, double t) {
    const std::vector<CubeFace> faces = faces_of({x, y, z});
    return faces.size() == 1 && faces[0].number == face && std::abs(faces[0].s.low - s) < 1e-5 && std::abs(faces[0].t.low - t) < 1e-5;
  };
  CHECK(meets(1, 1, 1, 4, 1, 0));
  CHECK(meets(1, 1, 0, 2, 1, 0.5));
  CHECK(meets(1, 0, 1, 4, 1, 0.5));
  CHECK(meets(-1, -1, -1, 5, 1, 1));
  CHECK(meets(1, 2, 3, 4, 2.0 / 3, 1.0 / 6));
  CHECK(meets(-3, 1, 2, 1, 5.0 / 6, 1.0 / 3));
  CHECK(meets(1e-30, 2e-30, -3e-30, 5, 1.0 / 3, 1.0 / 6));
  CHECK(faces_of({Interval{0.9, 1.1}, 0.0, 1.0}).size() == 2);
}

}  // namespace
}  // namespace tuberia::oracle
