#include <cmath>
#include <ctime>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QWindow>
#include <QtTest>

#include "editor/canvas/MapView.h"
#include "editor/canvas/RouteModel.h"
#include "editor/tools/ToolManager.h"
#include "sim2d/base/Rng.h"
#include "tests/support/WrittenMap.h"

using namespace editor;

namespace {

constexpr int kSide = 4000;           // cells
constexpr double kResolution = 0.05;  // [m]
constexpr double kMetres = kSide * kResolution;
constexpr int kFrames = 60;

/// A hall of 200 m by 200 m: outer walls and rows of shelves with aisles between them.
std::shared_ptr<const sim2d::OccupancyGrid> hall() {
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const bool isBorder = std::min(row, column) < 8 || std::max(row, column) >= kSide - 8;
      const bool isShelf =
          row % 200 >= 120 && row % 200 < 150 && column % 400 >= 80 && column % 400 < 320;
      cells[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)] =
          isBorder || isShelf ? 100 : 0;
    }
  }
  return std::make_shared<sim2d::OccupancyGrid>(kSide, kSide, kResolution, Pose2{},
                                                std::move(cells));
}

/// A place in an aisle: rows of shelves stand at 6.0 to 7.5 m of every 10 m.
Vec2 place(int number, int what) {
  const base::AgentRng rng(7, number);
  const auto draw = [&](int index) {
    return rng.uniform01(base::DrawPurpose::Test, static_cast<std::uint32_t>(2 * what + index));
  };
  const double aisle = 10.0 * std::floor(draw(0) * 19.0) + 1.0;
  return {4.0 + draw(1) * (kMetres - 8.0), aisle + 3.5 * draw(0)};
}

/// People who walk to two of twenty goals each, and obstacles, doors and areas for the rest.
sim2d::Scenario crowd(int people, int things) {
  sim2d::Scenario scenario;
  int key = 1;
  for (int i = 0; i < 20; ++i) {
    sim2d::GlobalGoal goal;
    goal.key = {EntityKind::Goal, key++};
    goal.id = i + 1;
    goal.position = place(i, 0);
    scenario.goals.push_back(goal);
  }
  for (int i = 0; i < people; ++i) {
    sim2d::Human human;
    human.key = {EntityKind::Human, key++};
    human.id = i + 1;
    human.name = "agent" + std::to_string(i + 1);
    human.initPose = {place(i, 1), 0.1 * i};
    human.behavior.type = static_cast<sim2d::BehaviorType>(i % 6 + 1);
    human.goals = {i % 20 + 1, (i * 7 + 3) % 20 + 1};
    scenario.humans.push_back(human);
  }
  for (int i = 0; i < things; ++i) {
    const Vec2 at = place(i, 2);
    const std::string name = "thing" + std::to_string(i + 1);
    if (i % 3 == 2) {
      sim2d::Area area;
      area.key = {EntityKind::Area, key++};
      area.name = name;
      area.points = {at, at + Vec2(2.0, 0.0), at + Vec2(2.0, 1.0), at + Vec2(0.0, 1.0)};
      scenario.areas.push_back(area);
    } else {
      sim2d::Obstacle obstacle;
      obstacle.key = {EntityKind::Obstacle, key++};
      obstacle.name = name;
      obstacle.kind = i % 3 == 0 ? sim2d::ObstacleKind::Box : sim2d::ObstacleKind::Circle;
      obstacle.pose = {at, 0.3 * i};
      obstacle.length = 0.6;
      obstacle.width = 0.4;
      obstacle.radius = 0.25;
      scenario.obstacles.push_back(obstacle);
    }
  }
  return scenario;
}

/// Time that the window's thread has worked [s]: what other programs take does not count.
double workedSeconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Frames of a gesture, by the clock on the wall and by the work of the window's thread.
class FrameClock {
 public:
  FrameClock() { clock_.start(); }
  void frame() {
    const double now = workedSeconds();
    worst_ = std::max(worst_, now - last_);
    last_ = now;
    ++count_;
  }
  void tell() const {
    const double rate = 1e9 * count_ / double(clock_.nsecsElapsed());
    const double mean = 1e3 * (last_ - begin_) / count_;
    qInfo("%.1f frames/s; work per frame %.2f ms (%.0f frames/s), at most %.1f ms", rate, mean,
          1e3 / mean, 1e3 * worst_);
    QTest::setBenchmarkResult(rate, QTest::FramesPerSecond);
  }

 private:
  QElapsedTimer clock_;
  double begin_ = workedSeconds(), last_ = begin_, worst_ = 0.0;
  int count_ = 0;
};

}  // namespace

/// Frames per second of the canvas, told as frames of real paint events on an offscreen window.
class CanvasBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void dragOnePerson_among500();
  void dragTwentyPeople_among500();
  void pan_2000things_data();
  void pan_2000things();
  void zoom_2000things();
  void hover_2000things();
  void open_500people();

 private:
  void show(int people, int things, double pixelsPerMetre);
  void drag(std::vector<EntityId> what);

  std::shared_ptr<const sim2d::OccupancyGrid> hall_;
  ScenarioDocument document_;
  MapScene scene_{document_, Theme::light()};
  MapView view_{scene_};
  ToolManager tools_{document_, scene_};
};

