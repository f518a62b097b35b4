#pragma once
// The eight relations that tests are made of.

namespace tuberia::oracle {

enum class Compare { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

template <class Number>
bool holds(Compare test, Number a, Number b) {
  switch (test) {
    case Compare::never: return false;
    case Compare::less: return a < b;
    case Compare::equal: return a == b;
    case Compare::less_equal: return a <= b;
    case Compare::greater: return a > b;
    case Compare::not_equal: return a != b;
    case Compare::greater_equal: return a >= b;
    case Compare::always: return true;
  }
  return true;
}

}  // namespace tuberia::oracle
