#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "app/studies/AvoidableContact.h"
#include "app/studies/Manoeuvres.h"

namespace {

constexpr double kDt = 0.05;          // [s]
constexpr double kTolerance = 0.1;    // [s]
constexpr double kRobotRadius = 0.3;  // [m]
// A trial takes 1 to 2 ms of a processor, a copy of the process included: at most 2 s per contact.
constexpr std::size_t kMostTrials = 1000;

/// A robot that drives along the x axis and a person who does not evade.
struct ContactScene {
  double speed = 1.0, deceleration = 1.0, maxSpeed = 1.0;  // of the robot
  double distance = 6.0;                                   // of the centres at the start [m]
  double personSpeed = 0.0;                                // along x [m/s]
  double personRadius = 0.35;
  bool hasCorridor = true;   // no room beside the robot
  bool hasDeadEnd = false;   // a wall right in front of the robot
  double hiddenUntil = 0.0;  // the person appears at this time [s]
  bool isHolonomic = false;

  double touching() const { return kRobotRadius + personRadius; }  // distance of the centres
};

void addWall(sim2d::Scenario& scenario, const std::string& name, const base::Vec2& from,
             const base::Vec2& to) {
  sim2d::Obstacle& wall = scenario.obstacles.emplace_back();
  wall.key = {base::EntityKind::Obstacle, 30 + static_cast<int>(scenario.obstacles.size())};
  wall.name = name;
  wall.kind = sim2d::ObstacleKind::Wall;
  wall.points = {from, to};
}

void addWalls(const ContactScene& scene, sim2d::Scenario& scenario) {
  constexpr double kHalfThickness = 0.05, kRoom = 0.05;  // [m]
  const double y = std::max(kRobotRadius, scene.personRadius) + kRoom + kHalfThickness;
  if (scene.hasCorridor) {
    addWall(scenario, "left", {-30.0, y}, {30.0, y});
    addWall(scenario, "right", {-30.0, -y}, {30.0, -y});
  }
  if (scene.hasDeadEnd) {
    const double x = kRobotRadius + 0.02 + kHalfThickness;
    addWall(scenario, "end", {x, -y}, {x, y});
  }
}

app::Bundle bundleOf(const ContactScene& scene) {
  sim2d::Scenario scenario;
  sim2d::Human& human = scenario.humans.emplace_back();
  human.key = {base::EntityKind::Human, 1};
  human.id = 1;
  human.name = "anna";
  human.radius = scene.personRadius;
  human.initPose = {{scene.distance, 0.0}, base::kPi};
  if (scene.hiddenUntil > 0.0) {
    human.ours.startTime = scene.hiddenUntil;
  }
  sim2d::Robot& robot = scenario.robots.emplace_back();
  robot.key = {base::EntityKind::Robot, 20};
  robot.name = "robot1";
  robot.radius = kRobotRadius;
  robot.maxVel = scene.maxSpeed;
  robot.maxAcc = scene.deceleration;
  robot.goal.point = sim2d::Vec2(25.0, 0.0);
  if (scene.isHolonomic) {
    robot.kinematics = sim2d::Kinematics::Omnidirectional;
  }
  addWalls(scene, scenario);
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  return bundle;
}

/// The robot's command, and where the person is, whatever happens.
sim2d::StepInputs scriptOf(const ContactScene& scene, double time) {
  sim2d::StepInputs inputs(time >= scene.hiddenUntil ? 2 : 1);
  inputs.front().kind = sim2d::InputKind::Robot;
  inputs.front().id = -1;
  inputs.front().velocity = {scene.speed, 0.0};
  if (inputs.size() > 1) {
    inputs.back().kind = sim2d::InputKind::Set;
    inputs.back().id = 1;
    inputs.back().pose = {{scene.distance + scene.personSpeed * time, 0.0}, base::kPi};
    inputs.back().velocity = inputs.back().desiredVelocity = {scene.personSpeed, 0.0};
  }
  return inputs;
}

/// Simulates the scene until shortly after its first contact.
app::RepeatableRun recordedScene(const ContactScene& scene) {
  app::RepeatableRun run;
  run.bundle = bundleOf(scene);
  app::Verdict verdict = app::check(run.bundle);
  if (verdict.world == nullptr) {
    qWarning("%s", verdict.problems.front().message.c_str());
    return run;
  }
  sim2d::World& world = *verdict.world;
  const auto recording = std::make_shared<sim2d::Recording>();
  recording->setHeader(world.header());
  recording->append(world.frame());
  constexpr double kLongest = 40.0;  // [s]
  while (world.time() < kLongest) {
    world.step(scriptOf(scene, world.time()));
    recording->append(world.frame());
    const auto& events = world.frame().events;
    if (std::any_of(events.begin(), events.end(), [](const sim2d::Event& event) {
          return event.kind == sim2d::EventKind::Contact && event.hasOther;
        })) {
      break;
    }
  }
  // The script of the person continues beyond the contact.
  for (int k = 1; k <= 60; ++k) {
    const double time = world.time() + (k - 1) * kDt;
    for (const sim2d::Input& input : scriptOf(scene, time)) {
      recording->addInput(world.stepIndex() + k, input);
    }
  }
  run.recording = recording;
  return run;
}

const auto kContinue = [] { return false; };

std::optional<app::AvoidableContact> analysed(const ContactScene& scene,
                                              const app::AvoidanceOptions& options = {}) {
  const app::RepeatableRun run = recordedScene(scene);
  if (run.recording == nullptr) {
    return std::nullopt;
  }
  const auto contacts = app::avoidableContacts(run, options, kContinue);
  if (!contacts) {
    qWarning("%s", contacts.diagnostics().front().message.c_str());
    return std::nullopt;
  }
  return contacts->empty() ? std::nullopt : std::optional(contacts->front());
}

app::AvoidanceOptions ofRobot(double lookback = 6.0) {
  app::AvoidanceOptions options;
  options.tryPeople = false;
  options.lookback = lookback;
  return options;
}

enum class Aside { Nothing, Sideways, Turn };

/// Whether an omnidirectional robot misses the person when it begins to evade `lead` [s] before the
/// contact, simulated without the program.
bool misses(const ContactScene& scene, double lead, double target, Aside aside) {
  constexpr double kStep = 0.001, kMaxOmega = 1.5, kMaxAlpha = 3.0;  // of the generic robot
  const double change = scene.deceleration * kStep;
  base::Vec2 place(-scene.touching() - scene.speed * lead, 0.0), velocity(scene.speed, 0.0);
  double heading = 0.0, omega = 0.0;
  for (double time = 0.0; time < lead + 2.0; time += kStep) {
    velocity.x() = std::clamp(target, velocity.x() - change, velocity.x() + change);
    if (aside == Aside::Sideways) {
      velocity.y() = std::min(scene.maxSpeed, velocity.y() + change);
    } else if (aside == Aside::Turn) {
      omega = std::min(kMaxOmega, omega + kMaxAlpha * kStep);
    }
    heading += omega * kStep;
    const base::Vec2 ahead(std::cos(heading), std::sin(heading));
    place += kStep * (velocity.x() * ahead + velocity.y() * base::Vec2(-ahead.y(), ahead.x()));
    if (place.norm() < scene.touching()) {
      return false;
    }
  }
  return true;
}

/// The shortest time before the contact at which it can begin to evade [s].
double evasionLead(const ContactScene& scene) {
  double best = 10.0;
  for (const double target : {0.0, -scene.maxSpeed, scene.speed, scene.maxSpeed}) {
    for (const Aside aside : {Aside::Nothing, Aside::Sideways, Aside::Turn}) {
      for (double lead = 0.0; lead < best; lead += 0.005) {
        if (misses(scene, lead, target, aside)) {
          best = lead;
        }
      }
    }
  }
  return best;
}

}  // namespace

