#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bt/human/TreeBehavior.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/Registries.h"
#include "sim2d/world/Runner.h"

/// Scenarios that come with the program, loaded as `hunavsim run` does.
namespace shipped {

using base::Vec2;
using sim2d::Event;
using sim2d::EventKind;
using sim2d::Frame;

inline std::string mapsFolder() {
  return SOURCE_DIR "/maps";
}

/// Everything of one scenario, with all that was said about it on the way.
struct Loaded {
  std::shared_ptr<const sim2d::Scenario> scenario;
  sim2d::OccupancyGrid map;
  bt::TreeFiles trees;  // "" = generated
  base::Diagnostics diagnostics;
};

inline Loaded load(const std::string& path) {
  Loaded loaded;
  sim2d::ScenarioReading reading = sim2d::readScenario(path);
  loaded.diagnostics = reading.diagnostics;
  loaded.scenario = std::make_shared<const sim2d::Scenario>(std::move(reading.scenario));
  sim2d::FileSearchPaths places;
  places.scenarioPath = path;
  places.shippedMaps = mapsFolder();
  const base::Result<std::string> mapPath = sim2d::findMap(*loaded.scenario, places);
  base::append(loaded.diagnostics, mapPath.diagnostics());
  if (!mapPath) {
    return loaded;
  }
  if (!mapPath->empty()) {
    base::Result<sim2d::MapFile> map = sim2d::readMap(*mapPath, {});
    base::append(loaded.diagnostics, map.diagnostics());
    if (map) {
      loaded.map = std::move(map->grid);
    }
    const sim2d::Surroundings around = sim2d::makeSurroundings(*loaded.scenario, loaded.map);
    base::append(loaded.diagnostics,
                 sim2d::checkScenario(*loaded.scenario, around, path,
                                      sim2d::knownNames(sim2d::builtinRegistries())));
  }
  for (const sim2d::Human& human : loaded.scenario->humans) {
    loaded.trees[human.name] = sim2d::findTree(*loaded.scenario, human, places);
  }
  return loaded;
}

/// "maps/<place>/<name>.yaml".
inline Loaded load(const std::string& place, const std::string& name) {
  return load(mapsFolder() + "/" + place + "/" + name + ".yaml");
}

/// With people as they are written, the same in every seed.
inline Loaded loadAsWritten(const std::string& place, const std::string& name) {
  Loaded loaded = load(place, name);
  auto scenario = std::make_shared<sim2d::Scenario>(*loaded.scenario);
  scenario->desktop.variation = sim2d::VariationSettings();
  loaded.scenario = std::move(scenario);
  return loaded;
}

/// nullptr when the run is impossible; what was said is added to `loaded.diagnostics`.
inline std::unique_ptr<sim2d::World> makeWorld(Loaded& loaded, int threads = 1) {
  sim2d::WorldSetup setup;
  setup.scenario = loaded.scenario;
  setup.map = loaded.map;
  setup.threads = threads;
  setup.behavior = bt::makeTreeBehavior(*loaded.scenario, loaded.trees, loaded.diagnostics);
  if (!setup.behavior) {
    return nullptr;
  }
  base::Result<std::unique_ptr<sim2d::World>> world = sim2d::World::create(std::move(setup));
  base::append(loaded.diagnostics, world.diagnostics());
  return world ? *std::move(world) : nullptr;
}

/// Errors and warnings, one per line.
inline std::string pendingDiagnostics(const base::Diagnostics& diagnostics) {
  std::string text;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != base::Severity::Info) {
      text += diagnostic.text() + "\n";
    }
  }
  return text;
}

/// All frames of so many steps, step 0 first. Ends early when the world fails.
inline std::vector<Frame> framesOf(sim2d::World& world, std::int64_t steps) {
  std::vector<Frame> frames = {world.frame()};
  while (world.stepIndex() < steps && world.step()) {
    frames.push_back(world.frame());
  }
  return frames;
}

/// As long as the scenario says.
inline std::vector<Frame> framesOf(sim2d::World& world) {
  return framesOf(world, sim2d::stopRuleOf(world.view().scenario()).maximumSteps);
}

/// Time of the first such event, with this text if it is not empty; -1: there is none.
inline double timeOf(const std::vector<Frame>& frames, EventKind kind, int id,
                     const std::string& text = {}) {
  for (const Frame& frame : frames) {
    for (const Event& event : frame.events) {
      if (event.kind == kind && event.id == id && (text.empty() || event.text == text)) {
        return frame.time;
      }
    }
  }
  return -1.0;
}

inline base::Pose2 poseOf(const Frame& frame, std::size_t row = 0) {
  return {Vec2(frame.humans.x[row], frame.humans.y[row]), frame.humans.heading[row]};
}
inline base::Pose2 robotPoseOf(const Frame& frame) {
  return {Vec2(frame.robots.x[0], frame.robots.y[0]), frame.robots.heading[0]};
}
inline double speedOf(const Frame& frame, std::size_t row = 0) {
  return Vec2(frame.humans.vx[row], frame.humans.vy[row]).norm();
}
inline double robotSpeedOf(const Frame& frame) {
  return Vec2(frame.robots.vx[0], frame.robots.vy[0]).norm();
}
/// Angle between where somebody looks and a point [rad], 0 to pi.
inline double angleOff(const base::Pose2& pose, const Vec2& point) {
  const Vec2 local = pose.toLocal(point);
  return std::fabs(std::atan2(local.y(), local.x()));
}

}  // namespace shipped
