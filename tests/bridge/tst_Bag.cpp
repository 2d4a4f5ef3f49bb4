#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include <sqlite3.h>

#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/bag/BagTrace.h"
#include "app/bridge/bag/McapFormat.h"
#include "app/bridge/bag/RunBagWriter.h"
#include "app/bridge/messages/Codec.h"
#include "app/run/RecordedRun.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "tests/bridge/BagRun.h"
#include "tests/bridge/WrapperBag.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Mutator.h"
#include "tests/support/Peers.h"

using namespace bridge;

namespace {

constexpr double kSeconds = 4.0;

metrics::Evaluation measured(const sim2d::Trace& trace) {
  metrics::Selection selection;
  selection.everyRobot = false;
  const auto evaluation = metrics::evaluate(trace, selection, {});
  return evaluation ? *evaluation : metrics::Evaluation();
}

/// Keys of metrics that differ by more than the tolerance (relative above 1).
std::string different(const metrics::Evaluation& a, const metrics::Evaluation& b,
                      double tolerance) {
  std::string keys;
  for (const metrics::MetricResult& result : a.results) {
    const metrics::MetricResult* const other = b.find(result.info.key);
    const double none = std::numeric_limits<double>::lowest();
    const double x = result.value.value.value_or(none);
    const double y = other != nullptr ? other->value.value.value_or(none) : none;
    const bool isSame = x == y || std::fabs(x - y) <= tolerance * std::max(1.0, std::fabs(x));
    keys += isSame ? "" : result.info.key + " ";
  }
  return keys;
}

/// All messages of a bag as a database of rosbag2.
void writeDatabase(Bag& bag, const std::string& path) {
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  sqlite3_exec(database,
               "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT,"
               " serialization_format TEXT, offered_qos_profiles TEXT);"
               "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER,"
               " timestamp INTEGER, data BLOB); BEGIN",
               nullptr, nullptr, nullptr);
  for (std::size_t k = 0; k < bag.channels().size(); ++k) {
    const std::string row = "INSERT INTO topics VALUES(" + std::to_string(k + 1) + ",'" +
                            bag.channels()[k].topic + "','" + bag.channels()[k].type +
                            "','cdr','')";
    sqlite3_exec(database, row.c_str(), nullptr, nullptr, nullptr);
  }
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?,?,?)", -1,
                     &insert, nullptr);
  const std::vector<bool> all(bag.channels().size(), true);
  bag.read(all, [&](std::size_t channel, std::int64_t time, std::string_view bytes) {
    sqlite3_bind_int64(insert, 1, static_cast<sqlite3_int64>(channel + 1));
    sqlite3_bind_int64(insert, 2, time);
    sqlite3_bind_blob(insert, 3, bytes.data(), static_cast<int>(bytes.size()), nullptr);
    sqlite3_step(insert);
    sqlite3_reset(insert);
  });
  sqlite3_finalize(insert);
  sqlite3_exec(database, "COMMIT", nullptr, nullptr, nullptr);
  sqlite3_close(database);
}

std::size_t messagesIn(Bag& bag, base::Diagnostics* told = nullptr) {
  std::size_t count = 0;
  const std::vector<bool> all(bag.channels().size(), true);
  const base::Diagnostics problems = bag.read(
      all,
      [&](std::size_t /*channel*/, std::int64_t /*time*/, std::string_view /*bytes*/) { ++count; });
  if (told != nullptr) {
    *told = problems;
  }
  return count;
}

/// Places on /goal_pose.
std::vector<double> goalsIn(const std::string& file) {
  base::Result<std::unique_ptr<Bag>> bag = openBag(file);
  std::vector<double> places;
  std::vector<bool> wanted;
  for (const BagChannel& channel : (*bag)->channels()) {
    wanted.push_back(channel.topic == "/goal_pose");
  }
  (*bag)->read(wanted, [&](std::size_t, std::int64_t, std::string_view bytes) {
    places.push_back(decode<geometry_msgs::PoseStamped>(bytes)->pose.position.x);
  });
  return places;
}

}  // namespace

class BagTest : public QObject {
  Q_OBJECT

