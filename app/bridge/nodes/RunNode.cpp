#include "app/bridge/nodes/RunNode.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/action_msgs.h"
#include "app/bridge/messages/geometry_msgs.h"
#include "app/bridge/messages/nav2_msgs.h"
#include "app/bridge/nodes/Node.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/world/WorldState.h"

namespace bridge {
namespace {

constexpr Milliseconds kLockstepWait(2000);
constexpr Milliseconds kMeetWait(3000), kFirstCommandWait(20000), kTellAgain(200);
constexpr std::int64_t kSameStamp = 1000;  // [ns], tolerance for times that are multiples of a step
constexpr int kReadAtMost = 100;           // messages per step
constexpr double kNoTurn = 1e-9;           // norm of an unset quaternion
constexpr int kFirstRobot = -1;            // its id in frames
constexpr const char* kGoalPose = "/goal_pose";
constexpr const char* kInitialPose = "/initialpose";

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

/// Sends a robot's goals to Nav2 through the action `navigate_to_pose`, one at a time. A new goal
/// replaces the previous one. A rejected goal is resent after 1 s, because Nav2 can be discovered
/// before it is active. Goals are never canceled. Single-threaded.
class GoalSender {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;

  /// `node`: index of the node. Errors: DDS cannot create the clients.
  static base::Result<std::unique_ptr<GoalSender>> create(Participant& participant, int node,
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

  /// Whether the action server is available.
  bool isReady() { return send_->isReady() && result_->isReady(); }
  /// Call repeatedly with the current goal. Sends the goal if it changed and Nav2 is available, and
  /// reads responses.
  void update(const std::optional<geometry_msgs::PoseStamped>& goal) {
    const bool isNew = goal && (!place_ || encode(goal->pose.position) != encode(*place_));
    if (isNew && std::chrono::steady_clock::now() >= retryAt_ && isReady()) {
      sendGoal(*goal);
    }
    readAnswers();
  }
  /// Whether the newest goal was accepted.
  bool isAccepted() const { return isAccepted_; }

 private:
  GoalSender(std::unique_ptr<Client> send, std::unique_ptr<Client> result, Distro distro,
             ReportCallback report)
      : send_(std::move(send)),
        result_(std::move(result)),
        distro_(distro),
        report_(std::move(report)) {}
  void sendGoal(const geometry_msgs::PoseStamped& goal) {
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
  void readAnswers() {
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
  void readResult(const Bytes& bytes) {
    const auto result = read(bytes, distro_);
    if (!result || result->first != Status::kStatusSucceeded) {
      const std::string end = result ? wordOf(result->first) + result->second : "invalid response";
      report_(base::problem(base::Severity::Warning, "ros2.goal-failed", {end}));
    }
  }
  /// Requested immediately, because Nav2 discards results soon.
  void requestResult() {
    Action::GetResult::Request request;
    request.goalId = id_;
    resultNumber_ = result_->send(encode(request));
  }

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

RunNode::RunNode(std::unique_ptr<Participant> participant, const sim2d::TraceHeader& header,
                 const RunTopicsOptions& options, const RunNodeSettings& settings,
                 ReportCallback report)
    : NodeProgram(std::move(participant), settings.domain, std::move(report)),
      settings_(settings),
      topics_(header, options),
      node_(makeNode("/", "hunavsim", {})) {}

void RunNode::reportRejected(const base::Diagnostics& refused) {
  for (const base::Diagnostic& diagnostic : refused) {
    reportOnce(diagnostic);
  }
}

void RunNode::warnOfMessage(const char* topic, const char* reason) {
  reportOnce(base::problem(base::Severity::Warning, "ros2.bad-message", {topic, reason}));
}

base::Diagnostics RunNode::start(bool hasRobot) {
  for (const Topic& topic : topics_.topics()) {
    const Qos qos = topic.isLatched ? Qos::latched() : Qos::keepLast(topic.depth);
    auto made = participant_->publisher(node_->number(), topic.name, std::string(topic.type), qos);
    base::append(startProblems_, made.diagnostics());
    publishers_.push_back(made ? *std::move(made) : nullptr);
  }
  if (hasRobot) {
    subscribeCommands();
    node_->subscribe<geometry_msgs::PoseWithCovarianceStamped>(
        kInitialPose, Qos::input(), [this](const auto& message) {
          takePose(kInitialPose, sim2d::InputKind::Move, message.header, message.pose.pose);
        });
    node_->subscribe<geometry_msgs::PoseStamped>(
        kGoalPose, Qos::input(), [this](const auto& message) {
          takePose(kGoalPose, sim2d::InputKind::Goal, message.header, message.pose);
        });
  }
  if (hasRobot && settings_.sendsGoals) {
    auto made =
        GoalSender::create(*participant_, node_->number(), settings_.domain.distro,
                           [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
    base::append(startProblems_, made.diagnostics());
    goals_ = made ? *std::move(made) : nullptr;
  }
  return finishStart();
}

void RunNode::subscribeCommands() {
  driver_ = settings_.stampedCommands
                ? node_->subscribe<geometry_msgs::TwistStamped>(
                      "/cmd_vel", Qos::input(),
                      [this](const geometry_msgs::TwistStamped& command) { takeStamped(command); })
                : node_->subscribe<geometry_msgs::Twist>(
                      "/cmd_vel", Qos::input(),
                      [this](const geometry_msgs::Twist& command) { takeCommand(command); });
}

/// In lockstep a command for an earlier state is too late and is ignored.
void RunNode::takeStamped(const geometry_msgs::TwistStamped& command) {
  const builtin_interfaces::Time& stamp = command.header.stamp;
  const bool isStamped = stamp.sec != 0 || stamp.nanosec != 0;
  if (settings_.lockstep && isStamped && nanosecondsOf(stamp) + kSameStamp < publishedTime_) {
    return;
  }
  takeCommand(command.twist);
}

void RunNode::takeCommand(const geometry_msgs::Twist& twist) {
  // The world rejects larger values. The comparison is false for NaN.
  const auto isUsable = [](double value) { return std::fabs(value) <= sim2d::kMaxPlausibleSpeed; };
  if (!isUsable(twist.linear.x) || !isUsable(twist.linear.y) || !isUsable(twist.angular.z)) {
    warnOfMessage("/cmd_vel", "a number is not finite or above 1000");
    return;
  }
  command_ = twist;
  ++commands_;
}

/// The newest input of each kind is passed to the next step.
void RunNode::takePose(const char* topic, sim2d::InputKind kind, const std_msgs::Header& header,
                       const geometry_msgs::Pose& pose) {
  const std::string& frame = header.frameId;
  geometry_msgs::Quaternion q = pose.orientation;
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const bool isUsable =
      std::isfinite(pose.position.x) && std::isfinite(pose.position.y) && std::isfinite(length);
  if (!isUsable || (!frame.empty() && frame != kMapFrame)) {
    warnOfMessage(topic, isUsable ? "its frame is not 'map'" : "a number is not finite");
    return;
  }
  sim2d::Input input;
  input.kind = kind;
  input.id = kFirstRobot;
  if (length > kNoTurn) {
    q = {q.x / length, q.y / length, q.z / length, q.w / length};
  }
  input.pose = {{pose.position.x, pose.position.y}, headingOf(q)};
  (kind == sim2d::InputKind::Move ? moved_ : ordered_) = input;
}

void RunNode::readAll() {
  for (int i = 0; i < kReadAtMost && participant_->spin(Milliseconds(0)); ++i) {
  }
}

void RunNode::publish(const sim2d::Frame& frame) {
  const auto send = [this](std::size_t topic, const std::string& bytes) {
    if (publishers_[topic] != nullptr) {
      publishers_[topic]->publish(bytes);
    }
  };
  // Latched messages are always published, except external goals: Nav2 would take a republished
  // goal for a new one.
  const auto isHeard = [this](std::size_t topic) {
    if (topics_.topics()[topic].name == kGoalPose && topics_.hasExternalGoal(0)) {
      return false;
    }
    return publishers_[topic] != nullptr && publishers_[topic]->hasReceivers();
  };
  topics_.publish(frame, send, isHeard);
}

void RunNode::updateGoal(const sim2d::Frame& frame) {
  if (goals_ != nullptr) {
    const sim2d::TraceGoal* const goal = topics_.hasExternalGoal(0) ? nullptr : topics_.goalOf(0);
    goals_->update(goal == nullptr ? std::nullopt
                                   : std::optional(bridge::goalOf(goal->position, frame.time)));
  }
}

void RunNode::publishState(const sim2d::Frame& frame) {
  reportMissingPeers();
  topics_.track(frame);
  if (settings_.lockstep) {
    readAll();
    command_.reset();  // it answered the previous state
  }
  publishedTime_ = nanosecondsOf(frame.time);
  publish(frame);
  updateGoal(frame);
}

void RunNode::waitForCommander(const sim2d::Frame& frame) {
  if (!settings_.lockstep || driver_ == nullptr || std::exchange(hasWaited_, true)) {
    return;
  }
  const auto isStopped = [this] { return settings_.wantsStop && settings_.wantsStop(); };
  const auto isMet = [this] {
    return driver_->matched() > 0 && (goals_ == nullptr || goals_->isReady());
  };
  reportOnce(base::problem(base::Severity::Info, "ros2.waits"));
  participant_->spinUntil([&] { return isMet() || isStopped(); }, kMeetWait);
  if (!isMet()) {
    return;
  }
  const auto until = std::chrono::steady_clock::now() + kFirstCommandWait;
  const auto isDriven = [this] {
    return commands_ > 0 && (goals_ == nullptr || goals_->isAccepted());
  };
  while (!isDriven() && !isStopped() && std::chrono::steady_clock::now() < until) {
    publish(frame);
    updateGoal(frame);
    participant_->spinUntil([&] { return isDriven(); }, kTellAgain);
  }
  // Commands that answer earlier publications may still arrive. The answer to the last one counts.
  participant_->spinUntil([] { return false; }, kTellAgain);
  publish(frame);
  participant_->spinUntil([] { return false; }, kTellAgain);
}

/// Commands may stop when a goal is reached; the run continues.
void RunNode::waitForCommand() {
  if (!participant_->spinUntil([this] { return command_.has_value(); }, kLockstepWait)) {
    isDriven_ = false;
    reportOnce(base::problem(base::Severity::Warning, "ros2.lockstep-late",
                             {std::to_string(kLockstepWait.count() / 1000)}));
  }
}

sim2d::StepInputs RunNode::inputs(const sim2d::Frame& frame) {
  waitForCommander(frame);
  readAll();
  updateGoal(frame);
  isDriven_ = isDriven_ || command_.has_value();
  if (settings_.lockstep && isDriven_) {
    waitForCommand();
  }
  sim2d::StepInputs inputs;
  for (std::optional<sim2d::Input>* const each : {&moved_, &ordered_}) {
    if (*each) {
      inputs.push_back(*std::exchange(*each, std::nullopt));
    }
  }
  if (!command_) {
    return inputs;
  }
  const geometry_msgs::Twist twist = *std::exchange(command_, std::nullopt);
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = kFirstRobot;
  input.velocity = {twist.linear.x, twist.linear.y};
  input.omega = twist.angular.z;
  inputs.push_back(input);
  return inputs;
}

base::Result<std::unique_ptr<RunNode>> RunNode::create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings,
                                                       ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  std::unique_ptr<RunNode> node(
      new RunNode(*std::move(participant), header, options, settings, std::move(report)));
  base::Diagnostics problems = node->start(!header.robots.empty());
  return base::resultOf(std::move(node), std::move(problems));
}

}  // namespace bridge
