#include "editor/document/TreeIssues.h"

#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "bt/human/AgentTreeCheck.h"
#include "bt/human/TreeLoader.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

namespace fs = std::filesystem;

/// A text that was looked at, under the name of the first file that has it.
struct Checked {
  std::string path;
  bt::TreeLoader::Loaded loaded;
  base::Diagnostics found;
};

base::Diagnostics renamed(base::Diagnostics found, const std::string& from, const std::string& to) {
  for (base::Diagnostic& diagnostic : found) {
    if (diagnostic.file == from) {
      diagnostic.file = to;
    }
  }
  return found;
}

class Checker {
 public:
  Checker(const sim2d::Scenario& scenario, const sim2d::FilePlaces& places)
      : scenario_(scenario), places_(places), loader_(scenario) {}

  void add(const sim2d::Human& human, const WrittenTree& tree) {
    const std::string path =
        tree.path.empty() ? sim2d::findTree(scenario_, human, places_) : tree.path;
    base::Result<std::string> text =
        tree.text ? base::Result<std::string>(*tree.text) : base::readTextFile(path);
    if (!text) {
      if (told_.insert(path).second) {
        base::append(found_, text.diagnostics());
      }
      return;
    }
    const Checked& checked = look(*text, path.empty() ? placeOfNew(human) : path);
    if (path.empty()) {
      base::append(found_, about(human, renamed(checked.found, checked.path, path)));
    } else if (told_.insert(path).second) {
      base::append(found_, renamed(checked.found, checked.path, path));
    }
    if (checked.loaded.program) {
      base::append(found_, renamed(bt::checkAgentTree(checked.loaded.table, human, scenario_,
                                                      treeCatalogue()),
                                   checked.path, path));
    }
  }

  base::Diagnostics take() { return std::move(found_); }

 private:
  /// A tree that is in no file is found by its person.
  static base::Diagnostics about(const sim2d::Human& human, base::Diagnostics found) {
    for (base::Diagnostic& diagnostic : found) {
      diagnostic.entity = human.key;
      diagnostic.message = "tree of " + human.name + ": " + diagnostic.message;
    }
    return found;
  }

  /// Where saving would put it; empty while the scenario has no place either.
  std::string placeOfNew(const sim2d::Human& human) const {
    const fs::path folder = treeFolderOf(places_.scenarioPath);
    return places_.scenarioPath.empty() ? std::string()
                                        : (folder / treeFileName("own", human.id)).string();
  }

  const Checked& look(const std::string& text, const std::string& path) {
    const auto [place, isNew] =
        checked_.try_emplace(std::pair(fs::path(path).parent_path().string(), text));
    Checked& checked = place->second;
    if (isNew) {
      checked.path = path;
      checked.loaded = loader_.loadText(text, path, checked.found);
    }
    return checked;
  }

  const sim2d::Scenario& scenario_;
  const sim2d::FilePlaces& places_;
  bt::TreeLoader loader_;
  std::map<std::pair<std::string, std::string>, Checked> checked_;  // by folder and text
  std::set<std::string> told_;                                      // files
  base::Diagnostics found_;
};

}  // namespace

base::Diagnostics treeIssues(const sim2d::Scenario& scenario, const std::vector<WrittenTree>& trees,
                             const sim2d::FilePlaces& places) {
  std::map<base::EntityId, const WrittenTree*> byPerson;
  for (const WrittenTree& tree : trees) {
    byPerson[tree.human] = &tree;
  }
  Checker checker(scenario, places);
  for (const sim2d::Human& human : scenario.humans) {
    const auto tree = byPerson.find(human.key);
    if (human.listed && tree != byPerson.end()) {
      checker.add(human, *tree->second);
    }
  }
  return checker.take();
}

}  // namespace editor
