#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "bt/robot/Nav2Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Body.h"
#include "tests/run/Nav2Scene.h"

namespace {

const std::string kTree =
    SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";

}  // namespace

/// Files of Nav2 as a robot has them: several parameter files, trees by their places on the robot,
/// the robot's body, strict checks.
class Nav2FilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void severalFiles_laterOnesWin();
  void severalFiles_areAllInputsOfTheRun();
  void singleValuesAlone_areOverTheScenariosFile();
  void singleValue_thatNoParameterFits_isAnError();
  void scenario_listOfFiles_isRead();
  void tree_byItsPlaceOnTheRobot_isFound_data();
  void tree_byItsPlaceOnTheRobot_isFound();
  void tree_thatIsNotFound_isAWarningAndNav2sOwn();
  void check_tree_thatIsNotFound_isReported();
  void ownTree_ofOtherPlugins_usesTheFirst();
  void body_ofTheFile_isTheRobots_data();
  void body_ofTheFile_isTheRobots();
  void body_thatTheFileLacks_isAWarning();
  void lateralSpeed_isReportedForOtherKinematics();
  void strict_substitution_isAnErrorWithoutARun();
  void manifest_substitutions_haveFileLineWhatAndByWhat();

 private:
  std::string write(const char* name, const std::string& text) const {
    const QString path = folder_.filePath(QString::fromLatin1(name));
    QDir().mkpath(QFileInfo(path).path());
    return base::writeFileAtomically(path.toStdString(), text).empty() ? path.toStdString()
                                                                       : std::string();
  }
  /// Of a robot in an open plane that these files drive.
  app::RunSpec optionsOf(const std::vector<std::string>& params) const {
    app::RunSpec options;
    options.scenario = scenario_;
    options.planner = "nav2";
    options.nav2Params = params;
    options.nav2Tree = kTree;
    return options;
  }

  QTemporaryDir folder_;
  std::string scenario_, pursuit_;
};

namespace {

const std::string kController = R"(controller_server:
  ros__parameters:
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
      desired_linear_vel: 0.4
)";

app::Bundle bundleOf(const app::RunSpec& options, bool isStrict = false) {
  app::RunSettings settings;
  settings.strict = isStrict;
  return app::readBundle(options, settings, sim2d::ImageLoader());
}

app::Verdict verdictOf(const app::RunSpec& options, bool isStrict = false) {
  return app::check(bundleOf(options, isStrict));
}

std::string textsOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += problem.text() + "\n";
  }
  return text;
}

std::string allOf(const app::Verdict& verdict) {
  return textsOf(verdict.wrongOptions) + textsOf(verdict.problems) + textsOf(verdict.worldRemarks);
}

/// What the manifest has of the robot's navigator.
nlohmann::json reportOf(const app::Verdict& verdict) {
  if (!verdict.world) {
    throw std::runtime_error(allOf(verdict));  // the test fails with it
  }
  verdict.world->step();  // the planner has its map since
  return nlohmann::json::parse(verdict.world->plannerReports().at(0));
}

/// The files with the trees that are shipped.
bt::Nav2Loaded loadedWith(const std::string& params) {
  return bt::loadNav2({{params}, {}, {}, {}}, {}, "robot1",
                      {SOURCE_DIR "/resources/nav2_params", SOURCE_DIR "/resources/nav2_trees"});
}
const std::string kJazzyTree =
    SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_w_replanning_time.xml";

std::string keyOf(const nlohmann::json& report, const std::string& key) {
  for (const nlohmann::json& each : report.at("keys")) {
    if (each.at("key") == key) {
      return each.at("value");
    }
  }
  return {};
}

}  // namespace

void Nav2FilesTest::initTestCase() {
  scenario_ = write("plane.yaml", nav2scene::planeText(nav2scene::kStraight));
  pursuit_ = write("nav/config/pursuit.yaml", kController);
}

