#include <algorithm>
#include <deque>
#include <fastdds/rtps/common/WriteParams.h>
#include <optional>
#include <utility>
#include <vector>

#include "app/bridge/dds/DdsEntities.h"
#include "sim2d/base/LittleEndian.h"

/// Service servers and clients for both encodings of the request identity: rmw_fastrtps sends it
/// beside the sample (`related_sample_identity`), rmw_cyclonedds as 16 bytes before the fields.
namespace bridge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds kSettled(500);  // time for the server to discover both client endpoints
constexpr std::size_t kHeader = 4;     // [bytes], CDR encapsulation
constexpr std::size_t kCallId = 16;    // [bytes], guid and request number
constexpr std::uint8_t kReaderBit = 0x04;
constexpr Milliseconds kLongestWait(2000);  // for the client's reader
constexpr std::size_t kMaxKept = 256;       // queued responses
constexpr std::size_t kMaxQueued = 100;     // responses to one client

struct CallId {
  std::uint64_t client = 0;
  std::int64_t number = 0;
};

std::uint64_t numberAt(const Bytes& from, std::size_t at, bool isBigEndian) {
  Bytes bytes = from.substr(at, sizeof(std::uint64_t));
  if (isBigEndian) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return base::littleEndian<std::uint64_t>(bytes);
}

/// Removes the 16-byte request identity from the body. Nothing: the body is too short.
std::optional<CallId> takeCallId(Bytes& bytes) {
  if (bytes.size() < kHeader + kCallId) {
    return std::nullopt;
  }
  const bool isBigEndian = bytes[1] == 0;
  const CallId id = {numberAt(bytes, kHeader, isBigEndian),
                     static_cast<std::int64_t>(numberAt(bytes, kHeader + 8, isBigEndian))};
  bytes.erase(kHeader, kCallId);
  return id;
}

Bytes withCallId(const Bytes& bytes, const CallId& id) {
  if (bytes.size() < kHeader) {
    return bytes;
  }
  Bytes whole = bytes.substr(0, kHeader);
  base::appendLittleEndian(whole, id.client);
  base::appendLittleEndian(whole, id.number);
  return whole.append(bytes, kHeader);
}

bool isKnown(const rtps::GUID_t& guid) {
  return !(guid == rtps::GUID_t::unknown());
}

/// Formats a GUID as DDS user data: "key=1.a.ff;".
std::string userDataOf(const char* key, const Guid& guid) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = key;
  for (std::size_t i = 0; i < guid.size(); ++i) {
    text += i == 0 ? "=" : ".";
    if (guid[i] >= 16) {
      text += kDigits[guid[i] / 16];
    }
    text += kDigits[guid[i] % 16];
  }
  return text + ";";
}

