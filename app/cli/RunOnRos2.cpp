#include "app/cli/RunOnRos2.h"

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#ifdef HUNAV_ROS2
#include "app/bridge/nodes/RunNode.h"
#endif

namespace app {

void addRunOnRos2Options(CLI::App& command, RunOnRos2Words& words) {
  addRos2Options(command, words.ros2,
                 "Tell the run on topics of ROS 2 in real time; /cmd_vel drives the first robot");
  CLI::Option* const ros2 = command.get_option("--ros2");
  const auto flag = [&](const char* name, bool& given, const char* help) {
    command.add_flag(name, given, help)->needs(ros2);
  };
  flag("--ros2-send-goals", words.sendsGoals,
       "With --ros2: the goals of the first robot go to Nav2 (action navigate_to_pose)");
  flag("--lockstep", words.lockstep,
       "With --ros2: each step waits for the /cmd_vel that follows on it, 2 s at most");
  flag("--stamped", words.stamped, "With --ros2: /cmd_vel is TwistStamped, as from Kilted on");
}

#ifdef HUNAV_ROS2
namespace {

class TopicsOfRun final : public RunOnRos2 {
 public:
  TopicsOfRun(std::unique_ptr<bridge::RunNode> node, const sim2d::World& world)
      : node_(std::move(node)), world_(world) {}
  void tell(const sim2d::Frame& frame) override {
    node_->tellRefused(world_.refused());
    node_->tell(frame);
  }

 private:
  std::unique_ptr<bridge::RunNode> node_;
  const sim2d::World& world_;
};

}  // namespace

std::unique_ptr<RunOnRos2> RunOnRos2::open(const RunOnRos2Words& words,
                                           const sim2d::Scenario& scenario, sim2d::World& world,
                                           Session& session) {
  if (!words.ros2.ros2) {
    return nullptr;
  }
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf(words.ros2);
  requireFine(domain.diagnostics());
  base::Result<std::unique_ptr<bridge::RunNode>> node = bridge::RunNode::create(
      world.header(), bridge::lidarsOf(scenario),
      {*domain, words.stamped, words.lockstep, words.sendsGoals, wasInterrupted},
      [](const base::Diagnostic& said) { printDiagnostics({said}); });
  requireFine(node.diagnostics());
  world.tellScans(true);
  session.setSpeed(1.0);
  session.steer([&to = **node](const sim2d::Frame& frame) { return to.inputs(frame); });
  return std::make_unique<TopicsOfRun>(*std::move(node), world);
}
#else
std::unique_ptr<RunOnRos2> RunOnRos2::open(const RunOnRos2Words& words,
                                           const sim2d::Scenario& /*scenario*/,
                                           sim2d::World& /*world*/, Session& /*session*/) {
  if (words.ros2.ros2) {
    requireFine(domainSettingsOf(words.ros2).diagnostics());
  }
  return nullptr;
}
#endif

}  // namespace app
