#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bt/tree/TreeSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/HumanBehavior.h"

namespace bt {

/// Source of a person's tree. Without path and text: the generated tree.
struct TreeSource {
  TreeSource(std::string file = {}) : path(std::move(file)) {}  // NOLINT: implicit by intent
  TreeSource(std::string xml, std::string file, std::string besides)
      : path(std::move(file)), text(std::move(xml)), folder(std::move(besides)) {}

  std::string path;                 // file path, also used in messages
  std::optional<std::string> text;  // empty: the file's content
  std::string folder;               // base of its includes if it is not saved yet
  bool isGenerated() const { return path.empty() && !text; }
};
/// Tree by person name; without an entry the generated one.
using TreeFiles = std::map<std::string, TreeSource>;

/// Trees shared by runs: each text per folder and each generated content is parsed and compiled
/// once. Included files are assumed not to change. Not synchronised.
class TreeCache;
std::shared_ptr<TreeCache> makeTreeCache();

/// People controlled by behaviour trees, one per person, ticked once per step by ascending id with
/// the entries `id` and `dt`. Equal trees of one folder are compiled once. People spawned by a
/// source area run the tree of their prototype.
///
/// A tree with a run-time fault (missing input, invalid script) is halted permanently with one
/// warning, and its person brakes. With `loop_trees: false` a person stops after the step in which
/// the root succeeds without moving them or removing a goal from their list: a round of navigation
/// does not count as the end.
///
/// Returns nullptr and errors in `diagnostics` if a tree is missing or invalid. Does not keep
/// `scenario`. Of `quirks`, those of generated trees apply here; the others
/// apply during the run. `known`: trees of earlier runs; null: none.
std::unique_ptr<sim2d::HumanBehavior> makeTreeBehavior(
    const sim2d::Scenario& scenario, const TreeFiles& files, base::Diagnostics& diagnostics,
    const sim2d::Compatibility& quirks = {}, const std::shared_ptr<TreeCache>& known = nullptr);

/// The same trees for the same people before any of them has entered. `behavior` must come from
/// makeTreeBehavior. Nothing is read or compiled again.
std::unique_ptr<sim2d::HumanBehavior> withInitialState(const sim2d::HumanBehavior& behavior);

/// Problems of a breakpoint's condition: a syntax error, or an assignment.
base::Diagnostics checkBreakpoint(const sim2d::TreeBreakpoint& point);

/// The tree of a person in such a run, with its includes resolved.
base::Result<TreeTable> treeOf(const sim2d::Human& human, const TreeFiles& files,
                               const sim2d::Scenario& scenario,
                               const sim2d::Compatibility& quirks = {});

}  // namespace bt
