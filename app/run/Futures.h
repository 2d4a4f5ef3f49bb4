#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/RunBranch.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/trace/Recording.h"

namespace app {

/// Number and duration of the simulated futures of a run.
struct FuturesOptions {
  int count = 20;          // of futures
  double horizon = 10.0;   // [s]
  double spread = 0.2;     // [m/s] standard deviation of random pushes, per axis
  int jobs = 1;            // processes at a time
  long long seed = 1;      // of future k: this + k
  double sampleGap = 0.2;  // [s] between two points of a trajectory
};
constexpr int kMaxFutures = 1000;
constexpr double kLongestFuture = 600.0;  // [s]

/// The first contact of a robot with a person; in a run without robots, of two people.
struct FutureContact {
  double time = 0.0;  // of the run [s]
  int id = 0, other = 0;
  base::Vec2 where = base::Vec2::Zero();  // of `id` [m]
};

/// One simulated continuation of a run.
struct Future {
  int number = 0;  // 0, 1 … in the order of their seeds
  long long seed = 1;
  std::vector<double> times;                    // of the points [s], the moment first
  std::map<int, std::vector<base::Vec2>> ways;  // by id; NaN while absent [m]
  std::optional<FutureContact> contact;
  std::string failure;  // why the world stopped before the horizon; empty: it did not
};

/// Simulates futures of a world, each in a copy of the process with its own random seed. Once per
/// second, each walking person gets a random velocity with standard deviation `spread` per axis.
/// `onFuture` receives each finished future; `wantsStop` is polled ten times per second. The
/// process must have a single thread. Errors: external code in the scenario, no more processes.
base::Diagnostics simulateFutures(sim2d::World& world, const Bundle& bundle,
                                  const FuturesOptions& options,
                                  const std::function<void(const Future&)>& onFuture,
                                  const std::function<bool()>& wantsStop);
/// Simulates one future in this process; the world must not be used afterwards.
Future simulateFuture(sim2d::World& world, const Bundle& bundle, const FuturesOptions& options,
                      int number);

/// A line of JSON, without a line end; reading gives equal values.
std::string futureText(const Future& future);
std::optional<Future> futureOf(const std::string& text);

/// The futures with a contact up to a time, and the probability that follows.
struct ContactChance {
  double time = 0.0;  // [s]
  int contacts = 0, futures = 0;
  double chance = 0.0;
  statistics::Interval interval;  // Wilson's, 95 %
};
/// Every `gap` [s] from the moment to the horizon. Futures that failed before a contact count as
/// free of contact.
std::vector<ContactChance> contactChances(const std::vector<Future>& futures, double from,
                                          double horizon, double gap = 0.2);
/// The median time of the contacts [s]; none without contacts.
std::optional<double> medianContactTime(const std::vector<Future>& futures);

/// A request to another process of this program to simulate futures of a run.
struct FuturesRequest {
  Bundle bundle;  // of the beginning of the run
  std::vector<RunBranch> branches;
  sim2d::RecordedInputs inputs;
  std::int64_t at = 0;  // step of the moment
  std::string state;    // its rows as in trajectory.csv, which the replay must reproduce
  FuturesOptions options;
};
/// The request as bytes; only the same version of the program can read them.
std::string encodeFuturesRequest(const FuturesRequest& request);
base::Result<FuturesRequest> decodeFuturesRequest(const std::string& bytes);
/// Replays the run up to the step `at`, then simulates its futures. Errors: those of the run and of
/// `simulateFutures`; the replay diverges from the recording.
base::Diagnostics runFuturesRequest(const FuturesRequest& request,
                                    const std::function<void(const Future&)>& onFuture,
                                    const std::function<bool()>& wantsStop);

}  // namespace app
