#include "examples/tuberia/witness/explaining.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/colour.hpp"

namespace tuberia::witness {
namespace {

constexpr int kDirections = 16, kRings = 4;  // of places around a pixel's centre

int code_of(double light) { return srgb_code_from_linear(std::clamp(light, 0.0, 1.0)); }

/// All subsets of a set of techniques, small ones first.
std::vector<Causes> subsets_of(Causes techniques) {
  std::vector<Causes> subsets;
  for (unsigned bits = 0; bits < 1u << kCauseCount; ++bits)
    if (Causes(bits).is_within(techniques)) subsets.emplace_back(bits);
  std::stable_sort(subsets.begin(), subsets.end(), [](Causes a, Causes b) { return a.count() < b.count(); });
  return subsets;
}

}  // namespace

Rgba8 Development::code(const glm::dvec3& light) const {
  glm::dvec3 exposed = light * factor;
  if (overflow == description::Overflow::hue_preserving) exposed /= std::max({exposed.r, exposed.g, exposed.b, 1.0});
  const auto code = [](double channel) { return static_cast<std::uint8_t>(code_of(channel)); };
  return {code(exposed.r), code(exposed.g), code(exposed.b), 255};
}

bool Development::may_be(const Rgba8& colour, const LightRange& light) const {
  if (light.empty()) return false;
  const int drawn[3] = {colour.r, colour.g, colour.b};
  for (int c = 0; c < 3; ++c) {
    double low = light.low[c] * factor, high = light.high[c] * factor;
    if (overflow == description::Overflow::hue_preserving) {
      // A channel is least where the others are most, and the other way round.
      const double least_divisor = std::max({high, light.low[(c + 1) % 3] * factor, light.low[(c + 2) % 3] * factor, 1.0});
      low /= std::max({low, light.high[(c + 1) % 3] * factor, light.high[(c + 2) % 3] * factor, 1.0});
      high /= least_divisor;
    }
    if (drawn[c] < code_of(low) - kToleratedCodes || drawn[c] > code_of(high) + kToleratedCodes) return false;
  }
  return true;
}

Explaining::Sight Explaining::nearest(const Place& place, tracer::TraceScratch& scratch) const {
  const tracer::Ray ray = imitation_.ray(place);
  return {place, ray, tracer_.first_hit(ray, scratch)};
}

/// The centre first, then rings of growing radius up to kEdgeDistance.
Explaining::Sights Explaining::around(const glm::ivec2& pixel, tracer::TraceScratch& scratch) const {
  Sights sights{nearest({.pixel = pixel}, scratch)};
  for (int ring = 1; ring <= kRings; ++ring)
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections, radius = kEdgeDistance * ring / kRings;
      sights.push_back(nearest({.pixel = pixel, .offset = radius * glm::dvec2(std::cos(angle), std::sin(angle))}, scratch));
    }
  return sights;
}

/// Depth in the buffer, 0 near .. 1 far; the background's is 1.
double Explaining::depth_of(const Sight& sight) const {
  if (!sight.hit) return 1;
  const auto basis = basis_of(camera_);
  const double z = -glm::dot(sight.ray.at(sight.hit.t) - camera_.eye, basis->w), near_distance = camera_.view.near_distance, far_distance = camera_.view.far_distance;
  if (camera_.projection == Projection::orthographic) return (z - near_distance) / (far_distance - near_distance);
  return far_distance / (far_distance - near_distance) * (1 - near_distance / z);
}

/// What lies behind a sight's surface by no more than the depth buffer can tell apart.
void Explaining::add_behind(Sights& sights, tracer::TraceScratch& scratch) const {
  const std::size_t count = sights.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = depth_of(sights[i]);
    for (Sight behind = sights[i]; behind.hit;) {
      behind.ray.t_min = behind.hit.t;
      behind.hit = tracer_.first_hit(behind.ray, scratch);
      if (!behind.hit || depth_of(behind) - depth > kDepthQuantum) break;
      sights.push_back(behind);
    }
  }
}

