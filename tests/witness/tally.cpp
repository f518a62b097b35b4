#include "tests/witness/tally.hpp"

#include <algorithm>

namespace tuberia::witness {
namespace {

constexpr std::size_t kNumbersKept = 5;

void keep(std::vector<std::uint64_t>& numbers, const std::vector<std::uint64_t>& more) {
  for (const std::uint64_t number : more)
    if (numbers.size() < kNumbersKept) numbers.push_back(number);
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  tried += other.tried;
  failed += other.failed;
  undecided += other.undecided;
  pixels += other.pixels;
  depth_error = std::max(depth_error, other.depth_error);
  keep(failures, other.failures);
  keep(doubts, other.doubts);
  return *this;
}

Tally run(Class kind, std::uint64_t seed, std::uint64_t first, std::int64_t count, Workers& workers, std::vector<Machines>& machines) {
  // Many short pieces, added up in order, so that the numbers kept do not depend on the threads.
  constexpr std::int64_t kPiece = 256;
  std::vector<Tally> pieces(static_cast<std::size_t>((count + kPiece - 1) / kPiece));
  parallel_for(workers, static_cast<std::int64_t>(pieces.size()), [&](std::int64_t piece, int worker) {
    Tally& tally = pieces[static_cast<std::size_t>(piece)];
    for (std::int64_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i) {
      const std::uint64_t number = first + static_cast<std::uint64_t>(i);
      const Case c = random_case(kind, seed, number);
      const Finding finding = compare(c, machines[static_cast<std::size_t>(worker)]);
      const auto triangles = static_cast<std::int64_t>(c.triangle_count());
      tally.tried += triangles;
      tally.pixels += finding.pixels;
      tally.depth_error = std::max(tally.depth_error, finding.depth_error);
      if (finding.verdict == Verdict::agreed) continue;
      const bool is_failure = finding.verdict == Verdict::failed;
      (is_failure ? tally.failed : tally.undecided) += triangles;
      (is_failure ? tally.failures : tally.doubts).push_back(number);
    }
  });
  Tally total;
  for (const Tally& piece : pieces) total += piece;
  return total;
}

}  // namespace tuberia::witness
