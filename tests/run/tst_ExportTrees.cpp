#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Export.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/Interop.h"
#include "tests/support/TreeAttributes.h"

using base::Vec2;

namespace {

/// Gaps in the numbers, goals of two people's lists, of one, of a tree alone, of a robot alone.
const char kYard[] = R"(hunav_loader:
  ros__parameters:
    map: yard
    global_goals:
      2: {x: 1.0, y: 2.0}
      5: {x: 3.125, y: 4.0}
      9: {x: -7.5, y: 0.0}
      12: {x: 6.25, y: 6.0}
    agents: [Ana, Ben]
    Ana: {id: 7, init_pose: {x: 0.5, y: 0.5, h: 0.0}, behavior: {type: Regular}, goals: [5, 2, 5]}
    Ben: {id: 9, init_pose: {x: 2.5, y: 0.5, h: 0.0}, behavior: {type: Regular}, goals: [2, 5]}
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    robots: [robot1]
    robot1: {start: {x: 4.0, y: -3.0, h: 0.0}, goals: [9, 12]}
    Ana: {tree: ana.xml}
)";

/// Names goals 1, 3 and 40, which are not there, beside those that are.
const char kTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Walk"><Sequence>
<GoTo agent_id="{id}" goal_id="12" time_step="{dt}"/>
<GoTo agent_id="7" goal_id="1" time_step="{dt}"/>
<LookAtAgent observer_id="{id}" target_id="9"/>
<LookAtAgent observer_id="{id}" target_id="1"/>
<GoTo agent_id="{id}" goal_id="5" time_step="{dt}"/>
<GoTo agent_id="{id}" goal_id="2 " time_step="{dt}"/>
<GoTo agent_id="{id}" goal_id="3" time_step="{dt}"/>
<GoTo agent_id="{id}" goal_id="40" time_step="{dt}"/>
<GoTo agent_id="{id}" goal_id="9" time_step="{dt}"/>
</Sequence></BehaviorTree></root>
)";

using Values = std::vector<std::string>;
using Places = std::vector<std::optional<Vec2>>;  // nothing: there is no such goal

/// Of the ports of this name in the trees of a file, in order.
Values portsOf(const std::string& xml, const char* port) {
  Values values;
  for (const QString& value : attributesIn(QByteArray::fromStdString(xml), port)) {
    values.push_back(value.toStdString());
  }
  return values;
}

/// Where the goals are that a tree names; what is in the blackboard counts as nowhere.
Places placesOf(const std::string& xml, const sim2d::Scenario& scenario) {
  Places places;
  for (const std::string& text : portsOf(xml, "goal_id")) {
    const std::optional<long long> number = base::parseInt(base::trimmed(text));
    const sim2d::GlobalGoal* goal = number ? scenario.goal(static_cast<int>(*number)) : nullptr;
    places.push_back(goal ? std::optional<Vec2>(goal->position) : std::nullopt);
  }
  return places;
}

std::string textOf(const Places& places) {
  std::string text;
  for (const std::optional<Vec2>& place : places) {
    text +=
        place ? "(" + base::formatDouble(place->x()) + ", " + base::formatDouble(place->y()) + ") "
              : "- ";
  }
  return text;
}

struct Exported {
  sim2d::Scenario scenario;                  // without our own block
  std::map<std::string, std::string> trees;  // of the people by name
};

/// Null where the source is refused.
std::optional<Exported> exported(const app::Bundle& source, const std::string& target,
                                 std::optional<sim2d::Dialect> dialect = std::nullopt) {
  app::ExportRequest request;
  request.target = target;
  request.dialect = dialect;
  request.folder = "/nowhere";
  const app::ExportPlan plan = app::planExport(source, request);
  if (base::hasErrors(plan.report)) {
    return std::nullopt;
  }
  const std::string text = plan.files.at(0).content.content;
  const std::string theirs = text.substr(0, text.find("\nhunavsim_desktop:"));
  Exported result;
  result.scenario = sim2d::readScenarioText(theirs, "there.yaml").scenario;
  for (const sim2d::Human& human : result.scenario.humans) {
    const std::string end = "__agent_" + std::to_string(human.id) + "_bt.xml";
    for (const app::ExportPlan::File& file : plan.files) {
      const std::string& path = file.content.path;
      if (human.listed && path.size() > end.size() &&
          path.compare(path.size() - end.size(), end.size(), end) == 0) {
        result.trees[human.name] = file.content.content;
      }
    }
  }
  return result;
}

std::vector<QString> scenarioFiles() {
  std::vector<QString> files;
  for (const QString& folder : {QStringLiteral(SOURCE_DIR "/maps"), QStringLiteral(GENERATED_MAPS),
                                interopFile(QStringLiteral("hunavsim2"))}) {
    QDirIterator it(folder, {QStringLiteral("*.yaml")}, QDir::Files, QDirIterator::Subdirectories);
    while (!folder.isEmpty() && it.hasNext()) {
      const QString path = it.next();
      const base::Result<std::string> text = base::readTextFile(path.toStdString());
      if (text && text->find("hunav_loader:") != std::string::npos) {
        files.push_back(path);
      }
    }
  }
  return files;
}

}  // namespace

