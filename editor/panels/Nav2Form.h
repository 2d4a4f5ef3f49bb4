#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeWidget>

#include "app/run/Nav2Robots.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

constexpr int kParameterRole = Qt::UserRole + 7;  // of column 0

/// The parameters of a robot's `nav2_params.yaml` by their own names, below node and plugin: found
/// by name or help, edited in place, checked while they are typed. What the scenario gives instead
/// of the file is marked, and taken back one by one.
class Nav2Form : public QWidget {
  Q_OBJECT
 public:
  explicit Nav2Form(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// None: several robots, or none with Nav2.
  void show(const std::optional<sim2d::Robot>& robot, const QString& scenarioPath);

  int changedCount() const;  // of parameters
  QTreeWidget& tree() const { return *tree_; }
  /// Whose number a row has as `kParameterRole`; null: a node or plugin.
  const app::Nav2Parameter* parameterOf(const QVariant& number) const;
  QTreeWidgetItem* rowOf(const std::string& path) const;  // "FollowPath.temperature"; null: none
  /// What is wrong with such a value; empty: nothing.
  QString problemOf(const app::Nav2Parameter& parameter, const QString& text) const;
  /// Edited in a row.
  void give(const app::Nav2Parameter& parameter, const QString& text);

 Q_SIGNALS:
  /// Another value, or none: that of the file.
  void edited(const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml);

 private:
  void build();
  void showValues();
  void filter();
  void showHelp();
  void resetRow();
  const app::Nav2Parameter* current() const;
  QTreeWidgetItem* groupOf(const app::Nav2Parameter& parameter);

  QLineEdit* search_;
  QAction* searchMark_;
  QToolButton *onlyChanged_, *reset_;
  QTreeWidget* tree_;
  QLabel* help_;
  NothingFound* nothing_;
  QColor accent_, secondary_;
  std::optional<sim2d::Robot> robot_;
  QString scenarioPath_;
  app::Nav2Sheet sheet_;
  std::map<std::string, QTreeWidgetItem*> groups_;  // by node, and node and plugin
  std::vector<QTreeWidgetItem*> rows_;              // beside sheet_.parameters
};

}  // namespace editor
