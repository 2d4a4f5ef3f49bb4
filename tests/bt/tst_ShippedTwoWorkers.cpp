#include <cmath>
#include <optional>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "tests/bt/ShippedScenario.h"

using namespace shipped;

namespace {

constexpr double kStep = 0.05;  // [s]
constexpr double kTiny = 1e-9;
constexpr std::size_t kFirst = 0;   // row of worker 1
constexpr std::size_t kSecond = 1;  // row of worker 2
const Vec2 kFirstRack(-4.5, -3.0);
const Vec2 kLastRack(-7.56, 8.76);
const Vec2 kMeeting(-2.35, 5.1);
const Vec2 kTalk(-6.0, 5.6);
const Vec2 kExit(-2.48, -14.95);

const char* const kStepsOfFirst =
    "GoToFirstRack, LookAtRobot, Wonder, GoToSecondRack, LookAtSecondRack, CheckSecondRack, "
    "GoToThirdRack, LookAtThirdRack, CheckThirdRack, GoToLastRack, LookAtLastRack, CheckLastRack, "
    "LookAtWorker2, ListenToWorker2, heard Follow me, FollowWorker2";
const char* const kStepsOfSecond =
    "GoToFirstRack, LookAtFirstRack, LookAtRobot, ApproachRobot, GoToSecondRack, "
    "LookAtSecondRack, GoToThirdRack, LookAtThirdRack, LookAtWorker1, IsWorker1Looking, Talk, "
    "say Follow me, GoToExit";

/// Of the steps from the first time on and before the second.
std::vector<double> timesOf(double from, double until) {
  std::vector<double> times;
  for (int step = 0; from + step * kStep < until; ++step) {
    times.push_back(from + step * kStep);
  }
  return times;
}

/// Everything a worker began, said or heard.
std::string stepsOf(const std::vector<Frame>& frames, int id) {
  std::string steps;
  for (const Frame& frame : frames) {
    for (const Event& event : frame.events) {
      const bool isSpeech = event.kind == EventKind::Say || event.kind == EventKind::Heard;
      if (event.id == id && (isSpeech || event.kind == EventKind::Action)) {
        steps += steps.empty() ? "" : ", ";
        steps += (isSpeech ? std::string(eventKindName(event.kind)) + " " : "") + event.text;
      }
    }
  }
  return steps;
}

Vec2 placeOf(const Frame& frame, std::size_t row) {
  return poseOf(frame, row).position;
}

}  // namespace

