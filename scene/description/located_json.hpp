#pragma once
// JSON whose values know the line that they stand on, so that a refusal can name it.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tuberia::description {

struct LocatedMember;

/// Only what belongs to its kind is set.
struct LocatedJson {
  enum class Kind { null, flag, number, text, list, object };
  Kind kind = Kind::null;
  int line = 1;                        // where it begins, from 1
  bool flag = false;
  double number = 0;                   // finite
  std::string text{};                  // UTF-8
  std::vector<LocatedJson> items{};    // of a list
  std::vector<LocatedMember> members;  // of an object, in the order of the text; no two of one key

  /// The value of a key; null if there is none.
  const LocatedJson* find(std::string_view key) const noexcept;
};

struct LocatedMember {
  std::string key;
  int line = 1;  // of the key
  LocatedJson value;
};

/// A value of a kind, with nothing in it yet.
LocatedJson json_of_kind(LocatedJson::Kind kind);

/// "a list", "a number", ...
std::string_view name_of(LocatedJson::Kind kind) noexcept;

/// Where in a text something is wrong.
struct JsonError {
  int line = 1, column = 0;  // from 1; column 0: the line says enough
  std::string reason;
};

/// The one value of a text. Error: bad syntax or UTF-8, a number too large for a double, a key that an object
/// has twice, or lists and objects nested more than 64 deep.
std::variant<LocatedJson, JsonError> parse_located_json(std::string_view text);

}  // namespace tuberia::description
