#include "base/parallel_for.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

// The thread sanitizer sees races everywhere in a library that is not compiled with it. Under the
// sanitizer the same loops run on plain threads, so that it checks what our loops do.
#if defined(__SANITIZE_THREAD__)
#define TUBERIA_PLAIN_THREADS 1
#else
#define TUBERIA_PLAIN_THREADS 0
#endif

namespace tuberia {

struct Workers::Arena {
  // Without the control, the library would give no arena more threads than there are cores, and
  // the tests could not show that seven threads draw what one draws.
  explicit Arena(int thread_count)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(thread_count)),
        arena(thread_count) {}
  tbb::global_control control;
  tbb::task_arena arena;
};

namespace {

int threads_or_cores(int thread_count) {
  if (thread_count > 0) return thread_count;
  const unsigned cores = std::thread::hardware_concurrency();
  return cores > 0 ? static_cast<int>(cores) : 1;
}

}  // namespace

Workers::Workers(int thread_count) : thread_count_(threads_or_cores(thread_count)) {
  if (thread_count_ > 1) arena_ = std::make_unique<Arena>(thread_count_);
}

Workers::~Workers() = default;

void Workers::run(std::int64_t count, void* body, Call call) {
  // One thread, or one item, needs nobody's help.
  if (!arena_ || count <= 1) {
    for (std::int64_t item = 0; item < count; ++item) call(body, item, 0);
    return;
  }

#if TUBERIA_PLAIN_THREADS
  std::atomic<std::int64_t> next{0};
  const auto work = [&](int worker) {
    for (std::int64_t item = next++; item < count; item = next++) call(body, item, worker);
  };
  std::vector<std::thread> others;
  for (int worker = 1; worker < thread_count_; ++worker) others.emplace_back(work, worker);
  work(0);
  for (std::thread& other : others) other.join();
#else
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::int64_t>(0, count, 1),
        [&](const tbb::blocked_range<std::int64_t>& range) {
          const int worker = tbb::this_task_arena::current_thread_index();
          for (std::int64_t item = range.begin(); item != range.end(); ++item) call(body, item, worker);
        },
        tbb::simple_partitioner{});
  });
#endif
}

}  // namespace tuberia