 private:
  std::string path(const char* name) const {
    return folder_.filePath(QString::fromUtf8(name)).toStdString();
  }
  std::string bagFile() const { return path("run/bag/bag_0.mcap"); }
  std::string bytes(const std::string& file) const {
    const base::Result<std::string> text = base::readTextFile(file);
    return text ? *text : std::string();
  }
  std::string written(const char* name, const std::string& content) const {
    base::writeFileAtomically(path(name), content);
    return path(name);
  }

  QTemporaryDir folder_;

  std::string made(const char* name, const std::string& sql) {
    sqlite3* database = nullptr;
    sqlite3_open(path(name).c_str(), &database);
    sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
    sqlite3_close(database);
    return path(name);
  }

 private Q_SLOTS:
  void initTestCase() {
    const base::Diagnostics problems = runCafeInto(path("run"), kSeconds);
    QVERIFY2(problems.empty(), textsOf(problems).c_str());
  }

  void crc32_isThatOfZlib() {
    QCOMPARE(crc32("123456789"), 0xCBF43926U);  // the check value of the catalogue of CRCs
    QCOMPARE(crc32(""), 0U);
    QCOMPARE(crc32("6789", crc32("12345")), 0xCBF43926U);
  }

  void run_bag_isListedInTheManifest() {
    const std::string manifest = bytes(path("run/manifest.json"));
    for (const char* name : kBagFiles) {
      QVERIFY2(manifest.find(name) != std::string::npos, name);
      QVERIFY2(std::filesystem::exists(path("run/") + name), name);
    }
    QVERIFY(QJsonDocument::fromJson(
                QByteArray::fromStdString(bytes(path("run/bag/foxglove_layout.json"))))
                .isObject());
  }

  void run_metadata_isThatOfRosbag2() {
    base::Diagnostics problems;
    const base::YamlNode root =
        base::parseYaml(bytes(path("run/bag/metadata.yaml")), "metadata.yaml", problems);
    QVERIFY2(problems.empty(), textsOf(problems).c_str());
    const base::YamlNode& info = *root.find("rosbag2_bagfile_information");
    QCOMPARE(info.find("version")->text, std::string("5"));
    QCOMPARE(info.find("storage_identifier")->text, std::string("mcap"));
    QCOMPARE(info.find("duration")->find("nanoseconds")->text, std::string("4000000000"));
    QCOMPARE(info.find("relative_file_paths")->items.front().text, std::string("bag_0.mcap"));
    for (const base::YamlNode& topic : info.find("topics_with_message_count")->items) {
      const base::YamlNode& told = *topic.find("topic_metadata");
      const bool isMap = told.find("name")->text == "/map";
      const std::string qos = told.find("offered_qos_profiles")->text;
      if (isMap || told.find("name")->text == "/human_states") {
        QCOMPARE(topic.find("message_count")->text, std::string(isMap ? "1" : "81"));
        QVERIFY(qos.find(isMap ? "durability: 1\n" : "durability: 2\n") != std::string::npos);
      }
      QVERIFY(told.find("name")->text != "/clock");
    }
  }

