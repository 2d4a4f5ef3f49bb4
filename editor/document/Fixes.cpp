#include "editor/document/Fixes.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "editor/document/BehaviorValues.h"
#include "editor/document/EditCommands.h"
#include "editor/document/FixEdits.h"
#include "editor/document/MapEdit.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

using base::Diagnostic;

QString tr(const char* text) {
  return QObject::tr(text);
}

/// A step on one entity of that type.
template <class T, class Edit>
Fix edit(const QString& words, EntityId id, Edit change) {
  return {words, [words, id, change](ScenarioDocument& document) {
            pushChange<T>(document, id, words, change);
          }};
}

/// A step that gets the words of its button.
template <class Edit>
Fix step(const QString& words, Edit change) {
  return {words, [words, change](ScenarioDocument& document) { change(document, words); }};
}

Fix intoFreePlace(const ScenarioDocument&, EntityId id, const Diagnostic& problem) {
  const bool robotGoal = id.kind == EntityKind::Robot && problem.value("place") == "goal";
  return step(tr("Move it out of the wall"),
              [id, robotGoal](ScenarioDocument& document, const QString& words) {
                moveToFreePlace(document, id, robotGoal, words);
              });
}

Fix numberPeople(const ScenarioDocument&, EntityId, const Diagnostic&) {
  return step(tr("Renumber people"), renumberPeople);
}

Fix numberGoals(const ScenarioDocument&, EntityId, const Diagnostic&) {
  return step(tr("Renumber goals"), renumberGoals);
}

Fix withoutGoal(const ScenarioDocument&, EntityId id, const Diagnostic& problem) {
  const int goal = std::stoi(problem.value("goal"));
  return step(tr("Remove goal %1 from the route").arg(goal),
              [id, goal](ScenarioDocument& document, const QString& words) {
                dropGoal(document, id, goal, words);
              });
}

Fix withoutRobotGoal(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Robot>(tr("Remove the goal"), id,
                            [](sim2d::Robot& robot) { robot.goal.point.reset(); });
}

Fix otherName(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return step(tr("Give another name"), [id](ScenarioDocument& document, const QString& words) {
    giveFreeName(document, id, words);
  });
}

Fix clampNumbers(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Human>(tr("Clamp to the range"), id, [](sim2d::Human& human) {
    const auto clamp = [](std::optional<double>& value, double low, double high) {
      value = value ? std::optional(std::clamp(*value, low, high)) : std::nullopt;
    };
    sim2d::Behavior& behavior = human.behavior;
    if (behavior.configuration != sim2d::Configuration::Custom) {
      clamp(behavior.goalForceFactor, 2.0, 5.0);
      clamp(behavior.obstacleForceFactor, 2.0, 50.0);
      clamp(behavior.socialForceFactor, 5.0, 20.0);
      clamp(behavior.otherForceFactor, 0.0, 25.0);
    }
    if (behavior.vel) {
      behavior.vel = std::min(*behavior.vel, 1.8);
    }
  });
}

Fix clampSkin(const ScenarioDocument& document, EntityId id, const Diagnostic&) {
  const int most = sim2d::largestSkin(document.scenario().simulator.value_or(std::string()));
  return edit<sim2d::Human>(tr("Clamp to the range"), id, [most](sim2d::Human& human) {
    human.skin = std::clamp(human.skin.value_or(0), 0, most);
  });
}

Fix wholeReaction(const ScenarioDocument& document, EntityId id, const Diagnostic&) {
  const sim2d::Human* human = document.human(id);
  sim2d::Human whole = human == nullptr ? sim2d::Human() : *human;
  completeReaction(document.scenario(), whole);
  return edit<sim2d::Human>(
      tr("Write these values"), id,
      [behavior = whole.behavior](sim2d::Human& person) { person.behavior = behavior; });
}

Fix writePose(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Human>(tr("Write the start 0, 0"), id,
                            [](sim2d::Human& human) { human.hasInitPose = true; });
}

Fix fitWaits(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Human>(tr("One wait for each goal"), id, [](sim2d::Human& human) {
    human.ours.wait.resize(human.goals.size(), 0.0);
  });
}

Fix giveGoals(const ScenarioDocument&, EntityId, const Diagnostic&) {
  return {tr("Give goals…"), {}, true};
}

/// "did you mean": what was meant, else the default.
Fix knownWord(const ScenarioDocument&, EntityId id, const Diagnostic& problem) {
  const std::string nearest = problem.value("nearest");
  const std::optional<std::string> word = nearest.empty() ? std::nullopt : std::optional(nearest);
  const QString words =
      word ? tr("Use '%1'").arg(QString::fromStdString(nearest)) : tr("Use the default");
  if (id.kind == EntityKind::Human) {
    return edit<sim2d::Human>(words, id, [word](sim2d::Human& human) { human.ours.model = word; });
  }
  if (id.kind == EntityKind::Robot) {
    const bool type = problem.value("key") == "type";
    return edit<sim2d::Robot>(words, id, [word, type](sim2d::Robot& robot) {
      (type ? robot.type : robot.planner) = word;
    });
  }
  return edit<ScenarioSettings>(
      words, id, [word](ScenarioSettings& settings) { settings.desktop.model = word; });
}

