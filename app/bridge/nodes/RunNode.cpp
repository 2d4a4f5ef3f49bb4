#include "app/bridge/nodes/RunNode.h"

#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "app/bridge/messages/GeometryMessages.h"

namespace bridge {
namespace {

constexpr Milliseconds kLockstepWait(200);
constexpr int kReadAtMost = 100;  // messages between two steps
constexpr int kFirstRobot = -1;   // its id in frames

class DdsRunNode final : public RunNode {
 public:
  DdsRunNode(std::unique_ptr<Participant> participant, const sim2d::TraceHeader& header,
             const RunTopicsOptions& options, const RunNodeSettings& settings, Tell tell)
      : settings_(settings),
        participant_(std::move(participant)),
        topics_(header, options),
        tell_(std::move(tell)),
        node_(*participant_, settings.domain, "/", "hunavsim", {},
              [this](const base::Diagnostic& said) { tellOnce(said); }) {}

  base::Diagnostics start(bool hasRobot);
  void tell(const sim2d::Frame& frame) override;
  sim2d::StepInputs inputs(const sim2d::Frame& frame) override;
  std::uint64_t commands() const override { return commands_; }

 private:
  void takeCommand(const geometry_msgs::Twist& twist);
  void tellOnce(const base::Diagnostic& said) {
    if (told_.insert(said.text()).second) {
      if (hasStarted_) {
        tell_(said);
      } else {
        startProblems_.push_back(said);
      }
    }
  }

  RunNodeSettings settings_;
  std::unique_ptr<Participant> participant_;
  RunTopics topics_;
  Tell tell_;
  std::set<std::string> told_;
  base::Diagnostics startProblems_;
  bool hasStarted_ = false;
  Node node_;
  std::vector<std::unique_ptr<Publisher>> publishers_;  // by topic
  std::optional<geometry_msgs::Twist> command_;         // not given to a step yet
  std::uint64_t commands_ = 0;
};

base::Diagnostics DdsRunNode::start(bool hasRobot) {
  for (const Topic& topic : topics_.topics()) {
    const Qos qos = topic.isLatched ? Qos::latched() : Qos::keepLast(topic.depth);
    auto made = participant_->publisher(node_.number(), topic.name, std::string(topic.type), qos);
    base::append(startProblems_, made.diagnostics());
    publishers_.push_back(made ? *std::move(made) : nullptr);
  }
  if (hasRobot && settings_.stampedCommands) {
    node_.subscribe<geometry_msgs::TwistStamped>(
        "/cmd_vel", Qos(),
        [this](const geometry_msgs::TwistStamped& command) { takeCommand(command.twist); });
  } else if (hasRobot) {
    node_.subscribe<geometry_msgs::Twist>(
        "/cmd_vel", Qos(), [this](const geometry_msgs::Twist& command) { takeCommand(command); });
  }
  participant_->announce();
  hasStarted_ = true;
  return startProblems_;
}

void DdsRunNode::takeCommand(const geometry_msgs::Twist& twist) {
  const bool isFinite = std::isfinite(twist.linear.x) && std::isfinite(twist.linear.y) &&
                        std::isfinite(twist.angular.z);
  if (!isFinite) {
    tellOnce(base::problem(base::Severity::Warning, "ros2.bad-message",
                           {"/cmd_vel", "a number is not finite"}));
    return;
  }
  command_ = twist;
  ++commands_;
}

void DdsRunNode::tell(const sim2d::Frame& frame) {
  topics_.tell(frame, [this](std::size_t topic, const std::string& bytes) {
    if (publishers_[topic] != nullptr) {
      publishers_[topic]->publish(bytes);
    }
  });
}

sim2d::StepInputs DdsRunNode::inputs(const sim2d::Frame& /*frame*/) {
  for (int i = 0; i < kReadAtMost && participant_->spin(Milliseconds(0)); ++i) {
  }
  if (settings_.lockstep && commands_ > 0) {
    participant_->spinUntil([this] { return command_.has_value(); }, kLockstepWait);
  }
  if (!command_) {
    return {};
  }
  const geometry_msgs::Twist twist = *std::exchange(command_, std::nullopt);
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = kFirstRobot;
  input.velocity = {twist.linear.x, twist.linear.y};
  input.omega = twist.angular.z;
  return {input};
}

}  // namespace

base::Result<std::unique_ptr<RunNode>> RunNode::create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings,
                                                       Tell tell) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  auto node = std::make_unique<DdsRunNode>(*std::move(participant), header, options, settings,
                                           std::move(tell));
  base::Diagnostics problems = node->start(!header.robots.empty());
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<RunNode>(std::move(node)), std::move(problems)};
}

}  // namespace bridge
