#include <catch2/catch.hpp>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bench/trade/adviser_table.hpp"
#include "bench/trade/closed_forms.hpp"
#include "bench/trade/plots.hpp"
#include "bench/trade/probes.hpp"
#include "bench/trade/report.hpp"
#include "bench/trade/scenes.hpp"
#include "bench/trade/settings.hpp"
#include "scene/adviser/measured_trade.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr Effort kNoEffort{.seconds = 0, .fewest_rounds = 1};

const Setting& setting_named(const std::vector<Setting>& settings, const std::string& name) {
  for (const Setting& each : settings)
    if (each.name == name) return each;
  FAIL("there is no setting " << name);
  return settings.front();
}

/// The errors of a scene drawn with each of the settings.
std::vector<double> errors_of(const Scene& scene, const std::vector<Setting>& settings) {
  const auto measured = measure(scene, settings, kNoEffort, {.threads = 1});
  REQUIRE(measured.ok());
  std::vector<double> errors;
  for (const Measurement& each : *measured) errors.push_back(each.error);
  return errors;
}

/// Fields of a line of CSV; quoted ones may hold commas.
std::size_t fields_of(const std::string& line) {
  std::size_t count = 1;
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ',' && !is_quoted) ++count;
  }
  CHECK_FALSE(is_quoted);
  return count;
}

Measurement made_up(const std::string& name, double ratio, double error, std::vector<std::size_t> choices) {
  Measurement made{.setting = name,
                   .time = {.median_ms = ratio, .ratio = ratio},
                   .error = error,
                   .to_ideal = {},
                   .to_reference = {}};
  made.to_ideal.rmse_codes = error;
  made.to_reference.rmse_codes = error;
  made.to_ideal.psnr_db = error == 0 ? HUGE_VAL : 40;
  made.choices = std::move(choices);
  return made;
}

TradeResult made_up_result() {
  TradeResult result;
  result.stages.push_back({"filter",
                           "Filters \"all\"",
                           "About <b>them</b>.",
                           "RMSE, codes",
                           {{"filter, of texels",
                             "floor",
                             "a floor",
                             true,
                             {made_up("best", 1, 0, {}), made_up("a \"quick\" one, rather", 0.5, 3, {})}},
                            {"numbers", "square", "no picture", false, {made_up("best", 1, 0, {})}}}});
  result.scenes.push_back({"floor",
                           "a floor",
                           "",
                           {"filter", "samples"},
                           {{"best", "quick"}, {"1", "4"}},
                           {made_up("best + 1", 1, 2, {0, 0}), made_up("best + 4", 3, 0, {0, 1}),
                            made_up("quick + 1", 0.5, 4, {1, 0}), made_up("quick + 4", 3.5, 1, {1, 1})}});
  return result;
}

}  // namespace

TEST_CASE("trade table: names are unique and every switch can be turned", "[bench][trade]") {
  std::set<std::string> stages;
  for (const Stage& stage : all_stages()) {
    CAPTURE(stage.name);
    CHECK(stages.insert(stage.name).second);
    for (const Switch& each : stage.switches) {
      CHECK(each.settings.size() >= 2);
      CHECK_FALSE(each.scenes.empty());
      std::set<std::string> names;
      for (const Setting& setting : each.settings) CHECK(names.insert(setting.name).second);
    }
  }
  std::set<std::string> scenes;
  for (const WholeScene& whole : whole_scenes()) CHECK(scenes.insert(whole.scene.name).second);
  CHECK(scenes.size() >= 6);
}

TEST_CASE("trade table: combinations are all of them once, the reference first", "[bench][trade]") {
  const auto add = [](int amount) {
    return [amount](Recipe& recipe) { recipe.target.width = recipe.target.width * 10 + amount; };
  };
  const std::vector<Switch> switches{{"a", {{"a0", add(1)}, {"a1", add(2)}, {"a2", add(3)}}, {}},
                                     {"b", {{"b0", add(4)}, {"b1", add(5)}}, {}}};
  const std::vector<Combination> all = combinations(switches);
  REQUIRE(all.size() == 6);
  CHECK(all.front().setting.name == "a0 + b0");
  std::set<int> widths;
  for (const Combination& each : all) {
    Recipe recipe;
    recipe.target.width = 0;
    each.setting.apply(recipe);
    widths.insert(recipe.target.width);
    CHECK(each.setting.name ==
          switches[0].settings[each.choices[0]].name + " + " + switches[1].settings[each.choices[1]].name);
  }
  CHECK(widths == std::set<int>{14, 15, 24, 25, 34, 35});
}

