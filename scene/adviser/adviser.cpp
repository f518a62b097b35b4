#include "scene/adviser/adviser.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace tuberia {
namespace {

constexpr int kTimedFrames = 5;

/// The codes of some pixels, as the screen shows them.
std::vector<Rgba8> codes_of(const Image<Rgba8>& image, const PixelRect& rect) {
  std::vector<Rgba8> codes;
  for (int y = rect.top; y < rect.bottom; ++y)
    for (int x = rect.left; x < rect.right; ++x) codes.push_back(image.at(x, y));
  return codes;
}

/// Sum over r, g and b of the squared differences, codes of 255 as 1.
double squared_error(const std::vector<Rgba8>& codes, const std::vector<Rgba8>& reference) {
  const auto square = [](int a, int b) { return (a - b) / 255.0 * ((a - b) / 255.0); };
  double sum = 0;
  for (std::size_t i = 0; i < codes.size(); ++i)
    sum += square(codes[i].r, reference[i].r) + square(codes[i].g, reference[i].g) + square(codes[i].b, reference[i].b);
  return sum;
}

/// Mean over the sample, and what the mean over all is at most but for two standard errors of a sample
/// drawn without putting back.
struct Estimate {
  double mean = 0, at_most = 0;
};
Estimate estimate_of(const std::vector<double>& sample, std::size_t all) {
  const auto n = static_cast<double>(sample.size());
  double sum = 0, squares = 0;
  for (const double each : sample) sum += each;
  const double mean = sum / n;
  for (const double each : sample) squares += (each - mean) * (each - mean);
  if (sample.size() < 2 || sample.size() >= all) return {mean, mean};
  const double left_out = 1 - n / static_cast<double>(all);
  return {mean, mean + 2 * std::sqrt(squares / (n - 1) / n * left_out)};
}

}  // namespace

