#pragma once

#include <QDialog>
#include <QLabel>
#include <QMenu>

#include "editor/look/Theme.h"
#include "editor/tools/Crowd.h"

namespace editor {

/// The people who are selected; everybody of the scenario when none is.
std::vector<EntityId> peopleMeant(const ScenarioDocument& document);

/// An entry for each behaviour, for the people that are selected, and at last one for a mix of
/// them. `theme` has to outlive the menu.
void fillBehaviorMenu(QMenu& menu, ScenarioDocument& document, const Theme& theme, QWidget* parent,
                      bool isEditing = true);

/// Shares of the behaviours for several people. They have the mix with each change and at the end,
/// as one undoable step; Cancel takes it back.
class MixDialog : public QDialog {
  Q_OBJECT
 public:
  MixDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent);
  void accept() override;
  void reject() override;

 private:
  void apply();
  void showShares();
  void takeBack();

  ScenarioDocument& document_;
  const std::vector<EntityId> people_;
  CrowdRecipe recipe_;
  QLabel* result_;
  bool isTouched_ = false;
  int appliedAt_ = 0;  // index of the undo stack behind its command; 0: there is none
};

/// Opens the dialog over the window of `parent`; it deletes itself.
void openMix(ScenarioDocument& document, const Theme& theme, QWidget* parent);

}  // namespace editor
