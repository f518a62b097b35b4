#pragma once
// What the tests of traced scenes share.

#include <catch2/catch.hpp>

#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "image/write_image.hpp"
#include "reference/ray_tracer/traced_scene.hpp"
#include "scene/description/read_scene.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/support/random.hpp"

namespace tuberia::tracer::traced_test {

inline SceneDescription described(const std::string& text) {
  const auto scene = scene_from_json(text, "scene.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

inline TracedScene traced(SceneDescription scene, const TracedSceneOptions& options = {}) {
  Workers workers(1);
  auto made = TracedScene::create(std::move(scene), workers, options);
  if (!made) FAIL(made.error().message);
  return *std::move(made);
}

inline TracedScene traced(const std::string& text, SurfaceKind surfaces = SurfaceKind::exact) { return traced(described(text), {.surfaces = surfaces}); }

/// Why there is no such scene; empty if there is.
inline std::string refusal_of_traced(const SceneDescription& scene) {
  Workers workers(1);
  const auto made = TracedScene::create(scene, workers);
  return made ? "" : made.error().message;
}

/// A glTF triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) with these coordinates as texture coordinates, a picture, and this material.
inline std::filesystem::path write_leaf(const TemporaryFolder& folder, const Image<Rgba8>& picture, const std::string& material) {
  REQUIRE(write_image(folder / "texture.png", picture).ok());
  return folder.write("leaf.gltf", std::string(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": "texture.png"}], "textures": [{"source": 0}], "materials": [)").append(material).append("]}"));
}

inline SceneDescription scene_of_model(const std::filesystem::path& file) {
  return described(std::string(R"({"objects": [{"shape": {"type": "model", "file": ")").append(file.string()).append("\"}}]}"));
}

struct TracedMeeting {
  Hit hit;
  SurfacePoint at;
};

/// What a ray from `from` towards `to` meets first; it must be something.
inline TracedMeeting met(const TracedScene& scene, const glm::dvec3& from, const glm::dvec3& to) {
  const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
  Traversal traversal;
  const Hit hit = scene.accelerator().nearest(ray, traversal);
  REQUIRE(hit);
  return {hit, scene.geometry().surface(ray, hit)};
}

/// The material that a ray from `from` towards `to` meets first.
inline PointMaterial material_met(const TracedScene& scene, const glm::dvec3& from, const glm::dvec3& to, const TextureFootprint& footprint = {}) {
  const TracedMeeting meeting = met(scene, from, to);
  return scene.material(meeting.hit.item, meeting.at, footprint);
}

inline double number_between(test::Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random.u64() >> 11) * 0x1p-53);
}

inline double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 difference = glm::abs(a - b);
  return std::max({difference.x, difference.y, difference.z});
}

}  // namespace tuberia::tracer::traced_test
