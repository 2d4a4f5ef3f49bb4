#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/bridge/dds/Participant.h"
#include "app/bridge/messages/nav2_msgs.h"

namespace bridge {

/// Sends a robot's goals to Nav2 through the action `navigate_to_pose`, one at a time. A new goal
/// replaces the previous one. A rejected goal is resent after 1 s, because Nav2 can be discovered
/// before it is active. Goals are never canceled. Single-threaded.
class GoalSender {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;

  /// `node`: index of the node. Errors: DDS cannot create the clients.
  static base::Result<std::unique_ptr<GoalSender>> create(Participant& participant, int node,
                                                          Distro distro, ReportCallback report);

  /// Whether the action server is available.
  bool isReady() { return send_->isReady() && result_->isReady(); }
  /// Call repeatedly with the current goal. Sends the goal if it changed and Nav2 is available, and
  /// reads responses.
  void update(const std::optional<geometry_msgs::PoseStamped>& goal);
  /// Whether the newest goal was accepted.
  bool isAccepted() const { return isAccepted_; }

 private:
  GoalSender(std::unique_ptr<Client> send, std::unique_ptr<Client> result, Distro distro,
             ReportCallback report)
      : send_(std::move(send)),
        result_(std::move(result)),
        distro_(distro),
        report_(std::move(report)) {}
  void sendGoal(const geometry_msgs::PoseStamped& goal);
  void readAnswers();
  void readResult(const Bytes& bytes);
  void requestResult();

  std::unique_ptr<Client> send_, result_;
  Distro distro_;
  ReportCallback report_;
  unique_identifier_msgs::UUID id_;
  std::uint64_t sent_ = 0;                            // number of goals sent
  std::optional<geometry_msgs::Point> place_;         // position of the newest goal
  std::int64_t sendNumber_ = -1, resultNumber_ = -1;  // request numbers for the newest goal
  bool isAccepted_ = false;
  std::chrono::steady_clock::time_point retryAt_{};  // earliest time to send the next goal
};

}  // namespace bridge
