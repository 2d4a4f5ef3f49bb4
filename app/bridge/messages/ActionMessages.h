#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/GeometryMessages.h"

/// Messages and services of action_msgs, and the action NavigateToPose of nav2_msgs.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::unique_identifier_msgs {

struct UUID {
  static constexpr const char* kType = "unique_identifier_msgs/msg/UUID";

  std::array<std::uint8_t, 16> uuid{};

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("uuid", self.uuid);
  }
};

}  // namespace bridge::unique_identifier_msgs

namespace bridge::action_msgs {

struct GoalInfo {
  static constexpr const char* kType = "action_msgs/msg/GoalInfo";

  unique_identifier_msgs::UUID goalId;
  builtin_interfaces::Time stamp;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("goal_id", self.goalId);
    field("stamp", self.stamp);
  }
};

struct GoalStatus {
  static constexpr const char* kType = "action_msgs/msg/GoalStatus";
  static constexpr std::int8_t kStatusUnknown = 0;
  static constexpr std::int8_t kStatusAccepted = 1;
  static constexpr std::int8_t kStatusExecuting = 2;
  static constexpr std::int8_t kStatusCanceling = 3;
  static constexpr std::int8_t kStatusSucceeded = 4;
  static constexpr std::int8_t kStatusCanceled = 5;
  static constexpr std::int8_t kStatusAborted = 6;

  GoalInfo goalInfo;
  std::int8_t status = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("goal_info", self.goalInfo);
    field("status", self.status);
  }
  template <class F>
  static void constants(F&& constant) {
    constant("STATUS_UNKNOWN", kStatusUnknown);
    constant("STATUS_ACCEPTED", kStatusAccepted);
    constant("STATUS_EXECUTING", kStatusExecuting);
    constant("STATUS_CANCELING", kStatusCanceling);
    constant("STATUS_SUCCEEDED", kStatusSucceeded);
    constant("STATUS_CANCELED", kStatusCanceled);
    constant("STATUS_ABORTED", kStatusAborted);
  }
};

struct GoalStatusArray {
  static constexpr const char* kType = "action_msgs/msg/GoalStatusArray";

  std::vector<GoalStatus> statusList;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("status_list", self.statusList);
  }
};

/// A zero goal_info cancels all goals.
struct CancelGoal {
  static constexpr const char* kType = "action_msgs/srv/CancelGoal";
  struct Request {
    static constexpr const char* kType = "action_msgs/srv/CancelGoal_Request";

    GoalInfo goalInfo;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("goal_info", self.goalInfo);
    }
  };
  struct Response {
    static constexpr const char* kType = "action_msgs/srv/CancelGoal_Response";
    static constexpr std::int8_t kErrorNone = 0;
    static constexpr std::int8_t kErrorRejected = 1;
    static constexpr std::int8_t kErrorUnknownGoalId = 2;
    static constexpr std::int8_t kErrorGoalTerminated = 3;

    std::int8_t returnCode = 0;
    std::vector<GoalInfo> goalsCanceling;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("return_code", self.returnCode);
      field("goals_canceling", self.goalsCanceling);
    }
    template <class F>
    static void constants(F&& constant) {
      constant("ERROR_NONE", kErrorNone);
      constant("ERROR_REJECTED", kErrorRejected);
      constant("ERROR_UNKNOWN_GOAL_ID", kErrorUnknownGoalId);
      constant("ERROR_GOAL_TERMINATED", kErrorGoalTerminated);
    }
  };
};

}  // namespace bridge::action_msgs

namespace bridge::nav2_msgs {

/// The action that sends a Nav2 robot to a pose. Its result type differs between distributions.
struct NavigateToPose {
  static constexpr const char* kType = "nav2_msgs/action/NavigateToPose";
  using GoalId = unique_identifier_msgs::UUID;

  struct Goal {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_Goal";

    geometry_msgs::PoseStamped pose;
    std::string behaviorTree;  // empty: the default tree

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("pose", self.pose);
      field("behavior_tree", self.behaviorTree);
    }
  };
  /// The result in Humble.
  struct HumbleResult {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_Result";

    std_msgs::Empty result;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("result", self.result);
    }
  };
  /// The result in Iron.
  struct IronResult {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_Result";

    std::uint16_t errorCode = 0;  // 0: none

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("error_code", self.errorCode);
    }
  };
  /// The result in Jazzy and later.
  struct JazzyResult {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_Result";

    std::uint16_t errorCode = 0;  // 0: none
    std::string errorMsg;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("error_code", self.errorCode);
      field("error_msg", self.errorMsg);
    }
  };
  /// Later distributions append fields: decode with TrailingBytes::Ignored.
  struct Feedback {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_Feedback";

    geometry_msgs::PoseStamped currentPose;
    builtin_interfaces::Duration navigationTime;
    builtin_interfaces::Duration estimatedTimeRemaining;
    std::int16_t numberOfRecoveries = 0;
    float distanceRemaining = 0;  // [m]

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("current_pose", self.currentPose);
      field("navigation_time", self.navigationTime);
      field("estimated_time_remaining", self.estimatedTimeRemaining);
      field("number_of_recoveries", self.numberOfRecoveries);
      field("distance_remaining", self.distanceRemaining);
    }
  };
  struct FeedbackMessage {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_FeedbackMessage";

    GoalId goalId;
    Feedback feedback;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("goal_id", self.goalId);
      field("feedback", self.feedback);
    }
  };
  struct SendGoal {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_SendGoal";
    struct Request {
      static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_SendGoal_Request";

      GoalId goalId;
      Goal goal;

      template <class Self, class F>
      static void fields(Self& self, F&& field) {
        field("goal_id", self.goalId);
        field("goal", self.goal);
      }
    };
    struct Response {
      static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_SendGoal_Response";

      bool accepted = false;
      builtin_interfaces::Time stamp;

      template <class Self, class F>
      static void fields(Self& self, F&& field) {
        field("accepted", self.accepted);
        field("stamp", self.stamp);
      }
    };
  };
  /// The response is sent when the goal has ended. Result is one of the three types above.
  template <class Result>
  struct GetResult {
    static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_GetResult";
    struct Request {
      static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_GetResult_Request";

      GoalId goalId;

      template <class Self, class F>
      static void fields(Self& self, F&& field) {
        field("goal_id", self.goalId);
      }
    };
    struct Response {
      static constexpr const char* kType = "nav2_msgs/action/NavigateToPose_GetResult_Response";

      std::int8_t status = 0;  // a status of action_msgs/GoalStatus
      Result result;

      template <class Self, class F>
      static void fields(Self& self, F&& field) {
        field("status", self.status);
        field("result", self.result);
      }
    };
  };
};

}  // namespace bridge::nav2_msgs
