#include "app/bridge/dds/ServiceReplies.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace bridge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds kLongestWait(2000);  // for the client's reader
constexpr std::size_t kMaxKept = 256;       // queued responses

}  // namespace

ReplyWriter::ReplyWriter(DdsPtr dds, int node, efd::DataWriter* writer,
                         std::unique_ptr<MatchedReaders> matched)
    : matched_(std::move(matched)), writer_(std::move(dds), node, writer) {}

ReplyWriter::~ReplyWriter() {
  writer_->set_listener(nullptr);
}

bool ReplyWriter::hasPendingFor(const rtps::GUID_t& client) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const PendingReply& each) { return each.client == client; });
}

void ReplyWriter::send(const rtps::GUID_t& client, Bytes answer,
                       const rtps::WriteParams& parameters) {
  sendPending();
  PendingReply made = {client, std::move(answer), parameters, Clock::now() + kLongestWait};
  if (!hasPendingFor(client) && matched_->has(client)) {
    writer_.write(made.answer, made.parameters);
    return;
  }
  if (pending_.size() >= kMaxKept) {
    writer_.write(pending_.front().answer, pending_.front().parameters);
    pending_.pop_front();
  }
  pending_.push_back(std::move(made));
}

void ReplyWriter::sendPending() {
  const Clock::time_point now = pending_.empty() ? Clock::time_point() : Clock::now();
  std::vector<rtps::GUID_t> waiting;  // clients with queued responses
  for (auto each = pending_.begin(); each != pending_.end();) {
    const bool waits = std::find(waiting.begin(), waiting.end(), each->client) != waiting.end() ||
                       (now < each->until && !matched_->has(each->client));
    if (waits) {
      waiting.push_back(each->client);
      ++each;
      continue;
    }
    writer_.write(each->answer, each->parameters);
    each = pending_.erase(each);
  }
}

namespace {

constexpr std::size_t kMaxQueued = 100;

}  // namespace

void ReplyReader::setFilter(ReplyFilter recognize) {
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_ = std::move(recognize);
}

std::optional<ReplyReader::Reply> ReplyReader::next() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.empty()) {
    return std::nullopt;
  }
  Reply reply = std::move(queue_.front());
  queue_.pop_front();
  return reply;
}

void ReplyReader::on_data_available(efd::DataReader* reader) {
  Bytes bytes;
  efd::SampleInfo info;
  bool hasQueued = false;
  while (takeNext(*reader, bytes, info)) {
    hasQueued = queueIfOwn(bytes, info) || hasQueued;
  }
  if (hasQueued) {
    wakeSignal_.notify();
  }
}

bool ReplyReader::queueIfOwn(Bytes& bytes, const efd::SampleInfo& info) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::optional<std::int64_t> number = filter_ ? filter_(bytes, info) : std::nullopt;
  if (!number) {
    return false;
  }
  if (queue_.size() >= kMaxQueued) {
    queue_.pop_front();
  }
  queue_.emplace_back(*number, std::move(bytes));
  return true;
}

}  // namespace bridge