/// maps/two_workers: the story of the HuNavSim 2.0 paper (section IV-B), step by step. Worker 1
/// waits until the robot comes in sight, worker 2 has a look at it; they meet, talk, and leave one
/// behind the other.
class ShippedTwoWorkersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    Loaded loaded = loadAsWritten("two_workers", "two_workers_agents");
    const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
    const std::string said = pendingDiagnostics(loaded.diagnostics);
    QVERIFY2(said.empty(), said.c_str());
    QVERIFY(world != nullptr);
    around_ = sim2d::makeSurroundings(*loaded.scenario, loaded.map);
    frames_ = framesOf(*world);
    QVERIFY2(world->failure().empty(), world->failure().c_str());
    QVERIFY(std::fabs(at(1.0).time - 1.0) < kTiny);
    base::Diagnostics found;
    world->behavior().takeDiagnostics(found);
    QVERIFY(found.empty());
  }

  void workers_takeTheStepsOfTheirTrees_inOrder() {
    QCOMPARE(QString::fromStdString(stepsOf(frames_, 1)), QString::fromUtf8(kStepsOfFirst));
    QCOMPARE(QString::fromStdString(stepsOf(frames_, 2)), QString::fromUtf8(kStepsOfSecond));
    for (const Frame& frame : frames_) {
      for (const Event& event : frame.events) {
        QVERIFY(event.kind != EventKind::Contact || frame.time > end(2, "GoToExit"));
        QVERIFY(event.kind != EventKind::Stuck);
        QVERIFY2(
            event.kind != EventKind::ActionEnd || event.text.find(" SUCCESS") != std::string::npos,
            event.text.c_str());
      }
    }
  }

  /// The robot is near all the time, but a rack hides it.
  void worker1_staysAtTheFirstRack_untilTheRobotIsInSight() {
    const double arrived = end(1, "GoToFirstRack");
    double seen = arrived;
    const auto isInSight = [&](const Frame& frame) {
      const Vec2 robot = robotPoseOf(frame).position;
      const Vec2 own = placeOf(frame, kFirst);
      return (robot - own).norm() <= 10.0 &&
             angleOff(poseOf(frame, kFirst), robot) <= base::kPi / 2.0 + 0.17 &&
             around_->obstacles.isVisible(own, robot);
    };
    while (!isInSight(at(seen))) {
      QVERIFY((robotPoseOf(at(seen)).position - placeOf(at(seen), kFirst)).norm() < 10.0);
      seen += kStep;
    }
    QVERIFY2(seen - arrived > 1.0, std::to_string(seen - arrived).c_str());
    // one step until he sees it; a condition that holds at once ends the step of a sequence
    const double waited = begin(1, "LookAtRobot") - seen;
    QVERIFY2(std::fabs(waited - 2.0 * kStep - 2.0) < kTiny, std::to_string(waited).c_str());
    QVERIFY(standsStill(kFirst, arrived, begin(1, "GoToSecondRack")));
    QVERIFY((placeOf(at(seen), kFirst) - kFirstRack).norm() <= 0.2 + kTiny);
    const Frame& looked = at(end(1, "LookAtRobot"));
    QVERIFY(angleOff(poseOf(looked, kFirst), robotPoseOf(looked).position) < 0.1);
  }

  void workers_waiting_standStill() {
    QVERIFY(standsStill(kFirst, begin(1, "Wonder"), end(1, "Wonder")));
    for (const auto& [action, seconds] :
         {std::pair("Wonder", 1.5), std::pair("CheckSecondRack", 3.0),
          std::pair("CheckThirdRack", 5.0), std::pair("CheckLastRack", 3.0)}) {
      QVERIFY2(std::fabs(end(1, action) - begin(1, action) - seconds) < kTiny, action);
      QVERIFY2(standsStill(kFirst, begin(1, action), end(1, action)), action);
    }
    QVERIFY(standsStill(kSecond, end(2, "LookAtFirstRack"), begin(2, "LookAtRobot")));
    QVERIFY(std::fabs(begin(2, "LookAtRobot") - end(2, "LookAtFirstRack") - 2.0) < kTiny);
    QVERIFY(standsStill(kSecond, end(2, "LookAtRobot"), begin(2, "ApproachRobot") - kStep));
    QVERIFY(std::fabs(begin(2, "ApproachRobot") - end(2, "LookAtRobot") - 1.0) < kTiny);
    QVERIFY(standsStill(kSecond, end(2, "LookAtSecondRack"), begin(2, "GoToThirdRack")));
    QVERIFY(std::fabs(begin(2, "GoToThirdRack") - end(2, "LookAtSecondRack") - 3.0) < kTiny);
  }

  void worker2_approachesTheRobot_forEightSeconds() {
    const double from = begin(2, "ApproachRobot");
    const double until = end(2, "ApproachRobot");
    QVERIFY(std::fabs(until - from - 8.0) < kTiny);
    const auto distance = [&](double time) {
      return (placeOf(at(time), kSecond) - robotPoseOf(at(time)).position).norm();
    };
    QVERIFY(distance(from) > 2.0);
    for (const double time : timesOf(from, until)) {
      QVERIFY(distance(time) > 1.2 - 1.0 * kStep);  // one step at no more than 1 m/s
    }
    QVERIFY(distance(until) < 1.21);
    QVERIFY(angleOff(poseOf(at(until), kSecond), robotPoseOf(at(until)).position) < 0.01);
  }

  void worker1_waitsAtTheLastRack_untilWorker2HasCome() {
    const double from = end(1, "GoToLastRack");
    const double turns = begin(1, "LookAtWorker2");
    QVERIFY(standsStill(kFirst, from, turns));
    QVERIFY((placeOf(at(from), kFirst) - kLastRack).norm() <= 0.2 + kTiny);
    QVERIFY((placeOf(at(turns - kStep), kSecond) - kMeeting).norm() <= 0.5);
  }

  void worker2_startsToTalk_onceWorker1LooksBack() {
    const double answered = end(2, "IsWorker1Looking");
    QVERIFY(answered > begin(1, "LookAtWorker2"));
    const auto angle = [&](double time) {
      return angleOff(poseOf(at(time), kFirst), placeOf(at(time), kSecond));
    };
    QVERIFY(angle(answered - kStep) <= 0.2);
    for (const double time : timesOf(begin(2, "IsWorker1Looking"), answered - 1.5 * kStep)) {
      QVERIFY(angle(time) > 0.2);
    }
    QVERIFY(std::fabs(begin(2, "Talk") - answered) < kStep + kTiny);
  }

  /// Places on the circle count as reached within 0.1 m.
  void workers_talk_faceToFaceOnTheCircle() {
    const double until = end(2, "Talk");
    const double from = until - 6.0;
    QVERIFY(from > begin(2, "Talk"));
    for (std::size_t row : {kFirst, kSecond}) {
      QVERIFY(standsStill(row, from, until));
      const base::Pose2 pose = poseOf(at(from), row);
      const double radius = (pose.position - kTalk).norm();
      QVERIFY2(std::fabs(radius - 0.7) <= 0.1, std::to_string(radius).c_str());
      QVERIFY(angleOff(pose, kTalk) <= 0.01);
    }
    const Vec2 first = placeOf(at(from), kFirst) - kTalk;
    const Vec2 second = placeOf(at(from), kSecond) - kTalk;
    QVERIFY(first.normalized().dot(second.normalized()) < -0.95);  // within 18 degrees
    QVERIFY((first - second).norm() > 1.2 && (first - second).norm() < 1.6);
  }

  void worker1_follows_onceAskedTo() {
    const double spoken = timeOf(frames_, EventKind::Say, 2, "Follow me");
    const double heard = timeOf(frames_, EventKind::Heard, 1, "Follow me");
    QVERIFY(spoken >= end(2, "Talk"));
    QVERIFY(heard > spoken && heard < spoken + 0.2);
    QVERIFY((placeOf(at(heard), kFirst) - placeOf(at(heard), kSecond)).norm() <= 5.0);
    const double follows = begin(1, "FollowWorker2");
    QVERIFY(follows >= heard);
    QVERIFY(standsStill(kFirst, end(2, "Talk") - 6.0, follows - kStep));
    for (const double time : timesOf(follows + 5.0, end(2, "GoToExit"))) {
      const double apart = (placeOf(at(time), kFirst) - placeOf(at(time), kSecond)).norm();
      QVERIFY2(std::fabs(apart - 1.5) < 0.3, std::to_string(apart).c_str());
    }
  }

  void worker2_atTheExit_stands() {
    const double left = end(2, "GoToExit");
    QVERIFY(left > 0.0);
    QVERIFY((placeOf(at(left), kSecond) - kExit).norm() <= 0.2 + kTiny);
    const Frame& last = frames_.back();
    QVERIFY(last.time > left + 1.0);
    QVERIFY((placeOf(last, kSecond) - kExit).norm() < 0.3);
  }

  void worker2_atTheExit_startsAnewWhenTreesLoop() {
    Loaded loaded = loadAsWritten("two_workers", "two_workers_agents");
    sim2d::Scenario scenario = *loaded.scenario;
    scenario.desktop.loopTrees = true;
    loaded.scenario = std::make_shared<const sim2d::Scenario>(scenario);
    const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
    QVERIFY(world != nullptr);
    const std::string steps = stepsOf(framesOf(*world), 2);
    QCOMPARE(QString::fromStdString(steps),
             QString::fromUtf8(kStepsOfSecond) + QStringLiteral(", GoToFirstRack"));
  }

 private:
  double begin(int id, const char* action) const {
    return timeOf(frames_, EventKind::Action, id, action);
  }

  double end(int id, const char* action) const {
    return timeOf(frames_, EventKind::ActionEnd, id, std::string(action) + " SUCCESS");
  }

  const Frame& at(double time) const {
    return frames_[static_cast<std::size_t>(std::lround(time / kStep))];
  }

  bool standsStill(std::size_t row, double from, double until) const {
    for (const double time : timesOf(from, until)) {
      if ((placeOf(at(time), row) - placeOf(at(from), row)).norm() > kTiny) {
        return false;
      }
    }
    return from > 0.0 && until > from;
  }

  std::vector<Frame> frames_;
  std::optional<sim2d::Surroundings> around_;
};

QTEST_APPLESS_MAIN(ShippedTwoWorkersTest)
#include "tst_ShippedTwoWorkers.moc"
