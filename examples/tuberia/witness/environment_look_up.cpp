#include "examples/tuberia/witness/environment_look_up.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <numbers>

#include "scene/content/environment_picture.hpp"
#include "scene/environment/directions.hpp"

namespace tuberia::witness {
namespace {

using LookUp = description::Environment::LookUp;

/// Half as many texels, rounded down, at least one: which of the larger row a place of the smaller one covers, and how much.
struct Share {
  int texel;
  float weight;
};
std::vector<Share> shares_of(int place, int from, int to) {
  const double step = static_cast<double>(from) / to, begin = place * step, end = begin + step;
  std::vector<Share> shares;
  for (int i = static_cast<int>(begin); i < std::min(from, static_cast<int>(std::ceil(end))); ++i)
    shares.push_back({i, static_cast<float>((std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i))) / step)});
  return shares;
}

Image<Rgba32F> halved(const Image<Rgba32F>& from) {
  Image<Rgba32F> to(std::max(from.width() / 2, 1), std::max(from.height() / 2, 1), Rgba32F{0, 0, 0, 1});
  for (int y = 0; y < to.height(); ++y)
    for (int x = 0; x < to.width(); ++x)
      for (const Share& down : shares_of(y, from.height(), to.height()))
        for (const Share& across : shares_of(x, from.width(), to.width())) {
          const Rgba32F& texel = from.at(across.texel, down.texel);
          const float weight = down.weight * across.weight;
          to.at(x, y).r += weight * texel.r;
          to.at(x, y).g += weight * texel.g;
          to.at(x, y).b += weight * texel.b;
        }
  return to;
}

/// Bilinear, texels beyond a face's edge being its neighbour's. At a cube's corner three texels meet; the fourth is their
/// mean.                                                                                                    [rules T5]
class CubeLevel {
 public:
  explicit CubeLevel(CubeImages faces) : faces_(std::make_shared<const CubeImages>(std::move(faces))), size_((*faces_)[0].width()) {}

  glm::dvec3 operator()(const glm::dvec3& direction) const {
    const CubeFacePoint point = cube_face_point(direction);
    const glm::dvec2 at = point.at * static_cast<double>(size_) - 0.5, first = glm::floor(at), weight = at - first;
    const glm::ivec2 texel(first);
    glm::dvec3 around[2][2];
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) around[j][i] = is_corner(texel + glm::ivec2(i, j)) ? glm::dvec3(0) : texel_at(point.face, texel + glm::ivec2(i, j));
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        if (is_corner(texel + glm::ivec2(i, j))) around[j][i] = (around[1 - j][i] + around[j][1 - i] + around[1 - j][1 - i]) / 3.0;
    return glm::mix(glm::mix(around[0][0], around[0][1], weight.x), glm::mix(around[1][0], around[1][1], weight.x), weight.y);
  }

 private:
  bool is_beyond(int i) const { return i < 0 || i >= size_; }
  bool is_corner(const glm::ivec2& texel) const { return is_beyond(texel.x) && is_beyond(texel.y); }
  glm::dvec3 texel_at(int face, const glm::ivec2& texel) const {
    const CubeFacePoint there = cube_face_point(cube_face_direction({face, (glm::dvec2(texel) + 0.5) / static_cast<double>(size_)}));
    const glm::ivec2 found = glm::clamp(glm::ivec2(there.at * static_cast<double>(size_)), glm::ivec2(0), glm::ivec2(size_ - 1));
    const Rgba32F& colour = (*faces_)[static_cast<std::size_t>(there.face)].at(found.x, found.y);
    return {colour.r, colour.g, colour.b};
  }

  std::shared_ptr<const CubeImages> faces_;
  int size_;
};

double log2_or_least(double x) { return std::log2(std::max(x, 0x1p-126)); }

}  // namespace

void EnvironmentLookUp::add_levels(CubeImages faces) {
  cube_size_ = faces[0].width();
  for (;;) {
    levels_.emplace_back(CubeLevel(faces));
    if (faces[0].width() == 1) return;
    for (Image<Rgba32F>& face : faces) face = halved(face);
  }
}

