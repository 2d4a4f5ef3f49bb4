#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/live/WebSocketFrames.h"
#include "app/bridge/live/WebSocketHandshake.h"

namespace live {

/// Bytes shared by the queues of several clients.
using SharedBytes = std::shared_ptr<const std::string>;

constexpr std::size_t kMaxQueuedMessages = std::size_t{8} << 20U;   // [B], per client
constexpr std::size_t kMaxQueuedReplies = std::size_t{256} << 10U;  // [B], per client

/// The send queue of one client. Messages may be dropped, oldest first; responses never are. Not
/// thread-safe.
class SendQueue {
 public:
  enum class Kind { Answer, Message };

  explicit SendQueue(std::size_t maxQueuedMessages = kMaxQueuedMessages)
      : most_(maxQueuedMessages) {}

  /// Responses do not cause messages to be dropped; instead, reading from a client with many queued
  /// responses is suspended (`hasManyReplies`).
  void add(std::string head, SharedBytes body = nullptr, Kind kind = Kind::Answer);
  /// Queues a response before all messages that have not been partly sent.
  void addNext(std::string bytes);
  /// Drops all messages that have not been partly sent.
  void dropAllMessages();

  bool isEmpty() const { return pieces_.empty(); }
  bool hasManyReplies() const { return replyBytes_ > kMaxQueuedReplies; }
  std::size_t waiting() const { return messageBytes_ + replyBytes_; }  // [B]
  std::size_t droppedCount() const { return dropped_; }                // number of messages dropped

  /// The next bytes to send, in at most `count` parts.
  std::vector<std::string_view> next(std::size_t count) const;
  /// Removes the bytes that were sent.
  void sent(std::size_t bytes);

 private:
  struct Piece {
    std::string head;
    SharedBytes body;
    Kind kind;
    std::size_t size() const { return head.size() + (body ? body->size() : 0); }
    std::size_t cost() const { return size() + kEach; }
  };
  static constexpr std::size_t kEach = 128;  // [B], memory overhead per piece
  using Place = std::deque<Piece>::iterator;
  Place firstWhole();
  Place drop(const Place& piece);
  void enforceLimit();
  std::size_t& sumOf(Kind kind) { return kind == Kind::Message ? messageBytes_ : replyBytes_; }

  std::size_t most_;
  std::deque<Piece> pieces_;
  std::size_t sentOfFirst_ = 0;  // [B] of the first piece already sent
  std::size_t messageBytes_ = 0, replyBytes_ = 0, dropped_ = 0;
};

using Clock = std::chrono::steady_clock;

/// Limits and accepted protocols of a server.
struct ConnectionLimits {
  std::vector<std::string> protocols;  // supported subprotocols
  std::vector<std::string> origins;    // allowed page origins besides the defaults
  std::size_t largestMessage = kLargestMessage;
  std::size_t maxQueuedMessages = kMaxQueuedMessages;
  std::chrono::milliseconds handshakeTime{10000};  // limit for the complete request
  std::chrono::milliseconds idleTimeout{20000};    // then ping; after twice that: lost
  std::chrono::milliseconds closeTime{2000};       // limit for the closing handshake
};

/// The state machine of one client connection, from the HTTP request to the close frame, without
/// I/O. A protocol violation ends the connection. Memory is limited to one message of maximum size,
/// one request and `kMaxQueuedReplies` bytes of responses. Not thread-safe.
class Connection {
 public:
  /// Callbacks, called in this order.
  struct Events {
    std::function<bool()> isFull;  // called before opening; true: reject; null: never full
    std::function<void()> opened;
    std::function<void(WebSocketMessage&&)> received;        // text or binary
    std::function<void(const std::string& origin)> refused;  // rejected page origin
  };

  Connection(const ConnectionLimits& rules, Clock::time_point now)
      : rules_(rules),
        reader_(rules.largestMessage),
        out_(rules.maxQueuedMessages),
        deadline_(now + rules.handshakeTime),
        lastReceived_(now) {}

  /// Processes received bytes. Responses to control frames and errors are added to the outbox.
  void read(std::string_view bytes, Clock::time_point now, const Events& events);
  /// Checks timeouts.
  void tick(Clock::time_point now);
  /// The client closed its side of the socket.
  void readEnd();

  // These have no effect unless the connection is open.
  void sendText(std::string_view payload);
  /// Sends `head` and `body` as one payload.
  void sendBinary(std::string_view head, const SharedBytes& body, SendQueue::Kind kind);
  void close(CloseCode code, std::string_view reason, Clock::time_point now);

  bool isOpen() const { return state_ == State::Open; }
  /// False: do not read from the socket now, because the client reads too slowly.
  bool canRead() const { return !isReadClosed_ && !out_.hasManyReplies(); }
  /// Everything has been sent: our side of the socket can be shut down.
  bool isSendFinished() const { return isSendClosed_ && out_.isEmpty(); }
  /// Whether the socket can be closed.
  bool isFinished() const { return state_ == State::Ended || (isReadClosed_ && out_.isEmpty()); }
  SendQueue& out() { return out_; }
  const SendQueue& out() const { return out_; }

 private:
  enum class State {
    Request,  // reading the HTTP request
    Open,
    Closing,  // close frame queued
    Ended
  };
  std::string_view readRequest(std::string_view bytes, Clock::time_point now, const Events& events);
  bool take(WebSocketMessage&& message, Clock::time_point now, const Events& events);
  void reject(const std::string& response, Clock::time_point now);
  void sendControl(Opcode opcode, std::string_view payload);
  void startClosing(Clock::time_point now);

  const ConnectionLimits& rules_;
  State state_ = State::Request;
  bool isSendClosed_ = false;  // no more data will be queued
  bool isReadClosed_ = false;  // the client closed its side
  std::string request_;
  FrameReader reader_;
  SendQueue out_;
  Clock::time_point deadline_;      // of the handshake or of closing
  Clock::time_point lastReceived_;  // time of the last received bytes
  bool isPingSent_ = false;         // ping sent since lastReceived_
};

}  // namespace live