void Nav2FilesTest::severalFiles_laterOnesWin() {
  const std::string faster = write(
      "nav/config/faster.yaml",
      "/**:\n  ros__parameters:\n    FollowPath.desired_linear_vel: 0.5\n    use_sim_time: true\n");
  const std::string speed = "controller_server.FollowPath.desired_linear_vel";
  QCOMPARE(keyOf(reportOf(verdictOf(optionsOf({pursuit_}))), speed), std::string("0.4"));
  QCOMPARE(keyOf(reportOf(verdictOf(optionsOf({pursuit_, faster}))), speed), std::string("0.5"));
  QCOMPARE(keyOf(reportOf(verdictOf(optionsOf({faster, pursuit_}))), speed), std::string("0.4"));
  QCOMPARE(keyOf(reportOf(verdictOf(optionsOf(
                     {pursuit_, "controller_server.FollowPath.desired_linear_vel:=0.3", faster}))),
                 speed),
           std::string("0.5"));
  QCOMPARE(keyOf(reportOf(verdictOf(optionsOf(
                     {pursuit_, faster, "controller_server:FollowPath.desired_linear_vel:=0.3"}))),
                 speed),
           std::string("0.3"));
}

void Nav2FilesTest::severalFiles_areAllInputsOfTheRun() {
  const std::string other =
      write("nav/other.yaml", "controller_server:\n  ros__parameters: {use_sim_time: true}\n");
  const std::string single = "FollowPath.desired_linear_vel:=0.3";
  const app::Bundle bundle = bundleOf(optionsOf({pursuit_, single, other}));
  for (const std::string& file : {pursuit_, other}) {
    QVERIFY2(std::count(bundle.inputs.begin(), bundle.inputs.end(), file) == 1, file.c_str());
  }
  const nlohmann::json report = reportOf(app::check(bundle));
  QCOMPARE(report.at("params_files").get<std::vector<std::string>>(),
           (std::vector<std::string>{pursuit_, other}));
  QCOMPARE(report.at("params_overrides").get<std::vector<std::string>>(),
           std::vector<std::string>{single});
}

void Nav2FilesTest::singleValuesAlone_areOverTheScenariosFile() {
  app::RunSpec options = optionsOf({"FollowPath.desired_linear_vel:=0.25"});
  options.set = {"robot1.nav2_params=" + pursuit_};
  const app::Verdict verdict = verdictOf(options);
  QVERIFY2(verdict.world != nullptr, allOf(verdict).c_str());
  const nlohmann::json report = reportOf(verdict);
  QCOMPARE(report.at("params").get<std::string>(), pursuit_);
  QCOMPARE(keyOf(report, "controller_server.FollowPath.desired_linear_vel"), std::string("0.25"));
}

void Nav2FilesTest::singleValue_thatNoParameterFits_isAnError() {
  for (const char* const value :
       {"FollowPath.desired_linear_vell:=0.3", "FollowPath.desired_linear_vel:=1",
        "controller_server:FollowPath.desired_linear_vel:="}) {
    const app::Verdict verdict = verdictOf(optionsOf({pursuit_, value}));
    QVERIFY2(verdict.world == nullptr, value);
    QVERIFY2(allOf(verdict).find("desired_linear_vel") != std::string::npos,
             allOf(verdict).c_str());
  }
}

void Nav2FilesTest::scenario_listOfFiles_isRead() {
  app::RunSpec options = optionsOf({});
  options.set = {"robot1.nav2_params=[" + pursuit_ + ", FollowPath.desired_linear_vel:=0.2]"};
  const app::Verdict verdict = verdictOf(options);
  QVERIFY2(verdict.world != nullptr, allOf(verdict).c_str());
  QCOMPARE(keyOf(reportOf(verdict), "controller_server.FollowPath.desired_linear_vel"),
           std::string("0.2"));
}

