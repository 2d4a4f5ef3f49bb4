#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QtWidgets>

#include "app/run/Nav2Robots.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

constexpr int kParameterRole = Qt::UserRole + 7;  // Of column 0.

/// The parameters of a robot's `nav2_params.yaml` by their original names, grouped by node and
/// plugin: searchable by name and help, edited in place, validated while typing. Values that the
/// scenario overrides are marked and can be reset individually.
class Nav2Form : public QWidget {
  Q_OBJECT
 public:
  explicit Nav2Form(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// None: several robots, or no robot with Nav2.
  void show(const std::optional<sim2d::Robot>& robot, const QString& scenarioPath);

  int changedCount() const;  // Number of overridden parameters.
  QTreeWidget& tree() const { return *tree_; }
  /// The parameter whose index a row stores as `kParameterRole`; null: a node or plugin.
  const app::Nav2Parameter* parameterOf(const QVariant& number) const;
  QTreeWidgetItem* rowOf(const std::string& path) const;  // "FollowPath.temperature"; null: none.
  /// The reason why a value is invalid; empty: valid.
  QString problemOf(const app::Nav2Parameter& parameter, const QString& text) const;
  /// Sets a value edited in a row.
  void applyEdit(const app::Nav2Parameter& parameter, const QString& text);

 Q_SIGNALS:
  /// A new value, or none for that of the file.
  void edited(const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml);

 private:
  void build();
  void showValues();
  void filter();
  void showHelp();
  void resetRow();
  const app::Nav2Parameter* current() const;
  QTreeWidgetItem* groupOf(const app::Nav2Parameter& parameter);

  SearchField* search_;
  QToolButton *onlyChanged_, *reset_;
  QTreeWidget* tree_;
  QLabel* help_;
  NoMatchesPlaceholder* nothing_;
  QColor accent_, secondary_;
  std::optional<sim2d::Robot> robot_;
  QString scenarioPath_;
  app::Nav2ParameterList sheet_;
  std::map<std::string, QTreeWidgetItem*> groups_;  // By node, and by node and plugin.
  std::vector<QTreeWidgetItem*> rows_;              // Parallel to sheet_.parameters.
};

}  // namespace editor