/// The participant's GUID with a unique number per service or client in the last two bytes.
Guid callerGuid(const DdsEntities& dds) {
  Guid guid = dds.guid();
  const std::size_t number = dds.sources.size();
  guid[14] = static_cast<std::uint8_t>(number / 256);
  guid[15] = static_cast<std::uint8_t>(number % 256);
  return guid;
}

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
              std::unique_ptr<MatchedReaders> matched)
      : matched_(std::move(matched)), writer_(std::move(dds), node, writer) {}
  ~ReplyWriter() { writer_->set_listener(nullptr); }
  ReplyWriter(const ReplyWriter&) = delete;
  ReplyWriter& operator=(const ReplyWriter&) = delete;
  ReplyWriter(ReplyWriter&&) = delete;
  ReplyWriter& operator=(ReplyWriter&&) = delete;

  /// `client`: GUID of the client's reader. If its entity id is unknown, any reader of the
  /// participant counts; if the GUID is unknown, the response is sent immediately.
  void send(const rtps::GUID_t& client, Bytes answer, const rtps::WriteParams& parameters) {
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
  /// Sends the queued responses whose client is matched or whose 2 s have passed.
  void sendPending() {
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

 private:
  struct PendingReply {
    rtps::GUID_t client;
    Bytes answer;
    rtps::WriteParams parameters;
    std::chrono::steady_clock::time_point until;
  };
  bool hasPendingFor(const rtps::GUID_t& client) const {
    return std::any_of(pending_.begin(), pending_.end(),
                       [&](const PendingReply& each) { return each.client == client; });
  }

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
  void setFilter(ReplyFilter recognize) {
    const std::lock_guard<std::mutex> lock(mutex_);
    filter_ = std::move(recognize);
  }
  std::optional<Reply> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (queue_.empty()) {
      return std::nullopt;
    }
    Reply reply = std::move(queue_.front());
    queue_.pop_front();
    return reply;
  }

  void on_data_available(efd::DataReader* reader) override {
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
  void on_subscription_matched(efd::DataReader* /*reader*/,
                               const efd::SubscriptionMatchedStatus& /*status*/) override {
    wakeSignal_.notify();
  }

 private:
  bool queueIfOwn(Bytes& bytes, const efd::SampleInfo& info) {
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

  WakeSignal& wakeSignal_;
  std::mutex mutex_;
  ReplyFilter filter_;
  std::deque<Reply> queue_;  // oldest first
};

class DdsServer : public Server, public SampleSource {
 public:
  DdsServer(DdsPtr dds, int node, efd::DataReader* requests, efd::DataWriter* replies,
            std::unique_ptr<MatchedReaders> matchedReaders, Participant::ServiceCallback callback)
      : SampleSource(std::move(dds)),
        callback_(std::move(callback)),
        requests_(dds_, node, requests),
        replies_(dds_, node, replies, std::move(matchedReaders)) {}

  bool deliverOne() override {
    replies_.sendPending();
    ServiceRequest request;
    efd::SampleInfo info;
    if (!requests_.take(request.bytes, info)) {
      return false;
    }
    const bool isFast = isKnown(info.related_sample_identity.writer_guid());
    request.clientRmw = isFast ? Rmw::FastRtps : Rmw::CycloneDds;
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      replyAsCycloneDds(request, rtps::iHandle2GUID(info.publication_handle));
    } else {
      replyAsFastRtps(request, info);
    }
    return true;
  }

 private:
  void replyAsCycloneDds(ServiceRequest& request, const rtps::GUID_t& writer) {
    const std::optional<CallId> id = takeCallId(request.bytes);
    const Bytes reply = callback_(request);
    if (id) {
      const rtps::GUID_t anyReader(writer.guidPrefix, rtps::EntityId_t::unknown());
      replies_.send(anyReader, withCallId(reply, *id), {});
    }
  }

  void replyAsFastRtps(const ServiceRequest& request, const efd::SampleInfo& info) {
    const Bytes reply = callback_(request);
    rtps::SampleIdentity caller = info.sample_identity;
    if (request.clientRmw == Rmw::FastRtps) {
      caller.writer_guid(info.related_sample_identity.writer_guid());
    }
    const bool isReader = (caller.writer_guid().entityId.value[3] & kReaderBit) != 0;
    rtps::WriteParams parameters;
    parameters.related_sample_identity(caller);
    replies_.send(isReader ? caller.writer_guid() : rtps::GUID_t::unknown(), reply, parameters);
  }

  Participant::ServiceCallback callback_;
  OwnedReader requests_;
  ReplyWriter replies_;
};

class DdsClient : public Client {
 public:
  DdsClient(DdsPtr dds, int node, efd::DataReader* replies, efd::DataWriter* requests,
            std::unique_ptr<ReplyReader> answers)
      : dds_(std::move(dds)),
        replyReader_(std::move(answers)),
        replies_(dds_, node, replies),
        requests_(dds_, node, requests) {
    const Guid own = guidOf(requests_->guid());
    for (const std::uint8_t byte : own) {  // FNV-1a hash; any unique number works
      lastRequest_.client = (lastRequest_.client ^ byte) * 1099511628211U;
    }
    setReplyFilter();
  }

  bool isReady() override {
    if (requests_.matched() == 0 || replies_.matched() == 0) {
      matchedSince_.reset();
      return false;
    }
    if (!matchedSince_) {
      matchedSince_ = Clock::now();
    }
    return Clock::now() - *matchedSince_ >= kSettled;
  }

  std::int64_t send(const Bytes& request) override {
    rtps::WriteParams parameters;
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      ++lastRequest_.number;
      return requests_.write(withCallId(request, lastRequest_), parameters) ? lastRequest_.number
                                                                            : -1;
    }
    rtps::SampleIdentity caller;
    caller.writer_guid(replies_->guid());
    parameters.related_sample_identity(caller);
    if (!requests_.write(request, parameters)) {
      return -1;
    }
    return static_cast<std::int64_t>(parameters.sample_identity().sequence_number().to64long());
  }

  std::optional<std::pair<std::int64_t, Bytes>> receive() override { return replyReader_->next(); }

  std::optional<Bytes> call(const Bytes& request, Milliseconds atMost) override {
    const Clock::time_point until = Clock::now() + atMost;
    const std::int64_t number = send(request);
    while (number >= 0) {
      const std::uint64_t seen = dds_->wakeSignal.count();
      while (std::optional<std::pair<std::int64_t, Bytes>> reply = receive()) {
        if (reply->first == number) {
          return std::move(reply->second);
        }
      }
      if (!dds_->wakeSignal.waitAfter(seen, until)) {
        break;
      }
    }
    return std::nullopt;
  }

 private:
  void setReplyFilter() {
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      replyReader_->setFilter(
          [client = lastRequest_.client](Bytes& bytes, const efd::SampleInfo& /*info*/) {
            const std::optional<CallId> id = takeCallId(bytes);
            return id && id->client == client ? std::optional(id->number) : std::nullopt;
          });
      return;
    }
    replyReader_->setFilter([reader = replies_->guid(), writer = requests_->guid()](
                                Bytes& /*bytes*/, const efd::SampleInfo& info) {
      const rtps::SampleIdentity& to = info.related_sample_identity;
      const bool isOurs = to.writer_guid() == reader || to.writer_guid() == writer;
      return isOurs ? std::optional(static_cast<std::int64_t>(to.sequence_number().to64long()))
                    : std::nullopt;
    });
  }

  DdsPtr dds_;
  CallId lastRequest_{14695981039346656037U, 0};  // last request sent
  std::optional<Clock::time_point> matchedSince_;
  std::unique_ptr<ReplyReader> replyReader_;  // listener of replies_
  OwnedReader replies_;
  OwnedWriter requests_;
};

}  // namespace

