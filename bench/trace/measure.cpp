#include "bench/trace/measure.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "bench/figures/timing.hpp"

namespace tuberia::bench {
namespace {

using Accelerators = std::array<std::unique_ptr<tracer::Accelerator>, kAcceleratorKinds.size()>;

// Rays that ask every item make about so many tests in a round, and for the comparison of hits.
constexpr std::int64_t kTestsOfRound = 4'000'000, kTestsOfComparison = 100'000'000;

std::size_t rays_for(std::int64_t tests, std::int64_t objects, std::size_t most) {
  return std::clamp(static_cast<std::size_t>(tests / std::max<std::int64_t>(objects, 1)), std::size_t{2}, most);
}

std::unique_ptr<tracer::Accelerator> built(tracer::AcceleratorKind kind, const tracer::Items& items, Workers& workers, int times,
                                           tracer::AcceleratorFacts& facts) {
  std::unique_ptr<tracer::Accelerator> accelerator;
  for (int i = 0; i < times; ++i) {
    accelerator.reset();
    accelerator = tracer::make_accelerator(kind, items, workers);
    const double seconds = i == 0 ? accelerator->facts().build_seconds : std::min(facts.build_seconds, accelerator->facts().build_seconds);
    facts = accelerator->facts();
    facts.build_seconds = seconds;
  }
  return accelerator;
}

void count_tests(const Accelerators& accelerators, std::span<const tracer::Ray> rays, ComparedAccelerators& to) {
  const auto ray_count = static_cast<double>(rays.size());
  for (std::size_t i = 0; i < accelerators.size(); ++i) {
    if (kAcceleratorKinds[i] == tracer::AcceleratorKind::none) {
      to.figures[i].item_tests = static_cast<double>(to.objects);
      continue;
    }
    tracer::Traversal traversal;
    for (const tracer::Ray& ray : rays) accelerators[i]->nearest(ray, traversal);
    to.figures[i].item_tests = static_cast<double>(traversal.work.item_tests) / ray_count;
    to.figures[i].volume_tests = static_cast<double>(traversal.work.volume_tests) / ray_count;
  }
}

void compare_hits(const Accelerators& accelerators, std::span<const tracer::Ray> rays, ComparedAccelerators& to) {
  tracer::Traversal traversal;
  for (const tracer::Ray& ray : rays) {
    const tracer::Hit expected = accelerators[0]->nearest(ray, traversal);
    for (std::size_t i = 1; i < accelerators.size(); ++i) {
      ++to.hits_compared;
      to.hits_different += accelerators[i]->nearest(ray, traversal) != expected;
    }
  }
}

void time_rays(const Accelerators& accelerators, std::span<const tracer::Ray> rays, const TraceOptions& options, ComparedAccelerators& to) {
  std::vector<std::function<void()>> ways;
  std::vector<double> ray_counts;
  std::vector<tracer::Traversal> traversals(accelerators.size());
  for (std::size_t i = 0; i < accelerators.size(); ++i) {
    const bool asks_all = kAcceleratorKinds[i] == tracer::AcceleratorKind::none;
    const std::span<const tracer::Ray> some = asks_all ? rays.first(rays_for(kTestsOfRound, to.objects, rays.size())) : rays;
    ray_counts.push_back(static_cast<double>(some.size()));
    ways.emplace_back([some, accelerator = accelerators[i].get(), traversal = &traversals[i]] {
      for (const tracer::Ray& ray : some) accelerator->nearest(ray, *traversal);
    });
  }
  const Effort effort{.seconds = options.quick ? 0.3 : 4, .fewest_rounds = options.quick ? 3 : 9, .of_processor = true};
  const std::vector<RelativeTime> times = time_in_turns(ways, effort);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double rays_ratio = ray_counts[i] / ray_counts[0];
    to.figures[i].nanoseconds = 1e6 * times[i].median_ms / ray_counts[i];
    to.figures[i].speedup = rays_ratio / times[i].ratio;
    to.figures[i].lower_quartile = rays_ratio / times[i].upper_quartile;
    to.figures[i].upper_quartile = rays_ratio / times[i].lower_quartile;
  }
}

}  // namespace

ComparedAccelerators compare_accelerators(const tracer::Items& items, std::span<const tracer::Ray> rays, const TraceOptions& options, bool exhaustive) {
  ComparedAccelerators compared{.objects = items.count(), .figures = {}};
  Workers workers(options.threads);
  Accelerators accelerators;
  for (std::size_t i = 0; i < accelerators.size(); ++i)
    accelerators[i] = built(kAcceleratorKinds[i], items, workers, options.quick ? 1 : 3, compared.figures[i].facts);
  compare_hits(accelerators, exhaustive ? rays : rays.first(rays_for(kTestsOfComparison, items.count(), rays.size())), compared);
  count_tests(accelerators, rays, compared);
  time_rays(accelerators, rays, options, compared);
  return compared;
}

}  // namespace tuberia::bench
