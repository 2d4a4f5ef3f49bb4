#include <algorithm>

#include <QtTest>

#include "sim2d/trace/TrackFormats.h"
#include "tests/support/Interop.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// Lines "id x y" between lines "frame".
sim2d::TrackFile readFilm(const sim2d::TrackInput& input) {
  sim2d::FrameTracks tracks;
  sim2d::WordReader words(input.path, input.problems);
  sim2d::TextRows rows(input.text);
  long long frame = -1;
  for (std::vector<sim2d::Word> row; rows.next(row);) {
    frame += row.size() == 1 ? 1 : 0;
    const auto id = row.size() == 3 ? sim2d::idOf(words, row[0]) : std::nullopt;
    if (id) {
      const base::Vec2 place(*words.finite(row[1], "x"), *words.finite(row[2], "y"));
      tracks.add(*id, frame, place, row[0].line, row[0].column);
    }
  }
  return tracks.finish(input.path, input.options.framesPerSecond);
}

sim2d::FormatMatch claimFilm(const sim2d::FilePreview& look) {
  return look.endsWith(".film") ? sim2d::FormatMatch::ByName : sim2d::FormatMatch::None;
}

void badRow(const char* title, const char* name, const char* text, const char* problem) {
  QTest::newRow(title) << QByteArray(name) << QByteArray(text) << QByteArray(problem);
}

void badTables() {
  badRow("empty csv", "a.csv", "", "a.csv: error: the file is empty");
  badRow("header only", "a.csv", "time,id,x,y\n", "a.csv: error: the file contains no positions");
  badRow("no id", "a.csv", "time,x,y\n0,0,0\n", "a.csv:1:1: error: no column 'id'");
  badRow("no time", "a.csv", "id,x,y\n0,0,0\n", "a.csv:1:1: error: no time column");
  badRow("no id of Pathfinder", "no.csv", "t,agent,x,y\ns,,m,m\n0,1,1,1\n",
         "no column 'id' (--columns id=NAME)");
  badRow("unit", "far.csv", "time,id,x [furlong],y [furlong]\n0,1,1,1\n",
         "far.csv:1:9: error: unknown unit 'furlong' of the column x (--unit METRES)");
  badRow("nan", "a.csv", "time,id,x,y\n0,1,nan,0\n", "a.csv:2:5: error: x is not a finite");
  badRow("text", "a.csv", "time,id,x,y\n0,1,0,0\n1,1,b,0\n", "a.csv:3:5: error: x is not a finite");
  badRow("backwards", "a.csv", "time,id,x,y\n1,1,0,0\n0.5,1,0,0\n",
         "a.csv:3:1: error: time does not increase for id 1");
  badRow("twice", "a.csv", "time,id,x,y\n1,1,0,0\n1,1,0,0\n", "a.csv:3:1: error: time does not");
  badRow("fraction", "a.csv", "time,id,x,y\n0,1.5,0,0\n",
         "a.csv:2:3: error: the id is not an integer");
  badRow("negative", "a.csv", "time,id,x,y\n0,-1,0,0\n", "a.csv:2:3: error: a person's id");
  badRow("fields", "a.csv", "time,id,x,y\n0,1,0\n", "a.csv:2:5: error: the line has 3 fields");
  badRow("too long", "a.csv", "time,id,x,y\n0,1,0,0\n0.001,1,0,0\n0.002,1,0,0\n1e9,1,0,0\n",
         "a.csv: error: the times span more than");
  badRow("wild times", "a.csv", "time,id,x,y\n-1e308,1,0,0\n1e308,1,1,0\n",
         "a.csv: error: the times span more than");
}

