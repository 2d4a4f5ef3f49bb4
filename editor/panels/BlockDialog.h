#pragma once

#include <functional>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "bt/human/Blocks.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/RouteList.h"

namespace editor {

/// The parameters of a block of behaviour, with units and ranges.
class BlockForm : public QWidget {
  Q_OBJECT
 public:
  explicit BlockForm(const ScenarioDocument& document, QWidget* parent = nullptr);
  void show(const bt::Block& block);  // without `edited`
  const bt::Block& block() const { return block_; }

 Q_SIGNALS:
  void edited(const bt::Block& block);

 private:
  void build();
  QWidget* makeField(const bt::BlockParameter& parameter);
  QWidget* makeNumber(const bt::BlockParameter& parameter);
  QWidget* makeChoice(const bt::BlockParameter& parameter);
  void showChoice(ChoiceField& field, const bt::BlockParameter& parameter) const;
  void showPeople(ChoiceField& field, const bt::BlockParameter& parameter) const;
  QWidget* makeText(const bt::BlockParameter& parameter);
  void addRepeat();
  void set(const std::string& key, const std::string& text);
  void refresh();
  std::vector<std::pair<std::string, QString>> choicesOf(const bt::BlockParameter& parameter) const;

  const ScenarioDocument& document_;
  bt::Block block_;
  QVBoxLayout* layout_;
  FormSection* section_ = nullptr;
  std::vector<std::function<void()>> refreshers_;
};

/// "Add a block": the ten blocks at the left, what they do and their numbers in the middle, who
/// gets it at the right. One undoable step for all.
class BlockDialog : public QDialog {
  Q_OBJECT
 public:
  BlockDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
  void accept() override;
  QListWidget& kinds() const { return *kinds_; }
  QListWidget& people() const { return *people_; }
  BlockForm& form() const { return *form_; }

 private:
  void showKind();
  std::vector<EntityId> chosen() const;

  ScenarioDocument& document_;
  HintList *kinds_, *people_;
  QLabel* about_;
  BlockForm* form_;
  QPushButton* add_ = nullptr;
};

}  // namespace editor
