// The page of `tuberia witness`: one file that says what was compared, what differs, and why.

#include <algorithm>
#include <cstdio>

#include "examples/tuberia/embedded_image.hpp"
#include "examples/tuberia/witness/comparison.hpp"

namespace tuberia::witness {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tuberia: two witnesses of one scene</title>
<style>
  body { margin: 2rem auto; max-width: 84rem; padding: 0 1.5rem; background: #14161b; color: #d7dae0;
         font: 16px/1.5 system-ui, sans-serif; }
  h1 { font-weight: 600; margin-bottom: 0; }
  h2 { font-weight: 600; margin: 2.5rem 0 0; padding-top: 1rem; border-top: 1px solid #2b303a; }
  p, td { color: #aab0bb; }
  p { max-width: 54rem; }
  .pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(34rem, 100%), 1fr)); gap: 1.25rem; margin-top: 1.25rem; }
  figure { margin: 0; background: #1d2027; border-radius: 8px; overflow: hidden; }
  img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
  figcaption { padding: .7rem 1rem 1rem; }
  strong { display: block; color: #d7dae0; }
  table { border-collapse: collapse; margin-top: 1rem; }
  td, th { padding: .5rem .9rem .5rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid #2b303a; }
  td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  .swatch { display: inline-block; width: .9em; height: .9em; border-radius: 3px; margin-right: .5em; border: 1px solid #3b414d; vertical-align: -.1em; }
  .close { display: grid; grid-template-columns: repeat(auto-fill, minmax(25rem, 1fr)); gap: 1.25rem; margin-top: 1.25rem; }
  .close div { display: grid; grid-template-columns: 1fr 1fr 1fr; gap: 3px; }
  .close span.one { position: relative; }
  .close span.one::after { content: ""; position: absolute; left: 46.67%; top: 46.67%; width: 6.67%; height: 6.67%; outline: 1px solid #fff; }
  .legend { white-space: nowrap; margin-right: 1rem; }
  .verdict { padding: .6rem 1rem; border-radius: 8px; max-width: 54rem; color: #14161b; font-weight: 600; }
  .confirmed { background: #50d28c; } .refuted { background: #ff6060; }
</style>
</head>
<body>
)";

constexpr int kCloseUpPixels = 15;     // across
constexpr int kCloseUpsOfEach = 3;     // of each set of causes
constexpr int kAmplification = 8;

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

const ClassWords& words_of(PixelClass pixel_class) { return kClassWords[static_cast<std::size_t>(pixel_class)]; }

std::string swatch(PixelClass pixel_class) {
  const auto& c = words_of(pixel_class).colour;
  return "<span class=\"swatch\" style=\"background:rgb(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")\"></span>";
}

/// Each channel's difference, many times over.
Image<Rgba8> difference_picture(const Comparison& comparison) {
  Image<Rgba8> picture(comparison.drawn.width(), comparison.drawn.height());
  const auto amplified = [](int a, int b) { return static_cast<std::uint8_t>(std::min(kAmplification * std::abs(a - b), 255)); };
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const Rgba8 &a = comparison.drawn.pixels()[i], &b = comparison.traced.pixels()[i];
    picture.pixels()[i] = {amplified(a.r, b.r), amplified(a.g, b.g), amplified(a.b, b.b), 255};
  }
  return picture;
}

Image<Rgba8> map_of_classes(const Comparison& comparison) {
  Image<Rgba8> picture(comparison.drawn.width(), comparison.drawn.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const auto& c = words_of(class_of(comparison.verdicts.pixels()[i])).colour;
    picture.pixels()[i] = {c[0], c[1], c[2], 255};
  }
  return picture;
}

/// The pixels around one; beyond the picture its border.
Image<Rgba8> close_up(const Image<Rgba8>& picture, int x, int y) {
  Image<Rgba8> part(kCloseUpPixels, kCloseUpPixels);
  for (int j = 0; j < kCloseUpPixels; ++j)
    for (int i = 0; i < kCloseUpPixels; ++i)
      part.at(i, j) = picture.at(std::clamp(x + i - kCloseUpPixels / 2, 0, picture.width() - 1), std::clamp(y + j - kCloseUpPixels / 2, 0, picture.height() - 1));
  return part;
}

std::string figure(const Image<Rgba8>& image, std::string_view title, std::string_view caption) {
  return "<figure><img src=\"" + cli::data_url(image) + "\" alt=\"" + escaped(title) + "\"><figcaption><strong>" + escaped(title) + "</strong>" + std::string(caption) + "</figcaption></figure>\n";
}

std::string four_pictures(const Comparison& comparison, const Counts& counts) {
  std::string legend;
  for (const ClassWords& words : kClassWords)
    if (counts.of(words.pixel_class) > 0) legend += "<span class=\"legend\">" + swatch(words.pixel_class) + std::string(words.name) + "</span> ";
  std::string html = "<div class=\"pictures\">\n";
  html += figure(comparison.drawn, "The pipeline", "Triangles, drawn in " + formatted("%.2f", comparison.drawing_seconds) + " s.");
  html += figure(comparison.traced, "The ray tracer", "The same triangles, one ray through the centre of each pixel and what follows from it, in double precision, in " +
                                                          formatted("%.2f", comparison.tracing_seconds) + " s.");
  html += figure(difference_picture(comparison), "Their difference, " + std::to_string(kAmplification) + " times",
                 "The largest is " + std::to_string(counts.largest_difference) + " of 255 codes.");
  html += figure(map_of_classes(comparison), "Why", legend);
  return html + "</div>\n";
}

std::string row_of_causes(Causes causes, std::int64_t count, const Counts& counts) {
  std::string meaning, test;
  for (const CauseWords& words : kCauseWords) {
    if (!causes.has(words.cause)) continue;
    meaning += std::string(meaning.empty() ? "" : "<br>") + escaped(words.meaning);
    test += std::string(test.empty() ? "" : "<br>") + escaped(words.test);
  }
  const PixelClass shown = class_of({.differs = true, .explained = true, .causes = causes});
  return "<tr><td>" + swatch(shown) + escaped(name_of(causes)) + "</td><td class=\"number\">" + std::to_string(count) + "<br>" +
         formatted("%.3f %%", 100.0 * static_cast<double>(count) / static_cast<double>(counts.pixels)) + "</td><td>" + meaning + "</td><td>" + test + "</td></tr>\n";
}

std::string table_of_causes(const Counts& counts) {
  std::string html = "<h2>What differs, and why</h2>\n<p>Every pixel that differs is asked the questions below, one after the other and several together, those that leave no room before edges and depths. "
                     "A cause counts only if what it makes of the tracer's ray, within one code, is what the pipeline drew.</p>\n"
                     "<table><tr><th>Cause</th><th>Pixels</th><th>What it means</th><th>How it was tested, pixel by pixel</th></tr>\n";
  for (const auto& [bits, count] : counts.of_causes) html += row_of_causes(Causes(bits), count, counts);
  const std::int64_t rest = counts.of(PixelClass::unexplained);
  html += "<tr><td>" + swatch(PixelClass::unexplained) + "unexplained</td><td class=\"number\">" + std::to_string(rest) + "</td><td>" +
          escaped(words_of(PixelClass::unexplained).meaning) + "</td><td>None of the above, alone or together, gives what was drawn.</td></tr>\n";
  return html + "</table>\n";
}

std::string codes(const Rgba8& c) { return std::to_string(c.r) + " " + std::to_string(c.g) + " " + std::to_string(c.b); }

std::string object_name(const Comparison& comparison, int object) {
  return object < 0 ? "no object" : comparison.object_names[static_cast<std::size_t>(object)];
}

std::string close_up_of(const Comparison& comparison, const Image<Rgba8>& map, int x, int y) {
  const PixelVerdict& verdict = comparison.verdicts.at(x, y);
  const std::string why = verdict.explained ? name_of(verdict.causes) : "unexplained";
  std::string html = "<figure><div>";
  for (const Image<Rgba8>* picture : {&comparison.drawn, &comparison.traced, &map}) html += "<span class=\"one\"><img src=\"" + cli::data_url(close_up(*picture, x, y)) + "\" alt=\"close up\"></span>";
  html += "</div><figcaption><strong>" + swatch(class_of(verdict)) + escaped(why) + "</strong>Pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), in the middle: drawn " +
          codes(comparison.drawn.at(x, y)) + " (" + escaped(object_name(comparison, comparison.drawn_objects.at(x, y))) + "), traced " + codes(comparison.traced.at(x, y)) + " (" +
          escaped(object_name(comparison, comparison.traced_objects.at(x, y))) + ").</figcaption></figure>\n";
  return html;
}

/// A few pixels of each set of causes, those that differ most.
std::string close_ups(const Comparison& comparison) {
  struct Found {
    int difference, x, y;
  };
  std::map<unsigned, std::vector<Found>> found;
  constexpr unsigned kUnexplainedFirst = 0;
  for (int y = 0; y < comparison.drawn.height(); ++y)
    for (int x = 0; x < comparison.drawn.width(); ++x) {
      const PixelVerdict& verdict = comparison.verdicts.at(x, y);
      if (verdict.differs) found[verdict.explained ? verdict.causes.bits() : kUnexplainedFirst].push_back({difference(comparison.drawn.at(x, y), comparison.traced.at(x, y)), x, y});
    }
  if (found.empty()) return "";
  const Image<Rgba8> map = map_of_classes(comparison);
  std::string html = "<h2>Close up</h2>\n<p>Drawn, traced, and why; of each cause the pixels that differ most.</p>\n<div class=\"close\">\n";
  for (auto& [bits, pixels] : found) {
    std::stable_sort(pixels.begin(), pixels.end(), [](const Found& a, const Found& b) { return a.difference > b.difference; });
    for (std::size_t i = 0; i < std::min<std::size_t>(pixels.size(), kCloseUpsOfEach); ++i) html += close_up_of(comparison, map, pixels[i].x, pixels[i].y);
  }
  return html + "</div>\n";
}

}  // namespace

std::string page_of(const Comparison& comparison) {
  const Counts counts = counts_of(comparison);
  std::string page = kHead;
  page += "<h1>" + escaped(comparison.title) + "</h1>\n<p>Two witnesses of one scene, " + escaped(comparison.file) + ", " + std::to_string(comparison.drawn.width()) + " x " +
          std::to_string(comparison.drawn.height()) +
          " pixels. They share the description of the scene, the shapes' triangles and the formulas of reflection, and no code that draws: what both say is hardly a mistake of either.</p>\n";
  page += std::string("<p class=\"verdict ") + (is_confirmed(counts) ? "confirmed\">Confirmed: " : "refuted\">Not confirmed: ") + "the same object at " +
          formatted("%.3f %%", 100 * counts.same_objects()) + " of the pixels, " + std::to_string(counts.differing()) + " pixels differ by more than one code, " +
          std::to_string(counts.of(PixelClass::unexplained)) + " of them unexplained.</p>\n";
  for (const std::string& remark : comparison.remarks) page += "<p>" + escaped(remark) + "</p>\n";
  return page + four_pictures(comparison, counts) + table_of_causes(counts) + close_ups(comparison) + "</body>\n</html>\n";
}

}  // namespace tuberia::witness
