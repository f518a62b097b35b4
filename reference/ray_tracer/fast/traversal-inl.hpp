// One ray through the tree. [WideTrees] [Filters]
// Compiled once per instruction set.

#if defined(TUBERIA_RAY_TRACER_TRAVERSAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RAY_TRACER_TRAVERSAL_INL
#undef TUBERIA_RAY_TRACER_TRAVERSAL_INL
#else
#define TUBERIA_RAY_TRACER_TRAVERSAL_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "reference/ray_tracer/fast/filter_ray-inl.hpp"
#include "reference/ray_tracer/shapes/triangle.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia::tracer {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Eight floats are one register, or two of four.
using Lanes = hn::CappedTag<float, kWidth>;
using Floats = hn::Vec<Lanes>;
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(Lanes{}));

/// Bit i is lane i.
HWY_INLINE std::uint32_t bits_of(hn::Mask<Lanes> mask) {
#if HWY_TARGET == HWY_AVX3
  return static_cast<std::uint32_t>(mask.raw);
#elif HWY_TARGET == HWY_AVX2
  return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.raw));
#elif HWY_TARGET == HWY_SSE4
  return static_cast<std::uint32_t>(_mm_movemask_ps(mask.raw));
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Lanes{}, mask, bytes);
  return bytes[0];
#endif
}

HWY_INLINE Floats all(float value) { return hn::Set(Lanes{}, value); }

/// The nearest hit of a ray so far.
class Nearest {
 public:
  HWY_INLINE void begin(const FastRay& ray) {
    ray_ = &ray;
    t_ = ray.t_max;
    hit_ = {};
    prepared_.reset();
  }

  HWY_INLINE double t() const { return t_; }
  HWY_INLINE const FastHit& hit() const { return hit_; }

  /// Asks the tracer's own test in doubles. Whether the triangle is the nearest now.
  HWY_NOINLINE bool meet(const TriangleBlock& block, int place) {
    if (!prepared_) prepared_.emplace(Ray{glm::dvec3(ray_->origin), glm::dvec3(ray_->direction), ray_->t_min, ray_->t_max});
    std::array<glm::dvec3, 3> corners;
    for (int vertex = 0; vertex < 3; ++vertex)
      for (int axis = 0; axis < 3; ++axis) corners[vertex][axis] = block.corner[vertex][axis][place];
    const std::optional<ShapeHit> met = intersect_triangle(*prepared_, corners);
    if (!met || met->t > t_ || (met->t == t_ && !(block.triangle[place] < hit_.triangle))) return false;
    t_ = met->t;
    hit_ = {static_cast<float>(met->t), block.triangle[place], static_cast<float>(met->at.x), static_cast<float>(met->at.y)};
    return true;
  }

 private:
  const FastRay* ray_;
  std::optional<PreparedRay> prepared_;
  double t_;
  FastHit hit_;
};

struct Vector {
  Floats x, y, z;
};

HWY_INLINE Vector all(const float* v) { return {all(v[0]), all(v[1]), all(v[2])}; }

/// The part of a FilterRay that boxes are tested with, in registers.
class BoxTest {
 public:
  HWY_INLINE explicit BoxTest(const FilterRay& ray)
      : enter_(all(ray.enter)), leave_(all(ray.leave)), minus_inverse_(all(ray.minus_inverse)), t_min_(all(ray.t_min)),
        near_x_(ray.near_plane[0]), near_y_(ray.near_plane[1]), near_z_(ray.near_plane[2]),
        far_x_(ray.far_plane[0]), far_y_(ray.far_plane[1]), far_z_(ray.far_plane[2]) {}

  /// Which children's boxes the ray may meet; `entry`: where it enters them, but not below 0.
  HWY_INLINE std::uint32_t met_children(const WideNode& node, float latest, float* entry) const {
    const Lanes lanes;
    std::uint32_t met = 0;
    for (int part = 0; part < kWidth; part += kLanes) {
      const float* planes = node.planes + part;
      const auto along = [planes](Floats origin, std::size_t plane, Floats minus_inverse) HWY_ATTR {
        return hn::Mul(hn::Sub(origin, hn::Load(Lanes{}, planes + plane)), minus_inverse);
      };
      const Floats near_x = along(enter_.x, near_x_, minus_inverse_.x), far_x = along(leave_.x, far_x_, minus_inverse_.x);
      const Floats near_y = along(enter_.y, near_y_, minus_inverse_.y), far_y = along(leave_.y, far_y_, minus_inverse_.y);
      const Floats near_z = along(enter_.z, near_z_, minus_inverse_.z), far_z = along(leave_.z, far_z_, minus_inverse_.z);
      const Floats near = hn::Max(hn::Max(near_x, near_y), hn::Max(near_z, t_min_));
      const Floats far = hn::Min(hn::Min(far_x, far_y), hn::Min(far_z, all(latest)));
      met |= bits_of(hn::Le(near, far)) << part;
      hn::Store(hn::Max(near, hn::Zero(lanes)), lanes, entry + part);
    }
    return met;
  }

 private:
  Vector enter_, leave_, minus_inverse_;
  Floats t_min_;
  std::size_t near_x_, near_y_, near_z_, far_x_, far_y_, far_z_;
};

