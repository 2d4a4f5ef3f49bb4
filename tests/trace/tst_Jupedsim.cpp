#include <sqlite3.h>

#include <QFile>
#include <QtTest>

#include "sim2d/trace/TrackFormats.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// The tables that JuPedSim's writer creates, version 2.
constexpr char kTables[] =
    "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT "
    "NULL, pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata (key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL);"
    "CREATE TABLE frame_data (frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);"
    "CREATE INDEX frame_id_idx ON trajectory_data(frame, id);"
    "INSERT INTO metadata VALUES ('version', '2'), ('xmin', '0'), ('xmax', '4'), ('ymin', '0'), "
    "('ymax', '3');";
constexpr char kRate[] = "INSERT INTO metadata VALUES ('fps', '10.0');";
constexpr char kRows[] =
    "INSERT INTO trajectory_data VALUES (1, 5, 1.5, 1.0, 0.0, 1.0), (0, 5, 1.0, 1.0, 1.0, 0.0), "
    "(0, 6, 3.0, 1.0, 0.0, 0.0), (1, 6, 3.0, 1.0, 0.0, 0.0);";

}  // namespace

/// SQLite trajectories of JuPedSim.
class JupedsimTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void trajectories_areRead() {
    const base::Result<TrackFile> file = read(written("a.sqlite", {kTables, kRate, kRows}));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(file.diagnostics().empty());
    QCOMPARE(file->tracks.size(), std::size_t{2});
    const Track& walker = *trackOf(*file, 5);
    QCOMPARE(walker.points.size(), std::size_t{2});  // in the order of their frames
    QVERIFY(isNear(walker.points[1].time - walker.points[0].time, 0.1));
    QCOMPARE(walker.points[1].position, base::Vec2(1.5, 1.0));
    QVERIFY(isNear(*walker.points[0].heading, 0.0));
    QVERIFY(isNear(*walker.points[1].heading, base::kPi / 2.0));
    QVERIFY(!trackOf(*file, 6)->points[0].heading);  // no direction
  }
  void geometry_isTheWall() {
    const std::string path = written(
        "g.sqlite",
        {kTables, kRate, kRows,
         "INSERT INTO geometry VALUES (9, 'POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))'), (7, "
         "'GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0), (1 2, 2 2, 2 2.5, 1 2)))');"
         "INSERT INTO frame_data VALUES (0, 7), (1, 9);"});
    const base::Result<TrackFile> file = read(path);
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(tells(file.diagnostics(), "tracks.geometries"));
    QCOMPARE(file->obstacles.size(), std::size_t{1});
    const std::vector<sim2d::Outline>& outlines = file->obstacles[0].outlines;
    QCOMPARE(outlines.size(), std::size_t{2});
    QVERIFY(isNear(sim2d::signedArea(outlines[0].points), -12.0));  // solid outside
    QVERIFY(isNear(sim2d::signedArea(outlines[1].points), 0.25));   // solid inside
  }
  void noRate_asksForIt() {
    const std::string path = written("r.sqlite", {kTables, kRows});
    QVERIFY(textOf(read(path).diagnostics()).find("--fps F") != std::string::npos);
    QVERIFY(isNear(
        trackOf(*read(path, with(&TrackImportOptions::framesPerSecond, 5.0)), 5)->points[1].time,
        0.2));
  }
  void badFiles_areErrors() {
    const auto told = [](const std::string& path) {
      return read(path, with(&TrackImportOptions::format, "jupedsim")).diagnostics();
    };
    QVERIFY(
        tells(told(written("t.sqlite", {"CREATE TABLE other (a);"})), "tracks.no-trajectory-data"));
    QVERIFY(tells(told(files_.add("n.sqlite", "no database at all")), "tracks.bad-database"));
    const std::string text = written(
        "c.sqlite",
        {"CREATE TABLE trajectory_data (frame, id, pos_x, pos_y);"
         "CREATE TABLE metadata (key, value); INSERT INTO metadata VALUES ('fps', 10);"
         "INSERT INTO trajectory_data VALUES (0, 1, 1, 1), (1, 1, 'east', 1), (2, 1, 1, NULL), "
         "(3, -1, 1, 1), (4, 1.5, 1, 1);"});
    const base::Diagnostics problems = told(text);
    QCOMPARE(problems.size(), std::size_t{4});
    QVERIFY(textOf(problems).find("row 2 of trajectory_data: pos_x is not a valid number") !=
            std::string::npos);
    QVERIFY(textOf(problems).find("row 3 of trajectory_data: pos_y") != std::string::npos);
    QVERIFY(tells(told("-"), "tracks.needs-file"));
  }
  /// A view instead of the table would never end; the value of a row would be larger than the file.
  void queriesInTheFile_areNotRun() {
    const std::string view = written(
        "v.sqlite",
        {"CREATE VIEW trajectory_data AS WITH RECURSIVE n(k) AS (SELECT 1 UNION ALL SELECT k + 1 "
         "FROM n) SELECT k AS frame, 1 AS id, 0.0 AS pos_x, 0.0 AS pos_y FROM n;",
         "CREATE TABLE metadata (key, value); INSERT INTO metadata VALUES ('fps', 10);"});
    QVERIFY(!read(view));
    const std::string column = written(
        "x.sqlite", {"CREATE TABLE trajectory_data (frame, id, pos_y, pos_x AS "
                     "(length(hex(zeroblob(2000000)))));",
                     "CREATE TABLE metadata (key, value); INSERT INTO metadata VALUES ('fps', 10);",
                     "INSERT INTO trajectory_data VALUES (0, 1, 1);"});
    QElapsedTimer clock;
    clock.start();
    QVERIFY(tells(read(column).diagnostics(), "tracks.bad-database"));
    QVERIFY(clock.elapsed() < 2000);
  }
  /// Pages that refer to the same page again and again would be 461^4 pages of rows.
  void damagedPages_endTheReading() {
    const std::string path = written("p.sqlite", {"PRAGMA page_size = 4096;", kTables, kRate});
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    sqlite3_exec(database,
                 "DROP INDEX frame_id_idx; WITH RECURSIVE n(k) AS (SELECT 0 UNION ALL SELECT k + 1 "
                 "FROM n LIMIT 40000) INSERT INTO trajectory_data SELECT k, 1, 0.5 * k + 0.1, 1.5, "
                 "0.1, 0.2 FROM n;",
                 nullptr, nullptr, nullptr);
    sqlite3_stmt* root = nullptr;
    sqlite3_prepare_v2(database,
                       "SELECT rootpage FROM sqlite_master WHERE name = 'trajectory_data'", -1,
                       &root, nullptr);
    QCOMPARE(sqlite3_step(root), SQLITE_ROW);
    const auto page = static_cast<std::size_t>(sqlite3_column_int(root, 0));
    sqlite3_finalize(root);
    sqlite3_close(database);
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::ReadWrite));
    std::string bytes = file.readAll().toStdString();
    nestPages(bytes, page);
    QVERIFY(file.seek(0));
    QCOMPARE(file.write(bytes.data(), static_cast<qint64>(bytes.size())),
             static_cast<qint64>(bytes.size()));
    file.close();
    QVERIFY(tells(read(path).diagnostics(), "tracks.more-rows"));
  }
  /// 900 sums per row.
  void expensiveColumns_endTheReading() {
    std::string sum = "frame";
    for (int k = 0; k < 900; ++k) {
      sum += " + frame";
    }
    const std::string table =
        "CREATE TABLE trajectory_data (frame INT, id INT, pos_y REAL, pos_x REAL AS (" + sum +
        "));";
    const std::string path = written(
        "s.sqlite",
        {table.c_str(), "CREATE TABLE metadata (key, value);", kRate,
         "WITH RECURSIVE n(k) AS (SELECT 0 UNION ALL SELECT k + 1 FROM n LIMIT 40000) INSERT INTO "
         "trajectory_data SELECT k, 1, 1.5 FROM n;"});
    QVERIFY(tells(read(path).diagnostics(), "tracks.too-many-steps"));
  }
  void wkt_ofOtherShapes_isNoWall() {
    QCOMPARE(sim2d::walkableOutlines("MULTIPOLYGON (((0 0, 1 0, 1 1)), ((5 5, 6 5, 6 6)))")->size(),
             std::size_t{2});
    QCOMPARE(sim2d::walkableOutlines("POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))")->size(),
             std::size_t{1});
    for (const char* text : {"LINESTRING (0 0, 1 1)", "POLYGON ((0 0, 1 0", "POLYGON ((a b))",
                             "POLYGON ((0 0, 1e400 0, 1 1))", "{}", "((((((", "POLYGON EMPTY"}) {
      QVERIFY2(!sim2d::walkableOutlines(text), text);
    }
  }

 private:
  static std::uint32_t bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < count; ++k) {
      value = value << 8U | static_cast<unsigned char>(bytes[at + k]);
    }
    return value;
  }
  /// All children of the root become one page that has the root's children, and so on, thrice.
  static void nestPages(std::string& bytes, std::size_t root) {
    constexpr std::size_t kPage = 4096;
    constexpr std::size_t kHead = 12;  // of an interior page; then the places of its cells
    const std::size_t begin = (root - 1) * kPage;
    const std::string original = bytes.substr(begin, kPage);
    const std::uint32_t count = bigEndian(original, 3, 2);
    const auto cell = [&original](std::size_t k) { return bigEndian(original, kHead + 2 * k, 2); };
    std::uint32_t child = bigEndian(original, cell(0), 4);
    const auto pageOf = [&](std::uint32_t number) {
      std::string page = original;
      const auto put = [&page, number](std::size_t at) {
        for (std::size_t k = 0; k < 4; ++k) {
          page[at + k] = static_cast<char>(number >> (24U - 8U * k));
        }
      };
      for (std::size_t k = 0; k < count; ++k) {
        put(cell(k));
      }
      put(8);  // the last child
      return page;
    };
    for (std::size_t k = 1; k <= 3; ++k) {
      const std::uint32_t place = bigEndian(original, cell(k), 4);
      bytes.replace((place - 1) * kPage, kPage, pageOf(child));
      child = place;
    }
    bytes.replace(begin, kPage, pageOf(child));
  }

  std::string written(const char* name, const std::vector<const char*>& statements) {
    const std::string path = files_.add(name, "");
    QFile::remove(QString::fromStdString(path));
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    for (const char* sql : statements) {
      char* why = nullptr;
      if (sqlite3_exec(database, sql, nullptr, nullptr, &why) != SQLITE_OK) {
        qFatal("%s", why);
      }
    }
    sqlite3_close(database);
    return path;
  }

  Written files_;
};

QTEST_APPLESS_MAIN(JupedsimTest)
#include "tst_Jupedsim.moc"
