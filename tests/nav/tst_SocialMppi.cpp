#include <cmath>
#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/mppi/MppiScene.h"
#include "tests/nav/MppiScenes.h"
#include "tests/nav/PlannerFunctions.h"

using namespace sim2d;

namespace {

using mppitest::discRobot;
using mppitest::Meeting;
using mppitest::Outcome;
using mppitest::Scene;
using mppitest::SceneMaker;

constexpr int kSeeds = 3;

std::shared_ptr<Planner> make(const std::string& name, const RobotBody& body, std::uint64_t seed) {
  return mppitest::plannerOf(name == "mppi" ? addMppi : addSocialMppi, body, seed);
}

Outcome outcomeOf(const char* name, Meeting meeting, std::uint64_t seed) {
  const Scene scene = SceneMaker(meeting, seed).make();
  const RobotBody body = discRobot(Kinematics::Differential);
  const auto planner = make(name, body, seed);
  return scene.world->run(*planner, body, scene.pose, scene.goal, scene.people, 40.0);
}

TrackedBody tracked(const Vec2& position, const Vec2& velocity, double heading = 0.0) {
  TrackedBody body;
  body.position = position;
  body.velocity = velocity;
  body.heading = heading;
  body.radius = 0.3;
  return body;
}

}  // namespace

class SocialMppiTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Sums over meetings and seeds, as a single meeting may go either way.
  void command_meetings_arrivesWithMoreRoomThanMppi() {
    double gaps[2] = {};
    double intimate[2] = {};
    for (const Meeting meeting : mppitest::kMeetings) {
      for (int seed = 1; seed <= kSeeds; ++seed) {
        for (const std::size_t planner : {std::size_t{0}, std::size_t{1}}) {
          const Outcome outcome = outcomeOf(planner == 0 ? "mppi" : "social_mppi", meeting,
                                            static_cast<std::uint64_t>(seed));
          const QString where = QStringLiteral("%1 %2 seed %3: gap %4, %5 s")
                                    .arg(planner)
                                    .arg(QString::fromUtf8(meetingName(meeting)))
                                    .arg(seed)
                                    .arg(outcome.leastGap)
                                    .arg(outcome.time);
          QVERIFY2(outcome.arrived, qPrintable(where));
          QVERIFY2(outcome.leastGap > 0.0, qPrintable(where));
          QVERIFY2(outcome.leastWallGap > 0.0, qPrintable(where));
          gaps[planner] += outcome.leastGap;
          intimate[planner] += outcome.intimate;
        }
      }
    }
    qInfo("sum of gaps %.2f and %.2f m, intimate %.3f and %.3f", gaps[0], gaps[1], intimate[0],
          intimate[1]);
    QVERIFY(gaps[1] > gaps[0]);
    QVERIFY(intimate[1] < intimate[0]);
  }

  void coverOf_polygon_holdsItsPoints() {
    Footprint footprint;
    footprint.corners = {Vec2(-0.6, -0.25), Vec2(0.14, -0.25), Vec2(0.2, 0.0), Vec2(0.14, 0.25),
                         Vec2(-0.6, 0.25)};
    const std::vector<MppiDisc> discs = discsCovering(footprint);
    for (std::size_t i = 0; i < footprint.corners.size(); ++i) {
      const Vec2& a = footprint.corners[i];
      const Vec2& b = footprint.corners[(i + 1) % footprint.corners.size()];
      for (int k = 0; k <= 20; ++k) {
        const Vec2 point = a + k / 20.0 * (b - a);
        double gap = 1e9;
        for (const MppiDisc& disc : discs) {
          const Vec2 centre(static_cast<double>(disc.x), static_cast<double>(disc.y));
          gap = std::min(gap, (point - centre).norm() - static_cast<double>(disc.radius));
          QVERIFY(disc.radius < 0.35F);  // and does not stand out by far: half the width is 0.25
        }
        QVERIFY(gap < 1e-6);
      }
    }
  }

  void addGroups_twoFaceToFace_shareTheMiddle() {
    const std::vector<PredictedBody> talk = {
        {tracked(Vec2(2.0, 0.7), Vec2::Zero(), -0.5 * base::kPi), {}, {}},
        {tracked(Vec2(2.0, -0.7), Vec2::Zero(), 0.5 * base::kPi), {}, {}}};
    std::vector<MppiZone> zones;
    addGroups(talk, Vec2(1.0, 0.0), 3.0, zones);
    QCOMPARE(static_cast<int>(zones.size()), 1);
    QCOMPARE(zones[0].x, 1.0F);
    QCOMPARE(zones[0].y, 0.0F);
    QVERIFY(std::fabs(zones[0].perRadius2 - 1.0F / 0.49F) < 1e-4F);
    std::vector<PredictedBody> apart = talk;
    apart[0].now.heading = 0.5 * base::kPi;  // looks away
    zones.clear();
    addGroups(apart, Vec2::Zero(), 3.0, zones);
    QVERIFY(zones.empty());
    std::vector<PredictedBody> walking = talk;
    walking[1].now.velocity = Vec2(0.0, 1.0);
    addGroups(walking, Vec2::Zero(), 3.0, zones);
    QVERIFY(zones.empty());
  }

  /// Two who walk at each other: at constant velocity they would meet in one point.
  void predictSocial_headOn_stepsAside() {
    std::vector<PredictedBody> bodies = {{tracked(Vec2(0.0, 0.0), Vec2(1.2, 0.0)), {}, {}},
                                         {tracked(Vec2(4.0, 0.05), Vec2(-1.2, 0.0)), {}, {}}};
    PredictedBody robot;
    robot.now = tracked(Vec2(100.0, 0.0), Vec2::Zero());
    robot.positions.assign(56, robot.now.position);
    robot.velocities.assign(56, Vec2::Zero());
    const ClearanceGrid open;
    predictSocial(bodies, robot, 56, 0.05, open);
    double least = 1e9;
    for (std::size_t step = 0; step < 56; ++step) {
      least = std::min(least, (bodies[0].positions[step] - bodies[1].positions[step]).norm());
    }
    QVERIFY2(least > 0.3, qPrintable(QString::number(least)));
    QVERIFY(bodies[0].positions.back().x() > 2.0);  // and still got on
  }

  void predictSocial_nobodyNear_isConstant() {
    std::vector<PredictedBody> bodies = {{tracked(Vec2(1.0, 2.0), Vec2(0.6, -0.8)), {}, {}}};
    PredictedBody robot;
    robot.now = tracked(Vec2(100.0, 0.0), Vec2::Zero());
    robot.positions.assign(41, robot.now.position);
    robot.velocities.assign(41, Vec2::Zero());
    const ClearanceGrid open;
    predictSocial(bodies, robot, 41, 0.05, open);
    for (std::size_t step = 0; step < 41; ++step) {
      const Vec2 expected = Vec2(1.0, 2.0) + 0.05 * static_cast<double>(step + 1) * Vec2(0.6, -0.8);
      QVERIFY((bodies[0].positions[step] - expected).norm() < 1e-9);
    }
  }

  void narrowPlaceAhead_doorway_isFound() {
    const Scene scene = SceneMaker(Meeting::Doorway, 1).make();
    RobotRoute route;
    const Observation observation =
        scene.world->observe({Vec2(3.0, 0.2), 0.0}, {}, scene.goal, {}, 0.0);
    route.update(observation, 0.3, 1.0);
    const NarrowPlace place =
        narrowPlaceAhead(route, observation.pose.position, scene.world->obstacles(), 1.6);
    QVERIFY(place.isFound);
    QVERIFY(std::fabs(place.position.x() - 5.0) < 0.25);  // the wall stands from 4.9 to 5.1
    QVERIFY(std::fabs(place.width - 1.2) < 0.1);
    QVERIFY(place.direction.x() > 0.9);
    QVERIFY(
        !narrowPlaceAhead(route, observation.pose.position, scene.world->obstacles(), 1.0).isFound);
  }

  void comesThrough_waysOfOnePerson() {
    const NarrowPlace door{true, Vec2(5.0, 0.0), Vec2(1.0, 0.0), 1.0};
    QVERIFY(isComingThrough(tracked(Vec2(7.0, 0.0), Vec2(-1.0, 0.0)), door));
    QVERIFY(!isComingThrough(tracked(Vec2(7.0, 0.0), Vec2(1.0, 0.0)), door));    // goes away
    QVERIFY(!isComingThrough(tracked(Vec2(7.0, 0.0), Vec2::Zero()), door));      // stands
    QVERIFY(!isComingThrough(tracked(Vec2(3.0, 0.0), Vec2(-1.0, 0.0)), door));   // is through
    QVERIFY(!isComingThrough(tracked(Vec2(7.0, 3.0), Vec2(-1.0, 0.0)), door));   // walks past it
    QVERIFY(!isComingThrough(tracked(Vec2(12.0, 0.0), Vec2(-1.0, 0.0)), door));  // is far away
  }

  void specs_everyParameter_isDescribed() {
    PlannerRegistry registry;
    addSocialMppi(registry);
    for (const base::ParameterSpec& spec : registry.find("social_mppi")->parameters) {
      QVERIFY2(!spec.help.empty(), spec.key.c_str());
      QVERIFY2(spec.range.contains(std::get<double>(spec.fallback)), spec.key.c_str());
    }
  }
};

QTEST_GUILESS_MAIN(SocialMppiTest)
#include "tst_SocialMppi.moc"
