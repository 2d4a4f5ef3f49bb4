#include "app/bridge/nodes/RunNode.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/bridge/messages/geometry_msgs.h"
#include "app/bridge/nodes/GoalSender.h"
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

class DdsRunNode final : public RunNode {
 public:
  DdsRunNode(std::unique_ptr<Participant> participant, const sim2d::TraceHeader& header,
             const RunTopicsOptions& options, const RunNodeSettings& settings,
             ReportCallback report)
      : settings_(settings),
        noPeer_(settings.domain),
        participant_(std::move(participant)),
        topics_(header, options),
        report_(std::move(report)),
        node_(*participant_, settings.domain, "/", "hunavsim", {},
              [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); }) {}

  base::Diagnostics start(bool hasRobot);
  void publishState(const sim2d::Frame& frame) override;
  sim2d::StepInputs inputs(const sim2d::Frame& frame) override;
  void reportRejected(const base::Diagnostics& refused) override {
    for (const base::Diagnostic& diagnostic : refused) {
      reportOnce(diagnostic);
    }
  }
  std::uint64_t commands() const override { return commands_; }

 private:
  void subscribeCommands();
  void readAll();
  void publish(const sim2d::Frame& frame);
  void updateGoal(const sim2d::Frame& frame);
  void waitForCommander(const sim2d::Frame& frame);
  void waitForCommand();
  void takeCommand(const geometry_msgs::Twist& twist);
  void takeStamped(const geometry_msgs::TwistStamped& command);
  void takePose(const char* topic, sim2d::InputKind kind, const std_msgs::Header& header,
                const geometry_msgs::Pose& pose);
  void reportOnce(const base::Diagnostic& diagnostic) {
    if (reported_.isNew(problemKey(diagnostic))) {
      if (hasStarted_) {
        report_(diagnostic);
      } else {
        startProblems_.push_back(diagnostic);
      }
    }
  }

  RunNodeSettings settings_;
  NoPeerCheck noPeer_;
  std::unique_ptr<Participant> participant_;
  RunTopics topics_;
  ReportCallback report_;
  base::DiagnosticFilter reported_;
  base::Diagnostics startProblems_;
  bool hasStarted_ = false;
  Node node_;
  std::vector<std::unique_ptr<Publisher>> publishers_;  // one per topic
  std::optional<geometry_msgs::Twist> command_;         // not passed to a step yet
  std::optional<sim2d::Input> moved_, ordered_;         // as command_
  std::uint64_t commands_ = 0;
  const Subscription* driver_ = nullptr;
  std::unique_ptr<GoalSender> goals_;
  std::int64_t publishedTime_ = 0;  // [ns], time of the last published state
  bool isDriven_ = false;           // commands are being received
  bool hasWaited_ = false;          // for the first command
};

