#include "app/bridge/live/FoxgloveServer.h"

#include <algorithm>
#include <utility>

#include "app/bridge/live/LittleEndian.h"
#include "app/bridge/live/ServerText.h"
#include "sim2d/base/Text.h"

namespace live {

namespace {

constexpr std::size_t kMostOwn = 100;  // channels that one client publishes on

enum BinaryOp : char { MessageData = 1, TimeOfServer = 2, ServiceResponse = 3 };

/// "a; b and 3 more".
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
    server->outlets_.push_back(std::make_unique<Outlet>());
    server->outlets_.back()->channel = channel;
  }
  server->greeting_ = serverInfoText(server->settings_);
  server->channels_ = advertiseText(channels);
  server->services_ = servicesText(server->settings_.services);
  for (const Parameter& each : server->settings_.parameters) {
    server->told_[each.name] = each.get();
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
    server_->stop("the server ends");
  }
}

bool FoxgloveServer::isWanted(ChannelId channel) const {
  const Outlet& outlet = *outlets_.at(channel - 1);
  return outlet.wanted > 0 || outlet.channel.isLatched;
}

void FoxgloveServer::publish(std::uint64_t time, const std::vector<Message>& messages) {
  publish(time, messages, false);
}

void FoxgloveServer::catchUp(std::uint64_t time, const std::vector<Message>& messages) {
  publish(time, messages, true);
}

void FoxgloveServer::publish(std::uint64_t time, const std::vector<Message>& messages,
                             bool onlyAwaited) {
  std::string clock(1, TimeOfServer);
  appendLittleEndian(clock, time);
  server_->exclusively([&] {
    for (const Message& message : messages) {
      Outlet& outlet = *outlets_.at(message.channel - 1);
      if (outlet.channel.isLatched) {
        outlet.time = time;
        outlet.newest = message.payload;
      }
    }
    for (auto& [client, table] : tables_) {
      publishTo(client, table, {time, clock, messages}, onlyAwaited);
      tellLoss(client, table);
    }
  });
}

/// The time goes before the messages; also alone, unless only awaited messages are sent.
void FoxgloveServer::publishTo(Client client, Table& table, const Publication& publication,
                               bool onlyAwaited) {
  bool isTimeDue = true;
  const auto sendTime = [&] {
    Connection* const connection = server_->find(client);
    if (connection != nullptr && std::exchange(isTimeDue, false)) {
      connection->sendBinary(publication.clock, nullptr, Outbox::Kind::Message);
    }
  };
  if (!onlyAwaited) {
    sendTime();
  }
  for (const Message& message : publication.messages) {
    const auto wanted = table.wanted.find(message.channel);
    if (wanted != table.wanted.end() && (!onlyAwaited || wanted->second.isAwaited)) {
      sendTime();
      sendMessage(client, message.channel, wanted->second, publication.time, message.payload,
                  Outbox::Kind::Message);
    }
  }
}

void FoxgloveServer::sendMessage(Client client, ChannelId channel, Wanted& wanted,
                                 std::uint64_t time, const SharedBytes& payload,
                                 Outbox::Kind kind) {
  if (Connection* const connection = server_->find(client)) {
    std::string head(1, MessageData);
    appendLittleEndian(head, wanted.subscription);
    appendLittleEndian(head, time);
    connection->sendBinary(head, payload, kind);
    outlets_.at(channel - 1)->awaited -= std::exchange(wanted.isAwaited, false) ? 1 : 0;
  }
}

void FoxgloveServer::leave(ChannelId channel, const Wanted& wanted) {
  Outlet& outlet = *outlets_.at(channel - 1);
  --outlet.wanted;
  outlet.awaited -= wanted.isAwaited ? 1 : 0;
}

/// Once is enough.
void FoxgloveServer::tellLoss(Client client, Table& table) {
  Connection* const connection = server_->find(client);
  if (connection != nullptr && connection->out().leftOut() > 0 &&
      !std::exchange(table.isToldOfLoss, true)) {
    tell(client, statusText(StatusLevel::Warning,
                            "this connection is too slow: older messages are left out", "slow"));
  }
}

void FoxgloveServer::noteParameters() {
  server_->exclusively([this] { tellParameters(); });
}

