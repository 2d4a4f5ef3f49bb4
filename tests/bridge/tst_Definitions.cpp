#include <set>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/messages/AllMessages.h"
#include "app/bridge/messages/Codec.h"
#include "tests/bridge/Samples.h"
#include "tests/support/Peers.h"

using namespace bridge;

namespace {

const std::string kLine = std::string(80, '=') + "\n";

template <class M>
QJsonObject peerCase() {
  M message{};
  SampleFiller().fill(message);
  return {{QStringLiteral("type"), QLatin1String(M::kType)},
          {QStringLiteral("definition"), QString::fromStdString(M::kDefinition)},
          {QStringLiteral("bytes"),
           QString::fromLatin1(QByteArray::fromStdString(encode(message)).toHex())},
          {QStringLiteral("value"), sampleJson(message)}};
}

template <class... M>
QJsonArray peerCases(TypeList<M...> /*list*/) {
  return {peerCase<M>()...};
}

template <class M>
void compareSample() {
  M message{};
  SampleFiller().fill(message);
  const base::Result<M> read = decode<M>(encode(message));
  QVERIFY2(static_cast<bool>(read), M::kType);
  QVERIFY2(sampleJson(*read) == sampleJson(message), M::kType);
}

template <class... M>
void compareSamples(TypeList<M...> /*list*/) {
  (compareSample<M>(), ...);
}

}  // namespace

class DefinitionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void definition_nested_isThereOnce() {
    QCOMPARE(std::string(rosgraph_msgs::Clock::kDefinition), "builtin_interfaces/Time clock\n" +
                                                                 kLine +
                                                                 "MSG: builtin_interfaces/Time\n"
                                                                 "int32 sec\n"
                                                                 "uint32 nanosec\n");
  }

  void definition_agents_isThatOfHunav() {
    const std::string text = hunav_msgs::Agents::kDefinition;
    const std::string beginning =
        "std_msgs/Header header\n"
        "hunav_msgs/Agent[] agents\n" +
        kLine +
        "MSG: std_msgs/Header\n"
        "builtin_interfaces/Time stamp\n"
        "string frame_id\n" +
        kLine +
        "MSG: builtin_interfaces/Time\n"
        "int32 sec\n"
        "uint32 nanosec\n" +
        kLine +
        "MSG: hunav_msgs/Agent\n"
        "uint8 PERSON=1\n"
        "uint8 ROBOT=2\n"
        "uint8 OTHER=3\n"
        "int32 id\n"
        "uint8 type\n"
        "uint8 skin\n"
        "string name\n"
        "int8 group_id\n"
        "geometry_msgs/Pose position\n"
        "float32 yaw\n"
        "geometry_msgs/Twist velocity\n"
        "float32 desired_velocity\n"
        "float32 radius\n"
        "float32 linear_vel\n"
        "float32 angular_vel\n"
        "hunav_msgs/AgentBehavior behavior\n"
        "geometry_msgs/Pose[] goals\n"
        "bool cyclic_goals\n"
        "float32 goal_radius\n"
        "geometry_msgs/Point[] closest_obs\n" +
        kLine + "MSG: geometry_msgs/Pose\n";
    QCOMPARE(text.substr(0, beginning.size()), beginning);
    QVERIFY(text.find("uint8 BEH_CONF_RANDOM_UNIFORM=3\nuint8 type\nuint8 state\n") !=
            std::string::npos);
    for (const char* each : {"geometry_msgs/Point\n", "geometry_msgs/Vector3\n"}) {
      const std::string head = std::string("MSG: ") + each;
      QVERIFY(text.find(head) != std::string::npos);
      QCOMPARE(text.find(head), text.rfind(head));
    }
  }

  /// The types of visualization_msgs/msg/Marker as the file of Jazzy has them; ARROW_STRIP came
  /// with it.
  void definition_marker_hasTheConstantsOfJazzy() {
    const std::string text = visualization_msgs::Marker::kDefinition;
    QCOMPARE(text.find("int32 ARROW=0\nint32 CUBE=1\nint32 SPHERE=2\nint32 CYLINDER=3\n"
                       "int32 LINE_STRIP=4\nint32 LINE_LIST=5\nint32 CUBE_LIST=6\n"
                       "int32 SPHERE_LIST=7\nint32 POINTS=8\nint32 TEXT_VIEW_FACING=9\n"
                       "int32 MESH_RESOURCE=10\nint32 TRIANGLE_LIST=11\nint32 ARROW_STRIP=12\n"
                       "int32 ADD=0\nint32 MODIFY=0\nint32 DELETE=2\nint32 DELETEALL=3\n"),
             std::size_t{0});
  }

  void definition_boundsAndArrays_areWritten() {
    const std::string text = rmw_dds_common::IronNodeEntitiesInfo::kDefinition;
    QVERIFY(text.find("string<=256 node_namespace\n") == 0);
    QVERIFY(text.find("uint8[16] data\n") != std::string::npos);
    QVERIFY(std::string(rcl_interfaces::ParameterDescriptor::kDefinition)
                .find("rcl_interfaces/IntegerRange[<=1] integer_range\n") != std::string::npos);
    QVERIFY(std::string(rcl_interfaces::ParameterValue::kDefinition)
                .find("byte[] byte_array_value\n") != std::string::npos);
  }

  void typeNames_areThoseOfDds() {
    QCOMPARE(ddsTypeName("geometry_msgs/msg/Twist"),
             std::string("geometry_msgs::msg::dds_::Twist_"));
    QCOMPARE(ddsTypeName(hunav_msgs::ComputeAgents::Request::kType),
             std::string("hunav_msgs::srv::dds_::ComputeAgents_Request_"));
    QCOMPARE(ddsTypeName(nav2_msgs::NavigateToPose::SendGoal::Response::kType),
             std::string("nav2_msgs::action::dds_::NavigateToPose_SendGoal_Response_"));
  }

  void knownTypes_areFoundByName() {
    QVERIFY(knownTypes().size() > 80);
    QVERIFY(findType("hunav_msgs/msg/Agents") != nullptr);
    QVERIFY(findType("hunav_msgs/Agents") == nullptr);
    std::set<std::string_view> names;
    for (const KnownType& each : knownTypes()) {
      QVERIFY2(names.insert(each.type).second, std::string(each.type).c_str());
    }
  }

  void generator_wrongDefinition_isNamed_data() {
    QTest::addColumn<QByteArray>("definition");
    QTest::addColumn<QByteArray>("problem");
    QTest::newRow("type") << QByteArray("flaot32 x\n") << QByteArray("unknown type: flaot32 x");
    QTest::newRow("line") << QByteArray("float32\n")
                          << QByteArray("neither field nor constant: float32");
  }
  void generator_wrongDefinition_isNamed() {
    QFETCH(const QByteArray, definition);
    QFETCH(const QByteArray, problem);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("definitions.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly) &&
            file.write("=== test_msgs/msg/A\n" + definition) > 0);
    file.close();
    QProcess generator;
    generator.start(QStringLiteral("python3"),
                    {QStringLiteral(SOURCE_DIR "/app/bridge/messages/generate.py"), file.fileName(),
                     folder.filePath(QStringLiteral("made"))});
    QVERIFY(generator.waitForFinished());
    QCOMPARE(generator.exitCode(), 1);
    const QByteArray told = generator.readAllStandardError();
    QVERIFY2(told.contains("test_msgs/msg/A: " + problem), told.constData());
  }

  void defaults_areThoseOfRos() {
    QCOMPARE(geometry_msgs::TransformStamped{}.transform.rotation.w, 1.0);
    QCOMPARE(hunav_msgs::StartEvaluation::Request{}.experimentTag, std::string("exp_1"));
  }

  void everyType_comesBackAsWritten() { compareSamples(AllMessages{}); }

  /// Foxglove's reader, by our texts and by those of ROS 2 that it comes with.
  void everyType_isReadByOthers() {
    if (!hasPeer(QStringLiteral("@foxglove/rosmsg2-serialization"))) {
      QSKIP("no Foxglove reader here (tests/support/Peers.h)");
    }
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("cases.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        QJsonDocument(QJsonObject{{QStringLiteral("cases"), peerCases(AllMessages{})}}).toJson());
    file.close();
    const PeerAnswer answer = askPeer(QStringLiteral("decode.js"), {file.fileName()});
    QVERIFY2(answer.isFine, answer.output);
    QVERIFY2(answer.output.contains("types, 4"), answer.output);  // 40 or more
    qInfo("%s", answer.output.trimmed().constData());
  }
};

QTEST_APPLESS_MAIN(DefinitionsTest)
#include "tst_Definitions.moc"
