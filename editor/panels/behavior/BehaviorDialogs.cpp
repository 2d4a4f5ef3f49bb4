#include "editor/panels/behavior/BehaviorDialogs.h"

#include <algorithm>

#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/FigurePainter.h"
#include "editor/tools/ToolOptionFields.h"

namespace editor {

using sim2d::BehaviorType;

namespace {

void setBehaviorOfPeople(ScenarioDocument& document, BehaviorType type) {
  std::vector<Entity> people;
  for (const EntityId id : document.selection()) {
    if (const sim2d::Human* human = document.human(id)) {
      people.emplace_back(*human);
      auto& person = std::get<sim2d::Human>(people.back());
      person.behavior.type = type;
      addMissingReactionKeys(document.scenario(), person);
    }
  }
  pushEdit(document, std::move(people),
           QObject::tr("Set behaviour: %1").arg(lookName(lookOf(type)).toLower()));
}

}  // namespace

std::vector<EntityId> selectedOrAllPeople(const ScenarioDocument& document) {
  std::vector<EntityId> people;
  for (const EntityId id : document.selection()) {
    if (id.kind == EntityKind::Human) {
      people.push_back(id);
    }
  }
  return people.empty() ? document.entities(EntityKind::Human) : people;
}

void fillBehaviorMenu(QMenu& menu, ScenarioDocument& document, const Theme& theme, QWidget* parent,
                      bool isEditing) {
  for (int i = 1; i <= kBehaviorCount; ++i) {
    const auto type = static_cast<BehaviorType>(i);
    const QString name = lookName(lookOf(type));
    QAction* action =
        menu.addAction(name, &document, [&document, type] { setBehaviorOfPeople(document, type); });
    describe(*action,
             QObject::tr("Set the behaviour of the selected people to %1").arg(name.toLower()));
    action->setEnabled(isEditing);
  }
  menu.addSeparator();
  QAction* mix = menu.addAction(QObject::tr("&Mix…"), parent, [&document, &theme, parent] {
    openMixDialog(document, theme, parent);
  });
  describe(*mix, QObject::tr("Set the shares of behaviours among the selected people, or among "
                             "all"));
  mix->setEnabled(isEditing);
}

BehaviorMixDialog::BehaviorMixDialog(ScenarioDocument& document, const Theme& theme,
                                     QWidget* parent)
    : QDialog(parent), document_(document), people_(selectedOrAllPeople(document)) {
  setWindowTitle(tr("Behaviours of %1").arg(peopleText(people_.size())));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  result_->setWordWrap(true);
  result_->setMinimumWidth(260);
  QWidget* fields = makeMixFields(
      recipe_, theme, [this] { apply(); }, this);
  configuredLayout(new QVBoxLayout(this), {12, 12, 12, 12}, 8, {fields, result_, buttons});
  showShares();
}

/// Accepting the initial mix also applies it. Nothing is pushed before, so that opening the dialog
/// keeps the redo stack.
void BehaviorMixDialog::accept() {
  if (!isTouched_) {
    apply();
  }
  QDialog::accept();
}

void BehaviorMixDialog::reject() {
  undoMix();
  QDialog::reject();
}

/// Starts from the original state each time, so that no part of the previous mix remains.
void BehaviorMixDialog::apply() {
  isTouched_ = true;
  undoMix();
  const int before = document_.undoStack().index();
  pushMix(document_, people_, recipe_);
  const int after = document_.undoStack().index();
  appliedAt_ = after > before ? after : 0;
  showShares();
}

void BehaviorMixDialog::showShares() {
  QStringList words;
  const std::vector<BehaviorType> given = shuffledBehaviors(recipe_, people_.size());
  for (int i = 1; i <= kBehaviorCount; ++i) {
    const auto type = static_cast<BehaviorType>(i);
    if (const auto count = std::count(given.begin(), given.end(), type); count > 0) {
      words << QStringLiteral("%1 %2").arg(count).arg(lookName(lookOf(type)));
    }
  }
  result_->setText(words.join(QStringLiteral(" · ")));
}

void BehaviorMixDialog::undoMix() {
  const int at = std::exchange(appliedAt_, 0);
  if (at > 0 && at == document_.undoStack().index()) {  // Otherwise changed elsewhere.
    document_.undoStack().undo();
  }
}

void openMixDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent) {
  auto* dialog = new BehaviorMixDialog(document, theme, parent->window());
  deleteWhenClosed(*dialog);
  dialog->open();
}

namespace {

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

BlockDialog::BlockDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QDialog(parent),
      document_(document),
      ids_(document.entities(EntityKind::Human)),
      kinds_(new HintList(theme, tr("Blocks"), this)),
      people_(new HintList(theme, tr("People"), this)) {
  setWindowTitle(tr("Add a behaviour block"));
  resize(780, limitedToScreen(*this, 480));
  kinds_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setHint(tr("No people yet"));
  about_->setWordWrap(true);
  for (const bt::BlockType& kind : bt::blockTypes()) {
    new QListWidgetItem(coreText(kind.title), kinds_);
  }
  addPeople(*people_, document, theme);
  auto* middle = new QWidget(this);
  configuredLayout(new QVBoxLayout(middle), {}, -1, {about_, form_})->addStretch(1);
  QScrollArea* area = scrollArea(middle, this);
  area->setMinimumWidth(330);
  auto* columns = configuredLayout(new QHBoxLayout, {}, 16);
  columns->addLayout(titledColumn(tr("Block"), theme, kinds_), 3);
  columns->addLayout(titledColumn(tr("What it does"), theme, area), 5);
  columns->addLayout(titledColumn(tr("People"), theme, people_), 3);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  add_ = buttons->button(QDialogButtonBox::Ok);
  add_->setText(tr("Add"));
  connect(buttons, &QDialogButtonBox::accepted, this, &BlockDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 16);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons);
  connect(kinds_, &QListWidget::currentRowChanged, this, &BlockDialog::showKind);
  connect(form_, &ValueForm::edited, this, [this](const std::string& key, const QString& text) {
    setValue(block_, key, text);
    showBlock();
  });
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
  const bt::BlockType& kind = bt::blockTypes()[static_cast<std::size_t>(row)];
  about_->setText(coreText(kind.description) + QLatin1Char('.'));
  block_ = {kind.id, {}};
  showBlock();
}

std::vector<EntityId> BlockDialog::chosen() const {
  std::vector<EntityId> result;
  for (int row = 0; row < people_->count(); ++row) {
    if (people_->item(row)->checkState() == Qt::Checked) {
      result.push_back(ids_[static_cast<std::size_t>(row)]);
    }
  }
  return result;
}

void BlockDialog::accept() {
  pushAddBlock(document_, chosen(), block_);
  QDialog::accept();
}

}  // namespace editor
