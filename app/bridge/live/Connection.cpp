#include "app/bridge/live/Connection.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace live {

void SendQueue::add(std::string head, SharedBytes body, Kind kind) {
  pieces_.push_back({std::move(head), std::move(body), kind});
  sumOf(kind) += pieces_.back().cost();
  enforceLimit();
}

void SendQueue::addNext(std::string bytes) {
  const auto at = std::find_if(firstWhole(), pieces_.end(),
                               [](const Piece& piece) { return piece.kind == Kind::Message; });
  replyBytes_ += pieces_.insert(at, {std::move(bytes), nullptr, Kind::Answer})->cost();
}

void SendQueue::dropAllMessages() {
  for (auto piece = firstWhole(); piece != pieces_.end();) {
    piece = piece->kind == Kind::Message ? drop(piece) : std::next(piece);
  }
}

/// The first piece that has not been partly sent.
SendQueue::Place SendQueue::firstWhole() {
  return pieces_.begin() + (sentOfFirst_ > 0 ? 1 : 0);
}

SendQueue::Place SendQueue::drop(const Place& piece) {
  messageBytes_ -= piece->cost();
  ++dropped_;
  return pieces_.erase(piece);
}

/// Drops the oldest messages above the limit. The newest message and a partly sent one are kept.
void SendQueue::enforceLimit() {
  for (auto piece = firstWhole();
       messageBytes_ > most_ && piece != pieces_.end() && std::next(piece) != pieces_.end();) {
    piece = piece->kind == Kind::Message ? drop(piece) : std::next(piece);
  }
}

std::vector<std::string_view> SendQueue::next(std::size_t count) const {
  std::vector<std::string_view> parts;
  std::size_t skip = sentOfFirst_;
  for (const Piece& piece : pieces_) {
    for (const std::string* bytes : {&piece.head, piece.body.get()}) {
      if (bytes == nullptr) {
        continue;
      }
      const std::size_t here = std::min(skip, bytes->size());
      skip -= here;
      if (here < bytes->size()) {
        if (parts.size() == count) {
          return parts;
        }
        parts.emplace_back(std::string_view(*bytes).substr(here));
      }
    }
  }
  return parts;
}

void SendQueue::sent(std::size_t bytes) {
  sentOfFirst_ += bytes;
  while (!pieces_.empty() && sentOfFirst_ >= pieces_.front().size()) {
    sentOfFirst_ -= pieces_.front().size();
    sumOf(pieces_.front().kind) -= pieces_.front().cost();
    pieces_.pop_front();
  }
}

namespace {

constexpr std::string_view kHeadEnd = "\r\n\r\n";

}  // namespace

void Connection::read(std::string_view bytes, Clock::time_point now, const Events& events) {
  lastReceived_ = now;
  isPingSent_ = false;
  if (state_ == State::Request) {
    bytes = readRequest(bytes, now, events);
  }
  if (isSendClosed_ || state_ == State::Request) {
    return;
  }
  const auto wrong = reader_.read(
      bytes, [&](WebSocketMessage&& message) { return take(std::move(message), now, events); });
  if (wrong) {
    close(wrong->code, wrong->reason, now);
  }
}

/// Returns the bytes after the request.
std::string_view Connection::readRequest(std::string_view bytes, Clock::time_point now,
                                         const Events& events) {
  const std::size_t before = request_.size();
  request_.append(bytes.substr(0, kLongestRequest + kHeadEnd.size() - before));
  const std::size_t end = request_.find(kHeadEnd, before < 3 ? 0 : before - 3);
  if (end == std::string::npos) {
    if (request_.size() > kLongestRequest) {
      reject(httpError("431 Request Header Fields Too Large", "The request is too long."), now);
    }
    return {};
  }
  const std::size_t size = end + kHeadEnd.size();
  const HandshakeResponse answer = respondToHandshake(std::string_view(request_).substr(0, size),
                                                      rules_.protocols, rules_.origins);
  request_ = {};
  if (!answer.isAccepted) {
    reject(answer.response, now);
    if (!answer.rejectedOrigin.empty()) {
      events.refused(answer.rejectedOrigin);
    }
    return {};
  }
  if (events.isFull && events.isFull()) {
    reject(httpError("503 Service Unavailable", "Too many connections."), now);
    return {};
  }
  out_.add(answer.response);
  state_ = State::Open;
  events.opened();
  return bytes.substr(size - before);
}

void Connection::reject(const std::string& response, Clock::time_point now) {
  out_.add(response);
  request_ = {};
  isSendClosed_ = true;
  startClosing(now);
}

void Connection::startClosing(Clock::time_point now) {
  state_ = State::Closing;
  deadline_ = now + rules_.closeTime;
}

bool Connection::take(WebSocketMessage&& message, Clock::time_point now, const Events& events) {
  switch (message.opcode) {
    case Opcode::Ping:
      sendControl(Opcode::Pong, message.payload);
      return true;
    case Opcode::Close:
      out_.dropAllMessages();
      sendControl(Opcode::Close, std::string_view(message.payload).substr(0, 2));
      isSendClosed_ = true;
      startClosing(now);
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
    if (now - lastReceived_ >= 2 * rules_.idleTimeout) {
      state_ = State::Ended;
    } else if (now - lastReceived_ >= rules_.idleTimeout && !std::exchange(isPingSent_, true)) {
      sendControl(Opcode::Ping, {});
    }
  } else if (now >= deadline_) {
    state_ = State::Ended;
  }
}

void Connection::readEnd() {
  isReadClosed_ = true;
  if (!isSendClosed_) {
    state_ = State::Ended;
  }
}

/// Control frames may be sent between other frames, so a pong need not wait for a long queue.
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

void Connection::sendBinary(std::string_view head, const SharedBytes& body, SendQueue::Kind kind) {
  if (state_ == State::Open) {
    std::string begin = frameHead(Opcode::Binary, head.size() + (body ? body->size() : 0));
    begin.append(head);
    out_.add(std::move(begin), body, kind);
  }
}

void Connection::close(CloseCode code, std::string_view reason, Clock::time_point now) {
  if (state_ == State::Open) {
    out_.add(closeFrame(code, reason));
    startClosing(now);
  }
}

}  // namespace live
