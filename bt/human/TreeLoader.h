#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/engine/TreeState.h"
#include "bt/human/TreeBehavior.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace bt {

/// A compiled tree and the entries that are filled from the person's behaviour parameters (trees of
/// HuNavSim 1.5: {dist}, {duration} …).
struct AgentProgram {
  std::shared_ptr<const Program> program;
  std::vector<std::string> placeholders;  // host entries after `id` and `dt`

  /// A new tree state with all host entries set.
  TreeState start(const sim2d::ResolvedHuman& human) const;
};

/// Maps people to programs.
struct AgentPrograms {
  std::vector<std::pair<int, std::shared_ptr<const AgentProgram>>> byAgentId;  // by ascending id
  std::map<std::string, std::shared_ptr<const AgentProgram>> bySourceArea;     // by area name

  /// Null if there is no program for the person.
  const AgentProgram* find(const sim2d::ResolvedHuman& person) const;
};

/// Resolves the includes of a tree file. If the file that all generated trees include is missing,
/// the built-in copy is used, with a warning. A tree without a path gets no such warning.
base::Result<TreeTable> loadAgentTrees(base::Result<TreeFile> file);

/// A parsed text, under the path of the first file that contains it.
struct LoadedTree {
  std::string path;
  TreeTable table;
  std::shared_ptr<const AgentProgram> program;  // nullptr: invalid
  base::Diagnostics found;
};

class TreeCache {
 public:
  std::map<std::pair<std::string, std::string>, LoadedTree> texts;       // by folder and text
  std::map<std::string, std::shared_ptr<const AgentProgram>> generated;  // by content
  /// Clears the cache when it has too many entries.
  void limit();
};

/// Loads and compiles trees; equal texts in one folder and equal generated trees share a program.
class TreeLoader {
 public:
  /// `known`: cache of earlier loaders; null: none.
  explicit TreeLoader(const sim2d::Scenario& scenario, const sim2d::Compatibility& quirks = {},
                      std::shared_ptr<TreeCache> known = nullptr);

  /// Returns nullptr and errors for an invalid tree. Problems of a file are reported once,
  /// mismatches with a person for each person. Problems of a tree without a file name the person.
  std::shared_ptr<const AgentProgram> load(const sim2d::Human& human, const TreeSource& source,
                                           base::Diagnostics& diagnostics);

  /// Loads the trees of all listed people and of the prototypes of source areas.
  AgentPrograms loadAll(const TreeFiles& files, base::Diagnostics& diagnostics);

 private:
  std::shared_ptr<const AgentProgram> loadFromSource(const sim2d::Human& human,
                                                     const TreeSource& source,
                                                     base::Diagnostics& diagnostics);
  const LoadedTree& look(const std::string& text, const std::string& path);
  std::shared_ptr<const AgentProgram> compileTable(const TreeTable& table,
                                                   base::Diagnostics& diagnostics) const;

  const sim2d::Scenario& scenario_;
  sim2d::Compatibility quirks_;
  NodeLibrary library_;
  std::shared_ptr<TreeCache> cache_;
  std::map<std::string, base::Result<std::string>> files_;  // by path
  std::set<std::string> reportedPaths_;                     // paths already reported
};

}  // namespace bt
