// A ray tree as a drawing: a row for each step from the eye, parents above the middle of their children.

#include <algorithm>
#include <array>
#include <cstdio>

#include "reference/ray_tracer/ray_tree.hpp"

namespace tuberia::tracer {
namespace {

// Pixels.
constexpr double kColumn = 192, kRow = 130, kBoxWidth = 180, kBoxHeight = 76, kMargin = 20, kLine = 16;
constexpr std::size_t kMostLetters = 20;  // of an object's name in a box

struct Place {
  double column = 0;
  int row = 0;
};

/// Children are found after their parents: rows forwards, columns of leaves in the order of a walk, and of parents backwards.
std::vector<Place> places_of(const std::vector<TracedRay>& rays) {
  std::vector<Place> places(rays.size());
  std::vector<std::vector<std::size_t>> children(rays.size());
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const std::size_t parent = static_cast<std::size_t>(rays[i].parent);
    places[i].row = places[parent].row + 1;
    children[parent].push_back(i);
  }
  double next = 0;
  std::vector<std::size_t> waiting{0};
  while (!waiting.empty() && !rays.empty()) {
    const std::size_t i = waiting.back();
    waiting.pop_back();
    if (children[i].empty()) places[i].column = next++;
    waiting.insert(waiting.end(), children[i].rbegin(), children[i].rend());
  }
  for (std::size_t i = rays.size(); i-- > 0;)
    if (!children[i].empty()) places[i].column = 0.5 * (places[children[i].front()].column + places[children[i].back()].column);
  return places;
}

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return escaped;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string short_rgb(const glm::dvec3& v) { return v.x == v.y && v.y == v.z ? short_number(v.x) : short_number(v.x) + " " + short_number(v.y) + " " + short_number(v.z); }

/// Cut between characters, not within one of several bytes.
std::string short_name(std::string_view name) {
  if (name.size() <= kMostLetters) return std::string(name);
  std::size_t length = kMostLetters;
  while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0) == 0x80) --length;
  return std::string(name.substr(0, length)) + "...";
}

std::string_view colour_of(const TracedRay& ray) {
  if (!ray.was_followed()) return "#9a9a9a";
  static constexpr std::array<std::string_view, 5> kColours{"#333333", "#2a6fb5", "#2d8a4b", "#777777", "#c28a00"};
  return kColours[static_cast<std::size_t>(ray.kind)];
}

double centre_x(const Place& place) { return kMargin + 0.5 * kBoxWidth + kColumn * place.column; }
double upper_y(const Place& place) { return kMargin + kRow * place.row; }

std::string line_between(const Place& from, const Place& to, const TracedRay& ray) {
  char text[256];
  std::snprintf(text, sizeof text, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\"%s/>\n", centre_x(from), upper_y(from) + kBoxHeight, centre_x(to), upper_y(to),
                colour_of(ray).data(), ray.was_followed() ? "" : " stroke-dasharray=\"5 4\"");
  return text;
}

std::string box_of(const Place& place, const TracedRay& ray) {
  const double x = centre_x(place), y = upper_y(place);
  char frame[256];
  std::snprintf(frame, sizeof frame, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%g\" height=\"%g\" rx=\"6\" fill=\"#ffffff\" stroke=\"%s\"%s/>\n", x - 0.5 * kBoxWidth, y, kBoxWidth, kBoxHeight,
                colour_of(ray).data(), ray.was_followed() ? "" : " stroke-dasharray=\"5 4\"");
  const bool has_light = ray.kind != RayKind::shadow && ray.was_followed();
  const std::array<std::string, 4> lines{ray.name + ", weight " + short_rgb(ray.weight),
                                         ray.hit_number > 0 ? "hits " + (ray.object.empty() ? "an object" : short_name(ray.object)) : "", std::string(name_of(ray.end)),
                                         has_light ? "adds " + short_rgb(ray.weight * ray.light) : ""};
  std::string text = frame;
  double baseline = y + kLine;
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    char start[64];
    std::snprintf(start, sizeof start, "<text x=\"%.1f\" y=\"%.1f\">", x, baseline);
    text += start + xml_text(line) + "</text>\n";
    baseline += kLine;
  }
  return text;
}

}  // namespace

std::string svg_of(const RayTree& tree) {
  const std::vector<TracedRay>& rays = tree.rays();
  const std::vector<Place> places = places_of(rays);
  double width = 0, height = 0;
  for (const Place& place : places) {
    width = std::max(width, centre_x(place) + 0.5 * kBoxWidth + kMargin);
    height = std::max(height, upper_y(place) + kBoxHeight + kMargin);
  }
  char start[256];
  std::snprintf(start, sizeof start, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" font-family=\"sans-serif\" font-size=\"11\" text-anchor=\"middle\" fill=\"#222222\">\n",
                width, height);
  std::string text = start;
  for (std::size_t i = 1; i < rays.size(); ++i) text += line_between(places[static_cast<std::size_t>(rays[i].parent)], places[i], rays[i]);
  for (std::size_t i = 0; i < rays.size(); ++i) text += box_of(places[i], rays[i]);
  return text + "</svg>\n";
}

}  // namespace tuberia::tracer
