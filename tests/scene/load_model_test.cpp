// What a loaded model looks like.

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

#include <glm/geometric.hpp>

#include "image/write_image.hpp"
#include "scene/load_model.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

namespace fs = std::filesystem;

/// A square of two triangles in the plane z = 0, with texture coordinates, facing +z.
const std::string kSquare =
    "mtllib square.mtl\nusemtl painted\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

std::string with_windows_lines(const std::string& text) {
  std::string lines;
  for (const char letter : text) {
    if (letter == '\n') lines += '\r';
    lines += letter;
  }
  return lines;
}

Result<Model> load_square(const TemporaryFolder& folder, const std::string& material) {
  folder.write("square.mtl", "newmtl painted\n" + material);
  return load_model(folder.write("square.obj", kSquare));
}

void check_attributes_fit(const Model& model) {
  for (const Mesh& mesh : model.meshes) {
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    REQUIRE((mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size()));
    REQUIRE((mesh.colours.empty() || mesh.colours.size() == mesh.positions.size()));
    REQUIRE(mesh.indices.size() % 3 == 0);
    REQUIRE(mesh.material >= 0);
    REQUIRE(mesh.material < static_cast<int>(model.materials.size()));
    bool indices_in_range = true, unit_normals = true;
    for (const std::uint32_t index : mesh.indices) indices_in_range &= index < mesh.positions.size();
    for (const glm::vec3& normal : mesh.normals)
      unit_normals &= std::abs(glm::length(normal) - 1.0f) < 1e-5f;
    CHECK(indices_in_range);
    CHECK(unit_normals);
  }
  for (const Material& material : model.materials)
    CHECK(material.texture < static_cast<int>(model.textures.size()));
}

}  // namespace

TEST_CASE("scene: a square stays indexed, with texture coordinates from the upper left", "[scene]") {
  const TemporaryFolder folder("with spaces");
  const bool windows = GENERATE(false, true);
  const Result<Model> model =
      load_model(folder.write("my square.obj", windows ? with_windows_lines(kSquare) : kSquare));
  CAPTURE(model.ok() ? "" : model.error().message);
  REQUIRE(model.ok());
  check_attributes_fit(*model);
  REQUIRE(model->meshes.size() == 1);
  const Mesh& mesh = model->meshes[0];
  CHECK(model->triangle_count() == 2);
  CHECK(model->vertex_count() == 4);
  CHECK(mesh.positions[0] == glm::vec3(0, 0, 0));
  CHECK(mesh.texcoords[0] == glm::vec2(0, 1));
  CHECK(mesh.texcoords[2] == glm::vec2(1, 0));
  for (const glm::vec3& normal : mesh.normals) CHECK(normal == glm::vec3(0, 0, 1));
  CHECK(model->bounds() == Bounds{glm::vec3(0, 0, 0), glm::vec3(1, 1, 0)});
}

TEST_CASE("scene: OBJ colours are decoded from sRGB, opacity is not", "[scene]") {
  const TemporaryFolder folder;
  const Result<Model> model = load_square(folder, "Kd 0.5 1 0\nKs 0.25 0.25 0.25\nNs 20\nd 0.5\n");
  REQUIRE(model.ok());
  CHECK(model->warnings.empty());
  const Material& material = model->materials[static_cast<std::size_t>(model->meshes[0].material)];
  CHECK(material.name == "painted");
  CHECK(material.base_colour.r == Approx(0.21404114).epsilon(1e-5));
  CHECK(material.base_colour.g == 1.0f);
  CHECK(material.base_colour.b == 0.0f);
  CHECK(material.base_colour.a == 0.5f);
  CHECK(material.specular.r == Approx(0.05087609).epsilon(1e-5));
  CHECK(material.shininess == 20.0f);
  CHECK(material.texture == -1);
}

TEST_CASE("scene: a texture is found under the names that other machines give it", "[scene]") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder / "Bricks.png", Image<Rgba8>(2, 2, {1, 2, 3, 255})).ok());
  fs::create_directory(folder / "Maps");
  REQUIRE(write_image(folder / "Maps/wood 1.png", Image<Rgba8>(2, 2, {1, 2, 3, 255})).ok());
  const std::string name =
      GENERATE("Bricks.png", "bricks.PNG", "C:\\Users\\somebody\\bricks.png", "/home/somebody/Bricks.png",
               "..\\elsewhere\\Bricks.png", "./Bricks.png", "maps\\wood 1.png", "Maps/Wood 1.png");
  CAPTURE(name);
  const Result<Model> model = load_square(folder, "map_Kd " + name + "\n");
  REQUIRE(model.ok());
  CHECK(model->warnings.empty());
  REQUIRE(model->textures.size() == 1);
  CHECK(!model->textures[0].missing);
  CHECK(model->textures[0].image.at(1, 1) == Rgba8{1, 2, 3, 255});
  CHECK(model->materials[static_cast<std::size_t>(model->meshes[0].material)].texture == 0);
}

