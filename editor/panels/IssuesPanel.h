#pragma once

#include <array>
#include <vector>

#include <QIcon>
#include <QLabel>
#include <QStackedLayout>
#include <QTableWidget>
#include <QTimer>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// What the list says: the words of the check, which begin with a capital letter unless they begin
/// with a name or a key of the format.
QString issueSentence(const base::Diagnostic& issue);

/// What is wrong with the scenario, live, and what could not be read. A click selects the thing it
/// is about or shows the line of the file; the link at the end of a row mends it, which is one
/// undoable step. Hints are folded to their number.
class IssuesPanel : public QWidget {
  Q_OBJECT
 public:
  IssuesPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);

  /// Problems of an action (opening, saving, starting a run), shown above the document's own until
  /// the next action; empty clears them.
  void setActionIssues(const base::Diagnostics& issues);
  int count() const;  // errors and warnings
  bool hasErrors() const;
  QTableView& table() const { return *table_; }

 Q_SIGNALS:
  void countChanged(int count);
  void entityWanted(editor::EntityId id);          // select it and go there
  void fileWanted(const QString& file, int line);  // when nothing on the map is meant
  void goalsWanted();                              // the person who needs goals is selected

 private:
  void makeTable();
  void rebuild();
  void fillRow(int row, const base::Diagnostic& issue, const QString& fix);
  const base::Diagnostic* issueAt(int row) const;  // null: the row that folds hints
  QString fixAt(int row) const;
  void unfold(bool open);
  void fillFold(int row);
  bool isLink(const QModelIndex& index) const;
  void jump(const base::Diagnostic& issue);
  void mend(const base::Diagnostic& issue);
  void offerMenu(const QPoint& at);

  ScenarioDocument& document_;
  Theme theme_;
  std::array<QIcon, 3> icons_;  // by severity
  base::Diagnostics action_;
  base::Diagnostics issues_;    // as shown, the worst first
  std::vector<QString> fixes_;  // what mends each, in words; empty: nothing does
  bool areHintsOpen_ = false;   // else one row counts them
  QStackedLayout* stack_;
  QTableWidget* table_;
  QLabel* calm_;
  QTimer fit_;  // of the rows to their texts, once for many changes
};

}  // namespace editor
