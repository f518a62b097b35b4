// Model files that are refused, and what the refusal says.

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/load_model.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

namespace fs = std::filesystem;

/// Loads a file that must be refused with these words, in one line that names the file.
void check_refused(const fs::path& path, const std::string& words) {
  const Result<Model> model = load_model(path);
  CAPTURE(path);
  REQUIRE(!model.ok());
  CAPTURE(model.error().message);
  CHECK(one_line_naming(model.error().message, words));
  CHECK(one_line_naming(model.error().message, path.filename().string()));
}

const std::string kThreeVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("scene: what is no model file is refused with its reason", "[scene][refused]") {
  const TemporaryFolder folder("with spaces");
  check_refused(folder / "missing.obj", "no such file");
  check_refused(folder / "missing folder/a.obj", "no such file");
  check_refused(folder / "", "it is a folder");
  check_refused(folder.write("empty.obj", ""), "the file is empty");
  check_refused(folder.write("a.unknown", "This is no model.\n"), "unknown model format");
  check_refused(folder.write("noextension", "This is no model.\n"), "unknown model format");
  check_refused(folder.write("text.obj", "This is no model.\n"), "text.obj");
  check_refused(folder.write("text.glb", "This is no model.\n"), "text.glb");
}

TEST_CASE("scene: an OBJ with an index out of range is refused with line and count", "[scene][refused]") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& lines, const std::string& words) {
    check_refused(folder.write("bad.obj", kThreeVertices + lines), words);
  };
  refused("f 1 2 900\n", "line 4: index 900, but the model has 3 vertices");
  refused("f 1 2 3\nf 1 2 -4\n", "line 5: index -4, but the model has 3 vertices so far");
  refused("f 0 1 2\n", "line 4: index 0");
  refused("f 1/1 2/1 3/1\n", "line 4: index 1, but the model has 0 texture coordinates");
  refused("vn 0 0 1\nf 1//1 2//1 3//2\n", "line 5: index 2, but the model has 1 normals");
  refused("f 1 2 \\\n99\n", "line 4: index 99");
  refused("f 1 2 99999999999999999999\n", "line 4: index 99999999999999999999 is out of range");
  refused("\r\nf 1 2 900\r\n", "line 5: index 900");
}

