#include "sim2d/nav/external/LibraryPlanner.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim2d/nav/external/PlannerLibrary.h"
#include "sim2d/nav/external/PlannerProtocol.h"
#include "sim2d/nav/external/ShownText.h"

namespace sim2d {
namespace {

constexpr std::size_t kMostPathPoints = 100000;

hunavsim_point plainPoint(const Vec2& point) {
  return {point.x(), point.y()};
}

hunavsim_pose plainPose(const Pose2& pose) {
  return {pose.position.x(), pose.position.y(), pose.heading};
}

std::vector<hunavsim_point> plainPoints(const std::vector<Vec2>& points) {
  std::vector<hunavsim_point> all;
  all.reserve(points.size());
  for (const Vec2& point : points) {
    all.push_back(plainPoint(point));
  }
  return all;
}

int32_t plainKinematics(Kinematics kinematics) {
  switch (kinematics) {
    case Kinematics::Omnidirectional:
      return HUNAVSIM_OMNIDIRECTIONAL;
    case Kinematics::Ackermann:
      return HUNAVSIM_ACKERMANN;
    default:
      return HUNAVSIM_DIFFERENTIAL;
  }
}

hunavsim_body plainBody(const TrackedBody& body) {
  return {body.id,
          body.kind == BodyKind::Person ? HUNAVSIM_PERSON : HUNAVSIM_ROBOT,
          plainPoint(body.position),
          plainPoint(body.velocity),
          body.heading,
          body.radius};
}

hunavsim_scan plainScan(const LaserScan& scan) {
  return {plainPose(scan.sensor), scan.time,  scan.angleMin,
          scan.perBeam,           scan.range, scan.distances.data(),
          scan.distances.size()};
}

/// The walls as the library sees them, worked out anew when doors have moved.
class PlainWalls {
 public:
  /// True: they are others than before.
  bool update(const Observation& observation) {
    if (observation.navigation->version() == version_) {
      return false;
    }
    version_ = observation.navigation->version();
    points_.clear();
    outlines_.clear();
    for (const Outline* outline : standingOutlines(*observation.obstacles)) {
      points_.push_back(plainPoints(outline->points));
    }
    outlines_.reserve(points_.size());
    for (const std::vector<hunavsim_point>& points : points_) {
      outlines_.push_back({points.data(), points.size()});
    }
    return true;
  }
  const std::vector<hunavsim_outline>& outlines() const { return outlines_; }

 private:
  int version_ = -1;
  std::vector<std::vector<hunavsim_point>> points_;
  std::vector<hunavsim_outline> outlines_;
};

std::string libraryWords(const char* text) {
  return text == nullptr ? std::string() : shownText(text);
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
    const bool haveWallsChanged = walls_.update(observation);
    hunavsim_observation plain = plainOf(observation);
    plain.walls_changed = haveWallsChanged ? 1 : 0;
    hunavsim_scan scan = {};
    if (observation.scan != nullptr) {
      scan = plainScan(*observation.scan);
      plain.scan = &scan;
    }
    hunavsim_twist twist = {0.0, 0.0, 0.0};
    const int32_t code = library_->command(planner_, &plain, &twist);
    if (code != 0) {
      return ofRobot(base::error(
          "library.failed", {library_->file(), code, libraryWords(library_->error(planner_))}));
    }
    return checked(twist);
  }

  std::vector<Vec2> path() const override {
    if (library_->path == nullptr) {
      return {};
    }
    std::vector<hunavsim_point> points(library_->path(planner_, nullptr, 0));
    points.resize(std::min(points.size(), kMostPathPoints));
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
  base::Diagnostic ofRobot(base::Diagnostic problem) const {
    return base::within("robot '" + robot_ + "'", std::move(problem));
  }

  /// But for scan and walls_changed.
  hunavsim_observation plainOf(const Observation& observation) {
    bodies_.clear();
    bodies_.reserve(observation.bodies.size());
    for (const TrackedBody& body : observation.bodies) {
      bodies_.push_back(plainBody(body));
    }
    hunavsim_observation plain = {};
    plain.time = observation.time;
    plain.dt = observation.dt;
    plain.pose = plainPose(observation.pose);
    plain.motion = {observation.motion.linear, observation.motion.angular,
                    observation.motion.lateral};
    plain.goal = plainPoint(observation.goal);
    plain.goal_radius = observation.goalRadius;
    plain.bodies = bodies_.data();
    plain.body_count = bodies_.size();
    plain.walls = walls_.outlines().data();
    plain.wall_count = walls_.outlines().size();
    return plain;
  }

  base::Result<BodyTwist> checked(const hunavsim_twist& twist) const {
    const std::pair<const char*, double> parts[] = {
        {"linear", twist.linear}, {"angular", twist.angular}, {"lateral", twist.lateral}};
    for (const auto& [key, value] : parts) {
      if (!std::isfinite(value)) {
        return ofRobot(base::error("library.no-number", {key, library_->file()}));
      }
    }
    return BodyTwist{twist.linear, twist.angular, twist.lateral};
  }

  const std::string robot_;
  const std::shared_ptr<const PlannerLibrary> library_;
  hunavsim_planner* const planner_;
  PlainWalls walls_;
  std::vector<hunavsim_body> bodies_;
};

base::Result<std::shared_ptr<Planner>> loadLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file,
                                                          CodePermission permission) {
  if (file.empty()) {
    return base::error("library.no-file");
  }
  if (!permission.allowed) {
    return base::error("library.not-allowed", {file});
  }
  base::Result<std::shared_ptr<const PlannerLibrary>> library = PlannerLibrary::load(file);
  if (!library) {
    return library.diagnostics();
  }
  const RobotBody& body = setup.body;
  const std::vector<hunavsim_point> corners = plainPoints(body.footprint.corners);
  const DriveLimits& limits = body.limits;
  const hunavsim_robot robot = {setup.robot.c_str(),
                                setup.robotId,
                                plainKinematics(body.kinematics),
                                reachOf(body.footprint),
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
    return base::error("library.refused", {file, libraryWords((*library)->error(nullptr))});
  }
  return std::shared_ptr<Planner>(
      std::make_shared<LibraryPlanner>(setup.robot, *std::move(library), planner));
}

}  // namespace

base::Result<std::shared_ptr<Planner>> makeLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file,
                                                          CodePermission permission) {
  base::Result<std::shared_ptr<Planner>> planner = loadLibraryPlanner(setup, file, permission);
  if (planner) {
    return planner;
  }
  base::Diagnostics problems;
  for (const base::Diagnostic& problem : planner.diagnostics()) {
    problems.push_back(base::within("robot '" + setup.robot + "'", problem));
  }
  return problems;
}

}  // namespace sim2d
