#include "app/bridge/groot/WatchedRun.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "sim2d/base/Text.h"

namespace groot {

namespace {

constexpr std::size_t kHead = 6;  // [B] of a request
constexpr char kProtocol = 2;
constexpr std::uint8_t kWasIdled = 10;  // plus the status before
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

void append(std::string& bytes, std::uint64_t value, int count) {
  for (int k = 0; k < count; ++k) {
    bytes.push_back(static_cast<char>(value >> (8 * k) & 0xFFU));
  }
}

/// A number or truth value where the text is one.
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

/// Entries of the subtree and entries that are remapped into it; the latter under its own keys.
nlohmann::json blackboardOf(const WatchedTree& tree, const WatchedTree::Part& part,
                            const WatchedRun::Entries& known) {
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
    const auto entry = std::find_if(known.begin(), known.end(), [&name = source](const auto& each) {
      return each.first == name;
    });
    if (entry != known.end()) {
      add(key, entry->second);
    }
  }
  return entries;
}

Message refused(const std::string& why) {
  return {"error", why};
}

}  // namespace

WatchedRun::WatchedRun(WatchedTree tree, const RunName& name)
    : tree_(std::move(tree)),
      name_(name),
      statuses_(static_cast<std::size_t>(tree_.nodes), base::NodeStatus::Idle),
      told_(statuses_.size(), 0) {}

void WatchedRun::set(int node, base::NodeStatus status, double time) {
  const auto at = static_cast<std::size_t>(node);
  if (node < 0 || at >= statuses_.size()) {
    return;
  }
  const auto before = static_cast<std::uint8_t>(statuses_[at]);
  const bool isIdle = status == base::NodeStatus::Idle;
  told_[at] =
      isIdle ? static_cast<std::uint8_t>(kWasIdled + before) : static_cast<std::uint8_t>(status);
  statuses_[at] = status;
  if (isRecording_ && transitions_.size() < kMostTransitions) {
    transitions_.push_back({static_cast<std::uint64_t>(time * 1e6),
                            static_cast<std::uint16_t>(at + 1), static_cast<std::uint8_t>(status)});
  }
}

std::string WatchedRun::statuses() const {
  std::string bytes;
  for (std::size_t at = 0; at < told_.size(); ++at) {
    append(bytes, at + 1, 2);
    append(bytes, told_[at], 1);
  }
  return bytes;
}

/// Blackboards of the named trees (separated by ';') as MessagePack. The main tree has no name of
/// its own, so its ID is used.
std::string WatchedRun::blackboards(const std::string& names) const {
  nlohmann::json all = nlohmann::json::object();
  for (const std::string& name : base::split(names, ';')) {
    const auto part =
        std::find_if(tree_.parts.begin(), tree_.parts.end(), [&](const WatchedTree::Part& each) {
          return each.fullPath == name || (each.fullPath.empty() && each.treeId == name);
        });
    if (part != tree_.parts.end()) {
      all[name] = blackboardOf(tree_, *part, entries_);
    }
  }
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_msgpack(all);
  return {bytes.begin(), bytes.end()};
}

/// Told is when it began in microseconds of the run: 0, as the transitions count from there.
Message WatchedRun::record(const std::string& word) {
  isRecording_ = word == "start";
  transitions_.clear();
  return isRecording_ ? Message{"0"} : Message{};
}

std::string WatchedRun::takeTransitions() {
  std::string bytes;
  for (const Transition& each : transitions_) {
    append(bytes, each.microseconds, 6);
    append(bytes, each.node, 2);
    append(bytes, each.status, 1);
  }
  transitions_.clear();
  return bytes;
}

/// The parts behind the head; none: the request makes no sense.
std::optional<Message> WatchedRun::contentOf(char kind, const Message& request,
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

Message WatchedRun::answer(const Message& request) {
  if (request.empty() || request.front().size() != kHead) {
    return refused("wrong request header");
  }
  std::string problem;
  std::optional<Message> content = contentOf(request.front()[1], request, problem);
  if (!content) {
    return refused(problem);
  }
  std::string head = request.front();
  head[0] = kProtocol;
  head.append(name_.begin(), name_.end());
  content->insert(content->begin(), head);
  return *content;
}

}  // namespace groot
