#include "scene/description/check_scene.hpp"

#include <cmath>

#include "scene/description/scene_keys.hpp"

namespace tuberia {
namespace description {
namespace {

/// Visits a description as it is, and keeps the first complaint.
class KeyChecker final : public Keys {
 public:
  explicit KeyChecker(const SceneDescription& scene) : scene_(scene) {}
  const std::string& complaint() const noexcept { return complaint_; }

  using Keys::number;
  using Keys::whole;
  void number(const Key& key, double& value, const Range& range) override { check(path_of(key.name), value, range); }
  void whole(const Key& key, std::int64_t& value, std::int64_t least, std::int64_t most) override {
    check(path_of(key.name), static_cast<double>(value), within(static_cast<double>(least), static_cast<double>(most)));
  }
  void flag(const Key&, bool&) override {}
  void text(const Key& key, std::string& value) override {
    if (key.required && value.empty()) complain(path_of(key.name) + " is empty");
  }
  void name(const Key& key, std::string& value, NameOf kind) override {
    text(key, value);
    if (value.empty()) return;
    const bool is_texture = kind == NameOf::texture;
    const bool is_there = is_texture ? find_texture(scene_, value) != nullptr : find_material(scene_, value) != nullptr;
    if (!is_there) complain(path_of(key.name) + " is '" + value + "', but there is no " + (is_texture ? "texture" : "material") + " of that name");
  }
  void one_of(const Key& key, std::size_t& choice, std::span<const std::string_view> names) override {
    if (choice >= names.size()) complain(path_of(key.name) + " is none of its values");
  }
  void numbers(const Key& key, std::span<double> values, const Range& range, bool) override {
    for (std::size_t i = 0; i < values.size(); ++i) check(path_of(key.name), i, values[i], range);
  }
  void rows(const Key& key, std::vector<std::vector<double>>& rows, std::size_t columns, const Range& range) override {
    for (std::size_t row = 0; row < rows.size() && complaint_.empty(); ++row) {
      if (rows[row].size() != (columns == 0 ? rows[0].size() : columns)) complain(path_of(key.name, row) + " is a list of " + std::to_string(rows[row].size()));
      for (std::size_t i = 0; i < rows[row].size(); ++i)
        if (!range.contains(rows[row][i])) check(path_of(key.name, row), i, rows[row][i], range);
    }
  }
  void which(std::span<const std::string_view>, std::size_t&) override {}
  void require(std::string_view key, bool holds, std::string_view reason) override {
    if (!holds) complain(path_of(key) + " " + std::string(reason));
  }

 private:
  bool begin_where(std::string_view, bool holds) override { return holds; }
  void end_where() override {}
  bool begin_object(const Key& key, bool is_there) override {
    if (is_there) paths_.push_back(path_of(key.name));
    return is_there;
  }
  void end_object() override { paths_.pop_back(); }
  std::size_t begin_list(const Key& key, std::size_t count) override {
    paths_.push_back(path_of(key.name));
    return count;
  }
  std::size_t begin_named(const Key& key, std::size_t count) override { return begin_list(key, count); }
  void begin_item(std::size_t index) override { paths_.push_back(paths_.back() + "[" + std::to_string(index) + "]"); }
  void begin_named_item(std::size_t, std::string& name) override { paths_.push_back(path_of(name)); }
  void end_item() override { paths_.pop_back(); }
  void end_list() override { paths_.pop_back(); }

  std::string path_of(std::string_view key) const { return (paths_.back().empty() ? "" : paths_.back() + ".") + std::string(key); }
  std::string path_of(std::string_view key, std::size_t index) const { return path_of(key) + "[" + std::to_string(index) + "]"; }
  void check(const std::string& path, double value, const Range& range) {
    if (range.contains(value)) return;
    const std::string words = range.words();
    complain(path + " is " + words_of(value) + (std::abs(value) > Range::kLargest ? ", which is too large" : words.empty() ? ", which is no number" : ", but must be " + words));
  }
  void check(const std::string& list, std::size_t index, double value, const Range& range) {
    if (!range.contains(value)) check(list + "[" + std::to_string(index) + "]", value, range);
  }
  void complain(std::string what) {
    if (complaint_.empty()) complaint_ = std::move(what);
  }

  const SceneDescription& scene_;
  std::vector<std::string> paths_{""};
  std::string complaint_;
};

}  // namespace
}  // namespace description

Result<Nothing> check_scene(const SceneDescription& scene) {
  SceneDescription copy = scene;  // who visits keys may change values; this one does not
  description::KeyChecker checker(scene);
  description::scene_keys(checker, copy);
  if (!checker.complaint().empty()) return Error{checker.complaint()};
  return Nothing{};
}

}  // namespace tuberia
