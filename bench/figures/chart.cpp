#include "bench/figures/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/figures/page.hpp"
#include "bench/figures/svg.hpp"

namespace tuberia::bench {
namespace {

constexpr double kWidth = 560, kHeight = 340, kLeft = 62, kRight = 12, kTop = 10, kBottom = 44;

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
