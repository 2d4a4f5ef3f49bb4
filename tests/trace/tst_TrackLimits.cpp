#include <sys/resource.h>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/trace/JsonInput.h"
#include "tests/support/Sanitizers.h"
#include "tests/trace/ArchiveFile.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// People who walk along x for a thousand frames each.
std::vector<ArchiveFile::Row> walks(int people) {
  std::vector<ArchiveFile::Row> rows;
  for (int k = 0; k < 1000 * people; ++k) {
    const int frame = k % 1000;
    rows.push_back({k / 1000, frame, 0.01F * static_cast<float>(frame), 1.0, 0.0});
  }
  return rows;
}

/// Largest memory of the process so far [B].
std::size_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024U;
}

}  // namespace

/// Small files do not take much memory or time.
class TrackLimitsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    before_ = peakMemory();
    clock_.start();
  }
  void cleanup() {
    constexpr std::size_t kMost = std::size_t{400} << 20U;  // [B]
    const std::size_t used = peakMemory() - before_;        // with that of a sanitizer for itself
    QVERIFY2(used < kMost || kIsSanitized, std::to_string(used).c_str());
    QVERIFY2(clock_.elapsed() < 20000, std::to_string(clock_.elapsed()).c_str());
  }

  /// 2 kB that declare 640 MB.
  void hdf5_rowsThatAreNotThere_areRefused() {
    const base::Diagnostics told = read(archive("rows.h5", {}, 1024, 20000000)).diagnostics();
    QCOMPARE(told.size(), std::size_t{1});
    QVERIFY(tells(told, "tracks.too-many-rows"));
  }
  void hdf5_hugePiece_isRefused() {
    QVERIFY(
        tells(read(archive("piece.h5", {}, 100000000, 3)).diagnostics(), "tracks.too-many-rows"));
  }
  /// Rows as they are packed well: the limit is far from what recordings have.
  void hdf5_packedRows_areRead() {
    const base::Result<TrackFile> file = read(archive("packed.h5", walks(200), 4096));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks.size(), std::size_t{200});
    QCOMPARE(file->tracks[199].points.size(), std::size_t{1000});
  }
  /// One piece that is larger than what is read together otherwise.
  void hdf5_largePiece_isRead() {
    const base::Result<TrackFile> file = read(archive("large.h5", walks(150), 100000));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks.size(), std::size_t{150});
    QCOMPARE(file->tracks[149].points.size(), std::size_t{1000});
  }
  /// The same frame of the same body again and again, as of rows that were never written.
  void hdf5_emptyRows_endTheReading() {
    const std::string path = archive("empty.h5", {}, 1024, 500000);
    const base::Result<TrackFile> file = read(path);
    QVERIFY(file && file->tracks.at(0).points.size() < 100000);
    QVERIFY(tells(traceOf(path).diagnostics(), "tracks.backwards"));
  }

  /// Four lines that span a month of milliseconds.
  void csv_longSpan_isRefused() {
    const std::string path =
        files_.add("span.csv", "time,id,x,y\n0,1,0,0\n0.001,1,0,0\n1999,2,0,0\n1999.001,2,0,0\n");
    const base::Diagnostics told = traceOf(path).diagnostics();
    QVERIFY(tells(told, "tracks.too-long"));
    QVERIFY(told.back().message.find("--time-unit") != std::string::npos);
  }
  /// Straight lines of 300 people over 40 000 instants each.
  void vsp_longLines_areRefused() {
    std::string text = "300\n";
    for (int k = 0; k < 300; ++k) {
      text += "2\n0 0 0 0\n1 1 400000 0\n";
    }
    files_.add("H.txt", "0 0.01 0\n0.02 0 0\n0 0 1\n");
    QVERIFY(tells(traceOf(files_.add("long.vsp", text)).diagnostics(), "tracks.too-many-states"));
  }
  /// Every person is in every group's line.
  void groups_ofManyPeople_areReadInTime() {
    std::string rows;
    std::string groups;
    for (int k = 0; k < 60000; ++k) {
      rows += "0 " + std::to_string(k) + " 0 0 0 0 0 0\n";
      groups += std::to_string(k) + (k % 2 == 0 ? " " : "\n");
    }
    const std::string path = files_.add("obsmat.txt", rows);
    files_.add("groups.txt", groups);
    const base::Result<TrackFile> file = read(path);
    QVERIFY(file);
    QCOMPARE(trackOf(*file, 59999)->group, 30000);
    files_.add("groups.txt", "");
  }
  void thor_manyBodies_areReadInTime() {
    std::string names = "Frame,Time";
    std::string row = "1,0";
    for (int k = 0; k < 40000; ++k) {
      const std::string name = "Helmet_" + std::to_string(k) + "b";
      names += "," + name + " Centroid_X," + name + " Centroid_Y";
      row += ",1,1";
    }
    const base::Result<TrackFile> file = read(files_.add("thor.csv", names + "\n" + row + "\n"));
    QVERIFY(file);
    QCOMPARE(file->tracks.size(), std::size_t{40000});
  }
  void problems_ofManyRows_areLimited() {
    std::string text = "0 1 0 0\n";
    for (int k = 0; k < 2000000; ++k) {
      text += "a\n";
    }
    const base::Diagnostics told =
        read(files_.add("rows.txt", text), with(&TrackImportOptions::format, "trajnet"))
            .diagnostics();
    QVERIFY(tells(told, "tracks.more-of-a-kind") && told.size() < 20);
  }
  /// Paths of members would take the square of the file.
  void json_deepAndLongKeys_takeLittle() {
    std::string deep;
    for (int k = 0; k < 100000; ++k) {
      deep += "{\"a\":";
    }
    deep += "1" + std::string(100000, '}');
    QCOMPARE(sim2d::JsonLineIndex(deep).lineOf("a.a.a"), 1);
    std::string list = "{\"" + std::string(300000, 'k') + "\": [";
    for (int k = 0; k < 100000; ++k) {
      list += "{},";
    }
    QCOMPARE(sim2d::JsonLineIndex(list + "{}]}").lineOf("a"), 0);
  }

 private:
  std::string archive(const char* name, const std::vector<ArchiveFile::Row>& rows, hsize_t chunk,
                      hsize_t count = 0) {
    const std::string path = files_.add(name, "");
    const ArchiveFile file(path, rows, chunk, count);
    ArchiveFile::number(file.root(), "fps", 25.0);
    return path;
  }

  Written files_;
  QElapsedTimer clock_;
  std::size_t before_ = 0;
};

QTEST_APPLESS_MAIN(TrackLimitsTest)
#include "tst_TrackLimits.moc"
