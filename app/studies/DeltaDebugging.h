#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// A subset of the elements 0 … count - 1, in increasing order.
using ElementSet = std::vector<std::size_t>;

/// Returns for each subset whether it still fails. An error ends the minimisation.
using SubsetTest =
    std::function<base::Result<std::vector<bool>>(const std::vector<ElementSet>& subsets)>;

/// A subset that still fails and of which no single element can be removed without losing the
/// failure: the algorithm ddmin (Zeller & Hildebrandt 2002, IEEE TSE 28(2)). All elements together
/// must fail. All subsets of a step are tested together, and the first one that fails is taken, so
/// that the result does not depend on the number of parallel tests.
base::Result<ElementSet> minimalFailure(std::size_t count, const SubsetTest& fails);

}  // namespace app
