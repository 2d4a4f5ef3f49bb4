#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "sim2d/base/Text.h"

namespace {

using Json = nlohmann::json;

sim2d::Robot robot(const std::string& name, double y, double goal) {
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, static_cast<int>(y) + 1};
  robot.name = name;
  robot.start = {{0.0, y}, 0.0};
  robot.goal.point = base::Vec2(goal, y);
  return robot;
}

/// Robots on the open plane, run into the folder by the rule of their scenario.
base::Diagnostics runInto(const std::string& folder, const std::vector<sim2d::Robot>& robots) {
  sim2d::Scenario scenario;
  scenario.robots = robots;
  scenario.desktop.duration = 4.0;
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  app::Verdict verdict = app::check(bundle);
  if (!verdict.world) {
    return verdict.problems;
  }
  base::Result<std::unique_ptr<app::OutputFolder>> output = app::OutputFolder::open(folder, false);
  if (!output) {
    return output.diagnostics();
  }
  metrics::Selection selection = verdict.metrics.selection;
  selection.everyRobot = true;
  app::RunWriter writer((*output)->staging(), *verdict.world, verdict.world->header(), selection,
                        verdict.metrics.parameters);
  app::Session session(sim2d::stopRuleOf(*bundle.scenario));
  sim2d::RunResult result = session.run(*verdict.world, &writer);
  const app::FinishedRun run{
      verdict.world->header(), std::move(result), {}, writer.evaluation(), {}, false, {}, {}};
  return app::writeRunFolder(**output, run, writer, bundle, {"hunavsim"});
}

}  // namespace

/// The files of a run with several robots.
class RunFolderTest : public QObject {
  Q_OBJECT

 private:
  QString path(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }
  std::string text(const char* name) const {
    const base::Result<std::string> read = base::readTextFile(path(name).toStdString());
    return read ? *read : std::string();
  }
  bool run(const std::vector<sim2d::Robot>& robots) {
    return runInto(folder_.path().toStdString(), robots).empty();
  }

  QTemporaryDir folder_;

 private Q_SLOTS:
  /// `near` arrives within 4 s, `far` drives for the whole time.
  void write_twoRobots_tellsOfBoth() {
    QVERIFY(run({robot("near", 0.0, 1.0), robot("far", 9.0, 20.0)}));
    const Json manifest = Json::parse(text("manifest.json"));
    QCOMPARE(manifest["reason"].get<std::string>(), std::string("duration"));
    const Json& robots = manifest["robots"];
    QCOMPARE(robots[0]["result"].get<std::string>(), std::string("arrived"));
    QVERIFY(robots[0]["time"].get<double>() > 0.8 && robots[0]["time"].get<double>() < 4.0);
    QCOMPARE(robots[1]["result"].get<std::string>(), std::string("timeout"));
    QCOMPARE(robots[1]["time"].get<double>(), 4.0);
    const Json measured = Json::parse(text("metrics.json"));
    const double near = measured["metrics"]["path_length"]["value"].get<double>();
    const double far = measured["robots"]["far"]["metrics"]["path_length"]["value"].get<double>();
    QVERIFY(near > 0.79 && near < 1.01);  // until 0.2 m before its goal
    QVERIFY(far > 3.4 && far < 3.6);      // 0.5 m in the first second, 1 m in each other one
    QCOMPARE(measured["robots"].size(), std::size_t{1});
    const std::vector<std::string> rows = base::split(text("metrics_far.csv"), '\n');
    const std::vector<std::string> keys = base::split(rows[0], ',');
    const auto at = std::find(keys.begin(), keys.end(), "path_length") - keys.begin();
    const std::string field = base::split(rows[1], ',')[static_cast<std::size_t>(at)];
    QCOMPARE(base::parseDouble(field).value_or(-1.0), far);
    QCOMPARE(rows[0], base::split(text("metrics.csv"), '\n')[0]);
    const auto lines = [this](const char* name) { return base::split(text(name), '\n').size(); };
    QCOMPARE(lines("steps_far.csv"), lines("steps.csv"));
    QVERIFY(lines("steps.csv") > 80);
    QVERIFY(text("steps_far.csv") != text("steps.csv"));
  }

  void write_overARunOfMoreRobots_takesItsFilesAway() {
    QVERIFY(run({robot("near", 0.0, 1.0), robot("far", 9.0, 20.0)}));
    for (const char* name : {"metrics_mine.csv", "metrics_near.csv"}) {  // of no run
      QFile file(path(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
    }
    QVERIFY(run({robot("near", 0.0, 1.0)}));
    QVERIFY(!QFile::exists(path("metrics_far.csv")) && !QFile::exists(path("steps_far.csv")));
    QVERIFY(QFile::exists(path("metrics_mine.csv")) && QFile::exists(path("metrics_near.csv")));
    QVERIFY(!Json::parse(text("metrics.json")).contains("robots"));
  }
};

QTEST_APPLESS_MAIN(RunFolderTest)
#include "tst_RunFolder.moc"
