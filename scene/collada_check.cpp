#include "scene/collada_check.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "scene/text_scan.hpp"

namespace tuberia {
namespace {

std::string at_byte(std::string_view text, std::size_t position, const std::string& what) {
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n');
  return "line " + std::to_string(line) + ": " + what;
}

/// The integer of an attribute such as count="24" in a tag's text; nothing if it is not there.
std::optional<std::int64_t> attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const bool whole_word =
        at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != std::string_view::npos;
    std::string_view rest = tag.substr(at + name.size());
    if (whole_word && take_word(rest, " \t\r\n\"'") == "=")
      return integer_in(take_word(rest, " \t\r\n\"'"));
  }
  return std::nullopt;
}

/// The lists <p> and <vcount>.
std::string why_not_index_lists(std::string_view text) {
  for (const std::string_view tag : {"<p>", "<vcount>"}) {
    for (std::size_t begin = text.find(tag); begin != std::string_view::npos;
         begin = text.find(tag, begin)) {
      begin += tag.size();
      const std::string_view list = text.substr(begin, text.find('<', begin) - begin);
      const std::size_t bad = list.find_first_not_of(" \t\r\n0123456789");
      // Without a number in front it is no list, but somebody's paragraph.
      if (bad == std::string_view::npos || list.find_first_of("0123456789") > bad) continue;
      return at_byte(text, begin + bad, "a list of indices is corrupt");
    }
  }
  return {};
}

/// Each array of numbers, and the accessor behind it in the same source.
std::string why_not_arrays(std::string_view text) {
  constexpr std::string_view kArray = "<float_array", kAccessor = "<accessor";
  for (std::size_t begin = text.find(kArray); begin != std::string_view::npos;
       begin = text.find(kArray, begin + 1)) {
    const auto count = attribute(text.substr(begin, text.find('>', begin) - begin), "count");
    if (!count || *count < 0) return at_byte(text, begin, "an array without a count");
    if (*count > static_cast<std::int64_t>(text.size()))
      return impossible_claim(*count, "numbers", text.size());

    const std::size_t accessor = text.find(kAccessor, begin);
    if (accessor == std::string_view::npos || accessor > text.find("</source", begin)) continue;
    const std::string_view tag = text.substr(accessor, text.find('>', accessor) - accessor);
    const std::int64_t reads = attribute(tag, "count").value_or(0),
                       stride = attribute(tag, "stride").value_or(1);
    const std::int64_t offset = attribute(tag, "offset").value_or(0);
    const bool sane = reads >= 0 && stride >= 0 && offset >= 0 && reads <= *count && stride <= *count &&
                      offset <= *count;
    if (!sane || (reads > 0 && offset + reads * stride > *count)) {
      return at_byte(text, accessor,
                     "an accessor reaches beyond its array of " + std::to_string(*count) + " numbers");
    }
  }
  return {};
}

}  // namespace

std::string why_not_collada(std::string_view text) {
  std::string reason = why_not_index_lists(text);
  return reason.empty() ? why_not_arrays(text) : reason;
}

}  // namespace tuberia
