#include "reference/ray_tracer/accelerators/search.hpp"

#include <algorithm>

#include "base/assertion.hpp"
#include "reference/ray_tracer/accelerators/slabs.hpp"

namespace tuberia::tracer {
namespace {

bool is_bounded(const Box& box) noexcept { return std::max(largest_component(box.lower), largest_component(box.upper)) <= kLargestCoordinate; }

/// Whether the numbers of a ray can be multiplied by those of boxes.
bool is_ordinary(const Ray& ray) noexcept {
  const double length = largest_component(ray.direction);
  return largest_component(ray.origin) <= kLargestCoordinate && length >= 1 / kLargestCoordinate && length <= kLargestCoordinate;
}

}  // namespace

void Search::open_mailboxes() {
  if (const auto count = static_cast<std::size_t>(items_.count()); traversal_.mailboxes.size() < count) traversal_.mailboxes.resize(count, 0);
  if (++traversal_.ray_number != 0) return;
  // All numbers have been used: the next ray begins anew, and no box may hold its number yet.
  std::fill(traversal_.mailboxes.begin(), traversal_.mailboxes.end(), 0u);
  traversal_.ray_number = 1;
}

void Search::ask_all() noexcept {
  const auto count = static_cast<std::uint32_t>(items_.count());
  for (std::uint32_t item = 0; item < count && !is_over(); ++item) ask(item);
}

BoxedItems boxes_of(const Items& items, Workers& workers) {
  constexpr std::int64_t kChunk = 4096;
  const std::int64_t count = items.count();
  TUBERIA_ASSERT(count < std::int64_t{0xffffffff}, "more items than 32 bits can number");
  std::vector<BoxedItem> all(static_cast<std::size_t>(count));
  parallel_for(workers, (count + kChunk - 1) / kChunk, [&](std::int64_t chunk, int) {
    const std::int64_t end = std::min(count, (chunk + 1) * kChunk);
    for (std::int64_t i = chunk * kChunk; i < end; ++i) all[static_cast<std::size_t>(i)] = {items.bounds(i), static_cast<std::uint32_t>(i)};
  });

  BoxedItems boxed;
  for (const BoxedItem& each : all)
    if (!each.box.empty() && !is_bounded(each.box)) boxed.unbounded.push_back(each.item);
  std::erase_if(all, [](const BoxedItem& each) { return each.box.empty() || !is_bounded(each.box); });
  for (const BoxedItem& each : all) boxed.box.add(each.box);
  if (!all.empty()) boxed.largest_coordinate = std::max(largest_component(boxed.box.lower), largest_component(boxed.box.upper));
  boxed.bounded = std::move(all);
  return boxed;
}

Hit SearchingAccelerator::found(const Ray& ray, Traversal& traversal, bool for_anything) const noexcept {
  ++traversal.work.rays;
  if (!is_sound(ray)) return {};
  Search search(items_, ray, traversal, for_anything);
  if (!is_ordinary(ray)) {
    search.ask_all();
    return search.nearest();
  }
  for (const std::uint32_t item : unbounded_) {
    search.ask(item);
    if (search.is_over()) break;
  }
  if (!search.is_over()) this->search(search);
  return search.nearest();
}

Hit SearchingAccelerator::nearest(const Ray& ray, Traversal& traversal) const noexcept { return found(ray, traversal, false); }

bool SearchingAccelerator::any(const Ray& ray, Traversal& traversal) const noexcept { return static_cast<bool>(found(ray, traversal, true)); }

}  // namespace tuberia::tracer
