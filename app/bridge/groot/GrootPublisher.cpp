#include "app/bridge/groot/GrootPublisher.h"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <zmq.h>

namespace groot {

namespace {

constexpr int kPatience = 100;                     // [ms] between checks for stop requests
constexpr std::size_t kMostParts = 8;              // of a request
constexpr std::int64_t kLargestRequest = 1 << 20;  // [B] of a part
constexpr int kTrials = 20;                        // attempts to find two adjacent free ports
constexpr int kHandshakeTime = 1000;               // [ms]; a local client takes a few
/// Length of the queue of connections not yet accepted, limited by the system. With ZeroMQ's
/// default of 100, a burst of connections delays further clients by seconds.
constexpr int kMostWaitingToConnect = 4096;

struct CloseContext {
  void operator()(void* context) const { zmq_ctx_term(context); }
};
struct CloseSocket {
  void operator()(void* socket) const { zmq_close(socket); }
};
using Context = std::unique_ptr<void, CloseContext>;
using Socket = std::unique_ptr<void, CloseSocket>;

std::string addressOf(int port) {
  return "tcp://127.0.0.1:" + (port == 0 ? std::string("*") : std::to_string(port));
}

int portOf(void* socket) {
  char address[64] = {};
  std::size_t size = sizeof(address);
  zmq_getsockopt(socket, ZMQ_LAST_ENDPOINT, address, &size);
  const std::string text(address);
  return std::stoi(text.substr(text.rfind(':') + 1));
}

Socket socketOf(void* context, int kind) {
  Socket socket(zmq_socket(context, kind));
  const int linger = 0;
  zmq_setsockopt(socket.get(), ZMQ_LINGER, &linger, sizeof(linger));
  zmq_setsockopt(socket.get(), ZMQ_RCVTIMEO, &kPatience, sizeof(kPatience));
  zmq_setsockopt(socket.get(), ZMQ_SNDTIMEO, &kPatience, sizeof(kPatience));
  zmq_setsockopt(socket.get(), ZMQ_MAXMSGSIZE, &kLargestRequest, sizeof(kLargestRequest));
  zmq_setsockopt(socket.get(), ZMQ_HANDSHAKE_IVL, &kHandshakeTime, sizeof(kHandshakeTime));
  zmq_setsockopt(socket.get(), ZMQ_BACKLOG, &kMostWaitingToConnect, sizeof(kMostWaitingToConnect));
  return socket;
}

/// Receives a request with all its parts. Empty: none arrived.
Message receive(void* socket) {
  Message parts;
  int more = 1;
  while (more != 0) {
    zmq_msg_t part;
    zmq_msg_init(&part);
    if (zmq_msg_recv(&part, socket, 0) < 0) {
      zmq_msg_close(&part);
      return {};
    }
    if (parts.size() < kMostParts) {
      parts.emplace_back(static_cast<const char*>(zmq_msg_data(&part)), zmq_msg_size(&part));
    }
    more = zmq_msg_more(&part);
    zmq_msg_close(&part);
  }
  return parts;
}

void send(void* socket, const Message& message) {
  for (std::size_t k = 0; k < message.size(); ++k) {
    const int flags = k + 1 < message.size() ? ZMQ_SNDMORE : 0;
    zmq_send(socket, message[k].data(), message[k].size(), flags);
  }
}

}  // namespace

struct GrootServer::Sockets {
  Context context{zmq_ctx_new()};
  Socket answers, breakpoints;

  /// Binds both sockets. Returns the port that is not available; nothing on success.
  std::optional<int> bind(int port) {
    answers = socketOf(context.get(), ZMQ_REP);
    breakpoints = socketOf(context.get(), ZMQ_PUB);
    if (zmq_bind(answers.get(), addressOf(port).c_str()) != 0) {
      return port;
    }
    const int behind = portOf(answers.get()) + 1;
    const bool isBound = zmq_bind(breakpoints.get(), addressOf(behind).c_str()) == 0;
    return isBound ? std::nullopt : std::optional(behind);
  }
};

base::Result<std::unique_ptr<GrootServer>> GrootServer::listen(std::uint16_t port,
                                                               GrootProtocol run) {
  auto sockets = std::make_unique<Sockets>();
  std::optional<int> taken = sockets->bind(port);
  for (int trial = 0; taken && port == 0 && trial < kTrials; ++trial) {
    taken = sockets->bind(port);
  }
  if (taken) {
    return base::error("live.no-port", {"127.0.0.1", *taken, zmq_strerror(zmq_errno())});
  }
  const auto bound = static_cast<std::uint16_t>(portOf(sockets->answers.get()));
  return std::unique_ptr<GrootServer>(
      new GrootServer(std::move(sockets), bound, std::move(run)));  // NOLINT: private constructor
}

GrootServer::GrootServer(std::unique_ptr<Sockets> sockets, std::uint16_t port, GrootProtocol run)
    : sockets_(std::move(sockets)),
      port_(port),
      run_(std::move(run)),
      thread_([this] { serve(); }) {}

GrootServer::~GrootServer() {
  isStopping_ = true;
  thread_.join();
}

void GrootServer::serve() {
  while (!isStopping_) {
    const Message request = receive(sockets_->answers.get());
    if (!request.empty()) {
      hadRequest_ = true;
      Message answer;
      change([&](GrootProtocol& run) { answer = run.answer(request); });
      send(sockets_->answers.get(), answer);
    }
  }
}

namespace {

constexpr std::chrono::milliseconds kBetweenBlackboards{100};
constexpr int kMaxNodes = 65535;  // node uids have 16 bits

/// A random run identifier. It does not affect the run.
RunName newName() {
  std::random_device device;
  RunName name = {};
  std::generate(name.begin(), name.end(), [&] { return static_cast<char>(device() & 0xFFU); });
  return name;
}

}  // namespace

base::Result<std::unique_ptr<GrootPublisher>> GrootPublisher::open(std::uint16_t port,
                                                                   sim2d::World& world, int human,
                                                                   const bt::TreeTable& tree) {
  GrootTree watched = grootTree(tree);
  if (watched.nodes > kMaxNodes) {
    return base::error("groot.too-many", {watched.nodes, kMaxNodes}, tree.file);
  }
  auto server = GrootServer::listen(port, GrootProtocol(std::move(watched), newName()));
  if (!server) {
    return server.diagnostics();
  }
  return std::unique_ptr<GrootPublisher>(
      new GrootPublisher(world, human, *std::move(server)));  // NOLINT
}

GrootPublisher::GrootPublisher(sim2d::World& world, int human, std::unique_ptr<GrootServer> server)
    : world_(world),
      human_(human),
      id_(world.view().constants(human).id),
      server_(std::move(server)) {}

void GrootPublisher::show(const sim2d::Frame& frame) {
  const auto now = std::chrono::steady_clock::now();
  // Also without a client: a client that connects during a pause gets the entries from before it.
  const bool isDue = !lastBlackboard_ || now - *lastBlackboard_ >= kBetweenBlackboards;
  server_->change([&](GrootProtocol& run) {
    frame.treeChanges.forEach(
        [&](int id, const auto& /*paths*/, int node, base::NodeStatus status) {
          if (id == id_) {
            run.set(node, status, frame.time);
          }
        });
    if (isDue) {
      run.setBlackboard(world_.behavior().blackboard(human_));
    }
  });
  lastBlackboard_ = isDue ? now : lastBlackboard_;
}

}  // namespace groot