void badFilesOfOthers() {
  badRow("thor width", "thor.csv",
         "Frame,Time,Helmet_1 Centroid_X,Helmet_1 Centroid_Y\n1,0,0,0\n2,1,0\n",
         "thor.csv:3:5: error: the line has 3 fields");
  badRow("thor number", "thor.csv", "Frame,Time,Helmet_1 Centroid_X,Helmet_1 Centroid_Y\n1,0,b,0\n",
         "thor.csv:2:5: error: x is not a finite");
  badRow("thor twins", "thor.csv",
         "Frame,Time,Helmet_1 Centroid_X,Helmet_1 Centroid_Y,Helmet_01 Centroid_X,Helmet_01 "
         "Centroid_Y\n1,0,0,0,5,5\n",
         "thor.csv:2:9: error: id 1 is used by more than one person");
  badRow("vadere back", "a.traj", "timeStep pedestrianId x y\n2 7 0 0\n1 7 1 0\n",
         "a.traj:3:1: error: time does not increase for id 7");
  badRow("vadere word", "a.traj", "timeStep pedestrianId x y\n1 7 b 0\n",
         "a.traj:2:5: error: a number is not a finite");
  badRow("vadere width", "a.traj", "timeStep pedestrianId x y\n1 7 0\n",
         "a.traj:2:5: error: the line has 3 fields");
  badRow("vadere columns", "a.traj", "pedestrianId x y\n1 7 0\n",
         "a.traj:1:1: error: no header line");
  badRow("jrdb cut", "a.json", R"({"labels": {"0.pcd": [{"label_id": "pedestrian:1", )",
         "a.json:1:52: error: not valid JSON");
  badRow("jrdb bracket", "bad.json", "{\"labels\":\n {\"0.pcd\": [{\"label_id\": 1]}}",
         "bad.json:2:27: error: not valid JSON");
  badRow("jrdb frame", "a.json", R"({"labels": {"first": [{"label_id": "pedestrian:1"}]}})",
         "no number in the frame 'first'");
  badRow("jrdb label", "a.json", R"({"labels": {"0.pcd": [{"label_id": "pedestrian:4294967297",
      "box": {"cx": 0, "cy": 0}}]}})",
         "no valid number in 'pedestrian:4294967297'");
  badRow("jrdb places", "a.json", R"({"labels": {"0.pcd": [{"label_id": "pedestrian:1",
      "box": {"cx": "b", "cy": 0}}]}})",
         "a.json: error: cannot read the frames");
  badRow("atc width", "atc.csv", "1351651345,1,0,0,0,0,0,0\n1351651346,1,0\n",
         "atc.csv:2:14: error: the line has 3 numbers instead of 8");
  badRow("atc word", "atc.csv", "1351651345,1,0,0,0,0,0,0\n1351651346,1,b,0,0,0,0,0\n",
         "atc.csv:2:14: error: x is not a finite");
  badRow("sdd scale", "annotations.txt", "4 0 0 9 9 0 0 0 0 \"Pedestrian\"\n",
         "annotations.txt: error: positions are in pixels (give the size of a pixel with --unit");
  badRow("hdf5 cut", "a.h5", "\x89HDF\r\n\x1a\n", "a.h5: error: no table 'trajectory'");
  badRow("obsmat width", "obsmat.txt", "1 1 0 0 0 0 0 0\n2 1 0 0\n",
         "obsmat.txt:2:7: error: the line has 4 numbers instead of 8");
  badRow("vsp without matrix", "a.vsp", "0\n", "H.txt");
  badRow("json", "a.ndjson", "{\"track\": {\"f\": 1,\n", "a.ndjson:1:");
  badRow("json number", "a.ndjson", "{\"track\": {\"f\": 1, \"p\": 1, \"x\": null, \"y\": 0}}\n",
         "a.ndjson:1:1: error: a track needs");
}

}  // namespace

