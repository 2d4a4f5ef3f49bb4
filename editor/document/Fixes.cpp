#include "editor/document/Fixes.h"

#include <algorithm>

#include <QRegularExpression>

#include "editor/document/BehaviorValues.h"
#include "editor/document/EditCommands.h"
#include "editor/document/FixEdits.h"
#include "editor/document/MapEdit.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

using Match = QRegularExpressionMatch;

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

Fix intoFreePlace(const ScenarioDocument&, EntityId id, const Match& match) {
  const bool robotGoal = id.kind == EntityKind::Robot && match.captured(1) == QLatin1String("goal");
  const QString words = tr("Move it out of the wall");
  return {words, [words, id, robotGoal](ScenarioDocument& document) {
            moveToFreePlace(document, id, robotGoal, words);
          }};
}

Fix numberPeople(const ScenarioDocument&, EntityId, const Match&) {
  const QString words = tr("Renumber people");
  return {words, [words](ScenarioDocument& document) { renumberPeople(document, words); }};
}

Fix numberGoals(const ScenarioDocument&, EntityId, const Match&) {
  const QString words = tr("Renumber goals");
  return {words, [words](ScenarioDocument& document) { renumberGoals(document, words); }};
}

Fix withoutGoal(const ScenarioDocument&, EntityId id, const Match& match) {
  const int goal = match.captured(1).toInt();
  const QString words = tr("Remove goal %1 from the route").arg(goal);
  return {words, [words, id, goal](ScenarioDocument& document) {
            dropGoals(
                document, id, [goal](int each) { return each == goal; }, words);
          }};
}

Fix withoutRobotGoal(const ScenarioDocument&, EntityId id, const Match&) {
  return edit<sim2d::Robot>(tr("Remove the goal"), id,
                            [](sim2d::Robot& robot) { robot.goal.point.reset(); });
}

Fix otherName(const ScenarioDocument&, EntityId id, const Match&) {
  const QString words = tr("Give another name");
  return {words, [words, id](ScenarioDocument& document) { giveFreeName(document, id, words); }};
}

