#pragma once
// What Assimp mutters while it reads; only files that know Assimp include this.

#include <functional>
#include <string>
#include <vector>

namespace tuberia {

/// Runs `work` and returns the warnings and errors that Assimp logged meanwhile; it prints none.
/// Assimp has one logger for the whole program, so only one thread at a time gets through here,
/// and a logger that the program may have given to Assimp itself is gone afterwards.
std::vector<std::string> assimp_complaints_during(const std::function<void()>& work);

}  // namespace tuberia
