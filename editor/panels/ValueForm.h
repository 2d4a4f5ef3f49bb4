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
};

/// Rows for one thing after another; made anew when the next one has others.
class ValueForm : public QWidget {
 public:
  explicit ValueForm(QWidget* parent);

 protected:
  /// `name`: the same for things whose rows are of the same meaning.
  void showRows(const QString& name, const QString& title, const QString& note, bool isEditable,
                std::vector<ValueRow> rows);
  virtual void take(const std::string& key, const QString& text) = 0;

 private:
  QWidget* makeField(const ValueRow& row, std::size_t index);
  void showRow(const ValueRow& row, QWidget* widget);

  QVBoxLayout* layout_;
  FormSection* section_ = nullptr;
  QString shape_;
  std::vector<ValueRow> rows_;
  std::vector<QWidget*> fields_;
};

/// The ports of one node: numbers with unit and range, words, or "{key}" of the blackboard.
class PortForm : public ValueForm {
  Q_OBJECT
 public:
  PortForm() : ValueForm(nullptr) {}
  void show(const bt::NodeSpec& node, bool editable);

 Q_SIGNALS:
  void edited(const QString& port, const QString& text);  // an empty text leaves the port out

 protected:
  void take(const std::string& key, const QString& text) override;
};

/// The parameters of a block of behaviour, with units and ranges.
class BlockForm : public ValueForm {
  Q_OBJECT
 public:
  explicit BlockForm(const ScenarioDocument& document, QWidget* parent = nullptr)
      : ValueForm(parent), document_(document) {}
  void show(const bt::Block& block);  // without `edited`
  const bt::Block& block() const { return block_; }

 Q_SIGNALS:
  void edited(const bt::Block& block);

 protected:
  void take(const std::string& key, const QString& text) override;

 private:
  ValueRow rowOf(const bt::BlockParameter& parameter) const;

  const ScenarioDocument& document_;
  bt::Block block_;
};

}  // namespace editor
