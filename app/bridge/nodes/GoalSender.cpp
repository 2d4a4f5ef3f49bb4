#include "app/bridge/nodes/GoalSender.h"

#include <random>
#include <string>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/action_msgs.h"

namespace bridge {
namespace {

using Action = nav2_msgs::NavigateToPose;
using Status = action_msgs::GoalStatus;

constexpr std::chrono::seconds kAgainAfter(1);  // after a rejected goal
constexpr const char* kSend = "navigate_to_pose/_action/send_goal";
constexpr const char* kResult = "navigate_to_pose/_action/get_result";

/// A unique id: the first 8 bytes are random per process, the last 8 bytes are a counter.
unique_identifier_msgs::UUID newId(std::uint64_t count) {
  static const std::uint64_t kOwn = [] {
    std::random_device device;
    return (std::uint64_t{device()} << 32U) | device();
  }();
  unique_identifier_msgs::UUID id;
  constexpr unsigned kByte = 8;
  for (unsigned k = 0; k < kByte; ++k) {
    id.uuid[k] = static_cast<std::uint8_t>(kOwn >> (kByte * k));
    id.uuid[kByte + k] = static_cast<std::uint8_t>(count >> (kByte * k));
  }
  return id;
}

const char* wordOf(std::int8_t status) {
  return status == Status::kStatusCanceled  ? "canceled"
         : status == Status::kStatusAborted ? "aborted"
                                            : "unknown status";
}

/// The status and Nav2's error text: a code from Iron on, also a message from Jazzy on.
template <class NavigateToPose, class Words>
std::optional<std::pair<std::int8_t, std::string>> read(const Bytes& bytes, Words words) {
  const auto response =
      decode<typename NavigateToPose::GetResult::Response>(bytes, TrailingBytes::Ignored);
  return response ? std::optional(std::pair(response->status, words(response->result)))
                  : std::nullopt;
}

std::optional<std::pair<std::int8_t, std::string>> read(const Bytes& bytes, Distro distro) {
  if (distro == Distro::Humble) {
    return read<Action>(bytes, [](const auto&) { return std::string(); });
  }
  const auto withText = read<nav2_msgs::JazzyNavigateToPose>(bytes, [](const auto& result) {
    return " (" + std::to_string(result.errorCode) +
           (result.errorMsg.empty() ? "" : ": " + result.errorMsg) + ")";
  });
  return withText ? withText : read<nav2_msgs::IronNavigateToPose>(bytes, [](const auto& result) {
    return " (" + std::to_string(result.errorCode) + ")";
  });
}

}  // namespace

base::Result<std::unique_ptr<GoalSender>> GoalSender::create(Participant& participant, int node,
                                                             Distro distro, ReportCallback report) {
  auto send = participant.client(node, kSend, Action::SendGoal::kType);
  auto result = participant.client(node, kResult, Action::GetResult::kType);
  base::Diagnostics problems = send.diagnostics();
  base::append(problems, result.diagnostics());
  if (!send || !result) {
    return problems;
  }
  return std::unique_ptr<GoalSender>(
      new GoalSender(*std::move(send), *std::move(result), distro, std::move(report)));
}

void GoalSender::update(const std::optional<geometry_msgs::PoseStamped>& goal) {
  const bool isNew = goal && (!place_ || encode(goal->pose.position) != encode(*place_));
  if (isNew && std::chrono::steady_clock::now() >= retryAt_ && isReady()) {
    sendGoal(*goal);
  }
  readAnswers();
}

void GoalSender::sendGoal(const geometry_msgs::PoseStamped& goal) {
  id_ = newId(++sent_);
  isAccepted_ = false;
  resultNumber_ = -1;
  Action::SendGoal::Request request;
  request.goalId = id_;
  request.goal.pose = goal;
  sendNumber_ = send_->send(encode(request));
  if (sendNumber_ >= 0) {
    place_ = goal.pose.position;
  }
}

void GoalSender::readAnswers() {
  while (const auto answer = send_->receive()) {
    if (answer->first != sendNumber_) {
      continue;  // response to an earlier goal
    }
    const auto response = decode<Action::SendGoal::Response>(answer->second);
    isAccepted_ = response && response->accepted;
    if (isAccepted_) {
      requestResult();
    } else {
      place_.reset();
      retryAt_ = std::chrono::steady_clock::now() + kAgainAfter;
      report_(base::problem(base::Severity::Warning, "ros2.goal-refused"));
    }
  }
  while (const auto answer = result_->receive()) {
    if (answer->first == resultNumber_) {
      readResult(answer->second);
    }
  }
}

/// Requested immediately, because Nav2 discards results soon.
void GoalSender::requestResult() {
  Action::GetResult::Request request;
  request.goalId = id_;
  resultNumber_ = result_->send(encode(request));
}

void GoalSender::readResult(const Bytes& bytes) {
  const auto result = read(bytes, distro_);
  if (!result || result->first != Status::kStatusSucceeded) {
    const std::string end = result ? wordOf(result->first) + result->second : "invalid response";
    report_(base::problem(base::Severity::Warning, "ros2.goal-failed", {end}));
  }
}

}  // namespace bridge
