#include "reference/ray_tracer/ray_tracer.hpp"

#include <algorithm>

#include "math/optics.hpp"
#include "reference/ray_tracer/ray_tree.hpp"

namespace tuberia::tracer {
namespace {

// Beyond these refractive indices nothing changes that could be seen, and squares of their ratio stay far from infinity.
constexpr double kLeastIndex = 1e-6, kMostIndex = 1e6;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// Indices that are none bend nothing.
double sound_index(double index) { return index > 0 && std::isfinite(index) ? std::clamp(index, kLeastIndex, kMostIndex) : 1; }

/// A normal that is not the surface's own may send a ray to the wrong side of it: then the surface mirrors it back.
glm::dvec3 kept_above(const glm::dvec3& direction, const glm::dvec3& surface_normal) {
  const double cosine = glm::dot(direction, surface_normal);
  return cosine < 0 ? direction - 2 * cosine * surface_normal : direction;
}

/// A ray of the tree when it sets out.
struct Branch {
  Ray ray;
  RayKind kind = RayKind::eye;
  int level = 0;
  int parent = -1, node = -1;     // in the tree: what it comes from, and itself
  glm::dvec3 weight{1};           // the product of the coefficients from the eye to it
  std::int64_t skipped_item = -1; // AcneRemedy::skip_convex
};

/// p of the notes, and what the surface is like there.
struct Meeting {
  Hit hit;
  SurfacePoint at;
  TextureFootprint footprint;
  PointMaterial material;
  glm::dvec3 V;                   // to where the ray came from, unit
  bool is_inside;                 // the ray came from within
  glm::dvec3 facing;              // the surface's own normal, on V's side
};

/// What one piece of a ray brings, and which share of what is behind it.
struct Seen {
  glm::dvec3 light{0};
  double through = 0;
  Hit hit;
};

/// One eye ray and all that it spawns.
struct Tracing {
  const TracedScene& scene;
  const TraceSettings& settings;
  TraceScratch& scratch;
  RayTree* tree;
  const NeighbourRays* neighbours;

  /// RayTracing(o, u, n): the light along a ray, and straight on behind holes and what is not opaque.                  [A 2.3]
  glm::dvec3 ray_tracing(Branch branch) {
    const bool is_of_eye = branch.kind == RayKind::eye;
    glm::dvec3 light(0);
    for (double through = 1; through > 0;) {
      if (tree) branch.node = tree->add(branch.kind, branch.parent, branch.level, branch.weight, branch.ray);
      const Seen seen = see(branch, is_of_eye);
      light += through * seen.light;
      through *= seen.through;
      if (through > 0) scene.go_on_behind(seen.hit, branch.ray);
      branch.kind = RayKind::straight;
      branch.parent = branch.node;
      branch.weight *= seen.through;
    }
    return light;
  }

  Hit nearest(const Ray& ray, std::int64_t skipped_item) {
    Hit hit = scene.accelerator().nearest(ray, scratch.traversal);
    for (Ray beyond = ray; hit && hit.item == skipped_item; hit = scene.accelerator().nearest(beyond, scratch.traversal))
      scene.go_on_behind(hit, beyond);
    return hit;
  }

  /// One piece of it, up to the first surface.
  Seen see(const Branch& branch, bool is_of_eye) {
    Seen seen;
    const auto ended = [&](RayEnd why, const glm::dvec3& light) {
      if (tree) tree->end(branch.node, why, light);
      return seen.light = light, seen;
    };
    if (branch.level > settings.most_level) return ended(RayEnd::level, glm::dvec3(0));
    if (largest(branch.weight) < settings.least_weight) return ended(RayEnd::weight, glm::dvec3(0));
    if (scratch.rays_of_this_eye_ray >= settings.most_rays) return ++scratch.unfollowed_rays, ended(RayEnd::budget, glm::dvec3(0));
    ++scratch.rays_of_this_eye_ray;
    scratch.reflected_rays += branch.kind == RayKind::reflected;
    scratch.transmitted_rays += branch.kind == RayKind::transmitted;

    const Hit hit = nearest(branch.ray, branch.skipped_item);
    if (!hit) return ended(RayEnd::escaped, scene.background(branch.ray.direction, is_of_eye));
    const Meeting m = meet(branch.ray, hit, is_of_eye);
    if (tree) tree->meet(branch.node, scene.description().objects[static_cast<std::size_t>(scene.object_of(hit.item))].name, hit.t, m.at.position);
    seen.hit = hit;
    seen.through = m.material.is_cut_out ? 1 : 1 - m.material.alpha;
    if (m.material.is_cut_out) return ended(RayEnd::branched, glm::dvec3(0));
    RayEnd why = RayEnd::nothing_to_follow;
    const glm::dvec3 light = evaluate(m, branch, why);
    return ended(seen.through > 0 && why == RayEnd::nothing_to_follow ? RayEnd::branched : why, m.material.alpha * light);
  }

