#include <algorithm>
#include <cmath>

#include <QtTest>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/nodes/AgentServer.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;
using agentstest::agentAt;
using agentstest::hasRemark;

namespace {

constexpr int kDomain = 23;

/// A server and somebody who calls it.
struct Pair {
  explicit Pair(Rmw rmw = Rmw::FastRtps, const std::function<void(ServeSettings&)>& change = {}) {
    ServeSettings settings;
    settings.domain = inDomain(kDomain, rmw);
    if (change) {
      change(settings);
    }
    auto made =
        AgentServer::create(agentstest::bundleOf(agentstest::oneWalker(), "hunav2"), settings,
                            [this](const base::Diagnostic& said) { told.push_back(said); });
    server = made ? *std::move(made) : nullptr;
    caller = participant(inDomain(kDomain, rmw));
    node = caller->addNode("/", "wrapper");
  }
  std::unique_ptr<Client> client(const std::string& service, const std::string& type) {
    auto made = caller->client(node, service, type);
    return made ? *std::move(made) : nullptr;
  }
  bool until(const std::function<bool()>& isDone) {
    const auto end = std::chrono::steady_clock::now() + kLong;
    bool done = isDone();
    while (!done && std::chrono::steady_clock::now() < end) {
      server->spin(Milliseconds(2));
      caller->spin(Milliseconds(2));
      done = isDone();
    }
    return done;
  }
  std::optional<Bytes> ask(Client& of, const Bytes& request) {
    if (!until([&] { return of.isReady(); }) || of.send(request) < 0) {
      return std::nullopt;
    }
    std::optional<std::pair<std::int64_t, Bytes>> reply;
    until([&] { return (reply = of.receive()).has_value(); });
    return reply ? std::optional<Bytes>(reply->second) : std::nullopt;
  }
  template <class S>
  std::optional<typename S::Response> call(Client& of, const typename S::Request& request) {
    const std::optional<Bytes> reply = ask(of, encode(request));
    const auto read = decode<typename S::Response>(reply.value_or(Bytes()));
    return read ? std::optional<typename S::Response>(*read) : std::nullopt;
  }

  base::Diagnostics told;
  std::unique_ptr<AgentServer> server;
  std::unique_ptr<Participant> caller;
  int node = 0;
};

using hunav_msgs::ComputeAgents;
constexpr const char* kCompute = ComputeAgents::kType;

}  // namespace

