#pragma once

#include <vector>

#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "editor/look/Theme.h"
#include "editor/panels/RouteList.h"
#include "editor/panels/ValueForm.h"

namespace editor {

/// "Add a block": the ten blocks at the left, what they do and their numbers in the middle, who
/// gets it at the right. One undoable step for all.
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
  const std::vector<EntityId> ids_;  // of the people that are listed
  HintList *kinds_, *people_;
  QLabel* about_;
  ValueForm* form_;
  bt::Block block_;
  QPushButton* add_ = nullptr;
};

}  // namespace editor
