#include "bench/requirements/scenes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/transforms.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench {
namespace {

constexpr double kDegrees = std::numbers::pi / 180.0;

/// Keeps a mesh with the scene.
const SceneArrays& keep(RequirementScene& scene, const WorkloadMesh& mesh) {
  auto arrays = std::make_unique<SceneArrays>();
  arrays->positions = mesh.positions;
  arrays->normals = mesh.normals;
  arrays->texcoords = mesh.texture_coordinates;
  for (const Rgba8& c : mesh.colours) arrays->colours.push_back(glm::vec4(c.r, c.g, c.b, c.a) / 255.0f);
  arrays->indices = mesh.indices;
  return *scene.arrays.emplace_back(std::move(arrays));
}

MeshView view_of(const SceneArrays& arrays) {
  return {.positions = arrays.positions, .normals = arrays.normals, .texcoords = arrays.texcoords, .colours = arrays.colours, .custom = {},
          .indices = arrays.indices};
}

DrawCall draw_of(const SceneArrays& arrays, FragmentProgram program) {
  DrawCall draw;
  draw.mesh = view_of(arrays);
  draw.program = std::move(program);
  return draw;
}

glm::mat4 perspective_of(const RequirementScene& scene, double near_distance, double far_distance) {
  const double aspect = static_cast<double>(scene.target.width) / scene.target.height;
  return perspective(60 * kDegrees, aspect, near_distance, far_distance, ClipVolume::minus_w_to_w).value();
}

tuberia::Lighting light() {
  tuberia::Lighting lighting{.ambient = {0.15f, 0.14f, 0.13f}, .diffuse = {0.7f, 0.6f, 0.5f}, .specular = glm::vec3(0.4f), .eye = {0, 0, 0}};
  lighting.lights[0].towards = glm::normalize(glm::vec3(0.4f, 0.6f, 0.7f));
  return lighting;
}

std::shared_ptr<const Texture> texture_of(const Image<Rgba8>& image) {
  return std::make_shared<const Texture>(*Texture::create(image, TextureEncoding::srgb));
}

/// Balls at the places of a lattice; a draw each.
void add_balls(RequirementScene& scene, int segments, int columns, int rows, int slices, float distance, const FragmentProgram& program) {
  const SceneArrays& ball = keep(scene, unit_sphere(segments));
  for (int z = 0; z < slices; ++z)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        DrawCall draw = draw_of(ball, program);
        const glm::vec3 place(static_cast<float>(2 * x - columns + 1), static_cast<float>(2 * y - rows + 1), static_cast<float>(2 * z - slices + 1));
        draw.state.transform.world_from_object = translation(glm::dvec3(place * 1.3f) - glm::dvec3(0, 0, distance));
        draw.state.transform.clip_from_world = perspective_of(scene, 0.5, 100);
        draw.state.culling.cull = CullFace::back;
        scene.draws.push_back(std::move(draw));
      }
}

RequirementScene balls() {
  RequirementScene scene{.name = "balls", .caption = "20 balls of 8,192 triangles, all in view, lit at every fragment (Blinn-Phong), culled."};
  add_balls(scene, 64, 5, 4, 1, 9.5f, phong(light()));
  return scene;
}

RequirementScene crowd() {
  RequirementScene scene{.name = "crowd", .caption = "343 balls of 2,048 triangles around the eye, most of them out of its sight; lit at the vertices."};
  add_balls(scene, 32, 7, 7, 7, 0, gouraud());
  for (DrawCall& draw : scene.draws) {
    draw.state.transform.vertex_lighting = light();
    draw.mesh.colours = {};
  }
  return scene;
}

