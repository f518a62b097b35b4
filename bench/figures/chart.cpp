#include "bench/figures/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/figures/page.hpp"

namespace tuberia::bench {
namespace {

constexpr double kWidth = 560, kHeight = 340, kLeft = 62, kRight = 12, kTop = 10, kBottom = 44;
constexpr int kColours = 8;

/// 1500 as "1.5 k", 0.002 as "2 m": a tick's text.
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

/// Where values of one axis lie on the page.
class Scale {
 public:
  Scale(bool logarithmic, double low, double high, double begin, double end)
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

  double operator()(double value) const {
    const double at = logarithmic_ ? std::log10(value) : value;
    return begin_ + (at - low_) / (high_ - low_) * (end_ - begin_);
  }

  std::vector<double> ticks() const { return logarithmic_ ? decades() : steps(); }

 private:
  // Powers of ten; over less than two of them 2 and 5 times as well.
  std::vector<double> decades() const {
    std::vector<double> values;
    const bool few = high_ - low_ < 2;
    const int every = std::max(1, static_cast<int>((high_ - low_) / 8));
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade)
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor > 1 && !few) break;
        const double value = factor * std::pow(10.0, decade);
        if (std::log10(value) >= low_ && std::log10(value) <= high_ && decade % every == 0) values.push_back(value);
      }
    return values;
  }

  // Four to ten round numbers from 0.
  std::vector<double> steps() const {
    double step = std::pow(10.0, std::floor(std::log10(high_ / 4)));
    for (const double factor : {2.0, 2.5, 2.0})
      if (high_ / step > 8) step *= factor;
    std::vector<double> values;
    for (int i = 0; i * step <= high_; ++i) values.push_back(i * step);
    return values;
  }

  bool logarithmic_;
  double low_, high_, begin_, end_;
};

struct Range {
  double low = 0, high = 0;
};

Range range_of(const Chart& chart, double CurvePoint::*coordinate) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const Series& series : chart.series)
    for (const CurvePoint& point : series.points) {
      range.low = std::min(range.low, point.*coordinate);
      range.high = std::max(range.high, point.*coordinate);
    }
  return range;
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

std::string axes(const Chart& chart, const Scale& x, const Scale& y) {
  const double bottom = kHeight - kBottom, right = kWidth - kRight;
  std::string svg;
  for (const double tick : x.ticks()) {
    svg += line(x(tick), kTop, x(tick), bottom, "class=\"grid\"");
    svg += words(x(tick), bottom + 16, "class=\"quiet\" text-anchor=\"middle\"", short_text(tick));
  }
  for (const double tick : y.ticks()) {
    svg += line(kLeft, y(tick), right, y(tick), "class=\"grid\"");
    svg += words(kLeft - 6, y(tick) + 4, "class=\"quiet\" text-anchor=\"end\"", short_text(tick));
  }
  svg += line(kLeft, bottom, right, bottom, "class=\"axis\"") + line(kLeft, kTop, kLeft, bottom, "class=\"axis\"");
  svg += words((kLeft + right) / 2, kHeight - 8, "text-anchor=\"middle\"", chart.x.label);
  char turn[96];
  std::snprintf(turn, sizeof turn, "text-anchor=\"middle\" transform=\"rotate(-90 14 %.1f)\"", (kTop + bottom) / 2);
  return svg + words(14, (kTop + bottom) / 2, turn, chart.y.label);
}

std::string colour(std::size_t number) { return "var(--c" + std::to_string(number % kColours) + ")"; }

// A broad band under the points that the law was fitted to.
std::string law_line(const Series& series, const Scale& x, const Scale& y, const std::string& stroke) {
  if (!series.law) return {};
  const auto at = [&](double value) { return series.law->factor * std::pow(value, series.law->exponent); };
  const double from = series.law->from, to = series.law->to;
  return line(x(from), y(at(from)), x(to), y(at(to)),
              "stroke=\"" + stroke + "\" stroke-width=\"6\" stroke-opacity=\".25\" stroke-linecap=\"round\"");
}

std::string drawn(const Series& series, const Scale& x, const Scale& y, const std::string& stroke) {
  std::string path, points;
  for (const CurvePoint& point : series.points) {
    char text[160];
    std::snprintf(text, sizeof text, "%s%.1f %.1f", path.empty() ? "M" : " L", x(point.x), y(point.y));
    path += text;
    std::snprintf(text, sizeof text, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"><title>", x(point.x),
                  y(point.y), stroke.c_str());
    points +=
        text + escaped(series.name) + ": " + number_text(point.x) + ", " + number_text(point.y) + "</title></circle>\n";
  }
  return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + stroke + "\" stroke-width=\"1.75\"/>\n" + points;
}

std::string key_of(const Chart& chart) {
  std::string key = "<div class=\"key\">";
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    key += "<span><span class=\"swatch\" style=\"background:" + colour(i) + "\"></span>" + escaped(series.name);
    if (series.law) {
      const std::string text = "exponent " + exponent_text(*series.law);
      key += is_superlinear(*series.law) ? ", <span class=\"alarm\">" + text + ": more than proportional</span>"
                                         : ", " + text;
    }
    key += "</span>";
  }
  return key + "</div>\n";
}

}  // namespace

std::string exponent_text(const PowerLaw& law) {
  char text[64];
  if (law.standard_error) std::snprintf(text, sizeof text, "%.3f ± %.3f", law.exponent, *law.standard_error);
  else std::snprintf(text, sizeof text, "%.3f", law.exponent);
  return text;
}

bool is_superlinear(const PowerLaw& law) noexcept { return law.exponent > kSuperlinear; }

std::string figure_of(const Chart& chart) {
  const Range xs = range_of(chart, &CurvePoint::x), ys = range_of(chart, &CurvePoint::y);
  const Scale x(chart.x.logarithmic, xs.low, xs.high, kLeft, kWidth - kRight);
  const Scale y(chart.y.logarithmic, ys.low, ys.high, kHeight - kBottom, kTop);
  char begin[160];
  std::snprintf(begin, sizeof begin,
                "<figure style=\"max-width:%.0fpx\">\n<svg viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" role=\"img\">\n",
                kWidth, kWidth, kHeight, kWidth);
  std::string svg = begin + axes(chart, x, y);
  for (std::size_t i = 0; i < chart.series.size(); ++i) svg += law_line(chart.series[i], x, y, colour(i));
  for (std::size_t i = 0; i < chart.series.size(); ++i) svg += drawn(chart.series[i], x, y, colour(i));
  return svg + "</svg>\n" + key_of(chart) + "</figure>\n";
}

}  // namespace tuberia::bench
