#include "reference/ray_tracer/ray_tree.hpp"

namespace tuberia::tracer {
namespace {

constexpr std::string_view kKindNames[] = {"eye", "reflected", "transmitted", "straight on", "shadow"};
constexpr std::string_view kEndNames[] = {"escaped",  "not followed: level limit", "not followed: weighs too little", "not followed: too many rays", "nothing to follow",
                                          "branched", "total reflection",          "lit",                             "blocked"};
constexpr char kLetters[] = {'E', 'R', 'T', 'P', 'L'};

}  // namespace

void RayTree::clear() noexcept {
  rays_.clear();
  hits_ = 0;
}

int RayTree::add(RayKind kind, int parent, int level, const glm::dvec3& weight, const Ray& ray, int light_number) {
  TracedRay added{.kind = kind, .parent = parent, .level = level, .weight = weight, .ray = ray};
  added.name = kLetters[static_cast<int>(kind)];
  if (parent >= 0) added.name += std::to_string(rays_[static_cast<std::size_t>(parent)].hit_number);
  if (light_number > 0) (added.name += ".") += std::to_string(light_number);
  rays_.push_back(std::move(added));
  return static_cast<int>(rays_.size()) - 1;
}

void RayTree::meet(int index, std::string_view object, double t, const glm::dvec3& point) {
  TracedRay& ray = rays_[static_cast<std::size_t>(index)];
  ray.hit_number = ++hits_;
  ray.object = object;
  ray.t = t;
  ray.point = point;
}

void RayTree::end(int index, RayEnd why, const glm::dvec3& light) {
  TracedRay& ray = rays_[static_cast<std::size_t>(index)];
  ray.end = why;
  ray.light = light;
}

std::string_view name_of(RayKind kind) noexcept { return kKindNames[static_cast<int>(kind)]; }
std::string_view name_of(RayEnd end) noexcept { return kEndNames[static_cast<int>(end)]; }

}  // namespace tuberia::tracer
