#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
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
  void beginStep() {
    std::vector<Utterance> said;
    said.swap(fresh_);
    for (Utterance& words : said) {
      forget(words.speaker);
      audible_.insert(audible_.begin(), std::move(words));
    }
  }
  void say(std::int64_t step, int speaker, std::string text) {
    fresh_.push_back({++count_, step, speaker, std::move(text)});
  }
  /// A person who comes anew has said nothing.
  void forget(int speaker) {
    const auto isTheirs = [speaker](const Utterance& words) { return words.speaker == speaker; };
    audible_.erase(std::remove_if(audible_.begin(), audible_.end(), isTheirs), audible_.end());
    fresh_.erase(std::remove_if(fresh_.begin(), fresh_.end(), isTheirs), fresh_.end());
  }
  /// Audible last words, latest first.
  const std::vector<Utterance>& lastWords() const { return audible_; }

 private:
  std::vector<Utterance> audible_;
  std::vector<Utterance> fresh_;
  std::int64_t count_ = 0;
};

}  // namespace bt
