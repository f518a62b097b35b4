#include "examples/tuberia/stage_report.hpp"

#include <algorithm>

namespace tuberia::cli {
namespace {

constexpr int kWindowWidth = 72, kWindowHeight = 48;  // pixels; more is not readable anyway

struct PrimitivePlace {
  int draw = 0;
  std::int64_t primitive = 0;
};

std::vector<std::int64_t> first_primitives(const std::vector<DrawCall>& draws) {
  std::vector<std::int64_t> first{0};
  for (const DrawCall& draw : draws)
    first.push_back(first.back() + primitive_count(draw.state.assembly.topology, static_cast<std::int64_t>(draw.mesh.element_count())));
  return first;
}

std::string mesh_name(const DrawCall& draw, const Model& model) {
  for (const Mesh& mesh : model.meshes)
    if (mesh.positions.data() == draw.mesh.positions.data()) return mesh.name;
  return {};
}

Result<Nothing> check(const StageRequest& request, const StageReport& report) {
  const int draws = static_cast<int>(report.frame.draws.size());
  if (request.draw && (*request.draw < 0 || *request.draw >= draws))
    return Error{"--draw " + std::to_string(*request.draw) + ": the frame has draws 0 to " + std::to_string(draws - 1)};
  if (report.first_primitive.back() == 0) return Error{"the model has nothing to draw"};
  if (request.draw || request.primitive) {
    const auto at = static_cast<std::size_t>(request.draw.value_or(0));
    const std::int64_t count = request.draw ? report.first_primitive[at + 1] - report.first_primitive[at] : report.first_primitive.back();
    if (count == 0) return Error{"--draw " + std::to_string(*request.draw) + " has no primitives"};
    if (request.primitive && (*request.primitive < 0 || *request.primitive >= count))
      return Error{"--primitive " + std::to_string(*request.primitive) + ": the " + (request.draw ? "draw" : "frame") + " has primitives 0 to " +
                   std::to_string(count - 1)};
  }
  const RenderTarget& target = report.frame.target;
  if (request.pixel && (request.pixel->x < 0 || request.pixel->y < 0 || request.pixel->x >= target.width() || request.pixel->y >= target.height()))
    return Error{"--pixel " + std::to_string(request.pixel->x) + "," + std::to_string(request.pixel->y) + " lies outside the target of " +
                 std::to_string(target.width()) + "x" + std::to_string(target.height()) + " pixels"};
  return Nothing{};
}

/// The primitive that is seen at the pixel, or nearest to it; none if nothing is seen.
std::optional<PrimitivePlace> primitive_near(const Image<Owner>& owner, const PixelPlace& place, std::optional<int> draw) {
  std::optional<PrimitivePlace> found;
  std::int64_t nearest = -1;
  for (int y = 0; y < owner.height(); ++y)
    for (int x = 0; x < owner.width(); ++x) {
      const Owner& here = owner.at(x, y);
      if (here.draw < 0 || (draw && here.draw != *draw)) continue;
      const std::int64_t dx = x - place.x, dy = y - place.y, distance = dx * dx + dy * dy;
      if (nearest >= 0 && distance >= nearest) continue;
      nearest = distance;
      found = PrimitivePlace{here.draw, here.primitive};
    }
  return found;
}

PrimitivePlace chosen_primitive(const StageRequest& request, const StageReport& report) {
  if (!request.primitive) {
    const PixelPlace middle{report.frame.target.width() / 2, report.frame.target.height() / 2};
    if (const auto seen = primitive_near(report.maps.owner, request.pixel.value_or(middle), request.draw)) return *seen;
  }
  const std::int64_t number = request.primitive.value_or(0);
  if (request.draw) return {*request.draw, number};
  const auto& first = report.first_primitive;
  const auto next = std::upper_bound(first.begin(), first.end(), number);
  const auto draw = static_cast<std::size_t>(next - first.begin()) - 1;
  return {static_cast<int>(draw), number - first[draw]};
}

/// Where to look at a primitive: all of it, or if that is too much, the pixel that was asked for,
/// one of its corners on the target, or its middle.
PixelRect window_of(const PrimitiveLife& life, const std::optional<PixelPlace>& pixel, const RenderTarget& target) {
  const PixelRect& all = life.covered;
  if (all.right - all.left <= kWindowWidth && all.bottom - all.top <= kWindowHeight) return all;
  PixelPlace middle{(all.left + all.right) / 2, (all.top + all.bottom) / 2};
  for (const PrimitiveCorner& corner : life.corners) {
    const int x = corner.x_units >> 8, y = corner.y_units >> 8;
    if (x >= 0 && y >= 0 && x < target.width() && y < target.height()) middle = {x, y};
  }
  if (pixel && pixel->x >= all.left && pixel->x < all.right && pixel->y >= all.top && pixel->y < all.bottom) middle = *pixel;
  const int left = middle.x - kWindowWidth / 2, top = middle.y - kWindowHeight / 2;
  return intersection({left, top, left + kWindowWidth, top + kWindowHeight}, target.bounds());
}

/// Draws the frame with the primitive's draw watched.
Result<PrimitiveLife> life_of(StageReport& report, const PixelRect& window, Pipeline& pipeline) {
  PrimitiveRecorder recorder(static_cast<std::uint32_t>(report.primitive), window);
  clear(report.frame, pipeline);
  for (std::size_t i = 0; i < report.frame.draws.size(); ++i) {
    const DrawCall& call = report.frame.draws[i];
    const auto drawn = static_cast<int>(i) == report.draw ? pipeline.draw(report.frame.target, call, recorder) : pipeline.draw(report.frame.target, call);
    if (!drawn) return drawn.error();
  }
  return recorder.life();
}

}  // namespace

Result<StageReport> stage_report(const Model& model, const RenderOptions& options, const StageRequest& request, Pipeline& pipeline) {
  auto frame = prepare(model, options);
  if (!frame) return frame.error();
  StageReport report{.frame = *std::move(frame), .caption = {}, .mesh_of_draw = {}, .first_primitive = {}, .statistics = {},
                     .maps = FrameMaps(options.width_pixels, options.height_pixels), .life = {}, .window = {}, .pixel = {}};
  for (const DrawCall& draw : report.frame.draws) report.mesh_of_draw.push_back(mesh_name(draw, model));
  report.first_primitive = first_primitives(report.frame.draws);
  if (const auto checked = check(request, report); !checked) return checked.error();

  // Once for the whole frame and the pixel, then for the primitive: where it is, and what is there.
  clear(report.frame, pipeline);
  const PixelPlace place = request.pixel.value_or(PixelPlace{});
  PixelRecorder pixel(report.frame.target, place.x, place.y);
  Observers watching({&report.maps, &pixel});
  const auto drawn = draw(report.frame, pipeline, &watching);
  if (!drawn) return drawn.error();
  report.statistics = *drawn;
  if (request.pixel) report.pixel = pixel.history();

  const PrimitivePlace chosen = chosen_primitive(request, report);
  report.chosen = request.primitive.has_value();
  report.draw = chosen.draw;
  report.primitive = chosen.primitive;
  const auto whole = life_of(report, {}, pipeline);
  if (!whole) return whole.error();
  report.window = window_of(*whole, request.pixel, report.frame.target);
  auto life = life_of(report, report.window, pipeline);
  if (!life) return life.error();
  report.life = *std::move(life);
  return report;
}

}  // namespace tuberia::cli
