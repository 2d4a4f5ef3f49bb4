#include <algorithm>

#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

constexpr char kDay[] =
    "1351651345.000,1,2000,-3000,1700,1000,0.0,0.5\n"
    "1351651345.040,1,2040,-3000,1700,1000,0.0,0.5\n";

/// Rows of a body that walks along x at 1 m/s.
std::string walk(int id, double y, double step, int count, double begin = 0.0) {
  std::string rows;
  for (int k = 0; k < count; ++k) {
    const double time = begin + step * k;
    rows += base::formatDouble(time) + ',' + std::to_string(id) + ',' + base::formatDouble(time) +
            ',' + base::formatDouble(y) + '\n';
  }
  return rows;
}

/// In how many instants somebody of this id is there.
std::size_t instantsOf(const Trace& trace, int id) {
  std::size_t count = 0;
  for (const sim2d::Frame& frame : trace.frames) {
    const std::vector<int>& ids = frame.humans.id;
    count += static_cast<std::size_t>(std::count(ids.begin(), ids.end(), id));
  }
  return count;
}

}  // namespace

/// Units of lengths, times and angles: those of the format, of the file and of the user. How long
/// somebody may be unseen and yet be there, where bodies are seen at different rates.
class ForeignUnitsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void radius_ofTheFile_isInItsUnit() {
    TrackImportOptions options = with(&TrackImportOptions::lengthUnit, 1e-3);
    const base::Result<TrackFile> file =
        read(files_.add("mm.csv",
                        "time,id,x,y,radius\n0,1,0,0,300\n0.1,1,100,0,300\n0,2,2000,0,\n"
                        "0.1,2,2000,100,\n"),
             options);
    QVERIFY(file);
    QVERIFY(file->tracks[0].radius && isNear(*file->tracks[0].radius, 0.3));
    QVERIFY(!file->tracks[1].radius);
    const base::Result<Trace> trace = sim2d::traceOfTracks(*file, {});
    QCOMPARE(trace->header.humans[0].radius, 0.3);
    QCOMPARE(trace->header.humans[1].radius, 0.35);  // the usual one, in metres
    options.radius = 0.2;                            // of the user, in metres
    QCOMPARE(*read(files_.add("mm2.csv", "time,id,x,y,radius\n0,1,0,0,300\n"), options)
                  ->tracks[0]
                  .radius,
             0.2);
  }
  void radius_toldOnce_counts() {
    const base::Result<TrackFile> file = read(
        files_.add("once.csv", "time,id,x,y,radius,group\n0,1,0,0,0.2,3\n1,1,1,0,,\n2,1,2,0,,\n"));
    QVERIFY(file && file->tracks[0].radius);
    QCOMPARE(*file->tracks[0].radius, 0.2);
    QCOMPARE(file->tracks[0].group, 3);
  }

  void petrack_unit_standsInTheLineOfColumns_data() {
    QTest::addColumn<QByteArray>("comments");
    QTest::addColumn<double>("x");  // of 250
    const auto row = [](const char* name, const char* comments, double x) {
      QTest::newRow(name) << QByteArray(comments) << x;
    };
    row("description",
        "# description: corridor, recorded in cm resolution\n"
        "#framerate: 16.00\n#ID\tFR\tX\tY\tZ (in m)\n",
        250.0);
    row("description in [cm], none told",
        "# heights are in [cm], 5 px/cm\n# framerate: 16\n\n# PersID Frame X Y Z\n", 250.0);
    row("x/cm", "#framerate: 16\n#ID FR X/cm Y/cm\n", 2.5);
    row("[in cm]",
        "# framerate: 16 fps\n"
        "# <number> <frame> <x> [in cm] <y> [in cm] <z>\r\n",
        2.5);
    row("after an empty line", "# framerate: 16 fps\n\n# id frame x[cm] y[cm]\n", 2.5);
    row("x/m", "# x, y in cm are not exact\n#framerate: 16\n#id FR x/m y/m\n", 250.0);
    row("mm", "#framerate: 16\n#id FR x/mm y/mm\n", 0.25);
    row("line of the unit", "# unit: cm\n#framerate: 16\n#id FR x y\n", 2.5);
    row("line below", "#framerate: 16\n#id FR x y\n# [in cm]\n", 2.5);
    row("named columns win", "# unit: cm\n#framerate: 16\n#id FR x/m y/m\n", 250.0);
  }
  void petrack_unit_standsInTheLineOfColumns() {
    QFETCH(QByteArray, comments);
    QFETCH(double, x);
    const base::Result<TrackFile> file =
        read(files_.add("pet.txt", comments.toStdString() + "1 0 250 100\n1 1 260 100\n"));
    QVERIFY2(file, file ? "" : file.diagnostics().front().text().c_str());
    QVERIFY2(isNear(file->tracks[0].points[0].position.x(), x),
             std::to_string(file->tracks[0].points[0].position.x()).c_str());
    QVERIFY(isNear(file->tracks[0].points[1].time, 1.0 / 16.0));
  }
  /// Rates in the description of the film are not those of the rows.
  void petrack_rate_standsInItsLine() {
    const base::Result<TrackFile> file =
        read(files_.add("rate.txt",
                        "# description: framerate thinned from 50 fps\n# Framerate: 16.00\n"
                        "#ID FR X Y\n1 0 2 1\n1 1 2 1\n"));
    QVERIFY(file);
    QVERIFY(isNear(file->tracks[0].points[1].time, 1.0 / 16.0));
  }

  /// Else its four numbers would be frame, id, x, y of another format.
  void petrack_rateInCapitals_isSeen() {
    const base::Result<TrackFile> file =
        read(files_.add("capitals.txt", "# Framerate: 16\n7 3 2 1\n7 4 2 1\n"));
    QVERIFY(file);
    QCOMPARE(file->tracks.size(), std::size_t{1});
    QCOMPARE(file->tracks[0].id, 7);
    QVERIFY(isNear(file->tracks[0].points[1].time - file->tracks[0].points[0].time, 1.0 / 16.0));
  }

  /// What has angles in radians, and what has none.
  void degrees_ofFixedAngles_areRefused_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("atc") << QByteArray("atc.csv") << QByteArray(kDay);
    QTest::newRow("jrdb") << QByteArray("a.json")
                          << QByteArray(
                                 R"({"labels": {"0.pcd": [{"label_id": "pedestrian:1",
                                 "box": {"cx": 0, "cy": 0, "rot_z": 1}}]}})");
    QTest::newRow("obsmat") << QByteArray("obsmat.txt") << QByteArray("1 1 0 0 0 0 0 0\n");
  }
  void degrees_ofFixedAngles_areRefused() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, text);
    const std::string path = files_.add(name.constData(), text.toStdString());
    QVERIFY(read(path));
    QVERIFY(tells(read(path, with(&TrackImportOptions::degrees, true)).diagnostics(),
                  "tracks.fixed-angles"));
  }
  void columns_thatAreFixed_areNotNamed() {
    const std::string path = files_.add("atc.csv", kDay);
    QVERIFY(tells(read(path, withColumns("x=y")).diagnostics(), "tracks.fixed-columns"));
  }
  /// Both of a person's directions by the same rule: motion along x, body at 0.5 rad.
  void unit_ofADay_scalesPlacesAndSpeeds() {
    const base::Result<TrackFile> file =
        read(files_.add("atc.csv", kDay), with(&TrackImportOptions::lengthUnit, 1e-2));
    QVERIFY(file);
    const sim2d::TrackPoint& point = file->tracks[0].points[0];
    QVERIFY((point.position - base::Vec2(20.0, -30.0)).norm() < 1e-9);
    QVERIFY((*point.velocity - base::Vec2(10.0, 0.0)).norm() < 1e-9);
    QVERIFY(isNear(*point.heading, 0.5));
  }
  /// The grid of footsteps is ours: steps of 0.4 s whatever the unit of their times.
  void timeUnit_ofFootsteps_keepsTheGrid() {
    const auto trace = traceOf(files_.add("feet.traj",
                                          "pedestrianId simTime endTime startX startY endX endY\n"
                                          "3 0 500 0.0 0.0 0.6 0.0\n3 500 1000 0.6 0.0 1.2 0.0\n"),
                               with(&TrackImportOptions::timeUnit, 1e-3));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.4);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    QVERIFY(isNear(trace->frames[1].humans.x[0], 0.48));  // 0.4 s of 0.5 s
  }
  void rate_ofTimes_isTold() {
    const TrackImportOptions options = with(&TrackImportOptions::framesPerSecond, 25.0);
    const std::string times = files_.add("t.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    QVERIFY(tells(read(times, options).diagnostics(), "tracks.no-frames"));
    QVERIFY(read(times).diagnostics().empty());
    const std::string frames = files_.add("f.csv", "frame,id,x,y\n0,1,0,0\n25,1,1,0\n");
    QVERIFY(read(frames, options).diagnostics().empty());
  }
  void places_beyondTheEarth_areRefused() {
    const auto trace = traceOf(files_.add("far.csv", "time,id,x,y\n0,1,0,0\n1,1,1e308,0\n"));
    QVERIFY(!trace && tells(trace.diagnostics(), "tracks.too-far"));
    QCOMPARE(trace.diagnostics().back().line, 3);
    const auto apart = read(files_.add("inf.csv", "time,id,x,y\n0,1,1e308,0\n1,1,-1e308,0\n"));
    QVERIFY(apart && apart.diagnostics().empty());  // no speed that is infinite
  }

  /// Seen twice at 0.1 s and then after a minute on the other side of the robot's way.
  void person_afterAMinute_wasAway() {
    const auto trace = traceOf(files_.add("minute.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) +
                                                            "0,2,3,0\n0.1,2,3,0.01\n60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.1);
    QCOMPARE(instantsOf(*trace, 1), std::size_t{601});
    QCOMPARE(instantsOf(*trace, 2), std::size_t{3});
    QVERIFY(!tells(trace.diagnostics(), "tracks.rates-differ-by-body"));
  }
  /// Two observations tell no rate: that of the other counts.
  void person_seenTwice_wasAway() {
    const auto trace = traceOf(
        files_.add("twice.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) + "0,2,3,0\n60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{2});
  }
  /// Nor do three, 2 s apart: 0.55 s are an absence beside somebody at 10 Hz, and 0.5 s are none.
  void person_seenThreeTimes_wasAwayAsLongAsOthersAre() {
    const auto instants = [this](double step) {
      const auto trace = traceOf(files_.add(
          "three.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 101) + walk(2, 0.0, step, 3)));
      return trace ? instantsOf(*trace, 2) : 0;
    };
    QCOMPARE(instants(2.0), std::size_t{3});
    QCOMPARE(instants(0.6), std::size_t{3});
    QCOMPARE(instants(0.5), std::size_t{11});
  }
  /// Alone: the step is the shorter of two intervals, not the longer.
  void person_alone_wasAway() {
    const auto trace = traceOf(files_.add("alone.csv",
                                          "time,id,x,y\n0,2,3,0\n0.1,2,3,0.01\n"
                                          "60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.1);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{3});
  }
  /// Every 20 s beside others at 10 Hz: a rate of its own, but no way between. That is told.
  void person_seenSeldom_isThereAtTheseInstants() {
    const auto trace = traceOf(files_.add(
        "seldom.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 1001) + walk(2, 0.0, 20.0, 6)));
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{6});
    QCOMPARE(trace.diagnostics().size(), std::size_t{1});
    QVERIFY(tells(trace.diagnostics(), "tracks.seen-seldom"));
    QVERIFY(trace.diagnostics()[0].message.find("20 s") != std::string::npos);
  }
  /// At 10 Hz beside a robot at 1000 Hz, one of them seen four times only: no gaps.
  void people_seenHundredTimesLessOften_areThere() {
    const auto trace =
        traceOf(files_.add("fast.csv", "time,id,x,y\n" + walk(1, 5.0, 0.001, 2001) +
                                           walk(2, 0.0, 0.1, 21) + walk(3, 2.0, 0.1, 4)));
    QVERIFY(trace && tells(trace.diagnostics(), "tracks.rates-differ-by-body"));
    QCOMPARE(trace->header.dt, 0.001);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{2001});
    QCOMPARE(instantsOf(*trace, 3), std::size_t{301});
  }
  /// 1 Hz beside 50 Hz: 5.5 of its own intervals are 5.5 s, gaps of 5 s are none and of 6 s are.
  void gaps_goByTheOwnInterval() {
    const auto seen = [this](double again) {
      const auto trace =
          traceOf(files_.add("own.csv", "time,id,x,y\n" + walk(1, 5.0, 0.02, 801) +
                                            walk(2, 0.0, 1.0, 6) + walk(2, 0.0, 1.0, 6, again)));
      return trace ? instantsOf(*trace, 2) : 0;
    };
    QCOMPARE(seen(10.0), std::size_t{751});        // 0 to 15 s
    QCOMPARE(seen(11.0), std::size_t{251 + 251});  // 0 to 5 s and 11 s to 16 s
  }
  /// A finer grid makes nobody absent: those seen every 0.4 s stay there at steps of 1 ms.
  void step_thatIsFiner_keepsPeople() {
    TrackOptions options;
    options.step = 0.001;
    const auto trace =
        traceOf(files_.add("fine.csv", "time,id,x,y\n" + walk(1, 0.0, 0.4, 6)), {}, options);
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 1), std::size_t{2001});
  }
  void robot_seldomSeen_isTold() {
    TrackOptions options;
    options.robotId = 2;
    const auto trace = traceOf(files_.add("robot.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) +
                                                           "0,2,3,0\n0.1,2,3,0.01\n60,2,3,10\n"),
                               {}, options);
    QVERIFY(trace && tells(trace.diagnostics(), "tracks.robot-gap"));
    QVERIFY(trace.diagnostics().front().message.find("59.9 s") != std::string::npos);
  }

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(ForeignUnitsTest)
#include "tst_TrackImportUnits.moc"
