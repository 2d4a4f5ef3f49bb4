#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/document/DocumentDisk.h"
#include "editor/document/TreeQuestion.h"
#include "sim2d/base/Files.h"

/// What saving a document writes where. Private to this folder.
namespace editor {

/// A tree that saving writes.
struct PlannedTree {
  EntityId human;
  std::string path, content;
};

/// All that saving would do; nothing is done yet.
struct SavePlan {
  QString path;  // of the scenario
  sim2d::Scenario scenario;
  QString mapPath;
  std::vector<base::FileContent> mapFiles;
  std::vector<PlannedTree> trees;
  base::Diagnostics problems;
};

/// Finds out what saving a document would write and what is to be asked before. Looks at the disk,
/// changes nothing.
class SavePlanner {
 public:
  SavePlanner(const ScenarioDocument& document, const DocumentDisk& disk, QString shippedMaps)
      : document_(document),
        disk_(disk),
        map_(document.mapState()),
        shippedMaps_(std::move(shippedMaps)) {}

  SavePlan plan(const QString& path) const;
  std::vector<TreeQuestion> questions(const QString& path) const;
  /// The tree that is saved for a person, and run: the own one, that of the file or the generated.
  std::string wantedTree(const sim2d::Scenario& scenario, const sim2d::Human& human) const;

 private:
  void placeMap(SavePlan& plan) const;
  void planTrees(SavePlan& plan) const;

  const ScenarioDocument& document_;
  const DocumentDisk& disk_;
  MapState map_;
  QString shippedMaps_;
};

/// Of a file; none when it cannot be read.
std::optional<std::string> textAt(const std::string& path);

}  // namespace editor
