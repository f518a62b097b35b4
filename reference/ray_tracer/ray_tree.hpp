#pragma once
// The rays that one pixel's light came along.                                          [B 5.1, Figs 32, 36]

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// straight: an eye, reflected or transmitted ray that goes on behind a hole or a surface whose alpha is below 1.
enum class RayKind : std::uint8_t { eye, reflected, transmitted, straight, shadow };

/// Why nothing follows behind a ray, or what does. level, weight, budget: it was not followed itself; its light is black.
enum class RayEnd : std::uint8_t {
  escaped,               // it met nothing: the background
  level,                 // beyond the most that was asked for
  weight,                // its coefficients multiply to less than the least
  budget,                // the eye ray had used up its rays
  nothing_to_follow,     // it met a surface that neither mirrors nor transmits
  branched,              // it met one that does
  total_reflection,      // it met one from within so obliquely that all is mirrored
  lit,                   // of a shadow ray: all or some of the light arrives
  blocked                // of a shadow ray: none
};

struct TracedRay {
  RayKind kind = RayKind::eye;
  RayEnd end = RayEnd::escaped;
  int parent = -1;              // its index; the eye ray has none
  int level = 0;                // of what it comes from or, of a shadow ray, of its parent
  glm::dvec3 weight{1};         // the product of the coefficients from the eye to it
  Ray ray{};
  std::string name{};           // "E"; "R2": reflected where the second hit is; "T2"; "P2": straight on; "L2.1": to the first light
  int hit_number = 0;           // counted from 1 as they were found, reflected rays before transmitted ones; 0: none
  std::string object{};         // that was hit
  double t = kInfinity;
  glm::dvec3 point{0};
  glm::dvec3 light{0};          // that came along it, but for what is straight behind: times the weight, what it adds to the pixel; of a shadow ray, the share

  bool was_followed() const noexcept { return end != RayEnd::level && end != RayEnd::weight && end != RayEnd::budget; }
};

/// In the order of their discovery: parents before children.
class RayTree {
 public:
  const std::vector<TracedRay>& rays() const noexcept { return rays_; }
  void clear() noexcept;

  /// Returns its index. light_number: of a shadow ray, from 1.
  int add(RayKind kind, int parent, int level, const glm::dvec3& weight, const Ray& ray, int light_number = 0);
  /// What a ray met; object may be without a name.
  void meet(int index, std::string_view object, double t, const glm::dvec3& point);
  void end(int index, RayEnd why, const glm::dvec3& light);

 private:
  std::vector<TracedRay> rays_;
  int hits_ = 0;
};

std::string_view name_of(RayKind kind) noexcept;  // "eye", "reflected", ...
std::string_view name_of(RayEnd end) noexcept;    // as a person would say it: "escaped", "level limit", ...

/// Graphviz, JSON, and a drawing of its own layout. Whatever objects are called, the files are well-formed.
std::string dot_of(const RayTree& tree);
std::string json_of(const RayTree& tree);
std::string svg_of(const RayTree& tree);

/// By the file's extension, .dot, .json or .svg. Error for another one, and when it cannot be written.
Result<Nothing> write_ray_tree(const std::string& path, const RayTree& tree);

}  // namespace tuberia::tracer
