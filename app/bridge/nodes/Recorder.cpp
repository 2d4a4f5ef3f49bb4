#include "app/bridge/nodes/Recorder.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <set>
#include <utility>
#include <vector>

#include "app/bridge/agents/LoaderAnswers.h"
#include "app/bridge/bag/BagChoice.h"
#include "app/bridge/bag/McapWriter.h"
#include "app/bridge/messages/BasicMessages.h"
#include "app/bridge/messages/HunavServices.h"
#include "app/bridge/messages/TypeTable.h"
#include "app/bridge/nodes/NoPeerCheck.h"

namespace bridge {
namespace {

constexpr std::size_t kMostTopics = 200;
constexpr std::size_t kMostCauses = 1000;
constexpr int kDepth = 1000;  // messages of a topic that wait for this thread
constexpr std::size_t kMostLatched = 100;
constexpr std::size_t kMostLatchedBytes = std::size_t{256} << 20U;

std::int64_t nowInNanoseconds() {
  using std::chrono::nanoseconds;
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<nanoseconds>(since).count();
}

/// What is kept for those who begin later: the newest ones.
class Latched {
 public:
  void add(const Bytes& bytes) {
    kept_.push_back(bytes);
    size_ += bytes.size();
    while (kept_.size() > kMostLatched || (size_ > kMostLatchedBytes && kept_.size() > 1)) {
      size_ -= kept_.front().size();
      kept_.pop_front();
    }
  }
  const std::deque<Bytes>& kept() const { return kept_; }

 private:
  std::deque<Bytes> kept_;
  std::size_t size_ = 0;
};

struct Heard {
  OthersTopic topic;
  std::optional<std::uint16_t> channel;  // of the file that is being written
  Latched latched;
};

std::optional<base::Vec2> goalOf(const geometry_msgs::PoseStamped& asked) {
  const geometry_msgs::PoseStamped nobodys;
  return encode(asked) == encode(nobodys)
             ? std::nullopt
             : std::optional(base::Vec2(asked.pose.position.x, asked.pose.position.y));
}

class DdsRecorder final : public Recorder {
 public:
  DdsRecorder(RecorderSettings settings, std::unique_ptr<Participant> participant,
              Services services, Tell tell)
      : settings_(std::move(settings)),
        noPeer_(settings_.domain),
        participant_(std::move(participant)),
        services_(std::move(services)),
        tell_(std::move(tell)) {
    node_ = std::make_unique<Node>(*participant_, settings_.domain, settings_.space,
                                   "hunav_evaluator_node",
                                   Node::Parameters{parameter("use_sim_time", false)},
                                   [this](const base::Diagnostic& said) { tellOnce(said); });
    offerServices();
    participant_->announce();
  }

  void spin(Milliseconds atMost) override {
    participant_->spin(atMost);
    lookForTopics();
    if (const auto said = noPeer_.look(*participant_)) {
      tellOnce(*said);
    }
  }
  void begin(const std::string& path) override;
  base::Diagnostics end() override {
    const std::unique_ptr<McapWriter> written = std::move(writer_);
    return written == nullptr ? base::Diagnostics() : written->finish();
  }
  bool isRecording() const override { return writer_ != nullptr; }
  bool hasFailed() const override { return writer_ != nullptr && writer_->hasFailed(); }
  std::uint64_t messages() const override { return messages_; }

 private:
  void offerServices();
  void lookForTopics();
  void listenTo(const OthersTopic& topic);
  void take(Heard& from, const Bytes& bytes);
  void write(Heard& from, const Bytes& bytes);
  void tellOnce(const base::Diagnostic& said) {
    if (told_.size() < kMostCauses && told_.insert(causeOf(said)).second) {
      tell_(said);
    }
  }

  RecorderSettings settings_;
  NoPeerCheck noPeer_;
  std::unique_ptr<Participant> participant_;
  Services services_;
  Tell tell_;
  std::set<std::string> told_;
  std::vector<std::unique_ptr<Heard>> heard_;
  std::size_t seen_ = 0;  // topics of others
  std::unique_ptr<McapWriter> writer_;
  std::uint64_t messages_ = 0;
  std::unique_ptr<Node> node_;  // its subscriptions call: gone first
};

void DdsRecorder::offerServices() {
  const Qos qos = Qos::keepLast(100);
  using Start = hunav_msgs::StartEvaluation;
  node_->serve<Start>("hunav_start_recording", qos, [this](const Start::Request& request) {
    Start::Response response;
    response.success = !isRecording() && services_.start({request.experimentTag, request.runId,
                                                          goalOf(request.robotGoal)});
    return response;
  });
  using Stop = std_srvs::Empty;
  node_->serve<Stop>("hunav_stop_recording", qos, [this](const Stop::Request& /*request*/) {
    if (isRecording()) {
      services_.stop();
    }
    return Stop::Response();
  });
}

void DdsRecorder::lookForTopics() {
  const std::vector<OthersTopic> all = participant_->topicsOfOthers();
  const bool isAny = seen_ < all.size();
  for (; seen_ < all.size(); ++seen_) {
    const OthersTopic& topic = all[seen_];
    if (heard_.size() < kMostTopics && isOfUse({topic.name, topic.type}, settings_.use)) {
      listenTo(topic);
    }
  }
  if (isAny) {
    participant_->announce();
  }
}

void DdsRecorder::listenTo(const OthersTopic& topic) {
  auto heard = std::make_unique<Heard>();
  heard->topic = topic;
  Heard& from = *heard;
  Qos qos = Qos::input(kDepth);  // other publishers may offer less than the first one
  qos.transientLocal = topic.transientLocal;
  if (node_->subscribeBytes(topic, qos, [this, &from](const Bytes& bytes) { take(from, bytes); })) {
    heard_.push_back(std::move(heard));
    tellOnce(base::problem(base::Severity::Info, "ros2.hears", {topic.name, topic.type}));
  }
}

void DdsRecorder::take(Heard& from, const Bytes& bytes) {
  if (from.topic.transientLocal) {
    from.latched.add(bytes);
  }
  if (isRecording()) {
    write(from, bytes);
    ++messages_;
  }
}

void DdsRecorder::write(Heard& from, const Bytes& bytes) {
  if (!from.channel) {
    const KnownType* const type = findType(from.topic.type);
    from.channel =
        writer_->addChannel({from.topic.name,
                             from.topic.type,
                             type == nullptr ? std::string() : std::string(type->definition),
                             {{"offered_qos_profiles", ""}, {"topic_type_hash", ""}}});
  }
  writer_->write(*from.channel, nowInNanoseconds(), bytes);
}

void DdsRecorder::begin(const std::string& path) {
  writer_ = std::make_unique<McapWriter>(path);
  messages_ = 0;
  for (const std::unique_ptr<Heard>& from : heard_) {
    from->channel.reset();
    for (const Bytes& bytes : from->latched.kept()) {
      write(*from, bytes);
    }
  }
}

}  // namespace

base::Result<std::unique_ptr<Recorder>> Recorder::create(const RecorderSettings& settings,
                                                         Services services, Tell tell) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  return std::unique_ptr<Recorder>(std::make_unique<DdsRecorder>(
      settings, *std::move(participant), std::move(services), std::move(tell)));
}

}  // namespace bridge
