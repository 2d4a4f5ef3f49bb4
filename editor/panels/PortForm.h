#pragma once

#include <functional>
#include <vector>

#include <QVBoxLayout>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "editor/look/Form.h"

namespace editor {

/// The ports of one node: numbers with unit and range, words, or "{key}" of the blackboard.
class PortForm : public QWidget {
  Q_OBJECT
 public:
  explicit PortForm(QWidget* parent = nullptr);
  void show(const bt::NodeSpec& node, bool editable);
  void clear();

 Q_SIGNALS:
  void edited(const QString& port, const QString& text);  // an empty text leaves the port out

 private:
  QWidget* makeField(const bt::PortSpec& port, const std::string& text);
  QString shape(const bt::NodeSpec& node, bool editable) const;

  QVBoxLayout* layout_;
  FormSection* section_ = nullptr;
  QString shape_;
  std::vector<std::function<void(const bt::NodeSpec&)>> refreshers_;
};

}  // namespace editor
