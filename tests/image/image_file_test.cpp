// Images into files and back, and what is refused on the way.

#include <catch2/catch.hpp>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <limits>
#include <string>

#include "image/read_image.hpp"
#include "image/write_image.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

namespace fs = std::filesystem;

/// Every code in every component, and an alpha that varies.
Image<Rgba8> patterned_image(int width, int height) {
  Image<Rgba8> image(width, height);
  std::uint32_t state = 12345;
  for (Rgba8& pixel : image.pixels()) {
    state = state * 1664525u + 1013904223u;
    pixel = {static_cast<std::uint8_t>(state >> 24), static_cast<std::uint8_t>(state >> 16),
             static_cast<std::uint8_t>(state >> 8), static_cast<std::uint8_t>(state >> 12)};
  }
  return image;
}

std::string truncated_to(const std::string& content, double part) {
  return content.substr(0, static_cast<std::size_t>(static_cast<double>(content.size()) * part));
}

}  // namespace

TEST_CASE("image: a lossless format gives back every code", "[image]") {
  const TemporaryFolder folder("with spaces");
  const auto [width, height] =
      GENERATE(std::pair{1, 1}, std::pair{3, 2}, std::pair{37, 19}, std::pair{256, 130});
  const Image<Rgba8> image = patterned_image(width, height);
  for (const char* extension : {"png", "tga", "bmp", "PNG", "ppm"}) {
    const fs::path path = folder / (std::string("my image.") + extension);
    REQUIRE(write_image(path, image).ok());
    const Result<Image<Rgba8>> back = read_image(path);
    CAPTURE(extension);
    REQUIRE(back.ok());
    Image<Rgba8> expected = image;
    if (std::string(extension) == "ppm") {
      for (Rgba8& pixel : expected.pixels()) pixel.a = 255;
    }
    CHECK(*back == expected);
  }
}

TEST_CASE("image: PGM and PPM of any code range read as 8-bit codes", "[image]") {
  const TemporaryFolder folder;
  const Result<Image<Rgba8>> grey =
      read_image(folder.write("a.pgm", "P5 # a comment\n2 1\n15\n\x0f\x05"));
  REQUIRE(grey.ok());
  CHECK(grey->at(0, 0) == Rgba8{255, 255, 255, 255});
  CHECK(grey->at(1, 0) == Rgba8{85, 85, 85, 255});
  const Result<Image<Rgba8>> deep =
      read_image(folder.write("b.ppm", std::string("P6 1 1 65535\n\xff\xff\x80\x80\0\0", 19)));
  REQUIRE(deep.ok());
  CHECK(deep->at(0, 0) == Rgba8{255, 128, 0, 255});
  CHECK(!read_image(folder.write("c.ppm", std::string("P6 1 1 65535\n\xff\xff\x80\x80\0", 18))).ok());
  CHECK(!read_image(folder.write("d.ppm", "P6 1 1 70000\nxxxxxx")).ok());
}

TEST_CASE("image: a JPEG whose Huffman table claims too many codes is refused", "[image]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "whole.jpg", Image<Rgba8>(16, 16)).ok());
  std::string content = folder.read("whole.jpg");
  const std::size_t table = content.find("\xff\xc4");
  REQUIRE(table != std::string::npos);
  // 16 counts of codes follow the marker, the length and the class.
  content.replace(table + 5, 16, std::string(16, '\xff'));
  const Result<Image<Rgba8>> image = read_image(folder.write("bad.jpg", content));
  REQUIRE(!image.ok());
  CHECK(one_line_naming(image.error().message, "Huffman"));
}

TEST_CASE("image: JPEG keeps size and roughly the colour", "[image]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "a.jpg", Image<Rgba8>(50, 30, {200, 100, 50, 255})).ok());
  const Result<Image<Rgba8>> back = read_image(folder / "a.jpg");
  REQUIRE(back.ok());
  REQUIRE(back->width() == 50);
  REQUIRE(back->height() == 30);
  CHECK(std::abs(back->at(20, 20).r - 200) <= 3);
  CHECK(std::abs(back->at(20, 20).b - 50) <= 3);
}

TEST_CASE("image: PFM gives back every bit and keeps the upper row above", "[image]") {
  const TemporaryFolder folder;
  Image<Rgba32F> image(3, 2);
  image.at(0, 0) = {1.5f, -0.0f, std::numeric_limits<float>::denorm_min(), 1};
  image.at(2, 1) = {std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity(), 1e-20f, 1};
  REQUIRE(write_image(folder / "a.pfm", image).ok());
  const Result<Image<Rgba32F>> back = read_float_image(folder / "a.pfm");
  REQUIRE(back.ok());
  CHECK(*back == image);
  CHECK(std::signbit(back->at(0, 0).g));

  Image<float> depth(4, 3, 0.25f);
  depth.at(3, 0) = 0.75f;
  REQUIRE(write_image(folder / "depth.pfm", depth).ok());
  const Result<Image<Rgba32F>> grey = read_float_image(folder / "depth.pfm");
  REQUIRE(grey.ok());
  CHECK(grey->at(3, 0) == Rgba32F{0.75f, 0.75f, 0.75f, 1});
  CHECK(grey->at(0, 2) == Rgba32F{0.25f, 0.25f, 0.25f, 1});
}

