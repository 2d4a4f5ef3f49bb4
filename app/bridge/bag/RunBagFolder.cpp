#include "app/bridge/bag/RunBagFolder.h"

#include <filesystem>
#include <utility>

namespace bridge {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kTogether = 16;  // states that are handed over at once

}  // namespace

RunBagFolder::RunBagFolder(const std::string& staging, const sim2d::Scenario& scenario,
                           const sim2d::World& world)
    : world_(world),
      bag_((fs::path(staging) / kBagFiles[0]).string(), world.header(), lidarsOf(scenario)) {
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
  Taken taken;
  if (bag_.isRecorded(frame.step)) {
    taken.frame = frame;
    if (meetsSomebody(frame)) {
      taken.header = world_.header();
    }
  } else if (!frame.events.empty() || !frame.inputs.empty()) {
    taken.frame.step = frame.step;
    taken.frame.events = frame.events;
    taken.frame.inputs = frame.inputs;
  } else {
    return;
  }
  gathered_.push_back(std::move(taken));
  if (gathered_.size() >= kTogether) {
    handOver();
  }
}

/// Waits until those of before have been taken.
void RunBagFolder::handOver() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return taken_.empty() || thrown_ != nullptr || isOver_; });
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  taken_.swap(gathered_);
  gathered_.clear();
  changed_.notify_all();
}

/// None: there are no more.
std::vector<RunBagFolder::Taken> RunBagFolder::next() {
  std::vector<Taken> all;
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return isOver_ || !taken_.empty(); });
  all.swap(taken_);
  changed_.notify_all();
  return all;
}

void RunBagFolder::work() {
  try {
    for (std::vector<Taken> all = next(); !all.empty(); all = next()) {
      for (Taken& taken : all) {
        if (taken.header) {
          bag_.setHeader(*std::move(taken.header));
        }
        bag_.append(taken.frame);
      }
      hasFailed_ = bag_.hasFailed();
    }
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    thrown_ = std::current_exception();
    changed_.notify_all();
  }
}

void RunBagFolder::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    isOver_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

base::Diagnostics RunBagFolder::finish(app::OutputFolder& output,
                                       const sim2d::TraceHeader& header) {
  if (!gathered_.empty()) {
    handOver();
  }
  end();
  if (thrown_ != nullptr) {
    std::rethrow_exception(thrown_);
  }
  base::Diagnostics problems = bag_.finish(header);
  const std::string name = fs::path(kBagFiles[0]).filename().string();
  base::append(problems, output.write(kBagFiles[1], bag_.metadata(name)));
  base::append(problems, output.write(kBagFiles[2], foxgloveLayout()));
  return problems;
}

}  // namespace bridge
