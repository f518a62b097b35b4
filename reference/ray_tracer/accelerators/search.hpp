#pragma once
// What all accelerators share: asking items, counting, and the items without bounds.        [B 5.7]

#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/ray_tracer/accelerators/accelerator.hpp"

namespace tuberia::tracer {

/// One ray on its way through an accelerator.
class Search {
 public:
  /// A search for anything ends with its first hit. The ray is sound.
  Search(const Items& items, const Ray& ray, Traversal& traversal, bool for_anything) noexcept
      : items_(items), ray_(ray), traversal_(traversal), t_min_(ray.t_min), t_min_of_later_(just_before(ray)), for_anything_(for_anything) {
    ray_.ray.t_min = t_min_of_later_;
  }

  const Ray& ray() const noexcept { return ray_.ray; }
  const Hit& nearest() const noexcept { return nearest_; }
  /// What is farther does not count any more; what is as far may.
  double limit() const noexcept { return nearest_ ? nearest_.t : ray_.ray.t_max; }
  bool is_over() const noexcept { return for_anything_ && nearest_; }

  void ask_all() noexcept;
  void ask(std::uint32_t item) noexcept {
    ++traversal_.work.item_tests;
    ray_.ray.t_min = item < ray_.ray.first_item_at_t_min ? t_min_ : t_min_of_later_;
    items_.intersect(item, ray_, nearest_);
  }
  /// Unless this ray has asked it before: for items that are in several voxels. After open_mailboxes.
  void ask_once(std::uint32_t item) noexcept {
    if (traversal_.mailboxes[item] == traversal_.ray_number) return;
    traversal_.mailboxes[item] = traversal_.ray_number;
    ask(item);
  }
  void open_mailboxes();
  void count_volume() noexcept { ++traversal_.work.volume_tests; }

 private:
  /// From where on items are met that are at the ray's t_min itself; its t_min if none may be.
  static double just_before(const Ray& ray) noexcept {
    return ray.first_item_at_t_min == Ray{}.first_item_at_t_min ? ray.t_min : std::nextafter(ray.t_min, -kInfinity);
  }

  const Items& items_;
  PreparedRay ray_;
  Traversal& traversal_;
  double t_min_, t_min_of_later_;
  Hit nearest_;
  bool for_anything_;
};

/// An item on its way into an accelerator.
struct BoxedItem {
  Box box;
  std::uint32_t item = 0;
};

/// Items by what can be done with them. Those whose box is empty are left out: nothing meets them.
struct BoxedItems {
  std::vector<BoxedItem> bounded;
  std::vector<std::uint32_t> unbounded;
  Box box;                         // of the bounded ones
  double largest_coordinate = 0;   // of that box
};

BoxedItems boxes_of(const Items& items, Workers& workers);

/// An accelerator but for its search.
class SearchingAccelerator : public Accelerator {
 public:
  Hit nearest(const Ray& ray, Traversal& traversal) const noexcept final;
  bool any(const Ray& ray, Traversal& traversal) const noexcept final;
  AcceleratorFacts facts() const noexcept final { return facts_; }
  void set_build_seconds(double seconds) noexcept { facts_.build_seconds = seconds; }

 protected:
  explicit SearchingAccelerator(const Items& items) : items_(items) {}

  const Items& items() const noexcept { return items_; }
  /// Every ray asks them.
  void set_unbounded(std::vector<std::uint32_t> unbounded) { unbounded_ = std::move(unbounded); }
  std::int64_t unbounded_bytes() const noexcept { return static_cast<std::int64_t>(unbounded_.size() * sizeof(unbounded_[0])); }

  /// Asks the bounded items that the ray may meet at search.limit() or nearer, until search.is_over().
  virtual void search(Search& search) const noexcept = 0;

  AcceleratorFacts facts_;

 private:
  Hit found(const Ray& ray, Traversal& traversal, bool for_anything) const noexcept;

  const Items& items_;
  std::vector<std::uint32_t> unbounded_;
};

}  // namespace tuberia::tracer
