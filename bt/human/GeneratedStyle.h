#pragma once

#include <optional>
#include <string>

#include "bt/human/TreeGenerator.h"

namespace bt {

/// Returns true if `xml` contains comments that `made` does not have; the parsed tree has no
/// comments.
bool hasExtraComments(const std::string& xml, const std::string& made);

/// The style in which the generator writes this text for the person: with the same meaning and all
/// of its comments. None: a custom tree, or a broken file.
std::optional<TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                        const sim2d::Human& human, const NodeCatalogue& catalogue);

}  // namespace bt
