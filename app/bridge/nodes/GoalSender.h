#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/bridge/dds/Participant.h"
#include "app/bridge/messages/ActionMessages.h"

namespace bridge {

/// Sends a robot's goals to Nav2 by its action `navigate_to_pose`, one after the other: a new goal
/// takes the place of the one before, and one that is refused is sent again a second later (Nav2 is
/// there before it is active). Nothing is canceled. One thread.
class GoalSender {
 public:
  using Tell = std::function<void(const base::Diagnostic&)>;

  /// `node`: its number. Error: DDS refuses.
  static base::Result<std::unique_ptr<GoalSender>> create(Participant& participant, int node,
                                                          Distro distro, Tell tell);

  /// Nav2 can be reached.
  bool isReady() { return send_->isReady() && result_->isReady(); }
  /// To be called again and again with the goal of the moment: what differs from the one before is
  /// sent when Nav2 can be reached. Reads the answers.
  void follow(const std::optional<geometry_msgs::PoseStamped>& goal);
  /// The newest goal was sent and taken.
  bool isAccepted() const { return isAccepted_; }

 private:
  GoalSender(std::unique_ptr<Client> send, std::unique_ptr<Client> result, Distro distro, Tell tell)
      : send_(std::move(send)),
        result_(std::move(result)),
        distro_(distro),
        tell_(std::move(tell)) {}
  void sendGoal(const geometry_msgs::PoseStamped& goal);
  void readAnswers();
  void readResult(const Bytes& bytes);
  void askForResult();

  std::unique_ptr<Client> send_, result_;
  Distro distro_;
  Tell tell_;
  nav2_msgs::NavigateToPose::GoalId id_;
  std::uint64_t sent_ = 0;                            // goals
  std::optional<geometry_msgs::Point> place_;         // of the newest one
  std::int64_t sendNumber_ = -1, resultNumber_ = -1;  // of the requests for it
  bool isAccepted_ = false;
  std::chrono::steady_clock::time_point notBefore_{};  // of the next goal
};

}  // namespace bridge
