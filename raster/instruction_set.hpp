#pragma once
// Which machine instructions draw, chosen at run time; and how exactly they must do it.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tuberia {

/// What the kernels are compiled for: one set of names for all processors, narrowest first.
/// `baseline` is what every file of the build assumes (SSE4 on x86, NEON on Arm).
enum class InstructionSet { baseline, avx2, avx3 };
inline constexpr int kInstructionSetCount = 3;

/// exact: the same bits from every instruction set, compiler and thread count.
/// fast: may fuse and approximate; each operation states its largest error. The others are one
/// ingredient of fast alone, to measure what it brings; only some programs have them.
enum class Precision : std::uint8_t {
  exact = 0,
  fast_reciprocal = 1,       // 1/x by an estimate and a Newton step
  fast_inverse_sqrt = 2,     // 1/sqrt(x) likewise
  fused_multiply_add = 4,    // a b + c with one rounding, where the machine can
  fast_power = 8,            // log2, exp2 and pow, made of the first and the third
  fast = 15,
};

constexpr bool contains(Precision precision, Precision ingredient) noexcept {
  return (static_cast<int>(precision) & static_cast<int>(ingredient)) == static_cast<int>(ingredient);
}

/// Neither exact nor fast but one ingredient of it.
constexpr bool is_one_ingredient(Precision precision) noexcept {
  return precision == Precision::fast_reciprocal || precision == Precision::fast_inverse_sqrt || precision == Precision::fused_multiply_add ||
         precision == Precision::fast_power;
}

/// "exact", "fast", "reciprocal", "inverse-sqrt", "fused", "power".
std::string_view name_of(Precision) noexcept;
std::optional<Precision> precision_named(std::string_view name) noexcept;

/// Those that this build contains and this processor runs, narrowest first; never empty.
std::span<const InstructionSet> supported_instruction_sets();

/// The widest supported one.
InstructionSet best_instruction_set();

bool is_supported(InstructionSet) noexcept;

/// "sse4" (or "neon", "baseline"), "avx2", "avx3".
std::string_view name_of(InstructionSet) noexcept;
std::optional<InstructionSet> instruction_set_named(std::string_view name) noexcept;

}  // namespace tuberia