std::unique_ptr<Server> makeServer(const DdsPtr& dds, int node, const ServiceNames& names,
                                   const Qos& qos, Participant::ServiceCallback callback) {
  const bool sendsId = dds->settings.rmw == Rmw::CycloneDds;
  const std::string id = sendsId ? userDataOf("serviceid", callerGuid(*dds)) : std::string();
  auto matchedReaders = std::make_unique<MatchedReaders>(dds->wakeSignal);
  efd::DataWriter* const replies =
      dds->makeWriter(names.replyTopic, names.replyType, qos, id, matchedReaders.get());
  efd::DataReader* const requests =
      replies == nullptr ? nullptr
                         : dds->makeReader(names.requestTopic, names.requestType, qos, id);
  if (requests == nullptr) {
    if (replies != nullptr) {
      dds->drop(replies);
    }
    return nullptr;
  }
  return std::make_unique<DdsServer>(dds, node, requests, replies, std::move(matchedReaders),
                                     std::move(callback));
}

std::unique_ptr<Client> makeClient(const DdsPtr& dds, int node, const ServiceNames& names) {
  const bool sendsId = dds->settings.rmw == Rmw::CycloneDds;
  const std::string id = sendsId ? userDataOf("clientid", callerGuid(*dds)) : std::string();
  const Qos qos = Qos::keepLast(100);
  auto answers = std::make_unique<ReplyReader>(dds->wakeSignal);
  efd::DataReader* const replies =
      dds->makeReader(names.replyTopic, names.replyType, qos, id, answers.get());
  efd::DataWriter* const requests =
      replies == nullptr ? nullptr
                         : dds->makeWriter(names.requestTopic, names.requestType, qos, id, nullptr);
  if (requests == nullptr) {
    if (replies != nullptr) {
      dds->drop(replies);
    }
    return nullptr;
  }
  return std::make_unique<DdsClient>(dds, node, replies, requests, std::move(answers));
}

}  // namespace bridge
