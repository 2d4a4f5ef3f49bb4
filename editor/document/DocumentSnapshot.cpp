#include "editor/document/DocumentSnapshot.h"

#include <algorithm>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "editor/document/DocumentDisk.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace editor {

namespace {

constexpr const char* kScenarioFile = "scenario.yaml";
constexpr const char* kMapFile = "map.yaml";

std::string in(const QString& folder, const QString& name) {
  return QDir(folder).filePath(name).toStdString();
}

std::string in(const QString& folder, const char* name) {
  return in(folder, QString::fromLatin1(name));
}

QString treeFile(int number) {
  return QStringLiteral("tree_%1.xml").arg(number);
}

/// In the order in which a file holds them.
std::vector<const sim2d::Human*> inFileOrder(const sim2d::Scenario& scenario) {
  std::vector<const sim2d::Human*> people;
  for (const sim2d::Human& human : scenario.humans) {
    people.push_back(&human);
  }
  std::stable_partition(people.begin(), people.end(),
                        [](const sim2d::Human* human) { return human->listed; });
  return people;
}

base::Result<MapState> readMapOf(const QString& folder, const QJsonObject& notes) {
  MapState state;
  state.grid = std::make_shared<sim2d::OccupancyGrid>();
  state.path = notes[QStringLiteral("map_path")].toString();
  state.isMissing = notes[QStringLiteral("map_is_missing")].toBool();
  if (notes[QStringLiteral("map_is_in_file")].toBool(true)) {
    return state;
  }
  base::Result<sim2d::MapFile> map = sim2d::readMap(in(folder, kMapFile), {});
  if (!map) {
    return map.diagnostics();
  }
  state.grid = std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid));
  return state;
}

}  // namespace

std::vector<base::FileContent> snapshotFiles(const DocumentSnapshot& snapshot,
                                             const QString& folder) {
  std::vector<base::FileContent> files = {
      {in(folder, kScenarioFile), sim2d::writeScenario(snapshot.scenario)}};
  QJsonArray trees;
  int number = 0;
  for (const sim2d::Human* human : inFileOrder(snapshot.scenario)) {
    const auto tree = snapshot.trees.find(human->key);
    if (tree != snapshot.trees.end()) {
      files.push_back({in(folder, treeFile(number)), tree->second});
      trees.append(number);
    }
    ++number;
  }
  if (!snapshot.mapIsInFile) {
    if (auto map = sim2d::mapFileContents(*snapshot.map.grid, in(folder, kMapFile))) {
      files.insert(files.end(), map->begin(), map->end());
    }
  }
  const QJsonObject notes = {{QStringLiteral("path"), snapshot.path},
                             {QStringLiteral("map_path"), snapshot.map.path},
                             {QStringLiteral("map_is_in_file"), snapshot.mapIsInFile},
                             {QStringLiteral("map_is_missing"), snapshot.map.isMissing},
                             {QStringLiteral("read_only"), snapshot.readOnly},
                             {QStringLiteral("trees"), trees},
                             {QStringLiteral("when"), snapshot.when.toString(Qt::ISODateWithMs)}};
  files.push_back({in(folder, kNotesFile), QJsonDocument(notes).toJson().toStdString()});
  return files;
}

base::Result<DocumentSnapshot> readSnapshot(const QString& folder) {
  const base::Result<std::string> text = base::readTextFile(in(folder, kNotesFile));
  if (!text) {
    return text.diagnostics();
  }
  const QJsonObject notes = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  sim2d::ScenarioReading reading = sim2d::readScenario(in(folder, kScenarioFile));
  base::Result<MapState> map = readMapOf(folder, notes);
  base::Diagnostics problems = map.diagnostics();
  if (!map) {
    return problems;
  }
  for (const base::Diagnostic& found : reading.diagnostics) {
    if (found.severity == base::Severity::Error) {  // else it is about a file that nobody has
      base::append(problems, asWarnings({found}));
    }
  }
  DocumentSnapshot result;
  result.scenario = std::move(reading.scenario);
  result.map = *std::move(map);
  result.mapIsInFile = notes[QStringLiteral("map_is_in_file")].toBool(true);
  result.path = notes[QStringLiteral("path")].toString();
  result.readOnly = notes[QStringLiteral("read_only")].toBool();
  result.when = QDateTime::fromString(notes[QStringLiteral("when")].toString(), Qt::ISODateWithMs);
  for (const QJsonValue& value : notes[QStringLiteral("trees")].toArray()) {
    const int number = value.toInt(-1);
    base::Result<std::string> tree = base::readTextFile(in(folder, treeFile(number)));
    if (!tree || number < 0 || number >= static_cast<int>(result.scenario.humans.size())) {
      base::append(problems, tree.diagnostics());
      continue;
    }
    result.trees[result.scenario.humans[static_cast<std::size_t>(number)].key] = *std::move(tree);
  }
  return {std::move(result), std::move(problems)};
}

}  // namespace editor
