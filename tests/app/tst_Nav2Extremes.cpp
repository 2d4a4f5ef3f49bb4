#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/ForkedProgram.h"
#include "tests/app/Nav2Yard.h"

using namespace outside;

/// Parameters of Nav2 and navigator trees that ask for too much: refused in a line, or driven in
/// the end. Each row took all memory, never ended or broke a rule of C++ once.
class Nav2ExtremesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  QString at(const char* name) const { return folder_.filePath(text(name)); }

 private Q_SLOTS:
  void initTestCase();
  void value_asFarAsItGoes_endsWithALine_data();
  void value_asFarAsItGoes_endsWithALine();
  void file_ofMasses_isRefused_data();
  void file_ofMasses_isRefused();
  void tree_thatGoesRound_endsWithALine();
  void problem_ofTheParameterFile_namesIt();
  void futures_ofWordsThatDoNotFit_areRefused_data();
  void futures_ofWordsThatDoNotFit_areRefused();
};

namespace {

constexpr unsigned kSeconds = kIsSanitized ? 120 : 30;

/// Three controllers that the shipped files have not.
constexpr char kControllers[] =
    "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
    "    FollowPath: {plugin: \"nav2_graceful_controller::GracefulController\"}\n";

QByteArray paramsOf(const char* distro) {
  return bytesOf(text(TEST_DATA_DIR "/nav2/params_") + text(distro) + text(".yaml"));
}

}  // namespace

void Nav2ExtremesTest::initTestCase() {
  writeNav2Yard(folder_.path());
  writeText(at("params_graceful.yaml"), kControllers);
}

void Nav2ExtremesTest::value_asFarAsItGoes_endsWithALine_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("value");
  QTest::addColumn<QString>("told");  // empty: it is driven
  const auto row = [](const char* file, const char* value, const char* told) {
    QTest::addRow("%s %s", file, value) << text(file) << text(value) << text(told);
  };
  row("humble", "FollowPath.max_vel_x=.nan", "FollowPath.max_vel_x nan: numbers must be finite");
  row("humble", "FollowPath.min_vel_y=.nan", "FollowPath.min_vel_y nan: numbers must be finite");
  row("humble", "FollowPath.acc_lim_x=.inf", "");
  row("humble", "FollowPath.vx_samples=1000000000", "vx_samples 1000000000 with");
  row("humble", "FollowPath.vtheta_samples=1000000000", "vtheta_samples 1000000000 with");
  row("humble", "FollowPath.sim_time=1000.0", "sim_time");
  row("humble", "FollowPath.GoalAlign.forward_point_distance=1e9", "forward_point_distance");
  row("humble", "Foot.simulation_time_step=1e-300", "Foot.simulation_time_step");
  row("humble", "Foot.time_before_collision=1e9", "Foot.time_before_collision");
  row("humble", "Foot.max_points=2147483647", "");
  row("humble", "GridBased.angle_quantization_bins=720", "");
  row("humble", "controller_server.controller_frequency=1e9", "controller_frequency 1e+09");
  row("humble", "controller_server.controller_frequency=1e-300", "");
  row("humble", "smoothing_frequency=1e9", "smoothing_frequency: must be above 0, up to 1000 Hz");
  row("humble", "cycle_frequency=0.0", "cycle_frequency: must be above 0");
  row("humble", "simulate_ahead_time=1e9", "simulate_ahead_time: must be 0 to 100 s");
  row("humble", "backup.deceleration_limit=1.0", "backup.deceleration_limit: must be 0 or less");
  row("jazzy", "goal_checker.xy_goal_tolerance=0.0", "");
  row("jazzy", "goal_checker.xy_goal_tolerance=-1.0", "");
  row("jazzy", "FollowPath.batch_size=1000000000", "batch_size 1e+09 is not 1 to 50000");
  row("jazzy", "FollowPath.time_steps=1000000000", "time_steps 1e+09 is not 2 to 200");
  row("jazzy", "FollowPath.iteration_count=100", "");
  row("jazzy", "FollowPath.iteration_count=1000000", "iteration_count");
  row("jazzy", "local_costmap.resolution=1e-9", "resolution");
  row("jazzy", "local_costmap.width=1000000000", "width");
  row("jazzy", "voxel_layer.scan.observation_persistence=1e9", "observation_persistence");
  row("jazzy", "local_costmap.inflation_layer.cost_scaling_factor=-1.0", "");
  row("jazzy", "local_costmap.inflation_layer.inflation_radius=1e9", "inflation_radius");
  row("jazzy", "voxel_layer.scan.raytrace_max_range=1e9", "");
  row("jazzy", "local_costmap.footprint=\"[[1e9, 1e9], [-1e9, 1e9], [0.0, -1e9]]\"", "");
  row("main", "FollowPath.simulate_ahead_time=1e9", "simulate_ahead_time 1e+09 is not");
  row("main", "FollowPath.max_angular_accel=-1.0", "");
  row("main", "FollowPath.max_allowed_time_to_collision_up_to_carrot=1e9", "");
  row("graceful", "FollowPath.footprint_scaling_step=0.0",
      "footprint_scaling_step 0 is not above 0");
  row("graceful", "FollowPath.footprint_scaling_step=1e-300", "");
}

void Nav2ExtremesTest::value_asFarAsItGoes_endsWithALine() {
  QFETCH(QString, file);
  QFETCH(QString, value);
  QFETCH(QString, told);
  const QString distro = file == text("graceful") ? text("main") : file;
  const Ended ended =
      runForked(folder_.path(),
                {text("run"), text("yard.yaml"), text("-q"), text("--duration"), text("1"),
                 text("--nav2-params"), text("params_%1.yaml").arg(file), text("--nav2-distro"),
                 distro, text("--set"), text("robot1.nav2.") + value},
                kSeconds);
  QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
  const int expected = told.isEmpty() ? 0 : 2;
  QVERIFY2(WEXITSTATUS(ended.status) == expected, qPrintable(ended.err));
  QVERIFY2(ended.err.contains(told), qPrintable(ended.err));
}

