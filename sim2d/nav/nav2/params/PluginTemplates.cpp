#include "sim2d/nav/nav2/params/PluginTemplates.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

constexpr char kDwb[] = "dwb_core::DWBLocalPlanner";
constexpr char kMppi[] = "nav2_mppi_controller::MPPIController";
constexpr char kPursuit[] =
    "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";
constexpr char kGraceful[] = "nav2_graceful_controller::GracefulController";

/// Part of the name of a class, in small letters, and what it stands for.
struct NamePart {
  const char* part;
  const char* plugin;
  const char* why;
};
constexpr char kLimitsKept[] = "it is not re-implemented; the limits of velocity are kept";
constexpr char kKeysKept[] = "it is not re-implemented; the keys that both have are kept";
constexpr std::array<NamePart, 9> kParts = {{{"teb", kMppi, kLimitsKept},
                                             {"mppi", kMppi, kKeysKept},
                                             {"mpc", kMppi, kLimitsKept},
                                             {"graceful", kGraceful, kKeysKept},
                                             {"pursuit", kPursuit, kKeysKept},
                                             {"stanley", kPursuit, kLimitsKept},
                                             {"pathfollow", kPursuit, kLimitsKept},
                                             {"path_follow", kPursuit, kLimitsKept},
                                             {"dwb", kDwb, kKeysKept}}};

/// Lines "key: value".
class Lines {
 public:
  Lines& add(const char* key, double value) { return add(key, base::formatDecimals(value, 1)); }
  Lines& add(const char* key, int value) { return add(key, std::to_string(value)); }
  Lines& add(const char* key, const std::string& value) {
    text_ += std::string(key) + ": " + value + "\n";
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string dwbTemplate(const ReplacedLimits& limits) {
  return Lines()
      .add("min_vel_x", -limits.back)
      .add("max_vel_x", limits.ahead)
      .add("max_vel_theta", limits.turn)
      .add("min_speed_xy", 0.0)
      .add("max_speed_xy", limits.ahead)
      .add("min_speed_theta", 0.0)
      .add("acc_lim_x", limits.acceleration)
      .add("acc_lim_theta", limits.turning)
      .add("decel_lim_x", -limits.acceleration)
      .add("decel_lim_theta", -limits.turning)
      .add("vx_samples", 20)
      .add("vtheta_samples", 20)
      .add("sim_time", 1.7)
      .add("linear_granularity", 0.05)
      .add("angular_granularity", 0.025)
      .add("critics",
           "[RotateToGoal, Oscillation, BaseObstacle, GoalAlign, PathAlign, PathDist, GoalDist]")
      .add("BaseObstacle.scale", 0.02)
      .add("PathAlign.scale", 32.0)
      .add("PathAlign.forward_point_distance", 0.1)
      .add("GoalAlign.scale", 24.0)
      .add("GoalAlign.forward_point_distance", 0.1)
      .add("PathDist.scale", 32.0)
      .add("GoalDist.scale", 24.0)
      .add("RotateToGoal.scale", 32.0)
      .text();
}

/// As Nav2's example file has it, with steps that are no shorter than the controller's period.
std::string mppiTemplate(Distro distro, const ReplacedLimits& limits, double rate) {
  constexpr double kStep = 0.05, kHorizon = 2.8;  // [s]
  constexpr int kFewest = 10, kMost = 100;
  const double step = rate > 0.0 ? std::max(kStep, 1.0 / rate) : kStep;
  const int steps = std::clamp(static_cast<int>(std::round(kHorizon / step)), kFewest, kMost);
  const bool isCar = limits.turningRadius > 0.0, isNew = distro >= Distro::Lyrical;
  Lines lines;
  lines.add("time_steps", steps)
      .add("model_dt", step)
      .add("batch_size", 2000)
      .add("vx_max", limits.ahead)
      .add("vx_min", -limits.back)
      .add("wz_max", limits.turn)
      .add("vx_std", std::max(0.1, 0.4 * limits.ahead))
      .add("wz_std", std::max(0.2, 0.4 * limits.turn));
  if (distro != Distro::Humble) {
    lines.add("ax_max", limits.acceleration)
        .add("ax_min", -limits.acceleration)
        .add("az_max", limits.turning);
  }
  if (isNew) {
    lines.add("motion_model", isCar ? "ackermann" : "diff_drive");
  } else {
    lines.add("motion_model", isCar ? "Ackermann" : "DiffDrive").add("prune_distance", 1.7);
  }
  if (isCar) {
    lines.add(isNew ? "ackermann.min_turning_r" : "AckermannConstraints.min_turning_r",
              limits.turningRadius);
  }
  return lines
      .add("critics",
           "[ConstraintCritic, CostCritic, GoalCritic, GoalAngleCritic, PathAlignCritic, "
           "PathFollowCritic, PathAngleCritic, PreferForwardCritic]")
      .text();
}

}  // namespace

ReplacedController nearestController(const std::string& type) {
  std::string name = type;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const NamePart& each : kParts) {
    if (name.find(each.part) != std::string::npos) {
      return {each.plugin, each.why};
    }
  }
  return {kDwb, kLimitsKept};
}

std::string templateOf(const std::string& plugin, Distro distro, const ReplacedLimits& limits,
                       double rate) {
  if (plugin == kDwb) {
    return dwbTemplate(limits);
  }
  if (plugin == kMppi) {
    return mppiTemplate(distro, limits, rate);
  }
  const bool isNew = distro >= Distro::Lyrical;
  if (plugin == kPursuit) {
    return Lines().add(isNew ? "max_linear_vel" : "desired_linear_vel", limits.ahead).text();
  }
  return Lines().add("v_linear_max", limits.ahead).add("v_angular_max", limits.turn).text();
}

}  // namespace sim2d::nav2
