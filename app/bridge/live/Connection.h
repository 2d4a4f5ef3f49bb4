#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/live/Outbox.h"
#include "app/bridge/live/WebSocketFrames.h"
#include "app/bridge/live/WebSocketHandshake.h"

namespace live {

using Clock = std::chrono::steady_clock;

/// What a server asks of its clients.
struct ConnectionRules {
  std::vector<std::string> protocols;  // the subprotocols spoken here
  std::vector<std::string> origins;    // of pages that may connect beside the usual ones
  std::size_t largestMessage = kLargestMessage;
  std::size_t mostWaiting = kMostWaiting;
  std::chrono::milliseconds handshakeTime{10000};  // for the whole request
  std::chrono::milliseconds silence{20000};        // then a ping is sent; as long again: it is gone
  std::chrono::milliseconds closeTime{2000};       // for its close frame and what is under way
};

/// One client: from the request of HTTP to the close frame, without input and output. What it does
/// against the rules ends it; nothing that it sends makes us keep more than a message of the
/// largest size, a request, and `kMostAnswers` of answers. Thread: one at a time.
class Connection {
 public:
  /// What is told of it, in this order.
  struct Events {
    std::function<bool()> isFull;  // asked before it opens: true refuses it; null: never
    std::function<void()> opened;
    std::function<void(WebSocketMessage&&)> received;        // Text or Binary
    std::function<void(const std::string& origin)> refused;  // a page of that origin
  };

  Connection(const ConnectionRules& rules, Clock::time_point now)
      : rules_(rules),
        reader_(rules.largestMessage),
        out_(rules.mostWaiting),
        deadline_(now + rules.handshakeTime),
        heard_(now) {}

  /// Bytes came. Answers to control frames and to mistakes go into the outbox by themselves.
  void read(std::string_view bytes, Clock::time_point now, const Events& events);
  /// Looks at the clock.
  void tick(Clock::time_point now);
  /// The client has closed its side of the socket.
  void readEnd();

  // nothing happens unless it is open
  void sendText(std::string_view payload);
  /// `head` and `body` are one payload.
  void sendBinary(std::string_view head, const SharedBytes& body, Outbox::Kind kind);
  void close(CloseCode code, std::string_view reason, Clock::time_point now);

  bool isOpen() const { return state_ == State::Open; }
  /// False: what comes is not to be read yet; the client reads too slowly.
  bool wantsBytes() const { return !isAtEnd_ && !out_.hasManyAnswers(); }
  /// Nothing more will be said: our side of the socket can be shut down.
  bool isSaid() const { return isLast_ && out_.isEmpty(); }
  /// The socket can be closed.
  bool isOver() const { return state_ == State::Ended || (isAtEnd_ && out_.isEmpty()); }
  Outbox& out() { return out_; }
  const Outbox& out() const { return out_; }

 private:
  enum class State {
    Request,  // its head is read
    Open,
    Closing,  // our last word is said
    Ended
  };
  std::string_view readRequest(std::string_view bytes, Clock::time_point now, const Events& events);
  bool take(WebSocketMessage&& message, Clock::time_point now, const Events& events);
  void refuse(const std::string& response, Clock::time_point now);
  void sendControl(Opcode opcode, std::string_view payload);
  void endSoon(Clock::time_point now);

  const ConnectionRules& rules_;
  State state_ = State::Request;
  bool isLast_ = false;   // nothing more will be said
  bool isAtEnd_ = false;  // the client says no more
  std::string request_;
  FrameReader reader_;
  Outbox out_;
  Clock::time_point deadline_;  // of the request, of closing
  Clock::time_point heard_;     // its last bytes
  bool isAsked_ = false;        // a ping was sent since then
};

}  // namespace live
