#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>
#include <zmq.h>

#include <nlohmann/json.hpp>
#include <tinyxml2.h>

#include <QtTest>

#include "app/bridge/groot/GrootPublisher.h"
#include "app/run/Bundle.h"
#include "app/run/Session.h"
#include "bt/engine/TreeState.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "tests/bridge/LiveClient.h"
#include "tests/support/Mutator.h"
#include "tests/support/TraceHash.h"

using groot::GrootProtocol;
using groot::GrootPublisher;
using groot::GrootServer;
using groot::grootTree;
using groot::GrootTree;
using groot::Message;

namespace {

const char* const kCafe = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";

/// A SubTree twice, the second without a name; entries of their own.
const char* const kTwice = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence name="all">
      <Script code="mine:=1" _uid="77"/>
      <SubTree ID="Part" name="first" given="2.5"/>
      <SubTree ID="Part" given="hello"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Part">
    <Fallback>
      <Script code="own:=given"/>
      <AlwaysFailure/>
    </Fallback>
  </BehaviorTree>
</root>)";

bt::TreeTable tableOf(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(xml, "twice.xml");
  return *bt::resolveIncludes(*file);
}

/// By number; "" where a number came twice.
void collect(const tinyxml2::XMLElement& node, std::map<int, std::string>& labels) {
  const char* const name = node.Attribute("name");
  const char* const label = name != nullptr ? name : node.Attribute("ID");
  const int uid = node.IntAttribute("_uid");
  const bool isNew = labels.count(uid) == 0;
  labels[uid] = isNew && label != nullptr ? label : std::string();
  for (const auto* child = node.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    collect(*child, labels);
  }
}

/// The text holds trees of one name, which files of trees do not: read as plain XML.
std::map<int, std::string> labelsIn(const std::string& xml) {
  std::map<int, std::string> labels;
  tinyxml2::XMLDocument document;
  document.Parse(xml.data(), xml.size());
  const tinyxml2::XMLElement* tree =
      document.RootElement() == nullptr ? nullptr
                                        : document.RootElement()->FirstChildElement("BehaviorTree");
  for (; tree != nullptr; tree = tree->NextSiblingElement("BehaviorTree")) {
    collect(*tree->FirstChildElement(), labels);
  }
  return labels;
}

groot::RunName nameOf(char letter) {
  groot::RunName name;
  name.fill(letter);
  return name;
}

/// Of version 2, with the number 0x04030201.
std::string headOf(char kind) {
  return {'\2', kind, '\1', '\2', '\3', '\4'};
}

/// Groot2's end of the line.
class Client {
 public:
  explicit Client(int port) : context_(zmq_ctx_new()), socket_(zmq_socket(context_, ZMQ_REQ)) {
    const int patience = 20000;  // [ms]
    const int linger = 0;
    zmq_setsockopt(socket_, ZMQ_RCVTIMEO, &patience, sizeof(patience));
    zmq_setsockopt(socket_, ZMQ_LINGER, &linger, sizeof(linger));
    zmq_connect(socket_, ("tcp://127.0.0.1:" + std::to_string(port)).c_str());
  }
  ~Client() {
    zmq_close(socket_);
    zmq_ctx_term(context_);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  Client(Client&&) = delete;
  Client& operator=(Client&&) = delete;

  Message ask(const Message& request) {
    for (std::size_t k = 0; k < request.size(); ++k) {
      zmq_send(socket_, request[k].data(), request[k].size(),
               k + 1 < request.size() ? ZMQ_SNDMORE : 0);
    }
    Message answer;
    for (int more = 1; more != 0;) {
      zmq_msg_t part;
      zmq_msg_init(&part);
      if (zmq_msg_recv(&part, socket_, 0) < 0) {
        return {};
      }
      answer.emplace_back(static_cast<const char*>(zmq_msg_data(&part)), zmq_msg_size(&part));
      more = zmq_msg_more(&part);
      zmq_msg_close(&part);
    }
    return answer;
  }

 private:
  void* context_;
  void* socket_;
};

nlohmann::json unpacked(const std::string& bytes) {
  return nlohmann::json::from_msgpack(bytes.begin(), bytes.end());
}

/// The café, ready to run.
struct Scene {
  Scene() {
    app::RunSpec options;
    options.scenario = kCafe;
    bundle = app::readBundle(options, *app::runSettingsOf(options), {});
    verdict = app::check(bundle);
  }
  sim2d::World& world() { return *verdict.world; }
  const sim2d::Human& person() const { return bundle.scenario->humans.front(); }
  bt::TreeTable tree() const { return *bt::treeOf(person(), bundle.trees, *bundle.scenario); }

