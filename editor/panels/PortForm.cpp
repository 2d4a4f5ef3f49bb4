#include "editor/panels/PortForm.h"

#include "bt/tree/TextValue.h"
#include "editor/document/TreeFiles.h"
#include "editor/look/Fields.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

QString textOf(const bt::NodeSpec& node, const std::string& port) {
  const std::string* text = bt::findText(node.ports, port);
  return text == nullptr ? QString() : QString::fromStdString(*text);
}

bool isNumber(const bt::PortSpec& port) {
  return port.type == bt::PortType::Double || port.type == bt::PortType::Int ||
         port.type == bt::PortType::Unsigned;
}

/// What a port without a text shows, and whether a constant can be shown as a number.
bool takesNumber(const bt::PortSpec& port, const std::string& text) {
  const std::string shown = text.empty() ? port.defaultText.value_or("") : text;
  return isNumber(port) && base::parseDouble(shown).has_value();
}

NumberField::Range rangeOf(const bt::PortSpec& port) {
  const bool whole = port.type != bt::PortType::Double;
  return {port.min.value_or(whole ? -1000000.0 : -10000.0), port.max.value_or(1000000.0),
          whole ? 0 : 2, whole ? 1.0 : 0.1};
}

}  // namespace

PortForm::PortForm(QWidget* parent) : QWidget(parent), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
}

void PortForm::clear() {
  if (section_ != nullptr) {
    section_->hide();
    section_->deleteLater();
    section_ = nullptr;
  }
  refreshers_.clear();
  shape_.clear();
}

/// Two nodes of one shape are shown by the same fields.
QString PortForm::shape(const bt::NodeSpec& node, bool editable) const {
  QString shape = QString::fromStdString(node.id) + (editable ? QStringLiteral("+") : QString());
  if (const bt::NodeManifest* manifest = treeCatalogue().find(node.id)) {
    for (const bt::PortSpec& port : manifest->ports) {
      shape += takesNumber(port, textOf(node, port.name).toStdString()) ? QLatin1Char('n')
                                                                        : QLatin1Char('t');
    }
  }
  return shape;
}

void PortForm::show(const bt::NodeSpec& node, bool editable) {
  const QString wanted = shape(node, editable);
  if (wanted != shape_ || section_ == nullptr) {
    clear();
    shape_ = wanted;
    section_ = new FormSection(QString::fromStdString(node.label()), this);
    const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
    if (manifest == nullptr) {
      section_->setNote(tr("unknown node"));
    } else if (manifest->ports.empty()) {
      section_->setNote(tr("nothing to set"));
    } else {
      section_->setNote(editable ? QString() : tr("in an included file"));
      for (const bt::PortSpec& port : manifest->ports) {
        QWidget* field = makeField(port, textOf(node, port.name).toStdString());
        field->setEnabled(editable);
        section_->addRow(QString::fromStdString(port.name), field);
      }
    }
    layout_->addWidget(section_);
    section_->show();
  }
  for (const auto& refresh : refreshers_) {
    refresh(node);
  }
}

QWidget* PortForm::makeField(const bt::PortSpec& port, const std::string& text) {
  const QString name = QString::fromStdString(port.name);
  const QString about = QString::fromStdString(port.description);
  if (takesNumber(port, text)) {
    auto* field = new NumberField(rangeOf(port), QString::fromStdString(port.unit), section_);
    field->setToolTip(about + QStringLiteral("\n") + field->toolTip());
    connect(field, &NumberField::edited, this, [this, name](double value) {
      Q_EMIT edited(name, QString::fromStdString(base::formatDouble(value)));
    });
    connect(field, &NumberField::defaultWanted, this, [this, name] { Q_EMIT edited(name, {}); });
    refreshers_.push_back([field, port](const bt::NodeSpec& node) {
      const std::string own = textOf(node, port.name).toStdString();
      const std::string shown = own.empty() ? port.defaultText.value_or("0") : own;
      field->show(base::parseDouble(shown).value_or(0.0), own.empty());
    });
    return field;
  }
  auto* field = new TextField(section_);
  field->setHint(about);
  field->setPlaceholderText(QString::fromStdString(port.defaultText.value_or("")));
  field->setCheck([port](const QString& typed) {
    const std::string word = typed.toStdString();
    const bool fine = (word.empty() && !port.required) || bt::referencedKey(word, port.name) ||
                      (!word.empty() && bt::isConvertible(word, port.type));
    return fine ? QString()
                : tr("A value (%1) or the name of an entry in braces, such as {id}")
                      .arg(QString::fromLatin1(bt::portTypeName(port.type)));
  });
  connect(field, &TextField::edited, this,
          [this, name](const QString& typed) { Q_EMIT edited(name, typed); });
  refreshers_.push_back(
      [field, port](const bt::NodeSpec& node) { field->show(textOf(node, port.name)); });
  return field;
}

}  // namespace editor
