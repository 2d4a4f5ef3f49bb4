#pragma once

#include "editor/look/DeferredActions.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/trees/NodeFields.h"
#include "editor/trees/RunningNodes.h"
#include "editor/trees/TreeCanvas.h"
#include "editor/trees/TreeEdits.h"
#include "editor/trees/TreeHistory.h"
#include "editor/trees/TreeViews.h"

namespace editor {

/// The behaviour tree of a person as an editable graph: the node palette on the left, the graph,
/// and below it the return values over time or the XML. Shows the person selected last. Each edit
/// is one command of the document.
class TreeEditor : public QWidget {
  Q_OBJECT
 public:
  explicit TreeEditor(PanelContext& context);
  void setTheme(const Theme& theme);

  TreeCanvas& canvas() const { return *canvas_; }
  NodePalette& palette() const { return *palette_; }
  TreeHistory& history() const { return *history_; }
  TreeText& text() const { return *text_; }
  BlackboardView& entries() const { return *entries_; }
  QTabWidget& lower() const { return *lower_; }  // History, text and entries.
  EntityId person() const { return person_; }
  /// The people changed by an edit: all who have an identical custom tree, unless that option is
  /// off.
  std::vector<EntityId> edited() const;
  QToolButton& sharing() const { return *sharing_; }
  QToolButton& positionSource() const {
    return *positionSource_;
  }                                            // Hidden if the file contains no positions.
  MapInset& inset() const { return *inset_; }  // Visible while the map is hidden.
  QString hint() const { return hint_->text(); }
  QString problem() const { return problem_->isHidden() ? QString() : problem_->text(); }
  QLineEdit& nameField() const { return *nameField_; }
  NodeFields& fields() const { return *fields_; }
  RunningNodes& running() const { return *running_; }

  void choose(int node);  // Emits `nodeChosen`.
  /// Chooses the person and the node of an issue in a tree, if the editor is visible.
  void showIssue(const base::Diagnostic& issue);
  /// Shows why a run was refused: chooses the person and the node of the first error in a tree.
  /// Returns false if no error concerns a tree.
  bool showRefusedRun(const base::Diagnostics& problems);
  /// Fills the context menu of a node; -1: of the tree.
  void fillMenu(QMenu& menu, int node);

  // Edits of the selected nodes, or of the chosen one if only one applies. Each is one command and
  // reports why it is impossible.
  void add(const QString& xml);
  void addAt(const QString& xml, const DropTarget& to);
  void move(int node, const DropTarget& to);
  void moveBy(int places);  // Among its siblings.
  void remove();
  void duplicate();
  void cut();
  void copy();
  void paste();
  void wrapIn(const std::string& id);
  void replaceBy(const std::string& id);
  void unwrap();
  void extract();
  void inlineSubtree();  // Inlines a SubTree.
  void beginRename();
  /// Opens the name and the ports of the chosen node as fields in its place.
  void editFields();
  /// Replaces the tree by one whose root is an empty Sequence.
  void startNewTree();
  /// The goal or person selected next becomes the value of a port.
  void pick(const std::string& port);
  bool isPicking() const { return !pickedPort_.empty(); }
  void assignTreeTo(EntityId other);  // Assigns the same tree, or restores the own one.

 Q_SIGNALS:
  void nodeChosen(int node);
  void personShown(editor::EntityId person);  // None: the editor is hidden.
  void pictureRequested(editor::EntityId person);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Edit = std::function<OptionalLocations(bt::TreeFile&)>;
  using EditOfNode = std::function<OptionalLocation(bt::TreeFile&, const NodeLocation&)>;
  using EditOfNodes =
      std::function<OptionalLocations(bt::TreeFile&, const std::vector<NodeLocation>&)>;
  using WhyNotOne = std::function<QString(const bt::TreeFile&, const NodeLocation&)>;
  using WhyNot = std::function<QString(const bt::TreeFile&, const std::vector<NodeLocation>&)>;
  /// Applies the edit, or shows why it is impossible (not empty).
  bool apply(const QString& text, const QString& whyNot, const Edit& edit);
  bool applyToChosen(const QString& text, const WhyNotOne& whyNot, const EditOfNode& edit);
  bool applyToSelected(const QString& text, const WhyNot& whyNot, const EditOfNodes& edit);
  /// No places: one is in an included file.
  bool applyTo(const OptionalLocations& places, const QString& text, const WhyNot& whyNot,
               const EditOfNodes& edit);
  /// Positions in the file without descendants of other selected nodes; none if one of them is in
  /// an included file.
  OptionalLocations selectedLocations() const;
  QString selectedNodesText() const;
  QString selectedText() const;  // XML.
  static QString readOnlyText();
  static bool isPickable(const std::string& port);
  void fillMultiSelectionMenu(QMenu& menu);
  void makeLayout();
  QWidget* makeHead();
  void connectParts();
  void follow();
  void rebuild();
  void showProblems(const base::Diagnostics& problems, const QString& title = {});
  void colorProblem(const Theme& theme);
  int faultyNode(const base::Diagnostic& issue) const;
  void listPeople();
  void showSharing();
  void showChosen();  // Updates the parts beside the graph.
  void applyText(const std::string& xml);
  int lineOf(int node) const;  // Line in the text; 0 = none.
  int nodeAtLine(int line) const;
  void showStatuses();
  void showBreakpoints();
  void showAssignMenu();
  void openNode(int node);
  void handleKey(int key, Qt::KeyboardModifiers modifiers);
  void addKinds(QMenu& menu, const QString& title, bool areParents,
                const std::function<QString(const bt::NodeSpec&)>& whyNot,
                const std::function<void(const std::string&)>& take);
  void addStructureEntries(QMenu& menu, const NodeLocation& place);
  void addViewEntries(QMenu& menu, int node);
  void fillTreeMenu(QMenu& menu);
  void addPicks(QMenu& menu, const bt::NodeSpec& node);
  bool finishPick();
  void endRename(bool take);
  void applyFields(const bt::NodeSpec& edited);
  void showHint(const QString& text);
  void placeInset();
  void placeProblem();
  bool isAnyFolded() const;
  void updateLayoutButtons();
  const sim2d::Human* human() const { return context_.document.human(person_); }
  QString label(int node) const;

  PanelContext& context_;
  ScenarioDocument& document_;
  SimulationRunner& runner_;
  EntityId person_;
  bool stale_ = true;
  bool choosing_ = false;
  std::string pickedPort_;
  QComboBox* people_ = new ChoiceField(this);
  QToolButton *sharing_, *turn_, *folds_, *assignButton_, *newTree_, *positionSource_;
  QLabel *hint_ = new QLabel(this), *problem_ = new QLabel(this),
         *empty_ = emptyState(tr("No people yet: press P and click on the map."), this);
  QTimer hintTimer_;
  TreeCanvas* canvas_;
  NodePalette* palette_;
  TreeHistory* history_;
  TreeText* text_;
  BlackboardView* entries_;
  QTabWidget* lower_ = new QTabWidget(this);
  QSplitter* splitter_ = new QSplitter(Qt::Vertical, this);
  bool isSplitByUser_ = false;  // The user has moved the splitter.
  MapInset* inset_;
  QLineEdit* nameField_ = new QLineEdit(canvas_);
  NodeFields* fields_;
  RunningNodes* running_;
  bool isErrorShown_ = false;
  PanelMenu menu_;
  std::vector<int> lines_;  // Line of each node in the text; 0 = in another file.
};

/// "Cannot run: 2 errors"
QString refusedRunText(const base::Diagnostics& problems);

}  // namespace editor
