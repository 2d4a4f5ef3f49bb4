#include <ctime>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include "app/window/MainWindow.h"
#include "editor/look/AppStyle.h"
#include "sim2d/base/Text.h"
#include "tests/support/WrittenMap.h"

using app::MainWindow;

namespace {

constexpr int kSide = 4000;  // cells
constexpr int kPeople = 500;
constexpr int kInRow = 25;

/// A hall of 200 m by 200 m with rows of shelves.
base::Diagnostics writeHall(const std::string& path) {
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const bool isBorder = std::min(row, column) < 8 || std::max(row, column) >= kSide - 8;
      const bool isShelf = row % 400 < 8 && column % 500 < 320;
      cells[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)] =
          isBorder || isShelf ? 100 : 0;
    }
  }
  return sim2d::writeMap(sim2d::OccupancyGrid(kSide, kSide, 0.05, sim2d::Pose2{}, std::move(cells)),
                         path);
}

sim2d::Scenario crowd() {
  sim2d::Scenario scenario;
  for (int i = 0; i < 10; ++i) {
    sim2d::GlobalGoal goal;
    goal.key = {base::EntityKind::Goal, i + 1};
    goal.id = i + 1;
    goal.position = {28.0 + 16.0 * i, 24.0 + 10.0 * i};
    scenario.goals.push_back(goal);
  }
  for (int i = 0; i < kPeople; ++i) {
    sim2d::Human human;
    human.key = {base::EntityKind::Human, i + 20};
    human.id = i + 1;
    human.name = "p" + std::to_string(i + 1);
    human.initPose.position = {5.0 + 7.6 * (i % kInRow), 3.0 + 9.4 * (i / kInRow)};
    human.hasInitPose = true;
    human.behavior.type = static_cast<sim2d::BehaviorType>(i % 6 + 1);
    human.goals = {i % 10 + 1, (i * 7 + 3) % 10 + 1};
    scenario.humans.push_back(human);
  }
  return scenario;
}

/// Time that all threads of the program have worked since its start [s].
double workedSeconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Notes the first picture of a widget.
class FirstPaint : public QObject {
 public:
  explicit FirstPaint(QWidget& widget) { widget.installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    isThere = isThere || event->type() == QEvent::Paint;
    return false;
  }
  bool isThere = false;
};

}  // namespace

/// From nothing to the first picture of a large scenario, as when the program is started with it.
class OpenBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void start_500peopleOn4000x4000() {
    QTemporaryDir folder;
    const QString map = folder.filePath(QStringLiteral("hall.yaml"));
    QVERIFY(!base::hasErrors(writeHall(map.toStdString())));
    const QString file = folder.filePath(QStringLiteral("hall_agents.yaml"));
    {
      editor::ScenarioDocument made;
      made.load(crowd());
      QVERIFY(!base::hasErrors(made.openMap(map)));
      QVERIFY(!base::hasErrors(made.save(file)));
    }
    QElapsedTimer clock;
    clock.start();
    const double before = workedSeconds();
    editor::applyTheme(editor::Theme::light());
    app::WindowSetup setup;
    setup.followsSystem = false;
    setup.storesSettings = false;
    MainWindow window(setup);
    window.resize(1280, 800);
    window.show();
    FirstPaint paint(*window.workspace().view().viewport());
    QVERIFY(window.open(file));
    while (!paint.isThere) {
      QCoreApplication::processEvents();
    }
    QCoreApplication::processEvents();  // the paint event has been handled
    const double seconds = 1e-9 * double(clock.nsecsElapsed());
    qInfo("%.2f s to the first picture, %.2f s of work", seconds, workedSeconds() - before);
    QTest::setBenchmarkResult(1e3 * seconds, QTest::WalltimeMilliseconds);
    QVERIFY(window.workspace().document().scenario().humans.size() == kPeople);
  }
};

QTEST_MAIN(OpenBench)
#include "bench_Open.moc"
