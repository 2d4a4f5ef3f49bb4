#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace bt {

/// "3;1;1": numbers of 0 or more, at least one above 0, with a finite sum. Nothing = it is not
/// that.
std::optional<std::vector<double>> parseWeights(std::string_view text);

}  // namespace bt
