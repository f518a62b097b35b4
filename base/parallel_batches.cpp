// Two loops a batch, each with all threads waiting at its end for the slowest, cost two threads 4 to 8 % of the chunks' time. Here a
// thread that finds nothing left of one half goes on with the next: with items if a batch is open, else with
// a piece of the next batch, as far as there are slots: docs/decisions/0015-two-threads.md.

#include "base/parallel_batches.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/assertion.hpp"

namespace tuberia {
namespace {

constexpr std::size_t kCacheLine = 64;  // workers' shares lie on lines of their own, since each is written often

// A question for every item would cost 0.5 % of a frame with many batches; a long run is one thread's, however heavy its items
// turn out to be. (8: real frames are as fast as without a limit; it was not tuned further.)
constexpr std::uint32_t kMostItemsAtOnce = 8;

// How often a thread looks for work before it sleeps until there is some. (100: two threads are as fast as if they never slept; it
// was not tuned further.)
constexpr int kLooks = 100;

/// Neighbouring numbers, begin <= i < end.
struct Range {
  std::int64_t begin = 0, end = 0;
};

/// A worker's share of a loop, neighbours together: it takes them from the front, and who has finished his own takes them from
/// the back. Both ends are in one word, so that nobody takes what another has.
class alignas(kCacheLine) Share {
 public:
  void deal(Range all) noexcept { ends_ = word(static_cast<std::uint32_t>(all.begin), static_cast<std::uint32_t>(all.end)); }

  /// An eighth of what is left: few questions, and to the end something for those who help.
  Range take_first(std::uint32_t most) noexcept {
    for (std::uint64_t now = ends_; begin_of(now) < end_of(now);) {
      const std::uint32_t begin = begin_of(now), end = begin + std::clamp((end_of(now) - begin) / 8, 1u, most);
      if (ends_.compare_exchange_weak(now, word(end, end_of(now)))) return {begin, end};
    }
    return {};
  }

  Range take_last() noexcept {
    for (std::uint64_t now = ends_; begin_of(now) < end_of(now);)
      if (const std::uint32_t last = end_of(now) - 1; ends_.compare_exchange_weak(now, word(begin_of(now), last))) return {last, last + 1};
    return {};
  }

 private:
  static std::uint64_t word(std::uint32_t begin, std::uint32_t end) noexcept { return std::uint64_t{end} << 32 | begin; }
  static std::uint32_t begin_of(std::uint64_t word) noexcept { return static_cast<std::uint32_t>(word); }
  static std::uint32_t end_of(std::uint64_t word) noexcept { return static_cast<std::uint32_t>(word >> 32); }

  std::atomic<std::uint64_t> ends_{0};
};

/// A loop's numbers, dealt to the workers in shares.
class Shares {
 public:
  explicit Shares(int workers) : shares_(static_cast<std::size_t>(workers)) {}

  void deal(std::int64_t count) noexcept {
    const auto workers = static_cast<std::int64_t>(shares_.size());
    for (std::int64_t w = 0; w < workers; ++w) shares_[static_cast<std::size_t>(w)].deal({count * w / workers, count * (w + 1) / workers});
  }

  /// At most so many: of the worker's own, then of what the next workers have left; an empty range if there is nothing.
  Range take(int worker, std::uint32_t most) noexcept {
    const auto mine = static_cast<std::size_t>(worker);
    Range taken = shares_[mine].take_first(most);
    for (std::size_t k = 1; taken.begin == taken.end && k < shares_.size(); ++k) taken = shares_[(mine + k) % shares_.size()].take_last();
    return taken;
  }

 private:
  std::vector<Share> shares_;
};

/// A batch whose pieces are being produced, or whose items are being consumed.
struct Batch {
  explicit Batch(int workers) : pieces(workers) {}
  Shares pieces;
  int untaken = 0, unfinished = 0;
  std::vector<int> slots;  // of its pieces
};

struct Piece {
  std::int64_t batch = 0;
  int number = 0, slot = 0;
};

/// Who does what next. All but the items is dealt under a lock: there are few pieces, and they take long.
class Schedule {
 public:
  Schedule(BatchedWork& work, std::int64_t batches, int most_pieces, const Workers& workers)
      : work_(work), batches_(batches), most_pieces_(most_pieces),
        in_flight_{Batch(workers.thread_count()), Batch(workers.thread_count())}, items_(workers.thread_count()) {
    // All memory is asked for here, so that a batch is never left half begun.
    for (Batch& batch : in_flight_) batch.slots.reserve(static_cast<std::size_t>(most_pieces));
    for (int slot = slot_count(workers, most_pieces); slot-- > 0;) free_slots_.push_back(slot);
    begin_batch(0);
  }

  /// What one thread does until all is done, or another has failed.
  void run(int worker) {
    try {
      for (int looks = 0; !is_over_;) {
        const std::uint32_t seen = changes_;
        if (consume_items(worker) || produce_piece(worker)) looks = 0;
        else if (++looks < kLooks) std::this_thread::yield();
        else changes_.wait(seen);
      }
    } catch (...) {
      is_over_ = true;
      tell();
      throw;
    }
  }

