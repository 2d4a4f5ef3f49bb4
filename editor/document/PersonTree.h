#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bt/human/Blocks.h"
#include "bt/tree/TreeSpec.h"
#include "editor/document/ScenarioDocument.h"

namespace editor {

/// The behaviour tree of a person as it counts: made from behaviour and goals, or their own.
struct PersonTree {
  bool isOwn = false;
  /// Without its blocks it is what behaviour and goals make: it follows when those change.
  bool isMadeWithBlocks = false;
  bt::TreeFile file;
  bt::TreeTable table;         // with what it includes
  base::Diagnostics problems;  // XML that cannot be read, unknown nodes …, goals of another route
  bool hasOtherGoals = false;  // than the route of the scenario

  bt::TreeSpec* mainTree();
  const bt::TreeSpec* mainTree() const;
};
PersonTree personTree(const ScenarioDocument& document, EntityId person);
/// An own tree that is made with blocks.
bool hasFollowingTree(const ScenarioDocument& document, EntityId person);

/// A node of the tree, SubTrees followed. The place in the list is the number that frames of a run
/// give the node.
struct OutlineNode {
  const bt::NodeSpec* node = nullptr;  // within PersonTree::table
  int parent = -1;
  std::string tree;         // ID of the tree that holds it
  bt::NodePath path;        // in that tree
  bool isEditable = false;  // it stands in the person's own file, not in an included one
};
std::vector<OutlineNode> outlineOf(const PersonTree& tree);
/// The names by which records know them: "MainFallback/SetGoals/RunOnce[2]".
std::vector<std::string> recordedNames(const std::vector<OutlineNode>& nodes);

/// Each is one command and makes the tree the person's own, or back again when it is what behaviour
/// and goals make.
void pushPort(ScenarioDocument& document, EntityId person, const OutlineNode& node,
              const std::string& port, const std::string& text);
/// The file as it is to be, of all these people; what it does not change stays as it is written.
/// They become people with trees of their own, or with made ones where it is what theirs would be.
void pushTreeFile(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::TreeFile& file, const QString& text);
/// The person and all others whose own tree is the same text; the person alone without one.
std::vector<EntityId> peopleWithTreeOf(const ScenarioDocument& document, EntityId person);
void pushBlocks(ScenarioDocument& document, EntityId person, const std::vector<bt::Block>& blocks);
/// Adds a block to several people at once, or replaces the one at `index` (of one person).
void pushAddBlock(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::Block& block);
/// The goals of the scenario's route into the tree.
void pushGoalsOfRoute(ScenarioDocument& document, EntityId person);
/// Another text, or none for the tree that is made.
void pushTreeText(ScenarioDocument& document, EntityId person, std::optional<std::string> xml,
                  const QString& text);
/// The trees that behaviour and goals make, for all of these people in one command.
void pushTreesAnew(ScenarioDocument& document, const std::vector<EntityId>& people);
/// As it is written into the tree file.
std::string treeText(const ScenarioDocument& document, EntityId person);

/// For a person whose tree is made with blocks: the text after the person has changed to `after`;
/// nothing when the tree does not follow or stays the same.
std::optional<std::string> followedTree(const ScenarioDocument& document,
                                        const sim2d::Human& after);

}  // namespace editor
