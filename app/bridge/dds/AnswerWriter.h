#pragma once

#include <chrono>
#include <deque>
#include <memory>

#include "app/bridge/dds/DdsInside.h"

namespace bridge {

/// Writes the answers of a service. A client that asks has often found us before we have found the
/// reader of its answers, and what is written until then does not reach it: its answers are kept
/// until it is met, for two seconds at most (256 of them), and those to others go out meanwhile.
/// Calls of rmw_cyclonedds tell the participant of who asks alone: of several clients of one
/// service in one participant the first to be met lets all answers out.
class AnswerWriter {
 public:
  /// `met`: the listener of `writer`.
  AnswerWriter(DdsPtr dds, int node, efd::DataWriter* writer, std::unique_ptr<MetReaders> met);
  ~AnswerWriter();
  AnswerWriter(const AnswerWriter&) = delete;
  AnswerWriter& operator=(const AnswerWriter&) = delete;
  AnswerWriter(AnswerWriter&&) = delete;
  AnswerWriter& operator=(AnswerWriter&&) = delete;

  /// `asker`: its reader; any reader of its participant where the entity is unknown; unknown as a
  /// whole: nobody is waited for.
  void send(const rtps::GUID_t& asker, Bytes answer, const rtps::WriteParams& parameters);
  /// Those whose askers are met by now, or are not within two seconds.
  void sendKept();

 private:
  struct Kept {
    rtps::GUID_t asker;
    Bytes answer;
    rtps::WriteParams parameters;
    std::chrono::steady_clock::time_point until;
  };
  bool isKeptFor(const rtps::GUID_t& asker) const;

  std::unique_ptr<MetReaders> met_;
  OwnedWriter writer_;
  std::deque<Kept> kept_;  // the oldest first
};

}  // namespace bridge
