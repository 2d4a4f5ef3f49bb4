#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "app/bridge/bag/RunBag.h"
#include "app/run/RunFolder.h"
#include "sim2d/world/World.h"

namespace bridge {

/// Names in the folder of a run: a folder of rosbag2, and a layout to look at it with.
constexpr const char* kBagFiles[] = {"bag/bag_0.mcap", "bag/metadata.yaml",
                                     "bag/foxglove_layout.json"};

/// Makes the bag of a run beside its other files, in a thread of its own: the run goes on while
/// messages are made, compressed and written, and waits only when many states (128) are still to be
/// taken; no more than that are kept, but for the batches at hand. All calls come from the thread
/// of the run.
class RunBagFolder final : public app::RunCompanion {
 public:
  /// `staging`: of the run's output. The world must outlive this.
  RunBagFolder(const std::string& staging, const sim2d::Scenario& scenario,
               const sim2d::World& world);
  ~RunBagFolder() override;
  RunBagFolder(const RunBagFolder&) = delete;
  RunBagFolder& operator=(const RunBagFolder&) = delete;
  RunBagFolder(RunBagFolder&&) = delete;
  RunBagFolder& operator=(RunBagFolder&&) = delete;

  /// Throws what the thread has met (out of memory).
  void append(const sim2d::Frame& frame) override;
  bool hasFailed() const override { return hasFailed_; }
  void conclude(const sim2d::TraceHeader& header) override;
  base::Diagnostics finish(app::OutputFolder& output) override;

 private:
  struct Taken {
    sim2d::Frame frame;
    std::optional<sim2d::TraceHeader> header;  // a newer one
  };
  /// States whose memory is used again: that of one thread given back by another is dear.
  struct Batch {
    std::vector<Taken> states;
    std::size_t count = 0;  // of them that are new
  };
  bool meetsSomebody(const sim2d::Frame& frame);
  void work();
  void handOver();
  bool next(Batch& batch);
  void end();

  const sim2d::World& world_;
  std::string path_;
  std::set<int> known_;  // people of the header
  Batch gathered_;       // of the run, until they are enough to hand over
  RunBag bag_;           // of the thread, until it has ended
  std::atomic<bool> hasFailed_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> waiting_;  // to be taken
  std::vector<Batch> spare_;   // taken, their memory for others
  bool isOver_ = false;
  std::optional<sim2d::TraceHeader> conclusion_;  // of the whole run
  base::Diagnostics problems_;                    // of the thread
  std::optional<std::string> hash_;               // of the bag's file, by the thread
  std::exception_ptr thrown_;
  std::thread thread_;
};

}  // namespace bridge