base::Diagnostics DdsRunNode::start(bool hasRobot) {
  for (const Topic& topic : topics_.topics()) {
    const Qos qos = topic.isLatched ? Qos::latched() : Qos::keepLast(topic.depth);
    auto made = participant_->publisher(node_.number(), topic.name, std::string(topic.type), qos);
    base::append(startProblems_, made.diagnostics());
    publishers_.push_back(made ? *std::move(made) : nullptr);
  }
  if (hasRobot) {
    subscribeCommands();
    node_.subscribe<geometry_msgs::PoseWithCovarianceStamped>(
        kInitialPose, Qos::input(), [this](const auto& message) {
          takePose(kInitialPose, sim2d::InputKind::Move, message.header, message.pose.pose);
        });
    node_.subscribe<geometry_msgs::PoseStamped>(
        kGoalPose, Qos::input(), [this](const auto& message) {
          takePose(kGoalPose, sim2d::InputKind::Goal, message.header, message.pose);
        });
  }
  if (hasRobot && settings_.sendsGoals) {
    auto made =
        GoalSender::create(*participant_, node_.number(), settings_.domain.distro,
                           [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
    base::append(startProblems_, made.diagnostics());
    goals_ = made ? *std::move(made) : nullptr;
  }
  participant_->publishGraph();
  hasStarted_ = true;
  return startProblems_;
}

void DdsRunNode::subscribeCommands() {
  driver_ = settings_.stampedCommands
                ? node_.subscribe<geometry_msgs::TwistStamped>(
                      "/cmd_vel", Qos::input(),
                      [this](const geometry_msgs::TwistStamped& command) { takeStamped(command); })
                : node_.subscribe<geometry_msgs::Twist>(
                      "/cmd_vel", Qos::input(),
                      [this](const geometry_msgs::Twist& command) { takeCommand(command); });
}

/// In lockstep a command for an earlier state is too late and is ignored.
void DdsRunNode::takeStamped(const geometry_msgs::TwistStamped& command) {
  const builtin_interfaces::Time& stamp = command.header.stamp;
  const bool isStamped = stamp.sec != 0 || stamp.nanosec != 0;
  if (settings_.lockstep && isStamped && nanosecondsOf(stamp) + kSameStamp < publishedTime_) {
    return;
  }
  takeCommand(command.twist);
}

void DdsRunNode::takeCommand(const geometry_msgs::Twist& twist) {
  // The world rejects larger values. The comparison is false for NaN.
  const auto isUsable = [](double value) { return std::fabs(value) <= sim2d::kMaxPlausibleSpeed; };
  if (!isUsable(twist.linear.x) || !isUsable(twist.linear.y) || !isUsable(twist.angular.z)) {
    reportOnce(base::problem(base::Severity::Warning, "ros2.bad-message",
                             {"/cmd_vel", "a number is not finite or above 1000"}));
    return;
  }
  command_ = twist;
  ++commands_;
}

/// The newest input of each kind is passed to the next step.
void DdsRunNode::takePose(const char* topic, sim2d::InputKind kind, const std_msgs::Header& header,
                          const geometry_msgs::Pose& pose) {
  const std::string& frame = header.frameId;
  geometry_msgs::Quaternion q = pose.orientation;
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const bool isUsable =
      std::isfinite(pose.position.x) && std::isfinite(pose.position.y) && std::isfinite(length);
  if (!isUsable || (!frame.empty() && frame != kMapFrame)) {
    reportOnce(
        base::problem(base::Severity::Warning, "ros2.bad-message",
                      {topic, isUsable ? "its frame is not 'map'" : "a number is not finite"}));
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

void DdsRunNode::readAll() {
  for (int i = 0; i < kReadAtMost && participant_->spin(Milliseconds(0)); ++i) {
  }
}

void DdsRunNode::publish(const sim2d::Frame& frame) {
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

void DdsRunNode::updateGoal(const sim2d::Frame& frame) {
  if (goals_ != nullptr) {
    const sim2d::TraceGoal* const goal = topics_.hasExternalGoal(0) ? nullptr : topics_.goalOf(0);
    goals_->update(goal == nullptr ? std::nullopt
                                   : std::optional(bridge::goalOf(goal->position, frame.time)));
  }
}

void DdsRunNode::publishState(const sim2d::Frame& frame) {
  if (const auto diagnostic = noPeer_.check(*participant_)) {
    reportOnce(*diagnostic);
  }
  topics_.track(frame);
  if (settings_.lockstep) {
    readAll();
    command_.reset();  // it answered the previous state
  }
  publishedTime_ = nanosecondsOf(frame.time);
  publish(frame);
  updateGoal(frame);
}

void DdsRunNode::waitForCommander(const sim2d::Frame& frame) {
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
void DdsRunNode::waitForCommand() {
  if (!participant_->spinUntil([this] { return command_.has_value(); }, kLockstepWait)) {
    isDriven_ = false;
    reportOnce(base::problem(base::Severity::Warning, "ros2.lockstep-late",
                             {std::to_string(kLockstepWait.count() / 1000)}));
  }
}

sim2d::StepInputs DdsRunNode::inputs(const sim2d::Frame& frame) {
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

}  // namespace

base::Result<std::unique_ptr<RunNode>> RunNode::create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings,
                                                       ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  auto node = std::make_unique<DdsRunNode>(*std::move(participant), header, options, settings,
                                           std::move(report));
  base::Diagnostics problems = node->start(!header.robots.empty());
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<RunNode>(std::move(node)), std::move(problems)};
}

}  // namespace bridge
