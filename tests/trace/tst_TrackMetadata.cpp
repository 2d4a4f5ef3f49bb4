#include <QtTest>

#include "tests/trace/ArchiveFile.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

std::vector<ArchiveFile::Row> walk() {
  return {{1, 0, 100.F, 200.0, 0.0}, {1, 1, 110.F, 200.0, 0.0}};
}

double secondTime(const base::Result<TrackFile>& file) {
  return file ? file->tracks.at(0).points.at(1).time - file->tracks.at(0).points.at(0).time : -1.0;
}

/// Two people walk side by side, 5 m apart, 0.1 m per frame; sorted by id, then by frame.
std::string rowsById(const char* rest) {
  std::string text;
  for (int id = 1; id <= 2; ++id) {
    for (int frame = 0; frame < 5; ++frame) {
      text += std::to_string(id) + " " + std::to_string(frame) + " " +
              base::formatDouble(0.1 * frame) + " " + std::to_string(5 * id) + rest + "\n";
    }
  }
  return text;
}

}  // namespace

/// Frame rates, units and orders of columns wherever files state them, and the options for those
/// that they do not.
class TrackMetadataTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hdf5_rate_isAnAttributeOfFileOrTable_data() {
    QTest::addColumn<bool>("ofTable");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<int>("kind");  // a number, a fixed text, a variable one
    QTest::newRow("file") << false << QByteArray("fps") << 0;
    QTest::newRow("table") << true << QByteArray("fps") << 0;
    QTest::newRow("text of the table") << true << QByteArray("fps") << 1;
    QTest::newRow("variable text of the file") << false << QByteArray("fps") << 2;
    QTest::newRow("framerate") << true << QByteArray("framerate") << 0;
  }
  void hdf5_rate_isAnAttributeOfFileOrTable() {
    QFETCH(bool, ofTable);
    QFETCH(QByteArray, name);
    QFETCH(int, kind);
    const std::string path = files_.add("rate.h5", "");
    {
      const ArchiveFile file(path, walk());
      const hid_t of = ofTable ? file.table() : file.root();
      if (kind == 0) {
        ArchiveFile::number(of, name.constData(), 25.0);
      } else {
        ArchiveFile::text(of, name.constData(), "25 fps", kind == 2);
      }
    }
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(isNear(secondTime(file), 0.04));
  }
  void hdf5_rateInSinglePrecision_isTheSameRate() {
    const std::string path = files_.add("single.h5", "");
    {
      const ArchiveFile file(path, walk());
      ArchiveFile::number(file.root(), "fps", static_cast<double>(29.97F));
      ArchiveFile::number(file.table(), "fps", 29.97);
    }
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
  }
  void hdf5_twoRates_needTheUsers() {
    const std::string path = files_.add("rates.h5", "");
    {
      const ArchiveFile file(path, walk());
      ArchiveFile::number(file.root(), "fps", 25.0);
      ArchiveFile::number(file.table(), "fps", 16.0);
    }
    QVERIFY(textOf(read(path).diagnostics())
                .find("two frame rates are stated, 25 and 16 (choose with --fps F)") !=
            std::string::npos);
    QVERIFY(isNear(secondTime(read(path, with(&TrackImportOptions::framesPerSecond, 10.0))), 0.1));
  }
  void hdf5_unitOfColumns_andWalls_areRead() {
    const std::string path = files_.add("unit.h5", "");
    {
      const ArchiveFile file(path, walk());
      ArchiveFile::number(file.table(), "fps", 25.0);
      ArchiveFile::text(file.table(), "x", "pedestrian x-coordinate (centimeter [cm])", true);
      ArchiveFile::text(file.root(), "wkt_geometry", "POLYGON ((0 0, 400 0, 400 300, 0 300, 0 0))",
                        true);
    }
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].points[0].position, base::Vec2(1.0, 2.0));
    const base::Result<Trace> trace = sim2d::traceOfTracks(*file, {});
    QVERIFY(trace);
    QCOMPARE(trace->header.obstacles.size(), std::size_t{1});
    const sim2d::Outline& border = trace->header.obstacles[0].outlines.at(0);
    QCOMPARE(border.points.size(), std::size_t{4});
    QVERIFY(isNear(sim2d::signedArea(border.points), -12.0));  // clockwise: solid outside
  }

  /// Ten rows of "id frame x y z", no comment.
  void petrack_bareRows_nameTheirOptions() {
    for (const char* rest : {"", " 1.7"}) {
      const std::string path = files_.add("bare.txt", rowsById(rest));
      const std::string told = textOf(read(path).diagnostics());
      QVERIFY2(told.find("--fps F") != std::string::npos, told.c_str());
      QVERIFY2(told.find("--unit m, cm or mm") != std::string::npos, told.c_str());
      TrackImportOptions options = with(&TrackImportOptions::framesPerSecond, 16.0);
      const base::Result<TrackFile> metres = read(path, options);
      QVERIFY(metres && tells(metres.diagnostics(), "tracks.no-unit"));
      options.lengthUnit = 0.01;
      const base::Result<TrackFile> file = read(path, options);
      QVERIFY(file && file.diagnostics().empty());
      QCOMPARE(file->tracks.size(), std::size_t{2});
      QVERIFY(isNear(file->tracks[1].points[4].position.x(), 0.004));
      QVERIFY(isNear(file->tracks[1].points[4].time, 0.25));
    }
  }
  /// The same people as TrajNet has them: frame first.
  void trajnet_rows_areNotTakenForBareRows() {
    std::string text;
    for (int frame = 0; frame < 5; ++frame) {
      for (int id = 1; id <= 2; ++id) {
        text += std::to_string(frame) + " " + std::to_string(id) + " " +
                base::formatDouble(0.1 * frame) + " " + std::to_string(5 * id) + "\n";
      }
    }
    const base::Result<TrackFile> file = read(files_.add("frames.txt", text));
    QVERIFY(file);
    QCOMPARE(file->tracks.size(), std::size_t{2});
    QVERIFY(isNear(secondTime(file), 0.4));
  }
  void petrack_order_standsInTheComment() {
    const base::Result<TrackFile> file = read(files_.add(
        "order.txt", "# framerate: 10\n# frame id y/cm x/cm\n0 7 200 100\n1 7 200 110\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].id, 7);
    QCOMPARE(file->tracks[0].points[0].position, base::Vec2(1.0, 2.0));
    QVERIFY(isNear(secondTime(file), 0.1));
  }
  void petrack_unitInWords_isRead() {
    const base::Result<TrackFile> file =
        read(files_.add("words.txt",
                        "#framerate: 8.00\n#ID: the agent ID\n#X,Y,Z: the agents coordinates (in "
                        "metres)\n#ID FR X Y Z\n1 0 2 1 0\n1 1 3 1 0\n"));
    QVERIFY(file && file.diagnostics().empty());  // a unit is stated
    QVERIFY(isNear(file->tracks[0].points[1].position.x(), 3.0));
  }
  void columns_ofNumbers_areSaid() {
    TrackImportOptions options = withColumns("frame=2,id=1");
    options.framesPerSecond = 2.0;
    options.format = "trajnet";
    const base::Result<TrackFile> rows =
        read(files_.add("swap.txt", "7 0 1 2\n7 1 3 2\n"), options);
    QVERIFY2(rows, textOf(rows.diagnostics()).c_str());
    QCOMPARE(rows->tracks[0].id, 7);
    QVERIFY(isNear(secondTime(rows), 0.5));
    options.columns = {{"heading", "1"}};
    QVERIFY(tells(read(files_.add("swap.txt", "7 0 1 2\n"), options).diagnostics(),
                  "tracks.not-numbered"));
    options.columns = {{"x", "five"}};
    QVERIFY(tells(read(files_.add("swap.txt", "7 0 1 2\n"), options).diagnostics(),
                  "tracks.bad-column-number"));
  }

  void csv_withoutNames_asksForNumbers() {
    const std::string path = files_.add("bare.csv", "0.0,1,2,3\n0.5,1,3,3\n");
    const std::string told = textOf(read(path).diagnostics());
    QVERIFY2(told.find("bare.csv:1:1: error: the first line has numbers") != std::string::npos,
             told.c_str());
    QVERIFY(told.find("--columns time=1,id=2,x=3,y=4") != std::string::npos);
    const base::Result<TrackFile> file = read(path, withColumns("time=1,id=2,x=3,y=4"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].points.size(), std::size_t{2});
    QVERIFY(isNear(file->tracks[0].points[1].position.x(), 3.0));
  }
  void csv_units_standBehindTheNames_data() {
    QTest::addColumn<QByteArray>("header");
    QTest::newRow("square") << QByteArray("time [ms],id,x [cm],y [cm],heading [deg]\n");
    QTest::newRow("round") << QByteArray("Time(ms),ID,X(cm),Y(cm),Heading(deg)\n");
    QTest::newRow("slash") << QByteArray("time/ms,id,x/cm,y/cm,heading/deg\n");
    QTest::newRow("below") << QByteArray("time,id,x,y,heading\nms,,cm,cm,deg\n");
  }
  void csv_units_standBehindTheNames() {
    QFETCH(QByteArray, header);
    const base::Result<TrackFile> file =
        read(files_.add("units.csv", header.toStdString() + "0,1,100,200,90\n500,1,150,200,90\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(isNear(secondTime(file), 0.5));
    QCOMPARE(file->tracks[0].points[1].position, base::Vec2(1.5, 2.0));
    QVERIFY(isNear(*file->tracks[0].points[0].heading, base::kPi / 2.0));
    TrackImportOptions options;  // options of the user take precedence
    options.lengthUnit = 1e-3;
    const base::Result<TrackFile> given =
        read(files_.add("units.csv", header.toStdString() + "0,1,100,200,90\n500,1,150,200,90\n"),
             options);
    QVERIFY(isNear(given->tracks[0].points[1].position.x(), 0.15));
  }
  void csv_differentUnits_needTheOption() {
    const std::string path = files_.add("two.csv", "time,id,x [mm],y [cm]\n0,1,10,20\n1,1,20,20\n");
    const std::string told = textOf(read(path).diagnostics());
    QVERIFY2(told.find("x and y have different units (--unit METRES)") != std::string::npos,
             told.c_str());
    const base::Result<TrackFile> file = read(path, with(&TrackImportOptions::lengthUnit, 0.1));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY((file->tracks[0].points[0].position - base::Vec2(1.0, 2.0)).norm() < 1e-12);
  }
  void csv_rate_standsInAComment() {
    for (const char* comment : {"fps: 20", "fps of camera 2: 20", "frame rate [1/s] = 20"}) {
      const base::Result<TrackFile> file = read(files_.add(
          "c.csv", std::string("# lab\n# ") + comment + "\nframe,id,x,y\n0,1,0,0\n1,1,0.1,0\n"));
      QVERIFY2(file, textOf(file.diagnostics()).c_str());
      QVERIFY2(isNear(secondTime(file), 0.05), comment);
    }
    const base::Result<TrackFile> named =
        read(files_.add("n.csv", "#frame,id,x,y\n0,1,0,0\n1,1,0.1,0\n"));
    QVERIFY(textOf(named.diagnostics()).find("--fps F") != std::string::npos);
  }
  void csv_decimalCommas_areRead() {
    const base::Result<TrackFile> file =
        read(files_.add("comma.csv", "time;id;x;y\n0,5;1;1,25;2\n1,0;1;1,5;2\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(isNear(secondTime(file), 0.5));
    QVERIFY(isNear(file->tracks[0].points[0].position.x(), 1.25));
  }

  void csv_decimalCommasEverywhere_areNoUnits() {
    const base::Result<TrackFile> file =
        read(files_.add("commas.csv", "time;id;x;y\n0,5;1;1,25;2,5\n1,0;1;1,5;2,5\n"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks[0].points.size(), std::size_t{2});
    QVERIFY((file->tracks[0].points[0].position - base::Vec2(1.25, 2.5)).norm() < 1e-12);
  }

  void vsp_withoutMatrix_takesTheSizeOfAPixel() {
    const std::string path = files_.add("film.vsp", "1\n2\n-60.0 88.0 0 90.0\n40.0 -12.0 20 0.0\n");
    const std::string told = textOf(read(path).diagnostics());
    QVERIFY2(told.find("--unit METRES") != std::string::npos, told.c_str());
    const base::Result<TrackFile> file = read(path, with(&TrackImportOptions::lengthUnit, 0.02));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY((file->tracks[0].points[0].position - base::Vec2(-1.2, 1.76)).norm() < 1e-12);
  }
  void thor_framesAlone_needARate() {
    const std::string table = "Frame,Helmet_1 Centroid_X,Helmet_1 Centroid_Y\n1,1000,0\n2,1100,0\n";
    QVERIFY(textOf(read(files_.add("t.csv", table)).diagnostics()).find("--fps F") !=
            std::string::npos);
    QVERIFY(isNear(secondTime(read(files_.add("u.csv", "FREQUENCY,100\n" + table))), 0.01));
  }
  void vadere_step_standsInTheScenarioBeside() {
    Written folder;
    const std::string path =
        folder.add("postvis.traj", "timeStep pedestrianId x-PID1 y-PID1\n1 7 1 2\n2 7 1.4 2\n");
    QVERIFY(isNear(secondTime(read(path)), 0.4));
    folder.add(
        "hall.scenario",
        R"({"name": "hall", "scenario": {"attributesSimulation": {"simTimeStepLength": 0.1}}})");
    QVERIFY(isNear(secondTime(read(path)), 0.1));
    QVERIFY(isNear(secondTime(read(path, with(&TrackImportOptions::framesPerSecond, 5.0))), 0.2));
    folder.add("hall.scenario", "{");
    QVERIFY(isNear(secondTime(read(path)), 0.4));
  }
  void trajnet_rate_standsInAComment() {
    QVERIFY(isNear(secondTime(read(files_.add("r.txt", "# fps: 5\n0 1 0 0\n1 1 1 0\n2 1 2 0\n"),
                                   with(&TrackImportOptions::format, "trajnet"))),
                   0.2));
  }
  void unknownFormat_listsTheNames() {
    const std::string told =
        textOf(read(files_.add("x.bin", std::string("\0\1\2\3", 4))).diagnostics());
    QVERIFY2(told.find("--format NAME, one of csv, eth, vsp") != std::string::npos, told.c_str());
  }
  void jrdb_badJson_isToldInOurWords() {
    const std::string type =
        textOf(read(files_.add("type.json", "{\"labels\": {\"0.pcd\": [{\"label_id\": 1}]}}"))
                   .diagnostics());
    QVERIFY(!type.empty());
    QVERIFY2(type.find("json.exception") == std::string::npos, type.c_str());
  }

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(TrackMetadataTest)
#include "tst_TrackMetadata.moc"
