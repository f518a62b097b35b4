#include "tests/differential/comparison.hpp"

#include <cmath>
#include <sstream>

#include "tests/differential/translation.hpp"

namespace tuberia::differential {
namespace {

RenderTarget target_of(const TargetDescription& t, Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create({.width = t.width, .height = t.height, .colour = static_cast<ColourFormat>(t.colour),
                                               .depth = static_cast<DepthFormat>(t.depth), .stencil = t.has_stencil, .samples = t.samples});
  ClearCommand clear{.colour = Rgba32F{t.clear_colour.r, t.clear_colour.g, t.clear_colour.b, t.clear_colour.a}, .depth = t.clear_depth};
  if (t.has_stencil) clear.stencil = t.clear_stencil;
  const Result<Nothing> cleared = target.clear(clear, pipeline.workers());
  TUBERIA_ASSERT(cleared.ok(), "a clear value was refused");
  return target;
}

oracle::Target oracle_target_of(const TargetDescription& t) {
  oracle::Target target(t.width, t.height, t.samples, t.colour, t.depth);
  target.clear(t.clear_colour, t.clear_depth, t.clear_stencil);
  return target;
}

void clear_both(const oracle::Clear& part, RenderTarget& target, oracle::Target& oracle_target, Pipeline& pipeline) {
  const Result<Nothing> cleared = target.clear(translated(part), pipeline.workers());
  TUBERIA_ASSERT(cleared.ok(), "a partial clear was refused");
  oracle_target.clear(part);
}

/// A sentence for the first disagreement only.
template <class... Parts>
void tell(std::string& first, const Parts&... parts) {
  if (!first.empty()) return;
  std::ostringstream sentence;
  sentence.precision(12);
  (sentence << ... << parts);
  first = sentence.str();
}

void compare_counts(std::size_t number, const DrawStatistics& pipeline, const oracle::Counts& oracle, bool fragments_are_counted,
                    Tally& tally, std::string& first) {
  const auto check = [&](const char* what, std::int64_t a, std::int64_t b) {
    if (a == b) return;
    ++tally.counts;
    tell(first, "draw ", number, ": ", what, ": pipeline ", a, ", oracle ", b);
  };
  check("primitives assembled", pipeline.triangles_in, oracle.primitives_in);
  check("primitives clipped", pipeline.triangles_clipped, oracle.clipped);
  check("primitives after clipping", pipeline.triangles_after_clipping, oracle.after_clipping);
  check("primitives drawn", pipeline.triangles_drawn, oracle.drawn);
  if (!fragments_are_counted) return;
  check("fragments", pipeline.fragments, oracle.fragments);
  if (!oracle.are_certain) return;
  check("fragments shaded", pipeline.fragments_shaded, oracle.fragments_shaded);
  check("samples passed", pipeline.samples_passed, oracle.samples_passed);
}

/// What the pipeline left in one sample of each pixel, or in the resolved pixels.
struct Planes {
  Image<Rgba8> codes;
  Image<Rgba32F> floats;
  Image<std::int32_t> depths;
  Image<std::uint8_t> stencils;
  bool is_float = false;

  std::array<double, 4> colour(int x, int y) const {
    const Rgba8& c = codes.at(x, y);
    const Rgba32F& f = floats.at(x, y);
    if (is_float) return {static_cast<double>(f.r), static_cast<double>(f.g), static_cast<double>(f.b), static_cast<double>(f.a)};
    return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b), static_cast<double>(c.a)};
  }
};

Planes sample_planes(const RenderTarget& target, int sample, bool is_float) {
  return {target.sample_colour_image(sample), target.sample_linear_image(sample), target.sample_depth_codes(sample),
          target.sample_stencil_codes(sample), is_float};
}

Planes resolved_planes(const RenderTarget& target, bool is_float) {
  return {target.colour_image(), target.linear_image(), target.depth_codes(), target.stencil_codes(), is_float};
}

struct Place {
  int x, y, sample;  // -1: the resolved pixel
};
std::ostream& operator<<(std::ostream& out, const Place& place) {
  return out << "pixel (" << place.x << ", " << place.y << ") sample " << place.sample;
}

/// Whether bounds leave more than one code, or more of a float than rounding explains.
bool are_wide(const oracle::Interval& bounds, bool is_float) {
  if (!is_float) return bounds.low != bounds.high;
  return !(bounds.high - bounds.low <= 1e-4 * (1 + std::abs(bounds.low)));
}

