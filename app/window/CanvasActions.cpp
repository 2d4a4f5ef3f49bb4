#include "app/window/CanvasActions.h"

#include "editor/canvas/Tool.h"
#include "editor/look/ActionText.h"
#include "editor/look/Icons.h"
#include "editor/tools/SelectionActions.h"

namespace app {

using editor::CanvasOptions;

CanvasActions::CanvasActions(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  const QString says = tr("Show or hide on the map");
  layers_ = {toggle(tr("&Map"), {}, says, &CanvasOptions::map),
             toggle(tr("&People"), {}, says, &CanvasOptions::people),
             toggle(tr("&Robots"), {}, says, &CanvasOptions::robots),
             toggle(tr("&Goals"), {}, says, &CanvasOptions::goals),
             toggle(tr("&Obstacles and doors"), {}, says, &CanvasOptions::obstacles),
             toggle(tr("&Areas"), {}, says, &CanvasOptions::areas),
             toggle(tr("Gro&ups"), {}, says, &CanvasOptions::groups)};
  snapping_ = {toggle(tr("Snap to p&oints"), QKeySequence(Qt::Key_S),
                      tr("Corners, ends and centres of other things hold what is drawn"),
                      &CanvasOptions::snapToPoints),
               toggle(tr("Snap to &walls"), {},
                      tr("Corners and edges of the map's walls hold what is drawn"),
                      &CanvasOptions::snapToWalls),
               toggle(tr("Snap to the gr&id"), QKeySequence(Qt::SHIFT | Qt::Key_S),
                      tr("What is drawn lies on half metres"), &CanvasOptions::snapToGrid)};
  makeArranging();
  connect(&workspace_.document(), &editor::ScenarioDocument::selectionChanged, this,
          &CanvasActions::followSelection);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &CanvasActions::followSelection);
  followSelection();
}

QAction* CanvasActions::toggle(const QString& text, const QKeySequence& shortcut,
                               const QString& says, bool CanvasOptions::*option) {
  auto* action = new QAction(text, this);
  action->setShortcut(shortcut);
  editor::describe(*action, says);
  action->setCheckable(true);
  editor::MapScene& scene = workspace_.scene();
  action->setChecked(scene.options().*option);
  connect(action, &QAction::toggled, &scene, [&scene, option](bool on) {
    CanvasOptions options = scene.options();
    options.*option = on;
    scene.setOptions(options);
  });
  connect(&scene, &editor::MapScene::optionsChanged, action,
          [action, &scene, option] { action->setChecked(scene.options().*option); });
  return action;
}

QAction* CanvasActions::arrange(const QString& text, const QString& says,
                                const std::function<void()>& work) {
  auto* action = new QAction(text, this);
  editor::describe(*action, says);
  connect(action, &QAction::triggered, this, work);
  return action;
}

void CanvasActions::makeArranging() {
  using editor::Align;
  editor::ScenarioDocument& document = workspace_.document();
  const std::pair<QString, Align> sides[] = {
      {tr("Align &left"), Align::Left},       {tr("Align &centres across"), Align::CentreX},
      {tr("Align &right"), Align::Right},     {tr("Align &tops"), Align::Top},
      {tr("Align &middles"), Align::CentreY}, {tr("Align &bottoms"), Align::Bottom}};
  for (const auto& [text, side] : sides) {
    arranging_.emplace_back(
        arrange(text, tr("Move what is selected onto one line"),
                [&document, how = side] { editor::alignSelection(document, how); }),
        2);
  }
  const QString gaps = tr("Equal gaps between what is selected");
  arranging_.emplace_back(
      arrange(tr("Distribute &across"), gaps,
              [&document] { editor::distributeSelection(document, editor::Distribute::Across); }),
      3);
  arranging_.emplace_back(
      arrange(tr("Distribute &up"), gaps,
              [&document] { editor::distributeSelection(document, editor::Distribute::Up); }),
      3);
  const std::pair<QString, double> turns[] = {{tr("Rotate 15° left\t["), editor::kSnapAngle},
                                              {tr("Rotate 15° right\t]"), -editor::kSnapAngle},
                                              {tr("Rotate 90° left"), 0.5 * base::kPi},
                                              {tr("Rotate 90° right"), -0.5 * base::kPi}};
  for (const auto& [text, angle] : turns) {
    arranging_.emplace_back(
        arrange(text, tr("Turn what is selected about its middle"),
                [&document, by = angle] { editor::rotateSelection(document, by); }),
        1);
  }
}

void CanvasActions::fillArrangeMenu(QMenu& menu) const {
  std::size_t before = 0;
  for (const auto& [action, least] : arranging_) {
    if (before != 0 && least != before) {
      menu.addSeparator();
    }
    menu.addAction(action);
    before = least;
  }
}

void CanvasActions::setTheme(const editor::Theme& theme) {
  snapToPoints()->setIcon(editor::themedIcon(QStringLiteral("snap"), theme));
}

void CanvasActions::followSelection() {
  const bool editing = workspace_.runner().state() == editor::SimulationRunner::State::Editing;
  const std::size_t count = workspace_.document().selection().size();
  for (const auto& [action, least] : arranging_) {
    action->setEnabled(editing && count >= least);
  }
}

QToolButton* makeToolGroup(const std::vector<QAction*>& actions, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setPopupMode(QToolButton::MenuButtonPopup);
  auto* menu = new QMenu(button);
  for (QAction* action : actions) {
    menu->addAction(action);
    QObject::connect(action, &QAction::toggled, button, [button, action](bool on) {
      if (on) {
        button->setDefaultAction(action);
      }
    });
  }
  button->setMenu(menu);
  button->setDefaultAction(actions.front());
  return button;
}

}  // namespace app
