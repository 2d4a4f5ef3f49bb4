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
  std::string space = "/";  // namespace of the node
  BagUse use;               // topics by name; the others of types that tell of people or a robot
};

/// What hunav_start_recording was called with.
struct RecordingAsked {
  std::string tag;
  int runId = 0;
  std::optional<base::Vec2> goal;  // none: a pose that nobody filled in [m]
};

/// HuNavSim's node `hunav_evaluator_node`, in the place of the original: it listens to all that
/// others tell of people, of a robot and of the map, and keeps it as a bag (MCAP) while it is told
/// to. One thread.
class Recorder {
 public:
  using Tell = std::function<void(const base::Diagnostic&)>;
  /// What the services do; within their call.
  struct Services {
    std::function<bool(const RecordingAsked&)> start;  // false: it cannot begin
    std::function<void()> stop;
  };

  /// `tell`: each problem as it is met, and each topic.
  static base::Result<std::unique_ptr<Recorder>> create(const RecorderSettings& settings,
                                                        Services services, Tell tell);
  virtual ~Recorder() = default;
  /// Takes what has come, or comes within this time.
  virtual void spin(Milliseconds atMost) = 0;

  /// From now on all goes into this file, first what is latched (the map, fixed transforms).
  virtual void begin(const std::string& path) = 0;
  /// Empty = the file is in its place.
  virtual base::Diagnostics end() = 0;
  virtual bool isRecording() const = 0;
  virtual bool hasFailed() const = 0;          // to write; end() tells why
  virtual std::uint64_t messages() const = 0;  // of this recording, but for what was latched
};

}  // namespace bridge
