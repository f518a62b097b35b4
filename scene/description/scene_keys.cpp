#include "scene/description/scene_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace tuberia::description {
namespace {

using Names = std::string_view;
constexpr Names kTypeOfLight = "what it is: parallel light from far away, a point, a point with a cone, or a parallelogram";

constexpr std::array<Names, 2> kProjections{"perspective", "orthographic"};
constexpr std::array<Names, 5> kMotions{"pan", "dolly", "zoom", "orbit", "turn"};
constexpr std::array<Names, 3> kOverflows{"clamp", "global-scale", "hue-preserving"};
constexpr std::array<Names, 2> kSamplePatterns{"uniform", "jittered"}, kSampleFilters{"box", "gaussian"};
constexpr std::array<Names, 4> kLights{"directional", "point", "spot", "area"};
constexpr std::array<Names, 3> kFalloffs{"none", "linear", "inverse-square"};
constexpr std::array<Names, 4> kSources{"sky", "panorama", "faces", "rendered"};
constexpr std::array<Names, 3> kLookUps{"cube", "sphere", "panorama"};
constexpr std::array<Names, 6> kFaces{"+x", "-x", "+y", "-y", "+z", "-z"};
constexpr std::array<Names, 4> kShadings{"flat", "gouraud", "dot-product", "phong"};
constexpr std::array<Names, 3> kNormals{"exact", "facet", "averaged"};
constexpr std::array<Names, 4> kTransforms{"translate", "rotate", "scale", "matrix"};

bool is_parallel(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(glm::cross(a, b)) <= 1e-9 * glm::length(a) * glm::length(b);
}

void motion_keys(Keys& keys, CameraMotion& motion) {
  using Kind = CameraMotion::Kind;
  keys.choice({"type", "see docs/conventions.md", true}, motion.kind, kMotions);
  keys.where("type is pan", motion.kind == Kind::pan, [&] {
    keys.number({"right", "world units along the camera's own axis"}, motion.right);
    keys.number({"up", "world units along the camera's own axis"}, motion.up);
  });
  keys.where("type is dolly", motion.kind == Kind::dolly, [&] { keys.number({"distance", "world units towards the point of interest"}, motion.distance); });
  keys.where("type is zoom", motion.kind == Kind::zoom, [&] { keys.number({"factor", "how many times larger things appear"}, motion.factor, above(0)); });
  keys.where("type is orbit", motion.kind == Kind::orbit, [&] {
    keys.number({"right_degrees", "of the eye around the point of interest"}, motion.right_degrees);
    keys.number({"up_degrees", "of the eye around the point of interest"}, motion.up_degrees);
    keys.flag({"inspection", "the other senses, as if the object were turned"}, motion.inspection);
  });
  keys.where("type is turn", motion.kind == Kind::turn, [&] {
    keys.number({"pitch_degrees", "of the head, upwards"}, motion.pitch_degrees);
    keys.number({"yaw_degrees", "of the head, to the left"}, motion.yaw_degrees);
    keys.number({"roll_degrees", "of the head, counter-clockwise"}, motion.roll_degrees);
  });
}

void shadow_keys(Keys& keys, Shadow& shadow) {
  keys.whole({"resolution", "texels of the depth map, each way"}, shadow.resolution, 1, 8192);
  keys.number({"constant_bias", "moves points towards the light before they are compared, world units"}, shadow.constant_bias, at_least(0));
  keys.number({"slope_bias", "the same, in heights that clear the depths of a texel"}, shadow.slope_bias, at_least(0));
  keys.number({"normal_offset", "moves points along their normal, in such heights"}, shadow.normal_offset, at_least(0));
  keys.whole({"taps", "texels each way that are compared, whose mean is taken"}, shadow.taps, 1, 8);
}

void projection_keys(Keys& keys, Projection& projection) {
  keys.name({"texture", "one of `textures`", true}, projection.texture, NameOf::texture);
  keys.vector({"up", "of the picture"}, projection.up);
  keys.number({"fovy_degrees", "of a point or spot: its vertical opening"}, projection.fovy_degrees, inside(0, 180));
  keys.number({"height", "of a directional light: world units"}, projection.height, above(0));
}

void sky_keys(Keys& keys, Sky& sky) {
  keys.vector({"sun_towards", "the direction to the sun"}, sky.sun_towards);
  keys.require("sun_towards", sky.sun_towards != glm::dvec3(0), "is no direction");
  keys.number({"sun_degrees", "its diameter as it is seen"}, sky.sun_degrees, inside(0, 90));
  keys.colour({"sun", "its radiance"}, sky.sun);
  keys.colour({"glow", "around the sun, falling off with the angle"}, sky.glow);
  keys.colour({"zenith", "straight above"}, sky.zenith);
  keys.colour({"horizon", "at the horizon"}, sky.horizon);
  keys.colour({"ground", "below the horizon"}, sky.ground);
  keys.number({"cloudiness", "share of the sky under clouds"}, sky.cloudiness, within(0, 1));
  keys.seed({"seed", "of the clouds"}, sky.seed);
}

void object_keys(Keys& keys, Object& object) {
  keys.text({"name", "for messages"}, object.name);
  keys.object({"shape", "what it is made of", true}, object.shape, shape_keys);
  keys.name({"material", "one of `materials`; none: a grey diffuse one"}, object.material, NameOf::material);
  keys.list({"transforms", "steps that place it in the world, the first one first"}, object.transforms, transform_keys);
  keys.choice({"shading", "how intensities between vertices are found"}, object.shading, kShadings);
  keys.choice({"normals", "those of the curved surface itself, of each triangle, or the mean of the triangles at a vertex"}, object.normals, kNormals);
  keys.where("normals is averaged", object.normals == Normals::averaged, [&] {
    keys.number({"crease_degrees", "triangles that meet at a larger angle keep normals of their own"}, object.crease_degrees, within(0, 180));
  });
  keys.flag({"casts_shadow", "whether lights with shadows see it"}, object.casts_shadow);
  keys.flag({"seen_in_environment", "whether it is part of an environment rendered from the scene"}, object.seen_in_environment);
}

}  // namespace

