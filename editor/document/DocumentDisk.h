#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "bt/human/Templates.h"
#include "bt/human/TreeBehavior.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"
#include "sim2d/map/MapReader.h"

/// What a document knows of its files on the disk, and what saving it writes where. Private to this
/// folder.
namespace editor {

/// The tree file of a person as it was read or written.
struct KnownTree {
  std::string path, content;
  std::optional<bt::TreeStyle> style;  // of the generator that made it; none: someone wrote it
  std::string generated;               // what the generator made of the person then
};

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
  std::set<EntityId> unreadTrees;  // people whose file is there, cannot be read, and so stays
  base::Diagnostics problems;
};

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
  bool readOnly = false;
  bool isBeginning = false;   // of a damaged file
  std::size_t readCount = 0;  // load problems, the first ones, that are of the scenario file itself

  void note(const QString& file, const std::string& content);
  void noteFile(const QString& file);  // as it is now
  /// By the rule of that name, and notes it.
  base::Result<MapState> readMap(const QString& yamlPath, const std::optional<std::string>& rule);
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
/// Of a file; none when it cannot be read.
std::optional<std::string> textAt(const std::string& path);
std::string baseNameOf(const QString& path);
/// Problems that do not keep the scenario from being edited.
base::Diagnostics asWarnings(base::Diagnostics found);

}  // namespace editor
