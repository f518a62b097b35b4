#include "examples/tuberia/gallery.hpp"

namespace tuberia::cli {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tuberia: the gallery</title>
<style>
  body { margin: 2rem auto; max-width: 78rem; padding: 0 1rem; background: #14161b; color: #d7dae0;
         font: 16px/1.5 system-ui, sans-serif; }
  h1 { font-weight: 600; margin-bottom: 0; }
  main { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); gap: 1.5rem; margin-top: 1.5rem; }
  figure { margin: 0; background: #1d2027; border-radius: 8px; overflow: hidden; }
  img { display: block; width: 100%; height: auto; }
  figcaption { padding: .7rem 1rem 1rem; }
  strong { display: block; }
  small { color: #8f96a3; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>Tuberia</h1>
)";

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

}  // namespace

std::string gallery_page(const std::vector<GalleryPicture>& pictures, const std::string& machine) {
  std::string page = kHead;
  page += "<p>Drawn by a graphics pipeline in software: " + escaped(machine) + ".</p>\n<main>\n";
  for (const GalleryPicture& picture : pictures) {
    page += "<figure><a href=\"" + escaped(picture.file) + "\"><img src=\"" + escaped(picture.file) + "\" alt=\"" +
            escaped(picture.title) + "\"></a>\n<figcaption><strong>" + escaped(picture.title) + "</strong>" +
            escaped(picture.caption) + "<br><small>" + escaped(picture.performance) + "</small></figcaption></figure>\n";
  }
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace tuberia::cli
