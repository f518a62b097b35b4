#include "scene/description/key_reader.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::description {
namespace {

/// "a, b or c"
std::string list_of(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

/// How many letters must be put in, left out or replaced to make one word of the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i - 1] != to[j - 1]);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[to.size()];
}

/// What may have been meant by a key, as the end of a sentence.
std::string suggestion(std::string_view key, const std::vector<std::string_view>& known) {
  constexpr std::size_t kLongestKey = 40;
  if (known.empty()) return "";
  const auto distance = [&](std::string_view name) { return key.size() > kLongestKey ? kLongestKey : edit_distance(key, name); };
  const auto nearest = std::min_element(known.begin(), known.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
  if (distance(*nearest) <= 2) return "; did you mean '" + std::string(*nearest) + "'?";
  return "; there could be " + list_of(known);
}

}  // namespace

std::string KeyReader::path_of(std::string_view key) const {
  const std::string& path = levels_.back().path;
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

/// Keeps the complaint whose line comes first.
void KeyReader::refuse(int line, const std::string& reason) {
  if (!error_ || line < error_->line) error_ = JsonError{.line = line, .column = 0, .reason = reason};
}

const LocatedJson* KeyReader::find(const Key& key) {
  Level& level = levels_.back();
  level.asked.push_back(key.name);
  const LocatedJson* value = level.json->find(key.name);
  if (value == nullptr && key.required) refuse(level.json->line, path_of(key.name) + " is missing");
  return value;
}

const LocatedJson* KeyReader::find(const Key& key, LocatedJson::Kind kind) {
  const LocatedJson* value = find(key);
  if (value == nullptr || value->kind == kind) return value;
  refuse(value->line, path_of(key.name) + " is " + std::string(name_of(value->kind)) + ", but must be " + std::string(name_of(kind)));
  return nullptr;
}

bool KeyReader::is_number(const LocatedJson& value, const std::string& path, const Range& range) {
  if (value.kind != LocatedJson::Kind::number) {
    refuse(value.line, path + " is " + std::string(name_of(value.kind)) + ", but must be a number");
    return false;
  }
  if (range.contains(value.number)) return true;
  const bool is_too_large = std::abs(value.number) > Range::kLargest;
  refuse(value.line, path + " is " + words_of(value.number) + (is_too_large ? ", which is too large" : ", but must be " + range.words()));
  return false;
}

void KeyReader::number(const Key& key, double& value, const Range& range) {
  const LocatedJson* json = find(key);
  if (json != nullptr && is_number(*json, path_of(key.name), range)) value = json->number;
}

void KeyReader::whole(const Key& key, std::int64_t& value, std::int64_t least, std::int64_t most) {
  const LocatedJson* json = find(key);
  if (json == nullptr || !is_number(*json, path_of(key.name), within(static_cast<double>(least), static_cast<double>(most)))) return;
  if (json->number != std::floor(json->number)) return refuse(json->line, path_of(key.name) + " is " + words_of(json->number) + ", but must be a whole number");
  value = static_cast<std::int64_t>(json->number);
}

void KeyReader::flag(const Key& key, bool& value) {
  if (const LocatedJson* json = find(key, LocatedJson::Kind::flag)) value = json->flag;
}

void KeyReader::text(const Key& key, std::string& value) {
  const LocatedJson* json = find(key, LocatedJson::Kind::text);
  if (json == nullptr) return;
  if (key.required && json->text.empty()) return refuse(json->line, path_of(key.name) + " is empty");
  value = json->text;
}

void KeyReader::name(const Key& key, std::string& value, NameOf kind) {
  text(key, value);
  const LocatedJson* json = levels_.back().json->find(key.name);
  if (json != nullptr && !value.empty()) references_.push_back({path_of(key.name), json->line, value, kind});
}

void KeyReader::one_of(const Key& key, std::size_t& choice, std::span<const std::string_view> names) {
  const LocatedJson* json = find(key, LocatedJson::Kind::text);
  if (json == nullptr) return;
  const auto found = std::find(names.begin(), names.end(), json->text);
  if (found == names.end()) return refuse(json->line, path_of(key.name) + " is '" + json->text + "', but must be " + list_of(names));
  choice = static_cast<std::size_t>(found - names.begin());
}

void KeyReader::numbers(const Key& key, std::span<double> values, const Range& range, bool or_one) {
  const LocatedJson* json = find(key);
  if (json == nullptr) return;
  const std::string path = path_of(key.name);
  if (or_one && json->kind == LocatedJson::Kind::number) {
    if (is_number(*json, path, range)) std::fill(values.begin(), values.end(), json->number);
    return;
  }
  if (json->kind != LocatedJson::Kind::list || json->items.size() != values.size()) {
    const std::string what = json->kind == LocatedJson::Kind::list ? "a list of " + std::to_string(json->items.size()) : std::string(name_of(json->kind));
    return refuse(json->line, path + " is " + what + ", but must be " + (or_one ? "a number or " : "") + "a list of " + std::to_string(values.size()) + " numbers");
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_number(json->items[i], path + "[" + std::to_string(i) + "]", range)) values[i] = json->items[i].number;
}

bool KeyReader::row_of(const LocatedJson& json, const std::string& path, std::size_t columns, const Range& range, std::vector<double>& row) {
  if (json.kind != LocatedJson::Kind::list || json.items.size() != columns) {
    const std::string what = json.kind == LocatedJson::Kind::list ? "a list of " + std::to_string(json.items.size()) : std::string(name_of(json.kind));
    refuse(json.line, path + " is " + what + ", but must be a list of " + std::to_string(columns) + " numbers");
    return false;
  }
  for (std::size_t i = 0; i < columns; ++i) {
    const bool is_good = json.items[i].kind == LocatedJson::Kind::number && range.contains(json.items[i].number);
    if (!is_good) return is_number(json.items[i], path + "[" + std::to_string(i) + "]", range);
    row.push_back(json.items[i].number);
  }
  return true;
}

void KeyReader::rows(const Key& key, std::vector<std::vector<double>>& rows, std::size_t columns, const Range& range) {
  const LocatedJson* json = find(key, LocatedJson::Kind::list);
  if (json == nullptr) return;
  if (columns == 0 && !json->items.empty()) columns = json->items[0].items.size();
  std::vector<std::vector<double>> read(json->items.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    if (!row_of(json->items[i], path_of(key.name) + "[" + std::to_string(i) + "]", columns, range, read[i])) return;
  rows = std::move(read);
}

void KeyReader::which(std::span<const std::string_view> keys, std::size_t& choice) {
  const LocatedJson& object = *levels_.back().json;
  std::size_t count = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (object.find(keys[i]) == nullptr) continue;
    if (++count == 1) choice = i;
  }
  if (count == 1) return;
  levels_.back().asked.insert(levels_.back().asked.end(), keys.begin(), keys.end());
  refuse(object.line, levels_.back().path + (count == 0 ? " is none of " : " is several of ") + list_of(keys));
}

void KeyReader::require(std::string_view key, bool holds, std::string_view reason) {
  if (holds) return;
  const LocatedJson* json = levels_.back().json->find(key);
  refuse(json != nullptr ? json->line : levels_.back().json->line, path_of(key) + " " + std::string(reason));
}

const LocatedJson* KeyReader::open_level(const Key& key, LocatedJson::Kind kind) {
  const LocatedJson* json = find(key, kind);
  if (json != nullptr) levels_.push_back({.json = json, .path = path_of(key.name)});
  return json;
}

bool KeyReader::begin_object(const Key& key, bool) { return open_level(key, LocatedJson::Kind::object) != nullptr; }

void KeyReader::end_object() {
  refuse_unknown_keys();
  levels_.pop_back();
}

std::size_t KeyReader::begin_list(const Key& key, std::size_t) {
  static const LocatedJson kEmpty = json_of_kind(LocatedJson::Kind::list);
  if (const LocatedJson* json = open_level(key, LocatedJson::Kind::list)) return json->items.size();
  levels_.push_back({.json = &kEmpty, .path = ""});
  return 0;
}

std::size_t KeyReader::begin_named(const Key& key, std::size_t) {
  static const LocatedJson kEmpty = json_of_kind(LocatedJson::Kind::object);
  if (const LocatedJson* json = open_level(key, LocatedJson::Kind::object)) return json->members.size();
  levels_.push_back({.json = &kEmpty, .path = ""});
  return 0;
}

/// An item that is no object is read as an empty one, so that the reading goes on.
void KeyReader::begin_item(std::size_t index) {
  const std::string path = levels_.back().path + "[" + std::to_string(index) + "]";
  const LocatedJson& item = levels_.back().json->items[index];
  if (item.kind != LocatedJson::Kind::object) refuse(item.line, path + " is " + std::string(name_of(item.kind)) + ", but must be an object");
  levels_.push_back({.json = &item, .path = path});
}

void KeyReader::begin_named_item(std::size_t index, std::string& name) {
  const LocatedMember& member = levels_.back().json->members[index];
  const std::string path = path_of(member.key);
  if (member.value.kind != LocatedJson::Kind::object)
    refuse(member.value.line, path + " is " + std::string(name_of(member.value.kind)) + ", but must be an object");
  if (member.key.empty()) refuse(member.line, levels_.back().path + " has an empty name");
  name = member.key;
  levels_.push_back({.json = &member.value, .path = path});
}

void KeyReader::refuse_unknown_keys() {
  const Level& level = levels_.back();
  for (const LocatedMember& member : level.json->members)
    if (std::find(level.asked.begin(), level.asked.end(), member.key) == level.asked.end())
      refuse(member.line, path_of(member.key) + " is no key that belongs here" + suggestion(member.key, level.asked));
}

void KeyReader::finish(const SceneDescription& scene) {
  refuse_unknown_keys();
  for (const Reference& reference : references_) {
    const bool is_texture = reference.kind == NameOf::texture;
    const bool is_there = is_texture ? find_texture(scene, reference.name) != nullptr : find_material(scene, reference.name) != nullptr;
    if (!is_there) refuse(reference.line, reference.path + " is '" + reference.name + "', but there is no " + (is_texture ? "texture" : "material") + " of that name");
  }
}

}  // namespace tuberia::description
