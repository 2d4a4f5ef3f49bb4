#pragma once

#include <array>
#include <vector>

#include <QtWidgets>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Form.h"
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
  /// until the next action or edit; empty clears them.
  void setActionIssues(const base::Diagnostics& issues);
  /// While a recorded run is shown, which cannot be edited, only problems of actions are listed.
  void setRecorded(bool recorded);
  int count() const;  // Number of errors and warnings.
  bool hasErrors() const;
  QTableView& table() const { return *table_; }

 Q_SIGNALS:
  void countChanged(int count);
  void entityRequested(editor::EntityId id);  // Requests selecting and showing an entity.
  void treeIssueRequested(const base::Diagnostic& issue);  // Of the tree of a person.
  void fileRequested(const QString& file, int line);       // For problems without an entity.
  void goalsRequested();                                   // The person without goals is selected.

 private:
  void makeTable();
  void rebuild();
  base::Diagnostics currentIssues();
  QString noIssuesText() const;
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
  bool isRecorded_ = false;
  base::Diagnostics action_;
  base::Diagnostics issues_;    // As shown, most severe first.
  std::vector<QString> fixes_;  // Label of each fix; empty: no fix.
  bool areHintsOpen_ = false;   // False: a single row shows their number.
  QStackedLayout* stack_ = new QStackedLayout(this);
  QTableWidget* table_;
  QLabel* noIssuesLabel_ = emptyState(tr("No issues."), this);
  QTimer fit_;  // Fits row heights once after several changes.
};

/// Highlights a line of a text, from 1, like a selected list row; 0: none.
void markLine(QPlainTextEdit& text, int line, const Theme& theme);

/// Shows a text file at a line, read-only, with line numbers: for problems without an entity on the
/// map. A single window that is reused.
class TextViewer : public QDialog {
  Q_OBJECT
 public:
  explicit TextViewer(const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// `line` from 1; 0 = the beginning. Returns an error message, or an empty text.
  QString showFile(const QString& path, int line);
  QPlainTextEdit& text() const { return *text_; }
  QString path() const { return path_; }
  int line() const { return line_; }

 private:
  void openOutside();
  void markLine();
  Theme theme_;
  QString path_;
  int line_ = 0;
  QLabel* place_ = new QLabel(this);
  QPlainTextEdit* text_;
};

}  // namespace editor
