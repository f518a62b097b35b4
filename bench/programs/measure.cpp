#include "bench/programs/measure.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <numbers>
#include <span>

#include "bench/figures/timing.hpp"
#include "bench/programs/table.hpp"
#include "math/transforms.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::bench {
namespace {

constexpr int kSize = 512;  // pixels, each way

/// A square that is wider than the view and turned about a slanted axis: no two pixels of it have the same
/// depth, no attribute is linear on the screen.
struct Square {
  std::vector<glm::vec3> positions{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  std::vector<glm::vec3> normals{{-0.1f, -0.1f, 1}, {0.1f, -0.1f, 1}, {0.1f, 0.1f, 1}, {-0.1f, 0.1f, 1}};
  std::vector<glm::vec2> texcoords{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  std::vector<glm::vec4> colours{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
  std::vector<glm::vec3> tangents = std::vector<glm::vec3>(4, glm::vec3(3, 0, 0)), bitangents = std::vector<glm::vec3>(4, glm::vec3(0, 3, 0));
  std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};

  MeshView view() const {
    MeshView mesh{.positions = positions, .normals = normals, .texcoords = texcoords, .colours = colours, .indices = indices};
    mesh.tangents = tangents, mesh.bitangents = bitangents;
    return mesh;
  }
};

PipelineState state_of(const TransformState& transform) {
  PipelineState state{.transform = transform};
  state.transform.world_from_object = rotation({1, 0.4, 0}, 0.6);
  state.transform.clip_from_world = compose(*perspective(std::numbers::pi / 3, 1, 0.1, 100, ClipVolume::minus_w_to_w), translation({0, 0, -5}));
  state.depth.test = Compare::always;  // so that the picture need not be cleared
  return state;
}

struct Entry {
  ProgramCost::Kind kind;
  std::string name;
  DrawCall draw;
  std::vector<std::string> parts{};
};

std::vector<Entry> entries(const Square& square) {
  std::vector<Entry> all;
  const auto add = [&](ProgramCost::Kind kind, const std::string& name, const FragmentProgram& program, const TransformState& transform, const std::vector<std::string>& parts) {
    all.push_back({kind, name, {.mesh = square.view(), .program = program, .state = state_of(transform)}, parts});
  };
  for (const NamedProgram& p : named_programs()) add(ProgramCost::Kind::program, p.name, p.program, p.transform, {});
  add(ProgramCost::Kind::base, "surface: lambert", surface(base_surface()), {}, {});
  for (const Technique& t : techniques()) add(ProgramCost::Kind::technique, t.name, surface(surface_with({t.name})), {}, {});
  for (const Combination& c : combinations()) add(ProgramCost::Kind::combination, name_of(c), surface(surface_with(c.techniques)), {}, c.techniques);
  return all;
}

std::vector<RelativeTime> times_of(std::span<const Entry> all, const MeasureOptions& options, Precision precision) {
  const auto pipeline = std::make_shared<Pipeline>(PipelineOptions{.threads = 1, .instruction_set = options.instruction_set, .precision = precision});
  const auto target = std::make_shared<RenderTarget>(*RenderTarget::create(kSize, kSize));
  std::vector<std::function<void()>> ways;
  for (const Entry& entry : all)
    ways.emplace_back([pipeline, target, &entry] {
      if (const auto drawn = pipeline->draw(*target, entry.draw); !drawn) {
        std::fprintf(stderr, "%s: %s\n", entry.name.c_str(), drawn.error().message.c_str());
        std::exit(1);
      }
    });
  return time_in_turns(ways, {.seconds = options.seconds, .fewest_rounds = options.fewest_rounds, .of_processor = true});
}

/// The increment over the base by the sum of the parts' own.
double ratio_of(const Entry& entry, const std::map<std::string, double>& nanoseconds, double base) {
  double sum = 0;
  for (const std::string& part : entry.parts) sum += nanoseconds.at(part) - base;
  return (nanoseconds.at(entry.name) - base) / sum;
}

}  // namespace

std::vector<ProgramCost> measure_programs(const MeasureOptions& options) {
  const Square square;
  const std::vector<Entry> all = entries(square);
  std::vector<ProgramCost> costs;
  for (const Entry& entry : all) costs.push_back({.kind = entry.kind, .name = entry.name});
  for (const Precision precision : {Precision::exact, Precision::fast}) {
    const bool is_exact = precision == Precision::exact;
    const std::vector<RelativeTime> times = times_of(all, options, precision);
    // Ratios of one round know nothing of what the machine did in the others; flat's median gives them a unit.
    const double flat = times.front().median_ms * 1e6 / (kSize * kSize);
    std::map<std::string, double> nanoseconds;
    double base = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double ns = flat * times[i].ratio;
      if (all[i].kind != ProgramCost::Kind::program) nanoseconds[all[i].name] = ns;  // phong is a technique, too
      if (all[i].kind == ProgramCost::Kind::base) base = ns;
      (is_exact ? costs[i].exact : costs[i].fast) = ns;
      if (is_exact) costs[i].exact_low = flat * times[i].lower_quartile, costs[i].exact_high = flat * times[i].upper_quartile;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == ProgramCost::Kind::combination) (is_exact ? costs[i].exact_ratio : costs[i].fast_ratio) = ratio_of(all[i], nanoseconds, base);
  }
  return costs;
}

}  // namespace tuberia::bench
