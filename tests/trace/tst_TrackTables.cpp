#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

std::string textOf(const base::Diagnostics& problems) {
  std::string all;
  for (const base::Diagnostic& problem : problems) {
    all += problem.text() + "\n";
  }
  return all;
}

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

}  // namespace

/// Tables of other simulators: Pathfinder, Viswalk.
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
  void pathfinder_missingColumn_namesTheOption() {
    const std::string told =
        textOf(read(files_.add("no.csv", "t,agent,x,y\ns,,m,m\n0,1,1,1\n")).diagnostics());
    QVERIFY2(told.find("no column 'id' (--columns id=NAME)") != std::string::npos, told.c_str());
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

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(TrackTablesTest)
#include "tst_TrackTables.moc"
