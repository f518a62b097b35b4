// Whose decoder reads PNG files.

#include <catch2/catch.hpp>

#include "image/read_image.hpp"
#include "image/write_image.hpp"
#include "tests/image/temporary_folder.hpp"

using namespace tuberia;

TEST_CASE("image: an unknown chunk of a PNG is refused in one line, without quoting its bytes", "[image]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "whole.png", Image<Rgba8>(4, 4, {1, 2, 3, 255})));
  std::string content = folder.read("whole.png");
  // After the signature (8 bytes) and the header (25): an empty chunk that a reader must know.
  constexpr std::size_t kAfterHeader = 33;
  content.insert(kAfterHeader, std::string("\0\0\0\0", 4) + "\nQ\x7f\xe4" + "sums");
  const auto refused = read_image(folder.write("odd.png", content));
  REQUIRE_FALSE(refused);
  CAPTURE(refused.error().message);
  CHECK(one_line_naming(refused.error().message, "odd.png"));
  CHECK(refused.error().message.find("unknown PNG chunk type") != std::string::npos);
}
