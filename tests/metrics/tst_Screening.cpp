#include <random>

#include <QtTest>

#include "metrics/Samples.h"
#include "sim2d/map/Outlines.h"

using base::Vec2;
using metrics::Sample;
using metrics::SampleBuilder;

/// Who is screened from the robot: by what is drawn and by closed doors, not by walls of the map.
class ScreeningTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void screened_isWhatDrawnObstaclesHide();
};

namespace {

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

sim2d::Outline boxAt(std::mt19937& random) {
  const base::Pose2 pose{{between(random, 0.0, 12.0), between(random, 0.0, 12.0)},
                         between(random, -3.0, 3.0)};
  return sim2d::boxOutline(pose, between(random, 0.1, 1.5), between(random, 0.1, 1.5));
}

std::vector<sim2d::Outline> boxes(std::mt19937& random, int count) {
  std::vector<sim2d::Outline> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    all.push_back(boxAt(random));
  }
  return all;
}

}  // namespace

void ScreeningTest::screened_isWhatDrawnObstaclesHide() {
  std::mt19937 random(7);
  sim2d::TraceHeader header;
  header.robots.push_back({});
  header.humans.push_back({});
  header.humans.back().id = 1;
  header.obstacles.push_back({"map", false, false, {}, boxes(random, 8)});
  header.obstacles.push_back({"shelves", false, false, {}, boxes(random, 6)});
  header.obstacles.push_back({"door", true, true, {10.0}, boxes(random, 3)});  // closes at 10 s
  SampleBuilder builder(header);
  int screened = 0;
  int behindMapAlone = 0;
  for (int k = 0; k < 2000; ++k) {
    sim2d::Obstacles drawn;
    drawn.add(header.obstacles[1].outlines);
    drawn.add(header.obstacles[2].outlines, k >= 1000);
    drawn.build();
    sim2d::Obstacles map;
    map.add(header.obstacles[0].outlines);
    map.build();
    const Vec2 robot(between(random, 0.0, 12.0), between(random, 0.0, 12.0));
    const Vec2 person(between(random, 0.0, 12.0), between(random, 0.0, 12.0));
    sim2d::Frame frame;
    frame.time = k < 1000 ? 5.0 : 15.0;
    frame.robots.add(-1, {robot, 0.0}, Vec2::Zero(), 0.0, sim2d::kNoGoal);
    frame.humans.add(1, {person, 0.0}, Vec2::Zero(), 0.0, sim2d::kNoGoal);
    frame.humans.group.push_back(-1);
    frame.humans.state.push_back(0);
    const Sample sample = builder.sampleOf(frame);
    const bool isHidden = !drawn.isVisible(person, robot);
    QCOMPARE(sample.people.at(0).screened, isHidden);
    screened += isHidden ? 1 : 0;
    behindMapAlone += !isHidden && !map.isVisible(person, robot) ? 1 : 0;
  }
  QVERIFY(screened > 200 && behindMapAlone > 200);
}

QTEST_APPLESS_MAIN(ScreeningTest)
#include "tst_Screening.moc"
