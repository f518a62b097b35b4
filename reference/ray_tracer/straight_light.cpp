#include "reference/ray_tracer/straight_light.hpp"

#include <algorithm>

namespace tuberia::tracer {

void BodiesOnTheWay::start_behind(const PointMaterial& material, int object) { bodies_.push_back({object, 0, material.shadow_density, true}); }

std::vector<BodiesOnTheWay::Body>::iterator BodiesOnTheWay::last_of(int object) {
  const auto found = std::find_if(bodies_.rbegin(), bodies_.rend(), [&](const Body& body) { return body.object == object; });
  return found == bodies_.rend() ? bodies_.end() : std::prev(found.base());
}

glm::dvec3 BodiesOnTheWay::share(const PointMaterial& material, int object, double t, bool comes_in) {
  if (comes_in) {
    bodies_.push_back({object, t, material.shadow_density, false});
    return material.transmitted;
  }
  const auto body = last_of(object);
  if (body == bodies_.end()) return material.transmitted;
  const double inside = std::exp(-material.shadow_density * (t - body->from));
  const glm::dvec3 share = body->owes_kt ? material.transmitted * inside : glm::dvec3(inside);
  bodies_.erase(body);
  return share;
}

bool BodiesOnTheWay::may_absorb() const noexcept {
  return std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.density > 0; });
}

double BodiesOnTheWay::share_around_light(int object, double t_light, bool leaves) {
  const auto body = last_of(object);
  if (body == bodies_.end()) return 1;
  const double share = leaves ? std::exp(-body->density * (t_light - body->from)) : 1;
  bodies_.erase(body);
  return share;
}

}  // namespace tuberia::tracer
