#include <algorithm>
#include <clocale>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/map/MapReader.h"
#include "tests/map/WrittenFiles.h"
#include "tests/support/Columns.h"
#include "tests/support/Interop.h"
#include "tests/support/WrittenMap.h"

using namespace sim2d;
using written::contains;
using written::textOf;

namespace {

const char* const kGoodYaml =
    "image: map.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

MapImage pixel(std::uint16_t r, std::uint16_t g, std::uint16_t b, std::uint16_t a, bool hasAlpha) {
  MapImage image;
  image.width = image.height = 1;
  image.hasAlpha = hasAlpha;
  image.setValues<std::uint16_t>({r, g, b, a});
  return image;
}

}  // namespace

Q_DECLARE_METATYPE(sim2d::MapMode)
Q_DECLARE_METATYPE(sim2d::MapRule)

class MapReaderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() { files_ = std::make_unique<written::Files>(); }

  void gridFromImage_pixels_data() {
    addColumns<QVector<int>, bool, double, MapMode, bool, int, int>(
        {"rgba", "alpha", "free", "mode", "negate", "humble", "main"});
    using V = QVector<int>;
    const auto grey = [](int v) { return V{v, v, v, 255}; };
    const MapMode trinary = MapMode::Trinary;
    const MapMode scale = MapMode::Scale;
    QTest::newRow("254") << grey(254) << false << 0.196 << trinary << false << 0 << 0;
    QTest::newRow("0") << grey(0) << false << 0.25 << trinary << false << 100 << 100;
    QTest::newRow("205 ros") << grey(205) << false << 0.196 << trinary << false << -1 << -1;
    QTest::newRow("205 gazebo") << grey(205) << false << 0.25 << trinary << false << 0 << 0;
    QTest::newRow("127 opaque") << grey(127) << true << 0.196 << trinary << false << -1 << -1;
    QTest::newRow("0 opaque") << grey(0) << true << 0.196 << trinary << false << 100 << 100;
    QTest::newRow("205 opaque") << grey(205) << true << 0.196 << trinary << false << 0 << -1;
    // p = 1 - 3 * 200 / 4 / 255 = 0.412; without the alpha it would be 0.216
    QTest::newRow("200 clear") << V{200, 200, 200, 0} << true << 0.25 << trinary << false << -1
                               << -1;
    QTest::newRow("255 clear") << V{255, 255, 255, 0} << true << 0.26 << trinary << false << 0
                               << -1;
    QTest::newRow("negate 0") << grey(0) << false << 0.196 << trinary << true << 0 << 0;
    QTest::newRow("negate 254") << grey(254) << false << 0.196 << trinary << true << 100 << 100;
    QTest::newRow("red") << V{255, 0, 0, 255} << false << 0.196 << trinary << false << 100 << 100;
    // mean 1/3: p = 0.667 > 0.65; luma of green 0.587: p = 0.413
    QTest::newRow("green") << V{0, 255, 0, 255} << false << 0.196 << trinary << false << 100 << -1;
    QTest::newRow("scale clear") << V{0, 0, 0, 254} << true << 0.196 << scale << false << -1 << -1;
    QTest::newRow("scale black") << grey(0) << true << 0.196 << scale << false << 100 << 100;
    QTest::newRow("scale white") << grey(255) << true << 0.196 << scale << false << 0 << 0;
    // p = 1 - 127/255 = 0.50196; (p - 0.196) / 0.454 * 100 = 67.39
    QTest::newRow("scale 127") << grey(127) << true << 0.196 << scale << false << 67 << 67;
    // p = 0.2: (0.2 - 0.175) / 0.475 * 100 = 5.263
    QTest::newRow("scale 204") << grey(204) << false << 0.175 << scale << false << 5 << 5;
    QTest::newRow("raw 100") << grey(100) << false << 0.196 << MapMode::Raw << false << 100 << 100;
    QTest::newRow("raw 101") << grey(101) << false << 0.196 << MapMode::Raw << true << -1 << -1;
    QTest::newRow("raw 7") << grey(7) << true << 0.196 << MapMode::Raw << true << 7 << 7;
  }

  void gridFromImage_pixels() {
    QFETCH(const QVector<int>, rgba);
    QFETCH(const bool, alpha);
    QFETCH(const double, free);
    QFETCH(const MapMode, mode);
    QFETCH(const bool, negate);
    QFETCH(const int, humble);
    QFETCH(const int, main);
    const auto channel = [&](int i) { return static_cast<std::uint16_t>(rgba[i]); };
    const MapImage image = pixel(channel(0), channel(1), channel(2), channel(3), alpha);
    MapDescription description;
    description.freeThreshold = free;
    description.mode = mode;
    description.negate = negate;
    QCOMPARE(int{gridFromImage(image, description, MapRule::Humble).valueAt({0, 0})}, humble);
    QCOMPARE(int{gridFromImage(image, description, MapRule::Main).valueAt({0, 0})}, main);
  }

  void gridFromImage_firstRow_isTop() {
    MapImage image;
    image.width = 2;
    image.height = 2;
    image.setValues<std::uint16_t>({0, 0, 0, 255, 255, 255, 255, 255,          // top: wall, free
                                    255, 255, 255, 255, 255, 255, 255, 255});  // bottom: free
    const OccupancyGrid grid = gridFromImage(image, {}, MapRule::Humble);
    QVERIFY(grid.isWall({0, 1}));
    QVERIFY(!grid.isWall({0, 0}));
    QVERIFY(!grid.isWall({1, 1}));
  }

  void parseMapDescription_good_readsAll() {
    const auto result = parseMapDescription(
        "image: \"a b.png\"\nresolution: 5e-2\norigin: [-1, .5, 1.0e0]\nnegate: True\n"
        "occupied_thresh: 1\nfree_thresh: 0\nmode: SCALE\n",
        "m.yaml");
    QVERIFY2(result, textOf(result.diagnostics()).c_str());
    QCOMPARE(QString::fromStdString(result->image), QStringLiteral("a b.png"));
    QCOMPARE(result->resolution, 0.05);
    QCOMPARE(result->origin.position.y(), 0.5);
    QCOMPARE(result->origin.heading, 1.0);
    QVERIFY(result->negate);
    QCOMPARE(result->occupiedThreshold, 1.0);
    QCOMPARE(result->freeThreshold, 0.0);
    QVERIFY(result->mode == MapMode::Scale);
    const auto plain = parseMapDescription(kGoodYaml, "m.yaml");
    QVERIFY(plain && plain.diagnostics().empty());
    QVERIFY(plain->mode == MapMode::Trinary && !plain->negate);
  }

  void parseMapDescription_bad_tellsPlace_data() {
    addColumns<QByteArray, QByteArray, QByteArray>({"from", "to", "message"});
    const auto row = [](const char* name, const char* from, const char* to, const char* message) {
      QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QByteArray(message);
    };
    row("no image", "image: map.pgm\n", "", "m.yaml: error: key 'image' is missing");
    row("no resolution", "resolution: 0.05\n", "", "key 'resolution' is missing");
    row("no origin", "origin: [-1.5, 2, 0]\n", "", "key 'origin' is missing");
    row("no negate", "negate: 0\n", "", "key 'negate' is missing");
    row("no occupied", "occupied_thresh: 0.65\n", "", "key 'occupied_thresh' is missing");
    row("no free", "free_thresh: 0.196\n", "", "key 'free_thresh' is missing");
    row("empty image", "map.pgm", "''", "m.yaml:1:8: error: image must name a file");
    row("image list", "map.pgm", "[a]", "m.yaml:1:8: error: image must name");
    row("two numbers", "-1.5, 2, 0", "-1.5, 2",
        "m.yaml:3:9: error: origin must be a list of three");
    row("four numbers", "-1.5, 2, 0", "1, 2, 3, 4", "m.yaml:3:9: error: origin must be a list");
    row("origin word", "2, 0]", "two, 0]", "m.yaml:3:16: error: origin must be a finite number");
    row("origin inf", "2, 0]", ".inf, 0]", "m.yaml:3:16: error: origin must be a finite number");
    row("resolution zero", "0.05", "0", "m.yaml:2:13: error: resolution must be above 0");
    row("resolution huge", "0.05", "1e8", "m.yaml:2:13: error: resolution must be 0.001 to 10 m");
    row("resolution tiny", "0.05", "1e-9", "m.yaml:2:13: error: resolution must be 0.001 to 10 m");
    row("origin far", "[-1.5, 2, 0]", "[-1e300, 2, 0]", "origin must lie within 1e6 m");
    row("resolution below", "0.05", "-0.05", "m.yaml:2:13: error: resolution must be above 0");
    row("resolution nan", "0.05", ".nan", "m.yaml:2:13: error: resolution must be a finite number");
    row("resolution junk", "0.05", "0.05m", "resolution must be a finite number, not '0.05m'");
    row("resolution comma", "0.05", "0,05", "resolution must be a finite number, not '0,05'");
    for (const char* const word : {"-nan", ".nan", "nan", "-.nan", "-.NaN", "-nan(ind)", "NaN",
                                   "1.#QNAN", "-1.#IND", "+inf"}) {
      const std::string message = "m.yaml:3:19: error: origin must be a finite number, not '" +
                                  std::string(word) + "' (write 0)";
      QTest::newRow((std::string("yaw ") + word).c_str())
          << QByteArray("2, 0]") << "2, " + QByteArray(word) + "]" << QByteArray(message.c_str());
    }
    row("all of the origin", "-1.5, 2, 0", "nan, 2, -nan", "m.yaml:3:18: error: origin must be");
    row("resolution -inf", "0.05", "-inf", "not '-inf' (write the metres per pixel");
    row("resolution 1e999", "0.05", "1e999", "not '1e999' (write the metres per pixel");
    row("occupied nan", "0.65", "-nan",
        "occupied_thresh must be a finite number, not '-nan' (write");
    row("free nan", "0.196", "nan", "m.yaml:6:14: error: free_thresh must be a finite number");
    row("thresholds swapped", "0.196", "0.7", "m.yaml:6:14: error: thresholds must be");
    row("thresholds equal", "0.196", "0.65", "not 0.65 and 0.65");
    row("threshold below", "0.196", "-0.1", "thresholds must be");
    row("threshold above", "0.65", "1.01", "thresholds must be");
    row("negate word", "negate: 0", "negate: maybe", "m.yaml:4:9: error: negate must be");
    row("mode", "negate: 0", "mode: tri\nnegate: 0", "m.yaml:4:7: error: mode must be trinary");
    row("no yaml", "image: map.pgm", "image: [", "not valid YAML");
    row("tab", "image: map.pgm", "a:\n\tb: 1", "not valid YAML");
  }

  void parseMapDescription_bad_tellsPlace() {
    QFETCH(const QByteArray, from);
    QFETCH(const QByteArray, to);
    QFETCH(const QByteArray, message);
    const std::string text = replaced(kGoodYaml, from.toStdString(), to.toStdString());
    const auto result = parseMapDescription(text, "m.yaml");
    QVERIFY(!result);
    QVERIFY2(contains(result.diagnostics(), message.toStdString()),
             textOf(result.diagnostics()).c_str());
  }

  void parseMapDescription_manyErrors_tellsAll() {
    const auto result = parseMapDescription("resolution: x\norigin: 3\nmode: y\n", "m.yaml");
    QVERIFY(!result);
    QCOMPARE(result.diagnostics().size(), std::size_t{7});  // 4 missing, 3 wrong
    for (const char* text : {"", "- 1\n", "word\n", "# only a comment\n"}) {
      const auto other = parseMapDescription(text, "m.yaml");
      QVERIFY(!other);
      QVERIFY(contains(other.diagnostics(), "keys and values"));
    }
  }

  /// map_server reads with yaml-cpp, which finds the first of two keys.
  void parseMapDescription_repeatedKey_firstCounts() {
    const std::string text = replaced(kGoodYaml, "negate: 0", "resolution: 0.1\nnegate: 0");
    const auto result = parseMapDescription(text, "m.yaml");
    QVERIFY2(result, textOf(result.diagnostics()).c_str());
    QCOMPARE(result->resolution, 0.05);
    QVERIFY2(
        contains(result.diagnostics(),
                 "m.yaml:4:1: warning: key 'resolution' is repeated: the value of line 2 is used, "
                 "not that of line 4"),
        textOf(result.diagnostics()).c_str());
  }

  void parseMapDescription_unknownKey_warns() {
    const auto result = parseMapDescription(std::string(kGoodYaml) + "moode: raw\n", "m.yaml");
    QVERIFY(result);
    QVERIFY(contains(result.diagnostics(),
                     "m.yaml:7:1: warning: unknown key 'moode' (did you mean 'mode'?)"));
  }

  void parseMapDescription_yaw_warns() {
    const auto result = parseMapDescription(replaced(kGoodYaml, "2, 0]", "2, 0.5]"), "m.yaml");
    QVERIFY(result);
    QCOMPARE(result->origin.heading, 0.5);
    QVERIFY(contains(result.diagnostics(), "m.yaml:3:19: warning:"));
  }

  void readMap_onePixel_works() {
    write("map.pgm", "P2 1 1 1 0");
    const auto map = readMap(write("m.yaml", kGoodYaml), nullptr);
    QVERIFY2(map, textOf(map.diagnostics()).c_str());
    QCOMPARE(map->grid.width(), 1);
    QVERIFY(map->grid.isWall({0, 0}));
    QCOMPARE(map->grid.origin().position.x(), -1.5);
    QVERIFY(map.diagnostics().empty());
  }

  void readMap_home_isExpanded() {
    write("map.pgm", "P2 1 1 1 0");
    write("m.yaml", kGoodYaml);
    const QByteArray home = qgetenv("HOME");
    qputenv("HOME", files_->folder().toLocal8Bit());
    const auto map = readMap("~/m.yaml", nullptr);
    qputenv("HOME", home);
    QVERIFY2(map, textOf(map.diagnostics()).c_str());
  }

  void readMap_imageTroubles_nameTheKey_data() {
    addColumns<QByteArray, QByteArray>({"image", "message"});
    QTest::newRow("missing") << QByteArray("none.pgm") << QByteArray("does not exist");
    QTest::newRow("folder") << QByteArray(".") << QByteArray("not a file");
    QTest::newRow("empty") << QByteArray("empty.png") << QByteArray("is empty");
    QTest::newRow("no loader") << QByteArray("a.png") << QByteArray("only PGM");
    for (const char* const name : {"pointer.pgm", "pointer.png", "pointer.tiff"}) {
      QTest::newRow(name) << QByteArray(name)
                          << QByteArray(
                                 "the file is a Git LFS pointer: fetch its content with git "
                                 "lfs pull");
    }
    QTest::newRow("truncated") << QByteArray("short.pgm") << QByteArray("is truncated");
  }

  void readMap_imageTroubles_nameTheKey() {
    QFETCH(const QByteArray, image);
    QFETCH(const QByteArray, message);
    write("empty.png", "");
    write("a.png", "\x89PNG");
    for (const char* const name : {"pointer.pgm", "pointer.png", "pointer.tiff"}) {
      write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 4096\n");
    }
    write("short.pgm", "P5 9 9 255\nA");
    const std::string yaml = replaced(kGoodYaml, "map.pgm", image.toStdString());
    const auto map = readMap(write("m.yaml", QByteArray::fromStdString(yaml)), nullptr);
    QVERIFY(!map);
    QVERIFY2(contains(map.diagnostics(), "m.yaml:1:8: error: image '"),
             textOf(map.diagnostics()).c_str());
    QVERIFY2(contains(map.diagnostics(), message.toStdString()), textOf(map.diagnostics()).c_str());
  }

  void readMap_yamlAndImageTroubles_comeTogether() {
    const auto map = readMap(write("m.yaml",
                                   "image: none.pgm\nresolution: 0\norigin: [0, 0, 0]\nnegate: 0\n"
                                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n"),
                             nullptr);
    QVERIFY(!map);
    QCOMPARE(map.diagnostics().size(), std::size_t{2});
  }

  void readMap_missingOrFolder_isError() {
    QVERIFY(!readMap(files_->folder().toStdString() + "/none.yaml", nullptr));
    QVERIFY(!readMap(files_->folder().toStdString(), nullptr));
    QVERIFY(!readMap("", nullptr));
    QVERIFY(!readMap(write("m.yaml", ""), nullptr));
  }

  void readMap_loader_isUsed() {
    write("a.png", "x");
    const std::string yaml =
        write("m.yaml", QByteArray::fromStdString(replaced(kGoodYaml, "map.pgm", "a.png")));
    const auto good = readMap(yaml, [](const std::string&) -> base::Result<MapImage> {
      return pixel(0, 0, 0, 255, true);
    });
    QVERIFY(good && good->grid.isWall({0, 0}));
    const auto bad = readMap(yaml, [](const std::string& path) -> base::Result<MapImage> {
      return base::error("run.failed", {"no picture"}, path);
    });
    QVERIFY(!bad && contains(bad.diagnostics(), "m.yaml:1:8: error: image"));
    QVERIFY(contains(bad.diagnostics(), "no picture"));
    const auto empty =
        readMap(yaml, [](const std::string&) -> base::Result<MapImage> { return MapImage(); });
    QVERIFY(!empty);
  }

  void writeMap_roundTrip_isEqual() {
    const OccupancyGrid grid(3, 2, 0.1, {{-0.3, 7.0}, 0.25}, {0, 100, -1, -1, 0, 100});
    const std::string path = files_->path("sub/my map.yaml").toStdString();
    QVERIFY(writeMap(grid, path).empty());
    const auto map = readMap(path, nullptr);
    QVERIFY2(map, textOf(map.diagnostics()).c_str());
    QVERIFY(map->grid == grid);
    QCOMPARE(QString::fromStdString(map->description.image), QStringLiteral("my map.pgm"));
    const std::string odd = files_->path("sub/two\nlines \"and\" quotes\\.yaml").toStdString();
    QVERIFY(writeMap(grid, odd).empty());
    const auto oddMap = readMap(odd, nullptr);
    QVERIFY2(oddMap, textOf(oddMap.diagnostics()).c_str());
    QVERIFY(oddMap->grid == grid);
  }

  void writeMap_troubles_areTold() {
    const OccupancyGrid grid(1, 1, 0.1, {}, {0});
    QVERIFY(!writeMap(OccupancyGrid(), files_->path("a.yaml").toStdString()).empty());
    QVERIFY(base::hasErrors(writeMap(grid, "/proc/none/a.yaml")));
  }

  void readMap_shippedMaps_countCells_data() {
    addColumns<QString, int, int>({"file", "free", "occupied"});
    const auto row = [](const char* name, int free, int occupied) {
      QTest::newRow(name) << QString::fromUtf8(name) << free << occupied;
    };
    row("own/maps/yard.yaml", 1064, 136);
    row("gazebo_classic/maps/cafe.yaml", 87994, 3102);
    row("gazebo_classic/maps/house.yaml", 79462, 3788);
    row("gazebo_classic/maps/warehouse.yaml", 111434, 5746);
    row("hunav_sim_v1/maps/map_cafe2.yaml", 87994, 3102);
    row("hunav_sim_v1/maps/small_house.yaml", 79462, 3788);
    row("hunav_sim_v1/maps/small_warehouse.yaml", 111434, 5746);
    row("hunav_sim_v1/maps/bookstore.yaml", 86542, 4562);
  }

  void readMap_shippedMaps_countCells() {
    QFETCH(const QString, file);
    QFETCH(const int, free);
    QFETCH(const int, occupied);
    const QString path = interopFile(QStringLiteral("hunavsim2/") + file);
    if (path.isEmpty()) {
      QSKIP("maps of HuNavSim are not here (set HUNAV_INTEROP_DIR)");
    }
    const auto map = readMap(path.toStdString(), nullptr);
    QVERIFY2(map, textOf(map.diagnostics()).c_str());
    const auto& cells = map->grid.cells();
    QCOMPARE(static_cast<int>(std::count(cells.begin(), cells.end(), std::int8_t{0})), free);
    QCOMPARE(static_cast<int>(std::count(cells.begin(), cells.end(), std::int8_t{100})), occupied);
    QCOMPARE(static_cast<int>(cells.size()), free + occupied);
  }

  void readMap_shippedMap_withoutImage() {
    const auto map = readMap(TEST_DATA_DIR "/interop/hunavsim2/own/maps/bare.yaml", nullptr);
    QVERIFY(!map);
    QVERIFY(contains(map.diagnostics(), "bare.yaml:1:8: error: image '"));
  }

 private:
  std::string write(const char* name, const QByteArray& content) const {
    return files_->write(name, content);
  }

  std::unique_ptr<written::Files> files_;  // of each test its own
};

QTEST_APPLESS_MAIN(MapReaderTest)
#include "tst_MapReader.moc"
