#include <CLI/CLI.hpp>

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "app/cli/CommandRegistry.h"
#include "app/run/Experiment.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/nav/onnx/PolicyNetwork.h"
#include "tests/app/ForkedProgram.h"
#include "tests/app/Nav2Numbers.h"
#include "tests/app/Nav2Yard.h"
#include "tests/app/NumericFields.h"
#include "tests/support/WrittenMap.h"

namespace app {
void addAllCommands(CommandRegistry& to);  // written by CMake
}

using namespace outside;

namespace {

constexpr double kMostSeconds = kIsSanitized ? 200.0 : 10.0;  // of processors
constexpr unsigned kWait = kIsSanitized ? 600 : 100;          // [s] by the clock, on a busy machine
constexpr std::size_t kMostMemory = 2;                        // [GB]

/// A scenario with every planner that needs no other file, every model and behaviour and every
/// shape, in rooms with walls.
constexpr char kScenario[] = R"(hunav_loader:
  ros__parameters:
    yaml_base_name: fields
    simulator: Gazebo Classic
    map: fields_map
    global_goals:
      1: {x: 17.0, y: 2.0}
      2: {x: 2.0, y: 9.0}
    agents: [p1, p2, p3, p4, p5, p6]
    p1: {id: 1, group_id: 1, skin: 0, max_vel: 1.2, radius: 0.3, goal_radius: 0.3,
      init_pose: {x: 3.0, y: 3.0, z: 1.25, h: 0.5}, goals: [1, 2],
      behavior: {type: Regular, configuration: 1, goal_force_factor: 2.0,
        obstacle_force_factor: 10.0, social_force_factor: 5.0, other_force_factor: 20.0}}
    p2: {id: 2, group_id: 1, init_pose: {x: 4.0, y: 3.0, h: 0.5}, goals: [1, 2],
      behavior: {type: Impassive}}
    p3: {id: 3, init_pose: {x: 5.0, y: 4.0, h: 0.0}, goals: [2, 1], behavior: {type: Surprised,
      dist: 8.0}}
    p4: {id: 4, init_pose: {x: 6.0, y: 3.0, h: 0.0}, goals: [2, 1], behavior: {type: Scared,
      dist: 8.0}}
    p5: {id: 5, init_pose: {x: 7.0, y: 3.0, h: 0.0}, goals: [2, 1], behavior: {type: Curious,
      dist: 8.0, stop_dist: 1.0}}
    p6: {id: 6, init_pose: {x: 8.0, y: 3.0, h: 0.0}, goals: [2, 1], behavior: {type: Threatening,
      dist: 8.0, front_dist: 1.0}}
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: fields_map.yaml
    model: sfm
    groups: {1: pair}
    variation: {preset: strong, start: {kind: normal}, heading: {kind: normal},
      start_time: {kind: normal, min: 0.0, max: 0.0}}
    metrics: {from: begin, frequency: 10.0, parameters: {collision_horizon: 2.0}}
    p2: {model: das}
    p3: {model: orca, wait: [0.5, 0.5]}
    p5: {model: das}
    p6: {model: orca}
    robots: [r1, r2, r3, r4, r5, r6, r7, r8, r9]
    r1: {planner: pursuit, start: {x: 3.0, y: 6.0, h: 0.0}, goal: {x: 16.0, y: 6.0},
      detector: {noise: 0.02, misses: 0.01}, odometry_noise: {alpha1: 0.01, alpha3: 0.01},
      localization: {std_x: 0.05, std_y: 0.05, std_yaw: 0.035, jump_rate: 0.1,
        jump_distance: 0.2}, battery: {capacity: 100.0, level: 0.8}}
    r2: {planner: dwa, start: {x: 5.0, y: 6.0, h: 0.0}, goals: [1], lidar: {beams: 180},
      footprint_x: [0.3, -0.3, -0.3, 0.3], footprint_y: [0.2, 0.2, -0.2, -0.2]}
    r3: {planner: mppi, start: {x: 7.0, y: 6.0, h: 0.0}, goal: {x: 2.0, y: 6.0},
      planner_parameters: {samples: 64, time_steps: 20}}
    r4: {planner: social_mppi, start: {x: 9.0, y: 6.0, h: 0.0}, goal: {x: 2.0, y: 8.0},
      planner_parameters: {samples: 64, time_steps: 20}}
    r5: {planner: orca, start: {x: 11.0, y: 6.0, h: 0.0}, goal: {x: 2.0, y: 2.0},
      kinematics: ackermann, turning_radius: 0.8}
    r6: {planner: social_force, start: {x: 13.0, y: 6.0, h: 0.0}, goal: {x: 2.0, y: 4.0},
      kinematics: omnidirectional}
    r7: {planner: dwa, start: {x: 15.0, y: 6.0, h: 3.0}, goal: {x: 9.0, y: 2.0}}
    r8: {planner: straight, start: {x: 17.0, y: 6.0, h: 3.0}, goal: {x: 9.0, y: 3.0}}
    r9: {planner: teleop, start: {x: 5.0, y: 7.2, h: 0.0}}
    obstacles: [box1, pillar1, block1, wall1]
    box1: {kind: box, x: 4.0, y: 8.5, h: 0.3, length: 1.0, width: 0.5}
    pillar1: {kind: circle, x: 6.0, y: 8.5, radius: 0.4}
    block1: {kind: polygon, xs: [8.0, 9.0, 8.5], ys: [8.0, 8.0, 9.0]}
    wall1: {kind: wall, xs: [11.0, 12.0], ys: [8.0, 9.0], thickness: 0.1}
    docks: [dock1]
    dock1: {kind: charging, x: 3.0, y: 8.0, h: 1.0}
    doors: [door1]
    door1: {x1: 14.0, y1: 8.0, x2: 15.0, y2: 8.0, thickness: 0.05, toggles: [0.5]}
    areas: [in1, out1, wait1, exit1, belt1]
    in1: {kind: source, like: p1, rate: 0.5, xs: [14.0, 16.0, 15.0], ys: [2.0, 2.0, 4.0],
      count: 3}
    out1: {kind: sink, xs: [17.0, 18.0, 18.0], ys: [9.0, 9.0, 10.0]}
    wait1: {kind: wait, xs: [1.0, 2.0, 2.0], ys: [1.0, 1.0, 2.0]}
    exit1: {kind: exit, xs: [18.0, 19.0, 19.0], ys: [1.0, 1.0, 2.0]}
    belt1: {kind: speed, factor: 0.8, carry_speed: 0.5, carry_h: 1.0,
      xs: [2.5, 8.5, 8.5, 2.5], ys: [2.5, 2.5, 4.5, 4.5]}
)";