void Nav2FilesTest::tree_byItsPlaceOnTheRobot_isFound_data() {
  QTest::addColumn<QString>("named");
  QTest::addColumn<QString>("file");  // below the folder; empty: a shipped one
  QTest::newRow("package") << "$(find-pkg-share nav)/trees/mine.xml"
                           << "nav/trees/mine.xml";
  QTest::newRow("installed") << "/opt/ros/jazzy/share/my_nav/behavior_trees/mine.xml"
                             << "nav/trees/mine.xml";
  QTest::newRow("url") << "package://nav/trees/mine.xml"
                       << "nav/trees/mine.xml";
  QTest::newRow("Nav2's own") << "/opt/ros/humble/share/nav2_bt_navigator/behavior_trees/"
                                 "navigate_w_replanning_time.xml"
                              << "";
}

void Nav2FilesTest::tree_byItsPlaceOnTheRobot_isFound() {
  QFETCH(QString, named);
  QFETCH(QString, file);
  write("nav/trees/mine.xml",
        "<root main_tree_to_execute=\"MainTree\"><BehaviorTree ID=\"MainTree\">"
        "<PipelineSequence name=\"N\"><ComputePathToPose goal=\"{goal}\" path=\"{path}\"/>"
        "<FollowPath path=\"{path}\"/></PipelineSequence></BehaviorTree></root>");
  const std::string params =
      write("nav/config/with_tree.yaml",
            kController + "bt_navigator:\n  ros__parameters:\n    default_nav_to_pose_bt_xml: \"" +
                named.toStdString() + "\"\n");
  const bt::Nav2Loaded loaded = loadedWith(params);
  QVERIFY2(loaded.ok(), textsOf(loaded.problems).c_str());
  QCOMPARE(textsOf(loaded.problems), std::string());
  QCOMPARE(loaded.treeFile, file.isEmpty() ? kJazzyTree : folder_.filePath(file).toStdString());
}

void Nav2FilesTest::tree_thatIsNotFound_isAWarningAndNav2sOwn() {
  const std::string params =
      write("nav/config/no_tree.yaml",
            kController +
                "bt_navigator:\n  ros__parameters:\n    default_nav_to_pose_bt_xml: "
                "$(find-pkg-share nav)/nowhere.xml\n");
  const bt::Nav2Loaded loaded = loadedWith(params);
  QVERIFY2(loaded.ok(), textsOf(loaded.problems).c_str());
  const std::string text = textsOf(loaded.problems);
  const std::string told =
      params +
      ":8:33: warning: bt_navigator: default_nav_to_pose_bt_xml: '$(find-pkg-share "
      "nav)/nowhere.xml' was not found (searched in " +
      folder_.filePath(QStringLiteral("nav")).toStdString();
  QVERIFY2(text.compare(0, told.size(), told) == 0, text.c_str());
  QCOMPARE(loaded.treeFile, kTree);
}

void Nav2FilesTest::check_tree_thatIsNotFound_isReported() {
  const std::string params =
      write("nav/config/no_trees.yaml",
            kController +
                "bt_navigator:\n  ros__parameters:\n    default_nav_through_poses_bt_xml: "
                "nowhere.xml\n");
  const std::string text = textsOf(app::checkNav2Files({params}));
  QVERIFY2(text.find(params + ":8:39: warning: bt_navigator: default_nav_through_poses_bt_xml: "
                              "'nowhere.xml' was not found") != std::string::npos,
           text.c_str());
}

