#pragma once
// Words and lines of model files that are text; no memory of their own, no exceptions.

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tuberia {

inline constexpr std::string_view kBlanks = " \t\r\v\f";

/// Takes the next word off a text; empty at its end.
inline std::string_view take_word(std::string_view& text, std::string_view separators = " \t\r\v\f\n") {
  const std::size_t begin = text.find_first_not_of(separators);
  text.remove_prefix(begin == std::string_view::npos ? text.size() : begin);
  const std::string_view word = text.substr(0, text.find_first_of(separators));
  text.remove_prefix(word.size());
  return word;
}

/// Takes the next line off a text, without its end; empty at the text's end.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The integer that the whole word is; nothing if it is none or too large.
inline std::optional<std::int64_t> integer_in(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// "it claims 353535235358 vertices in 309 bytes"
inline std::string impossible_claim(std::int64_t count, std::string_view things, std::size_t size_bytes) {
  return "it claims " + std::to_string(count) + " " + std::string(things) + " in " +
         std::to_string(size_bytes) + " bytes";
}

}  // namespace tuberia