  void run_bag_isReadByOthers() {
    if (!hasPeer(QStringLiteral("@mcap/nodejs")) || !hasPeer(QStringLiteral("fzstd"))) {
      QSKIP("no reader of MCAP here (tests/support/Peers.h)");
    }
    const PeerAnswer answer =
        askPeer(QStringLiteral("read_mcap.js"), {QString::fromStdString(bagFile())});
    QVERIFY2(answer.isFine, answer.output);
    const QJsonObject told = QJsonDocument::fromJson(answer.output).object();
    QCOMPARE(told.value(QStringLiteral("profile")).toString(), QStringLiteral("ros2"));
    QCOMPARE(told.value(QStringLiteral("end")).toString(), QStringLiteral("4000000000"));
    QCOMPARE(told.value(QStringLiteral("secondHalfOfTf")).toInt(), 41);  // 2.00 s to 4.00 s
    const QJsonObject topics = told.value(QStringLiteral("topics")).toObject();
    const auto countOf = [&](const char* name) {
      return topics.value(QLatin1String(name)).toObject().value(QStringLiteral("count")).toInt();
    };
    QCOMPARE(countOf("/human_states"), 81);
    QCOMPARE(countOf("/robot_states"), 81);
    QCOMPARE(countOf("/map"), 1);
    QVERIFY(countOf("/scan") >= 39 && countOf("/scan") <= 41);  // 10 Hz
    // Where everybody was is what the run's own table says.
    std::map<std::pair<double, int>, std::pair<double, double>> places;
    for (const std::string& row : base::split(bytes(path("run/trajectory.csv")), '\n')) {
      const std::vector<std::string> fields = base::split(row, ',');
      if (fields.size() > 6 && base::parseDouble(fields[1])) {
        const double time = std::round(*base::parseDouble(fields[1]) * 1e9);
        places[{time, static_cast<int>(*base::parseInt(fields[2]))}] = {
            *base::parseDouble(fields[4]), *base::parseDouble(fields[5])};
      }
    }
    const QJsonArray way = told.value(QStringLiteral("way")).toArray();
    QCOMPARE(static_cast<std::size_t>(way.size()), places.size());
    for (const QJsonValue& each : way) {
      const QJsonArray row = each.toArray();
      const auto place = places.find({row[0].toString().toDouble(), row[1].toInt()});
      QVERIFY(place != places.end());
      QCOMPARE(row[2].toDouble(), place->second.first);
      QCOMPARE(row[3].toDouble(), place->second.second);
    }
  }

  /// Only headings go through a quaternion: what is left of them is 1e-15.
  void evaluate_bagOfOurs_isAsTheRun() {
    const base::Result<sim2d::Trace> run = app::readRun(path("run"));
    QVERIFY(static_cast<bool>(run));
    for (const std::string& source : {path("run/bag"), bagFile()}) {
      const base::Result<sim2d::Trace> bag = readBagTrace(source, {}, {});
      QVERIFY2(static_cast<bool>(bag), textsOf(bag.diagnostics()).c_str());
      QVERIFY2(bag.diagnostics().empty(), textsOf(bag.diagnostics()).c_str());
      QCOMPARE(bag->frames.size(), run->frames.size());
      QVERIFY(bag->header == run->header);
      QCOMPARE(bag->events.size(), run->events.size());
      QVERIFY(bag->frames[40].humans.x == run->frames[40].humans.x);
      QVERIFY(bag->frames[40].humans.goal == run->frames[40].humans.goal);
      const std::string keys = different(measured(*run), measured(*bag), 1e-9);
      QVERIFY2(keys.empty(), keys.c_str());
    }
  }

  /// By its messages alone: radii and desired speeds are floats there (1e-6), events are not there.
  void evaluate_byTopics_isAsTheRun() {
    const base::Result<sim2d::Trace> run = app::readRun(path("run"));
    QVERIFY(static_cast<bool>(run));
    const metrics::Evaluation wanted = measured(*run);
    for (const char* robot : {"/robot_states", "/odom", "/tf"}) {
      const base::Result<sim2d::Trace> bag =
          readBagTrace(path("run/bag"), {"/human_states", robot, "/map"}, {});
      QVERIFY2(static_cast<bool>(bag), textsOf(bag.diagnostics()).c_str());
      QCOMPARE(bag->frames.size(), run->frames.size());
      const metrics::Evaluation got = measured(*bag);
      const metrics::MetricResult* const length = got.find("path_length");
      QVERIFY(length != nullptr && length->value.value && *length->value.value > 0.5);
      QVERIFY(std::fabs(*length->value.value - *wanted.find("path_length")->value.value) < 1e-6);
      const double near = *wanted.find("minimum_distance_to_people")->value.value;
      QVERIFY(std::fabs(*got.find("minimum_distance_to_people")->value.value - near) < 1e-6);
      QCOMPARE(bag->header.humans.size(), run->header.humans.size());
      QCOMPARE(bag->header.humans.front().name, run->header.humans.front().name);
      QCOMPARE(bag->header.humans.front().radius, run->header.humans.front().radius);
      QVERIFY(bag->header.map == run->header.map);
    }
    const base::Result<sim2d::Trace> people =
        readBagTrace(path("run/bag"), {"/people", "", ""}, {});
    QVERIFY2(static_cast<bool>(people), textsOf(people.diagnostics()).c_str());
    QVERIFY(std::fabs(people->frames[40].humans.x[0] - run->frames[40].humans.x[0]) < 1e-9);
  }

