#pragma once

#include <array>
#include <vector>

#include <QtWidgets>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// The text shown in the list: the message of the check, capitalized unless it starts with a name
/// or a key of the format.
QString issueSentence(const base::Diagnostic& issue);

/// The current problems of the scenario, and those of reading its files. A click selects the
/// affected entity or shows the line of the file; the link at the end of a row applies a fix as one
/// undoable step. Hints are collapsed to their number.
class IssuesPanel : public QWidget {
  Q_OBJECT
 public:
  IssuesPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);

  /// Problems of an action (opening, saving, starting a run), shown above those of the document
  /// until the next action; empty clears them.
  void setActionIssues(const base::Diagnostics& issues);
  int count() const;  // Number of errors and warnings.
  bool hasErrors() const;
  QTableView& table() const { return *table_; }

 Q_SIGNALS:
  void countChanged(int count);
  void entityRequested(editor::EntityId id);          // Requests selecting and showing an entity.
  void fileRequested(const QString& file, int line);  // For problems without an entity.
  void goalsRequested();                              // The person without goals is selected.

 private:
  void makeTable();
  void rebuild();
  void fillRow(int row, const base::Diagnostic& issue, const QString& fix);
  const base::Diagnostic* issueAt(int row) const;  // Null: the row that collapses hints.
  QString fixAt(int row) const;
  void setHintsOpen(bool open);
  void fillFold(int row);
  bool isLink(const QModelIndex& index) const;
  void goToIssue(const base::Diagnostic& issue);
  void applyFix(const base::Diagnostic& issue);
  void offerMenu(const QPoint& at);

  ScenarioDocument& document_;
  Theme theme_;
  std::array<QIcon, 3> icons_;  // By severity.
  base::Diagnostics action_;
  base::Diagnostics issues_;    // As shown, most severe first.
  std::vector<QString> fixes_;  // Label of each fix; empty: no fix.
  bool areHintsOpen_ = false;   // False: a single row shows their number.
  QStackedLayout* stack_;
  QTableWidget* table_;
  QLabel* noIssuesLabel_;
  QTimer fit_;  // Fits row heights once after several changes.
};

}  // namespace editor