/// Those of other programs and files.
constexpr char kOtherRobots[] =
    "    r10: {planner: replay, planner_parameters: {file: replay.csv}, "
    "start: {x: 7.0, y: 7.2, h: 0.0}, goal: {x: 16.0, y: 7.2}}\n"
    "    r11: {planner: external, command: " TEST_OUTPUT_DIR
    "/planners/follow, start: {x: 9.0, y: 7.2, h: 0.0}, goal: {x: 16.0, y: 7.2}}\n"
    "    r12: {planner: library, planner_parameters: {file: " TEST_OUTPUT_DIR
    "/planners/library.so}, start: {x: 11.0, y: 7.2, h: 0.0}, goal: {x: 16.0, y: 7.2}}\n";
constexpr char kLearnedRobot[] =
    "    r13: {planner: onnx, planner_parameters: {file: " SOURCE_DIR
    "/resources/policies/crossing_policy.onnx}, start: {x: 13.0, y: 7.2, h: 0.0}, "
    "goal: {x: 2.0, y: 7.2}}\n";

/// The scenario with a robot of each planner (of `onnx` where this build has it).
std::string wholeScenario() {
  const bool hasOnnx = !sim2d::policyModuleFile().empty();
  std::string words = std::string(kScenario) + kOtherRobots + (hasOnnx ? kLearnedRobot : "");
  const std::string last = "r8, r9";
  words.insert(words.find(last) + last.size(),
               hasOnnx ? ", r10, r11, r12, r13" : ", r10, r11, r12");
  return words;
}
constexpr char kRunWhole[] = "run fields.yaml -q --duration 1 --allow-code";

