#include <QtTest>

#include "HandMade.h"

using namespace metrics;
using namespace handmade;

namespace {

constexpr double kPi = base::kPi;

/// A standing robot at (6, -3), people at these places (of each sample) in a ring of 12 m.
SampledRun ringOf(const std::vector<std::vector<Vec2>>& places, const Vec2& robot = {6.0, -3.0}) {
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < places.size(); ++k) {
    samples.push_back(sampleAt(static_cast<double>(k), robot.x(), robot.y()));
    for (std::size_t id = 0; id < places[k].size(); ++id) {
      samples.back().people.push_back(
          personAt(static_cast<int>(id) + 1, places[k][id].x(), places[k][id].y(), 1.0));
    }
  }
  SampledRun run = recordingOfSamples(std::move(samples));
  run.robotId = -1;
  run.seam = {0.0, 12.0};
  return run;
}

/// Somebody on y = 0 from 0.5 m to 11.5 m, again and again.
std::vector<std::vector<Vec2>> rounds(int count) {
  std::vector<std::vector<Vec2>> places(static_cast<std::size_t>(12) *
                                        static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] = {Vec2(0.5 + static_cast<double>(k % 12), 0.0)};
  }
  return places;
}

// Turned round the robot while passing once: from 5.5 m behind to 5.5 m ahead, 3 m beside.
const double kPassage = (kPi - 2.0 * std::atan2(3.0, 5.5)) / (2.0 * kPi);

SampledRun robotAlong(const std::vector<Vec2>& places) {
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < places.size(); ++k) {
    samples.push_back(sampleAt(static_cast<double>(k), places[k].x(), places[k].y(), 1.0));
  }
  return recordingOfSamples(std::move(samples));
}

}  // namespace

/// What is summed up from one sample to the next; expected values by hand.
class StepsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void winding_overTheSeam_doesNotTurnBack() {
    QVERIFY(isNear(valueOf(ringOf(rounds(1)), "topological_complexity"), kPassage));
    QVERIFY(isNear(valueOf(ringOf(rounds(5)), "topological_complexity"), 5.0 * kPassage));
  }

  void winding_withoutSeam_countsTheWayBack() {
    SampledRun run = ringOf(rounds(1));
    run.seam = {};
    for (int k = 11; k >= 0; --k) {
      run.samples.push_back(sampleAt(23.0 - k, 6.0, -3.0));
      run.samples.back().people = {personAt(1, 0.5 + k, 0.0)};
    }
    QVERIFY(std::fabs(valueOf(run, "topological_complexity")) < 1e-9);
  }

  void winding_ofWhoComesAgain_goesOnFromThere() {
    SampledRun run = ringOf(rounds(2));
    run.seam = {};
    sim2d::Event enter;
    enter.kind = sim2d::EventKind::Enter;
    enter.id = 1;
    run.events = {{11.5, enter}};
    QVERIFY(isNear(valueOf(run, "topological_complexity"), 2.0 * kPassage));
  }

  /// Two walk beside each other, over the seam, away from the robot between their lines.
  void groupCrossings_overTheSeam_areNone() {
    std::vector<std::vector<Vec2>> places;
    for (const double x : {10.8, 11.8, 0.8, 1.8}) {
      places.push_back({Vec2(x, -1.0), Vec2(x, 1.0)});
    }
    SampledRun run = ringOf(places, {6.0, 0.0});
    for (Sample& sample : run.samples) {
      sample.people[0].group = sample.people[1].group = 1;
    }
    QCOMPARE(valueOf(run, "group_crossings"), 0.0);
    run.samples.resize(2);
    run.samples[1].robot.position.x() = 12.0;  // through them
    QCOMPARE(valueOf(run, "group_crossings"), 1.0);
  }

  void groupCrossings_ofWhoComeAgain_areNone() {
    SampledRun run = ringOf({{Vec2(10, -1), Vec2(10, 1)}, {Vec2(2, -1), Vec2(2, 1)}}, {6.0, 0.0});
    run.seam = {};
    for (Sample& sample : run.samples) {
      sample.people[0].group = sample.people[1].group = 1;
    }
    QCOMPARE(valueOf(run, "group_crossings"), 1.0);  // they walked past it
    sim2d::Event enter;
    enter.kind = sim2d::EventKind::Enter;
    enter.id = 2;
    run.events = {{0.5, enter}};
    QCOMPARE(valueOf(run, "group_crossings"), 0.0);
  }

  void roughness_ofTurns_isByTheLongestSide() {
    const double square = valueOf(robotAlong({{0, 0}, {1, 0}, {1, 1}}), "roughness_avg");
    QVERIFY(isNear(square, 1.0 / 2.0));  // twice the area 1, the longest side root 2
    const double sharp = valueOf(robotAlong({{0, 0}, {1, 0}, {0.5, 0.5}}), "roughness_avg");
    QVERIFY(isNear(sharp, 0.5 / 1.0));
    const double even =
        valueOf(robotAlong({{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}}), "roughness_avg");
    QVERIFY(isNear(even, std::sqrt(0.75)));
  }

  /// Out and back the same way, to a ten-millionth of a metre: one of three triples bends by that.
  void roughness_ofTurningBack_isBounded() {
    const double back =
        valueOf(robotAlong({{0, 0}, {1, 0}, {2, 0}, {1, 1e-7}, {0, 2e-7}}), "roughness_avg");
    QVERIFY2(std::fabs(back - 1e-7 / 3.0) < 1e-12, qPrintable(QString::number(back)));
  }
};

QTEST_APPLESS_MAIN(StepsTest)
#include "tst_Steps.moc"
