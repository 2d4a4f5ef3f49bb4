#include "editor/panels/PropertyPage.h"

#include <algorithm>

#include <QRegularExpression>

namespace editor {

PropertyPage::PropertyPage(ScenarioDocument& document, QWidget* parent,
                           const sim2d::FieldTables& tables)
    : QWidget(parent), document_(document), tables_(tables), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(0);
}

void PropertyPage::setTargets(const std::vector<EntityId>& targets) {
  targets_ = targets;
  refresh();
}

std::vector<Entity> PropertyPage::values() const {
  std::vector<Entity> result;
  for (const EntityId id : targets_) {
    if (std::optional<Entity> value = document_.entity(id)) {
      result.push_back(std::move(*value));
    }
  }
  return result;
}

void PropertyPage::refresh() {
  const std::vector<Entity> shown = values();
  if (shown.empty()) {
    return;
  }
  for (const auto& refreshRow : refreshers_) {
    refreshRow(shown);
  }
}

void PropertyPage::apply(const QString& text, const std::function<void(Entity&)>& edit) {
  std::vector<Entity> edited = values();
  for (Entity& value : edited) {
    edit(value);
  }
  pushEdit(document_, std::move(edited), text, Merge::WithPrevious);
}

void PropertyPage::addRefresh(std::function<void(const std::vector<Entity>&)> refresh) {
  refreshers_.push_back(std::move(refresh));
}

FormSection* PropertyPage::addSection(const QString& title) {
  auto* section = new FormSection(title, this);
  layout_->addWidget(section);
  sections_.push_back(section);
  return section;
}

void PropertyPage::finish() {
  layout_->addStretch();
}

long long PropertyPage::seed() const {
  return document_.scenario().desktop.seed.value_or(1);
}

void PropertyPage::change(const EntityField& field, const base::ParameterValue& value) {
  const bool isReset = value == base::ParameterValue();
  const QString label = labelOf(field.spec).toLower();
  apply((isReset ? tr("Reset %1") : tr("Change %1")).arg(label),
        [&](Entity& entity) { field.set(entity, value); });
}

QString PropertyPage::nameProblem(const QString& name) const {
  static const QRegularExpression kName(QStringLiteral("^[A-Za-z][A-Za-z0-9_]*$"));
  if (!kName.match(name).hasMatch()) {
    return tr("A name begins with a letter and has only letters, digits and _");
  }
  return isNameTaken(document_.scenario(), name.toStdString()) ? tr("This name is taken")
                                                               : QString();
}

TextField* PropertyPage::addName(FormSection* section) {
  auto* field = new TextField(this);
  field->setCheck([this](const QString& name) { return nameProblem(name); });
  connect(field, &TextField::edited, this, [this](const QString& name) {
    if (targets_.size() == 1) {
      pushRename(document_, targets_.front(), name.toStdString());
    }
  });
  addRefresh([field](const std::vector<Entity>& shown) {
    const bool one = shown.size() == 1;
    field->setEnabled(one);
    field->show(one ? QString::fromStdString(nameOf(shown.front()))
                    : tr("%1 selected").arg(shown.size()));
  });
  section->addRow(tr("Name"), field);
  return field;
}

}  // namespace editor
