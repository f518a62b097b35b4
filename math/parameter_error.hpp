#pragma once
// How the functions of this folder name a parameter they refuse.

#include <cstdio>

#include "base/result.hpp"

namespace tuberia {

/// "<name> is <value>, but must be <rule>".
inline Error parameter_error(const char* name, double value, const char* rule) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.9g", value);
  return Error{std::string(name) + " is " + digits + ", but must be " + rule};
}

}  // namespace tuberia
