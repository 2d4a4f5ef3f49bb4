#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"
#include "app/bridge/live/RunControl.h"
#include "app/bridge/live/RunMetrics.h"
#include "app/bridge/topics/RunTopics.h"
#include "app/run/MetricsSetup.h"
#include "app/run/Session.h"
#include "sim2d/world/World.h"

namespace live {

struct LiveRunSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
  std::vector<std::string> origins;  // of pages that may connect beside the usual ones
  bool canDrive = true;              // robots with planner `teleop` listen to /cmd_vel
  std::function<bool()> wantsStop;   // asked ten times a second; ends the run even while it pauses
  std::function<void(const base::Diagnostic&)> warn;  // in the server's thread
};

/// A run that goes on before the eyes of Foxglove: all of its topics (RunTopics), its metrics, what
/// clients may do with it (RunControl). Of its results nothing changes. Made and used in the thread
/// that runs; session, world and scenario must outlive it.
class LiveRun {
 public:
  /// From now on clients are served. Errors: as of WebSocketServer.
  static base::Result<std::unique_ptr<LiveRun>> open(const LiveRunSettings& settings,
                                                     app::Session& session, sim2d::World& world,
                                                     const sim2d::Scenario& scenario,
                                                     const std::string& scenarioName,
                                                     const app::MetricsSetup& metrics);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;
  LiveRun(LiveRun&&) = delete;
  LiveRun& operator=(LiveRun&&) = delete;

  std::uint16_t port() const { return server_->port(); }
  bool wasWatched() const { return server_->hadClients(); }  // some client has connected
  /// Each state once, in order. Of those that come faster than a screen shows, some are left out.
  void show(const sim2d::Frame& frame);
  /// The last state, also if it was shown, with the metrics in the end; clients are told why there
  /// are no more.
  void finish(const sim2d::Frame& frame, const std::string& reason);

 private:
  LiveRun(app::Session& session, sim2d::World& world, const sim2d::Scenario& scenario,
          const std::string& scenarioName, const app::MetricsSetup& metrics,
          const LiveRunSettings& settings);
  FoxgloveSettings settingsOf(const LiveRunSettings& given, const std::string& scenarioName);
  std::vector<Channel> channels() const;
  void meet(const sim2d::Frame& frame);
  using Wants = std::function<bool(ChannelId)>;
  void publish(const sim2d::Frame& frame, Clock::time_point now);
  /// Publishes the messages of the frame that are subscribed to; metrics of those channels too if
  /// `withMetrics`.
  std::vector<FoxgloveServer::Message> messagesOf(const sim2d::Frame& frame, const Wants& wants,
                                                  bool withMetrics);
  /// After a subscription or at the start of a pause: publishes the newest state to all
  /// subscriptions that lack it.
  void catchUp(const sim2d::Frame& frame);
  bool wantsMetrics(const Wants& wants) const;
  bool isFasterThanScreens() const;

  app::Session& session_;
  sim2d::World& world_;
  bridge::RunTopics topics_;  // channels 1 …
  RunMetrics metrics_;        // the channels behind them
  RunControl control_;
  std::vector<int> present_;  // people whose data the topics have
  std::optional<Clock::time_point> shown_, measured_;
  std::int64_t newest_ = -1;                // step
  std::int64_t published_ = -1;             // step of what clients got last
  std::set<std::string> warned_;            // origins; of the server's thread
  std::unique_ptr<FoxgloveServer> server_;  // goes first: its thread uses all else
};

}  // namespace live
