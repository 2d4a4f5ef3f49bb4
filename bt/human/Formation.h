#pragma once

#include <optional>
#include <vector>

#include "bt/human/HumanContext.h"

/// Who takes part in a group node and where they stand.
namespace bt {

/// The ids in a list such as "2, 3": leading number of each token, empty tokens skipped; nothing
/// when a token has no number.
std::optional<std::vector<int>> parseIds(const std::string& text);

/// The main person and the others, in order, nobody twice. Nothing when somebody does not exist or
/// is not in the world (the node fails) or the list is no list (the tree is faulty).
std::optional<std::vector<int>> membersOf(LeafContext& leaf, int mainPort, int othersPort);

/// Places on a circle of 0.5 m + 0.2 m for each member after the first, evenly spread from the
/// direction in which the first member looks; the closest pairs of person and place first.
std::vector<Spot> circleSpots(const sim2d::WorldView& view, const std::vector<int>& members,
                              const base::Vec2& centre);

}  // namespace bt