/// The trees of an export name the same places as those of the source.
class ExportTreesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString yard() const { return folder_.filePath(QStringLiteral("yard.yaml")); }

  static app::Bundle sourceOf(const QString& file) {
    app::RunSpec options;
    options.scenario = file.toStdString();
    base::Result<app::Bundle> source = app::readExportSource(options, {});
    return source ? std::move(*source) : app::Bundle();
  }

 private Q_SLOTS:
  void initTestCase() {
    const std::string folder = folder_.path().toStdString();
    QVERIFY(base::writeFileAtomically(folder + "/yard.yaml", kYard).empty());
    QVERIFY(base::writeFileAtomically(folder + "/ana.xml", kTree).empty());
  }

  void trees_nameTheSamePlaces_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("target");
    QTest::addColumn<bool>("isOld");
    std::vector<QString> files = scenarioFiles();
    QVERIFY(files.size() >= 3);
    files.push_back(yard());
    for (const QString& file : files) {
      const bool isOne = file.contains(QStringLiteral("realism"));  // crowds: one of them is enough
      for (const sim2d::TargetInfo& target : sim2d::exportTargets()) {
        for (const bool isOld : {true, false}) {
          if (isOne && (!isOld || target.name != "webots")) {
            continue;
          }
          QTest::addRow("%s to %s %s", qPrintable(QFileInfo(file).fileName()), target.name.c_str(),
                        isOld ? "B" : "C")
              << file << QString::fromStdString(target.name) << isOld;
        }
      }
    }
  }

  void trees_nameTheSamePlaces() {
    QFETCH(QString, file);
    QFETCH(QString, target);
    QFETCH(bool, isOld);
    const app::Bundle source = sourceOf(file);
    const std::optional<Exported> was =
        source.hasScenario() ? exported(source, "native", sim2d::Dialect::C) : std::nullopt;
    if (!was) {
      QSKIP("no scenario that is exported");
    }
    const std::optional<Exported> is =
        exported(source, target.toStdString(), isOld ? sim2d::Dialect::B : sim2d::Dialect::C);
    QVERIFY(is);
    QCOMPARE(is->trees.size(), was->trees.size());
    for (std::size_t k = 0; k < was->scenario.humans.size(); ++k) {
      const sim2d::Human& human = was->scenario.humans[k];
      if (!human.listed || human.goals.empty()) {
        continue;  // without goals one is added, and the tree names it
      }
      const Places before = placesOf(was->trees.at(human.name), *source.scenario);
      const Places after = placesOf(is->trees.at(is->scenario.humans[k].name), is->scenario);
      QVERIFY2(before == after,
               (human.name + ": " + textOf(before) + "became " + textOf(after)).c_str());
    }
  }

  /// The numbers by hand: Webots' people have 5, 2, 5 and 2, 5; 9 and 12 are in nobody's list, so
  /// they are 1 and 2, Ana's goals 3, 4, 5. Goals that are not there are not there either.
  void trees_ofTheYard_haveTheseNumbers() {
    const app::Bundle source = sourceOf(yard());
    const std::optional<Exported> webots = exported(source, "webots");
    QVERIFY(webots);
    const std::vector<sim2d::GlobalGoal>& goals = webots->scenario.goals;
    QCOMPARE(goals.size(), std::size_t(7));
    QVERIFY(goals[0].position == Vec2(-7.5, 0.0) && goals[1].position == Vec2(6.25, 6.0));
    QCOMPARE(webots->scenario.humans.at(0).goals, (std::vector<int>{3, 4, 5}));
    QCOMPARE(webots->scenario.humans.at(1).goals, (std::vector<int>{6, 7}));
    const Values numbers = portsOf(webots->trees.at("Ana"), "goal_id");
    QCOMPARE(numbers.size(), std::size_t(7));
    QCOMPARE((Values{numbers[0], numbers[2], numbers[3], numbers[6]}),
             (Values{"2", "3", "4", "1"}));
    for (const std::size_t k : {1U, 4U, 5U}) {
      const std::optional<long long> number = base::parseInt(numbers[k]);
      QVERIFY2(number && *number > 7, numbers[k].c_str());
    }
    const Values looked = portsOf(webots->trees.at("Ana"), "target_id");
    QCOMPARE(looked.at(0), std::string("2"));
    QVERIFY2(*base::parseInt(looked.at(1)) > 2, looked.at(1).c_str());  // nobody, as before
  }

  /// What SetBlackboard and a SubTree hand on to such a port is a number of a goal as well.
  void trees_withNumbersOnTheBlackboard_follow() {
    const char* const text = R"(<root BTCPP_format="4" main_tree_to_execute="A">
<BehaviorTree ID="A"><Sequence><SetBlackboard output_key="where" value="12"/>
<SetBlackboard output_key="count" value="12"/><SetBlackboard output_key="who" value="9"/>
<SubTree ID="B" to="{where}" whom="{who}" id="7" n="12"/>
<SubTree ID="B" to="5" whom="7" id="{id}" n="{count}"/></Sequence></BehaviorTree>
<BehaviorTree ID="B"><Sequence><GoTo agent_id="{id}" goal_id="{to}" time_step="0.05"/>
<SubTree ID="C" _autoremap="true"/><StopAndWaitTimerAction agent_id="{id}" wait_duration="{n}"/>
</Sequence></BehaviorTree>
<BehaviorTree ID="C"><LookAtAgent observer_id="{id}" target_id="{whom}"/></BehaviorTree></root>)";
    const std::string folder = folder_.path().toStdString();
    std::string scenario = kYard;
    scenario.replace(scenario.find("ana.xml"), 7, "board.xml");
    QVERIFY(base::writeFileAtomically(folder + "/board.xml", text).empty());
    QVERIFY(base::writeFileAtomically(folder + "/board.yaml", scenario).empty());
    const app::Bundle source = sourceOf(folder_.filePath(QStringLiteral("board.yaml")));
    const std::optional<Exported> isaac = exported(source, "isaac");  // goals 1 to 4, people 1, 2
    QVERIFY(isaac);
    const std::string& tree = isaac->trees.at("Ana");
    QCOMPARE(portsOf(tree, "value"), (Values{"4", "12", "2"}));
    QCOMPARE(portsOf(tree, "to"), (Values{"{where}", "2"}));
    QCOMPARE(portsOf(tree, "whom"), (Values{"{who}", "1"}));
    QCOMPARE(portsOf(tree, "id"), (Values{"1", "{id}"}));
    QCOMPARE(portsOf(tree, "n"), (Values{"12", "{count}"}));
  }

  /// Files that a tree includes, and those that these include, have the same numbers.
  void trees_thatAreIncluded_follow() {
    const char* const outer = R"(<root BTCPP_format="4" main_tree_to_execute="A">
<include path="inner.xml"/><BehaviorTree ID="A"><SubTree ID="B" id="{id}"/></BehaviorTree></root>)";
    const char* const inner = R"(<root BTCPP_format="4"><include path="inmost.xml"/>
