#pragma once

#include <optional>
#include <vector>

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QListWidget>
#include <QRadioButton>
#include <QToolButton>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace app {

class DiffView;

/// Asks before saving replaces trees that somebody wrote by hand: keep, take the other one, and
/// what the difference is. Closing it means not to save.
class TreeChoiceDialog : public QDialog {
  Q_OBJECT
 public:
  TreeChoiceDialog(std::vector<editor::TreeQuestion> questions, const editor::Theme& theme,
                   QWidget* parent = nullptr);
  const editor::TreesToReplace& replaced() const { return replaced_; }
  void choose(int question, bool isReplaced);
  void showDifferences(bool on);
  void moveOnScreen(const QPoint& corner);

  /// Nothing when cancelled.
  static std::optional<editor::TreesToReplace> ask(std::vector<editor::TreeQuestion> questions,
                                                   const editor::Theme& theme, QWidget* parent);

 private:
  void build();
  void showQuestion(int index);
  void take(bool isReplaced);
  void updateRow(int index);

  std::vector<editor::TreeQuestion> questions_;
  editor::TreesToReplace replaced_;
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
