#include "app/bridge/live/FoxgloveServer.h"

#include <algorithm>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace live {

namespace {

constexpr std::size_t kMaxClientChannels = 100;  // advertised channels per client

/// Joins problems: "a; b and 3 more".
std::string summaryOf(const std::vector<std::string>& problems) {
  constexpr std::size_t kTold = 3;
  const std::vector<std::string> first(
      problems.begin(),
      problems.begin() + static_cast<std::ptrdiff_t>(std::min(problems.size(), kTold)));
  const std::string more = problems.size() > kTold
                               ? " and " + std::to_string(problems.size() - kTold) + " more"
                               : std::string();
  return base::join(first, "; ") + more;
}

bool isSupported(std::string_view encoding) {
  return encoding == "cdr" || encoding == "json";
}

/// Without names, all parameters are meant.
bool isNamed(const Parameter& parameter, const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), parameter.name) != names.end();
}

}  // namespace

base::Result<std::unique_ptr<FoxgloveServer>> FoxgloveServer::listen(
    FoxgloveSettings settings, const std::vector<Channel>& channels) {
  settings.server.protocols = {"foxglove.sdk.v1", "foxglove.websocket.v1"};
  std::unique_ptr<FoxgloveServer> server(new FoxgloveServer(std::move(settings)));
  for (const Channel& channel : channels) {
    server->publishedChannels_.emplace_back().channel = channel;
  }
  server->greeting_ = serverInfoText(server->settings_);
  server->channels_ = advertiseText(channels);
  server->services_ = servicesText(server->settings_.services);
  for (const Parameter& each : server->settings_.parameters) {
    server->sentParameters_[each.name] = each.get();
  }
  auto listening = WebSocketServer::listen(server->settings_.server, *server);
  if (!listening) {
    return listening.diagnostics();
  }
  server->server_ = *std::move(listening);
  return base::Result<std::unique_ptr<FoxgloveServer>>(std::move(server));
}

FoxgloveServer::~FoxgloveServer() {
  if (server_) {
    server_->stop("the server is stopping");
  }
}

bool FoxgloveServer::isWanted(ChannelId channel) const {
  const PublishedChannel& published = publishedChannels_.at(channel - 1);
  return published.wanted > 0 || published.channel.isLatched;
}

void FoxgloveServer::publish(std::uint64_t time, const std::vector<Message>& messages,
                             Recipients recipients) {
  server_->exclusively([&] {
    for (const Message& message : messages) {
      PublishedChannel& published = publishedChannels_.at(message.channel - 1);
      if (published.channel.isLatched) {
        published.time = time;
        published.newest = message.payload;
      }
    }
    for (auto& [client, state] : clientStates_) {
      publishTo(client, state, time, messages, recipients);
      warnOfLoss(client, state);
    }
  });
}

/// Sends the time before the first message; with Recipients::All every client receives the time,
/// even without a message.
void FoxgloveServer::publishTo(Client client, ClientState& state, std::uint64_t time,
                               const std::vector<Message>& messages, Recipients recipients) {
  const bool isToAll = recipients == Recipients::All;
  bool isTimeSent = false;
  const auto sendTime = [&] {
    if (!std::exchange(isTimeSent, true)) {
      server_->send(client, {SendQueue::Kind::Topic, timeMessage(time)});
    }
  };
  if (isToAll) {
    sendTime();
  }
  for (const Message& message : messages) {
    const auto wanted = state.wanted.find(message.channel);
    if (wanted != state.wanted.end() && (isToAll || wanted->second.isMessageAwaited)) {
      sendTime();
      sendMessage(client, message.channel, wanted->second, time, message.payload,
                  SendQueue::Kind::Topic);
    }
  }
}

void FoxgloveServer::sendMessage(Client client, ChannelId channel, ClientSubscription& wanted,
                                 std::uint64_t time, const SharedBytes& payload,
                                 SendQueue::Kind kind) {
  server_->send(client, {kind, messageHead(wanted.subscription, time), payload});
  publishedChannels_.at(channel - 1).awaited -=
      std::exchange(wanted.isMessageAwaited, false) ? 1 : 0;
}

void FoxgloveServer::removeSubscription(ChannelId channel, const ClientSubscription& wanted) {
  PublishedChannel& published = publishedChannels_.at(channel - 1);
  --published.wanted;
  published.awaited -= wanted.isMessageAwaited ? 1 : 0;
}

