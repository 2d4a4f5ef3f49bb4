#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>

namespace live {

/// Bytes shared by the queues of several clients.
using SharedBytes = std::shared_ptr<const std::string>;

constexpr std::size_t kMaxQueuedMessages = std::size_t{8} << 20U;   // [B], per client
constexpr std::size_t kMaxQueuedReplies = std::size_t{256} << 10U;  // [B], per client

/// The messages that wait to be sent to one client. Topic messages may be dropped, oldest first;
/// responses never are. Not thread-safe.
class SendQueue {
 public:
  enum class Kind { Text, Response, Topic };  // Text: a response as JSON; the others are binary
  /// `head` and `body` are sent as one message.
  struct Message {
    Kind kind = Kind::Text;
    std::string head;
    SharedBytes body = nullptr;
  };

  /// `limit`: bytes of queued topic messages, above which the oldest are dropped.
  explicit SendQueue(std::size_t limit = kMaxQueuedMessages) : limit_(limit) {}

  /// Responses do not cause messages to be dropped; instead, reading from a client with many queued
  /// responses is suspended (`hasManyReplies`).
  void add(Message message);
  /// Returns the oldest message, which is no longer dropped and stays valid until `removeFirst`.
  /// The queue must not be empty.
  const Message& startFirst();
  void removeFirst();

  bool isEmpty() const { return messages_.empty(); }
  bool hasManyReplies() const { return replyBytes_ > kMaxQueuedReplies; }
  std::size_t droppedCount() const { return dropped_; }  // number of messages dropped

 private:
  std::size_t& sumOf(Kind kind) { return kind == Kind::Topic ? topicBytes_ : replyBytes_; }

  std::size_t limit_;
  std::list<Message> messages_;  // a list, because the first one is read while others are dropped
  bool isFirstStarted_ = false;
  std::size_t topicBytes_ = 0, replyBytes_ = 0, dropped_ = 0;
};

}  // namespace live
