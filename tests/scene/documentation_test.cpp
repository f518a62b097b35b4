// What the documents must say.

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string text_of(const char* path) {
  std::ifstream file(path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A page from a heading to the next one.
std::string section_of(const std::string& page, const std::string& heading) {
  const std::size_t begin = page.find("## " + heading);
  REQUIRE(begin != std::string::npos);
  return page.substr(begin, page.find("\n## ", begin) - begin);
}

}  // namespace

TEST_CASE("documentation: what the local model does not cover is said", "[scene][B31]") {
  const std::string left_out = section_of(text_of("docs/surfaces.md"), "What a local model leaves out");
  // Distributed sources, and the four kinds of light that arrives by way of another surface.
  for (const char* path : {"lights of larger extent", "specular-specular", "specular-diffuse", "diffuse-specular", "diffuse-diffuse"}) {
    CAPTURE(path);
    CHECK(left_out.find(path) != std::string::npos);
  }
  CHECK(left_out.find("ambient light stands") != std::string::npos);
}

TEST_CASE("documentation: the three scales of roughness are told apart", "[scene][B38]") {
  const std::string roughness = section_of(text_of("docs/surfaces.md"), "Roughness, three scales of it");
  for (const char* scale : {"Macroscopic", "Microscopic", "Nanometric"}) CHECK(roughness.find(scale) != std::string::npos);
  CHECK(roughness.find("not modelled") != std::string::npos);
}