TEST_CASE("scene: a truncated or corrupt OBJ is refused", "[scene][refused]") {
  const TemporaryFolder folder;
  check_refused(folder.write("a.obj", kThreeVertices + "f 1 2"), "line 4: the file ends within a face");
  check_refused(folder.write("b.obj", "v 0 0 0\nv 1 0"), "line 2: a vertex of 2 numbers");
  check_refused(folder.write("c.obj", kThreeVertices), "c.obj");
  check_refused(folder.write("d.obj", kThreeVertices + "l 1 2\n"), "it has no triangles");
  check_refused(folder.write("e.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "e.obj");
}

TEST_CASE("scene: a position that is not finite is refused with its vertex", "[scene][refused]") {
  const TemporaryFolder folder;
  const std::string number = GENERATE("nan", "inf", "-inf", "1e999");
  CAPTURE(number);
  const fs::path path = folder.write("bad.obj", "o x\nv 0 0 0\nv 1 " + number + " 0\nv 0 1 0\nf 1 2 3\n");
  check_refused(path, "vertex 1 of mesh 'x' has a position that is not finite");
}

TEST_CASE("scene: OFF files that claim, lack or misname something are refused", "[scene][refused]") {
  const TemporaryFolder folder;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  REQUIRE(load_model(folder.write("good.off", "OFF\n# three\n3 1 0\n" + vertices + "3 0 1 2\n")).ok());
  check_refused(folder.write("a.off", "OFF\n353535235358 6 0\n0 0 0\n"),
                "it claims 353535235358 vertices");
  check_refused(folder.write("b.off", "OFF\n3 1 0\n" + vertices + "3 0 1 900\n"),
                "line 6: index 900, but the model has 3 vertices");
  check_refused(folder.write("c.off", "OFF\n3 1 0\n" + vertices), "it is truncated: 0 of 1 faces");
  check_refused(folder.write("d.off", "OFF\n3 1 0\n" + vertices + "3 0 1"),
                "a face breaks off after 2 of 3");
  check_refused(folder.write("e.off", "OFF\n"), "no valid counts");
}

TEST_CASE("scene: PLY files that claim, lack or misname something are refused", "[scene][refused]") {
  const TemporaryFolder folder;
  const auto ply = [](const std::string& count, const std::string& body) {
    return "ply\nformat ascii 1.0\nelement vertex " + count +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
           "property list uchar int vertex_index\nend_header\n" +
           body;
  };
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  REQUIRE(load_model(folder.write("good.ply", ply("3", vertices + "3 0 1 2\n"))).ok());
  const std::string two_lines = "comment\nMade by somebody\nelement vertex";
  std::string commented = ply("3", vertices + "3 0 1 2\n");
  REQUIRE(load_model(
              folder.write("commented.ply", commented.replace(commented.find("element"), 14, two_lines)))
              .ok());
  check_refused(folder.write("a.ply", ply("353535235358", vertices)),
                "it claims 353535235358 elements 'vertex'");
  check_refused(folder.write("b.ply", ply("3", vertices + "3 0 1 900\n")), "index 900");
  check_refused(folder.write("c.ply", ply("3", vertices + "3 0 1")),
                "the elements 'face' break off after 0 of 1");
  check_refused(folder.write("d.ply", "ply\nformat ascii 1.0\n"), "its header breaks off");
  check_refused(folder.write("e.ply", "ply\nformat ascii 1.0\nelement vertex x\nend_header\n"),
                "invalid line");
  check_refused(folder.write("f.ply", "ply\nformat ascii 1.0\nend_header50 0 0\n"),
                "its header breaks off");
}

TEST_CASE("scene: Collada with a broken index list or a wrong count is refused", "[scene][refused]") {
  const TemporaryFolder folder;
  check_refused(folder.write("a.dae", "<COLLADA>\n<p>0 1 2q3</p>\n</COLLADA>\n"),
                "line 2: a list of indices is corrupt");
  check_refused(folder.write("b.dae", "<source><float_array>1 2 3</float_array></source>"),
                "an array without a count");
  check_refused(folder.write("c.dae",
                             "<source>\n<float_array count=\"3\">1 2 3</float_array>\n"
                             "<accessor count=\"2\" stride=\"3\"/></source>"),
                "line 3: an accessor reaches beyond its array of 3 numbers");
}

TEST_CASE("scene: truncated ASCII STL is refused", "[scene][refused]") {
  const TemporaryFolder folder;
  check_refused(folder.write("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
                "it is truncated");
}

TEST_CASE("scene: truncated glTF is refused", "[scene][refused]") {
  const TemporaryFolder folder;
  check_refused(folder.write("a.gltf", R"({"asset":{"version":"2.0"},"scene":0,"sce)"),
                "corrupt or truncated");
  check_refused(folder.write("b.glb", std::string("glTF\2\0\0\0\xff\xff\0\0{}", 14)),
                "it is truncated: 65535 bytes claimed, 14 there");
  check_refused(folder.write("c.glb", "glTF"), "it is truncated");
}

TEST_CASE("scene: every cut of real files is a model or a one-line error", "[scene][refused][models]") {
  const TemporaryFolder folder;
  const fs::path models = "/usr/share/assimp/models";
  for (const char* name :
       {"OBJ/cube_usemtl.obj", "OFF/Cube.off", "PLY/cube.ply", "PLY/cube_binary.ply", "PLY/Wuson.ply",
        "STL/triangle.stl", "3DS/RotatingCube.3DS", "Collada/cube_triangulate.dae",
        "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb",
        "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf"}) {
    if (!fs::exists(models / name)) continue;
    const TemporaryFolder cuts;
    fs::copy_file(models / name, cuts / "whole");
    const std::string content = cuts.read("whole");
    for (std::size_t part = 1; part < 40; ++part) {
      const fs::path cut = cuts.write("cut" + fs::path(name).extension().string(),
                                      content.substr(0, content.size() * part / 40));
      const Result<Model> model = load_model(cut);
      CAPTURE(name, part);
      CHECK((model.ok() || one_line_naming(model.error().message, "cut")));
    }
  }
}

TEST_CASE("scene: every test file of Assimp is a model or a one-line error", "[scene][refused][models]") {
  const fs::path models = "/usr/share/assimp/models";
  for (const char* name : {"invalid", "OBJ", "OFF", "PLY", "STL", "3DS", "Collada", "glTF", "glTF2"}) {
    if (!fs::exists(models / name)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(models / name)) {
      if (!entry.is_regular_file()) continue;
      CAPTURE(entry.path());
      const Result<Model> model = load_model(entry.path());
      CHECK((model.ok() || one_line_naming(model.error().message, entry.path().filename().string())));
      const bool invalid = std::string(name) == "invalid" && entry.path().filename() != "malformed2.obj";
      if (invalid) CHECK(!model.ok());
      if (model.ok()) CHECK(model->triangle_count() > 0);
    }
  }
}

}  // namespace tuberia
