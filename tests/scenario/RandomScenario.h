#pragma once

#include <string>

#include "sim2d/base/Rng.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/Variation.h"

/// Scenarios with random contents, for properties that hold for every scenario.
namespace scenariotest {

class RandomScenario {
 public:
  explicit RandomScenario(std::uint64_t seed) : rng_(seed, 0) {}

  sim2d::Scenario make() {
    sim2d::Scenario scenario;
    maybe(scenario.yamlBaseName, [&] { return word(); });
    maybe(scenario.simulator, [&] { return word(); });
    maybe(scenario.map, [&] { return word(); });
    maybe(scenario.publishPeople, [&] { return flip(); });
    for (int i = upTo(4); i > 0; --i) {
      sim2d::GlobalGoal goal;
      goal.id = static_cast<int>(scenario.goals.size()) * 2 + 1 + upTo(1);
      goal.position = point();
      goal.unknown = unknown();
      scenario.goals.push_back(goal);
    }
    for (int i = upTo(5), listed = upTo(i); i > 0; --i, --listed) {
      scenario.humans.push_back(human(scenario, listed > 0));
    }
    for (int i = upTo(2), listed = upTo(i); i > 0; --i, --listed) {
      scenario.robots.push_back(robot(i, listed > 0));
    }
    for (int i = upTo(3), listed = upTo(i); i > 0; --i, --listed) {
      scenario.obstacles.push_back(obstacle(i, listed > 0));
    }
    for (int i = upTo(2), listed = upTo(i); i > 0; --i, --listed) {
      scenario.doors.push_back(door(i, listed > 0));
    }
    for (int i = upTo(2), listed = upTo(i); i > 0; --i, --listed) {
      scenario.areas.push_back(area(i, listed > 0));
    }
    for (int i = upTo(2), listed = upTo(i); i > 0; --i, --listed) {
      scenario.docks.push_back(dock(i, listed > 0));
    }
    scenario.desktop = desktop();
    scenario.unknown = unknown();
    if (flip()) {
      scenario.otherNodes = {{"other_node", "ros__parameters:\n  rate: 1.50"}};
    }
    return scenario;
  }