/// The nodes of HuNavSim, called by a client on this machine.
class AgentServerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void services_callOfAWrapper_movesAndPublishes_data() { addRmws(); }

  void services_callOfAWrapper_movesAndPublishes() {
    QFETCH(const Rmw, rmw);
    Pair pair(rmw);
    QVERIFY(pair.server);
    std::vector<std::string> heard;  // in the order of arrival
    std::vector<double> places;
    std::vector<std::unique_ptr<Subscription>> subscriptions;
    const auto hear = [&](const char* topic, const char* type, const Qos& qos) {
      auto made = pair.caller->subscription(
          pair.node, topic, type, qos, [&heard, topic](const Bytes&) { heard.push_back(topic); });
      subscriptions.push_back(made ? *std::move(made) : nullptr);
    };
    hear("tf", "tf2_msgs/msg/TFMessage", Qos::transforms());
    hear("sfm_forces", "visualization_msgs/msg/MarkerArray", Qos::keepLast(5));
    hear("robot_states", "hunav_msgs/msg/Agent", Qos::keepLast(1));
    hear("people", "people_msgs/msg/People", Qos::keepLast(1));
    auto states = pair.caller->subscription(
        pair.node, "human_states", "hunav_msgs/msg/Agents", Qos::keepLast(1),
        [&](const Bytes& bytes) {
          const auto agents = decode<hunav_msgs::Agents>(bytes);
          places.push_back(agents ? agents->agents.at(0).position.position.x : -1.0);
        });
    const auto client = pair.client("compute_agents", kCompute);
    QVERIFY(client && states);
    QVERIFY(pair.until([&] {
      bool all = (*states)->matched() > 0;
      for (const auto& each : subscriptions) {
        all = all && each->matched() > 0;
      }
      return all && client->isReady();
    }));
    QTest::qWait(500);  // the writers see the readers a little later
    auto request = agentstest::requestOf({agentAt(1, 0.0, 0.0)}, 1.0);
    request.robot = agentstest::robotAt(9.0, 9.0);
    QVERIFY(pair.call<ComputeAgents>(*client, request));
    agentstest::setStamp(request.currentAgents, 1.05);
    const auto moved = pair.call<ComputeAgents>(*client, request);
    QVERIFY(moved);
    QVERIFY(std::fabs(moved->updatedAgents.agents.at(0).position.position.x - 0.015) < 1e-4);
    request.currentAgents.agents = moved->updatedAgents.agents;
    agentstest::setStamp(request.currentAgents, 1.1);
    QVERIFY(pair.call<ComputeAgents>(*client, request));
    QVERIFY(pair.until([&] { return places.size() == 2 && heard.size() == 10; }));
    QCOMPARE(places[0], 0.0);  // of the second request: nothing is published in the first
    QCOMPARE(places[1], moved->updatedAgents.agents.at(0).position.position.x);
    QCOMPARE(std::count(heard.begin(), heard.end(), std::string("tf")), std::ptrdiff_t{4});
    QCOMPARE(std::count(heard.begin(), heard.end(), std::string("people")), std::ptrdiff_t{2});
    QCOMPARE(pair.server->answered(), std::uint64_t{3});
    QVERIFY(pair.told.empty());
  }

  void services_namespaceGiven_areThere() {
    Pair pair(Rmw::FastRtps, [](ServeSettings& settings) {
      settings.nameSpace = "/lab";
      settings.actsAsGenerator = true;
    });
    const auto client = pair.client("/lab/get_agents", hunav_msgs::GetAgents::kType);
    const auto response = pair.call<hunav_msgs::GetAgents>(*client, {});
    QVERIFY(response);
    QCOMPARE(response->agents.agents.at(0).name, std::string("person1"));
    QCOMPARE(response->agents.agents.at(0).goals.at(0).position.x, 5.0);
  }

  void loader_parameters_areThoseGeneratorsAskFor() {
    Pair pair(Rmw::FastRtps, [](ServeSettings& settings) { settings.actsAsLoader = true; });
    const auto summary = pair.client("/get_parameters", hunav_msgs::GetParameters::kType);
    const auto told = pair.call<hunav_msgs::GetParameters>(*summary, {});
    QVERIFY(told);
    QVERIFY(told->publishPeople);
    QCOMPARE(told->goalIds, std::vector<std::int64_t>{1});
    QCOMPARE(told->goalXCoords, std::vector<double>{5.0});
    const auto values =
        pair.client("/hunav_loader/get_parameters", rcl_interfaces::GetParameters::kType);
    rcl_interfaces::GetParameters::Request request;
    request.names = {"agents",          "person1.id",           "person1.behavior.type",
                     "person1.max_vel", "person1.cyclic_goals", "person1.goals",
                     "global_goals.1.x"};
    const auto found = pair.call<rcl_interfaces::GetParameters>(*values, request);
    QVERIFY(found);
    const std::vector<std::uint8_t> types = {9, 2, 4, 3, 1, 7, 3};
    QCOMPARE(found->values.size(), types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
      QCOMPARE(found->values[i].type, types[i]);
    }
    QCOMPARE(found->values[0].stringArrayValue, std::vector<std::string>{"person1"});
    QCOMPARE(found->values[1].integerValue, std::int64_t{1});
    QCOMPARE(found->values[2].stringValue, std::string("Regular"));
    QCOMPARE(found->values[3].doubleValue, 1.5);
    QCOMPARE(found->values[5].integerArrayValue, std::vector<std::int64_t>{1});
    request.names.push_back("person1.nothing");
    const auto none = pair.call<rcl_interfaces::GetParameters>(*values, request);
    QVERIFY(none && none->values.empty());  // as rclcpp
  }

  void parameters_setAndListed_asRclcpp() {
    Pair pair;
    using rcl_interfaces::ListParameters;
    using rcl_interfaces::SetParameters;
    const auto list = pair.client("/hunav_agent_manager/list_parameters", ListParameters::kType);
    const auto listed = pair.call<ListParameters>(*list, {});
    QVERIFY(listed);
    QCOMPARE(listed->result.names,
             (std::vector<std::string>{"publish_tf", "publish_sfm_forces", "use_sim_time"}));
    const auto set = pair.client("/hunav_agent_manager/set_parameters", SetParameters::kType);
    SetParameters::Request request;
    request.parameters = {bridge::parameter("publish_tf", false),
                          bridge::parameter("publish_tf", 1.0), bridge::parameter("other", true)};
    const auto results = pair.call<SetParameters>(*set, request);
    QVERIFY(results);
    QCOMPARE(results->results.size(), std::size_t{3});
    QVERIFY(results->results[0].successful);
    QVERIFY(!results->results[1].successful);
    QVERIFY(!results->results[2].successful);
    const auto get =
        pair.client("/hunav_agent_manager/get_parameters", rcl_interfaces::GetParameters::kType);
    const auto now = pair.call<rcl_interfaces::GetParameters>(*get, {{"publish_tf"}});
    QVERIFY(now);
    QCOMPARE(now->values.at(0).boolValue, false);
  }

  void forces_switchedOff_areNotPublished() {
    Pair pair(Rmw::FastRtps, [](ServeSettings& settings) { settings.publishesForces = false; });
    int forces = 0;
    int people = 0;
    const auto first =
        pair.caller->subscription(pair.node, "sfm_forces", "visualization_msgs/msg/MarkerArray",
                                  Qos::keepLast(5), [&](const Bytes&) { ++forces; });
    const auto second =
        pair.caller->subscription(pair.node, "people", "people_msgs/msg/People", Qos::keepLast(5),
                                  [&](const Bytes&) { ++people; });
    const auto client = pair.client("compute_agents", kCompute);
    QVERIFY(pair.until(
        [&] { return (*first)->matched() > 0 && (*second)->matched() > 0 && client->isReady(); }));
    QTest::qWait(500);
    for (const double time : {1.0, 1.05, 1.1}) {
      QVERIFY(
          pair.call<ComputeAgents>(*client, agentstest::requestOf({agentAt(1, 0.0, 0.0)}, time)));
    }
    QVERIFY(pair.until([&] { return people == 2; }));
    QCOMPARE(forces, 0);
  }

  void request_ofTheOtherRmw_isTold_data() { addRmws(); }

  void request_ofTheOtherRmw_isTold() {
    QFETCH(const Rmw, rmw);
    Pair pair(rmw);
    pair.caller =
        participant(inDomain(kDomain, rmw == Rmw::FastRtps ? Rmw::CycloneDds : Rmw::FastRtps));
    pair.node = pair.caller->addNode("/", "wrapper");
    const auto client = pair.client("compute_agents", kCompute);
    QVERIFY(pair.until([&] { return client->isReady(); }));
    for (int i = 0; i < 3; ++i) {
      QVERIFY(client->send(encode(agentstest::requestOf({agentAt(1, 0.0, 0.0)}, 1.0))) >= 0);
    }
    QVERIFY(pair.until([&] { return !pair.told.empty(); }));
    pair.until([&, until = std::chrono::steady_clock::now() + Milliseconds(300)] {
      return std::chrono::steady_clock::now() > until;
    });
    QCOMPARE(pair.told.size(), std::size_t{1});  // not for each request
    QVERIFY(hasRemark(pair.told, "ros2.other-rmw"));
  }

  /// HuNavSim 1.x: behavior and its state are bytes of the agent. The type has the same name.
  void request_ofVersionOne_isAnsweredAndTold() {
    Pair pair;
    const auto client = pair.client("compute_agents", kCompute);
    std::string bytes;
    CdrWriter writer(bytes);
    writer.write(std_msgs::Header());
    writer.write(std::uint32_t{1});
    writer.write(std::int32_t{1});  // id, type, skin, behavior, name, behavior_state, group_id
    writer.write(std::uint8_t{1});
    writer.write(std::uint8_t{0});
    writer.write(std::uint8_t{3});
    writer.write(std::string("anna"));
    writer.write(std::uint8_t{0});
    writer.write(std::int8_t{-1});
    writer.write(geometry_msgs::Pose());
    writer.write(0.5F);
    writer.write(geometry_msgs::Twist());
    for (int i = 0; i < 4; ++i) {
      writer.write(1.0F);
    }
    writer.write(std::vector<geometry_msgs::Pose>(2));
    writer.write(true);
    writer.write(0.3F);
    writer.write(std::vector<geometry_msgs::Point>());
    const std::optional<Bytes> reply = pair.ask(*client, bytes);
    QVERIFY(reply);
    const auto read = decode<ComputeAgents::Response>(*reply);
    QVERIFY(read);
    QVERIFY(read->updatedAgents.agents.empty());
    QVERIFY(hasRemark(pair.told, "ros2.other-version"));
  }

  void request_truncated_isAnsweredAndTold() {
    Pair pair;
    const auto client = pair.client("compute_agents", kCompute);
    const Bytes whole = encode(agentstest::requestOf({agentAt(1, 0.0, 0.0)}, 1.0));
    for (const std::size_t size : {whole.size() / 2, std::size_t{8}}) {
      QVERIFY(pair.ask(*client, whole.substr(0, size)));
    }
    Bytes huge = whole;
    huge.replace(4 + 8, 4, "\xff\xff\xff\xff");  // the length of frame_id
    QVERIFY(pair.ask(*client, huge));
    QVERIFY(hasRemark(pair.told, "ros2.other-version"));
    QVERIFY(pair.call<ComputeAgents>(*client, agentstest::requestOf({agentAt(1, 0.0, 0.0)}, 1.0)));
  }

  void server_noOtherParticipant_warnsOnce() {
    constexpr int kEmptyDomain = 65;  // of no other test
    base::Diagnostics reported;
    ServeSettings settings;
    settings.domain = inDomain(kEmptyDomain);
    const auto server =
        AgentServer::create(agentstest::bundleOf(agentstest::oneWalker(), "hunav2"), settings,
                            [&](const base::Diagnostic& problem) { reported.push_back(problem); });
    QVERIFY(server);
    reported.clear();  // those of the scenario
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < Milliseconds(6500)) {
      (*server)->spin(Milliseconds(20));
    }
    QCOMPARE(reported.size(), std::size_t{1});
    QCOMPARE(reported[0].code, std::string_view("ros2.no-peer-here"));
  }
};

QTEST_GUILESS_MAIN(AgentServerTest)
#include "tst_AgentServer.moc"