  // Not inlined, like the local model: what only they need would lie on the stack for as long as rays are followed from here.
  [[gnu::noinline]] Meeting meet(const Ray& ray, const Hit& hit, bool is_of_eye) const {
    const SurfacePoint at = scene.geometry().surface(ray, hit);
    const glm::dvec3 V = -glm::normalize(ray.direction);
    const bool is_inside = glm::dot(at.geometric_normal, V) < 0;
    const TextureFootprint footprint = is_of_eye && neighbours ? footprint_of(at, *neighbours) : TextureFootprint{};
    return {.hit = hit, .at = at, .footprint = footprint, .material = scene.material(hit.item, at, footprint), .V = V, .is_inside = is_inside,
            .facing = is_inside ? -at.geometric_normal : at.geometric_normal};
  }

  /// I = local model + kr Ir + kt It, the last two once, outside the sum over the lights.                     [B 5-2] [FIX 18]
  glm::dvec3 evaluate(const Meeting& m, const Branch& branch, RayEnd& why) {
    glm::dvec3 I = local_model(m, branch);
    glm::dvec3 kr = m.material.mirrored;
    const glm::dvec3 kt = m.material.transmitted;
    if (!(largest(kr) > 0 || largest(kt) > 0)) return I;
    // N on V's side [B 5-7]; where relief or an interpolated normal is turned away from V, the surface's own.
    glm::dvec3 N = m.is_inside ? -m.material.normal : m.material.normal;
    if (!(glm::dot(N, m.V) > 0)) N = m.facing;
    const double inside = sound_index(m.material.refractive_index);
    const auto T = refracted(-m.V, N, m.is_inside ? inside : 1, m.is_inside ? 1 : inside);
    why = largest(kt) > 0 && !T ? RayEnd::total_reflection : RayEnd::branched;
    // All that would go through is mirrored.                                                                           [B 5.3]
    if (!T) kr += kt;
    const glm::dvec3 R = 2 * glm::dot(N, m.V) * N - m.V;  // [B 5-5]
    if (largest(kr) > 0) I += kr * ray_tracing(leaving(m, kept_above(R, m.facing), RayKind::reflected, kr, branch));
    if (T && largest(kt) > 0) I += kt * ray_tracing(leaving(m, kept_above(glm::normalize(*T), -m.facing), RayKind::transmitted, kt, branch));
    return I;
  }

  /// ka Ia + sum of V(p, q_i) Ip_i [kd (N.L_i) + ks ...].                                                    [B 5-2] [A 2.2]
  [[gnu::noinline]] glm::dvec3 local_model(const Meeting& m, const Branch& branch) {
    const ReflectionConstants& constants = m.material.reflection;
    const bool is_turned = m.material.two_sided && glm::dot(m.at.normal, m.V) < 0;
    const glm::dvec3 N = is_turned ? -m.material.normal : m.material.normal;
    glm::dvec3 I = glm::dvec3(constants.ambient) * scene.ambient();
    scratch.lights.clear();
    scene.lights(m.at.position, scratch.lights, point_footprint(m.at, m.footprint));
    for (std::size_t i = 0; i < scratch.lights.size(); ++i) {
      const TracedLight& light = scratch.lights[i];
      if (!(glm::dot(N, light.to_light) > 0 && largest(light.intensity) > 0)) continue;
      const glm::dvec3 V = visibility(m, light, static_cast<int>(i) + 1, branch);
      if (largest(V) > 0) I += V * light.intensity * reflected_share(constants, {.normal = N, .to_light = light.to_light, .to_eye = m.V});
    }
    return I;
  }