/// Those that have changed, to whoever watches them.
void FoxgloveServer::tellParameters() {
  std::vector<NamedValue> changed;
  for (const Parameter& each : settings_.parameters) {
    ParameterValue value = each.get();
    if (told_[each.name] != value) {
      told_[each.name] = value;
      changed.push_back({each.name, std::move(value)});
    }
  }
  for (const auto& [client, table] : tables_) {
    std::vector<NamedValue> watched;
    std::copy_if(
        changed.begin(), changed.end(), std::back_inserter(watched),
        [&set = table.watched](const NamedValue& each) { return set.count(each.name) > 0; });
    if (!watched.empty()) {
      tell(client, parametersText(watched, std::nullopt));
    }
  }
}

void FoxgloveServer::opened(Client client) {
  tables_[client];
  clientCount_ = tables_.size();
  hadClients_ = true;
  tell(client, greeting_);
  tell(client, channels_);
  if (!settings_.services.empty()) {
    tell(client, services_);
  }
}

void FoxgloveServer::received(Client client, WebSocketMessage&& message) {
  const ClientRequest asked = message.opcode == Opcode::Text ? requestOfText(message.payload)
                                                             : requestOfBytes(message.payload);
  std::visit([&](const auto& request) { answer(client, request); }, asked);
}

