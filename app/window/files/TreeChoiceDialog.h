#pragma once

#include <optional>
#include <vector>

#include <QtWidgets>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace app {

class DiffView;

/// Asks before saving replaces manually edited trees: keep, replace, show differences. Closing the
/// dialog cancels saving.
class TreeChoiceDialog : public QDialog {
  Q_OBJECT
 public:
  TreeChoiceDialog(std::vector<editor::TreeConflict> questions, const editor::Theme& theme,
                   QWidget* parent = nullptr);
  const editor::TreeReplacements& replaced() const { return replaced_; }
  void choose(int question, bool isReplaced);
  void showDifferences(bool on);
  void moveOnScreen(const QPoint& corner);

  /// Nothing: cancelled.
  static std::optional<editor::TreeReplacements> ask(std::vector<editor::TreeConflict> questions,
                                                     const editor::Theme& theme, QWidget* parent);

 private:
  void build();
  void showQuestion(int index);
  void take(bool isReplaced);
  void updateRow(int index);

  std::vector<editor::TreeConflict> questions_;
  editor::TreeReplacements replaced_;
  editor::Theme theme_;
  QListWidget* list_;
  QLabel* why_;
  QRadioButton* keep_;
  QRadioButton* replace_;
  QCheckBox* all_;
  QToolButton* differences_;
  QLabel* legend_;
  DiffView* diff_;
};

}  // namespace app
