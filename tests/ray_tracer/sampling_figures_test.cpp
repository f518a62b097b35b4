// The notes' pictures of traced rays, small.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reference/ray_tracer/trace_scene.hpp"
#include "scene/content/develop.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"
#include "tests/golden/golden.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using description::Sampling;

namespace {

SceneDescription figure_scene(const std::string& name, int width, int height) {
  auto scene = read_scene("examples/scenes/" + name + ".json");
  if (!scene) FAIL(scene.error().message);
  scene->picture.width = width;
  scene->picture.height = height;
  return *std::move(scene);
}

TracedPicture traced_figure(const SceneDescription& scene) {
  Workers workers;
  auto picture = trace_scene(scene, workers);
  if (!picture) FAIL(picture.error().message);
  return *std::move(picture);
}

std::string golden_of_figure(const std::string& name, const SceneDescription& scene) {
  tuberia::test::GoldenFolders folders;
  folders.golden /= "rays";
  return tuberia::test::golden_difference(name, srgb_codes_of(developed(traced_figure(scene).light, scene.picture)), folders, {.codes = 1, .share_of_pixels = 1e-3});
}

/// A scene, its rays and what they meet first.
struct TracedView {
  Workers workers;
  SceneDescription description;
  Result<TracedScene> scene;
  Result<View> view;
  TraceScratch scratch;

  explicit TracedView(const SceneDescription& what)
      : description(what), scene(TracedScene::create(what, workers)),
        view(View::create(*camera_of(what.camera, static_cast<double>(what.picture.width) / what.picture.height), what.picture.width, what.picture.height)) {
    if (!scene) FAIL(scene.error().message);
  }

  Ray eye_ray(int x, int y) const { return view->ray({x + 0.5, y + 0.5}); }
  const description::Object* first_object(const Ray& ray) {
    const Hit hit = RayTracer(*scene).first_hit(ray, scratch);
    return hit ? &description.objects[static_cast<std::size_t>(scene->object_of(hit.item))] : nullptr;
  }
  bool sees_mirror(const Ray& ray) {
    const description::Object* object = first_object(ray);
    return object && object->material == "mirror";
  }
};

double root_mean_square(const Image<Rgba32F>& a, const Image<Rgba32F>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) sum += std::pow(std::min(a.pixels()[i].g, 1.0f) - std::min(b.pixels()[i].g, 1.0f), 2);
  return std::sqrt(sum / static_cast<double>(a.pixels().size()));
}

/// The lower right corner of the mirror on the wall.
SceneDescription crop_of_figure_49() {
  SceneDescription scene = figure_scene("62_two_mirrors", 48, 48);
  scene.camera.look_at = {1.95, 0.8, -3.88};
  scene.camera.fovy_degrees = 5;
  return scene;
}

}  // namespace

TEST_CASE("figure 49: what stands in the scene of two mirrors", "[ray_tracer][sampling][B74]") {
  const SceneDescription scene = figure_scene("62_two_mirrors", 500, 500);
  std::array<int, 5> count{};
  for (const description::Object& object : scene.objects) {
    count[0] += std::holds_alternative<description::Sphere>(object.shape);
    count[1] += std::holds_alternative<description::Cylinder>(object.shape);
    count[2] += std::holds_alternative<description::Polygon>(object.shape);
    count[3] += std::holds_alternative<description::InfinitePlane>(object.shape);
    count[4] += std::holds_alternative<description::Disc>(object.shape);
  }
  CHECK(count == std::array{9, 9, 2, 2, 2});  // one plane more than the notes count: the floor [FIX 21]
  CHECK(scene.lights.size() == 2);
  CHECK(scene.ambient == glm::vec3(0.3f));
  CHECK(scene.tracing.depth == 12);
  CHECK(find_material(scene, "mirror")->mirror == glm::vec3(0.9f));
  CHECK(find_material(scene, "ball")->specular == glm::vec3(0.9f));
}

TEST_CASE("figure 49: images in the mirrors darken by .9 with every reflection", "[ray_tracer][sampling][B74]") {
  TracedView figure(figure_scene("62_two_mirrors", 125, 125));
  const RayTracer tracer(*figure.scene, {.most_level = 12});
  std::array<int, 14> rays{};
  for (int y = 0; y < 125; ++y)
    for (int x = 0; x < 125; ++x) {
      // Both mirrors are upright and face along z: unfold the path by hand. Wood looks its place up as a float.
      Ray last = figure.eye_ray(x, y);
      std::size_t reflections = 0;
      while (reflections < 13 && figure.sees_mirror(last)) {
        const double z = last.direction.z < 0 ? -3.88 : 5;
        last.origin = last.at((z - last.origin.z) / last.direction.z);
        last.direction.z = -last.direction.z;
        last.origin.z += last.direction.z > 0 ? 1e-9 : -1e-9;
        ++reflections;
      }
      ++rays[reflections];
      const glm::dvec3 seen = tracer.radiance(figure.eye_ray(x, y), figure.scratch);
      const glm::dvec3 there = reflections > 12 ? glm::dvec3(0) : tracer.radiance(last, figure.scratch);
      const double share = std::pow(static_cast<double>(0.9f), static_cast<double>(reflections));
      for (int c = 0; c < 3; ++c) REQUIRE(seen[c] == Approx(share * there[c]).epsilon(1e-4));
    }
  for (std::size_t k = 0; k <= 4; ++k) CHECK(rays[k] > 40);
}

