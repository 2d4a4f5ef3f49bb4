#include <algorithm>
#include <cmath>
#include <map>

#include <QHBoxLayout>

#include "bt/tree/NodeCatalogue.h"
#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/panels/behavior/BehaviorDialogs.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

using Kind = ValueRow::Kind;

constexpr const char* kRepeatKey = "happens";  // Not keys of parameters.
constexpr const char* kChanceKey = "chance";

QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

/// "3, 7" -> 3 and 7
QStringList idsIn(const std::string& list) {
  return qt(list).remove(QLatin1Char(' ')).split(QLatin1Char(','), Qt::SkipEmptyParts);
}

void showChoice(ChoiceField& field, const ValueRow& row) {
  for (const auto& [value, words] : row.choices) {
    field.addItem(words, value);
  }
  const QString value = qt(row.text);
  if (field.findData(value) < 0) {  // A value that is not in the scenario is shown unchanged.
    field.addItem(QObject::tr("%1 (missing)").arg(value), value);
  }
  field.setCurrentIndex(field.findData(value));
}

void showChoices(ChoiceField& field, const ValueRow& row) {
  const QStringList chosen = idsIn(row.text);
  QStringList names;
  for (const auto& [value, words] : row.choices) {
    const bool on = chosen.contains(value);
    field.addItem((on ? QStringLiteral("✓ ") : QStringLiteral("    ")) + words, value);
    names += on ? QStringList(words) : QStringList();
  }
  field.setPlaceholderText(names.isEmpty() ? QObject::tr("none")
                                           : names.join(QStringLiteral(", ")));
  field.setCurrentIndex(-1);
}

std::string defaultTextOf(const bt::PortSpec& port) {
  return port.fallbackText() != nullptr ? *port.fallbackText() : std::string();
}

bool isNumeric(const bt::PortSpec& port) {
  return port.portType == bt::PortType::Double || port.portType == bt::PortType::Int ||
         port.portType == bt::PortType::Unsigned;
}

/// Constants are shown as numbers, also the default of an empty text.
bool takesNumber(const bt::PortSpec& port, const std::string& text) {
  const bool isNumber = isNumeric(port);
  const std::string shown = text.empty() ? defaultTextOf(port) : text;
  return isNumber && base::parseDouble(shown).has_value();
}

NumberField::Range rangeOf(const bt::PortSpec& port) {
  const bool whole = port.portType != bt::PortType::Double;
  const base::Range defaultText = {whole ? -1000000.0 : -10000.0, 1000000.0};
  return {std::isfinite(port.range.low) ? port.range.low : defaultText.low,
          std::isfinite(port.range.high) ? port.range.high : defaultText.high, whole ? 0 : 2,
          whole ? 1.0 : 0.1};
}

ValueRow rowOf(const bt::PortSpec& port, const bt::NodeSpec& node) {
  const std::string* text = bt::findAttribute(node.ports, port.key);
  ValueRow row;
  row.key = port.key;
  row.label = qt(port.key);
  row.text = text == nullptr ? std::string() : *text;
  row.help = coreText(port.help);
  row.defaultText = defaultTextOf(port);
  if (takesNumber(port, row.text)) {
    row.kind = Kind::Number;
    row.help += QStringLiteral("\n%1");
    row.unit = qt(port.unit);
    row.range = rangeOf(port);
    row.alternative = "{" + port.key + "}";
  } else if (isNumeric(port)) {
    const std::string defaultText = defaultTextOf(port);
    row.alternative = base::parseDouble(defaultText) ? defaultText : "1";
  }
  row.check = [port](const QString& typed) {
    const std::string word = typed.toStdString();
    const bool fine = (word.empty() && !port.required) || bt::referencedKey(word, port.key) ||
                      (!word.empty() && bt::isConvertible(word, port.portType));
    return fine ? QString()
                : QObject::tr("A value (%1) or a blackboard entry in braces, such as {id}")
                      .arg(QString::fromLatin1(bt::portTypeName(port.portType)));
  };
  return row;
}

QString modeText(const std::string& mode) {
  static const std::map<std::string, const char*> kWords = {
      {"nearest", QT_TRANSLATE_NOOP("QObject", "The nearest person")},
      {"specific", QT_TRANSLATE_NOOP("QObject", "A person by name")},
      {"robot", QT_TRANSLATE_NOOP("QObject", "The robot")}};
  const auto known = kWords.find(mode);
  return known == kWords.end() ? coreText(capitalized(qt(mode)).toStdString())
                               : QObject::tr(known->second);
}