void FoxgloveServer::closed(Client client) {
  const auto found = tables_.find(client);
  if (found != tables_.end()) {
    for (const auto& [channel, wanted] : found->second.wanted) {
      leave(channel, wanted);
    }
    tables_.erase(found);
  }
  clientCount_ = tables_.size();
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

void FoxgloveServer::tell(Client client, const std::string& text) {
  if (Connection* const connection = server_->find(client)) {
    connection->sendText(text);
  }
}

void FoxgloveServer::complain(Client client, const std::string& why) {
  tell(client, statusText(StatusLevel::Error, why));
}

void FoxgloveServer::answer(Client client, const request::Refused& asked) {
  complain(client, asked.why);
}

void FoxgloveServer::answer(Client client, const request::Subscribe& asked) {
  std::vector<std::string> problems;
  for (const Subscription& each : asked.subscriptions) {
    if (std::string problem = subscribe(client, each); !problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
  if (!problems.empty()) {
    complain(client, summaryOf(problems));
  }
  const auto& wanted = tables_[client].wanted;
  const bool isAwaiting = std::any_of(wanted.begin(), wanted.end(),
                                      [](const auto& each) { return each.second.isAwaited; });
  if (isAwaiting && settings_.subscribed) {
    settings_.subscribed();
  }
}

/// Returns what is wrong.
std::string FoxgloveServer::subscribe(Client client, const Subscription& wanted) {
  Table& table = tables_[client];
  if (wanted.channel == 0 || wanted.channel > outlets_.size()) {
    return "there is no channel " + std::to_string(wanted.channel);
  }
  if (std::any_of(table.wanted.begin(), table.wanted.end(),
                  [&](const auto& each) { return each.second.subscription == wanted.id; })) {
    return "there is a subscription " + std::to_string(wanted.id) + " already";
  }
  const auto [added, isNew] = table.wanted.emplace(wanted.channel, Wanted{wanted.id});
  if (!isNew) {
    return "channel " + std::to_string(wanted.channel) + " is subscribed to already";
  }
  Outlet& outlet = *outlets_[wanted.channel - 1];
  ++outlet.wanted;
  ++outlet.awaited;
  if (outlet.newest) {
    sendMessage(client, wanted.channel, added->second, outlet.time, outlet.newest,
                Outbox::Kind::Answer);
  }
  return {};
}

void FoxgloveServer::answer(Client client, const request::Unsubscribe& asked) {
  for (const std::uint32_t subscription : asked.subscriptions) {
    unsubscribe(tables_[client], subscription);
  }
}

/// One that is not there is gone already.
void FoxgloveServer::unsubscribe(Table& table, std::uint32_t subscription) {
  const auto found = std::find_if(table.wanted.begin(), table.wanted.end(), [&](const auto& each) {
    return each.second.subscription == subscription;
  });
  if (found != table.wanted.end()) {
    leave(found->first, found->second);
    table.wanted.erase(found);
  }
}

void FoxgloveServer::answer(Client client, const request::Advertise& asked) {
  std::vector<std::string> problems;
  auto& own = tables_[client].own;
  for (const ClientChannel& channel : asked.channels) {
    const bool isTaken =
        std::any_of(settings_.inlets.begin(), settings_.inlets.end(), [&](const Inlet& inlet) {
          return inlet.topic == channel.topic && inlet.schemaName == channel.schemaName;
        });
    if (!isTaken) {
      problems.push_back("nothing listens to " + channel.topic + " of " + channel.schemaName);
    } else if (channel.encoding != "cdr" && channel.encoding != "json") {
      problems.push_back("the encoding '" + channel.encoding + "' is not known here");
    } else if (own.size() >= kMostOwn || !own.emplace(channel.id, channel).second) {
      problems.push_back("there is a channel " + std::to_string(channel.id) +
                         " of yours already, or too many");
    }
  }
  if (!problems.empty()) {
    complain(client, summaryOf(problems));
  }
}

void FoxgloveServer::answer(Client client, const request::Unadvertise& asked) {
  for (const std::uint32_t channel : asked.channels) {
    tables_[client].own.erase(channel);
  }
}

void FoxgloveServer::answer(Client client, const request::Publish& asked) {
  const auto& own = tables_[client].own;
  const auto channel = own.find(asked.channel);
  if (channel == own.end()) {
    complain(client, "there is no channel " + std::to_string(asked.channel) + " of yours");
    return;
  }
  for (const Inlet& inlet : settings_.inlets) {
    if (inlet.topic == channel->second.topic && inlet.schemaName == channel->second.schemaName) {
      const std::string problem = inlet.take(channel->second.encoding, asked.payload);
      if (!problem.empty()) {
        complain(client, inlet.topic + ": " + problem);
      }
    }
  }
}

void FoxgloveServer::answer(Client client, const request::CallService& asked) {
  const auto fail = [&](const std::string& why) {
    tell(client, callFailureText(asked.service, asked.call, why));
  };
  if (asked.service == 0 || asked.service > settings_.services.size()) {
    fail("there is no service " + std::to_string(asked.service));
    return;
  }
  if (asked.encoding != "cdr" && asked.encoding != "json") {
    fail("the encodings of services are cdr and json");
    return;
  }
  const ServiceAnswer done =
      settings_.services[asked.service - 1].call(asked.encoding, asked.payload);
  if (!done.isFine) {
    fail(done.payload);
    return;
  }
  std::string bytes(1, ServiceResponse);
  appendLittleEndian(bytes, asked.service);
  appendLittleEndian(bytes, asked.call);
  appendLittleEndian(bytes, static_cast<std::uint32_t>(asked.encoding.size()));
  bytes.append(asked.encoding).append(done.payload);
  if (Connection* const connection = server_->find(client)) {
    connection->sendBinary(bytes, nullptr, Outbox::Kind::Answer);
  }
  tellParameters();
}

const Parameter* FoxgloveServer::parameter(const std::string& name) const {
  const auto found = std::find_if(settings_.parameters.begin(), settings_.parameters.end(),
                                  [&](const Parameter& each) { return each.name == name; });
  return found == settings_.parameters.end() ? nullptr : &*found;
}

/// Those that are not there have no value, and are left out.
void FoxgloveServer::answer(Client client, const request::GetParameters& asked) {
  std::vector<NamedValue> values;
  for (const Parameter& each : settings_.parameters) {
    if (asked.names.empty() ||
        std::find(asked.names.begin(), asked.names.end(), each.name) != asked.names.end()) {
      values.push_back({each.name, each.get()});
    }
  }
  tell(client, parametersText(values, asked.id));
}

/// With an id it is told what counts then, whether it could be set or not.
void FoxgloveServer::answer(Client client, const request::SetParameters& asked) {
  std::vector<std::string> problems;
  request::GetParameters after{{}, asked.id};
  for (const NamedValue& each : asked.values) {
    const Parameter* const known = parameter(each.name);
    const std::string problem = known == nullptr ? "is not there"
                                : !known->set    ? "cannot be set"
                                                 : known->set(each.value);
    if (!problem.empty()) {
      problems.push_back(each.name + " " + problem);
    }
    after.names.push_back(each.name);
  }
  if (!problems.empty()) {
    complain(client, summaryOf(problems));
  }
  if (asked.id && !after.names.empty()) {
    answer(client, after);
  }
  tellParameters();
}

void FoxgloveServer::answer(Client client, const request::WatchParameters& asked) {
  std::set<std::string>& watched = tables_[client].watched;
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
