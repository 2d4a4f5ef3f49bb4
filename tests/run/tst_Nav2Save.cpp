#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "app/run/Nav2Save.h"
#include "sim2d/base/Text.h"

namespace {

const std::string kShipped = SOURCE_DIR "/resources/nav2_params/generic.yaml";

sim2d::Robot robotOf(std::vector<std::string> params, sim2d::ParameterTexts values) {
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, 1};
  robot.name = "robot1";
  robot.planner = "nav2";
  robot.nav2Params = std::move(params);
  robot.nav2Values = std::move(values);
  return robot;
}

}  // namespace

/// Changed parameters of Nav2 as a file: what a robot does is the same as before.
class Nav2SaveTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> folder_;

  std::string at(const char* name) const {
    return folder_->filePath(QString::fromUtf8(name)).toStdString();
  }
  std::string scenario() const { return at("scene.yaml"); }
  static std::string textOf(const std::string& file) { return *base::readTextFile(file); }
  /// The values in effect of all parameters.
  std::map<std::string, std::string> valuesOf(const sim2d::Robot& robot) const {
    std::map<std::string, std::string> values;
    for (const app::Nav2Parameter& each : app::nav2ParameterListOf(robot, scenario()).parameters) {
      values[each.node + "." + each.name] = each.value();
    }
    return values;
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void oneFile_withValues_isTheSameRobot() {
    const sim2d::Robot robot =
        robotOf({kShipped}, {{"FollowPath.temperature", "0.2"},
                             {"local_costmap.inflation_layer.inflation_radius", "0.9"},
                             {"FollowPath.vx_max", "1"}});
    const auto before = valuesOf(robot);
    const auto saved = app::saveNav2Parameters(robot, scenario(), at("new.yaml"), "new.yaml");
    QVERIFY(bool(saved));
    QVERIFY(saved->kept.empty() && saved->robot.nav2Values.empty());
    QCOMPARE(saved->robot.nav2Params, std::vector<std::string>{"new.yaml"});
    auto now = valuesOf(saved->robot);
    QCOMPARE(now.at("controller_server.FollowPath.vx_max"), std::string("1.0"));  // a double
    now["controller_server.FollowPath.vx_max"] = before.at("controller_server.FollowPath.vx_max");
    QVERIFY(now == before);
    // Three lines are others; nothing else is.
    const QStringList old = QString::fromStdString(textOf(kShipped)).split(QLatin1Char('\n'));
    const QStringList lines =
        QString::fromStdString(textOf(at("new.yaml"))).split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), old.size());
    int others = 0;
    for (int k = 0; k < lines.size(); ++k) {
      others += lines[k] == old[k] ? 0 : 1;
    }
    QCOMPARE(others, 3);
  }

  /// Without a file the shipped one is read: the new file is a copy of it.
  void noFile_isTheShippedOne() {
    const auto saved = app::saveNav2Parameters(robotOf({}, {{"FollowPath.temperature", "0.2"}}),
                                               scenario(), at("new.yaml"), "new.yaml");
    QVERIFY(bool(saved));
    QCOMPARE(saved->robot.nav2Params, std::vector<std::string>{"new.yaml"});
    QCOMPARE(valuesOf(saved->robot).at("controller_server.FollowPath.temperature"),
             std::string("0.2"));
  }

  /// The last file overrides the others; a single value overrides it, so that of the scenario
  /// stays.
  void severalFiles_theLastIsWritten() {
    QVERIFY(base::writeFileAtomically(at("more.yaml"),
                                      "controller_server:  # mine\n  ros__parameters:\n"
                                      "    controller_frequency: 15.0\n")
                .empty());
    const sim2d::Robot robot =
        robotOf({kShipped, at("more.yaml"), "controller_server:FollowPath.vx_max:=0.4"},
                {{"FollowPath.temperature", "0.2"},
                 {"FollowPath.vx_max", "0.6"},
                 {"controller_frequency", "10.0"}});
    const auto before = valuesOf(robot);
    const auto saved = app::saveNav2Parameters(robot, scenario(), at("new.yaml"), "new.yaml");
    QVERIFY(bool(saved));
    QCOMPARE(saved->robot.nav2Params,
             (std::vector<std::string>{kShipped, "new.yaml",
                                       "controller_server:FollowPath.vx_max:=0.4"}));
    QCOMPARE(saved->robot.nav2Values, (sim2d::ParameterTexts{{"FollowPath.vx_max", "0.6"}}));
    QCOMPARE(saved->kept, std::vector<std::string>{"FollowPath.vx_max"});
    QVERIFY(valuesOf(saved->robot) == before);
    const std::string text = textOf(at("new.yaml"));
    QVERIFY(text.find("controller_server:  # mine\n") == 0);
    QVERIFY(text.find("controller_frequency: 10.0\n") != std::string::npos);
  }

  void file_thatCannotBeWritten_isReported() {
    QVERIFY(base::writeFileAtomically(at("file"), "no folder").empty());
    const auto saved = app::saveNav2Parameters(robotOf({kShipped}, {}), scenario(),
                                               at("file/new.yaml"), "new.yaml");
    QVERIFY(!saved && !saved.diagnostics().empty());
    const auto unread = app::saveNav2Parameters(robotOf({at("none.yaml")}, {}), scenario(),
                                                at("new.yaml"), "new.yaml");
    QVERIFY(!unread && !QFile::exists(QString::fromStdString(at("new.yaml"))));
  }
};

QTEST_GUILESS_MAIN(Nav2SaveTest)
#include "tst_Nav2Save.moc"
