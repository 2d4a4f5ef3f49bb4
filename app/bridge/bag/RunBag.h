#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/bag/BagTopics.h"
#include "app/bridge/bag/BagWriter.h"
#include "app/bridge/topics/RunTopics.h"
#include "sim2d/trace/Recording.h"

namespace bridge {

/// Name of the metadata record in which our bags keep what messages have no place for: keys
/// "trace.json" and "events.csv", the texts of the files of those names.
constexpr const char* kRunMetadata = "hunavsim";

/// Takes a run while it goes on and writes the states that are recorded, all that `RunTopics` tells
/// but /clock, into one file, which has a temporary name until finish(): a database of rosbag2 when
/// its name ends in .db3, else MCAP.
class RunBag : public sim2d::FrameSink {
 public:
  RunBag(const std::string& path, const sim2d::TraceHeader& header, RunTopicsOptions options);
  /// Somebody came from a source: before the first frame with them.
  void setHeader(sim2d::TraceHeader header) { topics_.setHeader(std::move(header)); }
  bool isRecorded(std::int64_t step) const { return step % recordEvery_ == 0; }
  void append(const sim2d::Frame& frame) override;  // with its inputs and events
  void addInput(const sim2d::Input& input) { topics_.note(input); }
  void addEvent(std::int64_t step, const sim2d::Event& event);

  /// A file could not be written: there is no use in going on.
  bool hasFailed() const { return writer_->hasFailed(); }
  /// `header`: of the whole run. Empty = the file is in its place.
  base::Diagnostics finish(const sim2d::TraceHeader& header);

  /// metadata.yaml of a folder that holds the file under that name.
  std::string metadata(const std::string& name) const;

 private:
  RunTopics topics_;
  std::unique_ptr<BagWriter> writer_;
  std::vector<std::uint16_t> channels_;  // by topic
  int recordEvery_;
  double dt_;
  std::string events_;  // rows of events.csv
};

/// The same of a run that is over. `scans`: of its lidars, in the order of their steps.
base::Diagnostics writeRunBag(const std::string& path, const sim2d::Recording& recording,
                              const std::vector<sim2d::RecordedScan>& scans = {});

}  // namespace bridge
