#include "sim2d/nav/RobotTypes.h"

#include <utility>

#include "sim2d/base/Find.h"

namespace sim2d {
namespace {

constexpr double kLidarDegree = base::kPi / 180.0;

/// Beams over a full turn, starting backward.
constexpr RobotLidar allRoundLidar(int beams, double range, double rate) {
  return {beams, -base::kPi, base::kPi * (1.0 - 2.0 / beams), range, rate, 0.0, 0.0, 0.3, 0.01};
}
/// Beams from -half to half [degrees].
constexpr RobotLidar sectorLidar(int beams, double half, double range, double rate) {
  return {beams, -half * kLidarDegree, half * kLidarDegree, range, rate, 0.0, 0.0, 0.3, 0.01};
}
constexpr RobotLidar mountedLidar(RobotLidar lidar, double x, double height, double noise) {
  lidar.x = x;
  lidar.height = height;
  lidar.noise = noise;
  return lidar;
}

// SICK TIM571 as mounted by PAL.
constexpr RobotLidar kTim571 =
    mountedLidar(sectorLidar(666, 110.0, 25.0, 10.0), 0.202, 0.095, 0.02);

/// Maximum velocity, reverse velocity, acceleration, turn rate and angular acceleration; the
/// minimum turning radius.
DriveLimits driveLimits(double maxVel, double maxReverse, double maxAcc, double maxOmega,
                        double maxAlpha, double turningRadius = 0.0) {
  return {maxVel, maxReverse, maxAcc, maxOmega, maxAlpha, turningRadius};
}

RobotBody discRobot(double radius, const DriveLimits& limits, double mass,
                    Kinematics kinematics = Kinematics::Differential) {
  return {kinematics, {radius, {}}, limits, mass};
}

/// A rectangle from `rear` to `front` with a half width.
RobotBody boxRobot(double rear, double front, double half, const DriveLimits& limits, double mass,
                   Kinematics kinematics = Kinematics::Differential) {
  Footprint footprint{0.0, {{rear, -half}, {front, -half}, {front, half}, {rear, half}}};
  footprint.radius = circumscribedRadius(footprint);
  return {kinematics, footprint, limits, mass};
}

std::vector<RobotType> firstRobots() {
  const DriveLimits pmb2 = driveLimits(1.0, 0.2, 0.5, 1.05, 1.05);
  return {
      {"generic", "Generic robot", discRobot(0.35, driveLimits(1.0, 1.0, 1.0, 1.5, 3.0), 50.0), 1.0,
       mountedLidar(allRoundLidar(360, 10.0, 10.0), 0.0, 0.3, 0.01),
       "A generic service robot of medium size."},
      {"pmb2", "PAL PMB-2", discRobot(0.27, pmb2, 32.9), 0.3, kTim571,
       "pal-robotics/pmb2_robot @6fcda26 (base.urdf.xacro: base 28.3 kg, wheels 2 x 1.8 kg, rest "
       "about 1 kg; footprint.yaml, mobile_base_controller.yaml, SICK TIM571). Height and noise of "
       "the lidar: manufacturer's figures, unverified."},
      {"tiago", "PAL TIAGo", discRobot(0.27, pmb2, 66.0), 1.1, kTim571,
       "Base as PMB-2, pal-robotics/pmb2_robot @6fcda26; mass summed from pal-robotics/tiago_robot "
       "@9c460fb. Height (1.10 to 1.45 m) and noise of the lidar: manufacturer's figures, "
       "unverified."},
      {"nova_carter", "NVIDIA Nova Carter",
       boxRobot(-0.596, 0.129, 0.25, driveLimits(0.7, 0.7, 2.5, 1.9, 3.2), 48.0), 0.556,
       mountedLidar(allRoundLidar(3200, 30.0, 10.0), 0.0, 0.3, 0.03),
       "NVIDIA's Nova Carter page (0.725 x 0.500 x 0.556 m, 48 kg; the drive reaches 3.3 m/s) and "
       "NVIDIA-ISAAC-ROS/nova_carter @f03bba7 (position of the axle, navigation at 0.7 m/s and 1.9 "
       "rad/s, 2.5 m/s²). Angular acceleration: default of nav2's velocity smoother. Lidar (one "
       "with a full turn, in place of its two RPLIDAR S2E), reverse speed: unverified."},
      {"jetbot", "NVIDIA JetBot",
       boxRobot(-0.075, 0.075, 0.065, driveLimits(0.3, 0.3, 1.0, 3.0, 6.0), 0.8), 0.13,
       std::nullopt,
       "Size, mass and speeds: manufacturer's figures, unverified. Accelerations: not published, "
       "assumed. It has a camera, no lidar."},
      {"create3", "iRobot Create 3",
       discRobot(0.164, driveLimits(0.306, 0.306, 0.9, 1.9, 7.7), 2.3), 0.092, std::nullopt,
       "iRobotEducation/create3_sim @7df657e (create3.urdf.xacro, control.yaml), create3_docs "
       "safety.md @53f188f (0.306 m/s; 0.46 m/s without safety). Height: manufacturer's figure, "
       "unverified. It has infrared sensors and a bumper, no lidar."},
      {"turtlebot3_burger", "TurtleBot 3 Burger",
       boxRobot(-0.101, 0.037, 0.089, driveLimits(0.22, 0.22, 2.5, 2.84, 3.2), 1.0), 0.192,
       mountedLidar(allRoundLidar(360, 3.5, 5.0), -0.032, 0.182, 0.01),
       "ROBOTIS-GIT/turtlebot3 @da785b7 (urdf, teleop_keyboard.py), turtlebot3_simulations "
       "model.sdf @eb50ff8 (LDS-01); accelerations of nav2's bringup. Size 0.138 x 0.178 x 0.192 m "
       "and mass: manufacturer's figures, unverified; assumed: the body is centred on its lidar."},
      {"turtlebot3_waffle", "TurtleBot 3 Waffle",
       boxRobot(-0.2045, 0.0765, 0.153, driveLimits(0.26, 0.26, 2.5, 1.82, 3.2), 1.8), 0.141,
       mountedLidar(allRoundLidar(360, 3.5, 5.0), -0.064, 0.132, 0.01),
       "ROBOTIS-GIT/turtlebot3 @da785b7 (urdf, teleop_keyboard.py), turtlebot3_simulations "
       "model.sdf @eb50ff8 (LDS-01); accelerations of nav2's bringup. Size 0.281 x 0.306 x 0.141 m "
       "and mass: manufacturer's figures, unverified; assumed: the body is centred on its lidar."}};
}

std::vector<RobotType> furtherRobots() {
  return {
      {"turtlebot4", "TurtleBot 4", discRobot(0.175, driveLimits(0.31, 0.31, 0.9, 1.9, 7.7), 3.945),
       0.351, mountedLidar(allRoundLidar(640, 12.0, 5.5), -0.04, 0.193, 0.01),
       "turtlebot/turtlebot4-user-manual features.md @f59428c (0.31 m/s; 0.46 m/s without safety), "
       "turtlebot/turtlebot4 @d688175; accelerations of its base, the Create 3. RPLIDAR A1M8: its "
       "rate, noise and height are manufacturer's figures, unverified."},
      {"pepper", "SoftBank Pepper",
       discRobot(0.28, driveLimits(0.35, 0.35, 0.3, 1.0, 0.75), 28.7, Kinematics::Omnidirectional),
       1.21, mountedLidar(sectorLidar(15, 30.0, 5.0, 6.66), 0.056, 0.05, 0.03),
       "ros-naoqi/pepper_robot @60d4e08 (mass: sum of pepper.urdf; range of the laser: the default "
       "of its driver), SoftBank's page of the laser (6.66 Hz). Size, speeds (defaults; 0.55 m/s "
       "and 2 rad/s at most), accelerations: manufacturer's figures, unverified. The lidar is the "
       "front one of three, its beams, position and noise are unverified."},
      {"jackal", "Clearpath Jackal",
       boxRobot(-0.254, 0.254, 0.2159, driveLimits(2.0, 2.0, 20.0, 4.0, 25.0), 18.4), 0.25,
       mountedLidar(sectorLidar(720, 135.0, 10.0, 40.0), 0.12, 0.33, 0.03),
       "clearpathrobotics/cpr-documentation user_manual_jackal.mdx @df69220, clearpath_nav2_demos "
       "@e7a2b36 (footprint), jackal/jackal @c6ab6ca (URDF 16.5 + 4 x 0.48 kg, control.yaml: "
       "accelerations of its controller, less on slippery ground; 720 beams). Skid steering, "
       "modelled as differential drive. Height, and the Hokuyo UST-10LX's range, rate, noise and "
       "position: manufacturer's figures, unverified."},
      {"wheelchair", "Electric wheelchair",
       boxRobot(-0.41, 0.69, 0.325, driveLimits(0.8, 0.4, 0.5, 1.0, 1.5), 200.0), 1.3, std::nullopt,
       "A dealer's page (cnboxin.com: turning radius 20 to 30 in, top speed 3 to 8 mph); the "
       "position of the axle results in 30 in. Size, mass with a person, speeds and accelerations "
       "of autonomous ones: typical figures, unverified; reverse speed and angular acceleration "
       "assumed."},
      {"ackermann_car", "Model car 1/10",
       boxRobot(-0.10, 0.20, 0.08, driveLimits(1.5, 1.0, 1.5, 1.5 / 0.65, 6.0, 0.65), 4.5,
                Kinematics::Ackermann),
       0.2, mountedLidar(sectorLidar(1081, 135.0, 10.0, 40.0), 0.1, 0.15, 0.03),
       "A student project's hardware page (Traxxas Maxx, nishant-zfyii.github.io: footprint, "
       "minimum turning radius 0.65 m). Mass, speed (1 to 2 m/s indoors), lidar: typical figures, "
       "unverified; height, reverse speed and accelerations assumed."},
  };
}

}  // namespace

const std::vector<RobotType>& robotTypes() {
  static const std::vector<RobotType> kTypes = [] {
    std::vector<RobotType> types = firstRobots();
    for (RobotType& type : furtherRobots()) {
      types.push_back(std::move(type));
    }
    return types;
  }();
  return kTypes;
}

const RobotType* findRobotType(const std::string& name) {
  return base::findBy(robotTypes(), &RobotType::name, name);
}

}  // namespace sim2d
