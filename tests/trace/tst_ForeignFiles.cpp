#include <cmath>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignFiles.h"

using sim2d::ForeignFormat;
using sim2d::ForeignOptions;
using sim2d::Trace;
using sim2d::Track;
using sim2d::TrackFile;
using sim2d::TrackOptions;

namespace {

QString recordings() {
  const QString folder =
      qEnvironmentVariable("HUNAV_INTEROP_DIR", QStringLiteral(SOURCE_DIR "/../shared/interop"));
  return QDir(folder).absoluteFilePath(QStringLiteral("trajectories"));
}

/// A file in a folder of its own.
class Written {
 public:
  std::string add(const char* name, const std::string& text) {
    const std::string path = folder_.path().toStdString() + "/" + name;
    written_ = base::writeFileAtomically(path, text).empty() && written_;
    return written_ ? path : std::string();
  }

 private:
  QTemporaryDir folder_;
  bool written_ = true;
};

base::Result<Trace> traceOf(const std::string& path, const ForeignOptions& options = {},
                            const TrackOptions& tracks = {}) {
  const base::Result<TrackFile> file = sim2d::readForeign(path, options);
  return file ? sim2d::traceOfTracks(*file, tracks) : base::Result<Trace>(file.diagnostics());
}

ForeignOptions withColumns(const char* text) {
  ForeignOptions options;
  options.columns = *sim2d::parseColumns(text);
  return options;
}

bool isNear(double a, double b) {
  return std::fabs(a - b) < 1e-9;
}

const Track* trackOf(const TrackFile& file, int id) {
  for (const Track& track : file.tracks) {
    if (track.id == id) {
      return &track;
    }
  }
  return nullptr;
}

}  // namespace

class ForeignFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void csv_namedColumns_giveStatesOfEachInstant();
  void csv_unevenTimes_areInterpolated();
  void csv_toldMotion_isKept();
  void csv_personAway_isNotThere();
  void csv_oneSample_isARecord();
  void csv_robotColumn_givesARobot();
  void obsmat_rows_giveFramesAndVelocities();
  void vsp_splines_areCornersInMetres();
  void trajnet_rowsAndLines_giveTheSame();
  void trajnetLines_sceneRate_isUsed();
  void socnavbench_fourLines_areColumns();
  void robot_ofAPerson_cutsTheRecord();
  void robot_betweenTheOthers_isMetByTheInstants();
  void trace_writtenAndRead_isEqual();
  void badInput_isToldWithItsPlace_data();
  void badInput_isToldWithItsPlace();
  void parseColumns_wrongWords_areErrors();
  void recordings_zara_splinesLieOnTheAnnotations();
  void recordings_obsmat_instantsAreTheRows_data();
  void recordings_obsmat_instantsAreTheRows();
};