Fix copySomebody(const ScenarioDocument& document, EntityId id, const Diagnostic&) {
  const std::vector<sim2d::Human>& people = document.scenario().humans;
  if (people.empty()) {
    return {};
  }
  const std::string name = people.front().name;
  return edit<sim2d::Area>(tr("Copy %1").arg(QString::fromStdString(name)), id,
                           [name](sim2d::Area& area) { area.like = name; });
}

Fix giveRate(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Area>(tr("One every 10 s"), id, [](sim2d::Area& area) { area.rate = 0.1; });
}

Fix swapTimes(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return edit<sim2d::Area>(tr("Swap the times"), id,
                           [](sim2d::Area& area) { std::swap(area.from, area.until); });
}

Fix removeIt(const ScenarioDocument&, EntityId id, const Diagnostic&) {
  return {tr("Remove it"), [id](ScenarioDocument& document) { pushRemove(document, {id}); }};
}

Fix plainMapName(const ScenarioDocument& document, EntityId, const Diagnostic&) {
  const std::string name = sim2d::mapBaseName(document.scenario().map.value_or(std::string()));
  return edit<ScenarioSettings>(tr("Write '%1'").arg(QString::fromStdString(name)), kSettingsId,
                                [name](ScenarioSettings& settings) { settings.map = name; });
}

Fix aRobot(const ScenarioDocument&, EntityId, const Diagnostic&) {
  return {tr("Add a robot"), [](ScenarioDocument& document) { addRobot(document); }};
}

Fix openPlane(const ScenarioDocument&, EntityId, const Diagnostic&) {
  return {tr("Open plane"), pushOpenPlane};
}

/// What the command line names, the scenario cannot mend.
Fix openPlaneForFile(const ScenarioDocument& document, EntityId id, const Diagnostic& problem) {
  return problem.value("key") == "map_file" ? openPlane(document, id, problem) : Fix();
}

using Maker = Fix (*)(const ScenarioDocument&, EntityId, const Diagnostic&);

Maker makerFor(std::string_view code) {
  static const std::map<std::string_view, Maker> kMakers = {
      {"places.moved", intoFreePlace},
      {"places.no-place", intoFreePlace},
      {"scenario.ids-not-in-order", numberPeople},
      {"scenario.id-twice", numberPeople},
      {"scenario.id-negative", numberPeople},
      {"scenario.goal-missing", numberGoals},
      {"scenario.goal-below-one", numberGoals},
      {"scenario.goal-twice", numberGoals},
      {"scenario.goal-undefined", withoutGoal},
      {"places.no-way", withoutGoal},
      {"places.no-way-to-point", withoutRobotGoal},
      {"scenario.name-twice", otherName},
      {"scenario.bad-person-name", otherName},
      {"person.name-is-key", otherName},
      {"scenario.bad-name", otherName},
      {"person.out-of-range", clampNumbers},
      {"person.vel-too-high", clampNumbers},
      {"person.skin-unknown", clampSkin},
      {"person.behavior-incomplete", wholeReaction},
      {"person.no-init-pose", writePose},
      {"person.wait-count", fitWaits},
      {"person.no-goals", giveGoals},
      {"scenario.unknown-word", knownWord},
      {"source.no-like", copySomebody},
      {"source.like-unknown", copySomebody},
      {"source.no-rate", giveRate},
      {"source.until-before-from", swapTimes},
      {"shape.door-without-length", removeIt},
      {"scenario.map-name", plainMapName},
      {"map.not-found", openPlane},
      {"map.not-there", openPlaneForFile},
      {"map.is-folder", openPlaneForFile},
      {"map.not-named", openPlane},
      {"scenario.no-robot", aRobot},
  };
  const auto found = kMakers.find(code);
  return found == kMakers.end() ? nullptr : found->second;
}

}  // namespace

std::optional<Fix> fixFor(const ScenarioDocument& document, const base::Diagnostic& problem) {
  if (!problem.entity || !document.contains(problem.entity)) {
    return std::nullopt;
  }
  const Maker make = makerFor(problem.code);
  Fix fix = make == nullptr ? Fix() : make(document, problem.entity, problem);
  return fix.words.isEmpty() ? std::nullopt : std::optional(std::move(fix));
}

void applyToAll(ScenarioDocument& document, const base::Diagnostics& problems,
                const QString& words) {
  document.undoStack().beginMacro(words);
  for (const base::Diagnostic& problem : problems) {
    const std::optional<Fix> fix = fixFor(document, problem);
    if (fix && fix->words == words && fix->apply) {
      fix->apply(document);
    }
  }
  document.undoStack().endMacro();
}

base::Diagnostics adviceFor(const sim2d::Scenario& scenario) {
  const auto listed = [](const auto& each) { return each.listed; };
  const bool people = std::any_of(scenario.humans.begin(), scenario.humans.end(), listed);
  if (!people || std::any_of(scenario.robots.begin(), scenario.robots.end(), listed)) {
    return {};
  }
  base::Diagnostic advice = base::problem(base::Severity::Info, "scenario.no-robot");
  advice.entity = {EntityKind::Scenario, 0};
  return {std::move(advice)};
}

}  // namespace editor
