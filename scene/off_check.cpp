#include "scene/off_check.hpp"

#include <array>

#include "scene/text_scan.hpp"

namespace tuberia {
namespace {

struct Lines {
  std::string_view rest;
  int number = 0;  // of the line taken last, from 1
};

/// The next line that is neither blank nor a comment, without trailing comment; empty at the end.
std::string_view next_line(Lines& lines) {
  while (!lines.rest.empty()) {
    std::string_view line = take_line(lines.rest);
    ++lines.number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(kBlanks) != std::string_view::npos) return line;
  }
  return {};
}

/// A face is a line "3 0 1 2", perhaps with a colour behind.
std::string why_not_face(std::string_view line, int line_number, std::int64_t vertex_count) {
  const std::string at_line = "line " + std::to_string(line_number) + ": ";
  const auto corners = integer_in(take_word(line));
  if (!corners || *corners < 1) return at_line + "a face without a number of corners";
  for (std::int64_t corner = 0; corner < *corners; ++corner) {
    const auto index = integer_in(take_word(line));
    if (!index)
      return at_line + "a face breaks off after " + std::to_string(corner) + " of " +
             std::to_string(*corners) + " corners";
    if (*index < 0 || *index >= vertex_count) {
      return at_line + "index " + std::to_string(*index) + ", but the model has " +
             std::to_string(vertex_count) + " vertices";
    }
  }
  return {};
}

}  // namespace

std::string why_not_off(std::string_view text) {
  Lines lines{.rest = text};
  std::string_view header = next_line(lines);
  const std::string_view magic = take_word(header);
  // Other spellings, with their dimension in the header, are for Assimp to judge.
  if (!magic.ends_with("OFF") || magic.find('n') != std::string_view::npos) return {};
  if (header.find_first_not_of(kBlanks) == std::string_view::npos) header = next_line(lines);

  std::array<std::int64_t, 2> counts{};
  constexpr std::array<std::string_view, 2> kThings = {"vertices", "faces"};
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const auto count = integer_in(take_word(header));
    if (!count)
      return header.find("BINARY") == std::string_view::npos ? "its header gives no valid counts" : "";
    counts[kind] = *count;
    if (counts[kind] < 0 || counts[kind] > static_cast<std::int64_t>(text.size())) {
      return impossible_claim(counts[kind], kThings[kind], text.size());
    }
  }

  for (std::size_t kind = 0; kind < 2; ++kind) {
    for (std::int64_t i = 0; i < counts[kind]; ++i) {
      const std::string_view line = next_line(lines);
      if (line.empty()) {
        return "it is truncated: " + std::to_string(i) + " of " + std::to_string(counts[kind]) + " " +
               std::string(kThings[kind]);
      }
      if (kind == 0) continue;
      if (std::string reason = why_not_face(line, lines.number, counts[0]); !reason.empty())
        return reason;
    }
  }
  return {};
}

}  // namespace tuberia