TEST_CASE("image: PFM of the other byte order reads the same", "[image]") {
  const TemporaryFolder folder;
  const fs::path path =
      folder.write("big.pfm", std::string("Pf\n1 1\n1.0\n") + '\x3f' + '\xc0' + '\0' + '\0');
  const Result<Image<Rgba32F>> image = read_float_image(path);
  REQUIRE(image.ok());
  CHECK(image->at(0, 0).r == 1.5f);
}

TEST_CASE("image: HDR keeps intensities within 1 percent and survives NaN", "[image]") {
  const TemporaryFolder folder;
  Image<Rgba32F> image(20, 2, {0.5f, 100.0f, 40.0f, 1});
  image.at(1, 1) = {std::numeric_limits<float>::quiet_NaN(), -3.0f,
                    std::numeric_limits<float>::infinity(), 1};
  REQUIRE(write_image(folder / "a.hdr", image).ok());
  const Result<Image<Rgba32F>> back = read_float_image(folder / "a.hdr");
  REQUIRE(back.ok());
  CHECK(back->at(0, 0).g == Approx(100.0f).epsilon(0.01));
  CHECK(back->at(0, 0).r == Approx(0.5f).margin(1.0));
  CHECK(back->at(1, 1).r == 0.0f);
  CHECK(back->at(1, 1).b == Approx(1e38f).epsilon(0.01));
}

TEST_CASE("image: depths become grey codes, clamped, NaN black", "[image]") {
  const TemporaryFolder folder;
  Image<float> depth(5, 1);
  depth.at(0, 0) = -1.0f;
  depth.at(1, 0) = 0.5f;
  depth.at(2, 0) = 1.0f;
  depth.at(3, 0) = 7.0f;
  depth.at(4, 0) = std::numeric_limits<float>::quiet_NaN();
  REQUIRE(write_image(folder / "depth.png", depth).ok());
  const Result<Image<Rgba8>> back = read_image(folder / "depth.png");
  REQUIRE(back.ok());
  const int expected[] = {0, 128, 255, 255, 0};
  for (int x = 0; x < 5; ++x) CHECK(back->at(x, 0).r == expected[x]);
}

TEST_CASE("image: a truncated PNG is refused and named, as is every other format", "[image]") {
  const TemporaryFolder folder;
  const Image<Rgba8> image = patterned_image(61, 47);
  const std::string extension = GENERATE("png", "tga", "bmp", "ppm", "jpg");
  REQUIRE(write_image(folder / ("whole." + extension), image).ok());
  REQUIRE(read_image(folder / ("whole." + extension)).ok());
  const std::string content = folder.read("whole." + extension);
  for (const double part : {0.001, 0.01, 0.1, 0.5, 0.9, 0.99}) {
    CAPTURE(extension, part);
    const fs::path path = folder.write("cut." + extension, truncated_to(content, part));
    const Result<Image<Rgba8>> cut = read_image(path);
    REQUIRE(!cut.ok());
    CHECK(one_line_naming(cut.error().message, "cut." + extension));
  }
}

TEST_CASE("image: a PNG short of any number of bytes is refused", "[image]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "whole.png", patterned_image(9, 7)).ok());
  const std::string content = folder.read("whole.png");
  // The last four bytes are a checksum, which tells nothing of the image.
  for (std::size_t size = 0; size + 4 < content.size(); ++size) {
    CAPTURE(size, content.size());
    CHECK(!read_image(folder.write("cut.png", content.substr(0, size))).ok());
  }
}

TEST_CASE("image: truncated float images are refused and named", "[image]") {
  const TemporaryFolder folder;
  const std::string extension = GENERATE("pfm", "hdr");
  REQUIRE(
      write_image(folder / ("whole." + extension), Image<Rgba32F>(31, 17, {0.5f, 2.0f, 3.0f, 1})).ok());
  const std::string content = folder.read("whole." + extension);
  for (const double part : {0.01, 0.1, 0.5, 0.9}) {
    CAPTURE(extension, part);
    const Result<Image<Rgba32F>> cut =
        read_float_image(folder.write("cut." + extension, truncated_to(content, part)));
    REQUIRE(!cut.ok());
    CHECK(one_line_naming(cut.error().message, "cut." + extension));
  }
}

