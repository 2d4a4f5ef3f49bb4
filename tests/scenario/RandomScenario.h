#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sim2d/base/Rng.h"
#include "sim2d/scenario/Fields.h"

/// Scenarios with random contents, for properties that hold for every scenario. Values of keys come
/// from the field tables.
namespace scenariotest {

class RandomScenario {
 public:
  explicit RandomScenario(std::uint64_t seed) : rng_(seed, 0) {}

  sim2d::Scenario make() {
    sim2d::Scenario scenario;
    fill<sim2d::ScenarioSettings>(scenario);
    fillDesktop();
    scenario.desktop = desktop_;
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
    addEntities(scenario.robots, "robot", 2, [this](sim2d::Robot& to) { fillRobot(to); });
    addEntities(scenario.obstacles, "obstacle", 3, [this](sim2d::Obstacle& to) {
      const bool hasCorners =
          to.kind == sim2d::ObstacleKind::Polygon || to.kind == sim2d::ObstacleKind::Wall;
      to.points = points(hasCorners ? 3 + upTo(2) : 0);
    });
    addEntities(scenario.doors, "door", 2, [](sim2d::Door&) {});
    addEntities(scenario.areas, "area", 2,
                [this](sim2d::Area& to) { to.points = points(3 + upTo(2)); });
    addEntities(scenario.docks, "dock", 2, [](sim2d::Dock&) {});
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
  double within(const base::Range& range) {
    const double low = std::max(range.low, -50.0);
    const double high = std::min(range.high, 50.0);
    const double value = rng_.uniform(low, high, base::DrawPurpose::Test, ++draw_);
    const double rounded = std::round(value * 10.0) / 10.0;
    return flip() && range.contains(rounded) ? rounded : value;
  }
  sim2d::Vec2 point() {
    const double x = real();
    return {x, real()};
  }
  std::vector<double> numbers(int count, const base::Range& range) {
    std::vector<double> values;
    for (; count > 0; --count) {
      values.push_back(within(range));
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
  sim2d::ParameterValue valueOf(const sim2d::ParameterSpec& spec, bool is64Bit) {
    switch (spec.type) {
      case sim2d::ParameterType::Boolean:
        return flip();
      case sim2d::ParameterType::Integer:
        return is64Bit && upTo(3) == 0 ? 9000000000000000LL
                                       : std::llround(std::max(spec.range.low, -1.0)) + upTo(720);
      case sim2d::ParameterType::Number:
        return within(spec.range);
      case sim2d::ParameterType::Numbers:
        return numbers(upTo(3), spec.range);
      default:
        break;
    }
    const int last = static_cast<int>(spec.choices.size()) - 1;
    return last < 0 ? word() : spec.choices[static_cast<std::size_t>(upTo(last))];
  }
  /// The keys without a reader of their own: required ones always, of the others about a half, of
  /// these a part with their default.
  template <class T>
  void fill(T& to) {
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
      if (field.isStructure() || field.read || !field.belongsTo(to) ||
          (!field.required && flip())) {
        continue;
      }
      const sim2d::ParameterValue usual = field.fallback(to, desktop_);
      const bool isUsual = usual != sim2d::ParameterValue() && flip();
      field.assign(to, isUsual ? usual : valueOf(field.spec, field.is64Bit));
    }
  }
  template <class T>
  void fillObject(T& to) {
    fill(to);
    to.unknown = unknown();
  }
  template <class T, class More>
  void addEntities(std::vector<T>& to, const std::string& name, int most, More more) {
    for (int i = upTo(most), listed = upTo(i); i > 0; --i, --listed) {
      T& entity = to.emplace_back();
      entity.name = name + std::to_string(i);
      entity.listed = listed > 0;
      fillObject(entity);
      more(entity);
    }
  }
  sim2d::Human human(const sim2d::Scenario& scenario, bool listed) {
    sim2d::Human to;
    fillObject(to);
    const auto number = std::to_string(scenario.humans.size());
    to.name = flip() ? "agent" + number : word() + " " + number + "x";
    to.id = static_cast<int>(scenario.humans.size()) + upTo(1) * 10;
    to.listed = listed;
    // a block without one of these two would not be taken for a person when it is not listed
    to.initPose = {point(), real()};
    if (flip()) {
      to.initZ = real();
    }
    to.initPoseUnknown = unknown();
    fillObject(to.behavior);
    if (upTo(5) > 0) {
      to.behavior.type = static_cast<sim2d::BehaviorType>(1 + upTo(5));
    } else if (flip()) {
      to.behavior.type = sim2d::BehaviorType::Regular;
      to.behavior.unknownType = flip() ? "Happy" : "9";
    }
    if (flip()) {
      to.behavior.configuration = static_cast<sim2d::Configuration>(upTo(3));
    }
    for (int i = scenario.goals.empty() ? 0 : upTo(3); i > 0; --i) {
      to.goals.push_back(1 + upTo(9));
    }
    if (flip()) {
      fillObject(to.ours);
    }
    return to;
  }
  void fillRobot(sim2d::Robot& to) {
    if (flip()) {
      to.plannerParameters = {{"lookahead", "0.80"}, {"on", "\"text\""}};
    }
    to.nav2Params.resize(static_cast<std::size_t>(upTo(2)));
    for (std::size_t i = 0; i < to.nav2Params.size(); ++i) {
      to.nav2Params[i] = word() + std::to_string(i);  // each once
    }
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
    const int corners = flip() ? 4 : 0;
    to.footprintX = numbers(corners, {0.01, 50.0});
    to.footprintY = numbers(corners, {0.01, 50.0});
    const auto sometimes = [this](auto& sensor) {
      if (flip()) {
        fillObject(sensor);
      }
    };
    sometimes(to.lidar);
    sometimes(to.detector);
    sometimes(to.odometryNoise);
    sometimes(to.localization);
    sometimes(to.battery);
  }
  void fillDesktop() {
    sim2d::DesktopSettings& to = desktop_;
    if (upTo(3) == 0) {
      return;
    }
    fillObject(to);
    if (!to.unknown.empty()) {
      to.unknown[0].key = "strange_setting";
    }
    if (flip()) {
      to.wrapX = {-within({0.01, 50.0}), within({1.01, 50.0})};  // a metre at least
    }
    if (flip()) {
      to.modelParameters = {{"orca", {{"horizon", "2.50"}, {"range", "4.0"}}},
                            {"das", {{"a", "1"}}}};
    }
    if (flip()) {
      to.groups = {{upTo(3), word()}, {5, word()}};
    }
    fillObject(to.card);
    to.card.unknown = unknown();
    fillObject(to.variation);
    for (sim2d::SpreadSettings& spread : to.variation.spreads) {
      spread.unknown = unknown();
    }
    fillObject(to.metrics);
    if (flip()) {
      to.metrics.from = flip() ? "begin" : "event contact";
      to.metrics.until = flip() ? "end" : "time 3.5";
    }
    if (flip()) {
      to.metrics.parameters = {{"one", real()}, {"two", real()}};
    }
  }

  base::AgentRng rng_;
  std::uint32_t draw_ = 0;
  sim2d::DesktopSettings desktop_;
};

}  // namespace scenariotest
