#include <algorithm>
#include <cstdio>

#include "bench/requirements/report.hpp"

namespace tuberia::bench {
namespace {

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string ratio_text(double value) { return formatted("%.2f", value); }

/// Milliseconds of the three whole pipelines.
struct WholeTimes {
  double asked, smallest, all;
};
WholeTimes whole_times(const MeasuredScene& scene) {
  return {scene.of(Variant::Kind::as_asked).milliseconds, scene.of(Variant::Kind::smallest).milliseconds, scene.of(Variant::Kind::everything).milliseconds};
}

/// The colour of a kind's bars, and what it is called.
struct KindLook {
  const char *colour, *words;
};
KindLook look_of(Variant::Kind kind) {
  switch (kind) {
    case Variant::Kind::bare:
    case Variant::Kind::needed_alone: return {"var(--c1)", "bare, and with one thing that is needed"};
    case Variant::Kind::smallest: return {"var(--c2)", "the smallest pipeline: all that is needed"};
    case Variant::Kind::as_asked: return {"var(--c0)", "as the scene asks"};
    case Variant::Kind::neutral_alone: return {"var(--c3)", "smallest, and one feature more that changes nothing"};
    case Variant::Kind::everything: break;
  }
  return {"var(--c5)", "everything enabled"};
}

std::string key() {
  std::string key = "<div class=\"key\">";
  for (const Variant::Kind kind : {Variant::Kind::bare, Variant::Kind::smallest, Variant::Kind::as_asked, Variant::Kind::neutral_alone, Variant::Kind::everything})
    key += std::string("<span><span class=\"swatch\" style=\"background:") + look_of(kind).colour + "\"></span>" + look_of(kind).words + "</span>";
  return key + "</div>\n";
}

std::string text_at(double x, int y, const char* anchor, const std::string& words) {
  return "<text x=\"" + formatted("%.1f", x) + "\" y=\"" + std::to_string(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(words) + "</text>";
}

/// A bar for each way to draw the scene, with a line between the quartiles.
std::string bars(const MeasuredScene& scene) {
  constexpr int kRow = 22, kLabels = 290, kWidth = 560, kNumbers = 150;
  double largest = 0;
  for (const Variant& v : scene.variants) largest = std::max(largest, v.third_quarter);
  const auto x_of = [&](double milliseconds) { return kLabels + kWidth * milliseconds / largest; };
  const double smallest = scene.of(Variant::Kind::smallest).milliseconds;
  const int height = kRow * static_cast<int>(scene.variants.size()) + 4, width = kLabels + kWidth + kNumbers;
  std::string svg = "<svg viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) + "\" width=\"" + std::to_string(width) + "\" role=\"img\">\n";
  int y = 2;
  for (const Variant& v : scene.variants) {
    const bool is_neutral = v.kind == Variant::Kind::neutral_alone;
    char shape[400];
    std::snprintf(shape, sizeof shape,
                  "<rect x=\"%d\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"%s\"/>"
                  "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\" stroke=\"currentColor\" stroke-width=\"2\"/>",
                  kLabels, y, kWidth * v.milliseconds / largest, kRow - 5, look_of(v.kind).colour, x_of(v.first_quarter),
                  x_of(v.third_quarter), y + 8, y + 8);
    const std::string label = (is_neutral ? "smallest + " : "") + v.name;
    const std::string figures = number_text(v.milliseconds) + " ms, " + ratio_text(v.milliseconds / smallest);
    svg += text_at(kLabels - 8, y + 13, "end", label) + shape + text_at(x_of(v.third_quarter) + 8, y + 13, "start", figures) + "\n";
    y += kRow;
  }
  return svg + "</svg>\n";
}

Table table_of_scenes(std::span<const MeasuredScene> scenes) {
  Table table{.headings = {"scene", "draws,<br>needed", "as asked<br>ms", "smallest<br>ms", "everything<br>ms", "as asked /<br>smallest", "everything /<br>smallest",
                           "examining<br>once, ms", "pictures"},
              .rows = {}};
  for (const MeasuredScene& s : scenes) {
    const auto [asked, smallest, all] = whole_times(s);
    table.rows.push_back({escaped(s.name), std::to_string(s.draws) + ", " + std::to_string(s.needed_draws), number_text(asked), number_text(smallest), number_text(all),
                          ratio_text(asked / smallest), "<b>" + ratio_text(all / smallest) + "</b>", number_text(s.examining_milliseconds),
                          s.pictures_are_equal ? "the same bits" : "<span class=\"alarm\">differ</span>"});
  }
  return table;
}

std::vector<std::string> neutral_names(std::span<const MeasuredScene> scenes) {
  std::vector<std::string> names;
  for (const MeasuredScene& s : scenes)
    for (const Variant& v : s.variants)
      if (v.kind == Variant::Kind::neutral_alone && std::find(names.begin(), names.end(), v.name) == names.end()) names.push_back(v.name);
  return names;
}

/// Time with the feature, relative to the smallest pipeline; "-" where it has no form that changes nothing.
std::string cost_of(const MeasuredScene& scene, const std::string& feature) {
  for (const Variant& v : scene.variants)
    if (v.kind == Variant::Kind::neutral_alone && v.name == feature) return ratio_text(v.milliseconds / scene.of(Variant::Kind::smallest).milliseconds);
  return "-";
}

Table table_of_features(std::span<const MeasuredScene> scenes) {
  Table table{.headings = {"time / smallest"}, .rows = {}};
  for (const std::string& name : neutral_names(scenes)) table.headings.push_back(escaped(name));
  for (const MeasuredScene& s : scenes) {
    table.rows.push_back({escaped(s.name)});
    for (const std::string& name : neutral_names(scenes)) table.rows.back().push_back(cost_of(s, name));
  }
  return table;
}

std::string table_of_reasons(const MeasuredScene& scene) {
  std::string html = "<style>td.words { text-align: left }</style><details><summary>What it needs, and why</summary><table><tr><th>feature</th><th>needed</th><th>reason</th></tr>\n";
  for (const Requirement& r : scene.requirements.features) {
    const char* verdict = r.is_needed ? "<b>yes</b>" : r.was_on ? "turned off" : "no";
    html += "<tr><td>" + escaped(name_of(r.feature)) + "</td><td class=\"words\">" + verdict + "</td><td class=\"words\">" + escaped(r.reason) + "</td></tr>\n";
  }
  return html + "</table></details>\n";
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row.append(" ").append(cell).append(" |");
  return row + "\n";
}

const std::string kAboutScenes = R"(<p>Examining a draw finds out what it cannot do without. The smallest pipeline has the
rest turned off; <i>everything enabled</i> has every feature on in a form that changes nothing, such as fog of density 0. All
three leave the same bits of colour and depth.</p>
)";
const std::string kAboutFeatures = R"(<p>The smallest pipeline with this feature alone, relative to the smallest pipeline.</p>
)";

}  // namespace

