#pragma once
// Roots of polynomials between two limits.

#include <array>
#include <span>

namespace tuberia::tracer {

inline constexpr std::size_t kMostRoots = 4;

struct PolynomialRoots {
  std::array<double, kMostRoots> values{};
  std::size_t count = 0;

  std::span<const double> all() const noexcept { return {values.data(), count}; }
};

/// The values where c[0] + c[1] x + c[2] x^2 + ... changes its sign in low <= x <= high, ascending; at most kMostRoots + 1 coefficients.
/// Between neighbouring roots of its derivative a polynomial only rises or only falls, so that there is at most one root, which
/// halving finds however bad the coefficients are. Where it touches 0 and turns back it has none.
PolynomialRoots sign_changes(std::span<const double> coefficients, double low, double high) noexcept;

}  // namespace tuberia::tracer
