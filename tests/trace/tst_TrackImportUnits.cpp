#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

constexpr char kDay[] =
    "1351651345.000,1,2000,-3000,1700,1000,0.0,0.5\n"
    "1351651345.040,1,2040,-3000,1700,1000,0.0,0.5\n";

}  // namespace

/// Units of lengths, times and angles: those of the format, of the file and of the user.
class ForeignUnitsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void radius_ofTheFile_isInItsUnit() {
    TrackImportOptions options;
    options.lengthUnit = 1e-3;
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
    QTest::newRow("description") << QByteArray(
                                        "# description: corridor, recorded in cm resolution\n"
                                        "#framerate: 16.00\n#ID\tFR\tX\tY\tZ (in m)\n")
                                 << 250.0;
    QTest::newRow("description in [cm], none told")
        << QByteArray("# heights are in [cm], 5 px/cm\n# framerate: 16\n\n# PersID Frame X Y Z\n")
        << 250.0;
    QTest::newRow("x/cm") << QByteArray("#framerate: 16\n#ID FR X/cm Y/cm\n") << 2.5;
    QTest::newRow("[in cm]") << QByteArray(
                                    "# framerate: 16 fps\n"
                                    "# <number> <frame> <x> [in cm] <y> [in cm] <z>\r\n")
                             << 2.5;
    QTest::newRow("after an empty line")
        << QByteArray("# framerate: 16 fps\n\n# id frame x[cm] y[cm]\n") << 2.5;
    QTest::newRow("x/m") << QByteArray(
                                "# x, y in cm are not exact\n#framerate: 16\n#id FR x/m y/m\n")
                         << 250.0;
    QTest::newRow("mm") << QByteArray("#framerate: 16\n#id FR x/mm y/mm\n") << 0.25;
    QTest::newRow("line of the unit")
        << QByteArray("# unit: cm\n#framerate: 16\n#id FR x y\n") << 2.5;
    QTest::newRow("line below") << QByteArray("#framerate: 16\n#id FR x y\n# [in cm]\n") << 2.5;
    QTest::newRow("named columns win")
        << QByteArray("# unit: cm\n#framerate: 16\n#id FR x/m y/m\n") << 250.0;
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
    TrackImportOptions options;
    options.degrees = true;
    QVERIFY(tells(read(path, options).diagnostics(), "tracks.fixed-angles"));
  }
  void columns_thatAreFixed_areNotNamed() {
    const std::string path = files_.add("atc.csv", kDay);
    QVERIFY(tells(read(path, withColumns("x=y")).diagnostics(), "tracks.fixed-columns"));
  }
  /// Both of a person's directions by the same rule: motion along x, body at 0.5 rad.
  void unit_ofADay_scalesPlacesAndSpeeds() {
    TrackImportOptions options;
    options.lengthUnit = 1e-2;
    const base::Result<TrackFile> file = read(files_.add("atc.csv", kDay), options);
    QVERIFY(file);
    const sim2d::TrackPoint& point = file->tracks[0].points[0];
    QVERIFY((point.position - base::Vec2(20.0, -30.0)).norm() < 1e-9);
    QVERIFY((*point.velocity - base::Vec2(10.0, 0.0)).norm() < 1e-9);
    QVERIFY(isNear(*point.heading, 0.5));
  }
  /// The grid of footsteps is ours: steps of 0.4 s whatever the unit of their times.
  void timeUnit_ofFootsteps_keepsTheGrid() {
    TrackImportOptions options;
    options.timeUnit = 1e-3;
    const auto trace = traceOf(files_.add("feet.traj",
                                          "pedestrianId simTime endTime startX startY endX endY\n"
                                          "3 0 500 0.0 0.0 0.6 0.0\n3 500 1000 0.6 0.0 1.2 0.0\n"),
                               options);
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.4);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    QVERIFY(isNear(trace->frames[1].humans.x[0], 0.48));  // 0.4 s of 0.5 s
  }
  void rate_ofTimes_isTold() {
    TrackImportOptions options;
    options.framesPerSecond = 25.0;
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

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(ForeignUnitsTest)
#include "tst_TrackImportUnits.moc"
