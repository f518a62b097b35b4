#include "bench/figures/page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace tuberia::bench {
namespace {

// Eight colours that keep apart in both schemes, also for those who do not tell red from green.
constexpr const char* kLightColours = R"(
  --paper: #f6f6f3; --card: #ffffff; --ink: #22262b; --quiet: #5b626b; --line: #dcdcd6; --grid: #e9e9e4; --alarm: #b3261e;
  --c0: #2563b0; --c1: #c2570c; --c2: #0f7f6b; --c3: #a3276f; --c4: #7a6a00; --c5: #6246b5; --c6: #3d7d1f; --c7: #777d86; )";

constexpr const char* kStyle = R"(
@media (prefers-color-scheme: dark) { :root {
  --paper: #14161b; --card: #1d2027; --ink: #e2e5ea; --quiet: #9aa2ae; --line: #343944; --grid: #2a2e37; --alarm: #ff8a80;
  --c0: #74aef5; --c1: #f5a25d; --c2: #4fd0b5; --c3: #f08fc6; --c4: #d6c648; --c5: #b5a0fa; --c6: #93cf70; --c7: #99a0aa; } }
body { margin: 0 auto; max-width: 78rem; padding: 1.5rem 1.25rem 4rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 1.7rem; }
h2 { margin: 0 0 .3rem; font-size: 1.15rem; }
header p, section > p, figcaption { color: var(--quiet); }
header p { margin: .3rem 0 0; max-width: 62rem; }
section { margin-top: 1.4rem; padding: 1rem 1.25rem 1.2rem; background: var(--card); border: 1px solid var(--line); border-radius: 8px; }
section > p { margin: .3rem 0 .8rem; max-width: 62rem; }
.row { display: flex; flex-wrap: wrap; gap: 1.2rem 1.5rem; align-items: flex-start; }
.row > div { flex: 1 1 20rem; min-width: 0; }
figure { margin: 0; }
figcaption { margin-top: .25rem; font-size: .85rem; }
svg { display: block; max-width: 100%; height: auto; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .8rem; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .45rem .15rem 0; text-align: right; white-space: nowrap; vertical-align: top; }
th { font-weight: 600; color: var(--quiet); vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; }
tr + tr td { border-top: 1px solid var(--grid); }
.alarm { color: var(--alarm); font-weight: 600; }
.swatch { display: inline-block; width: .8em; height: .8em; margin-right: .35em; border-radius: 2px; vertical-align: -.05em; }
.key { font-size: .85rem; display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; margin: .2rem 0 .6rem; }
)";

constexpr const char* kFigureStyle = R"(
svg text { font: 12px system-ui, sans-serif; fill: var(--ink); }
svg text.quiet { fill: var(--quiet); }
svg text.label { font-size: 11px; paint-order: stroke; stroke: var(--card); stroke-width: 3px; }
svg .grid { stroke: var(--grid); } svg .axis { stroke: var(--quiet); }
)";

/// Thousands separated.
std::string with_decimals(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string digits = text;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = value < 0 ? 1 : 0;
  for (std::size_t place = point; place > first + 3; place -= 3) digits.insert(place - 3, 1, ',');
  return digits;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string number_text(double value) {
  if (value == 0) return "0";
  const double magnitude = std::abs(value);
  if (!(magnitude < 1e15) || magnitude < 1e-4) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2e", value);
    return text;
  }
  const int decimals = magnitude >= 100  ? 0
                       : magnitude >= 10 ? 1
                       : magnitude >= 1  ? 2
                                         : 2 - static_cast<int>(std::floor(std::log10(magnitude)));
  return with_decimals(value, decimals);
}

std::string light_svg_style() { return std::string(":root {") + kLightColours + "}" + kFigureStyle; }

std::string count_text(double count) { return with_decimals(count, 0); }

std::string Table::html() const {
  std::string out = "<div class=\"scroll\"><table>\n<tr>";
  for (const std::string& heading : headings) out += "<th>" + heading + "</th>";
  out += "</tr>\n";
  for (const std::vector<std::string>& row : rows) {
    out += "<tr>";
    for (const std::string& cell : row) out += "<td>" + cell + "</td>";
    out += "</tr>\n";
  }
  return out + "</table></div>\n";
}

void Page::add_section(const std::string& heading, const std::string& html) {
  sections_ += "<section>\n<h2>" + escaped(heading) + "</h2>\n" + html + "</section>\n";
}

Result<Nothing> Page::write(const std::string& path) const {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return Error{"cannot make " + folder.string() + ": " + error.message()};
  std::ofstream file(path);
  file << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
       << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" << escaped(title_)
       << "</title>\n<style>\n:root { color-scheme: light dark;" << kLightColours << "}" << kStyle << kFigureStyle
       << "</style>\n</head>\n<body>\n<header>\n<h1>" << escaped(title_) << "</h1>\n<p>" << lede_ << "</p>\n</header>\n"
       << sections_ << "</body>\n</html>\n";
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
}

}  // namespace tuberia::bench
