#include "app/window/files/MapFiles.h"

#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace app {

namespace {

QStringList yamlPatterns() {
  return {QStringLiteral("*.yaml"), QStringLiteral("*.yml")};
}

}  // namespace

bool isSameFile(const QFileInfo& a, const QFileInfo& b) {
  const QString real = a.canonicalFilePath();
  return a.absoluteFilePath() == b.absoluteFilePath() ||
         (!real.isEmpty() && real == b.canonicalFilePath());
}

bool isMapImage(const QString& path) {
  static const QStringList kImages = {QStringLiteral("png"), QStringLiteral("pgm"),
                                      QStringLiteral("bmp"), QStringLiteral("jpg"),
                                      QStringLiteral("jpeg")};
  return kImages.contains(QFileInfo(path).suffix().toLower());
}

bool isMapYaml(const QString& path) {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  const auto has = [&text](const char* words) { return text->find(words) != std::string::npos; };
  return text && (sim2d::parseMapDescription(*text, path.toStdString()) ||
                  (has("image:") && has("resolution:") && !has("ros__parameters")));
}

QString imageOf(const QString& mapYaml) {
  const base::Result<std::string> text = base::readTextFile(mapYaml.toStdString());
  const auto description = text ? sim2d::parseMapDescription(*text, mapYaml.toStdString())
                                : base::Result<sim2d::MapDescription>(text.diagnostics());
  return description ? QFileInfo(mapYaml).dir().filePath(QString::fromStdString(description->image))
                     : QString();
}

QString mapYamlOf(const QString& image) {
  const QFileInfo wanted(image);
  QStringList names = wanted.dir().entryList(yamlPatterns(), QDir::Files, QDir::Name);
  std::stable_partition(names.begin(), names.end(), [&wanted](const QString& name) {
    return QFileInfo(name).completeBaseName() == wanted.completeBaseName();
  });
  for (const QString& name : names) {
    QString path = wanted.dir().filePath(name);
    const QString named = isMapYaml(path) ? imageOf(path) : QString();
    if (!named.isEmpty() && isSameFile(QFileInfo(named), wanted)) {
      return path;
    }
  }
  return {};
}

bool MapFileFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto* files = qobject_cast<QFileSystemModel*>(sourceModel());
  if (files == nullptr) {
    return true;
  }
  const QFileInfo file = files->fileInfo(files->index(row, 0, parent));
  const QString suffix = file.suffix().toLower();
  if (file.isDir() || (suffix != QLatin1String("yaml") && suffix != QLatin1String("yml"))) {
    return true;  // The name filter of the dialog applies to other files.
  }
  const QString key =
      file.absoluteFilePath() + QString::number(file.lastModified().toMSecsSinceEpoch());
  const auto found = known_.constFind(key);
  return found != known_.constEnd() ? *found
                                    : *known_.insert(key, isMapYaml(file.absoluteFilePath()));
}

/// The file system model sorts folders before files.
void MapFileFilter::sort(int column, Qt::SortOrder order) {
  sourceModel()->sort(column, order);
}

}  // namespace app