ValueRow repeatRow(const bt::Block& block) {
  ValueRow row;
  row.kind = Kind::Choice;
  row.key = kRepeatKey;
  row.label = QObject::tr("Occurs");
  row.text = std::to_string(static_cast<int>(block.repeat));
  row.choices = {{QStringLiteral("0"), QObject::tr("Whenever possible")},
                 {QStringLiteral("1"), QObject::tr("Only once")},
                 {QStringLiteral("2"), QObject::tr("At random")}};
  return row;
}

ValueRow chanceRow(const bt::Block& block) {
  ValueRow row;
  row.kind = Kind::Number;
  row.key = kChanceKey;
  row.label = QObject::tr("Probability");
  row.text = base::formatDouble(block.probability);
  row.help = QObject::tr("Probability in each time step in which the block can start");
  row.range = {0.0, 1.0, 2, 0.05};
  row.isVisible = block.repeat == bt::BlockRepeat::Random;
  return row;
}

decltype(ValueRow::choices) choicesOf(const bt::BlockParameter& parameter,
                                      const sim2d::Scenario& scenario) {
  using Of = bt::BlockParameter::Kind;
  decltype(ValueRow::choices) choices;
  if (parameter.kind == Of::Goal) {
    for (const sim2d::GlobalGoal& goal : scenario.goals) {
      choices.emplace_back(QString::number(goal.id), goalName(goal.id));
    }
  } else if (parameter.kind == Of::Choice) {
    for (const std::string& choice : parameter.choices) {
      choices.emplace_back(qt(choice), modeText(choice));
    }
  } else if (parameter.kind != Of::Number && parameter.kind != Of::Text) {
    for (const sim2d::Human& human : scenario.humans) {
      choices.emplace_back(QString::number(human.id), qt(human.name));
    }
  }
  return choices;
}

ValueRow rowOf(const bt::BlockParameter& parameter, const bt::Block& block,
               const ScenarioDocument& document) {
  using Of = bt::BlockParameter::Kind;
  ValueRow row;
  row.kind = parameter.kind == Of::Number   ? Kind::Number
             : parameter.kind == Of::Text   ? Kind::Text
             : parameter.kind == Of::People ? Kind::Choices
                                            : Kind::Choice;
  row.key = parameter.key;
  row.label = coreText(parameter.label);
  row.text = block.value(parameter.key);
  row.isVisible = parameter.mode.empty() || block.value("mode") == parameter.mode;
  row.unit = qt(parameter.unit);
  row.range = {parameter.min, parameter.max, 2, parameter.max - parameter.min > 30.0 ? 5.0 : 0.1};
  if (parameter.kind == Of::Text) {
    row.check = [](const QString& text) {
      return text.trimmed().isEmpty() ? QObject::tr("Enter text") : QString();
    };
  }
  row.choices = choicesOf(parameter, document.scenario());
  if (parameter.kind == Of::People) {
    row.help = QObject::tr("Select a person to add or remove");
  }
  return row;
}

}  // namespace

ValueRows portRows(const bt::NodeSpec& node, bool isEditable) {
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  std::vector<ValueRow> rows;
  if (manifest != nullptr) {
    for (const bt::PortSpec& port : manifest->ports) {
      rows.push_back(rowOf(port, node));
    }
  }
  const QString note = manifest == nullptr ? QObject::tr("unknown node")
                       : rows.empty()      ? QObject::tr("no settings")
                       : isEditable        ? QString()
                                           : QObject::tr("in an included file");
  return {qt(node.id), qt(node.label()), note, std::move(rows), isEditable};
}

ValueRows blockRows(const bt::Block& block, const ScenarioDocument& document) {
  const bt::BlockType& kind = *bt::blockType(block.id);
  std::vector<ValueRow> rows;
  for (const bt::BlockParameter& parameter : kind.parameters) {
    rows.push_back(rowOf(parameter, block, document));
  }
  rows.push_back(repeatRow(block));
  rows.push_back(chanceRow(block));
  return {qt(kind.id), coreText(kind.title), {}, std::move(rows)};
}

void setValue(bt::Block& block, const std::string& key, const QString& text) {
  if (key == kRepeatKey) {
    block.repeat = static_cast<bt::BlockRepeat>(text.toInt());
  } else if (key == kChanceKey) {
    block.probability = base::parseDouble(text.toStdString()).value_or(0.0);
  } else {
    block.values[key] = text.toStdString();
  }
}

ValueForm::ValueForm(QWidget* parent)
    : QWidget(parent), layout_(configuredLayout(new QVBoxLayout(this), {}, 0)) {}

