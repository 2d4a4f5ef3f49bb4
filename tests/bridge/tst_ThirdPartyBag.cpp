#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include <sqlite3.h>

#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/topics/RunMessages.h"
#include "app/run/RecordedRun.h"
#include "metrics/Report.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/RecordedPoints.h"
#include "tests/bridge/BagRun.h"
#include "tests/bridge/WrapperBag.h"

using namespace bridge;
using namespace wrapper;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

struct Measured {
  base::Result<sim2d::Trace> trace;
  sim2d::RecordedPoints points;
  std::map<std::string, metrics::MetricValue> values;

  double value(const char* key) const {
    const auto found = values.find(key);
    return found == values.end() ? kNan : found->second.value.value_or(kNan);
  }
};

Measured measured(const std::string& bag, metrics::Profile profile = metrics::Profile::Corrected,
                  const BagTopicOptions& use = {}) {
  Measured made{base::error("bag.no-bag"), {}, {}};
  made.trace = readBagTrace(bag, use, {}, &made.points);
  if (!made.trace) {
    return made;
  }
  metrics::MetricParameters parameters;
  parameters.profile = profile;
  const auto evaluation = metrics::evaluate(*made.trace, made.points, {}, parameters);
  for (std::size_t k = 0; evaluation && k < evaluation->results.size(); ++k) {
    made.values[evaluation->results[k].info.key] = evaluation->results[k].value;
  }
  return made;
}

bool isClose(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || a == b ||
         std::fabs(a - b) <= 1e-6 * std::max(1.0, std::fabs(a));
}

/// All messages of a bag, except its metadata and the topics that `isLeft` rejects.
bool copyMessages(const std::string& from, const std::string& to,
                  const std::function<bool(const std::string&)>& isLeft = {}) {
  base::Result<std::unique_ptr<Bag>> bag = openBag(from);
  if (!bag) {
    return false;
  }
  const std::unique_ptr<BagWriter> writer = makeMcapWriter(to);
  std::vector<std::uint16_t> channels;
  std::vector<bool> wanted;
  for (const BagChannel& channel : (*bag)->channels()) {
    channels.push_back(writer->addChannel({channel.topic, channel.type, "", {}}));
    wanted.push_back(!isLeft || isLeft(channel.topic));
  }
  (*bag)->read(wanted, [&](std::size_t channel, std::int64_t time, std::string_view bytes) {
    writer->write(channels[channel], time, bytes);
  });
  return writer->finish().empty();
}

}  // namespace

/// Recordings of other programs: what their messages hold is used.
class ForeignBagTest : public QObject {
  Q_OBJECT

 private:
  std::string path(const char* name) const {
    return folder_.filePath(QString::fromUtf8(name)).toStdString();
  }

  QTemporaryDir folder_;

 private Q_SLOTS:
  /// 10 exp(-(0.5 - r)/0.2) by hand: 10/e = 3.678794 with r = 0.3, 10 exp(-0.75) = 4.723666 with
  /// r = 0.35; of people the mean of each sample, summed over 20.
  void evaluate_closestObs_makesTheForces() {
    QVERIFY(writeWrapper(path("points.mcap")));
    for (const auto profile : {metrics::Profile::Corrected, metrics::Profile::Hunav2}) {
      const Measured bag = measured(path("points.mcap"), profile);
      QVERIFY2(static_cast<bool>(bag.trace), textsOf(bag.trace.diagnostics()).c_str());
      QVERIFY(isClose(bag.value("obstacle_force_on_agents"), kSamples * 3.6787944117));
      QVERIFY(isClose(bag.value("obstacle_force_on_robot"), kSamples * 4.7236655274));
      QVERIFY(isClose(bag.value("clearing_distance_min"), 0.5 - 0.35));
    }
  }

  void evaluate_noPoints_isUndefined() {
    QVERIFY(writeWrapper(path("none.mcap"), [](int, auto& people, auto& robot) {
      robot.closestObs.clear();
      for (hunav_msgs::Agent& agent : people.agents) {
        agent.closestObs.clear();
      }
    }));
    const Measured bag = measured(path("none.mcap"));
    QVERIFY(std::isnan(bag.value("obstacle_force_on_agents")));
    QVERIFY(std::isnan(bag.value("obstacle_force_on_robot")));
  }

