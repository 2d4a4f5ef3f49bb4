#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "app/bridge/dds/DdsInside.h"

namespace bridge {

/// The answers to one client, taken from among those to all clients of its service in the thread of
/// DDS, as they come: however many go to others while nobody looks, its own are there, the last
/// hundred of them. Listener of the client's reader; thread: any.
class OwnAnswers : public efd::DataReaderListener {
 public:
  using Answer = std::pair<std::int64_t, Bytes>;  // number of the call, answer
  /// The number of the call, where the answer is ours; takes out of the bytes what is not of the
  /// answer.
  using Recognize = std::function<std::optional<std::int64_t>(Bytes&, const efd::SampleInfo&)>;

  explicit OwnAnswers(Bell& bell) : bell_(bell) {}  // rings when one has come

  /// To be called before anything is asked: what comes until then is of others.
  void recognizeBy(Recognize recognize);
  std::optional<Answer> next();

  void on_data_available(efd::DataReader* reader) override;
  void on_subscription_matched(efd::DataReader* /*reader*/,
                               const efd::SubscriptionMatchedStatus& /*status*/) override {
    bell_.ring();
  }

 private:
  bool keepIfOurs(Bytes& bytes, const efd::SampleInfo& info);

  Bell& bell_;
  std::mutex mutex_;
  Recognize recognize_;
  std::deque<Answer> waiting_;  // the oldest first
};

}  // namespace bridge
