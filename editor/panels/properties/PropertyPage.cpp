#include "editor/panels/properties/PropertyPage.h"

#include "editor/document/RunValues.h"
#include "editor/look/CoreText.h"
#include "sim2d/base/Find.h"

namespace editor {

namespace {

using base::ParameterType;
using base::ParameterValue;

template <class T>
T valueOr(const ParameterValue& value, T otherwise) {
  const T* own = std::get_if<T>(&value);
  return own == nullptr ? otherwise : *own;
}

/// "1/s" is shown as "/s" after a number.
QString unitOf(const base::ParameterSpec& spec) {
  const QString unit = QString::fromStdString(spec.unit);
  return unit.startsWith(QStringLiteral("1/")) ? unit.mid(1) : unit;
}

NumberField::Range rangeOf(const base::ParameterSpec& spec, bool is64Bit) {
  NumberField::Range range = {spec.range.low, spec.range.high, spec.form.decimals, spec.form.step,
                              spec.range.excludesLow};
  if (spec.type == ParameterType::Integer) {
    constexpr double kLargest = 2147483647.0;
    constexpr double kLargestWide = 9223372036854774784.0;  // Fits a double and 64 bits.
    range.decimals = 0;
    range.step = 1.0;
    range.minimum = std::max(range.minimum, -kLargest);
    range.maximum = std::min(range.maximum, is64Bit ? kLargestWide : kLargest);
  }
  return range;
}

QString textOf(const ParameterValue& value) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    return listText(*numbers);
  }
  if (const auto* integers = std::get_if<std::vector<int>>(&value)) {
    return listText({integers->begin(), integers->end()});
  }
  return QString::fromStdString(valueOr<std::string>(value, {}));
}

ParameterValue valueFromText(ParameterType type, const QString& text) {
  if (text.isEmpty()) {
    return {};
  }
  if (type == ParameterType::Text) {
    return text.toStdString();
  }
  const auto numbers = listFromText(text).value_or(std::vector<double>());
  return type == ParameterType::Numbers
             ? ParameterValue(numbers)
             : ParameterValue(std::vector<int>(numbers.begin(), numbers.end()));
}

/// The value of the entity, else its default.
ParameterValue effectiveValue(const EntityField& field, const Entity& entity) {
  ParameterValue own = field.get(entity);
  return own == ParameterValue() && field.fallback ? field.fallback(entity) : own;
}

/// The value in the file; an empty text is not a value.
ParameterValue ownValue(const EntityField& field, const Entity& entity) {
  const ParameterValue own =
      field.belongs && !field.belongs(entity) ? ParameterValue() : field.get(entity);
  return own == ParameterValue(std::string()) ? ParameterValue() : own;
}

/// The value if the file does not set the key.
ParameterValue defaultValueOf(const EntityField& field, Entity entity) {
  field.set(entity, {});
  return field.fallback ? field.fallback(entity) : ParameterValue();
}

QString listProblem(const base::Range& range, const QString& text) {
  const auto values = listFromText(text);
  const bool fits = values && std::all_of(values->begin(), values->end(),
                                          [&](double value) { return range.contains(value); });
  return fits ? QString() : QObject::tr("Numbers, separated by commas");
}

}  // namespace

PropertyPage::PropertyPage(ScenarioDocument& document, const sim2d::FieldTables& tables)
    : document_(document),
      tables_(tables),
      layout_(configuredLayout(new QVBoxLayout(this), {}, 0)) {
  layout_->addStretch();
}

void PropertyPage::setTargets(const std::vector<EntityId>& targets) {
  targets_ = targets;
  refresh();
}

/// The values of the shown run, except those that were edited since its start.
void PropertyPage::refresh() {
  std::vector<Entity> shown = values();
  inRun_.clear();
  for (Entity& value : shown) {
    inRun_.push_back(document_.entityInRun(idOf(value)));
    value = withRunValues(document_, std::move(value));
  }
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
  layout_->insertWidget(layout_->count() - 1, section);
  sections_.push_back(section);
  return section;
}

FormSection* PropertyPage::addFold(const QString& title) {
  FormSection* section = addSection(title);
  section->setOpen(false);
  const std::size_t number = folds_.size();
  folds_.push_back({section, {}});
  QToolButton* reset = section->addLink(tr("Reset"), tr("Reset all to their default values"),
                                        [this, section] { resetFold(section); });
  reset->setObjectName(QStringLiteral("reset"));
  addRefresh([this, number, reset](const std::vector<Entity>& shown) {
    showFold(folds_[number], *reset, shown);
  });
  return section;
}

