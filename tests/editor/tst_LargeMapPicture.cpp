#include <QImage>
#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <QtTest>

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"

using namespace editor;

namespace {

constexpr int kSide = 4000;  // cells: 64 tiles
constexpr double kResolution = 0.05;

/// Values that repeat nowhere near.
std::shared_ptr<const sim2d::OccupancyGrid> patterned() {
  std::vector<std::int8_t> cells(std::size_t{kSide} * kSide);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const int cell = row * kSide + column;
      const int value = (7 * column + 13 * row + column * row / 64) % 102 - 1;
      cells[static_cast<std::size_t>(cell)] = static_cast<std::int8_t>(value);
    }
  }
  return std::make_shared<const sim2d::OccupancyGrid>(kSide, kSide, kResolution, Pose2{},
                                                      std::move(cells));
}

MapItem& mapItemOf(const MapScene& scene) {
  for (QGraphicsItem* item : scene.items()) {
    if (auto* map = dynamic_cast<MapItem*>(item)) {
      return *map;
    }
  }
  qFatal("no map in the scene");
}

/// What the item paints of a rectangle of pixels of the whole map, `scale` pixels per cell.
QImage paintedPart(MapItem& item, const QRect& part, double scale) {
  QImage image(part.size(), QImage::Format_RGB32);
  image.fill(Qt::magenta);
  QPainter painter(&image);
  const double perMetre = scale / kResolution;
  const QPointF topLeft = toScene({0.0, kSide * kResolution});
  painter.translate(-part.topLeft());
  painter.scale(perMetre, perMetre);
  painter.translate(-topLeft);
  QStyleOptionGraphicsItem option;
  option.exposedRect = painter.worldTransform().inverted().mapRect(QRectF(image.rect()));
  item.paint(&painter, &option, nullptr);
  return image;
}

}  // namespace

/// A map that is painted in tiles looks as if it were one picture and takes little memory.
class LargeMapPictureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { document_.setMap(patterned()); }

  void paint_acrossTiles_isEachCellsColour() {
    const QImage whole = mapImage(*document_.map(), scene_.theme());
    MapItem& item = mapItemOf(scene_);
    const QRect part(412, 1440, 300, 200);  // over the corner of four tiles
    QCOMPARE(paintedPart(item, part, 1.0), whole.copy(part));
    const QImage near = paintedPart(item, QRect(2 * 500, 2 * 1000, 60, 100), 2.0);
    QCOMPARE(near, whole.copy(500, 1000, 30, 50).scaled(60, 100));
    const QRect end(kSide - 90, kSide - 50, 90, 50);
    QCOMPARE(paintedPart(item, end, 1.0), whole.copy(end));
  }

  /// Looked at everywhere, near and far: half of what one picture of all cells would take.
  void bytes_lookedAtEverywhere_areBounded() {
    MapItem& item = mapItemOf(scene_);
    QCOMPARE(item.bytes(), qint64{0});
    for (int round = 0; round < 2; ++round) {
      for (int top = 0; top + 500 <= kSide; top += 500) {
        for (int left = 0; left + 500 <= kSide; left += 500) {
          paintedPart(item, QRect(left, top, 500, 500), 1.0);
          paintedPart(item, QRect(left / 8, top / 8, 60, 60), 0.125);
        }
      }
    }
    QVERIFY(item.bytes() > 0);
    QVERIFY2(item.bytes() <= qint64{36} * 512 * 512 * 4, qPrintable(QString::number(item.bytes())));
  }

  void paint_farAway_showsTheWhole() {
    const QImage far = paintedPart(mapItemOf(scene_), QRect(0, 0, kSide / 16, kSide / 16), 0.0625);
    for (const QPoint& corner : {far.rect().topLeft(), far.rect().bottomRight()}) {
      QVERIFY(far.pixelColor(corner) != QColor(Qt::magenta));
    }
  }

 private:
  ScenarioDocument document_;
  MapScene scene_{document_, Theme::light()};
};

QTEST_MAIN(LargeMapPictureTest)
#include "tst_LargeMapPicture.moc"
