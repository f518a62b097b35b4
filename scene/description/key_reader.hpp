#pragma once
// Reads a description from JSON, key by key.

#include <optional>
#include <string>
#include <vector>

#include "scene/description/keys.hpp"
#include "scene/description/located_json.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia::description {

/// Takes over what the text says and leaves defaults elsewhere. What is wrong it notes and goes on; the
/// complaint that counts is the first one in the text.
class KeyReader final : public Keys {
 public:
  /// root: an object; must outlive the reader.
  explicit KeyReader(const LocatedJson& root) { levels_.push_back({.json = &root, .path = ""}); }

  /// When all keys were visited: refuses those that nobody asked for, and names that are not there.
  void finish(const SceneDescription& scene);
  const std::optional<JsonError>& error() const noexcept { return error_; }

  using Keys::number;
  using Keys::whole;
  void number(const Key&, double& value, const Range&) override;
  void whole(const Key&, std::int64_t& value, std::int64_t least, std::int64_t most) override;
  void flag(const Key&, bool& value) override;
  void text(const Key&, std::string& value) override;
  void name(const Key&, std::string& value, NameOf) override;
  void one_of(const Key&, std::size_t& choice, std::span<const std::string_view> names) override;
  void numbers(const Key&, std::span<double> values, const Range&, bool or_one) override;
  void rows(const Key&, std::vector<std::vector<double>>& rows, std::size_t columns, const Range&) override;
  void which(std::span<const std::string_view> keys, std::size_t& choice) override;
  void require(std::string_view key, bool holds, std::string_view reason) override;

 private:
  /// An object that is being read, or a list, and the keys that were asked for.
  struct Level {
    const LocatedJson* json;
    std::string path;
    std::vector<std::string_view> asked{};
  };
  struct Reference {
    std::string path;
    int line;
    std::string name;
    NameOf kind;
  };

  bool begin_where(std::string_view, bool holds) override { return holds; }
  void end_where() override {}
  bool begin_object(const Key&, bool is_there) override;
  void end_object() override;
  std::size_t begin_list(const Key&, std::size_t count) override;
  std::size_t begin_named(const Key&, std::size_t count) override;
  void begin_item(std::size_t index) override;
  void begin_named_item(std::size_t index, std::string& name) override;
  void end_item() override { end_object(); }
  void end_list() override { levels_.pop_back(); }

  const LocatedJson* find(const Key&);
  const LocatedJson* find(const Key&, LocatedJson::Kind);
  const LocatedJson* open_level(const Key&, LocatedJson::Kind);
  bool is_number(const LocatedJson&, const std::string& path, const Range&);
  bool row_of(const LocatedJson&, const std::string& path, std::size_t columns, const Range&, std::vector<double>& row);
  std::string path_of(std::string_view key) const;
  void refuse_unknown_keys();
  void refuse(int line, const std::string& reason);

  std::vector<Level> levels_;
  std::vector<Reference> references_;
  std::optional<JsonError> error_;
};

}  // namespace tuberia::description
