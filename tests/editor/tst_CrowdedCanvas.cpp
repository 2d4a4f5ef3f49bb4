#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/RouteModel.h"
#include "editor/document/EditCommands.h"

using namespace editor;

namespace {

/// People in rows all over the small room, none on the wall at x = 6.
sim2d::Scenario crowd() {
  sim2d::Scenario scenario = small::scenario();
  scenario.humans.clear();
  for (int i = 0; i < 240; ++i) {
    const double x = 0.7 + 0.45 * (i % 24);
    const int row = i / 24;
    const Vec2 at(x > 5.6 ? x + 0.6 : x, 0.7 + 0.8 * row);
    scenario.humans.push_back(small::person(100 + i, ("p" + std::to_string(i)).c_str(), at, 0.1 * i,
                                            sim2d::BehaviorType::Threatening, {1 + i % 3}));
    scenario.humans.back().radius = 0.15;
  }
  return scenario;
}

int differingPixels(const QImage& a, const QImage& b, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      const QColor left = a.pixelColor(x, y);
      const QColor right = b.pixelColor(x, y);
      const int apart = std::abs(left.red() - right.red()) +
                        std::abs(left.green() - right.green()) +
                        std::abs(left.blue() - right.blue());
      count += apart > 40 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

/// The canvas with so many things that it keeps a picture of what rests.
class CrowdedCanvasTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start(crowd());
    QVERIFY(scene_.isCrowded());
    scene_.routes().finish();
    QTest::qWait(200);  // the view has settled
  }

  void picture_atRest_equalsPlainPainting() {
    QCOMPARE(differingPixels(shot(), plain(), aboveTheScaleBar()), 0);
  }

  void picture_afterEveryKindOfChange_isNew() {
    const auto changes = [this](const std::function<void()>& change) {
      const QImage before = shot();
      change();
      scene_.routes().finish();
      return differingPixels(before, shot(), before.rect());
    };
    QVERIFY(changes([&] { pushMove(document_, {person(130)}, Vec2(0.0, 0.3)); }) > 20);
    QVERIFY(changes([&] { undo(); }) > 20);
    QVERIFY(changes([&] { document_.setSelection({person(130)}); }) > 20);
    QVERIFY(changes([&] { scene_.setHovered(person(140)); }) > 5);
    QVERIFY(changes([&] { scene_.setFaded({person(150)}); }) > 20);
    QVERIFY(changes([&] { scene_.setTheme(Theme::dark()); }) > 1000);
    scene_.setTheme(Theme::light());
    scene_.setFaded({});
    CanvasOptions options;
    options.routes = false;
    QVERIFY(changes([&] { scene_.setOptions(options); }) > 200);
    QVERIFY(changes([&] { pushRemove(document_, {person(150)}); }) > 20);
    QVERIFY(changes([&] { document_.setMap(std::make_shared<sim2d::OccupancyGrid>()); }) > 1000);
  }

  void picture_whileDragging_showsWhoMoves() {
    document_.setSelection({});
    const EntityId who = person(100 + 24 + 4);
    const Vec2 from = document_.human(who)->initPose.position;
    const Vec2 to(6.0, 0.9);  // on the wall, where nobody stands
    QVERIFY(!isOfPerson(shot(), to + Vec2(0.0, 0.05)));
    press(from);
    move(from + Vec2(0.3, 0.2));
    move(to);
    QCOMPARE(scene_.movingIds().size(), std::size_t{1});
    const QImage during = shot();
    bool seen = false;
    for (int i = 0; i <= 30; ++i) {
      seen = seen || isOfPerson(during, Pose2{to, 0.2 * i}.ahead(0.09));
    }
    QVERIFY(seen);
    key(Qt::Key_Escape);
    release(to);
    QVERIFY(scene_.movingIds().empty());
    QVERIFY(document_.human(who)->initPose.position == from);
  }

