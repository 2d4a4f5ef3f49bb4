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

/// Where the tree of a person comes from. Neither path nor text: the generated tree.
struct TreeSource {
  TreeSource(std::string file = {}) : path(std::move(file)) {}  // NOLINT: meant to convert
  TreeSource(std::string xml, std::string file, std::string besides)
      : path(std::move(file)), text(std::move(xml)), folder(std::move(besides)) {}

  std::string path;                 // of its file, which names it in messages
  std::optional<std::string> text;  // none: what the file says
  std::string folder;               // of what it includes, when it is in no file yet
  bool isGenerated() const { return path.empty() && !text; }
};
/// Name of a person -> their tree; no entry = the generated one.
using TreeFiles = std::map<std::string, TreeSource>;

/// Trees that runs have in common: each text of a folder and each content of a generated tree is
/// read and compiled when it is first met. What files include is taken not to change. One thread.
class KnownTrees;
std::shared_ptr<KnownTrees> makeKnownTrees();

/// People who decide by behaviour trees, one per person, ticked once per step by ascending id with
/// the entries `id` and `dt`. Equal trees of one folder are compiled once. People of a source area
/// run the tree of the person they are like.
///
/// A tree that goes wrong while it runs (missing input, bad script) is halted for good with one
/// warning; its person brakes. With `loop_trees: false` a person stands from the step on after the
/// one in which the root succeeds without moving them or taking a goal off their list: a round of
/// navigation is no end.
///
/// nullptr and errors among `diagnostics` when a tree is missing or broken. `scenario` is not kept.
/// Of the quirks those of generated trees count here; the others act in the run.
/// `known`: of runs before; null: none.
std::unique_ptr<sim2d::HumanBehavior> makeTreeBehavior(
    const sim2d::Scenario& scenario, const TreeFiles& files, base::Diagnostics& diagnostics,
    const sim2d::Compatibility& quirks = {}, const std::shared_ptr<KnownTrees>& known = nullptr);

/// The same trees for the same people, none of whom has entered yet; `behavior` was returned by
/// makeTreeBehavior. Nothing is read or compiled again.
std::unique_ptr<sim2d::HumanBehavior> withFreshMinds(const sim2d::HumanBehavior& behavior);

/// The tree that such a run gives a person, with all that it includes.
base::Result<TreeTable> treeOf(const sim2d::Human& human, const TreeFiles& files,
                               const sim2d::Scenario& scenario,
                               const sim2d::Compatibility& quirks = {});

/// Loads and checks one person's tree (engine, then meaning): what makeTreeBehavior would say.
base::Diagnostics checkAgentTreeFile(const std::string& path, const sim2d::Human& human,
                                     const sim2d::Scenario& scenario);

}  // namespace bt
