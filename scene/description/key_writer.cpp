// A description as JSON.

#include <nlohmann/json.hpp>

#include "scene/description/read_scene.hpp"
#include "scene/description/scene_keys.hpp"

namespace tuberia {
namespace description {
namespace {

using Json = nlohmann::ordered_json;

/// Writes every key, also where it has its default.
class KeyWriter final : public Keys {
 public:
  KeyWriter() { levels_.push_back({.key = "", .value = Json::object()}); }
  std::string text() const { return levels_.front().value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

  using Keys::number;
  using Keys::whole;
  void number(const Key& key, double& value, const Range&) override { put(key.name, value); }
  void whole(const Key& key, std::int64_t& value, std::int64_t, std::int64_t) override { put(key.name, value); }
  void flag(const Key& key, bool& value) override { put(key.name, value); }
  void text(const Key& key, std::string& value) override { put(key.name, value); }
  void name(const Key& key, std::string& value, NameOf) override { put(key.name, value); }
  void one_of(const Key& key, std::size_t& choice, std::span<const std::string_view> names) override { put(key.name, names[choice]); }
  void numbers(const Key& key, std::span<double> values, const Range&, bool) override { put(key.name, std::vector<double>(values.begin(), values.end())); }
  void rows(const Key& key, std::vector<std::vector<double>>& rows, std::size_t, const Range&) override { put(key.name, rows); }
  void which(std::span<const std::string_view>, std::size_t&) override {}
  void require(std::string_view, bool, std::string_view) override {}

 private:
  /// A value that is being filled, and the key that it will stand under; a named item has its own.
  struct Level {
    std::string key{};
    Json value;
  };

  bool begin_where(std::string_view, bool holds) override { return holds; }
  void end_where() override {}
  bool begin_object(const Key& key, bool is_there) override {
    if (is_there) levels_.push_back({.key = std::string(key.name), .value = Json::object()});
    return is_there;
  }
  void end_object() override { close(); }
  std::size_t begin_list(const Key& key, std::size_t count) override {
    levels_.push_back({.key = std::string(key.name), .value = Json::array()});
    return count;
  }
  std::size_t begin_named(const Key& key, std::size_t count) override {
    levels_.push_back({.key = std::string(key.name), .value = Json::object()});
    return count;
  }
  void begin_item(std::size_t) override { levels_.push_back({.key = "", .value = Json::object()}); }
  void begin_named_item(std::size_t, std::string& name) override { levels_.push_back({.key = name, .value = Json::object()}); }
  void end_item() override { close(); }
  void end_list() override { close(); }

  template <class T>
  void put(std::string_view key, const T& value) { levels_.back().value[std::string(key)] = value; }
  void close() {
    Level level = std::move(levels_.back());
    levels_.pop_back();
    Json& parent = levels_.back().value;
    if (parent.is_array()) parent.push_back(std::move(level.value));
    else parent[level.key] = std::move(level.value);
  }

  std::vector<Level> levels_;
};

}  // namespace
}  // namespace description

std::string json_of_scene(const SceneDescription& scene) {
  SceneDescription copy = scene;  // who visits keys may change values; this one does not
  description::KeyWriter writer;
  description::scene_keys(writer, copy);
  return writer.text();
}

}  // namespace tuberia
