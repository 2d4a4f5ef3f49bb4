#include <ctime>

#include <QElapsedTimer>
#include <QScreen>
#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"

namespace {

/// Time that the window's thread has worked [s]: what other programs take does not count.
double workedSeconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// People in rows over a room of 80 m by 60 m, who walk between four goals.
sim2d::Scenario crowd(int people) {
  sim2d::Scenario scenario;
  int key = 1;
  const base::Vec2 goals[] = {{5, 5}, {75, 55}, {5, 55}, {75, 5}};
  for (int k = 0; k < 4; ++k) {
    sim2d::GlobalGoal goal;
    goal.key = {base::EntityKind::Goal, key++};
    goal.id = k + 1;
    goal.position = goals[k];
    scenario.goals.push_back(goal);
  }
  const int columns = static_cast<int>(std::ceil(std::sqrt(people * 4.0 / 3.0)));
  for (int k = 0; k < people; ++k) {
    sim2d::Human human;
    human.key = {base::EntityKind::Human, key++};
    human.id = k + 1;
    human.name = "agent" + std::to_string(k + 1);
    human.initPose = {base::Vec2(4.0 + 72.0 * (k % columns) / columns,
                                 4.0 + 52.0 * (k / columns) / (people / columns + 1)),
                      0.0};
    human.goals = {k % 4 + 1, (k + 1) % 4 + 1};
    scenario.humans.push_back(human);
  }
  scenario.desktop.duration = 600.0;
  return scenario;
}

}  // namespace

/// Overlays by a name of the table below.
void switchOn(editor::MapScene& scene, const QString& overlays) {
  editor::CanvasOptions options = scene.options();
  const bool all = overlays == QLatin1String("all");
  options.density = all || overlays == QLatin1String("density");
  options.proxemics = options.gaussian = all || overlays == QLatin1String("spaces");
  options.velocities = all || overlays == QLatin1String("velocities");
  options.forces = all || overlays == QLatin1String("forces");
  options.plans = all || overlays == QLatin1String("plans");
  options.contacts = options.thoughts = options.sight = all;
  scene.setOptions(options);
}

/// What reaches the screen while a crowd walks: pictures that differ from the one before, and what
/// a picture costs the window.
class FramesBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void crowd_walking_isSeen_data() {
    QTest::addColumn<int>("people");
    QTest::addColumn<QString>("overlays");
    for (const int people : {210, 1000, 2000}) {
      QTest::newRow(QByteArray::number(people).constData()) << people << QString();
    }
    for (const char* overlay : {"density", "spaces", "velocities", "forces", "plans", "all"}) {
      QTest::newRow(QByteArray("1000 ").append(overlay).constData())
          << 1000 << QString::fromLatin1(overlay);
    }
  }
  void crowd_walking_isSeen() {
    QFETCH(int, people);
    QFETCH(QString, overlays);
    auto window = quiet::shownWindow();
    app::Workspace& workspace = window->workspace();
    window->actions().newOpenPlane->trigger();
    workspace.document().load(crowd(people));
    workspace.document().setMap(editor::emptyRoom(80.0, 60.0));
    workspace.view().fitAll(false);
    switchOn(workspace.scene(), overlays);
    workspace.runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(
        workspace.runner().newestFrame() && workspace.runner().newestFrame()->time > 2.0, 120000);
    paints_ = 0;
    workspace.view().viewport()->installEventFilter(this);
    QElapsedTimer clock;
    clock.start();
    const double before = workedSeconds();
    double grabbing = 0.0;
    int differing = 0;
    QImage last;
    for (int seen = 0; clock.elapsed() < 4000;) {
      QTest::qWait(1);
      if (paints_ == seen) {
        continue;
      }
      seen = paints_;
      const double begin = workedSeconds();
      const QImage now = grab(workspace.view());
      differing += now != last ? 1 : 0;
      last = now;
      grabbing += workedSeconds() - begin;
    }
    const double seconds = 1e-9 * double(clock.nsecsElapsed());
    const double work = workedSeconds() - before - grabbing;
    qInfo(
        "%d people%s: %.1f different pictures/s (wanted: 50), %.1f paints/s, %.2f ms of the "
        "window each",
        people, qPrintable(overlays.isEmpty() ? overlays : QStringLiteral(", ") + overlays),
        differing / seconds, paints_ / seconds, 1e3 * work / std::max(paints_, 1));
    QTest::setBenchmarkResult(differing / seconds, QTest::FramesPerSecond);
    QVERIFY(differing > 10);  // it moves; how fast is a figure, not a verdict: machines are shared
    workspace.runner().reset();
    quiet::leave(window);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    paints_ += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }

 private:
  /// A part of the middle as the screen has it.
  static QImage grab(editor::MapView& view) {
    const QPoint middle = view.viewport()->mapTo(view.window(), view.viewport()->rect().center());
    return view.screen()
        ->grabWindow(view.window()->winId(), middle.x() - 120, middle.y() - 90, 240, 180)
        .toImage();
  }

  int paints_ = 0;
};

QTEST_MAIN(FramesBench)
#include "bench_Frames.moc"
