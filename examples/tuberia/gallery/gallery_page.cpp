#include "examples/tuberia/gallery/gallery.hpp"

#include <algorithm>

namespace tuberia::cli {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tuberia: the gallery</title>
<style>
  body { margin: 2rem auto; max-width: 84rem; padding: 0 1.5rem; background: #14161b; color: #d7dae0;
         font: 16px/1.5 system-ui, sans-serif; }
  h1 { font-weight: 600; margin-bottom: 0; }
  h2 { font-weight: 600; margin: 3rem 0 0; padding-top: 1rem; border-top: 1px solid #2b303a; }
  nav a { color: #8ab4f8; margin-right: 1.2rem; }
  p { max-width: 50rem; color: #aab0bb; }
  .pictures { display: flex; flex-wrap: wrap; gap: 1.25rem; margin-top: 1.25rem; align-items: flex-start; }
  figure { margin: 0; background: #1d2027; border-radius: 8px; overflow: hidden; max-width: 100%; }
  img { display: block; width: 100%; height: auto; }
  figcaption { padding: .7rem 1rem 1rem; }
  strong { display: block; }
  small { color: #8f96a3; font-variant-numeric: tabular-nums; }
  .source { float: right; margin-left: 1rem; }
</style>
</head>
<body>
<h1>Tuberia: the gallery</h1>
)";

// How wide pictures stand on the page, in its own pixels.
constexpr int kNarrowest = 300, kWidest = 640;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string anchor_of(std::size_t section) { return "section-" + std::to_string(section + 1); }

std::string figure(const GalleryPicture& picture) {
  const int width = std::clamp(picture.width_pixels, kNarrowest, kWidest);
  const std::string file = escaped(picture.file);
  std::string html = "<figure style=\"width:" + std::to_string(width) + "px\"><a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" alt=\"";
  html += escaped(picture.title) + "\"></a>\n<figcaption>";
  if (!picture.source.empty()) html += "<small class=\"source\">" + escaped(picture.source) + "</small>";
  html += "<strong>" + escaped(picture.title) + "</strong>" + escaped(picture.caption);
  html += "<br><small>" + escaped(picture.performance) + "</small></figcaption></figure>\n";
  return html;
}

}  // namespace

std::string gallery_page(const std::vector<GallerySection>& sections, const std::string& machine) {
  std::string page = kHead;
  page += "<p>Every picture was drawn by a graphics pipeline in software, or, where rays are what it is about, by the ray tracer that bears witness to it: " +
          escaped(machine) + ".</p>\n<nav>";
  for (std::size_t i = 0; i < sections.size(); ++i) page += "<a href=\"#" + anchor_of(i) + "\">" + escaped(sections[i].title) + "</a>\n";
  page += "</nav>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    page += "<h2 id=\"" + anchor_of(i) + "\">" + escaped(sections[i].title) + "</h2>\n<p>" + escaped(sections[i].lede) + "</p>\n<div class=\"pictures\">\n";
    for (const GalleryPicture& picture : sections[i].pictures) page += figure(picture);
    page += "</div>\n";
  }
  return page + "</body>\n</html>\n";
}

}  // namespace tuberia::cli
