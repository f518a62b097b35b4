// Traced scenes: what they are made of, and what they are refused for.

#include <cmath>
#include <glm/mat4x4.hpp>

#include "image/write_image.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"

namespace tuberia::tracer::traced_test {
namespace {

using description::Material;
using description::Object;

SceneDescription scene_of_balls() {
  return described(R"({"lights": [{"type": "spot", "name": "lamp"}], "textures": {"t": {"source": "checker"}},
    "materials": {"red": {"diffuse": [1, 0, 0]}, "glass": {"model": "weighted-phong", "transmission": 0.9, "refractive_index": [1.2, 1.3, 1.4], "shadow_density": 2}},
    "objects": [{"name": "one", "shape": {"type": "sphere"}, "material": "red"},
                {"name": "two", "shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [4, 0, 0]}]}]})");
}

description::TriangleMesh triangle_of(std::vector<glm::dvec3> positions, std::vector<std::uint32_t> indices) {
  description::TriangleMesh mesh;
  mesh.positions = std::move(positions);
  mesh.indices = std::move(indices);
  return mesh;
}

void check_refused_scene(const std::string& words, void (*spoil)(SceneDescription&)) {
  SceneDescription scene = scene_of_balls();
  CHECK(refusal_of_traced(scene).empty());
  spoil(scene);
  const std::string message = refusal_of_traced(scene);
  CAPTURE(words, message);
  CHECK(one_line_naming(message, words));
}

}  // namespace

TEST_CASE("traced scene: items know their objects and materials", "[ray_tracer][traced_scene]") {
  const TracedScene scene = traced(scene_of_balls());
  REQUIRE(scene.geometry().count() == 2);
  CHECK_FALSE(scene.has_only_opaque_casters());
  const TracedMeeting red = met(scene, {0, 0, 5}, {0, 0, 0}), glass = met(scene, {4, 0, 5}, {4, 0, 0});
  CHECK(scene.object_of(red.hit.item) == 0);
  CHECK(scene.object_of(glass.hit.item) == 1);
  CHECK_FALSE(scene.lets_light_through(red.hit.item));
  CHECK(scene.lets_light_through(glass.hit.item));
  const PointMaterial opaque = scene.material(red.hit.item, red.at), clear = scene.material(glass.hit.item, glass.at);
  CHECK(opaque.reflection.diffuse == glm::vec3(1, 0, 0));
  CHECK(opaque.transmitted == glm::dvec3(0));
  CHECK_FALSE(opaque.two_sided);
  CHECK(largest_difference(clear.transmitted, glm::dvec3(0.9)) < 1e-7);
  CHECK(clear.refractive_index == Approx(1.3).epsilon(1e-6));
  CHECK(clear.shadow_density == 2);
  CHECK(clear.two_sided);
  CHECK(clear.alpha == 1);
}

TEST_CASE("traced scene: what stands in the way of light is told", "[ray_tracer][traced_scene]") {
  SceneDescription scene = scene_of_balls();
  scene.objects[1].material = "red";
  CHECK(traced(scene).has_only_opaque_casters());
  scene.objects[0].casts_shadow = false;
  const TracedScene made = traced(scene);
  CHECK_FALSE(made.has_only_opaque_casters());
  CHECK_FALSE(made.casts_shadow(0));
  CHECK(made.casts_shadow(1));
  scene.objects[0].casts_shadow = true;
  scene.materials[0].alpha = 0.5;
  CHECK_FALSE(traced(scene).has_only_opaque_casters());
  CHECK(traced(scene).lets_light_through(0));
}

TEST_CASE("traced scene: triangles for all are those of the mesh", "[ray_tracer][traced_scene]") {
  const TracedScene triangles = traced(R"({"objects": [{"shape": {"type": "cube", "segments": 2}}, {"shape": {"type": "infinite-plane"}}]})", SurfaceKind::tessellated);
  CHECK(triangles.geometry().count() == 6 * 4 * 2 + 1);  // and the plane, which has none
  for (std::int64_t item = 0; item < 48; ++item) CHECK(triangles.geometry().triangle(item).has_value());
  const TracedScene exact = traced(R"({"objects": [{"shape": {"type": "cube", "segments": 2}}, {"shape": {"type": "teapot", "segments": 2}}]})");
  CHECK(exact.geometry().count() > 100);  // a teapot is triangles in any case
  CHECK_FALSE(exact.geometry().triangle(0).has_value());
}

TEST_CASE("traced scene: each kind of shape is what it says, exactly and as triangles", "[ray_tracer][traced_scene]") {
  // A ray that meets it, where it does, and the normal there.
  struct Kind {
    std::string shape;
    glm::dvec3 from, to, wanted, normal;
    bool is_exact = true, has_mesh = true;
  };
  const double slanted = 1 / std::sqrt(5.0);  // of a cone that rises by 2 on a radius of 1
  const std::vector<Kind> kinds{
      {R"("type": "plane", "width": 2, "depth": 4)", {0.5, 2, 1.5}, {0.5, 0, 1.5}, {0.5, 0, 1.5}, {0, 1, 0}},
      {R"("type": "cube", "size": [1, 2, 3])", {5, 0.5, 0.5}, {0, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0}},
      {R"("type": "sphere", "radius": 2)", {0, 0, 9}, {0, 0, 0}, {0, 0, 2}, {0, 0, 1}},
      {R"("type": "cylinder", "radius": 2, "height": 1)", {0, 0.25, 9}, {0, 0.25, 0}, {0, 0.25, 2}, {0, 0, 1}},
      {R"("type": "cone", "radius": 1, "height": 2)", {0, 0, 9}, {0, 0, 0}, {0, 0, 0.5}, {0, slanted, 2 * slanted}},
      {R"("type": "torus", "ring_radius": 2, "tube_radius": 0.5)", {0, 5, 2}, {0, 0, 2}, {0, 0.5, 2}, {0, 1, 0}},
      {R"("type": "disc", "radius": 2)", {1, 3, 1}, {1, 0, 1}, {1, 0, 1}, {0, 1, 0}},
      {R"("type": "mesh", "positions": [[0,0,0],[2,0,0],[0,0,-2]], "triangles": [[0,1,2]])", {0.5, 3, -0.5}, {0.5, 0, -0.5}, {0.5, 0, -0.5}, {0, 1, 0}, false},
      {R"("type": "height-field", "heights": [[2, 2], [2, 2]])", {0.3, 5, 0.2}, {0.3, 0, 0.2}, {0.3, 2, 0.2}, {0, 1, 0}, false},
      {R"("type": "infinite-plane")", {1e4, 1, 0}, {1e4, 0, 0}, {1e4, 0, 0}, {0, 1, 0}, true, false},
      {R"("type": "polygon", "outline": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]])", {3, 1, 2}, {3, 1, 0}, {3, 1, 0}, {0, 0, 1}},
      {R"("type": "polygon", "outline": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "holes": [{"points": [[1,1,0],[2,1,0],[2,2,0]]}])", {3, 1, 2}, {3, 1, 0}, {3, 1, 0}, {0, 0, 1}, true, false},
      {R"("type": "polyhedron", "planes": [[1,0,0,-1],[-1,0,0,-1],[0,1,0,-2],[0,-1,0,-2],[0,0,1,-3],[0,0,-1,-3]])", {0.5, 9, 0.5}, {0.5, 0, 0.5}, {0.5, 2, 0.5}, {0, 1, 0}, true, false},
      {R"("type": "quadric", "q": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-4]], "lower": [-2,-2,-2], "upper": [2,2,2])", {9, 0, 0}, {0, 0, 0}, {2, 0, 0}, {1, 0, 0}, true, false}};
  for (const SurfaceKind surfaces : {SurfaceKind::exact, SurfaceKind::tessellated})
    for (const Kind& kind : kinds) {
      CAPTURE(kind.shape);
      const TracedScene scene = traced(std::string(R"({"objects": [{"shape": {)").append(kind.shape).append(R"(}, "transforms": [{"translate": [1, 0, 0]}]}]})"), surfaces);
      const glm::dvec3 moved(1, 0, 0);
      const TracedMeeting meeting = met(scene, kind.from + moved, kind.to + moved);
      const bool is_exact = surfaces == SurfaceKind::exact ? kind.is_exact : !kind.has_mesh;
      CHECK(scene.geometry().triangle(meeting.hit.item).has_value() == !is_exact);
      CHECK(largest_difference(meeting.at.position - moved, kind.wanted) < (is_exact ? 1e-12 : 0.01));
      CHECK(largest_difference(meeting.at.normal, kind.normal) < (is_exact ? 1e-12 : 0.05));
    }
}

TEST_CASE("traced scene: polygons that are drawn have the coordinates of those that are traced", "[A44][ray_tracer][traced_scene]") {
  const std::string leaning = R"({"objects": [{"shape": {"type": "polygon", "outline": [[0,0,0],[4,0,1],[5,3,2],[1,2,0.75]]}}]})";
  const std::string lying = R"({"objects": [{"shape": {"type": "polygon", "outline": [[0,0,0],[0,1,2],[3,1,2],[3,0,0]]}}]})";
  const std::string aside = R"({"objects": [{"shape": {"type": "polygon", "outline": [[0,0,0],[0,3,0],[-1,3,2],[-1,0,2]]}}]})";
  for (const std::string& text : {leaning, lying, aside}) {
    const TracedScene exact = traced(text), drawn = traced(text, SurfaceKind::tessellated);
    REQUIRE(exact.geometry().count() == 1);
    REQUIRE(drawn.geometry().count() == 2);
    const auto corners = std::get<description::Polygon>(exact.description().objects[0].shape).outline;
    const glm::dvec3 middle = 0.4 * corners[0] + 0.3 * corners[1] + 0.2 * corners[2] + 0.1 * corners[3];
    const glm::dvec3 front = middle + glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0]));
    const TracedMeeting one = met(exact, front, middle), other = met(drawn, front, middle);
    CHECK(largest_difference(one.at.normal, other.at.normal) < 1e-6);
    CHECK(largest_difference(one.at.tangent, other.at.tangent) < 1e-5);
    CHECK(largest_difference(one.at.bitangent, other.at.bitangent) < 1e-5);
    CHECK(glm::length(one.at.texcoord - other.at.texcoord) < 1e-6);
  }
}

