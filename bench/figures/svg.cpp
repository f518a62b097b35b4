#include "bench/figures/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/figures/page.hpp"

namespace tuberia::bench {
namespace {

constexpr int kColours = 8;

}  // namespace

Scale::Scale(bool logarithmic, double low, double high, double begin, double end)
    : logarithmic_(logarithmic),
      low_(logarithmic ? std::log10(low) : 0),
      high_(logarithmic ? std::log10(high) : high),
      begin_(begin),
      end_(end) {
  const double margin = 0.04 * (high_ - low_) + (logarithmic ? 0.02 : 0);
  high_ += margin;
  if (logarithmic) low_ -= margin;
  if (!(high_ > low_)) high_ = low_ + 1;
}

double Scale::operator()(double value) const {
  const double at = logarithmic_ ? std::log10(value) : value;
  return begin_ + (at - low_) / (high_ - low_) * (end_ - begin_);
}

// Powers of ten; over less than two of them 2 and 5 times as well, over less than one some more.
std::vector<double> Scale::decades() const {
  std::vector<double> values;
  const bool few = high_ - low_ < 2, very_few = high_ - low_ < 1;
  const int every = std::max(1, static_cast<int>((high_ - low_) / 8));
  for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade)
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
      if (factor > 1 && !few) break;
      if (!very_few && factor != 1 && factor != 2 && factor != 5) continue;
      const double value = factor * std::pow(10.0, decade);
      if (std::log10(value) >= low_ && std::log10(value) <= high_ && decade % every == 0) values.push_back(value);
    }
  return values;
}

// Four to ten round numbers from 0.
std::vector<double> Scale::steps() const {
  double step = std::pow(10.0, std::floor(std::log10(high_ / 4)));
  for (const double factor : {2.0, 2.5, 2.0})
    if (high_ / step > 8) step *= factor;
  std::vector<double> values;
  for (int i = 0; i * step <= high_; ++i) values.push_back(i * step);
  return values;
}

std::string short_text(double value) {
  if (value == 0) return "0";
  constexpr struct {
    double unit;
    const char* suffix;
  } kSuffixes[] = {{1e9, " G"}, {1e6, " M"}, {1e3, " k"}, {1, ""}};
  char text[32];
  for (const auto& [unit, suffix] : kSuffixes)
    if (std::abs(value) >= unit * 0.9999) {
      std::snprintf(text, sizeof text, "%.3g%s", value / unit, suffix);
      return text;
    }
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  char text[128];
  std::snprintf(text, sizeof text, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" ", x1, y1, x2, y2);
  return text + attributes + "/>\n";
}

std::string words(double x, double y, const std::string& attributes, const std::string& text) {
  char place[64];
  std::snprintf(place, sizeof place, "<text x=\"%.1f\" y=\"%.1f\" ", x, y);
  return place + attributes + ">" + escaped(text) + "</text>\n";
}

std::string colour(std::size_t number) { return "var(--c" + std::to_string(number % kColours) + ")"; }

}  // namespace tuberia::bench