  app::Bundle bundle;
  app::Verdict verdict;
  app::Session session{{100, false}};
};

}  // namespace

/// Groot2 watches a tree: what it is told, byte by byte, and a run under its eyes.
class GrootTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The numbers are those of the engine, which puts SubTrees in their place.
  void numbers_areThoseOfTheProgram() {
    const bt::TreeTable table = tableOf(kTwice);
    const auto program = bt::compile(table, bt::humanNodes());
    QVERIFY(static_cast<bool>(program));
    const GrootTree watched = grootTree(table);
    QCOMPARE(watched.nodes, (*program)->nodeCount());
    const std::map<int, std::string> labels = labelsIn(watched.xml);
    QCOMPARE(labels.size(), static_cast<std::size_t>(watched.nodes));
    for (int node = 0; node < watched.nodes; ++node) {
      QCOMPARE(labels.at(node + 1), (*program)->label(node));
    }
  }

  /// As BehaviorTree.CPP writes it: a tree for each place, with the way to it.
  void subTrees_standByThemselves() {
    tinyxml2::XMLDocument document;
    QCOMPARE(document.Parse(grootTree(tableOf(kTwice)).xml.c_str()), tinyxml2::XML_SUCCESS);
    std::vector<std::string> ways;
    const tinyxml2::XMLElement& root = *document.RootElement();
    for (const auto* tree = root.FirstChildElement("BehaviorTree"); tree != nullptr;
         tree = tree->NextSiblingElement("BehaviorTree")) {
      ways.push_back(std::string(tree->Attribute("ID")) + " at " + tree->Attribute("_fullpath"));
    }
    QCOMPARE(ways, (std::vector<std::string>{"Main at ", "Part at first", "Part at Part::7"}));
    const tinyxml2::XMLElement& second =
        *root.FirstChildElement("BehaviorTree")->FirstChildElement()->LastChildElement();
    QCOMPARE(std::string(second.Attribute("_fullpath")), std::string("Part::7"));
    QVERIFY(second.FirstChildElement() == nullptr);
    QCOMPARE(std::string(root.LastChildElement()->Name()), std::string("TreeNodesModel"));
  }

  /// By hand: version, kind, number, then the name of the run; 3 bytes for each node.
  void statuses_areToldByteByByte() {
    GrootTree tree;
    tree.nodes = 2;
    GrootProtocol run(tree, nameOf('n'));
    run.set(0, base::NodeStatus::Running, 0.05);
    run.set(1, base::NodeStatus::Failure, 0.05);
    run.set(1, base::NodeStatus::Idle, 0.1);
    run.set(2, base::NodeStatus::Success, 0.1);  // of another tree
    const Message answer = run.answer({headOf('S')});
    QCOMPARE(answer.size(), std::size_t{2});
    QCOMPARE(answer[0], headOf('S') + std::string(16, 'n'));
    QCOMPARE(answer[1], std::string("\1\0\1\2\0\15", 6));  // 13: idle, was a failure
  }

  /// By hand: 6 bytes of microseconds, 2 of the node, 1 of its status.
  void transitions_areToldWhileTheyAreRecorded() {
    GrootTree tree;
    tree.nodes = 1;
    GrootProtocol run(tree, nameOf('n'));
    run.set(0, base::NodeStatus::Running, 1.0);
    QCOMPARE(run.answer({headOf('r'), "start"})[1], std::string("0"));
    run.set(0, base::NodeStatus::Success, 1.25);  // 1250000 = 0x1312D0
    QCOMPARE(run.answer({headOf('t')})[1], std::string("\xD0\x12\x13\0\0\0\1\0\2", 9));
    QCOMPARE(run.answer({headOf('t')})[1], std::string());
    QCOMPARE(run.answer({headOf('r'), "stop"}).size(), std::size_t{1});
    run.set(0, base::NodeStatus::Failure, 2.0);
    QCOMPARE(run.answer({headOf('t')})[1], std::string());
  }

  void requests_withoutSense_areRefused() {
    GrootProtocol run({}, nameOf('n'));
    for (const Message& request :
         {Message{}, Message{""}, Message{"12345"}, Message{headOf('?')}, Message{headOf('B')},
          Message{headOf('I'), "{}"}, Message{headOf('r')}}) {
      const Message answer = run.answer(request);
      QCOMPARE(answer.size(), std::size_t{2});
      QCOMPARE(answer[0], std::string("error"));
    }
    QCOMPARE(run.answer({headOf('D')})[1], std::string("[]"));
    QCOMPARE(run.answer({headOf('A')}).size(), std::size_t{1});
    Mutator mutator(3);
    for (int k = 0; k < 2000; ++k) {
      run.answer({mutator.mutated(headOf("TSBDArtX"[k % 8])), mutator.mutated("start;Part::7")});
    }
  }

  /// Entries of each part under its own name, numbers as numbers.
  void blackboards_areThoseOfTheParts() {
    const bt::TreeTable table = tableOf(kTwice);
    const auto program = bt::compile(table, bt::humanNodes());
    bt::TreeState state(*program);
    state.tickOnce({});
    GrootProtocol run(grootTree(table), nameOf('n'));
    run.setBlackboard(state.entries());
    const nlohmann::json all = unpacked(run.answer({headOf('B'), ";first;Part::7;nowhere"})[1]);
    QCOMPARE(all.size(), std::size_t{3});
    QCOMPARE(all.at("").at("mine"), nlohmann::json(1));
    QCOMPARE(all.at("first").at("own"), nlohmann::json(2.5));
    QCOMPARE(all.at("Part::7").at("own"), nlohmann::json("hello"));
    QVERIFY(!all.at("").contains("own"));
    QCOMPARE(unpacked(run.answer({headOf('B'), ""})[1]).size(), std::size_t{1});
  }

  /// As BehaviorTree.CPP registers them: the main tree under its ID, as it has no name.
  void blackboard_ofTheMainTree_answersToItsId() {
    const bt::TreeTable table = tableOf(kTwice);
    bt::TreeState state(*bt::compile(table, bt::humanNodes()));
    state.tickOnce({});
    GrootProtocol run(grootTree(table), nameOf('n'));
    run.setBlackboard(state.entries());
    const nlohmann::json all = unpacked(run.answer({headOf('B'), "Main;Part"})[1]);
    QCOMPARE(all.size(), std::size_t{1});
    QCOMPARE(all.at("Main").at("mine"), nlohmann::json(1));
  }

  /// Entries of the caller are seen under the keys of the SubTree, also two levels down.
  void blackboard_ofASubTree_hasWhatItWasGiven() {
    const bt::TreeTable table = tableOf(R"(<root BTCPP_format="4" main_tree_to_execute="Main">
      <BehaviorTree ID="Main"><Sequence><Script code="a := 7; free := 'x'"/>
        <SubTree ID="Part" name="first" given="{a}"/></Sequence></BehaviorTree>
      <BehaviorTree ID="Part"><Sequence><Script code="own := given"/>
        <SubTree ID="Inner" name="inner" _autoremap="true"/></Sequence></BehaviorTree>
      <BehaviorTree ID="Inner"><ScriptCondition code="given == own"/></BehaviorTree></root>)");
    bt::TreeState state(*bt::compile(table, bt::humanNodes()));
    QCOMPARE(state.tickOnce({}), base::NodeStatus::Success);
    GrootProtocol run(grootTree(table), nameOf('n'));
    run.setBlackboard(state.entries());
    const nlohmann::json all = unpacked(run.answer({headOf('B'), "first;first/inner"})[1]);
    QCOMPARE(all.at("first"), nlohmann::json({{"given", 7}, {"own", 7}}));
    QCOMPARE(all.at("first/inner"), nlohmann::json({{"given", 7}, {"own", 7}}));
  }

  /// Over the wire: after each stretch of a run the statuses are those of its record, and the run
  /// is the one without a watcher.
  void run_watched_tellsItsStatusesAndStaysTheSame() {
    Scene scene;
    auto opened = GrootPublisher::open(0, scene.world(), 0, scene.tree());
    QVERIFY(static_cast<bool>(opened));
    GrootPublisher& watched = **opened;
    Client client(watched.port());
    const std::string xml = client.ask({headOf('T')}).at(1);
    const std::size_t count = labelsIn(xml).size();
    QVERIFY(count > 5);
    std::map<std::int64_t, std::string> told;
    sim2d::Recording record;
    record.setHeader(scene.world().header());
    scene.session.run(scene.world(), &record, [&](const sim2d::Frame& frame) {
      watched.show(frame);
      if (frame.step % 10 == 0) {
        told[frame.step] = client.ask({headOf('S')}).at(1);
      }
    });
    QCOMPARE(told.size(), std::size_t{10});
    std::set<char> seen;
    for (const auto& [step, statuses] : told) {
      const std::vector<base::NodeStatus> recorded =
          record.treeAt(scene.person().id, step).statuses;
      QCOMPARE(statuses.size(), 3 * count);
      for (std::size_t node = 0; node < count; ++node) {
        const char status = statuses[3 * node + 2];
        const bool isIdle = status == 0 || status >= 10;
        const base::NodeStatus now = step == 0 ? base::NodeStatus::Idle : recorded.at(node);
        QCOMPARE(isIdle ? '\0' : status, static_cast<char>(now));
        seen.insert(status);
      }
    }
    // Success, failure, and idle after a success.
    QVERIFY(seen.count(2) == 1 && seen.count(3) == 1 && seen.count(12) == 1);
    const nlohmann::json all = unpacked(client.ask({headOf('B'), ""}).at(1));
    QCOMPARE(all.at("").at("id"), nlohmann::json(scene.person().id));
    Scene alone;
    sim2d::Recording recordAlone;
    recordAlone.setHeader(alone.world().header());
    alone.session.run(alone.world(), &recordAlone, {});
    QCOMPARE(sim2d::hashOf(record.trace(scene.world().header())),
             sim2d::hashOf(recordAlone.trace(alone.world().header())));
  }

  /// Whatever connections other programs of this machine leave open, requests are answered within a
  /// second.
  void request_besideManyHalfOpen_isAnsweredAtOnce_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("nothing said") << QByteArray();
    QTest::newRow("half a greeting") << QByteArray("\xff\0\0\0\0\0\0\0\1\x7f", 10);
  }
  void request_besideManyHalfOpen_isAnsweredAtOnce() {
    QFETCH(const QByteArray, said);
    GrootTree tree;
    auto server = GrootServer::listen(0, GrootProtocol(tree, nameOf('a')));
    QVERIFY(static_cast<bool>(server));
    QElapsedTimer timer;
    timer.start();
    std::vector<std::unique_ptr<client::LiveClient>> others;
    for (int k = 0; k < 300; ++k) {
      others.push_back(std::make_unique<client::LiveClient>((*server)->port()));
      others.back()->write(said.toStdString());
    }
    Client client((*server)->port());
    QCOMPARE(client.ask({headOf('S')}).size(), std::size_t{2});
    QVERIFY2(timer.elapsed() < 1000, QByteArray::number(timer.elapsed()));
    // A connection without a handshake is closed soon, so that it uses no file descriptor of the
    // run.
    QVERIFY(others.front()->awaitEnd());
    QVERIFY2(timer.elapsed() < 3000, QByteArray::number(timer.elapsed()));
  }

  void port_thatIsTaken_isToldWithItsReason() {
    GrootTree tree;
    auto first = GrootServer::listen(0, GrootProtocol(tree, nameOf('a')));
    QVERIFY(static_cast<bool>(first));
    const auto second = GrootServer::listen((*first)->port(), GrootProtocol(tree, nameOf('b')));
    QVERIFY(!second);
    QCOMPARE(std::string(second.diagnostics().front().code), std::string("live.no-port"));
    // The port in front is free, the one behind it is not: that one is named.
    const int taken = (*first)->port();
    const auto third = GrootServer::listen(static_cast<std::uint16_t>(taken - 1),
                                           GrootProtocol(tree, nameOf('c')));
    QVERIFY(!third);
    const std::string words = third.diagnostics().front().message;
    if (words.find("port " + std::to_string(taken - 1)) != std::string::npos) {
      QSKIP("another program has the port in front");
    }
    QVERIFY2(words.find("port " + std::to_string(taken)) != std::string::npos, words.c_str());
  }
};

QTEST_APPLESS_MAIN(GrootTest)
#include "tst_Groot.moc"