TEST_CASE("traced scene: leaves of model files have holes where their picture says so", "[ray_tracer][traced_scene]") {
  const TemporaryFolder folder;
  Image<Rgba8> picture(8, 8, {255, 0, 0, 255});  // whole on the left, gone on the right
  for (int y = 0; y < 8; ++y)
    for (int x = 4; x < 8; ++x) picture.at(x, y).a = 0;
  const auto file = write_leaf(folder, picture, R"({"alphaMode": "MASK", "alphaCutoff": 0.5, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}})");
  const TracedScene scene = traced(scene_of_model(file));
  CHECK(scene.lets_light_through(0));
  const PointMaterial leaf = material_met(scene, {0.2, 0.1, 1}, {0.2, 0.1, 0}), hole = material_met(scene, {0.7, 0.1, 1}, {0.7, 0.1, 0});
  CHECK_FALSE(leaf.is_cut_out);
  CHECK(leaf.alpha == 1);
  CHECK(largest_difference(leaf.reflection.diffuse, {1, 0, 0}) < 1e-6);
  CHECK(hole.is_cut_out);
  // Halfway between both halves' texels alpha is 1/2.
  CHECK_FALSE(material_met(scene, {0.499, 0.1, 1}, {0.499, 0.1, 0}).is_cut_out);
  CHECK(material_met(scene, {0.501, 0.1, 1}, {0.501, 0.1, 0}).is_cut_out);
}

