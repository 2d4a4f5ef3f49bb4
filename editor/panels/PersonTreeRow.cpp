#include <algorithm>

#include "editor/document/PersonTree.h"
#include "editor/panels/EntityPages.h"

// The part of PersonPage that tells of trees of their own.
namespace editor {

namespace {

/// Trees made with blocks follow by themselves and keep their blocks.
std::vector<EntityId> withoutBlocks(const ScenarioDocument& document,
                                    std::vector<EntityId> people) {
  const auto follows = [&document](EntityId id) { return hasFollowingTree(document, id); };
  people.erase(std::remove_if(people.begin(), people.end(), follows), people.end());
  return people;
}

}  // namespace

/// Trees that somebody wrote do not hear of behaviour, reaction and goals, other than those made
/// with blocks: it is told, and mended by a click.
void PersonPage::addTreeRow(FormSection* section) {
  ownTree_ = secondaryLabel({}, this);
  ownTree_->setWordWrap(true);
  section->addRow(QString(), ownTree_);
  treeAnew_ = linkButton(
      tr("Make the tree anew"),
      tr("The tree that behaviour, reaction and goals make; Ctrl+Z brings the other one back"),
      this, [this] { pushTreesAnew(document(), withoutBlocks(document(), targets())); });
  section->addRow(QString(), treeAnew_);
  addRefresh([this, section](const std::vector<Entity>&) { showTreeRow(*section); });
}

void PersonPage::showTreeRow(FormSection& section) {
  constexpr std::size_t kMostAsked = 200;  // whether a tree is behind takes its time
  std::size_t asked = 0, own = 0, behind = 0;
  for (const EntityId id : targets()) {
    if (!document().tree(id)) {
      continue;
    }
    const bool isAsked = ++asked <= kMostAsked;  // the others are taken to be like these
    const bool isOwn = isAsked ? !hasFollowingTree(document(), id) : own > 0;
    own += isOwn ? 1 : 0;
    behind += isOwn && isAsked && document().isTreeBehind(id) ? 1 : 0;
  }
  const bool isOne = targets().size() == 1;
  const QString who =
      isOne ? tr("A tree of their own decides.")
            : tr("%1 with trees of their own.").arg(counted(own, tr("person"), tr("people")));
  const QString what = behind > 0 ? isOne ? tr("It does not hear of what was changed here.")
                                          : tr("Their trees do not hear of what was changed here.")
                       : isOne ? tr("Behaviour, reaction and goals do not reach it.")
                                  : tr("Behaviour, reaction and goals do not reach their trees.");
  ownTree_->setText(who + QLatin1Char(' ') + what);
  section.setRowVisible(ownTree_, own > 0);
  section.setRowVisible(treeAnew_, own > 0);
}

}  // namespace editor
