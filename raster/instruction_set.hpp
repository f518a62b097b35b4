#pragma once
// Which machine instructions draw, chosen at run time; and how exactly they must do it.

#include <optional>
#include <span>
#include <string_view>

namespace tuberia {

/// What the kernels are compiled for: one set of names for all processors, narrowest first.
/// `baseline` is what every file of the build assumes (SSE4 on x86, NEON on Arm).
enum class InstructionSet { baseline, avx2, avx3 };
inline constexpr int kInstructionSetCount = 3;

/// exact: the same bits from every instruction set, compiler and thread count.
/// fast: may fuse and approximate; each operation states its largest error.
enum class Precision { exact, fast };
inline constexpr int kPrecisionCount = 2;

/// Those that this build contains and this processor runs, narrowest first; never empty.
std::span<const InstructionSet> supported_instruction_sets();

/// The widest supported one.
InstructionSet best_instruction_set();

bool is_supported(InstructionSet) noexcept;

/// "sse4" (or "neon", "baseline"), "avx2", "avx3".
std::string_view name_of(InstructionSet) noexcept;
std::optional<InstructionSet> instruction_set_named(std::string_view name) noexcept;

}  // namespace tuberia