TEST_CASE("traced scene: pictures of model files are theirs, alpha and all", "[ray_tracer][traced_scene]") {
  const TemporaryFolder folder;
  const auto file = write_leaf(folder, Image<Rgba8>(2, 2, {255, 255, 255, 102}), R"({"alphaMode": "BLEND", "pbrMetallicRoughness":
    {"baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 0.25, 1, 0.5], "metallicFactor": 0}})");
  const PointMaterial pane = material_met(traced(scene_of_model(file)), {0.2, 0.2, 1}, {0.2, 0.2, 0});
  CHECK(largest_difference(pane.reflection.diffuse, {0.5, 0.25, 1}) < 1e-6);
  CHECK(pane.alpha == Approx(0.5 * 0.4).epsilon(1e-6));
  CHECK_FALSE(pane.is_cut_out);
}

TEST_CASE("traced scene: files that are not there are refused with their names", "[ray_tracer][traced_scene][refused]") {
  const auto check = [](const std::string& text, const std::string& words) { CHECK(one_line_naming(refusal_of_traced(described(text)), words)); };
  check(R"({"textures": {"wall": {"file": "no such wall.png"}}, "materials": {"m": {"texture": "wall"}}, "objects": [{"shape": {"type": "cube"}, "material": "m"}]})", "texture 'wall': ");
  check(R"({"objects": [{"name": "duck", "shape": {"type": "model", "file": "no such model.obj"}}]})", "object 0 'duck': ");
  check(R"({"environment": {"source": "panorama", "file": "no such hall.hdr"}})", "environment: ");
  check(R"({"textures": {"t": {"source": "checker"}}, "lights": [{"type": "spot", "name": "slides", "position": [0, 5, 0], "projection": {"texture": "t"}}]})",
        "light 0 'slides': its projection: ");
  check(R"({"objects": [{"name": "slab", "shape": {"type": "polyhedron", "planes": [[0,1,0,-1],[0,-1,0,-1]]}}]})", "object 0 'slab': ");
  check(R"({"objects": [{"name": "kite", "shape": {"type": "polygon", "outline": [[0,0,0],[1,0,0],[2,0,0]]}}]})", "object 0 'kite': ");
  check(R"({"objects": [{"name": "kite", "shape": {"type": "polygon", "outline": [[0,0,0],[1,0,0],[1,1,0],[0,1,1]]}}]})", "object 0 'kite': ");
  check(R"({"materials": {"m": {"pattern": {"type": "checker"}}}, "objects": [{"name": "leaf", "material": "m",
    "shape": {"type": "mesh", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}}]})", "object 0 'leaf': ");
  check(R"({"materials": {"m": {"bump": {"type": "waves"}}}, "objects": [{"name": "leaf", "material": "m",
    "shape": {"type": "mesh", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}}]})", "object 0 'leaf': ");
}

