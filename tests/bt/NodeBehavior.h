#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "tests/bt/ScriptedNavigator.h"

/// The table tests/data/nav2/node_behavior.txt: what each node of navigator trees does, and in
/// which it depends on its ports. Its head describes the columns.
namespace nodebehavior {

using namespace navigator;

/// Attributes of a node: key and value, in order.
using Ports = std::vector<std::pair<std::string, std::string>>;

struct Row {
  std::string node, branch, portText, scene, children, expected;
  Ports ports;
  int line = 0;
};

inline Ports portsIn(const std::string& text) {
  Ports ports;
  for (std::size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string::npos;) {
    const std::size_t quote = text.find("=\"", at), end = text.find('"', quote + 2);
    ports.emplace_back(text.substr(at, quote - at), text.substr(quote + 2, end - quote - 2));
    at = end + 1;
  }
  return ports;
}

/// The rows; a cell of one quotation mark repeats that of the row before.
inline std::vector<Row> rowsIn(const std::string& text) {
  std::vector<Row> rows;
  std::vector<std::string> before(6);
  int number = 0;
  for (const std::string& line : base::split(text, '\n')) {
    ++number;
    if (line.empty() || line.front() == '#') {
      continue;
    }
    std::vector<std::string> cells = base::split(line, '|');
    cells.resize(before.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] = base::trimmed(cells[i]);
      cells[i] = cells[i] == "\"" ? before[i] : cells[i];
    }
    rows.push_back(
        {cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], portsIn(cells[2]), number});
    before = std::move(cells);
  }
  return rows;
}

inline std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : base::split(text, ' ')) {
    if (const auto number = base::parseDouble(word)) {
      numbers.push_back(*number);
    }
  }
  return numbers;
}

/// "x y", "x y heading"; several separated by ','.
inline Path posesIn(const std::string& text) {
  Path poses;
  for (const std::string& pose : base::split(text, ',')) {
    std::vector<double> numbers = numbersIn(pose);
    numbers.resize(3, 0.0);
    poses.push_back({{numbers[0], numbers[1]}, numbers[2]});
  }
  return poses;
}

/// The same text of poses, headings to a thousandth; 0 is left out.
inline std::string textOf(const Path& path) {
  std::vector<std::string> poses;
  for (const base::Pose2& pose : path) {
    const double rounded = std::round(1e3 * pose.heading) / 1e3;
    const std::string heading = rounded == 0.0 ? "" : " " + base::formatDouble(rounded);
    poses.push_back(base::formatDouble(pose.position.x()) + " " +
                    base::formatDouble(pose.position.y()) + heading);
  }
  return poses.empty() ? "none" : base::join(poses, ", ");
}

inline std::string textOf(const bt::Waypoints& waypoints) {
  std::string letters;
  for (const bt::Waypoint& each : waypoints) {
    letters += "PCSF"[static_cast<int>(each.status)];
  }
  return letters;
}

/// A costmap of single costs by x, where `local` and `footprint` select others; absent: 0.
struct Costs {
  std::map<double, std::uint8_t> at, inLocal, ofFootprint, inLayer;
  static std::uint8_t find(const std::map<double, std::uint8_t>& costs, double x) {
    const auto found = costs.find(x);
    return found == costs.end() ? std::uint8_t{0} : found->second;
  }
};

/// A scripted navigator whose log has requests with all that differs from a plain one.
class Recording : public Scripted {
 public:
  explicit Recording(Distro distro) : Scripted(distro) {}

  Costs costmap;
  double width = 100.0;  // poses beyond are off the map [m]
  base::Pose2 placeInOdom;
  double duration = 0.0;    // of finished actions [s]
  bool isCompleted = true;  // smoothing
  int retries = 0;          // docking
  bool acceptsClears = true;

