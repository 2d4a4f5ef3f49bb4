#include <cmath>
#include <set>

#include <QtTest>

#include "tests/bt/ShippedScenario.h"

using namespace shipped;

namespace {

constexpr double kStep = 0.05;      // [s]
constexpr double kRounding = 1e-9;  // [m], [s]

std::vector<Frame> framesOf(const std::string& kind) {
  Loaded loaded = loadAsWritten("reactions", "reaction_" + kind + "_agents");
  const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
  const std::string said = pendingDiagnostics(loaded.diagnostics);
  if (!world || !said.empty()) {
    qWarning("%s", said.c_str());
    return {};
  }
  return shipped::framesOf(*world);
}

bool hasContact(const std::vector<Frame>& frames) {
  return timeOf(frames, EventKind::Contact, 1) >= 0.0 ||
         timeOf(frames, EventKind::Contact, -1) >= 0.0;
}

double distanceOf(const Frame& frame) {
  return (poseOf(frame).position - robotPoseOf(frame).position).norm();
}
double angleToRobot(const Frame& frame) {
  return angleOff(poseOf(frame), robotPoseOf(frame).position);
}

}  // namespace

/// The scenarios of maps/reactions: one person, one robot, the generated tree. Each shows what the
/// person's type does when the robot comes.
class ShippedReactionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void regularAndImpassive_walkOn_data() {
    QTest::addColumn<QString>("kind");
    QTest::newRow("regular") << "regular";
    QTest::newRow("impassive") << "impassive";
  }

  /// Regular people feel the robot as one of their own, impassive ones as an obstacle. The walls of
  /// the hall are too far away to be felt while they pass.
  void regularAndImpassive_walkOn() {
    QFETCH(QString, kind);
    const std::vector<Frame> frames = framesOf(kind.toStdString());
    QVERIFY(!frames.empty());
    double closest = 1e9;
    double social = 0.0;
    double obstacle = 0.0;  // part away from the robot
    for (const Frame& frame : frames) {
      QVERIFY(frame.humans.state[0] == 0);
      closest = std::min(closest, distanceOf(frame));
      if (frame.time < 1.0 || frame.time > 8.0) {
        continue;
      }
      QVERIFY2(speedOf(frame) > 1.15, std::to_string(frame.time).c_str());  // of 1.3 m/s
      QVERIFY(std::fabs(poseOf(frame).position.y() - 4.6) < 0.3);
      const Vec2 away = (poseOf(frame).position - robotPoseOf(frame).position).normalized();
      social = std::max(social, frame.forces.social[0].norm());
      obstacle = std::max(obstacle, frame.forces.obstacle[0].dot(away));
    }
    QVERIFY(!hasContact(frames));
    QVERIFY2(closest > 0.7 && closest < 1.4, std::to_string(closest).c_str());
    if (kind == QStringLiteral("regular")) {
      QVERIFY2(social > 0.1 && obstacle < 0.01, std::to_string(social).c_str());
    } else {
      QVERIFY2(social < kRounding && obstacle > 0.1, std::to_string(obstacle).c_str());
    }
    const double first = timeOf(frames, EventKind::Goal, 1, "1");
    QVERIFY(first > 0.0 && first < timeOf(frames, EventKind::Goal, 1, "2"));
  }

  void surprised_standsAndWatchesWhileTheRobotIsNear() {
    const std::vector<Frame> frames = framesOf("surprised");
    QVERIFY(!frames.empty());
    double from = -1.0;
    double until = -1.0;
    Vec2 place = Vec2::Zero();
    for (const Frame& frame : frames) {
      const bool isSurprised = frame.humans.state[0] != 0;
      if (isSurprised && from < 0.0) {
        from = frame.time;
        place = poseOf(frame).position;
        QVERIFY(std::fabs(distanceOf(frame) - 4.0) < 0.2);
      }
      if (isSurprised) {
        until = frame.time;
        QVERIFY(speedOf(frame) < kRounding);
        QVERIFY((poseOf(frame).position - place).norm() < kRounding);
        QVERIFY(frame.time < from + 0.5 || angleToRobot(frame) < 0.05);
      }
      if (distanceOf(frame) < 3.95) {
        QVERIFY(isSurprised);
      }
    }
    QVERIFY2(until - from > 5.0, std::to_string(until - from).c_str());
    for (const Frame& frame : frames) {
      QVERIFY(frame.time < until + 1.0 || frame.time > until + 3.0 || speedOf(frame) > 1.1);
    }
    QVERIFY(timeOf(frames, EventKind::Goal, 1, "1") > until);
    QVERIFY(timeOf(frames, EventKind::Arrived, -1) > from);
  }

  /// The flight aims at 4 m from the robot and ends where that place counts as reached, 0.3 m
  /// before.
  void scared_keepsTheSafeDistance() {
    const std::vector<Frame> frames = framesOf("scared");
    QVERIFY(!frames.empty());
    const double seen = timeOf(frames, EventKind::Action, 1, "AvoidRobot");
    QVERIFY(seen > 0.0);
    double startX = 0.0;
    double robotStartX = 0.0;
    for (const Frame& frame : frames) {
      QVERIFY2(distanceOf(frame) > 4.0 - 0.3 - 0.06, std::to_string(distanceOf(frame)).c_str());
      if (std::fabs(frame.time - seen) < kRounding) {
        QVERIFY(distanceOf(frame) <= 5.0);
        startX = poseOf(frame).position.x();
        robotStartX = robotPoseOf(frame).position.x();
      }
    }
    const Frame& last = frames.back();
    QVERIFY(robotPoseOf(last).position.x() - robotStartX > 4.0);
    QVERIFY(poseOf(last).position.x() - startX > 3.5);  // else the robot would be 1 m away
    QVERIFY(distanceOf(last) < 4.2);
    QVERIFY(!hasContact(frames));
  }

  void curious_comesToTheStopDistanceAndStays() {
    const std::vector<Frame> frames = framesOf("curious");
    QVERIFY(!frames.empty());
    const double seen = timeOf(frames, EventKind::Action, 1, "ApproachRobot");
    QVERIFY(seen > 0.0);
    int stays = 0;
    for (const Frame& frame : frames) {
      QVERIFY(distanceOf(frame) > 1.4);
      if (frame.time >= frames.back().time - 10.0) {
        ++stays;
        QVERIFY(frame.humans.state[0] == 1);
        QVERIFY(distanceOf(frame) <= 1.5);
        QVERIFY(speedOf(frame) < kRounding);
        QVERIFY(angleToRobot(frame) < 0.01);
      }
    }
    QVERIFY(stays >= 200);
    QVERIFY(timeOf(frames, EventKind::Arrived, -1) > seen);
  }

  void threatening_standsInTheWayUntilItIsOver() {
    const std::vector<Frame> frames = framesOf("threatening");
    QVERIFY(!frames.empty());
    const double from = timeOf(frames, EventKind::Action, 1, "BlockRobot");
    const double until = timeOf(frames, EventKind::ActionEnd, 1, "BlockRobot SUCCESS");
    QVERIFY(from > 0.0);
    QVERIFY(std::fabs(until - from - 15.0) < kStep + kRounding);
    for (const Frame& frame : frames) {
      if (frame.time < from + 5.0 || frame.time > until - kStep) {
        continue;
      }
      QVERIFY(speedOf(frame) < kRounding);
      QVERIFY(angleToRobot(frame) < 0.05);
      QVERIFY(robotSpeedOf(frame) < 0.05);
      const Vec2 place = robotPoseOf(frame).toLocal(poseOf(frame).position);
      QVERIFY2(place.x() > 0.7 && place.x() < 1.4 + 0.8, std::to_string(place.x()).c_str());
      QVERIFY2(std::fabs(place.y()) < 0.7, std::to_string(place.y()).c_str());  // both radii
    }
    QVERIFY(!hasContact(frames));
    QVERIFY(timeOf(frames, EventKind::Goal, 1, "1") > until);
    QVERIFY(timeOf(frames, EventKind::Arrived, -1) > until);
  }

  // maps/corner_cafe, the first that people see: the robot comes through, nobody walks into it, and
  // who reacts to robots does.

  void initTestCase() {
    Loaded cafe = load("corner_cafe", "corner_cafe_agents");
    const std::unique_ptr<sim2d::World> world = makeWorld(cafe);
    QVERIFY2(world != nullptr, pendingDiagnostics(cafe.diagnostics).c_str());
    frames_ = shipped::framesOf(*world);
  }

  void robot_arrives_untouched() {
    double arrival = 0.0;
    for (const Frame& frame : frames_) {
      for (const Event& event : frame.events) {
        const bool isRobots = event.id < 0;
        QVERIFY2(!isRobots || event.kind != EventKind::Contact,
                 qPrintable(QStringLiteral("touches %1 at %2 s").arg(event.other).arg(frame.time)));
        arrival = isRobots && event.kind == EventKind::Arrived ? frame.time : arrival;
      }
    }
    QVERIFY2(arrival > 10.0 && arrival < 40.0, qPrintable(QString::number(arrival)));
  }

  void people_seldomTouchEachOther() {
    int contacts = 0;
    for (const Frame& frame : frames_) {
      contacts += static_cast<int>(
          std::count_if(frame.events.begin(), frame.events.end(),
                        [](const Event& event) { return event.kind == EventKind::Contact; }));
    }
    QVERIFY2(contacts <= 3, qPrintable(QString::number(contacts)));
  }

  void people_reactToTheRobot() {
    std::set<int> reacting;
    for (const Frame& frame : frames_) {
      for (std::size_t k = 0; k < frame.humans.size(); ++k) {
        if (frame.humans.state[k] != 0) {
          reacting.insert(frame.humans.id[k]);
        }
      }
    }
    // Chloe (curious), Emma (surprised), Farid (scared), Greta (threatening)
    QCOMPARE(reacting, (std::set<int>{3, 5, 6, 7}));
  }

 private:
  std::vector<Frame> frames_;
};

QTEST_APPLESS_MAIN(ShippedReactionsTest)
#include "tst_ShippedReactions.moc"
