#pragma once

#include "bt/human/TreeBehavior.h"
#include "bt/human/TreeGenerator.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"
#include "sim2d/map/MapReader.h"

/// The state of a document's files on disk, and the plan of a save. Private to this folder.
namespace editor {

/// The tree file of a person as last read or written.
struct TreeFileState {
  std::string path, content;
  std::optional<bt::TreeStyle> style;  // Of the generator; none: hand-written tree.
  std::string generated;               // Generated tree of the person at that time.
};

/// A tree to be written by a save.
struct PlannedTree {
  EntityId human;
  std::string path, content;
};

/// Everything that a save writes. Making a plan changes nothing on disk.
struct SavePlan {
  QString path;  // Path of the scenario file.
  sim2d::Scenario scenario;
  QString mapPath;
  std::vector<base::FileContent> mapFiles;
  std::vector<PlannedTree> trees;
  std::set<EntityId> unreadableTrees;  // People whose tree file is unreadable and is kept.
  base::Diagnostics problems;
};

struct DocumentDiskState {
  std::map<EntityId, TreeFileState> trees;
  std::set<EntityId> unreadableTrees;     // People whose tree file could not be read.
  std::map<EntityId, std::string> bases;  // Generated trees when custom ones were written.
  std::map<QString, QByteArray> hashes;   // Hashes of all files, by absolute path.
  std::map<QString, std::shared_ptr<const sim2d::OccupancyGrid>> maps;  // By path of the YAML file.
  QString mapImage;
  std::optional<std::string> mapFile;  // Name when the scenario was read; an edited one is saved
                                       // but used only when the scenario is opened again.
  std::map<EntityId, int> lines;       // Line of each entity in the scenario file.
  bool readOnly = false;
  bool isBeginning = false;  // The file is damaged and only its beginning was read.
  std::size_t readProblemCount =
      0;  // Number of leading load problems that concern the scenario file.

  void note(const QString& file, const std::string& content);
  void recordFile(const QString& file);  // Stores the hash of the current content.
  /// Reads a map by the rule `rule` for map names, and stores its hashes.
  base::Result<MapState> readMap(const QString& yamlPath, const std::optional<std::string>& rule);
  const TreeFileState* known(EntityId human) const {
    const auto found = trees.find(human);
    return found == trees.end() ? nullptr : &found->second;
  }
  bool holds(const MapState& map) const;  // Returns true if the cells equal those of the file.
  /// Returns true if the user has changed the map file in the settings.
  bool isMapFileChanged(const sim2d::Scenario& scenario) const {
    return scenario.desktop.mapFile && scenario.desktop.mapFile != mapFile;
  }
  void recordMapFiles(const SavePlan& plan, const DocumentDiskState& before);
  void recordTree(const PlannedTree& written, bool isCustom, std::string generated,
                  const TreeFileState* before);
};

/// Line of each entity of a document in a file with the same content; the keys of the entities may
/// differ.
std::map<EntityId, int> linesOf(const sim2d::Scenario& scenario,
                                const sim2d::ScenarioReading& reading);

/// Hash of the content of a file; empty if the file cannot be read.
QByteArray hashOfFile(const QString& file);

// Helper functions for files.
/// The text of a file; none if it cannot be read.
std::optional<std::string> textAt(const std::string& path);
std::string baseNameOf(const QString& path);
/// Downgrades errors to warnings, for problems that do not prevent editing the scenario.
base::Diagnostics downgradedToWarnings(base::Diagnostics found);

}  // namespace editor
