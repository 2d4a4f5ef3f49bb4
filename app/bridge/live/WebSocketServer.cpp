#include "app/bridge/live/WebSocketServer.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <exception>
#include <fcntl.h>
#include <future>
#include <sys/socket.h>
#include <utility>

#include "app/bridge/live/Connection.h"

namespace live {

namespace {

using Tcp = boost::asio::ip::tcp;
using std::chrono::milliseconds;

constexpr milliseconds kBetweenTicks{100};
constexpr milliseconds kFlushTimeout{1000};  // to flush queues when stopping
constexpr milliseconds kNoSocket{500};       // retry delay after accept failed
constexpr int kSystemBuffer = 256 << 10;     // [B], send buffer
constexpr int kMostAccepted = 32;            // connections per turn
static_assert(kMostAccepted < kMostUnopened,
              "each connection is read before newer ones replace it");

}  // namespace

struct WebSocketServer::Io {
  boost::asio::io_context context{1};
  Tcp::acceptor listener{context};
  boost::asio::steady_timer timer{context};
};

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
  ErrorCode problem;
  const auto address = boost::asio::ip::make_address(settings_.address, problem);
  if (problem) {
    return {base::error("live.no-address", {settings_.address})};
  }
  const Tcp::endpoint place(address, settings_.port);
  try {
    io_ = std::make_unique<Io>();
    Tcp::acceptor& listener = io_->listener;
    listener.open(place.protocol());
    ::fcntl(listener.native_handle(), F_SETFD, FD_CLOEXEC);
    listener.set_option(Tcp::acceptor::reuse_address(true));  // allows an immediate restart
    listener.bind(place);
    listener.listen();
    listener.non_blocking(true);
    port_ = listener.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    const std::string port = std::to_string(settings_.port);
    return {error.code() == boost::asio::error::address_in_use
                ? base::error("live.port-taken", {port})
                : base::error("live.no-port", {settings_.address, port, error.code().message()})};
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
    endAt_ = Clock::now() + kFlushTimeout;
    io_->listener.close();
    for (const auto& connection : connections()) {
      if (connection->isOpened()) {
        connection->close(reason);
      } else {
        connection->end();
      }
    }
    if (connections_.empty()) {
      io_->context.stop();
    }
  });
  thread_.join();
}

void WebSocketServer::exclusively(const std::function<void()>& work) {
  if (!thread_.joinable()) {
    work();
    return;
  }
  std::packaged_task<void()> task(work);
  std::future<void> done = task.get_future();
  boost::asio::post(io_->context, std::move(task));
  done.get();
}

void WebSocketServer::send(Client client, SendQueue::Message message) {
  const auto found = connections_.find(client);
  if (found != connections_.end()) {
    found->second->send(std::move(message));
  }
}

std::size_t WebSocketServer::droppedCount(Client client) const {
  const auto found = connections_.find(client);
  return found == connections_.end() ? 0 : found->second->droppedCount();
}

void WebSocketServer::serve() {
  awaitClients();
  tick();
  io_->context.run();
  for (const auto& connection : connections()) {
    connection->end();
  }
}

void WebSocketServer::tick() {
  io_->timer.expires_after(kBetweenTicks);
  io_->timer.async_wait([this](const ErrorCode& problem) {
    if (!problem) {
      tick();
    }
  });
  const Clock::time_point now = Clock::now();
  for (const auto& connection : connections()) {
    try {
      connection->checkTime(now);
    } catch (const std::exception&) {  // out of memory for this client
      connection->end();
    }
  }
  if (acceptAgainAt_ && now >= *acceptAgainAt_) {
    acceptAgainAt_.reset();
    acceptAll();
  }
  handler_.tick();
  if (endAt_ && now >= *endAt_) {
    io_->context.stop();
  }
}

void WebSocketServer::awaitClients() {
  io_->listener.async_wait(Tcp::acceptor::wait_read, [this](const ErrorCode& problem) {
    if (!problem) {
      acceptAll();
    }
  });
}

void WebSocketServer::acceptAll() {
  if (!io_->listener.is_open()) {
    return;
  }
  for (int i = 0; i < kMostAccepted; ++i) {
    // Unlike that of Asio, this call sets the flag for child processes.
    const int socket = ::accept4(io_->listener.native_handle(), nullptr, nullptr, SOCK_CLOEXEC);
    if (socket >= 0) {
      acceptOne(socket);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      break;
    } else if (errno != EINTR && errno != ECONNABORTED && limitUnopened(0) == 0) {
      acceptAgainAt_ = Clock::now() + kNoSocket;
      return;
    }
  }
  awaitClients();
}

void WebSocketServer::acceptOne(int socket) {
  ErrorCode ignored;
  Tcp::socket stream(io_->context);
  stream.assign(io_->listener.local_endpoint().protocol(), socket);
  stream.set_option(Tcp::no_delay(true), ignored);
  stream.set_option(Tcp::socket::send_buffer_size(kSystemBuffer), ignored);
  limitUnopened(kMostUnopened - 1);
  const auto connection = std::make_shared<Connection>(*this, ++last_, std::move(stream));
  connections_.emplace(last_, connection);
  connection->start();
}

std::size_t WebSocketServer::limitUnopened(std::size_t most) {
  std::vector<std::shared_ptr<Connection>> unopened = connections();  // ordered by arrival
  unopened.erase(std::remove_if(unopened.begin(), unopened.end(),
                                [](const auto& each) { return each->isOpened(); }),
                 unopened.end());
  const std::size_t tooMany = unopened.size() > most ? unopened.size() - most : 0;
  for (std::size_t i = 0; i < tooMany; ++i) {
    unopened[i]->end();
  }
  return tooMany;
}

bool WebSocketServer::isFull() const {
  const auto open = std::count_if(connections_.begin(), connections_.end(),
                                  [](const auto& each) { return each.second->isOpened(); });
  return static_cast<std::size_t>(open) >= settings_.mostClients;
}

/// A copy, because connections remove themselves when they end.
std::vector<std::shared_ptr<Connection>> WebSocketServer::connections() const {
  std::vector<std::shared_ptr<Connection>> all;
  for (const auto& [client, connection] : connections_) {
    all.push_back(connection);
  }
  return all;
}

void WebSocketServer::remove(Client client) {
  connections_.erase(client);
  if (endAt_ && connections_.empty()) {
    io_->context.stop();
  }
}

}  // namespace live
