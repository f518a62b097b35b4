#include "bench/figures/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/figures/label_placement.hpp"
#include "bench/figures/page.hpp"
#include "bench/figures/pareto.hpp"
#include "bench/figures/svg.hpp"

namespace tuberia::bench {
namespace {

constexpr double kWidth = 760, kHeight = 440, kLeft = 74, kRight = 16, kTop = 12, kBottom = 46;
constexpr double kZeroStrip = 30;  // below a logarithmic axis, for what is exactly right
constexpr double kEnd = kWidth - kRight, kFloor = kHeight - kBottom;

struct Range {
  double low = HUGE_VAL, high = 0;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return !(low <= high); }
};

/// Where everything lies.
class Layout {
 public:
  explicit Layout(const Scatter& scatter)
      : negligible_(scatter.negligible),
        has_zeros_(scatter.y.logarithmic &&
                   std::any_of(scatter.points.begin(), scatter.points.end(),
                               [&](const ScatterPoint& point) { return point.y <= scatter.negligible; })),
        x_(scale_of(scatter.x, range(scatter, true), kLeft, kEnd)),
        y_(scale_of(scatter.y, range(scatter, false), bottom(), kTop)) {}

  double bottom() const { return has_zeros_ ? kFloor - kZeroStrip : kFloor; }
  double x(double value) const { return x_(value); }
  double y(double value) const { return has_zeros_ && value <= negligible_ ? kFloor - kZeroStrip / 2 : y_(value); }
  std::vector<double> x_ticks() const { return x_.ticks(); }
  std::vector<double> y_ticks() const { return y_.ticks(); }
  bool has_zeros() const { return has_zeros_; }

 private:
  Range range(const Scatter& scatter, bool of_x) const {
    Range values;
    for (const ScatterPoint& point : scatter.points)
      if (of_x || point.y > scatter.negligible || !scatter.y.logarithmic) values.add(of_x ? point.x : point.y);
    return values.empty() ? Range{0.1, 1} : values;
  }
  // At least a factor of two, so that equal values do not fill the axis with their noise.
  static Scale scale_of(const Axis& axis, Range values, double begin, double end) {
    if (axis.logarithmic && values.high < 2 * values.low) {
      const double middle = std::sqrt(values.low * values.high);
      values = {middle / std::sqrt(2.0), middle * std::sqrt(2.0)};
    }
    return Scale(axis.logarithmic, values.low, values.high, begin, end);
  }

