#include "editor/tools/OptionsRow.h"

#include <QComboBox>

#include "editor/look/Form.h"

namespace editor {

OptionsRow::OptionsRow(QWidget* parent) : QWidget(parent), layout_(new QHBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(8);
}

void OptionsRow::add(const QString& label, QWidget* field) {
  if (layout_->count() > 0) {
    layout_->addSpacing(8);
  }
  layout_->addWidget(secondaryLabel(label, this));
  add(field);
}

void OptionsRow::add(QWidget* field) {
  if (auto* box = qobject_cast<QComboBox*>(field)) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // there is no column to keep to
  }
  layout_->addWidget(field);
}

}  // namespace editor