void CanvasBench::initTestCase() {
  hall_ = hall();
  view_.resize(860, 640);
  view_.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view_));
}

void CanvasBench::show(int people, int things, double pixelsPerMetre) {
  document_.load(crowd(people, things));
  document_.setMap(hall_);
  view_.fitAll(false);
  if (pixelsPerMetre > 0.0) {
    view_.setPixelsPerMetre(pixelsPerMetre);
  }
  QTest::qWait(3000);  // settled, with ways of some of the people
}

void CanvasBench::drag(std::vector<EntityId> what) {
  document_.setSelection(what);
  const Vec2 from = document_.human(what.front())->initPose.position;
  view_.centerOn(toScene(from));
  QTest::qWait(200);
  QWindow* window = view_.windowHandle();
  const auto at = [&](int frame) {
    return view_.viewport()->mapTo(&view_, view_.viewportFrom(from) + QPoint(6 + frame, frame / 2));
  };
  QTest::mousePress(window, Qt::LeftButton, {}, at(-6));
  QTest::mouseMove(window, at(0));
  QCoreApplication::processEvents();
  FrameClock clock;
  for (int frame = 0; frame < kFrames; ++frame) {
    QTest::mouseMove(window, at(frame));
    QCoreApplication::processEvents();
    view_.viewport()->repaint();
    clock.frame();
  }
  clock.tell();
  QTest::mouseRelease(window, Qt::LeftButton, {}, at(kFrames));
  QCOMPARE(document_.undoStack().count(), 1);
  document_.undoStack().clear();
}

void CanvasBench::dragOnePerson_among500() {
  show(500, 0, 6.0);
  drag({document_.entities(EntityKind::Human).front()});
}

void CanvasBench::dragTwentyPeople_among500() {
  show(500, 0, 6.0);
  const std::vector<EntityId> people = document_.entities(EntityKind::Human);
  drag({people.begin(), people.begin() + 20});
}

void CanvasBench::pan_2000things_data() {
  QTest::addColumn<double>("pixelsPerMetre");
  QTest::newRow("all in view") << 0.0;
  QTest::newRow("20 px/m") << 20.0;
  QTest::newRow("60 px/m") << 60.0;
}

void CanvasBench::pan_2000things() {
  QFETCH(double, pixelsPerMetre);
  show(1000, 1000, pixelsPerMetre);
  QWindow* window = view_.windowHandle();
  const auto at = [](int frame) { return QPoint(200 + 5 * frame, 200 + 3 * frame); };
  QTest::mousePress(window, Qt::MiddleButton, {}, at(0));
  FrameClock clock;
  for (int frame = 1; frame <= kFrames; ++frame) {
    QMouseEvent event(QEvent::MouseMove, at(frame), at(frame), Qt::NoButton, Qt::MiddleButton, {});
    QCoreApplication::sendEvent(view_.viewport(), &event);
    view_.viewport()->repaint();
    clock.frame();
  }
  clock.tell();
  QTest::mouseRelease(window, Qt::MiddleButton, {}, at(kFrames));
}

void CanvasBench::zoom_2000things() {
  show(1000, 1000, 0.0);
  FrameClock clock;
  for (int frame = 0; frame < kFrames; ++frame) {
    view_.zoomBy(frame < kFrames / 2 ? 1.06 : 1.0 / 1.06, QPointF(300.0, 250.0));
    view_.viewport()->repaint();
    clock.frame();
  }
  clock.tell();
}

void CanvasBench::hover_2000things() {
  show(1000, 1000, 0.0);
  FrameClock clock;
  const std::vector<EntityId> people = document_.entities(EntityKind::Human);
  for (int frame = 0; frame < kFrames; ++frame) {  // each time all is painted anew
    scene_.setHovered(people[static_cast<std::size_t>(frame)]);
    view_.viewport()->repaint();
    clock.frame();
  }
  clock.tell();
}

void CanvasBench::open_500people() {
  QTemporaryDir folder;
  const QString map = folder.filePath(QStringLiteral("hall.yaml"));
  QVERIFY(!base::hasErrors(sim2d::writeMap(*hall_, map.toStdString())));
  ScenarioDocument made;
  made.load(crowd(500, 0));
  QVERIFY(!base::hasErrors(made.openMap(map)));
  const QString file = folder.filePath(QStringLiteral("crowd.yaml"));
  QVERIFY(!base::hasErrors(made.save(file)));
  QElapsedTimer clock;
  clock.start();
  const double worked = workedSeconds();
  const base::Diagnostics found = document_.open(file);
  view_.viewport()->repaint();
  const double seconds = 1e-9 * double(clock.nsecsElapsed());
  QVERIFY(!base::hasErrors(found));
  qInfo("%.2f s to open and paint, %.2f s of them work", seconds, workedSeconds() - worked);
  QTest::setBenchmarkResult(1e3 * seconds, QTest::WalltimeMilliseconds);
}

QTEST_MAIN(CanvasBench)
#include "bench_Canvas.moc"
