#include "base/parallel_for.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace tuberia {

TEST_CASE("parallel_for: every item runs once, by a worker in range", "[base][threads]") {
  // Seven threads are more than this machine may have cores; results must not care.
  for (const int thread_count : {1, 2, 3, 7, 16})
    for (const std::int64_t count : {0, 1, 2, 1000, 100000}) {
      Workers workers(thread_count);
      REQUIRE(workers.thread_count() == thread_count);
      std::vector<int> calls(static_cast<std::size_t>(count));
      std::atomic<bool> workers_in_range{true};
      parallel_for(workers, count, [&](std::int64_t item, int worker) {
        ++calls[static_cast<std::size_t>(item)];
        if (worker < 0 || worker >= thread_count) workers_in_range = false;
      });
      CHECK(std::all_of(calls.begin(), calls.end(), [](int n) { return n == 1; }));
      CHECK(workers_in_range);
    }
}

TEST_CASE("parallel_for: no two running calls share a worker index", "[base][threads]") {
  constexpr int kThreads = 7;
  Workers workers(kThreads);
  std::vector<std::atomic<int>> running(kThreads);
  std::atomic<bool> shared{false};
  parallel_for(workers, 2000, [&](std::int64_t, int worker) {
    auto& mine = running[static_cast<std::size_t>(worker)];
    if (mine.fetch_add(1) != 0) shared = true;
    std::this_thread::yield();
    mine.fetch_sub(1);
  });
  CHECK_FALSE(shared);
}

TEST_CASE("parallel_for: what the items wrote can be read when it returns", "[base][threads]") {
  Workers workers(7);
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::vector<std::int64_t> squares(501, -1);
    parallel_for(workers, 501, [&](std::int64_t item, int) { squares[static_cast<std::size_t>(item)] = item * item; });
    for (std::int64_t item = 0; item < 501; ++item) REQUIRE(squares[static_cast<std::size_t>(item)] == item * item);
  }
}

namespace {

/// How many of `count` items meet all the others, which only so many threads can satisfy; a busy
/// machine may take a while to start them, but not this long.
int how_many_meet(Workers& workers, int count) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(60);
  std::atomic<int> arrived{0}, met_all{0};
  parallel_for(workers, count, [&](std::int64_t, int) {
    ++arrived;
    while (arrived < count && Clock::now() < deadline) std::this_thread::yield();
    if (Clock::now() < deadline) ++met_all;
  });
  return met_all;
}

}  // namespace

TEST_CASE("parallel_for: seven threads really are seven, whatever the core count", "[base][threads]") {
  Workers workers(7);
  CHECK(how_many_meet(workers, 7) == 7);
}

TEST_CASE("parallel_for: workers with few threads leave others theirs", "[base][threads]") {
  Workers two(2), seven(7);
  auto three = std::make_unique<Workers>(3);
  CHECK(how_many_meet(seven, 7) == 7);
  three.reset();
  Workers nine(9);
  CHECK(how_many_meet(seven, 7) == 7);
  CHECK(how_many_meet(nine, 9) == 9);
  CHECK(how_many_meet(two, 2) == 2);
}

TEST_CASE("parallel_for: what an item throws reaches the caller, and the next loop is whole", "[base][threads]") {
  Workers workers(4);
  for (int repeat = 0; repeat < 50; ++repeat) {
    CHECK_THROWS_AS(parallel_for(workers, 1000, [&](std::int64_t item, int) { if (item == 7 * repeat) throw std::bad_alloc(); }), std::bad_alloc);
    std::atomic<int> calls{0};
    parallel_for(workers, 100, [&](std::int64_t, int) { ++calls; });
    CHECK(calls == 100);
  }
}

TEST_CASE("parallel_for: zero threads means one per core", "[base][threads]") {
  CHECK(Workers(0).thread_count() == static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
}

}  // namespace tuberia
