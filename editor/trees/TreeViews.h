#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <QWidget>
#include <QtWidgets>

#include "bt/tree/TreeSpec.h"
#include "editor/canvas/MapScene.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/base/Result.h"

namespace editor {

/// The XML of a tree as in its file, beside the graph. Typed text is applied as soon as it can be
/// parsed; errors are shown below with their line.
class TreeText : public QWidget {
  Q_OBJECT
 public:
  explicit TreeText(const Theme& theme);
  void setTheme(const Theme& theme);
  /// Sets the current text. Typed text that has not been applied is lost only if `text` differs
  /// from the previous one.
  void showText(const std::string& text);
  void showLine(int line);   // From 1; 0 = none.
  void commitPendingEdit();  // Applies the typed text immediately if it can be parsed.
  QPlainTextEdit& text() const { return *text_; }
  QString problem() const { return problem_->text(); }

 Q_SIGNALS:
  void edited(const std::string& xml);  // A parsable file.
  void lineChosen(int line);            // By mouse or arrow keys.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();
  void markLine();
  Theme theme_;
  std::string taken_;  // The current text.
  int line_ = 0;
  bool showing_ = false;
  QTimer pause_;
  QPlainTextEdit* text_ = new QPlainTextEdit(this);
  QLabel* problem_ = new QLabel(this);
  QToolButton* back_;
};

/// The blackboard of the watched person in the shown state. During a run values can be edited: they
/// take effect in the next step and are recorded as inputs, so that the run is reproducible.
class BlackboardView : public QWidget {
  Q_OBJECT
 public:
  BlackboardView(SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  void showPerson(std::optional<int> id);
  QTableWidget& table() const { return *table_; }
  QString words() const { return words_->text(); }  // Shown instead of the table, or below it.

 Q_SIGNALS:
  void messageChanged(const QString& text);

 private:
  void follow();
  QString whyEmpty() const;
  bool isUserSet(const QString& key) const;  // No other source sets the entry.
  void showRow(int row, const std::string& key, const std::string& value);
  void take(int row, int column);

  SimulationRunner& runner_;
  Theme theme_;
  std::optional<int> person_;
  QTableWidget* table_;
  QLabel* words_ = emptyState({}, this);
  QTimer soon_;  // Shows the typed text after the table has finished editing.
  bool showing_ = false;
  /// Edited values that have not taken effect yet, with the step shown at that time.
  std::map<std::string, std::pair<std::string, std::int64_t>> typed_;
};

/// A small read-only map around a person, shown in a corner of the tree view while the map is
/// hidden. It shows the person's motion while the nodes run.
class MapInset : public QWidget {
  Q_OBJECT
 public:
  static constexpr QSize kSize{232, 164};

  MapInset(MapScene& scene, SimulationRunner& runner, QWidget* parent);
  void follow(EntityId person);
  /// Position of the person in the shown state, else at the start; none if there is no person.
  std::optional<Vec2> centre() const;
  QString title() const;  // "Map around Ana"

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintTitle(QPainter& painter) const;

  MapScene& scene_;
  SimulationRunner& runner_;
  EntityId person_;
};

/// All building blocks of a tree, grouped by kind, with a search over names and descriptions: nodes
/// of the catalogue, trees of the file, and behaviour blocks as templates. Rows can be dragged.
class NodePalette : public QWidget {
  Q_OBJECT
 public:
  explicit NodePalette(const Theme& theme);
  void setTheme(const Theme& theme);
  /// The trees that a SubTree of the person may run.
  void showTrees(const QStringList& ids);
  QTreeWidget& list() const { return *list_; }
  QLineEdit& search() const { return *search_; }
  void startSearch();  // Typing replaces the previous text.
  /// XML of the row; empty for headings.
  static QString xmlOf(const QTreeWidgetItem* row);

 Q_SIGNALS:
  void addRequested(const QString& xml);  // Emitted on a double click, or Enter.
  void escaped();                         // By the Escape key in the search field.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addRows();
  QTreeWidgetItem* addGroup(const QString& title);
  void addNode(QTreeWidgetItem& group, const bt::NodeSpec& node, const QString& title,
               const QString& help);
  static void numberByName(QTreeWidgetItem& group);
  QTreeWidgetItem* firstMatch() const;  // Null = none.
  void moveCurrent(bool down);
  void addCurrent();
  void filter();
  void explain();

  Theme theme_;
  SearchField* search_ = new SearchField(tr("Find a node"), tr("Find a node"), this);
  QTreeWidget* list_;
  NoMatchesPlaceholder* nothing_;
  QLabel* help_ = new QLabel(this);  // Shown if there is space.
  QTreeWidgetItem* trees_ = nullptr;
};

}  // namespace editor