Fix clampNumbers(const ScenarioDocument&, EntityId id, const Match&) {
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

Fix clampSkin(const ScenarioDocument& document, EntityId id, const Match&) {
  const int most = sim2d::largestSkin(document.scenario().simulator.value_or(std::string()));
  return edit<sim2d::Human>(tr("Clamp to the range"), id, [most](sim2d::Human& human) {
    human.skin = std::clamp(human.skin.value_or(0), 0, most);
  });
}

Fix writeReaction(const ScenarioDocument& document, EntityId id, const Match&) {
  const sim2d::Human* human = document.human(id);
  sim2d::Human whole = human == nullptr ? sim2d::Human() : *human;
  completeReaction(document.scenario(), whole);
  return edit<sim2d::Human>(
      tr("Write these values"), id,
      [behavior = whole.behavior](sim2d::Human& person) { person.behavior = behavior; });
}

Fix writePose(const ScenarioDocument&, EntityId id, const Match&) {
  return edit<sim2d::Human>(tr("Write the start 0, 0"), id,
                            [](sim2d::Human& human) { human.hasInitPose = true; });
}

Fix fitWaits(const ScenarioDocument&, EntityId id, const Match&) {
  return edit<sim2d::Human>(tr("One wait for each goal"), id, [](sim2d::Human& human) {
    human.ours.wait.resize(human.goals.size(), 0.0);
  });
}

Fix giveGoals(const ScenarioDocument&, EntityId, const Match&) {
  return {tr("Give goals…"), {}, true};
}

/// "did you mean": what was meant, else the default.
Fix knownWord(const ScenarioDocument&, EntityId id, const Match& match) {
  const QString key = match.captured(1);
  const QString meant = match.captured(2);
  const std::optional<std::string> word =
      meant.isEmpty() ? std::nullopt : std::optional(meant.toStdString());
  const QString words = meant.isEmpty() ? tr("Use the default") : tr("Use '%1'").arg(meant);
  if (id.kind == EntityKind::Human) {
    return edit<sim2d::Human>(words, id, [word](sim2d::Human& human) { human.ours.model = word; });
  }
  if (id.kind == EntityKind::Robot) {
    const bool type = key == QLatin1String("type");
    return edit<sim2d::Robot>(words, id, [word, type](sim2d::Robot& robot) {
      (type ? robot.type : robot.planner) = word;
    });
  }
  return edit<ScenarioSettings>(
      words, id, [word](ScenarioSettings& settings) { settings.desktop.model = word; });
}

Fix copySomebody(const ScenarioDocument& document, EntityId id, const Match&) {
  const std::vector<sim2d::Human>& people = document.scenario().humans;
  if (people.empty()) {
    return {};
  }
  const std::string name = people.front().name;
  return edit<sim2d::Area>(tr("Copy %1").arg(QString::fromStdString(name)), id,
                           [name](sim2d::Area& area) { area.like = name; });
}

Fix giveRate(const ScenarioDocument&, EntityId id, const Match&) {
  return edit<sim2d::Area>(tr("One every 10 s"), id, [](sim2d::Area& area) { area.rate = 0.1; });
}

Fix swapTimes(const ScenarioDocument&, EntityId id, const Match&) {
  return edit<sim2d::Area>(tr("Swap the times"), id,
                           [](sim2d::Area& area) { std::swap(area.from, area.until); });
}

Fix removeIt(const ScenarioDocument&, EntityId id, const Match&) {
  return {tr("Remove it"), [id](ScenarioDocument& document) { pushRemove(document, {id}); }};
}

Fix plainMapName(const ScenarioDocument& document, EntityId, const Match&) {
  const std::string name = sim2d::mapBaseName(document.scenario().map.value_or(std::string()));
  return edit<ScenarioSettings>(tr("Write '%1'").arg(QString::fromStdString(name)), kSettingsId,
                                [name](ScenarioSettings& settings) { settings.map = name; });
}

Fix aRobot(const ScenarioDocument&, EntityId, const Match&) {
  return {tr("Add a robot"), [](ScenarioDocument& document) { addRobot(document); }};
}

Fix openPlane(const ScenarioDocument&, EntityId, const Match&) {
  return {tr("Open plane"), pushOpenPlane};
}

using Maker = Fix (*)(const ScenarioDocument&, EntityId, const Match&);

struct Rule {
  QRegularExpression said;
  Maker make;
};

/// By the words of the checks; a test lets each of them speak and sees the problem go.
const std::vector<Rule>& rules() {
  static const auto rule = [](const char* said, Maker make) {
    return Rule{QRegularExpression(QString::fromUtf8(said)), make};
  };
  static const std::vector<Rule> kRules = {
      rule("(init_pose|start|goal)(?: \\d+)? \\(.*does not fit, a run takes", intoFreePlace),
      rule("(init_pose|start|goal)(?: \\d+)? \\(.*fits neither there nor", intoFreePlace),
      rule("^the ids are not 1, 2, 3", numberPeople),
      rule(": id -?\\d+ is that of .* too$", numberPeople),
      rule(": needs an id from 0 on$", numberPeople),
      rule("^goal -?\\d+ is missing in global_goals", numberGoals),
      rule("^goal -?\\d+: goals are numbered from 1", numberGoals),
      rule("^goal -?\\d+ is there twice", numberGoals),
      rule(": goal (-?\\d+) is not defined", withoutGoal),
      rule("no way from the start to goal (\\d+)", withoutGoal),
      rule("no way from the start to .*: goal", withoutRobotGoal),
      rule("^the name '.*' is there twice", otherName),
      rule("^a person cannot have the name", otherName),
      rule("^a person called '.*' can have no settings", otherName),
      rule("cannot be a name", otherName),
      rule("loader will clamp it$", clampNumbers),
      rule(": skin -?\\d+ counts as", clampSkin),
      rule(": missing in behavior, so these count", writeReaction),
      rule(": without init_pose the start is 0, 0", writePose),
      rule(": wait needs one number for each", fitWaits),
      rule(": has no goals", giveGoals),
      rule("(model|type|planner) '.*' is unknown \\((?:did you mean '([^']+)')?", knownWord),
      rule(": a source needs 'like'", copySomebody),
      rule(": there is no person '.*' to copy", copySomebody),
      rule(": without a 'rate' nobody arrives", giveRate),
      rule(": 'until' is before 'from'", swapTimes),
      rule(": both ends are the same point", removeIt),
      rule("^map '.*' counts as", plainMapName),
      rule("^no map '.*' found", openPlane),
      rule("^map_file .* is (?:not there|a folder)", openPlane),
      rule("^the scenario names no map", openPlane),
      rule("^there is no robot", aRobot),
  };
  return kRules;
}

}  // namespace

std::optional<Fix> fixFor(const ScenarioDocument& document, const base::Diagnostic& problem) {
  if (!problem.entity || !document.contains(problem.entity)) {
    return std::nullopt;
  }
  const QString message = QString::fromStdString(problem.message);
  for (const Rule& rule : rules()) {
    const Match match = rule.said.match(message);
    if (match.hasMatch()) {
      Fix fix = rule.make(document, problem.entity, match);
      return fix.words.isEmpty() ? std::nullopt : std::optional(std::move(fix));
    }
  }
  return std::nullopt;
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
  return {{base::Severity::Info,
           {},
           0,
           0,
           "there is no robot: what is measured about it stays empty",
           {EntityKind::Scenario, 0}}};
}

}  // namespace editor
