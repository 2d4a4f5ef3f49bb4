#include "app/bridge/dds/AnswerWriter.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace bridge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds kLongestWait(2000);  // for the reader of who asked
constexpr std::size_t kMostKept = 256;      // answers

}  // namespace

AnswerWriter::AnswerWriter(DdsPtr dds, int node, efd::DataWriter* writer,
                           std::unique_ptr<MetReaders> met)
    : met_(std::move(met)), writer_(std::move(dds), node, writer) {}

AnswerWriter::~AnswerWriter() {
  writer_->set_listener(nullptr);
}

bool AnswerWriter::isKeptFor(const rtps::GUID_t& asker) const {
  return std::any_of(kept_.begin(), kept_.end(),
                     [&](const Kept& each) { return each.asker == asker; });
}

void AnswerWriter::send(const rtps::GUID_t& asker, Bytes answer,
                        const rtps::WriteParams& parameters) {
  sendKept();
  Kept made = {asker, std::move(answer), parameters, Clock::now() + kLongestWait};
  if (!isKeptFor(asker) && met_->has(asker)) {
    writer_.write(made.answer, made.parameters);
    return;
  }
  if (kept_.size() >= kMostKept) {
    writer_.write(kept_.front().answer, kept_.front().parameters);
    kept_.pop_front();
  }
  kept_.push_back(std::move(made));
}

void AnswerWriter::sendKept() {
  const Clock::time_point now = kept_.empty() ? Clock::time_point() : Clock::now();
  std::vector<rtps::GUID_t> waiting;  // answers to one go out in their order
  for (auto each = kept_.begin(); each != kept_.end();) {
    const bool waits = std::find(waiting.begin(), waiting.end(), each->asker) != waiting.end() ||
                       (now < each->until && !met_->has(each->asker));
    if (waits) {
      waiting.push_back(each->asker);
      ++each;
      continue;
    }
    writer_.write(each->answer, each->parameters);
    each = kept_.erase(each);
  }
}

}  // namespace bridge
