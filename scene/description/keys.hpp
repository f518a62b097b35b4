#pragma once
// The keys of a scene file, said once: the functions in *_keys.cpp tell them, with their meaning, range and
// default, to whoever visits a description: who reads a file, writes one, or prints the page of all keys.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tuberia::description {

/// A key and what it means. required: there is no default.
struct Key {
  std::string_view name, meaning;
  bool required = false;
};

/// What a number may be. No number of a scene is larger than kLargest, so that all are finite as floats.
struct Range {
  static constexpr double kLargest = 1e30;
  double least = -kLargest, most = kLargest;
  bool least_excluded = false, most_excluded = false;

  bool contains(double value) const noexcept;
  std::string words() const;  // "0 or more"; "" if any number will do
};
constexpr Range at_least(double least) noexcept { return {.least = least}; }
constexpr Range above(double least) noexcept { return {.least = least, .least_excluded = true}; }
constexpr Range within(double least, double most) noexcept { return {.least = least, .most = most}; }
constexpr Range inside(double least, double most) noexcept { return {.least = least, .most = most, .least_excluded = true, .most_excluded = true}; }

/// What a text may name.
enum class NameOf : std::uint8_t { texture, material };

class Keys {
 public:
  virtual ~Keys() = default;

  virtual void number(const Key&, double& value, const Range& = {}) = 0;
  virtual void whole(const Key&, std::int64_t& value, std::int64_t least, std::int64_t most) = 0;
  virtual void flag(const Key&, bool& value) = 0;
  virtual void text(const Key&, std::string& value) = 0;
  virtual void name(const Key&, std::string& value, NameOf) = 0;  // "": none
  virtual void one_of(const Key&, std::size_t& choice, std::span<const std::string_view> names) = 0;
  /// As many numbers as there are; with `or_one`, one number for all of them will do.
  virtual void numbers(const Key&, std::span<double> values, const Range&, bool or_one) = 0;
  /// Rows of numbers, each of `columns`, or all as long if that is 0.
  virtual void rows(const Key&, std::vector<std::vector<double>>& rows, std::size_t columns, const Range&) = 0;
  /// Which one of these keys the object has.
  virtual void which(std::span<const std::string_view> keys, std::size_t& choice) = 0;
  /// A condition between several keys; `key` is the one to blame. The reason continues its name.
  virtual void require(std::string_view key, bool holds, std::string_view reason) = 0;

  // The rest of the conveniences, in terms of these.
  void number(const Key&, float& value, const Range& = {});
  void whole(const Key&, int& value, int least, int most);
  void seed(const Key&, std::uint32_t& value);
  void vector(const Key& key, glm::dvec3& value) { numbers(key, {&value.x, 3}, {}, false); }
  void pair(const Key& key, glm::dvec2& value, const Range& range) { numbers(key, {&value.x, 2}, range, true); }
  void factors(const Key& key, glm::dvec3& value) { numbers(key, {&value.x, 3}, {}, true); }
  void colour(const Key&, glm::vec3& value, const Range& = at_least(0));

  template <class Enumeration>
  void choice(const Key& key, Enumeration& value, std::span<const std::string_view> names) {
    auto index = static_cast<std::size_t>(value);
    one_of(key, index, names);
    value = static_cast<Enumeration>(index);
  }

  /// Keys that are there only if something holds, which the words say: "type is spot".
  template <class Visit>
  void where(std::string_view words, bool holds, Visit&& visit) {
    if (!begin_where(words, holds)) return;
    visit();
    end_where();
  }

  template <class T, class Visit>
  void object(const Key& key, T& value, Visit&& visit) {
    if (!begin_object(key, true)) return;
    visit(*this, value);
    end_object();
  }
  template <class T, class Visit>
  void object(const Key& key, std::optional<T>& value, Visit&& visit) {
    if (!begin_object(key, value.has_value())) return;
    if (!value) value.emplace();
    visit(*this, *value);
    end_object();
  }

  template <class T, class Visit>
  void list(const Key& key, std::vector<T>& items, Visit&& visit) {
    items.resize(begin_list(key, items.size()));
    for (std::size_t i = 0; i < items.size(); ++i) {
      begin_item(i);
      visit(*this, items[i]);
      end_item();
    }
    end_list();
  }

  /// Objects that the file has under their names.
  template <class T, class Visit>
  void named(const Key& key, std::vector<T>& items, Visit&& visit) {
    items.resize(begin_named(key, items.size()));
    for (std::size_t i = 0; i < items.size(); ++i) {
      begin_named_item(i, items[i].name);
      visit(*this, items[i]);
      end_item();
    }
    end_list();
  }

 protected:
  virtual bool begin_where(std::string_view words, bool holds) = 0;  // whether to visit
  virtual void end_where() = 0;
  virtual bool begin_object(const Key&, bool is_there) = 0;           // whether to visit
  virtual void end_object() = 0;
  virtual std::size_t begin_list(const Key&, std::size_t count) = 0;  // how many items to visit
  virtual std::size_t begin_named(const Key&, std::size_t count) = 0;
  virtual void begin_item(std::size_t index) = 0;
  virtual void begin_named_item(std::size_t index, std::string& name) = 0;
  virtual void end_item() = 0;
  virtual void end_list() = 0;
};

/// The number that a person would write for a float: 0.1, not 0.10000000149.
double as_written(float value) noexcept;
/// "0.1", "1e+30": as few digits as tell it from all other doubles.
std::string words_of(double value);

}  // namespace tuberia::description
