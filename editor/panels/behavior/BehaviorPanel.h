#pragma once

#include "bt/human/BehaviorBlocks.h"
#include "editor/document/PersonTree.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/panels/behavior/BehaviorDialogs.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The second tab of the right dock: the behaviour tree of the selected person as an outline, with
/// the values of the chosen node or block below it. Shows the state of a run.
class BehaviorPanel : public QWidget {
  Q_OBJECT
 public:
  /// `folder`: initial folder of the file dialogs for trees.
  BehaviorPanel(ScenarioDocument& document, SimulationRunner& runner, const Theme& theme,
                std::function<QString()> folder);
  void setTheme(const Theme& theme);
  TreeOutline& outline() const { return *outline_; }
  EntityId person() const { return person_; }
  QTableWidget& entries() const { return *entries_; }
  /// Reads a file as the custom tree of a person. Returns its problems; an unreadable file changes
  /// nothing.
  base::Diagnostics loadTreeFrom(const QString& path, EntityId person);
  base::Diagnostics saveTreeTo(const QString& path, EntityId person) const;
  /// Sets a behaviour and its generated tree: one command.
  void applyTemplate(sim2d::BehaviorType type);
  /// The person that is shown while no person is selected; none: a hint is shown.
  void showPersonOf(EntityId person);

 Q_SIGNALS:
  void problemsReported(const base::Diagnostics& problems);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makePage();
  void makeLinks(QVBoxLayout& layout);
  void follow();
  /// False between the removal of the person and the next rebuild.
  bool hasPerson() const { return document_.human(person_) != nullptr; }
  void rebuild();
  void showSummary();
  void colorProblem();
  void showNode();
  void showStatus();
  void offerTemplates();
  void offerBreakpoints(const QPoint& at);
  void showBreakpoints();
  void showEntries();
  void chooseTreeToLoad();
  void chooseFileToSave();
  void editBlock(const std::string& key, const QString& text);
  void moveBlock(int by);    // 0 = remove it
  int currentBlock() const;  // Index of the block, -1 = another node.

  ScenarioDocument& document_;
  Theme theme_;
  SimulationRunner& runner_;
  std::function<QString()> folder_;
  EntityId person_;
  EntityId otherPerson_;  // Shown while no person is selected.
  PersonTree tree_;
  std::vector<bt::Block> blocks_;  // Blocks of the main tree.
  bool stale_ = false;             // The document has changed while the panel was hidden.
  QStackedLayout* stack_ = new QStackedLayout(this);
  QLabel* empty_ = emptyState({}, this);  // Shown instead of the tree.
  QLabel *name_ = headingLabel({}, theme_.font(12.0, QFont::DemiBold)),
         *about_ = secondaryLabel({}), *problem_ = new QLabel;
  QToolButton *add_, *template_, *regenerate_, *takeRoute_, *earlier_, *later_;
  TreeOutline* outline_;
  QWidget* blockLinks_ = new QWidget;
  ValueForm *blockForm_ = new ValueForm, *portForm_ = new ValueForm;
  QLabel* hint_ = emptyState(tr("Select a node above to see its ports."),
                             this);  // Shown while no node is chosen.
  QLabel* entriesTitle_ = headingLabel(tr("Blackboard"), theme_.font(9.5, QFont::DemiBold));
  QTableWidget* entries_ = new QTableWidget(0, 2);  // Blackboard entries during a run.
  PanelMenu menu_;                                  // Menu for the current person.
};

}  // namespace editor