/// The tree of such a robot is unknown; Nav2's own one names other plugins.
void Nav2FilesTest::ownTree_ofOtherPlugins_usesTheFirst() {
  std::string text = kController;
  text.replace(text.find("    FollowPath:"), 15,
               "    controller_plugins: [Pursuit]\n    goal_checker_plugins: [coarse, fine]\n"
               "    coarse: {plugin: \"nav2_controller::SimpleGoalChecker\"}\n"
               "    fine: {plugin: \"nav2_controller::SimpleGoalChecker\"}\n    Pursuit:");
  const std::string params =
      write("nav/config/other_names.yaml",
            text +
                "planner_server:\n  ros__parameters:\n    planner_plugins: [Navfn]\n"
                "    Navfn: {plugin: \"nav2_navfn_planner::NavfnPlanner\"}\n");
  app::RunSpec options = optionsOf({params});
  options.nav2Tree.reset();
  const std::string found = textsOf(app::checkNav2Files({params}));
  const app::Verdict verdict = verdictOf(options);
  for (const char* const warning :
       {":12:22: warning: planner_server: planner_plugins: Nav2's own tree names 'GridBased': "
        "'Navfn' is used",
        ":3:25: warning: controller_server: controller_plugins: Nav2's own tree names "
        "'FollowPath': 'Pursuit' is used",
        ":4:27: warning: controller_server: goal_checker_plugins: Nav2's own tree names none of "
        "several: 'coarse' is used"}) {
    QVERIFY2(found.find(params + warning) != std::string::npos, found.c_str());
    QVERIFY2(allOf(verdict).find(params + warning) != std::string::npos, allOf(verdict).c_str());
  }
  QVERIFY(verdictOf(options, true).world == nullptr);
  QVERIFY2(verdict.world != nullptr, allOf(verdict).c_str());
  for (int step = 0; step < 100; ++step) {
    verdict.world->step();
  }
  const nlohmann::json report = nlohmann::json::parse(verdict.world->plannerReports().at(0));
  QVERIFY2(report.at("action_failure_reasons").empty(), report.dump().c_str());
  QVERIFY(report.at("counts").at("replans").get<int>() > 0);
  // A tree that was chosen is run as it is.
  const app::Verdict chosen = verdictOf(optionsOf({params}));
  QVERIFY2(allOf(chosen).find("is used") == std::string::npos, allOf(chosen).c_str());
}

void Nav2FilesTest::body_ofTheFile_isTheRobots_data() {
  QTest::addColumn<QString>("shape");
  QTest::addColumn<double>("reach");  // [m]
  QTest::addColumn<int>("corners");
  QTest::newRow("radius") << "robot_radius: 0.175" << 0.175 << 0;
  // the corner 0.3, 0.4 is 0.5 m away; the padding is not the body's
  QTest::newRow("footprint") << "footprint: \"[[0.3, 0.4], [-0.3, 0.2], [-0.3, -0.2]]\"\n      "
                                "footprint_padding: 0.1"
                             << 0.5 << 3;
}

void Nav2FilesTest::body_ofTheFile_isTheRobots() {
  QFETCH(QString, shape);
  QFETCH(double, reach);
  QFETCH(int, corners);
  const std::string params =
      write("nav/config/body.yaml", kController +
                                        "local_costmap:\n  local_costmap:\n    "
                                        "ros__parameters:\n      " +
                                        shape.toStdString() + "\n");
  app::RunSpec options = optionsOf({params});
  const auto bodyIn = [](const app::Verdict& verdict) {
    return verdict.world->header().robots.front();
  };
  const app::Verdict own = verdictOf(options);
  QVERIFY2(own.world != nullptr, allOf(own).c_str());
  QCOMPARE(bodyIn(own).radius, 0.35);  // of the general type
  QVERIFY2(allOf(own).find("nav2_body: true takes the body") != std::string::npos,
           allOf(own).c_str());
  for (const bool isOption : {true, false}) {
    options.nav2Body = isOption;
    options.set =
        isOption ? std::vector<std::string>() : std::vector<std::string>{"robot1.nav2_body=true"};
    const app::Verdict taken = verdictOf(options);
    QVERIFY2(taken.world != nullptr, allOf(taken).c_str());
    QCOMPARE(bodyIn(taken).radius, reach);
    QCOMPARE(static_cast<int>(bodyIn(taken).footprint.size()), corners);
    QVERIFY2(allOf(taken).find(" reaches ") == std::string::npos, allOf(taken).c_str());
  }
}

