#include "app/bridge/bag/BagTopics.h"

namespace bridge {

/// Panels by the names that Foxglove gives its own: 3D, Plot, RawMessages.
std::string foxgloveLayout() {
  return R"~~~({
  "configById": {
    "3D!hunavsim": {
      "cameraState": {
        "perspective": false,
        "distance": 25,
        "phi": 0,
        "thetaOffset": 0,
        "targetOffset": [0, 0, 0],
        "target": [0, 0, 0],
        "targetOrientation": [0, 0, 0, 1],
        "fovy": 45,
        "near": 0.5,
        "far": 5000
      },
      "followMode": "follow-none",
      "followTf": "map",
      "scene": {"transforms": {"showLabel": false, "axisScale": 0.5}},
      "layers": {"grid": {"layerId": "foxglove.Grid", "visible": true, "frameId": "map"}},
      "topics": {
        "/map": {"visible": true, "colorMode": "map"},
        "/obstacles": {"visible": true},
        "/markers": {"visible": true},
        "/scan": {"visible": true, "colorMode": "flat", "flatColor": "#d0632dff"},
        "/plan": {"visible": true, "type": "line", "lineWidth": 0.08},
        "/goal_pose": {"visible": true},
        "/odom": {"visible": false}
      }
    },
    "Plot!hunavsim": {
      "title": "Speed of the robot",
      "paths": [
        {"value": "/robot_states.linear_vel", "enabled": true, "timestampMethod": "receiveTime", "label": "linear [m/s]"},
        {"value": "/robot_states.angular_vel", "enabled": true, "timestampMethod": "receiveTime", "label": "angular [rad/s]"}
      ],
      "showLegend": true,
      "xAxisVal": "timestamp"
    },
    "RawMessages!hunavsim": {"topicPath": "/human_states", "diffEnabled": false}
  },
  "globalVariables": {},
  "userNodes": {},
  "playbackConfig": {"speed": 1},
  "layout": {
    "direction": "row",
    "first": "3D!hunavsim",
    "second": {
      "direction": "column",
      "first": "Plot!hunavsim",
      "second": "RawMessages!hunavsim",
      "splitPercentage": 40
    },
    "splitPercentage": 68
  }
}
)~~~";
}

}  // namespace bridge