void picture_keys(Keys& keys, Picture& picture) {
  keys.whole({"width", "pixels"}, picture.width, 1, 16384);
  keys.whole({"height", "pixels"}, picture.height, 1, 16384);
  keys.whole({"supersampling", "samples each way for every pixel, whose mean it is; traced pictures have trace.samples"}, picture.supersampling, 1, 16);
  keys.colour({"background", "where there is nothing else"}, picture.background);
  keys.number({"exposure_stops", "all intensities times 2 to this power"}, picture.exposure_stops, within(-30, 30));
  keys.choice({"overflow", "what becomes of intensities above 1: cut off, the picture divided by its largest, or each pixel by its largest channel"},
              picture.overflow, kOverflows);
}

void tracing_keys(Keys& keys, Tracing& tracing) {
  Sampling& sampling = tracing.sampling;
  keys.whole({"depth", "level of the last rays that are followed; those from the eye are 0"}, tracing.depth, 0, 1000);
  keys.number({"least_weight", "branches whose coefficients multiply to less are not followed"}, tracing.least_weight, within(0, 1));
  keys.whole({"samples", "rays for a pixel, a square number"}, sampling.per_pixel, 1, 1024);
  const int root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(std::max(sampling.per_pixel, 0)))));
  keys.require("samples", root * root == sampling.per_pixel, "is no square number");
  keys.choice({"pattern", "the centres of equal parts of the pixel, or a random point of each"}, sampling.pattern, kSamplePatterns);
  keys.where("pattern is jittered", sampling.pattern == Sampling::Pattern::jittered, [&] { keys.seed({"seed", "of the random points"}, sampling.seed); });
  keys.flag({"adaptive", "so many samples only where the corners of a pixel, or of a part of it, differ"}, sampling.adaptive);
  keys.where("adaptive is true", sampling.adaptive, [&] {
    keys.numbers({"contrast", "(max - min) / (max + min) of red, green and blue above which a part is split"}, {&sampling.contrast.x, 3}, within(0, 1), true);
  });
  keys.choice({"filter", "how samples become a colour: their mean, or weighted by the distance to the pixel's centre"}, sampling.filter, kSampleFilters);
  keys.where("filter is gaussian", sampling.filter == Sampling::Filter::gaussian, [&] {
    keys.number({"filter_radius", "pixels from the centre"}, sampling.filter_radius, {.least = 0, .most = 8, .least_excluded = true});
  });
}

