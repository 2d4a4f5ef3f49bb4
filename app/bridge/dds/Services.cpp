#include <algorithm>
#include <fastdds/rtps/common/WriteParams.h>
#include <utility>

#include "app/bridge/dds/AnswerWriter.h"
#include "app/bridge/dds/DdsInside.h"
#include "app/bridge/dds/OwnAnswers.h"

/// Calls of services in both ways of writing who asked. rmw_fastrtps has it beside the sample
/// (`related_sample_identity`), rmw_cyclonedds as 16 bytes in front of the fields.
namespace bridge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds kSettled(500);  // until a server knows both ends of a client
constexpr std::size_t kHeader = 4;     // [bytes] of CDR
constexpr std::size_t kCallId = 16;    // guid, then number
constexpr std::uint8_t kReaderBit = 0x04;

struct CallId {
  std::uint64_t client = 0;
  std::int64_t number = 0;
};

void putNumber(std::uint64_t value, Bytes& to) {
  for (int shift = 0; shift < 64; shift += 8) {
    to.push_back(static_cast<char>(value >> shift & 0xffU));
  }
}

std::uint64_t numberAt(const Bytes& from, std::size_t at, bool isBigEndian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t shift = 8 * (isBigEndian ? 7 - i : i);
    value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(from[at + i])) << shift;
  }
  return value;
}

/// Takes the 16 bytes out of the body. Nothing: it is too short to have them.
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
  putNumber(id.client, whole);
  putNumber(static_cast<std::uint64_t>(id.number), whole);
  return whole.append(bytes, kHeader);
}

bool isKnown(const rtps::GUID_t& guid) {
  return !(guid == rtps::GUID_t::unknown());
}

/// "key=1.a.ff;" of these bytes.
std::string idText(const char* key, const Guid& guid) {
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

/// Of the participant, with a number of its own for each service or client.
Guid callerGuid(const DdsEntities& dds) {
  Guid guid = dds.guid();
  const std::size_t number = dds.sources.size();
  guid[14] = static_cast<std::uint8_t>(number / 256);
  guid[15] = static_cast<std::uint8_t>(number % 256);
  return guid;
}

class DdsServer : public Server, public Source {
 public:
  DdsServer(DdsPtr dds, int node, efd::DataReader* requests, efd::DataWriter* replies,
            std::unique_ptr<MetReaders> met, Participant::Answer answer)
      : dds_(std::move(dds)),
        answer_(std::move(answer)),
        requests_(dds_, node, requests),
        replies_(dds_, node, replies, std::move(met)) {
    dds_->sources.push_back(this);
  }
  ~DdsServer() override {
    std::vector<Source*>& all = dds_->sources;
    all.erase(std::remove(all.begin(), all.end(), this), all.end());
  }
  DdsServer(const DdsServer&) = delete;
  DdsServer& operator=(const DdsServer&) = delete;
  DdsServer(DdsServer&&) = delete;
  DdsServer& operator=(DdsServer&&) = delete;

  bool handOutOne() override {
    replies_.sendKept();
    ServiceRequest request;
    efd::SampleInfo info;
    if (!requests_.take(request.bytes, info)) {
      return false;
    }
    const bool isFast = isKnown(info.related_sample_identity.writer_guid());
    request.writtenFor = isFast ? Rmw::FastRtps : Rmw::CycloneDds;
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      answerInBody(request, rtps::iHandle2GUID(info.publication_handle));
    } else {
      answerBeside(request, info);
    }
    return true;
  }

 private:
  void answerInBody(ServiceRequest& request, const rtps::GUID_t& writer) {
    const std::optional<CallId> id = takeCallId(request.bytes);
    const Bytes reply = answer_(request);
    if (id) {
      const rtps::GUID_t anyReader(writer.guidPrefix, rtps::EntityId_t::unknown());
      replies_.send(anyReader, withCallId(reply, *id), {});
    }
  }

  void answerBeside(const ServiceRequest& request, const efd::SampleInfo& info) {
    const Bytes reply = answer_(request);
    rtps::SampleIdentity caller = info.sample_identity;
    if (request.writtenFor == Rmw::FastRtps) {
      caller.writer_guid(info.related_sample_identity.writer_guid());
    }
    const bool isReader = (caller.writer_guid().entityId.value[3] & kReaderBit) != 0;
    rtps::WriteParams parameters;
    parameters.related_sample_identity(caller);
    replies_.send(isReader ? caller.writer_guid() : rtps::GUID_t::unknown(), reply, parameters);
  }

  DdsPtr dds_;
  Participant::Answer answer_;
  OwnedReader requests_;
  AnswerWriter replies_;
};

