#include "app/bridge/live/Connection.h"

#include <utility>

namespace live {

namespace {

constexpr std::string_view kHeadEnd = "\r\n\r\n";

}  // namespace

void Connection::read(std::string_view bytes, Clock::time_point now, const Events& events) {
  heard_ = now;
  isAsked_ = false;
  if (state_ == State::Request) {
    bytes = readRequest(bytes, now, events);
  }
  if (isLast_ || state_ == State::Request) {
    return;
  }
  const auto wrong = reader_.read(
      bytes, [&](WebSocketMessage&& message) { return take(std::move(message), now, events); });
  if (wrong) {
    close(wrong->code, wrong->reason, now);
  }
}

/// Returns what stands behind the request.
std::string_view Connection::readRequest(std::string_view bytes, Clock::time_point now,
                                         const Events& events) {
  const std::size_t before = request_.size();
  request_.append(bytes.substr(0, kLongestRequest + kHeadEnd.size() - before));
  const std::size_t end = request_.find(kHeadEnd, before < 3 ? 0 : before - 3);
  if (end == std::string::npos) {
    if (request_.size() > kLongestRequest) {
      refuse(httpRefusal("431 Request Header Fields Too Large", "The request is too long."), now);
    }
    return {};
  }
  const std::size_t size = end + kHeadEnd.size();
  const HandshakeAnswer answer =
      answerHandshake(std::string_view(request_).substr(0, size), rules_.protocols, rules_.origins);
  request_ = {};
  if (!answer.isAccepted) {
    refuse(answer.response, now);
    if (!answer.refusedOrigin.empty()) {
      events.refused(answer.refusedOrigin);
    }
    return {};
  }
  if (events.isFull && events.isFull()) {
    refuse(httpRefusal("503 Service Unavailable", "Too many are connected."), now);
    return {};
  }
  out_.add(answer.response);
  state_ = State::Open;
  events.opened();
  return bytes.substr(size - before);
}

void Connection::refuse(const std::string& response, Clock::time_point now) {
  out_.add(response);
  request_ = {};
  isLast_ = true;
  endSoon(now);
}

void Connection::endSoon(Clock::time_point now) {
  state_ = State::Closing;
  deadline_ = now + rules_.closeTime;
}

bool Connection::take(WebSocketMessage&& message, Clock::time_point now, const Events& events) {
  switch (message.opcode) {
    case Opcode::Ping:
      sendControl(Opcode::Pong, message.payload);
      return true;
    case Opcode::Close:
      out_.dropMessages();
      sendControl(Opcode::Close, std::string_view(message.payload).substr(0, 2));
      isLast_ = true;
      endSoon(now);
      return false;
    case Opcode::Text:
    case Opcode::Binary:
      if (state_ == State::Open) {
        events.received(std::move(message));
      }
      return true;
    case Opcode::Pong:
    case Opcode::Continuation:
      break;
  }
  return true;
}

void Connection::tick(Clock::time_point now) {
  if (state_ == State::Open) {
    if (now - heard_ >= 2 * rules_.silence) {
      state_ = State::Ended;
    } else if (now - heard_ >= rules_.silence && !std::exchange(isAsked_, true)) {
      sendControl(Opcode::Ping, {});
    }
  } else if (now >= deadline_) {
    state_ = State::Ended;
  }
}

void Connection::readEnd() {
  isAtEnd_ = true;
  if (!isLast_) {
    state_ = State::Ended;
  }
}

/// Control frames may stand between any others: a ping needs no answer from behind a long queue.
void Connection::sendControl(Opcode opcode, std::string_view payload) {
  if (state_ == State::Open) {
    out_.addNext(wholeFrame(opcode, payload));
  }
}

void Connection::sendText(std::string_view payload) {
  if (state_ == State::Open) {
    out_.add(wholeFrame(Opcode::Text, payload));
  }
}

void Connection::sendBinary(std::string_view head, const SharedBytes& body, Outbox::Kind kind) {
  if (state_ == State::Open) {
    std::string begin = frameHead(Opcode::Binary, head.size() + (body ? body->size() : 0));
    begin.append(head);
    out_.add(std::move(begin), body, kind);
  }
}

void Connection::close(CloseCode code, std::string_view reason, Clock::time_point now) {
  if (state_ == State::Open) {
    out_.add(closeFrame(code, reason));
    endSoon(now);
  }
}

}  // namespace live
