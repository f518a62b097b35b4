#include "scene/description/keys.hpp"

#include <array>
#include <charconv>
#include <limits>

namespace tuberia::description {

bool Range::contains(double value) const noexcept {
  return (least_excluded ? value > least : value >= least) && (most_excluded ? value < most : value <= most);
}

std::string Range::words() const {
  const bool has_least = least > -kLargest, has_most = most < kLargest;
  if (!has_least && !has_most) return {};
  if (!has_most) return least_excluded ? "more than " + words_of(least) : words_of(least) + " or more";
  if (!has_least) return most_excluded ? "less than " + words_of(most) : words_of(most) + " or less";
  return (least_excluded ? "more than " : "from ") + words_of(least) + (most_excluded ? " to less than " : " to ") + words_of(most);
}

void Keys::number(const Key& key, float& value, const Range& range) {
  double wide = as_written(value);
  number(key, wide, range);
  value = static_cast<float>(wide);
}

void Keys::whole(const Key& key, int& value, int least, int most) {
  std::int64_t wide = value;
  whole(key, wide, std::int64_t{least}, std::int64_t{most});
  value = static_cast<int>(wide);
}

void Keys::seed(const Key& key, std::uint32_t& value) {
  std::int64_t wide = value;
  whole(key, wide, std::int64_t{0}, std::int64_t{std::numeric_limits<std::uint32_t>::max()});
  value = static_cast<std::uint32_t>(wide);
}

void Keys::colour(const Key& key, glm::vec3& value, const Range& range) {
  std::array<double, 3> wide{as_written(value.r), as_written(value.g), as_written(value.b)};
  numbers(key, wide, range, true);
  value = {static_cast<float>(wide[0]), static_cast<float>(wide[1]), static_cast<float>(wide[2])};
}

double as_written(float value) noexcept {
  std::array<char, 32> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double wide = static_cast<double>(value);
  std::from_chars(text.data(), written.ptr, wide);
  return wide;
}

std::string words_of(double value) {
  std::array<char, 32> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), written.ptr};
}

}  // namespace tuberia::description
