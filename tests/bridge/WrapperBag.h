#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"

/// Recordings as a wrapper of HuNavSim makes them.
namespace wrapper {

constexpr int kSamples = 20;  // 10 per second

inline bridge::builtin_interfaces::Time stampOfSample(int k) {
  return {k / 10, static_cast<std::uint32_t>(k % 10) * 100000000U};
}

inline std::int64_t timeOfSample(int k) {
  return std::int64_t{k} * 100000000;
}

/// A writer of messages of known types.
class Wrapper {
 public:
  explicit Wrapper(const std::string& path) : writer_(bridge::makeMcapWriter(path)) {}

  template <class M>
  void write(const std::string& topic, int sample, const M& message) {
    writeAt(timeOfSample(sample), topic, message);
  }
  template <class M>
  void writeAt(std::int64_t time, const std::string& topic, const M& message) {
    const auto known = channels_.find(topic);
    const std::uint16_t channel = known != channels_.end()
                                      ? known->second
                                      : writer_->addChannel({topic, M::kType, M::kDefinition, {}});
    channels_[topic] = channel;
    writer_->write(channel, time, bridge::encode(message));
  }
  bool finish() { return writer_->finish().empty(); }

 private:
  std::unique_ptr<bridge::BagWriter> writer_;
  std::map<std::string, std::uint16_t> channels_;
};

/// Stands at (2 id, 0) and looks along x; one obstacle point 0.5 m to its left.
inline bridge::hunav_msgs::Agent agentAt(int id, float radius) {
  bridge::hunav_msgs::Agent agent;
  agent.id = id;
  agent.name = "agent" + std::to_string(id);
  agent.groupId = -1;
  agent.radius = radius;
  agent.position.position = {2.0 * id, 0.0, 0.0};
  agent.closestObs = {{2.0 * id, 0.5, 0.0}};
  return agent;
}

/// Messages as a wrapper of HuNavSim publishes them: three people and a robot that stand. `change`
/// modifies a sample.
using Change = std::function<void(int sample, bridge::hunav_msgs::Agents& people,
                                  bridge::hunav_msgs::Agent& robot)>;
inline bool writeWrapper(const std::string& path, const Change& change = {}) {
  Wrapper wrapper(path);
  for (int k = 0; k < kSamples; ++k) {
    bridge::hunav_msgs::Agents people;
    people.header.stamp = stampOfSample(k);
    for (int id = 1; id <= 3; ++id) {
      people.agents.push_back(agentAt(id, 0.3F));
    }
    bridge::hunav_msgs::Agent robot = agentAt(0, 0.35F);
    if (change) {
      change(k, people, robot);
    }
    wrapper.write("/human_states", k, people);
    wrapper.write("/robot_states", k, robot);
  }
  return wrapper.finish();
}

}  // namespace wrapper
