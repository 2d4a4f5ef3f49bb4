#pragma once

#include <functional>
#include <vector>

#include <QVBoxLayout>

#include "bt/human/Blocks.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"

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
  QWidget* makePeople(const bt::BlockParameter& parameter);
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

}  // namespace editor
