#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

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
class Recorder {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;
  /// Callbacks of the services, called while the request is handled.
  struct Services {
    std::function<bool(const RecordingRequest&)> start;  // false: recording cannot start
    std::function<void()> stop;
  };

  /// `report` is called for each distinct problem and each subscribed topic.
  static base::Result<std::unique_ptr<Recorder>> create(const RecorderSettings& settings,
                                                        Services services, ReportCallback report);
  virtual ~Recorder() = default;
  /// Handles pending messages; waits at most `atMost` for the first one.
  virtual void spin(Milliseconds atMost) = 0;

  /// Starts recording to this file. Latched messages (the map, static transforms) are written
  /// first.
  virtual void begin(const std::string& path) = 0;
  /// Closes the file. Empty on success.
  virtual base::Diagnostics end() = 0;
  virtual bool isRecording() const = 0;
  virtual bool hasFailed() const = 0;          // a write failed; end() returns the error
  virtual std::uint64_t messages() const = 0;  // in this recording, without latched messages
};

}  // namespace bridge
