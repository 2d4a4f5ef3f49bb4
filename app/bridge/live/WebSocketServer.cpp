#include "app/bridge/live/WebSocketServer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <system_error>
#include <utility>

#include "app/bridge/live/WebSocketHandshake.h"

namespace live {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kTurn{100};                          // poll timeout
constexpr milliseconds kFlushTimeout{1000};                 // to flush queues when stopping
constexpr milliseconds kNoSocket{500};                      // retry delay after accept failed
constexpr std::size_t kPiece = std::size_t{64} << 10U;      // [B], read buffer
constexpr std::size_t kMostAtOnce = std::size_t{1} << 20U;  // [B], sent to one client per turn
constexpr int kSystemBuffer = 256 << 10;                    // [B], send buffer
constexpr std::size_t kMostParts = 32;                      // parts per sendmsg
constexpr int kMostAccepted = 32;                           // connections per turn
static_assert(kMostAccepted < kMostUnopened,
              "each connection is read before newer ones replace it");

void setOption(int socket, int level, int option, int value) {
  ::setsockopt(socket, level, option, &value, sizeof value);  // optional: errors are ignored
}

struct AddressList {
  addrinfo* first = nullptr;
  AddressList() = default;
  ~AddressList() {
    if (first != nullptr) {
      ::freeaddrinfo(first);
    }
  }
  AddressList(const AddressList&) = delete;
  AddressList& operator=(const AddressList&) = delete;
  AddressList(AddressList&&) = delete;
  AddressList& operator=(AddressList&&) = delete;
};

std::string reasonOf(int number) {
  return std::generic_category().message(number);
}

std::uint16_t portOf(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  std::array<char, NI_MAXSERV> port{};
  // getnameinfo returns text, which avoids casting the address to another type.
  auto* const plain = static_cast<sockaddr*>(static_cast<void*>(&address));
  if (::getsockname(socket, plain, &size) != 0 ||
      ::getnameinfo(plain, size, nullptr, 0, port.data(), port.size(), NI_NUMERICSERV) != 0) {
    return 0;
  }
  return static_cast<std::uint16_t>(std::strtoul(port.data(), nullptr, 10));
}

/// Sends queued bytes. False: the connection is broken.
bool sendSome(int socket, SendQueue& out) {
  std::size_t total = 0;
  while (!out.isEmpty() && total < kMostAtOnce) {
    std::array<iovec, kMostParts> parts{};
    std::size_t count = 0;
    for (const std::string_view part : out.next(parts.size())) {
      parts.at(count++) = {const_cast<char*>(part.data()), part.size()};  // NOLINT: only read
    }
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = count;
    const ssize_t sent = ::sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) {
      return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    }
    out.sent(static_cast<std::size_t>(sent));
    total += static_cast<std::size_t>(sent);
  }
  return true;
}

}  // namespace

WebSocketServer::WebSocketServer(const ServerSettings& settings, Handler& handler)
    : settings_(settings), handler_(handler) {}

WebSocketServer::~WebSocketServer() {
  stop("the server is stopping");
}

base::Result<std::unique_ptr<WebSocketServer>> WebSocketServer::listen(
    const ServerSettings& settings, Handler& handler) {
  std::unique_ptr<WebSocketServer> server(new WebSocketServer(settings, handler));
  base::Diagnostics problems = server->open();
  if (!problems.empty()) {
    return problems;
  }
  return base::Result<std::unique_ptr<WebSocketServer>>(std::move(server));
}

base::Diagnostics WebSocketServer::open() {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  AddressList found;
  const std::string port = std::to_string(settings_.port);
  if (::getaddrinfo(settings_.address.c_str(), port.c_str(), &wanted, &found.first) != 0) {
    return {base::error("live.no-address", {settings_.address})};
  }
  const addrinfo& place = *found.first;
  listener_ = base::FileDescriptor(
      ::socket(place.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  setOption(listener_.number(), SOL_SOCKET, SO_REUSEADDR, 1);  // allows an immediate restart
  if (!listener_.isOpen() || ::bind(listener_.number(), place.ai_addr, place.ai_addrlen) != 0 ||
      ::listen(listener_.number(), SOMAXCONN) != 0) {
    const int why = errno;
    return {why == EADDRINUSE
                ? base::error("live.port-taken", {port})
                : base::error("live.no-port", {settings_.address, port, reasonOf(why)})};
  }
  port_ = portOf(listener_.number());
  wakeEvent_ = base::FileDescriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!wakeEvent_.isOpen()) {
    return {base::error("live.no-port", {settings_.address, port, reasonOf(errno)})};
  }
  return {};
}

void WebSocketServer::start() {
  thread_ = std::thread([this] { serve(); });
}

void WebSocketServer::stop(std::string_view reason) {
  if (!thread_.joinable()) {
    return;
  }
  exclusively([&] {
    isEnding_ = true;
    endAt_ = Clock::now() + kFlushTimeout;
    for (auto peer = peers_.begin(); peer != peers_.end();) {
      peer->second.connection.close(CloseCode::GoingAway, reason, Clock::now());
      peer = peer->second.isOpened ? std::next(peer) : peers_.erase(peer);
    }
  });
  thread_.join();
  listener_.close();
}

void WebSocketServer::exclusively(const std::function<void()>& work) {
  {
    const std::unique_lock<std::mutex> lock = lockFairly();
    work();
  }
  wake();
}

std::unique_lock<std::mutex> WebSocketServer::lockFairly() {
  const std::lock_guard<std::mutex> gate(turnMutex_);
  return std::unique_lock<std::mutex>(mutex_);
}

void WebSocketServer::wake() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wakeEvent_.number(), &one, sizeof one);
}

