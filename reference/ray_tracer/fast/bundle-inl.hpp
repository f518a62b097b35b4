// Rays from one origin that go much the same way, through the tree together. [Packets]
// Compiled once per instruction set.

#if defined(TUBERIA_RAY_TRACER_BUNDLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RAY_TRACER_BUNDLE_INL
#undef TUBERIA_RAY_TRACER_BUNDLE_INL
#else
#define TUBERIA_RAY_TRACER_BUNDLE_INL
#endif

#include <hwy/highway.h>

#include "reference/ray_tracer/fast/traversal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia::tracer {
namespace HWY_NAMESPACE {

inline constexpr int kMostInBundle = 16;
// Of directions, along each axis, as a part of the longest component: beyond, the rays meet too much that not all of them meet.
inline constexpr float kMostSpread = 1.0f / 32;

/// The smallest and the largest of each of the rays' eight numbers.
struct Range {
  FastRay least, most;
  bool has_nan = false;
};

static_assert(sizeof(FastRay) == kWidth * sizeof(float));
HWY_INLINE const float* numbers_of(const FastRay& ray) { return reinterpret_cast<const float*>(&ray); }
HWY_INLINE float* numbers_of(FastRay& ray) { return reinterpret_cast<float*>(&ray); }

HWY_INLINE Range range_of(const FastRay* rays, int count) {
  const Lanes lanes;
  Range range;
  for (int part = 0; part < kWidth; part += kLanes) {
    const auto load = [&](int ray) HWY_ATTR { return hn::LoadU(lanes, numbers_of(rays[ray]) + part); };
    Floats least = load(0), most = least;
    auto numbers = hn::Eq(least, least);
    for (int i = 1; i < count; ++i) {
      const Floats ray = load(i);
      least = hn::Min(least, ray);
      most = hn::Max(most, ray);
      numbers = hn::And(numbers, hn::Eq(ray, ray));
    }
    hn::StoreU(least, lanes, numbers_of(range.least) + part);
    hn::StoreU(most, lanes, numbers_of(range.most) + part);
    range.has_nan |= !hn::AllTrue(lanes, numbers);
  }
  return range;
}

/// What boxes and triangles are tested with, for all rays together. As FilterRay has it, but that there are two
/// reciprocals of each component, the least and the largest.
struct FilterBundle {
  float enter[3], leave[3], minus_inverse[2][3];
  std::size_t near_plane[3], far_plane[3];
  glm::vec3 origin;
  int z;
  float z_sign;
  float volume_error_of_size;
  float t_min;
};

HWY_INLINE bool is_bundle(const WideTree& tree, const Range& range, float furthest) {
  const FastRay &least = range.least, &most = range.most;
  if (range.has_nan || !is_sound(least) || !is_sound(most) || least.origin != most.origin || !(most.t_min < least.t_max)) return false;
  const float longest = std::max(largest_of(least.direction), largest_of(most.direction));
  if (!(longest > kShortest && longest < kLongest && furthest < kFar * largest_of(tree.bounds.upper - tree.bounds.lower))) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = least.direction[axis], high = most.direction[axis];
    const bool have_one_sign = low > 1 / kLargestInverse || high < -1 / kLargestInverse;
    if (!have_one_sign || high - low > kMostSpread * longest) return false;
  }
  return true;
}

/// Whether the rays are a bundle.
HWY_INLINE bool set_up(FilterBundle& bundle, const WideTree& tree, const FastRay* rays, int count) {
  const Range range = range_of(rays, count);
  const float furthest = reach(tree.bounds, range.least.origin);
  if (!is_bundle(tree, range, furthest)) return false;
  FilterRay least, most;
  set_up(least, tree.bounds, range.least.origin, range.least.direction, 0);
  set_up(most, tree.bounds, range.least.origin, range.most.direction, 0);
  for (int axis = 0; axis < 3; ++axis) {
    bundle.enter[axis] = least.enter[axis], bundle.leave[axis] = least.leave[axis];
    bundle.near_plane[axis] = least.near_plane[axis], bundle.far_plane[axis] = least.far_plane[axis];
    bundle.minus_inverse[0][axis] = least.minus_inverse[axis], bundle.minus_inverse[1][axis] = most.minus_inverse[axis];
  }
  bundle.origin = range.least.origin;
  bundle.z = longest_axis(range.least.direction);
  bundle.z_sign = std::copysign(1.0f, range.least.direction[bundle.z]);
  const float longest = std::max(largest_of(range.least.direction), largest_of(range.most.direction));
  bundle.volume_error_of_size = 48 * kUnit * furthest * longest;
  bundle.t_min = range.least.t_min - std::abs(range.least.t_min) * 0x1p-21f;
  return true;
}

