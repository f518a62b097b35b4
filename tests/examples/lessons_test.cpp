// The numbered lessons: each runs, and its picture shows what it is about.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "image/read_image.hpp"
#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

/// Runs a lesson and gives its picture.
Image<Rgba8> picture_of_lesson(const char* lesson, const char* file) {
  const TemporaryFolder folder;
  const std::string program = std::string(PROGRAMS_FOLDER) + "/lesson_" + lesson;
  const test::Outcome outcome = test::run_program("", folder, program.c_str());
  INFO(lesson << ": " << outcome.output);
  REQUIRE(outcome.status == 0);
  const auto image = read_image(folder / "out" / file);
  REQUIRE(image.ok());
  return *image;
}

int brightness(const Rgba8& pixel) { return pixel.r + pixel.g + pixel.b; }

/// The colours that occur in the columns [left, right).
std::set<int> colours_between(const Image<Rgba8>& image, int left, int right) {
  std::set<int> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = left; x < right; ++x) colours.insert(image.at(x, y).r << 16 | image.at(x, y).g << 8 | image.at(x, y).b);
  return colours;
}

int brightest_between(const Image<Rgba8>& image, int left, int right) {
  int brightest = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = left; x < right; ++x) brightest = std::max(brightest, brightness(image.at(x, y)));
  return brightest;
}

/// The mean squared difference of neighbours in some rows.
double roughness(const Image<Rgba8>& image, int left, int right, int top, int bottom) {
  double sum = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x + 1 < right; ++x) sum += std::pow(image.at(x + 1, y).g - image.at(x, y).g, 2);
  return sum / ((bottom - top) * (right - left - 1));
}

}  // namespace

TEST_CASE("lesson 1: the stages, one by one", "[examples]") {
  const TemporaryFolder folder;
  const test::Outcome stages = test::run_program("", folder, PROGRAMS_FOLDER "/lesson_01_one_triangle_stage_by_stage");
  CHECK(stages.status == 0);
  CHECK(stages.output.find("9 Blending") != std::string::npos);
  CHECK(read_image(folder / "out/one_triangle.png").ok());
}

TEST_CASE("lesson 2: rings of two colours, the sky untouched", "[examples]") {
  const auto ripples = picture_of_lesson("02_your_own_program", "ripples.png");
  int dark = 0, light = 0;
  for (const Rgba8& pixel : ripples.pixels()) {
    dark += pixel.a == 255 && pixel.r < 60 && pixel.b > 90;
    light += pixel.a == 255 && pixel.r > 230;
  }
  CHECK(dark > 10000);
  CHECK(light > 10000);
  CHECK(ripples.at(320, 5).a == 0);
}

TEST_CASE("lesson 3: ambient light is flat, highlights narrow", "[examples][B06]") {
  const auto image = picture_of_lesson("03_a_lit_sphere", "a_lit_sphere.png");
  CHECK(colours_between(image, 90, 150).size() <= 6);  // the disc, the background and what four samples make between them
  CHECK(colours_between(image, 300, 380).size() > 100);
  CHECK(brightest_between(image, 680, 880) > brightest_between(image, 250, 440) + 100);
  const auto bright_pixels = [&](int left, int right) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = left; x < right; ++x) count += brightness(image.at(x, y)) > 620;
    return count;
  };
  CHECK(bright_pixels(460, 660) > 3 * bright_pixels(680, 880));
  CHECK(bright_pixels(680, 880) > 100);
}

TEST_CASE("lesson 4: facets have few colours, Phong the brightest highlight", "[examples][B21][B28]") {
  const auto image = picture_of_lesson("04_flat_gouraud_phong", "flat_gouraud_phong.png");
  CHECK(colours_between(image, 0, 300).size() < colours_between(image, 300, 600).size());
  CHECK(brightest_between(image, 600, 900) > brightest_between(image, 300, 600) + 50);
}

TEST_CASE("lesson 5: mipmaps calm the distance and leave what is near", "[examples][A01][A05]") {
  const auto image = picture_of_lesson("05_textures_and_mipmaps", "textures_and_mipmaps.png");
  int horizon = 0;
  while (image.at(10, horizon) == image.at(10, 0)) ++horizon;
  CHECK(roughness(image, 0, 300, horizon, horizon + 8) > 10 * roughness(image, 300, 600, horizon, horizon + 8));
  CHECK(roughness(image, 600, 900, horizon + 8, horizon + 16) > roughness(image, 300, 600, horizon + 8, horizon + 16));
  for (const auto& [x, y] : {std::pair{60, 290}, {200, 280}}) CHECK(image.at(x, y) == image.at(x + 300, y));
}