TEST_CASE("scene: a texture that is missing or corrupt becomes a checker with a warning", "[scene]") {
  const TemporaryFolder folder;
  folder.write("corrupt.png", "\x89PNG\r\n\x1a\n but no more");
  const std::string name = GENERATE("missing.png", "corrupt.png");
  const Result<Model> model = load_square(folder, "map_Kd " + name + "\n");
  REQUIRE(model.ok());
  REQUIRE(model->textures.size() == 1);
  CHECK(model->textures[0].missing);
  CHECK(model->textures[0].image.at(0, 0) == Rgba8{255, 0, 255, 255});
  CHECK(model->textures[0].image.at(8, 0) == Rgba8{0, 0, 0, 255});
  REQUIRE(model->warnings.size() == 1);
  CHECK(one_line_naming(model->warnings[0], name));
  CHECK(one_line_naming(model->warnings[0], "square.obj"));
}

TEST_CASE("scene: a missing material library is a warning", "[scene]") {
  const TemporaryFolder folder;
  const Result<Model> model = load_model(folder.write("square.obj", kSquare));
  REQUIRE(model.ok());
  REQUIRE(model->warnings.size() == 1);
  CHECK(one_line_naming(model->warnings[0], "square.mtl"));
}

TEST_CASE("scene: points and lines are left out with a warning", "[scene]") {
  const TemporaryFolder folder;
  const Result<Model> model =
      load_model(folder.write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 3\nf 1 2 3\n"));
  REQUIRE(model.ok());
  CHECK(model->triangle_count() == 1);
  REQUIRE(model->warnings.size() == 1);
  CHECK(one_line_naming(model->warnings[0], "points and lines"));
}

TEST_CASE("scene: triangles without an area are kept", "[scene]") {
  const TemporaryFolder folder;
  const Result<Model> model = load_model(
      folder.write("thin.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\n"));
  REQUIRE(model.ok());
  CHECK(model->triangle_count() == 3);
  check_attributes_fit(*model);
}

TEST_CASE("scene: a very small model keeps its vertices apart", "[scene]") {
  const TemporaryFolder folder;
  const Result<Model> model =
      load_model(folder.write("tiny.obj", "v 0 0 0\nv 1e-7 0 0\nv 0 1e-7 0\nf 1 2 3\n"));
  REQUIRE(model.ok());
  CHECK(model->vertex_count() == 3);
  CHECK(model->meshes[0].normals[0] == glm::vec3(0, 0, 1));
}

TEST_CASE("scene: a node's mirror keeps fronts outside, its scale keeps normals perpendicular",
          "[scene]") {
  const TemporaryFolder folder;
  // Three positions, a normal each and three indices of 16 bits, in base 64.
  const std::string buffer =
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
      "AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/AAABAAIA";
  const std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[-2,1,1],"translation":[0,0,5]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
      R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},)"
      R"({"buffer":0,"byteOffset":72,"byteLength":6}],)"
      R"("buffers":[{"byteLength":78,"uri":"data:application/octet-stream;base64,)" +
      buffer + R"("}]})";
  const Result<Model> model = load_model(folder.write("mirror.gltf", text));
  REQUIRE(model.ok());
  check_attributes_fit(*model);
  CHECK(model->bounds() == Bounds{glm::vec3(-2, 0, 5), glm::vec3(0, 1, 5)});
  const Mesh& mesh = model->meshes[0];
  const glm::vec3 a = mesh.positions[mesh.indices[0]], b = mesh.positions[mesh.indices[1]],
                  c = mesh.positions[mesh.indices[2]];
  CHECK(glm::normalize(glm::cross(b - a, c - a)) == glm::vec3(0, 0, 1));
  CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
}

TEST_CASE("scene: the bunny of glmark2 is whole, indexed and smooth", "[scene][models]") {
  const fs::path path = "/usr/share/glmark2/models/bunny.obj";
  if (!fs::exists(path)) return;
  const Result<Model> model = load_model(path);
  REQUIRE(model.ok());
  check_attributes_fit(*model);
  CHECK(model->triangle_count() == 69666);
  CHECK(model->vertex_count() == 34835);
  CHECK(model->warnings.empty());
}

}  // namespace tuberia
