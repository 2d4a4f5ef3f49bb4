#pragma once

#include <string>

#include "app/bridge/bag/RunBag.h"
#include "app/run/RunFolder.h"
#include "sim2d/world/World.h"

namespace bridge {

/// Names in the folder of a run: a folder of rosbag2, and a layout to look at it with.
constexpr const char* kBagFiles[] = {"bag/bag_0.mcap", "bag/metadata.yaml",
                                     "bag/foxglove_layout.json"};

/// Makes the bag of a run beside its other files.
class RunBagFolder final : public app::RunCompanion {
 public:
  /// `staging`: of the run's output. The world must outlive this.
  RunBagFolder(const std::string& staging, const sim2d::Scenario& scenario,
               const sim2d::World& world);

  void append(const sim2d::Frame& frame) override { bag_.append(frame); }
  bool hasFailed() const override { return bag_.hasFailed(); }
  base::Diagnostics finish(app::OutputFolder& output, const sim2d::TraceHeader& header) override;

 private:
  RunBag bag_;
};

}  // namespace bridge