constexpr char kExperiment[] = R"(hunavsim_experiment: 1
scenarios: [fields.yaml]
seeds: 2
duration: 0.2
dt: 0.05
stuck_after: 5.0
values:
  r1.mass: [40.0, 60.0]
  p1.max_vel: {range: [1.0, 1.2, 0.2]}
  p2.max_vel: {normal: [1.2, 0.2, 0.6, 1.8]}
  p3.max_vel: {uniform: [0.8, 1.2]}
)";

/// Counts the values and says which of them are tried: usually one in `usual`, with
/// HUNAV_ALL_TESTS one in `ofLong`; with HUNAV_FIELDS all of the fields that it matches.
class Selection {
 public:
  explicit Selection(std::size_t usual, std::size_t ofLong = 1)
      : step_(qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? ofLong : usual),
        only_(qEnvironmentVariable("HUNAV_FIELDS")) {}
  bool takes(const std::string& name) {
    ++number_;
    return only_.pattern().isEmpty() ? number_ % step_ == 0
                                     : only_.match(QString::fromStdString(name)).hasMatch();
  }

 private:
  std::size_t step_;
  std::size_t number_ = 0;
  QRegularExpression only_;
};

base::YamlNode yamlOf(const std::string& words) {
  base::Diagnostics problems;
  base::YamlNode root = base::parseYaml(words, "base.yaml", problems);
  if (!problems.empty()) {
    qFatal("%s", problems.front().text().c_str());
  }
  return root;
}

/// Empty: it ended by itself, in time, with one of these exit codes, and reported the reason of a
/// failure.
QString faultOf(const Ended& ended, const std::vector<int>& codes) {
  if (const QString signal = signalOf(ended); !signal.isEmpty()) {
    return signal + QLatin1Char('\n') + ended.err.left(2000);
  }
  if (ended.seconds > kMostSeconds) {
    return text("took %1 s").arg(ended.seconds);
  }
  const int code = WEXITSTATUS(ended.status);
  if (std::find(codes.begin(), codes.end(), code) == codes.end()) {
    return text("exit code %1\n").arg(code) + ended.err.left(2000);
  }
  if (ended.err.contains(text("not enough memory")) || ended.err.contains(text("json.exception"))) {
    return ended.err.left(2000);
  }
  return code != 0 && ended.err.isEmpty() ? text("exit code %1 without a word").arg(code)
                                          : QString();
}

}  // namespace

/// Every number that users can write: tiny, huge, not a number. The program accepts the value or
/// refuses it with a message; it neither crashes nor hangs. Usually a sample is tested, with
/// HUNAV_ALL_TESTS all of them (two hours of processor time), with HUNAV_FIELDS=EXPRESSION those of
/// the fields whose names it matches.
class NumericFieldsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  Ended run(const QString& words) const {
    return runForked(folder_.path(), words.split(QLatin1Char(' ')), kWait, kMostMemory);
  }
  void write(const char* name, const std::string& content) const {
    writeText(folder_.filePath(text(name)), QByteArray::fromStdString(content));
  }
  QString faultOfScenario(const NumericField& field, const std::string& value) const;
  static std::vector<std::pair<QStringList, QString>> numericOptions();

 private Q_SLOTS:
  void initTestCase();
  void ranges_ofAllTables_haveTwoEnds();
  void scenario_asItIs_runs();
  void scenario_anyNumber_isTakenOrRefused();
  void nav2_anyNumber_isTakenOrRefused();
  void experiment_anyNumber_isTakenOrRefused();
  void commandLine_anyNumber_isTakenOrRefused();
  void given_farTooLarge_isRefusedAtItsPlace_data();
  void given_farTooLarge_isRefusedAtItsPlace();
  void file_farTooLarge_isRefusedAtItsPlace_data();
  void file_farTooLarge_isRefusedAtItsPlace();
};

void NumericFieldsTest::initTestCase() {
  constexpr std::size_t kWidth = 200, kHeight = 110;
  std::vector<std::int8_t> cells(kWidth * kHeight, 0);
  for (std::size_t row = 0; row < kHeight; ++row) {
    for (std::size_t column = 0; column < kWidth; ++column) {
      const bool isBorder = row < 2 || row >= kHeight - 2 || column < 2 || column >= kWidth - 2;
      const bool isWall = row == 50 && column > 40 && column < 90;
      cells[row * kWidth + column] = isBorder || isWall ? 100 : 0;
    }
  }
  const sim2d::OccupancyGrid grid(kWidth, kHeight, 0.1, {}, std::move(cells));
  QVERIFY(!base::hasErrors(
      sim2d::writeMap(grid, folder_.filePath(text("fields_map.yaml")).toStdString())));
  write("fields.yaml", kScenario);
  write("replay.csv", "time,linear,angular\n0.0,0.4,0.1\n0.5,0.2,0.0\n1.0,0.0,0.0\n");
}

