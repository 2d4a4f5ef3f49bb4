#pragma once

#include <QtWidgets>

namespace app {

/// Whether both are the same file, also through links. The files need not exist.
bool isSameFile(const QFileInfo& a, const QFileInfo& b);
/// Whether the file name is that of an image that can be a map.
bool isMapImage(const QString& path);
/// Whether the file is a YAML file of a map, even a damaged one.
bool isMapYaml(const QString& path);
/// The path of the image that the YAML file of a map names; empty if the file cannot be read.
QString imageOf(const QString& mapYaml);
/// The YAML file that names this image, in the folder of the image; the one with the name of the
/// image takes precedence. Empty: none.
QString mapYamlOf(const QString& image);

/// Limits the list of a file dialog to folders, images and YAML files of maps: scenarios have the
/// same ending.
class MapFileFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit MapFileFilter(QObject* parent = nullptr) : QSortFilterProxyModel(parent) {}
  void sort(int column, Qt::SortOrder order) override;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  mutable QHash<QString, bool> known_;  // Whether a YAML file is a map, by path and time.
};

}  // namespace app