  base::Pose2 poseIn(const std::string& frame) const override {
    return bt::bareName(frame) == "odom" ? placeInOdom : place;
  }
  std::optional<std::uint8_t> costAt(bool isLocal, const base::Pose2& pose,
                                     bool usesFootprint) const override {
    const double x = pose.position.x();
    if (x > width) {
      return std::nullopt;
    }
    return Costs::find(isLocal         ? costmap.inLocal
                       : usesFootprint ? costmap.ofFootprint
                                       : costmap.at,
                       x);
  }
  /// As the service is_path_valid: 254 blocks, 255 is unknown.
  bt::PathCheckResult checkPath(const bt::PathCheck& check) const override {
    const Path& path = paths().get(check.path);
    const auto& grid = !check.layer.empty()       ? costmap.inLayer
                       : !check.footprint.empty() ? costmap.ofFootprint
                                                  : costmap.at;
    bt::PathCheckResult result;
    for (const base::Pose2& pose : path) {
      const int cost = Costs::find(grid, pose.position.x());
      const bool isAhead =
          check.lookahead < 0.0 || pose.position.x() - path.front().position.x() <= check.lookahead;
      const bool isBlocked = cost == 255 ? check.unknownBlocks : cost >= check.maxCost;
      if (isAhead && isBlocked && (result.collisions.empty() || !check.stopsAtFirst)) {
        result.collisions.push_back(pose);
      }
    }
    result.isValid = !path.empty() && result.collisions.empty();
    return result;
  }
  void begin(RobotAction action, const bt::RobotRequest& request) override {
    Scripted::begin(action, request);
    log.back() += "(" + base::join(detailsOf(action, request), "; ") + ")";
  }
  bt::RobotOutcome outcome(RobotAction action) const override {
    bt::RobotOutcome result = Scripted::outcome(action);
    result.duration = duration;
    result.wasCompleted = isCompleted;
    result.retries = retries;
    result.path = action == RobotAction::ComputeAndTrackRoute ? progress.route : result.path;
    return result;
  }
  void cancel(RobotAction action) override {
    Scripted::cancel(action);
    log.back() += std::string("-") + kActionNames.at(static_cast<std::size_t>(action));
  }
  bool clear(const bt::ClearRequest& request) override {
    static constexpr std::array<const char*, 4> kExtents = {"entire", "around", "except", "pose"};
    Scripted::clear(request);
    std::vector<std::string> details = {kExtents.at(static_cast<std::size_t>(request.extent))};
    add(details, "side ", request.distance, 1.0);
    add(details, "at ", request.pose ? nodebehavior::textOf({*request.pose}) : std::string());
    add(details, "layers ", request.plugins);
    log.back() += "(" + base::join(details, "; ") + ")";
    return acceptsClears;
  }

 private:
  using Details = std::vector<std::string>;
  static void add(Details& details, const char* name, const std::string& text) {
    if (!text.empty()) {
      details.push_back(name + text);
    }
  }
  static void add(Details& details, const char* name, double value, double usual = 0.0) {
    if (value != usual) {
      details.push_back(name + base::formatDouble(value));
    }
  }
  void addPath(Details& details, const char* name, bt::PathId path) const {
    if (path != 0) {
      details.push_back(name + nodebehavior::textOf(paths().get(path)));
    }
  }

  Details detailsOf(RobotAction action, const bt::RobotRequest& request) const {
    Details details;
    addPath(details, "to ", request.path);
    addPath(details, "from ", request.start.value_or(0));
    addPath(details, "via ", request.viaPoints);
    add(details, "by ", request.server);
    add(details, "goal checker ", request.goalChecker);
    add(details, "progress checker ", request.progressChecker);
    add(details, "path handler ", request.pathHandler);
    add(details, "", request.amount);
    add(details, "speed ", request.speed);
    add(details, "within ", request.timeAllowance);
    add(details, "", request.checksCollisions ? "checked" : "");
    add(details, "", request.ignoresCollisions ? "unchecked" : "");
    add(details, "tree ", request.tree);
    add(details, "nodes ",
        request.usesPoses
            ? ""
            : base::formatDouble(request.startId) + "-" + base::formatDouble(request.goalId));
    add(details, "topic ", request.object.topic);
    add(details, "frame ", request.object.frame);
    if (action == RobotAction::DockRobot || action == RobotAction::UndockRobot) {
      add(details, "id ", request.dock.usesDockId ? request.dock.dockId : "-");
      add(details, "type ", request.dock.type);
      add(details, "staging ", request.dock.maxStagingTime, 1000.0);
      add(details, "", request.dock.navigatesToStaging ? "" : "direct");
    }
    return details;
  }
};