  void picture_afterZooming_settlesSharp() {
    shot();
    view_.zoomBy(1.2, QPointF(300.0, 200.0));
    shot();
    QTest::qWait(300);
    QCOMPARE(differingPixels(shot(), plain(), aboveTheScaleBar()), 0);
  }

  void layers_switchedOff_areNeitherPaintedNorHit() {
    const Vec2 at = document_.human(person(130))->initPose.position;
    QVERIFY(scene_.entityAt(at) == person(130));
    CanvasOptions options;
    options.people = options.goals = options.obstacles = options.areas = options.robots = false;
    options.routes = options.map = options.grid = false;
    scene_.setOptions(options);
    QVERIFY(!scene_.entityAt(at));
    const QImage image = shot();
    QSet<QRgb> colors;
    for (int x = 0; x < image.width(); x += 2) {
      for (int y = 0; y < image.height() - 60; y += 2) {
        colors.insert(image.pixel(x, y));
      }
    }
    QCOMPARE(colors.size(), 1);
  }

  /// While editing the picture was painted past Qt's own painting; a run must be seen all the same.
  void run_ofManyPeople_isPainted() {
    view_.viewport()->repaint();
    document_.setSelection({person(130)});  // asks for painting
    QCoreApplication::processEvents();
    struct Paints : QObject {
      int count = 0;
      bool eventFilter(QObject*, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
      }
    } paints;
    view_.viewport()->installEventFilter(&paints);
    QImage before = shot();
    for (int step = 1; step <= 3; ++step) {
      sim2d::Frame frame;
      frame.step = step;
      frame.time = 0.05 * step;
      for (const sim2d::Human& human : scenario().humans) {
        frame.humans.add(human.id, {human.initPose.position + Vec2(0.05 * step, 0.0), 0.0},
                         Vec2(1.0, 0.0), 0.0, sim2d::kNoGoal);
        frame.humans.group.push_back(-1);
        frame.humans.state.push_back(0);
      }
      paints.count = 0;
      scene_.showFrame(std::make_shared<const sim2d::Frame>(frame));
      QTRY_VERIFY(paints.count > 0);  // nobody has asked the window itself
      const QImage after = shot();
      QVERIFY(differingPixels(before, after, aboveTheScaleBar()) > 500);
      // Names of what rests keep their places while people walk over them.
      const QImage both = plain({CanvasPart::Resting, CanvasPart::Moving});
      QCOMPARE(differingPixels(after, both, aboveTheScaleBar()), 0);
      const Vec2 walked(0.05 * step, 0.0);
      QVERIFY(isOfPerson(after, scenario().humans[50].initPose.position + walked + Vec2(0.0, 0.1)));
      before = after;
    }
    scene_.showFrame(nullptr);
  }

 private:
  QImage shot() { return view_.viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32); }
  QRect aboveTheScaleBar() { return view_.viewport()->rect().adjusted(0, 0, 0, -50); }
  /// Painted without a picture of what rests.
  QImage plain(const std::vector<CanvasPart>& parts = {CanvasPart::All}) {
    QImage image(view_.viewport()->size(), QImage::Format_RGB32);
    image.fill(scene_.groundColor());
    QPainter painter(&image);
    painter.setRenderHints(view_.renderHints());
    painter.setTransform(view_.viewportTransform());
    for (const CanvasPart part : parts) {
      scene_.paintPart(painter, part, view_.mapToScene(view_.viewport()->rect()).boundingRect());
    }
    return image;
  }
  bool isOfPerson(const QImage& image, const Vec2& world) {
    const QColor pixel = image.pixelColor(view_.viewportFrom(world));
    const QColor fill = scene_.theme().fill(Look::Threatening);
    return std::abs(pixel.hslHue() - fill.hslHue()) < 15 && pixel.hslSaturation() > 90;
  }
};
QTEST_MAIN(CrowdedCanvasTest)
#include "tst_CrowdedCanvas.moc"
