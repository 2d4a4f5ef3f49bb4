#include "app/bridge/bag/RunBagWriter.h"

#include <cassert>
#include <filesystem>
#include <limits>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/topics/RunMessages.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"

namespace bridge {
namespace {

RunTopicsOptions withoutClock(RunTopicsOptions options) {
  options.clock = false;
  return options;
}

constexpr int kKeepLast = 1, kReliable = 1, kTransientLocal = 1, kVolatile = 2, kAutomatic = 1;
constexpr const char* kForEver = "\n    sec: 9223372036\n    nsec: 854775807\n";

/// The offered QoS profile of the topic as YAML.
std::string offeredQos(const Topic& topic) {
  const auto line = [](const char* key, int value) {
    return std::string(key) + ": " + std::to_string(value) + "\n";
  };
  return line("- history", kKeepLast) + line("  depth", topic.depth) +
         line("  reliability", kReliable) +
         line("  durability", topic.isLatched ? kTransientLocal : kVolatile) +
         "  deadline:" + kForEver + "  lifespan:" + kForEver + line("  liveliness", kAutomatic) +
         "  liveliness_lease_duration:" + kForEver + "  avoid_ros_namespace_conventions: false";
}

std::unique_ptr<BagWriter> writerOf(const std::string& path) {
  if (base::toLower(std::filesystem::path(path).extension().string()) == ".db3") {
    return makeSqliteBagWriter(path);
  }
  return makeMcapWriter(path);
}

}  // namespace

RunBagWriter::RunBagWriter(const std::string& path, const sim2d::TraceHeader& header,
                           RunTopicsOptions options)
    : topics_(header, withoutClock(std::move(options))),
      writer_(writerOf(path)),
      recordEvery_(header.recordEvery),
      dt_(header.dt),
      events_(sim2d::headerLine(sim2d::kEventColumns)) {
  for (const Topic& topic : topics_.topics()) {
    const KnownType* const type = findType(topic.type);
    channels_.push_back(writer_->addChannel(
        {topic.name, std::string(topic.type), type->definition, offeredQos(topic)}));
  }
}

void RunBagWriter::addEvent(std::int64_t step, const sim2d::Event& event) {
  topics_.track(event);
  sim2d::appendEventRow(events_, step, dt_, event);
}

void RunBagWriter::append(const sim2d::Frame& frame) {
  for (const sim2d::Input& input : frame.inputs) {
    addInput(input);
  }
  for (const sim2d::Event& event : frame.events) {
    addEvent(frame.step, event);
  }
  if (!isRecorded(frame.step)) {
    return;
  }
  const std::int64_t time = nanosecondsOf(frame.time);
  topics_.publish(frame, [&](std::size_t topic, const std::string& bytes) {
    writer_->write(channels_[topic], time, bytes);
  });
}

base::Diagnostics RunBagWriter::finish(const sim2d::TraceHeader& header) {
  writer_->addMetadata(kRunMetadata,
                       {{"trace.json", sim2d::traceJson(header)}, {"events.csv", events_}});
  return writer_->finish();
}

base::Diagnostics writeRunBag(const std::string& path, const sim2d::Recording& recording,
                              const std::vector<sim2d::RecordedScan>& scans) {
  const sim2d::TraceHeader header = *recording.header();
  RunBagWriter bag(path, header, {});
  std::size_t event = 0;
  std::size_t input = 0;
  const auto addUntil = [&](std::int64_t step) {
    for (; event < recording.events().size() && recording.events()[event].first <= step; ++event) {
      const auto& [itsStep, its] = recording.events()[event];
      for (; input < recording.inputs().size() && recording.inputs()[input].first <= itsStep;
           ++input) {
        bag.addInput(recording.inputs()[input].second);
      }
      bag.addEvent(itsStep, its);
    }
    for (; input < recording.inputs().size() && recording.inputs()[input].first <= step; ++input) {
      bag.addInput(recording.inputs()[input].second);
    }
  };
  auto scan = scans.begin();
  for (std::size_t k = recording.first(); k < recording.size() && !bag.hasFailed(); ++k) {
    sim2d::Frame frame = *recording.frame(k);
    for (; scan != scans.end() && scan->step < frame.step; ++scan) {  // of the previous state
      frame.scans.push_back(*scan);
    }
    addUntil(frame.step);
    bag.append(frame);
  }
  addUntil(std::numeric_limits<std::int64_t>::max());
  return bag.finish(header);
}

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kTogether = 16;  // states per batch
constexpr std::size_t kWaiting = 8;    // max. batches; covers compressing one chunk

}  // namespace