void camera_keys(Keys& keys, Camera& camera) {
  keys.choice({"type", "how it projects"}, camera.kind, kProjections);
  keys.vector({"eye", "where it stands"}, camera.eye);
  keys.vector({"look_at", "the point of interest"}, camera.look_at);
  keys.vector({"up", "the vertical"}, camera.up);
  keys.require("look_at", camera.eye != camera.look_at, "is where the eye stands");
  keys.require("up", camera.eye == camera.look_at || !is_parallel(camera.up, camera.look_at - camera.eye), "is parallel to the line of sight");
  keys.where("type is perspective", camera.kind == Camera::Kind::perspective,
             [&] { keys.number({"fovy_degrees", "the vertical opening"}, camera.fovy_degrees, inside(0, 180)); });
  keys.where("type is orthographic", camera.kind == Camera::Kind::orthographic,
             [&] { keys.number({"height", "what the picture's height shows, world units"}, camera.height, above(0)); });
  keys.number({"near", "distance of the near plane, world units; traced rays start at the eye"}, camera.near_distance, above(0));
  keys.number({"far", "distance of the far plane, world units; traced rays have no end"}, camera.far_distance, above(0));
  keys.require("far", camera.near_distance < camera.far_distance, "is not beyond near");
  keys.list({"motions", "what it does while the time runs from 0 to 1"}, camera.motions, motion_keys);
}

void light_keys(Keys& keys, Light& light) {
  using Kind = Light::Kind;
  keys.choice({"type", kTypeOfLight, true}, light.kind, kLights);
  keys.text({"name", "for messages"}, light.name);
  keys.colour({"intensity", "Ip"}, light.intensity);
  keys.where("type is directional", light.kind == Kind::directional, [&] {
    keys.vector({"towards", "the direction to the light"}, light.towards);
    keys.require("towards", light.towards != glm::dvec3(0), "is no direction");
  });
  keys.where("type is not directional", light.kind != Kind::directional, [&] {
    keys.vector({"position", "where it is; of an area its middle"}, light.position);
    keys.choice({"falloff", "with the distance d: I, I / (d + d0), I / (4 pi d^2)"}, light.falloff, kFalloffs);
    keys.where("falloff is linear", light.falloff == Light::Falloff::linear,
               [&] { keys.number({"falloff_distance", "d0, world units"}, light.falloff_distance, above(0)); });
  });
  keys.where("type is spot", light.kind == Kind::spot, [&] {
    keys.number({"cone_degrees", "from the axis to where its light ends"}, light.cone_degrees, inside(0, 90));
    keys.number({"full_cone_degrees", "from the axis to where its light begins to weaken"}, light.full_cone_degrees, within(0, 90));
    keys.require("full_cone_degrees", light.full_cone_degrees <= light.cone_degrees, "is more than cone_degrees");
  });
  keys.where("type is not area", light.kind != Kind::area, [&] {
    keys.vector({"look_at", "the point that a spot's axis, or a projection's, goes through"}, light.look_at);
    keys.require("look_at", light.kind == Kind::directional || light.look_at != light.position, "is where the light is");
    keys.object({"projection", "a picture that it throws, as a slide projector does"}, light.projection, projection_keys);
  });
  keys.where("type is area", light.kind == Kind::area, [&] {
    keys.vector({"edge_u", "one side of the parallelogram"}, light.edge_u);
    keys.vector({"edge_v", "the other side"}, light.edge_v);
    keys.whole({"samples", "points each way that share its intensity"}, light.samples, 1, 16);
  });
  keys.object({"shadow", "casts shadows, by a map of depths; without this key it casts none"}, light.shadow, shadow_keys);
}

