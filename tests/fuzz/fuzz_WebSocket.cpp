#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/bridge/live/ClientRequest.h"
#include "app/bridge/live/Connection.h"
#include "app/bridge/live/RunControl.h"
#include "tests/fuzz/Require.h"

/// Any bytes as what a client of the live view sends. The first tells how: after a good request of
/// HTTP or instead of it, and the size of the pieces in which they come. What happens is the same
/// for every size; each message is read as a request, a value or a message of ROS.
namespace {

constexpr std::string_view kRequest =
    "GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: x\r\n"
    "Sec-WebSocket-Version: 13\r\n\r\n";

struct Heard {
  std::vector<std::string> messages;
  std::string said;
  bool isOpen = false;
  friend bool operator==(const Heard& a, const Heard& b) {
    return a.messages == b.messages && a.said == b.said && a.isOpen == b.isOpen;
  }
};

Heard heardOf(std::string_view bytes, std::size_t piece) {
  live::ConnectionLimits rules;
  rules.protocols = {"x"};
  rules.largestMessage = 5000;
  const live::Clock::time_point now{};
  live::Connection connection(rules, now);
  Heard heard;
  live::Connection::Events events;
  events.opened = [] {};
  events.received = [&](live::WebSocketMessage&& message) {
    require(message.payload.size() <= rules.largestMessage, "messages have a limit");
    require(message.opcode != live::Opcode::Text || live::isUtf8(message.payload),
            "texts are UTF-8");
    heard.messages.push_back(message.payload);
  };
  events.refused = [](const std::string&) {};
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    connection.read(bytes.substr(at, piece), now, events);
  }
  for (const std::string_view part : connection.out().next(1000000)) {
    heard.said.append(part);
  }
  heard.isOpen = connection.isOpen();
  connection.readEnd();
  connection.out().sent(heard.said.size());
  require(connection.out().isEmpty() && connection.out().waiting() == 0, "all can be sent");
  require(connection.isFinished(), "it ends with its socket");
  return heard;
}

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
  const unsigned how = data[0];
  std::string bytes(how % 2 == 0 ? kRequest : std::string_view());
  bytes.append(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Heard whole = heardOf(bytes, bytes.size() + 1);
  require(heardOf(bytes, 1 + how / 2 % 50) == whole, "pieces make no difference");
  for (std::size_t i = 0; i < std::min<std::size_t>(whole.messages.size(), 20); ++i) {
    readAsAll(whole.messages[i]);
  }
  return 0;
}
