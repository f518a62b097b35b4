#include "raster/sample_positions.hpp"

namespace tuberia {
namespace {

constexpr std::array<SamplePosition, 1> kOne{{{0, 0}}};
constexpr std::array<SamplePosition, 2> kTwo{{{4, 4}, {-4, -4}}};
constexpr std::array<SamplePosition, 4> kFour{{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
constexpr std::array<SamplePosition, 8> kEight{{{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
constexpr std::array<SamplePosition, 16> kSixteen{{{1, 1}, {-1, -3}, {-3, 2}, {4, -1}, {-5, -2}, {2, 5}, {5, 3}, {3, -5},
                                                   {-2, 6}, {0, -7}, {-4, -6}, {-6, 4}, {-8, 0}, {7, -4}, {6, 7}, {-7, -8}}};

}  // namespace

std::span<const SamplePosition> sample_positions(int samples) noexcept {
  switch (samples) {
    case 2: return kTwo;
    case 4: return kFour;
    case 8: return kEight;
    case 16: return kSixteen;
    default: return kOne;
  }
}

}  // namespace tuberia
