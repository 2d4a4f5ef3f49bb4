#include <algorithm>
#include <arpa/inet.h>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <set>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "app/bridge/live/FoxgloveMessages.h"
#include "app/bridge/live/RunControl.h"
#include "app/bridge/live/WebSocketServer.h"
#include "tests/fuzz/Require.h"

/// Any bytes as what a client of the live view sends, over a socket to a server. The first tells
/// how: after a good request of HTTP or instead of it, and the size of the pieces in which they
/// come. What happens is the same for every size; each message is read as a request, a value or a
/// message of ROS.
namespace {

constexpr std::string_view kRequest =
    "GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: x\r\n"
    "Sec-WebSocket-Version: 13\r\n\r\n";
constexpr std::size_t kLargestMessage = 5000;

struct Heard {
  std::vector<std::string> messages;
  std::string said;
  friend bool operator==(const Heard& a, const Heard& b) {
    return a.messages == b.messages && a.said == b.said;
  }
};

/// One server for all inputs, with one client at a time.
class Target : live::WebSocketServer::Handler {
  using Client = live::WebSocketServer::Client;

 public:
  Target() {
    live::ServerSettings settings;
    settings.protocols = {"x"};
    settings.largestMessage = kLargestMessage;
    auto listening = live::WebSocketServer::listen(settings, *this);
    require(static_cast<bool>(listening), "a port is free");
    server_ = *std::move(listening);
    server_->start();
  }

  /// Sends the bytes in pieces of that size, then ends the sending side and reads until the server
  /// ends too.
  Heard heardOf(std::string_view bytes, std::size_t piece) {
    const int socket = connected();
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      const std::string_view some = bytes.substr(at, piece);
      // fails after the server has closed
      [[maybe_unused]] const auto sent = ::send(socket, some.data(), some.size(), MSG_NOSIGNAL);
    }
    ::shutdown(socket, SHUT_WR);
    Heard heard;
    char buffer[4096];
    for (ssize_t count = 1; count > 0;) {
      count = ::recv(socket, buffer, sizeof buffer, 0);
      heard.said.append(buffer, count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    ::close(socket);
    server_->exclusively([&] { heard.messages = std::exchange(messages_, {}); });
    return heard;
  }

 private:
  void opened(Client client) override {
    require(open_.insert(client).second, "clients are opened once");
  }
  void received(Client client, bool /*isText*/, const std::string& message) override {
    require(open_.count(client) == 1, "messages come from open clients");
    require(message.size() <= kLargestMessage, "messages have a limit");
    messages_.push_back(message);
  }
  void closed(Client client) override {
    require(open_.erase(client) == 1, "clients are closed once");
  }
  void refused(const std::string& /*origin*/) override {}

  int connected() const {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int one = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(server_->port());
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    require(::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0,
            "the server accepts");
    return socket;
  }

  std::set<Client> open_;
  std::vector<std::string> messages_;
  std::unique_ptr<live::WebSocketServer> server_;
};

void readAsAll(const std::string& message) {
  live::requestOfText(message);
  live::requestOfBytes(message);
  app::Session session{sim2d::StopRule{}};
  live::RunControl control(session, {}, {{"/cmd_vel", -1}});
  for (const std::string_view encoding : {"cdr", "json"}) {
    for (const live::Service& service : control.services()) {
      require(!service.call(encoding, message).payload.empty(), "calls are answered");
    }
    control.clientTopics().front().take(encoding, message);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  static Target target;
  const unsigned how = data[0];
  std::string bytes(how % 2 == 0 ? kRequest : std::string_view());
  bytes.append(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Heard whole = target.heardOf(bytes, bytes.size() + 1);
  require(target.heardOf(bytes, 1 + how / 2 % 50) == whole, "pieces make no difference");
  for (std::size_t i = 0; i < std::min<std::size_t>(whole.messages.size(), 20); ++i) {
    readAsAll(whole.messages[i]);
  }
  return 0;
}