/// Which children's boxes any of the rays may meet; `entry` as of one ray.
HWY_INLINE std::uint32_t met_children(const WideNode& node, const FilterBundle& bundle, float latest, float* entry) {
  const Lanes lanes;
  std::uint32_t met = 0;
  for (int part = 0; part < kWidth; part += kLanes) {
    Floats near = all(bundle.t_min), far = all(latest);
    for (int axis = 0; axis < 3; ++axis) {
      const Floats least = all(bundle.minus_inverse[0][axis]), most = all(bundle.minus_inverse[1][axis]);
      const Floats to_near = hn::Sub(all(bundle.enter[axis]), hn::Load(lanes, node.planes + bundle.near_plane[axis] + part));
      const Floats to_far = hn::Sub(all(bundle.leave[axis]), hn::Load(lanes, node.planes + bundle.far_plane[axis] + part));
      near = hn::Max(near, hn::Min(hn::Mul(to_near, least), hn::Mul(to_near, most)));
      far = hn::Min(far, hn::Max(hn::Mul(to_far, least), hn::Mul(to_far, most)));
    }
    met |= bits_of(hn::Le(near, far)) << part;
    hn::Store(hn::Max(near, hn::Zero(lanes)), lanes, entry + part);
  }
  return met;
}

HWY_INLINE Vector operator-(const Vector& a, const Vector& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE Floats dot(const Vector& a, const Vector& b) { return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z)); }
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// The nearest hits of a bundle's rays.
class BundleTraversal {
 public:
  HWY_INLINE BundleTraversal(const FilterBundle& bundle, const FastRay* rays, int count) : bundle_(bundle), rays_(rays), count_(count) {
    for (int i = 0; i < count; ++i) {
      nearest_[i].begin(rays[i]);
      latest_[i] = rays[i].t_max;
    }
    update_latest();
  }

  HWY_INLINE void run(const WideTree& tree) {
    traverse(
        tree, latest_of_all_, [&](const WideNode& node, float* entry) HWY_ATTR { return met_children(node, bundle_, latest_of_all_, entry); },
        [&](const TriangleBlock& block) HWY_ATTR { meet_block(block); });
  }

  HWY_INLINE void store(FastHit* hits) const {
    for (int i = 0; i < count_; ++i) hits[i] = nearest_[i].hit();
  }

 private:
  HWY_INLINE void update_latest() {
    latest_of_all_ = latest_[0];
    for (int i = 1; i < count_; ++i) latest_of_all_ = std::max(latest_of_all_, latest_[i]);
  }

  // The ray passes an edge on the side that the sign of direction . (from x to) says, which all rays share but for the direction.
  HWY_INLINE void meet_block(const TriangleBlock& block) {
    const Lanes lanes;
    bool has_met = false;
    for (int part = 0; part < kWidth; part += kLanes) {
      const auto corner = [&](int i) HWY_ATTR {
        return Vector{hn::Load(lanes, block.corner[i][0] + part), hn::Load(lanes, block.corner[i][1] + part),
                      hn::Load(lanes, block.corner[i][2] + part)};
      };
      const Vector a = corner(0), b = corner(1), c = corner(2), origin = all(&bundle_.origin.x);
      const Vector from_a = a - origin, from_b = b - origin, from_c = c - origin;
      // from x to is from x (to - from), of which less is lost.
      const Vector of_a = cross(from_b, c - b), of_b = cross(from_c, a - c), of_c = cross(from_a, b - a);
      const Floats tolerance = hn::Add(hn::Mul(hn::Load(lanes, block.size + part), all(bundle_.volume_error_of_size)), all(kUnderflow));
      for (int i = 0; i < count_; ++i) {
        const Vector direction = all(&rays_[i].direction.x);
        const Floats side_a = dot(direction, of_a), side_b = dot(direction, of_b), side_c = dot(direction, of_c);
        const Floats least = hn::Min(side_a, hn::Min(side_b, side_c)), most = hn::Max(side_a, hn::Max(side_b, side_c));
        std::uint32_t inside = bits_of(hn::Or(hn::Ge(least, hn::Neg(tolerance)), hn::Le(most, tolerance)));
        for (; inside != 0; inside &= inside - 1) has_met |= meet(block, part + std::countr_zero(inside), i);
      }
    }
    if (has_met) update_latest();
  }

  HWY_INLINE bool meet(const TriangleBlock& block, int place, int ray) {
    // Behind what is met already?
    const auto depth = [&](int corner) { return (block.corner[corner][bundle_.z][place] - bundle_.origin[bundle_.z]) * bundle_.z_sign; };
    const float size = std::abs(rays_[ray].direction[bundle_.z]);
    if (std::min({depth(0), depth(1), depth(2)}) > beyond(latest_[ray] * size)) return false;
    if (!nearest_[ray].meet(block, place)) return false;
    latest_[ray] = beyond(static_cast<float>(nearest_[ray].t()));
    return true;
  }

  const FilterBundle& bundle_;
  const FastRay* rays_;
  int count_;
  Nearest nearest_[kMostInBundle];
  float latest_[kMostInBundle];
  float latest_of_all_;
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia::tracer
HWY_AFTER_NAMESPACE();

#endif
