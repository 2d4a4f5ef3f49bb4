#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>

#include "editor/look/PanelMenu.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/trees/MapInset.h"
#include "editor/trees/NodePalette.h"
#include "editor/trees/TreeCanvas.h"
#include "editor/trees/TreeEntries.h"
#include "editor/trees/TreeGroups.h"
#include "editor/trees/TreeHistory.h"
#include "editor/trees/TreeText.h"

namespace editor {

/// The behaviour tree of a person as a graph that is edited and watched: what the tree is made of
/// at the left, the graph, and below it what its nodes returned over time, or its XML. Shows the
/// person who was selected last. Every edit is one command of the document.
class TreeStudio : public QWidget {
  Q_OBJECT
 public:
  explicit TreeStudio(PanelContext& context);
  void setTheme(const Theme& theme);

  TreeCanvas& canvas() const { return *canvas_; }
  NodePalette& palette() const { return *palette_; }
  TreeHistory& history() const { return *history_; }
  TreeText& text() const { return *text_; }
  TreeEntries& entries() const { return *entries_; }
  QTabWidget& lower() const { return *lower_; }  // history, text and entries
  EntityId person() const { return person_; }
  /// Who is changed by an edit: all who have the very same tree of their own, unless the switch for
  /// that is off.
  std::vector<EntityId> edited() const;
  QToolButton& sharing() const { return *sharing_; }
  QToolButton& placing() const { return *placing_; }  // hidden where the file has no places
  MapInset& inset() const { return *inset_; }         // while the map is not seen
  QString hint() const { return hint_->text(); }
  QString problem() const { return problem_->isHidden() ? QString() : problem_->text(); }
  QLineEdit& nameField() const { return *nameField_; }

  void choose(int node);  // tells others
  /// What can be done with a node of the tree; -1: with the tree.
  void fillMenu(QMenu& menu, int node);

  // edits of the nodes that are selected, or of the one that is chosen where it says "it"; each is
  // one command, and they say why when they cannot be done
  void add(const QString& xml);
  void addAt(const QString& xml, const DropPlace& to);
  void move(int node, const DropPlace& to);
  void moveBy(int places);  // among its siblings
  void remove();
  void duplicate();
  void cut();
  void copy();
  void paste();
  void wrapIn(const std::string& id);
  void replaceBy(const std::string& id);
  void unwrap();
  void extract();
  void putInPlace();  // what a SubTree runs
  void beginRename();
  /// The next goal or person that is selected becomes the value of a port.
  void pick(const std::string& port);
  bool isPicking() const { return !pickedPort_.empty(); }
  void giveTo(EntityId other);  // the same tree, or back to the own one

 Q_SIGNALS:
  void nodeChosen(int node);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Edit = std::function<MaybePlaces(bt::TreeFile&)>;
  bool apply(const QString& text, const QString& ifNot, const Edit& edit);
  bool applyToChosen(const QString& text, const QString& ifNot,
                     const std::function<MaybePlace(bt::TreeFile&, const TreePlace&)>& edit);
  bool applyToSelected(
      const QString& text, const QString& ifNot,
      const std::function<MaybePlaces(bt::TreeFile&, const std::vector<TreePlace>&)>& edit);
  /// Of the file, outer ones alone; nothing: one of them is in an included file.
  std::optional<std::vector<TreePlace>> selectedPlaces() const;
  QString selectedWords() const;
  QString selectedText() const;  // XML
  static bool isPickable(const std::string& port);
  void fillMenuOfSeveral(QMenu& menu);
  void makeLayout();
  QWidget* makeHead();
  void connectParts();
  void follow();
  void rebuild();
  void showProblems(const base::Diagnostics& problems);
  void listPeople();
  void showSharing();
  void showChosen();  // in the parts beside the graph
  void takeText(const std::string& xml);
  int lineOf(int node) const;  // in the text; 0 = none
  int nodeAtLine(int line) const;
  void showStatuses();
  void showBreakpoints();
  void offerGiving();
  void openNode(int node);
  void doKey(int key, Qt::KeyboardModifiers modifiers);
  void addKinds(QMenu& menu, const QString& title, bool areParents,
                const std::function<void(const std::string&)>& take);
  void addPicks(QMenu& menu, const bt::NodeSpec& node);
  bool takePicked();
  void endRename(bool take);
  void say(const QString& text);
  void placeInset();
  bool isAnyFolded() const;
  void showPlacing();
  const sim2d::Human* human() const { return context_.document.human(person_); }
  QString label(int node) const;

  PanelContext& context_;
  ScenarioDocument& document_;
  SimulationRunner& runner_;
  EntityId person_;
  bool stale_ = true;
  bool choosing_ = false;
  std::string pickedPort_;
  QComboBox* people_;
  QToolButton *sharing_, *turn_, *folds_, *give_, *placing_;
  QLabel *hint_, *problem_, *empty_;
  QTimer hintTimer_;
  TreeCanvas* canvas_;
  NodePalette* palette_;
  TreeHistory* history_;
  TreeText* text_;
  TreeEntries* entries_;
  QTabWidget* lower_;
  QSplitter* halves_;
  bool isDivided_ = false;  // by the user
  MapInset* inset_;
  QLineEdit* nameField_;
  PanelMenu menu_;
  std::vector<int> lines_;  // of the nodes in the text, 0 = in another file
};

}  // namespace editor
