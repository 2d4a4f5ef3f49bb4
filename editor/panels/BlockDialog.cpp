#include "editor/panels/BlockDialog.h"

#include <map>

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "editor/document/Groups.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

using Kind = bt::BlockParameter::Kind;

QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

QString modeWords(const std::string& mode) {
  static const std::map<std::string, const char*> kWords = {
      {"nearest", QT_TR_NOOP("The nearest person")},
      {"specific", QT_TR_NOOP("Somebody by name")},
      {"robot", QT_TR_NOOP("The robot")}};
  const auto known = kWords.find(mode);
  const QString word = qt(mode);
  return known == kWords.end() ? word.left(1).toUpper() + word.mid(1) : QObject::tr(known->second);
}

/// "3, 7" -> 3 and 7
QStringList idsIn(const std::string& list) {
  return qt(list).remove(QLatin1Char(' ')).split(QLatin1Char(','), Qt::SkipEmptyParts);
}

QLabel* heading(const QString& text, const Theme& theme, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(theme.font(9.5, QFont::DemiBold));
  return label;
}

void addPeople(QListWidget& list, const ScenarioDocument& document, const Theme& theme) {
  const FigurePainter painter(theme);
  for (const sim2d::Human& human : document.scenario().humans) {
    auto* item = new QListWidgetItem(painter.markIcon(lookOfPerson(document, human)),
                                     QString::fromStdString(human.name), &list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    item->setCheckState(document.isSelected(human.key) ? Qt::Checked : Qt::Unchecked);
  }
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
  return parameter.kind == Kind::Number ? makeNumber(parameter)
         : parameter.kind == Kind::Text ? makeText(parameter)
                                        : makeChoice(parameter);
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

/// Of people several can be chosen, one after the other.
QWidget* BlockForm::makeChoice(const bt::BlockParameter& parameter) {
  auto* field = new ChoiceField(section_);
  const bool isMany = parameter.kind == Kind::People;
  if (isMany) {
    field->setToolTip(tr("Choosing a person adds or takes them off"));
  }
  connect(field, qOverload<int>(&QComboBox::activated), this,
          [this, field, isMany, key = parameter.key](int index) {
            const QString id = field->itemData(index).toString();
            QStringList chosen = isMany ? idsIn(block_.value(key)) : QStringList();
            chosen.contains(id) ? (void)chosen.removeAll(id) : chosen.push_back(id);
            set(key, chosen.join(QLatin1Char(',')).toStdString());
          });
  refreshers_.push_back([this, field, isMany, parameter] {
    field->clear();
    isMany ? showPeople(*field, parameter) : showChoice(*field, parameter);
  });
  return field;
}

void BlockForm::showChoice(ChoiceField& field, const bt::BlockParameter& parameter) const {
  for (const auto& [value, words] : choicesOf(parameter)) {
    field.addItem(words, qt(value));
  }
  const QString value = qt(block_.value(parameter.key));
  if (field.findData(value) < 0) {  // not in the scenario: shown as it is
    field.addItem(tr("%1 (missing)").arg(value), value);
  }
  field.setCurrentIndex(field.findData(value));
}

void BlockForm::showPeople(ChoiceField& field, const bt::BlockParameter& parameter) const {
  const QStringList chosen = idsIn(block_.value(parameter.key));
  QStringList names;
  for (const auto& [value, words] : choicesOf(parameter)) {
    const bool on = chosen.contains(qt(value));
    field.addItem((on ? QStringLiteral("✓ ") : QStringLiteral("    ")) + words, qt(value));
    names += on ? QStringList(words) : QStringList();
  }
  field.setPlaceholderText(names.isEmpty() ? tr("nobody") : names.join(QStringLiteral(", ")));
  field.setCurrentIndex(-1);
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

BlockDialog::BlockDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QDialog(parent),
      document_(document),
      kinds_(new HintList(theme, tr("Blocks"), this)),
      people_(new HintList(theme, tr("People"), this)),
      about_(secondaryLabel({}, this)),
      form_(new BlockForm(document, this)) {
  setWindowTitle(tr("Add a block of behaviour"));
  resize(780, 480);
  kinds_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setHint(tr("No people yet"));
  about_->setWordWrap(true);
  for (const bt::BlockKind& kind : bt::blockKinds()) {
    new QListWidgetItem(QString::fromStdString(kind.title), kinds_);
  }
  addPeople(*people_, document, theme);
  auto* middle = new QWidget(this);
  auto* words = new QVBoxLayout(middle);
  words->setContentsMargins(0, 0, 0, 0);
  words->addWidget(about_);
  words->addWidget(form_);
  words->addStretch(1);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(middle);
  area->setMinimumWidth(330);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(4);
  grid->addWidget(heading(tr("Block"), theme, this), 0, 0);
  grid->addWidget(heading(tr("What it does"), theme, this), 0, 1);
  grid->addWidget(heading(tr("Who does it"), theme, this), 0, 2);
  grid->addWidget(kinds_, 1, 0);
  grid->addWidget(area, 1, 1);
  grid->addWidget(people_, 1, 2);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 5);
  grid->setColumnStretch(2, 3);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  add_ = buttons->button(QDialogButtonBox::Ok);
  add_->setText(tr("Add"));
  connect(buttons, &QDialogButtonBox::accepted, this, &BlockDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(16);
  layout->addLayout(grid, 1);
  layout->addWidget(buttons);
  connect(kinds_, &QListWidget::currentRowChanged, this, &BlockDialog::showKind);
  const auto judge = [this] { add_->setEnabled(!chosen().empty()); };
  connect(people_, &QListWidget::itemChanged, this, judge);
  kinds_->setCurrentRow(0);
  judge();
}

void BlockDialog::showKind() {
  const int row = kinds_->currentRow();
  if (row < 0) {
    return;
  }
  const bt::BlockKind& kind = bt::blockKinds()[static_cast<std::size_t>(row)];
  about_->setText(QString::fromStdString(kind.description) + QLatin1Char('.'));
  form_->show({kind.id, {}});
}

std::vector<EntityId> BlockDialog::chosen() const {
  std::vector<EntityId> result;
  for (int row = 0; row < people_->count(); ++row) {
    if (people_->item(row)->checkState() == Qt::Checked) {
      result.push_back(document_.scenario().humans[static_cast<std::size_t>(row)].key);
    }
  }
  return result;
}

void BlockDialog::accept() {
  pushAddBlock(document_, chosen(), form_->block());
  QDialog::accept();
}

}  // namespace editor