TEST_CASE("traced scene: constants that were set out of range are refused by name", "[ray_tracer][traced_scene][refused]") {
  check_refused_scene("materials.glass.refractive_index[1] is -1.5, but must be from 0.001 to 1000", [](SceneDescription& s) { s.materials[1].refractive_index.y = -1.5f; });
  check_refused_scene("materials.glass.refractive_index[2] is 1e+20", [](SceneDescription& s) { s.materials[1].refractive_index.z = 1e20f; });
  check_refused_scene("materials.glass.transmission[0] is nan", [](SceneDescription& s) { s.materials[1].transmission.x = std::nanf(""); });
  check_refused_scene("materials.red.diffuse[0] is inf, which is too large", [](SceneDescription& s) { s.materials[0].diffuse.x = INFINITY; });
  check_refused_scene("materials.red.exponent is -1, but must be 0 or more", [](SceneDescription& s) { s.materials[0].exponent = -1; });
  check_refused_scene("objects[0].shape.radius is 0, but must be more than 0", [](SceneDescription& s) { std::get<description::Sphere>(s.objects[0].shape).radius = 0; });
  check_refused_scene("objects[1].transforms[0].translate[2] is nan", [](SceneDescription& s) { s.objects[1].transforms[0].vector.z = NAN; });
  check_refused_scene("objects[1].material is 'blue'", [](SceneDescription& s) { s.objects[1].material = std::string("blue"); });
  check_refused_scene("materials.red.texture is 'wall'", [](SceneDescription& s) { s.materials[0].texture = std::string("wall"); });
  check_refused_scene("lights[0].look_at is where the light is", [](SceneDescription& s) { s.lights[0].look_at = s.lights[0].position; });
  check_refused_scene("lights[0].intensity[0] is -1", [](SceneDescription& s) { s.lights[0].intensity.x = -1; });
  check_refused_scene("camera.up is parallel", [](SceneDescription& s) { s.camera.up = {0, 0, 1}; });
  check_refused_scene("camera.fovy_degrees is 180", [](SceneDescription& s) { s.camera.fovy_degrees = 180; });
  check_refused_scene("image.width is 0", [](SceneDescription& s) { s.picture.width = 0; });
  check_refused_scene("ambient[2] is nan", [](SceneDescription& s) { s.ambient.z = std::nanf(""); });
  check_refused_scene("trace.depth is 1001", [](SceneDescription& s) { s.tracing.depth = 1001; });
  check_refused_scene("trace.samples is no square number", [](SceneDescription& s) { s.tracing.sampling.per_pixel = 3; });
  check_refused_scene("objects[0].shape.positions[1][0] is nan", [](SceneDescription& s) {
    s.objects[0].shape = triangle_of({{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}, {0, 1, 2});
  });
  check_refused_scene("objects[0].shape.triangles has the index 7", [](SceneDescription& s) {
    s.objects[0].shape = triangle_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 7});
  });
}

