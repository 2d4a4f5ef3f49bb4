#include <QTemporaryDir>
#include <QtTest>

#include "app/studies/GateSide.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"

using app::GateSide;
using Kind = app::GateSide::Kind;

namespace {

constexpr char kPrefix[] = "hunav_loader:\n  ros__parameters:\n    agents: []\n";

}  // namespace

/// What a user may compare in a gate.
class GateSideTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  std::string at(const char* name) const {
    return folder_.filePath(QString::fromUtf8(name)).toStdString();
  }
  std::string written(const char* name, const std::string& text) const {
    QDir().mkpath(QFileInfo(QString::fromStdString(at(name))).absolutePath());
    base::writeFileAtomically(at(name), text);
    return at(name);
  }
  static GateSide sideOf(const std::string& text) {
    const auto side = app::gateSideOf(text);
    return side ? *side : GateSide{Kind::Planner, "refused", {}, {}};
  }
  static std::string problemOf(const base::Diagnostics& problems) {
    return problems.empty() ? std::string() : std::string(problems.front().code);
  }

 private Q_SLOTS:
  void kinds_areRecognised() {
    QVERIFY(sideOf("pursuit").kind == Kind::Planner);
    QCOMPARE(sideOf("pursuit").value, std::string("pursuit"));
    QVERIFY(sideOf("FollowPath.vx_max:=0.4").kind == Kind::Nav2Params);
    QVERIFY(sideOf("turtlebot3").kind == Kind::Nav2Params);
    QVERIFY(
        sideOf(written("params.yaml", "controller_server:\n  ros__parameters: {a: 1}\n")).kind ==
        Kind::Nav2Params);
    QVERIFY(sideOf(written("tree.xml", "<root/>")).kind == Kind::Nav2Tree);
    QVERIFY(sideOf(written("libplanner.so", "x")).kind == Kind::Library);
    QVERIFY(sideOf("robot1.max_vel=0.5").kind == Kind::Value);
    QVERIFY(sideOf("sh -c 'cat'").kind == Kind::Program);
    QCOMPARE(sideOf("sh -c 'a $b'").value, std::string("\"sh\" \"-c\" \"a \\$b\""));
    QVERIFY(sideOf("crossing_agents").kind == Kind::Scenarios);
    const GateSide one = sideOf(written("scene.yaml", kPrefix));
    QVERIFY(one.kind == Kind::Scenarios);
    QCOMPARE(one.scenarios.front().first, std::string("scene"));
  }

  void kinds_unknownWords_areErrors() {
    QCOMPARE(problemOf(app::gateSideOf("no-such-thing").diagnostics()),
             std::string("gate.unknown-side"));
    QCOMPARE(problemOf(app::gateSideOf("").diagnostics()), std::string("gate.unknown-side"));
    QVERIFY(!app::gateSideOf(written("broken.yaml", "a: [1")));
    QVERIFY(!app::gateSideOf(written("notes.txt", "not a program")));
  }

  void folders_matchByName() {
    for (const char* name : {"old/a.yaml", "old/b.yaml", "new/a.yaml", "new/b.yaml"}) {
      written(name, kPrefix);
    }
    written("old/params.yaml", "controller_server:\n  ros__parameters: {a: 1}\n");
    const GateSide older = sideOf(at("old"));
    const GateSide newer = sideOf(at("new"));
    QCOMPARE(older.scenarios.size(), std::size_t{2});
    const auto all = app::gateScenarios(older, newer, {});
    QVERIFY(all);
    QCOMPARE(all->size(), std::size_t{2});
    QCOMPARE((*all)[1].candidate, at("new/b.yaml"));
    const auto selected = app::gateScenarios(older, newer, {"b"});
    QCOMPARE(selected->size(), std::size_t{1});
    QCOMPARE(problemOf(app::gateScenarios(older, newer, {"c"}).diagnostics()),
             std::string("gate.unknown-scenario"));
    QCOMPARE(problemOf(app::gateScenarios(older, sideOf("pursuit"), {}).diagnostics()),
             std::string("gate.mixed"));
    QFile::remove(QString::fromStdString(at("new/b.yaml")));
    QCOMPARE(problemOf(app::gateScenarios(older, sideOf(at("new")), {}).diagnostics()),
             std::string("gate.unmatched"));
  }

  void specs_setWhatDiffers() {
    const std::string cafe = SOURCE_DIR "/maps/planners/crossing_agents.yaml";
    app::RunSpec common;
    common.set = {"dt=0.1"};
    QCOMPARE(*app::specOfSide(sideOf("dwa"), common, cafe).planner, std::string("dwa"));
    const app::RunSpec nav2 = app::specOfSide(sideOf("turtlebot3"), common, cafe);
    QCOMPARE(*nav2.planner, std::string("nav2"));
    QCOMPARE(nav2.nav2Params, std::vector<std::string>{"turtlebot3"});
    const app::RunSpec program = app::specOfSide(sideOf("sh planner.sh"), common, cafe);
    QCOMPARE(*program.planner, std::string("external"));
    QCOMPARE(program.set.back(), std::string("robot1.command=\"\\\"sh\\\" \\\"planner.sh\\\"\""));
    QCOMPARE(program.set.front(), std::string("dt=0.1"));
    const app::RunSpec value = app::specOfSide(sideOf("robot1.max_vel=0.5"), common, cafe);
    QCOMPARE(value.set.back(), std::string("robot1.max_vel=0.5"));
    QVERIFY(!value.planner);
  }
};

QTEST_APPLESS_MAIN(GateSideTest)
#include "tst_GateSide.moc"