void Nav2ExtremesTest::file_ofMasses_isRefused_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("told");
  const auto many = [](int count, const auto& make) {
    QByteArray all;
    for (int k = 0; k < count; ++k) {
      all += make(QByteArray::number(k));
    }
    return all;
  };
  const QByteArray server = "controller_server:\n  ros__parameters:\n";
  QTest::newRow("keys") << server +
                               many(250000,
                                    [](const QByteArray& k) { return "    k" + k + ": 1.0\n"; })
                        << text("more than 5000 parameters");
  QTest::newRow("nodes") << many(600, [](const QByteArray& k) {
    return "n" + k + "/controller_server:\n  ros__parameters:\n" +
           "    controller_frequency: 20.0\n";
  }) << text("more than 500 nodes");
  QTest::newRow("controllers") << server + "    controller_plugins: [" +
                                      many(999,
                                           [](const QByteArray&) { return "\"FollowPath\","; }) +
                                      "]\n"
                               << text("controller_plugins contains 999 names, the limit is 100");
  QTest::newRow("plugins") << server + "    controller_plugins: [" +
                                  many(99999, [](const QByteArray&) { return "\"FollowPath\","; }) +
                                  "]\n"
                           << text("a list of more than 1000");
  QTest::newRow("a long text") << server + "    odom_topic: \"" + QByteArray(200000, 'x') + "\"\n"
                               << text("longer than 100000 characters");
  const QByteArray jazzy = paramsOf("jazzy");
  QByteArray sources = jazzy;
  sources.replace("observation_sources: \"scan\"",
                  "observation_sources: \"" + QByteArray("scan ").repeated(9999) + '"');
  QTest::newRow("sources") << sources
                           << text(
                                  "observation_sources contains 9999 names, the limit "
                                  "is 100");
}

void Nav2ExtremesTest::file_ofMasses_isRefused() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, told);
  writeText(at("masses.yaml"), bytes);
  for (const char* words : {"check masses.yaml", "run yard.yaml -q --nav2-params masses.yaml"}) {
    const Ended ended = runForked(folder_.path(), text(words).split(QLatin1Char(' ')), kSeconds);
    QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
    QCOMPARE(WEXITSTATUS(ended.status), 2);
    const QString said = ended.out + ended.err;
    QVERIFY2(said.contains(told), qPrintable(said.left(2000)));
  }
}

/// Each of five nodes within each other tries 1000 times, and nothing ever waits.
void Nav2ExtremesTest::tree_thatGoesRound_endsWithALine() {
  QByteArray open, close;
  for (int k = 0; k < 5; ++k) {
    open += "<RecoveryNode number_of_retries=\"2147483647\">";
    close.prepend("<AlwaysSuccess/></RecoveryNode>");
  }
  writeText(at("round.xml"), "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" + open +
                                 "<AlwaysFailure/>" + close + "</BehaviorTree></root>");
  const Ended ended =
      runForked(folder_.path(),
                text("run yard.yaml -q --duration 1 --nav2-tree round.xml").split(QLatin1Char(' ')),
                kSeconds);
  QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
  QVERIFY2(ended.err.contains(text("never returns RUNNING")), qPrintable(ended.err));
  QCOMPARE(WEXITSTATUS(ended.status), 1);
}

/// Not the scenario with the line of another file.
void Nav2ExtremesTest::problem_ofTheParameterFile_namesIt() {
  QByteArray bytes = paramsOf("jazzy");
  bytes.replace("batch_size: 200", "batch_size: 0");
  const int line = bytes.left(bytes.indexOf("batch_size: 0")).count('\n') + 1;
  writeText(at("wrong.yaml"), bytes);
  const Ended ended = runForked(
      folder_.path(), text("run yard.yaml -q --nav2-params wrong.yaml").split(QLatin1Char(' ')),
      kSeconds);
  const QString place = text("wrong.yaml:%1:").arg(line);
  QVERIFY2(ended.err.contains(place), qPrintable(ended.err));
  QVERIFY2(!ended.err.contains(text("yard.yaml:%1:").arg(line)), qPrintable(ended.err));
}

void Nav2ExtremesTest::futures_ofWordsThatDoNotFit_areRefused_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<int>("code");
  QTest::newRow("planner") << QStringList{text("--planner"), text("nope")} << 64;
  QTest::newRow("speed") << QStringList{text("--set"), text("*.max_vel=1e308")} << 64;
  QTest::newRow("parameter") << QStringList{text("--set"), text("robot1.nav2.FollowPath.nope=1")}
                             << 64;
}

/// As words of `run` are.
void Nav2ExtremesTest::futures_ofWordsThatDoNotFit_areRefused() {
  QFETCH(QStringList, words);
  QFETCH(int, code);
  const Ended made = runForked(
      folder_.path(), text("run yard.yaml -q --duration 0.5 -o r --force").split(QLatin1Char(' ')),
      kSeconds);
  QVERIFY2(made.status == 0, qPrintable(made.err));
  const Ended ended = runForked(
      folder_.path(), QStringList{text("futures"), text("r@0.2"), text("-q")} + words, kSeconds);
  QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
  QCOMPARE(WEXITSTATUS(ended.status), code);
  QVERIFY2(ended.err.contains(text("error")), qPrintable(ended.err));
}

QTEST_APPLESS_MAIN(Nav2ExtremesTest)
#include "tst_Nav2Extremes.moc"
