#include "app/bridge/live/Connection.h"

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <exception>
#include <utility>

#include "sim2d/base/Text.h"

namespace live {

namespace asio = boost::asio;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using http::field;

namespace {

constexpr std::size_t kLongestReason = 123;             // [B], of a close frame
constexpr std::size_t kPiece = std::size_t{64} << 10U;  // [B], of unread data at the end

HttpResponse rejection(http::status status, const std::string& text) {
  HttpResponse response(status, 11);
  response.set(field::connection, "close");
  response.set(field::content_type, "text/plain; charset=utf-8");
  if (status == http::status::upgrade_required) {
    response.set(field::upgrade, "websocket");
    response.set(field::sec_websocket_version, "13");
  }
  response.body() = text + "\n";
  response.prepare_payload();
  return response;
}

HttpResponse invalidRequest() {
  return rejection(http::status::bad_request, "This is not a supported HTTP 1.1 request.");
}

/// Headers with a single value must not be repeated.
bool isValid(const HttpRequest& request) {
  return request.method() == http::verb::get && request.version() == 11 &&
         request.target().starts_with('/') && request.count(field::host) == 1 &&
         request.count(field::origin) <= 1 && request.count(field::sec_websocket_key) <= 1 &&
         request.count(field::sec_websocket_version) <= 1;
}

bool hasToken(const HttpRequest& request, field name, boost::beast::string_view token) {
  const auto [first, last] = request.equal_range(name);
  return std::any_of(
      first, last, [&](const auto& line) { return http::token_list(line.value()).exists(token); });
}

/// Whether the key is 16 bytes in base64.
bool isKey(boost::beast::string_view key) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  return key.size() == 24 && key.find_first_not_of(kDigits) == 22 && key.ends_with("==");
}

/// The client's first supported subprotocol; empty: none.
std::string protocolOf(const HttpRequest& request, const std::vector<std::string>& supported) {
  const auto [first, last] = request.equal_range(field::sec_websocket_protocol);
  for (auto line = first; line != last; ++line) {
    for (const auto& offered : http::token_list(line->value())) {
      const auto found = std::find(supported.begin(), supported.end(), offered);
      if (found != supported.end()) {
        return *found;
      }
    }
  }
  return {};
}

/// The response to a request that is rejected because of its contents; nothing if it is accepted.
std::optional<HttpResponse> rejectionOf(const HttpRequest& request,
                                        const ServerSettings& settings) {
  if (!isValid(request)) {
    return invalidRequest();
  }
  if (!hasToken(request, field::upgrade, "websocket") ||
      !hasToken(request, field::connection, "upgrade")) {
    return rejection(http::status::upgrade_required,
                     "This is the live view of hunavsim. Open it in Foxglove: Open connection, "
                     "Foxglove WebSocket, ws:// and this address.");
  }
  if (request[field::sec_websocket_version] != "13") {
    return rejection(http::status::upgrade_required, "Only version 13 of WebSocket is supported.");
  }
  if (!isKey(request[field::sec_websocket_key])) {
    return rejection(http::status::bad_request, "Sec-WebSocket-Key is not 16 bytes in base64.");
  }
  const auto origin = request.find(field::origin);  // programs may omit the origin
  if (origin != request.end() && !isAllowedOrigin(std::string(origin->value()), settings.origins)) {
    return rejection(http::status::forbidden, "Pages of this origin are not allowed to connect.");
  }
  if (protocolOf(request, settings.protocols).empty()) {
    return rejection(http::status::bad_request, "One of these subprotocols is required: " +
                                                    base::join(settings.protocols, ", ") + ".");
  }
  return std::nullopt;
}

/// Limits the reason to the size of a close frame, without truncating a character of UTF-8.
websocket::close_reason closeReasonOf(std::string_view reason) {
  std::size_t size = std::min(reason.size(), kLongestReason);
  while (size > 0 && size < reason.size() &&
         (static_cast<unsigned>(reason[size]) & 0xC0U) == 0x80U) {
    --size;
  }
  return {websocket::close_code::going_away, boost::beast::string_view(reason.data(), size)};
}

/// The host of "http://localhost:8080". Nothing for other schemes and for text after the port.
std::optional<std::string> webHostOf(std::string_view origin) {
  for (const std::string_view scheme :
       {std::string_view("http://"), std::string_view("https://")}) {
    if (origin.substr(0, scheme.size()) == scheme) {
      std::string_view host = origin.substr(scheme.size());
      const std::size_t port =
          host.find(':', host.find(']') == std::string_view::npos ? 0 : host.find(']'));
      const std::string_view digits =
          port == std::string_view::npos ? std::string_view("0") : host.substr(port + 1);
      if (digits.empty() || !std::all_of(digits.begin(), digits.end(), base::isDigit)) {
        return std::nullopt;
      }
      return std::string(host.substr(0, port));
    }
  }
  return std::nullopt;
}

}  // namespace

bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more) {
  const auto same = [&](std::string_view other) { return origin == other; };
  if (same("https://app.foxglove.dev") || same("https://studio.foxglove.dev") || same("file://") ||
      std::any_of(more.begin(), more.end(), same)) {
    return true;
  }
  const std::optional<std::string> host = webHostOf(origin);
  return host && (*host == "localhost" || *host == "127.0.0.1" || *host == "[::1]");
}

/// Called by the library after the close frame was sent. Closes only the sending side: closing the
/// socket while data is unread would discard the close frame.
template <class Handler>
void async_teardown(boost::beast::role_type /*role*/,  // NOLINT(readability-identifier-naming)
                    ClientStream& stream, Handler&& handler) {
  ErrorCode ignored;
  stream.next_layer().shutdown(asio::socket_base::shutdown_send, ignored);
  asio::post(stream.get_executor(),
             boost::beast::bind_front_handler(std::forward<Handler>(handler), ErrorCode()));
}

/// A completion handler that keeps this object alive and calls `work` unless the connection has
/// ended.
template <class Work>
auto Connection::handler(Work work) {
  return [self = shared_from_this(), work](const ErrorCode& problem, auto&&... /*size*/) {
    if (self->state_ == State::Ended) {
      return;
    }
    try {
      work(problem);
    } catch (const std::exception&) {  // out of memory for this client
      self->end();
    }
  };
}

Connection::Connection(WebSocketServer& server, WebSocketServer::Client client, Socket socket)
    : server_(server),
      client_(client),
      stream_(std::move(socket)),
      queue_(server.settings_.maxQueuedMessages),
      deadline_(Clock::now() + server.settings_.handshakeTime) {
  parser_.emplace();
  parser_->header_limit(kLongestRequest);
  stream_.read_message_max(server.settings_.largestMessage);
  stream_.auto_fragment(false);
  stream_.control_callback([this](websocket::frame_type kind, boost::beast::string_view) {
    noteReceived();
    if (kind == websocket::frame_type::close && state_ != State::Ended) {
      startClosing(State::Closed);
    }
  });
}

void Connection::start() {
  http::async_read_header(socket(), stream_.next_layer().buffer(), *parser_,
                          handler([this](const ErrorCode& problem) { answerRequest(problem); }));
}

void Connection::answerRequest(const ErrorCode& problem) {
  const bool isOfParser = problem.category() == ErrorCode(http::error::bad_method).category();
  if (problem == http::error::header_limit) {
    reject(rejection(http::status::request_header_fields_too_large, "The request is too long."));
  } else if (problem == http::error::end_of_stream || problem == http::error::partial_message ||
             (problem && !isOfParser)) {
    end();
  } else if (problem) {
    reject(invalidRequest());
  } else if (auto wrong = rejectionOf(parser_->get(), server_.settings_)) {
    const bool isPage = wrong->result() == http::status::forbidden;
    reject(*std::move(wrong));
    if (isPage) {
      server_.handler_.refused(std::string(parser_->get()[field::origin]));
    }
  } else if (server_.isFull()) {
    reject(rejection(http::status::service_unavailable, "Too many connections."));
  } else {
    accept(protocolOf(parser_->get(), server_.settings_.protocols));
  }
}

void Connection::reject(HttpResponse response) {
  startClosing(State::Closed);
  rejection_ = std::move(response);
  http::async_write(socket(), rejection_, handler([this](const ErrorCode& problem) {
                      ErrorCode ignored;
                      socket().shutdown(asio::socket_base::shutdown_send, ignored);
                      finish(problem);
                    }));
}

void Connection::accept(const std::string& protocol) {
  HttpRequest& request = parser_->get();
  request.set(field::connection, "upgrade");  // the library reads only the first of several lines
  request.set(field::upgrade, "websocket");
  stream_.set_option(
      websocket::stream_base::decorator([protocol](websocket::response_type& response) {
        response.set(field::server, "hunavsim");
        response.set(field::sec_websocket_protocol, protocol);
      }));
  state_ = State::Opening;
  isOpened_ = isWriting_ = true;
  deadline_.reset();
  noteReceived();
  stream_.async_accept(request, handler([this](const ErrorCode& problem) {
                         if (problem) {
                           end();
                           return;
                         }
                         parser_.reset();
                         state_ = state_ == State::Opening ? State::Open : state_;
                         readNext();
                         writeNext();
                       }));
  server_.handler_.opened(client_);
}

