#include "base/parallel_for.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
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

namespace {

int cores() {
  const unsigned count = std::thread::hardware_concurrency();
  return count > 0 ? static_cast<int>(count) : 1;
}

/// What the thread library is allowed: by itself it gives no arena more threads than there are cores,
/// and the tests could not show that seven threads draw what one draws. A control lifts that, but of
/// several controls the smallest counts, for the whole process. So there is one at most, as large as
/// the largest Workers alive, and none where the cores suffice: the program around us may use them.
class Parallelism {
 public:
  void add(int thread_count) {
    const std::lock_guard lock(mutex_);
    counts_.insert(thread_count);
    adjust();
  }
  void remove(int thread_count) {
    const std::lock_guard lock(mutex_);
    counts_.erase(counts_.find(thread_count));
    adjust();
  }

 private:
  void adjust() {
    const int wanted = counts_.empty() ? 0 : *counts_.rbegin();
    if (wanted == lifted_to_ || (wanted <= cores() && !control_)) return;
    control_.reset();
    lifted_to_ = wanted;
    if (wanted > cores()) control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(wanted));
  }

  std::mutex mutex_;
  std::multiset<int> counts_;
  std::optional<tbb::global_control> control_;
  int lifted_to_ = 0;
};

Parallelism& parallelism() {
  static Parallelism the_only;
  return the_only;
}

}  // namespace

struct Workers::Arena {
  explicit Arena(int count) : thread_count(count) {
    parallelism().add(count);
    arena.initialize(count);
  }
  ~Arena() {
    arena.terminate();
    parallelism().remove(thread_count);
  }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  int thread_count;
  tbb::task_arena arena;
};

Workers::Workers(int thread_count) : thread_count_(thread_count > 0 ? thread_count : cores()) {
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
  std::mutex mutex;
  std::exception_ptr failure;  // the first
  const auto work = [&](int worker) {
    try {
      for (std::int64_t item = next++; item < count; item = next++) call(body, item, worker);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (int worker = 1; worker < thread_count_; ++worker) others.emplace_back(work, worker);
  work(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
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