 private:
  Batch& batch(std::int64_t number) noexcept { return in_flight_[static_cast<std::size_t>(number % 2)]; }

  /// As many items of the open batch as there are to be had.
  bool consume_items(int worker) {
    std::int64_t consumed = 0;
    for (Range taken; taken = items_.take(worker, kMostItemsAtOnce), taken.begin < taken.end;) {
      for (std::int64_t item = taken.begin; item < taken.end; ++item) {
        if (is_over_) return true;  // somebody failed: this batch is never reported as consumed
        work_.consume(item, worker);
      }
      consumed += taken.end - taken.begin;
    }
    if (consumed == 0) return false;
    // The batch stays open until all items have been reported, so these were all of one batch.
    if ((unconsumed_ -= consumed) == 0) {
      const std::lock_guard lock(mutex_);
      end_batch();
      open_batches();
    }
    return true;
  }

  bool produce_piece(int worker) {
    const std::optional<Piece> piece = take_piece(worker);
    if (!piece) return false;
    work_.produce(piece->batch, piece->number, piece->slot);
    const std::lock_guard lock(mutex_);
    --batch(piece->batch).unfinished;
    open_batches();
    return true;
  }

  std::optional<Piece> take_piece(int worker) {
    const std::lock_guard lock(mutex_);
    if (is_over_) return std::nullopt;
    if (batch(begun_).untaken == 0) {
      // One batch ahead of the one that is open or next to be, at most: there is room for two.
      if (begun_ + 1 == batches_ || begun_ > ended_) return std::nullopt;
      begin_batch(begun_ + 1);
    }
    if (free_slots_.empty()) return std::nullopt;
    Batch& from = batch(begun_);
    const auto number = static_cast<int>(from.pieces.take(worker, 1).begin);
    const int slot = free_slots_.back();
    free_slots_.pop_back();
    --from.untaken;
    from.slots[static_cast<std::size_t>(number)] = slot;
    return Piece{begun_, number, slot};
  }

  void begin_batch(std::int64_t number) {
    Batch& begun = batch(number);
    begun_ = number;
    begun.untaken = begun.unfinished = work_.pieces(number);
    TUBERIA_ASSERT(begun.untaken >= 1 && begun.untaken <= most_pieces_, "a batch has 1 to most_pieces pieces");
    begun.slots.resize(static_cast<std::size_t>(begun.untaken));
    begun.pieces.deal(begun.untaken);
  }

  /// The next batch, if it is whole and its turn has come; and those after it, while there is nothing to consume.
  void open_batches() {
    while (!is_over_ && !is_open_ && ended_ <= begun_ && batch(ended_).unfinished == 0) {
      is_open_ = true;  // first: if gathering fails, nobody gathers again
      const std::int64_t items = work_.gather(ended_, batch(ended_).slots);
      TUBERIA_ASSERT(items >= 0 && items <= std::numeric_limits<std::uint32_t>::max(), "a batch's items are counted in 32 bits");
      unconsumed_ = items;
      items_.deal(items);
      if (items == 0) end_batch();
      tell();
    }
  }

  void end_batch() {
    const std::vector<int>& slots = batch(ended_).slots;
    free_slots_.insert(free_slots_.end(), slots.rbegin(), slots.rend());
    is_open_ = false;
    if (++ended_ == batches_) is_over_ = true;
    tell();
  }

  /// There may be work for those who sleep: a batch was opened or ended, or all is over.
  void tell() noexcept {
    ++changes_;
    changes_.notify_all();
  }

  BatchedWork& work_;
  const std::int64_t batches_;
  const int most_pieces_;
  std::mutex mutex_;                  // for all but the items
  std::array<Batch, 2> in_flight_;    // those with even and with odd numbers
  std::int64_t begun_ = 0;            // the last batch whose pieces have been dealt
  std::int64_t ended_ = 0;            // how many are consumed, which is the number of the one that is open or next to be
  bool is_open_ = false;
  std::vector<int> free_slots_;
  Shares items_;                      // of the open batch
  alignas(kCacheLine) std::atomic<std::int64_t> unconsumed_{0};
  std::atomic<bool> is_over_{false};
  std::atomic<std::uint32_t> changes_{0};
};

}  // namespace

int slot_count(const Workers& workers, int most_pieces) noexcept {
  const int threads = workers.thread_count();
  return most_pieces + (threads > 1 ? threads : 0);
}

void parallel_batches(Workers& workers, std::int64_t batches, int most_pieces, BatchedWork& work) {
  if (batches == 0) return;
  // A single piece needs nobody's help, and its few items perhaps nobody's either.
  if (batches == 1 && work.pieces(0) == 1) {
    work.produce(0, 0, 0);
    parallel_for(workers, work.gather(0, std::array{0}), [&](std::int64_t item, int worker) { work.consume(item, worker); });
    return;
  }
  Schedule schedule(work, batches, most_pieces, workers);
  parallel_for(workers, workers.thread_count(), [&](std::int64_t, int worker) { schedule.run(worker); });
}

}  // namespace tuberia
