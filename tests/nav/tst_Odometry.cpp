#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <QtTest>

#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/Localization.h"

using namespace sim2d;

namespace {

constexpr int kRobots = 10000;
constexpr double kWithin = 0.06;  // four deviations of a variance of so many draws, relative

OdometryParameters noisy() {
  OdometryParameters parameters;
  parameters.alpha1 = 0.002;
  parameters.alpha2 = 0.001;
  parameters.alpha3 = 0.003;
  parameters.alpha4 = 0.004;
  return parameters;
}

/// Drives with a constant twist; returns the odometry after the last step.
Odometry driven(const OdometryParameters& parameters, int robot, const BodyTwist& twist,
                double time, int steps) {
  Pose2 truth{{2.0, -1.0}, 0.7};
  Odometry odometry(parameters, 42, robot, truth);
  for (int i = 0; i < steps; ++i) {
    truth = propagated(truth, twist, time / steps);
    odometry.advance(truth, twist, time / steps, static_cast<std::uint64_t>(i));
  }
  return odometry;
}

struct Moments {
  double mean = 0.0, variance = 0.0;
};
Moments momentsOf(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) {
    moments.mean += value / static_cast<double>(values.size());
  }
  for (const double value : values) {
    const double off = value - moments.mean;
    moments.variance += off * off / static_cast<double>(values.size());
  }
  return moments;
}

/// What each of many robots believes of one step: rot1, trans and rot2 as the book takes them from
/// two poses, and the errors of the twist.
struct BelievedSteps {
  std::vector<double> rot1, trans, rot2, linear, angular, lateral;
};
BelievedSteps believedSteps(const OdometryParameters& parameters, const BodyTwist& twist,
                            double time) {
  BelievedSteps steps;
  for (int robot = 0; robot < kRobots; ++robot) {
    const Odometry odometry = driven(parameters, robot, twist, time, 1);
    const Vec2 way = odometry.pose().position - Vec2(2.0, -1.0);
    const double direction = std::atan2(way.y(), way.x());
    steps.rot1.push_back(base::angleDiff(direction, 0.7));
    steps.trans.push_back(way.norm());
    steps.rot2.push_back(base::angleDiff(odometry.pose().heading, direction));
    steps.linear.push_back(odometry.motion().linear - twist.linear);
    steps.angular.push_back(odometry.motion().angular - twist.angular);
    steps.lateral.push_back(odometry.motion().lateral - twist.lateral);
  }
  return steps;
}

bool isAbout(double value, double expected) {
  return std::fabs(value - expected) <= kWithin * expected;
}
bool isMean(const Moments& moments, double expected) {  // five deviations
  return std::fabs(moments.mean - expected) <= 5.0 * std::sqrt(moments.variance / kRobots) + 1e-12;
}

double correlation(const std::vector<double>& one, const std::vector<double>& other) {
  const Moments first = momentsOf(one);
  const Moments second = momentsOf(other);
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    sum += (one[i] - first.mean) * (other[i] - second.mean);
  }
  return sum / static_cast<double>(one.size()) / std::sqrt(first.variance * second.variance);
}

}  // namespace

class OdometryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void advance_noErrors_isTheTruthToTheBit() {
    Pose2 truth{{0.1, 0.2}, 0.3};
    Odometry odometry({}, 1, 0, truth);
    QVERIFY(odometry.pose() == truth);
    for (std::uint64_t step = 0; step < 1000; ++step) {
      const BodyTwist twist{0.7, step % 2 == 0 ? 1.1 : -0.4, 0.13};
      truth = propagated(truth, twist, 0.05);
      odometry.advance(truth, twist, 0.05, step);
      QVERIFY(odometry.pose() == truth);
      QVERIFY(odometry.motion() == twist);
    }
  }

  /// Table 5.6 with rot1 = rot2 = 0 and trans = 1, where squares do not matter.
  void advance_oneMetre_hasTheVariancesOfTheBook() {
    const BelievedSteps steps = believedSteps(noisy(), {1.0, 0.0}, 1.0);
    QVERIFY(isAbout(momentsOf(steps.rot1).variance, 0.001));
    QVERIFY(isAbout(momentsOf(steps.rot2).variance, 0.001));
    QVERIFY(isAbout(momentsOf(steps.trans).variance, 0.003));
    QVERIFY(isMean(momentsOf(steps.rot1), 0.0));
    QVERIFY(isMean(momentsOf(steps.rot2), 0.0));
    QVERIFY(isMean(momentsOf(steps.trans), 1.0));
    QVERIFY(std::fabs(correlation(steps.rot1, steps.rot2)) < 0.04);
    QVERIFY(std::fabs(correlation(steps.rot1, steps.trans)) < 0.04);
  }

  /// Half a circle of radius 0.5: rot1 = rot2 = pi / 2, trans = 1.
  void advance_arc_hasTheVariancesOfTheFormula() {
    const double nearlyHalf = base::kPi - 1e-9;  // a turn by pi would have two signs
    const BelievedSteps steps = believedSteps(noisy(), {0.5, 1.0}, nearlyHalf);
    QVERIFY(isAbout(momentsOf(steps.rot1).variance, 0.002 * base::kPi / 2.0 + 0.001));
    QVERIFY(isAbout(momentsOf(steps.rot2).variance, 0.002 * base::kPi / 2.0 + 0.001));
    QVERIFY(isAbout(momentsOf(steps.trans).variance, 0.003 + 0.004 * base::kPi));
    QVERIFY(isMean(momentsOf(steps.rot1), base::kPi / 2.0));
    QVERIFY(isMean(momentsOf(steps.rot2), base::kPi / 2.0));
    QVERIFY(isMean(momentsOf(steps.trans), 1.0));
  }

  void advance_onTheSpot_hasTheVariancesOfTheFormula() {
    std::vector<double> turns;
    std::vector<double> squares;
    turns.reserve(kRobots);
    squares.reserve(kRobots);
    for (int robot = 0; robot < kRobots; ++robot) {
      const Odometry odometry = driven(noisy(), robot, {0.0, 1.0}, 2.0, 1);
      turns.push_back(base::angleDiff(odometry.pose().heading, 2.7));
      squares.push_back((odometry.pose().position - Vec2(2.0, -1.0)).squaredNorm());
    }
    QVERIFY(isAbout(momentsOf(turns).variance, 2.0 * 0.002));  // rot1 = rot2 = 1
    QVERIFY(isMean(momentsOf(turns), 0.0));
    QVERIFY(isAbout(momentsOf(squares).mean, 2.0 * 0.004));
  }

  void advance_backwardsAndSideways_countAsWays() {
    for (const BodyTwist& twist : {BodyTwist{-1.0, 0.0, 0.0}, BodyTwist{0.0, 0.0, 1.0}}) {
      const BelievedSteps steps = believedSteps(noisy(), twist, 1.0);
      QVERIFY(isAbout(momentsOf(steps.trans).variance, 0.003));
      std::vector<double> turns;
      turns.reserve(kRobots);
      for (int robot = 0; robot < kRobots; ++robot) {
        turns.push_back(driven(noisy(), robot, twist, 1.0, 1).pose().heading - 0.7);
      }
      QVERIFY(isAbout(momentsOf(turns).variance, 2.0 * 0.001));
    }
  }

  /// The variance of heading and length after 2 m does not depend on the length of the step.
  void advance_manySteps_giveTheVarianceOfTheWay() {
    for (const int count : {1, 40}) {
      std::vector<double> headings;
      std::vector<double> lengths;
      headings.reserve(kRobots);
      lengths.reserve(kRobots);
      OdometryParameters parameters = noisy();
      parameters.alpha2 = 1e-6;  // so that the way stays straight and its length adds up
      for (int robot = 0; robot < kRobots; ++robot) {
        const Odometry odometry = driven(parameters, robot, {1.0, 0.0}, 2.0, count);
        headings.push_back(odometry.pose().heading - 0.7);
        lengths.push_back((odometry.pose().position - Vec2(2.0, -1.0)).norm());
      }
      QVERIFY(isAbout(momentsOf(headings).variance, 2.0 * 2.0 * 1e-6));
      QVERIFY(isAbout(momentsOf(lengths).variance, 2.0 * 0.003));
    }
  }

  void advance_standing_believesTheSame() {
    Odometry odometry = driven(noisy(), 3, {1.0, 0.5}, 1.0, 20);
    const Pose2 truth = propagated({{2.0, -1.0}, 0.7}, {1.0, 0.5}, 1.0);
    odometry.advance(truth, {}, 0.05, 20);  // takes up what rounding has left of the way
    const Pose2 believed = odometry.pose();
    for (std::uint64_t step = 21; step < 100; ++step) {
      odometry.advance(truth, {}, 0.05, step);
      QVERIFY((odometry.pose().position - believed.position).norm() == 0.0);
      QVERIFY(odometry.pose().heading == believed.heading);
      QVERIFY(odometry.motion() == BodyTwist{});
    }
  }

  /// In one step of 0.5 s the believed twist is the believed motion over the time.
  void advance_twist_hasTheErrorsOfThePose() {
    const BodyTwist twist{1.2, 0.4};
    const BelievedSteps steps = believedSteps(noisy(), twist, 0.5);
    const double trans = 2.0 * 3.0 * std::sin(0.1);  // chord of radius 3 over 0.2 rad
    for (std::size_t i = 0; i < kRobots; ++i) {
      QVERIFY(std::fabs(steps.linear[i] - (steps.trans[i] - trans) / 0.5) < 1e-12);
      QVERIFY(std::fabs(steps.angular[i] - (steps.rot1[i] + steps.rot2[i] - 0.2) / 0.5) < 1e-12);
      QVERIFY(std::fabs(steps.lateral[i]) < 1e-12);
    }
    QVERIFY(isAbout(momentsOf(steps.linear).variance, (0.003 * trans + 0.004 * 0.2) / 0.25));
  }

  void advance_drift_bendsTheWay() {
    OdometryParameters parameters;
    parameters.headingDrift = 0.05;  // 0.05 rad per metre: a circle of radius 20
    const Odometry odometry = driven(parameters, 1, {1.0, 0.0}, 10.0, 20000);
    QVERIFY(std::fabs(odometry.pose().heading - 1.2) < 1e-9);
    const Pose2 circle = propagated({{2.0, -1.0}, 0.7}, {1.0, 0.05}, 10.0);
    QVERIFY((odometry.pose().position - circle.position).norm() < 1e-6);
    QVERIFY(std::fabs(odometry.motion().angular - 0.05) < 1e-9);
    QVERIFY(std::fabs(odometry.motion().linear - 1.0) < 1e-12);
  }

  void advance_driftBackAndForth_takesItBack() {
    OdometryParameters parameters;
    parameters.headingDrift = 0.1;
    const Pose2 start;
    Odometry odometry(parameters, 1, 1, start);
    const Pose2 ahead{{3.0, 0.0}, 0.0};
    odometry.advance(ahead, {3.0, 0.0}, 1.0, 0);
    QVERIFY(std::fabs(odometry.pose().heading - 0.3) < 1e-15);
    odometry.advance(start, {-3.0, 0.0}, 1.0, 1);
    QVERIFY(std::fabs(odometry.pose().heading) < 1e-15);
    QVERIFY(odometry.pose().position.norm() < 1e-14);
  }

  void advance_sameSeed_isRepeatable() {
    const BodyTwist twist{0.8, 0.3};
    const Odometry one = driven(noisy(), 5, twist, 3.0, 60);
    const Odometry again = driven(noisy(), 5, twist, 3.0, 60);
    QVERIFY(one.pose() == again.pose());
    QVERIFY(one.motion() == again.motion());
    QVERIFY(driven(noisy(), 6, twist, 3.0, 60).pose() != one.pose());
    // A copy goes on as the original does; another seed or step does not.
    Odometry original = one;
    Odometry copy = one;
    const Pose2 next{{3.0, 0.0}, 1.0};
    original.advance(next, twist, 0.05, 60);
    copy.advance(next, twist, 0.05, 60);
    QVERIFY(original.pose() == copy.pose());
    Odometry later = one;
    later.advance(next, twist, 0.05, 61);
    QVERIFY(later.pose() != copy.pose());
    Odometry first(noisy(), 1, 0, {});
    Odometry second(noisy(), 2, 0, {});
    first.advance(next, twist, 0.05, 0);
    second.advance(next, twist, 0.05, 0);
    QVERIFY(first.pose() != second.pose());
  }

  void reset_truth_forgetsTheErrors() {
    Odometry odometry = driven(noisy(), 5, {1.0, 0.2}, 3.0, 60);
    const Pose2 truth{{7.0, 8.0}, -1.0};
    odometry.reset(truth);
    QVERIFY(odometry.pose() == truth);
    QVERIFY(odometry.motion() == BodyTwist{});
    odometry.advance(truth, {}, 0.05, 61);  // the jump was no motion
    QVERIFY((odometry.pose().position - truth.position).norm() < 1e-15);
  }
};

QTEST_GUILESS_MAIN(OdometryTest)
#include "tst_Odometry.moc"