/// Last avoidable actions in scenes whose answer is known in closed form: at closing speed w and
/// deceleration a the robot must brake at the latest w / (2 a) before the contact would happen.
class AvoidableContactTest : public QObject {
  Q_OBJECT

 private:
  static void compareLead(const ContactScene& scene, double lead) {
    compareLead(analysed(scene, ofRobot()), lead);
  }
  static void compareLead(const std::optional<app::AvoidableContact>& contact, double lead) {
    QVERIFY(contact.has_value());
    QVERIFY(contact->robotAction.has_value());
    const double found = contact->time - contact->robotAction->time;
    const std::string text = std::to_string(found) + " s before " + std::to_string(contact->time) +
                             " s (" + contact->robotAction->manoeuvre + "), expected " +
                             std::to_string(lead);
    QVERIFY2(std::fabs(found - lead) <= kTolerance, text.c_str());
    QVERIFY(contact->couldRobotAvoid());
    QVERIFY(contact->robotAction->robotPath.size() > 1);
    QVERIFY2(contact->trials <= kMostTrials, std::to_string(contact->trials).c_str());
  }

 private Q_SLOTS:
  void standingPerson_brakingDistance_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("deceleration");
    QTest::addColumn<double>("radius");
    for (const double speed : {0.4, 0.8, 1.2}) {
      for (const double deceleration : {0.5, 1.0, 2.0}) {
        for (const double radius : {0.25, 0.4}) {
          QTest::addRow("v %g a %g r %g", speed, deceleration, radius)
              << speed << deceleration << radius;
        }
      }
    }
  }
  void standingPerson_brakingDistance() {
    ContactScene scene;
    QFETCH(double, speed);
    QFETCH(double, deceleration);
    QFETCH(double, radius);
    scene.speed = scene.maxSpeed = speed;
    scene.deceleration = deceleration;
    scene.personRadius = radius;
    compareLead(scene, speed / (2.0 * deceleration));
  }

  /// The robot must reach the person's velocity backwards: an approach is a higher closing speed.
  void approachingPerson_relativeBrakingDistance_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("deceleration");
    QTest::addColumn<double>("approach");
    for (const double speed : {0.6, 1.0}) {
      for (const double deceleration : {0.5, 1.0, 2.0}) {
        for (const double approach : {0.3, 0.5}) {
          QTest::addRow("v %g a %g u %g", speed, deceleration, approach)
              << speed << deceleration << approach;
        }
      }
    }
  }
  void approachingPerson_relativeBrakingDistance() {
    ContactScene scene;
    QFETCH(double, speed);
    QFETCH(double, deceleration);
    QFETCH(double, approach);
    scene.speed = scene.maxSpeed = speed;
    scene.deceleration = deceleration;
    scene.personSpeed = -approach;
    scene.distance = 8.0;
    compareLead(scene, (speed + approach) / (2.0 * deceleration));
  }

  void personWalkingAhead_relativeBrakingDistance_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("deceleration");
    QTest::addColumn<double>("ahead");
    for (const double deceleration : {0.5, 1.0}) {
      for (const double ahead : {0.2, 0.4, 0.6}) {
        QTest::addRow("a %g u %g", deceleration, ahead) << 1.2 << deceleration << ahead;
      }
    }
  }
  void personWalkingAhead_relativeBrakingDistance() {
    ContactScene scene;
    QFETCH(double, speed);
    QFETCH(double, deceleration);
    QFETCH(double, ahead);
    scene.speed = scene.maxSpeed = speed;
    scene.deceleration = deceleration;
    scene.personSpeed = ahead;
    scene.distance = 3.0;
    compareLead(scene, (speed - ahead) / (2.0 * deceleration));
  }

  /// The person is faster and comes from behind: the robot must accelerate to the same speed.
  void personFromBehind_acceleration_data() {
    QTest::addColumn<double>("deceleration");
    QTest::addColumn<double>("person");
    QTest::newRow("a 0.5") << 0.5 << 1.0;
    QTest::newRow("a 1") << 1.0 << 1.0;
    QTest::newRow("a 0.5, faster") << 0.5 << 1.3;
  }
  void personFromBehind_acceleration() {
    ContactScene scene;
    QFETCH(double, deceleration);
    QFETCH(double, person);
    scene.speed = 0.4;
    scene.maxSpeed = 1.5;
    scene.deceleration = deceleration;
    scene.personSpeed = person;
    scene.distance = -3.0;
    const auto contact = analysed(scene, ofRobot());
    compareLead(contact, (person - scene.speed) / (2.0 * deceleration));
    QVERIFY(contact->cause == sim2d::ContactMark::Cause::Person);
    QCOMPARE(*contact->brakingAvoids, false);  // it would be hit earlier
  }

  /// In front of a wall there is no way out.
  void personFromBehind_deadEnd_isNeverAvoidable_data() {
    QTest::addColumn<double>("person");
    QTest::newRow("slow") << 0.5;
    QTest::newRow("fast") << 1.2;
  }
  void personFromBehind_deadEnd_isNeverAvoidable() {
    ContactScene scene;
    QFETCH(double, person);
    scene.speed = 0.0;
    scene.hasDeadEnd = true;
    scene.personSpeed = person;
    scene.distance = -3.0;
    const auto contact = analysed(scene, ofRobot(1.5));
    QVERIFY(contact.has_value());
    QVERIFY(!contact->robotAction.has_value());
    QVERIFY(!contact->couldRobotAvoid());
    QVERIFY(contact->cause == sim2d::ContactMark::Cause::Person);
    QVERIFY(contact->trials > 100);
  }

  /// The person appears within the braking distance: the last action would have been before.
  void suddenPerson_isNotAvoidableSinceFirstSight_data() {
    QTest::addColumn<double>("deceleration");
    QTest::addColumn<double>("margin");  // of the appearance before the contact [s]
    QTest::newRow("a 0.5, 0.4 s") << 0.5 << 0.4;
    QTest::newRow("a 0.5, 0.8 s") << 0.5 << 0.8;
    QTest::newRow("a 1, 0.3 s") << 1.0 << 0.3;
  }
  void suddenPerson_isNotAvoidableSinceFirstSight() {
    ContactScene scene;
    QFETCH(double, deceleration);
    QFETCH(double, margin);
    scene.deceleration = deceleration;
    const auto visible = analysed(scene, ofRobot());
    QVERIFY(visible.has_value());
    scene.hiddenUntil = visible->time - margin;
    const auto contact = analysed(scene, ofRobot());
    QVERIFY(contact.has_value());
    QVERIFY(contact->robotSight.has_value());
    QVERIFY(std::fabs(*contact->robotSight - scene.hiddenUntil) <= 2.0 * kDt);
    QVERIFY(contact->robotAction.has_value());
    QVERIFY(std::fabs(contact->time - contact->robotAction->time - 0.5 / deceleration) <=
            kTolerance);
    QVERIFY(!contact->couldRobotAvoid());
    QCOMPARE(*contact->brakingAvoids, false);
    QCOMPARE(app::whoCouldAvoid(*contact), "none");
  }

  void openSpace_evasionOfHolonomicRobots_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("acceleration");
    for (const double speed : {0.8, 1.2}) {
      for (const double acceleration : {0.6, 1.5}) {
        QTest::addRow("v %g a %g", speed, acceleration) << speed << acceleration;
      }
    }
  }
  void openSpace_evasionOfHolonomicRobots() {
    ContactScene scene;
    QFETCH(double, speed);
    QFETCH(double, acceleration);
    scene.speed = scene.maxSpeed = speed;
    scene.deceleration = acceleration;
    scene.hasCorridor = false;
    scene.isHolonomic = true;
    compareLead(scene, evasionLead(scene));
  }

  /// A person who stands in the way of a robot that sees it all the time can step aside as well.
  void personWhoIsFree_couldAvoidToo() {
    ContactScene scene;
    scene.hasCorridor = false;
    scene.speed = scene.maxSpeed = 2.5;  // too fast for the person to yield
    app::RepeatableRun run = recordedScene(scene);
    // The same run without the script of the person, who stands still without goals.
    const auto recording = std::make_shared<sim2d::Recording>();
    app::Verdict verdict = app::check(run.bundle);
    sim2d::World& world = *verdict.world;
    recording->setHeader(world.header());
    recording->append(world.frame());
    bool hasTouched = false;
    while (world.time() < 20.0 && !hasTouched) {
      sim2d::StepInputs inputs(2);
      inputs[0] = scriptOf(scene, 0.0).front();
      inputs[1].kind = sim2d::InputKind::Stop;
      inputs[1].id = 1;
      world.step(inputs);
      recording->append(world.frame());
      hasTouched = std::any_of(
          world.frame().events.begin(), world.frame().events.end(),
          [](const sim2d::Event& each) { return each.kind == sim2d::EventKind::Contact; });
    }
    QVERIFY(hasTouched);
    verdict.world.reset();
    run.recording = recording;
    const auto contacts = app::avoidableContacts(run, {}, kContinue);
    QVERIFY(contacts && contacts->size() == 1);
    const app::AvoidableContact& contact = contacts->front();
    QVERIFY(contact.couldRobotAvoid());
    QVERIFY(contact.personSight.has_value());
    QVERIFY(contact.personAction.has_value());
    QCOMPARE(app::whoCouldAvoid(contact), "both");
    QCOMPARE(*contact.brakingAvoids, true);
  }

  void stopRequested_returnsWhatIsFinished() {
    const app::RepeatableRun run = recordedScene({});
    const auto contacts = app::avoidableContacts(run, {}, [] { return true; });
    QVERIFY(contacts && contacts->empty());
  }

  /// Another seed of the program would be another run.
  void otherRecording_isReported() {
    app::RepeatableRun run = recordedScene({});
    auto scenario = std::make_shared<sim2d::Scenario>(*run.bundle.scenario);
    scenario->robots.front().start.position.x() = 0.1;
    run.bundle.scenario = scenario;
    const auto contacts = app::avoidableContacts(run, {}, kContinue);
    QVERIFY(!contacts);
    QCOMPARE(contacts.diagnostics().front().code, std::string_view("contacts.goes-elsewhere"));
  }

  void manoeuvres_dependOnTheDrive() {
    sim2d::TraceRobot robot;
    QCOMPARE(app::robotManoeuvres(robot, {0.5, 0.0, 0.0}).size(), std::size_t{36});
    robot.kinematics = "omnidirectional";
    QCOMPARE(app::robotManoeuvres(robot, {0.5, 0.0, 0.0}).size(), std::size_t{20});
    QCOMPARE(app::robotManoeuvres(robot, {}).front().name, std::string("brake"));
  }
};

QTEST_GUILESS_MAIN(AvoidableContactTest)
#include "tst_AvoidableContact.moc"
