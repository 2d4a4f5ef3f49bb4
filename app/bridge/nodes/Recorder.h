#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"
#include "app/bridge/nodes/Node.h"
#include "sim2d/base/Types.h"

namespace bridge {

struct RecorderSettings {
  DomainSettings domain;
  std::string nameSpace = "/";  // namespace of the node
  BagTopicOptions use;          // topics by name; others by type (people, robot)
};

/// The arguments of a hunav_start_recording request.
struct RecordingRequest {
  std::string tag;
  int runId = 0;
  std::optional<base::Vec2> goal;  // [m]; none: the pose was not set
};

/// Replacement of HuNavSim's node `hunav_evaluator_node`. It subscribes to all topics about people,
/// a robot or the map and writes them to a bag (MCAP) between start and stop. Single-threaded.
class Recorder : public NodeProgram {
 public:
  /// Callbacks of the services, called while the request is handled.
  struct Services {
    std::function<bool(const RecordingRequest&)> start;  // false: recording cannot start
    std::function<void()> stop;
  };

  /// `report` is called for each distinct problem and each subscribed topic.
  static base::Result<std::unique_ptr<Recorder>> create(const RecorderSettings& settings,
                                                        Services services, ReportCallback report);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  Recorder(Recorder&&) = delete;
  Recorder& operator=(Recorder&&) = delete;
  /// Handles pending messages; waits at most `atMost` for the first one.
  void spin(Milliseconds atMost);

  /// Starts recording to this file. Latched messages (the map, static transforms) are written
  /// first.
  void begin(const std::string& path);
  /// Closes the file. Empty on success.
  base::Diagnostics end();
  bool isRecording() const { return writer_ != nullptr; }
  bool hasFailed() const { return isRecording() && writer_->hasFailed(); }  // end() has the error
  std::uint64_t messages() const { return messages_; }  // in this recording, without latched ones

 private:
  struct SubscribedTopic;

  Recorder(const RecorderSettings& settings, std::unique_ptr<Participant> participant,
           Services services, ReportCallback report);
  void createServices();
  void subscribeNewTopics();
  void subscribe(const RemoteTopic& topic);
  void take(SubscribedTopic& from, const Bytes& bytes);
  void write(SubscribedTopic& from, const Bytes& bytes);

  BagTopicOptions use_;
  Services services_;
  std::vector<std::unique_ptr<SubscribedTopic>> subscribed_;
  std::size_t processedTopics_ = 0;  // number of remote topics processed
  std::unique_ptr<BagWriter> writer_;
  std::uint64_t messages_ = 0;
  std::unique_ptr<Node> node_;  // last member: its subscriptions call this object
};

}  // namespace bridge
