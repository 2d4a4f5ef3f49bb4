#include <algorithm>

#include "app/window/WindowActions.h"
#include "editor/canvas/MapScene.h"

/// The commands that show and hide what the map has: layers, overlays and snapping.
namespace app {

using editor::CanvasOptions;

namespace {

constexpr int kWithShift = Qt::SHIFT;  // an integer: keys and modifiers are different enums
constexpr const char* kOpacities = "map/opacities";
constexpr const char* kShowOrHide =
    QT_TRANSLATE_NOOP("app::WindowActions", "Show or hide on the map");

/// Connects a checkable action with an option of the map.
void bindOption(QAction& action, editor::MapScene& scene, bool CanvasOptions::*option) {
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

}  // namespace

/// A checkable command for an option of the map.
struct WindowActions::Toggle {
  const char* text;
  bool CanvasOptions::*option;
  int shortcut;  // 0: none
  const char* tip;
  const char* key = nullptr;  // key of the stored state; null: not stored
  QAction* WindowActions::*action = nullptr;
  const char* icon = nullptr;
};

namespace {

using Named = std::pair<const char*, bool CanvasOptions::*>;
constexpr Named kOverlayNames[] = {
    {"density", &CanvasOptions::density},   {"sight", &CanvasOptions::sight},
    {"gaussian", &CanvasOptions::gaussian}, {"velocities", &CanvasOptions::velocities},
    {"plans", &CanvasOptions::plans},       {"contacts", &CanvasOptions::contacts},
    {"thoughts", &CanvasOptions::thoughts}, {"zones", &CanvasOptions::proxemics},
    {"forces", &CanvasOptions::forces},     {"local-costs", &CanvasOptions::localCosts},
    {"ways", &CanvasOptions::candidates},   {"global-costs", &CanvasOptions::globalCosts},
    {"laser", &CanvasOptions::lidar},       {"masks", &CanvasOptions::masks}};

}  // namespace

std::vector<std::string> WindowActions::overlayNames() {
  std::vector<std::string> all;
  for (const auto& [name, option] : kOverlayNames) {
    all.emplace_back(name);
  }
  return all;
}

void WindowActions::showOverlays(const std::vector<std::string>& shown) {
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [name, option] : kOverlayNames) {
    const bool isWanted = std::find(shown.begin(), shown.end(), name) != shown.end();
    const bool isUsual = option != &CanvasOptions::lidar;  // in pictures only if requested
    options.*option = isWanted || (isUsual && options.*option);
  }
  workspace_.scene().setOptions(options);
}

QList<QAction*> WindowActions::togglesOf(const std::vector<Toggle>& rows) {
  QList<QAction*> all;
  for (const Toggle& row : rows) {
    QAction* action = make(tr(row.text), tr(row.tip), row.shortcut, row.icon);
    bindOption(*action, workspace_.scene(), row.option);
    action->setIconVisibleInMenu(false);  // there it has a check mark
    optionOf_[action] = row.option;
    all << action;
    if (row.action != nullptr) {
      this->*row.action = action;
    }
    if (row.key != nullptr) {
      stored_.emplace_back(action, row.key);
    }
  }
  return all;
}

void WindowActions::makeToggles() {
  makeOverlays();
  makeLayers();
  makeSnapping();
  makeRunOverlays();
}

void WindowActions::makeOverlays() {
  using Actions = WindowActions;
  using Options = CanvasOptions;
  overlays = togglesOf(
      {{QT_TRANSLATE_NOOP("app::WindowActions", "&Names"), &Options::names, Qt::Key_N, kShowOrHide,
        "map/names", &Actions::names, "view-names"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Rou&tes"), &Options::routes,
        kWithShift | Qt::Key_R, kShowOrHide, "map/routes", &Actions::routes, "tool-route"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Grid"), &Options::grid, kWithShift | Qt::Key_G,
        kShowOrHide, "map/grid", &Actions::grid, "view-grid"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "R&ulers"), &Options::rulers, 0, kShowOrHide,
        "map/rulers"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Tr&ails"), &Options::trails, Qt::Key_T,
        QT_TRANSLATE_NOOP("app::WindowActions", "Past paths of people in a run"), "map/trails",
        nullptr, "view-trails"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Personal spaces"), &Options::proxemics, Qt::Key_X,
        QT_TRANSLATE_NOOP(
            "app::WindowActions",
            "Hall's zones around selected people; in a run around all if none is selected"),
        "map/rings", &Actions::rings, "view-rings"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "For&ces"), &Options::forces,
        kWithShift | Qt::Key_F,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Forces on selected people in a run; on all if none is selected"),
        "map/forces", &Actions::forces, "view-forces"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Robot pat&hs"), &Options::robotPath, 0,
        QT_TRANSLATE_NOOP("app::WindowActions", "Paths that robot planners follow in a run"),
        "map/robotPath"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Lid&ar scans"), &Options::lidar,
        kWithShift | Qt::Key_L,
        QT_TRANSLATE_NOOP("app::WindowActions", "Lidar scans of robots in a run"), "map/lidar",
        &Actions::lidar},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Detections"), &Options::detections,
        kWithShift | Qt::Key_D,
        QT_TRANSLATE_NOOP(
            "app::WindowActions",
            "Positions of people and of the robots, as estimated by the robots in a run"),
        "map/detections", &Actions::detections},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Candidate tra&jectories"), &Options::candidates,
        kWithShift | Qt::Key_W,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Trajectories that robot planners evaluated in a run"),
        "map/ways", &Actions::candidates}});
}

