#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffered_read_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/bridge/live/WebSocketServer.h"

namespace live {

using ErrorCode = boost::beast::error_code;
using HttpRequest = boost::beast::http::request<boost::beast::http::empty_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

/// The socket of a client with the bytes that were read after its request.
class ClientStream : public boost::beast::buffered_read_stream<boost::asio::ip::tcp::socket,
                                                               boost::beast::flat_buffer> {
 public:
  using buffered_read_stream::buffered_read_stream;
};

/// One client of a WebSocketServer, from the HTTP request to the end of its socket. Memory is
/// limited to one request or message of maximum size, the queued topic messages and about
/// `kMaxQueuedReplies` bytes of responses. All functions are called in the server's thread; each
/// pending operation shares the ownership, so that none outlives the object.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  Connection(WebSocketServer& server, WebSocketServer::Client client, Socket socket);

  /// Starts reading the HTTP request.
  void start();
  /// Has no effect unless the connection is open.
  void send(SendQueue::Message message);
  /// Sends a close frame with code 1001 after the queued messages.
  void close(std::string_view reason);
  /// Closes the socket and removes the connection from the server.
  void end();
  /// Checks timeouts.
  void checkTime(Clock::time_point now);

  bool isOpened() const { return isOpened_; }  // the request was accepted
  std::size_t droppedCount() const { return queue_.droppedCount(); }

 private:
  enum class State {
    Request,   // reading the HTTP request
    Opening,   // sending the response
    Open,      // exchanging messages
    Closing,   // the close frame follows the queued messages
    Closed,    // nothing more is sent, except what the library sends to close
    Draining,  // waiting until the client closes its side of the socket
    Ended
  };

  template <class Work>
  auto handler(Work work);
  Socket& socket() { return stream_.next_layer().next_layer(); }
  void answerRequest(const ErrorCode& problem);
  void accept(const std::string& protocol);
  void reject(HttpResponse response);
  void readNext();
  void handleRead(const ErrorCode& problem);
  void writeNext();
  void noteReceived();
  void startClosing(State state);
  void finish(const ErrorCode& problem);
  void drain();

  WebSocketServer& server_;
  const WebSocketServer::Client client_;
  boost::beast::websocket::stream<ClientStream, false> stream_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>> parser_;
  HttpResponse rejection_;
  boost::beast::flat_buffer input_;  // the received part of a message
  SendQueue queue_;
  std::optional<boost::beast::websocket::close_reason> closeReason_;  // close frame not sent yet
  State state_ = State::Request;
  bool isOpened_ = false, isReading_ = false, isWriting_ = false;
  std::optional<Clock::time_point> deadline_;  // of the request or of closing
  Clock::time_point lastReceived_;             // time of the last received bytes
  bool isPingSent_ = false;                    // a ping was sent since lastReceived_
  bool isPingPending_ = false;                 // it waits for another frame
};

}  // namespace live
