#include "datasets/files/allocation_limit.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace datasets {

AllocationLimit::AllocationLimit(std::size_t bytes) {
  getrlimit(RLIMIT_AS, &before_);
  rlim_t pages = 0;
  if (!(std::ifstream("/proc/self/statm") >> pages)) return;
  const rlim_t present = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  const rlimit bounded{std::min<rlim_t>(present + bytes, before_.rlim_cur), before_.rlim_max};
  setrlimit(RLIMIT_AS, &bounded);
}

AllocationLimit::~AllocationLimit() {
  setrlimit(RLIMIT_AS, &before_);
}

}  // namespace datasets
