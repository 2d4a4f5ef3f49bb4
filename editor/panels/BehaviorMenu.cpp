#include "editor/panels/BehaviorMenu.h"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/document/BehaviorValues.h"
#include "editor/document/EditCommands.h"
#include "editor/look/DeleteWhenClosed.h"
#include "editor/look/Form.h"
#include "editor/tools/CrowdOptions.h"

namespace editor {

using sim2d::BehaviorType;

namespace {

void makeAllBehave(ScenarioDocument& document, BehaviorType type) {
  std::vector<Entity> people;
  for (const EntityId id : document.selection()) {
    if (const sim2d::Human* human = document.human(id)) {
      people.emplace_back(*human);
      auto& person = std::get<sim2d::Human>(people.back());
      person.behavior.type = type;
      completeReaction(document.scenario(), person);
    }
  }
  pushEdit(document, std::move(people),
           QObject::tr("Make %1").arg(lookName(lookOf(type)).toLower()));
}

}  // namespace

std::vector<EntityId> peopleMeant(const ScenarioDocument& document) {
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
        menu.addAction(name, &document, [&document, type] { makeAllBehave(document, type); });
    describe(*action, QObject::tr("Make the people that are selected %1").arg(name.toLower()));
    action->setEnabled(isEditing);
  }
  menu.addSeparator();
  QAction* mix = menu.addAction(QObject::tr("&Mix…"), parent,
                                [&document, &theme, parent] { openMix(document, theme, parent); });
  describe(*mix, QObject::tr("Shares of behaviours among those selected, or among everybody"));
  mix->setEnabled(isEditing);
}

MixDialog::MixDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QDialog(parent),
      document_(document),
      people_(peopleMeant(document)),
      result_(secondaryLabel({}, this)) {
  setWindowTitle(tr("Behaviours of %1").arg(peopleText(people_.size())));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  result_->setWordWrap(true);
  result_->setMinimumWidth(260);
  QWidget* fields = makeMixFields(
      recipe_, theme, [this] { apply(); }, this);
  arranged(new QVBoxLayout(this), {12, 12, 12, 12}, 8, {fields, result_, buttons});
  showShares();
}

/// The mix as it was offered is one too. Nothing is pushed before: opening keeps what can be
/// redone.
void MixDialog::accept() {
  if (!isTouched_) {
    apply();
  }
  QDialog::accept();
}

void MixDialog::reject() {
  takeBack();
  QDialog::reject();
}

/// Every time from how they were, so that nothing of the mix before is left.
void MixDialog::apply() {
  isTouched_ = true;
  takeBack();
  const int before = document_.undoStack().index();
  pushMix(document_, people_, recipe_);
  const int after = document_.undoStack().index();
  appliedAt_ = after > before ? after : 0;
  showShares();
}

void MixDialog::showShares() {
  QStringList words;
  const std::vector<BehaviorType> given = mixedBehaviors(recipe_, people_.size());
  for (int i = 1; i <= kBehaviorCount; ++i) {
    const auto type = static_cast<BehaviorType>(i);
    if (const auto count = std::count(given.begin(), given.end(), type); count > 0) {
      words << QStringLiteral("%1 %2").arg(count).arg(lookName(lookOf(type)));
    }
  }
  result_->setText(words.join(QStringLiteral(" · ")));
}

void MixDialog::takeBack() {
  const int at = std::exchange(appliedAt_, 0);
  if (at > 0 && at == document_.undoStack().index()) {  // else somebody else has changed something
    document_.undoStack().undo();
  }
}

void openMix(ScenarioDocument& document, const Theme& theme, QWidget* parent) {
  auto* dialog = new MixDialog(document, theme, parent->window());
  deleteWhenClosed(*dialog);
  dialog->open();
}

}  // namespace editor