void NumericFieldsTest::ranges_ofAllTables_haveTwoEnds() {
  const base::YamlNode root = yamlOf(wholeScenario());
  const NumericFields fields(root);
  QCOMPARE(QString::fromStdString(base::join(fields.unbounded(), ", ")),
           text("PERSON.group_id, PERSON.skin, ROBOT.goals, metrics.run_id"));  // names, no amounts
  QVERIFY(fields.all().size() > 300);
}

void NumericFieldsTest::scenario_asItIs_runs() {
  write("fields.yaml", wholeScenario());
  const Ended checked = run(text("check fields.yaml"));
  QVERIFY2(faultOf(checked, {0}).isEmpty(), qPrintable(faultOf(checked, {0})));
  const Ended ended = run(text(kRunWhole));
  QVERIFY2(faultOf(ended, {0}).isEmpty(), qPrintable(faultOf(ended, {0})));
}

QString NumericFieldsTest::faultOfScenario(const NumericField& field,
                                           const std::string& value) const {
  static const base::YamlNode root = yamlOf(wholeScenario());
  write("fields.yaml", base::emitYaml(withValue(root, field, value)) + "\n");
  const Ended checked = run(text("check fields.yaml"));
  QString fault = faultOf(checked, {0, 2});
  if (!fault.isEmpty()) {
    return text("check: ") + fault;
  }
  const bool isTaken = WEXITSTATUS(checked.status) == 0;
  static const QRegularExpression placed(text("(^|\n)fields.yaml:\\d+:\\d+: error: "));
  if (!isTaken && !checked.err.contains(placed)) {
    return text("refused without a place\n") + checked.err.left(2000);
  }
  const bool isFinite = base::parseDouble(value) && std::isfinite(*base::parseDouble(value));
  if (isTaken && !isFinite) {
    return text("taken, though it is no number");
  }
  fault = faultOf(run(text(kRunWhole)), isTaken ? std::vector<int>{0, 1} : std::vector<int>{2});
  return fault.isEmpty() ? QString() : text("run: ") + fault;
}

void NumericFieldsTest::scenario_anyNumber_isTakenOrRefused() {
  Selection selection(211);  // a prime
  const base::YamlNode root = yamlOf(wholeScenario());
  const NumericFields fields(root);
  QStringList faults;
  for (const NumericField& field : fields.all()) {
    for (const std::string& value : field.values) {
      if (!selection.takes(field.name)) {
        continue;
      }
      const QString fault = faultOfScenario(field, value);
      if (!fault.isEmpty()) {
        faults << QString::fromStdString(field.name + " = " + value + ": ") + fault;
        qWarning("%s", qPrintable(faults.last()));
      }
    }
  }
  write("fields.yaml", kScenario);
  QVERIFY2(faults.isEmpty(), qPrintable(text("%1 faults").arg(faults.size())));
}

/// Each number that Nav2 declares, by itself in a file beside a whole one for its branch. In the
/// long version a third of the values.
void NumericFieldsTest::nav2_anyNumber_isTakenOrRefused() {
  writeNav2Yard(folder_.filePath(text("nav2")));
  Selection selection(997, 3);
  int fields = 0, faults = 0;
  for (const Nav2Number& number : nav2Numbers()) {
    ++fields;
    for (const std::string& value : extremeValues(number.isInteger)) {
      if (!selection.takes(number.name)) {
        continue;
      }
      write("nav2/key.yaml", number.place.fileWith(number.key, value));
      const QString distro = text(number.distro);
      const Ended checked = run(text("check nav2/key.yaml --nav2-distro ") + distro);
      const Ended ended =
          run(text("run nav2/yard.yaml -q --duration 1 --nav2-params nav2/params_%1.yaml "
                   "--nav2-params nav2/key.yaml --nav2-distro %1")
                  .arg(distro));
      QString fault = faultOf(checked, {0, 2}) + faultOf(ended, {0, 1, 2});
      static const QRegularExpression placed(
          text("(^|\n)\\S*nav2/(key|params_\\w+)\\.yaml(:\\d+){0,2}: error: "));
      for (const Ended* each : {&checked, &ended}) {
        const bool isRefused = WIFEXITED(each->status) && WEXITSTATUS(each->status) == 2;
        fault += isRefused && !each->err.contains(placed)
                     ? text("refused without a place\n") + each->err.left(2000)
                     : QString();
      }
      if (!fault.isEmpty()) {
        ++faults;
        qWarning("%s = %s (%s): %s", number.name.c_str(), value.c_str(), number.distro,
                 qPrintable(fault));
      }
    }
  }
  QVERIFY(fields > 400);
  QCOMPARE(faults, 0);
}

