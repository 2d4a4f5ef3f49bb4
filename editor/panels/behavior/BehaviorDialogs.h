#pragma once

#include <vector>

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "editor/panels/behavior/RouteList.h"
#include "editor/panels/behavior/ValueForm.h"
#include "editor/tools/CrowdGenerator.h"

namespace editor {

/// The selected people, or all people of the scenario if none is selected.
std::vector<EntityId> selectedOrAllPeople(const ScenarioDocument& document);

/// Adds an entry for each behaviour of the selected people, and one for a mix of behaviours.
/// `theme` must outlive the menu.
void fillBehaviorMenu(QMenu& menu, ScenarioDocument& document, const Theme& theme, QWidget* parent,
                      bool isEditing = true);

/// Edits the behaviour shares of several people. Each change is applied immediately; the result is
/// one undoable step. Cancel undoes it.
class BehaviorMixDialog : public QDialog {
  Q_OBJECT
 public:
  BehaviorMixDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent);
  void accept() override;
  void reject() override;

 private:
  void apply();
  void showShares();
  void undoMix();

  ScenarioDocument& document_;
  const std::vector<EntityId> people_;
  CrowdRecipe recipe_;
  QLabel* result_;
  bool isTouched_ = false;
  int appliedAt_ = 0;  // Index of the undo stack after the command; 0: not applied.
};

/// Opens the dialog over the window of `parent`; it deletes itself.
void openMixDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent);

/// "Add a block": the ten blocks on the left, description and parameters in the middle, people on
/// the right. One undoable step for all people.
class BlockDialog : public QDialog {
  Q_OBJECT
 public:
  BlockDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
  void accept() override;
  QListWidget& kinds() const { return *kinds_; }

 private:
  void showKind();
  void showBlock() { form_->show(blockRows(block_, document_)); }
  std::vector<EntityId> chosen() const;

  ScenarioDocument& document_;
  const std::vector<EntityId> ids_;  // The listed people.
  HintList *kinds_, *people_;
  QLabel* about_;
  ValueForm* form_;
  bt::Block block_;
  QPushButton* add_ = nullptr;
};

}  // namespace editor