TEST_CASE("figure 49: the picture", "[ray_tracer][sampling][golden][B74]") {
  const SceneDescription scene = figure_scene("62_two_mirrors", 125, 125);
  CHECK(golden_of_figure("two_mirrors", scene) == "");

  // A quarter of the rays that 16 everywhere would take, at most half; the bits of one worker are those of three.
  Workers one(1), three(3);
  const auto alone = trace_scene(scene, one), shared = trace_scene(scene, three);
  CHECK(alone->light == shared->light);
  CHECK(alone->counts.eye_rays < 125 * 125 * 16 / 2);
  CHECK(alone->counts.eye_rays == shared->counts.eye_rays);
  CHECK(alone->counts.shadow_rays == shared->counts.shadow_rays);
  CHECK(alone->counts.reflected_rays == shared->counts.reflected_rays);
  CHECK(alone->counts.work == shared->counts.work);
}

TEST_CASE("figure 51: depths change what mirrors show, and nothing else", "[ray_tracer][sampling][golden][B77]") {
  SceneDescription scene = figure_scene("62_two_mirrors", 125, 125);
  scene.tracing.sampling = {};
  TracedView figure(scene);
  std::vector<Image<Rgba32F>> pictures;
  for (scene.tracing.depth = 0; scene.tracing.depth <= 3; ++scene.tracing.depth) {
    CHECK(golden_of_figure("two_mirrors_depth_" + std::to_string(scene.tracing.depth), scene) == "");
    pictures.push_back(traced_figure(scene).light);
  }
  std::array<int, 3> changed{};
  for (int y = 0; y < 125; ++y)
    for (int x = 0; x < 125; ++x) {
      const bool is_mirror = figure.sees_mirror(figure.eye_ray(x, y));
      if (is_mirror) REQUIRE(pictures[0].at(x, y) == Rgba32F{0, 0, 0, 1});
      for (std::size_t depth = 0; depth < 3; ++depth) {
        const bool is_same = pictures[depth].at(x, y) == pictures[depth + 1].at(x, y);
        if (!is_mirror) REQUIRE(is_same);
        changed[depth] += !is_same;
      }
    }
  // Each depth fills the mirrors that the last one left black, which are ever smaller.
  CHECK(changed[0] > changed[1]);
  CHECK(changed[1] > changed[2]);
  CHECK(changed[2] > 40);
}

TEST_CASE("figure 50: the glass ball shows its background upside down", "[ray_tracer][sampling][golden][B75]") {
  SceneDescription scene = figure_scene("63_glass_ball", 150, 100);
  const description::Material& glass = *find_material(scene, "glass");
  CHECK(glass.refractive_index == glm::vec3(1.3f));
  CHECK(glass.transmission == glm::vec3(0.99f));
  CHECK(glass.specular == glm::vec3(0.9f));
  CHECK((scene.tracing.depth == 5 && scene.tracing.sampling.per_pixel == 9 && scene.tracing.sampling.adaptive));
  CHECK(golden_of_figure("glass_ball", scene) == "");

  // Where the red of the post, and the floor, lie: beside the ball and in it.
  scene.tracing.sampling = {};
  TracedView figure(scene);
  const Image<Rgba32F> picture = traced_figure(scene).light;
  struct Where {
    double x = 0, y = 0, count = 0;
    void add(int at_x, int at_y) { x += at_x, y += at_y, ++count; }
  };
  Where ball, post, red, blue, wall;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 150; ++x) {
      const description::Object* object = figure.first_object(figure.eye_ray(x, y));
      const Rgba32F& seen = picture.at(x, y);
      if (object && object->name == "post") post.add(x, y);
      if (!object || object->name != "ball") continue;
      ball.add(x, y);
      if (seen.r > 3 * seen.b) red.add(x, y);
      if (seen.b > 3 * seen.r) blue.add(x, y);
      if (seen.b > 1.15f * seen.r && seen.b < 2 * seen.r) wall.add(x, y);
    }
  REQUIRE((ball.count > 1000 && post.count > 50 && red.count > 10 && blue.count > 10 && wall.count > 100));
  CHECK(post.x / post.count < ball.x / ball.count);
  CHECK(red.x / red.count > ball.x / ball.count + 5);   // the post on the left is seen on the right
  CHECK(blue.x / blue.count < ball.x / ball.count - 5);  // and the block on the left
  CHECK(wall.y / wall.count > ball.y / ball.count + 5);  // the wall below, so the floor above
}

