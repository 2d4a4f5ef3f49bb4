#include <algorithm>

#include "editor/panels/EntityPages.h"
#include "editor/panels/KeyAccess.h"
#include "metrics/Samples.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Runner.h"
#include "sim2d/world/World.h"

namespace editor {

namespace {

sim2d::DesktopSettings& desktop(Entity& entity) {
  return std::get<ScenarioSettings>(entity).desktop;
}
const sim2d::DesktopSettings& desktop(const Entity& entity) {
  return std::get<ScenarioSettings>(entity).desktop;
}

QString textOf(const std::optional<std::string>& value) {
  return QString::fromStdString(value.value_or(std::string()));
}

std::optional<std::string> valueOf(const QString& text) {
  return text.isEmpty() ? std::nullopt : std::optional(text.toStdString());
}

}  // namespace

namespace {

TextKey thresholdsKey() {
  TextKey key;
  key.label = QObject::tr("Thresholds");
  key.placeholder = QObject::tr("the usual ones");
  key.hint = QObject::tr("Of metrics, such as name=value, name=value");
  key.get = [](const Entity& entity) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [name, value] : desktop(entity).metrics.parameters) {
      pairs.emplace_back(name, base::formatDouble(value));
    }
    return pairsText(pairs);
  };
  key.set = [](Entity& entity, const QString& text) {
    auto& parameters = desktop(entity).metrics.parameters;
    parameters.clear();
    const auto pairs = pairsFromText(text);
    for (const auto& [name, value] : pairs.value()) {
      parameters.emplace_back(name, base::parseDouble(value).value_or(0.0));
    }
  };
  key.check = [](const QString& text) {
    const auto pairs = pairsFromText(text);
    const bool numbers = pairs && std::all_of(pairs->begin(), pairs->end(), [](const auto& each) {
                           return base::parseDouble(each.second).has_value();
                         });
    return numbers ? QString() : QObject::tr("name=number, with commas between them");
  };
  return key;
}

/// Worlds that HuNavSim has for a simulator; a map of another name needs one of its own there.
QString worldsOf(const QString& simulator) {
  if (simulator == QLatin1String("Isaac Sim")) {
    return QStringLiteral("warehouse, hospital, office, empty_world");
  }
  if (simulator == QLatin1String("Webots")) {
    return QStringLiteral("factory, hall, office");
  }
  return simulator.isEmpty() ? QString() : QStringLiteral("cafe, house, warehouse");
}

}  // namespace

SettingsPage::SettingsPage(ScenarioDocument& document, QWidget* parent)
    : PropertyPage(document, parent) {
  addRunSection();
  addPeopleSection();
  addMeasureSection();
  addFileSection();
  finish();
}

void SettingsPage::addRunSection() {
  FormSection* section = addSection(tr("Run"));
  NumberKey seed = placedKey(
      tr("Seed"), {}, {0.0, 2147483647.0, 0, 1.0}, 1.0,
      [](Entity & e) -> auto& { return desktop(e).seed; });
  seed.hint = tr("The same seed gives the same run");
  addNumber(section, seed);
  NumberKey duration = placedKey(
      tr("Duration"), tr("s"), {0.05, 86400.0, 1, 5.0}, 60.0,
      [](Entity & e) -> auto& { return desktop(e).duration; });
  duration.fallback = [this](const Entity&) {
    sim2d::Scenario plain;
    plain.robots = this->document().scenario().robots;
    plain.desktop.dt = 1.0;
    return static_cast<double>(sim2d::stopRuleOf(plain).maximumSteps);
  };
  duration.hint = tr("Left out: until the robot has arrived plus 1 s, at most 120 s");
  addNumber(section, duration);
  NumberKey step = placedKey(
      tr("Time step"), tr("s"), {0.001, 0.1, 3, 0.005}, 0.05,
      [](Entity & e) -> auto& { return desktop(e).dt; });
  addNumber(section, step);
  NumberKey record = placedKey(
      tr("Record every"), tr("steps"), {1.0, 10000.0, 0, 1.0}, 1.0,
      [](Entity & e) -> auto& { return desktop(e).recordEvery; });
  record.unitOfOne = tr("step");
  addNumber(section, record);
}

