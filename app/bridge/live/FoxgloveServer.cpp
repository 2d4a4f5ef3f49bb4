#include "app/bridge/live/FoxgloveServer.h"

#include <algorithm>
#include <utility>

#include "app/bridge/live/ServerMessages.h"
#include "sim2d/base/LittleEndian.h"
#include "sim2d/base/Text.h"

namespace live {

namespace {

constexpr std::size_t kMaxClientChannels = 100;  // advertised channels per client

enum BinaryOp : char { MessageData = 1, ServerTime = 2, ServiceResponse = 3 };

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

}  // namespace

base::Result<std::unique_ptr<FoxgloveServer>> FoxgloveServer::listen(
    FoxgloveSettings settings, const std::vector<Channel>& channels) {
  settings.server.rules.protocols = {"foxglove.sdk.v1", "foxglove.websocket.v1"};
  std::unique_ptr<FoxgloveServer> server(new FoxgloveServer(std::move(settings)));
  for (const Channel& channel : channels) {
    server->publishedChannels_.push_back(std::make_unique<PublishedChannel>());
    server->publishedChannels_.back()->channel = channel;
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
  const PublishedChannel& published = *publishedChannels_.at(channel - 1);
  return published.wanted > 0 || published.channel.isLatched;
}

void FoxgloveServer::publish(std::uint64_t time, const std::vector<Message>& messages,
                             bool onlyAwaited) {
  std::string clock(1, ServerTime);
  base::appendLittleEndian(clock, time);
  server_->exclusively([&] {
    for (const Message& message : messages) {
      PublishedChannel& published = *publishedChannels_.at(message.channel - 1);
      if (published.channel.isLatched) {
        published.time = time;
        published.newest = message.payload;
      }
    }
    for (auto& [client, state] : clientStates_) {
      publishTo(client, state, {time, clock, messages}, onlyAwaited);
      warnOfLoss(client, state);
    }
  });
}

/// The time goes before the messages; also alone, unless only awaited messages are sent.
void FoxgloveServer::publishTo(Client client, ClientState& state, const Publication& publication,
                               bool onlyAwaited) {
  bool isTimeDue = true;
  const auto sendTime = [&] {
    Connection* const connection = server_->find(client);
    if (connection != nullptr && std::exchange(isTimeDue, false)) {
      connection->sendBinary(publication.clock, nullptr, SendQueue::Kind::Message);
    }
  };
  if (!onlyAwaited) {
    sendTime();
  }
  for (const Message& message : publication.messages) {
    const auto wanted = state.wanted.find(message.channel);
    if (wanted != state.wanted.end() && (!onlyAwaited || wanted->second.isMessageAwaited)) {
      sendTime();
      sendMessage(client, message.channel, wanted->second, publication.time, message.payload,
                  SendQueue::Kind::Message);
    }
  }
}

void FoxgloveServer::sendMessage(Client client, ChannelId channel, ClientSubscription& wanted,
                                 std::uint64_t time, const SharedBytes& payload,
                                 SendQueue::Kind kind) {
  if (Connection* const connection = server_->find(client)) {
    std::string head(1, MessageData);
    base::appendLittleEndian(head, wanted.subscription);
    base::appendLittleEndian(head, time);
    connection->sendBinary(head, payload, kind);
    publishedChannels_.at(channel - 1)->awaited -=
        std::exchange(wanted.isMessageAwaited, false) ? 1 : 0;
  }
}

void FoxgloveServer::removeSubscription(ChannelId channel, const ClientSubscription& wanted) {
  PublishedChannel& published = *publishedChannels_.at(channel - 1);
  --published.wanted;
  published.awaited -= wanted.isMessageAwaited ? 1 : 0;
}

/// Warns each client once.
void FoxgloveServer::warnOfLoss(Client client, ClientState& state) {
  Connection* const connection = server_->find(client);
  if (connection != nullptr && connection->out().droppedCount() > 0 &&
      !std::exchange(state.isWarnedOfLoss, true)) {
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

void FoxgloveServer::received(Client client, WebSocketMessage&& message) {
  const ClientRequest asked = message.opcode == Opcode::Text ? requestOfText(message.payload)
                                                             : requestOfBytes(message.payload);
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
  if (Connection* const connection = server_->find(client)) {
    connection->sendText(text);
  }
}

void FoxgloveServer::sendError(Client client, const std::string& why) {
  send(client, statusText(StatusLevel::Error, why));
}

void FoxgloveServer::answer(Client client, const request::Refused& asked) {
  sendError(client, asked.why);
}

void FoxgloveServer::answer(Client client, const request::Subscribe& asked) {
  std::vector<std::string> problems;
  for (const Subscription& each : asked.subscriptions) {
    if (std::string problem = subscribe(client, each); !problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
  if (!problems.empty()) {
    sendError(client, summaryOf(problems));
  }
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
  PublishedChannel& published = *publishedChannels_[wanted.channel - 1];
  ++published.wanted;
  ++published.awaited;
  if (published.newest) {
    sendMessage(client, wanted.channel, added->second, published.time, published.newest,
                SendQueue::Kind::Answer);
  }
  return {};
}

void FoxgloveServer::answer(Client client, const request::Unsubscribe& asked) {
  for (const std::uint32_t subscription : asked.subscriptions) {
    unsubscribe(clientStates_[client], subscription);
  }
}

/// An unknown subscription is ignored.
void FoxgloveServer::unsubscribe(ClientState& state, std::uint32_t subscription) {
  const auto found = std::find_if(state.wanted.begin(), state.wanted.end(), [&](const auto& each) {
    return each.second.subscription == subscription;
  });
  if (found != state.wanted.end()) {
    removeSubscription(found->first, found->second);
    state.wanted.erase(found);
  }
}

void FoxgloveServer::answer(Client client, const request::Advertise& asked) {
  std::vector<std::string> problems;
  auto& own = clientStates_[client].own;
  for (const ClientChannel& channel : asked.channels) {
    const bool isTaken = std::any_of(settings_.clientTopics.begin(), settings_.clientTopics.end(),
                                     [&](const ClientTopic& clientTopic) {
                                       return clientTopic.topic == channel.topic &&
                                              clientTopic.schemaName == channel.schemaName;
                                     });
    if (!isTaken) {
      problems.push_back("no subscriber for " + channel.topic + " of type " + channel.schemaName);
    } else if (channel.encoding != "cdr" && channel.encoding != "json") {
      problems.push_back("the encoding '" + channel.encoding + "' is not supported");
    } else if (own.size() >= kMaxClientChannels || !own.emplace(channel.id, channel).second) {
      problems.push_back("client channel " + std::to_string(channel.id) +
                         " already exists, or there are too many");
    }
  }
  if (!problems.empty()) {
    sendError(client, summaryOf(problems));
  }
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
    sendError(client, "there is no client channel " + std::to_string(asked.channel));
    return;
  }
  for (const ClientTopic& clientTopic : settings_.clientTopics) {
    if (clientTopic.topic == channel->second.topic &&
        clientTopic.schemaName == channel->second.schemaName) {
      const std::string problem = clientTopic.take(channel->second.encoding, asked.payload);
      if (!problem.empty()) {
        sendError(client, clientTopic.topic + ": " + problem);
      }
    }
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
  if (asked.encoding != "cdr" && asked.encoding != "json") {
    fail("services support the encodings cdr and json");
    return;
  }
  const ServiceAnswer done =
      settings_.services[asked.service - 1].call(asked.encoding, asked.payload);
  if (!done.isFine) {
    fail(done.payload);
    return;
  }
  std::string bytes(1, ServiceResponse);
  base::appendLittleEndian(bytes, asked.service);
  base::appendLittleEndian(bytes, asked.call);
  base::appendLittleEndian(bytes, static_cast<std::uint32_t>(asked.encoding.size()));
  bytes.append(asked.encoding).append(done.payload);
  if (Connection* const connection = server_->find(client)) {
    connection->sendBinary(bytes, nullptr, SendQueue::Kind::Answer);
  }
  sendParameters();
}

const Parameter* FoxgloveServer::parameter(const std::string& name) const {
  const auto found = std::find_if(settings_.parameters.begin(), settings_.parameters.end(),
                                  [&](const Parameter& each) { return each.name == name; });
  return found == settings_.parameters.end() ? nullptr : &*found;
}

/// Unknown parameters have no value and are omitted.
void FoxgloveServer::answer(Client client, const request::GetParameters& asked) {
  std::vector<NamedValue> values;
  for (const Parameter& each : settings_.parameters) {
    if (asked.names.empty() ||
        std::find(asked.names.begin(), asked.names.end(), each.name) != asked.names.end()) {
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
    const Parameter* const known = parameter(each.name);
    const std::string problem = known == nullptr ? "does not exist"
                                : !known->set    ? "cannot be set"
                                                 : known->set(each.value);
    if (!problem.empty()) {
      problems.push_back(each.name + " " + problem);
    }
    after.names.push_back(each.name);
  }
  if (!problems.empty()) {
    sendError(client, summaryOf(problems));
  }
  if (asked.id && !after.names.empty()) {
    answer(client, after);
  }
  sendParameters();
}

void FoxgloveServer::answer(Client client, const request::WatchParameters& asked) {
  std::set<std::string>& watched = clientStates_[client].watched;
  for (const Parameter& each : settings_.parameters) {
    const bool isMeant = asked.names.empty() || std::find(asked.names.begin(), asked.names.end(),
                                                          each.name) != asked.names.end();
    if (isMeant && asked.isWatched) {
      watched.insert(each.name);
    } else if (isMeant) {
      watched.erase(each.name);
    }
  }
}

}  // namespace live
