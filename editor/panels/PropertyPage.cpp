#include "editor/panels/PropertyPage.h"

#include <algorithm>

#include <QRegularExpression>

namespace editor {

PropertyPage::PropertyPage(ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), layout_(new QVBoxLayout(this)) {
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
  return section;
}

void PropertyPage::finish() {
  layout_->addStretch();
}

NumberField* PropertyPage::makeNumber(const NumberKey& key) {
  auto* field = new NumberField(key.range, key.unit, this);
  field->setUnitOfOne(key.unitOfOne);
  if (!key.hint.isEmpty()) {
    field->setToolTip(key.hint + QStringLiteral("\n") + field->toolTip());
  }
  connect(field, &NumberField::edited, this, [this, key](double value) {
    apply(tr("Change %1").arg(key.label.toLower()),
          [&](Entity& entity) { key.set(entity, value); });
  });
  connect(field, &NumberField::defaultWanted, this, [this, key] {
    apply(tr("Reset %1").arg(key.label.toLower()),
          [&](Entity& entity) { key.set(entity, std::nullopt); });
  });
  addRefresh([field, key](const std::vector<Entity>& shown) {
    const auto shownValue = [&key](const Entity& value) {
      const std::optional<double> own = key.get(value);
      return own ? *own : key.fallback ? key.fallback(value) : 0.0;
    };
    const double first = shownValue(shown.front());
    const bool same = std::all_of(shown.begin(), shown.end(),
                                  [&](const Entity& value) { return shownValue(value) == first; });
    if (same) {
      field->show(first, !key.get(shown.front()).has_value());
    } else {
      field->showMixed();
    }
  });
  return field;
}

NumberField* PropertyPage::addNumber(FormSection* section, const NumberKey& key) {
  NumberField* field = makeNumber(key);
  if (key.sliderTo > 0.0) {
    section->addRow(key.label, new LinkedSlider(*field, key.range.minimum, key.sliderTo, this),
                    field);
  } else {
    section->addRow(key.label, field);
  }
  return field;
}

void PropertyPage::addNumberPair(FormSection* section, const QString& label, const NumberKey& first,
                                 const NumberKey& second) {
  NumberField* left = makeNumber(first);
  NumberField* right = makeNumber(second);
  section->addRow(label, left, right);
  left->setAccessibleName(first.label);
  right->setAccessibleName(second.label);
}

ChoiceField* PropertyPage::addChoice(FormSection* section, const ChoiceKey& key) {
  auto* field = new ChoiceField(this);
  field->addItems(key.words);
  field->setToolTip(key.hint);
  connect(field, qOverload<int>(&QComboBox::activated), this, [this, key](int index) {
    apply(tr("Change %1").arg(key.label.toLower()),
          [&](Entity& entity) { key.set(entity, index); });
  });
  addRefresh([field, key](const std::vector<Entity>& shown) {
    const int first = key.get(shown.front());
    const bool same = std::all_of(shown.begin(), shown.end(),
                                  [&](const Entity& value) { return key.get(value) == first; });
    field->setCurrentIndex(same ? first : -1);
  });
  section->addRow(key.label, field);
  return field;
}

QCheckBox* PropertyPage::addSwitch(FormSection* section, const SwitchKey& key) {
  auto* box = new QCheckBox(key.words, this);
  box->setToolTip(key.hint);
  connect(box, &QCheckBox::clicked, this, [this, key](bool on) {
    apply(tr("Change %1").arg(key.label.toLower()), [&](Entity& entity) { key.set(entity, on); });
  });
  addRefresh([box, key](const std::vector<Entity>& shown) {
    const bool first = key.get(shown.front());
    const bool same = std::all_of(shown.begin(), shown.end(),
                                  [&](const Entity& value) { return key.get(value) == first; });
    box->setTristate(!same);
    box->setCheckState(!same ? Qt::PartiallyChecked : first ? Qt::Checked : Qt::Unchecked);
  });
  section->addRow(key.label, box);
  return box;
}

TextField* PropertyPage::addText(FormSection* section, const TextKey& key) {
  auto* field = new TextField(this);
  field->setPlaceholderText(key.placeholder);
  field->setCheck(key.check);
  field->setHint(key.hint);
  connect(field, &TextField::edited, this, [this, key](const QString& text) {
    apply(tr("Change %1").arg(key.label.toLower()), [&](Entity& entity) { key.set(entity, text); });
  });
  addRefresh([field, key](const std::vector<Entity>& shown) {
    const QString first = key.get(shown.front());
    const bool same = std::all_of(shown.begin(), shown.end(),
                                  [&](const Entity& value) { return key.get(value) == first; });
    field->show(same ? first : QString());
  });
  section->addRow(key.label, field);
  return field;
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

namespace {

constexpr NumberField::Range kPlace = {-10000.0, 10000.0, 2, 0.1};

NumberKey placeKey(const QString& label, int axis) {
  NumberKey key;
  key.label = label;
  key.unit = QStringLiteral("m");
  key.range = kPlace;
  key.get = [axis](const Entity& entity) -> std::optional<double> {
    const std::optional<Vec2> at = positionOf(entity);
    return at ? std::optional((*at)(axis)) : std::nullopt;
  };
  key.set = [axis](Entity& entity, std::optional<double> value) {
    if (const std::optional<Vec2> at = positionOf(entity); at && value) {
      Vec2 delta = Vec2::Zero();
      delta(axis) = *value - (*at)(axis);
      entity = moved(std::move(entity), delta);
    }
  };
  return key;
}

}  // namespace

NumberKey xKey() {
  return placeKey(QStringLiteral("X"), 0);
}
NumberKey yKey() {
  return placeKey(QStringLiteral("Y"), 1);
}

NumberKey headingKey() {
  NumberKey key;
  key.label = QStringLiteral("Heading");
  key.unit = QStringLiteral("°");
  key.range = {-180.0, 180.0, 1, 5.0};
  key.hint = QStringLiteral("Counter-clockwise from the right");
  key.get = [](const Entity& entity) -> std::optional<double> {
    const std::optional<double> heading = headingOf(entity);
    return heading ? std::optional(*heading / kDegree) : std::nullopt;
  };
  key.set = [](Entity& entity, std::optional<double> value) {
    entity = turned(std::move(entity), value.value_or(0.0) * kDegree);
  };
  return key;
}

}  // namespace editor
