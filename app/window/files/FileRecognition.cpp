#include <QtWidgets>

#include "app/report/StudyOutput.h"
#include "app/run/FileKind.h"
#include "app/window/files/FileCommands.h"
#include "app/window/files/MapFiles.h"
#include "app/window/study/StudyProcess.h"
#include "sim2d/base/Text.h"

namespace app {

/// Whether the name is that of third-party trajectories: no scenario, map or tree has it.
bool FileCommands::isTracks(const QString& path) {
  static const QStringList kTracks = {QStringLiteral("csv"),    QStringLiteral("txt"),
                                      QStringLiteral("tsv"),    QStringLiteral("h5"),
                                      QStringLiteral("hdf5"),   QStringLiteral("sqlite"),
                                      QStringLiteral("ndjson"), QStringLiteral("json")};
  return kTracks.contains(QFileInfo(path).suffix().toLower());
}

/// Detects the kind by content; for images, trajectories and the header of a recorded run by file
/// name.
FileCommands::Kind FileCommands::kindOf(const QString& path) const {
  const QFileInfo file(path);
  if (report::studyOutputFile(path.toStdString())) {
    return Kind::StudyResults;
  }
  if (file.isDir() && isBatchFolder(path)) {
    return Kind::Batch;
  }
  if (file.isDir() || file.fileName() == QLatin1String("trace.json")) {
    return Kind::Run;
  }
  if (file.suffix().toLower() == QLatin1String("hnv")) {
    return Kind::Capsule;
  }
  if (isMapImage(path)) {
    return Kind::Image;
  }
  if (isTracks(path)) {
    return Kind::Tracks;
  }
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  if (!text) {
    return Kind::Scenario;  // whose reader reports the error
  }
  switch (fileKindOf(*text)) {
    case FileKind::Tree:
      return Kind::Tree;
    case FileKind::NavigatorTree:
    case FileKind::Nav2:
      return Kind::Nav2;
    case FileKind::Map:
      return Kind::Map;
    case FileKind::Experiment:
      return Kind::Experiment;
    case FileKind::Scenario:
      break;
  }
  return Kind::Scenario;
}

}  // namespace app