/// The robot of the scenario is differential.
void Nav2FilesTest::lateralSpeed_isReportedForOtherKinematics() {
  const auto found = [&](const std::string& controller, const std::vector<std::string>& set) {
    app::RunSpec options = optionsOf(
        {write("lateral.yaml",
               "controller_server:\n  ros__parameters:\n    FollowPath: " + controller + "\n")});
    options.set = set;
    return allOf(verdictOf(options));
  };
  const std::string mppi =
      "{plugin: \"nav2_mppi_controller::MPPIController\", vy_max: 0.4, critics: [GoalCritic], "
      "motion_model: ";
  const std::string dwb =
      "{plugin: \"dwb_core::DWBLocalPlanner\", max_vel_x: 0.3, max_vel_theta: 1.0, "
      "critics: [GoalDist], max_vel_y: ";
  const std::string reported = "drops the lateral part";
  for (const std::string& controller : {mppi + "Omni}", dwb + "0.2}"}) {
    const std::string text = found(controller, {});
    QVERIFY2(text.find(reported) != std::string::npos, text.c_str());
    const std::string omni = found(controller, {"robot1.kinematics=omnidirectional"});
    QVERIFY2(omni.find(reported) == std::string::npos, omni.c_str());
  }
  for (const std::string& controller : {mppi + "DiffDrive}", dwb + "0.0}"}) {
    const std::string text = found(controller, {});
    QVERIFY2(text.find(reported) == std::string::npos, text.c_str());
  }
}

void Nav2FilesTest::body_thatTheFileLacks_isAWarning() {
  app::RunSpec options = optionsOf({pursuit_});
  options.nav2Body = true;
  const app::Verdict verdict = verdictOf(options);
  QVERIFY2(verdict.world != nullptr, allOf(verdict).c_str());
  QVERIFY2(allOf(verdict).find("local_costmap has no footprint and no robot_radius") !=
               std::string::npos,
           allOf(verdict).c_str());
  QVERIFY(verdictOf(options, true).world == nullptr);
}

void Nav2FilesTest::strict_substitution_isAnErrorWithoutARun() {
  const std::string layers = R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [sonar]
      sonar: {plugin: "my_layers::SonarLayer"}
)";
  const std::string params = write("nav/config/layers.yaml", kController + layers);
  const app::Verdict usual = verdictOf(optionsOf({params}));
  QVERIFY2(usual.world != nullptr, allOf(usual).c_str());
  const app::Verdict strict = verdictOf(optionsOf({params}), true);
  QVERIFY(strict.world == nullptr);
  QVERIFY2(allOf(strict).find(params + ":10:23: error: ") != std::string::npos,
           allOf(strict).c_str());
  QVERIFY(!base::hasErrors(verdictOf(optionsOf({pursuit_}), true).problems));
}

void Nav2FilesTest::manifest_substitutions_haveFileLineWhatAndByWhat() {
  const std::string params = write("nav/config/replaced.yaml", kController + R"(
    controller_frequency: FREQUENCY
local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [sonar]
      sonar: {plugin: "my_layers::SonarLayer"}
)");
  const nlohmann::json all = reportOf(verdictOf(optionsOf({params}))).at("substitutions");
  const auto find = [&all](const char* kind) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& each) { return each.at("kind") == kind; });
    return found == all.end() ? nlohmann::json() : *found;
  };
  const nlohmann::json left = find("nav2.left-out");
  QVERIFY2(!left.is_null(), all.dump().c_str());
  QCOMPARE(left.at("file").get<std::string>(), params);
  QCOMPARE(left.at("line").get<int>(), 12);
  QCOMPARE(left.at("name").get<std::string>(), std::string("local_costmap.sonar"));
  QCOMPARE(left.at("found").get<std::string>(), std::string("my_layers::SonarLayer"));
  const nlohmann::json taken = find("nav2.placeholder");
  QVERIFY2(!taken.is_null(), all.dump().c_str());
  QCOMPARE(taken.at("line").get<int>(), 7);
  QCOMPARE(taken.at("value").get<std::string>(), std::string("20.0"));
}

QTEST_GUILESS_MAIN(Nav2FilesTest)
#include "tst_Nav2Files.moc"