  double negligible_;
  bool has_zeros_;
  Scale x_, y_;
};

std::string axes(const Scatter& scatter, const Layout& at) {
  std::string svg;
  for (const double tick : at.x_ticks()) {
    svg += line(at.x(tick), kTop, at.x(tick), kFloor, "class=\"grid\"");
    svg += words(at.x(tick), kFloor + 16, "class=\"quiet\" text-anchor=\"middle\"", short_text(tick));
  }
  for (const double tick : at.y_ticks()) {
    svg += line(kLeft, at.y(tick), kEnd, at.y(tick), "class=\"grid\"");
    svg += words(kLeft - 6, at.y(tick) + 4, "class=\"quiet\" text-anchor=\"end\"", short_text(tick));
  }
  if (at.has_zeros()) {
    svg += line(kLeft, at.bottom(), kEnd, at.bottom(), "class=\"axis\" stroke-dasharray=\"2 3\"");
    svg += words(kLeft - 6, at.y(0) + 4, "class=\"quiet\" text-anchor=\"end\"",
                 scatter.negligible > 0 ? "< " + short_text(scatter.negligible) : "0");
  }
  svg += line(kLeft, kFloor, kEnd, kFloor, "class=\"axis\"") + line(kLeft, kTop, kLeft, kFloor, "class=\"axis\"");
  svg += words((kLeft + kEnd) / 2, kHeight - 8, "text-anchor=\"middle\"", scatter.x.label);
  char turn[96];
  std::snprintf(turn, sizeof turn, "text-anchor=\"middle\" transform=\"rotate(-90 14 %.1f)\"", (kTop + kFloor) / 2);
  return svg + words(14, (kTop + kFloor) / 2, turn, scatter.y.label);
}

/// Steps: whoever may pay up to x gets the error of the last choice that is not dearer.
std::string front_line(const std::vector<const ScatterPoint*>& points, const Layout& at, const std::string& stroke) {
  std::vector<Choice> choices;
  for (const ScatterPoint* point : points) choices.push_back({point->x, point->y});
  std::string path;
  double height = 0;
  for (const std::size_t i : pareto_front(choices)) {
    const double x = at.x(choices[i].cost), y = at.y(choices[i].error);
    char text[96];
    if (path.empty()) std::snprintf(text, sizeof text, "M%.1f %.1f L%.1f %.1f", x, kTop, x, y);
    else std::snprintf(text, sizeof text, " L%.1f %.1f L%.1f %.1f", x, height, x, y);
    path += text;
    height = y;
  }
  if (path.empty()) return {};
  char text[48];
  std::snprintf(text, sizeof text, " L%.1f %.1f", kEnd, height);
  return "<path class=\"front\" d=\"" + path + text + "\" fill=\"none\" stroke=\"" + stroke +
         "\" stroke-width=\"2.5\" stroke-opacity=\".35\" stroke-linejoin=\"round\"/>\n";
}

std::string fronts(const Scatter& scatter, const Layout& at) {
  std::string svg;
  for (std::size_t group = 0; group < (scatter.front_of_each_group ? scatter.groups.size() : 1); ++group) {
    std::vector<const ScatterPoint*> points;
    for (const ScatterPoint& point : scatter.points)
      if (!point.is_detail && (!scatter.front_of_each_group || point.group == group)) points.push_back(&point);
    svg += front_line(points, at, scatter.front_of_each_group ? colour(group) : "var(--ink)");
  }
  return svg;
}

std::string dot(const ScatterPoint& point, const Layout& at) {
  const std::string paint = colour(point.group);
  const char* style = point.is_detail      ? "r=\"2.2\" fill-opacity=\".45\" stroke=\"none\" fill"
                      : point.is_reference ? "r=\"5\" fill=\"var(--card)\" stroke-width=\"2.5\" stroke"
                                           : "r=\"4.5\" stroke=\"var(--card)\" fill";
  char text[200];
  std::snprintf(text, sizeof text, "<circle cx=\"%.1f\" cy=\"%.1f\" %s=\"%s\"><title>", at.x(point.x), at.y(point.y),
                style, paint.c_str());
  return text + escaped(point.hover.empty() ? point.label : point.hover) + "</title></circle>\n";
}

std::string labels(const Scatter& scatter, const Layout& at) {
  std::vector<Labelled> wanted;
  std::vector<std::size_t> groups;
  for (const ScatterPoint& point : scatter.points)
    if (!point.is_detail) {
      wanted.push_back({at.x(point.x), at.y(point.y), point.label});
      groups.push_back(point.group);
    }
  const std::vector<PlacedLabel> placed = place_labels(wanted, {kLeft + 2, kTop, kEnd, kFloor});
  std::string svg;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i].is_shown) continue;
    const Box& box = placed[i].box;
    const std::string paint = colour(groups[i]);
    if (placed[i].needs_leader)
      svg += line(wanted[i].x, wanted[i].y, std::clamp(wanted[i].x, box.left, box.right),
                  std::clamp(wanted[i].y, box.top, box.bottom), "stroke=\"" + paint + "\" stroke-opacity=\".5\"");
    svg += words(box.left + 1, box.bottom - 3, "class=\"label\" style=\"fill:" + paint + "\"", wanted[i].text);
  }
  return svg;
}

std::string drawing(const Scatter& scatter) {
  const Layout at(scatter);
  std::string details, dots;
  for (const ScatterPoint& point : scatter.points) (point.is_detail ? details : dots) += dot(point, at);
  return axes(scatter, at) + details + fronts(scatter, at) + dots + labels(scatter, at);
}

}  // namespace

std::string figure_of(const Scatter& scatter) {
  char begin[160];
  std::snprintf(begin, sizeof begin,
                "<figure style=\"max-width:%.0fpx\">\n<svg viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" role=\"img\">\n",
                kWidth, kWidth, kHeight, kWidth);
  std::string key;
  for (std::size_t i = 0; scatter.groups.size() > 1 && i < scatter.groups.size(); ++i)
    key += "<span><span class=\"swatch\" style=\"background:" + colour(i) + "\"></span>" + escaped(scatter.groups[i]) +
           "</span>";
  return begin + drawing(scatter) + "</svg>\n" + (key.empty() ? "" : "<div class=\"key\">" + key + "</div>\n") +
         "</figure>\n";
}

std::string svg_file_of(const Scatter& scatter, const std::string& title) {
  constexpr double kHeading = 30, kKey = 24;
  const double height = kHeight + kHeading + (scatter.groups.size() > 1 ? kKey : 0);
  char begin[200];
  std::snprintf(begin, sizeof begin,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\">\n", kWidth, height,
                kWidth);
  std::string svg = begin + ("<style>" + light_svg_style() + "</style>\n");
  svg += "<rect width=\"100%\" height=\"100%\" style=\"fill:var(--card)\"/>\n";
  svg += words(kLeft, 21, "style=\"font-weight:600;font-size:14px\"", title);
  char shift[64];
  std::snprintf(shift, sizeof shift, "<g transform=\"translate(0 %.0f)\">\n", kHeading);
  svg += shift + drawing(scatter) + "</g>\n";
  double x = kLeft;
  for (std::size_t i = 0; scatter.groups.size() > 1 && i < scatter.groups.size(); ++i) {
    char mark[120];
    std::snprintf(mark, sizeof mark, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"%s\"/>", x, height - 14,
                  colour(i).c_str());
    svg += mark + words(x + 9, height - 10, "", scatter.groups[i]);
    x += 30 + 6.4 * static_cast<double>(scatter.groups[i].size());
  }
  return svg + "</svg>\n";
}

}  // namespace tuberia::bench
