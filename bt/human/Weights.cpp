#include "bt/human/Weights.h"

#include <cmath>

#include "sim2d/base/Text.h"

namespace bt {

std::optional<std::vector<double>> parseWeights(std::string_view text) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const std::string& token : base::split(text, ';')) {
    const std::optional<double> weight = base::parseDouble(base::trimmed(token));
    if (!weight || !(*weight >= 0.0)) {
      return std::nullopt;
    }
    weights.push_back(*weight);
    sum += *weight;
  }
  const bool isUsable = sum > 0.0 && std::isfinite(sum);
  return isUsable ? std::optional<std::vector<double>>(std::move(weights)) : std::nullopt;
}

}  // namespace bt
