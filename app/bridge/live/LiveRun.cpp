#include "app/bridge/live/LiveRun.h"

#include <algorithm>
#include <utility>

#include "app/bridge/messages/TypeTable.h"
#include "app/bridge/topics/RunMessages.h"

namespace live {

namespace {

constexpr std::chrono::microseconds kBetweenFrames{16000};  // no screen shows more
constexpr std::chrono::milliseconds kBetweenMetrics{250};   // making them takes its time

constexpr std::size_t kMostWarnings = 5;     // pages may try again and again, under many names
constexpr std::size_t kLongestOrigin = 200;  // [B]

/// Those whose planner listens.
std::vector<RunControl::Driven> drivenOf(const sim2d::TraceHeader& header) {
  std::vector<RunControl::Driven> driven;
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

LiveRun::LiveRun(app::Session& session, sim2d::World& world, const sim2d::Scenario& scenario,
                 const std::string& scenarioName, const app::MetricsSetup& metrics,
                 const LiveRunSettings& settings)
    : session_(session),
      world_(world),
      topics_(world.header(), bridge::lidarsOf(scenario)),
      metrics_(world.header(), metrics.selection, metrics.parameters),
      control_(session, {scenarioName, static_cast<std::int64_t>(world.header().seed), world.dt()},
               settings.canDrive ? drivenOf(world.header()) : std::vector<RunControl::Driven>()) {}

base::Result<std::unique_ptr<LiveRun>> LiveRun::open(const LiveRunSettings& settings,
                                                     app::Session& session, sim2d::World& world,
                                                     const sim2d::Scenario& scenario,
                                                     const std::string& scenarioName,
                                                     const app::MetricsSetup& metrics) {
  std::unique_ptr<LiveRun> run(
      new LiveRun(session, world, scenario, scenarioName, metrics, settings));
  auto server = FoxgloveServer::listen(run->settingsOf(settings, scenarioName), run->channels());
  if (!server) {
    return server.diagnostics();
  }
  run->server_ = *std::move(server);
  world.tellScans(true);
  session.refreshWith([to = run.get()](const sim2d::Frame& frame) { to->catchUp(frame); });
  run->server_->start();
  return base::Result<std::unique_ptr<LiveRun>>(std::move(run));
}

LiveRun::~LiveRun() {
  if (server_) {
    session_.refreshWith({});
    server_->stop("the run is over");
  }
}

FoxgloveSettings LiveRun::settingsOf(const LiveRunSettings& given,
                                     const std::string& scenarioName) {
  FoxgloveSettings settings;
  settings.server.address = given.address;
  settings.server.port = given.port;
  settings.server.rules.origins = given.origins;
  settings.name = "hunavsim: " + scenarioName;
  settings.session = newSessionName();
  settings.services = control_.services();
  settings.inlets = control_.inlets();
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

std::vector<Channel> LiveRun::channels() const {
  std::vector<Channel> channels;
  for (const bridge::Topic& topic : topics_.topics()) {
    channels.push_back({topic.name, std::string(topic.type),
                        bridge::findType(topic.type)->definition, topic.isLatched});
  }
  channels.insert(channels.end(), metrics_.channels().begin(), metrics_.channels().end());
  return channels;
}

void LiveRun::show(const sim2d::Frame& frame) {
  if (frame.step <= newest_) {
    return;
  }
  newest_ = frame.step;
  meet(frame);
  topics_.note(frame);
  metrics_.add(frame, [this] { return world_.header(); });
  const Clock::time_point now = Clock::now();
  if (!shown_ || !isFasterThanScreens() || now - *shown_ >= kBetweenFrames) {
    publish(frame, now);
  }
}

/// Else each state is shown: single steps, and those that come late and in a hurry.
bool LiveRun::isFasterThanScreens() const {
  const std::chrono::duration<double> each(world_.dt() / control_.speed());
  return !control_.isPaused() && each < kBetweenFrames;
}

/// With the metrics as they are in the end.
void LiveRun::finish(const sim2d::Frame& frame, const std::string& reason) {
  const bool isNew = frame.step > newest_;
  measured_.reset();
  shown_.reset();
  show(frame);
  if (!isNew) {
    publish(frame, Clock::now());
  }
  server_->stop(reason);
}

/// Somebody came from a source.
void LiveRun::meet(const sim2d::Frame& frame) {
  if (frame.humans.id != present_) {
    present_ = frame.humans.id;
    topics_.setHeader(world_.header());
  }
}

bool LiveRun::wantsMetrics(const Wants& wants) const {
  for (std::size_t i = 0; i < metrics_.channels().size(); ++i) {
    if (wants(static_cast<ChannelId>(topics_.topics().size() + i + 1))) {
      return true;
    }
  }
  return false;
}

std::vector<FoxgloveServer::Message> LiveRun::messagesOf(const sim2d::Frame& frame,
                                                         const Wants& wants, bool withMetrics) {
  std::vector<FoxgloveServer::Message> messages;
  const auto add = [&messages](std::size_t channel, std::string&& bytes) {
    messages.push_back({static_cast<ChannelId>(channel + 1),
                        std::make_shared<const std::string>(std::move(bytes))});
  };
  topics_.tell(
      frame, [&](std::size_t topic, std::string bytes) { add(topic, std::move(bytes)); },
      [&](std::size_t topic) { return wants(static_cast<ChannelId>(topic + 1)); });
  if (withMetrics && wantsMetrics(wants)) {
    metrics_.tell([&](std::size_t channel, std::string&& bytes) {
      add(topics_.topics().size() + channel, std::move(bytes));
    });
  }
  return messages;
}

void LiveRun::publish(const sim2d::Frame& frame, Clock::time_point now) {
  const Wants isWanted = [this](ChannelId channel) { return server_->isWanted(channel); };
  const bool withMetrics = !measured_ || now - *measured_ >= kBetweenMetrics;
  const auto messages = messagesOf(frame, isWanted, withMetrics);
  if (withMetrics && wantsMetrics(isWanted)) {
    measured_ = now;
  }
  server_->publish(static_cast<std::uint64_t>(bridge::nanosecondsOf(frame.time)), messages);
  shown_ = now;
  published_ = frame.step;
}

void LiveRun::catchUp(const sim2d::Frame& frame) {
  if (frame.step > newest_) {
    return;  // it will be shown
  }
  if (frame.step > published_) {  // skipped, as newer frames came faster than a screen shows
    publish(frame, Clock::now());
  }
  topics_.repeatScans();
  server_->catchUp(
      static_cast<std::uint64_t>(bridge::nanosecondsOf(frame.time)),
      messagesOf(
          frame, [this](ChannelId channel) { return server_->isAwaited(channel); }, true));
}

}  // namespace live
