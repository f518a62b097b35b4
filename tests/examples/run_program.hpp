#pragma once
// Programs run as a person would run them.

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/image/temporary_folder.hpp"

namespace tuberia::test {

struct Outcome {
  int status;          // exit status; -1 if the program died
  std::string output;  // both streams
};

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// In the folder, where the output stays in output.txt.
inline Outcome run_program(const std::string& arguments, const TemporaryFolder& folder, const char* program = TUBERIA_PROGRAM) {
  const std::filesystem::path log = folder / "output.txt";
  const std::string command = "cd '" + log.parent_path().string() + "' && '" + program + "' " + arguments + " > output.txt 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(log)};
}

}  // namespace tuberia::test
