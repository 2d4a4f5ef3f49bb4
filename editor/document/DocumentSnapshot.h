#pragma once

#include <map>
#include <string>

#include <QDateTime>

#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"

namespace editor {

/// A document as a value: what an emergency copy holds. May be made in the GUI thread and written
/// in another one.
struct DocumentSnapshot {
  sim2d::Scenario scenario;
  std::map<EntityId, std::string> trees;  // own ones of people
  MapState map;
  bool mapIsInFile = true;  // the cells are those of `map.path`, which is all that is kept then
  QString path;             // of the scenario file; empty: none yet
  bool readOnly = false;
  QDateTime when;
};

/// What a snapshot holds beside the scenario; a folder with it holds one.
constexpr const char* kNotesFile = "recovery.json";

/// The files of a snapshot in a folder: scenario.yaml, tree_<number>.xml, map.yaml, map.pgm and
/// recovery.json.
std::vector<base::FileContent> snapshotFiles(const DocumentSnapshot& snapshot,
                                             const QString& folder);
base::Result<DocumentSnapshot> readSnapshot(const QString& folder);

}  // namespace editor