/// Each number of the file; a batch is run only for values that give few runs.
void NumericFieldsTest::experiment_anyNumber_isTakenOrRefused() {
  Selection selection(17);
  constexpr std::size_t kMostRuns = 16;
  constexpr double kLongest = 10.0;  // [s]; longer runs take as long as they are asked to
  const base::YamlNode root = yamlOf(kExperiment);
  std::vector<NumericField> fields;
  const std::function<void(const base::YamlNode&, const YamlPath&)> add =
      [&](const base::YamlNode& node, const YamlPath& path) {
        for (std::size_t k = 0; k < node.items.size(); ++k) {
          YamlPath inner = path;
          inner.push_back(node.isMap() ? node.items[k].key : "[" + std::to_string(k) + "]");
          add(node.items[k], inner);
        }
        if (isNumber(node)) {
          fields.push_back({base::join(path, "."),
                            {path},
                            extremeValues(base::parseInt(node.text).has_value())});
        }
      };
  add(root, {});
  QVERIFY(fields.size() >= 15);
  const std::string path = folder_.filePath(text("study.yaml")).toStdString();
  for (const NumericField& field : fields) {
    for (const std::string& value : field.values) {
      if (!selection.takes(field.name)) {
        continue;
      }
      write("study.yaml", base::emitYaml(withValue(root, field, value)) + "\n");
      const Ended checked = run(text("check study.yaml"));
      QString fault = faultOf(checked, {0, 2});
      const base::Result<app::Experiment> experiment = app::readExperiment(path);
      const bool isShort = experiment && experiment->runCount() <= kMostRuns &&
                           experiment->common.duration.value_or(0.0) < kLongest;
      if (fault.isEmpty() && isShort) {
        fault = faultOf(run(text("batch study.yaml -q --force --jobs 1 -o study")), {0, 1, 2});
      }
      QVERIFY2(fault.isEmpty(),
               qPrintable(QString::fromStdString(field.name + " = " + value) + text(": ") + fault));
    }
  }
}

/// Options that take a number, with the arguments that such a command needs.
std::vector<std::pair<QStringList, QString>> NumericFieldsTest::numericOptions() {
  const std::map<std::string, QString> words = {
      {"run", text("run fields.yaml -q --duration 0.5")},
      {"render", text("render made -q -o x.svg --force")},
      {"evaluate", text("evaluate made -q")},
      {"futures", text("futures made@0.3 -q --seeds 1 --horizon 0.3")},
      {"trees", text("trees fields.yaml")},
      {"batch", text("batch study.yaml -q --script slurm -o none")},
  };
  CLI::App root;
  app::CommandRegistry commands(root);
  app::addAllCommands(commands);
  std::vector<std::pair<QStringList, QString>> options;
  for (const auto& [name, begin] : words) {
    for (const CLI::Option* option : root.get_subcommand(name)->get_options()) {
      const std::string type = option->get_type_name();
      const bool isNumber = type.find("INT") == 0 || type.find("UINT") == 0 ||
                            type.find("FLOAT") == 0 || type.find("NUMBER") == 0;
      if (isNumber && !option->get_lnames().empty()) {
        QStringList all = begin.split(QLatin1Char(' '));
        const QString word = text("--") + QString::fromStdString(option->get_lnames().front());
        const int at = all.indexOf(word);
        if (at >= 0) {
          all.removeAt(at + 1);
          all.removeAt(at);
        }
        options.emplace_back(all, word);
      }
    }
  }
  return options;
}