  /// The force is proportional to the factor; the profile hunav2 has one for all.
  void evaluate_socialForceFactor_isThatOfTheMessages() {
    const auto forceOf = [&](float factor, metrics::Profile profile) {
      writeWrapper(path("factor.mcap"), [factor](int, auto& people, auto&) {
        for (hunav_msgs::Agent& agent : people.agents) {
          agent.behavior.socialForceFactor = factor;
          agent.behavior.goalForceFactor = 2.0F;
        }
      });
      return measured(path("factor.mcap"), profile).value("social_force_on_agents");
    };
    const double weak = forceOf(5.0F, metrics::Profile::Corrected);
    QVERIFY(weak > 0.0);
    QVERIFY(isClose(forceOf(50.0F, metrics::Profile::Corrected), 10.0 * weak));
    QCOMPARE(forceOf(50.0F, metrics::Profile::Hunav2), forceOf(5.0F, metrics::Profile::Hunav2));
    const Measured bag = measured(path("factor.mcap"));
    const auto& parameters = bag.trace->header.humans.front().parameters;
    QVERIFY(std::find(parameters.begin(), parameters.end(),
                      std::pair<std::string, double>("goal_force_factor", 2.0)) !=
            parameters.end());
  }

  /// Each of an agent's factors is read; of the metrics only forces on people depend on one of
  /// them.
  void evaluate_eachFactor_changesItsMetrics_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("changed");
    QTest::newRow("social") << QStringLiteral("social_force_factor")
                            << QStringLiteral(
                                   "social_force_on_agents social_force_on_agents_mean "
                                   "social_work social_work_mean");
    QTest::newRow("obstacle") << QStringLiteral("obstacle_force_factor") << QString();
    QTest::newRow("goal") << QStringLiteral("goal_force_factor") << QString();
    QTest::newRow("other") << QStringLiteral("other_force_factor") << QString();
  }

  void evaluate_eachFactor_changesItsMetrics() {
    QFETCH(const QString, key);
    QFETCH(const QString, changed);
    const auto* const factor =
        std::find_if(std::begin(kBehaviorParameters), std::end(kBehaviorParameters),
                     [&](const BehaviorParameter& each) { return each.key == key.toStdString(); });
    QVERIFY(factor != std::end(kBehaviorParameters));
    const auto measuredWith = [&](float value) {
      writeWrapper(path("factors.mcap"), [&](int, auto& people, auto&) {
        for (hunav_msgs::Agent& agent : people.agents) {
          agent.behavior.socialForceFactor = 5.0F;
          agent.behavior.goalForceFactor = 2.0F;
          agent.behavior.obstacleForceFactor = 10.0F;
          agent.behavior.otherForceFactor = 20.0F;
          agent.behavior.*factor->member = value;
        }
      });
      return measured(path("factors.mcap"));
    };
    const Measured weak = measuredWith(3.0F);
    const Measured strong = measuredWith(30.0F);
    const std::pair<std::string, double> wanted(key.toStdString(), 30.0);
    for (const sim2d::TraceHuman& human : strong.trace->header.humans) {
      QCOMPARE(std::count(human.parameters.begin(), human.parameters.end(), wanted),
               std::ptrdiff_t{1});
    }
    QStringList different;
    for (const auto& each : weak.values) {
      const char* const metric = each.first.c_str();
      if (!isClose(weak.value(metric), strong.value(metric))) {
        different << QString::fromStdString(each.first);
      }
    }
    QCOMPARE(different.join(QLatin1Char(' ')), changed);
  }

  /// State and group of each message, not of the first alone.
  void read_stateAndGroup_areThoseOfTheSample() {
    QVERIFY(writeWrapper(path("states.mcap"), [](int k, auto& people, auto&) {
      people.agents[1].behavior.state = k >= 10 ? 1 : 0;
      people.agents[2].groupId = k >= 5 ? 4 : -1;
    }));
    const Measured bag = measured(path("states.mcap"));
    QCOMPARE(static_cast<int>(bag.trace->frames[9].humans.state[1]), 0);
    QCOMPARE(static_cast<int>(bag.trace->frames[10].humans.state[1]), 1);
    QCOMPARE(bag.trace->frames[4].humans.group[2], -1);
    QCOMPARE(bag.trace->frames[5].humans.group[2], 4);
  }

  /// people_msgs hold the type of behaviour as a tag of HuNavSim.
  void read_tagsOfPeople_giveTheBehavior() {
    Wrapper wrapper(path("tags.mcap"));
    for (int k = 0; k < kSamples; ++k) {
      people_msgs::People people;
      people.header.stamp = stampOfSample(k);
      people.people.emplace_back().name = "anna";
      people.people.back().tagnames = {"id", "group_id", "behavior"};
      people.people.back().tags = {"7", "2", "4"};
      wrapper.write("/people", k, people);
    }
    QVERIFY(wrapper.finish());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("tags.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    const sim2d::TraceHuman& anna = trace->header.humans.front();
    QCOMPARE(anna.id, 7);
    QCOMPARE(anna.group, 2);
    QCOMPARE(anna.behavior, 4);
    QCOMPARE(anna.radius, 0.35);
    QCOMPARE(anna.desiredSpeed, 1.0);
  }

  void read_goalPose_isTheGoal() {
    Wrapper wrapper(path("goal.mcap"));
    for (int k = 0; k < kSamples; ++k) {
      nav_msgs::Odometry odometry;
      odometry.header.stamp = stampOfSample(k);
      odometry.header.frameId = "map";
      odometry.pose.pose.position.x = 0.1 * k;
      wrapper.write("/odom", k, odometry);
      if (k == 2) {
        geometry_msgs::PoseStamped goal;
        goal.header.frameId = "map";
        goal.pose.position.x = 1.9;
        wrapper.write("/goal_pose", k, goal);
      }
    }
    QVERIFY(wrapper.finish());
    const Measured bag = measured(path("goal.mcap"));
    QVERIFY2(static_cast<bool>(bag.trace), textsOf(bag.trace.diagnostics()).c_str());
    QCOMPARE(bag.trace->header.robots.front().goals.size(), std::size_t{1});
    QCOMPARE(bag.trace->header.robots.front().goals.front().position.x(), 1.9);
    QCOMPARE(bag.value("completed"), 1.0);
  }

  /// Samples with invalid numbers are left out, with one warning per topic and field.
  void read_badNumbers_areLeftOut() {
    QVERIFY(writeWrapper(path("bad.mcap"), [](int k, auto& people, auto& robot) {
      people.agents[0].position.position.x = k == 3 || k == 4 ? kNan : 2.0;
      people.agents[1].velocity.linear.y = k == 5 ? 1e300 : 0.0;
      people.agents[2].radius = k < 2 ? std::numeric_limits<float>::infinity() : 0.3F;
      robot.velocity.angular.z = k == 7 ? -kNan : 0.0;
      robot.closestObs.push_back({kNan, 0.0, 0.0});
    }));
    const Measured bag = measured(path("bad.mcap"));
    QVERIFY2(static_cast<bool>(bag.trace), textsOf(bag.trace.diagnostics()).c_str());
    const std::string told = textsOf(bag.trace.diagnostics());
    QVERIFY2(
        told.find("2 samples of topic /human_states are ignored: position") != std::string::npos,
        told.c_str());
    QVERIFY2(told.find("1 samples of topic /human_states are ignored: velocity.linear") !=
                 std::string::npos,
             told.c_str());
    QVERIFY2(told.find("1 samples of topic /robot_states are ignored: velocity.angular") !=
                 std::string::npos,
             told.c_str());
    QVERIFY2(told.find("2 values of topic /human_states are not used: radius") != std::string::npos,
             told.c_str());
    QVERIFY2(told.find("19 values of topic /robot_states are not used: closest_obs") !=
                 std::string::npos,
             told.c_str());
    QCOMPARE(bag.trace->header.humans[2].radius, 0.3);
    for (const sim2d::Frame& frame : bag.trace->frames) {
      for (const sim2d::BodyColumns* const columns :
           {static_cast<const sim2d::BodyColumns*>(&frame.humans), &frame.robots}) {
        for (std::size_t k = 0; k < columns->size(); ++k) {
          QVERIFY(std::fabs(columns->x[k]) < 100.0 && std::fabs(columns->vy[k]) < 100.0 &&
                  std::fabs(columns->omega[k]) < 100.0);
        }
      }
    }
  }

  /// Messages that a tool has copied, without the metadata: what they hold gives the values of the
  /// run. `kLost` is in no message: where a robot's motion or path begins is.
  void evaluate_copiedBagOfOurs_isAsTheRun() {
    const base::Diagnostics problems = runCafeInto(path("run"), 8.0);
    QVERIFY2(problems.empty(), textsOf(problems).c_str());
    const std::string own = path("run/bag/bag_0.mcap");
    QVERIFY(copyMessages(own, path("copied.mcap")));
    const Measured run = measured(own);
    const Measured copied = measured(path("copied.mcap"));
    QVERIFY2(static_cast<bool>(copied.trace), textsOf(copied.trace.diagnostics()).c_str());
    std::string keys;
    for (const auto& [key, value] : run.values) {
      if (!isClose(run.value(key.c_str()), copied.value(key.c_str()))) {
        keys += key + " " + std::to_string(run.value(key.c_str())) + " " +
                std::to_string(copied.value(key.c_str())) + "\n";
      }
    }
    QVERIFY2(keys.empty(), keys.c_str());
  }

  /// A parked robot has its /goal_pose when it sets off, and that is the start of its way.
  void evaluate_parkedRobot_setsOffWithItsGoal() {
    app::RunSpec options;
    options.set = {"robot1.start_time=1.5"};
    const base::Diagnostics problems = runCafeInto(path("parked"), 4.0, options);
    QVERIFY2(problems.empty(), textsOf(problems).c_str());
    QVERIFY(copyMessages(path("parked/bag/bag_0.mcap"), path("parked.mcap")));
    const Measured run = measured(path("parked/bag/bag_0.mcap"));
    const Measured copied = measured(path("parked.mcap"));
    QVERIFY2(static_cast<bool>(copied.trace), textsOf(copied.trace.diagnostics()).c_str());
    QCOMPARE(copied.trace->header.robots.front().startTime, 1.5);
    for (const char* const key : {"time_not_moving", "avg_robot_linear_speed", "stalled_time"}) {
      QVERIFY2(isClose(run.value(key), copied.value(key)), key);
    }
  }

  /// A part of the time is missing, but the metadata still exists: they do not match.
  void evaluate_cutBagOfOurs_isReadByItsMessages() {
    base::Result<std::unique_ptr<Bag>> bag = openBag(path("run/bag/bag_0.mcap"));
    QVERIFY(static_cast<bool>(bag));
    const std::unique_ptr<BagWriter> writer = makeMcapWriter(path("cut.mcap"));
    std::vector<std::uint16_t> channels;
    for (const BagChannel& channel : (*bag)->channels()) {
      channels.push_back(writer->addChannel({channel.topic, channel.type, "", {}}));
    }
    const std::vector<bool> all(channels.size(), true);
    (*bag)->read(all, [&](std::size_t channel, std::int64_t time, std::string_view bytes) {
      if (time >= 2000000000 || (*bag)->channels()[channel].topic == "/map") {
        writer->write(channels[channel], time, bytes);
      }
    });
    writer->addMetadata(kRunMetadata,
                        {{"trace.json", (*bag)->metadata(kRunMetadata, "trace.json")},
                         {"events.csv", (*bag)->metadata(kRunMetadata, "events.csv")}});
    QVERIFY(writer->finish().empty());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("cut.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    QCOMPARE(codesOf(trace.diagnostics()), std::string("bag.not-as-written"));
    QCOMPARE(trace->frames.size(), std::size_t{121});  // 2 s to 8 s
  }

  void read_otherRobots_areNamed() {
    Wrapper wrapper(path("robots.mcap"));
    for (int k = 0; k < kSamples; ++k) {
      hunav_msgs::Agents people;
      people.header.stamp = stampOfSample(k);
      people.agents = {agentAt(1, 0.3F)};
      wrapper.write("/human_states", k, people);
      wrapper.write("/robot_states", k, agentAt(0, 0.3F));
      wrapper.write("/robot2/robot_states", k, agentAt(2, 0.3F));
    }
    QVERIFY(wrapper.finish());
    const auto several = readBagTrace(path("robots.mcap"), {}, {});
    QCOMPARE(codesOf(several.diagnostics()), std::string("bag.other-robots"));
    QVERIFY(textsOf(several.diagnostics()).find("/robot2/robot_states") != std::string::npos);
    const auto chosen = readBagTrace(path("robots.mcap"), {"", "/robot2/robot_states", ""}, {});
    QVERIFY(chosen.diagnostics().empty());
    QCOMPARE(chosen->frames.front().robots.x.front(), 4.0);
  }

  /// The file that is written beside the record gives the same points.
  void points_textOfThem_readsBack() {
    QVERIFY(writeWrapper(path("points.mcap")));
    const Measured bag = measured(path("points.mcap"));
    const std::string text = bag.points.csv();
    QCOMPARE(text.substr(0, text.find('\n')), std::string("step,id,kind,points"));
    const auto again = sim2d::parseRecordedPoints(text, "p.csv");
    QVERIFY(again && again->hasPeople() && again->hasRobot());
    QCOMPARE(again->csv(), text);
    const sim2d::RecordedPoints::Range points = again->of(3, 2, false);
    QCOMPARE(std::distance(points.begin(), points.end()), std::ptrdiff_t{1});
    QCOMPARE(points.begin()->x(), 4.0);
    const auto bad =
        sim2d::parseRecordedPoints("step,id,kind,points\n0,1,human,1 2 nan 4\n", "p.csv");
    QCOMPARE(codesOf(bad.diagnostics()), std::string("trace.bad-points"));
  }

  void open_compressedMessages_areRefused() {
    std::filesystem::create_directories(path("packed"));
    base::writeFileAtomically(path("packed/metadata.yaml"),
                              "rosbag2_bagfile_information:\n  storage_identifier: sqlite3\n"
                              "  compression_format: zstd\n  compression_mode: MESSAGE\n"
                              "  relative_file_paths: [a.db3]\n");
    QCOMPARE(codesOf(openBag(path("packed")).diagnostics()),
             std::string("bag.compressed-messages"));
  }

  /// Tables as rosbag2 makes them, its metadata, and the metrics of the run.
  void write_database_isThatOfRosbag2() {
    const base::Result<app::RecordedRun> run = app::readRecordedRun(path("run"));
    QVERIFY(static_cast<bool>(run));
    QVERIFY(writeRunBag(path("run.db3"), *run->recording).empty());
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path().toStdString())) {
      QVERIFY(entry.path().string().find(".db3.") == std::string::npos);  // nothing is left beside
    }
    base::Result<std::unique_ptr<Bag>> bag = openBag(path("run.db3"));
    QVERIFY2(static_cast<bool>(bag), textsOf(bag.diagnostics()).c_str());
    QVERIFY(!(*bag)->metadata(kRunMetadata, "trace.json").empty());
    const Measured wanted = measured(path("run/bag/bag_0.mcap"));
    const Measured got = measured(path("run.db3"));
    QVERIFY2(got.trace.diagnostics().empty(), textsOf(got.trace.diagnostics()).c_str());
    for (const auto& [key, value] : wanted.values) {
      QVERIFY2(isClose(wanted.value(key.c_str()), got.value(key.c_str())), key.c_str());
    }
    sqlite3* database = nullptr;
    QCOMPARE(sqlite3_open(path("run.db3").c_str(), &database), SQLITE_OK);
    const auto textOf = [&](const char* sql) {
      sqlite3_stmt* statement = nullptr;
      sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
      std::string text;
      while (sqlite3_step(statement) == SQLITE_ROW) {
        text += reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
        text += " ";
      }
      sqlite3_finalize(statement);
      return text;
    };
    QCOMPARE(textOf("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name"),
             std::string("hunavsim_metadata messages metadata schema topics "));
    QCOMPARE(textOf("SELECT schema_version FROM schema"), std::string("3 "));
    QCOMPARE(textOf("SELECT type FROM topics WHERE name = '/human_states'"),
             std::string("hunav_msgs/msg/Agents "));
    QCOMPARE(textOf("SELECT count(*) FROM messages m JOIN topics t ON m.topic_id = t.id"
                    " WHERE t.name = '/human_states'"),
             std::string("161 "));
    QCOMPARE(textOf("SELECT max(timestamp) FROM messages"), std::string("8000000000 "));
    QVERIFY(textOf("SELECT metadata FROM metadata").find("storage_identifier: sqlite3") !=
            std::string::npos);
    sqlite3_close(database);
  }

  void read_badOdometryAndPeople_areLeftOut() {
    Wrapper wrapper(path("others.mcap"));
    for (int k = 0; k < kSamples; ++k) {
      nav_msgs::Odometry odometry;
      odometry.header.stamp = stampOfSample(k);
      odometry.pose.pose.position.x = k == 4 ? 1e300 : 0.1 * k;
      odometry.twist.twist.linear.x = k == 6 ? kNan : 1.0;
      wrapper.write("/odom", k, odometry);
      people_msgs::People people;
      people.header.stamp = stampOfSample(k);
      people.people.emplace_back().name = "anna";
      people.people.back().velocity.x = k == 8 ? std::numeric_limits<double>::infinity() : 0.0;
      wrapper.write("/people", k, people);
    }
    QVERIFY(wrapper.finish());
    const base::Result<sim2d::Trace> trace = readBagTrace(path("others.mcap"), {}, {});
    QVERIFY2(static_cast<bool>(trace), textsOf(trace.diagnostics()).c_str());
    const std::string told = textsOf(trace.diagnostics());
    for (const char* part : {"/odom are ignored: pose.position", "/odom are ignored: twist.linear",
                             "/people are ignored: velocity"}) {
      QVERIFY2(told.find(part) != std::string::npos, told.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(ForeignBagTest)
#include "tst_ThirdPartyBag.moc"
