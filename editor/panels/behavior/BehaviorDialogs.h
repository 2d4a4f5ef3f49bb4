#pragma once

#include <optional>
#include <string>
#include <utility>

#include <QVBoxLayout>

#include "bt/human/BehaviorBlocks.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/behavior/GoalAssignment.h"
#include "editor/tools/CrowdGenerator.h"

namespace editor {

/// A text value as a row of a form: its editor and its current value.
struct ValueRow {
  enum class Kind { Number, Text, Choice, Choices };  // Choices: a sequence of values.
  Kind kind = Kind::Text;
  std::string key;
  QString label;
  std::string text;
  QString help{};  // Tooltip; for numbers with %1 for the range.
  QString unit{};
  NumberField::Range range{};
  std::optional<std::string> defaultText{};  // Effective if `text` is empty; none: required.
  TextField::Check check{};
  std::vector<std::pair<QString, QString>> choices{};  // Value and label.
  bool isVisible = true;
  /// The replacement that a button behind the field inserts: a blackboard entry for a constant, or
  /// a constant for an entry; empty: no button.
  std::string alternative{};
};

/// The rows of one object.
struct ValueRows {
  QString name;  // Equal for objects with the same kind of rows.
  QString title, note;
  std::vector<ValueRow> rows;
  bool isEditable = true;
};

/// The ports of a node: numbers with unit and range, texts, or "{key}" of the blackboard. An empty
/// text removes the port.
ValueRows portRows(const bt::NodeSpec& node, bool isEditable);
/// The parameters of a behaviour block with units and ranges.
ValueRows blockRows(const bt::Block& block, const ScenarioDocument& document);
/// Sets the value edited in a row.
void setValue(bt::Block& block, const std::string& key, const QString& text);

/// A form for changing objects; its fields are recreated when the next object has other rows.
class ValueForm : public QWidget {
  Q_OBJECT
 public:
  explicit ValueForm(QWidget* parent = nullptr);
  void show(ValueRows what);  // Does not emit `edited`.

 Q_SIGNALS:
  void edited(const std::string& key, const QString& text);

 private:
  QWidget* makeField(const ValueRow& row, std::size_t index);
  QWidget* withToggleButton(QWidget& field, const ValueRow& row);
  void showRow(const ValueRow& row, QWidget* widget);

  QVBoxLayout* layout_;
  FormSection* section_ = nullptr;
  QString shape_;
  std::vector<ValueRow> rows_;
  std::vector<QWidget*> fields_;
};

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
  QLabel* result_ = secondaryLabel({}, this);
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
  QLabel* about_ = secondaryLabel({}, this);
  ValueForm* form_ = new ValueForm(this);
  bt::Block block_;
  QPushButton* add_ = nullptr;
};

}  // namespace editor
