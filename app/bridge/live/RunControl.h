#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"
#include "app/run/Session.h"

namespace live {

constexpr double kSlowest = 0.1, kFastest = 100.0;  // simulated seconds per second

/// What clients may do with a run, so that it stays the same run: pause it, take a step, change its
/// pace; drive a robot whose planner is `teleop`, which is recorded with the steps in which it
/// counts. Thread: any; the session must outlive it.
class RunControl {
 public:
  struct Facts {  // that parameters tell
    std::string scenario;
    std::int64_t seed = 1;
    double timeStep = 0.05;  // [s]
  };
  /// A robot that may be driven.
  struct Driven {
    std::string topic;  // "/cmd_vel"
    int id = -1;        // in frames
  };

  RunControl(app::Session& session, Facts facts, const std::vector<Driven>& robots);
  ~RunControl();
  RunControl(const RunControl&) = delete;
  RunControl& operator=(const RunControl&) = delete;
  RunControl(RunControl&&) = delete;
  RunControl& operator=(RunControl&&) = delete;

  std::vector<Service> services();      // /hunavsim/pause, /hunavsim/step
  std::vector<Parameter> parameters();  // /hunavsim.paused, /hunavsim.real_time_factor and facts
  std::vector<Inlet> inlets();
  // As anybody ordered.
  bool isPaused() const { return session_.isPaused(); }
  double speed() const { return session_.speed(); }

 private:
  std::string setPaused(const ParameterValue& value);
  std::string setSpeed(const ParameterValue& value);
  Service pauseService();
  Service stepService();
  std::string drive(int robot, std::string_view encoding, std::string_view payload);
  sim2d::StepInputs takeDriven();

  app::Session& session_;
  const Facts facts_;
  const std::vector<Driven> robots_;
  std::mutex mutex_;
  std::map<int, sim2d::Input> driven_;  // the newest word for each robot; guarded by the mutex
};

}  // namespace live
