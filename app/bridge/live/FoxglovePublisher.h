#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"
#include "app/bridge/live/RunControl.h"
#include "app/bridge/topics/RunTopics.h"
#include "app/run/MetricsSetup.h"
#include "app/run/Session.h"
#include "metrics/IncrementalEvaluation.h"
#include "sim2d/world/World.h"

namespace live {

struct FoxglovePublisherSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
  std::vector<std::string> origins;  // allowed page origins besides the defaults
  bool canDrive = true;              // robots with planner `teleop` follow /cmd_vel
  std::function<bool()> wantsStop;   // polled 10 times/s, also during a pause; ends the run
  std::function<void(const base::Diagnostic&)> warn;  // called in the server's thread
};

/// Publishes a running simulation to Foxglove: all topics (RunTopics), the controls of clients
/// (RunControl) and the current metrics, each as a number on its own topic
/// (`/hunavsim/metrics/minimum_distance`, std_msgs/msg/Float64), which Foxglove and PlotJuggler can
/// plot; undefined metrics are not published. Does not affect the results. Created and used in the
/// thread of the run; session, world and scenario must outlive it.
class FoxglovePublisher {
 public:
  /// Starts serving clients. Errors: those of WebSocketServer.
  static base::Result<std::unique_ptr<FoxglovePublisher>> open(
      const FoxglovePublisherSettings& settings, app::Session& session, sim2d::World& world,
      const sim2d::Scenario& scenario, const std::string& scenarioName,
      const app::MetricsSetup& metrics);
  ~FoxglovePublisher();
  FoxglovePublisher(const FoxglovePublisher&) = delete;
  FoxglovePublisher& operator=(const FoxglovePublisher&) = delete;
  FoxglovePublisher(FoxglovePublisher&&) = delete;
  FoxglovePublisher& operator=(FoxglovePublisher&&) = delete;

  std::uint16_t port() const { return server_->port(); }
  bool hadClient() const { return server_->hadClient(); }  // a client has ever connected
  /// Call for each state once, in order. States faster than the display rate are skipped.
  void show(const sim2d::Frame& frame);
  /// Publishes the last state, even if already published, with the final metrics, and closes the
  /// connections with the reason.
  void finish(const sim2d::Frame& frame, const std::string& reason);

 private:
  FoxglovePublisher(app::Session& session, sim2d::World& world, const sim2d::Scenario& scenario,
                    const std::string& scenarioName, const app::MetricsSetup& metrics,
                    const FoxglovePublisherSettings& settings);
  FoxgloveSettings settingsOf(const FoxglovePublisherSettings& given,
                              const std::string& scenarioName);
  using ChannelFilter = std::function<bool(ChannelId)>;
  void publish(const sim2d::Frame& frame, Clock::time_point now);
  /// The messages of the frame for channels that pass the filter, and those of all metrics if
  /// `withMetrics`.
  std::vector<FoxgloveServer::Message> messagesOf(const sim2d::Frame& frame,
                                                  const ChannelFilter& filter, bool withMetrics);
  /// After a subscription or at the start of a pause: publishes the newest state to all
  /// subscriptions that lack it.
  void catchUp(const sim2d::Frame& frame);
  bool hasMetricSubscribers(const ChannelFilter& filter) const;
  bool isAboveDisplayRate() const;

  app::Session& session_;
  sim2d::World& world_;
  bridge::RunTopics topics_;
  metrics::FrameEvaluation metrics_;
  std::vector<Channel> channels_;                 // of topics_, then of the metrics
  std::map<std::string, std::size_t> channelOf_;  // index in channels_ by metric key
  RunControl control_;
  sim2d::KnownPeople known_;  // to topics_ and metrics_
  std::optional<Clock::time_point> publishedAt_, metricsPublishedAt_;
  std::int64_t newest_ = -1;                // step
  std::int64_t published_ = -1;             // step of the last published state
  std::set<std::string> warned_;            // rejected origins; used in the server's thread
  std::unique_ptr<FoxgloveServer> server_;  // last member: its thread uses the others
};

}  // namespace live
