// Materials of glTF files: what ours make of them, and what is told to be left out.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "image/write_image.hpp"
#include "scene/description/model_material.hpp"
#include "scene/load_model.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

/// A triangle with texture coordinates (the position's x and y) and this material.
std::string gltf_triangle(const std::string& material) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": "texture.png"}], "textures": [{"source": 0}],
    "materials": [)" + material + "]}";
}

Model model_with(const std::string& material) {
  const TemporaryFolder folder;
  const Image<Rgba8> flat(2, 2, {128, 128, 255, 255});
  REQUIRE(write_image(folder / "texture.png", flat).ok());
  const auto model = load_model(folder.write("one.gltf", gltf_triangle(material)));
  if (!model) FAIL(model.error().message);
  REQUIRE(model->meshes.size() == 1);
  REQUIRE(model->meshes[0].positions.size() == 3);
  return *model;
}

const Material& material_in(const Model& model) { return model.materials.at(static_cast<std::size_t>(model.meshes.at(0).material)); }

/// Fresnel's reflectance at normal incidence.                                          [FIX 11]
double reflectance_of(float index) { return std::pow((index - 1.0) / (index + 1.0), 2); }

}  // namespace

TEST_CASE("gltf: metal and roughness are read", "[scene][gltf]") {
  const Model model = model_with(R"({"name": "copper", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.5, 0.2, 1], "metallicFactor": 1, "roughnessFactor": 0.5}})");
  const Material& material = material_in(model);
  REQUIRE(material.metallic_roughness.has_value());
  CHECK(material.metallic_roughness->metallic == 1);
  CHECK(material.metallic_roughness->roughness == 0.5f);
  CHECK(material.base_colour == glm::vec4(0.9f, 0.5f, 0.2f, 1));
  CHECK(material.normal_texture == -1);
  CHECK(model.warnings.empty());
}

TEST_CASE("gltf: a metal reflects with its base colour and is never black", "[scene][gltf]") {
  const Material copper{.base_colour = {0.9f, 0.5f, 0.2f, 1}, .metallic_roughness = MetallicRoughness{.metallic = 1, .roughness = 0.5f}};
  const description::Material material = description_of(copper);
  CHECK(material.model == description::Reflection::cook_torrance);
  CHECK_FALSE(material.divided_by_pi);
  CHECK(material.diffuse == glm::vec3(0));
  CHECK(material.ambient.value() == glm::vec3(0.9f, 0.5f, 0.2f));
  CHECK(material.roughness == Approx(0.25));
  for (int c = 0; c < 3; ++c) CHECK(reflectance_of(material.refractive_index[c]) == Approx(copper.base_colour[c]).epsilon(1e-5));
  CHECK(material.mirror == glm::vec3(0));
  const description::Material in_surroundings = description_of(copper, true);
  CHECK(in_surroundings.mirror.r == Approx(0.9 * 0.25));
}

TEST_CASE("gltf: a dielectric keeps its colour and has a colourless highlight", "[scene][gltf]") {
  const description::Material material = description_of({.base_colour = {0.2f, 0.6f, 0.4f, 1}, .metallic_roughness = MetallicRoughness{.metallic = 0, .roughness = 0}});
  CHECK(material.diffuse == glm::vec3(0.2f, 0.6f, 0.4f));
  CHECK(material.roughness == 0.02);  // of a mirror, still wide enough to be seen
  for (int c = 0; c < 3; ++c) CHECK(material.refractive_index[c] == Approx(1.5));  // reflects 0.04
  const description::Material half = description_of({.base_colour = {1, 1, 1, 1}, .metallic_roughness = MetallicRoughness{.metallic = 0.5f, .roughness = 1}});
  CHECK(half.diffuse == glm::vec3(0.5f));
  CHECK(reflectance_of(half.refractive_index.r) == Approx(0.52));
}

TEST_CASE("gltf: a normal texture becomes relief", "[scene][gltf]") {
  const Model model = model_with(R"({"normalTexture": {"index": 0, "scale": 0.5}, "pbrMetallicRoughness": {"metallicFactor": 0}})");
  REQUIRE(material_in(model).normal_texture == 0);
  CHECK(material_in(model).normal_scale == 0.5f);
  CHECK(material_in(model).texture == -1);
  CHECK(model.textures.at(0).image.at(0, 0) == Rgba8{128, 128, 255, 255});
  CHECK(model.warnings.empty());
}

TEST_CASE("gltf: what is not honoured is said, once for each material", "[scene][gltf]") {
  const Model model = model_with(R"({"name": "lamp", "emissiveFactor": [1, 1, 0], "occlusionTexture": {"index": 0}, "emissiveTexture": {"index": 0},
    "pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}})");
  REQUIRE(model.warnings.size() == 1);
  const std::string& warning = model.warnings[0];
  CAPTURE(warning);
  CHECK(one_line_naming(warning, "material 'lamp' of model"));
  for (const char* words : {"one.gltf", "a metallic-roughness texture", "an occlusion texture", "an emissive texture", "light of its own"}) CHECK(one_line_naming(warning, words));
}

TEST_CASE("gltf: Assimp's clear coats are read with their relief, and said to be left out", "[scene][gltf][models]") {
  const std::filesystem::path path = "/usr/share/assimp/models/glTF2/ClearCoat-glTF/ClearCoatTest.gltf";
  if (!std::filesystem::exists(path)) return;
  const auto model = load_model(path);
  REQUIRE(model.ok());
  int with_relief = 0;
  for (const Material& material : model->materials) {
    with_relief += material.normal_texture >= 0;
  }
  CHECK(with_relief > 0);
  const auto tells = [&](const std::string& words) {
    return std::any_of(model->warnings.begin(), model->warnings.end(), [&](const std::string& warning) { return one_line_naming(warning, words); });
  };
  CHECK(tells("a clear coat"));
  CHECK(tells("a metallic-roughness texture"));
}

TEST_CASE("gltf: other formats keep the materials that they have", "[scene][gltf]") {
  const description::Material dull = description_of({.name = "dull", .base_colour = {0.5f, 0.25f, 0.125f, 0.5f}, .two_sided = true});
  CHECK(dull.model == description::Reflection::lambert);
  CHECK(dull.name == "dull");
  CHECK(dull.diffuse == glm::vec3(0.5f, 0.25f, 0.125f));
  CHECK_FALSE(dull.ambient.has_value());
  CHECK(dull.alpha == 0.5);
  CHECK(dull.two_sided);
  const description::Material shiny = description_of({.specular = glm::vec3(0.5f), .shininess = 20});
  CHECK(shiny.model == description::Reflection::blinn_phong);
  CHECK(shiny.exponent == 20);
  CHECK(shiny.specular == glm::vec3(0.5f));
}

}  // namespace tuberia
