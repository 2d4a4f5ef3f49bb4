#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bt {

/// Something said. Heard by others from the step after it was said.
struct Utterance {
  std::int64_t serial = 0;  // from 1, in order of saying
  std::int64_t step = 0;
  int speaker = 0;  // index of the person
  std::string text;
};

/// What people have said: the last words of everyone, so its size is that of the crowd.
class SpeechBus {
 public:
  /// Words of the step before become audible.
  void beginStep();
  void say(std::int64_t step, int speaker, std::string text);
  /// A person who comes anew has said nothing.
  void forget(int speaker);
  /// Audible last words, latest first.
  const std::vector<Utterance>& lastWords() const { return audible_; }

 private:
  std::vector<Utterance> audible_;
  std::vector<Utterance> fresh_;
  std::int64_t count_ = 0;
};

}  // namespace bt