<BehaviorTree ID="B"><GoTo agent_id="{id}" goal_id="12" time_step="0.05"/></BehaviorTree></root>)";
    const char* const inmost = R"(<root BTCPP_format="4">
<BehaviorTree ID="C"><GoTo agent_id="{id}" goal_id="5" time_step="0.05"/></BehaviorTree></root>)";
    const std::string folder = folder_.path().toStdString() + "/";
    std::string scenario = kYard;
    scenario.replace(scenario.find("ana.xml"), 7, "outer.xml");
    for (const auto& [name, text] : std::map<std::string, std::string>{{"outer.xml", outer},
                                                                       {"inner.xml", inner},
                                                                       {"inmost.xml", inmost},
                                                                       {"outer.yaml", scenario}}) {
      QVERIFY(base::writeFileAtomically(std::string(folder).append(name), text).empty());
    }
    app::ExportRequest request;
    request.target = "isaac";  // goals 1 to 4
    request.folder = "/nowhere";
    const app::Bundle source = sourceOf(folder_.filePath(QStringLiteral("outer.yaml")));
    QVERIFY(source.hasScenario());
    const app::ExportPlan plan = app::planExport(source, request);
    std::map<std::string, Values> numbers;
    for (const app::ExportPlan::File& file : plan.files) {
      const std::string& path = file.content.path;
      if (path.find("/inn") != std::string::npos || path.find("/inm") != std::string::npos) {
        numbers[path.substr(path.rfind('/') + 1)] = portsOf(file.content.content, "goal_id");
      }
    }
    const std::map<std::string, Values> wanted = {{"inner.xml", {"4"}}, {"inmost.xml", {"2"}}};
    QVERIFY(numbers == wanted);
  }

  /// Whoever reads the export finds nothing wrong that was not wrong before.
  void export_ofTwoWorkers_namesNoMissingGoal() {
    const app::Bundle source =
        sourceOf(QStringLiteral(SOURCE_DIR "/maps/two_workers/two_workers_agents.yaml"));
    const std::optional<Exported> webots = exported(source, "webots");
    QVERIFY(webots);
    std::size_t named = 0;
    for (const auto& [name, tree] : webots->trees) {
      for (const std::optional<Vec2>& place : placesOf(tree, webots->scenario)) {
        QVERIFY(place);
        ++named;
      }
    }
    QVERIFY(named >= 13);  // behavior-trees.md lists them
  }
};

QTEST_APPLESS_MAIN(ExportTreesTest)
#include "tst_ExportTrees.moc"
