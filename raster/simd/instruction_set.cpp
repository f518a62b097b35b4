#include "raster/instruction_set.hpp"

#include <array>

// Not for its kernels, of which there are none here, but to know which sets the build contains.
#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/instruction_set.cpp"
#include "raster/simd/every_instruction_set.hpp"

#if HWY_ONCE
namespace tuberia {
namespace {

constexpr std::array<InstructionSet, kInstructionSetCount> kAll{InstructionSet::baseline, InstructionSet::avx2,
                                                                InstructionSet::avx3};

bool runs_here(InstructionSet set) {
  const auto runs = static_cast<std::int64_t>(hwy::SupportedTargets()) & static_cast<std::int64_t>(HWY_TARGETS);
  switch (set) {
    case InstructionSet::avx3: return (runs & HWY_AVX3) != 0 && HWY_STATIC_TARGET != HWY_AVX3;
    case InstructionSet::avx2: return (runs & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2;
    case InstructionSet::baseline: break;
  }
  return true;
}

struct Supported {
  std::array<InstructionSet, kInstructionSetCount> sets{};
  std::size_t count = 0;
};

const Supported& supported() {
  static const Supported found = [] {
    Supported s;
    for (const InstructionSet set : kAll)
      if (runs_here(set)) s.sets[s.count++] = set;
    return s;
  }();
  return found;
}

}  // namespace

std::span<const InstructionSet> supported_instruction_sets() { return {supported().sets.data(), supported().count}; }

InstructionSet best_instruction_set() { return supported_instruction_sets().back(); }

bool is_supported(InstructionSet set) noexcept {
  for (const InstructionSet each : supported_instruction_sets())
    if (each == set) return true;
  return false;
}

std::string_view name_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::avx3: return "avx3";
    case InstructionSet::avx2: return "avx2";
    case InstructionSet::baseline: break;
  }
#if HWY_ARCH_X86
  return "sse4";
#elif HWY_ARCH_ARM
  return "neon";
#else
  return "baseline";
#endif
}

std::optional<InstructionSet> instruction_set_named(std::string_view name) noexcept {
  for (const InstructionSet set : kAll)
    if (name_of(set) == name) return set;
  return std::nullopt;
}

std::string_view name_of(Precision precision) noexcept {
  switch (precision) {
    case Precision::exact: break;
    case Precision::fast_reciprocal: return "reciprocal";
    case Precision::fast_inverse_sqrt: return "inverse-sqrt";
    case Precision::fused_multiply_add: return "fused";
    case Precision::fast_power: return "power";
    case Precision::fast: return "fast";
  }
  return "exact";
}

std::optional<Precision> precision_named(std::string_view name) noexcept {
  for (const Precision precision : {Precision::exact, Precision::fast_reciprocal, Precision::fast_inverse_sqrt, Precision::fused_multiply_add,
                                    Precision::fast_power, Precision::fast})
    if (name_of(precision) == name) return precision;
  return std::nullopt;
}

}  // namespace tuberia
#endif