void ValueForm::show(ValueRows what) {
  rows_ = std::move(what.rows);
  QString shape = what.isEditable ? what.name + QLatin1Char('+') : what.name;
  for (const ValueRow& row : rows_) {
    shape += QString::number(static_cast<int>(row.kind));
    shape += row.alternative.empty() ? QString() : qt(row.alternative);
  }
  if (shape != shape_) {
    shape_ = shape;
    if (section_ != nullptr) {
      section_->hide();
      section_->deleteLater();
    }
    section_ = new FormSection(what.title, this);
    section_->setNote(what.note);
    fields_.clear();
    for (const ValueRow& row : rows_) {
      fields_.push_back(makeField(row, fields_.size()));
      fields_.back()->setEnabled(what.isEditable);
      section_->addRow(row.label, row.alternative.empty() ? fields_.back()
                                                          : withToggleButton(*fields_.back(), row));
    }
    layout_->addWidget(section_);
    section_->show();
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    showRow(rows_[i], fields_[i]);
  }
}

/// Adds a button that switches between a constant and a blackboard entry.
QWidget* ValueForm::withToggleButton(QWidget& field, const ValueRow& row) {
  auto* both = new QWidget(section_);
  const bool toEntry = row.alternative.front() == '{';
  const QString words[] = {tr("Use entry"), tr("Use number")};
  auto* button = linkButton(
      {},
      toEntry ? tr("Read %1 from a blackboard entry").arg(row.label)
              : tr("Enter %1 as a number").arg(row.label),
      both, [this, key = row.key, text = qt(row.alternative)] { Q_EMIT edited(key, text); });
  int width = 0;  // The same in all rows.
  for (const QString& each : {words[toEntry ? 1 : 0], words[toEntry ? 0 : 1]}) {
    button->setText(each);
    width = std::max(width, button->sizeHint().width());
  }
  button->setFixedWidth(width);
  button->setEnabled(field.isEnabled());
  field.setAccessibleName(row.label);
  QSizePolicy policy = field.sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Ignored);
  field.setSizePolicy(policy);
  configuredLayout(new QHBoxLayout(both), {}, 4, {&field, button})->setStretchFactor(&field, 1);
  return both;
}

QWidget* ValueForm::makeField(const ValueRow& row, std::size_t index) {
  const auto change = [this, key = row.key](const QString& text) { Q_EMIT edited(key, text); };
  if (row.kind == Kind::Number) {
    auto* field = new NumberField(row.range, row.unit, section_);
    if (!row.help.isEmpty()) {
      field->setToolTip(QString(row.help).replace(QStringLiteral("%1"), field->toolTip()));
    }
    connect(field, &NumberField::edited, this,
            [change](double value) { change(qt(base::formatDouble(value))); });
    if (row.defaultText) {
      connect(field, &NumberField::resetRequested, this, [change] { change({}); });
    }
    return field;
  }
  if (row.kind == Kind::Text) {
    auto* field = new TextField(section_);
    field->setHint(row.help);
    field->setPlaceholderText(qt(row.defaultText.value_or("")));
    field->setCheck(row.check);
    connect(field, &TextField::edited, this, change);
    return field;
  }
  auto* field = new ChoiceField(section_);
  field->setToolTip(row.help);
  connect(field, qOverload<int>(&QComboBox::activated), this,
          [this, change, field, index](int item) {
            const ValueRow& shown = rows_[index];
            const QString value = field->itemData(item).toString();
            QStringList chosen = shown.kind == Kind::Choices ? idsIn(shown.text) : QStringList();
            chosen.contains(value) ? (void)chosen.removeAll(value) : chosen.push_back(value);
            change(chosen.join(QLatin1Char(',')));
          });
  return field;
}

void ValueForm::showRow(const ValueRow& row, QWidget* widget) {
  section_->setRowVisible(widget, row.isVisible);
  if (row.kind == Kind::Number) {
    const std::string shown = row.text.empty() ? row.defaultText.value_or("") : row.text;
    static_cast<NumberField*>(widget)->show(base::parseDouble(shown).value_or(0.0),
                                            row.defaultText && row.text.empty());
  } else if (row.kind == Kind::Text) {
    static_cast<TextField*>(widget)->show(qt(row.text));
  } else {
    auto& field = *static_cast<ChoiceField*>(widget);
    field.clear();
    row.kind == Kind::Choice ? showChoice(field, row) : showChoices(field, row);
  }
}

}  // namespace editor
