#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <QtTest>

#include "app/bridge/dds/DdsEntities.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/std_msgs.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;

namespace {

constexpr int kDomain = 20;

constexpr const char* kType = "std_msgs/msg/String";
constexpr const char* kService = "test_msgs/srv/Words";

/// Answers "x" by "x!".
std::unique_ptr<Server> echo(Participant& to, int node) {
  base::Result<std::unique_ptr<Server>> made = to.server(
      node, "echo", kService, Qos::keepLast(100),
      [](const ServiceRequest& request) { return encodedText(textIn(request.bytes) + "!"); });
  return made ? *std::move(made) : nullptr;
}

}  // namespace

/// Topics and services between two participants on this machine.
class ParticipantTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void names_areThoseOfRos_data() {
    QTest::addColumn<QString>("made");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const std::string& made, const char* expected) {
      QTest::newRow(name) << QString::fromStdString(made) << expected;
    };
    row("relative", resolvedName("human_states", "/", "a"), "/human_states");
    row("in a namespace", resolvedName("human_states", "/lab", "a"), "/lab/human_states");
    row("absolute", resolvedName("/tf", "/lab", "a"), "/tf");
    row("private", resolvedName("~/get_parameters", "/lab", "a"), "/lab/a/get_parameters");
    row("topic", ddsTopic("/a/b"), "rt/a/b");
    const ServiceNames names = serviceNames("/compute_agents", "hunav_msgs/srv/ComputeAgents");
    row("request", names.requestTopic, "rq/compute_agentsRequest");
    row("reply", names.replyTopic, "rr/compute_agentsReply");
    row("request type", names.requestType, "hunav_msgs::srv::dds_::ComputeAgents_Request_");
    row("reply type", names.replyType, "hunav_msgs::srv::dds_::ComputeAgents_Response_");
  }

  void names_areThoseOfRos() {
    QFETCH(const QString, made);
    QFETCH(const QString, expected);
    QCOMPARE(made, expected);
  }

  void namespaces_areChecked() {
    for (const char* const good : {"/", "/lab", "/lab_2/a"}) {
      QVERIFY2(isNamespace(good), good);
    }
    for (const char* const bad : {"", "lab", "/2lab", "/lab/", "//", "/a-b", "/a b"}) {
      QVERIFY2(!isNamespace(bad), bad);
    }
  }

  // By hand: header 4, gid 24 (16), count 4, "/" 4 + 2, "n" at 4: 2 + 4 + 2, readers at 4: 2 + 4 +
  // gid, writers 4.
  void graphSample_hasTheSizesOfEachDistro() {
    Guid participant{};
    participant[0] = 7;
    Guid reader{};
    reader[15] = 9;
    const std::vector<NodeEndpoints> nodes = {{"/", "n", {reader}, {}}};
    const Bytes humble = graphSample(participant, nodes, Distro::Humble);
    const Bytes jazzy = graphSample(participant, nodes, Distro::Jazzy);
    QCOMPARE(humble.size(), std::size_t{4 + 24 + 4 + 6 + 2 + 6 + 2 + 4 + 24 + 4});
    QCOMPARE(jazzy.size(), std::size_t{humble.size() - 16});
    QCOMPARE(humble[4], char{7});
    QCOMPARE(humble[4 + 24], char{1});
    QCOMPARE(jazzy[4 + 16], char{1});
    QCOMPARE(humble[4 + 24 + 4 + 6 + 2 + 6 + 2 + 4 + 15], char{9});
  }

  void topic_arrivesInOrder() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    QVERIFY(a && b);
    std::vector<std::string> heard;
    const auto talks = a->publisher(a->addNode("/", "talker"), "words", kType, Qos());
    const auto hears = b->subscription(b->addNode("/", "listener"), "words", kType, Qos(),
                                       [&](const Bytes& bytes) { heard.push_back(textIn(bytes)); });
    QVERIFY(talks && hears);
    QVERIFY(spinBoth(*a, *b, [&] { return (*talks)->matched() == 1 && (*hears)->matched() == 1; }));
    for (int i = 0; i < 5; ++i) {
      QVERIFY((*talks)->publish(encodedText(std::to_string(i))));
    }
    QVERIFY(spinBoth(*a, *b, [&] { return heard.size() == 5; }));
    QCOMPARE(heard, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
  }

  void topic_ofOneself_isNotHeard() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    int own = 0;
    int heard = 0;
    const int node = a->addNode("/", "both");
    const auto talks = a->publisher(node, "words", kType, Qos());
    const auto hearsItself =
        a->subscription(node, "words", kType, Qos(), [&](const Bytes&) { ++own; });
    const int listener = b->addNode("/", "listener");
    const auto hears =
        b->subscription(listener, "words", kType, Qos(), [&](const Bytes&) { ++heard; });
    const auto answers = b->publisher(listener, "words", kType, Qos());
    QVERIFY(talks && hearsItself && hears && answers);
    QVERIFY(spinBoth(*a, *b, [&] {
      (*talks)->publish(encodedText("mine"));
      return heard > 2;
    }));
    QCOMPARE(own, 0);
    QVERIFY(spinBoth(*a, *b, [&] {
      (*answers)->publish(encodedText("yours"));
      return own > 0;
    }));
  }

  void topic_isWanted_byWhoHearsIt() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    QVERIFY(a && b);
    const auto talks = a->publisher(a->addNode("/", "talker"), "words", kType, Qos());
    const auto keeps = a->publisher(0, "kept_words", kType, Qos::latched());
    QVERIFY(talks && keeps);
    QVERIFY(!(*talks)->hasReceivers());
    QVERIFY((*keeps)->hasReceivers());  // by who comes later
    {
      const auto hears = b->subscription(b->addNode("/", "listener"), "words", kType, Qos(),
                                         [](const Bytes& /*bytes*/) {});
      QVERIFY(hears);
      QVERIFY(spinBoth(*a, *b, [&] { return (*talks)->hasReceivers(); }));
    }
    QVERIFY(spinBoth(*a, *b, [&] { return !(*talks)->hasReceivers(); }));
  }

  void topic_latched_comesToWhoComesLater() {
    const auto a = participant(inDomain(kDomain));
    const auto talks = a->publisher(a->addNode("/", "talker"), "map", kType, Qos::latched());
    QVERIFY(talks);
    QVERIFY((*talks)->publish(encodedText("old")));
    QVERIFY((*talks)->publish(encodedText("walls")));
    const auto b = participant(inDomain(kDomain));
    std::string heard;
    const auto hears = b->subscription(b->addNode("/", "listener"), "map", kType, Qos::latched(),
                                       [&](const Bytes& bytes) { heard += textIn(bytes); });
    QVERIFY(hears);
    QVERIFY(spinBoth(*a, *b, [&] { return !heard.empty(); }));
    QCOMPARE(heard, std::string("walls"));
  }

  void topic_bestEffortReader_isServed() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    int heard = 0;
    const auto talks = a->publisher(a->addNode("/", "talker"), "clock", kType, Qos::keepLast(1));
    const auto hears = b->subscription(b->addNode("/", "listener"), "clock", kType,
                                       Qos::clockReader(), [&](const Bytes&) { ++heard; });
    QVERIFY(talks && hears);
    QVERIFY(spinBoth(*a, *b, [&] {
      (*talks)->publish(encodedText("tick"));
      return heard > 0;
    }));
  }

  void topic_otherTypeUnderTheName_isRefused() {
    const auto a = participant(inDomain(kDomain));
    const int node = a->addNode("/", "talker");
    const auto twist = a->publisher(node, "cmd_vel", "geometry_msgs/msg/Twist", Qos());
    const auto stamped = a->publisher(node, "cmd_vel", "geometry_msgs/msg/TwistStamped", Qos());
    QVERIFY(twist);
    QVERIFY(!stamped);
    QCOMPARE(std::string(stamped.diagnostics().at(0).code), std::string("ros2.other-type"));
  }

  void service_everyCall_isAnswered_data() { addRmws(); }

  void service_everyCall_isAnswered() {
    QFETCH(const Rmw, rmw);
    const auto a = participant(inDomain(kDomain, rmw));
    const auto b = participant(inDomain(kDomain, rmw));
    const auto server = echo(*a, a->addNode("/", "server"));
    const auto client = b->client(b->addNode("/", "client"), "echo", kService);
    QVERIFY(server && client);
    QVERIFY(spinBoth(*a, *b, [&] { return (*client)->isReady(); }));
    for (int i = 0; i < 50; ++i) {
      const std::int64_t number = (*client)->send(encodedText(std::to_string(i)));
      QVERIFY(number >= 0);
      std::optional<std::pair<std::int64_t, Bytes>> reply;
      QVERIFY(spinBoth(*a, *b, [&] { return (reply = (*client)->receive()).has_value(); }));
      QCOMPARE(reply->first, number);
      QCOMPARE(textIn(reply->second), std::to_string(i) + "!");
    }
  }

  void service_twoClients_getTheirOwnAnswers_data() { addRmws(); }

  void service_twoClients_getTheirOwnAnswers() {
    QFETCH(const Rmw, rmw);
    const auto a = participant(inDomain(kDomain, rmw));
    const auto b = participant(inDomain(kDomain, rmw));
    const auto server = echo(*a, a->addNode("/", "server"));
    const int node = b->addNode("/", "clients");
    const std::array<base::Result<std::unique_ptr<Client>>, 2> clients = {
        b->client(node, "echo", kService), b->client(node, "echo", kService)};
    QVERIFY(server && clients[0] && clients[1]);
    QVERIFY(spinBoth(*a, *b, [&] {
      const bool first = (*clients[0])->isReady();
      return (*clients[1])->isReady() && first;
    }));
    for (int i = 0; i < 10; ++i) {
      for (std::size_t who = 0; who < 2; ++who) {
        QVERIFY((*clients[who])->send(encodedText(who == 0 ? "anna" : "bert")) >= 0);
      }
    }
    std::array<std::vector<std::string>, 2> answers;
    QVERIFY(spinBoth(*a, *b, [&] {
      for (std::size_t who = 0; who < 2; ++who) {
        while (const auto reply = (*clients[who])->receive()) {
          answers[who].push_back(textIn(reply->second));
        }
      }
      return answers[0].size() == 10 && answers[1].size() == 10;
    }));
    QCOMPARE(answers[0], std::vector<std::string>(10, "anna!"));
    QCOMPARE(answers[1], std::vector<std::string>(10, "bert!"));
  }

  void service_manyAnswersToOthersMeanwhile_ownIsThere_data() { addRmws(); }

  /// Answers go to all clients of a service. One that is busy must not lose its own among them.
  void service_manyAnswersToOthersMeanwhile_ownIsThere() {
    QFETCH(const Rmw, rmw);
    const auto a = participant(inDomain(kDomain, rmw));
    const auto b = participant(inDomain(kDomain, rmw));
    const auto c = participant(inDomain(kDomain, rmw));
    const auto server = echo(*a, a->addNode("/", "server"));
    const auto busy = b->client(b->addNode("/", "busy"), "echo", kService);
    const auto other = c->client(c->addNode("/", "other"), "echo", kService);
    QVERIFY(server && busy && other);
    QVERIFY(spinBoth(*b, *c, [&] {
      const bool first = (*busy)->isReady();
      return (*other)->isReady() && first;
    }));
    const std::int64_t number = (*busy)->send(encodedText("busy"));
    for (int i = 0; i < 400; ++i) {
      QVERIFY((*other)->send(encodedText(std::to_string(i))) >= 0);
      QVERIFY(spinBoth(*a, *c, [&] { return (*other)->receive().has_value(); }));
    }
    std::optional<std::pair<std::int64_t, Bytes>> reply;
    QVERIFY(spinBoth(*a, *b, [&] { return (reply = (*busy)->receive()).has_value(); }));
    QCOMPARE(reply->first, number);
    QCOMPARE(textIn(reply->second), std::string("busy!"));
  }

  /// Their readers are taken away while the threads of DDS hand them answers to others.
  void service_clientsGoWhileAnswersCome_othersAreAnswered() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    const auto c = participant(inDomain(kDomain));
    const auto server = echo(*a, a->addNode("/", "server"));
    const auto stays = b->client(b->addNode("/", "stays"), "echo", kService);
    const int node = c->addNode("/", "short");
    QVERIFY(server && stays);
    QVERIFY(spinBoth(*a, *b, [&] { return (*stays)->isReady(); }));
    for (int i = 0; i < 10; ++i) {
      auto goes = c->client(node, "echo", kService);
      QVERIFY(bool(goes));
      QVERIFY(spinBoth(*a, *c, [&] { return (*goes)->isReady(); }));
      for (int k = 0; k < 80; ++k) {
        QVERIFY((*stays)->send(encodedText("here")) >= 0);
      }
      int answered = 0;
      QVERIFY(spinBoth(*a, *b, [&] {
        while ((*stays)->receive()) {
          ++answered;
        }
        if (answered > 5) {
          (*goes).reset();
        }
        return answered == 80;
      }));
    }
  }

  void service_clientGoneInMidCall_othersAreAnswered() {
    const auto a = participant(inDomain(kDomain));
    const auto server = echo(*a, a->addNode("/", "server"));
    auto b = participant(inDomain(kDomain));
    const auto c = participant(inDomain(kDomain));
    auto gone = b->client(b->addNode("/", "gone"), "echo", kService);
    const auto stays = c->client(c->addNode("/", "stays"), "echo", kService);
    QVERIFY(server && gone && stays);
    QVERIFY(spinBoth(*b, *c, [&] {
      const bool first = (*gone)->isReady();
      return (*stays)->isReady() && first;
    }));
    QVERIFY((*gone)->send(encodedText("lost")) >= 0);
    (*gone).reset();
    b.reset();
    QVERIFY((*stays)->send(encodedText("here")) >= 0);
    std::optional<std::pair<std::int64_t, Bytes>> reply;
    QVERIFY(spinBoth(*a, *c, [&] { return (reply = (*stays)->receive()).has_value(); }));
    QCOMPARE(textIn(reply->second), std::string("here!"));
  }

  void service_serverComesLast_isFound() {
    const auto b = participant(inDomain(kDomain));
    const auto client = b->client(b->addNode("/", "client"), "echo", kService);
    QVERIFY(client);
    QVERIFY(!(*client)->isReady());
    QVERIFY(!(*client)->call(encodedText("nobody"), Milliseconds(100)));
    const auto a = participant(inDomain(kDomain));
    const auto server = echo(*a, a->addNode("/", "server"));
    QVERIFY(spinBoth(*a, *b, [&] { return (*client)->isReady(); }));
    QVERIFY((*client)->send(encodedText("late")) >= 0);
    std::optional<std::pair<std::int64_t, Bytes>> reply;
    QVERIFY(spinBoth(*a, *b, [&] { return (reply = (*client)->receive()).has_value(); }));
    QCOMPARE(textIn(reply->second), std::string("late!"));
  }

  void service_payloadTooShort_isHandedOut() {
    const auto a = participant(inDomain(kDomain, Rmw::CycloneDds));
    const auto b = participant(inDomain(kDomain, Rmw::CycloneDds));
    std::vector<std::size_t> sizes;
    const auto server = a->server(a->addNode("/", "server"), "echo", kService, Qos(),
                                  [&](const ServiceRequest& request) {
                                    sizes.push_back(request.bytes.size());
                                    return encodedText("x");
                                  });
    // A plain publisher on the topic of requests, as anybody could have one.
    const auto other = participant(inDomain(kDomain));
    const auto client = other->client(other->addNode("/", "other"), "echo", kService);
    QVERIFY(server && client);
    QVERIFY(spinBoth(*a, *other, [&] { return (*client)->isReady(); }));
    QVERIFY((*client)->send(Bytes("\0\1\0\0\7\0\0\0", 8)) >= 0);
    QVERIFY(spinBoth(*a, *other, [&] { return !sizes.empty(); }));
    QCOMPARE(sizes.front(), std::size_t{8});
  }

  void service_largeRequest_arrivesWhole() {
    const auto a = participant(inDomain(kDomain));
    const auto b = participant(inDomain(kDomain));
    const auto server = echo(*a, a->addNode("/", "server"));
    const auto client = b->client(b->addNode("/", "client"), "echo", kService);
    QVERIFY(spinBoth(*a, *b, [&] { return (*client)->isReady(); }));
    const std::string large(300000, 'x');
    QVERIFY((*client)->send(encodedText(large)) >= 0);
    std::optional<std::pair<std::int64_t, Bytes>> reply;
    QVERIFY(spinBoth(*a, *b, [&] { return (reply = (*client)->receive()).has_value(); }));
    QCOMPARE(textIn(reply->second).size(), large.size() + 1);
  }

  void create_domainBeyondAll_isTold() {
    const base::Result<std::unique_ptr<Participant>> made = Participant::create(inDomain(100000));
    QVERIFY(!made);
    QCOMPARE(std::string(made.diagnostics().at(0).code), std::string("ros2.no-participant"));
  }
};

QTEST_APPLESS_MAIN(ParticipantTest)
#include "tst_Participant.moc"
