#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "app/bridge/dds/DdsEntities.h"

namespace bridge {

/// Writes the responses of a service. A request can arrive before the client's response reader is
/// discovered, and a response written before that would be lost. Responses to such a client are
/// queued until its reader is matched, for at most 2 s and at most 256 in total; responses to other
/// clients are sent meanwhile. Requests of rmw_cyclonedds identify only the participant of the
/// client: if a participant has several clients of one service, the first match releases all of its
/// responses.
class ReplyWriter {
 public:
  /// `matched` is the listener of `writer`.
  ReplyWriter(DdsPtr dds, int node, efd::DataWriter* writer,
              std::unique_ptr<MatchedReaders> matched);
  ~ReplyWriter();
  ReplyWriter(const ReplyWriter&) = delete;
  ReplyWriter& operator=(const ReplyWriter&) = delete;
  ReplyWriter(ReplyWriter&&) = delete;
  ReplyWriter& operator=(ReplyWriter&&) = delete;

  /// `client`: GUID of the client's reader. If its entity id is unknown, any reader of the
  /// participant counts; if the GUID is unknown, the response is sent immediately.
  void send(const rtps::GUID_t& client, Bytes answer, const rtps::WriteParams& parameters);
  /// Sends the queued responses whose client is matched or whose 2 s have passed.
  void sendPending();

 private:
  struct PendingReply {
    rtps::GUID_t client;
    Bytes answer;
    rtps::WriteParams parameters;
    std::chrono::steady_clock::time_point until;
  };
  bool hasPendingFor(const rtps::GUID_t& client) const;

  std::unique_ptr<MatchedReaders> matched_;
  OwnedWriter writer_;
  std::deque<PendingReply> pending_;  // oldest first
};

/// Receives the responses to one client. A DDS thread filters them from the responses to all
/// clients of the service as they arrive, so that responses to other clients cannot displace them.
/// Keeps the last 100. Listener of the client's reader; thread-safe.
class ReplyReader : public efd::DataReaderListener {
 public:
  using Reply = std::pair<std::int64_t, Bytes>;  // request number, response
  /// Returns the request number if the response belongs to this client, and removes the request
  /// identity from the bytes.
  using ReplyFilter = std::function<std::optional<std::int64_t>(Bytes&, const efd::SampleInfo&)>;

  explicit ReplyReader(WakeSignal& wakeSignal)
      : wakeSignal_(wakeSignal) {}  // notified for each response

  /// Call before the first request. Samples that arrive earlier are discarded.
  void setFilter(ReplyFilter recognize);
  std::optional<Reply> next();

  void on_data_available(efd::DataReader* reader) override;
  void on_subscription_matched(efd::DataReader* /*reader*/,
                               const efd::SubscriptionMatchedStatus& /*status*/) override {
    wakeSignal_.notify();
  }

 private:
  bool queueIfOwn(Bytes& bytes, const efd::SampleInfo& info);

  WakeSignal& wakeSignal_;
  std::mutex mutex_;
  ReplyFilter filter_;
  std::deque<Reply> queue_;  // oldest first
};

}  // namespace bridge
