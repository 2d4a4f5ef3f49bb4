#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "app/window/Workspace.h"

/// A run of 10 minutes with 100 people, jumped about in: from the order to the picture of the map,
/// wall time. Limit: 50 ms per jump.
class ScrubBench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void jump_data();
  void jump();
};

namespace {

constexpr int kPeople = 100;
constexpr std::int64_t kSteps = 12000;  // of 0.05 s

editor::RecordingPtr longRun() {
  auto recording = std::make_shared<sim2d::Recording>();
  sim2d::TraceHeader header;
  header.dt = 0.05;
  for (int id = 1; id <= kPeople; ++id) {
    sim2d::TraceHuman human;
    human.id = id;
    human.name = "P" + std::to_string(id);
    header.humans.push_back(human);
  }
  recording->setHeader(header);
  for (std::int64_t step = 0; step <= kSteps; ++step) {
    sim2d::Frame frame;
    frame.step = step;
    frame.time = 0.05 * static_cast<double>(step);
    for (int id = 1; id <= kPeople; ++id) {
      const double phase = 0.02 * static_cast<double>(step) + id;
      const base::Vec2 middle(2.0 * (id % 10), 2.0 * (id / 10));
      const base::Vec2 at = middle + base::Vec2(std::cos(phase), std::sin(phase));
      frame.humans.add(id, {at, base::wrapToPi(phase)}, {0.4, 0.1}, 0.2, sim2d::kNoGoal);
      frame.humans.group.push_back(-1);
      frame.humans.state.push_back(0);
    }
    recording->addState(frame);
    if (step % 600 == 300) {
      recording->addEvent(step, {sim2d::EventKind::Contact, 1, true, 2, true, {}});
    }
  }
  return recording;
}

}  // namespace

void ScrubBench::jump_data() {
  QTest::addColumn<double>("trails");  // [s]
  QTest::addColumn<bool>("onion");
  QTest::newRow("as it is at first") << 6.0 << false;
  QTest::newRow("with onion skin") << 6.0 << true;
  QTest::newRow("trails of 60 s") << 60.0 << false;
}

void ScrubBench::jump() {
  QFETCH(double, trails);
  QFETCH(bool, onion);
  static const editor::RecordingPtr run = longRun();
  app::Workspace workspace(editor::Theme::light());
  workspace.openRecorded(run, QStringLiteral("run"));
  editor::CanvasOptions options = workspace.scene().options();
  options.trailSeconds = trails;
  workspace.scene().setOptions(options);
  workspace.scrub().onionSkin->setChecked(onion);
  editor::MapView& view = workspace.view();
  view.resize(960, 640);
  view.setSceneRect(QRectF(-2.0, -22.0, 26.0, 26.0));
  view.show();
  std::mt19937 draw(3);
  std::vector<double> times;  // [ms]
  const auto one = [&] {
    QElapsedTimer clock;
    clock.start();
    workspace.runner().seek(static_cast<std::int64_t>(draw() % kSteps));
    view.viewport()->repaint();
    times.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
  };
  one();
  times.clear();
  QBENCHMARK {
    one();
  }
  for (int k = 0; k < 100; ++k) {
    one();
  }
  std::sort(times.begin(), times.end());
  qInfo("jump: median %.1f ms, 99 %% %.1f ms", times[times.size() / 2],
        times[times.size() * 99 / 100]);
}

QTEST_MAIN(ScrubBench)
#include "bench_Scrub.moc"
