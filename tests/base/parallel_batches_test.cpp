#include "base/parallel_batches.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <thread>
#include <vector>

namespace tuberia {
namespace {

/// Long enough for others to come in between.
void dawdle() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(2);
  while (std::chrono::steady_clock::now() < end) {}
}

/// Checks every promise while it counts. Batch b has 1 + b % most_pieces pieces and 3 * (b % 40) items: some have none.
class WatchedWork : public BatchedWork {
 public:
  WatchedWork(const Workers& workers, std::int64_t batches, int most_pieces)
      : threads_(workers.thread_count()), most_pieces_(most_pieces), produced_(static_cast<std::size_t>(batches)),
        consumed_(static_cast<std::size_t>(batches)), owner_(static_cast<std::size_t>(slot_count(workers, most_pieces))),
        running_(static_cast<std::size_t>(workers.thread_count())) {
    for (auto& owner : owner_) owner = -1;
  }

  int pieces(std::int64_t batch) const noexcept override { return static_cast<int>(1 + batch % most_pieces_); }

  void produce(std::int64_t batch, int piece, int slot) override {
    const std::int64_t me = name_of(batch, piece);
    keep(slot >= 0 && slot < static_cast<int>(owner_.size()));
    keep(owner_[static_cast<std::size_t>(slot)].exchange(me) == -1);  // it was free
    // At most one batch ahead of the one that is open or next to be.
    const std::int64_t gathered = gathered_;
    keep(batch <= gathered || (batch == gathered + 1 && (gathered == 0 || is_consumed(gathered - 1))));
    dawdle();
    ++produced_[static_cast<std::size_t>(batch)];
  }

  std::int64_t gather(std::int64_t batch, std::span<const int> slots) override {
    release();
    keep(batch == gathered_ && !in_gather_.exchange(true));
    keep(static_cast<int>(slots.size()) == pieces(batch) && produced_[static_cast<std::size_t>(batch)] == pieces(batch));
    for (std::size_t i = 0; i < slots.size(); ++i) keep(owner_[static_cast<std::size_t>(slots[i])] == name_of(batch, static_cast<int>(i)));
    keep(batch == 0 || is_consumed(batch - 1));
    open_ = {slots.begin(), slots.end()};
    items_.assign(static_cast<std::size_t>(items_of(batch)), 0);
    ++gathered_;
    in_gather_ = false;
    // A batch without items is over at once, and so are its slots.
    if (items_.empty()) release();
    return items_of(batch);
  }

  void consume(std::int64_t item, int worker) override {
    keep(worker >= 0 && worker < threads_);
    keep(running_[static_cast<std::size_t>(worker)].fetch_add(1) == 0);
    const std::int64_t batch = gathered_ - 1;
    dawdle();
    ++items_[static_cast<std::size_t>(item)];
    // The last one out gives the slots back, before the schedule can.
    if (++consumed_[static_cast<std::size_t>(batch)] == items_of(batch)) release();
    running_[static_cast<std::size_t>(worker)].fetch_sub(1);
  }

  bool all_done() const {
    for (std::size_t b = 0; b < produced_.size(); ++b)
      if (produced_[b] != pieces(static_cast<std::int64_t>(b)) || consumed_[b] != items_of(static_cast<std::int64_t>(b))) return false;
    return gathered_ == static_cast<std::int64_t>(produced_.size());
  }
  bool kept() const { return kept_; }

 private:
  static std::int64_t name_of(std::int64_t batch, int piece) { return batch * 1000 + piece; }
  bool is_consumed(std::int64_t batch) const { return consumed_[static_cast<std::size_t>(batch)] == items_of(batch); }
  static int items_of(std::int64_t batch) { return static_cast<int>(3 * (batch % 40)); }
  void keep(bool promise) { if (!promise) kept_ = false; }
  void release() {
    for (const int slot : open_) owner_[static_cast<std::size_t>(slot)] = -1;
    keep(std::all_of(items_.begin(), items_.end(), [](int n) { return n == 1; }));
    open_.clear();
  }

  int threads_, most_pieces_;
  std::vector<std::atomic<int>> produced_, consumed_;
  std::vector<std::atomic<std::int64_t>> owner_;  // of a slot: the piece in it, -1: nobody
  std::vector<std::atomic<int>> running_;         // calls of each worker
  std::vector<int> open_, items_;                 // of the batch that is being consumed
  std::atomic<std::int64_t> gathered_{0};
  std::atomic<bool> in_gather_{false}, kept_{true};
};

/// Batches of two pieces and four items, whose calls a test may replace.
struct PliableWork : BatchedWork {
  std::function<void(std::int64_t, int)> when_produced = [](std::int64_t, int) {};
  std::function<void(std::int64_t)> when_gathered = [](std::int64_t) {};
  std::function<void(std::int64_t, std::int64_t)> when_consumed = [](std::int64_t, std::int64_t) {};
  std::int64_t batch = 0;
  std::atomic<int> consumed{0};

  int pieces(std::int64_t) const noexcept override { return 2; }
  void produce(std::int64_t of, int piece, int) override { when_produced(of, piece); }
  std::int64_t gather(std::int64_t of, std::span<const int>) override {
    when_gathered(of);
    batch = of;
    return 4;
  }
  void consume(std::int64_t item, int) override {
    when_consumed(batch, item);
    ++consumed;
  }
};

/// Waits for what another thread does; a busy machine may take a while, but not this long.
bool comes_true(const std::atomic<bool>& what) {
  using Clock = std::chrono::steady_clock;
  for (const auto deadline = Clock::now() + std::chrono::seconds(60); !what && Clock::now() < deadline;) std::this_thread::yield();
  return what;
}

}  // namespace

