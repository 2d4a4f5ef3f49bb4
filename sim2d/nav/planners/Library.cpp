#include <algorithm>
#include <cmath>
#include <dlfcn.h>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/external/ExternalPlanner.h"
#include "sim2d/nav/external/LibraryPlanner.h"

namespace sim2d {

namespace {

constexpr std::size_t kMaxPathPoints = 100000;

hunavsim_point toAbiPoint(const Vec2& point) {
  return {point.x(), point.y()};
}

hunavsim_pose toAbiPose(const Pose2& pose) {
  return {pose.position.x(), pose.position.y(), pose.heading};
}

std::vector<hunavsim_point> toAbiPoints(const std::vector<Vec2>& points) {
  std::vector<hunavsim_point> all;
  all.reserve(points.size());
  for (const Vec2& point : points) {
    all.push_back(toAbiPoint(point));
  }
  return all;
}

int32_t toAbiKinematics(Kinematics kinematics) {
  switch (kinematics) {
    case Kinematics::Omnidirectional:
      return HUNAVSIM_OMNIDIRECTIONAL;
    case Kinematics::Ackermann:
      return HUNAVSIM_ACKERMANN;
    default:
      return HUNAVSIM_DIFFERENTIAL;
  }
}

hunavsim_body toAbiBody(const TrackedBody& body) {
  return {body.id,
          body.kind == BodyKind::Person ? HUNAVSIM_PERSON : HUNAVSIM_ROBOT,
          toAbiPoint(body.position),
          toAbiPoint(body.velocity),
          body.heading,
          body.radius};
}

hunavsim_scan toAbiScan(const LaserScan& scan) {
  return {toAbiPose(scan.sensor), scan.time,  scan.angleMin,
          scan.angleIncrement,    scan.range, scan.distances.data(),
          scan.distances.size()};
}

std::string libraryMessage(const char* text) {
  return text == nullptr ? std::string() : printableText(text);
}

class LibraryPlanner : public Planner {
 public:
  LibraryPlanner(std::string robot, std::shared_ptr<const PlannerLibrary> library,
                 hunavsim_planner* planner)
      : robot_(std::move(robot)), library_(std::move(library)), planner_(planner) {}
  ~LibraryPlanner() override { library_->destroy(planner_); }
  LibraryPlanner(const LibraryPlanner&) = delete;
  LibraryPlanner& operator=(const LibraryPlanner&) = delete;
  LibraryPlanner(LibraryPlanner&&) = delete;
  LibraryPlanner& operator=(LibraryPlanner&&) = delete;

  base::Result<BodyTwist> command(const Observation& observation) override {
    const bool haveWallsChanged = updateWalls(observation);
    hunavsim_observation plain = toAbiObservation(observation);
    plain.walls_changed = haveWallsChanged ? 1 : 0;
    hunavsim_scan scan = {};
    if (observation.scan != nullptr) {
      scan = toAbiScan(*observation.scan);
      plain.scan = &scan;
    }
    hunavsim_twist twist = {0.0, 0.0, 0.0};
    const int32_t code = library_->command(planner_, &plain, &twist);
    if (code != 0) {
      return withRobotName(
          robot_, {base::error("library.failed", {library_->file(), code,
                                                  libraryMessage(library_->error(planner_))})});
    }
    return checked(twist);
  }

  std::vector<Vec2> path() const override {
    if (library_->path == nullptr) {
      return {};
    }
    std::vector<hunavsim_point> points(library_->path(planner_, nullptr, 0));
    points.resize(std::min(points.size(), kMaxPathPoints));
    const std::size_t count = library_->path(planner_, points.data(), points.size());
    points.resize(std::min(points.size(), count));
    std::vector<Vec2> path;
    path.reserve(points.size());
    for (const hunavsim_point& point : points) {
      if (std::isfinite(point.x) && std::isfinite(point.y)) {
        path.emplace_back(point.x, point.y);
      }
    }
    return path;
  }

 private:
  /// Converts the walls when a door has moved; returns true if they changed.
  bool updateWalls(const Observation& observation) {
    if (observation.navigation->version() == wallVersion_) {
      return false;
    }
    wallVersion_ = observation.navigation->version();
    wallPoints_.clear();
    outlines_.clear();
    for (const Outline* outline : enabledOutlines(*observation.obstacles)) {
      wallPoints_.push_back(toAbiPoints(outline->points));
    }
    outlines_.reserve(wallPoints_.size());
    for (const std::vector<hunavsim_point>& points : wallPoints_) {
      outlines_.push_back({points.data(), points.size()});
    }
    return true;
  }

  /// Without scan and walls_changed.
  hunavsim_observation toAbiObservation(const Observation& observation) {
    bodies_.clear();
    bodies_.reserve(observation.bodies.size());
    for (const TrackedBody& body : observation.bodies) {
      bodies_.push_back(toAbiBody(body));
    }
    hunavsim_observation plain = {};
    plain.time = observation.time;
    plain.dt = observation.dt;
    plain.pose = toAbiPose(observation.pose);
    plain.motion = {observation.motion.linear, observation.motion.angular,
                    observation.motion.lateral};
    plain.goal = toAbiPoint(observation.goal);
    plain.goal_radius = observation.goalRadius;
    plain.bodies = bodies_.data();
    plain.body_count = bodies_.size();
    plain.walls = outlines_.data();
    plain.wall_count = outlines_.size();
    return plain;
  }

