#include <algorithm>

#include <QBuffer>
#include <QImage>
#include <QImageReader>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Bundle.h"
#include "editor/document/MapEdit.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/map/ImageValues.h"

namespace {

const char* const kYaml =
    "image: map.png\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// `ending`: of the file's name, where it differs from the format.
int valueOf(const QImage& image, const char* rule, const char* format = "png",
            const char* ending = nullptr) {
  QTemporaryDir folder;
  QString yaml = QString::fromLatin1(kYaml);
  const QString name =
      QStringLiteral("map.") + QString::fromLatin1(ending == nullptr ? format : ending);
  yaml.replace(QStringLiteral("map.png"), name);
  QFile file(folder.filePath(QStringLiteral("map.yaml")));
  file.open(QIODevice::WriteOnly);
  file.write(yaml.toUtf8());
  file.close();
  image.save(folder.filePath(name), format);
  const auto map = app::readMapFile(file.fileName().toStdString(), rule, editor::loadMapImage);
  return map ? map->grid.valueAt({0, 0}) : -100;
}

QByteArray bigEndian(quint32 value, int bytes) {
  QByteArray text;
  for (int k = bytes - 1; k >= 0; --k) {
    text.append(static_cast<char>(value >> (8 * k) & 0xFFU));
  }
  return text;
}

/// The check of a chunk of PNG (CRC-32).
quint32 checkOf(const QByteArray& chunk) {
  quint32 crc = 0xFFFFFFFFU;
  for (const char byte : chunk) {
    crc ^= static_cast<quint8>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xEDB88320U : crc >> 1U;
    }
  }
  return ~crc;
}

/// An image of one pixel whose header declares another size.
QByteArray declaring(quint32 width, quint32 height, const char* format) {
  QImage image(1, 1, QImage::Format_Grayscale8);
  image.fill(0);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, format);
  QByteArray bytes = buffer.data();
  if (QByteArray(format) == "png") {
    const int chunk = bytes.indexOf("IHDR");
    bytes.replace(chunk + 4, 8, bigEndian(width, 4) + bigEndian(height, 4));
    bytes.replace(chunk + 17, 4, bigEndian(checkOf(bytes.mid(chunk, 17)), 4));
  } else if (QByteArray(format) == "jpg") {
    const int frame = bytes.indexOf("\xFF\xC0");
    bytes.replace(frame + 5, 4, bigEndian(height, 2) + bigEndian(width, 2));
  } else {
    QByteArray size = bigEndian(height, 4) + bigEndian(width, 4);  // of a BMP, in the other order
    std::reverse(size.begin(), size.end());
    bytes.replace(18, 8, size);
  }
  return bytes;
}

}  // namespace

