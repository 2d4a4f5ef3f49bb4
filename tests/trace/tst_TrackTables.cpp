#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// As PTV Viswalk writes a pedestrian record.
std::string record(const char* unit, const char* header, const char* rows) {
  return std::string(
             "$VISION\n* File: C:\\models\\hall.inpx\n* Comment: \n* Date: 12.02.2026 15:33:12\n"
             "* PTV Vissim: 2024.00 [07]\n*\n* Table: Pedestrians In Network\n* \n"
             "* SIMSEC: SimSec, Simulation second (Simulation time [s]) [s]\n"
             "* NO: No, Number (Unique number of the pedestrian)\n"
             "* COORDCENTX: CoordCentX, Coordinate of center (x) [") +
         unit + "]\n* COORDCENTY: CoordCentY, Coordinate of center (y) [" + unit + "]\n*\n" +
         header + rows;
}

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

/// Tables with a header, also of Pathfinder and Viswalk; which body is the robot; bodies that have
/// words in the source: by them they are chosen, and the numbers are told.
class TrackTablesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pathfinder_rowOfUnits_isRead() {
    const base::Result<TrackFile> file = read(
        files_.add("occupants.csv",
                   "t,id,name,active,x,y,z,v\ns,,,,m,m,m,m/s\n0.0,3,\"00003\",1,1.0,2.0,0.0,1.2\n"
                   "0.5,3,\"00003\",1,1.5,2.0,0.0,1.2\n0.0,4,\"00004\",1,7.0,2.0,0.0,0.0\n0.5,4,"
                   "\"00004\",0,7.0,2.0,0.0,0.0\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(file.diagnostics().empty());
    QCOMPARE(file->tracks.size(), std::size_t{2});
    const Track* walker = trackOf(*file, 3);
    QVERIFY(walker != nullptr && walker->points.size() == 2);
    QVERIFY(isNear(walker->points[1].time, 0.5));
    QCOMPARE(walker->points[1].position, base::Vec2(1.5, 2.0));
    QCOMPARE(walker->points[1].line, 4);
    QCOMPARE(trackOf(*file, 4)->points.size(), std::size_t{1});  // it left: not active
  }
  void pathfinder_otherUnits_areConverted() {
    const base::Result<TrackFile> file = read(files_.add(
        "feet.csv",
        "\"t\",\"name\",\"x\",\"y\"\n\"min\",\"\",\"ft\",\"ft\"\n0,Anna,10,0\n0.5,Anna,20,0\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].name, std::string("Anna"));
    QVERIFY(isNear(file->tracks[0].points[1].time, 30.0));
    QVERIFY(isNear(file->tracks[0].points[1].position.x(), 6.096));  // 0.3048 m per foot
  }
  void pathfinder_unitsInBrackets_areRecognised() {
    const base::Result<TrackFile> file =
        read(files_.add("b.csv", "t;id;x;y\n;;[cm];[cm]\n0;1;100;0\n0.5;1;150;0\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(isNear(file->tracks[0].points[1].time, 0.5));
    QVERIFY(isNear(file->tracks[0].points[1].position.x(), 1.5));
  }
  void pathfinder_columnOfAnotherName_isSaid() {
    QVERIFY(read(files_.add("no.csv", "t,agent,x,y\ns,,m,m\n0,1,1,1\n"), withColumns("id=agent")));
  }

  void viswalk_record_isRead() {
    const base::Result<TrackFile> file =
        read(files_.add("hall_001.pp", record("m", "$PEDESTRIAN:SIMSEC;NO;COORDCENTX;COORDCENTY\n",
                                              "0.20;11;1.000;2.000\n0.40;11;1.250;2.000\n"
                                              "0.40;12;5.000;2.000\n")));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(file.diagnostics().empty());
    QCOMPARE(file->tracks.size(), std::size_t{2});
    const Track* walker = trackOf(*file, 11);
    QVERIFY(walker != nullptr && walker->points.size() == 2);
    QVERIFY(isNear(walker->points[1].time - walker->points[0].time, 0.2));
    QVERIFY(isNear(walker->points[1].position.x(), 1.25));
    QCOMPARE(walker->points[0].line, 15);
  }
  void viswalk_orderAndUnit_areThoseOfTheFile() {
    const base::Result<TrackFile> file = read(files_.add(
        "feet.pp",
        record("ft", "$PEDESTRIAN:NO;SPEED;COORDCENTY;COORDCENTX;SIMSEC\n", "7;4,5;10;20;1,5\n")));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].id, 7);
    const base::Vec2& place = file->tracks[0].points[0].position;
    QVERIFY(isNear(place.x(), 6.096) && isNear(place.y(), 3.048));
    QVERIFY(isNear(file->tracks[0].points[0].time, 1.5));
  }
  void viswalk_missingAttribute_isNamed() {
    const std::string told =
        textOf(read(files_.add("few.pp", record("m", "$PEDESTRIAN:SIMSEC;NO;COORDCENTX\n",
                                                "0.20;11;1.000\n")))
                   .diagnostics());
    QVERIFY2(told.find("few.pp:14:1: error: no column 'COORDCENTY' (--columns y=NAME)") !=
                 std::string::npos,
             told.c_str());
    const std::string times =
        textOf(read(files_.add("times.pp",
                               record("m", "$PEDESTRIAN:NO;COORDCENTX;COORDCENTY\n", "1;1;1\n")))
                   .diagnostics());
    QVERIFY2(times.find("no time column (--columns time=NAME") != std::string::npos, times.c_str());
  }
  void viswalk_badRow_hasItsPlace() {
    const std::string told = textOf(
        read(files_.add("bad.pp", record("m", "$PEDESTRIAN:SIMSEC;NO;COORDCENTX;COORDCENTY\n",
                                         "0.2;1;1;1\n0.4;1;east;1\n0.6;1\n")))
            .diagnostics());
    QVERIFY2(told.find("bad.pp:16:7: error: x is not a finite number: 'east'") != std::string::npos,
             told.c_str());
    QVERIFY2(
        told.find("bad.pp:17:5: error: the line has 2 fields instead of 4") != std::string::npos,
        told.c_str());
  }

  void csv_namedColumns_giveStatesOfEachInstant() {
    Written files;
    const auto trace = traceOf(files.add("a.csv",
                                         "t,ped,px,py\n"
                                         "10.0,7,0,0\n10.0,3,5,5\n10.5,7,1,0\n10.5,3,5,5\n"
                                         "11.0,7,2,1\n11.0,3,5,5\n"),
                               withColumns("time=t,id=ped,x=px,y=py"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.5);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    const sim2d::HumanColumns& middle = trace->frames[1].humans;
    QCOMPARE(trace->frames[1].time, 0.5);
    QVERIFY((middle.id == std::vector<int>{3, 7}));
    QCOMPARE(middle.x[1], 1.0);
    QVERIFY(isNear(middle.vx[1], 2.0));  // (2 - 0) / 1 s
    QVERIFY(isNear(middle.vy[1], 1.0));  // (1 - 0) / 1 s
    QVERIFY(isNear(middle.heading[1], std::atan2(1.0, 2.0)));
    QVERIFY(isNear(trace->frames[2].humans.vy[1], 2.0));  // (1 - 0) / 0.5 s
    QCOMPARE(middle.vx[0], 0.0);
    // Headings 0, atan2(1, 2), pi/4 over 1 s.
    QVERIFY(isNear(middle.omega[1], base::kPi / 4));
  }

  void csv_unevenTimes_areInterpolated() {
    Written files;
    TrackOptions options;
    options.step = 0.25;
    const auto trace =
        traceOf(files.add("a.csv", "time,id,x,y\n0,1,0,0\n0.4,1,4,0\n0.5,1,4,1\n"), {}, options);
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    QVERIFY(isNear(trace->frames[1].humans.x[0], 2.5));
    QCOMPARE(trace->frames[2].humans.x[0], 4.0);
    QCOMPARE(trace->frames[2].humans.y[0], 1.0);
  }

  void csv_toldMotion_isKept() {
    Written files;
    const auto trace =
        traceOf(files.add("a.csv",
                          "time,id,x,y,vx,vy,heading,omega,group,radius\n"
                          "0,1,0,0,0.3,0.4,1.5,0.25,4,0.2\n1,1,1,0,0.3,0.4,1.5,0.25,4,0.2\n"));
    QVERIFY(trace);
    const sim2d::HumanColumns& humans = trace->frames[0].humans;
    QCOMPARE(humans.vx[0], 0.3);
    QCOMPARE(humans.vy[0], 0.4);
    QCOMPARE(humans.heading[0], 1.5);
    QCOMPARE(humans.omega[0], 0.25);
    QCOMPARE(humans.group[0], 4);
    QCOMPARE(trace->header.humans[0].radius, 0.2);
  }

  void csv_personAway_isNotThere() {
    Written files;
    const auto trace = traceOf(files.add(
        "a.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n8,1,8,0\n9,1,9,0\n10,1,10,0\n"));
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{11});
    QCOMPARE(trace->frames[2].humans.size(), std::size_t{1});
    QCOMPARE(trace->frames[5].humans.size(), std::size_t{0});
    QCOMPARE(trace->frames[8].humans.x[0], 8.0);
    QVERIFY(isNear(trace->frames[8].humans.vx[0], 1.0));  // not over the absence
  }

  void csv_oneSample_isARecord() {
    Written files;
    const auto trace = traceOf(files.add("a.csv", "time,id,x,y\n3.5,1,2,4\n"));
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{1});
    QCOMPARE(trace->frames[0].humans.x[0], 2.0);
    QCOMPARE(trace->frames[0].humans.vx[0], 0.0);
  }

  void csv_robotColumn_givesARobot() {
    Written files;
    const std::string path = files.add("a.csv",
                                       "time,id,kind,x,y\n0,-1,robot,0,0\n0,1,human,3,0\n"
                                       "1,-1,robot,1,0\n1,1,human,3,0\n");
    TrackOptions options;
    options.robotGoal = base::Vec2(4.0, 0.0);
    const auto trace = traceOf(path, {}, options);
    QVERIFY(trace);
    QCOMPARE(trace->header.robots.size(), std::size_t{1});
    QCOMPARE(trace->header.robots[0].goals[0].position.x(), 4.0);
    QCOMPARE(trace->frames[1].robots.x[0], 1.0);
    QCOMPARE(trace->header.humans.size(), std::size_t{1});
  }

  void robot_ofAPerson_cutsTheRecord() {
    Written files;
    TrackOptions options;
    options.robotId = 2;
    const auto trace = traceOf(files.add("a.csv",
                                         "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n3,1,3,0\n"
                                         "1,2,5,5\n2,2,5,6\n"),
                               {}, options);
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{2});
    QCOMPARE(trace->frames[0].time, 0.0);
    QCOMPARE(trace->frames[0].robots.y[0], 5.0);
    QCOMPARE(trace->frames[0].humans.x[0], 1.0);
    QCOMPARE(trace->header.humans.size(), std::size_t{1});
  }

  void robot_betweenTheOthers_isMetByTheInstants() {
    Written files;
    TrackOptions options;
    options.robotId = 2;
    const auto trace = traceOf(files.add("a.csv",
                                         "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n3,1,3,0\n"
                                         "4,1,4,0\n0.5,2,5,5\n1.5,2,5,7\n2.5,2,5,6\n"),
                               {}, options);
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    const double places[] = {5.0, 7.0, 6.0};
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(std::fabs(trace->frames[k].robots.y[0] - places[k]) < 1e-5);
      QVERIFY(std::fabs(trace->frames[k].humans.x[0] - static_cast<double>(k) - 0.5) < 1e-5);
    }
  }