/// Warns each client once.
void FoxgloveServer::warnOfLoss(Client client, ClientState& state) {
  if (server_->droppedCount(client) > 0 && !std::exchange(state.isWarnedOfLoss, true)) {
    send(client, statusText(StatusLevel::Warning,
                            "this connection is too slow: older messages are dropped", "slow"));
  }
}

/// Sends changed parameters to the clients that subscribed to them.
void FoxgloveServer::sendParameters() {
  std::vector<NamedValue> changed;
  for (const Parameter& each : settings_.parameters) {
    ParameterValue value = each.get();
    if (sentParameters_[each.name] != value) {
      sentParameters_[each.name] = value;
      changed.push_back({each.name, std::move(value)});
    }
  }
  for (const auto& [client, state] : clientStates_) {
    std::vector<NamedValue> watched;
    std::copy_if(
        changed.begin(), changed.end(), std::back_inserter(watched),
        [&set = state.watched](const NamedValue& each) { return set.count(each.name) > 0; });
    if (!watched.empty()) {
      send(client, parametersText(watched, std::nullopt));
    }
  }
}

void FoxgloveServer::opened(Client client) {
  clientStates_[client];
  clientCount_ = clientStates_.size();
  hadClients_ = true;
  send(client, greeting_);
  send(client, channels_);
  if (!settings_.services.empty()) {
    send(client, services_);
  }
}

void FoxgloveServer::received(Client client, bool isText, const std::string& message) {
  const ClientRequest asked = isText ? requestOfText(message) : requestOfBytes(message);
  std::visit([&](const auto& request) { answer(client, request); }, asked);
}

void FoxgloveServer::closed(Client client) {
  const auto found = clientStates_.find(client);
  if (found != clientStates_.end()) {
    for (const auto& [channel, wanted] : found->second.wanted) {
      removeSubscription(channel, wanted);
    }
    clientStates_.erase(found);
  }
  clientCount_ = clientStates_.size();
}

void FoxgloveServer::refused(const std::string& origin) {
  if (settings_.refused) {
    settings_.refused(origin);
  }
}

void FoxgloveServer::tick() {
  if (settings_.tick) {
    settings_.tick();
  }
}

void FoxgloveServer::send(Client client, const std::string& text) {
  server_->send(client, {SendQueue::Kind::Text, text});
}

/// Has no effect without problems.
void FoxgloveServer::sendError(Client client, const std::vector<std::string>& problems) {
  if (!problems.empty()) {
    send(client, statusText(StatusLevel::Error, summaryOf(problems)));
  }
}

void FoxgloveServer::answer(Client client, const request::Refused& asked) {
  sendError(client, {asked.why});
}

