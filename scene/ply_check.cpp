#include "scene/ply_check.hpp"

#include <algorithm>
#include <vector>

#include "scene/text_scan.hpp"

namespace tuberia {
namespace {

enum class Encoding { ascii, little_endian, big_endian };

struct Property {
  std::size_t count_bytes = 0;  // of a list's count; 0: not a list
  std::size_t value_bytes = 0;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

/// 0 for a type that PLY does not have.
std::size_t bytes_of_type(std::string_view type) {
  constexpr std::string_view kTypes[4][4] = {{"char", "uchar", "int8", "uint8"},
                                             {"short", "ushort", "int16", "uint16"},
                                             {"int", "uint", "int32", "uint32"},
                                             {"float", "float32", "", ""}};
  constexpr std::size_t kBytes[4] = {1, 2, 4, 4};
  for (int row = 0; row < 4; ++row) {
    if (!type.empty() && std::find(kTypes[row], kTypes[row] + 4, type) != kTypes[row] + 4)
      return kBytes[row];
  }
  return type == "double" || type == "float64" ? 8 : 0;
}

/// One line of the header; false if it makes no sense. Unknown keywords are passed over, since
/// comments of more than one line are common.
bool read_header_line(std::string_view line, Header& header) {
  const std::string_view keyword = take_word(line);
  if (keyword == "format") {
    const std::string_view name = take_word(line);
    if (name == "binary_little_endian") header.encoding = Encoding::little_endian;
    if (name == "binary_big_endian") header.encoding = Encoding::big_endian;
  } else if (keyword == "element") {
    Element element;
    element.name = take_word(line);
    element.count = integer_in(take_word(line)).value_or(-1);
    header.elements.push_back(element);
    return element.count >= 0;
  } else if (keyword == "property") {
    Property property;
    std::string_view type = take_word(line);
    const bool list = type == "list";
    if (list) {
      property.count_bytes = bytes_of_type(take_word(line));
      type = take_word(line);
    }
    property.value_bytes = bytes_of_type(type);
    if (header.elements.empty() || property.value_bytes == 0 || (list && property.count_bytes == 0))
      return false;
    header.elements.back().properties.push_back(property);
  }
  return true;
}

/// An unsigned integer of so many bytes; counts are never negative.
std::uint64_t integer_at(std::string_view bytes, std::size_t size, Encoding encoding) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t from = encoding == Encoding::big_endian ? i : size - 1 - i;
    value = value << 8 | static_cast<unsigned char>(bytes[from]);
  }
  return value;
}

bool skip_words(std::string_view& body, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    if (take_word(body).empty()) return false;
  }
  return true;
}

bool skip_bytes(std::string_view& body, std::uint64_t count) {
  if (count > body.size()) return false;
  body.remove_prefix(static_cast<std::size_t>(count));
  return true;
}

/// Takes one property's value or list off the body; false if the body ends first.
bool skip_property(std::string_view& body, const Property& property, Encoding encoding) {
  std::uint64_t values = 1;
  if (encoding == Encoding::ascii) {
    if (property.count_bytes > 0)
      values = static_cast<std::uint64_t>(integer_in(take_word(body)).value_or(1));
    return skip_words(body, values);
  }
  if (property.count_bytes > 0) {
    if (property.count_bytes > body.size()) return false;
    values = integer_at(body, property.count_bytes, encoding);
    body.remove_prefix(property.count_bytes);
  }
  return values <= body.size() && skip_bytes(body, values * property.value_bytes);
}

std::string why_not_body(std::string_view body, const Header& header) {
  for (const Element& element : header.elements) {
    if (element.count > static_cast<std::int64_t>(body.size())) {
      return impossible_claim(element.count, "elements '" + element.name + "'", body.size());
    }
    for (std::int64_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (skip_property(body, property, header.encoding)) continue;
        return "it is truncated: the elements '" + element.name + "' break off after " +
               std::to_string(i) + " of " + std::to_string(element.count);
      }
    }
  }
  return {};
}

}  // namespace

std::string why_not_ply(std::string_view bytes) {
  std::string_view rest = bytes;
  Header header;
  while (!rest.empty()) {
    const std::string_view line = take_line(rest);
    std::string_view words = line;
    if (take_word(words) == "end_header") return why_not_body(rest, header);
    if (!read_header_line(line, header))
      return "its header has an invalid line '" + std::string(line.substr(0, 60)) + "'";
  }
  // Assimp would look for the end for ever.
  return "its header breaks off: truncated or corrupt";
}

}  // namespace tuberia
