#include "bt/human/SpeechBus.h"

#include <algorithm>
#include <utility>

namespace bt {

void SpeechBus::beginStep() {
  std::vector<Utterance> said;
  said.swap(fresh_);
  for (Utterance& words : said) {
    forget(words.speaker);
    audible_.insert(audible_.begin(), std::move(words));
  }
}

void SpeechBus::say(std::int64_t step, int speaker, std::string text) {
  fresh_.push_back({++count_, step, speaker, std::move(text)});
}

void SpeechBus::forget(int speaker) {
  const auto isTheirs = [speaker](const Utterance& words) { return words.speaker == speaker; };
  audible_.erase(std::remove_if(audible_.begin(), audible_.end(), isTheirs), audible_.end());
  fresh_.erase(std::remove_if(fresh_.begin(), fresh_.end(), isTheirs), fresh_.end());
}

}  // namespace bt
