#include "app/bridge/bag/RunBag.h"

#include <filesystem>
#include <limits>
#include <utility>

#include "app/bridge/bag/DatabaseWriter.h"
#include "app/bridge/bag/McapWriter.h"
#include "app/bridge/messages/TypeTable.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"

namespace bridge {
namespace {

RunTopicsOptions withoutClock(RunTopicsOptions options) {
  options.clock = false;
  return options;
}

std::unique_ptr<BagWriter> writerOf(const std::string& path) {
  if (base::lowered(std::filesystem::path(path).extension().string()) == ".db3") {
    return std::make_unique<DatabaseWriter>(path);
  }
  return std::make_unique<McapWriter>(path);
}

}  // namespace

RunBag::RunBag(const std::string& path, const sim2d::TraceHeader& header, RunTopicsOptions options)
    : topics_(header, withoutClock(std::move(options))),
      writer_(writerOf(path)),
      recordEvery_(header.recordEvery),
      dt_(header.dt),
      events_(sim2d::headLine(sim2d::kEventColumns)) {
  for (const Topic& topic : topics_.topics()) {
    const KnownType* const type = findType(topic.type);
    channels_.push_back(writer_->addChannel(
        {topic.name,
         std::string(topic.type),
         type->definition,
         {{"offered_qos_profiles", offeredQos(topic)}, {"topic_type_hash", ""}}}));
  }
}

void RunBag::addEvent(std::int64_t step, const sim2d::Event& event) {
  topics_.note(event);
  sim2d::appendEventRow(events_, step, dt_, event);
}

void RunBag::append(const sim2d::Frame& frame) {
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
  topics_.tell(frame, [&](std::size_t topic, const std::string& bytes) {
    writer_->write(channels_[topic], time, bytes);
  });
}

base::Diagnostics RunBag::finish(const sim2d::TraceHeader& header) {
  writer_->addMetadata(kRunMetadata,
                       {{"trace.json", sim2d::traceJson(header)}, {"events.csv", events_}});
  return writer_->finish();
}

std::string RunBag::metadata(const std::string& name) const {
  const BagWriter::Totals& totals = writer_->totals();
  std::vector<BagTopic> topics;
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const auto count = totals.perChannel.find(channels_[k]);
    const Topic& topic = topics_.topics()[k];
    topics.push_back({topic.name, std::string(topic.type),
                      count == totals.perChannel.end() ? 0 : count->second, offeredQos(topic)});
  }
  return bagMetadata(name, topics, {totals.begin, totals.end, totals.messages});
}

base::Diagnostics writeRunBag(const std::string& path, const sim2d::Recording& recording,
                              const std::vector<sim2d::RecordedScan>& scans) {
  const sim2d::TraceHeader header = *recording.header();
  RunBag bag(path, header, {});
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
    for (; scan != scans.end() && scan->step < frame.step; ++scan) {  // of the state before
      frame.scans.push_back(*scan);
    }
    addUntil(frame.step);
    bag.append(frame);
  }
  addUntil(std::numeric_limits<std::int64_t>::max());
  return bag.finish(header);
}

}  // namespace bridge
