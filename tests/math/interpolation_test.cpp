#include "math/interpolation.hpp"

#include <catch2/catch.hpp>

namespace tuberia {

namespace {

double midpoint_of_edge(double value0, double w0, double value1, double w1) {
  return perspective_correct({0.5, 0.5, 0.0}, {value0, value1, 0.0}, {w0, w1, 1.0});
}

}  // namespace

// notes 15.4
TEST_CASE("interpolation: a projected midpoint belongs mostly to the nearer vertex", "[math]") {
  CHECK(midpoint_of_edge(0, 1, 1, 3) == Approx(0.25).epsilon(1e-15));
  CHECK(midpoint_of_edge(0, 2, 1, 2) == 0.5);
  // The notes use view z, which is negative before the eye: the sign cancels.
  CHECK(midpoint_of_edge(0, -1, 1, -3) == midpoint_of_edge(0, 1, 1, 3));
}

// rules, cases 26 and 27
TEST_CASE("interpolation: extreme ratios of w keep their digits", "[math]") {
  CHECK(midpoint_of_edge(0, 1, 1, 1000) == Approx(9.99000999000999e-4).epsilon(1e-14));
  CHECK(midpoint_of_edge(0, 1, 1, 1e7) == Approx(9.9999990000001e-8).epsilon(1e-13));
  const double third = 1.0 / 3.0;
  CHECK(perspective_correct({third, third, third}, {0, 1, 2}, {1, 10, 100}) ==
        Approx(0.108108108108108108).epsilon(1e-14));
  CHECK(perspective_correct({0.25, 0.25, 0.5}, {10, 20, 30}, {1e-3, 1, 1e3}) ==
        Approx(10.01002994999010991).epsilon(1e-14));
}

TEST_CASE("interpolation: a constant attribute stays constant", "[math]") {
  CHECK(perspective_correct({0.2, 0.3, 0.5}, {7, 7, 7}, {1e-6, 1, 1e6}) == Approx(7.0).epsilon(1e-15));
}

}  // namespace tuberia