Page requirements_page(std::span<const MeasuredScene> scenes, const Machine& machine, const MeasureOptions& options, bool quick) {
  std::string lede = escaped(sentence_of(machine)) + ". " + std::string(name_of(options.instruction_set)) + ", exact precision, " + std::to_string(options.threads) +
                     (options.threads == 1 ? " thread" : " threads") + "; medians of " + std::to_string(options.rounds) +
                     " rounds in which every way to draw a scene had its turn; lines lie between the quartiles. Clearing is included.";
  if (quick) lede += " <span class=\"alarm\">A quick run: not to be quoted.</span>";
  Page page("Only what the scene requires", lede);
  page.add_section("Whole scenes", kAboutScenes + table_of_scenes(scenes).html());
  page.add_section("What a feature costs that changes nothing", kAboutFeatures + table_of_features(scenes).html());
  page.add_section("Each scene", key());
  for (const MeasuredScene& s : scenes) page.add_section(s.name, "<p>" + escaped(s.caption) + "</p>\n" + bars(s) + table_of_reasons(s));
  return page;
}

std::string requirements_markdown(std::span<const MeasuredScene> scenes) {
  std::string text = row_of({"scene", "draws, needed", "as asked ms", "smallest ms", "everything ms", "as asked / smallest", "everything / smallest"});
  text += "|---|---|---|---|---|---|---|\n";
  for (const MeasuredScene& s : scenes) {
    const auto [asked, smallest, all] = whole_times(s);
    text += row_of({s.name, std::to_string(s.draws) + ", " + std::to_string(s.needed_draws), number_text(asked), number_text(smallest), number_text(all),
                    ratio_text(asked / smallest), ratio_text(all / smallest)});
  }
  std::vector<std::string> headings{"time / smallest"};
  for (const std::string& name : neutral_names(scenes)) headings.push_back(name);
  text.append("\n").append(row_of(headings));
  text += row_of(std::vector<std::string>(headings.size(), "---"));
  for (const MeasuredScene& s : scenes) {
    std::vector<std::string> cells{s.name};
    for (const std::string& name : neutral_names(scenes)) cells.push_back(cost_of(s, name));
    text += row_of(cells);
  }
  return text;
}

}  // namespace tuberia::bench
