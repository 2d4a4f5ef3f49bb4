#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QVBoxLayout>

#include "bt/human/Blocks.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"

namespace editor {

/// A value that is kept as text, as a row of a form: how it is edited and what it is now.
struct ValueRow {
  enum class Kind { Number, Text, Choice, Choices };  // Choices: several, one after the other
  Kind kind = Kind::Text;
  std::string key;
  QString label;
  std::string text;
  QString help{};  // its tooltip; of a number with %1 for the range
  QString unit{};
  NumberField::Range range{};
  std::optional<std::string> usual{};  // counts while there is no text; none: there is always one
  TextField::Check check{};
  std::vector<std::pair<QString, QString>> choices{};  // value and words
  bool isVisible = true;
  /// What a button behind the field puts in its place: an entry of the blackboard for a constant, a
  /// constant for an entry; empty: there is none.
  std::string instead{};
};

/// Rows for one thing.
struct ValueRows {
  QString name;  // the same for things whose rows are of the same meaning
  QString title, note;
  std::vector<ValueRow> rows;
  bool isEditable = true;
};

/// The ports of one node: numbers with unit and range, words, or "{key}" of the blackboard. An
/// empty text leaves the port out.
ValueRows portRows(const bt::NodeSpec& node, bool isEditable);
/// The parameters of a block of behaviour, with units and ranges.
ValueRows blockRows(const bt::Block& block, const ScenarioDocument& document);
/// What was edited in such a row.
void setValue(bt::Block& block, const std::string& key, const QString& text);

/// Shows one thing after another; its fields are made anew when the next one has others.
class ValueForm : public QWidget {
  Q_OBJECT
 public:
  explicit ValueForm(QWidget* parent = nullptr);
  void show(ValueRows what);  // without `edited`

 Q_SIGNALS:
  void edited(const std::string& key, const QString& text);

 private:
  QWidget* makeField(const ValueRow& row, std::size_t index);
  QWidget* withSwitch(QWidget& field, const ValueRow& row);
  void showRow(const ValueRow& row, QWidget* widget);

  QVBoxLayout* layout_;
  FormSection* section_ = nullptr;
  QString shape_;
  std::vector<ValueRow> rows_;
  std::vector<QWidget*> fields_;
};

}  // namespace editor
