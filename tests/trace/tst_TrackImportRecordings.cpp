#include <QtTest>

#include "tests/support/Interop.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

/// Recordings of people: real ones, which need not be there, and one of ours.
class ForeignRecordingsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void recordings_zara_splinesLieOnTheAnnotations();
  void recordings_obsmat_instantsAreTheRows_data();
  void recordings_obsmat_instantsAreTheRows();
};

void ForeignRecordingsTest::recordings_zara_splinesLieOnTheAnnotations() {
  const QString found = interopFile(QStringLiteral("trajectories/zara01"));
  const std::string folder = found.toStdString() + "/";
  if (found.isEmpty()) {
    QSKIP("the recordings are not here (HUNAV_INTEROP_DIR)");
  }
  const auto splines = sim2d::importTracks(folder + "annotation.vsp", {});
  TrackImportOptions options;
  options.framesPerSecond = 25.0;
  const auto rows = sim2d::importTracks(folder + "obsmat.txt", options);
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

void ForeignRecordingsTest::recordings_obsmat_instantsAreTheRows_data() {
  QTest::addColumn<QString>("set");
  QTest::newRow("own") << QStringLiteral("own");
  QTest::newRow("eth") << QStringLiteral("eth");
  QTest::newRow("hotel") << QStringLiteral("hotel");
}

void ForeignRecordingsTest::recordings_obsmat_instantsAreTheRows() {
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

QTEST_APPLESS_MAIN(ForeignRecordingsTest)
#include "tst_TrackImportRecordings.moc"