 private:
  bool flip() { return upTo(1) == 1; }
  int upTo(int most) {
    return static_cast<int>(rng_.bits(base::DrawPurpose::Test, ++draw_) %
                            static_cast<unsigned>(most + 1));
  }
  double real() {
    const double value = rng_.normal(0.0, 20.0, base::DrawPurpose::Test, ++draw_);
    return flip() ? value : static_cast<double>(static_cast<int>(value * 10.0)) / 10.0;
  }
  double size() { return std::abs(real()) + 0.01; }
  sim2d::Vec2 point() {
    const double x = real();
    return {x, real()};
  }
  std::vector<double> sizes(int count) {
    std::vector<double> values;
    for (; count > 0; --count) {
      values.push_back(size());
    }
    return values;
  }
  std::vector<sim2d::Vec2> points(int count) {
    std::vector<sim2d::Vec2> values;
    for (; count > 0; --count) {
      values.push_back(point());
    }
    return values;
  }
  template <class T, class Make>
  void maybe(std::optional<T>& to, Make make) {
    if (flip()) {
      to = make();
    }
  }
  std::string word() {
    static const std::vector<std::string> kWords = {
        "plain", "on",          "No",       "1e3",        "0x1F",  "010",       "1.5",
        ".5",    "~",           "null",     "two words",  "a: b",  "a #b",      "#x",
        "- x",   "-",           "x:",       "'q'",        "\"q\"", "tab  here", "line  break",
        "ü €",   "yes",         "12:30:45", "2001-01-01", "<<",    "=",         "*x",
        "&x",    "!x",          "%x",       "@x",         "`x",    "[x]",       "{x}",
        "a,b",   "back\\slash", " blank ",  "1_000",      "+1",    "-.inf",     "NaN",
        "y",     "true",        "?"};
    return kWords[static_cast<std::size_t>(upTo(static_cast<int>(kWords.size()) - 1))];
  }
  sim2d::UnknownKeys unknown() {
    static const std::vector<std::string> kTexts = {
        "1", "0.10", "\"on\"", "plain text", "a: 1\nb:\n  - x\n  - \"1\"", "[]", "- 1\n- 2"};
    sim2d::UnknownKeys keys;
    if (upTo(3) == 0) {
      keys.push_back({"strange", kTexts[static_cast<std::size_t>(upTo(6))]});
    }
    return keys;
  }
  sim2d::Behavior behavior() {
    sim2d::Behavior to;
    if (upTo(5) > 0) {
      to.type = static_cast<sim2d::BehaviorType>(1 + upTo(5));
    } else if (flip()) {
      to.type = sim2d::BehaviorType::Regular;
      to.unknownType = flip() ? "Happy" : "9";
    }
    maybe(to.configuration, [&] { return static_cast<sim2d::Configuration>(upTo(3)); });
    for (auto* value : {&to.dist, &to.duration, &to.safeDistance, &to.stopDist, &to.frontDist,
                        &to.goalForceFactor, &to.obstacleForceFactor, &to.socialForceFactor,
                        &to.otherForceFactor}) {
      maybe(*value, [&] { return size(); });
    }
    maybe(to.vel, [&] { return size() / 20.0; });
    maybe(to.once, [&] { return flip(); });
    to.unknown = unknown();
    return to;
  }
  sim2d::Human human(const sim2d::Scenario& scenario, bool listed) {
    sim2d::Human to;
    const auto number = std::to_string(scenario.humans.size());
    to.name = flip() ? "agent" + number : word() + " " + number + "x";
    to.id = static_cast<int>(scenario.humans.size()) + upTo(1) * 10;
    to.listed = listed;
    maybe(to.groupId, [&] { return upTo(5) - 1; });
    maybe(to.skin, [&] { return upTo(12); });
    maybe(to.maxVel, [&] { return size() / 20.0; });
    maybe(to.radius, [&] { return size() / 20.0; });
    maybe(to.goalRadius, [&] { return size(); });
    maybe(to.cyclicGoals, [&] { return flip(); });
    // a block without one of these two would not be taken for a person when it is not listed
    to.initPose = {point(), real()};
    maybe(to.initZ, [&] { return real(); });
    to.initPoseUnknown = unknown();
    to.behavior = behavior();
    for (int i = upTo(3); i > 0; --i) {
      to.goals.push_back(1 + upTo(9));
    }
    if (scenario.goals.empty()) {
      to.goals.clear();
    }
    to.unknown = unknown();
    if (flip()) {
      to.ours = person();
    }
    return to;
  }
  sim2d::PersonExtension person() {
    sim2d::PersonExtension to;
    maybe(to.startTime, [&] { return flip() ? 0.0 : size(); });
    maybe(to.kind, [&] { return static_cast<sim2d::PersonKind>(upTo(4)); });
    maybe(to.mass, [&] { return flip() ? 80.0 : size(); });
    maybe(to.model, [&] { return flip() ? std::string("sfm") : word(); });
    maybe(to.route, [&] { return static_cast<sim2d::Route>(upTo(1)); });
    maybe(to.atEnd, [&] { return static_cast<sim2d::AtEnd>(upTo(2)); });
    to.wait = sizes(upTo(3));
    maybe(to.tree, [&] { return word(); });
    to.unknown = unknown();
    return to;
  }
  sim2d::Robot robot(int number, bool listed) {
    sim2d::Robot to;
    to.name = "robot" + std::to_string(number);
    to.listed = listed;
    maybe(to.type, [&] { return flip() ? std::string("generic") : word(); });
    maybe(to.planner, [&] { return flip() ? std::string("pursuit") : word(); });
    maybe(to.command, [&] { return word(); });
    if (flip()) {
      to.plannerParameters = {{"lookahead", "0.80"}, {"on", "\"text\""}};
    }
    to.nav2Params.resize(static_cast<std::size_t>(upTo(2)));
    for (std::size_t i = 0; i < to.nav2Params.size(); ++i) {
      to.nav2Params[i] = word() + std::to_string(i);  // each once
    }
    maybe(to.nav2Body, [&] { return flip(); });
    maybe(to.nav2Tree, [&] { return word(); });
    maybe(to.nav2Distro, [&] { return static_cast<sim2d::nav2::Distro>(upTo(2)); });
    maybe(to.nav2Topics, [&] { return word(); });
    if (flip()) {
      to.nav2Values = {{"FollowPath.temperature", "0.2"},
                       {"FollowPath.critics", "- A\n- B"},
                       {"local_costmap.width", "3"}};
    }
    to.start = {point(), real()};
    if (flip()) {
      to.goal.point = point();
    } else {
      to.goal.goals = {1, 2 + upTo(3)};
    }
    for (auto* value : {&to.goalRadius, &to.startTime, &to.radius, &to.mass, &to.maxVel, &to.maxAcc,
                        &to.maxOmega, &to.maxAlpha}) {
      maybe(*value, [&] { return flip() ? 1.0 : size(); });
    }
    if (flip()) {
      to.footprintX = sizes(4);
      to.footprintY = sizes(4);
    }
    maybe(to.kinematics, [&] { return static_cast<sim2d::Kinematics>(upTo(2)); });
    maybe(to.turningRadius, [&] { return size(); });
    to.lidar = lidar();
    to.detector = detector();
    to.odometryNoise = odometry();
    to.localization = localization();
    to.battery = battery();
    to.unknown = unknown();
    return to;
  }
  double share() { return upTo(10) / 10.0; }
  sim2d::BatterySettings battery() {
    sim2d::BatterySettings to;
    if (flip()) {
      return to;
    }
    maybe(to.level, [&] { return share(); });
    for (auto* value : {&to.capacity, &to.idlePower, &to.motionPower, &to.chargePower,
                        &to.emptyVoltage, &to.fullVoltage}) {
      maybe(*value, [&] { return size(); });
    }
    to.unknown = unknown();
    return to;
  }
  sim2d::LidarSettings lidar() {
    sim2d::LidarSettings to;
    if (flip()) {
      return to;
    }
    maybe(to.beams, [&] { return upTo(720); });
    for (auto* value : {&to.range, &to.rate, &to.noise}) {
      maybe(*value, [&] { return size() / 2.0; });
    }
    for (auto* value : {&to.angleMin, &to.angleMax, &to.x, &to.y, &to.h}) {
      maybe(*value, [&] { return flip() ? 0.0 : share() - 0.5; });
    }
    maybe(to.legs, [&] { return flip(); });
    maybe(to.record, [&] { return flip(); });
    to.unknown = unknown();
    return to;
  }
  sim2d::DetectorSettings detector() {
    sim2d::DetectorSettings to;
    if (flip()) {
      return to;
    }
    maybe(to.kind, [&] { return static_cast<sim2d::DetectorKind>(upTo(1)); });
    maybe(to.range, [&] { return flip() ? 10.0 : size(); });
    for (auto* value : {&to.field, &to.latency, &to.misses, &to.swaps, &to.maxOcclusion}) {
      maybe(*value, [&] { return 0.01 + share() * 0.9; });
    }
    for (auto* value : {&to.rate, &to.noise, &to.swapDistance, &to.coastTime}) {
      maybe(*value, [&] { return flip() ? 0.0 : size() / 2.0; });
    }
    maybe(to.occlusion, [&] { return flip(); });
    maybe(to.velocities, [&] { return static_cast<sim2d::TrackVelocities>(upTo(1)); });
    maybe(to.accelerationNoise, [&] { return flip() ? 0.5 : size(); });
    to.unknown = unknown();
    return to;
  }
  sim2d::LocalizationSettings localization() {
    sim2d::LocalizationSettings to;
    if (flip()) {
      return to;
    }
    for (auto* value :
         {&to.stdX, &to.stdY, &to.stdYaw, &to.correlationTime, &to.jumpRate, &to.jumpDistance,
          &to.jumpYaw, &to.rate, &to.initialPoseTime, &to.globalStd, &to.globalStdYaw}) {
      maybe(*value, [&] { return share(); });
    }
    for (auto* value : {&to.startX, &to.startY, &to.startYaw}) {
      maybe(*value, [&] { return share() - 0.5; });
    }
    to.unknown = unknown();
    return to;
  }
  sim2d::OdometrySettings odometry() {
    sim2d::OdometrySettings to;
    if (flip()) {
      return to;
    }
    for (auto* value : {&to.alpha1, &to.alpha2, &to.alpha3, &to.alpha4}) {
      maybe(*value, [&] { return share(); });
    }
    maybe(to.drift, [&] { return share() - 0.5; });
    to.unknown = unknown();
    return to;
  }
  sim2d::Obstacle obstacle(int number, bool listed) {
    sim2d::Obstacle to;
    to.name = "obstacle" + std::to_string(number);
    to.listed = listed;
    to.kind = static_cast<sim2d::ObstacleKind>(upTo(3));
    if (to.kind == sim2d::ObstacleKind::Box) {
      to.pose = {point(), real()};
      to.length = size();
      to.width = size();
    } else if (to.kind == sim2d::ObstacleKind::Circle) {
      to.pose.position = point();
      to.radius = size();
    } else {
      to.points = points(3 + upTo(2));
    }
    if (to.kind == sim2d::ObstacleKind::Wall) {
      maybe(to.thickness, [&] { return flip() ? 0.1 : size(); });
    }
    to.unknown = unknown();
    return to;
  }
  sim2d::Door door(int number, bool listed) {
    sim2d::Door to;
    to.name = "door" + std::to_string(number);
    to.listed = listed;
    to.from = point();
    to.to = point();
    maybe(to.thickness, [&] { return flip() ? 0.05 : size(); });
    maybe(to.open, [&] { return flip(); });
    to.toggles = sizes(upTo(3));
    to.unknown = unknown();
    return to;
  }
  sim2d::Area area(int number, bool listed) {
    sim2d::Area to;
    to.name = "area" + std::to_string(number);
    to.listed = listed;
    to.kind = static_cast<sim2d::AreaKind>(upTo(3));
    to.points = points(3 + upTo(2));
    maybe(to.like, [&] { return word(); });
    maybe(to.rate, [&] { return size(); });
    maybe(to.from, [&] { return flip() ? 0.0 : size(); });
    maybe(to.until, [&] { return size(); });
    maybe(to.count, [&] { return upTo(100); });
    to.unknown = unknown();
    return to;
  }
  sim2d::Dock dock(int number, bool listed) {
    sim2d::Dock to;
    to.name = "dock" + std::to_string(number);
    to.listed = listed;
    to.kind = static_cast<sim2d::DockKind>(upTo(1));
    to.pose = {point(), share()};
    to.unknown = unknown();
    return to;
  }
  sim2d::VariationSettings variation() {
    sim2d::VariationSettings to;
    maybe(to.preset, [&] { return static_cast<sim2d::VariationPreset>(upTo(2)); });
    for (std::size_t i = 0; i < sim2d::kVariedCount; ++i) {
      sim2d::SpreadSettings& spread = to.spreads[i];
      const bool isFactor = sim2d::variationInfo(static_cast<sim2d::VariationQuantity>(i)).isFactor;
      if (upTo(3) == 0) {
        maybe(spread.kind, [&] { return static_cast<sim2d::SpreadKind>(upTo(2)); });
        maybe(spread.sd, [&] { return size(); });
        maybe(spread.halfWidth, [&] { return size(); });
        maybe(spread.min, [&] { return isFactor ? 0.25 * (1 + upTo(3)) : -size(); });
        maybe(spread.max, [&] { return 1.0 + upTo(3); });
        spread.unknown = unknown();
      }
    }
    to.unknown = unknown();
    return to;
  }
  sim2d::DesktopSettings desktop() {
    sim2d::DesktopSettings to;
    if (upTo(3) == 0) {
      return to;
    }
    maybe(to.mapFile, [&] { return word(); });
    maybe(to.mapRule, [&] { return std::string(flip() ? "humble" : "main"); });
    maybe(to.seed, [&] { return upTo(3) == 0 ? 9000000000000000LL : upTo(2); });
    maybe(to.duration, [&] { return size(); });
    maybe(to.stopOnCollision, [&] { return static_cast<sim2d::StopOnCollision>(upTo(2)); });
    maybe(to.stuckAfter, [&] { return flip() ? 0.0 : size(); });
    maybe(to.dt, [&] { return flip() ? 0.05 : 0.02; });
    maybe(to.recordEvery, [&] { return 1 + upTo(3); });
    maybe(to.model, [&] { return flip() ? std::string("sfm") : word(); });
    maybe(to.route, [&] { return static_cast<sim2d::Route>(upTo(1)); });
    maybe(to.obstaclePoints, [&] { return static_cast<sim2d::ObstaclePoints>(upTo(1)); });
    maybe(to.loopTrees, [&] { return flip(); });
    if (flip()) {
      to.wrapX = {-size(), size() + 1.0};  // a metre at least
    }
    if (flip()) {
      to.modelParameters = {{"orca", {{"horizon", "2.50"}, {"range", "4.0"}}},
                            {"das", {{"a", "1"}}}};
    }
    if (flip()) {
      to.groups = {{upTo(3), word()}, {5, word()}};
    }
    to.variation = variation();
    sim2d::MetricsSettings& metrics = to.metrics;
    maybe(metrics.from, [&] { return std::string(flip() ? "begin" : "event contact"); });
    maybe(metrics.until, [&] { return std::string(flip() ? "end" : "time 3.5"); });
    maybe(metrics.frequency, [&] { return flip() ? 0.0 : size(); });
    maybe(metrics.tag, [&] { return word(); });
    maybe(metrics.runId, [&] { return upTo(3); });
    maybe(metrics.file, [&] { return word(); });
    if (flip()) {
      metrics.parameters = {{"one", real()}, {"two", real()}};
    }
    metrics.unknown = unknown();
    to.unknown = unknown();
    if (!to.unknown.empty()) {
      to.unknown[0].key = "strange_setting";
    }
    return to;
  }

  base::AgentRng rng_;
  std::uint32_t draw_ = 0;
};

}  // namespace scenariotest
