#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/HunavMessages.h"

/// Services of hunav_msgs 2.0.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::hunav_msgs {

struct ComputeAgents {
  static constexpr const char* kType = "hunav_msgs/srv/ComputeAgents";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/ComputeAgents_Request";

    Agents currentAgents;
    Agent robot;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("current_agents", self.currentAgents);
      field("robot", self.robot);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/ComputeAgents_Response";

    Agents updatedAgents;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("updated_agents", self.updatedAgents);
    }
  };
};

struct ComputeAgent {
  static constexpr const char* kType = "hunav_msgs/srv/ComputeAgent";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/ComputeAgent_Request";

    std::int32_t id = 0;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("id", self.id);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/ComputeAgent_Response";

    Agent updatedAgent;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("updated_agent", self.updatedAgent);
    }
  };
};

struct MoveAgent {
  static constexpr const char* kType = "hunav_msgs/srv/MoveAgent";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/MoveAgent_Request";

    Agents currentAgents;
    Agent robot;
    std::int32_t agentId = 0;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("current_agents", self.currentAgents);
      field("robot", self.robot);
      field("agent_id", self.agentId);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/MoveAgent_Response";

    Agent updatedAgent;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("updated_agent", self.updatedAgent);
    }
  };
};

struct ResetAgents {
  static constexpr const char* kType = "hunav_msgs/srv/ResetAgents";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/ResetAgents_Request";

    Agents currentAgents;
    Agent robot;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("current_agents", self.currentAgents);
      field("robot", self.robot);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/ResetAgents_Response";

    bool ok = false;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("ok", self.ok);
    }
  };
};

struct GetAgents {
  static constexpr const char* kType = "hunav_msgs/srv/GetAgents";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/GetAgents_Request";

    std::int32_t empty = 0;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("empty", self.empty);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/GetAgents_Response";

    Agents agents;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("agents", self.agents);
    }
  };
};

struct GetParameters {
  static constexpr const char* kType = "hunav_msgs/srv/GetParameters";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/GetParameters_Request";

    template <class Self, class F>
    static void fields(Self& /*self*/, F&& /*field*/) {}
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/GetParameters_Response";

    bool publishPeople = false;
    std::string map;
    std::string simulator;
    std::string yamlBaseName;
    std::vector<std::int64_t> goalIds;
    std::vector<double> goalXCoords;
    std::vector<double> goalYCoords;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("publish_people", self.publishPeople);
      field("map", self.map);
      field("simulator", self.simulator);
      field("yaml_base_name", self.yamlBaseName);
      field("goal_ids", self.goalIds);
      field("goal_x_coords", self.goalXCoords);
      field("goal_y_coords", self.goalYCoords);
    }
  };
};

struct StartEvaluation {
  static constexpr const char* kType = "hunav_msgs/srv/StartEvaluation";
  struct Request {
    static constexpr const char* kType = "hunav_msgs/srv/StartEvaluation_Request";

    geometry_msgs::PoseStamped robotGoal;
    std::string experimentTag = "exp_1";
    std::int32_t runId = 0;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("robot_goal", self.robotGoal);
      field("experiment_tag", self.experimentTag);
      field("run_id", self.runId);
    }
  };
  struct Response {
    static constexpr const char* kType = "hunav_msgs/srv/StartEvaluation_Response";

    bool success = false;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("success", self.success);
    }
  };
};

}  // namespace bridge::hunav_msgs
