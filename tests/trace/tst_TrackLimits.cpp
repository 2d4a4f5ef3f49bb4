#include <hdf5.h>
#include <sys/resource.h>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/trace/JsonInput.h"
#include "tests/support/Sanitizers.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

struct Row {
  int id, frame;
  double x, y, z;
};

hid_t rowType() {
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
  H5Tinsert(type, "id", HOFFSET(Row, id), H5T_NATIVE_INT);
  H5Tinsert(type, "frame", HOFFSET(Row, frame), H5T_NATIVE_INT);
  H5Tinsert(type, "x", HOFFSET(Row, x), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "y", HOFFSET(Row, y), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "z", HOFFSET(Row, z), H5T_NATIVE_DOUBLE);
  return type;
}

/// A table of `count` rows, in pieces of `chunk` that are packed; nothing is written into it but
/// the rows given.
void writeTable(const std::string& path, hsize_t count, hsize_t chunk,
                const std::vector<Row>& rows = {}) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = rowType();
  const hsize_t most = H5S_UNLIMITED;
  const hid_t space = H5Screate_simple(1, &count, &most);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 1, &chunk);
  H5Pset_deflate(creation, 9);
  const hid_t table =
      H5Dcreate2(file, "trajectory", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  if (!rows.empty()) {
    H5Dwrite(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data());
  }
  const double rate = 25.0;
  const hid_t scalar = H5Screate(H5S_SCALAR);
  const hid_t attribute =
      H5Acreate2(file, "fps", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &rate);
  H5Aclose(attribute);
  H5Sclose(scalar);
  H5Dclose(table);
  H5Pclose(creation);
  H5Sclose(space);
  H5Tclose(type);
  H5Fclose(file);
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
    const std::string path = files_.add("rows.h5", "");
    writeTable(path, 20000000, 1024);
    const base::Diagnostics told = read(path).diagnostics();
    QCOMPARE(told.size(), std::size_t{1});
    QVERIFY(tells(told, "tracks.too-many-rows"));
  }
  void hdf5_hugePiece_isRefused() {
    const std::string path = files_.add("piece.h5", "");
    writeTable(path, 3, 100000000);
    QVERIFY(tells(read(path).diagnostics(), "tracks.too-many-rows"));
  }
  /// Rows as they are packed well: the limit is far from what recordings have.
  void hdf5_packedRows_areRead() {
    std::vector<Row> rows;
    for (int k = 0; k < 200000; ++k) {
      rows.push_back({k / 1000, k % 1000, 0.01 * (k % 1000), 1.0, 0.0});
    }
    const std::string path = files_.add("packed.h5", "");
    writeTable(path, rows.size(), 4096, rows);
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, file ? "" : file.diagnostics().front().text().c_str());
    QCOMPARE(file->tracks.size(), std::size_t{200});
    QCOMPARE(file->tracks[199].points.size(), std::size_t{1000});
  }
  /// One piece that is larger than what is read together otherwise.
  void hdf5_largePiece_isRead() {
    std::vector<Row> rows;
    for (int k = 0; k < 150000; ++k) {
      rows.push_back({k / 1000, k % 1000, 0.01 * (k % 1000), 1.0, 0.0});
    }
    const std::string path = files_.add("large.h5", "");
    writeTable(path, rows.size(), 100000, rows);
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, file ? "" : file.diagnostics().front().text().c_str());
    QCOMPARE(file->tracks.size(), std::size_t{150});
    QCOMPARE(file->tracks[149].points.size(), std::size_t{1000});
  }
  /// The same frame of the same body again and again, as of rows that were never written.
  void hdf5_emptyRows_endTheReading() {
    const std::string path = files_.add("empty.h5", "");
    writeTable(path, 500000, 1024);
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
    TrackImportOptions options;
    options.format = "trajnet";
    const base::Diagnostics told = read(files_.add("rows.txt", text), options).diagnostics();
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
  Written files_;
  QElapsedTimer clock_;
  std::size_t before_ = 0;
};

QTEST_APPLESS_MAIN(TrackLimitsTest)
#include "tst_TrackLimits.moc"
