#include <catch2/catch.hpp>

#include "reference/ray_tracer/shapes/polynomial.hpp"
#include "reference/ray_tracer/shapes/quadratic.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {

TEST_CASE("shapes: quadratic equations keep the digits of both roots", "[ray_tracer][case-60][Y4]") {
  const auto check = [](double a, double b, double c, double first, double second) {
    const QuadraticRoots roots = solve_quadratic(a, b, c);
    CHECK(roots.count == 2);
    CHECK(roots.first == Approx(first).epsilon(2e-16).margin(0));
    CHECK(roots.second == Approx(second).epsilon(2e-16).margin(0));
  };
  check(1, -20000, 1, 5.0000000125000000625e-5, 19999.9999499999998750);
  check(1, -1e8, 1, 1.0000000000000001e-8, 1e8);
  check(1e-20, 1, 1, -1e20, -1);
  check(1, -2, 1, 1, 1);
  check(-1, 20000, -1, 5.0000000125000000625e-5, 19999.9999499999998750);
  check(1, 0, -4, -2, 2);
  check(1, 0, 0, 0, 0);
  check(0x1p900, 0, -0x1p902, -2, 2);    // squares beyond the largest number
  check(0x1p-900, 0, -0x1p-902, -0.5, 0.5);  // and below the smallest

  CHECK(solve_quadratic(0, 2, -4).count == 1);
  CHECK(solve_quadratic(0, 2, -4).first == 2);
  for (const auto& none : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 1), glm::dvec3(1, NAN, 1), glm::dvec3(1, INFINITY, 1)})
    CHECK(solve_quadratic(none.x, none.y, none.z).count == 0);
}

TEST_CASE("shapes: nearly double roots stay apart", "[ray_tracer][case-60]") {
  // (t - n)(t - n - 1) with n of 26 bits: b and c are whole and exact, b^2 - 4 a c is 1, and b^2 has 54 bits.
  Random random(60);
  for (int i = 0; i < 100000; ++i) {
    const double n = static_cast<double>(random.below(1 << 26));
    const QuadraticRoots roots = solve_quadratic(1, -2 * n - 1, n * (n + 1));
    REQUIRE(roots.count == 2);
    CHECK(std::abs(roots.first - n) <= 1e-15 * n);
    CHECK(std::abs(roots.second - n - 1) <= 1e-15 * (n + 1));
  }
}

TEST_CASE("shapes: polynomials change their sign where their factors do", "[ray_tracer][case-60]") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 4> factors{};
    for (double& factor : factors) factor = uniform(random, -1, 1);
    std::sort(factors.begin(), factors.end());
    std::array<double, 5> c{1, 0, 0, 0, 0};
    for (std::size_t degree = 0; degree < 4; ++degree)
      for (std::size_t k = degree + 2; k-- > 0;) c[k] = (k > 0 ? c[k - 1] : 0) - factors[degree] * (k <= degree ? c[k] : 0);
    double gap = 2;
    for (std::size_t k = 1; k < 4; ++k) gap = std::min(gap, factors[k] - factors[k - 1]);
    if (gap < 1e-3) continue;  // rounded coefficients may have no roots there
    const PolynomialRoots roots = sign_changes(c, -1, 1);
    REQUIRE(roots.count == 4);
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(roots.values[k] - factors[k]) < 1e-6);
  }
  CHECK(sign_changes(std::array{1.0, -2.0, 1.0}, -5, 5).count == 0);   // touches
  CHECK(sign_changes(std::array{1.0, 0.0, 1.0}, -5, 5).count == 0);
  CHECK(sign_changes(std::array{-6.0, 2.0}, -5, 5).values[0] == 3);
  CHECK(sign_changes(std::array{-6.0, 2.0}, -5, 2).count == 0);
  CHECK(sign_changes(std::array{1.0}, -5, 5).count == 0);
}

}  // namespace tuberia::tracer::shapes_test
