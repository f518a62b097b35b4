#include "reference/oracle/lighting.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

using Triple = std::array<Interval, 3>;

Triple exact(const glm::vec3& v) { return {one_float(v.x), one_float(v.y), one_float(v.z)}; }
Triple operator+(const Triple& a, const Triple& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Triple operator-(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Triple operator*(const Triple& a, Interval s) { return {a[0] * s, a[1] * s, a[2] * s}; }
Interval dot(const Triple& a, const Triple& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

/// A float vector to unit length takes at most eight roundings a coordinate: the squared length counts half
/// its three, then root, reciprocal and product; out of range two divisions more. 2^-20 allows sixteen.
Triple unit_of(const Triple& v) {
  double least = 0, most = 0;
  for (const Interval& x : v) {
    if (!x.is_known()) return {unknown(), unknown(), unknown()};
    const Interval size = absolute(x);
    least += size.low * size.low;
    most += size.high * size.high;
  }
  if (most == 0) return {0.0, 0.0, 0.0};
  Triple unit;
  for (std::size_t i = 0; i < 3; ++i) {
    // Towards 0 the length is at most `most`, away from it at least `least`; no coordinate exceeds 1.
    const auto share = [&](double x, bool is_low) { return x == 0 ? 0 : x / std::sqrt((x > 0) == is_low ? most : least); };
    unit[i] = widened(clamped({std::max(share(v[i].low, true), -1.0), std::min(share(v[i].high, false), 1.0)}, -1, 1), 0x1p-20);
  }
  return unit;
}

/// base^exponent by the documents' error, 3e-7 (1 + |exponent log2(base)|); powers below 2^-126 may be 0, and
/// bases below the normal floats may count as the smallest of these.
Interval power(Interval base, double exponent) {
  if (!base.is_known()) return unknown();
  if (exponent == 0) return 1.0;
  constexpr double kSmallestNormal = 0x1p-126;
  const auto bound = [&](double b, double side) {
    const double p = std::pow(b, exponent), error = 3e-7 * (1 + std::abs(exponent * std::log2(b)));
    return std::max(p * (1 + side * error) + side * 0x1p-125, 0.0);
  };
  const double low = base.low <= kSmallestNormal ? 0 : bound(base.low, -1);
  const double high = base.high <= 0 ? 0 : bound(std::max(base.high, kSmallestNormal), 1);
  return high > 1e38 ? unknown() : Interval{low, high};
}

Interval highlight(const Lighting& lighting, const Triple& n, const Triple& l, const Triple& v) {
  const Triple mirrored = n * (Interval(2.0) * dot(l, n)) - l;
  const Interval cosine = lighting.halfway ? dot(n, unit_of(l + v)) : dot(mirrored, v);
  return power(cosine, static_cast<double>(lighting.shininess));
}

/// The length of a float vector, its square clamped to at most 1e30: three products, two sums, a root.
Interval length_of(const Triple& v) {
  double least = 0, most = 0;
  for (const Interval& x : v) {
    if (!x.is_known()) return {0, 1e15};
    const Interval size = absolute(x);
    least += size.low * size.low;
    most += size.high * size.high;
  }
  const Interval length = widened({std::sqrt(least), std::sqrt(most)}, 0x1p-20);
  return {std::clamp(length.low, 0.0, 1e15), std::clamp(length.high, 0.0, 1.000001e15)};
}

/// 1/(d + d0) or 1/(4 pi d^2); d + d0 and d are at least a millionth.
Interval falloff(const Light& light, const Triple& way) {
  constexpr double kPi = 3.14159265358979323846;
  const Interval least = widened(1e-6, 0x1p-20), distance = length_of(way);
  switch (light.falloff) {
    case Falloff::none: break;
    case Falloff::linear: return widened(Interval(1.0) / larger(distance + one_float(light.falloff_distance), least.low), 0x1p-20);
    case Falloff::inverse_square: {
      const Interval d{std::max(distance.low, least.low), std::max(distance.high, least.high)};
      return widened({1 / (4 * kPi * d.high * d.high), 1 / (4 * kPi * d.low * d.low)}, 0x1p-20);
    }
  }
  return 1.0;
}

/// 1 within the inner cone, 0 outside the outer one, t^2 (3 - 2t) between. The edge is at least a
/// millionth wide, give or take what rounding makes of so small a difference of cosines.
Interval within_cone(const Light& light, const Triple& l) {
  const Triple axis = exact(light.axis);
  const Interval cosine = -dot(l, axis);
  if (!cosine.is_known()) return {0, 1};
  const double outer = static_cast<double>(light.cos_outer), inner = static_cast<double>(light.cos_inner);
  const double widest = std::max(inner, outer + 1.2e-6) - outer, narrowest = std::max(inner, outer + 0.9e-6) - outer;
  const auto t_of = [&](double c) { return c >= outer ? (c - outer) / narrowest : (c - outer) / widest; };
  const Interval t = clamped(widened({(cosine.low - outer) / (cosine.low >= outer ? widest : narrowest), t_of(cosine.high)}, 0x1p-20), 0, 1);
  const auto smooth = [](double x) { return x * x * (3 - 2 * x); };
  return clamped(widened({smooth(t.low), smooth(t.high)}, 0x1p-20), 0, 1);
}

Triple of_light(const Lighting& lighting, const Light& light, const Triple& point, const Triple& n, const Triple& v) {
  const Triple towards = exact(light.towards);
  const Triple l = light.is_point ? unit_of(towards - point) : towards;
  const Interval cosine = dot(n, l);
  if (cosine.high <= 0) return {0.0, 0.0, 0.0};
  Triple reflected = exact(lighting.diffuse) * larger(cosine, 0.0);
  if (lighting.specular != glm::vec3(0)) {
    Interval strength = highlight(lighting, n, l, v);
    if (cosine.low <= 0) strength = hull(strength, 0.0);  // below the surface there is none
    reflected = reflected + exact(lighting.specular) * strength;
  }
  if (light.is_point) reflected = reflected * falloff(light, towards - point);
  if (light.is_spot) reflected = reflected * within_cone(light, l);
  const Triple intensity = exact(light.intensity);
  return {intensity[0] * reflected[0], intensity[1] * reflected[1], intensity[2] * reflected[2]};
}

Triple reflected_light(const Lighting& lighting, const Triple& point, const Triple& n, const Triple& v) {
  Triple sum = exact(lighting.ambient);
  for (const Light& light : lighting.lights) sum = sum + of_light(lighting, light, point, n, v);
  for (Interval& c : sum) c = c.is_known() ? clamped(c, 0, 1) : Interval{0, 1};
  return sum;
}

}  // namespace

Colour lit(const Lighting& lighting, const glm::vec3& at, const glm::vec3& normal) {
  const Triple point = exact(at), n = exact(normal), v = unit_of(exact(lighting.eye) - point);
  const Interval facing = dot(n, v);
  const bool may_turn = lighting.two_sided && !(facing.low >= 0), may_stay = !lighting.two_sided || !(facing.high < 0);
  const Triple kept = reflected_light(lighting, point, n, v), turned = reflected_light(lighting, point, exact(-normal), v);
  Triple sum = may_stay ? kept : turned;
  for (std::size_t c = 0; c < 3; ++c)
    if (may_turn) sum[c] = hull(sum[c], turned[c]);
  return {sum[0], sum[1], sum[2], one_float(lighting.alpha)};
}

}  // namespace tuberia::oracle