TEST_CASE("traced scene: what has no extent is no error, and met by nothing", "[ray_tracer][traced_scene][bad]") {
  // A ball flattened to nothing; triangles without an area; a scene of nothing at all; an eye inside of a ball.
  SceneDescription scene = scene_of_balls();
  scene.objects[0].transforms = {{.kind = description::Transform::Kind::scale, .vector = {1, 0, 1}}};
  Object needle;
  needle.shape = triangle_of({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {0, 1, 2});
  scene.objects.push_back(needle);
  const TracedScene made = traced(scene);
  Traversal traversal;
  CHECK_FALSE(made.accelerator().nearest({.origin = {0, 0.1, 5}, .direction = {0, 0, -1}}, traversal));
  CHECK(met(made, {4, 0, 0}, {4, 0, -1}).at.position.z == Approx(-1));
  CHECK_FALSE(traced("{}").accelerator().nearest({}, traversal));
}

TEST_CASE("traced scene: every accelerator finds the same", "[ray_tracer][traced_scene]") {
  const SceneDescription scene = described(R"({"objects": [{"shape": {"type": "teapot", "segments": 3}}, {"shape": {"type": "infinite-plane"}},
    {"shape": {"type": "sphere"}, "transforms": [{"translate": [0, 3, 0]}]}]})");
  const TracedScene reference = traced(scene, {.accelerator = AcceleratorKind::none});
  const TracedScene fast = traced(scene, {.accelerator = AcceleratorKind::bvh});
  test::Random random(7);
  Traversal traversal;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 from(number_between(random, -5, 5), number_between(random, 0.1, 5), 6), to(number_between(random, -3, 3), number_between(random, 0, 3), 0);
    const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
    CHECK(fast.accelerator().nearest(ray, traversal) == reference.accelerator().nearest(ray, traversal));
  }
}

}  // namespace tuberia::tracer::traced_test