/// The number of ticks of an expected text: "RS20" is 21.
inline int ticksIn(const std::string& expected) {
  const std::string word = base::split(expected, ' ').front();
  int ticks = 0;
  for (std::size_t i = 0; i < word.size();) {
    char* end = nullptr;
    const long count = std::strtol(word.c_str() + i + 1, &end, 10);
    ticks += count == 0 ? 1 : static_cast<int>(count);
    i = static_cast<std::size_t>(end - word.c_str());
  }
  return ticks;
}

/// The XML of a row's node with its children, in the tree that the row has around it.
inline std::string xmlOf(const Row& row) {
  const std::size_t in = row.children.find("in <");
  const std::string children = row.children.substr(0, in);
  const std::string node =
      "<" + row.node + " " + row.portText + ">" + children + "</" + row.node + ">";
  if (in == std::string::npos) {
    return node;
  }
  std::string tree = row.children.substr(in + 3);
  const std::size_t place = tree.find('@');
  return place == std::string::npos ? std::string() : tree.replace(place, 1, node);
}

/// A row, played: its scene, its ticks and what came of it as text.
class Trial {
 public:
  Trial(const Row& row, Distro distro) : row_(row), played_(xmlOf(row), distro) {}

  const base::Diagnostics& problems() const { return played_.problems; }
  /// Words of the scene that mean nothing.
  const std::string& mistakes() const { return mistakes_; }

  /// As many ticks as the expected text has statuses.
  std::string outcome() {
    const int ticks = ticksIn(row_.expected);
    std::string statuses;
    int count = 0;
    char last = 0;
    const auto finish = [&] {
      statuses += last == 0 ? "" : last + (count > 1 ? std::to_string(count) : std::string());
    };
    for (int tick = 1; tick <= ticks; ++tick) {
      set(tick);
      const char letter = "IRSFK"[static_cast<int>(played_.tick())];
      if (letter != last) {
        finish();
        count = 0;
      }
      last = letter;
      ++count;
    }
    finish();
    const std::string log = played_.host.text();
    return statuses + (log.empty() ? "" : " ") + log + recoveries() + outputs();
  }

 private:
  /// Executes the statements of the scene for that tick; those without "@TICK" are for the first.
  void set(int tick) {
    for (const std::string& part : base::split(row_.scene, ';')) {
      std::string statement = base::trimmed(part);
      int when = 1;
      if (!statement.empty() && statement.front() == '@') {
        const std::size_t space = statement.find(' ');
        when = std::atoi(statement.substr(1, space).c_str());
        statement = base::trimmed(statement.substr(space));
      }
      if (when == tick && !statement.empty()) {
        apply(statement);
      }
    }
  }

  void apply(const std::string& statement) {
    const std::size_t equals = statement.find('='), space = statement.find(' ');
    if (equals < space) {
      setEntry(statement.substr(0, equals), statement.substr(equals + 1));
      return;
    }
    const std::string word = statement.substr(0, space);
    const std::string rest = space == std::string::npos ? "" : statement.substr(space + 1);
    const auto found = words().find(word);
    if (found == words().end()) {
      mistakes_ += word + " ";
    } else {
      found->second(*this, rest);
    }
  }

