#pragma once

#include <arpa/inet.h>
#include <cstdint>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>

#include "tests/bridge/ClientFrames.h"

/// A client of WebSocket on a socket of the system, with no code of the program. Waits have a limit
/// of time, which is only met when something is wrong.
namespace client {

constexpr int kPatience = 10000;  // [ms]

struct Frame {
  int first = 0;  // its first byte: 0x81 text, 0x82 bytes, 0x88 close …; 0: none came
  std::string payload;
};

class LiveClient {
 public:
  explicit LiveClient(int port, int receiveBuffer = 0) {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (receiveBuffer > 0) {
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer, sizeof receiveBuffer);
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    isConnected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~LiveClient() { ::close(socket_); }
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  bool isConnected() const { return isConnected_; }

  /// All of it, whether the other side reads or not; false when it is gone.
  bool write(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) {
        return false;
      }
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }
  void text(const std::string& json) { write(frame(0x81, json)); }
  void binary(const std::string& bytes) { write(frame(0x82, bytes)); }

  /// All bytes until the other side ends the connection.
  std::string rest() {
    awaitEnd();
    return in_;
  }

  /// The answer of HTTP to a request with these lines more.
  std::string request(const std::string& lines = {},
                      const std::string& protocol = "foxglove.websocket.v1") {
    write(
        "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: " +
        protocol + "\r\n" + lines + "\r\n");
    return httpAnswer();
  }
  std::string httpAnswer() {
    while (in_.find("\r\n\r\n") == std::string::npos && more()) {
    }
    const std::size_t end = in_.find("\r\n\r\n");
    const std::string head = in_.substr(0, end);
    in_.erase(0, end == std::string::npos ? end : end + 4);
    return head;
  }
  bool open() { return request().rfind("HTTP/1.1 101", 0) == 0; }

  /// The next frame; none when the connection ends or nothing comes.
  Frame next() {
    for (;;) {
      const auto byte = [this](std::size_t i) { return static_cast<std::uint8_t>(in_[i]); };
      std::size_t head = 2;
      std::size_t length = in_.size() > 1 ? byte(1) : 0;
      const int longer = length == 126 ? 2 : (length == 127 ? 8 : 0);
      head += static_cast<std::size_t>(longer);
      if (longer > 0 && in_.size() >= head) {
        length = 0;
        for (std::size_t i = 2; i < head; ++i) {
          length = length * 256 + byte(i);
        }
      }
      if (in_.size() >= head && in_.size() - head >= length) {
        const Frame frame{byte(0), in_.substr(head, length)};
        in_.erase(0, head + length);
        return frame;
      }
      if (!more()) {
        return {};
      }
    }
  }
  /// The next text message with that "op"; others are passed over.
  QJsonObject await(const char* op) {
    for (Frame frame = next(); frame.first != 0; frame = next()) {
      const QJsonObject object =
          QJsonDocument::fromJson(QByteArray::fromStdString(frame.payload)).object();
      if (frame.first == 0x81 &&
          object.value(QLatin1String("op")).toString() == QLatin1String(op)) {
        return object;
      }
    }
    return {};
  }
  /// The next bytes that begin with that operation; others are passed over.
  std::string awaitBinary(int operation) {
    for (Frame frame = next(); frame.first != 0; frame = next()) {
      if (frame.first == 0x82 && !frame.payload.empty() && frame.payload[0] == operation) {
        return frame.payload;
      }
    }
    return {};
  }
  /// The code of the close frame; -1 when the connection ends without one.
  int awaitClose() {
    for (Frame frame = next(); frame.first != 0; frame = next()) {
      if (frame.first == 0x88) {
        return frame.payload.size() < 2 ? 0
                                        : static_cast<std::uint8_t>(frame.payload[0]) * 256 +
                                              static_cast<std::uint8_t>(frame.payload[1]);
      }
    }
    return -1;
  }
  /// Whether the other side ends the connection.
  bool awaitEnd() {
    while (more()) {
    }
    return isAtEnd_;
  }

 private:
  /// Waits for some bytes; false when there are none any more.
  bool more() {
    pollfd ready{socket_, POLLIN, 0};
    if (isAtEnd_ || ::poll(&ready, 1, kPatience) <= 0) {
      return false;
    }
    char bytes[65536];
    const ssize_t count = ::recv(socket_, bytes, sizeof bytes, 0);
    isAtEnd_ = count <= 0;
    in_.append(bytes, isAtEnd_ ? 0 : static_cast<std::size_t>(count));
    return !isAtEnd_;
  }

  int socket_ = -1;
  bool isConnected_ = false, isAtEnd_ = false;
  std::string in_;
};

/// The answer of a service of a live view, called with JSON.
inline QJsonObject call(LiveClient& client, int service, const std::string& request) {
  std::string bytes(1, '\x02');
  for (const int number : {service, 1, 4}) {
    bytes += std::string{static_cast<char>(number), 0, 0, 0};
  }
  client.binary(bytes + "json" + request);
  const std::string answer = client.awaitBinary(3);
  return QJsonDocument::fromJson(QByteArray::fromStdString(answer).mid(17)).object();
}

/// Whether the run did so.
inline bool pause(LiveClient& client, bool isPaused) {
  return call(client, 1, isPaused ? R"({"data":true})" : R"({"data":false})")
      .value(QLatin1String("success"))
      .toBool();
}

}  // namespace client
