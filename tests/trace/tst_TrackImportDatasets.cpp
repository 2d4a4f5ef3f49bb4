#include <algorithm>

#include <QtTest>

#include "tests/trace/ArchiveFile.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

/// Files of other data sets, recognised by what is in them; units, rates and ids of others.
class OtherDataTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void petrack_rateAndUnit_standInComments() {
    const std::string metres = files_.add("a.txt",
                                          "# PeTrack project: hall.pet\n# framerate: 25 fps\n"
                                          "# <number> <frame> <x> [in m] <y> [in m] <z>\n"
                                          "1 100 2.5 -1.0 1.7\n1 105 2.7 -1.0 1.7\n");
    const base::Result<TrackFile> file = read(metres);
    QVERIFY(file);
    QVERIFY(isNear(file->tracks[0].points[1].time - file->tracks[0].points[0].time, 0.2));
    QVERIFY(isNear(file->tracks[0].points[0].position.x(), 2.5));
    const base::Result<TrackFile> centimetres = read(
        files_.add("b.txt", "#framerate: 16.00\n#ID FR X/cm Y/cm\n1 0 250 100\n1 1 260 100\n"));
    QVERIFY(isNear(centimetres->tracks[0].points[0].position.x(), 2.5));
    QVERIFY(isNear(centimetres->tracks[0].points[1].time, 1.0 / 16.0));
    QVERIFY(tells(
        read(files_.add("c.txt", "1 0 250 100\n"), with(&TrackImportOptions::format, "petrack"))
            .diagnostics(),
        "tracks.no-rate-or-unit"));
  }

  void vadere_stepsAndFootsteps() {
    const base::Result<TrackFile> steps = read(files_.add(
        "postvis.traj", "timeStep pedestrianId x-PID1 y-PID1\n1 7 1.0 2.0\n2 7 1.4 2.0\n"));
    QVERIFY(isNear(steps->tracks[0].points[1].time, 0.8));
    const base::Result<TrackFile> feet =
        read(files_.add("feet.traj",
                        "pedestrianId simTime endTime startX-PID1 startY-PID1 endX-PID1 endY-PID1\n"
                        "3 0.0 0.5 0.0 0.0 0.6 0.0\n3 0.5 1.0 0.6 0.0 1.2 0.0\n"));
    const Track* person = trackOf(*feet, 3);
    QVERIFY(person != nullptr);
    QCOMPARE(person->points.size(), std::size_t{3});
    QVERIFY(isNear(person->points[2].position.x(), 1.2) && isNear(person->points[2].time, 1.0));
  }

  void sdd_boxes_areCentresInMetres() {
    const std::string path =
        files_.add("annotations.txt",
                   "4 100 200 120 240 0 0 0 0 \"Pedestrian\"\n"
                   "4 110 200 130 240 30 0 0 0 \"Pedestrian\"\n"
                   "4 110 200 130 240 31 1 0 0 \"Pedestrian\"\n5 0 0 9 9 0 0 0 0 \"Car\"\n");
    QVERIFY(tells(read(path).diagnostics(), "tracks.no-scale"));
    const base::Result<TrackFile> file = read(path, with(&TrackImportOptions::lengthUnit, 0.05));
    QVERIFY(file && tells(file.diagnostics(), "tracks.not-people"));
    QCOMPARE(file->tracks.size(), std::size_t{1});
    QCOMPARE(file->tracks[0].points.size(), std::size_t{2});
    QVERIFY(isNear(file->tracks[0].points[0].position.x(), 5.5));
    QVERIFY(isNear(file->tracks[0].points[0].position.y(), -11.0));
    QVERIFY(isNear(file->tracks[0].points[1].time, 1.0));
  }

  void atc_day_isInMillimetres() {
    const base::Result<TrackFile> file =
        read(files_.add("atc.csv",
                        "1351651345.000,9101700,2000,-3000,1700,1000,0.0,0.5\n"
                        "1351651345.040,9101700,2040,-3000,1700,1000,0.0,0.5\n"));
    QVERIFY(file);
    const Track& person = file->tracks[0];
    QCOMPARE(person.id, 9101700);
    QVERIFY((person.points[1].position - base::Vec2(2.04, -3.0)).norm() < 1e-9);
    QVERIFY(std::fabs(person.points[1].time - 0.04) < 1e-6);
    QVERIFY((*person.points[0].velocity - base::Vec2(1.0, 0.0)).norm() < 1e-9);
    QVERIFY(isNear(*person.points[0].heading, 0.5));
  }

  void thor_table_hasPeopleAndARobot() {
    const base::Result<TrackFile> file =
        read(files_.add("thor.csv",
                        "FILE_ID,THOR-1\nN_FRAMES,2\n"
                        "Frame,Time,Helmet_2 Centroid_X,Helmet_2 Centroid_Y,Helmet_2 Centroid_Z,"
                        "DARKO_Robot Centroid_X,DARKO_Robot Centroid_Y\n"
                        "1,0.00,1000,2000,1700,0,0\n2,0.01,1010,2000,1700,,\n"));
    QVERIFY(file);
    const Track* person = trackOf(*file, 2);
    if (person == nullptr) {
      QFAIL("the person is missing");
    }
    QVERIFY(!person->isRobot);
    QVERIFY(isNear(person->points[1].position.x(), 1.01));
    QCOMPARE(std::count_if(file->tracks.begin(), file->tracks.end(),
                           [](const Track& track) { return track.isRobot; }),
             std::ptrdiff_t{1});
  }

  void jrdb_boxes_areAroundTheRobot() {
    const base::Result<TrackFile> file = read(files_.add(
        "jrdb.json",
        R"({"labels": {"000000.pcd": [{"label_id": "pedestrian:12", "box": {"cx": 1.0, "cy": -2.0,
        "cz": 0, "rot_z": 0.5}}, {"label_id": "car:1", "box": {"cx": 0, "cy": 0}}],
        "000003.pcd": [{"label_id": "pedestrian:12", "box": {"cx": 1.2, "cy": -2.0}}]}})"));
    QVERIFY(file);
    QCOMPARE(file->tracks.size(), std::size_t{1});
    QVERIFY(isNear(file->tracks[0].points[1].time, 0.2));
    QVERIFY(isNear(*file->tracks[0].points[0].heading, 0.5));
    QVERIFY(tells(
        read(files_.add("bad.json", R"({"labels": {"0.pcd": [{"label_id": 1}]}})")).diagnostics(),
        "tracks.bad-json"));
    QVERIFY(tells(file.diagnostics(), "tracks.not-people"));  // the car
    QVERIFY(tells(file.diagnostics(), "tracks.around-robot"));
  }

  void jrdb_frames_goByNumber() {
    const auto trace = traceOf(files_.add(
        "order.json",
        R"({"labels": {"10.pcd": [{"label_id": "pedestrian:1", "box": {"cx": 2, "cy": 0}}],
        "9.pcd": [{"label_id": "pedestrian:1", "box": {"cx": 1, "cy": 0}}]}})"));
    QVERIFY2(trace, trace ? "" : trace.diagnostics().front().text().c_str());
    QCOMPARE(trace->frames[0].humans.x[0], 1.0);
    QCOMPARE(trace->frames[1].humans.x[0], 2.0);
  }

  void thor_objects_areLeftOut() {
    const base::Result<TrackFile> file =
        read(files_.add("things.csv",
                        "Frame,Time,Helmet_2 Centroid_X,Helmet_2 Centroid_Y,LO_2 Centroid_X,"
                        "LO_2 Centroid_Y\n1,0.00,1000,2000,0,0\n\n"));
    QVERIFY(file && tells(file.diagnostics(), "tracks.not-people"));
    QCOMPARE(file->tracks.size(), std::size_t{1});
  }

  void sdd_badRows_haveTheirPlace() {
    const base::Diagnostics told =
        read(files_.add("rows.txt",
                        "4 0 0 9 9 0 0 0 0 \"Biker\"\n4 b 0 9 9 1 0 0 0 \"Biker\"\n4 0 0\n"),
             with(&TrackImportOptions::lengthUnit, 0.05))
            .diagnostics();
    QCOMPARE(told.size(), std::size_t{2});
    QVERIFY(told[0].line == 2 && told[0].column == 3);
    QVERIFY(told[1].line == 3 && told[1].column == 5);
  }

  void unitOfTime_ofFrames_isRefused() {
    const TrackImportOptions options = with(&TrackImportOptions::timeUnit, 1e-3);
    QVERIFY(tells(read(files_.add("u.txt", "0 1 0 0\n10 1 1 0\n"), options).diagnostics(),
                  "tracks.time-unit-of-frames"));
    QVERIFY(tells(
        read(files_.add("u.traj", "timeStep pedestrianId x y\n1 7 1 2\n"), options).diagnostics(),
        "tracks.time-unit-of-frames"));
  }

  /// Two of three people stand: the third one is too fast all the same.
  void speeds_ofWhoMoves_areLookedAt() {
    QVERIFY(tells(read(files_.add("stand.csv",
                                  "time,id,x,y\n0,1,0,0\n1,1,0,0\n0,2,5,0\n1,2,5,0\n0,3,0,0\n"
                                  "1,3,900,0\n"))
                      .diagnostics(),
                  "tracks.too-fast"));
  }

  void numbersOfIds_countByValue() {
    const base::Result<TrackFile> file =
        read(files_.add("value.csv", "time,id,x,y\n0,1,0,0\n1,1.0,1,0\n2,1e0,2,0\n"));
    QVERIFY(file);
    QCOMPARE(file->tracks.size(), std::size_t{1});
    QCOMPARE(file->tracks[0].points.size(), std::size_t{3});
  }

  void robot_ofAWord_isFound() {
    const std::string path =
        files_.add("names.csv", "time,id,x,y\n0,2,0,0\n0,anna,5,0\n1,2,1,0\n1,anna,5,3\n");
    TrackOptions options;
    options.robotName = "anna";
    const base::Result<Trace> anna = traceOf(path, {}, options);
    QVERIFY(anna);
    QCOMPARE(anna->frames[1].robots.y[0], 3.0);
    options.robotName = "2";  // the word of the file, not the number that stands for anna
    options.robotId = 2;
    QCOMPARE(traceOf(path, {}, options)->frames[1].robots.x[0], 1.0);
    options.robotName = "ben";
    options.robotId.reset();
    QVERIFY(tells(traceOf(path, {}, options).diagnostics(), "tracks.nobody"));
  }

  void robot_longUnseen_isTold() {
    const std::string walk = "time,id,kind,x,y\n0,1,robot,0,0\n1,1,robot,1,0\n2,1,robot,2,0\n";
    const auto gap = traceOf(files_.add("gap9.csv", walk + "11,1,robot,3,0\n12,1,robot,4,0\n"));
    QVERIFY(gap && tells(gap.diagnostics(), "tracks.robot-gap"));
    QCOMPARE(gap.diagnostics().front().line, 4);
    QVERIFY(gap.diagnostics().front().message.find("9 s") != std::string::npos);
    const auto none = traceOf(files_.add("gap5.csv", walk + "7,1,robot,3,0\n8,1,robot,4,0\n"));
    QVERIFY(none && none.diagnostics().empty());
  }

  void observations_offTheGrid_areTold() {
    const auto off = traceOf(files_.add(
        "off.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n2.2,1,2,0\n3,1,3,0\n4,1,4,0\n5,1,5,0\n"));
    QVERIFY(off && tells(off.diagnostics(), "tracks.off-grid"));
    QVERIFY(off.diagnostics().front().message.find("1 observations") == 0);
    const auto on = traceOf(files_.add("on.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n2.005,1,2,0\n"));
    QVERIFY(on && on.diagnostics().empty());
  }

  void hdf5_table_isRead() {
    const std::string path = files_.add("t.h5", "");
    writeTable(path, 10.0);
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, file ? "" : file.diagnostics().front().text().c_str());
    QCOMPARE(file->tracks.size(), std::size_t{2});
    QVERIFY(isNear(file->tracks[0].points[1].time, 0.1));
    QVERIFY(isNear(file->tracks[1].points[0].position.y(), 4.0));
    writeTable(path, 0.0);
    QVERIFY(tells(read(path).diagnostics(), "tracks.no-rate"));
    writeTable(path, 10.0, 3);  // several rates are none
    QVERIFY(tells(read(path).diagnostics(), "tracks.no-rate"));
    writeTable(path, 10.0, 1, 1LL << 32U);
    QVERIFY(tells(read(path).diagnostics(), "tracks.out-of-range"));
  }

  /// Rows that the file claims without having them.
  void hdf5_hugeTable_isRefused() {
    const std::string path = files_.add("huge.h5", "");
    QVERIFY(ArchiveFile(path, {}, 1024, hsize_t{1} << 50U).table() >= 0);
    QVERIFY(tells(read(path).diagnostics(), "tracks.too-many-rows"));
  }

  void units_thatAreSaid_count() {
    const std::string path = files_.add("mm.csv",
                                        "time,id,x,y,heading,vx,vy\n0,1,1000,2000,90,500,0\n"
                                        "100,1,1050,2000,90,500,0\n");
    TrackImportOptions options = with(&TrackImportOptions::lengthUnit, 1e-3);
    options.timeUnit = 1e-3;
    options.degrees = true;
    options.radius = 0.2;
    const base::Result<TrackFile> file = read(path, options);
    QVERIFY(file && file.diagnostics().empty());
    const Track& person = file->tracks[0];
    QVERIFY(isNear(person.points[1].time, 0.1) && isNear(person.points[1].position.x(), 1.05));
    QVERIFY(isNear(*person.points[0].heading, base::kPi / 2.0));
    QVERIFY(isNear(person.points[0].velocity->x(), 500.0));  // mm/ms are m/s
    QVERIFY(isNear(person.radius.value_or(0.0), 0.2));
    QVERIFY(!tells(read(path).diagnostics(), "tracks.too-fast"));  // 0.5 m/s by chance
    options.timeUnit = 1.0;
    options.lengthUnit = 1.0;
    QVERIFY(!tells(read(path, options).diagnostics(), "tracks.too-fast"));
    options.timeUnit = 1e-3;
    QVERIFY(tells(read(path, options).diagnostics(), "tracks.too-fast"));
  }

  void frames_withoutARate_askForIt() {
    const std::string path = files_.add("f.csv", "frame,id,x,y\n0,1,0,0\n1,1,0.1,0\n");
    QVERIFY(tells(read(path).diagnostics(), "tracks.no-rate"));
    QVERIFY(read(path, with(&TrackImportOptions::framesPerSecond, 25.0)));
  }

  void ids_thatAreWords_getNumbers() {
    const base::Result<TrackFile> file =
        read(files_.add("w.csv", "time,id,x,y\n0,ana,0,0\n0,ben,5,0\n1,ana,1,0\n1,ben,5,1\n"));
    QVERIFY(file && tells(file.diagnostics(), "tracks.ids-numbered"));
    QVERIFY(file.diagnostics().front().message.find("ana = 1, ben = 2") != std::string::npos);
    QVERIFY(isNear(trackOf(*file, 2)->points[1].position.y(), 1.0));
  }

  void wrongFormat_tellsWhatItLooksLike() {
    const std::string path = files_.add("v.traj", "timeStep pedestrianId x y\n1 7 1.0 2.0\n");
    const base::Diagnostics told =
        read(path, with(&TrackImportOptions::format, "eth")).diagnostics();
    QVERIFY(tells(told, "tracks.other-format"));
    QVERIFY(told.back().message.find("vadere") != std::string::npos);
  }

  /// 101 lines of four fields where eight are due: ten are shown, and what it is.
  void wrongFormat_ofManyLines_isTellable() {
    std::string text = "time,id,x,y\n";
    for (int k = 0; k < 100; ++k) {
      text += std::to_string(k) + ",1,0,0\n";
    }
    const base::Diagnostics told =
        read(files_.add("many.csv", text), with(&TrackImportOptions::format, "eth")).diagnostics();
    QCOMPARE(told.size(), std::size_t{12});
    QVERIFY(told[9].line == 10 && told[9].code == "tracks.number-count");
    QVERIFY(told[10].code == "tracks.more-of-a-kind" && told[10].message.find("91 more") == 0);
    QVERIFY(told[11].message.find("'csv'") != std::string::npos);
  }

  /// A robot at 50 Hz passes people at 10 Hz: they are there all the time.
  void rates_thatDiffer_areOneClock() {
    std::string text = "time,id,x,y,kind\n";
    for (int k = 0; k <= 100; ++k) {
      text += std::to_string(0.02 * k) + ",1," + std::to_string(0.02 * k) + ",0,robot\n";
      if (k % 5 == 0) {  // walks at 1 m/s
        text += std::to_string(0.02 * k) + ",7," + std::to_string(3.0 + 0.02 * k) + ",1,human\n";
      }
    }
    const base::Result<Trace> trace = traceOf(files_.add("rates.csv", text));
    QVERIFY(trace && tells(trace.diagnostics(), "tracks.rates-differ-by-body"));
    for (const sim2d::Frame& frame : trace->frames) {
      QCOMPARE(frame.humans.size(), std::size_t{1});
      QVERIFY(std::fabs(frame.humans.x[0] - 3.0 - frame.time) < 1e-5);
      QVERIFY(std::fabs(frame.humans.vx[0] - 1.0) < 1e-5);
    }
  }

  void gapsOfAFewFrames_areNoAbsence() {
    std::string text = "time,id,x,y\n";
    for (int k = 0; k <= 40; ++k) {
      if (k < 20 || k > 23) {
        text += std::to_string(0.1 * k) + ",1," + std::to_string(0.1 * k) + ",0\n";
      }
    }
    const base::Result<Trace> trace = traceOf(files_.add("gap.csv", text));
    QVERIFY(trace);
    for (const sim2d::Frame& frame : trace->frames) {
      QCOMPARE(frame.humans.size(), std::size_t{1});
    }
  }

  void robotsArrival_isAnEvent() {
    std::string text = "time,id,x,y,kind\n";
    for (int k = 0; k <= 20; ++k) {
      text += std::to_string(k) + ",1," + std::to_string(std::min(k, 10)) + ",0,robot\n";
    }
    TrackOptions options;
    options.robotGoal = base::Vec2(10.0, 0.0);
    const base::Result<Trace> trace = traceOf(files_.add("arrive.csv", text), {}, options);
    QVERIFY(trace);
    QCOMPARE(trace->events.size(), std::size_t{1});
    QCOMPARE(trace->events[0].first, std::int64_t{10});
    QVERIFY(trace->events[0].second.kind == sim2d::EventKind::Arrived);
  }

  /// A sample every 1/8 m: 0.2 m before the goal is between 9.75 m and 9.875 m.
  void robotsArrival_isInsideTheGoal() {
    const auto eventsOf = [this](double end) {
      std::string text = "time,id,x,y,kind\n";
      for (int k = 0; k <= 100; ++k) {
        text += base::formatDouble(k / 8.0) + ",1," + base::formatDouble(std::min(k / 8.0, end)) +
                ",0,robot\n";
      }
      TrackOptions options;
      options.robotGoal = base::Vec2(10.0, 0.0);
      const base::Result<Trace> trace = traceOf(files_.add("inside.csv", text), {}, options);
      return trace ? trace->events : decltype(trace->events)();
    };
    QCOMPARE(eventsOf(10.0).size(), std::size_t{1});
    QCOMPARE(eventsOf(10.0)[0].first, std::int64_t{79});
    QVERIFY(eventsOf(9.625).empty());  // it stays 0.175 m before the border
  }

 private:
  static void writeTable(const std::string& path, double rate, hsize_t rates = 1,
                         long long firstId = 1) {
    const ArchiveFile file(
        path, {{firstId, 0, 1.F, 2.0, 0.0}, {1, 1, 1.1F, 2.0, 0.0}, {2, 0, 3.F, 4.0, 0.0}});
    if (rate > 0.0) {
      ArchiveFile::number(file.root(), "fps", rate, rates);
    }
  }

  Written files_;
};

QTEST_APPLESS_MAIN(OtherDataTest)
#include "tst_TrackImportDatasets.moc"
