#pragma once
// Self-contained HTML pages of tables and charts, light or dark as the reader's system is.

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace tuberia::bench {

/// Text for HTML.
std::string escaped(std::string_view text);

/// A number for people: three significant digits, thousands separated.
std::string number_text(double value);

/// A whole number, thousands separated.
std::string count_text(double count);

/// The style sheet of a figure that is a file of its own: the page's light colours.
std::string light_svg_style();

/// Cells are HTML. The first column is of words, the rest of numbers.
struct Table {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  std::string html() const;
};

class Page {
 public:
  /// lede: a paragraph of HTML under the title.
  Page(std::string title, std::string lede) : title_(std::move(title)), lede_(std::move(lede)) {}

  /// html: paragraphs, tables, figures.
  void add_section(const std::string& heading, const std::string& html);

  /// Makes the folder if need be.
  Result<Nothing> write(const std::string& path) const;

 private:
  std::string title_, lede_, sections_;
};

}  // namespace tuberia::bench
