#include "bench/figures/schedule.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "base/assertion.hpp"

namespace tuberia::bench {

double makespan(std::span<const double> items, int threads) {
  TUBERIA_ASSERT(threads >= 1, "a loop needs a thread");
  // When each thread becomes free, the earliest on top.
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at(
      std::greater<>{}, std::vector<double>(static_cast<std::size_t>(threads), 0.0));
  double end = 0;
  for (const double item : items) {
    const double done = free_at.top() + item;
    free_at.pop();
    free_at.push(done);
    end = std::max(end, done);
  }
  return end;
}

namespace {

/// A draw on more threads than there are, from event to event.
class SimulatedDraw {
 public:
  SimulatedDraw(std::span<const Batch> draw, int threads) : draw_(draw), idle_(threads) {
    std::size_t most_chunks = 0;
    for (const Batch& batch : draw) {
      most_chunks = std::max(most_chunks, batch.chunks.size());
      unfinished_.push_back(batch.chunks.size());
    }
    free_slots_ = most_chunks + (threads > 1 ? static_cast<std::size_t>(threads) : 0);
  }

  double run() {
    open_batches();
    for (;;) {
      while (idle_ > 0 && (begin_tile() || begin_chunk())) --idle_;
      if (running_.empty()) return now_;
      // All that ends at the same time, before anybody looks for work again.
      now_ = running_.top().end;
      for (; !running_.empty() && running_.top().end <= now_; ++idle_) {
        const Running done = running_.top();
        running_.pop();
        if (done.is_tile) --untiled_;
        else --unfinished_[done.batch];
        open_batches();
      }
    }
  }

 private:
  struct Running {
    double end = 0;
    bool is_tile = false;
    std::size_t batch = 0;
    bool operator>(const Running& other) const { return end > other.end; }
  };

  bool begin_tile() {
    if (!is_open_ || next_tile_ == draw_[ended_].tiles.size()) return false;
    running_.push({now_ + draw_[ended_].tiles[next_tile_++], true, ended_});
    return true;
  }

  bool begin_chunk() {
    while (begun_ < draw_.size() && begun_ <= ended_ && next_chunk_ == draw_[begun_].chunks.size()) {
      ++begun_;
      next_chunk_ = 0;
    }
    if (begun_ >= draw_.size() || next_chunk_ == draw_[begun_].chunks.size() || free_slots_ == 0) return false;
    --free_slots_;
    running_.push({now_ + draw_[begun_].chunks[next_chunk_++], false, begun_});
    return true;
  }

  void open_batches() {
    while (ended_ < draw_.size()) {
      if (!is_open_ && unfinished_[ended_] > 0) return;
      if (!is_open_) {
        is_open_ = true;
        next_tile_ = 0;
        untiled_ = draw_[ended_].tiles.size();
      }
      if (untiled_ > 0) return;
      is_open_ = false;
      free_slots_ += draw_[ended_++].chunks.size();
    }
  }

  std::span<const Batch> draw_;
  int idle_;
  double now_ = 0;
  std::priority_queue<Running, std::vector<Running>, std::greater<>> running_;
  std::vector<std::size_t> unfinished_;          // chunks of each batch
  std::size_t begun_ = 0, next_chunk_ = 0;       // the batch whose chunks are dealt
  std::size_t ended_ = 0, next_tile_ = 0, untiled_ = 0;  // the batch whose tiles are dealt, or will be next
  bool is_open_ = false;
  std::size_t free_slots_ = 0;
};

double sum_of(const Loop& loop) { return std::accumulate(loop.begin(), loop.end(), 0.0); }
double longest_of(const Loop& loop) { return loop.empty() ? 0 : *std::max_element(loop.begin(), loop.end()); }

}  // namespace

double duration_of(std::span<const Batch> draw, int threads) {
  TUBERIA_ASSERT(threads >= 1, "a draw needs a thread");
  return SimulatedDraw(draw, threads).run();
}

double Work::total() const {
  double sum = alone;
  for (const Loop& loop : loops) sum += sum_of(loop);
  for (const std::vector<Batch>& draw : draws)
    for (const Batch& batch : draw) sum += sum_of(batch.chunks) + sum_of(batch.tiles);
  return sum;
}

double Work::duration(int threads) const {
  double sum = alone;
  for (const Loop& loop : loops) sum += makespan(loop, threads);
  for (const std::vector<Batch>& draw : draws) sum += duration_of(joined(draw, threads), threads);
  return sum;
}

double Work::longest_chain(int threads) const {
  double sum = alone;
  for (const Loop& loop : loops) sum += longest_of(loop);
  for (const std::vector<Batch>& draw : draws) {
    if (!draw.empty()) sum += longest_of(joined(draw, threads).front().chunks);
    for (const Batch& batch : joined(draw, threads)) sum += longest_of(batch.tiles);
  }
  return sum;
}

std::vector<Batch> Work::joined(std::span<const Batch> draw, int threads) {
  std::vector<Batch> all;
  for (std::size_t first = 0; first < draw.size(); first += static_cast<std::size_t>(threads)) {
    Batch& batch = all.emplace_back(draw[first]);
    const std::size_t end = std::min(draw.size(), first + static_cast<std::size_t>(threads));
    for (std::size_t i = first + 1; i < end; ++i) {
      batch.chunks.insert(batch.chunks.end(), draw[i].chunks.begin(), draw[i].chunks.end());
      std::transform(batch.tiles.begin(), batch.tiles.end(), draw[i].tiles.begin(), batch.tiles.begin(), std::plus<>{});
    }
  }
  return all;
}

}  // namespace tuberia::bench
