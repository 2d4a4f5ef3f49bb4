#include "app/bridge/bag/RunBagFolder.h"

#include <cassert>
#include <filesystem>
#include <utility>

#include "app/run/Sha256.h"

namespace bridge {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kTogether = 16;  // states that are handed over at once
constexpr std::size_t kWaiting = 8;  // such batches at most: a chunk of the bag is packed meanwhile

}  // namespace

RunBagFolder::RunBagFolder(const std::string& staging, const sim2d::Scenario& scenario,
                           const sim2d::World& world)
    : world_(world),
      path_((fs::path(staging) / kBagFiles[0]).string()),
      bag_(path_, world.header(), lidarsOf(scenario)) {
  for (const sim2d::TraceHuman& human : world.header().humans) {
    known_.insert(human.id);
  }
  thread_ = std::thread([this] { work(); });
}

RunBagFolder::~RunBagFolder() {
  end();
}

/// Somebody came from a source.
bool RunBagFolder::meetsSomebody(const sim2d::Frame& frame) {
  bool isNew = false;
  for (const int id : frame.humans.id) {
    isNew = known_.insert(id).second || isNew;
  }
  return isNew;
}

void RunBagFolder::append(const sim2d::Frame& frame) {
  const bool isRecorded = bag_.isRecorded(frame.step);
  if (!isRecorded && frame.events.empty() && frame.inputs.empty()) {
    return;
  }
  if (gathered_.count == gathered_.states.size()) {
    gathered_.states.emplace_back();
  }
  Taken& taken = gathered_.states[gathered_.count++];
  taken.header.reset();
  if (isRecorded) {
    taken.frame = frame;
    if (meetsSomebody(frame)) {
      taken.header = world_.header();
    }
  } else {
    taken.frame.step = frame.step;
    taken.frame.events = frame.events;
    taken.frame.inputs = frame.inputs;
  }
  if (gathered_.count == kTogether) {
    handOver();
  }
}

/// Waits where too many have not been taken yet.
void RunBagFolder::handOver() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock,
                [this] { return waiting_.size() < kWaiting || thrown_ != nullptr || isOver_; });
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  waiting_.push_back(std::move(gathered_));
  gathered_ = {};
  if (!spare_.empty()) {
    gathered_ = std::move(spare_.back());
    spare_.pop_back();
  }
  changed_.notify_all();
}

/// In exchange for a batch whose memory is used again; false: there are no more.
bool RunBagFolder::next(Batch& batch) {
  std::unique_lock<std::mutex> lock(mutex_);
  batch.count = 0;
  spare_.push_back(std::move(batch));
  changed_.wait(lock, [this] { return isOver_ || !waiting_.empty(); });
  if (waiting_.empty()) {
    return false;
  }
  batch = std::move(waiting_.front());
  waiting_.pop_front();
  changed_.notify_all();
  return true;
}

void RunBagFolder::work() {
  try {
    Batch batch;
    while (next(batch)) {
      for (std::size_t k = 0; k < batch.count; ++k) {
        Taken& taken = batch.states[k];
        if (taken.header) {
          bag_.setHeader(*std::move(taken.header));
        }
        bag_.append(taken.frame);
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

void RunBagFolder::conclude(const sim2d::TraceHeader& header) {
  if (gathered_.count > 0) {
    handOver();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  conclusion_ = header;
  isOver_ = true;
  changed_.notify_all();
}

void RunBagFolder::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    isOver_ = true;
    if (!conclusion_) {
      waiting_.clear();  // the run was given up
    }
    changed_.notify_all();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

base::Diagnostics RunBagFolder::finish(app::OutputFolder& output) {
  assert(conclusion_);
  end();
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  base::Diagnostics problems = std::move(problems_);
  if (hash_) {
    output.knowHash(kBagFiles[0], *hash_);
  }
  const std::string name = fs::path(kBagFiles[0]).filename().string();
  base::append(problems, output.write(kBagFiles[1], bag_.metadata(name)));
  base::append(problems, output.write(kBagFiles[2], foxgloveLayout()));
  return problems;
}

}  // namespace bridge
