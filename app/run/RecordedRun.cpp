#include "app/run/RecordedRun.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using base::EntityKind;
using sim2d::Vec2;

/// The first input of the manifest. Its path is relative to the working folder of the run or to the
/// run folder.
std::string findScenarioFile(const fs::path& folder, base::Diagnostics& problems) {
  const fs::path manifest = folder / "manifest.json";
  std::error_code none;
  if (!fs::exists(manifest, none)) {
    return {};  // a recording made by `evaluate`
  }
  const base::Result<std::string> text = base::readTextFile(manifest.string());
  base::append(problems, text.diagnostics());
  const auto json = nlohmann::json::parse(base::shallowJson(text ? *text : ""), nullptr, false);
  if (json.is_object() && json.value("kind", nlohmann::json()) == "evaluation") {
    return {};
  }
  const nlohmann::json::json_pointer first("/inputs/0/path");
  if (!json.contains(first) || !json[first].is_string()) {
    problems.push_back(base::error("trace.bad-manifest", {}, manifest.string()));
    return {};
  }
  const auto named = json[first].get<std::string>();
  const auto hash = json[first.parent_pointer()].value("sha256", nlohmann::json());
  const auto found =
      findInput(named, folder.string(), hash.is_string() ? hash.get<std::string>() : "");
  if (!found) {
    problems.push_back(base::warning("trace.scenario-gone", {}, named));
  }
  return found.value_or("");
}

class RecordedScenarioBuilder {
 public:
  RecordedScenarioBuilder(const sim2d::Recording& recording, sim2d::Scenario scenario)
      : recording_(recording),
        header_(*recording.header()),
        scenario_(std::move(scenario)),
        isFromRecording_(scenario_.humans.empty() && scenario_.robots.empty()),
        key_(scenario_.nextKey()) {}

  sim2d::Scenario make() {
    if (scenario_.desktop.seed.value_or(1) != header_.seed) {
      scenario_.desktop.seed = header_.seed;
    }
    scenario_.desktop.duration = recording_.timeOf(recording_.size() - 1);
    for (const sim2d::TraceHuman& human : header_.humans) {
      addHuman(human);
    }
    for (std::size_t k = 0; k < scenario_.robots.size(); ++k) {
      scenario_.robots[k].listed = scenario_.robots[k].listed && k < header_.robots.size();
    }
    for (std::size_t k = 0; k < header_.robots.size(); ++k) {
      setRobot(k);
    }
    for (const sim2d::TraceObstacle& obstacle : header_.obstacles) {
      if (isFromRecording_ && obstacle.name != "map") {
        obstacle.isDoor ? addDoor(obstacle) : addObstacle(obstacle);
      }
    }
    return std::move(scenario_);
  }

 private:
  template <class T>
  T& add(std::vector<T>& list, EntityKind kind) {
    list.emplace_back().key = {kind, key_++};
    return list.back();
  }

  void addHuman(const sim2d::TraceHuman& recorded) {
    if (auto* const there = base::findBy(scenario_.humans, &sim2d::Human::id, recorded.id)) {
      if (sim2d::resolveHuman(scenario_, *there, header_.seed).radius != recorded.radius) {
        there->radius = recorded.radius;
      }
    } else if (isFromRecording_) {  // other agents were spawned by a source
      addNew(recorded);
    }
  }

  void addNew(const sim2d::TraceHuman& recorded) {
    sim2d::Human& human = add(scenario_.humans, EntityKind::Human);
    human.name = recorded.name;
    human.id = recorded.id;
    human.radius = recorded.radius;
    human.maxVel = recorded.desiredSpeed;
    human.groupId = recorded.group;
    human.cyclicGoals = recorded.cyclicGoals;
    human.behavior.type = static_cast<sim2d::BehaviorType>(std::clamp(recorded.behavior, 1, 6));
    human.behavior.configuration =
        static_cast<sim2d::Configuration>(std::clamp(recorded.configuration, 0, 3));
    for (const sim2d::PersonKind kind :
         {sim2d::PersonKind::Adult, sim2d::PersonKind::Child, sim2d::PersonKind::Elderly,
          sim2d::PersonKind::Wheelchair, sim2d::PersonKind::Luggage}) {
      if (recorded.kind == sim2d::personKindName(kind)) {
        human.ours.kind = kind;
      }
    }
    for (const sim2d::TraceGoal& goal : recorded.goals) {
      addGoal(human, goal);
    }
    setStartPose(recording_.frame(0)->humans, recorded.id, human.initPose);
  }

  void addGoal(sim2d::Human& human, const sim2d::TraceGoal& recorded) {
    human.goalRadius = recorded.radius;
    human.goals.push_back(recorded.id);
    if (scenario_.goal(recorded.id) == nullptr) {
      sim2d::GlobalGoal& goal = add(scenario_.goals, EntityKind::Goal);
      goal.id = recorded.id;
      goal.position = recorded.position;
    }
  }