TEST_CASE("trade: wrong pixels per edge are those that rounding to the grid makes", "[bench][trade][rules-4]") {
  // 760,000 px of edge: at 8 bits some 570 pixels are wrong, give or take 24.
  const std::vector<Setting> settings = subpixel_settings();
  const std::vector<double> errors = errors_of(
      random_triangles(),
      {setting_named(settings, "8 bits"), setting_named(settings, "4 bits"), setting_named(settings, "0 bits")});
  CHECK(errors[0] == Approx(wrong_pixels_by_rounding(8)).epsilon(0.15));
  CHECK(errors[1] == Approx(wrong_pixels_by_rounding(4)).epsilon(0.05));
  // Whole pixels make some of these triangles vanish, and their edges meet.
  CHECK(errors[2] == Approx(wrong_pixels_by_rounding(0)).epsilon(0.1));
}

TEST_CASE("trade: pairs in the wrong order are as many as their codes say", "[bench][trade][rules-4][case-31]") {
  const std::vector<double> errors = errors_of(depth_pairs(1e-4), depth_format_settings());
  // 16384 pairs: a standard deviation is 0.4 %.
  CHECK(errors[0] == 0);
  CHECK(errors[1] == Approx(100 * misordered_pairs(DepthCoding::float32, 1e-4)).margin(1.6));
  CHECK(errors[3] == Approx(100 * misordered_pairs(DepthCoding::unorm24, 1e-4)).margin(1.6));
  CHECK(errors[4] == Approx(100 * misordered_pairs(DepthCoding::unorm16, 1e-4)).margin(1.6));
}

TEST_CASE("trade: more samples come nearer to the area under an edge", "[bench][trade][rules-4]") {
  const std::vector<double> errors = errors_of(polygon_edges(false), sample_settings());
  CHECK(errors[0] == Approx(0.243).epsilon(0.05));
  CHECK(errors[2] == Approx(0.090).epsilon(0.05));
  for (std::size_t i = 1; i < errors.size(); ++i) CHECK(errors[i] < errors[i - 1]);
}

TEST_CASE("trade: perspective every few pixels errs as the chords between them do", "[bench][trade][rules-4]") {
  for (const double w : {2.0, 10.0}) {
    const std::vector<double> errors = errors_of(receding_texels(w), perspective_settings());
    CHECK(errors[0] < 1e-3);
    CHECK(errors[1] == Approx(texel_error_by_steps(w, 8, 0.5)).epsilon(0.01));
    CHECK(errors[2] == Approx(texel_error_by_steps(w, 16, 0.5)).epsilon(0.01));
    CHECK(errors[3] == Approx(texel_error_by_steps(w, 32, 0.5)).epsilon(0.01));
    CHECK(errors[4] == Approx(texel_error_by_steps(w, 256)).epsilon(0.01));
  }
}

TEST_CASE("trade: edge functions in integers are right, in floats the more wrong the larger",
          "[bench][trade][rules-4]") {
  const std::vector<double> small = errors_of(large_triangles(256), edge_arithmetic_settings()),
                            large = errors_of(large_triangles(1024), edge_arithmetic_settings());
  CHECK(large[0] == 0);
  CHECK(large[1] == 0);
  CHECK(small[2] == 0);  // no edge is longer than the 512 px up to which anchored floats are exact
  CHECK(large[3] > small[3]);
  CHECK(large[3] > large[2]);
}