void WindowActions::makeLayers() {
  using Options = CanvasOptions;
  layers = togglesOf(
      {{QT_TRANSLATE_NOOP("app::WindowActions", "&Map"), &Options::map, 0, kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&People"), &Options::people, 0, kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Robots"), &Options::robots, 0, kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Goals"), &Options::goals, 0, kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Obstacles and doors"), &Options::obstacles, 0,
        kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Areas and docks"), &Options::areas, 0,
        kShowOrHide},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Gro&ups"), &Options::groups, 0, kShowOrHide}});
}

void WindowActions::makeSnapping() {
  using Options = CanvasOptions;
  snapping = togglesOf(
      {{QT_TRANSLATE_NOOP("app::WindowActions", "Snap to p&oints"), &Options::snapToPoints,
        Qt::Key_S,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Snap drawn items to corners, ends and centres of other items"),
        nullptr, &WindowActions::snapToPoints, "snap"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Snap to &walls"), &Options::snapToWalls, 0,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Snap drawn items to corners and edges of map walls")},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Snap to the gr&id"), &Options::snapToGrid,
        kWithShift | Qt::Key_S,
        QT_TRANSLATE_NOOP("app::WindowActions", "Snap drawn items to a grid of 0.5 m")},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Alignment guides"), &Options::guides, 0,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Align dragged items with edges, centres and distances of "
                          "others; Alt suspends this"),
        "map/guides"}});
}

