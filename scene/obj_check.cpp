#include "scene/obj_check.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "scene/text_scan.hpp"

namespace tuberia {
namespace {

constexpr std::array<std::string_view, 3> kKinds = {"vertices", "texture coordinates", "normals"};

struct Line {
  std::string_view text;   // without its end
  int number = 0;          // of its first part, from 1
  bool ends_file = false;  // no line end follows
};

/// Calls see(line) for each line until one gives a reason to stop. A backslash at its end joins a
/// line to the next.
template <class See>
std::string for_each_line(std::string_view text, See see) {
  int number = 1;
  while (!text.empty()) {
    Line line;
    line.number = number;
    std::size_t end = text.find('\n');
    for (; end != std::string_view::npos; end = text.find('\n', end + 1)) {
      ++number;
      const std::size_t last = end > 0 && text[end - 1] == '\r' ? end - 1 : end;
      if (last == 0 || text[last - 1] != '\\') break;
    }
    line.ends_file = end == std::string_view::npos;
    line.text = text.substr(0, end);
    text.remove_prefix(line.ends_file ? text.size() : end + 1);
    if (std::string reason = see(line); !reason.empty()) return reason;
  }
  return {};
}

/// The next word of a line, past a backslash and line end that join two lines; empty at the end.
std::string_view next_word(std::string_view& text) {
  while (!text.empty()) {
    const bool space = kBlanks.find(text[0]) != std::string_view::npos || text[0] == '\n' ||
                       (text[0] == '\\' && text.find_first_not_of(" \t\r", 1) == text.find('\n', 1));
    if (!space) break;
    text.remove_prefix(1);
  }
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\v\f\n"));
  text.remove_prefix(word.size());
  return word;
}

std::string at_line(const Line& line, const std::string& what) {
  return "line " + std::to_string(line.number) + ": " + what;
}

/// Which of the three kinds of element a keyword defines; -1 if none.
int kind_defined_by(std::string_view keyword) {
  if (keyword == "v") return 0;
  if (keyword == "vt") return 1;
  return keyword == "vn" ? 2 : -1;
}

using Counts = std::array<std::int64_t, 3>;

Counts count_elements(std::string_view text) {
  Counts counts{};
  for_each_line(text, [&](const Line& line) {
    std::string_view rest = line.text;
    if (const int kind = kind_defined_by(next_word(rest)); kind >= 0) ++counts[kind];
    return std::string();
  });
  return counts;
}

/// A vertex needs three numbers; what they are is for Assimp to say.
std::string why_not_vertex(const Line& line, std::string_view rest) {
  int numbers = 0;
  while (!next_word(rest).empty()) ++numbers;
  if (numbers >= 3) return {};
  return at_line(line, "a vertex of " + std::to_string(numbers) + " numbers instead of 3");
}

/// One index; positive ones count from the first of all elements, negative ones back from the
/// last of those defined so far.
std::string why_not_index(std::int64_t index, int kind, const Counts& all, const Counts& so_far) {
  if (index == 0) return "index 0, but OBJ counts from 1";
  const bool in_range = index > 0 ? index <= all[kind] : -index <= so_far[kind];
  if (in_range) return {};
  return "index " + std::to_string(index) + ", but the model has " +
         std::to_string(index > 0 ? all[kind] : so_far[kind]) + " " + std::string(kKinds[kind]) +
         (index > 0 ? "" : " so far");
}

/// One corner of a face: "v", "v/vt", "v//vn" or "v/vt/vn".
std::string why_not_corner(std::string_view corner, const Counts& all, const Counts& so_far) {
  for (int kind = 0; kind < 3; ++kind) {
    const std::string_view part = corner.substr(0, corner.find('/'));
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error == std::errc::result_out_of_range) return "index " + std::string(part) + " is out of range";
    if (error == std::errc()) {
      if (std::string reason = why_not_index(index, kind, all, so_far); !reason.empty()) return reason;
    }
    if (part.size() == corner.size()) break;
    corner.remove_prefix(part.size() + 1);
  }
  return {};
}

std::string why_not_face(const Line& line, std::string_view rest, const Counts& all,
                         const Counts& so_far) {
  int corners = 0;
  for (std::string_view word = next_word(rest); !word.empty() && word[0] != '#'; word = next_word(rest)) {
    if (const std::string reason = why_not_corner(word, all, so_far); !reason.empty())
      return at_line(line, reason);
    ++corners;
  }
  // Elsewhere a face of two corners is somebody's way to write a line; here the file breaks off.
  if (corners < 3 && line.ends_file) return at_line(line, "the file ends within a face: truncated");
  return {};
}

}  // namespace

std::string why_not_obj(std::string_view text) {
  // UTF-16 has zero bytes; Assimp converts it, and checks indices too, if less politely.
  if (text.substr(0, 64).find('\0') != std::string_view::npos) return {};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);

  const Counts all = count_elements(text);
  Counts so_far{};
  return for_each_line(text, [&](const Line& line) -> std::string {
    std::string_view rest = line.text;
    const std::string_view keyword = next_word(rest);
    if (const int kind = kind_defined_by(keyword); kind >= 0) ++so_far[kind];
    if (keyword == "v") return why_not_vertex(line, rest);
    if (keyword == "f") return why_not_face(line, rest, all, so_far);
    return {};
  });
}

std::vector<std::string> material_libraries_of_obj(std::string_view text) {
  std::vector<std::string> names;
  for_each_line(text, [&](const Line& line) {
    std::string_view rest = line.text;
    if (next_word(rest) != "mtllib") return std::string();
    // The rest of the line: names may have spaces.
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    while (!rest.empty() && kBlanks.find(rest.back()) != std::string_view::npos) rest.remove_suffix(1);
    if (!rest.empty()) names.emplace_back(rest);
    return std::string();
  });
  return names;
}

}  // namespace tuberia