TEST_CASE("trade: thin layers stall in codes, not in floats", "[bench][trade][case-45]") {
  const auto measured = measure(thin_layers(255), colour_format_settings(), kNoEffort, {.threads = 1});
  REQUIRE(measured.ok());
  CHECK(255 * measured->front().middle == Approx(white_under_layers(255)).margin(0.01));
  CHECK(255 * measured->back().middle == Approx(127).margin(0.01));
}

TEST_CASE("trade: Gouraud shading loses the highlight in the middle, Phong keeps it", "[bench][trade][case-54]") {
  const auto measured =
      measure(highlight_between_normals(20, 50), smooth_shading_settings(), kNoEffort, {.threads = 1});
  REQUIRE(measured.ok());
  CHECK((*measured)[0].middle == Approx(1).margin(1e-4));
  CHECK((*measured)[1].middle == Approx(gouraud_highlight(20, 50)).margin(1e-4));
}

TEST_CASE("trade: every whole scene draws, and the reference of a scene held against it has no error",
          "[bench][trade]") {
  for (const WholeScene& whole : whole_scenes()) {
    CAPTURE(whole.scene.name);
    Scene small = against_reference(whole.scene);
    small.recipe.target.width = 96;
    small.recipe.target.height = 54;
    const auto measured = measure(small, {{"as it is", [](Recipe&) {}}}, kNoEffort, {.threads = 1});
    REQUIRE(measured.ok());
    CHECK(measured->front().error == 0);
    // Something is to be seen: a picture of one colour would be like nothing else.
    Recipe recipe = small.recipe;
    auto frame = small.build(recipe);
    REQUIRE(frame.ok());
    REQUIRE(frame->draw().ok());
    const Image<Rgba32F> picture = frame->picture();
    std::set<float> reds;
    for (const Rgba32F& pixel : picture.pixels()) reds.insert(pixel.r);
    CHECK(reds.size() > 8);
  }
}

TEST_CASE("trade report: CSV has as many fields in every line, however names are written", "[bench][trade]") {
  std::istringstream lines(csv_of(made_up_result()));
  std::string line;
  std::getline(lines, line);
  const std::size_t fields = fields_of(line);
  int count = 0;
  for (; std::getline(lines, line); ++count) CHECK(fields_of(line) == fields);
  CHECK(count == 7);
}

TEST_CASE("trade report: JSON is read back, infinite PSNRs as null", "[bench][trade]") {
  Circumstances circumstances;
  circumstances.machine.date = "2026-01-01";
  const auto all = nlohmann::json::parse(json_of(made_up_result(), circumstances));
  CHECK(all["stages"][0]["switches"][0]["measurements"][0]["to_ideal"]["psnr_db"].is_null());
  CHECK(all["stages"][0]["switches"][0]["measurements"][1]["setting"] == "a \"quick\" one, rather");
  CHECK(all["known_figures"].size() > 40);
}

TEST_CASE("trade: the adviser's table is one that the adviser reads", "[bench][trade]") {
  const auto text = measure_adviser_table("today, here", {.seconds = 0, .fewest_rounds = 1}, {.threads = 1}, Progress());
  REQUIRE(text);
  const auto table = MeasuredTrade::parse(*text);
  INFO((table ? "" : table.error().message));
  REQUIRE(table.ok());
  CHECK(table->circumstances() == "today, here\n");
  // What is worse is worse, and what costs a seventh of the texels is quicker.
  const Effect nearest = table->predict(SurfaceKind::textured, {{6, 0, 0, 0}}), trilinear = table->predict(SurfaceKind::textured, {{3, 0, 0, 0}});
  CHECK(nearest.rmse > trilinear.rmse);
  CHECK(nearest.time_ratio < 0.5);
}

TEST_CASE("trade report: the page and the plots of whatever was measured have no broken numbers", "[bench][trade]") {
  const TradeResult result = made_up_result();
  for (const std::string& text : {figure_of(plot_of(result.stages[0])), figure_of(plot_of(result.scenes[0])),
                                  figure_of(plot_of(result.scenes)), markdown_of(result, {})}) {
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("=\"inf") == std::string::npos);
  }
}

}  // namespace tuberia::bench::trade
