#include "app/bridge/nodes/Recorder.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "app/bridge/agents/LoaderResponses.h"
#include "app/bridge/bag/McapWriter.h"
#include "app/bridge/bag/TopicSelection.h"
#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/TypeNames.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/std_srvs.h"
#include "app/bridge/nodes/Node.h"

namespace bridge {
namespace {

constexpr std::size_t kMostTopics = 200;
constexpr int kDepth = 1000;  // queued messages per topic
constexpr std::size_t kMostLatched = 100;
constexpr std::size_t kMostLatchedBytes = std::size_t{256} << 20U;

/// The newest messages of a latched topic, kept for recordings that start later.
class LatchedMessages {
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

struct SubscribedTopic {
  RemoteTopic topic;
  std::optional<std::uint16_t> channel;  // channel in the current file
  LatchedMessages latched;
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
              Services services, ReportCallback report)
      : settings_(std::move(settings)),
        noPeer_(settings_.domain),
        participant_(std::move(participant)),
        services_(std::move(services)),
        report_(std::move(report)) {
    node_ = std::make_unique<Node>(
        *participant_, settings_.domain, settings_.nameSpace, "hunav_evaluator_node",
        Node::Parameters{parameter("use_sim_time", false)},
        [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
    createServices();
    participant_->publishGraph();
  }

  void spin(Milliseconds atMost) override {
    participant_->spin(atMost);
    subscribeNewTopics();
    if (const auto diagnostic = noPeer_.check(*participant_)) {
      reportOnce(*diagnostic);
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
  void createServices();
  void subscribeNewTopics();
  void subscribe(const RemoteTopic& topic);
  void take(SubscribedTopic& from, const Bytes& bytes);
  void write(SubscribedTopic& from, const Bytes& bytes);
  void reportOnce(const base::Diagnostic& diagnostic) {
    if (reported_.isNew(problemKey(diagnostic))) {
      report_(diagnostic);
    }
  }

  RecorderSettings settings_;
  NoPeerCheck noPeer_;
  std::unique_ptr<Participant> participant_;
  Services services_;
  ReportCallback report_;
  base::DiagnosticFilter reported_;
  std::vector<std::unique_ptr<SubscribedTopic>> subscribed_;
  std::size_t processedTopics_ = 0;  // number of remote topics processed
  std::unique_ptr<McapWriter> writer_;
  std::uint64_t messages_ = 0;
  std::unique_ptr<Node> node_;  // last member: its subscriptions call this object
};

void DdsRecorder::createServices() {
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

void DdsRecorder::subscribeNewTopics() {
  const std::vector<RemoteTopic> all = participant_->remoteTopics();
  const bool isAny = processedTopics_ < all.size();
  for (; processedTopics_ < all.size(); ++processedTopics_) {
    const RemoteTopic& topic = all[processedTopics_];
    if (subscribed_.size() < kMostTopics &&
        isUsableTopic({topic.name, topic.type}, settings_.use)) {
      subscribe(topic);
    }
  }
  if (isAny) {
    participant_->publishGraph();
  }
}

void DdsRecorder::subscribe(const RemoteTopic& topic) {
  auto subscribed = std::make_unique<SubscribedTopic>();
  subscribed->topic = topic;
  SubscribedTopic& from = *subscribed;
  Qos qos = Qos::input(kDepth);  // other publishers may offer weaker QoS than the first
  qos.transientLocal = topic.transientLocal;
  if (node_->subscribeBytes(topic, qos, [this, &from](const Bytes& bytes) { take(from, bytes); })) {
    subscribed_.push_back(std::move(subscribed));
    reportOnce(base::problem(base::Severity::Info, "ros2.hears", {topic.name, topic.type}));
  }
}

void DdsRecorder::take(SubscribedTopic& from, const Bytes& bytes) {
  if (from.topic.transientLocal) {
    from.latched.add(bytes);
  }
  if (isRecording()) {
    write(from, bytes);
    ++messages_;
  }
}

void DdsRecorder::write(SubscribedTopic& from, const Bytes& bytes) {
  if (!from.channel) {
    const KnownType* const type = findType(from.topic.type);
    from.channel =
        writer_->addChannel({from.topic.name,
                             from.topic.type,
                             type == nullptr ? std::string() : std::string(type->definition),
                             {{"offered_qos_profiles", ""}, {"topic_type_hash", ""}}});
  }
  writer_->write(*from.channel, wallClockNanoseconds(), bytes);
}

void DdsRecorder::begin(const std::string& path) {
  writer_ = std::make_unique<McapWriter>(path);
  messages_ = 0;
  for (const std::unique_ptr<SubscribedTopic>& from : subscribed_) {
    from->channel.reset();
    for (const Bytes& bytes : from->latched.kept()) {
      write(*from, bytes);
    }
  }
}

}  // namespace

base::Result<std::unique_ptr<Recorder>> Recorder::create(const RecorderSettings& settings,
                                                         Services services, ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  return std::unique_ptr<Recorder>(std::make_unique<DdsRecorder>(
      settings, *std::move(participant), std::move(services), std::move(report)));
}

}  // namespace bridge
