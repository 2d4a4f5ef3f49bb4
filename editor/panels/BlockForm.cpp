#include "editor/panels/BlockForm.h"

#include <algorithm>

#include <QMenu>
#include <QToolButton>

#include "sim2d/base/Text.h"

namespace editor {

namespace {

using Kind = bt::BlockParameter::Kind;

QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

QString capital(QString text) {
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  return text;
}

QString modeWords(const std::string& mode) {
  if (mode == "nearest") {
    return QObject::tr("The nearest person");
  }
  if (mode == "specific") {
    return QObject::tr("Somebody by name");
  }
  return capital(mode == "robot" ? QObject::tr("the robot") : qt(mode));
}

}  // namespace

BlockForm::BlockForm(const ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
}

void BlockForm::show(const bt::Block& block) {
  const bool sameKind = block.id == block_.id && section_ != nullptr;
  block_ = block;
  if (!sameKind) {
    build();
  }
  refresh();
}

void BlockForm::build() {
  delete section_;
  section_ = nullptr;
  refreshers_.clear();
  const bt::BlockKind* kind = bt::blockKind(block_.id);
  if (kind == nullptr) {
    return;
  }
  section_ = new FormSection(qt(kind->title), this);
  for (const bt::BlockParameter& parameter : kind->parameters) {
    QWidget* field = makeField(parameter);
    section_->addRow(qt(parameter.label), field);
    if (!parameter.mode.empty()) {
      refreshers_.push_back([this, field, mode = parameter.mode] {
        section_->setRowVisible(field, block_.value("mode") == mode);
      });
    }
  }
  addRepeat();
  layout_->addWidget(section_);
  section_->show();
}

QWidget* BlockForm::makeField(const bt::BlockParameter& parameter) {
  switch (parameter.kind) {
    case Kind::Number:
      return makeNumber(parameter);
    case Kind::People:
      return makePeople(parameter);
    case Kind::Text:
      return makeText(parameter);
    case Kind::Choice:
    case Kind::Person:
    case Kind::Goal:
      break;
  }
  return makeChoice(parameter);
}

QWidget* BlockForm::makeNumber(const bt::BlockParameter& parameter) {
  const double step = parameter.max - parameter.min > 30.0 ? 5.0 : 0.1;
  auto* field =
      new NumberField({parameter.min, parameter.max, 2, step}, qt(parameter.unit), section_);
  connect(field, &NumberField::edited, this,
          [this, key = parameter.key](double value) { set(key, base::formatDouble(value)); });
  refreshers_.push_back([this, field, key = parameter.key] {
    field->show(base::parseDouble(block_.value(key)).value_or(0.0), false);
  });
  return field;
}

QWidget* BlockForm::makeText(const bt::BlockParameter& parameter) {
  auto* field = new TextField(section_);
  field->setCheck([](const QString& text) {
    return text.trimmed().isEmpty() ? tr("Say something") : QString();
  });
  connect(field, &TextField::edited, this,
          [this, key = parameter.key](const QString& text) { set(key, text.toStdString()); });
  refreshers_.push_back([this, field, key = parameter.key] { field->show(qt(block_.value(key))); });
  return field;
}

std::vector<std::pair<std::string, QString>> BlockForm::choicesOf(
    const bt::BlockParameter& parameter) const {
  std::vector<std::pair<std::string, QString>> choices;
  if (parameter.kind == Kind::Goal) {
    for (const sim2d::GlobalGoal& goal : document_.scenario().goals) {
      choices.emplace_back(std::to_string(goal.id), tr("Goal %1").arg(goal.id));
    }
  } else if (parameter.kind == Kind::Choice) {
    for (const std::string& choice : parameter.choices) {
      choices.emplace_back(choice, modeWords(choice));
    }
  } else {
    for (const sim2d::Human& human : document_.scenario().humans) {
      choices.emplace_back(std::to_string(human.id), qt(human.name));
    }
  }
  return choices;
}

QWidget* BlockForm::makeChoice(const bt::BlockParameter& parameter) {
  auto* field = new ChoiceField(section_);
  connect(field, qOverload<int>(&QComboBox::activated), this,
          [this, field, key = parameter.key](int index) {
            set(key, field->itemData(index).toString().toStdString());
          });
  refreshers_.push_back([this, field, parameter] {
    field->clear();
    for (const auto& [value, words] : choicesOf(parameter)) {
      field->addItem(words, qt(value));
    }
    const QString value = qt(block_.value(parameter.key));
    if (field->findData(value) < 0) {  // not in the scenario: shown as it is
      field->addItem(tr("%1 (missing)").arg(value), value);
    }
    field->setCurrentIndex(field->findData(value));
  });
  return field;
}

QWidget* BlockForm::makePeople(const bt::BlockParameter& parameter) {
  auto* field = new ChoiceField(section_);
  field->setPlaceholderText(tr("nobody"));
  connect(field, qOverload<int>(&QComboBox::activated), this,
          [this, field, key = parameter.key](int index) {
            QStringList chosen = qt(block_.value(key))
                                     .remove(QLatin1Char(' '))
                                     .split(QLatin1Char(','), Qt::SkipEmptyParts);
            const QString id = field->itemData(index).toString();
            chosen.contains(id) ? (void)chosen.removeAll(id) : chosen.push_back(id);
            set(key, chosen.join(QLatin1Char(',')).toStdString());
          });
  field->setToolTip(tr("Choosing a person adds or takes them off"));
  refreshers_.push_back([this, field, parameter] {
    const QStringList chosen = qt(block_.value(parameter.key))
                                   .remove(QLatin1Char(' '))
                                   .split(QLatin1Char(','), Qt::SkipEmptyParts);
    field->clear();
    QStringList names;
    for (const auto& [value, words] : choicesOf(parameter)) {
      const bool on = chosen.contains(qt(value));
      field->addItem((on ? QStringLiteral("✓ ") : QStringLiteral("    ")) + words, qt(value));
      if (on) {
        names << words;
      }
    }
    field->setPlaceholderText(names.isEmpty() ? tr("nobody") : names.join(QStringLiteral(", ")));
    field->setCurrentIndex(-1);
  });
  return field;
}

void BlockForm::addRepeat() {
  auto* repeat = new ChoiceField(section_);
  repeat->addItems({tr("Whenever it can"), tr("Only once"), tr("By chance")});
  section_->addRow(tr("Happens"), repeat);
  auto* chance = new NumberField({0.0, 1.0, 2, 0.05}, {}, section_);
  chance->setToolTip(tr("Drawn in every step in which the block could begin"));
  section_->addRow(tr("Chance"), chance);
  connect(repeat, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    block_.repeat = static_cast<bt::BlockRepeat>(index);
    refresh();
    Q_EMIT edited(block_);
  });
  connect(chance, &NumberField::edited, this, [this](double value) {
    block_.probability = value;
    Q_EMIT edited(block_);
  });
  refreshers_.push_back([this, repeat, chance] {
    repeat->setCurrentIndex(static_cast<int>(block_.repeat));
    chance->show(block_.probability, false);
    section_->setRowVisible(chance, block_.repeat == bt::BlockRepeat::Random);
  });
}

void BlockForm::set(const std::string& key, const std::string& text) {
  block_.values[key] = text;
  refresh();
  Q_EMIT edited(block_);
}

void BlockForm::refresh() {
  for (const auto& refreshRow : refreshers_) {
    refreshRow();
  }
}

}  // namespace editor
