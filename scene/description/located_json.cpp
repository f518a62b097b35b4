#include "scene/description/located_json.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

namespace tuberia::description {
namespace {

using Json = nlohmann::json;

/// The parser tells values but not where they stand. It takes letters one by one through this iterator,
/// which counts them: whenever it tells a value, it has read up to that value's end, and of a number one
/// letter more.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

/// Which line a place in a text is on, for places that only move forwards.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}
  int line_at(std::size_t offset) {
    for (; at_ < offset && at_ < text_.size(); ++at_) line_ += text_[at_] == '\n';
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// The first member, in the text, whose key an earlier one has; null if there is none.
const LocatedMember* repeated_member(const LocatedJson& object) {
  std::vector<const LocatedMember*> sorted;
  for (const LocatedMember& member : object.members) sorted.push_back(&member);
  std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return std::pair(std::string_view(a->key), a) < std::pair(std::string_view(b->key), b); });
  const LocatedMember* first = nullptr;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i - 1]->key == sorted[i]->key && (first == nullptr || sorted[i] < first)) first = sorted[i];
  return first;
}

constexpr std::size_t kDeepest = 64;

/// Listens to the parser and builds the values.
class Builder {
 public:
  Builder(std::string_view text, const std::size_t* read) : text_(text), read_(read), lines_(text) {}

  LocatedJson root;
  std::optional<JsonError> error;

  bool null() { return add(json_of_kind(LocatedJson::Kind::null)); }
  bool boolean(bool value) {
    LocatedJson json = json_of_kind(LocatedJson::Kind::flag);
    json.flag = value;
    return add(std::move(json));
  }
  bool number_integer(Json::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) { return number(value); }
  bool string(std::string& value) {
    LocatedJson json = json_of_kind(LocatedJson::Kind::text);
    json.text = std::move(value);
    return add(std::move(json));
  }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(LocatedJson::Kind::object); }
  bool start_array(std::size_t) { return open(LocatedJson::Kind::list); }
  bool end_object() {
    if (const LocatedMember* again = repeated_member(*open_.back())) return refuse({.line = again->line, .column = 0, .reason = "key '" + again->key + "' is there twice"});
    return close();
  }
  bool end_array() { return close(); }

  bool key(std::string& key) {
    open_.back()->members.push_back({.key = std::move(key), .line = line(), .value = {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& exception) {
    // The letter that it stumbled over is the last one that it read.
    const std::size_t read = std::min(position == 0 ? *read_ : position, text_.size());
    const std::string_view before = text_.substr(0, read > 0 ? read - 1 : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return refuse({.line = static_cast<int>(line), .column = static_cast<int>(before.size() - line_begin) + 1,
                   .reason = reason_of(exception, token)});
  }

 private:
  /// The parser's own words, without its prefix of numbers that we write another way.
  static std::string reason_of(const nlohmann::detail::exception& exception, const std::string& token) {
    if (exception.id == 406) return "number " + token + " is too large";
    const std::string words = exception.what();
    const std::size_t dash = words.find(" - ");
    return "it is no JSON: " + (dash == std::string::npos ? words : words.substr(dash + 3));
  }

  int line() { return lines_.line_at(*read_ > 0 ? *read_ - 1 : 0); }

  /// Of a number, the parser has read one letter more, which may be the end of its line; its first digit
  /// is on the line of its last.
  bool number(double value) {
    std::size_t last = *read_ > 0 ? *read_ - 1 : 0;
    if (last > 0 && !is_of_number(text_[last])) --last;
    LocatedJson json = json_of_kind(LocatedJson::Kind::number);
    json.number = value;
    json.line = lines_.line_at(last);
    return place(std::move(json)) != nullptr;
  }
  static bool is_of_number(char letter) { return (letter >= '0' && letter <= '9') || letter == '.' || letter == 'e' || letter == 'E'; }

  bool add(LocatedJson json) {
    json.line = line();
    return place(std::move(json)) != nullptr;
  }

  LocatedJson* place(LocatedJson json) {
    if (open_.empty()) return &(root = std::move(json));
    LocatedJson& parent = *open_.back();
    if (parent.kind == LocatedJson::Kind::list) return &parent.items.emplace_back(std::move(json));
    return &(parent.members.back().value = std::move(json));
  }

  bool open(LocatedJson::Kind kind) {
    if (open_.size() == kDeepest) return refuse({.line = line(), .column = 0, .reason = "lists and objects are nested more than 64 deep"});
    LocatedJson json = json_of_kind(kind);
    json.line = line();
    open_.push_back(place(std::move(json)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  bool refuse(JsonError why) {
    error = std::move(why);
    return false;
  }

  std::string_view text_;
  const std::size_t* read_;
  LineCounter lines_;
  std::vector<LocatedJson*> open_;  // a value moves only while it is closed: its parent grows no further until then
};

}  // namespace

const LocatedJson* LocatedJson::find(std::string_view key) const noexcept {
  const auto found = std::find_if(members.begin(), members.end(), [&](const LocatedMember& member) { return member.key == key; });
  return found == members.end() ? nullptr : &found->value;
}

LocatedJson json_of_kind(LocatedJson::Kind kind) {
  LocatedJson json;
  json.kind = kind;
  return json;
}

std::string_view name_of(LocatedJson::Kind kind) noexcept {
  constexpr std::array<std::string_view, 6> kNames{"null", "true or false", "a number", "a text", "a list", "an object"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::variant<LocatedJson, JsonError> parse_located_json(std::string_view text) {
  std::size_t read = 0;
  Builder builder(text, &read);
  const bool is_good = Json::sax_parse(CountingIterator(text.data(), &read), CountingIterator(text.data() + text.size(), &read), &builder);
  if (builder.error) return *std::move(builder.error);
  if (!is_good) return JsonError{.line = 1, .column = 0, .reason = "it is no JSON"};
  return std::move(builder.root);
}

}  // namespace tuberia::description