  using Word = std::function<void(Trial&, const std::string&)>;
  static const std::map<std::string, Word>& words() {
    static const std::map<std::string, Word> kWords = {
        {"at", [](Trial& t, const std::string& s) { t.place(posesIn(s).front()); }},
        {"odom", [](Trial& t, const std::string& s) { t.host().placeInOdom = posesIn(s).front(); }},
        {"speed", [](Trial& t, const std::string& s) { t.host().driven = numbersIn(s).at(0); }},
        {"braking", [](Trial& t, const std::string& s) { t.host().braking = numbersIn(s).at(0); }},
        {"cost", [](Trial& t, const std::string& s) { t.setCost(s); }},
        {"width", [](Trial& t, const std::string& s) { t.host().width = numbersIn(s).at(0); }},
        {"length", [](Trial& t, const std::string& s) { t.host().nextLength = numbersIn(s)[0]; }},
        {"topics", [](Trial& t, const std::string& s) { t.publish(s); }},
        {"answer", [](Trial& t, const std::string& s) { t.setAnswers(s); }},
        {"battery", [](Trial& t, const std::string& s) { t.setBattery(numbersIn(s)); }},
        {"tracked", [](Trial& t, const std::string& s) { t.track(numbersIn(s)); }},
        {"unlocalized", [](Trial& t, const std::string&) { t.host().hasPose = false; }},
        {"localized", [](Trial& t, const std::string&) { t.host().hasPose = true; }},
        {"no-localizer", [](Trial& t, const std::string&) { t.host().hasLocalizer = false; }},
        {"frames", [](Trial& t, const std::string& s) { t.host().frames.onRobot = {s}; }},
        {"reached", [](Trial& t, const std::string& s) { t.host().lastReached = t.number(s); }},
        {"retries", [](Trial& t, const std::string& s) { t.host().retries = t.number(s); }},
        {"took", [](Trial& t, const std::string& s) { t.host().duration = numbersIn(s).at(0); }},
        {"incomplete", [](Trial& t, const std::string&) { t.host().isCompleted = false; }},
        {"refusing", [](Trial& t, const std::string&) { t.host().acceptsClears = false; }},
        {"progress", [](Trial& t, const std::string& s) { t.setProgress(numbersIn(s)); }},
        {"halt", [](Trial& t, const std::string&) { t.halt(); }}};
    return kWords;
  }

  Recording& host() { return played_.host; }
  static int number(const std::string& text) { return static_cast<int>(numbersIn(text).at(0)); }
  void place(const base::Pose2& pose) { host().place = host().placeInOdom = pose; }
  void halt() { played_.state->halt({played_.step, 0.05, &played_.host}); }

  /// A path; "none"; "pending" for the waypoints of the goals; or text or a number after "value ".
  void setEntry(const std::string& name, const std::string& text) {
    const int slot = played_.program->findSlot(name);
    if (slot < 0) {
      return;  // rows of a node share their scene
    }
    if (base::startsWith(text, "value ")) {
      played_.state->setFromText(name, text.substr(6));
    } else if (text == "none") {
      played_.state->set(slot, 0);
    } else if (base::startsWith(text, "pending ")) {
      bt::Waypoints waypoints;
      for (const base::Pose2& pose : posesIn(text.substr(8))) {
        waypoints.push_back({pose, bt::Waypoint::Status::Pending});
      }
      played_.state->set(slot, static_cast<int>(host().waypoints().add(waypoints)));
    } else {
      played_.state->set(slot, static_cast<int>(host().paths().add(posesIn(text))));
    }
  }

  /// "X COST", or only of the "local" costmap, for a "footprint", or of a "layer".
  void setCost(const std::string& text) {
    const std::vector<double> numbers = numbersIn(text);
    const auto cost = static_cast<std::uint8_t>(numbers.at(1));
    Costs& costs = host().costmap;
    const std::map<std::string, std::vector<std::map<double, std::uint8_t>*>> parts = {
        {"local", {&costs.inLocal}},
        {"footprint", {&costs.ofFootprint}},
        {"layer", {&costs.inLayer}},
        {"centre", {&costs.at}}};
    const auto part = parts.find(base::split(text, ' ').front());
    const auto all = std::vector<std::map<double, std::uint8_t>*>{
        &costs.at, &costs.inLocal, &costs.ofFootprint, &costs.inLayer};
    for (auto* const grid : part == parts.end() ? all : part->second) {
      (*grid)[numbers[0]] = cost;
    }
  }