std::vector<int> spread_tiles(int tiles, int count) {
  std::vector<int> numbers;
  if (count >= tiles) {
    for (int i = 0; i < tiles; ++i) numbers.push_back(i);
    return numbers;
  }
  // Multiples of the golden ratio fill an interval evenly at every length of the sequence.
  for (int i = 0; static_cast<int>(numbers.size()) < count; ++i) {
    const double place = std::fmod(0.5 + i / std::numbers::phi, 1.0);
    const int number = static_cast<int>(place * tiles);
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

Adviser::Adviser(AdvisedPicture& picture, const RenderTargetDescription& target, const SurfaceTraits& traits, const MeasuredTrade& trade)
    : picture_(picture), description_(target), traits_(traits), trade_(trade) {}

Result<Nothing> Adviser::draw_reference_tiles() {
  if (target_) return Nothing{};
  auto target = RenderTarget::create(description_);
  if (!target) return target.error();
  constexpr int kFewest = 16, kOneIn = 6;
  const int tiles = target->tile_count();
  std::vector<PixelRect> rects;
  for (const int number : spread_tiles(tiles, std::max(kFewest, tiles / kOneIn))) {
    const int left = number % target->tiles_per_row() * kTileSize, top = number / target->tiles_per_row() * kTileSize;
    rects.push_back(intersection({left, top, left + kTileSize, top + kTileSize}, target->bounds()));
    if (const auto drawn = picture_.draw(Quality{}, *target, rects.back()); !drawn) return drawn.error();
  }
  const Image<Rgba8> image = target->colour_image();
  for (const PixelRect& rect : rects) reference_.push_back({rect, codes_of(image, rect)});
  target_ = *std::move(target);
  const auto reference = attempt(Quality{});
  if (!reference) return reference.error();
  reference_trial_ = *reference;
  return Nothing{};
}

Result<Trial> Adviser::attempt(const Quality& quality) {
  if (const auto ready = draw_reference_tiles(); !ready) return ready.error();
  Trial trial{.quality = quality, .predicted = trade_.predict(kind_of(traits_), quality)};
  std::vector<Trial> alone{trial};
  if (const auto timed = time_in_turns(alone); !timed) return timed.error();
  trial.seconds = alone.front().seconds;

  const Image<Rgba8> image = target_->colour_image();
  std::vector<double> errors;
  for (const ReferenceTile& tile : reference_)
    errors.push_back(squared_error(codes_of(image, tile.rect), tile.codes) / (3.0 * static_cast<double>(tile.codes.size())));
  const Estimate estimate = estimate_of(errors, static_cast<std::size_t>(target_->tile_count()));
  trial.rmse = std::sqrt(estimate.mean);
  trial.rmse_at_most = std::sqrt(estimate.at_most);
  return trial;
}

Result<double> Adviser::seconds_of_a_frame(const Quality& quality) {
  const auto begin = std::chrono::steady_clock::now();
  if (const auto drawn = picture_.draw(quality, *target_, std::nullopt); !drawn) return drawn.error();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Result<Nothing> Adviser::time_in_turns(std::vector<Trial>& trials) {
  for (Trial& trial : trials) trial.seconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= kTimedFrames; ++round)
    for (Trial& trial : trials) {
      const auto seconds = seconds_of_a_frame(trial.quality);
      if (!seconds) return seconds.error();
      if (round > 0) trial.seconds = std::min(trial.seconds, *seconds);  // the first one warms up
    }
  return Nothing{};
}

Result<Advice> Adviser::advise(const Budget& budget) {
  if (const auto ready = draw_reference_tiles(); !ready) return ready.error();
  auto advice = budget.rmse ? cheapest_within_error(*budget.rmse) : best_within_time(budget.seconds.value_or(0));
  if (!advice) return advice;
  if (budget.seconds) advice->keeps_budget &= advice->chosen.seconds <= *budget.seconds;
  advice->reference_seconds = reference_trial_.seconds;
  advice->sampled_tiles = static_cast<int>(reference_.size());
  advice->tiles = target_->tile_count();
  return advice;
}

Result<Advice> Adviser::cheapest_within_error(double rmse) {
  const auto part = [rmse](double error) { return error > 0 ? error / rmse : 0; };
  auto advice = search_for([&](const Effect& predicted) { return Outcome{.cost = predicted.time_ratio, .burden = part(predicted.rmse)}; },
                    [&](const Trial& trial) { return Outcome{.cost = trial.seconds, .burden = part(trial.rmse_at_most)}; },
                    [](const Quality& failed, const Quality& other) { return failed.is_at_least(other); });
  if (!advice) return advice;

  // Those that keep the budget are timed once more, in turns, the reference among them: what is no faster
  // than that is not worth its error.
  std::vector<Trial> finalists{reference_trial_};
  for (const Trial& trial : advice->trials)
    if (trial.rmse_at_most <= rmse && !trial.quality.is_reference()) finalists.push_back(trial);
  if (const auto timed = time_in_turns(finalists); !timed) return timed.error();
  reference_trial_ = finalists.front();
  advice->chosen = *std::min_element(finalists.begin(), finalists.end(), [](const Trial& a, const Trial& b) { return a.seconds < b.seconds; });
  advice->keeps_budget = true;
  return advice;
}

Result<Advice> Adviser::best_within_time(double seconds) {
  const double reference = reference_trial_.seconds / seconds;
  return search_for([&](const Effect& predicted) { return Outcome{.cost = predicted.rmse, .burden = predicted.time_ratio * reference}; },
                    [&](const Trial& trial) { return Outcome{.cost = trial.rmse, .burden = trial.seconds / seconds}; },
                    [](const Quality& failed, const Quality& other) { return other.is_at_least(failed); });
}

Result<Advice> Adviser::search_for(const std::function<Outcome(const Effect&)>& predicted, const std::function<Outcome(const Trial&)>& measured,
                                   const IsWorse& is_worse) {
  std::vector<Prospect> prospects;
  for (const Quality& quality : qualities_for(traits_)) {
    const Outcome outcome = predicted(trade_.predict(kind_of(traits_), quality));
    prospects.push_back({quality, outcome.cost, outcome.burden});
  }
  Advice advice;
  const auto found = search(prospects, is_worse, [&](const Quality& quality) -> Result<Outcome> {
    const auto trial = attempt(quality);
    if (!trial) return trial.error();
    advice.trials.push_back(*trial);
    return measured(*trial);
  });
  if (!found) return found.error();
  const auto chosen = std::find(found->tried.begin(), found->tried.end(), found->chosen) - found->tried.begin();
  advice.chosen = advice.trials[static_cast<std::size_t>(chosen)];
  advice.keeps_budget = found->keeps_budget;
  advice.stepped_up = found->broken_predictions;
  return advice;
}

}  // namespace tuberia