TEST_CASE("figures 52 and 53: more samples err less, uniform or jittered", "[ray_tracer][sampling][golden][B78][B79]") {
  SceneDescription scene = crop_of_figure_49();
  scene.tracing.sampling = {.per_pixel = 256};
  const Image<Rgba32F> truth = traced_figure(scene).light;
  std::array<double, 2> of_one_sample{};
  for (const Sampling::Pattern pattern : {Sampling::Pattern::uniform, Sampling::Pattern::jittered}) {
    const std::string name = pattern == Sampling::Pattern::uniform ? "uniform_" : "jittered_";
    double last = 1;
    for (const int per_pixel : {1, 4, 9}) {
      scene.tracing.sampling = {.pattern = pattern, .per_pixel = per_pixel};
      CHECK(golden_of_figure(name + std::to_string(per_pixel), scene) == "");
      const double error = root_mean_square(traced_figure(scene).light, truth);
      CHECK(error < 0.75 * last);
      last = error;
      if (per_pixel == 1) of_one_sample[static_cast<std::size_t>(pattern)] = error;
    }
  }

  // Noise instead of stairs. Of a pixel covered by the share c, a random point errs by c (1 - c) in the mean of squares, 1/6 over all c;
  // the middle by 1/12. But the mean of many seeds comes closer to the truth, and the middle says the same however often it is asked.
  Image<Rgba32F> mean(48, 48, {0, 0, 0, 1});
  for (std::uint32_t seed = 1; seed <= 16; ++seed) {
    scene.tracing.sampling = {.pattern = Sampling::Pattern::jittered, .seed = seed};
    const Image<Rgba32F> one = traced_figure(scene).light;
    for (std::size_t i = 0; i < mean.pixels().size(); ++i) mean.pixels()[i].g += std::min(one.pixels()[i].g, 1.0f) / 16;
  }
  CHECK(of_one_sample[1] == Approx(std::sqrt(2.0) * of_one_sample[0]).epsilon(0.15));
  CHECK(root_mean_square(mean, truth) < 0.4 * of_one_sample[1]);
}

TEST_CASE("all at once: texture, relief, shadows, mirror and glass in one picture", "[ray_tracer][sampling][golden][A47]") {
  SceneDescription scene = figure_scene("64_all_at_once", 160, 100);
  scene.environment->resolution = 64;
  for (description::Texture& texture : scene.textures) texture.size = 128;
  const auto has = [&](const auto& is_so) { return std::any_of(scene.materials.begin(), scene.materials.end(), is_so); };
  CHECK(has([](const description::Material& m) { return !m.texture.empty(); }));
  CHECK(has([](const description::Material& m) { return m.bump.has_value(); }));
  CHECK(has([](const description::Material& m) { return m.pattern.has_value(); }));
  CHECK(has([](const description::Material& m) { return m.mirror.r > 0.5f; }));
  CHECK(has([](const description::Material& m) { return m.transmission.r > 0.5f; }));
  for (const description::Light& light : scene.lights) CHECK(light.shadow.has_value());
  CHECK(golden_of_figure("all_at_once", scene) == "");

  // Each of them shows: without it, the picture is another one.
  scene.tracing.sampling = {};
  scene.picture.width = 80, scene.picture.height = 50;
  const Image<Rgba32F> whole = traced_figure(scene).light;
  const auto changes = [&](const auto& leave_out) {
    SceneDescription less = scene;
    for (description::Material& material : less.materials) leave_out(material);
    return root_mean_square(traced_figure(less).light, whole) > 1e-3;
  };
  CHECK(changes([](description::Material& m) { m.texture.clear(); }));
  CHECK(changes([](description::Material& m) { m.bump.reset(); }));
  CHECK(changes([](description::Material& m) { m.pattern.reset(); }));
  CHECK(changes([](description::Material& m) { m.mirror = glm::vec3(0); }));
  CHECK(changes([](description::Material& m) { m.transmission = glm::vec3(0); }));
  SceneDescription lit = scene;
  for (description::Light& light : lit.lights) light.shadow.reset();
  CHECK(root_mean_square(traced_figure(lit).light, whole) > 1e-2);
}