  base::Result<BodyTwist> checked(const hunavsim_twist& twist) const {
    const std::pair<const char*, double> parts[] = {
        {"linear", twist.linear}, {"angular", twist.angular}, {"lateral", twist.lateral}};
    for (const auto& [key, value] : parts) {
      if (!std::isfinite(value)) {
        return withRobotName(robot_, {base::error("library.no-number", {key, library_->file()})});
      }
    }
    return BodyTwist{twist.linear, twist.angular, twist.lateral};
  }

  const std::string robot_;
  const std::shared_ptr<const PlannerLibrary> library_;
  hunavsim_planner* const planner_;
  int wallVersion_ = -1;
  std::vector<std::vector<hunavsim_point>> wallPoints_;
  std::vector<hunavsim_outline> outlines_;  // of `wallPoints_`
  std::vector<hunavsim_body> bodies_;
};

base::Result<std::shared_ptr<Planner>> loadLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file) {
  if (file.empty()) {
    return base::error("library.no-file");
  }
  if (setup.code != ExternalCodePolicy::Allowed) {
    return base::error("library.not-allowed", {file});
  }
  base::Result<std::shared_ptr<const PlannerLibrary>> library = PlannerLibrary::load(file);
  if (!library) {
    return library.diagnostics();
  }
  const RobotBody& body = setup.body;
  const std::vector<hunavsim_point> corners = toAbiPoints(body.footprint.corners);
  const DriveLimits& limits = body.limits;
  const hunavsim_robot robot = {setup.robot.c_str(),
                                setup.robotId,
                                toAbiKinematics(body.kinematics),
                                circumscribedRadius(body.footprint),
                                corners.empty() ? nullptr : corners.data(),
                                corners.size(),
                                body.mass,
                                limits.maxVel,
                                limits.maxReverse,
                                limits.maxAcc,
                                limits.maxOmega,
                                limits.maxAlpha,
                                limits.turningRadius};
  hunavsim_planner* const planner = (*library)->create(&robot, setup.seed);
  if (planner == nullptr) {
    return base::error("library.refused", {file, libraryMessage((*library)->error(nullptr))});
  }
  return std::shared_ptr<Planner>(
      std::make_shared<LibraryPlanner>(setup.robot, *std::move(library), planner));
}

}  // namespace

base::Result<std::shared_ptr<Planner>> makeLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file) {
  base::Result<std::shared_ptr<Planner>> planner = loadLibraryPlanner(setup, file);
  return planner ? planner : withRobotName(setup.robot, planner.diagnostics());
}

namespace {

template <class Function>
void findSymbol(void* handle, const char* name, Function& to) {
  to = reinterpret_cast<Function>(::dlsym(handle, name));
}

}  // namespace

PlannerLibrary::PlannerLibrary(std::string file, void* handle)
    : file_(std::move(file)), handle_(handle) {}

PlannerLibrary::~PlannerLibrary() {
  ::dlclose(handle_);
}

base::Result<std::shared_ptr<const PlannerLibrary>> PlannerLibrary::load(const std::string& file) {
  void* const handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* why = ::dlerror();  // thread-local
    return base::error("library.not-loaded", {why == nullptr ? file : std::string(why)});
  }
  const std::shared_ptr<PlannerLibrary> library(new PlannerLibrary(file, handle));
  const base::Diagnostics problems = library->check();
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<const PlannerLibrary>(library);
}

base::Diagnostics PlannerLibrary::check() {
  base::Diagnostics problems;
  const auto need = [this, &problems](const char* name, auto& to) {
    findSymbol(handle_, name, to);
    if (to == nullptr) {
      problems.push_back(base::error("library.no-symbol", {file_, name}));
    }
  };
  decltype(&hunavsim_planner_abi) abi = nullptr;
  need("hunavsim_planner_abi", abi);
  need("hunavsim_planner_create", create);
  need("hunavsim_planner_command", command);
  need("hunavsim_planner_error", error);
  need("hunavsim_planner_destroy", destroy);
  findSymbol(handle_, "hunavsim_planner_path", path);
  if (abi != nullptr && abi() != HUNAVSIM_PLANNER_ABI) {
    problems = {base::error("library.other-version", {file_, abi(), HUNAVSIM_PLANNER_ABI})};
  }
  return problems;
}

namespace {

std::vector<base::ParameterSpec> librarySpecs() {
  return {fileSpec(
      "Shared library of the planner (hunavsim_planner.h), relative to the scenario; needs "
      "permission to run code.")};
}

/// Checks that do not require loading the library.
base::Result<std::shared_ptr<Planner>> makeIdlePlanner(const PlannerSetup& setup,
                                                       const std::string& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) {
    return withRobotName(setup.robot, {file.empty() ? base::error("library.no-file")
                                                    : base::error("library.not-there", {file})});
  }
  return std::shared_ptr<Planner>(std::make_shared<IdlePlanner>());
}

base::Result<std::shared_ptr<Planner>> makeLibrary(const PlannerSetup& setup) {
  const std::string file = fileParameter(setup, kFileParameter);
  if (setup.code == ExternalCodePolicy::Skipped) {
    return makeIdlePlanner(setup, file);
  }
  const bool isPlain = !file.empty() && file.find('/') == std::string::npos;  // not a system path
  return makeLibraryPlanner(setup, isPlain ? "./" + file : file);
}

}  // namespace

void addLibrary(PlannerRegistry& to);
void addLibrary(PlannerRegistry& to) {
  to.add(kLibraryPlanner, librarySpecs(), makeLibrary, "An external planner in a shared library.");
}

}  // namespace sim2d