TEST_CASE("image: what is no image is refused with its reason", "[image]") {
  const TemporaryFolder folder;
  const auto refused = [](const fs::path& path, const std::string& reason) {
    const Result<Image<Rgba8>> image = read_image(path);
    const Result<Image<Rgba32F>> float_image = read_float_image(path);
    REQUIRE(!image.ok());
    REQUIRE(!float_image.ok());
    CAPTURE(image.error().message);
    CHECK(one_line_naming(image.error().message, reason));
    CHECK(one_line_naming(image.error().message, path.filename().string()));
    CHECK(one_line_naming(float_image.error().message, path.filename().string()));
  };
  refused(folder / "missing.png", "no such file");
  refused(folder / "", "it is a folder");
  refused(folder.write("empty.png", ""), "the file is empty");
  refused(folder.write("text.png", "This is no image.\n"), "unknown image format");
  refused(folder.write("long.png", std::string(5000, 'x')), "unknown image format");
  refused(folder.write("tiny.png", "\x89"), "tiny.png");
  refused(folder.write("huge.ppm", "P6\n30000 8000\n255\n\1\2\3"), "30000x8000");
  refused(folder.write("absurd.ppm", "P6\n100000 100000\n255\n\1\2\3"), "absurd.ppm");
  refused("/dev/null", "it is not a regular file");
}

TEST_CASE("image: a PFM with an absurd header is refused", "[image]") {
  const TemporaryFolder folder;
  for (const char* header :
       {"PF\n", "PF\n4", "PF\n-4 4\n-1\n", "PF\n4 4\n0\n", "PF\n4 4\nnan\n", "PF\n99999 99999\n-1\n",
        "PF\n30000 8000\n-1\n", "PF\n4444444444444 4\n-1\n", "PF x y\n-1\n"}) {
    CAPTURE(header);
    const Result<Image<Rgba32F>> image = read_float_image(folder.write("bad.pfm", header));
    REQUIRE(!image.ok());
    CHECK(one_line_naming(image.error().message, "bad.pfm"));
  }
}

TEST_CASE("image: a decoded image in memory is refused under the name it was given", "[image]") {
  const Result<Image<Rgba8>> none = decode_image({}, "texture *0");
  REQUIRE(!none.ok());
  CHECK(one_line_naming(none.error().message, "texture *0"));
}

TEST_CASE("image: writing refuses bad targets, names them and leaves no file behind", "[image]") {
  const TemporaryFolder folder;
  const Image<Rgba8> image = patterned_image(4, 4);
  const auto refused = [&](const fs::path& path, const std::string& culprit) {
    const Result<Nothing> result = write_image(path, image);
    REQUIRE(!result.ok());
    CAPTURE(result.error().message);
    CHECK(one_line_naming(result.error().message, culprit));
  };
  refused(folder / "a.gifv", "unknown extension '.gifv'; supported: .png");
  refused(folder / "noextension", "no extension");
  refused(folder / "missing folder/a.png", "missing folder");
  refused(folder / (std::string(400, 'n') + ".png"), "too long");
  refused("", "no extension");
  refused("/dev/null.png/a.png", "/dev/null.png");
  CHECK(folder.file_count() == 0);

  fs::create_directory(folder / "folder.png");
  refused(folder / "folder.png", "it is a folder");
  CHECK(folder.file_count() == 1);
  CHECK(!write_image(folder / "a.png", Image<Rgba8>()).ok());
  CHECK(!write_image(folder / "a.png", Image<Rgba32F>(2, 2)).ok());
  CHECK(!write_image(folder / "a.hdr", Image<float>(2, 2)).ok());
  CHECK(folder.file_count() == 1);
}

TEST_CASE("image: a disk that fills up leaves the old file whole", "[image]") {
  const TemporaryFolder folder;
  const Image<Rgba8> old_image = patterned_image(4, 4);
  REQUIRE(write_image(folder / "a.ppm", old_image).ok());
  const std::string old_content = folder.read("a.ppm");

  // A limit on the size of files stands for a full disk.
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limited = before;
  limited.rlim_cur = 10000;
  const bool is_limited = setrlimit(RLIMIT_FSIZE, &limited) == 0;
  const Result<Nothing> result = write_image(folder / "a.ppm", patterned_image(200, 200));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);

  REQUIRE(is_limited);
  REQUIRE(!result.ok());
  CHECK(one_line_naming(result.error().message, "a.ppm"));
  CHECK(folder.read("a.ppm") == old_content);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("image: writing replaces the old file, through a link too", "[image]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "a.png", patterned_image(4, 4)).ok());
  fs::create_symlink(folder / "a.png", folder / "link.png");
  const Image<Rgba8> newer = patterned_image(5, 6);
  REQUIRE(write_image(folder / "link.png", newer).ok());
  CHECK(fs::is_symlink(folder / "link.png"));
  CHECK(read_image(folder / "a.png")->width() == 5);
  CHECK(folder.file_count() == 2);
}

}  // namespace tuberia
