#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/GracefulController.h"

/// Keys of docking_server and following_server (nav2_docking: opennav_docking, opennav_following).
namespace sim2d::nav2 {

/// Keys `controller.…` of both servers: the graceful control law and its collision check.
struct DockControllerParameters : GracefulParameters {
  DockControllerParameters() {
    kPhi = 3.0;
    kDelta = 2.0;
    maxLinear = 0.25;
    maxAngular = 0.75;
    slowdownRadius = 0.25;
  }

  double rotationSpeed = 1.0;                             // [rad/s], in place
  double rotationAcceleration = 3.2;                      // [rad/s²]
  double projectionTime = 5.0, simulationTimeStep = 0.1;  // [s]
  double dockCollisionThreshold = 0.3;                    // [m], no checks within this distance
};

/// A dock class: SimpleChargingDock or SimpleNonChargingDock.
struct DockPluginParameters {
  std::string name;                                      // "simple_charging_dock"
  bool isCharger = true;                                 // determined by its class
  double stagingXOffset = -0.7, stagingYawOffset = 0.0;  // [m], [rad]
  double dockingThreshold = 0.05;                        // [m]
  double chargingThreshold = 0.5;                        // [A]
  bool usesBatteryStatus = true;
  bool usesDetection = false;     // use_external_detection_pose
  double detectionTimeout = 1.0;  // [s]
  double filterCoef = 0.1;
  std::string direction = "forward";  // dock_direction, since Kilted
  bool rotatesToDock = false;         // since Kilted

  bool isBackward() const { return direction == "backward"; }
};

/// A dock from the parameter file or the scenario.
struct DockInstance {
  std::string name;  // "home_dock"
  std::string type;  // name of its plugin; empty: the only one
  std::string frame = "map";
  base::Pose2 pose;  // pose of the docked robot [m], [rad]
};

struct DockingServerParameters : DockControllerParameters {
  double controllerFrequency = 50.0;                                   // [Hz]
  double initialPerceptionTimeout = 5.0;                               // [s]
  double waitChargeTimeout = 5.0;                                      // [s]
  double dockApproachTimeout = 30.0;                                   // [s]
  double rotateToDockTimeout = 10.0;                                   // [s], since Kilted
  double undockLinearTolerance = 0.05, undockAngularTolerance = 0.05;  // [m], [rad]
  double rotationAngularTolerance = 0.05;                              // [rad], since Kilted
  double dockPrestagingTolerance = 0.5;                                // [m]
  int maxRetries = 3;
  bool dockBackwards = false;     // Jazzy, Kilted
  bool hasDockBackwards = false;  // the key is given; in Kilted it then applies to every dock
  std::vector<std::string> dockPlugins, docks;
  std::string dockDatabase;  // a YAML file with `docks`

  std::vector<DockPluginParameters> plugins;  // in the order of dock_plugins
  std::vector<DockInstance> instances;        // in the order of docks
};

struct FollowingServerParameters : DockControllerParameters {
  FollowingServerParameters() { usesCollisionDetection = false; }

  double controllerFrequency = 50.0;                       // [Hz]
  double desiredDistance = 1.0;                            // [m]
  double detectionTimeout = 2.0;                           // [s]
  double rotateToObjectTimeout = 10.0;                     // [s]
  double staticObjectTimeout = -1.0;                       // [s], < 0: never
  double linearTolerance = 0.15, angularTolerance = 0.15;  // [m], [rad]
  int maxRetries = 3;
  bool skipOrientation = true;  // ignores the object's heading
  bool searchByRotating = false;
  double searchAngle = base::kPi / 2.0;  // [rad], to each side
  double filterCoef = 0.1;
};

Nav2Keys<DockingServerParameters> dockingServerKeys();
IgnoredKeys ignoredDockingServerKeys();
Nav2Keys<DockPluginParameters> dockPluginKeys();
IgnoredKeys ignoredDockPluginKeys();
/// Keys of SimpleNonChargingDock, which has no battery keys.
Nav2Keys<DockPluginParameters> nonChargingDockKeys();
Nav2Keys<FollowingServerParameters> followingServerKeys();
IgnoredKeys ignoredFollowingServerKeys();

/// Errors in values for which a robot cannot be controlled; each names its key.
base::Diagnostics problemsOf(const DockingServerParameters& parameters);
base::Diagnostics problemsOf(const FollowingServerParameters& parameters);
base::Diagnostics problemsOf(const DockPluginParameters& plugin);

}  // namespace sim2d::nav2