RequirementScene street() {
  RequirementScene scene{.name = "street", .caption = "A city seen from its street: textured, trilinear, lit at the vertices, cut by the near plane."};
  WorkloadMesh mesh = city(64);
  const SceneArrays& arrays = keep(scene, mesh);
  const glm::mat4 turn = compose(rotation({1, 0, 0}, 8 * kDegrees), rotation({0, 1, 0}, 12 * kDegrees));
  for (const bool second : {false, true}) {
    const TexturedUniforms uniforms{.texture = texture_of(noisy_checkerboard(1024, second ? 777 : 0)), .sampler = {}};
    DrawCall draw = draw_of(arrays, textured_gouraud(uniforms));
    const std::span<const std::uint32_t> indices = arrays.indices;
    draw.mesh.indices = second ? indices.subspan(mesh.second_texture_begins) : indices.first(mesh.second_texture_begins);
    draw.mesh.colours = {};
    draw.state.transform.world_from_object = compose(turn, translation({-0.3, -1.7, -60}));
    draw.state.transform.clip_from_world = perspective_of(scene, 0.5, 400);
    draw.state.transform.vertex_lighting = light();
    draw.state.culling.cull = CullFace::back;
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

RequirementScene shadow_map() {
  RequirementScene scene{.name = "shadow map",
                         .caption = "A depth-only pass of 1,048,576 triangles in a map of 2048 x 2048; the mesh has colours, its program reads them.",
                         .target = {.width = 2048, .height = 2048, .stencil = true}};
  scene.draws.push_back(draw_of(keep(scene, jittered_grids(256, 256, 8, LayerOrder::back_to_front)), gouraud()));
  scene.draws.back().state.blend.write = false;
  return scene;
}

RequirementScene layers(const char* name, const char* caption, std::uint8_t alpha) {
  RequirementScene scene{.name = name, .caption = caption};
  scene.draws.push_back(draw_of(keep(scene, filling_quads(16, true, alpha, LayerOrder::back_to_front)), gouraud()));
  scene.draws.back().state.blend.mode = BlendMode::source_over;
  scene.draws.back().state.depth.write = alpha == 255;
  return scene;
}

RequirementScene small_triangles() {
  RequirementScene scene{.name = "small triangles", .caption = "1,036,800 triangles of about 14 pixels in 16 layers, interpolated colours, far ones first."};
  scene.draws.push_back(draw_of(keep(scene, jittered_grids(240, 135, 16, LayerOrder::back_to_front)), gouraud()));
  return scene;
}

RequirementScene many_vertices() {
  RequirementScene scene{.name = "many vertices", .caption = "A far ball of 500,000 triangles on few pixels, lit at the vertices, culled."};
  DrawCall draw = draw_of(keep(scene, unit_sphere(500)), gouraud());
  draw.mesh.colours = {};
  draw.state.transform.world_from_object = translation({0, 0, -18.6});
  draw.state.transform.clip_from_world = perspective_of(scene, 0.1, 100);
  draw.state.transform.vertex_lighting = light();
  draw.state.culling.cull = CullFace::back;
  scene.draws.push_back(std::move(draw));
  return scene;
}

/// Planes with a texture, one behind the other; every second row of squares has no texels if `holes`.
RequirementScene planes(const char* name, const char* caption, bool holes) {
  RequirementScene scene{.name = name, .caption = caption};
  Image<Rgba8> image = noisy_checkerboard(512, 1);
  for (int y = 0; y < 512 && holes; ++y)
    for (int x = 0; x < 512; ++x)
      if ((x / 32 + y / 32) % 2 == 0) image.at(x, y).a = 0;
  const TexturedUniforms uniforms{.texture = texture_of(image), .sampler = {}, .alpha_cutoff = 0.5f};
  DrawCall draw = draw_of(keep(scene, leaning_planes(8, 1280.0f / 720.0f)), textured(uniforms, true));
  draw.state.transform.clip_from_world = perspective_of(scene, 0.1, 100);
  scene.draws.push_back(std::move(draw));
  return scene;
}

RequirementScene silhouette() {
  RequirementScene scene{.name = "one colour", .caption = "200 overlapping balls without colours, unlit: all white, drawn with interpolated colours and blending."};
  add_balls(scene, 32, 8, 5, 5, 16, gouraud());
  for (DrawCall& draw : scene.draws) {
    draw.mesh.colours = {};
    draw.state.blend.mode = BlendMode::source_over;
  }
  return scene;
}

struct Recipe {
  const char* name;
  RequirementScene (*make)();
};
constexpr Recipe kRecipes[] = {
    {"balls", balls},
    {"crowd", crowd},
    {"street", street},
    {"shadow map", shadow_map},
    {"glass", [] { return layers("glass", "16 layers over the whole target, back to front, blended: alpha 1/4.", 64); }},
    {"opaque layers", [] { return layers("opaque layers", "The same 16 layers with blending on, but alpha 1 everywhere.", 255); }},
    {"small triangles", small_triangles},
    {"many vertices", many_vertices},
    {"fence", [] { return planes("fence", "8 textured planes with holes in them, back to front: the program discards.", true); }},
    {"wall", [] { return planes("wall", "The same 8 planes without holes; the program could discard.", false); }},
    {"one colour", silhouette},
};

}  // namespace

std::vector<std::string> requirement_scene_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : kRecipes) names.emplace_back(recipe.name);
  return names;
}

RequirementScene make_requirement_scene(const std::string& name) {
  return std::find_if(std::begin(kRecipes), std::end(kRecipes), [&](const Recipe& recipe) { return recipe.name == name; })->make();
}

}  // namespace tuberia::bench
