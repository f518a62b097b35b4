#pragma once
// The only way the library gets threads.

#include <cstdint>
#include <memory>
#include <type_traits>

namespace tuberia {

/// A fixed number of threads that share loops. The results of a loop must not depend on which
/// worker takes which item: every item has one owner and writes only what it owns.
class Workers {
 public:
  /// thread_count: 1 or more, the caller's thread included; 0 takes one per core.
  explicit Workers(int thread_count = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int thread_count() const noexcept { return thread_count_; }

 private:
  template <class Body>
  friend void parallel_for(Workers&, std::int64_t, Body&&);
  using Call = void (*)(void* body, std::int64_t item, int worker);
  void run(std::int64_t count, void* body, Call call);

  struct Arena;
  int thread_count_;
  std::unique_ptr<Arena> arena_;
};

/// Calls body(item, worker) for every item in [0, count), each once, in no particular order, and
/// returns when all are done. worker is in [0, thread_count) and no two running calls share it,
/// so it may index scratch memory.
template <class Body>
void parallel_for(Workers& workers, std::int64_t count, Body&& body) {
  using Callable = std::remove_reference_t<Body>;
  workers.run(count, const_cast<void*>(static_cast<const void*>(&body)),
              [](void* callable, std::int64_t item, int worker) {
                (*static_cast<Callable*>(callable))(item, worker);
              });
}

}  // namespace tuberia