  void render_recordedRun_isABagToo() {
    const base::Result<app::RecordedRun> run = app::readRecordedRun(path("run"));
    QVERIFY(static_cast<bool>(run));
    QVERIFY(writeRunBag(path("again.mcap"), *run->recording).empty());
    const base::Result<sim2d::Trace> bag = readBagTrace(path("again.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(bag), textsOf(bag.diagnostics()).c_str());
    const base::Result<sim2d::Trace> wanted = app::readRun(path("run"));
    const std::string keys = different(measured(*wanted), measured(*bag), 1e-9);
    QVERIFY2(keys.empty(), keys.c_str());
  }

  /// At a step whose state is not recorded.
  void run_robotIsOrdered_theBagsTellIt() {
    app::RunSpec options;
    options.recordEvery = 4;
    const std::string folder = path("ordered");
    QVERIFY(runCafeInto(folder, 2.0, options, [](const sim2d::Frame& frame) {
              sim2d::Input order;
              order.kind = sim2d::InputKind::Goal;
              order.id = -1;
              order.pose.position = {7.8, 0.9};
              return frame.step == 9 ? sim2d::StepInputs{order} : sim2d::StepInputs{};
            }).empty());
    const std::vector<double> goals = goalsIn(folder + "/bag/bag_0.mcap");
    QCOMPARE(goals.size(), std::size_t{2});
    QVERIFY(goals[0] != goals[1]);
    QCOMPARE(goals[1], 7.8);
    const base::Result<app::RecordedRun> run = app::readRecordedRun(folder);
    QVERIFY(static_cast<bool>(run));
    QVERIFY(writeRunBag(path("rendered.mcap"), *run->recording).empty());
    QCOMPARE(goalsIn(path("rendered.mcap")), goals);
  }

  void open_database_hasTheSameMessages() {
    base::Result<std::unique_ptr<Bag>> mcap = openBag(bagFile());
    QVERIFY(static_cast<bool>(mcap));
    writeDatabase(**mcap, path("bag_0.db3"));
    base::Result<std::unique_ptr<Bag>> database = openBag(path("bag_0.db3"));
    QVERIFY2(static_cast<bool>(database), textsOf(database.diagnostics()).c_str());
    QCOMPARE(messagesIn(**database), messagesIn(**mcap));
    const base::Result<sim2d::Trace> run = app::readRun(path("run"));
    const base::Result<sim2d::Trace> trace = readBagTrace(path("bag_0.db3"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    QCOMPARE(trace->frames.size(), run->frames.size());
    QVERIFY(std::fabs(trace->frames[40].robots.x[0] - run->frames[40].robots.x[0]) < 1e-12);
    QVERIFY(!openBag(written("no.db3", "SQLite format 3 and nothing else")));
  }

  /// 900 sums per message.
  void read_expensiveColumns_ends() {
    std::string sum = "id";
    for (int k = 0; k < 900; ++k) {
      sum += " + id";
    }
    base::Result<std::unique_ptr<Bag>> bag = openBag(made(
        "steps.db3",
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format "
        "TEXT); INSERT INTO topics VALUES(1, '/people', 't', 'cdr');"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data "
        "AS "
        "(" +
            sum +
            ")); WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n LIMIT 40000)"
            " INSERT INTO messages SELECT x, 1, x FROM n;"));
    QVERIFY(static_cast<bool>(bag));
    base::Diagnostics told;
    messagesIn(**bag, &told);
    QCOMPARE(codesOf(told), std::string("bag.bad-database"));
  }

  /// A view may be a query without an end.
  void open_databaseOfViews_isRefused() {
    const char* const endless = "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n)";
    const std::string topics =
        made("topics.db3", std::string("CREATE VIEW topics AS ") + endless +
                               " SELECT x AS id, '/t' AS name, 't' AS type, 'cdr' AS"
                               " serialization_format FROM n;"
                               "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER,"
                               " timestamp INTEGER, data BLOB)");
    QCOMPARE(codesOf(openBag(topics).diagnostics()), std::string("bag.bad-database"));
    const std::string messages =
        made("messages.db3",
             std::string("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT,"
                         " serialization_format TEXT);"
                         "INSERT INTO topics VALUES(1, '/people', 't', 'cdr');"
                         "CREATE VIEW messages AS ") +
                 endless + " SELECT x AS id, 1 AS topic_id, x AS timestamp, 'x' AS data FROM n");
    base::Result<std::unique_ptr<Bag>> bag = openBag(messages);
    QVERIFY(static_cast<bool>(bag));
    base::Diagnostics told;
    QCOMPARE(messagesIn(**bag, &told), std::size_t{0});
    QCOMPARE(codesOf(told), std::string("bag.bad-database"));
  }

  void open_cutFile_hasWhatIsWhole() {
    const std::string whole = bytes(bagFile());
    const std::string cut = written("cut.mcap", whole.substr(0, whole.size() * 2 / 3));
    base::Result<std::unique_ptr<Bag>> bag = openBag(cut);
    QVERIFY2(static_cast<bool>(bag), textsOf(bag.diagnostics()).c_str());
    QCOMPARE(codesOf(bag.diagnostics()), std::string("bag.cut"));
    const std::size_t count = messagesIn(**bag);
    base::Result<std::unique_ptr<Bag>> all = openBag(bagFile());
    QVERIFY(count > 100 && count < messagesIn(**all));  // also those of the chunk that is cut
    const base::Result<sim2d::Trace> trace = readBagTrace(cut, {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    QVERIFY(codesOf(trace.diagnostics()).find("bag.cut") != std::string::npos);
    // Without its summary alone nothing is lost.
    const std::string noMagic = written("open.mcap", whole.substr(0, whole.size() - 8));
    base::Result<std::unique_ptr<Bag>> scanned = openBag(noMagic);
    QVERIFY(static_cast<bool>(scanned) && scanned.diagnostics().empty());
    QCOMPARE(messagesIn(**scanned), messagesIn(**all));
  }

  void open_damagedChunk_isLeftOut() {
    std::string damaged = bytes(bagFile());
    damaged[200] = static_cast<char>(damaged[200] ^ 0x55);  // in the first chunk
    base::Result<std::unique_ptr<Bag>> bag = openBag(written("damaged.mcap", damaged));
    QVERIFY(static_cast<bool>(bag));
    base::Diagnostics told;
    messagesIn(**bag, &told);
    QCOMPARE(codesOf(told), std::string("bag.damaged"));
  }

  /// A chunk of 1 MiB of nothing is some hundred bytes; of 4300 of them the last are not unpacked.
  void open_chunksThatUnpackWithoutEnd_areRefused() {
    const std::unique_ptr<BagWriter> writer = makeMcapWriter(path("bomb.mcap"));
    const std::uint16_t channel = writer->addChannel({"/people", "t", "", {}});
    writer->write(channel, 1, std::string(std::size_t{1} << 20U, '\0'));
    QVERIFY(writer->finish().empty());
    const std::string whole = bytes(path("bomb.mcap"));
    std::string_view rest = std::string_view(whole).substr(kMcapMagic.size());
    std::string beginning;
    std::string chunk;
    McapRecordView piece;
    for (std::string_view before = rest; chunk.empty() && nextRecord(rest, piece); before = rest) {
      (piece.op == McapOp::Chunk ? chunk : beginning) +=
          before.substr(0, before.size() - rest.size());
    }
    QVERIFY(!chunk.empty() && chunk.size() < 500);
    std::string bomb = std::string(kMcapMagic) + beginning;
    for (int k = 0; k < 4300; ++k) {
      bomb += chunk;
    }
    QCOMPARE(codesOf(openBag(written("bombs.mcap", bomb)).diagnostics()),
             std::string("bag.unpacked"));
  }

  void open_chunksNamedTwice_areReadOnce() {
    std::string whole = bytes(bagFile());
    const std::size_t footer = whole.size() - kMcapMagic.size() - kRecordHeaderSize - 20;
    McapFields fields(std::string_view(whole).substr(footer + kRecordHeaderSize));
    const auto begin = static_cast<std::size_t>(fields.number<std::uint64_t>());
    std::string_view rest = std::string_view(whole).substr(begin, footer - begin);
    std::string indexes;
    McapRecordView piece;
    for (std::string_view before = rest; nextRecord(rest, piece); before = rest) {
      if (piece.op == McapOp::ChunkIndex) {
        indexes += before.substr(0, before.size() - rest.size());
      }
    }
    QVERIFY(!indexes.empty());
    whole.insert(footer, indexes);
    std::fill(whole.end() - 12, whole.end() - 8, '\0');  // no checksum of the summary
    base::Result<std::unique_ptr<Bag>> bag = openBag(written("twice.mcap", whole));
    base::Result<std::unique_ptr<Bag>> plain = openBag(bagFile());
    QVERIFY(bag && plain);
    QCOMPARE(messagesIn(**bag), messagesIn(**plain));
  }

  void open_mutatedFiles_neverCrash() {
    Mutator mutator(11);
    const std::string whole = bytes(bagFile());
    // Head, a piece of the first chunk, the summary: small, so that each wound meets something.
    const std::string small = whole.substr(0, 4000) + whole.substr(whole.size() - 20000);
    for (int k = 0; k < 300; ++k) {
      const std::string file =
          written("mutated.mcap", mutator.mutated(k % 2 == 0 ? small : whole.substr(0, 60000)));
      base::Result<std::unique_ptr<Bag>> bag = openBag(file);
      if (bag) {
        messagesIn(**bag);
      }
      static_cast<void>(readBagTrace(file, {}, {}));
    }
  }

  /// As a wrapper of HuNavSim is recorded: stamps of a clock, a robot that comes later, no
  /// metadata.
  void evaluate_recordingOfAWrapper_keepsItsDigits() {
    constexpr std::int64_t kBegin = 1700000000;  // [s]
    wrapper::Wrapper recording(path("wrapper.mcap"));
    for (int k = 0; k < 20; ++k) {
      hunav_msgs::Agents all;
      all.header.stamp = {static_cast<std::int32_t>(kBegin + k / 10),
                          static_cast<std::uint32_t>(k % 10) * 100000000U};
      hunav_msgs::Agent anna;
      anna.id = 3;
      anna.name = "anna";
      anna.radius = 0.3F;
      anna.position.position.x = 0.1 * k;
      anna.yaw = 0.5F;  // the quaternion is not filled
      anna.velocity.linear.x = 1.0;
      all.agents = {anna};
      hunav_msgs::Agent robot;  // until it is there: id 0, no name
      robot.id = k < 3 ? 0 : 20;
      robot.name = k < 3 ? "" : "rob";
      robot.position.position.y = 0.2 * k;
      robot.goals = {{{5.0, 5.0, 0.0}, {}}};
      robot.goalRadius = 0.5F;
      const std::int64_t recorded = (kBegin + 3) * 1000000000 + k * 100000000;
      recording.writeAt(recorded, "/human_states", all);
      recording.writeAt(recorded + 2000, "/robot_states", robot);
    }
    QVERIFY(recording.finish());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("wrapper.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    QVERIFY2(trace.diagnostics().empty(), textsOf(trace.diagnostics()).c_str());
    QCOMPARE(trace->frames.size(), std::size_t{17});  // the time of the robot
    QVERIFY(std::fabs(trace->header.dt - 0.1) < 1e-9);
    const sim2d::Frame& frame = trace->frames[7];  // the tenth message
    QVERIFY(std::fabs(frame.humans.x[0] - 1.0) < 1e-9);
    QCOMPARE(frame.humans.heading[0], 0.5);
    QVERIFY(std::fabs(frame.robots.y[0] - 2.0) < 1e-9);
    QCOMPARE(trace->header.humans.front().radius, 0.3);
    QCOMPARE(trace->header.robots.front().name, std::string("rob"));
    QCOMPARE(trace->header.robots.front().goals.front().radius, 0.5);
  }

  /// A publisher that never fills its stamps: one place is left of many, and that is told.
  void evaluate_stampsThatStand_areTold() {
    wrapper::Wrapper recording(path("stamps.mcap"));
    for (int k = 0; k < 20; ++k) {
      hunav_msgs::Agents all;
      all.agents.emplace_back().id = 1;
      all.agents.back().position.position.x = 0.1 * (k / 2);  // each place twice
      recording.write("/human_states", k, all);
    }
    QVERIFY(recording.finish());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("stamps.mcap"), {}, {});
    QCOMPARE(codesOf(trace.diagnostics()), std::string("bag.same-stamp"));
    QVERIFY(textsOf(trace.diagnostics()).find("18 positions") != std::string::npos);
  }

  /// The robot of such a recording gets a number that nobody has.
  void evaluate_greatestId_isRead() {
    wrapper::Wrapper recording(path("ids.mcap"));
    for (int k = 0; k < 10; ++k) {
      hunav_msgs::Agents all;
      all.header.stamp = wrapper::stampOfSample(k);
      all.agents.resize(2);
      all.agents[0].id = std::numeric_limits<std::int32_t>::max();
      all.agents[0].position.position.x = 0.1 * k;
      hunav_msgs::Agent robot;
      robot.position.position.y = 1.0 + 0.1 * k;
      recording.write("/human_states", k, all);
      recording.write("/robot_states", k, robot);
    }
    QVERIFY(recording.finish());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("ids.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    QCOMPARE(trace->header.humans.size(), std::size_t{2});
    QCOMPARE(trace->frames.back().humans.id.back(), std::numeric_limits<std::int32_t>::max());
    QCOMPARE(trace->frames.size(), std::size_t{10});
    QVERIFY(std::fabs(trace->frames.back().robots.y.front() - 1.9) < 1e-9);
  }

  void choice_wrongWords_areToldWithTheNearest() {
    QCOMPARE(codesOf(readBagTrace(bagFile(), {"/human_state", "", ""}, {}).diagnostics()),
             std::string("bag.no-topic"));
    const auto wrong = readBagTrace(bagFile(), {"human_state", "", ""}, {}).diagnostics().front();
    QVERIFY2(wrong.value("nearest").find("/human_states") != std::string::npos,
             wrong.text().c_str());
    QCOMPARE(codesOf(readBagTrace(bagFile(), {"/map", "", ""}, {}).diagnostics()),
             std::string("bag.wrong-type"));
    QCOMPARE(codesOf(parseBagTopicOptions("people=/a,robt=/b").diagnostics()),
             std::string("bag.topic-use"));
    QCOMPARE(parseBagTopicOptions("robot=/odom,people=/p")->robot, std::string("/odom"));
    QVERIFY(!isBag(path("run")));
    QVERIFY(!isBag(path("run/trajectory.csv")));
    QCOMPARE(codesOf(openBag(path("run/trajectory.csv")).diagnostics()), std::string("bag.no-bag"));
  }

  void write_fullDisk_isAnErrorAndLeavesNothing() {
    const base::Result<app::RecordedRun> run = app::readRecordedRun(path("run"));
    QVERIFY(static_cast<bool>(run));
    const support::FullDisk disk(4096);
    const base::Diagnostics problems = writeRunBag(path("full.mcap"), *run->recording);
    QVERIFY(base::hasErrors(problems));
    QVERIFY(!std::filesystem::exists(path("full.mcap")));
  }

  void asWritten_isTheShortDecimal() {
    QCOMPARE(shortestDecimal(0.05F), 0.05);
    QCOMPARE(shortestDecimal(0.35F), 0.35);
    QCOMPARE(shortestDecimal(1.0F), 1.0);
  }
};

QTEST_APPLESS_MAIN(BagTest)
#include "tst_Bag.moc"
