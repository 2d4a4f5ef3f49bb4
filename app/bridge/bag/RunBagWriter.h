#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/topics/RunTopics.h"
#include "app/run/RunFolder.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/World.h"

namespace bridge {

/// The name of the metadata record in which hunavsim stores what messages cannot contain: keys
/// "trace.json" and "events.csv", the contents of these files.
constexpr const char* kRunMetadata = "hunavsim";

/// Writes the recorded states of a running simulation, i.e. the topics of `RunTopics` without
/// /clock, to one file: a rosbag2 database if its name ends in .db3, otherwise MCAP. The file has a
/// temporary name until finish().
class RunBagWriter : public sim2d::FrameSink {
 public:
  RunBagWriter(const std::string& path, const sim2d::TraceHeader& header, RunTopicsOptions options);
  /// Call before the first frame that contains an agent spawned by a source.
  void setHeader(sim2d::TraceHeader header) { topics_.setHeader(std::move(header)); }
  bool isRecorded(std::int64_t step) const { return step % recordEvery_ == 0; }
  void append(const sim2d::Frame& frame) override;  // including its inputs and events
  void addInput(const sim2d::Input& input) { topics_.track(input); }
  void addEvent(std::int64_t step, const sim2d::Event& event);

  /// A write failed; there is no need to continue.
  bool hasFailed() const { return writer_->hasFailed(); }
  /// `header`: of the whole run. Empty on success: the file is at its final path.
  base::Diagnostics finish(const sim2d::TraceHeader& header);

  /// The contents of metadata.yaml for a folder that contains the file under this name.
  std::string metadata(const std::string& name) const {
    return writer_->rosbagMetadata(name, "mcap");
  }

 private:
  RunTopics topics_;
  std::unique_ptr<BagWriter> writer_;
  std::vector<std::uint16_t> channels_;  // by topic
  int recordEvery_;
  double dt_;
  std::string events_;  // rows of events.csv
};

/// Writes the bag of a finished run. `scans`: its lidar scans, ordered by step.
base::Diagnostics writeRunBag(const std::string& path, const sim2d::Recording& recording,
                              const std::vector<sim2d::RecordedScan>& scans = {});

/// Files in the folder of a run: a rosbag2 folder and a Foxglove layout.
constexpr const char* kBagFiles[] = {"bag/bag_0.mcap", "bag/metadata.yaml",
                                     "bag/foxglove_layout.json"};

/// A Foxglove layout: the map with people and robots, their speeds, raw messages. The file
/// resources/foxglove_layout.json, embedded by the build.
extern const char* const kFoxgloveLayoutText;

/// Writes the bag of a run in a separate thread, so that the simulation continues while messages
/// are created, compressed and written. The simulation waits only when more than 128 states are
/// queued. Call all functions from the thread of the run.
class BagFolderWriter final : public app::AdditionalRunWriter {
 public:
  /// `staging`: temporary output folder of the run. The world must outlive this object.
  BagFolderWriter(const std::string& staging, const sim2d::Scenario& scenario,
                  const sim2d::World& world);
  ~BagFolderWriter() override;
  BagFolderWriter(const BagFolderWriter&) = delete;
  BagFolderWriter& operator=(const BagFolderWriter&) = delete;
  BagFolderWriter(BagFolderWriter&&) = delete;
  BagFolderWriter& operator=(BagFolderWriter&&) = delete;

  /// Rethrows exceptions of the writer thread (out of memory).
  void append(const sim2d::Frame& frame) override;
  bool hasFailed() const override { return hasFailed_; }
  void conclude(const sim2d::TraceHeader& header) override;
  base::Diagnostics finish(app::OutputFolder& output) override;

 private:
  struct QueuedState {
    sim2d::Frame frame;
    std::optional<sim2d::TraceHeader> header;  // set if the header changed
  };
  /// A batch of states whose memory is reused, because freeing memory in another thread is
  /// expensive.
  struct Batch {
    std::vector<QueuedState> states;
    std::size_t count = 0;  // number of valid states
  };
  void writeQueued();
  void queueBatch();
  bool next(Batch& batch);
  void end();

  const sim2d::World& world_;
  std::string path_;
  sim2d::KnownPeople known_;
  Batch currentBatch_;  // used by the run's thread until the batch is full
  RunBagWriter bag_;    // used by the writer thread until it has ended
  std::atomic<bool> hasFailed_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> queue_;   // batches to be written
  std::vector<Batch> spare_;  // written batches, for reuse
  bool isStopping_ = false;
  std::optional<sim2d::TraceHeader> conclusion_;  // header of the whole run
  base::Diagnostics problems_;                    // of the writer thread
  std::optional<std::string> hash_;               // of the bag file, set by the writer thread
  std::exception_ptr thrown_;
  std::thread thread_;
};

}  // namespace bridge
