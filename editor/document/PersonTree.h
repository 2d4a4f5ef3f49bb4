#pragma once

#include "bt/human/BehaviorBlocks.h"
#include "bt/human/TreeGenerator.h"
#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"

namespace editor {

/// The effective behaviour tree of a person: generated from behaviour and goals, or custom.
struct PersonTree {
  bool isCustom = false;
  /// Without its blocks the tree equals the generated one, so it is updated when behaviour or goals
  /// change.
  bool isGeneratedWithBlocks = false;
  bt::TreeFile file;
  bt::TreeTable table;             // Includes the included files.
  base::Diagnostics problems;      // Unreadable XML, unknown nodes …, goals of another route.
  bool hasDifferentGoals = false;  // The goals of the tree differ from the route of the scenario.

  bt::TreeSpec* mainTree();
  const bt::TreeSpec* mainTree() const;
};
PersonTree personTree(const ScenarioDocument& document, EntityId person);
/// Returns true for a custom tree that consists of the generated tree and blocks.
bool hasAutoUpdatedTree(const ScenarioDocument& document, EntityId person);

/// The goals that the person walks to, in order: the person's own, or those of the GoTo nodes of a
/// custom tree that uses no others. Goals that depend on the blackboard are not included.
std::vector<int> walkedGoals(const ScenarioDocument& document, const sim2d::Human& human);

/// The message with the name of the node instead of its path: "Wait: port 'seconds' is missing".
/// `isAtNode`: without the name, for a message that is shown at the node.
QString treeProblemText(const base::Diagnostic& problem, bool isAtNode = false);
/// The errors first, as "message (and 2 more)"; empty: no problems.
QString problemSummary(const base::Diagnostics& problems);

/// A node of the tree, with SubTrees expanded. Its index in the list is the node number in the
/// frames of a run.
struct OutlineNode {
  const bt::NodeSpec* node = nullptr;  // Points into PersonTree::table.
  int parent = -1;
  std::string tree;         // ID of the tree that contains the node.
  bt::NodePath path;        // Path within that tree.
  bool isEditable = false;  // The node is in the person's file, not in an included one.
};
std::vector<OutlineNode> outlineOf(const PersonTree& tree);
/// Node names as used in recordings: "MainFallback/SetGoals/RunOnce[2]".
std::vector<std::string> recordedNames(const std::vector<OutlineNode>& nodes);

/// Each function pushes one command. The tree becomes custom, or generated again if it equals the
/// tree generated from behaviour and goals.
void pushPort(ScenarioDocument& document, EntityId person, const OutlineNode& node,
              const std::string& port, const std::string& text);
/// Sets the tree file of all these people; unchanged parts keep their text. Their trees become
/// custom, or generated where the file equals the generated tree.
void pushTreeFile(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::TreeFile& file, const QString& text);
/// The person and all others whose custom tree has the same text; only the person if their tree is
/// generated.
std::vector<EntityId> peopleWithTreeOf(const ScenarioDocument& document, EntityId person);
void pushBlocks(ScenarioDocument& document, EntityId person, const std::vector<bt::Block>& blocks);
/// Adds a block for several people, or replaces the one at `index` (one person only).
void pushAddBlock(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::Block& block);
/// Copies the goals of the scenario's route into the tree.
void pushGoalsOfRoute(ScenarioDocument& document, EntityId person);
/// Sets the XML text; none = the generated tree.
void pushTreeText(ScenarioDocument& document, EntityId person, std::optional<std::string> xml,
                  const QString& text);
/// Restores the generated trees of all these people in one command.
void pushRegeneratedTrees(ScenarioDocument& document, const std::vector<EntityId>& people);
/// The text as it is written to the tree file.
std::string treeText(const ScenarioDocument& document, EntityId person);

/// The updated text of a generated tree with blocks after the person has changed to `after`; none
/// if the tree is not updated automatically or stays the same.
std::optional<std::string> updatedTree(const ScenarioDocument& document, const sim2d::Human& after);

/// All nodes available in the trees of people.
const bt::NodeCatalogue& treeCatalogue();

/// The folder for the trees of a scenario file: ../behavior_trees if its own folder is called
/// scenarios.
std::string treeFolderOf(const std::string& scenarioPath);

/// XML of the tree generated from the behaviour and goals of a person.
std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          bt::TreeStyle style = bt::TreeStyle::Corrected);
/// See bt::generatedStyle. A broken file is kept unchanged; running it reports the problem.
std::optional<bt::TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                            const sim2d::Human& human);
/// The fixed tree file that generated trees include; none if the folder already has one.
std::optional<base::FileContent> missingIncludedTree(const std::string& folder);

}  // namespace editor