void SettingsPage::addPeopleSection() {
  FormSection* section = addSection(tr("People"));
  ChoiceKey model = nameChoice(
      tr("Model"), tr("sfm (default)"), sim2d::modelNames(),
      [](Entity & e) -> auto& { return desktop(e).model; });
  model.hint = tr("How people move among others");
  addChoice(section, model);
  ChoiceKey route;
  route.label = tr("Routes");
  route.words = QStringList{tr("Around walls"), tr("Straight, as the original")};
  route.get = [](const Entity& entity) {
    return static_cast<int>(desktop(entity).route.value_or(sim2d::Route::Planned));
  };
  route.set = [](Entity& entity, int index) {
    desktop(entity).route = static_cast<sim2d::Route>(index);
  };
  addChoice(section, route);
  ChoiceKey points;
  points.label = tr("Feel walls by");
  points.words = QStringList{tr("Nearest points of walls"), tr("Rays, as a laser")};
  points.get = [](const Entity& entity) {
    return static_cast<int>(
        desktop(entity).obstaclePoints.value_or(sim2d::ObstaclePoints::Boundary));
  };
  points.set = [](Entity& entity, int index) {
    desktop(entity).obstaclePoints = static_cast<sim2d::ObstaclePoints>(index);
  };
  addChoice(section, points);
  SwitchKey loop;
  loop.label = tr("Trees");
  loop.words = tr("Start again when they end");
  loop.get = [](const Entity& entity) { return desktop(entity).loopTrees.value_or(true); };
  loop.set = [](Entity& entity, bool on) { desktop(entity).loopTrees = on; };
  addSwitch(section, loop);
  TextKey corridor;
  corridor.label = tr("Corridor");
  corridor.placeholder = tr("no ring");
  corridor.hint = tr("Two values of x [m]: who passes the second comes in at the first");
  corridor.get = [](const Entity& entity) { return listText(desktop(entity).wrapX); };
  corridor.set = [](Entity& entity, const QString& text) {
    desktop(entity).wrapX = listFromText(text).value_or(std::vector<double>());
  };
  corridor.check = [](const QString& text) {
    const auto ends = listFromText(text);
    return ends && (ends->empty() || (ends->size() == 2 && (*ends)[0] < (*ends)[1]))
               ? QString()
               : tr("Two values of x in metres, ascending, with a comma between them");
  };
  addText(section, corridor);
}

void SettingsPage::addMeasureSection() {
  FormSection* section = addSection(tr("Measuring"));
  const auto window = [](std::optional<std::string> sim2d::MetricsSettings::*member) {
    TextKey key;
    key.get = [member](const Entity& entity) { return textOf(desktop(entity).metrics.*member); };
    key.set = [member](Entity& entity, const QString& text) {
      desktop(entity).metrics.*member = valueOf(text);
    };
    key.check = [member](const QString& text) {
      metrics::Window wanted;
      if (!text.isEmpty()) {
        (member == &sim2d::MetricsSettings::from ? wanted.from : wanted.until) = text.toStdString();
      }
      return QString::fromStdString(metrics::windowProblem(wanted));
    };
    return key;
  };
  TextKey from = window(&sim2d::MetricsSettings::from);
  from.label = tr("From");
  from.placeholder = tr("begin");
  from.hint = tr("begin, goal, motion, time 5.0 or event contact");
  addText(section, from);
  TextKey until = window(&sim2d::MetricsSettings::until);
  until.label = tr("Until");
  until.placeholder = tr("end");
  until.hint = tr("end, arrival, time 20.0 or event contact");
  addText(section, until);
  NumberKey frequency = placedKey(
      tr("Frequency"), tr("Hz"), {0.0, 1000.0, 1, 1.0}, 0.0,
      [](Entity & e) -> auto& { return desktop(e).metrics.frequency; });
  frequency.hint = tr("0 takes every recorded sample");
  addNumber(section, frequency);
  TextKey tag;
  tag.label = tr("Tag");
  tag.placeholder = QStringLiteral("exp_1");
  tag.get = [](const Entity& entity) { return textOf(desktop(entity).metrics.tag); };
  tag.set = [](Entity& entity, const QString& text) {
    desktop(entity).metrics.tag = valueOf(text);
  };
  addText(section, tag);
  NumberKey run = placedKey(
      tr("Run number"), {}, {0.0, 1000000.0, 0, 1.0}, 0.0,
      [](Entity & e) -> auto& { return desktop(e).metrics.runId; });
  addNumber(section, run);
  TextKey file;
  file.label = tr("Metrics file");
  file.placeholder = tr("all metrics");
  file.hint = tr("Which metrics are measured; relative to the scenario");
  file.get = [](const Entity& entity) { return textOf(desktop(entity).metrics.file); };
  file.set = [](Entity& entity, const QString& text) {
    desktop(entity).metrics.file = valueOf(text);
  };
  addText(section, file);
  addText(section, thresholdsKey());
}