int Explaining::object_of(const Sight& sight) const { return sight.hit ? tracer_.scene().object_of(sight.hit.item) : -1; }

LightRange Explaining::light(const Sight& sight, Causes techniques, tracer::TraceScratch& scratch) const {
  if (techniques != Causes()) return imitation_.light(sight.place, sight.ray, sight.hit, techniques, scratch);
  const auto beside = [&](int x, int y) { return imitation_.ray({.pixel = sight.place.pixel + glm::ivec2(x, y), .offset = sight.place.offset}); };
  const tracer::NeighbourRays neighbours{.right = beside(1, 0), .down = beside(0, 1)};
  return LightRange::of(tracer_.radiance(sight.ray, scratch, nullptr, &neighbours));
}

/// Whether a clear body that is drawn as rays see it brings by the tracer what its parts give without any technique. If not, another
/// technique's imitation would only put right what the tracer has wrong.
bool Explaining::is_told_truly(const Sight& sight, tracer::TraceScratch& scratch) const {
  if (!imitation_.is_clear(sight.hit) || techniques_along(sight, scratch).has(Cause::transmission)) return true;
  const LightRange by_parts = imitation_.light(sight.place, sight.ray, sight.hit, {}, scratch);
  return development_.may_be(development_.code(light(sight, {}, scratch).low), by_parts);
}

/// Whether the drawn colour lies between those of the sights that see the drawn object.
bool Explaining::gives(const DrawnPixel& drawn, const Sights& sights, Causes techniques, tracer::TraceScratch& scratch) const {
  LightRange range;
  for (const Sight& sight : sights) {
    if (object_of(sight) != drawn.object) continue;
    range.include(light(sight, techniques, scratch));
    if (development_.may_be(drawn.colour, range)) return true;
  }
  return false;
}

/// Of what a ray meets, and behind what is not opaque.
Causes Explaining::techniques_along(Sight sight, tracer::TraceScratch& scratch) const {
  Causes techniques = imitation_.techniques_of(sight.place, sight.ray, sight.hit, scratch);
  while (sight.hit && tracer_.scene().lets_light_through(sight.hit.item)) {
    sight.ray.t_min = sight.hit.t;
    sight.hit = tracer_.first_hit(sight.ray, scratch);
    techniques = techniques | imitation_.techniques_of(sight.place, sight.ray, sight.hit, scratch);
  }
  return techniques;
}

PixelVerdict Explaining::verdict(const glm::ivec2& pixel, const DrawnPixel& drawn, tracer::TraceScratch& scratch) const {
  const Sights centre{nearest({.pixel = pixel}, scratch)};
  if (!is_told_truly(centre.front(), scratch)) return {.differs = true, .explained = false, .causes = {}};
  Sights beside = around(pixel, scratch), behind = centre;
  Causes techniques;
  for (const Sight& sight : beside) techniques = techniques | techniques_along(sight, scratch);
  add_behind(behind, scratch);
  Sights anywhere = beside;
  add_behind(anywhere, scratch);

  struct Hypothesis {
    const Sights* sights;
    Causes of_place;
  };
  std::vector<Hypothesis> places{{&centre, {}}, {&beside, Cause::edge}};
  if (behind.size() > centre.size()) places.push_back({&behind, Cause::depth});
  if (anywhere.size() > beside.size()) places.push_back({&anywhere, Causes(Cause::edge) | Cause::depth});
  const std::vector<Causes> subsets = subsets_of(techniques);
  for (const Hypothesis& place : places)
    for (const Causes subset : subsets) {
      const Causes causes = subset | place.of_place;
      if (causes != Causes() && gives(drawn, *place.sights, subset, scratch)) return {.differs = true, .explained = true, .causes = causes};
    }
  return {.differs = true, .explained = false, .causes = {}};
}

}  // namespace tuberia::witness
