// The page of all keys, from the functions that read them.

#include <algorithm>
#include <utility>

#include "scene/description/read_scene.hpp"
#include "scene/description/scene_keys.hpp"

namespace tuberia {
namespace description {
namespace {

std::string code(std::string_view text) {
  std::string quoted(1, '`');
  quoted += text;
  return quoted += '`';
}

std::string with_range(const std::string& kind, const Range& range) {
  const std::string words = range.words();
  return words.empty() ? kind : kind + ", " + words;
}

/// Visits a description of defaults and notes every key, on whatever condition it is there.
class KeyPage final : public Keys {
 public:
  /// The tables, a section for each object.
  std::string text() const {
    std::string page;
    for (const Section& section : sections_) {
      page += "\n## " + (section.path.empty() ? "The scene" : code(section.path)) + "\n\n| key | value | unless given | meaning |\n|---|---|---|---|\n";
      for (const std::string& row : section.rows) page += row;
    }
    return page;
  }

  using Keys::number;
  using Keys::whole;
  void number(const Key& key, double& value, const Range& range) override { add(key, with_range("a number", range), words_of(value)); }
  void whole(const Key& key, std::int64_t& value, std::int64_t least, std::int64_t most) override {
    add(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), std::to_string(value));
  }
  void flag(const Key& key, bool& value) override { add(key, "true or false", value ? "true" : "false"); }
  void text(const Key& key, std::string&) override { add(key, "a text", "empty"); }
  void name(const Key& key, std::string&, NameOf kind) override { add(key, kind == NameOf::texture ? "the name of a texture" : "the name of a material", "none"); }
  void one_of(const Key& key, std::size_t& choice, std::span<const std::string_view> names) override {
    std::string values;
    for (const std::string_view each : names) values += (values.empty() ? "" : ", ") + code(each);
    add(key, values, code(names[choice]));
  }
  void numbers(const Key& key, std::span<double> values, const Range& range, bool or_one) override {
    std::string list;
    for (const double value : values) list += (list.empty() ? "[" : ", ") + words_of(value);
    const bool are_equal = std::all_of(values.begin(), values.end(), [&](double value) { return value == values[0]; });
    const std::string kind = (or_one ? "a number or a list of " : "a list of ") + std::to_string(values.size()) + (or_one ? "" : " numbers");
    add(key, with_range(kind, range), or_one && are_equal ? words_of(values[0]) : list + "]");
  }
  void rows(const Key& key, std::vector<std::vector<double>>&, std::size_t columns, const Range& range) override {
    add(key, with_range(columns == 0 ? "a list of lists of numbers, all as long" : "a list of lists of " + std::to_string(columns) + " numbers", range), "none");
  }
  void which(std::span<const std::string_view> keys, std::size_t&) override {
    std::string names;
    for (const std::string_view each : keys) names += (names.empty() ? "" : ", ") + code(each);
    alternatives_ = "one of " + names;
  }
  void require(std::string_view, bool, std::string_view) override {}

 private:
  struct Section {
    std::string path;
    std::vector<std::string> rows{};
  };

  void add(const Key& key, const std::string& value, const std::string& standard) {
    std::string condition;
    for (const std::string& each : conditions_) condition += each.empty() ? "" : "if " + each + ": ";
    const std::string absent = !key.required ? standard : alternatives_.empty() ? "must be there" : alternatives_;
    sections_[open_.back()].rows.push_back("| " + code(key.name) + " | " + value + " | " + absent + " | " + condition + std::string(key.meaning) + " |\n");
  }
  /// A section of its own for what the key stands for.
  void open(const Key& key, const std::string& kind, const std::string& suffix) {
    const std::string& parent = sections_[open_.back()].path;
    const std::string path = (parent.empty() ? "" : parent + ".") + std::string(key.name) + suffix;
    add(key, kind, "none");
    open_.push_back(sections_.size());
    sections_.push_back({.path = path});
    outer_conditions_.push_back(std::exchange(conditions_, {}));
  }
  void close() {
    open_.pop_back();
    conditions_ = std::move(outer_conditions_.back());
    outer_conditions_.pop_back();
    alternatives_.clear();
  }

  bool begin_where(std::string_view words, bool) override {
    conditions_.emplace_back(words);
    return true;
  }
  void end_where() override { conditions_.pop_back(); }
  bool begin_object(const Key& key, bool) override {
    open(key, "an object", "");
    return true;
  }
  void end_object() override { close(); }
  std::size_t begin_list(const Key& key, std::size_t) override {
    open(key, "a list of objects", "[]");
    return 1;
  }
  std::size_t begin_named(const Key& key, std::size_t) override {
    open(key, "objects under their names", ".NAME");
    return 1;
  }
  void begin_item(std::size_t) override {}
  void begin_named_item(std::size_t, std::string&) override {}
  void end_item() override {}
  void end_list() override { close(); }

  std::vector<Section> sections_{{.path = ""}};
  std::vector<std::size_t> open_{0};
  std::vector<std::string> conditions_;
  std::vector<std::vector<std::string>> outer_conditions_;
  std::string alternatives_;  // of an object that has exactly one of several keys
};

constexpr std::string_view kIntroduction = R"(# The scene file

`tuberia render SCENE.json -o PICTURE.png` draws a scene, `tuberia info SCENE.json` lists what is in it. The file is
JSON [JSON]; examples are in `examples/scenes`. This page is printed by the functions that read the file
(`tuberia info --scene-keys`), and a test compares the two.

Every key is read or refused: one that is unknown, there twice, of the wrong kind or out of range is an error that
names file, line and key, as `teapot.json:14: materials.red.exponent is -3, but must be 0 or more`. Numbers are at
most 1e30. Lengths are world units, y is up; angles are degrees; colours are linear RGB, `0.5` the same as
`[0.5, 0.5, 0.5]`. Files are looked for beside the scene file.
)";

constexpr std::string_view kModelMaterials = R"(
## Materials of model files

With `own_materials` a model keeps what its file says (`scene/description/model_material.hpp`). Of glTF's
metallic-roughness materials (base colour B, metallic M, roughness R) ours are Cook-Torrance with

| constant | value |
|---|---|
| `diffuse` | B (1 - M), times the base colour texture |
| `ambient` | B, so that metals are never black |
| `refractive_index` | (1 + s) / (1 - s), s = sqrt(F0) up to 0.98, of the reflectance F0 = 0.04 (1 - M) + B M |
| `specular`, `divided_by_pi` | 1, false |
| `roughness` | the larger of R^2 and 0.02 |
| `mirror` | F0 (1 - R)^2 where the scene has an environment, else 0 |
| `bump` | the normal texture, times its scale |

What is not honoured is a warning for each material: metallic-roughness, occlusion and emissive textures, light
of its own, clear coats, sheen, transmission, further sets of texture coordinates.
)";

}  // namespace
}  // namespace description

std::string scene_file_page() {
  SceneDescription scene;
  description::KeyPage page;
  description::scene_keys(page, scene);
  return std::string(description::kIntroduction) + page.text() + std::string(description::kModelMaterials);
}

}  // namespace tuberia
