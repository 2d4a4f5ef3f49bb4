#include "app/bridge/live/FoxglovePublisher.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/std_msgs.h"
#include "app/bridge/topics/RunMessages.h"

namespace live {

namespace {

using bridge::std_msgs::Float64;

/// A selection without windows, series and per-robot results: nothing that grows with the run.
metrics::Selection withoutSeries(metrics::Selection selection) {
  selection.window = {};
  selection.series = selection.seriesOnDisk = false;
  selection.behaviors = selection.behaviorSeries = false;
  selection.everyRobot = false;
  return selection;
}

constexpr std::chrono::microseconds kBetweenFrames{16000};  // about the display rate
constexpr std::chrono::milliseconds kBetweenMetrics{250};   // computing them takes time

constexpr std::size_t kMostWarnings = 5;     // pages may retry with many origins
constexpr std::size_t kLongestOrigin = 200;  // [B]

/// The robots with planner `teleop`.
std::vector<RunControl::TeleopRobot> teleopRobots(const sim2d::TraceHeader& header) {
  std::vector<RunControl::TeleopRobot> driven;
  for (const sim2d::TraceRobot& robot : header.robots) {
    if (robot.planner == "teleop") {
      const bool isFirst = &robot == &header.robots.front();
      driven.push_back({(isFirst ? "" : "/" + robot.name) + "/cmd_vel", robot.id});
    }
  }
  return driven;
}

std::string newSessionName() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

}  // namespace

FoxglovePublisher::FoxglovePublisher(app::Session& session, sim2d::World& world,
                                     const sim2d::Scenario& scenario,
                                     const std::string& scenarioName,
                                     const app::MetricsSetup& metrics,
                                     const FoxglovePublisherSettings& settings)
    : session_(session),
      world_(world),
      topics_(world.header(), bridge::lidarsOf(scenario)),
      metrics_(world.header(), withoutSeries(metrics.selection), metrics.parameters),
      control_(session, {scenarioName, static_cast<std::int64_t>(world.header().seed), world.dt()},
               settings.canDrive ? teleopRobots(world.header())
                                 : std::vector<RunControl::TeleopRobot>()),
      known_(world.header()) {
  for (const bridge::Topic& topic : topics_.topics()) {
    channels_.push_back({topic.name,
                         {std::string(topic.type), bridge::findType(topic.type)->definition},
                         topic.isLatched});
  }
  const metrics::Selection selection = withoutSeries(metrics.selection);
  for (const metrics::MetricEntry& entry : selection.entries(metrics::standardRegistry())) {
    channelOf_[entry.info.key] = channels_.size();
    channels_.push_back(
        {"/hunavsim/metrics/" + entry.info.key, {Float64::kType, Float64::kDefinition}, false});
  }
}

base::Result<std::unique_ptr<FoxglovePublisher>> FoxglovePublisher::open(
    const FoxglovePublisherSettings& settings, app::Session& session, sim2d::World& world,
    const sim2d::Scenario& scenario, const std::string& scenarioName,
    const app::MetricsSetup& metrics) {
  std::unique_ptr<FoxglovePublisher> run(
      new FoxglovePublisher(session, world, scenario, scenarioName, metrics, settings));
  auto server = FoxgloveServer::listen(run->settingsOf(settings, scenarioName), run->channels_);
  if (!server) {
    return server.diagnostics();
  }
  run->server_ = *std::move(server);
  world.enableScans(true);
  session.setRefreshCallback([to = run.get()](const sim2d::Frame& frame) { to->catchUp(frame); });
  run->server_->start();
  return base::Result<std::unique_ptr<FoxglovePublisher>>(std::move(run));
}

FoxglovePublisher::~FoxglovePublisher() {
  if (server_) {
    session_.setRefreshCallback({});
    server_->stop("the run has ended");
  }
}

FoxgloveSettings FoxglovePublisher::settingsOf(const FoxglovePublisherSettings& given,
                                               const std::string& scenarioName) {
  FoxgloveSettings settings;
  settings.server.address = given.address;
  settings.server.port = given.port;
  settings.server.origins = given.origins;
  settings.name = "hunavsim: " + scenarioName;
  settings.session = newSessionName();
  settings.services = control_.services();
  settings.clientTopics = control_.clientTopics();
  settings.parameters = control_.parameters();
  settings.tick = [this, wantsStop = given.wantsStop] {
    if (wantsStop && wantsStop()) {
      session_.stop();
    }
  };
  settings.subscribed = [this] { session_.refresh(); };
  settings.refused = [this, warn = given.warn](const std::string& origin) {
    const std::string shown = origin.substr(0, kLongestOrigin);
    if (warn && warned_.size() < kMostWarnings && warned_.insert(shown).second) {
      warn(base::warning("live.page-refused", {shown}));
    }
  };
  return settings;
}

void FoxglovePublisher::show(const sim2d::Frame& frame) {
  if (frame.step <= newest_) {
    return;
  }
  newest_ = frame.step;
  if (known_.addNew(frame)) {  // a source spawned a person
    sim2d::TraceHeader header = world_.header();
    metrics_.addHumans(header.humans);
    topics_.setHeader(std::move(header));
  }
  topics_.track(frame);
  for (const sim2d::Event& event : frame.events) {
    metrics_.note(frame.time, event);
  }
  metrics_.append(frame);
  const Clock::time_point now = Clock::now();
  if (!publishedAt_ || !isAboveDisplayRate() || now - *publishedAt_ >= kBetweenFrames) {
    publish(frame, now);
  }
}

/// If false, every state is published: single steps, and states slower than the display rate.
bool FoxglovePublisher::isAboveDisplayRate() const {
  const std::chrono::duration<double> each(world_.dt() / session_.speed());
  return !session_.isPaused() && each < kBetweenFrames;
}

/// Publishes the final metrics.
void FoxglovePublisher::finish(const sim2d::Frame& frame, const std::string& reason) {
  const bool isNew = frame.step > newest_;
  metricsPublishedAt_.reset();
  publishedAt_.reset();
  show(frame);
  if (!isNew) {
    publish(frame, Clock::now());
  }
  server_->stop(reason);
}

bool FoxglovePublisher::hasMetricSubscribers(const ChannelFilter& filter) const {
  return std::any_of(channelOf_.begin(), channelOf_.end(), [&](const auto& each) {
    return filter(static_cast<ChannelId>(each.second + 1));
  });
}

std::vector<FoxgloveServer::Message> FoxglovePublisher::messagesOf(const sim2d::Frame& frame,
                                                                   const ChannelFilter& filter,
                                                                   bool withMetrics) {
  std::vector<FoxgloveServer::Message> messages;
  const auto add = [&messages](std::size_t channel, std::string&& bytes) {
    messages.push_back({static_cast<ChannelId>(channel + 1),
                        std::make_shared<const std::string>(std::move(bytes))});
  };
  topics_.publish(
      frame, [&](std::size_t topic, std::string bytes) { add(topic, std::move(bytes)); },
      [&](std::size_t topic) { return filter(static_cast<ChannelId>(topic + 1)); });
  const std::vector<metrics::MetricResult> results =
      withMetrics ? metrics_.values() : std::vector<metrics::MetricResult>();
  for (const metrics::MetricResult& result : results) {
    const auto channel = channelOf_.find(result.info.key);
    if (channel != channelOf_.end() && result.value.value) {
      add(channel->second, bridge::encode(Float64{*result.value.value}));
    }
  }
  return messages;
}

void FoxglovePublisher::publish(const sim2d::Frame& frame, Clock::time_point now) {
  const ChannelFilter isWanted = [this](ChannelId channel) { return server_->isWanted(channel); };
  const bool withMetrics =
      (!metricsPublishedAt_ || now - *metricsPublishedAt_ >= kBetweenMetrics) &&
      hasMetricSubscribers(isWanted);
  if (withMetrics) {
    metricsPublishedAt_ = now;
  }
  server_->publish(static_cast<std::uint64_t>(bridge::nanosecondsOf(frame.time)),
                   messagesOf(frame, isWanted, withMetrics));
  publishedAt_ = now;
  published_ = frame.step;
}

void FoxglovePublisher::catchUp(const sim2d::Frame& frame) {
  if (frame.step > newest_) {
    return;  // `show` will publish it
  }
  if (frame.step > published_) {  // skipped because of the display rate
    publish(frame, Clock::now());
  }
  topics_.resendScans();
  const ChannelFilter isAwaited = [this](ChannelId channel) {
    return server_->isMessageAwaited(channel);
  };
  server_->publish(static_cast<std::uint64_t>(bridge::nanosecondsOf(frame.time)),
                   messagesOf(frame, isAwaited, hasMetricSubscribers(isAwaited)),
                   FoxgloveServer::Recipients::Awaiting);
}

}  // namespace live
