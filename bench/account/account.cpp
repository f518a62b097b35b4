#include "bench/account/account.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

namespace tuberia::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kNanosecond = 1e-9;
constexpr std::size_t kIndicesPerPiece = 1 << 16;  // in which validation checks them in parallel

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The pieces of one frame, in seconds and nanoseconds.
struct FrameTimes {
  double clear = 0, other = 0;
  DrawTimes times;
  std::vector<std::size_t> draw_ends;  // each draw's batches end before this one of times.batches

  double tiles() const {
    double sum = 0;
    for (const BatchTimes& batch : times.batches)
      for (const TileTimes& tile : batch.tiles) sum += static_cast<double>(tile.total) * kNanosecond;
    return sum;
  }
  double chunks() const {
    double sum = 0;
    for (const BatchTimes& batch : times.batches)
      for (const ChunkTimes& chunk : batch.chunks) sum += static_cast<double>(chunk.total()) * kNanosecond;
    return sum;
  }
};

Result<FrameTimes> timed_frame(TuberiaPeer& peer, std::span<const DrawCall> draws) {
  FrameTimes frame;
  Clock::time_point begin = Clock::now();
  peer.clear();
  frame.clear = seconds_since(begin);
  begin = Clock::now();
  for (const DrawCall& draw : draws) {
    const auto drawn = peer.pipeline().draw(peer.target(), draw, frame.times);
    if (!drawn) return drawn.error();
    frame.draw_ends.push_back(frame.times.batches.size());
  }
  const double known = static_cast<double>(frame.times.validation + frame.times.bookkeeping) * kNanosecond + frame.tiles() + frame.chunks();
  frame.other = std::max(0.0, seconds_since(begin) - known);
  return frame;
}

/// Of every piece the shorter time: the one that nothing else on the machine interrupted.
void keep_shorter(FrameTimes& kept, const FrameTimes& other) {
  const auto shorten = [](auto& mine, const auto& theirs) { mine = std::min(mine, theirs); };
  shorten(kept.clear, other.clear);
  shorten(kept.other, other.other);
  shorten(kept.times.validation, other.times.validation);
  for (std::size_t b = 0; b < kept.times.batches.size(); ++b) {
    BatchTimes& mine = kept.times.batches[b];
    const BatchTimes& theirs = other.times.batches[b];
    for (std::size_t i = 0; i < mine.chunks.size(); ++i)
      for (std::size_t stage = 0; stage < mine.chunks[i].stages.size(); ++stage)
        shorten(mine.chunks[i].stages[stage], theirs.chunks[i].stages[stage]);
    for (std::size_t i = 0; i < mine.tiles.size(); ++i) shorten(mine.tiles[i].total, theirs.tiles[i].total);
  }
}

/// After one frame for the memory and the caches.
Result<FrameTimes> shortest_pieces(TuberiaPeer& peer, std::span<const DrawCall> draws, int frames) {
  if (const auto first = timed_frame(peer, draws); !first) return first.error();
  auto kept = timed_frame(peer, draws);
  for (int i = 1; i < frames && kept; ++i) {
    const auto frame = timed_frame(peer, draws);
    if (!frame) return frame.error();
    keep_shorter(*kept, *frame);
  }
  return kept;
}

Result<DrawStatistics> count_fragments(TuberiaPeer& peer) {
  DrawStatistics all;
  peer.clear();
  for (DrawCall draw : peer.draws()) {
    draw.count_fragments = true;
    const auto counted = peer.pipeline().draw(peer.target(), draw);
    if (!counted) return counted.error();
    all += *counted;
  }
  return all;
}

/// Pixels that are no longer as they were cleared.
std::int64_t covered_pixels(const RenderTarget& target) {
  const Image<std::int32_t> depths = target.depth_codes();
  const Image<Rgba8> colours = target.colour_image();
  const std::int32_t cleared = code_of_depth(1, target.depth_format());
  std::int64_t covered = 0;
  for (std::size_t i = 0; i < depths.pixels().size(); ++i)
    if (depths.pixels()[i] != cleared || !(colours.pixels()[i] == Rgba8{0, 0, 0, 0})) ++covered;
  return covered;
}

/// The same draws with nothing to shade.
std::vector<DrawCall> without_colour(std::span<const DrawCall> draws) {
  std::vector<DrawCall> bare(draws.begin(), draws.end());
  for (DrawCall& draw : bare) draw.state.blend.write = false;
  return bare;
}

void share_out(const FrameTimes& frame, double tiles_without_colour, Account& account) {
  const auto at = [&](Item item) -> double& { return account.seconds[static_cast<std::size_t>(item)]; };
  at(Item::clear) = frame.clear;
  at(Item::validation) = static_cast<double>(frame.times.validation) * kNanosecond;
  for (const BatchTimes& batch : frame.times.batches)
    for (const ChunkTimes& chunk : batch.chunks)
      for (std::size_t stage = 0; stage < chunk.stages.size(); ++stage)
        account.seconds[static_cast<std::size_t>(Item::fetch) + stage] +=
            static_cast<double>(chunk.stages[stage]) * kNanosecond;
  at(Item::coverage_and_depth) = std::min(tiles_without_colour, frame.tiles());
  at(Item::shading_and_blending) = frame.tiles() - at(Item::coverage_and_depth);
  at(Item::other) = frame.other;
  account.frame_seconds = std::accumulate(account.seconds.begin(), account.seconds.end(), 0.0);
}

Batch batch_of(const BatchTimes& times) {
  Batch batch;
  for (const ChunkTimes& chunk : times.chunks) batch.chunks.push_back(static_cast<double>(chunk.total()) * kNanosecond);
  for (const TileTimes& tile : times.tiles) batch.tiles.push_back(static_cast<double>(tile.total) * kNanosecond);
  return batch;
}

