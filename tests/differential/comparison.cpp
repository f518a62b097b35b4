#include "tests/differential/comparison.hpp"

#include <cmath>
#include <sstream>

#include "tests/differential/translation.hpp"

namespace tuberia::differential {
namespace {

RenderTarget target_of(const TargetDescription& t, Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(t.width, t.height, static_cast<ColourFormat>(t.colour), static_cast<DepthFormat>(t.depth));
  target.clear_colour({t.clear_colour.r, t.clear_colour.g, t.clear_colour.b, t.clear_colour.a}, pipeline.workers());
  target.clear_depth(t.clear_depth, pipeline.workers());
  return target;
}

oracle::Target oracle_target_of(const TargetDescription& t) {
  oracle::Target target(t.width, t.height, t.samples, t.colour, t.depth);
  target.clear(t.clear_colour, t.clear_depth, t.clear_stencil);
  return target;
}

/// A sentence for the first disagreement only.
template <class... Parts>
void tell(std::string& first, const Parts&... parts) {
  if (!first.empty()) return;
  std::ostringstream sentence;
  sentence.precision(9);
  (sentence << ... << parts);
  first = sentence.str();
}

void compare_counts(std::size_t number, const DrawStatistics& pipeline, const oracle::Counts& oracle, Tally& tally, std::string& first) {
  const auto check = [&](const char* what, std::int64_t a, std::int64_t b) {
    if (a == b) return;
    ++tally.counts;
    tell(first, "draw ", number, ": ", what, ": pipeline ", a, ", oracle ", b);
  };
  check("primitives assembled", pipeline.triangles_in, oracle.primitives_in);
  check("fragments", pipeline.fragments, oracle.fragments);
  if (!oracle.are_certain) return;
  check("fragments shaded", pipeline.fragments_shaded, oracle.fragments_shaded);
  check("samples passed", pipeline.samples_passed, oracle.samples_passed);
}

/// What the pipeline left in one sample.
struct Stored {
  std::array<double, 4> colour;
  std::int32_t depth;
  std::uint8_t stencil;
};

/// Reads the tiles themselves, so that every sample is seen as it is stored.
class TargetReader {
 public:
  explicit TargetReader(RenderTarget& target)
      : colours_(target.colour_image()), linear_(target.linear_image()), depths_(target.depth_codes()),
        is_float_(target.colour_format() == ColourFormat::rgba32f || target.colour_format() == ColourFormat::rgba16f) {}

  Stored at(int x, int y, int /*sample*/) const {
    const Rgba8& c = colours_.at(x, y);
    const Rgba32F& f = linear_.at(x, y);
    Stored stored{{static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b), static_cast<double>(c.a)}, depths_.at(x, y), 0};
    if (is_float_) stored.colour = {static_cast<double>(f.r), static_cast<double>(f.g), static_cast<double>(f.b), static_cast<double>(f.a)};
    return stored;
  }

 private:
  Image<Rgba8> colours_;
  Image<Rgba32F> linear_;
  Image<std::int32_t> depths_;
  bool is_float_;
};

struct Place {
  int x, y, sample;
};
std::ostream& operator<<(std::ostream& out, const Place& place) {
  return out << "pixel (" << place.x << ", " << place.y << ") sample " << place.sample;
}

/// Whether bounds leave more than one code, or more of a float than rounding explains.
bool are_wide(const oracle::Interval& bounds, bool is_float) {
  if (!is_float) return bounds.low != bounds.high;
  return !(bounds.high - bounds.low <= 1e-4 * (1 + std::abs(bounds.low)));
}

void compare_colours(const Place& place, const Stored& pipeline, const oracle::Sample& oracle, const oracle::Sample& cleared,
                     bool is_float, Tally& tally, std::string& first) {
  for (std::size_t c = 0; c < 4; ++c) {
    const double value = pipeline.colour[c];
    const oracle::Interval& bounds = oracle.colour[c];
    if (bounds == cleared.colour[c] && value == bounds.low) continue;
    ++tally.drawn_channels;
    if (are_wide(bounds, is_float)) ++tally.tied_channels;
    if (!bounds.is_known() || (bounds.low <= value && value <= bounds.high)) continue;
    ++tally.colour;
    tell(first, place, " channel ", c, ": pipeline ", value, ", oracle ", bounds.low, " to ", bounds.high);
  }
}

void compare_sample(const Place& place, const Stored& pipeline, const oracle::Sample& oracle, const oracle::Sample& cleared,
                    bool is_float, Tally& tally, std::string& first) {
  ++tally.samples;
  if (oracle.is_uncertain) {
    ++tally.uncertain_samples;
    return;
  }
  if (pipeline.depth != oracle.depth) {
    ++tally.depth;
    tell(first, place, ": depth code: pipeline ", pipeline.depth, ", oracle ", oracle.depth);
  }
  if (pipeline.stencil != oracle.stencil) {
    ++tally.stencil;
    tell(first, place, ": stencil code: pipeline ", int{pipeline.stencil}, ", oracle ", int{oracle.stencil});
  }
  compare_colours(place, pipeline, oracle, cleared, is_float, tally, first);
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
    const Result<DrawStatistics> drawn = pipeline.draw(target, translated(draw, arrays));
    if (!drawn) {
      ++tally.refusals;
      tell(first, "draw ", i, " was refused: ", drawn.error().message);
      return tally;
    }
    const oracle::Counts counts = oracle::draw(oracle_target, draw);
    tally.fragments += counts.fragments;
    compare_counts(i, *drawn, counts, tally, first);
  }
  const TargetReader reader(target);
  const bool is_float = !oracle::is_8_bit(scene.target.colour);
  for (int y = 0; y < scene.target.height; ++y)
    for (int x = 0; x < scene.target.width; ++x)
      for (int s = 0; s < scene.target.samples; ++s)
        compare_sample({x, y, s}, reader.at(x, y, s), oracle_target.at(x, y, s), cleared, is_float, tally, first);
  return tally;
}

}  // namespace tuberia::differential