/// Map images that Qt reads: pixel values as nav2 takes them.
class MapImagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void png_pixel_becomesCell_data() {
    QTest::addColumn<QColor>("color");
    QTest::addColumn<bool>("alpha");
    QTest::addColumn<int>("humble");
    QTest::addColumn<int>("main");
    QTest::newRow("white") << QColor(254, 254, 254) << false << 0 << 0;
    QTest::newRow("black") << QColor(0, 0, 0) << false << 100 << 100;
    QTest::newRow("205") << QColor(205, 205, 205) << false << -1 << -1;
    QTest::newRow("127 opaque") << QColor(127, 127, 127, 255) << true << -1 << -1;
    QTest::newRow("0 opaque") << QColor(0, 0, 0, 255) << true << 100 << 100;
    QTest::newRow("205 opaque") << QColor(205, 205, 205, 255) << true << 0 << -1;
  }
  void png_pixel_becomesCell() {
    QFETCH(QColor, color);
    QFETCH(bool, alpha);
    QFETCH(int, humble);
    QFETCH(int, main);
    QImage image(1, 1, alpha ? QImage::Format_ARGB32 : QImage::Format_RGB32);
    image.setPixelColor(0, 0, color);
    QCOMPARE(valueOf(image, "humble"), humble);
    QCOMPARE(valueOf(image, "main"), main);
  }

  void otherFormats_sameCells() {
    QImage grey(2, 2, QImage::Format_Grayscale8);
    grey.fill(0);
    QCOMPARE(valueOf(grey, "humble"), 100);
    QCOMPARE(valueOf(grey, "humble", "bmp"), 100);
    QImage deep(2, 2, QImage::Format_Grayscale16);
    deep.fill(Qt::white);
    QCOMPARE(valueOf(deep, "humble"), 0);
    QImage palette(2, 2, QImage::Format_Indexed8);
    palette.setColorTable({qRgb(254, 254, 254), qRgb(0, 0, 0)});
    palette.fill(1);
    QCOMPARE(valueOf(palette, "humble"), 100);
  }

  /// Such files occur on robots: the content decides, not the name.
  void otherName_isReadByItsContent() {
    QImage grey(2, 2, QImage::Format_Grayscale8);
    grey.fill(0);
    for (const char* const format : {"png", "jpg", "bmp", "ppm", "pbm"}) {
      for (const char* const ending : {"pgm", "PGM", "png", "jpeg", "map"}) {
        QVERIFY2(valueOf(grey, "humble", format, ending) == 100, format);
      }
    }
    QCOMPARE(valueOf(grey, "humble", "pgm", "png"), 100);
  }

  /// Qt does not read them here: the formats that work are named.
  void tiffAndWebp_nameWhatWorks_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("format");
    QTest::newRow("tiff little") << QByteArray("II*\0\x08\0\0\0", 8) << QStringLiteral("TIFF");
    QTest::newRow("tiff big") << QByteArray("MM\0*\0\0\0\x08", 8) << QStringLiteral("TIFF");
    QTest::newRow("webp") << QByteArray("RIFF\x1A\0\0\0WEBPVP8L", 16) << QStringLiteral("WebP");
  }
  void tiffAndWebp_nameWhatWorks() {
    QFETCH(QByteArray, content);
    QFETCH(QString, format);
    if (QImageReader::supportedImageFormats().contains(format.toLower().toLatin1())) {
      QSKIP("Qt reads them here");
    }
    QTemporaryDir folder;
    for (const char* const name : {"map.pgm", "map.png", "map.tif"}) {
      QString yaml = QString::fromLatin1(kYaml);
      yaml.replace(QStringLiteral("map.png"), QString::fromLatin1(name));
      const auto write = [&](const QString& file, const QByteArray& bytes) {
        QFile to(folder.filePath(file));
        return to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size();
      };
      QVERIFY(write(QStringLiteral("map.yaml"), yaml.toUtf8()));
      QVERIFY(write(QString::fromLatin1(name), content));
      const auto map = app::readMapFile(folder.filePath(QStringLiteral("map.yaml")).toStdString(),
                                        "humble", editor::loadMapImage);
      QVERIFY(!map);
      const std::string text = map.diagnostics().front().text();
      const std::string wanted =
          format.toStdString() + " images cannot be read: save it as one of PGM, PNG";
      QVERIFY2(text.find(wanted) != std::string::npos, text.c_str());
    }
  }

  /// Before any pixel is read.
  void tooManyPixels_areRefusedByTheHeader_data() {
    QTest::addColumn<QByteArray>("format");
    for (const char* const format : {"png", "jpg", "bmp"}) {
      QTest::newRow(format) << QByteArray(format);
    }
  }
  void tooManyPixels_areRefusedByTheHeader() {
    QFETCH(QByteArray, format);
    QTemporaryDir folder;
    QString yaml = QString::fromLatin1(kYaml);
    const auto messageOf = [&](quint32 width, quint32 height) {
      const auto write = [&](const QString& name, const QByteArray& bytes) {
        QFile to(folder.filePath(name));
        return to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size();
      };
      const bool isWritten = write(QStringLiteral("map.yaml"), yaml.toUtf8()) &&
                             write(QStringLiteral("map.png"), declaring(width, height, format));
      const auto map = app::readMapFile(folder.filePath(QStringLiteral("map.yaml")).toStdString(),
                                        "humble", editor::loadMapImage);
      return isWritten && !map ? QString::fromStdString(map.diagnostics().front().message)
                               : QString();
    };
    const QString told = messageOf(12000, 10000);
    QVERIFY2(
        told.endsWith(QStringLiteral("map.png': the image of 12000 x 10000 pixels is too large "
                                     "(at most 100000000 pixels; scale it down)")),
        qPrintable(told));
    QCOMPARE(messageOf(1, 1), QString());
  }

  /// A colour image takes four values per pixel, a grey one a quarter of that; rows stay in order.
  void loadMapImage_rows_areInOrder() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rows.png"));
    for (const auto format : {QImage::Format_RGB32, QImage::Format_Grayscale8}) {
      QImage image(3, 4, format);
      for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
          const int shade = 10 + 20 * row + column;
          if (format == QImage::Format_Grayscale8) {
            image.scanLine(row)[column] = static_cast<uchar>(shade);
          } else {
            image.setPixel(column, row, qRgb(shade, 7, 200));
          }
        }
      }
      QVERIFY(image.save(path));
      const auto read = editor::loadMapImage(path.toStdString());
      QVERIFY(read);
      const std::size_t step = read->isGrey ? 1 : 4;
      QCOMPARE(read->isGrey, format == QImage::Format_Grayscale8);
      const std::vector<std::uint16_t> values = sim2d::valuesOf(*read);
      QCOMPARE(values.size(), 12 * step);
      for (std::size_t i = 0; i < 12; ++i) {
        const int value = values[step * i];
        QCOMPARE(value, static_cast<int>(10 + 20 * (i / 3) + i % 3));
      }
    }
  }

  void isaacWarehouse_countsAndFreePoints() {
    const QString root =
        qEnvironmentVariable("HUNAV_INTEROP_DIR", QStringLiteral(SOURCE_DIR "/../shared/interop")) +
        QStringLiteral("/hunavsim2/isaac/");
    if (!QDir(root).exists()) {
      QSKIP("the files of the original are not here (HUNAV_INTEROP_DIR)");
    }
    const auto map = app::readMapFile((root + QStringLiteral("maps/warehouse.yaml")).toStdString(),
                                      "humble", editor::loadMapImage);
    QVERIFY(map);
    int free = 0, occupied = 0, unknown = 0;
    for (const std::int8_t value : map->grid.cells()) {
      free += value == 0 ? 1 : 0;
      occupied += value == 100 ? 1 : 0;
      unknown += value == -1 ? 1 : 0;
    }
    QCOMPARE(free, 218058);
    QCOMPARE(occupied, 21386);
    QCOMPARE(unknown, 760556);
    const sim2d::ScenarioReading reading = sim2d::readScenario(
        (root + QStringLiteral("scenarios/warehouse_agents.yaml")).toStdString());
    QVERIFY(reading.ok());
    int points = 0;
    const auto expectFree = [&](const sim2d::Vec2& point) {
      QCOMPARE(static_cast<int>(map->grid.valueAt(map->grid.worldToCell(point))), 0);
      ++points;
    };
    for (const sim2d::Human& human : reading.scenario.humans) {
      expectFree(human.initPose.position);
      for (const int id : human.goals) {
        expectFree(reading.scenario.goal(id)->position);
      }
    }
    QCOMPARE(points, 34);
  }

  void noImage_clearError() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("text.png"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("no image at all");
    file.close();
    const auto image = editor::loadMapImage(path.toStdString());
    QVERIFY(!image);
    QVERIFY(image.diagnostics()[0].message.find("cannot read the image") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(MapImagesTest)
#include "tst_MapImages.moc"
