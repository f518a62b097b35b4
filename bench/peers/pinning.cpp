#include "bench/peers/pinning.hpp"

#include <sched.h>

namespace tuberia::bench {

std::string keep_to_cores(int count) {
  cpu_set_t allowed, chosen;
  CPU_ZERO(&chosen);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0)
    return "threads are not pinned: the system does not say which cores there are";
  std::string list;
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&chosen) < count; ++core) {
    if (!CPU_ISSET(core, &allowed)) continue;
    CPU_SET(core, &chosen);
    list += (list.empty() ? "" : ", ") + std::to_string(core);
  }
  if (CPU_COUNT(&chosen) < count)
    return "threads are not pinned: there are only " + std::to_string(CPU_COUNT(&chosen)) + " cores for them";
  if (sched_setaffinity(0, sizeof chosen, &chosen) != 0) return "threads are not pinned: the system refuses";
  return "all threads of both kept to " + std::string(count == 1 ? "core " : "cores ") + list;
}

}  // namespace tuberia::bench
