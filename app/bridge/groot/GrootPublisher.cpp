#include "app/bridge/groot/GrootPublisher.h"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <zmq.h>

#include <nlohmann/json.hpp>

#include "bt/engine/Program.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/LittleEndian.h"
#include "sim2d/base/Text.h"

namespace groot {
namespace {

class Numbering {
 public:
  explicit Numbering(const bt::TreeTable& table) : table_(table) {}

  GrootTree make() {
    file_.mainTree = table_.mainTree;
    if (const bt::TreeTable::Entry* main = table_.find(table_.mainTree)) {
      addSubTree(*main, {}, {}, {});
    }
    const bt::NodeLibrary library = bt::humanNodes();
    addAliases(library);
    const bt::NodeCatalogue& catalogue = library.catalogue();
    file_.model = bt::modelOf(catalogue);
    file_.order.assign(file_.trees.size(), bt::FilePart::Tree);
    file_.order.push_back(bt::FilePart::Model);
    watched_.xml = bt::writeTree(file_, catalogue);
    return std::move(watched_);
  }

 private:
  void addAliases(const bt::NodeLibrary& library) {
    const auto program = bt::compile(table_, library);
    if (!program) {
      return;
    }
    for (const bt::Program::Entry& alias : (*program)->aliases()) {
      watched_.aliases.emplace_back(alias.key, (*program)->keyOf(alias.slot));
    }
  }

  /// `path`: path of the SubTree node; empty for the main tree.
  void addSubTree(const bt::TreeTable::Entry& entry, const std::string& fullPath,
                  const std::string& prefix, const std::string& path) {
    watched_.parts.push_back({fullPath, prefix, entry.tree.id});
    const std::size_t place = file_.trees.size();
    bt::TreeSpec& tree = file_.trees.emplace_back();
    tree.id = entry.tree.id;
    tree.others = {{"_fullpath", fullPath}};
    const std::string& label = entry.tree.root.label();
    bt::NodeSpec root =
        numbered(entry.tree.root, fullPath, path.empty() ? label : path + "/" + label);
    file_.trees[place].root = std::move(root);  // trees were added meanwhile, so `tree` is invalid
  }

  bt::NodeSpec numbered(const bt::NodeSpec& node, const std::string& fullPath,
                        const std::string& path) {
    bt::NodeSpec converted = node;
    converted.children.clear();
    const std::string number = std::to_string(++watched_.nodes);
    bt::setAttribute(converted.others, "_uid", number);
    bt::removeAttribute(converted.others, "_fullpath");
    if (node.isSubTree()) {
      const std::string name = node.name.empty() ? node.subTree + "::" + number : node.name;
      const std::string own = fullPath.empty() ? name : fullPath + "/" + name;
      bt::setAttribute(converted.others, "_fullpath", own);
      if (const bt::TreeTable::Entry* entry = table_.find(node.subTree)) {
        addSubTree(*entry, own, path + "/", path);
      }
      return converted;
    }
    converted.name = node.label();
    const std::vector<std::string> names = bt::uniqueChildLabels(node.children);
    for (std::size_t k = 0; k < node.children.size(); ++k) {
      converted.children.push_back(numbered(node.children[k], fullPath, path + "/" + names[k]));
    }
    return converted;
  }

