#include <QtTest>

#include "sim2d/map/MapReader.h"
#include "tests/map/ImageValues.h"
#include "tests/map/WrittenFiles.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using written::contains;
using written::textOf;

/// Reading of PGM images, plain and raw.
namespace {

MapImage asMapImage(const MapImage& grey) {
  MapImage image;
  image.width = grey.width;
  image.height = grey.height;
  image.maximum = grey.maximum;
  std::vector<std::uint16_t> rgba;
  for (const std::uint16_t shade : valuesOf(grey)) {
    rgba.insert(rgba.end(), {shade, shade, shade, static_cast<std::uint16_t>(grey.maximum)});
  }
  image.setValues(std::move(rgba));
  return image;
}

}  // namespace

class PgmFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() { files_ = std::make_unique<written::Files>(); }

  void readPgm_formats_data() {
    addColumns<QByteArray, int, QVector<int>>({"content", "maximum", "shades"});
    using V = QVector<int>;
    QTest::newRow("P5") << QByteArray("P5\n2 1\n255\n\xfe\x0a", 13) << 255 << V{254, 10};
    QTest::newRow("P5 raster begins with #") << QByteArray("P5 2 1 255\n##") << 255 << V{35, 35};
    QTest::newRow("P5 comments") << QByteArray("P5 # made\n# by hand\n2 # w\n1\n255\nAB") << 255
                                 << V{65, 66};
    QTest::newRow("P5 maximum 3") << QByteArray("P5\n2 1\n3\n\x03\x01", 11) << 3 << V{3, 1};
    QTest::newRow("P5 16 bit") << QByteArray("P5\n2 1\n65535\n\x01\x02\x00\xff", 17) << 65535
                               << V{258, 255};
    QTest::newRow("P2") << QByteArray("P2\n2 1\n255\n7  255") << 255 << V{7, 255};
    QTest::newRow("P2 comments") << QByteArray("P2#a\n2 1#b\n1000#c\n#d\n1000\n#e\n500\n") << 1000
                                 << V{1000, 500};
    QTest::newRow("P2 CRLF") << QByteArray("P2\r\n2 1\r\n15\r\n0 15\r\n") << 15 << V{0, 15};
    QTest::newRow("more behind") << QByteArray("P5 2 1 255\nABCDEF") << 255 << V{65, 66};
  }

  void readPgm_formats() {
    QFETCH(const QByteArray, content);
    QFETCH(const int, maximum);
    QFETCH(const QVector<int>, shades);
    const auto image = readPgm(write("a.pgm", content));
    QVERIFY2(image, textOf(image.diagnostics()).c_str());
    QCOMPARE(image->width, 2);
    QCOMPARE(image->height, 1);
    QCOMPARE(image->maximum, maximum);
    QVERIFY(image->isGrey);
    const std::vector<std::uint16_t> values = valuesOf(*image);
    QCOMPARE(QVector<int>(values.begin(), values.end()), shades);
  }

  void readPgm_bad_isError_data() {
    addColumns<QByteArray, QByteArray>({"content", "message"});
    const auto row = [](const char* name, const QByteArray& content, const char* message) {
      QTest::newRow(name) << content << QByteArray(message);
    };
    row("empty", "", "is empty");
    row("PPM", "P6\n1 1\n255\nabc", "not a PGM");
    row("one byte", "P", "not a PGM");
    row("no header", "P5\n", "header");
    row("words", "P5\nwide 1\n255\nA", "header");
    row("negative", "P5\n-1 1\n255\nA", "header");
    row("no width", "P5\n0 1\n255\n", "no pixels");
    row("maximum 0", "P5\n1 1\n0\nA", "maximum");
    row("maximum 65536", "P5\n1 1\n65536\nAA", "maximum");
    row("truncated", "P5\n3 2\n255\nABCDE", "need 6 bytes, found 5");
    row("truncated 16 bit", "P5\n1 1\n256\nA", "need 2 bytes, found 1");
    row("truncated P2", "P2\n2 2\n255\n1 2 333", "pixel 4 of 4");
    row("word in P2", "P2\n2 1\n255\n1 x1 ", "pixel 2 of 2");
    row("huge", "P5\n20000 20000\n255\nA",
        "20000 x 20000 pixels is too large (at most 100000000 pixels");
    row("very huge", "P5\n99999999999 99999999999\n255\nA", "too large");
    row("large but not there", "P5\n10000 10000\n255\nA", "need 100000000 bytes");
    row("one row too many", "P5\n10000 10001\n255\nA", "10000 x 10001 pixels is too large");
  }

  void readPgm_bad_isError() {
    QFETCH(const QByteArray, content);
    QFETCH(const QByteArray, message);
    const auto image = readPgm(write("a.pgm", content));
    QVERIFY(!image);
    QVERIFY2(contains(image.diagnostics(), message.toStdString()),
             textOf(image.diagnostics()).c_str());
  }

  void readPgm_valueAboveMaximum_warns() {
    const auto image = readPgm(write("a.pgm", "P2 1 1 15 16"));
    QVERIFY(image);
    QCOMPARE(int{valuesOf(*image)[0]}, 15);
    QCOMPARE(image.diagnostics().size(), std::size_t{1});
  }

  void gridFromPgm_everyShade_isAsOfTheImage() {
    QByteArray content("P5\n32 8\n255\n");
    for (int shade = 0; shade < 256; ++shade) {
      content.append(static_cast<char>(shade));
    }
    const std::string path = write("all.pgm", content);
    const auto shades = readPgm(path);
    QVERIFY(shades);
    const MapImage image = asMapImage(*shades);
    for (const MapMode mode : {MapMode::Trinary, MapMode::Scale, MapMode::Raw}) {
      for (const MapRule rule : {MapRule::Humble, MapRule::Main}) {
        for (const bool negate : {false, true}) {
          MapDescription description;
          description.mode = mode;
          description.negate = negate;
          QVERIFY(gridFromImage(*shades, description, rule) ==
                  gridFromImage(image, description, rule));
        }
      }
    }
  }

 private:
  std::string write(const char* name, const QByteArray& content) const {
    return files_->write(name, content);
  }

  std::unique_ptr<written::Files> files_;  // of each test its own
};

QTEST_APPLESS_MAIN(PgmFilesTest)
#include "tst_PgmFiles.moc"