void WindowActions::makeRunOverlays() {
  using Options = CanvasOptions;
  runOverlays = togglesOf(
      {{QT_TRANSLATE_NOOP("app::WindowActions", "&Density of people"), &Options::density,
        kWithShift | Qt::Key_H,
        QT_TRANSLATE_NOOP("app::WindowActions", "People per m² as a colour map"), "map/density"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Field of view"), &Options::sight,
        kWithShift | Qt::Key_E,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Area that the selected people see; walls block the view"),
        "map/sight"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Gaussian spaces"), &Options::gaussian,
        kWithShift | Qt::Key_X,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Gaussian personal space, longer in the walking direction"),
        "map/gaussian"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Velocities"), &Options::velocities,
        kWithShift | Qt::Key_V,
        QT_TRANSLATE_NOOP("app::WindowActions", "Velocity vector of each body"), "map/velocities"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Peopl&e's paths"), &Options::plans,
        kWithShift | Qt::Key_P,
        QT_TRANSLATE_NOOP("app::WindowActions", "Remaining path of each person; newest step only"),
        "map/plans"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "C&ontacts"), &Options::contacts,
        kWithShift | Qt::Key_C,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Where bodies touched, and which body ran into the other"),
        "map/contacts"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "T&houghts"), &Options::thoughts,
        kWithShift | Qt::Key_T,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Current action of each person and its reason, below the name"),
        "map/thoughts"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Speech"), &Options::speech,
        kWithShift | Qt::Key_B,
        QT_TRANSLATE_NOOP("app::WindowActions", "What people say, and which people hear it"),
        "map/speech"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "&Local costmap"), &Options::localCosts,
        kWithShift | Qt::Key_M,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Local costmap that the controller of a robot with Nav2 uses"),
        "map/localCosts"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "Gl&obal costmap"), &Options::globalCosts,
        kWithShift | Qt::Key_K,
        QT_TRANSLATE_NOOP("app::WindowActions",
                          "Global costmap that the planner of a robot with Nav2 uses"),
        "map/globalCosts"},
       {QT_TRANSLATE_NOOP("app::WindowActions", "F&ilter masks"), &Options::masks,
        kWithShift | Qt::Key_J,
        QT_TRANSLATE_NOOP(
            "app::WindowActions",
            "Keepout zones and speed limits of the costmap filters of a robot with Nav2"),
        "map/masks"}});
}

/// In the order of the panel.
void WindowActions::makeLayerGroups() {
  using Options = CanvasOptions;
  const std::vector<std::pair<QString, std::vector<bool Options::*>>> groups = {
      {tr("Background"), {&Options::map, &Options::grid, &Options::rulers}},
      {tr("Scenario"),
       {&Options::people, &Options::robots, &Options::goals, &Options::obstacles, &Options::areas,
        &Options::groups, &Options::names, &Options::routes}},
      {tr("People in a run"),
       {&Options::trails, &Options::proxemics, &Options::forces, &Options::density, &Options::sight,
        &Options::gaussian, &Options::velocities, &Options::plans, &Options::contacts,
        &Options::thoughts, &Options::speech}},
      {tr("Robots in a run"),
       {&Options::robotPath, &Options::lidar, &Options::detections, &Options::candidates,
        &Options::localCosts, &Options::globalCosts, &Options::masks}}};
  for (const auto& [title, options] : groups) {
    LayerGroup& group = layerGroups_.emplace_back(LayerGroup{title, {}});
    for (const auto option : options) {
      group.layers.push_back({actionOf(option), option});
    }
  }
}

/// The action of an option, which has one.
QAction* WindowActions::actionOf(bool CanvasOptions::*option) const {
  const auto found = std::find_if(optionOf_.begin(), optionOf_.end(),
                                  [option](const auto& each) { return each.second == option; });
  Q_ASSERT(found != optionOf_.end());
  return found->first;
}

void WindowActions::restoreOpacities(const UserSettings& userSettings) {
  const QVariantMap stored = userSettings.value(kOpacities).toMap();
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [action, key] : stored_) {
    const double opacity = stored.value(QString::fromLatin1(key), 1.0).toDouble();
    options.setOpacity(optionOf_.at(action), std::clamp(opacity, 0.1, 1.0));
  }
  workspace_.scene().setOptions(options);
}

void WindowActions::storeOpacities(UserSettings& userSettings) const {
  QVariantMap opacities;
  for (const auto& [action, key] : stored_) {
    opacities[QString::fromLatin1(key)] =
        workspace_.scene().options().opacityOf(optionOf_.at(action));
  }
  userSettings.setValue(kOpacities, opacities);
}

void WindowActions::restoreAndStore(UserSettings& userSettings) {
  restoreOpacities(userSettings);
  for (const auto& [action, key] : stored_) {
    const QVariant before = userSettings.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&userSettings, where = key](bool on) { userSettings.setValue(where, on); });
  }
}

}  // namespace app