  const bt::TreeTable& table_;
  bt::TreeFile file_;
  GrootTree watched_;
};

}  // namespace

GrootTree grootTree(const bt::TreeTable& table) {
  return Numbering(table).make();
}

namespace {

constexpr std::size_t kHead = 6;  // [B] of a request
constexpr char kProtocol = 2;
constexpr std::uint8_t kIdleOffset = 10;  // plus the previous status
constexpr std::size_t kMostTransitions = 1000000;

enum Kind : char {
  FullTree = 'T',
  Statuses = 'S',
  Blackboards = 'B',
  HooksDump = 'D',
  RemoveHooks = 'A',
  Record = 'r',
  Transitions = 't'
};

/// Converts text that is a number or boolean to that type.
nlohmann::json valueOf(const std::string& text) {
  if (text == "true" || text == "false") {
    return text == "true";
  }
  if (const auto whole = base::parseInt(text)) {
    return *whole;
  }
  const auto number = base::parseDouble(text);
  return number ? nlohmann::json(*number) : nlohmann::json(text);
}

/// Entries of the subtree and entries that are remapped into it, the latter under the subtree's
/// keys.
nlohmann::json blackboardOf(const GrootTree& tree, const GrootTree::SubTree& part,
                            const GrootProtocol::Entries& known) {
  nlohmann::json entries = nlohmann::json::object();
  const auto add = [&](const std::string& key, const std::string& value) {
    const bool isOfPart = key.compare(0, part.prefix.size(), part.prefix) == 0;
    const std::string own = isOfPart ? key.substr(part.prefix.size()) : std::string();
    if (!own.empty() && own.find('/') == std::string::npos) {
      entries[own] = valueOf(value);
    }
  };
  for (const auto& [key, value] : known) {
    add(key, value);
  }
  for (const auto& [key, source] : tree.aliases) {
    if (const auto* const entry =
            base::findBy(known, &std::pair<std::string, std::string>::first, source)) {
      add(key, entry->second);
    }
  }
  return entries;
}

}  // namespace

GrootProtocol::GrootProtocol(GrootTree tree, const RunName& name)
    : tree_(std::move(tree)),
      name_(name),
      statuses_(static_cast<std::size_t>(tree_.nodes), base::NodeStatus::Idle),
      encodedStatuses_(statuses_.size(), 0) {}

void GrootProtocol::set(int node, base::NodeStatus status, double time) {
  const auto at = static_cast<std::size_t>(node);
  if (node < 0 || at >= statuses_.size()) {
    return;
  }
  const auto before = static_cast<std::uint8_t>(statuses_[at]);
  const bool isIdle = status == base::NodeStatus::Idle;
  encodedStatuses_[at] =
      isIdle ? static_cast<std::uint8_t>(kIdleOffset + before) : static_cast<std::uint8_t>(status);
  statuses_[at] = status;
  if (isRecording_ && transitions_.size() < kMostTransitions) {
    transitions_.push_back({static_cast<std::uint64_t>(time * 1e6),
                            static_cast<std::uint16_t>(at + 1), static_cast<std::uint8_t>(status)});
  }
}

std::string GrootProtocol::statuses() const {
  std::string bytes;
  for (std::size_t at = 0; at < encodedStatuses_.size(); ++at) {
    base::appendLittleEndian(bytes, at + 1, 2);
    base::appendLittleEndian(bytes, encodedStatuses_[at], 1);
  }
  return bytes;
}

/// Blackboards of the named trees (separated by ';') as MessagePack. The main tree has no instance
/// name, so its ID is used.
std::string GrootProtocol::blackboards(const std::string& names) const {
  nlohmann::json all = nlohmann::json::object();
  for (const std::string& name : base::split(names, ';')) {
    const GrootTree::SubTree* const part =
        base::findIf(tree_.parts, [&](const GrootTree::SubTree& each) {
          return each.fullPath == name || (each.fullPath.empty() && each.treeId == name);
        });
    if (part != nullptr) {
      all[name] = blackboardOf(tree_, *part, entries_);
    }
  }
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_msgpack(all);
  return {bytes.begin(), bytes.end()};
}

/// The response contains the start time in microseconds of the run: 0, the origin of the transition
/// times.
Message GrootProtocol::record(const std::string& word) {
  isRecording_ = word == "start";
  transitions_.clear();
  return isRecording_ ? Message{"0"} : Message{};
}

std::string GrootProtocol::takeTransitions() {
  std::string bytes;
  for (const Transition& each : transitions_) {
    base::appendLittleEndian(bytes, each.microseconds, 6);
    base::appendLittleEndian(bytes, each.node);
    base::appendLittleEndian(bytes, each.status);
  }
  transitions_.clear();
  return bytes;
}

/// The parts after the header. Nothing: invalid request.
std::optional<Message> GrootProtocol::contentOf(char kind, const Message& request,
                                                std::string& problem) {
  switch (kind) {
    case FullTree:
      return Message{tree_.xml};
    case Statuses:
      return Message{statuses()};
    case HooksDump:
      return Message{"[]"};
    case RemoveHooks:
      return Message{};
    case Transitions:
      return Message{takeTransitions()};
    case Blackboards:
    case Record:
      if (request.size() == 2) {
        return kind == Record ? record(request[1]) : Message{blackboards(request[1])};
      }
      problem = "must be 2 parts message";
      return std::nullopt;
    default:
      problem = "Request not recognized: breakpoints are set in HuNavSim's window";
      return std::nullopt;
  }
}

Message GrootProtocol::answer(const Message& request) {
  if (request.empty() || request.front().size() != kHead) {
    return {"error", "wrong request header"};
  }
  std::string problem;
  std::optional<Message> content = contentOf(request.front()[1], request, problem);
  if (!content) {
    return {"error", problem};
  }
  std::string head = request.front();
  head[0] = kProtocol;
  head.append(name_.begin(), name_.end());
  content->insert(content->begin(), head);
  return *content;
}

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