void SettingsPage::addFileSection() {
  FormSection* section = addSection(tr("Simulator and map"));
  ChoiceKey simulator;
  simulator.label = tr("Simulator");
  const QStringList names = {QStringLiteral("Gazebo Classic"), QStringLiteral("Gazebo Fortress"),
                             QStringLiteral("Isaac Sim"), QStringLiteral("Webots")};
  simulator.words = QStringList{tr("not said")} + names;
  simulator.get = [names](const Entity& entity) {
    return names.indexOf(textOf(std::get<ScenarioSettings>(entity).simulator)) + 1;
  };
  simulator.set = [names](Entity& entity, int index) {
    std::get<ScenarioSettings>(entity).simulator =
        index == 0 ? std::nullopt : valueOf(names[index - 1]);
  };
  simulator.hint = tr("The simulator that HuNavSim runs the file in");
  addChoice(section, simulator);
  TextKey map;
  map.label = tr("Map name");
  map.placeholder = tr("none");
  map.get = [](const Entity& entity) { return textOf(std::get<ScenarioSettings>(entity).map); };
  map.set = [](Entity& entity, const QString& text) {
    std::get<ScenarioSettings>(entity).map = valueOf(text);
  };
  addText(section, map);
  auto* worlds = secondaryLabel({}, this);
  worlds->setWordWrap(true);
  section->addRow(tr("Its worlds"), worlds);
  addRefresh([section, worlds](const std::vector<Entity>& shown) {
    const QString known = worldsOf(textOf(std::get<ScenarioSettings>(shown.front()).simulator));
    worlds->setText(known);
    section->setRowVisible(worlds, !known.isEmpty());
  });
  TextKey file;
  file.label = tr("Map file");
  file.placeholder = tr("looked for");
  file.hint = tr("Relative to the scenario; none is the open plane. Counts from the next opening");
  file.get = [](const Entity& entity) { return textOf(desktop(entity).mapFile); };
  file.set = [](Entity& entity, const QString& text) { desktop(entity).mapFile = valueOf(text); };
  addText(section, file);
  ChoiceKey rule;
  rule.label = tr("Map rule");
  rule.words = QStringList{tr("humble (default)"), QStringLiteral("main")};
  rule.hint = tr("How grey pixels are read: by the map server of ROS Humble or of today");
  rule.get = [](const Entity& entity) { return desktop(entity).mapRule == "main" ? 1 : 0; };
  rule.set = [](Entity& entity, int index) {
    desktop(entity).mapRule = index == 0 ? std::nullopt : std::optional<std::string>("main");
  };
  addChoice(section, rule);
  SwitchKey publish;
  publish.label = tr("ROS topics");
  publish.words = tr("Publish people");
  publish.get = [](const Entity& entity) {
    return std::get<ScenarioSettings>(entity).publishPeople.value_or(true);
  };
  publish.set = [](Entity& entity, bool on) {
    std::get<ScenarioSettings>(entity).publishPeople = on;
  };
  addSwitch(section, publish);
}

}  // namespace editor
