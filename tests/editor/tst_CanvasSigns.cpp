#include "CanvasTester.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/ViewOverlays.h"
#include "editor/document/PeopleEdits.h"
#include "editor/look/FigurePainter.h"

using namespace editor;

namespace {

constexpr sim2d::AreaKind kKinds[] = {sim2d::AreaKind::Source, sim2d::AreaKind::Sink,
                                      sim2d::AreaKind::Wait, sim2d::AreaKind::Exit,
                                      sim2d::AreaKind::Speed};

sim2d::Area areaOf(sim2d::AreaKind kind) {
  sim2d::Area area;
  area.key = {base::EntityKind::Area, 90};
  area.name = "place";
  area.kind = kind;
  area.points = {{1.0, 1.0}, {4.0, 1.0}, {4.0, 3.0}, {1.0, 3.0}};
  return area;
}

sim2d::Scenario scenarioWithGroup() {
  sim2d::Scenario scenario = small::scenario();
  scenario.humans[0].groupId = 3;
  scenario.humans[2].groupId = 3;
  return scenario;
}

/// A document and its canvas.
struct Canvas {
  explicit Canvas(sim2d::Scenario scenario) { document.load(std::move(scenario)); }

  ScenarioDocument document;
  MapScene scene{document, Theme::light()};
};

QImage picture(MapScene& scene) {
  constexpr double kPixelsPerMetre = 50.0;
  scene.setPixelsPerMetre(kPixelsPerMetre);
  QImage image(600, 450, QImage::Format_RGB32);
  image.fill(scene.groundColor());
  QPainter painter(&image);
  painter.setTransform(QTransform::fromScale(kPixelsPerMetre, kPixelsPerMetre).translate(0.0, 9.0));
  scene.paintPart(painter, CanvasPart::All, QRectF(0.0, -9.0, 12.0, 9.0));
  return image;
}

QPoint pixelOf(const Vec2& world) {
  return {static_cast<int>(50.0 * world.x()), static_cast<int>(50.0 * (9.0 - world.y()))};
}

/// How many pixels near a place are of nearly that colour.
int countNear(const QImage& image, const Vec2& world, const QColor& color) {
  int count = 0;
  const QPoint centre = pixelOf(world);
  for (int y = centre.y() - 24; y <= centre.y() + 24; ++y) {
    for (int x = centre.x() - 24; x <= centre.x() + 24; ++x) {
      const QColor here = image.pixelColor(x, y);
      const int off = std::abs(here.red() - color.red()) + std::abs(here.green() - color.green()) +
                      std::abs(here.blue() - color.blue());
      count += off < 40 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

class CanvasSignsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void area_eachKind_hasASignOfItsOwn() {
    std::vector<QImage> pictures;
    for (const sim2d::AreaKind kind : kKinds) {
      sim2d::Scenario scenario;
      scenario.areas = {areaOf(kind)};
      Canvas canvas(scenario);
      CanvasOptions options;
      options.names = false;  // the names say the kind as well
      canvas.scene.setOptions(options);
      pictures.push_back(picture(canvas.scene));
    }
    for (std::size_t a = 0; a < pictures.size(); ++a) {
      for (std::size_t b = a + 1; b < pictures.size(); ++b) {
        QVERIFY(pictures[a] != pictures[b]);
      }
    }
  }

  void sign_eachKind_fillsItsSquare() {
    for (const sim2d::AreaKind kind : kKinds) {
      const QRectF box = areaGlyph(kind).boundingRect();
      QVERIFY(QRectF(-8.0, -8.0, 16.0, 16.0).contains(box));
      QVERIFY(std::max(box.width(), box.height()) > 11.0);
      QVERIFY(!areaIcon(kind, Theme::dark()).isNull());
    }
  }

  void group_itsPeople_haveRingsInItsColor() {
    Canvas canvas(scenarioWithGroup());
    auto& [document, scene] = canvas;
    const QColor color = groupColor(3, scene.theme());
    const QImage with = picture(scene);
    for (const int person : {0, 2}) {
      const Vec2 at = document.scenario().humans[std::size_t(person)].initPose.position;
      QVERIFY(countNear(with, at, color) > 60);
    }
    QVERIFY(countNear(with, document.scenario().humans[1].initPose.position, color) < 10);
    CanvasOptions options = scene.options();
    options.groups = false;
    scene.setOptions(options);
    const QImage without = picture(scene);
    QVERIFY(countNear(without, document.scenario().humans[0].initPose.position, color) < 10);
  }

  void group_personIsDragged_ringFollows() {
    Canvas canvas(scenarioWithGroup());
    auto& [document, scene] = canvas;
    sim2d::Human moved = document.scenario().humans[0];
    moved.initPose.position = {2.0, 4.6};
    scene.setPreview({Entity(moved)});
    const QColor color = groupColor(3, scene.theme());
    const QImage image = picture(scene);
    QVERIFY(countNear(image, {2.0, 4.6}, color) > 60);
    QVERIFY(countNear(image, {2.0, 2.0}, color) < 20);
  }

  void groupColors_allReadableOnTheMap() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      for (int group = 0; group < 40; ++group) {
        QVERIFY(contrastRatio(groupColor(group, theme), theme.color(Role::MapFree)) >= 3.0);
      }
    }
  }

  void legend_coversNobody() {
    sim2d::Scenario scenario = scenarioWithGroup();
    scenario.humans[1].initPose.position = {11.0, 0.6};  // lower right
    const Canvas canvas(scenario);
    const MapScene& scene = canvas.scene;
    const QTransform view = QTransform::fromScale(50.0, 50.0).translate(0.0, 9.0);
    const QRectF box = groupLegendBox({scene, QRectF(0.0, 0.0, 600.0, 450.0), view, 50.0});
    QVERIFY(!box.isEmpty());
    QVERIFY(QRectF(0.0, 0.0, 600.0, 450.0).contains(box));
    for (const sim2d::Human& human : scenario.humans) {
      QVERIFY(!box.contains(view.map(toScene(human.initPose.position))));
    }
  }

  void legend_cornerIsFreeAgain_staysWhereItIs() {
    const Canvas canvas(scenarioWithGroup());
    const MapScene& scene = canvas.scene;
    const QTransform nobodyHere = QTransform::fromTranslate(-5000.0, 0.0);
    const QRectF window(0.0, 0.0, 600.0, 450.0);
    const QRectF lower = groupLegendBox({scene, window, nobodyHere, 50.0});
    const QRectF upper = groupLegendBox({scene, window, nobodyHere, 50.0, 1});
    QVERIFY(lower.top() > window.center().y());
    QVERIFY(upper.bottom() < window.center().y());
    QImage image(window.size().toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    QCOMPARE(paintGroupLegend(painter, {scene, window, nobodyHere, 50.0, 1}), 1);
  }

  void legend_withoutGroups_isNone() {
    const Canvas canvas(small::scenario());
    QVERIFY(groupLegendBox({canvas.scene, QRectF(0.0, 0.0, 600.0, 450.0), QTransform(), 50.0})
                .isEmpty());
  }

  void lines_onADenseScreen_areAsWideAsElsewhere() {
    for (const int ratio : {1, 2}) {
      QImage image(QSize(100, 100) * ratio, QImage::Format_RGB32);
      image.setDevicePixelRatio(ratio);
      image.fill(Qt::white);
      QPainter painter(&image);
      painter.scale(25.0, 25.0);  // points per metre
      painter.setPen(cosmetic(QPen(Qt::black, 3.0, Qt::SolidLine, Qt::FlatCap), painter));
      painter.drawLine(QPointF(0.0, 2.02), QPointF(4.0, 2.02));
      painter.end();
      int dark = 0;
      for (int y = 0; y < image.height(); ++y) {
        dark += qGray(image.pixel(image.width() / 2, y)) < 128 ? 1 : 0;
      }
      QCOMPARE(dark, 3 * ratio);
    }
  }

  void links_ofPointsInARow_joinNeighbours() {
    const auto links = minimumSpanningTree({{0.0, 0.0}, {3.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}});
    QCOMPARE(links.size(), std::size_t(3));
    double length = 0.0;
    const double xs[] = {0.0, 3.0, 1.0, 2.0};
    for (const auto& [from, to] : links) {
      length += std::abs(xs[from] - xs[to]);
    }
    QCOMPARE(length, 3.0);
    QVERIFY(minimumSpanningTree({{1.0, 1.0}}).empty());
    QVERIFY(minimumSpanningTree({}).empty());
  }
};

QTEST_MAIN(CanvasSignsTest)
#include "tst_CanvasSigns.moc"
