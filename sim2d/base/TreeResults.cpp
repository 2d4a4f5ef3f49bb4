#include "sim2d/base/TreeResults.h"

#include <algorithm>

namespace base {

void addTreeResults(const TreeResults& more, std::vector<TreeResults>& to) {
  const auto known = std::find_if(to.begin(), to.end(), [&](const TreeResults& each) {
    return each.owner == more.owner && (each.paths == more.paths || *each.paths == *more.paths);
  });
  if (known == to.end()) {
    to.push_back(more);
    return;
  }
  const bool haveEqualMarks =
      known->unreachable == more.unreachable ||
      (known->unreachable && more.unreachable && *known->unreachable == *more.unreachable);
  known->unreachable = haveEqualMarks ? known->unreachable : nullptr;
  for (std::size_t node = 0; node < more.returned.size(); ++node) {
    known->returned[node] = static_cast<StatusSet>(static_cast<unsigned>(known->returned[node]) |
                                                   static_cast<unsigned>(more.returned[node]));
  }
}

}  // namespace base
