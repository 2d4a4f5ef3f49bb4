#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/FileKind.h"
#include "app/run/Nav2Robots.h"
#include "sim2d/base/Text.h"

namespace {

const char kStands[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main"><AlwaysSuccess/></BehaviorTree>
</root>
)";

sim2d::Human person(int id, const std::string& name) {
  sim2d::Human human;
  human.key = {base::EntityKind::Human, id};
  human.id = id;
  human.name = name;
  human.initPose = {{2.0 * id, 0.0}, 0.0};
  human.goals = {1};
  return human;
}

/// Two people on the open plane, in no file.
app::Bundle bundleOf(const std::function<void(sim2d::Scenario&)>& change = {}) {
  sim2d::Scenario scenario;
  sim2d::GlobalGoal goal;
  goal.key = {base::EntityKind::Goal, 9};
  goal.id = 1;
  goal.position = {10.0, 0.0};
  scenario.goals = {goal};
  scenario.humans = {person(1, "anna"), person(2, "ben")};
  if (change) {
    change(scenario);
  }
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  return bundle;
}

std::string textOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += problem.text() + "\n";
  }
  return text;
}

}  // namespace

/// Runs from memory, without Qt behind them.
class BundleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void planners_inLists_areGroupedAndAlphabetical() {
    QCOMPARE(QString::fromStdString(base::join(app::listedPlanners(app::builtinRegistries()), " ")),
             QStringLiteral("dwa mppi orca pursuit replay social_force social_mppi straight teleop "
                            "nav2 external library onnx ros2"));
  }

  void check_fromMemory_makesAWorld() {
    const app::Verdict verdict = app::check(bundleOf());
    QVERIFY2(verdict.world != nullptr, textOf(verdict.problems).c_str());
    QVERIFY(verdict.world->step());
    QVERIFY(verdict.world->frame().humans.vx[0] > 0.0);
  }

  void check_runIsLeft_makesNoWorld() {
    app::Bundle bundle = bundleOf();
    const auto left = std::make_shared<base::StopFlag>();
    bundle.stopOfRun = left;
    left->stop();
    QVERIFY_EXCEPTION_THROWN(app::check(bundle), base::Stopped);
  }

  void readBundle_noTreeFiles_isToldAtTheListOfPeople() {
    app::RunSpec options;
    options.scenario = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
    const std::string text = *base::readTextFile(options.scenario);
    const auto place = static_cast<std::ptrdiff_t>(text.find("    agents:\n"));
    const auto line = 1 + std::count(text.begin(), text.begin() + place, '\n');
    const app::Bundle bundle = app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
    const auto told = std::find_if(
        bundle.remarks.begin(), bundle.remarks.end(),
        [](const base::Diagnostic& said) { return std::string(said.code) == "run.no-tree-files"; });
    QVERIFY(told != bundle.remarks.end());
    QCOMPARE(told->file, options.scenario);
    QCOMPARE(told->line, static_cast<int>(line));
    QCOMPARE(told->column, 5);
  }

  void check_treeFromMemory_isRun() {
    app::Bundle bundle = bundleOf();
    bundle.trees["anna"] = {kStands, "", ""};
    const app::Verdict verdict = app::check(bundle);
    QVERIFY2(verdict.world != nullptr, textOf(verdict.problems).c_str());
    for (int step = 0; step < 10; ++step) {
      QVERIFY(verdict.world->step());
    }
    const sim2d::HumanColumns& people = verdict.world->frame().humans;
    QVERIFY(people.x[0] < 2.1);
    QVERIFY(people.x[1] > 4.1);
  }

  void check_treeFromMemory_includesWhatLiesInItsFolder() {
    const QTemporaryDir folder;
    const std::string included = folder.filePath(QStringLiteral("more.xml")).toStdString();
    QVERIFY(base::writeFileAtomically(included, kStands).empty());
    app::Bundle bundle = bundleOf();
    bundle.trees["anna"] = {R"(<root BTCPP_format="4" main_tree_to_execute="Own">
  <include path="more.xml"/>
  <BehaviorTree ID="Own"><SubTree ID="Main"/></BehaviorTree>
</root>)",
                            "", folder.path().toStdString()};
    const app::Verdict verdict = app::check(bundle);
    QVERIFY2(verdict.world != nullptr, textOf(verdict.problems).c_str());
  }

  void check_brokenTreeInNoFile_isToldByItsPerson() {
    app::Bundle bundle = bundleOf();
    bundle.trees["ben"] = {"<root BTCPP_format='4'><Behav", "", ""};
    const app::Verdict verdict = app::check(bundle);
    QVERIFY(verdict.world == nullptr);
    QVERIFY2(textOf(verdict.problems).find("error: tree of ben: ") != std::string::npos,
             textOf(verdict.problems).c_str());
  }

  void check_equalTextsOfTwoFiles_areToldOfEach() {
    app::Bundle bundle = bundleOf();
    const std::string broken =
        "<root BTCPP_format='4'><BehaviorTree ID='A'><Dance/></BehaviorTree></root>";
    bundle.trees["anna"] = {broken, "a/anna.xml", ""};
    bundle.trees["ben"] = {broken, "a/ben.xml", ""};
    const std::string told = textOf(app::check(bundle).problems);
    QVERIFY2(told.find("a/anna.xml:1: error: ") != std::string::npos, told.c_str());
    QVERIFY2(told.find("a/ben.xml:1: error: ") != std::string::npos, told.c_str());
  }

  void check_errorInTheScenario_makesNoWorld() {
    const app::Verdict verdict = app::check(bundleOf([](sim2d::Scenario& scenario) {
      sim2d::Door door;
      door.key = {base::EntityKind::Door, 20};
      door.name = "gate";
      scenario.doors = {door};
    }));
    QVERIFY(verdict.world == nullptr);
    QVERIFY2(textOf(verdict.problems)
                     .find("the length of the door is 0: both ends are the same "
                           "point") != std::string::npos,
             textOf(verdict.problems).c_str());
  }

  void check_metricParameterOutOfItsRange_isRefused() {
    const auto toldOf = [](const std::string& parameter, double value) {
      const app::Verdict verdict = app::check(bundleOf([&](sim2d::Scenario& scenario) {
        scenario.desktop.metrics.parameters = {{parameter, value}};
      }));
      return (verdict.ok() ? "fine " : "wrong ") + textOf(verdict.problems);
    };
    const auto isTold = [&](const std::string& parameter, double value, const std::string& words) {
      return toldOf(parameter, value).find("error: " + parameter + ": " + words) !=
             std::string::npos;
    };
    QVERIFY2(isTold("lane_width", -0.5, "-0.5 must be from 0 to 1e+06"),
             toldOf("lane_width", -0.5).c_str());
    QVERIFY2(isTold("surprise_requires_motion", 2.0, "2 must be from 0 to 1"),
             toldOf("surprise_requires_motion", 2.0).c_str());
    QCOMPARE(toldOf("lane_width", 0.0).substr(0, 5), std::string("fine "));
    QCOMPARE(toldOf("flow_line_x1", -3.0).substr(0, 5), std::string("fine "));
  }

  /// What only the planner knows, so the world says it.
  void check_worldRefuses_tellsTheLineOfTheRobot() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("room.yaml")).toStdString();
    QVERIFY(base::writeFileAtomically(path, "a: 1\nb: 2\n  robot:\n").empty());
    app::Bundle bundle = bundleOf([](sim2d::Scenario& scenario) {
      sim2d::Robot robot;
      robot.key = {base::EntityKind::Robot, 30};
      robot.name = "porter";
      robot.plannerParameters = {{"slow_distance", "0.1"}, {"stop_distance", "0.5"}};
      scenario.robots = {robot};
    });
    bundle.path = path;
    bundle.lines[{base::EntityKind::Robot, 30}] = 3;
    const app::Verdict verdict = app::check(bundle);
    QVERIFY(verdict.world == nullptr);
    const std::string told = textOf(verdict.problems);
    QVERIFY2(told.find(path + ":3:3: error: robot 'porter': ") != std::string::npos, told.c_str());
  }

  void check_ofTheMeaning_makesNoWorld() {
    const app::Verdict verdict = app::check(bundleOf(), app::CheckDepth::Meaning);
    QVERIFY(verdict.world == nullptr);
    QVERIFY2(verdict.ok(), textOf(verdict.problems).c_str());
  }

  /// Comments and texts may mention the keys of other kinds.
  void kindOfFile_isThatOfItsKeys_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("kind");
    const auto row = [](const char* name, const char* text, app::FileKind kind) {
      QTest::newRow(name) << QByteArray(text) << static_cast<int>(kind);
    };
    const char* const scenario = "hunav_loader:\n  ros__parameters:\n    agents: [anna]\n";
    using Kind = app::FileKind;
    row("scenario", scenario, Kind::Scenario);
    const std::string before = std::string("# hunavsim_experiment: 1\n#image: a.pgm\n") + scenario;
    row("scenario with a comment", before.c_str(), Kind::Scenario);
    const std::string after = std::string(scenario) +
                              "hunavsim_desktop:\n  ros__parameters:\n    card: {text: \"for "
                              "hunavsim_experiment: 1\"}\n    # like amcl: of Nav2\n";
    row("scenario with a text", after.c_str(), Kind::Scenario);
    row("experiment", "# runs hunav_loader: files\nhunavsim_experiment: 1\nscenarios: [a.yaml]\n",
        Kind::Experiment);
    row("experiment in braces", "{hunavsim_experiment: 1, scenarios: [a.yaml]}", Kind::Experiment);
    row("experiment in quotes", "\xEF\xBB\xBF\"hunavsim_experiment\" : 1\n", Kind::Experiment);
    row("map", "# no ros__parameters: here, no hunavsim_experiment:\nimage: yard.pgm\n", Kind::Map);
    row("Nav2", "# without hunav_loader: \namcl:\n  ros__parameters: {}\n", Kind::Nav2);
    row("Nav2 with a namespace", "/**/controller_server:\n  ros__parameters: {}\n", Kind::Nav2);
    row("other node", "# image: amcl:\nrobot:\n  ros__parameters: {}\n", Kind::Scenario);
    row("tree", "<root><!-- no FollowPath --><BehaviorTree/><!-- <Spin/> --></root>", Kind::Tree);
    row("tree of a robot",
        "<root><!-- a --><BehaviorTree ID=\"T\"><FollowPath/></BehaviorTree></root>",
        Kind::NavigatorTree);
  }
  void kindOfFile_isThatOfItsKeys() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, kind);
    QCOMPARE(static_cast<int>(app::fileKindOf(text.toStdString())), kind);
  }
};

QTEST_APPLESS_MAIN(BundleTest)
#include "tst_Bundle.moc"