TEST_CASE("lesson 6: relief changes the inside, never the outline", "[examples][B41]") {
  const auto image = picture_of_lesson("06_bump_mapping", "bump_mapping.png");
  // The spheres stand symmetrically, so those at the ends are mirror images in outline, as are the two in the middle: but for the
  // samples within a pixel, which are no mirror images. Relief that moved the outline would move it by three pixels, all around.
  const Rgba8 background = image.at(0, 0);
  int differing = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < 450; ++x) differing += (image.at(x, y) == background) != (image.at(899 - x, y) == background);
  CHECK(differing < 100);
  const double smooth = roughness(image, 60, 180, 80, 170);
  for (const int left : {280, 500, 720}) CHECK(roughness(image, left, left + 120, 80, 170) > 3 * smooth);
}

TEST_CASE("lesson 7: the teapot mirrors the sky", "[examples][A35]") {
  const auto image = picture_of_lesson("07_environment", "environment.png");
  CHECK(image.at(360, 260).a == 255);
  CHECK(colours_between(image, 250, 470).size() > 1000);
}

TEST_CASE("lesson 8: what the lamp does not see is dark", "[examples][A18]") {
  const auto image = picture_of_lesson("08_shadows_in_two_passes", "shadows_in_two_passes.png");
  // The floor far to the left is lit; somewhere in the lower middle it lies in the ring's shadow, with ambient light alone.
  std::vector<int> row;
  for (int x = 0; x < image.width(); ++x) row.push_back(brightness(image.at(x, 330)));
  CHECK(*std::min_element(row.begin(), row.end()) < row[40] / 2);
}

TEST_CASE("lesson 9: the teapot with all of it", "[examples][A36]") {
  const auto image = picture_of_lesson("09_the_teapot", "the_teapot.png");
  CHECK(image.width() == 960);
  CHECK(colours_between(image, 0, 960).size() > 10000);
}

TEST_CASE("lesson 10: rays see shadows, mirrors and glass", "[examples]") {
  const auto image = picture_of_lesson("10_a_ray_tracer_in_a_page", "a_ray_tracer_in_a_page.png");
  const auto bluish = [](const Rgba8& pixel) { return pixel.b - pixel.r; };
  CHECK(bluish(image.at(170, 125)) > 15);  // the mirror shows the sky above
  CHECK(bluish(image.at(320, 300)) > 5);   // and the glass ball, which turns everything round, the sky below
  CHECK(image.at(500, 240).r > image.at(500, 240).b + 50);  // the ring
  // A dark square of the floor in the shadow of the glass ball, and one in the light.
  CHECK(3 * brightness(image.at(410, 300)) < 2 * brightness(image.at(60, 350)));
}

TEST_CASE("lesson 11: figures 47 and 48 in numbers, and rings that are not there", "[examples][B68][B72][B73]") {
  const TemporaryFolder folder;
  const test::Outcome lesson = test::run_program("", folder, PROGRAMS_FOLDER "/lesson_11_samples_of_a_pixel");
  CHECK(lesson.status == 0);

  // Samples at sixths of a pixel: 2 y > 1.03 + x counted in whole numbers.
  std::string table;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      int covered = 0;
      for (int part = 0; part < 9; ++part) covered += 200 * (6 * y + 2 * (part / 3) + 1) > 618 + 100 * (6 * x + 2 * (part % 3) + 1);
      table.append(" ").append(std::to_string(covered)).append("/9");
    }
    table += "\n";
  }
  INFO(lesson.output);
  CHECK(lesson.output.find(table) != std::string::npos);
  CHECK(lesson.output.find("62 rays where contrast asks for them, 117 everywhere, same picture") != std::string::npos);

  // One sample draws the centre's rings again where a pixel holds one whole ring; sixteen leave them grey; random ones are noise.
  const auto image = read_image(folder / "out/samples_of_a_pixel.png");
  REQUIRE(image.ok());
  int difference = 0;  // of the centre's rings and those at the left border, where they are a negative
  for (int x = 0; x < 10; ++x) difference += std::abs(image->at(x, 128).g - image->at(128 + x, 128).g);
  CHECK(difference / 10 > 150);
  CHECK(roughness(*image, 512, 522, 100, 156) > 4 * roughness(*image, 0, 10, 100, 156));
  CHECK(roughness(*image, 256, 266, 100, 156) < 0.1 * roughness(*image, 0, 10, 100, 156));
}

}  // namespace tuberia