  /// V(p, q_i): what arrives of a light through all that is nearer than it.                                   [A 2.2] [B 5.4]
  glm::dvec3 visibility(const Meeting& m, const TracedLight& light, int number, const Branch& branch) {
    if (!light.casts_shadows && !settings.shadows_of_all) return glm::dvec3(1);
    ++scratch.shadow_rays;
    Branch shadow = leaving(m, light.to_light, RayKind::shadow, glm::dvec3(1), branch);
    shadow.ray.t_max = light.distance - safe_offset(m.at);
    const bool is_simple = scene.has_only_opaque_casters() && shadow.skipped_item < 0;
    const glm::dvec3 share = is_simple ? glm::dvec3(scene.accelerator().any(shadow.ray, scratch.traversal) ? 0 : 1) : share_through(m, shadow);
    if (tree) {
      const int index = tree->add(RayKind::shadow, branch.node, branch.level, branch.weight, shadow.ray, number);
      tree->end(index, largest(share) > 0 ? RayEnd::lit : RayEnd::blocked, share);
    }
    return share;
  }

  /// 0 behind anything opaque; what transmits takes its part and bends nothing.                               [B 5.9, Fig 50]
  glm::dvec3 share_through(const Meeting& m, const Branch& shadow) {
    glm::dvec3 share(1);
    Ray ray = shadow.ray;
    scratch.bodies.clear();
    const bool starts_inside = glm::dot(ray.direction, m.at.geometric_normal) < 0 && largest(m.material.transmitted) > 0;
    if (starts_inside && scene.casts_shadow(m.hit.item)) scratch.bodies.start_behind(m.material, scene.object_of(m.hit.item));
    while (const Hit hit = nearest(ray, shadow.skipped_item)) {
      scene.go_on_behind(hit, ray);
      if (!scene.casts_shadow(hit.item)) continue;
      if (!scene.lets_light_through(hit.item) || !(largest(share) > 0)) return glm::dvec3(0);
      const SurfacePoint at = scene.geometry().surface(ray, hit);
      const PointMaterial material = scene.material(hit.item, at);
      if (material.is_cut_out) continue;
      const bool comes_in = glm::dot(ray.direction, at.geometric_normal) < 0;
      share *= (1 - material.alpha) + material.alpha * scratch.bodies.share(material, scene.object_of(hit.item), hit.t, comes_in);
    }
    return share * share_around_light(shadow);
  }

  /// What the bodies that the light itself is in absorb: those that the ray leaves beyond it. Of others it has met a sheet.
  double share_around_light(const Branch& shadow) {
    double share = 1;
    const double t_light = shadow.ray.t_max;
    Ray beyond{.origin = shadow.ray.origin, .direction = shadow.ray.direction, .t_min = t_light};
    while (scratch.bodies.may_absorb()) {
      const Hit hit = nearest(beyond, shadow.skipped_item);
      if (!hit) break;
      const SurfacePoint at = scene.geometry().surface(beyond, hit);
      share *= scratch.bodies.share_around_light(scene.object_of(hit.item), t_light, glm::dot(beyond.direction, at.geometric_normal) > 0);
      scene.go_on_behind(hit, beyond);
    }
    return share;
  }

  Branch leaving(const Meeting& m, const glm::dvec3& direction, RayKind kind, const glm::dvec3& coefficient, const Branch& from) const {
    const Departure start = departure(m.at, direction, scene.geometry().is_convex(m.hit.item), settings.remedy, settings.tolerance);
    return {.ray = start.ray, .kind = kind, .level = from.level + 1, .parent = from.node, .weight = m.material.alpha * coefficient * from.weight,
            .skipped_item = start.skips_surface ? m.hit.item : -1};
  }
};

}  // namespace

glm::dvec3 RayTracer::radiance(const Ray& ray, TraceScratch& scratch, RayTree* tree, const NeighbourRays* neighbours) const {
  scratch.rays_of_this_eye_ray = 0;
  if (tree) tree->clear();
  if (!is_sound(ray)) return glm::dvec3(0);
  return Tracing{scene_, settings_, scratch, tree, neighbours}.ray_tracing({.ray = ray});
}

Hit RayTracer::first_hit(const Ray& ray, TraceScratch& scratch) const {
  Hit hit = scene_.accelerator().nearest(ray, scratch.traversal);
  for (Ray beyond = ray; hit && scene_.lets_light_through(hit.item); hit = scene_.accelerator().nearest(beyond, scratch.traversal)) {
    if (!scene_.material(hit.item, scene_.geometry().surface(beyond, hit)).is_cut_out) break;
    scene_.go_on_behind(hit, beyond);
  }
  return hit;
}

}  // namespace tuberia::tracer