void environment_keys(Keys& keys, Environment& environment) {
  using Source = Environment::Source;
  keys.choice({"source", "a made sky, a panorama's file, six files, or the scene itself", true}, environment.source, kSources);
  keys.where("source is sky", environment.source == Source::sky, [&] { keys.object({"sky", "its colours"}, environment.sky, sky_keys); });
  keys.where("source is panorama", environment.source == Source::panorama,
             [&] { keys.text({"file", ".hdr, .pfm, or 8-bit sRGB codes; beside the scene file", true}, environment.file); });
  keys.where("source is faces", environment.source == Source::faces, [&] {
    keys.object({"faces", "files of the six sides, as cube maps have them: as seen from outside the cube", true}, environment.faces, [](Keys& inner, std::array<std::string, 6>& faces) {
      for (std::size_t i = 0; i < faces.size(); ++i) inner.text({kFaces[i], "file, beside the scene file", true}, faces[i]);
    });
  });
  keys.where("source is rendered", environment.source == Source::rendered,
             [&] { keys.vector({"from", "the point that it is seen from"}, environment.from); });
  keys.whole({"resolution", "texels along an edge of a cube that is made"}, environment.resolution, 1, 4096);
  keys.choice({"look_up", "the kind of map that is looked up; others are converted to it"}, environment.look_up, kLookUps);
  keys.number({"rotation_degrees", "of the surroundings about the vertical, counter-clockwise from above"}, environment.rotation_degrees);
  keys.flag({"shown", "behind the objects, too"}, environment.shown);
}

void transform_keys(Keys& keys, Transform& step) {
  using Kind = Transform::Kind;
  auto kind = static_cast<std::size_t>(step.kind);
  keys.which(kTransforms, kind);
  step.kind = static_cast<Kind>(kind);
  keys.where("", step.kind == Kind::translate, [&] { keys.vector({"translate", "moves by so many world units", true}, step.vector); });
  keys.where("", step.kind == Kind::rotate, [&] {
    keys.number({"rotate", "turns by so many degrees, counter-clockwise seen against the axis", true}, step.degrees);
    keys.vector({"about", "the axis through the origin; with `rotate`", true}, step.vector);
    keys.require("about", step.vector != glm::dvec3(0), "is no direction");
  });
  keys.where("", step.kind == Kind::scale, [&] { keys.factors({"scale", "multiplies the coordinates", true}, step.vector); });
  keys.where("", step.kind == Kind::matrix, [&] {
    std::vector<std::vector<double>> rows(4, std::vector<double>(4));
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = step.matrix[c][r];
    keys.rows({"matrix", "4 rows; the last one is 0, 0, 0, 1", true}, rows, 4, {});
    keys.require("matrix", rows.size() == 4 && rows[3] == std::vector<double>{0, 0, 0, 1}, "is not 4 rows of which the last is 0, 0, 0, 1");
    for (std::size_t r = 0; r < rows.size() && r < 4; ++r)
      for (int c = 0; c < 4; ++c) step.matrix[c][static_cast<int>(r)] = rows[r][static_cast<std::size_t>(c)];
  });
}

void scene_keys(Keys& keys, SceneDescription& scene) {
  keys.text({"title", "what the scene is"}, scene.title);
  keys.text({"caption", "what to see in its picture"}, scene.caption);
  keys.text({"source", "the figure that it shows"}, scene.source);
  keys.object({"image", "the picture"}, scene.picture, picture_keys);
  keys.object({"trace", "how rays make the picture, where they do"}, scene.tracing, tracing_keys);
  keys.object({"camera", "the observer"}, scene.camera, camera_keys);
  keys.colour({"ambient", "Ia, the light from everywhere"}, scene.ambient);
  keys.list({"lights", "what it is lit by"}, scene.lights, light_keys);
  keys.named({"textures", "pictures, by their names"}, scene.textures, texture_keys);
  keys.named({"materials", "surfaces, by their names"}, scene.materials, material_keys);
  keys.object({"environment", "what surrounds it; without this key nothing"}, scene.environment, environment_keys);
  keys.list({"objects", "what there is to see"}, scene.objects, object_keys);
}

}  // namespace tuberia::description