void ForeignFilesTest::csv_namedColumns_giveStatesOfEachInstant() {
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

void ForeignFilesTest::csv_unevenTimes_areInterpolated() {
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

void ForeignFilesTest::csv_toldMotion_isKept() {
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

void ForeignFilesTest::csv_personAway_isNotThere() {
  Written files;
  const auto trace = traceOf(
      files.add("a.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n8,1,8,0\n9,1,9,0\n10,1,10,0\n"));
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{11});
  QCOMPARE(trace->frames[2].humans.size(), std::size_t{1});
  QCOMPARE(trace->frames[5].humans.size(), std::size_t{0});
  QCOMPARE(trace->frames[8].humans.x[0], 8.0);
  QVERIFY(isNear(trace->frames[8].humans.vx[0], 1.0));  // not over the absence
}

void ForeignFilesTest::csv_oneSample_isARecord() {
  Written files;
  const auto trace = traceOf(files.add("a.csv", "time,id,x,y\n3.5,1,2,4\n"));
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{1});
  QCOMPARE(trace->frames[0].humans.x[0], 2.0);
  QCOMPARE(trace->frames[0].humans.vx[0], 0.0);
}

void ForeignFilesTest::csv_robotColumn_givesARobot() {
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

void ForeignFilesTest::obsmat_rows_giveFramesAndVelocities() {
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
  ForeignOptions options;
  options.framesPerSecond = 30.0;
  QCOMPARE(traceOf(path, options)->header.dt, 0.2);
}

void ForeignFilesTest::vsp_splines_areCornersInMetres() {
  Written files;
  const std::string path = files.add("crowd.vsp",
                                     "1 - the number of splines\n2 - Num of control points\n"
                                     "-60.0 88.0 0 90.0 - (2D point, m_id)\n40.0 -12.0 20 0.0\n");
  files.add("H.txt", "0 0.01 0\n0.02 0 0\n0 0 1\n");
  const base::Result<TrackFile> file = sim2d::readForeign(path, {});
  QVERIFY(file);
  const Track* track = trackOf(*file, 1);
  QVERIFY(track != nullptr && track->points.size() == 2);
  QVERIFY(isNear(track->points[0].position.x(), 0.01 * (360 - 60)));
  QVERIFY(isNear(track->points[0].position.y(), 0.02 * (288 - 88)));
  QVERIFY(isNear(track->points[1].time, 0.8));  // 25 frames a second
  const auto trace = sim2d::traceOfTracks(*file, {});
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{3});  // every 0.4 s
  QVERIFY(isNear(trace->frames[1].humans.x[0], 3.5));
}

void ForeignFilesTest::trajnet_rowsAndLines_giveTheSame() {
  Written files;
  const auto rows = traceOf(files.add("a.txt", "0 1 0.5 1\n10 1 1.0 1.25\n10 2 4 4\n20 2 4 5\n"));
  ForeignOptions options;
  options.framesPerSecond = 25.0;
  const auto lines = traceOf(files.add("a.ndjson",
                                       R"({"scene": {"id": 1, "p": 1, "s": 0, "e": 20, "fps": 25}}
{"track": {"f": 0, "p": 1, "x": 0.5, "y": 1}}
{"track": {"f": 10, "p": 1, "x": 1.0, "y": 1.25}}
{"track": {"f": 10, "p": 2, "x": 4, "y": 4}}
{"track": {"f": 20, "p": 2, "x": 4, "y": 5}}
{"track": {"f": 20, "p": 1, "x": 9, "y": 9, "prediction_number": 0, "scene_id": 1}}
)"),
                             options);
  QVERIFY(rows && lines);
  QCOMPARE(rows->header.dt, 0.4);
  QVERIFY(rows->frames.size() == 3 && lines->frames.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    QVERIFY(rows->frames[k].humans == lines->frames[k].humans);
  }
}

void ForeignFilesTest::trajnetLines_sceneRate_isUsed() {
  Written files;
  const auto trace = traceOf(files.add("a.ndjson", R"({"scene": {"id": 1, "fps": 2.0}}
{"track": {"f": 6, "p": 1, "x": 0, "y": 0}}
{"track": {"f": 12, "p": 1, "x": 1, "y": 0}}
)"));
  QVERIFY(trace);
  QCOMPARE(trace->header.dt, 0.5);  // two observations a second
  QVERIFY(isNear(trace->frames[1].humans.vx[0], 2.0));
}

void ForeignFilesTest::socnavbench_fourLines_areColumns() {
  Written files;
  const std::string path = files.add("a.csv", "0,10,0,10\n1,1,2,2\n0.0,1.0,5,5\n0,0,2,3\n");
  ForeignOptions options;
  options.format = ForeignFormat::Socnavbench;
  const auto trace = traceOf(path, options);
  QVERIFY(trace);
  QCOMPARE(trace->header.dt, 0.4);  // ten of 25 frames a second
  QCOMPARE(trace->frames[1].humans.x[0], 1.0);
  QCOMPARE(trace->frames[1].humans.y[1], 3.0);
  options.columns = {{"x", "4"}, {"y", "3"}};
  QCOMPARE(traceOf(path, options)->frames[1].humans.x[1], 3.0);
}

void ForeignFilesTest::robot_ofAPerson_cutsTheRecord() {
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

void ForeignFilesTest::robot_betweenTheOthers_isMetByTheInstants() {
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

void ForeignFilesTest::trace_writtenAndRead_isEqual() {
  Written files;
  TrackOptions options;
  options.robotId = 1;
  const auto trace = traceOf(
      files.add("a.csv", "time,id,x,y\n0,1,0,0\n0.1,1,1,0\n0.2,1,2,0\n0.1,2,0,0.5\n"), {}, options);
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

void ForeignFilesTest::badInput_isToldWithItsPlace_data() {
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("problem");
  const auto row = [](const char* title, const char* name, const char* text, const char* problem) {
    QTest::newRow(title) << QByteArray(name) << QByteArray(text) << QByteArray(problem);
  };
  row("empty csv", "a.csv", "", "a.csv: error: is empty");
  row("header only", "a.csv", "time,id,x,y\n", "a.csv: error: holds no positions");
  row("no id", "a.csv", "time,x,y\n0,0,0\n", "a.csv:1:1: error: no column 'id'");
  row("no time", "a.csv", "id,x,y\n0,0,0\n", "a.csv:1:1: error: no column of times");
  row("nan", "a.csv", "time,id,x,y\n0,1,nan,0\n", "a.csv:2:5: error: x is not a finite");
  row("text", "a.csv", "time,id,x,y\n0,1,0,0\n1,1,b,0\n", "a.csv:3:5: error: x is not a finite");
  row("backwards", "a.csv", "time,id,x,y\n1,1,0,0\n0.5,1,0,0\n",
      "a.csv:3:1: error: time does not advance for id 1");
  row("twice", "a.csv", "time,id,x,y\n1,1,0,0\n1,1,0,0\n", "a.csv:3:1: error: time does not");
  row("fraction", "a.csv", "time,id,x,y\n0,1.5,0,0\n", "a.csv:2:3: error: the id is not a whole");
  row("negative", "a.csv", "time,id,x,y\n0,-1,0,0\n", "a.csv:2:3: error: a person's id");
  row("fields", "a.csv", "time,id,x,y\n0,1,0\n", "a.csv:2:5: error: the line has 3 fields");
  row("too long", "a.csv", "time,id,x,y\n0,1,0,0\n0.001,1,0,0\n0.002,1,0,0\n1e9,1,0,0\n",
      "a.csv: error: the times span more than");
  row("obsmat width", "obsmat.txt", "1 1 0 0 0 0 0 0\n2 1 0 0\n",
      "obsmat.txt:2:7: error: the line has 4 numbers instead of 8");
  row("vsp without matrix", "a.vsp", "0\n", "H.txt");
  row("json", "a.ndjson", "{\"track\": {\"f\": 1,\n", "a.ndjson:1:");
  row("json number", "a.ndjson", "{\"track\": {\"f\": 1, \"p\": 1, \"x\": null, \"y\": 0}}\n",
      "a.ndjson:1:1: error: a track needs");
}

void ForeignFilesTest::badInput_isToldWithItsPlace() {
  QFETCH(QByteArray, name);
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, problem);
  Written files;
  const auto trace = traceOf(files.add(name.constData(), text.toStdString()));
  QVERIFY(!trace);
  std::string all;
  for (const base::Diagnostic& diagnostic : trace.diagnostics()) {
    all += diagnostic.text() + "\n";
  }
  QVERIFY2(all.find(problem.toStdString()) != std::string::npos, all.c_str());
}

void ForeignFilesTest::parseColumns_wrongWords_areErrors() {
  QVERIFY(!sim2d::parseColumns("time"));
  QVERIFY(!sim2d::parseColumns("tme=t"));
  QVERIFY(!sim2d::parseColumns("x=a,x=b"));
  QVERIFY(sim2d::parseColumns("tme=t").diagnostics()[0].message.find("'time'") !=
          std::string::npos);
}

void ForeignFilesTest::recordings_zara_splinesLieOnTheAnnotations() {
  const std::string folder = (recordings() + QStringLiteral("/zara01/")).toStdString();
  if (!QFile::exists(QString::fromStdString(folder))) {
    QSKIP("the recordings are not here (HUNAV_INTEROP_DIR)");
  }
  const auto splines = sim2d::readForeign(folder + "annotation.vsp", {});
  ForeignOptions options;
  options.framesPerSecond = 25.0;
  const auto rows = sim2d::readForeign(folder + "obsmat.txt", options);
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

void ForeignFilesTest::recordings_obsmat_instantsAreTheRows_data() {
  QTest::addColumn<QString>("set");
  QTest::newRow("eth") << QStringLiteral("eth");
  QTest::newRow("hotel") << QStringLiteral("hotel");
}

void ForeignFilesTest::recordings_obsmat_instantsAreTheRows() {
  QFETCH(QString, set);
  const std::string path = (recordings() + QLatin1Char('/') + set).toStdString() + "/obsmat.txt";
  if (!QFile::exists(QString::fromStdString(path))) {
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

QTEST_APPLESS_MAIN(ForeignFilesTest)
#include "tst_ForeignFiles.moc"
