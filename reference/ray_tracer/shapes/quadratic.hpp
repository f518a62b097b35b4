#pragma once
// Roots of quadratic equations, without the loss of digits that the formula of school has.     [case 60] [Kahan]

namespace tuberia::tracer {

/// first <= second where there are two; a double root is two equal ones.
struct QuadraticRoots {
  int count = 0;
  double first = 0, second = 0;
};

/// The real roots of a t^2 + b t + c, each to a few 2^-53 of itself. With a = 0 there is one, or none; where every t would do, none.
/// A root that no double can hold is infinite.
QuadraticRoots solve_quadratic(double a, double b, double c) noexcept;

}  // namespace tuberia::tracer
