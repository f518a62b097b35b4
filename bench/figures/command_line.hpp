#pragma once
// The command lines of the benchmarks.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia::bench {

/// What a program understands, said option by option; the values are set by parse() and keep what they are where nothing is
/// given, which --help tells. Each value must outlive it. The parser is compiled once for all benchmarks: it takes longer than what they do.
class CommandLine {
 public:
  CommandLine(std::string what_it_does, std::string program);
  ~CommandLine();

  void flag(const char* name, bool& value, const char* help);
  void text(const char* name, std::string& value, const char* help);
  void one_of(const char* name, std::string& value, std::vector<std::string> allowed, const char* help);
  void whole(const char* name, int& value, int least, int most, const char* help);
  void number(const char* name, double& value, double least, double most, const char* help);
  /// Words without an option. allowed: empty if any will do.
  void words(const char* name, std::vector<std::string>& values, const char* help, std::vector<std::string> allowed = {});
  void exclude(const char* name, const char* other);

  // What most of them have, in the same words everywhere.
  void page(std::string& file) { text("--page", file, "The page to write"); }
  void json(std::string& file) { text("--json", file, "Write the figures to this file, too"); }
  void commit(std::string& name) { text("--commit", name, "What the page calls the measured sources"); }
  void precision(std::string& name) { one_of("--precision", name, {"exact", "fast"}, "exact or fast"); }
  void instruction_set(std::string& name) { text("--isa", name, "Instruction set: sse4, avx2 or avx3 (default: the widest)"); }

  /// The status to exit with at once, after a complaint or --help was printed; nothing: go on.
  std::optional<int> parse(int argc, const char* const* argv);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// The instruction set called so, or the widest for "". Error when this machine lacks it.
inline Result<InstructionSet> instruction_set_from(const std::string& name) {
  if (name.empty()) return best_instruction_set();
  const auto chosen = instruction_set_named(name);
  if (!chosen || !is_supported(*chosen)) return Error{"this machine has no instruction set called " + name};
  return *chosen;
}

}  // namespace tuberia::bench