void compare_colours(const Place& place, const Planes& pipeline, const oracle::Sample& oracle, const oracle::Sample& cleared,
                     Tally& tally, std::string& first) {
  const std::array<double, 4> colour = pipeline.colour(place.x, place.y);
  for (std::size_t c = 0; c < 4; ++c) {
    const double value = colour[c];
    const oracle::Interval& bounds = oracle.colour[c];
    if (bounds == cleared.colour[c] && value == bounds.low) continue;
    ++tally.drawn_channels;
    if (are_wide(bounds, pipeline.is_float)) ++tally.tied_channels;
    if (!bounds.is_known() || (bounds.low <= value && value <= bounds.high)) continue;
    ++tally.colour;
    tell(first, place, " channel ", c, ": pipeline ", value, ", oracle ", bounds.low, " to ", bounds.high);
  }
}

void compare_sample(const Place& place, const Planes& pipeline, const oracle::Sample& oracle, const oracle::Sample& cleared,
                    Tally& tally, std::string& first) {
  ++tally.samples;
  if (oracle.is_uncertain) {
    ++tally.uncertain_samples;
    return;
  }
  const std::int32_t depth = pipeline.depths.at(place.x, place.y);
  const std::uint8_t stencil = pipeline.stencils.at(place.x, place.y);
  if (depth != oracle.depth) {
    ++tally.depth;
    tell(first, place, ": depth code: pipeline ", depth, ", oracle ", oracle.depth);
  }
  if (stencil != oracle.stencil) {
    ++tally.stencil;
    tell(first, place, ": stencil code: pipeline ", int{stencil}, ", oracle ", int{oracle.stencil});
  }
  compare_colours(place, pipeline, oracle, cleared, tally, first);
}

void compare_targets(const RenderTarget& target, oracle::Target& oracle_target, const oracle::Sample& cleared, Tally& tally, std::string& first) {
  const bool is_float = !oracle::is_8_bit(oracle_target.colour_format);
  // The resolved pixels come last, as one sample more.
  const int planes = target.samples() == 1 ? 1 : target.samples() + 1;
  for (int s = 0; s < planes; ++s) {
    const bool is_resolved = s == target.samples();
    const Planes pipeline = is_resolved ? resolved_planes(target, is_float) : sample_planes(target, s, is_float);
    for (int y = 0; y < target.height(); ++y)
      for (int x = 0; x < target.width(); ++x) {
        const oracle::Sample oracle = is_resolved ? oracle_target.resolved(x, y) : oracle_target.at(x, y, s);
        compare_sample({x, y, is_resolved ? -1 : s}, pipeline, oracle, cleared, tally, first);
      }
  }
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  states += other.states;
  draws += other.draws;
  fragments += other.fragments;
  samples += other.samples;
  drawn_channels += other.drawn_channels;
  tied_channels += other.tied_channels;
  uncertain_samples += other.uncertain_samples;
  colour += other.colour;
  depth += other.depth;
  stencil += other.stencil;
  counts += other.counts;
  refusals += other.refusals;
  return *this;
}

Pipeline& Machines::pipeline(int threads, InstructionSet set) {
  auto& slot = pipelines_[static_cast<std::size_t>(threads) * kInstructionSetCount + static_cast<std::size_t>(set)];
  if (!slot) slot = std::make_unique<Pipeline>(PipelineOptions{.threads = threads, .instruction_set = set});
  return *slot;
}

Tally compare(const Scene& scene, Machines& machines, std::string& first) {
  Tally tally;
  tally.states = 1;
  Pipeline& pipeline = machines.pipeline(scene.threads, scene.instruction_set);
  RenderTarget target = target_of(scene.target, pipeline);
  oracle::Target oracle_target = oracle_target_of(scene.target);
  const oracle::Sample cleared = oracle_target.at(0, 0, 0);
  for (std::size_t i = 0; i < scene.draws.size(); ++i) {
    const oracle::Draw& draw = scene.draws[i];
    ++tally.draws;
    const MeshArrays arrays = arrays_of(draw);
    DrawCall call = translated(draw, arrays);
    call.count_fragments = scene.is_counted;
    const Result<DrawStatistics> drawn = pipeline.draw(target, call);
    if (!drawn) {
      ++tally.refusals;
      tell(first, "draw ", i, " was refused: ", drawn.error().message);
      return tally;
    }
    const oracle::Counts counts = oracle::draw(oracle_target, draw);
    tally.fragments += counts.fragments;
    if (i == 0 && scene.clear) clear_both(*scene.clear, target, oracle_target, pipeline);
    compare_counts(i, *drawn, counts, scene.is_counted, tally, first);
  }
  compare_targets(target, oracle_target, cleared, tally, first);
  return tally;
}

}  // namespace tuberia::differential