void FoxgloveServer::answer(Client client, const request::Subscribe& asked) {
  std::vector<std::string> problems;
  for (const Subscription& each : asked.subscriptions) {
    if (std::string problem = subscribe(client, each); !problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
  sendError(client, problems);
  const auto& wanted = clientStates_[client].wanted;
  const bool isAwaiting = std::any_of(
      wanted.begin(), wanted.end(), [](const auto& each) { return each.second.isMessageAwaited; });
  if (isAwaiting && settings_.subscribed) {
    settings_.subscribed();
  }
}

/// Returns an error text; empty on success.
std::string FoxgloveServer::subscribe(Client client, const Subscription& wanted) {
  ClientState& state = clientStates_[client];
  if (wanted.channel == 0 || wanted.channel > publishedChannels_.size()) {
    return "there is no channel " + std::to_string(wanted.channel);
  }
  if (std::any_of(state.wanted.begin(), state.wanted.end(),
                  [&](const auto& each) { return each.second.subscription == wanted.id; })) {
    return "subscription " + std::to_string(wanted.id) + " already exists";
  }
  const auto [added, isNew] = state.wanted.emplace(wanted.channel, ClientSubscription{wanted.id});
  if (!isNew) {
    return "channel " + std::to_string(wanted.channel) + " is already subscribed";
  }
  PublishedChannel& published = publishedChannels_[wanted.channel - 1];
  ++published.wanted;
  ++published.awaited;
  if (published.newest) {
    sendMessage(client, wanted.channel, added->second, published.time, published.newest,
                SendQueue::Kind::Response);
  }
  return {};
}

/// Unknown subscriptions are ignored.
void FoxgloveServer::answer(Client client, const request::Unsubscribe& asked) {
  auto& subscriptions = clientStates_[client].wanted;
  for (const std::uint32_t id : asked.subscriptions) {
    const auto found =
        std::find_if(subscriptions.begin(), subscriptions.end(),
                     [id](const auto& each) { return each.second.subscription == id; });
    if (found != subscriptions.end()) {
      removeSubscription(found->first, found->second);
      subscriptions.erase(found);
    }
  }
}

void FoxgloveServer::answer(Client client, const request::Advertise& asked) {
  std::vector<std::string> problems;
  auto& own = clientStates_[client].own;
  for (const ClientChannel& channel : asked.channels) {
    const ClientTopic* const topic =
        base::findIf(settings_.clientTopics, [&](const ClientTopic& each) {
          return each.topic == channel.topic && each.schemaName == channel.schemaName;
        });
    if (topic == nullptr) {
      problems.push_back("no subscriber for " + channel.topic + " of type " + channel.schemaName);
    } else if (!isSupported(channel.encoding)) {
      problems.push_back("the encoding '" + channel.encoding + "' is not supported");
    } else if (own.size() >= kMaxClientChannels ||
               !own.emplace(channel.id, OwnChannel{topic, channel.encoding}).second) {
      problems.push_back("client channel " + std::to_string(channel.id) +
                         " already exists, or there are too many");
    }
  }
  sendError(client, problems);
}

void FoxgloveServer::answer(Client client, const request::Unadvertise& asked) {
  for (const std::uint32_t channel : asked.channels) {
    clientStates_[client].own.erase(channel);
  }
}

void FoxgloveServer::answer(Client client, const request::Publish& asked) {
  const auto& own = clientStates_[client].own;
  const auto channel = own.find(asked.channel);
  if (channel == own.end()) {
    sendError(client, {"there is no client channel " + std::to_string(asked.channel)});
    return;
  }
  const auto& [topic, encoding] = channel->second;
  const std::string problem = topic->take(encoding, asked.payload);
  if (!problem.empty()) {
    sendError(client, {topic->topic + ": " + problem});
  }
}

void FoxgloveServer::answer(Client client, const request::CallService& asked) {
  const auto fail = [&](const std::string& why) {
    send(client, callFailureText(asked.service, asked.call, why));
  };
  if (asked.service == 0 || asked.service > settings_.services.size()) {
    fail("there is no service " + std::to_string(asked.service));
    return;
  }
  if (!isSupported(asked.encoding)) {
    fail("services support the encodings cdr and json");
    return;
  }
  const ServiceAnswer done =
      settings_.services[asked.service - 1].call(asked.encoding, asked.payload);
  if (!done.isFine) {
    fail(done.payload);
    return;
  }
  server_->send(client, {SendQueue::Kind::Response, callResponse(asked, done.payload)});
  sendParameters();
}

/// Unknown parameters have no value and are omitted.
void FoxgloveServer::answer(Client client, const request::GetParameters& asked) {
  std::vector<NamedValue> values;
  for (const Parameter& each : settings_.parameters) {
    if (isNamed(each, asked.names)) {
      values.push_back({each.name, each.get()});
    }
  }
  send(client, parametersText(values, asked.id));
}

/// With an id, the client receives the resulting values, whether they could be set or not.
void FoxgloveServer::answer(Client client, const request::SetParameters& asked) {
  std::vector<std::string> problems;
  request::GetParameters after{{}, asked.id};
  for (const NamedValue& each : asked.values) {
    const Parameter* const known = base::findBy(settings_.parameters, &Parameter::name, each.name);
    const std::string problem = known == nullptr ? "does not exist"
                                : !known->set    ? "cannot be set"
                                                 : known->set(each.value);
    if (!problem.empty()) {
      problems.push_back(each.name + " " + problem);
    }
    after.names.push_back(each.name);
  }
  sendError(client, problems);
  if (asked.id && !after.names.empty()) {
    answer(client, after);
  }
  sendParameters();
}

void FoxgloveServer::answer(Client client, const request::WatchParameters& asked) {
  std::set<std::string>& watched = clientStates_[client].watched;
  for (const Parameter& each : settings_.parameters) {
    const bool isMeant = isNamed(each, asked.names);
    if (isMeant && asked.isWatched) {
      watched.insert(each.name);
    } else if (isMeant) {
      watched.erase(each.name);
    }
  }
}

}  // namespace live
