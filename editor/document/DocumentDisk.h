#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QByteArray>
#include <QString>

#include "bt/human/Templates.h"
#include "bt/human/TreeBehavior.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/scenario/ScenarioCheck.h"

/// What a document knows of its files on the disk. Private to this folder.
namespace editor {

/// The tree file of a person as it was read or written.
struct KnownTree {
  std::string path, content;
  std::optional<bt::TreeStyle> style;  // of the generator that made it; none: someone wrote it
  std::string generated;               // what the generator made of the person then
};

struct PlannedTree;
struct SavePlan;

struct DocumentDisk {
  std::map<EntityId, KnownTree> trees;
  std::set<EntityId> unreadTrees;         // people whose tree file could not be read
  std::map<EntityId, std::string> bases;  // what the generator made when an own tree was written
  std::map<QString, QByteArray> hashes;   // of all files, by absolute path
  std::map<QString, std::shared_ptr<const sim2d::OccupancyGrid>> maps;  // by path of the YAML
  QString mapImage;
  std::optional<std::string> mapFile;  // of the scenario when it was read: an edited one counts
                                       // from the next opening and is saved as it is
  std::map<EntityId, int> lines;       // of entities in the scenario file
  std::string mapOption, treesOption;
  bool readOnly = false;
  bool isBeginning = false;   // of a damaged file
  std::size_t readCount = 0;  // load problems, the first ones, that are of the scenario file itself

  sim2d::FilePlaces places(const QString& scenario, const QString& shippedMaps) const {
    return {scenario.toStdString(), mapOption, treesOption, shippedMaps.toStdString()};
  }
  void note(const QString& file, const std::string& content);
  void noteFile(const QString& file);  // as it is now
  void forgetFiles();                  // of the document before
  const KnownTree* known(EntityId human) const;
  bool holds(const MapState& map) const;  // the cells are those of its file
  /// Somebody has written the name of another file into the settings.
  bool isOtherMapWanted(const sim2d::Scenario& scenario) const;
  void noteMapFiles(const SavePlan& plan, const DocumentDisk& before);
  void noteTree(const PlannedTree& written, bool isOwn, std::string generated,
                const KnownTree* before);
};

/// Where the entities of a document stand in a file that holds it; the two may differ in keys.
std::map<EntityId, int> linesOf(const sim2d::Scenario& scenario,
                                const sim2d::ScenarioReading& reading);

/// Hash of a file's content; empty when it cannot be read.
QByteArray hashOfFile(const QString& file);

// Helpers of the functions on files.
std::string baseNameOf(const QString& path);
std::string relativeTo(const QString& scenarioPath, const QString& file);
/// Problems that do not keep the scenario from being edited.
base::Diagnostics asWarnings(base::Diagnostics found);
/// Paths relative to the old scenario file stay right beside the new one.
void moveRelativePaths(sim2d::Scenario& scenario, const QString& from, const QString& to);

}  // namespace editor
