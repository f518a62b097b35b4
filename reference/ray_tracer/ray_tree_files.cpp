// A ray tree as text: Graphviz and JSON, and files of any kind.

#include <cmath>
#include <cstdio>
#include <span>
#include <sstream>

#include "image/file.hpp"
#include "reference/ray_tracer/ray_tree.hpp"

namespace tuberia::tracer {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// JSON has neither infinity nor NaN.
std::string json_number(double value) { return std::isfinite(value) ? number(value) : "null"; }

std::string json_triple(const glm::dvec3& v) { return std::string("[").append(json_number(v.x)) + ", " + json_number(v.y) + ", " + json_number(v.z) + "]"; }

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    char escape[8];
    if (c == '"' || c == '\\') (quoted += '\\') += c;
    else if (static_cast<unsigned char>(c) >= 0x20) quoted += c;
    else std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c)), quoted += escape;
  }
  return quoted += '"';
}

/// In Graphviz a backslash before a quotation mark is all the escaping there is, and labels know more of them.
std::string dot_text(std::string_view text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted;
}

std::string rgb(const glm::dvec3& v) { return v.x == v.y && v.y == v.z ? number(v.x) : number(v.x) + " " + number(v.y) + " " + number(v.z); }

void write_dot_node(std::ostream& to, const TracedRay& ray, std::size_t index) {
  to << "  ray" << index << " [label=\"" << dot_text(ray.name) << "  weight " << rgb(ray.weight);
  if (ray.hit_number > 0) to << "\\nhits " << dot_text(ray.object.empty() ? "an object" : ray.object) << " at " << number(ray.t);
  to << "\\n" << name_of(ray.end);
  if (ray.kind != RayKind::shadow && ray.was_followed()) to << "\\nadds " << rgb(ray.weight * ray.light);
  to << "\"" << (!ray.was_followed() ? ", style=dashed, color=grey" : ray.kind == RayKind::shadow ? ", shape=ellipse, color=goldenrod" : "") << "];\n";
}

void write_json_ray(std::ostream& to, const TracedRay& ray, std::size_t index) {
  to << "  {\"index\": " << index << ", \"name\": " << json_text(ray.name) << ", \"kind\": " << json_text(name_of(ray.kind)) << ", \"parent\": ";
  if (ray.parent < 0) to << "null";
  else to << ray.parent;
  to << ", \"level\": " << ray.level << ", \"weight\": " << json_triple(ray.weight) << ",\n   \"origin\": " << json_triple(ray.ray.origin) << ", \"direction\": " << json_triple(ray.ray.direction);
  if (ray.hit_number > 0) to << ",\n   \"object\": " << json_text(ray.object) << ", \"t\": " << json_number(ray.t) << ", \"point\": " << json_triple(ray.point);
  to << ",\n   \"light\": " << json_triple(ray.light) << ", \"end\": " << json_text(name_of(ray.end)) << "}";
}

}  // namespace

std::string dot_of(const RayTree& tree) {
  std::ostringstream text;
  text << "digraph rays {\n  node [shape=box, fontname=\"sans-serif\"];\n";
  for (std::size_t i = 0; i < tree.rays().size(); ++i) {
    const TracedRay& ray = tree.rays()[i];
    write_dot_node(text, ray, i);
    if (ray.parent >= 0) text << "  ray" << ray.parent << " -> ray" << i << " [label=\"" << dot_text(ray.name) << "\"];\n";
  }
  text << "}\n";
  return text.str();
}

std::string json_of(const RayTree& tree) {
  std::ostringstream text;
  text << "{\"rays\": [";
  for (std::size_t i = 0; i < tree.rays().size(); ++i) {
    text << (i == 0 ? "\n" : ",\n");
    write_json_ray(text, tree.rays()[i], i);
  }
  text << "\n]}\n";
  return text.str();
}

Result<Nothing> write_ray_tree(const std::string& path, const RayTree& tree) {
  const std::string extension = lower_case_extension(path);
  std::string text;
  if (extension == ".dot") text = dot_of(tree);
  else if (extension == ".json") text = json_of(tree);
  else if (extension == ".svg") text = svg_of(tree);
  else return Error{"the ray tree " + quoted_path(path) + " must be a .dot, .json or .svg file"};
  return write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace tuberia::tracer
