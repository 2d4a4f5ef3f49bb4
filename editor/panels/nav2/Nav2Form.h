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

constexpr int kNav2ParameterRole = Qt::UserRole + 7;  // Of column 0.

/// Columns of the table of Nav2 parameters.
enum Nav2Column {
  Nav2NameColumn,
  Nav2ValueColumn,    // In effect; the only one that can be edited.
  Nav2FileColumn,     // In the robot's parameter file.
  Nav2DefaultColumn,  // In Nav2's code.
  Nav2HelpColumn,
  Nav2Columns
};

/// The parameters of a robot's `nav2_params.yaml` by their original names, with a tab per server
/// and grouped by plugin: searchable by name and help, edited in place, validated while typing,
/// with the value in the file, the default and the description in the same row. Values that the
/// scenario overrides are marked and can be reset individually.
class Nav2Form : public QWidget {
  Q_OBJECT
 public:
  explicit Nav2Form(QWidget* parent = nullptr);
  ~Nav2Form() override;
  Q_DISABLE_COPY_MOVE(Nav2Form)

  void setTheme(const Theme& theme);
  /// None: no robot with Nav2. `inRun`: the robot in the shown run, if there is one; values that
  /// differ from it are marked, because they apply at the next start.
  void show(const std::optional<sim2d::Robot>& robot, const QString& scenarioPath,
            const std::optional<sim2d::Robot>& inRun = std::nullopt);

  int changedCount() const;  // Number of overridden parameters.
  QString file() const { return QString::fromStdString(sheet_.file); }
  QTreeWidget& tree() const { return *tree_; }
  QTabBar& servers() const { return *tabs_; }
  QHBoxLayout& head() const { return *head_; }  // The row with the search field.
  /// The parameter whose index a row stores as `kNav2ParameterRole`; null: a node or plugin.
  const app::Nav2Parameter* parameterOf(const QVariant& number) const;
  QTreeWidgetItem* rowOf(const std::string& path) const;  // "FollowPath.temperature"; null: none.
  /// The reason why a value is invalid; empty: valid.
  QString problemOf(const app::Nav2Parameter& parameter, const QString& text) const;
  /// Sets a value edited in a row.
  void applyEdit(const app::Nav2Parameter& parameter, const QString& text);

 Q_SIGNALS:
  /// A new value, or none for that of the file.
  void edited(const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void styleTree();
  void build();
  void buildTabs();
  void showValues();
  void showRow(std::size_t index);
  bool isPending(const app::Nav2Parameter& parameter) const;
  void showTabs();
  void filter();
  QWidget* makeUnchanged();
  bool isShown(const app::Nav2Parameter& parameter) const;
  void showHelp();
  void resetRow();
  const app::Nav2Parameter* current() const;
  QTreeWidgetItem* groupOf(const app::Nav2Parameter& parameter);

  QHBoxLayout* head_ = new QHBoxLayout;
  SearchField* search_ = new SearchField(tr("Find a parameter"), tr("Find a Nav2 parameter"), this);
  QToolButton *onlyChanged_, *reset_;
  QTabBar* tabs_ = new QTabBar(this);
  QTreeWidget* tree_ = new QTreeWidget(this);
  QLabel* help_;
  NoMatchesPlaceholder* nothing_;
  QLabel* unchangedText_ = emptyState({}, this);
  QWidget* unchanged_;  // Shown instead of the list if no changed value matches.
  QColor accent_, secondary_, mark_;
  std::optional<sim2d::Robot> robot_;
  QString scenarioPath_;
  app::Nav2ParameterList sheet_;
  std::optional<std::map<std::string, std::string>> runValues_;  // By path; none: no run.
  std::map<std::string, QTreeWidgetItem*> groups_;               // By node, and by node and plugin.
  std::vector<QTreeWidgetItem*> rows_;                           // Parallel to sheet_.parameters.
};

}  // namespace editor
