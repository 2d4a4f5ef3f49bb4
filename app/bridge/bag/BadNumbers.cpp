#include "app/bridge/bag/BadNumbers.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"

namespace bridge {

bool BadNumbers::areFine(std::size_t channel, const char* field,
                         std::initializer_list<double> numbers, double most, Loss loss) {
  const auto* const bad = std::find_if(numbers.begin(), numbers.end(), [most](double number) {
    return !(std::fabs(number) <= most);  // NaN too
  });
  if (bad == numbers.end()) {
    return true;
  }
  Count& count = counts_[{channel, field}];
  if (count.count++ == 0) {
    count.first = *bad;
    count.loss = loss;
  }
  return false;
}

bool BadNumbers::hasSamples() const {
  return std::any_of(counts_.begin(), counts_.end(),
                     [](const auto& each) { return each.second.loss == Loss::Sample; });
}

base::Diagnostics BadNumbers::warnings(const std::vector<BagChannel>& channels,
                                       const std::string& path) const {
  base::Diagnostics warnings;
  for (const auto& [where, count] : counts_) {
    const char* const code = count.loss == Loss::Sample ? "bag.bad-samples" : "bag.bad-values";
    warnings.push_back(base::warning(
        code,
        {count.count, channels[where.first].topic, where.second, base::formatDouble(count.first)},
        path));
  }
  return warnings;
}

}  // namespace bridge