/// Formats of others; recordings of people: real ones, which need not be there, and one of ours.
class ForeignFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void obsmat_rows_giveFramesAndVelocities() {
    Written files;
    const std::string rows =
        "  7.80e+02 1.0e+00 8.5 0.0 3.5 1.6 0.0 0.2\n 7.86e+02 1 9.1 0 3.6 1.7 0 0.3\n"
        "792 2 0 0 1 0 0 -1\n";
    const std::string path = files.add("obsmat.txt", rows);
    files.add("groups.txt", "1 2\n");
    const auto trace = traceOf(path);
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.4);  // six frames
    QCOMPARE(trace->frames.size(), std::size_t{3});
    QCOMPARE(trace->frames[0].humans.x[0], 8.5);
    QCOMPARE(trace->frames[0].humans.y[0], 3.5);
    QCOMPARE(trace->frames[1].humans.vx[0], 1.7);
    QCOMPARE(trace->frames[1].humans.vy[0], 0.3);
    QCOMPARE(trace->frames[2].humans.id[0], 2);
    QCOMPARE(trace->frames[2].humans.group[0], 1);
    QCOMPARE(traceOf(path, with(&TrackImportOptions::framesPerSecond, 30.0))->header.dt, 0.2);
  }

  void vsp_splines_areCornersInMetres() {
    Written files;
    const std::string path = files.add("crowd.vsp",
                                       "1 - the number of splines\n2 - Num of control points\n"
                                       "-60.0 88.0 0 90.0 - (2D point, m_id)\n40.0 -12.0 20 0.0\n");
    files.add("H.txt", "0 0.01 0\n0.02 0 0\n0 0 1\n");
    const base::Result<TrackFile> file = sim2d::importTracks(path, {});
    QVERIFY(file);
    const Track* track = trackOf(*file, 1);
    QVERIFY(track != nullptr);
    QCOMPARE(track->points.size(), std::size_t{2});
    QVERIFY(isNear(track->points[0].position.x(), 0.01 * (360 - 60)));
    QVERIFY(isNear(track->points[0].position.y(), 0.02 * (288 - 88)));
    QVERIFY(isNear(track->points[1].time, 0.8));  // 25 frames a second
    const auto trace = sim2d::traceOfTracks(*file, {});
    QVERIFY(trace);
    QCOMPARE(trace->frames.size(), std::size_t{3});  // every 0.4 s
    QVERIFY(isNear(trace->frames[1].humans.x[0], 3.5));
  }

  void trajnet_rowsAndLines_giveTheSame() {
    Written files;
    const auto rows = traceOf(files.add("a.txt", "0 1 0.5 1\n10 1 1.0 1.25\n10 2 4 4\n20 2 4 5\n"));
    const auto lines = traceOf(files.add("a.ndjson",
                                         R"({"scene": {"id": 1, "p": 1, "s": 0, "e": 20, "fps": 25}}
{"track": {"f": 0, "p": 1, "x": 0.5, "y": 1}}
{"track": {"f": 10, "p": 1, "x": 1.0, "y": 1.25}}
{"track": {"f": 10, "p": 2, "x": 4, "y": 4}}
{"track": {"f": 20, "p": 2, "x": 4, "y": 5}}
{"track": {"f": 20, "p": 1, "x": 9, "y": 9, "prediction_number": 0, "scene_id": 1}}
)"),
                               with(&TrackImportOptions::framesPerSecond, 25.0));
    QVERIFY(rows && lines);
    QCOMPARE(rows->header.dt, 0.4);
    QVERIFY(rows->frames.size() == 3 && lines->frames.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(rows->frames[k].humans == lines->frames[k].humans);
    }
  }

  void trajnetLines_sceneRate_isUsed() {
    Written files;
    const auto trace = traceOf(files.add("a.ndjson", R"({"scene": {"id": 1, "fps": 2.0}}
{"track": {"f": 6, "p": 1, "x": 0, "y": 0}}
{"track": {"f": 12, "p": 1, "x": 1, "y": 0}}
)"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.5);  // two observations a second
    QVERIFY(isNear(trace->frames[1].humans.vx[0], 2.0));
  }

  void socnavbench_fourLines_areColumns() {
    Written files;
    const std::string path = files.add("a.csv", "0,10,0,10\n1,1,2,2\n0.0,1.0,5,5\n0,0,2,3\n");
    TrackImportOptions options = with(&TrackImportOptions::format, "socnavbench");
    const auto trace = traceOf(path, options);
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.4);  // ten of 25 frames a second
    QCOMPARE(trace->frames[1].humans.x[0], 1.0);
    QCOMPARE(trace->frames[1].humans.y[1], 3.0);
    options.columns = {{"x", "4"}, {"y", "3"}};
    QCOMPARE(traceOf(path, options)->frames[1].humans.x[1], 3.0);
  }

  void trace_writtenAndRead_isEqual() {
    Written files;
    TrackOptions options;
    options.robotId = 1;
    const auto trace =
        traceOf(files.add("a.csv", "time,id,x,y\n0,1,0,0\n0.1,1,1,0\n0.2,1,2,0\n0.1,2,0,0.5\n"), {},
                options);
    QVERIFY(trace);
    files.add("trajectory.csv", sim2d::trajectoryCsv(*trace));
    files.add("events.csv", sim2d::eventsCsv(*trace));
    const std::string header = files.add("trace.json", sim2d::traceJson(trace->header));
    const auto back = sim2d::readTrace(header.substr(0, header.find_last_of('/')));
    QVERIFY2(back, back ? "" : back.diagnostics().front().text().c_str());
    QVERIFY(back->header == trace->header);
    QCOMPARE(back->frames.size(), trace->frames.size());
    for (std::size_t k = 0; k < back->frames.size(); ++k) {
      QVERIFY(back->frames[k].humans == trace->frames[k].humans);
      QVERIFY(back->frames[k].robots == trace->frames[k].robots);
    }
  }

  void badInput_isToldWithItsPlace_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("problem");
    badTables();
    badFilesOfOthers();
  }

  void badInput_isToldWithItsPlace() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, problem);
    Written files;
    const auto trace = traceOf(files.add(name.constData(), text.toStdString()));
    QVERIFY(!trace);
    const std::string all = textOf(trace.diagnostics());
    QVERIFY2(all.find(problem.toStdString()) != std::string::npos, all.c_str());
  }

  void format_ofSomebodyElse_isReadLikeOurs() {
    sim2d::TrackFormats formats = sim2d::standardTrackFormats();
    const std::size_t ours = formats.names().size();
    formats.add({"film", 9, claimFilm, readFilm});
    QCOMPARE(formats.names().size(), ours + 1);
    QVERIFY(formats.find("film") != nullptr);
    Written files;
    const std::string path = files.add("a.film", "frame\n1 0 0\n2 5 5\nframe\n1 1 0\n");
    TrackImportOptions options = with(&TrackImportOptions::framesPerSecond, 2.0);
    const base::Result<TrackFile> read = sim2d::importTracks(path, options, formats);
    QVERIFY(read);
    QCOMPARE(trackOf(*read, 1)->points.size(), std::size_t{2});
    QCOMPARE(trackOf(*read, 1)->points[1].time, 0.5);
    options.format = "film";
    const std::string other = files.add("b.txt", "frame\n1 0 0\n2 5 5\nframe\n1 1 0\n");
    QVERIFY(sim2d::importTracks(other, options, formats));
    QVERIFY(!sim2d::importTracks(other, options));  // ours do not know the name
  }

  void recordings_zara_splinesLieOnTheAnnotations() {
    const QString found = interopFile(QStringLiteral("trajectories/zara01"));
    const std::string folder = found.toStdString() + "/";
    if (found.isEmpty()) {
      QSKIP("the recordings are not here (HUNAV_INTEROP_DIR)");
    }
    const auto splines = sim2d::importTracks(folder + "annotation.vsp", {});
    const auto rows = sim2d::importTracks(folder + "obsmat.txt",
                                          with(&TrackImportOptions::framesPerSecond, 25.0));
    QVERIFY(splines && rows);
    std::size_t points = 0;
    std::vector<double> distances;
    for (const Track& spline : splines->tracks) {
      points += spline.points.size();
      const Track* person = trackOf(*rows, spline.id);
      for (const sim2d::TrackPoint& corner : spline.points) {
        const double time = corner.time + 1.0 / 25.0;  // frame 0 is frame 1 of the rows
        for (std::size_t k = 1; person != nullptr && k < person->points.size(); ++k) {
          const sim2d::TrackPoint& a = person->points[k - 1];
          const sim2d::TrackPoint& b = person->points[k];
          if (time >= a.time - 1e-9 && time <= b.time + 1e-9) {
            const double share = (time - a.time) / (b.time - a.time);
            distances.push_back(
                (a.position + share * (b.position - a.position) - corner.position).norm());
            break;
          }
        }
      }
    }
    QVERIFY(points >= 1262);
    QVERIFY2(distances.size() == 1262, std::to_string(distances.size()).c_str());
    std::sort(distances.begin(), distances.end());
    const double median = distances[distances.size() / 2];
    QVERIFY2(median < 0.0115, std::to_string(median).c_str());
    QVERIFY(distances[distances.size() * 9 / 10] < 0.0345);
  }

  void recordings_obsmat_instantsAreTheRows_data() {
    QTest::addColumn<QString>("set");
    QTest::newRow("own") << QStringLiteral("own");
    QTest::newRow("eth") << QStringLiteral("eth");
    QTest::newRow("hotel") << QStringLiteral("hotel");
  }

  void recordings_obsmat_instantsAreTheRows() {
    QFETCH(QString, set);
    const std::string path =
        interopFile(QStringLiteral("trajectories/%1/obsmat.txt").arg(set)).toStdString();
    if (path.empty()) {
      QSKIP("the recordings are not here (HUNAV_INTEROP_DIR)");
    }
    const auto trace = traceOf(path);
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.4);
    std::size_t states = 0;
    for (const sim2d::Frame& frame : trace->frames) {
      states += frame.humans.size();
    }
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::ReadOnly));
    std::size_t rows = 0;
    while (!file.atEnd()) {
      rows += file.readLine().trimmed().isEmpty() ? 0U : 1U;
    }
    // Every row is an instant; single annotations that were left out are filled in. Films that were
    // cut have people between the instants: each loses one.
    QVERIFY2(states + trace->header.humans.size() >= rows && states < rows + rows / 10,
             (std::to_string(states) + " of " + std::to_string(rows)).c_str());
  }
};

QTEST_APPLESS_MAIN(ForeignFilesTest)
#include "tst_TrackImport.moc"
