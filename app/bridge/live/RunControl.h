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

constexpr double kSlowest = 0.1, kFastest = 100.0;  // real-time factor

/// Controls for clients that do not change the results of a run: pause, single step, real-time
/// factor. Clients can also drive a robot with planner `teleop`; the commands are recorded with the
/// steps that use them. Thread-safe; the session must outlive it.
class RunControl {
 public:
  struct Facts {  // published as parameters
    std::string scenario;
    std::int64_t seed = 1;
    double timeStep = 0.05;  // [s]
  };
  /// A robot that clients can drive.
  struct TeleopRobot {
    std::string topic;  // "/cmd_vel"
    int id = -1;        // id in frames
  };

  RunControl(app::Session& session, Facts facts, const std::vector<TeleopRobot>& robots);
  ~RunControl();
  RunControl(const RunControl&) = delete;
  RunControl& operator=(const RunControl&) = delete;
  RunControl(RunControl&&) = delete;
  RunControl& operator=(RunControl&&) = delete;

  std::vector<Service> services();      // /hunavsim/pause, /hunavsim/step
  std::vector<Parameter> parameters();  // /hunavsim.paused, /hunavsim.real_time_factor and facts
  std::vector<ClientTopic> clientTopics();

 private:
  std::string setPaused(const ParameterValue& value);
  std::string setSpeed(const ParameterValue& value);
  Service pauseService();
  Service stepService();
  std::string drive(int robot, std::string_view encoding, std::string_view payload);
  sim2d::StepInputs takeCommands();

  app::Session& session_;
  const Facts facts_;
  const std::vector<TeleopRobot> robots_;
  std::mutex mutex_;
  std::map<int, sim2d::Input> commands_;  // newest command per robot; guarded by mutex_
};

}  // namespace live
