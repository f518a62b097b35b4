#include <catch2/catch.hpp>

#include "bench/figures/chart.hpp"
#include "bench/figures/page.hpp"

namespace tuberia::bench {
namespace {

std::size_t how_often(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string figure_with_exponent(double exponent) {
  return figure_of(
      {.x = {"triangles"},
       .y = {"ms"},
       .series = {{.name = "a",
                   .points = {{1, 1}, {10, 12}, {100, 130}},
                   .law = PowerLaw{.exponent = exponent, .factor = 1, .standard_error = 0.01, .from = 1, .to = 100}}}});
}

}  // namespace

TEST_CASE("page: numbers keep three digits and separate thousands", "[bench]") {
  CHECK(number_text(0) == "0");
  CHECK(number_text(0.0123456) == "0.0123");
  CHECK(number_text(1.5) == "1.50");
  CHECK(number_text(12.345) == "12.3");
  CHECK(number_text(-1234.5) == "-1,234");
  CHECK(number_text(1234567) == "1,234,567");
  CHECK(count_text(100000000) == "100,000,000");
}

TEST_CASE("page: text cannot become markup", "[bench]") {
  CHECK(escaped("a < b & \"c\"") == "a &lt; b &amp; &quot;c&quot;");
  const Table table{.headings = {"x"}, .rows = {{escaped("<script>")}}};
  CHECK(table.html().find("<script>") == std::string::npos);
}

TEST_CASE("chart: an exponent above 1.05 is marked, one below is not", "[bench]") {
  CHECK(figure_with_exponent(1.049).find("alarm") == std::string::npos);
  const std::string steep = figure_with_exponent(1.06);
  CHECK(steep.find("alarm") != std::string::npos);
  CHECK(steep.find("1.060 ± 0.010") != std::string::npos);
}

TEST_CASE("chart: every point of every series is drawn, inside the picture", "[bench]") {
  const Chart chart{.x = {"scalars", false},
                    .y = {"ns"},
                    .series = {{.name = "a", .points = {{0, 1}, {16, 1000}}}, {.name = "b", .points = {{4, 3}}}}};
  const std::string figure = figure_of(chart);
  CHECK(how_often(figure, "<circle") == 3);
  CHECK(figure.find("nan") == std::string::npos);
  CHECK(figure.find("inf") == std::string::npos);
  CHECK(figure.find("=\"-") == std::string::npos);  // no negative coordinate
}

}  // namespace tuberia::bench
