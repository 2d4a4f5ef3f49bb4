#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

TrackOptions robotNamed(const std::string& name, std::optional<int> id = std::nullopt) {
  TrackOptions options;
  options.robotName = name;
  options.robotId = id;
  return options;
}

/// Person and two robots along x, in millimetres; the second robot has the number of the person.
constexpr char kTwoRobots[] =
    "Frame,Time,Helmet_2 Centroid_X,Helmet_2 Centroid_Y,DARKO_Robot Centroid_X,"
    "DARKO_Robot Centroid_Y,Robot_2 Centroid_X,Robot_2 Centroid_Y\n"
    "1,0.0,0,0,1000,0,2000,0\n2,0.1,10,0,1010,0,2010,0\n";

}  // namespace

/// Bodies that have words in the source: by them they are chosen, and the numbers are told.
class ForeignNamesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thor_bodies_haveTheirNames() {
    const base::Result<TrackFile> file =
        sim2d::importTracks(files_.add("thor.csv", kTwoRobots), {});
    QVERIFY(file && tells(file.diagnostics(), "tracks.ids-numbered"));
    const std::string& told = file.diagnostics().front().message;
    QVERIFY2(told.find("DARKO_Robot = 1000, Robot_2 = 1001") != std::string::npos, told.c_str());
    QCOMPARE(trackOf(*file, 2)->name, std::string("Helmet_2"));
    QCOMPARE(trackOf(*file, 1000)->name, std::string("DARKO_Robot"));
    QCOMPARE(trackOf(*file, 1001)->name, std::string("Robot_2"));
  }
  void thor_robot_isChosenByNameOrNumber() {
    const std::string path = files_.add("thor.csv", kTwoRobots);
    const auto robotAt = [&](const TrackOptions& options) {
      const auto trace = traceOf(path, {}, options);
      return trace ? trace->frames[0].robots.x[0] : -1.0;
    };
    QCOMPARE(robotAt(robotNamed("DARKO_Robot")), 1.0);
    QCOMPARE(robotAt(robotNamed("Robot_2")), 2.0);
    QCOMPARE(robotAt(robotNamed("Helmet_2")), 0.0);
    QCOMPARE(robotAt(robotNamed("1001", 1001)), 2.0);
    QCOMPARE(robotAt(robotNamed("2", 2)), 0.0);
    const auto other = traceOf(path, {}, robotNamed("DARKO_Robot"));
    QVERIFY(tells(other.diagnostics(), "tracks.robot-among-people"));
  }
  void robots_two_areNamed() {
    const auto trace = traceOf(files_.add("thor.csv", kTwoRobots));
    QVERIFY(!trace);
    const base::Diagnostic& told = trace.diagnostics().back();
    QCOMPARE(told.code, std::string("tracks.second-robot"));
    QVERIFY(told.message.find("--robot DARKO_Robot or --robot Robot_2") != std::string::npos);
    const auto numbers =
        traceOf(files_.add("two.csv", "time,id,kind,x,y\n0,4,robot,0,0\n0,7,robot,1,0\n"));
    QVERIFY(!numbers);
    QVERIFY(numbers.diagnostics().back().message.find("--robot 4 or --robot 7") !=
            std::string::npos);
  }
  /// People and robots may be numbered apart: the robot is meant.
  void robot_ofANumberThatAPersonHasToo_isTheRobot() {
    const auto trace =
        traceOf(files_.add("apart.csv", "time,id,kind,x,y\n0,1,human,5,0\n0,1,robot,7,0\n"), {},
                robotNamed("1", 1));
    QVERIFY2(trace, trace ? "" : trace.diagnostics().front().text().c_str());
    QCOMPARE(trace->frames[0].robots.x[0], 7.0);
    QCOMPARE(trace->frames[0].humans.x[0], 5.0);
  }
  void jrdb_people_haveTheirNames() {
    const std::string path = files_.add(
        "jrdb.json",
        R"({"labels": {"0.pcd": [{"label_id": "pedestrian:12", "box": {"cx": 1, "cy": 0}},
        {"label_id": "pedestrian:7", "box": {"cx": 2, "cy": 0}}]}})");
    QCOMPARE(trackOf(*sim2d::importTracks(path, {}), 12)->name, std::string("pedestrian:12"));
    const auto trace = traceOf(path, {}, robotNamed("pedestrian:12"));
    QVERIFY(trace);
    QCOMPARE(trace->frames[0].robots.x[0], 1.0);
    QVERIFY(traceOf(path, {}, robotNamed("7", 7)));
    QVERIFY(tells(traceOf(path, {}, robotNamed("pedestrian:9")).diagnostics(), "tracks.nobody"));
  }
  void nobody_hintsAtAName() {
    const auto trace = traceOf(files_.add("thor.csv", kTwoRobots), {}, robotNamed("DARKO_Robt"));
    QVERIFY(!trace);
    QVERIFY(trace.diagnostics().back().message.find("'DARKO_Robot'") != std::string::npos);
  }

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(ForeignNamesTest)
#include "tst_TrackImportNames.moc"