void Connection::readNext() {
  if (isReading_ || queue_.hasManyReplies() ||
      (state_ != State::Open && state_ != State::Closing)) {
    return;
  }
  isReading_ = true;
  stream_.async_read_some(input_, 0, handler([this](const ErrorCode& problem) {
                            isReading_ = false;
                            handleRead(problem);
                          }));
}

void Connection::handleRead(const ErrorCode& problem) {
  if (problem) {
    finish(problem);
    return;
  }
  noteReceived();
  if (stream_.is_message_done()) {
    const std::string message = boost::beast::buffers_to_string(input_.data());
    input_.clear();
    if (state_ == State::Open) {
      server_.handler_.received(client_, stream_.got_text(), message);
    }
  }
  readNext();
}

void Connection::send(SendQueue::Message message) {
  if (state_ != State::Opening && state_ != State::Open) {
    return;
  }
  queue_.add(std::move(message));
  if (!isWriting_) {
    writeNext();
  }
}

/// Sends the oldest message of the queue, then the next one.
void Connection::writeNext() {
  isWriting_ = false;
  if (state_ != State::Open && state_ != State::Closing) {
    return;
  }
  if (queue_.isEmpty()) {
    if (const auto reason = std::exchange(closeReason_, std::nullopt)) {
      stream_.async_close(*reason, handler([this](const ErrorCode& problem) { finish(problem); }));
    }
    return;
  }
  isWriting_ = true;
  const SendQueue::Message& message = queue_.startFirst();
  stream_.text(message.kind == SendQueue::Kind::Text);
  const std::array<asio::const_buffer, 2> bytes = {
      asio::buffer(message.head),
      message.body ? asio::buffer(*message.body) : asio::const_buffer()};
  stream_.async_write(
      bytes, handler([this](const ErrorCode& problem) {
        queue_.removeFirst();
        if (!problem) {
          writeNext();
          readNext();
        } else if (problem != asio::error::operation_aborted) {  // else the library closes
          end();
        }
      }));
}

void Connection::noteReceived() {
  lastReceived_ = Clock::now();
  isPingSent_ = isPingPending_;
}

void Connection::startClosing(State state) {
  state_ = state;
  deadline_ = Clock::now() + server_.settings_.closeTime;
}

void Connection::close(std::string_view reason) {
  if (state_ == State::Opening || state_ == State::Open) {
    startClosing(State::Closing);
    closeReason_ = closeReasonOf(reason);
    if (!isWriting_) {
      writeNext();
    }
  }
}

/// Called when the last frame or response was sent or the socket is broken (`problem`). Waits until
/// the client closes its side of the socket.
void Connection::finish(const ErrorCode& problem) {
  const bool isOfLibrary = problem.category() == ErrorCode(websocket::error::closed).category() ||
                           problem == asio::error::operation_aborted;
  if (problem && !isOfLibrary) {
    end();
  } else if (state_ != State::Draining) {
    deadline_ = deadline_.value_or(Clock::now() + server_.settings_.closeTime);
    state_ = State::Draining;
    drain();
  }
}

void Connection::drain() {
  input_.clear();
  socket().async_read_some(input_.prepare(kPiece), handler([this](const ErrorCode& problem) {
                             if (problem) {
                               end();
                             } else {
                               drain();
                             }
                           }));
}

void Connection::end() {
  if (std::exchange(state_, State::Ended) != State::Ended) {
    ErrorCode ignored;
    socket().close(ignored);
    if (isOpened_) {
      server_.handler_.closed(client_);
    }
    server_.remove(client_);
  }
}

void Connection::checkTime(Clock::time_point now) {
  const auto silence = now - lastReceived_;
  const auto& idleTimeout = server_.settings_.idleTimeout;
  if (state_ == State::Open && !stream_.is_open()) {  // a violation, after which the library closes
    startClosing(State::Closed);
  }
  if (deadline_ ? now >= *deadline_ : silence >= 2 * idleTimeout) {
    end();
  } else if (state_ == State::Open && silence >= idleTimeout && !isPingSent_) {
    isPingSent_ = isPingPending_ = true;
    stream_.async_ping({},
                       handler([this](const ErrorCode& /*problem*/) { isPingPending_ = false; }));
  }
}

}  // namespace live
