#pragma once

#include <optional>
#include <string>

#include "bt/human/Templates.h"
#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Files.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// All nodes that trees of people may have.
const bt::NodeCatalogue& treeCatalogue();

/// Folder for the trees of a scenario file: ../behavior_trees when its own is called scenarios.
std::string treeFolderOf(const std::string& scenarioPath);

/// XML of the tree that the behaviour and goals of a person make.
std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          bt::TreeStyle style = bt::TreeStyle::Corrected);
/// Whether somebody wrote comments into a tree that was made like that; the parsed tree does not
/// have them.
bool hasCommentsBeyond(const std::string& xml, const std::string& made);
/// The generator (ours or the original's) whose tree of this person means the same as the text and
/// has all of its comments.
std::optional<bt::TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                            const sim2d::Human& human);
/// The fixed tree that generated ones include; none when the folder has one already.
std::optional<base::FileContent> missingIncludedTree(const std::string& folder);

}  // namespace editor