  template <class Columns>
  static void setStartPose(const Columns& columns, int id, base::Pose2& pose) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns.id[k] == id) {
        pose = {Vec2(columns.x[k], columns.y[k]), columns.heading[k]};
      }
    }
  }

  /// Updates the robot at this index of the list, or appends it.
  void setRobot(std::size_t place) {
    const sim2d::TraceRobot& recorded = header_.robots[place];
    if (place == scenario_.robots.size()) {
      sim2d::Robot& robot = add(scenario_.robots, EntityKind::Robot);
      robot.name = recorded.name;
      setStartPose(recording_.frame(0)->robots, recorded.id, robot.start);
      if (!recorded.goals.empty()) {
        robot.goal.point = recorded.goals.front().position;
      }
    }
    sim2d::Robot& robot = scenario_.robots[place];
    const sim2d::ResolvedRobot now = sim2d::resolveRobot(scenario_, robot, recorded.id);
    if (now.radius != recorded.radius || now.footprint.empty() != recorded.footprint.empty()) {
      robot.radius = recorded.radius;
    }
    if (now.footprint != recorded.footprint) {
      robot.footprintX.clear();
      robot.footprintY.clear();
      for (const Vec2& corner : recorded.footprint) {
        robot.footprintX.push_back(corner.x());
        robot.footprintY.push_back(corner.y());
      }
    }
  }

  void addObstacle(const sim2d::TraceObstacle& recorded) {
    for (const sim2d::Outline& outline : recorded.outlines) {
      sim2d::Obstacle& obstacle = add(scenario_.obstacles, EntityKind::Obstacle);
      obstacle.name = recorded.name;
      obstacle.kind = sim2d::ObstacleKind::Polygon;
      obstacle.points = outline.points;
    }
  }

  void addDoor(const sim2d::TraceObstacle& recorded) {
    if (recorded.outlines.empty() || recorded.outlines.front().points.size() != 4) {
      return;
    }
    sim2d::Door& door = add(scenario_.doors, EntityKind::Door);
    door.name = recorded.name;
    door.open = recorded.open;
    door.toggles = recorded.toggles;
    const std::vector<Vec2>& corners = recorded.outlines.front().points;
    const bool isAlong = (corners[1] - corners[0]).norm() >= (corners[2] - corners[1]).norm();
    const std::size_t first = isAlong ? 0 : 1;  // first corner of a long side
    const auto corner = [&](std::size_t k) { return corners[(first + k) % 4]; };
    door.from = 0.5 * (corner(0) + corner(3));
    door.to = 0.5 * (corner(1) + corner(2));
    door.thickness = (corner(3) - corner(0)).norm();
  }

  const sim2d::Recording& recording_;
  const sim2d::TraceHeader& header_;
  sim2d::Scenario scenario_;
  bool isFromRecording_;
  int key_;
};

/// The staging folder that a killed run has left; empty if there is none.
std::string stagingOfKilledRun(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const bool isRest = isInternalEntry(at->path().filename().string());
    if (isRest && fs::exists(at->path() / "trace.json", error)) {
      return at->path().string();
    }
  }
  return {};
}

/// A time for display [s], rounded: a sum of steps may be 4.8000000000000007.
std::string shown(double time) {
  return base::formatDouble(std::round(time * 1000.0) / 1000.0);
}

base::Result<RecordedRun> readKilledRun(const std::string& folder, const std::string& rest,
                                        std::size_t mostInMemory) {
  const auto lock = FolderLock::acquire(folder);
  if (!lock) {
    return lock.diagnostics();  // the run is still active
  }
  RecordedRun run;
  sim2d::Truncation& cut = run.cut.emplace();
  cut.isUnfinished = true;
  const auto recording = sim2d::readRecording(rest, mostInMemory, &cut);
  if (!recording) {
    return recording.diagnostics();
  }
  if ((*recording)->size() == 0) {
    return base::error("trace.unfinished", {}, folder);
  }
  run.recording = *recording;
  cut.note("trajectory.csv");
  cut.time = run.recording->timeOf(run.recording->size() - 1);
  return {std::move(run), {base::warning("trace.killed", {shown(cut.time)}, folder)}};
}

/// Problems of the parts without those that the truncation already explains.
base::Diagnostics partProblems(const std::string& folder, const sim2d::Truncation& cut) {
  base::Diagnostics problems = checkRunFiles(folder);
  problems.erase(std::remove_if(problems.begin(), problems.end(),
                                [&cut](const base::Diagnostic& each) {
                                  return cut.has(fs::path(each.file).filename().string());
                                }),
                 problems.end());
  return problems;
}

}  // namespace

base::Result<RecordedRun> readRecordedRun(const std::string& folder, std::size_t mostInMemory,
                                          IncompleteRecordings cuts) {
  std::error_code none;
  if (fs::is_regular_file(folder, none)) {
    return base::error("trace.file-for-run", {}, folder);
  }
  const base::Diagnostics unsettled = completeCommit(folder);
  if (base::hasErrors(unsettled)) {
    return unsettled;
  }
  if (!fs::exists(fs::path(folder) / "trace.json", none)) {
    const std::string rest =
        cuts == IncompleteRecordings::Shown ? stagingOfKilledRun(folder) : std::string();
    if (!rest.empty()) {
      return readKilledRun(folder, rest, mostInMemory);
    }
    const bool isCut = fs::exists(fs::path(folder) / "trajectory.csv", none);
    return base::error(isCut ? "trace.unfinished" : "trace.no-run", {}, folder);
  }
  sim2d::Truncation cut;
  const auto recording = sim2d::readRecording(folder, mostInMemory,
                                              cuts == IncompleteRecordings::Shown ? &cut : nullptr);
  base::Diagnostics problems = recording.diagnostics();
  if (recording && (*recording)->size() == 0) {
    problems.push_back(base::error("trace.no-states", {}, folder));
  }
  base::append(problems, recording ? partProblems(folder, cut) : base::Diagnostics());
  RecordedRun run;
  if (cut.isTruncated()) {
    const std::string end = cut.end ? shown(*cut.end) : std::string();
    problems.push_back(base::warning("trace.cut", {shown(cut.time), end}, folder));
    run.cut = cut;
  }
  run.scenario = findScenarioFile(folder, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  run.recording = *recording;
  return {std::move(run), std::move(problems)};
}

sim2d::Scenario scenarioOf(const sim2d::Recording& recording, sim2d::Scenario read) {
  return RecordedScenarioBuilder(recording, std::move(read)).make();
}

}  // namespace app
