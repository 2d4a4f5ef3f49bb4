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
#include "sim2d/scenario/Defaults.h"

namespace bt {

/// A compiled tree and the entries that are filled from the person's behaviour block (trees of
/// HuNavSim 1.5: {dist}, {duration} …).
struct PersonProgram {
  std::shared_ptr<const Program> program;
  std::vector<std::string> placeholders;  // host entries behind `id` and `dt`

  /// A fresh tree with all entries of the host set.
  TreeState start(const sim2d::ResolvedHuman& human) const;
};

/// Who runs which program.
struct PersonPrograms {
  std::vector<std::pair<int, std::shared_ptr<const PersonProgram>>> ofPeople;  // by ascending id
  std::map<std::string, std::shared_ptr<const PersonProgram>> ofSources;  // by name of the area

  /// Null when nothing is said of the person.
  const PersonProgram* find(const sim2d::ResolvedHuman& person) const;
};

/// A tree file with its includes. When the file that all generated trees include is not there, our
/// own copy takes its place, with a warning.
/// One without a path lies beside no other, and is not warned of.
base::Result<TreeTable> loadPersonTrees(base::Result<TreeFile> file);

/// A text, under the name of the first file that has it.
struct LoadedTree {
  std::string path;
  TreeTable table;
  std::shared_ptr<const PersonProgram> program;  // nullptr = broken
  base::Diagnostics found;
};

class KnownTrees {
 public:
  std::map<std::pair<std::string, std::string>, LoadedTree> texts;        // by folder and text
  std::map<std::string, std::shared_ptr<const PersonProgram>> generated;  // by content
  /// Forgets all when they are many.
  void limit();
};

/// Loads and compiles; equal texts in one folder and equal generated trees share their program.
class TreeLoader {
 public:
  /// `known`: of loaders before; null: none.
  explicit TreeLoader(const sim2d::Scenario& scenario, const sim2d::Compatibility& quirks = {},
                      std::shared_ptr<KnownTrees> known = nullptr);

  /// nullptr and errors when broken. What is wrong with a file is told once, what does not fit the
  /// person for each; a tree that is in no file is told by its person.
  std::shared_ptr<const PersonProgram> load(const sim2d::Human& human, const TreeSource& source,
                                            base::Diagnostics& diagnostics);

  /// Of all listed people and of those that sources copy.
  PersonPrograms loadAll(const TreeFiles& files, base::Diagnostics& diagnostics);

 private:
  std::shared_ptr<const PersonProgram> loadWritten(const sim2d::Human& human,
                                                   const TreeSource& source,
                                                   base::Diagnostics& diagnostics);
  const LoadedTree& look(const std::string& text, const std::string& path);
  std::shared_ptr<const PersonProgram> compileTable(const TreeTable& table,
                                                    base::Diagnostics& diagnostics) const;

  const sim2d::Scenario& scenario_;
  sim2d::Compatibility quirks_;
  NodeLibrary library_;
  std::shared_ptr<KnownTrees> known_;
  std::map<std::string, base::Result<std::string>> files_;  // by path
  std::set<std::string> told_;                              // paths
};

}  // namespace bt
