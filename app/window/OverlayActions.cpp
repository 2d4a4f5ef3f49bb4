#include "app/window/OverlayActions.h"

#include <algorithm>
#include <utility>

#include "editor/look/Form.h"

namespace app {

using editor::CanvasOptions;

void followOption(QAction& action, editor::MapScene& scene, bool CanvasOptions::*option) {
  action.setCheckable(true);
  action.setChecked(scene.options().*option);
  QObject::connect(&action, &QAction::toggled, &scene, [&scene, option](bool on) {
    CanvasOptions options = scene.options();
    options.*option = on;
    scene.setOptions(options);
  });
  QObject::connect(&scene, &editor::MapScene::optionsChanged, &action,
                   [&action, &scene, option] { action.setChecked(scene.options().*option); });
}

OverlayActions::OverlayActions(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  density = toggle(tr("&Density of people"), &CanvasOptions::density, Qt::Key_H,
                   tr("How many people stand per m², as colours"));
  sight = toggle(tr("&Field of view"), &CanvasOptions::sight, Qt::Key_E,
                 tr("What the people that are selected see; walls hide the rest"));
  gaussian = toggle(tr("&Gaussian spaces"), &CanvasOptions::gaussian, Qt::Key_X,
                    tr("Personal space that is longer ahead of who walks"));
  velocities = toggle(tr("&Velocities"), &CanvasOptions::velocities, Qt::Key_V,
                      tr("An arrow for each body, its length the speed"));
  plans = toggle(tr("&Ways of people"), &CanvasOptions::plans, Qt::Key_P,
                 tr("What people follow from here on; only of the newest moment"));
  contacts = toggle(tr("&Contacts"), &CanvasOptions::contacts, Qt::Key_C,
                    tr("Where bodies touched, and who ran into whom"));
  thoughts = toggle(tr("&Thoughts"), &CanvasOptions::thoughts, Qt::Key_T,
                    tr("What people do and why, below their names"));
  speech = toggle(tr("&Speech"), &CanvasOptions::speech, Qt::Key_B,
                  tr("What people say, and who hears it"));
  localCosts = toggle(tr("&Local costmap"), &CanvasOptions::localCosts, Qt::Key_M,
                      tr("What the ground round a robot with Nav2 costs its controller"));
  globalCosts = toggle(tr("Gl&obal costmap"), &CanvasOptions::globalCosts, Qt::Key_K,
                       tr("What the ground costs the planner of a robot with Nav2"));
}

QAction* OverlayActions::toggle(const QString& text, bool CanvasOptions::*option, int letter,
                                const QString& says) {
  auto* action = new QAction(text, this);
  action->setShortcut(int{Qt::SHIFT} | letter);
  editor::describe(*action, says);
  followOption(*action, workspace_.scene(), option);
  all << action;
  return action;
}

namespace {

using Named = std::pair<const char*, bool CanvasOptions::*>;
constexpr Named kOverlayNames[] = {
    {"density", &CanvasOptions::density},   {"sight", &CanvasOptions::sight},
    {"gaussian", &CanvasOptions::gaussian}, {"velocities", &CanvasOptions::velocities},
    {"plans", &CanvasOptions::plans},       {"contacts", &CanvasOptions::contacts},
    {"thoughts", &CanvasOptions::thoughts}, {"zones", &CanvasOptions::proxemics},
    {"forces", &CanvasOptions::forces},     {"local-costs", &CanvasOptions::localCosts},
    {"ways", &CanvasOptions::candidates},   {"global-costs", &CanvasOptions::globalCosts},
    {"laser", &CanvasOptions::lidar}};

}  // namespace

std::vector<std::string> OverlayActions::names() {
  std::vector<std::string> all;
  for (const auto& [name, option] : kOverlayNames) {
    all.emplace_back(name);
  }
  return all;
}

void OverlayActions::show(const std::vector<std::string>& names) {
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [name, option] : kOverlayNames) {
    const bool isWanted = std::find(names.begin(), names.end(), name) != names.end();
    const bool isUsual = option != &CanvasOptions::lidar;  // on at first: in a picture if asked for
    options.*option = isWanted || (isUsual && options.*option);
  }
  workspace_.scene().setOptions(options);
}

void OverlayActions::remember(Memory& memory) {
  const std::pair<QAction*, const char*> kept[] = {
      {density, "map/density"},       {sight, "map/sight"},
      {gaussian, "map/gaussian"},     {plans, "map/plans"},
      {contacts, "map/contacts"},     {velocities, "map/velocities"},
      {thoughts, "map/thoughts"},     {speech, "map/speech"},
      {localCosts, "map/localCosts"}, {globalCosts, "map/globalCosts"}};
  for (const auto& [action, key] : kept) {
    const QVariant before = memory.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&memory, where = key](bool on) { memory.setValue(where, on); });
  }
}

}  // namespace app
