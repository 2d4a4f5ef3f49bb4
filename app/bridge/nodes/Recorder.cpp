#include "app/bridge/nodes/Recorder.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/Time.h"
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

std::optional<base::Vec2> goalOf(const geometry_msgs::PoseStamped& asked) {
  const geometry_msgs::PoseStamped nobodys;
  return encode(asked) == encode(nobodys)
             ? std::nullopt
             : std::optional(base::Vec2(asked.pose.position.x, asked.pose.position.y));
}

}  // namespace

struct Recorder::SubscribedTopic {
  RemoteTopic topic;
  std::optional<std::uint16_t> channel;  // channel in the current file
  LatchedMessages latched;
};

Recorder::Recorder(const RecorderSettings& settings, std::unique_ptr<Participant> participant,
                   Services services, ReportCallback report)
    : NodeProgram(std::move(participant), settings.domain, std::move(report)),
      use_(settings.use),
      services_(std::move(services)) {
  node_ = makeNode(settings.nameSpace, "hunav_evaluator_node", {parameter("use_sim_time", false)});
  createServices();
  for (const base::Diagnostic& problem : finishStart()) {
    report_(problem);
  }
}

Recorder::~Recorder() = default;

void Recorder::spin(Milliseconds atMost) {
  participant_->spin(atMost);
  subscribeNewTopics();
  reportMissingPeers();
}

base::Diagnostics Recorder::end() {
  const std::unique_ptr<BagWriter> written = std::move(writer_);
  return written == nullptr ? base::Diagnostics() : written->finish();
}

void Recorder::createServices() {
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

void Recorder::subscribeNewTopics() {
  const std::vector<RemoteTopic> all = participant_->remoteTopics();
  const bool isAny = processedTopics_ < all.size();
  for (; processedTopics_ < all.size(); ++processedTopics_) {
    const RemoteTopic& topic = all[processedTopics_];
    if (subscribed_.size() < kMostTopics && isUsableTopic({topic.name, topic.type}, use_)) {
      subscribe(topic);
    }
  }
  if (isAny) {
    participant_->publishGraph();
  }
}

void Recorder::subscribe(const RemoteTopic& topic) {
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

void Recorder::take(SubscribedTopic& from, const Bytes& bytes) {
  if (from.topic.transientLocal) {
    from.latched.add(bytes);
  }
  if (isRecording()) {
    write(from, bytes);
    ++messages_;
  }
}

void Recorder::write(SubscribedTopic& from, const Bytes& bytes) {
  if (!from.channel) {
    const KnownType* const type = findType(from.topic.type);
    from.channel =
        writer_->addChannel({from.topic.name,
                             from.topic.type,
                             type == nullptr ? std::string() : std::string(type->definition),
                             {}});
  }
  writer_->write(*from.channel, wallClockNanoseconds(), bytes);
}

void Recorder::begin(const std::string& path) {
  writer_ = makeMcapWriter(path);
  messages_ = 0;
  for (const std::unique_ptr<SubscribedTopic>& from : subscribed_) {
    from->channel.reset();
    for (const Bytes& bytes : from->latched.kept()) {
      write(*from, bytes);
    }
  }
}

base::Result<std::unique_ptr<Recorder>> Recorder::create(const RecorderSettings& settings,
                                                         Services services, ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  return std::unique_ptr<Recorder>(
      new Recorder(settings, *std::move(participant), std::move(services), std::move(report)));
}

}  // namespace bridge