FormSection* PropertyPage::foldOf(const QString& group) {
  const Fold* found =
      base::findIf(folds_, [&](const Fold& fold) { return fold.section->title() == group; });
  return found == nullptr ? addFold(group) : found->section;
}

void PropertyPage::showFold(const Fold& fold, QToolButton& reset,
                            const std::vector<Entity>& shown) {
  std::size_t changed = 0;
  bool isGiven = false;
  bool hasRows = false;
  for (const auto& [field, applies] : fold.rows) {
    hasRows = hasRows || applies(shown);
    bool isChanged = false;
    for (const Entity& entity : shown) {
      const ParameterValue own = ownValue(field, entity);
      isGiven = isGiven || own != ParameterValue();
      isChanged = isChanged || (own != ParameterValue() && own != defaultValueOf(field, entity));
    }
    changed += isChanged ? 1 : 0;
  }
  fold.section->setVisible(hasRows);
  fold.section->setNote(changed == 0 ? QString() : tr("%1 changed").arg(changed));
  reset.setVisible(isGiven);
}

void PropertyPage::resetFold(const FormSection* section) {
  const Fold* fold = base::findBy(folds_, &Fold::section, section);
  apply(tr("Reset %1").arg(section->title().toLower()), [fold](Entity& entity) {
    for (const auto& [field, applies] : fold->rows) {
      if (ownValue(field, entity) != ParameterValue()) {
        field.set(entity, {});
      }
    }
  });
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

/// Marks a row whose value differs from that of the shown run.
void PropertyPage::addPendingMark(FormSection* section, const QWidget* row,
                                  const std::vector<EntityField>& fields) {
  addRefresh([=](const std::vector<Entity>& shown) {
    bool isPending = false;
    for (std::size_t k = 0; k < shown.size() && !isPending; ++k) {
      isPending = inRun_[k] && std::any_of(fields.begin(), fields.end(), [&](const auto& field) {
                    return field.get(shown[k]) != field.get(*inRun_[k]);
                  });
    }
    section->setRowMark(row, isPending ? tr("Applies at the next start") : QString());
  });
}

void PropertyPage::addName(FormSection* section) {
  auto* field = new TextField(this);
  field->setCheck([this](const QString& name) {
    static const QRegularExpression kName(QStringLiteral("^[A-Za-z][A-Za-z0-9_]*$"));
    return !kName.match(name).hasMatch()
               ? tr("A name starts with a letter and contains only letters, digits and _")
           : UniqueNames(document_.scenario()).isTaken(name.toStdString())
               ? tr("This name is already in use")
               : QString();
  });
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
}

void PropertyPage::addUniqueNumber(FormSection* section, const QString& help, int least,
                                   std::function<int(const Entity&)> get,
                                   std::function<bool(int)> take) {
  auto* number = new NumberField({double(least), 2147483647.0, 0, 1.0}, {}, this);
  if (!help.isEmpty()) {
    number->setToolTip(help);
  }
  section->addRow(tr("Number"), number);
  connect(number, &NumberField::edited, this, [this, take = std::move(take)](double value) {
    if (targets_.size() != 1 || !take(static_cast<int>(value))) {
      refresh();
    }
  });
  addRefresh([number, get = std::move(get)](const std::vector<Entity>& shown) {
    number->setEnabled(shown.size() == 1);
    shown.size() == 1 ? number->show(get(shown.front()), false) : number->showMixed();
  });
}

QString labelOf(const base::ParameterSpec& spec) {
  if (!spec.form.label.empty()) {
    return coreText(spec.form.label);
  }
  const QString words =
      QString::fromStdString(spec.key).replace(QLatin1Char('_'), QLatin1Char(' '));
  return coreText(capitalized(words).toStdString());
}

QString helpOf(const base::ParameterSpec& spec) {
  return coreText(spec.help).remove(QLatin1Char('`'));
}

QWidget* PropertyPage::addRow(FormSection* section, const EntityField& field,
                              const FieldOptions& look) {
  const base::ParameterSpec& spec = field.spec;
  const bool isNumber = spec.type == ParameterType::Number || spec.type == ParameterType::Integer;
  QWidget* row = isNumber                                     ? makeNumber(field, look)
                 : spec.type == ParameterType::Boolean        ? makeSwitch(field, look)
                 : spec.choices.empty() && look.names.empty() ? makeText(field, look)
                                                              : makeChoice(field, look);
  row->setObjectName(QString::fromStdString(spec.key));
  if (spec.form.sliderMax > 0.0) {
    auto* number = static_cast<NumberField*>(row);
    section->addRow(labelOf(spec), new LinkedSlider(*number, spec.form.sliderMax, this), row);
  } else {
    section->addRow(labelOf(spec), row);
  }
  QWidget* whole = spec.form.sliderMax > 0.0 ? row->parentWidget() : row;
  const Applies applies = [belongs = field.belongs,
                           visible = look.visible](const std::vector<Entity>& shown) {
    return (!belongs || std::all_of(shown.begin(), shown.end(), belongs)) &&
           (!visible || visible(shown));
  };
  for (Fold& fold : folds_) {
    if (fold.section == section) {
      fold.rows.emplace_back(field, applies);
    }
  }
  addPendingMark(section, row, {field});
  addRefresh([=](const std::vector<Entity>& shown) {
    section->setRowVisible(row, applies(shown));
    whole->setEnabled(!look.enabled || look.enabled(shown));
  });
  return row;
}

void PropertyPage::addParameterRows(FormSection* section, const ParameterOwner& owner,
                                    const QString& helpOfOthers) {
  for (const auto& [name, specs] : owner.known) {
    for (const base::ParameterSpec& spec : specs) {
      QWidget* row = addRow(section, parameterField(owner, name, spec));
      row->setObjectName(QString::fromStdString(name + "." + spec.key));
    }
  }
  FieldOptions look = withPlaceholder(tr("none"), [](const QString& text) {
    return pairsFromText(text) ? QString() : tr("name=value, separated by commas");
  });
  look.visible = [owner](const std::vector<Entity>& shown) {
    return std::any_of(shown.begin(), shown.end(),
                       [&](const Entity& each) { return !otherParameters(owner, each).empty(); });
  };
  QWidget* others = addRow(section, otherParametersField(owner, helpOfOthers), look);
  others->setObjectName(QStringLiteral("other_parameters"));
}

/// Whether an entity is active in a run, for all kinds that can be switched off.
void PropertyPage::addListedRow(FormSection* section) {
  EntityField field;
  field.spec.type = ParameterType::Boolean;
  field.spec.form.label = tr("Active").toStdString();
  field.spec.help = tr("Off: kept in the file, but not in the run").toStdString();
  field.get = isListed;
  field.set = [](Entity& entity, const ParameterValue& on) {
    setListed(entity, std::get<bool>(on));
  };
  addRow(section, field, withLabels({tr("In the scenario")}));
}

void PropertyPage::addPosition(FormSection* section) {
  addNumberPair(section, tr("Position"), positionField(QStringLiteral("X"), 0),
                positionField(QStringLiteral("Y"), 1));
}

void PropertyPage::addNumberPair(FormSection* section, const QString& label,
                                 const EntityField& first, const EntityField& second) {
  NumberField* left = makeNumber(first);
  NumberField* right = makeNumber(second);
  section->addRow(label, left, right);
  left->setAccessibleName(labelOf(first.spec));
  right->setAccessibleName(labelOf(second.spec));
  addPendingMark(section, left, {first, second});
}

NumberField* PropertyPage::makeNumber(const EntityField& field, const FieldOptions& look) {
  const bool isInteger = field.spec.type == ParameterType::Integer;
  auto* number = new NumberField(rangeOf(field.spec, field.is64Bit),
                                 look.unit.isEmpty() ? unitOf(field.spec) : look.unit, this);
  number->setSingularUnit(look.singularUnit);
  QStringList hints = {helpOf(field.spec), number->toolTip()};
  hints.removeAll(QString());
  number->setToolTip(hints.join(QLatin1Char('\n')));
  connect(number, &NumberField::edited, this, [=](double value) {
    change(field, isInteger ? ParameterValue(static_cast<long long>(value)) : value);
  });
  connect(number, &NumberField::resetRequested, this, [=] { change(field, {}); });
  addRefresh([=](const std::vector<Entity>& shown) {
    const auto own = [&](const Entity& entity) {
      return !look.counts || look.counts(entity) ? numberIn(field.get(entity)) : std::nullopt;
    };
    const auto value = commonValue(shown, [&](const Entity& entity) {
      const std::optional<double> written = own(entity);
      return written || !field.fallback ? written.value_or(0.0)
                                        : numberIn(field.fallback(entity)).value_or(0.0);
    });
    value ? number->show(*value, !own(shown.front())) : number->showMixed();
  });
  return number;
}

namespace {

/// Fills a combo box; returns the values of its items.
std::vector<ParameterValue> fillChoice(QComboBox& box, const EntityField& field,
                                       const FieldOptions& look) {
  std::vector<ParameterValue> values;
  if (!look.none.isEmpty()) {
    box.addItem(look.none);
    values.emplace_back();
  }
  int index = 0;
  for (const std::string& value : field.spec.choices.empty() ? look.names : field.spec.choices) {
    box.addItem(index < look.labels.size() ? look.labels[index] : coreText(value));
    box.setItemData(box.count() - 1, index < look.hints.size() ? look.hints[index] : QString(),
                    Qt::ToolTipRole);
    values.emplace_back(value);
    ++index;
  }
  return values;
}

}  // namespace

/// Choosing the default removes the key, unless another item does that.
QWidget* PropertyPage::makeChoice(const EntityField& field, const FieldOptions& look) {
  const bool hasNone = !look.none.isEmpty();
  auto* box = new ChoiceField(this);
  const std::vector<ParameterValue> values = fillChoice(*box, field, look);
  box->setToolTip(helpOf(field.spec));
  connect(box, qOverload<int>(&QComboBox::activated), this, [=](int index) {
    const ParameterValue& value = values[static_cast<std::size_t>(index)];
    apply(tr("Change %1").arg(labelOf(field.spec).toLower()), [&](Entity& entity) {
      const bool isUsual = !hasNone && field.fallback && value == defaultValueOf(field, entity);
      field.set(entity, isUsual ? ParameterValue() : value);
    });
  });
  addRefresh([=](const std::vector<Entity>& shown) {
    const auto index = commonValue(shown, [&](const Entity& entity) {
      const ParameterValue value = hasNone ? field.get(entity) : effectiveValue(field, entity);
      const auto found = std::find(values.begin(), values.end(), value);
      const int none = value == ParameterValue() ? 0 : -1;  // -1: an unknown value.
      return found == values.end() ? none : static_cast<int>(found - values.begin());
    });
    box->setCurrentIndex(index.value_or(-1));
  });
  return box;
}

QWidget* PropertyPage::makeSwitch(const EntityField& field, const FieldOptions& look) {
  auto* box = new QCheckBox(look.labels.isEmpty() ? tr("Yes") : look.labels.front(), this);
  box->setToolTip(helpOf(field.spec));
  connect(box, &QCheckBox::clicked, this, [=](bool on) { change(field, on); });
  addRefresh([=](const std::vector<Entity>& shown) {
    const std::optional<bool> on = commonValue(
        shown, [&](const Entity& entity) { return valueOr(effectiveValue(field, entity), false); });
    box->setTristate(!on);
    box->setCheckState(!on ? Qt::PartiallyChecked : *on ? Qt::Checked : Qt::Unchecked);
  });
  return box;
}

/// A text, or a list as text.
QWidget* PropertyPage::makeText(const EntityField& field, const FieldOptions& look) {
  auto* line = new TextField(this);
  line->setPlaceholderText(look.placeholder);
  line->setHint(helpOf(field.spec));
  line->setCheck(
      look.check || field.spec.type == ParameterType::Text
          ? look.check
          : [range = field.spec.range](const QString& text) { return listProblem(range, text); });
  connect(line, &TextField::edited, this, [=](const QString& text) {
    apply(tr("Change %1").arg(labelOf(field.spec).toLower()),
          [&](Entity& entity) { field.set(entity, valueFromText(field.spec.type, text)); });
  });
  addRefresh([=](const std::vector<Entity>& shown) {
    const auto text =
        commonValue(shown, [&](const Entity& entity) { return textOf(field.get(entity)); });
    line->show(text.value_or(QString()));
  });
  return line;
}

}  // namespace editor
