#include "app/bridge/live/SendQueue.h"

#include <iterator>
#include <utility>

namespace live {

namespace {

/// With the memory overhead of a message [B].
std::size_t costOf(const SendQueue::Message& message) {
  constexpr std::size_t kOverhead = 128;
  return message.head.size() + (message.body ? message.body->size() : 0) + kOverhead;
}

}  // namespace

/// The newest message is not dropped, even if it is larger than the limit.
void SendQueue::add(Message message) {
  sumOf(message.kind) += costOf(message);
  messages_.push_back(std::move(message));
  auto each = std::next(messages_.begin(), isFirstStarted_ ? 1 : 0);
  while (topicBytes_ > limit_ && each != messages_.end() && std::next(each) != messages_.end()) {
    if (each->kind == Kind::Topic) {
      topicBytes_ -= costOf(*each);
      ++dropped_;
      each = messages_.erase(each);
    } else {
      ++each;
    }
  }
}

const SendQueue::Message& SendQueue::startFirst() {
  isFirstStarted_ = true;
  return messages_.front();
}

void SendQueue::removeFirst() {
  sumOf(messages_.front().kind) -= costOf(messages_.front());
  messages_.pop_front();
  isFirstStarted_ = false;
}

}  // namespace live