BagFolderWriter::BagFolderWriter(const std::string& staging, const sim2d::Scenario& scenario,
                                 const sim2d::World& world)
    : world_(world),
      path_((fs::path(staging) / kBagFiles[0]).string()),
      known_(world.header()),
      bag_(path_, world.header(), lidarsOf(scenario)) {
  thread_ = std::thread([this] { writeQueued(); });
}

BagFolderWriter::~BagFolderWriter() {
  end();
}

void BagFolderWriter::append(const sim2d::Frame& frame) {
  const bool isRecorded = bag_.isRecorded(frame.step);
  if (!isRecorded && frame.events.empty() && frame.inputs.empty()) {
    return;
  }
  if (currentBatch_.count == currentBatch_.states.size()) {
    currentBatch_.states.emplace_back();
  }
  QueuedState& queued = currentBatch_.states[currentBatch_.count++];
  queued.header.reset();
  if (isRecorded) {
    queued.frame = frame;
    if (known_.addNew(frame)) {
      queued.header = world_.header();
    }
  } else {
    queued.frame.step = frame.step;
    queued.frame.events = frame.events;
    queued.frame.inputs = frame.inputs;
  }
  if (currentBatch_.count == kTogether) {
    queueBatch();
  }
}

/// Queues the batch. Waits if too many batches are queued.
void BagFolderWriter::queueBatch() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock,
                [this] { return queue_.size() < kWaiting || thrown_ != nullptr || isStopping_; });
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  queue_.push_back(std::move(currentBatch_));
  currentBatch_ = {};
  if (!spare_.empty()) {
    currentBatch_ = std::move(spare_.back());
    spare_.pop_back();
  }
  changed_.notify_all();
}

/// Returns the old batch for reuse and takes the next one. False: no more batches.
bool BagFolderWriter::next(Batch& batch) {
  std::unique_lock<std::mutex> lock(mutex_);
  batch.count = 0;
  spare_.push_back(std::move(batch));
  changed_.wait(lock, [this] { return isStopping_ || !queue_.empty(); });
  if (queue_.empty()) {
    return false;
  }
  batch = std::move(queue_.front());
  queue_.pop_front();
  changed_.notify_all();
  return true;
}

void BagFolderWriter::writeQueued() {
  try {
    Batch batch;
    while (next(batch)) {
      for (std::size_t k = 0; k < batch.count; ++k) {
        QueuedState& queued = batch.states[k];
        if (queued.header) {
          bag_.setHeader(*std::move(queued.header));
        }
        bag_.append(queued.frame);
        hasFailed_ = bag_.hasFailed();
      }
    }
    if (conclusion_) {
      problems_ = bag_.finish(*conclusion_);
      hash_ = app::sha256OfFile(path_);
    }
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    thrown_ = std::current_exception();
    changed_.notify_all();
  }
}

void BagFolderWriter::conclude(const sim2d::TraceHeader& header) {
  if (currentBatch_.count > 0) {
    queueBatch();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  conclusion_ = header;
  isStopping_ = true;
  changed_.notify_all();
}

void BagFolderWriter::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    isStopping_ = true;
    if (!conclusion_) {
      queue_.clear();  // the run was aborted
    }
    changed_.notify_all();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

base::Diagnostics BagFolderWriter::finish(app::OutputFolder& output) {
  assert(conclusion_);
  end();
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  base::Diagnostics problems = std::move(problems_);
  if (hash_) {
    output.setHash(kBagFiles[0], *hash_);
  }
  const std::string name = fs::path(kBagFiles[0]).filename().string();
  base::append(problems, output.write(kBagFiles[1], bag_.metadata(name)));
  base::append(problems, output.write(kBagFiles[2], kFoxgloveLayoutText));
  return problems;
}

}  // namespace bridge
