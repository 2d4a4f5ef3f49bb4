#include <cmath>
#include <functional>

#include <QtTest>

#include "HandMade.h"
#include "metrics/RobotMotion.h"

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

using Speed = std::function<double(double)>;

/// A robot along x whose speed is sampled every `dt` for so many seconds.
SampledRun driven(const Speed& speed, double dt, double duration) {
  std::vector<Sample> samples;
  const int last = static_cast<int>(std::lround(duration / dt));
  for (int k = 0; k <= last; ++k) {
    samples.push_back(sampleAt(k * dt, 0.0, 0.0, speed(k * dt)));
  }
  return recordingOfSamples(std::move(samples));
}

/// From rest with 1 m/s² to 0.6 m/s, on, and to rest with 2 m/s²; its edges lie on no sample.
double trapezoid(double t) {
  const double up = std::clamp(t - 0.513, 0.0, 0.6);
  return std::max(std::min(up, 0.6 - 2.0 * (t - 3.271)), 0.0);
}

double shaken(double t) {
  return 0.5 + 0.1 * std::sin(6.0 * t);
}

/// Zero and first spherical Bessel functions make the second one.
double secondBessel(double x) {
  return (3.0 / (x * x) - 1.0) * std::sin(x) / x - 3.0 * std::cos(x) / (x * x);
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
    run.events = {{11.5, eventOf(EventKind::Enter, 1)}};
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
    run.events = {{0.5, eventOf(EventKind::Enter, 2)}};
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

  // Jerks of known speeds; expected values by integrals done by hand.

  /// The jerk of a speed c t²/2 is c, whatever the window and the steps.
  void parabola_hasItsOwn() {
    for (const double dt : {0.01, 0.1, 0.25, 0.4}) {
      const SampledRun run = driven([](double t) { return 0.5 * 0.8 * t * t; }, dt, 4.0);
      // Linear between the samples: off by (dt / half window)² at most.
      QVERIFY(std::fabs(valueOf(run, "max_jerk") - 0.8) < (dt < 0.3 ? 0.8 * dt * dt / 0.06 : 1e-9));
    }
    const SampledRun fine = driven([](double t) { return 0.5 * 0.8 * t * t; }, 0.005, 4.0);
    QVERIFY(std::fabs(valueOf(fine, "max_jerk") - 0.8) < 1e-3);
    QVERIFY(std::fabs(valueOf(fine, "avg_overacceleration") - 0.8) < 1e-3);
  }
  void evenAcceleration_hasNone() {
    const SampledRun run = driven([](double t) { return 0.3 + 0.7 * t; }, 0.05, 2.0);
    QVERIFY(valueOf(run, "max_jerk") < 1e-9);
  }
  /// 15 A / (16 H) where the acceleration steps by A: here 1 and 2 m/s², H = 0.375 s, at a sample.
  void stepOfTheAcceleration_isThatOfTheWindow() {
    const SampledRun one = driven([](double t) { return std::max(t - 1.0, 0.0); }, 0.05, 2.0);
    QVERIFY(std::fabs(valueOf(one, "max_jerk") - 2.5) < 1e-9);
    MetricParameters wide;
    wide.jerkWindow = 1.0;
    QVERIFY(std::fabs(valueOf(one, "max_jerk", wide) - 1.875) < 1e-9);
  }
  /// For a sine: the amplitude times 15 j(ωH) / H², j being the second spherical Bessel function.
  void sine_isDampedByTheWindow() {
    const double expected = 0.1 * 15.0 * secondBessel(6.0 * 0.375) / 0.140625;
    const double found = valueOf(driven(shaken, 0.002, 6.0), "max_jerk");
    QVERIFY2(std::fabs(found - expected) < 1e-3 * expected, qPrintable(QString::number(found)));
  }
  void halfTheStep_changesLittle_data() {
    QTest::addColumn<double>("dt");
    for (const double dt : {0.08, 0.05, 0.04, 1.0 / 30.0, 0.02}) {
      QTest::addRow("%g s", dt) << dt;
    }
  }
  void halfTheStep_changesLittle() {
    QFETCH(double, dt);
    for (const Speed& speed : {Speed(trapezoid), Speed(shaken)}) {
      for (const char* key : {"max_jerk", "avg_overacceleration"}) {
        const double whole = valueOf(driven(speed, dt, 5.0), key);
        const double half = valueOf(driven(speed, dt / 2.0, 5.0), key);
        const double quarter = valueOf(driven(speed, dt / 4.0, 5.0), key);
        const QString told = QStringLiteral("%1: %2 %3 %4")
                                 .arg(QLatin1String(key))
                                 .arg(whole)
                                 .arg(half)
                                 .arg(quarter);
        QVERIFY2(std::fabs(half - whole) <= 0.05 * std::max(half, whole), qPrintable(told));
        QVERIFY2(std::fabs(quarter - half) <= 0.05 * std::max(half, quarter), qPrintable(told));
      }
    }
  }
  /// A jump of the speed, as a contact makes it: 1.4434 / H² at most, not 1 / dt².
  void stepOfTheSpeed_isBounded() {
    for (const double dt : {0.05, 0.025, 0.0125}) {
      const double largest =
          valueOf(driven([](double t) { return t < 1.01 ? 1.0 : 0.0; }, dt, 2.0), "max_jerk");
      QVERIFY(largest < 1.4434 / 0.140625 && largest > 0.9 * 1.4434 / 0.140625);
    }
  }
  /// Slower than the window: second differences, 1 m/s² over 0.5 s and over 1 s.
  void coarseSamples_haveSecondDifferences() {
    const Speed kink = [](double t) { return std::max(t - 1.0, 0.0); };
    QVERIFY(isNear(valueOf(driven(kink, 0.5, 4.0), "max_jerk"), 2.0));
    QVERIFY(isNear(valueOf(driven(kink, 1.0, 4.0), "max_jerk"), 1.0));
  }
  void shortRecord_hasNone() {
    QVERIFY(std::isnan(valueOf(driven(shaken, 0.05, 0.7), "max_jerk")));
    QVERIFY(std::isnan(valueOf(driven(shaken, 0.5, 0.5), "max_jerk")));
    QVERIFY(!std::isnan(valueOf(driven(shaken, 0.05, 0.8), "max_jerk")));
  }
  void series_hasEachAtTheNextSample() {
    const SampledRun run = driven([](double t) { return std::max(t - 1.0, 0.0); }, 0.125, 2.0);
    const auto made = evaluate(run, Selection(), {});
    const std::vector<double>& jerks = made->find("avg_overacceleration")->value.series->values;
    QCOMPARE(jerks.size(), run.samples.size());
    QVERIFY(std::fabs(jerks[9] - 2.5) < 1e-9);  // of the sample at 1 s, number 8
    QCOMPARE(jerks[0], 0.0);
    QCOMPARE(jerks.back(), 0.0);
  }
  void originalProfile_dividesByTheStep() {
    MetricParameters original;
    original.profile = Profile::Hunav2;
    const SampledRun run = driven([](double t) { return std::max(t - 1.0, 0.0); }, 0.05, 2.0);
    QVERIFY(std::fabs(valueOf(run, "max_jerk", original) - 20.0) < 1e-6);
    QVERIFY(std::fabs(valueOf(run, "avg_overacceleration", original) - 20.0 * 20.0 / 41.0) < 1e-6);
  }
};

QTEST_APPLESS_MAIN(StepsTest)
#include "tst_Steps.moc"
