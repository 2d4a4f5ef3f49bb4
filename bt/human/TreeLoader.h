#pragma once

#include <map>
#include <memory>
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
  std::vector<std::shared_ptr<const PersonProgram>> programs;  // each once
  std::vector<std::pair<int, std::size_t>> ofPeople;           // by ascending id
  std::map<std::string, std::size_t> ofSources;                // by the name of the area

  /// Null when nothing is said of the person.
  const PersonProgram* find(const sim2d::ResolvedHuman& person) const;
};

/// A tree file with its includes. When the file that all generated trees include is not there, our
/// own copy takes its place, with a warning.
base::Result<TreeTable> loadPersonTrees(const std::string& path);
/// The same for a file that was read already; one without a path lies beside no other, and is not
/// warned of.
base::Result<TreeTable> loadPersonTrees(base::Result<TreeFile> file);

/// Loads and compiles; equal files and equal generated trees share their program.
class TreeLoader {
 public:
  struct Loaded {
    TreeTable table;
    std::shared_ptr<const PersonProgram> program;  // nullptr = broken
  };

  explicit TreeLoader(const sim2d::Scenario& scenario, const sim2d::Compatibility& quirks = {});

  /// By the person's file, or generated when `path` is empty. nullptr and errors when broken.
  std::shared_ptr<const PersonProgram> load(const sim2d::Human& human, const std::string& path,
                                            base::Diagnostics& diagnostics);

  /// A tree as an editor has it; its includes lie beside `path`. Nothing of it is kept.
  Loaded loadText(const std::string& text, const std::string& path,
                  base::Diagnostics& diagnostics) const;

  /// Of all listed people and of those that sources copy.
  PersonPrograms loadAll(const TreeFiles& files, base::Diagnostics& diagnostics);

 private:
  Loaded loadTable(base::Result<TreeTable> table, base::Diagnostics& diagnostics) const;
  std::shared_ptr<const PersonProgram> compileTable(const TreeTable& table,
                                                    base::Diagnostics& diagnostics) const;

  const sim2d::Scenario& scenario_;
  sim2d::Compatibility quirks_;
  NodeLibrary library_;
  std::map<std::string, Loaded> files_;                                    // by path
  std::map<std::string, std::shared_ptr<const PersonProgram>> generated_;  // by content
};

}  // namespace bt
