#include "scene/assimp_log.hpp"

#include <mutex>
#include <stdexcept>
#include <string>

#include <assimp/DefaultLogger.hpp>

// Debian's libassimp 5.2.5 has its assertions enabled, and malformed files reach them: a program
// would end for a bad file. This definition takes the place of the library's own, as ELF lets a
// program do, and turns a failed assertion into an exception, which load_model() reports.
namespace Assimp {
[[noreturn]] void aiAssertViolation(const char* condition, const char*, int);

void aiAssertViolation(const char* condition, const char*, int) {
  throw std::runtime_error(std::string("Assimp expects ") + condition);
}
}  // namespace Assimp

namespace tuberia {
namespace {

class Listener final : public Assimp::Logger {
 public:
  explicit Listener(std::vector<std::string>& heard) : heard_(heard) {}
  bool attachStream(Assimp::LogStream*, unsigned int) override { return false; }
  bool detachStream(Assimp::LogStream*, unsigned int) override { return false; }

 private:
  void OnDebug(const char*) override {}
  void OnVerboseDebug(const char*) override {}
  void OnInfo(const char*) override {}
  void OnWarn(const char* message) override { heard_.emplace_back(message); }
  void OnError(const char* message) override { heard_.emplace_back(message); }

  std::vector<std::string>& heard_;
};

/// Assimp owns the logger that it is given and deletes it when the next one comes.
struct Installed {
  explicit Installed(std::vector<std::string>& heard) { Assimp::DefaultLogger::set(new Listener(heard)); }
  ~Installed() { Assimp::DefaultLogger::set(nullptr); }
};

}  // namespace

std::vector<std::string> assimp_complaints_during(const std::function<void()>& work) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::vector<std::string> heard;
  const Installed installed(heard);
  work();
  return heard;
}

}  // namespace tuberia
