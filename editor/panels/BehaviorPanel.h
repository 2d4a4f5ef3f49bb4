#pragma once

#include <functional>

#include <QLabel>
#include <QStackedLayout>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "bt/human/Blocks.h"
#include "editor/document/PersonTree.h"
#include "editor/look/PanelMenu.h"
#include "editor/panels/TreeOutline.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

class ValueForm;

/// The right dock's second tab: the behaviour tree of the person who is selected, as an outline,
/// with the values of the node or block that is chosen below it. Follows a run.
class BehaviorPanel : public QWidget {
  Q_OBJECT
 public:
  /// `folder`: where the dialogs for trees begin.
  BehaviorPanel(ScenarioDocument& document, SimulationRunner& runner, const Theme& theme,
                std::function<QString()> folder);
  void setTheme(const Theme& theme);
  TreeOutline& outline() const { return *outline_; }
  EntityId person() const { return person_; }
  QTableWidget& entries() const { return *entries_; }
  /// Takes the text of a file as the person's own tree; what is wrong with it is told and nothing
  /// is changed when it cannot be read.
  base::Diagnostics takeTreeFrom(const QString& path, EntityId person);
  base::Diagnostics saveTreeTo(const QString& path, EntityId person) const;
  /// The tree that this behaviour makes, and the behaviour with it: one command.
  void takeTemplate(sim2d::BehaviorType type);

 Q_SIGNALS:
  void told(const base::Diagnostics& problems);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makePage();
  void makeLinks(QVBoxLayout& layout);
  void follow();
  /// False for a moment after the person was taken away, before the panel is built anew.
  bool hasPerson() const { return document_.human(person_) != nullptr; }
  void rebuild();
  void showWords();
  void showNode();
  void showStatus();
  void offerTemplates();
  void offerBreakpoints(const QPoint& at);
  void showBreakpoints();
  void showEntries();
  void askForTree();
  void askForFile();
  void editBlock(const std::string& key, const QString& text);
  void moveBlock(int by);    // 0 = remove it
  int currentBlock() const;  // place among the blocks, -1 = another node

  ScenarioDocument& document_;
  Theme theme_;
  SimulationRunner& runner_;
  std::function<QString()> folder_;
  EntityId person_;
  PersonTree tree_;
  std::vector<bt::Block> blocks_;  // of its main tree
  bool stale_ = false;             // the document has changed while this was hidden
  QStackedLayout* stack_;
  QLabel *name_, *about_, *problem_;
  QToolButton *add_, *template_, *anew_, *takeRoute_, *earlier_, *later_;
  TreeOutline* outline_;
  QWidget* blockLinks_;
  ValueForm *blockForm_, *portForm_;
  QLabel* hint_;  // while no node is chosen
  QLabel* entriesTitle_;
  QTableWidget* entries_;  // of the blackboard, in a run
  PanelMenu menu_;         // about the person
};

}  // namespace editor