void NumericFieldsTest::commandLine_anyNumber_isTakenOrRefused() {
  Selection selection(41);
  write("study.yaml", kExperiment);
  QVERIFY(faultOf(run(text("run fields.yaml -q --duration 0.5 -o made")), {0}).isEmpty());
  const auto options = numericOptions();
  QVERIFY(options.size() >= 12);
  for (const auto& [words, option] : options) {
    for (const std::string& value : extremeValues(false)) {
      const bool isLong = option == text("--duration") && value == "1000000.0";  // as asked for
      if (isLong || !selection.takes(option.toStdString())) {
        continue;
      }
      const QString word = option + QLatin1Char('=') + QString::fromStdString(value);
      const Ended ended = runForked(folder_.path(), QStringList(words) << word, kWait, kMostMemory);
      const QString fault = faultOf(ended, {0, 1, 2, 64});
      QVERIFY2(fault.isEmpty(), qPrintable(words.join(QLatin1Char(' ')) + QLatin1Char(' ') + word +
                                           text(": ") + fault));
    }
  }
}

void NumericFieldsTest::given_farTooLarge_isRefusedAtItsPlace_data() {
  QTest::addColumn<QString>("robot");
  QTest::addColumn<QString>("told");
  QTest::newRow("mass") << text("{mass: 3.0e+38, start: {x: 0.0, y: 0.0}}")
                        << text("bad.yaml:7:20: error: robot1.mass: 3.0e+38 must be from 0.01 to");
  QTest::newRow("noise") << text("{detector: {noise: 1.0e+155}, start: {x: 0.0, y: 0.0}}")
                         << text("bad.yaml:7:32: error: robot1.detector.noise: 1.0e+155 must be");
  QTest::newRow("planner's")
      << text("{planner_parameters: {lookahead: 1.0e+155}, start: {x: 0.0, y: 0.0}}")
      << text(
             "bad.yaml:7:46: error: robot1.planner_parameters.lookahead: '1.0e+155' is not a "
             "number "
             "from 0.001 to 1e+06 m");
  QTest::newRow("much to do")
      << text("{planner: dwa, max_vel: 100.0, max_acc: 0.01, start: {x: 0.0, y: 0.0}}")
      << text("the robot brakes for 10000 s");
}

void NumericFieldsTest::given_farTooLarge_isRefusedAtItsPlace() {
  QFETCH(QString, robot);
  QFETCH(QString, told);
  write("bad.yaml",
        "hunav_loader: {ros__parameters: {agents: []}}\nhunavsim_desktop:\n  ros__parameters:\n"
        "    format: 1\n    map_file: none\n    robots: [robot1]\n    robot1: " +
            robot.toStdString() + "\n");
  for (const char* words : {"check bad.yaml", "run bad.yaml -q --duration 1"}) {
    const Ended ended = run(text(words));
    QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
    QCOMPARE(WEXITSTATUS(ended.status), 2);
    QVERIFY2(ended.err.contains(told), qPrintable(ended.err));
  }
}

void NumericFieldsTest::file_farTooLarge_isRefusedAtItsPlace_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("told");
  QTest::newRow("mass") << text("mass_far_too_large.yaml")
                        << text(":6:19: error: robot.mass: 3.0e+38 must be from 0.01 to 1e+05");
  QTest::newRow("noise, two robots")
      << text("noise_far_too_large.yaml")
      << text(":7:91: error: r1.detector.noise: 1.0e+155 must be from 0 to 1000");
}

void NumericFieldsTest::file_farTooLarge_isRefusedAtItsPlace() {
  QFETCH(QString, file);
  QFETCH(QString, told);
  write(file.toLatin1().constData(),
        bytesOf(text(TEST_DATA_DIR "/scenario/bad/") + file).toStdString());
  for (const char* words : {"check %1", "run %1 -q --duration 1"}) {
    const Ended ended = run(text(words).arg(file));
    QVERIFY2(signalOf(ended).isEmpty(), qPrintable(signalOf(ended)));
    QCOMPARE(WEXITSTATUS(ended.status), 2);
    QVERIFY2(ended.err.startsWith(file + told), qPrintable(ended.err));
    QCOMPARE(ended.err.count(text("error: ")), 1);
  }
}

QTEST_APPLESS_MAIN(NumericFieldsTest)
#include "tst_NumericFields.moc"
