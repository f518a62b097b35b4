// What is said about a comparison, by made-up ones.

#include <catch2/catch.hpp>

#include "examples/tuberia/witness/comparison.hpp"

namespace tuberia::witness {
namespace {

constexpr Rgba8 kDrawn{100, 100, 100, 255};

/// Everything is the same but four pixels: an edge, a technique of two causes, several causes, and one that nobody can explain.
Comparison made_up_comparison() {
  Comparison comparison{.title = "Made <up>", .source = "B Figure 0", .file = "made_up.json", .drawn = Image<Rgba8>(20, 10, kDrawn), .traced = Image<Rgba8>(20, 10, kDrawn),
                        .drawn_objects = Image<int>(20, 10, 0), .traced_objects = Image<int>(20, 10, 0), .verdicts = Image<PixelVerdict>(20, 10),
                        .object_names = {"object 0 'ball'"}};
  const auto differ = [&](int x, int y, std::uint8_t code, const PixelVerdict& verdict) {
    comparison.traced.at(x, y) = {code, 100, 100, 255};
    comparison.verdicts.at(x, y) = verdict;
  };
  differ(3, 3, 90, {.differs = true, .explained = true, .causes = Cause::edge});
  differ(4, 3, 97, {.differs = true, .explained = true, .causes = Causes(Cause::environment_map) | Cause::mirror_of_surroundings});
  differ(5, 3, 104, {.differs = true, .explained = true, .causes = Causes(Cause::edge) | Cause::shadow_map});
  differ(6, 3, 0, {.differs = true, .explained = false, .causes = {}});
  comparison.traced_objects.at(3, 3) = -1;
  return comparison;
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("tracer witness: every pixel is counted once, in its class", "[Y5][tracer_witness]") {
  const Counts counts = counts_of(made_up_comparison());
  CHECK(counts.pixels == 200);
  CHECK(counts.other_objects == 1);
  CHECK(counts.same_objects() == Approx(0.995));
  CHECK(counts.largest_difference == 100);
  CHECK(counts.differing() == 4);
  for (const PixelClass pixel_class : {PixelClass::edge, PixelClass::technique, PixelClass::several, PixelClass::unexplained}) CHECK(counts.of(pixel_class) == 1);
  CHECK(counts.of_causes.size() == 3);
}

TEST_CASE("tracer witness: confirmed is what has the same objects and no riddles", "[Y5][tracer_witness]") {
  Comparison comparison = made_up_comparison();
  CHECK_FALSE(is_confirmed(counts_of(comparison)));
  comparison.verdicts.at(6, 3) = {.differs = true, .explained = true, .causes = Cause::mipmap};
  // 99.5 % is not more than 99.5 %.
  CHECK_FALSE(is_confirmed(counts_of(comparison)));
  comparison.traced_objects.at(3, 3) = 0;
  CHECK(is_confirmed(counts_of(comparison)));
}

TEST_CASE("tracer witness: the page needs no other file and says each cause", "[Y5][tracer_witness]") {
  const std::string page = page_of(made_up_comparison());
  CHECK(occurrences(page, "<img src=\"data:image/png;base64,iVBOR") == 4 + 3 * 4);  // the pictures, and three close-ups of each of four pixels
  CHECK(page.find("src=\"http") == std::string::npos);
  CHECK(page.find("Made &lt;up>") != std::string::npos);
  CHECK(page.find("Not confirmed: the same object at 99.500 % of the pixels, 4 pixels differ by more than one code, 1 of them unexplained.") != std::string::npos);
  CHECK(page.find("Pixel (6, 3), in the middle: drawn 100 100 100 (object 0 'ball'), traced 0 100 100 (object 0 'ball').") != std::string::npos);
  CHECK(page.find("(no object)") != std::string::npos);
  for (const char* name : {"edge", "environment map + mirror of the surroundings alone", "edge + shadow-map texel"}) CHECK(page.find(std::string("</span>") + name + "</td>") != std::string::npos);
}

TEST_CASE("tracer witness: remarks are on the page and in the summary", "[Y5][tracer_witness]") {
  Comparison comparison = made_up_comparison();
  comparison.remarks = {"object 0 'ball' is <blended>"};
  CHECK(page_of(comparison).find("<p>object 0 'ball' is &lt;blended></p>") != std::string::npos);
  CHECK(summary_of(comparison).find("  note: object 0 'ball' is <blended>\n") != std::string::npos);
}

TEST_CASE("tracer witness: the summary has a line for each set of causes", "[Y5][tracer_witness]") {
  const std::string summary = summary_of(made_up_comparison());
  CHECK(occurrences(summary, "\n") == 1 + 3 + 3 + 1 + 1);
  CHECK(summary.find("edge + shadow-map texel") != std::string::npos);
  CHECK(summary.find("NOT confirmed") != std::string::npos);
}

}  // namespace tuberia::witness