  void parseColumns_wrongWords_areErrors() {
    QVERIFY(!sim2d::parseColumns("time"));
    QVERIFY(!sim2d::parseColumns("tme=t"));
    QVERIFY(!sim2d::parseColumns("x=a,x=b"));
    QVERIFY(sim2d::parseColumns("tme=t").diagnostics()[0].message.find("'time'") !=
            std::string::npos);
  }

  void csv_otherSeparators_areSeen_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("semicolons") << QByteArray("time;id;x;y\n0;1;0;0\n1;1;0.5;2\n");
    QTest::newRow("tabs") << QByteArray("time\tid\tx\ty\n0\t1\t0\t0\n1\t1\t0.5\t2\n");
    QTest::newRow("mark, lines of Windows")
        << QByteArray("\xEF\xBB\xBFtime,id,x,y\r\n0,1,0,0\r\n1,1,0.5,2\r\n");
  }

  void csv_otherSeparators_areSeen() {
    QFETCH(QByteArray, text);
    Written files;
    const auto trace = traceOf(files.add("a.csv", text.toStdString()));
    QVERIFY2(trace, trace ? "" : trace.diagnostics().front().text().c_str());
    QCOMPARE(trace->frames[1].humans.x[0], 0.5);
    QCOMPARE(trace->frames[1].humans.y[0], 2.0);
  }

  /// Each slip once.
  void csv_wrongColumnNames_haveHints() {
    Written files;
    const auto trace = traceOf(files.add("a.csv", "t,ped,px,py\n0,1,0,0\n"),
                               withColumns("time=t,id=pad,x=px,y=yy"));
    QVERIFY(!trace);
    const base::Diagnostics& problems = trace.diagnostics();
    QCOMPARE(problems.size(), std::size_t{2});
    QVERIFY(problems[0].message == "there is no column 'pad' (did you mean 'ped'?)");
    QVERIFY(problems[1].message.find("there is no column 'yy'") == 0);
  }

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

QTEST_APPLESS_MAIN(TrackTablesTest)
#include "tst_TrackTables.moc"