  /// Messages separated by ',' instead of ';'; poses by '+' instead of ','.
  void publish(std::string text) {
    std::replace(text.begin(), text.end(), ',', ';');
    std::replace(text.begin(), text.end(), '+', ',');
    const auto topics = bt::NavigatorTopics::read(text);
    mistakes_ += topics ? "" : "topics ";
    host().topics = topics ? *topics : bt::NavigatorTopics();
  }

  /// "spin S2 F1:703": the first ends after two ticks, the next ones fail after one; S0 never ends.
  void setAnswers(const std::string& text) {
    const std::vector<std::string> list = base::split(text, ' ');
    const auto* const action = std::find(kActionNames.begin(), kActionNames.end(), list.front());
    mistakes_ += action == kActionNames.end() ? list.front() + " " : "";
    std::vector<Answer> answers;
    for (std::size_t i = 1; i < list.size(); ++i) {
      const std::size_t colon = list[i].find(':');
      answers.push_back(
          {list[i].front() == 'S' ? State::Succeeded : State::Failed,
           colon == std::string::npos ? 0 : std::atoi(list[i].substr(colon + 1).c_str()),
           std::atoi(list[i].substr(1).c_str())});
    }
    host().script[static_cast<RobotAction>(action - kActionNames.begin())] = std::move(answers);
  }

  /// Level, voltage, whether it charges.
  void setBattery(const std::vector<double>& numbers) {
    host().charge = sim2d::BatteryState{numbers.at(0), numbers.at(1), 1.0,
                                        numbers.size() > 2 && numbers[2] > 0};
  }
  /// Distance to the left [m], heading error [rad].
  void track(const std::vector<double>& numbers) {
    host().tracked.number += 1;
    host().tracked.positionError = numbers.at(0);
    host().tracked.headingError = numbers.at(1);
  }
  /// Last node, next node, edge, whether the route is a new one; the route leads to (NEXT, 0).
  void setProgress(const std::vector<double>& numbers) {
    bt::RouteProgress& progress = host().progress;
    ++progress.number;
    progress.route = host().paths().add({{{numbers.at(1), 0.0}, 0.0}});
    progress.lastNode = static_cast<std::uint32_t>(numbers.at(0));
    progress.nextNode = static_cast<std::uint32_t>(numbers.at(1));
    progress.currentEdge = static_cast<std::uint32_t>(numbers.at(2));
    progress.isRerouted = numbers.at(3) > 0.0;
  }

  std::string recoveries() const {
    const int count = played_.host.recoveries;
    return count == 0 ? "" : " recoveries=" + std::to_string(count);
  }

  /// Output ports that were written, as far as the row has them.
  std::string outputs() const {
    static const bt::NodeLibrary kNodes = bt::robotNodes();
    std::string text;
    for (const auto& [key, value] : row_.ports) {
      const bt::PortSpec* const port = kNodes.catalogue().find(row_.node)->port(key);
      const bool isOutput = port->direction != bt::PortDirection::Input && value.size() > 2;
      const int slot = isOutput ? played_.program->findSlot(value.substr(1, value.size() - 2)) : -1;
      if (slot < 0) {
        continue;
      }
      const bt::Value& written = played_.state->get(slot);
      if (written.toText().empty()) {
        continue;
      }
      const auto number = static_cast<int>(bt::valueAs<int>(written).value_or(0));
      const bool isPath = port->portType == bt::PortType::Any;
      text += " " + key + "=" +
              (key == "output_waypoint_statuses"
                   ? nodebehavior::textOf(played_.host.waypoints().get(number))
               : isPath && key != "tracking_feedback"
                   ? nodebehavior::textOf(played_.host.paths().get(number))
                   : written.toText());
    }
    return text;
  }

  Row row_;
  PlayedBy<Recording> played_;
  std::string mistakes_;
};

}  // namespace nodebehavior