Connection* WebSocketServer::find(Client client) {
  const auto found = peers_.find(client);
  return found == peers_.end() || !found->second.connection.isOpen() ? nullptr
                                                                     : &found->second.connection;
}

void WebSocketServer::close(Client client, CloseCode code, std::string_view reason) {
  if (Connection* const connection = find(client)) {
    connection->close(code, reason, Clock::now());
  }
}

bool WebSocketServer::isDone(Clock::time_point now) const {
  return isEnding_ && (peers_.empty() || now >= endAt_);
}

void WebSocketServer::serve() {
  std::vector<pollfd> watched;
  std::map<Client, short> ready;
  std::unique_lock<std::mutex> lock = lockFairly();
  for (Clock::time_point now = Clock::now(); !isDone(now); now = Clock::now()) {
    const bool isAccepting = !isEnding_ && now >= acceptRetryAt_;
    watched = {{wakeEvent_.number(), POLLIN, 0},
               {isAccepting ? listener_.number() : -1, POLLIN, 0}};
    ready.clear();
    for (const auto& [client, peer] : peers_) {
      const int wanted = (peer.connection.canRead() ? POLLIN : 0) |
                         (peer.connection.out().isEmpty() ? 0 : POLLOUT);
      watched.push_back({peer.socket.number(), static_cast<short>(wanted), 0});
      ready[client] = 0;
    }
    lock.unlock();
    ::poll(watched.data(), watched.size(), static_cast<int>(kTurn.count()));
    lock = lockFairly();
    std::uint64_t rings = 0;
    [[maybe_unused]] const ssize_t got = ::read(wakeEvent_.number(), &rings, sizeof rings);
    std::size_t at = 2;
    for (auto& [client, events] : ready) {
      events = watched[at++].revents;
    }
    serveClients(ready, Clock::now());
    if (watched[1].revents != 0) {
      acceptAll(Clock::now());
    }
    handler_.tick();
  }
  for (const auto& [client, peer] : std::exchange(peers_, {})) {
    if (peer.isOpened) {
      handler_.closed(client);
    }
  }
}

void WebSocketServer::acceptAll(Clock::time_point now) {
  for (int i = 0; i < kMostAccepted; ++i) {
    base::FileDescriptor socket(
        ::accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (socket.isOpen()) {
      acceptOne(std::move(socket), now);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return;
    } else if (errno != EINTR && errno != ECONNABORTED && limitUnopened(0) == 0) {
      acceptRetryAt_ = now + kNoSocket;
      return;
    }
  }
}

void WebSocketServer::acceptOne(base::FileDescriptor socket, Clock::time_point now) {
  setOption(socket.number(), IPPROTO_TCP, TCP_NODELAY, 1);
  setOption(socket.number(), SOL_SOCKET, SO_SNDBUF, kSystemBuffer);
  limitUnopened(kMostUnopened - 1);
  peers_.emplace(++last_, Peer{std::move(socket), Connection(settings_.rules, now)});
}

std::size_t WebSocketServer::limitUnopened(std::size_t most) {
  const auto isUnopened = [](const auto& each) { return !each.second.isOpened; };
  const auto count =
      static_cast<std::size_t>(std::count_if(peers_.begin(), peers_.end(), isUnopened));
  const std::size_t tooMany = count > most ? count - most : 0;
  for (std::size_t closed = 0; closed < tooMany; ++closed) {
    peers_.erase(std::find_if(peers_.begin(), peers_.end(), isUnopened));  // ordered by arrival
  }
  return tooMany;
}

bool WebSocketServer::isFull() const {
  const auto open = std::count_if(peers_.begin(), peers_.end(),
                                  [](const auto& each) { return each.second.isOpened; });
  return static_cast<std::size_t>(open) >= settings_.mostClients;
}

void WebSocketServer::serveClients(const std::map<Client, short>& ready, Clock::time_point now) {
  for (const auto& [client, events] : ready) {
    const auto found = peers_.find(client);
    if (found == peers_.end()) {
      continue;
    }
    try {
      serveClient(client, found->second, events, now);
    } catch (const std::exception&) {  // out of memory for this client
      end(client);
    }
  }
}

void WebSocketServer::serveClient(Client client, Peer& peer, short ready, Clock::time_point now) {
  Connection& connection = peer.connection;
  if ((ready & (POLLIN | POLLHUP | POLLERR)) != 0 && connection.canRead()) {
    readFrom(client, peer, now);
  }
  connection.tick(now);
  const bool isThere = sendSome(peer.socket.number(), connection.out());
  if (connection.isSendFinished() && !std::exchange(peer.isShut, connection.isSendFinished())) {
    ::shutdown(peer.socket.number(), SHUT_WR);
  }
  if (!isThere || connection.isFinished()) {
    end(client);
  }
}

void WebSocketServer::readFrom(Client client, Peer& peer, Clock::time_point now) {
  static thread_local std::array<char, kPiece> bytes;
  const ssize_t count = ::recv(peer.socket.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count > 0) {
    Connection::Events events;
    events.isFull = [this] { return isFull(); };
    events.opened = [&] {
      peer.isOpened = true;
      handler_.opened(client);
    };
    events.received = [&](WebSocketMessage&& message) {
      handler_.received(client, std::move(message));
    };
    events.refused = [&](const std::string& origin) { handler_.refused(origin); };
    peer.connection.read({bytes.data(), static_cast<std::size_t>(count)}, now, events);
  } else if (count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
    peer.connection.readEnd();
  }
}

void WebSocketServer::end(Client client) {
  const auto found = peers_.find(client);
  const bool isOpened = found->second.isOpened;
  peers_.erase(found);
  if (isOpened) {
    handler_.closed(client);
  }
}

}  // namespace live