class DdsClient : public Client {
 public:
  DdsClient(DdsPtr dds, int node, efd::DataReader* replies, efd::DataWriter* requests,
            std::unique_ptr<OwnAnswers> answers)
      : dds_(std::move(dds)),
        answers_(std::move(answers)),
        replies_(dds_, node, replies),
        requests_(dds_, node, requests) {
    const Guid own = guidOf(requests_->guid());
    for (const std::uint8_t byte : own) {  // FNV-1a: any number of its own will do
      number_.client = (number_.client ^ byte) * 1099511628211U;
    }
    recognizeAnswers();
  }

  bool isReady() override {
    if (requests_.matched() == 0 || replies_.matched() == 0) {
      met_.reset();
      return false;
    }
    if (!met_) {
      met_ = Clock::now();
    }
    return Clock::now() - *met_ >= kSettled;
  }

  std::int64_t send(const Bytes& request) override {
    rtps::WriteParams parameters;
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      ++number_.number;
      return requests_.write(withCallId(request, number_), parameters) ? number_.number : -1;
    }
    rtps::SampleIdentity caller;
    caller.writer_guid(replies_->guid());
    parameters.related_sample_identity(caller);
    if (!requests_.write(request, parameters)) {
      return -1;
    }
    return static_cast<std::int64_t>(parameters.sample_identity().sequence_number().to64long());
  }

  std::optional<std::pair<std::int64_t, Bytes>> receive() override { return answers_->next(); }

  std::optional<Bytes> call(const Bytes& request, Milliseconds atMost) override {
    const Clock::time_point until = Clock::now() + atMost;
    const std::int64_t number = send(request);
    while (number >= 0) {
      const std::uint64_t seen = dds_->bell.count();
      while (std::optional<std::pair<std::int64_t, Bytes>> reply = receive()) {
        if (reply->first == number) {
          return std::move(reply->second);
        }
      }
      if (!dds_->bell.waitBeyond(seen, until)) {
        break;
      }
    }
    return std::nullopt;
  }

 private:
  void recognizeAnswers() {
    if (dds_->settings.rmw == Rmw::CycloneDds) {
      answers_->recognizeBy(
          [client = number_.client](Bytes& bytes, const efd::SampleInfo& /*info*/) {
            const std::optional<CallId> id = takeCallId(bytes);
            return id && id->client == client ? std::optional(id->number) : std::nullopt;
          });
      return;
    }
    answers_->recognizeBy([reader = replies_->guid(), writer = requests_->guid()](
                              Bytes& /*bytes*/, const efd::SampleInfo& info) {
      const rtps::SampleIdentity& to = info.related_sample_identity;
      const bool isOurs = to.writer_guid() == reader || to.writer_guid() == writer;
      return isOurs ? std::optional(static_cast<std::int64_t>(to.sequence_number().to64long()))
                    : std::nullopt;
    });
  }

  DdsPtr dds_;
  CallId number_{14695981039346656037U, 0};  // of the request last sent
  std::optional<Clock::time_point> met_;
  std::unique_ptr<OwnAnswers> answers_;  // the listener of what follows
  OwnedReader replies_;
  OwnedWriter requests_;
};

}  // namespace

std::unique_ptr<Server> makeServer(const DdsPtr& dds, int node, const ServiceNames& names,
                                   const Qos& qos, Participant::Answer answer) {
  const bool tellsId = dds->settings.rmw == Rmw::CycloneDds;
  const std::string id = tellsId ? idText("serviceid", callerGuid(*dds)) : std::string();
  auto met = std::make_unique<MetReaders>(dds->bell);
  efd::DataWriter* const replies =
      dds->makeWriter(names.replyTopic, names.replyType, qos, id, met.get());
  efd::DataReader* const requests =
      replies == nullptr ? nullptr
                         : dds->makeReader(names.requestTopic, names.requestType, qos, id);
  if (requests == nullptr) {
    if (replies != nullptr) {
      dds->drop(replies);
    }
    return nullptr;
  }
  return std::make_unique<DdsServer>(dds, node, requests, replies, std::move(met),
                                     std::move(answer));
}

std::unique_ptr<Client> makeClient(const DdsPtr& dds, int node, const ServiceNames& names) {
  const bool tellsId = dds->settings.rmw == Rmw::CycloneDds;
  const std::string id = tellsId ? idText("clientid", callerGuid(*dds)) : std::string();
  const Qos qos = Qos::keepLast(100);
  auto answers = std::make_unique<OwnAnswers>(dds->bell);
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