void EnvironmentLookUp::add_levels(Image<Rgba32F> picture, Surroundings (*as_surroundings)(Image<Rgba32F>)) {
  const double width = picture.width(), height = picture.height();
  texels_per_radian_ = kind_ == LookUp::panorama ? std::max(width, 2 * height) / (2 * std::numbers::pi) : 0.25 * std::max(width, height);
  for (;;) {
    levels_.push_back(as_surroundings(picture).radiance);
    if (picture.width() == 1 && picture.height() == 1) return;
    picture = halved(picture);
  }
}

Result<EnvironmentLookUp> EnvironmentLookUp::create(const SceneDescription& scene, const description::Environment& environment, const Camera& camera) {
  auto picture = environment_picture(scene, environment);
  if (!picture) return picture.error();
  EnvironmentLookUp made;
  made.kind_ = environment.look_up;
  made.map_from_world_ = source_from_world(environment);
  if (made.kind_ == LookUp::cube) {
    auto* faces = std::get_if<CubeImages>(&*picture);
    made.add_levels(faces != nullptr ? std::move(*faces) : cube_of(surroundings_of(*std::move(picture)), environment.resolution));
  } else if (made.kind_ == LookUp::panorama) {
    auto* panorama = std::get_if<Image<Rgba32F>>(&*picture);
    const int height = 2 * environment.resolution;
    made.add_levels(panorama != nullptr ? std::move(*panorama) : panorama_of(surroundings_of(*std::move(picture)), 2 * height, height), panorama_surroundings);
  } else {
    const auto basis = basis_of(camera);
    if (!basis) return basis.error();
    const glm::dmat3 world_from_view(basis->u, basis->v, basis->w);
    const Surroundings seen = turned(surroundings_of(*std::move(picture)), made.map_from_world_ * world_from_view);
    made.add_levels(sphere_map_of(seen, 2 * environment.resolution), sphere_map_surroundings);
    made.map_from_world_ = glm::transpose(world_from_view);
  }
  return made;
}

/// Steps of the direction on the plane of the face that it meets, in texels.
double EnvironmentLookUp::level_of_cube(const glm::dvec3& direction, const BlockDirections& block) const {
  const CubeFacePoint point = cube_face_point(direction);
  const glm::dvec3 middle = cube_face_direction({point.face, {0.5, 0.5}});
  const glm::dvec3 s_axis = cube_face_direction({point.face, {1, 0.5}}) - middle, t_axis = cube_face_direction({point.face, {0.5, 1}}) - middle;
  const double m = glm::dot(direction, middle), s = glm::dot(direction, s_axis) / m, t = glm::dot(direction, t_axis) / m;
  double longest = 0;
  for (const std::size_t i : {1u, 2u}) {
    const glm::dvec3 step = block[i] - block[0];
    const double along = glm::dot(step, middle);
    longest = std::max(longest, std::hypot(glm::dot(step, s_axis) - s * along, glm::dot(step, t_axis) - t * along) / m);
  }
  return log2_or_least(longest * cube_size_ / 2);
}

double EnvironmentLookUp::level_of_angle(const BlockDirections& block) const {
  return log2_or_least(std::max(glm::length(block[1] - block[0]), glm::length(block[2] - block[0])) * texels_per_radian_);
}

glm::dvec3 EnvironmentLookUp::radiance(const glm::dvec3& direction, const BlockDirections& block) const {
  const glm::dvec3 in_map = map_from_world_ * direction;
  const BlockDirections block_in_map{map_from_world_ * block[0], map_from_world_ * block[1], map_from_world_ * block[2]};
  const double wanted = kind_ == LookUp::cube ? level_of_cube(in_map, block_in_map) : level_of_angle(block_in_map);
  const double level = std::clamp(wanted, 0.0, static_cast<double>(levels_.size() - 1)), finer = std::floor(level);
  const glm::dvec3 fine = levels_[static_cast<std::size_t>(finer)](in_map);
  return level == finer ? fine : glm::mix(fine, levels_[static_cast<std::size_t>(finer) + 1](in_map), level - finer);
}

}  // namespace tuberia::witness