/// The clear and the check of the indices are loops of equal pieces; then come the draws.
Work work_of(const FrameTimes& frame, const Account& account, std::size_t indices, int tiles) {
  const auto even_loop = [](double seconds, std::size_t pieces) {
    return Loop(pieces, seconds / static_cast<double>(pieces));
  };
  Work work;
  work.loops.push_back(even_loop(frame.clear, static_cast<std::size_t>(tiles)));
  work.loops.push_back(even_loop(account.of(Item::validation), indices / kIndicesPerPiece + 1));
  std::size_t next = 0;
  for (const std::size_t end : frame.draw_ends) {
    work.draws.emplace_back();
    for (; next < end; ++next) work.draws.back().push_back(batch_of(frame.times.batches[next]));
  }
  work.alone = account.of(Item::other);
  return work;
}

double vertex_bytes(const Workload& workload) {
  const bool textured = workload.filter != Filter::none;
  std::size_t bytes = sizeof(glm::vec3);
  if (workload.lit) bytes += sizeof(glm::vec3);
  if (textured) bytes += sizeof(glm::vec2);
  if (!workload.lit && !textured && !workload.depth_only) bytes += sizeof(glm::vec4);
  return static_cast<double>(bytes * workload.mesh.positions.size());
}

double texels_a_fragment(Filter filter) {
  switch (filter) {
    case Filter::none: return 0;
    case Filter::nearest:
    case Filter::nearest_mipmap_nearest: return 1;
    case Filter::linear:
    case Filter::linear_mipmap_nearest: return 4;
    case Filter::linear_mipmap_linear: return 8;
  }
  return 0;
}

Bounds bounds_of(const Workload& workload, const Account& account, const MachineLimits& limits) {
  constexpr double kCodeBytes = 4;  // of a depth, of a colour
  const double pixels = static_cast<double>(workload.width_pixels) * workload.height_pixels;
  const bool colour = !workload.depth_only;
  const double target = pixels * kCodeBytes * (colour ? 2 : 1);
  const double indices = kCodeBytes * static_cast<double>(workload.mesh.indices.size());

  // Blending reads and writes colours and only reads depths; otherwise both are written.
  const int codes_a_fragment = workload.blend ? 3 : static_cast<int>(workload.depth_test) + static_cast<int>(colour);
  const auto visible = static_cast<double>(account.visible);
  return {.memory = (target + indices + vertex_bytes(workload)) / limits.memory_bytes_per_second,
          .first_cache = visible * codes_a_fragment * kCodeBytes / limits.first_cache_bytes_per_second,
          .texels = visible * texels_a_fragment(workload.filter) / limits.texels_per_second};
}

/// The least of frames on one thread over the least on two, taken in turns: what else the machine does makes single frames longer,
/// and those on two threads more often.
double speed_up_of_two(TuberiaPeer& one, const Workload& workload, const AccountOptions& options,
                       Result<Nothing>& prepared) {
  TuberiaPeer two(2, options.instruction_set, options.precision);
  prepared = two.prepare(workload);
  if (!prepared) return 0;
  const auto seconds_of = [](TuberiaPeer& peer) {
    peer.frame();  // wakes its threads
    const Clock::time_point begin = Clock::now();
    peer.frame();
    return seconds_since(begin);
  };
  double least_alone = std::numeric_limits<double>::infinity(), least_of_two = least_alone;
  for (int i = 0; i < 2 * options.frames; ++i) {
    least_alone = std::min(least_alone, seconds_of(one));
    least_of_two = std::min(least_of_two, seconds_of(two));
  }
  return least_alone / least_of_two;
}

}  // namespace

std::string_view name_of(Item item) noexcept {
  constexpr std::array<std::string_view, kItems> kNames{
      "clear",   "validation", "vertex fetch", "transform", "assembly",        "clipping",          "divide",
      "culling", "attributes", "set-up",       "binning",   "coverage, depth", "shading, blending", "between"};
  return kNames[static_cast<std::size_t>(item)];
}

double Account::geometry_seconds() const noexcept {
  double sum = 0;
  for (int i = static_cast<int>(Item::fetch); i <= static_cast<int>(Item::binning); ++i)
    sum += seconds[static_cast<std::size_t>(i)];
  return sum;
}

Item Account::largest_item() const noexcept {
  return static_cast<Item>(std::max_element(seconds.begin(), seconds.end()) - seconds.begin());
}

Result<Account> account_for(const Workload& workload, const AccountOptions& options) {
  TuberiaPeer peer(1, options.instruction_set, options.precision);
  if (const auto prepared = peer.prepare(workload); !prepared) return prepared.error();
  Account account;
  account.workload = workload.name;
  account.triangles = static_cast<std::int64_t>(workload.mesh.indices.size() / 3);

  const auto frame = shortest_pieces(peer, peer.draws(), options.frames);
  if (!frame) return frame.error();
  const auto bare = shortest_pieces(peer, without_colour(peer.draws()), options.frames);
  if (!bare) return bare.error();
  share_out(*frame, bare->tiles(), account);
  account.work = work_of(*frame, account, workload.mesh.indices.size(), peer.target().tile_count());

  const auto counts = count_fragments(peer);
  if (!counts) return counts.error();
  account.counts = *counts;
  account.visible = workload.blend ? counts->samples_passed : covered_pixels(peer.target());
  account.bounds = bounds_of(workload, account, options.limits);

  Result<Nothing> prepared = Nothing{};
  account.speed_up_of_two = speed_up_of_two(peer, workload, options, prepared);
  if (!prepared) return prepared.error();
  return account;
}

}  // namespace tuberia::bench