/// Which triangles of a block the ray may meet before `latest`.
HWY_INLINE std::uint32_t met_triangles(const TriangleBlock& block, const ShearedRay& ray, float latest) {
  const Lanes lanes;
  std::uint32_t met = 0;
  for (int part = 0; part < kWidth; part += kLanes) {
    Floats x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
      z[i] = hn::Sub(hn::Load(lanes, block.corner[i][ray.axis[2]] + part), all(ray.origin[2]));
      x[i] = hn::Sub(hn::Sub(hn::Load(lanes, block.corner[i][ray.axis[0]] + part), all(ray.origin[0])), hn::Mul(all(ray.shear_x), z[i]));
      y[i] = hn::Sub(hn::Sub(hn::Load(lanes, block.corner[i][ray.axis[1]] + part), all(ray.origin[1])), hn::Mul(all(ray.shear_y), z[i]));
    }
    const auto edge = [&](int from, int to) HWY_ATTR { return hn::Sub(hn::Mul(x[from], y[to]), hn::Mul(y[from], x[to])); };
    const Floats of_a = edge(1, 2), of_b = edge(2, 0), of_c = edge(0, 1);
    const Floats least = hn::Min(of_a, hn::Min(of_b, of_c)), most = hn::Max(of_a, hn::Max(of_b, of_c));
    const Floats tolerance = hn::Add(hn::Mul(hn::Load(lanes, block.size + part), all(ray.area_error_of_size)), all(ray.area_error));
    std::uint32_t inside = bits_of(hn::Or(hn::Ge(least, hn::Neg(tolerance)), hn::Le(most, tolerance)));
    if (inside == 0) continue;
    const Floats t[3] = {hn::Mul(z[0], all(ray.inverse_z)), hn::Mul(z[1], all(ray.inverse_z)), hn::Mul(z[2], all(ray.inverse_z))};
    const Floats nearest = hn::Min(t[0], hn::Min(t[1], t[2]));
    inside &= bits_of(hn::Le(nearest, all(latest)));
    met |= inside << part;
  }
  return met;
}

/// Asks for what will be read soon.
HWY_INLINE void fetch(const WideTree& tree, ChildReference child) {
  constexpr std::size_t kCacheLine = 64, kLines = 4;
  const void* const at = child.is_block() ? static_cast<const void*>(&tree.blocks[child.number()]) : &tree.nodes[child.number()];
  for (std::size_t line = 0; line < kLines; ++line) hwy::Prefetch(static_cast<const char*>(at) + line * kCacheLine);
}

/// Children that wait, each behind where the ray enters it, so that whole numbers compare as entries do.
class WaitingChildren {
 public:
  HWY_INLINE static std::uint64_t entered(float entry, ChildReference child) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(entry)} << 32 | child.code;
  }

  HWY_INLINE void push(std::uint64_t child) { waiting_[count_++] = child; }

  /// The next that is entered before `latest`. Whether there is one.
  HWY_INLINE bool pop(float latest, ChildReference& child) {
    const std::uint64_t last = entered(std::max(latest, 0.0f), {0xffffffff});
    while (count_ > 0) {
      const std::uint64_t next = waiting_[--count_];
      child = {static_cast<std::uint32_t>(next)};
      if (next <= last) return true;
    }
    return false;
  }

  /// Pushes all children in `met` but the nearest, further ones below nearer ones. Returns the nearest.
  HWY_INLINE ChildReference push_all_but_nearest(const WideTree& tree, const WideNode& node, const float* entry, std::uint32_t met) {
    const int begin = count_;
    for (; met != 0; met &= met - 1) {
      const int place = std::countr_zero(met);
      const std::uint64_t added = entered(entry[place], node.child[place]);
      fetch(tree, node.child[place]);
      int at = count_++;
      for (; at > begin && waiting_[at - 1] < added; --at) waiting_[at] = waiting_[at - 1];
      waiting_[at] = added;
    }
    return {static_cast<std::uint32_t>(waiting_[--count_])};
  }

 private:
  std::uint64_t waiting_[kMostWaiting];
  int count_ = 0;
};

/// Visits the blocks that are met before `latest`, the nearest first as far as boxes tell. met_children(node, entry) gives a bit
/// for each child; meet_block(block) may bring `latest` nearer.
template <class MetChildren, class MeetBlock>
HWY_INLINE void traverse(const WideTree& tree, const float& latest, MetChildren met_children, MeetBlock meet_block) {
  WaitingChildren waiting;
  ChildReference child = ChildReference::node(0);
  alignas(32) float entry[kWidth];
  do {
    while (!child.is_block()) {
      const WideNode& node = tree.nodes[child.number()];
      const std::uint32_t met = met_children(node, entry);
      if (met == 0) break;
      const bool is_one = (met & (met - 1)) == 0;
      child = is_one ? node.child[std::countr_zero(met)] : waiting.push_all_but_nearest(tree, node, entry, met);
    }
    if (child.is_block()) meet_block(tree.blocks[child.number()]);
  } while (waiting.pop(latest, child));
}

HWY_INLINE FastHit nearest_of_one(const WideTree& tree, const FastRay& ray, const FilterRay& filter) {
  Nearest nearest;
  nearest.begin(ray);
  float latest = filter.t_max;
  const BoxTest boxes(filter);
  std::optional<ShearedRay> sheared_ray;  // most rays that miss meet no block either
  traverse(
      tree, latest, [&](const WideNode& node, float* entry) HWY_ATTR { return boxes.met_children(node, latest, entry); },
      [&](const TriangleBlock& block) HWY_ATTR {
        if (!sheared_ray) sheared_ray = sheared(filter);
        for (std::uint32_t met = met_triangles(block, *sheared_ray, latest); met != 0; met &= met - 1)
          if (nearest.meet(block, std::countr_zero(met))) latest = filter.latest(nearest.t());
      });
  return nearest.hit();
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia::tracer
HWY_AFTER_NAMESPACE();

#endif
