#pragma once
// What all figures are drawn with: scales, lines and words as SVG text.

#include <string>
#include <vector>

namespace tuberia::bench {

/// Where values of one axis lie on the page.
class Scale {
 public:
  /// low, high: the values to be shown, both positive on a logarithmic axis; any other begins at 0.
  /// begin, end: where they go, in pixels.
  Scale(bool logarithmic, double low, double high, double begin, double end);

  double operator()(double value) const;

  /// Four to ten round values, growing.
  std::vector<double> ticks() const { return logarithmic_ ? decades() : steps(); }

 private:
  std::vector<double> decades() const;
  std::vector<double> steps() const;

  bool logarithmic_;
  double low_, high_, begin_, end_;
};

/// 1500 as "1.5 k", 0.002 as "0.002": a tick's text.
std::string short_text(double value);

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes);

/// Text at a point; it is escaped.
std::string words(double x, double y, const std::string& attributes, const std::string& text);

/// One of eight colours of bench/figures/page.hpp, which begin anew after the last.
std::string colour(std::size_t number);

}  // namespace tuberia::bench