TEST_CASE("parallel_batches: every piece and every item once, in slots and in an order as promised", "[base][threads]") {
  for (const int threads : {1, 2, 3, 7, 16})
    for (const std::int64_t batches : {0, 1, 2, 3, 100})
      for (const int most_pieces : {1, 2, 5, 30}) {
        Workers workers(threads);
        WatchedWork work(workers, batches, most_pieces);
        parallel_batches(workers, batches, most_pieces, work);
        INFO(threads << " threads, " << batches << " batches of up to " << most_pieces << " pieces");
        CHECK(work.all_done());
        CHECK(work.kept());
      }
}

TEST_CASE("parallel_batches: heavy neighbours are shared, too", "[base][threads]") {
  // The first of 400 items waits for one of the next but seven: whoever has it must have left those to the other.
  struct Heavy : BatchedWork {
    std::array<std::atomic<bool>, 2> has_come{};
    std::atomic<bool> neighbour_begun{false}, in_time{true};
    int pieces(std::int64_t) const noexcept override { return 1; }
    void produce(std::int64_t, int, int) override {}
    std::int64_t gather(std::int64_t, std::span<const int>) override { return 400; }
    void consume(std::int64_t item, int worker) override {
      has_come[static_cast<std::size_t>(worker)] = true;
      if (!comes_true(has_come[static_cast<std::size_t>(1 - worker)])) in_time = false;
      if (item >= 8 && item < 16) neighbour_begun = true;
      if (item == 0 && !comes_true(neighbour_begun)) in_time = false;
    }
  } work;
  Workers two(2);
  parallel_batches(two, 2, 1, work);
  CHECK(work.in_time);
}

TEST_CASE("parallel_batches: nobody waits for the last piece of a batch, nor for its last item", "[base][threads]") {
  Workers two(2);
  PliableWork work;
  std::atomic<bool> second_begun{false}, third_begun{false};
  std::atomic<bool> in_time{true};
  work.when_produced = [&](std::int64_t batch, int piece) {
    if (batch == 0 && piece == 1 && !comes_true(second_begun)) in_time = false;
    if (batch == 1) second_begun = true;
    if (batch == 2) third_begun = true;
  };
  work.when_consumed = [&](std::int64_t batch, std::int64_t item) {
    if (batch == 1 && item == 3 && !comes_true(third_begun)) in_time = false;
  };
  parallel_batches(two, 3, 2, work);
  CHECK(in_time);
  CHECK(work.consumed == 12);
}

TEST_CASE("parallel_batches: what a call throws reaches the caller, and the next loop is whole", "[base][threads]") {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    const auto fails = [&](auto&& spoil) {
      PliableWork work;
      spoil(work);
      CHECK_THROWS_AS(parallel_batches(workers, 50, 2, work), std::bad_alloc);
    };
    fails([](PliableWork& work) { work.when_produced = [](std::int64_t batch, int) { if (batch == 20) throw std::bad_alloc(); }; });
    fails([](PliableWork& work) { work.when_gathered = [](std::int64_t batch) { if (batch == 20) throw std::bad_alloc(); }; });
    fails([](PliableWork& work) { work.when_consumed = [](std::int64_t batch, std::int64_t item) { if (batch == 20 && item == 2) throw std::bad_alloc(); }; });
    PliableWork work;
    parallel_batches(workers, 50, 2, work);
    CHECK(work.consumed == 200);
  }
}

TEST_CASE("parallel_batches: after a failure nothing more begins", "[base][threads]") {
  // One call fails when another thread has come, too; a call that begins after that gives the schedule time to learn of it.
  struct Failing : BatchedWork {
    enum Half { of_produce, of_gather, of_consume } half = of_produce;
    std::atomic<bool> other_has_come{false}, failed{false};
    std::atomic<int> calls{0}, gathered{0}, begun_afterwards{0};
    int pieces(std::int64_t) const noexcept override { return 100; }
    void call(bool may_fail) {
      if (failed) {
        ++begun_afterwards;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      if (!may_fail) return;
      if (++calls > 1) other_has_come = true, comes_true(failed);
      else if (comes_true(other_has_come)) failed = true, throw std::bad_alloc();
    }
    void produce(std::int64_t, int, int) override { call(half == of_produce); }
    std::int64_t gather(std::int64_t, std::span<const int>) override {
      if (++gathered == 1 && half == of_gather) failed = true, throw std::bad_alloc();
      return 400;
    }
    void consume(std::int64_t, int) override { call(half == of_consume); }
  };
  constexpr int kThreads = 5;
  Workers workers(kThreads);
  for (const auto half : {Failing::of_produce, Failing::of_gather, Failing::of_consume}) {
    Failing work;
    work.half = half;
    CHECK_THROWS_AS(parallel_batches(workers, 3, 100, work), std::bad_alloc);
    CHECK(work.gathered == (half == Failing::of_produce ? 0 : 1));
    CHECK(work.begun_afterwards <= 3 * kThreads);  // not the hundreds that are left
  }
}

TEST_CASE("parallel_batches: a single piece is done by the caller", "[base][threads]") {
  struct Single : PliableWork {
    int pieces(std::int64_t) const noexcept override { return 1; }
  } work;
  Workers workers(3);
  std::thread::id by{};
  work.when_produced = [&](std::int64_t, int) { by = std::this_thread::get_id(); };
  parallel_batches(workers, 1, 1, work);
  CHECK(by == std::this_thread::get_id());
  CHECK(work.consumed == 4);
}

}  // namespace tuberia
