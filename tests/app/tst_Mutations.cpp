#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <QCryptographicHash>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>

#include "app/capsule/Archive.h"
#include "app/capsule/CapsuleManifest.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "tests/app/ForkedProgram.h"
#include "tests/app/Nav2Yard.h"
#include "tests/nav/OnnxFile.h"
#include "tests/run/LatticeFile.h"
#include "tests/support/Mutator.h"
#include "tests/support/Sanitizers.h"

using namespace outside;

// Findings of the sanitizers are told apart from what the program says. The names are theirs.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {
  return "exitcode=99:hard_rss_limit_mb=6000";
}
extern "C" const char* __ubsan_default_options() {
  return "print_stacktrace=1";
}
// NOLINTEND(bugprone-reserved-identifier)

/// Files with damage in them, handed to every command that reads such files. Whatever they hold:
/// nothing crashes, hangs or takes all memory, each refusal says what is wrong in words that a
/// terminal can show, and what was read stays as it was.
///
/// With HUNAV_ALL_TESTS they take 20 minutes of a processor, shared by up to four. Others than the
/// usual are made by HUNAV_MUTATIONS="FIRST COUNT".
class MutationsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void damaged_isReadOrRefused();
  void json_otherThanExpected_isRefusedInOurWords_data();
  void json_otherThanExpected_isRefusedInOurWords();
};

namespace {

/// Files that belong together, one of which gets damaged, and what reads them.
struct Kind {
  const char* file;                 // that is damaged
  std::vector<QStringList> usual;   // commands
  std::vector<QStringList> seldom;  // costly ones
};

QStringList words(const char* line) {
  return text(line).split(QLatin1Char(' '));
}

const std::vector<Kind>& kinds() {  // NOLINT(readability-function-size): a table
  static const QStringList kRun = words("run s/two_workers_agents.yaml -q -o o --duration 0.3");
  static const QStringList kCheck = words("check s/two_workers_agents.yaml");
  static const QStringList kWindow =
      words("s/two_workers_agents.yaml --screenshot p.png --size 640x400");
  static const QStringList kEvaluate = words("evaluate r -q -o o");
  static const QStringList kPlay = words("render r -o p.html");
  static const QStringList kReplay = words("r --screenshot p.png --size 640x400 --at 0.5");
  static const QStringList kFutures = words("futures r@0.3 -q --seeds 2 --horizon 0.3 --json");
  static const std::vector<QStringList> kAgain = {
      words("run --from r@0.3 -q --duration 0.6 -o o"),
      words("run --from r@0.3 -q --seed 7 --duration 0.5")};
  static const std::vector<QStringList> kDrawn = {
      words("render r -q -o p.svg --strip 2"), words("render r -q -o p.svg --strip 0.1,0.4"),
      words("render r -q -o p.svg --plot avg_robot_linear_speed"),
      words("render r -q -o p.svg --overlay contacts,density --time-marks 0.2")};
  static const QStringList kHumble = words(
      "run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_humble.yaml --nav2-distro "
      "humble");
  static const QStringList kJazzy =
      words("run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_jazzy.yaml");
  static const QStringList kMain = words(
      "run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_main.yaml --nav2-distro "
      "main");
  static const std::vector<Kind> kKinds = {
      {"s/two_workers_agents.yaml",
       {kRun, kCheck, words("trees s/two_workers_agents.yaml -o o"),
        words("convert s/two_workers_agents.yaml --target isaac -o o"),
        words("check --json s/two_workers_agents.yaml")},
       {kWindow}},
      {"s/corner_cafe_agents.yaml",
       {words("run s/corner_cafe_agents.yaml -q -o o --duration 0.2"),
        words("check s/corner_cafe_agents.yaml"),
        words("convert s/corner_cafe_agents.yaml --target webots -o o")},
       {words("s/corner_cafe_agents.yaml --screenshot p.png --size 640x400")}},
      {"s/two_workers_agents__agent_1_bt.xml",
       {kRun, kCheck, words("check s/two_workers_agents__agent_1_bt.xml"),
        words("trees --play s/two_workers_agents__agent_1_bt.xml --ticks 50")},
       {kWindow}},
      {"s/two_workers.yaml", {kRun, kCheck, words("check s/two_workers.yaml")}, {kWindow}},
      {"s/two_workers.pgm", {kRun, kCheck}, {kWindow}},
      {"m.yaml",
       {words("evaluate r -q -o o --metrics m.yaml"),
        words("run s/two_workers_agents.yaml -q --duration 0.1 --metrics m.yaml")},
       {}},
      {"e.yaml",
       {words("check e.yaml")},
       {words("batch e.yaml --shard 1/1000 --time-limit 5 -q -o o")}},
      {"r/trajectory.csv", {kEvaluate, kPlay}, {kReplay}},
      {"r/events.csv", {kEvaluate, kPlay}, {kReplay}},
      {"r/trace.json", {kEvaluate, kPlay}, {kReplay}},
      {"r/trees.csv", {kPlay}, {kReplay}},
      {"r/manifest.json", {kEvaluate, kPlay, words("run s/two_workers_agents.yaml -q -o r")}, {}},
      {"b/results.csv", {words("report b --no-pdf -q")}, {}},
      {"b/manifest.json", {words("report b --no-pdf -q"), words("merge b -o o")}, {}},
      {"b/results.sqlite", {words("batch e.yaml -q -o b --resume"), words("merge b -o o")}, {}},
      {"t.csv", {words("evaluate t.csv -q -o o")}, {}},
      {"r/trajectory.csv", kAgain, {words("r --screenshot p.png --size 640x400 --at 0.3")}},
      {"r/trace.json", kAgain, {kFutures}},
      {"r/manifest.json", kAgain, {kFutures}},
      {"r/metrics.json", kDrawn, {}},
      {"r/steps.csv", kDrawn, {}},
      {"r/trajectory.csv", kDrawn, {words("render r -q -o p.gif --fps 2 --width 100")}},
      {"n/params_humble.yaml", {kHumble, kHumble, words("check n/params_humble.yaml")}, {}},
      {"n/params_jazzy.yaml", {kJazzy, kJazzy, words("check --json n/params_jazzy.yaml")}, {}},
      {"n/params_main.yaml", {kMain, kMain, words("check n/params_main.yaml")}, {}},
      {"n/tree.xml", {kHumble, kJazzy, words("check n/tree.xml")}, {}},
      {"n/yard.yaml",
       {words("run n/yard.yaml -q -o o --duration 0.6"), words("check n/yard.yaml")},
       {}},
      {"n/study.yaml",
       {words("check n/study.yaml")},
       {words("batch n/study.yaml --shard 1/1000 --time-limit 5 -q -o o")}},
      {"obsmat.txt",
       {words("evaluate obsmat.txt -q -o o"), words("evaluate obsmat.txt --format eth -q -o o")},
       {}},
  };
  return kKinds;
}

QTemporaryDir& corpus() {
  static QTemporaryDir folder;
  return folder;
}

/// Why the end of a command is none that users should see; empty: it is fine.
QString faultOf(const Ended& ended, bool wantsJson) {
  if (QString signal = signalOf(ended); !signal.isEmpty()) {
    return signal;
  }
  const int code = WEXITSTATUS(ended.status);
  if (code > 2) {
    return text("exit code %1").arg(code);
  }
  for (const char* word : {"std::", "not enough memory", "basic_string", "vector::", "::at", "stoi",
                           "json.exception"}) {
    if (ended.err.contains(text(word))) {
      return text("tells of its inside: ") + text(word);
    }
  }
  const bool isJson = !QJsonDocument::fromJson(ended.out.toUtf8()).isNull();
  if (wantsJson && !isJson) {
    return text("writes no JSON");
  }
  if (code == 2 && !(wantsJson ? ended.out : ended.err).contains(text("error"))) {
    return text("refuses without a reason");
  }
  for (const QChar c : ended.err + ended.out) {
    if ((c < QLatin1Char(' ') && c != QLatin1Char('\n') && c != QLatin1Char('\t')) ||
        c == QChar(QChar::ReplacementCharacter)) {
      return text("control character %1 on the terminal").arg(c.unicode());
    }
  }
  return {};
}

/// A damaged file of a run is found out by its checksum: now and then the manifest is not there, or
/// was made by who damaged it.
void adaptManifest(const QString& folder, const char* file, std::size_t way) {
  const QString name = QFileInfo(text(file)).fileName();
  const QString manifest = folder + text("/r/manifest.json");
  if (!text(file).startsWith(text("r/")) || name == text("manifest.json") || way == 0) {
    return;
  }
  if (way == 1) {
    QFile::remove(manifest);
    return;
  }
  QJsonObject whole = QJsonDocument::fromJson(bytesOf(manifest)).object();
  QJsonArray outputs = whole.value(text("outputs")).toArray();
  for (auto&& each : outputs) {
    QJsonObject output = each.toObject();
    if (output.value(text("path")).toString() == name) {
      const QByteArray bytes = bytesOf(folder + text("/r/") + name);
      output.insert(
          text("sha256"),
          QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex()));
      each = output;
    }
  }
  whole.insert(text("outputs"), outputs);
  writeText(manifest, QJsonDocument(whole).toJson());
}

/// Nothing: fine.
QString faultOfMutation(std::uint64_t number) {
  Mutator mutator(number);
  const Kind& kind = kinds()[mutator.pick(kinds().size())];
  const bool isSeldom = !kind.seldom.empty() && mutator.pick(kIsSanitized ? 100 : 25) == 0;
  const std::vector<QStringList>& commands = isSeldom ? kind.seldom : kind.usual;
  const QStringList command = commands[mutator.pick(commands.size())];
  QTemporaryDir place;
  const QString folder = place.filePath(text("w"));
  copyFolder(corpus().path(), folder);
  const QString damaged = folder + QLatin1Char('/') + text(kind.file);
  const std::string whole = bytesOf(damaged).toStdString();
  const bool isByNumbers = mutator.pick(text(kind.file).startsWith(text("n/")) ? 2 : 5) == 0;
  const QByteArray bytes = QByteArray::fromStdString(isByNumbers ? mutator.withOtherNumbers(whole)
                                                                 : mutator.mutated(whole));
  writeText(damaged, bytes);
  adaptManifest(folder, kind.file, mutator.pick(3));
  const Ended ended = runForked(folder, command, kIsSanitized ? 120 : 30);
  QString fault = faultOf(ended, command.contains(text("--json")));
  const bool isOutput = command.contains(text("--resume")) || command.endsWith(text("r"));
  if (fault.isEmpty() && !isOutput && bytesOf(damaged) != bytes) {
    fault = text("what it read has changed");
  }
  if (fault.isEmpty()) {
    return {};
  }
  const QString kept = text(TEST_OUTPUT_DIR "/mutations/%1").arg(number);
  QDir(kept).removeRecursively();
  copyFolder(folder, kept);
  return text("mutation %1 (%2): %3\n  hunavsim %4\n  in %5\n%6")
      .arg(number)
      .arg(text(kind.file), fault, command.join(QLatin1Char(' ')), kept, ended.err.left(1500));
}

/// Of every `step`-th mutation; tells the first faults.
bool standAll(std::uint64_t first, std::uint64_t end, std::uint64_t step) {
  int faults = 0;
  for (std::uint64_t number = first; number < end && faults < 20; number += step) {
    const QString fault = faultOfMutation(number);
    if (!fault.isEmpty()) {
      ++faults;
      qWarning("%s", qPrintable(fault));
    }
  }
  return faults == 0;
}

/// A robot of Nav2 that sets out at once, with all that its files can say.
void writeNav2Study(const QString& folder) {
  writeNav2Yard(folder);
  writeText(folder + text("/study.yaml"),
            "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 1\nduration: 0.2\n"
            "record: metrics\nvalues:\n  robot1.nav2.FollowPath.batch_size: [100, 200]\n"
            "");
}

using Json = nlohmann::ordered_json;
using JsonPlaces = std::vector<Json::json_pointer>;

/// All members, and of a list the first two elements.
void addPlaces(const Json& node, const Json::json_pointer& at, JsonPlaces& to) {
  constexpr std::size_t kElements = 2;
  if (!at.empty()) {
    to.push_back(at);
  }
  const Json members = node.is_object() ? node : Json::object();
  for (const auto& [key, value] : members.items()) {
    addPlaces(value, at / key, to);
  }
  for (std::size_t k = 0; node.is_array() && k < std::min(kElements, node.size()); ++k) {
    addPlaces(node[k], at / k, to);
  }
}

/// Texts in place of a JSON text: no JSON, other JSON, and each value replaced by one of another
/// type. Usually a sample.
std::vector<std::string> otherJson(const std::string& whole) {
  static const std::vector<std::string> kWrong = {"null", "true",       "-1",      "0.5",
                                                  "9e99", "\"a text\"", "[\"a\"]", "{\"a\": 1}"};
  const std::size_t number = whole.find_first_of("123456789");
  std::vector<std::string> texts = {"",
                                    "{",
                                    "[]",
                                    "{}",
                                    "7",
                                    "nonsense",
                                    whole.substr(0, whole.size() / 2),
                                    "{\"a\": \"\xff\"}",
                                    std::string(100000, '['),
                                    std::string(whole).replace(number, 1, "1e999")};
  const Json json = Json::parse(whole);
  JsonPlaces places;
  addPlaces(json, Json::json_pointer(), places);
  const bool isLong = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
  const std::size_t step =
      isLong ? 1 : std::max<std::size_t>(1, places.size() * kWrong.size() / 10);
  for (std::size_t k = 0; k < places.size() * kWrong.size(); k += step) {
    Json other = json;
    other[places[k % places.size()]] = Json::parse(kWrong[k / places.size()]);
    texts.push_back(other.dump(1));
  }
  return texts;
}

constexpr char kSocnav[] = R"({
 "grid": {"width": 2, "height": 1, "cell_size": 0.5, "x_orig": -1.0, "y_orig": -2.0,
          "angle_orig": 0.0, "data": [[1, 0]]},
 "walls": [[0.0, 3.0, 5.0, 3.0]],
 "sequence": [
  {"timestamp": 0.0, "robot": {"x": 0.0, "y": 0.0, "angle": 0.1, "speed_x": 0.5, "speed_y": 0.0,
   "speed_a": 0.0, "shape": {"type": "circle", "width": 0.6, "length": 0.6}},
   "goal": {"type": "go-to", "human": null, "x": 4.0, "y": 0.0, "angle": 0.0,
            "pos_threshold": 0.25, "angle_threshold": 3.14},
   "people": [{"id": 3, "x": 2.0, "y": 1.0, "angle": -1.5}],
   "objects": [{"id": 1, "type": "table", "x": 2.0, "y": 2.0, "angle": 0.0,
                "shape": {"type": "rectangle", "width": 0.5, "length": 1.0}}]},
  {"timestamp": 0.2, "robot": {"x": 0.1, "y": 0.0, "angle": 0.1},
   "people": [{"id": 3, "x": 2.0, "y": 1.0, "angle": -1.5}], "objects": []}]
})";
constexpr char kJrdb[] =
    R"({"labels": {"000001.pcd": [{"label_id": "pedestrian:1", "box": {"cx": 1.0, "cy": 2.0,
"cz": 0.0, "h": 1.7, "l": 0.5, "w": 0.5, "rot_z": 0.1}}], "000002.pcd": [{"label_id":
"pedestrian:1", "box": {"cx": 1.1, "cy": 2.0, "cz": 0.0, "h": 1.7, "l": 0.5, "w": 0.5,
"rot_z": 0.1}}]}})";
constexpr char kPolicyScenario[] =
    "hunav_loader: {ros__parameters: {agents: []}}\nhunavsim_desktop:\n  ros__parameters:\n"
    "    format: 1\n    map_file: none\n    robots: [robot1]\n    robot1: {planner: onnx, "
    "planner_parameters: {file: policy.onnx}, start: {x: 0.0, y: 0.0}, goal: {x: 5.0, y: 0.0}}\n";

/// JSON in files of every kind.
struct JsonKind {
  const char* name;
  const char* file;  // that is named by a refusal
  const char* command;
};
constexpr JsonKind kJsonKinds[] = {
    {"trace", "r/trace.json", "evaluate r -q -o o"},
    {"manifest of a run", "r/manifest.json", "run --from r@0.3 -q --duration 0.4"},
    {"manifest of a study", "b/manifest.json", "report b --no-pdf -q"},
    {"policy", "policy.onnx", "run policy.yaml -q --duration 0.1"},
    {"lattice", "n/lattice.json", "check n/params_lattice.yaml"},
    {"capsule", "c.hnv", "verify c.hnv -q"},
    {"jrdb", "jrdb.json", "evaluate jrdb.json --format jrdb -q -o o"},
    {"socnav3", "socnav3.json", "evaluate socnav3.json --format socnav3 -q -o o"},
    {"trajnet", "t.ndjson", "evaluate t.ndjson --format trajnet -q -o o"}};

bool isNamed(const JsonKind& kind, const char* name) {
  return std::string_view(kind.name) == name;
}

/// Whether a refusal names the file or its folder, or that no network can be run here at all.
bool isPlaced(const QString& told, const JsonKind& kind) {
  const QFileInfo file(text(kind.file));
  return told.contains(file.fileName()) || told.contains(file.path() + text(": error: ")) ||
         (isNamed(kind, "policy") && told.contains(text("needs the package hunavsim-onnx")));
}

/// The text of the undamaged file.
std::string jsonOf(const JsonKind& kind) {
  if (isNamed(kind, "policy")) {
    return onnxfile::metadataOf(0, 0, 0, 4);
  }
  if (isNamed(kind, "trajnet")) {
    return R"({"track": {"f": 3, "p": 1, "x": 0.5, "y": 0.0, "scene_id": 0}})";
  }
  const char* const file = isNamed(kind, "capsule") ? "c/manifest.json" : kind.file;
  std::string json = bytesOf(corpus().filePath(text(file))).toStdString();
  if (isNamed(kind, "manifest of a study")) {  // what only some studies have
    json.insert(json.find('{') + 1,
                R"("code": {"allowed": false}, "until": {"seeds": 3, "condition": "n > 2"},)");
  }
  return json;
}

/// All members of the capsule as they are now, with their hashes.
bool packCapsule(const QString& folder) {
  const std::string root = (folder + text("/c")).toStdString();
  app::FileHashes sums;
  std::vector<capsule::ArchiveMember> members;
  const std::vector<std::string> names = *app::filesBelow(root);
  for (const std::string& name : names) {
    if (name != capsule::kSumsMember) {
      sums[name] = *app::sha256OfFile(root + "/" + name);
    }
    members.push_back({name, {}, root + "/" + name, false});
  }
  writeText(QString::fromStdString(root + "/" + capsule::kSumsMember),
            QByteArray::fromStdString(capsule::sumsText(sums)));
  return capsule::writeArchive((folder + text("/c.hnv")).toStdString(), members).empty();
}

void putJson(const JsonKind& kind, const QString& folder, const std::string& json) {
  const QString file = folder + QLatin1Char('/') + text(kind.file);
  const QByteArray bytes = QByteArray::fromStdString(json);
  if (isNamed(kind, "policy")) {
    writeText(file,
              QByteArray::fromStdString(onnxfile::model(onnxfile::towardsGoal().graph(), json)));
  } else if (isNamed(kind, "capsule")) {
    writeText(folder + text("/c/manifest.json"), bytes);
    QVERIFY(packCapsule(folder));
  } else if (isNamed(kind, "trajnet")) {
    writeText(file, R"({"track": {"f": 1, "p": 1, "x": 0.0, "y": 0.0}})"
                    "\n" +
                        bytes + "\n");
  } else {
    writeText(file, bytes);
    adaptManifest(folder, kind.file, 2);
  }
}

/// What the commands for `kJsonKinds` read.
void writeJsonKinds(const QString& folder) {
  writeText(folder + text("/policy.yaml"), kPolicyScenario);
  writeText(folder + text("/jrdb.json"), kJrdb);
  writeText(folder + text("/socnav3.json"), kSocnav);
  writeText(folder + text("/n/lattice.json"), QByteArray::fromStdString(nav2set::latticeText()));
  QByteArray parameters = bytesOf(folder + text("/n/params_jazzy.yaml"));
  parameters.replace("\"nav2_theta_star_planner::ThetaStarPlanner\"",
                     "\"nav2_smac_planner::SmacPlannerLattice\"\n"
                     "      lattice_filepath: \"lattice.json\"");
  writeText(folder + text("/n/params_lattice.yaml"), parameters);
}

}  // namespace

void MutationsTest::initTestCase() {
  const QString folder = corpus().path();
  for (const char* file :
       {"two_workers/two_workers_agents.yaml", "two_workers/two_workers.yaml",
        "two_workers/two_workers.pgm", "two_workers/two_workers_agents__agent_1_bt.xml",
        "two_workers/two_workers_agents__agent_2_bt.xml", "corner_cafe/corner_cafe_agents.yaml",
        "corner_cafe/corner_cafe.yaml", "corner_cafe/corner_cafe.pgm"}) {
    const QByteArray bytes = bytesOf(text(SOURCE_DIR "/maps/") + text(file));
    QVERIFY2(!bytes.isEmpty(), file);
    writeText(folder + text("/s/") + QFileInfo(text(file)).fileName(), bytes);
  }
  writeText(folder + text("/m.yaml"),
            "use_all: false\nmetrics:\n  time_to_reach_goal: true\n  path_length: true\n"
            "frequency: 0\nwindow: {from: begin, until: end}\n");
  writeText(folder + text("/e.yaml"),
            "hunavsim_experiment: 1\nscenarios: [s/two_workers_agents.yaml]\nseeds: 2\n"
            "duration: 0.2\nrecord: metrics\nvalues:\n"
            "  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n  dt: [0.05, 0.1]\n");
  writeText(folder + text("/t.csv"),
            "time,id,x,y\n0,1,0,0\n0.4,1,0.5,0\n0.8,1,1,0.1\n"
            "0,2,3,3\n0.4,2,3,2.5\n0.8,2,3,2\n");
  writeText(folder + text("/obsmat.txt"),
            bytesOf(text(TEST_DATA_DIR "/interop/trajectories/own/obsmat.txt")));
  writeNav2Study(folder + text("/n"));
  for (const char* command : {"run s/corner_cafe_agents.yaml -q -o r --duration 1 --record-every 4",
                              "batch e.yaml -q -o b --jobs 1"}) {
    const Ended ended = runForked(folder, words(command), 300);
    QVERIFY2(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0, qPrintable(ended.err));
  }
}

void MutationsTest::json_otherThanExpected_isRefusedInOurWords_data() {
  QTest::addColumn<int>("number");
  for (std::size_t k = 0; k < std::size(kJsonKinds); ++k) {
    QTest::newRow(kJsonKinds[k].name) << static_cast<int>(k);
  }
  writeJsonKinds(corpus().path());
  const Ended packed = runForked(corpus().path(), words("pack r -q -o c.hnv"), 300);
  QVERIFY2(WIFEXITED(packed.status) && WEXITSTATUS(packed.status) == 0, qPrintable(packed.err));
  const std::string folder = corpus().path().toStdString();
  const auto archive = capsule::ArchiveReader::open(folder + "/c.hnv");
  QVERIFY(archive && (*archive)->extract(folder + "/c").empty());
}

/// No text of the JSON library, and the name of the file where it is refused.
void MutationsTest::json_otherThanExpected_isRefusedInOurWords() {
  QFETCH(int, number);
  const JsonKind& kind = kJsonKinds[number];
  const std::string whole = jsonOf(kind);
  QVERIFY(!whole.empty());
  int refused = 0, faults = 0;
  for (const std::string& json : otherJson(whole)) {
    QTemporaryDir place;
    const QString folder = place.filePath(text("w"));
    copyFolder(corpus().path(), folder);
    putJson(kind, folder, json);
    const Ended ended = runForked(folder, words(kind.command), kIsSanitized ? 120 : 30);
    QString fault = faultOf(ended, false);
    const bool isRefused = fault.isEmpty() && WEXITSTATUS(ended.status) != 0;
    refused += isRefused ? 1 : 0;
    if (isRefused && !isPlaced(ended.err, kind)) {
      fault = text("does not name ") + text(kind.file);
    }
    if (!fault.isEmpty()) {
      ++faults;
      qWarning("%s: %s\n%s", qPrintable(fault), qPrintable(ended.err.left(500)),
               json.substr(0, 300).c_str());
    }
  }
  QCOMPARE(faults, 0);
  QVERIFY(refused > 0);
}

void MutationsTest::damaged_isReadOrRefused() {
  const QStringList given = qEnvironmentVariable("HUNAV_MUTATIONS").split(QLatin1Char(' '));
  const bool isLong = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
  const std::uint64_t first = given.size() == 2 ? given[0].toULongLong() : 1;
  const std::uint64_t count = given.size() == 2 ? given[1].toULongLong() : (isLong ? 20000 : 200);
  constexpr int kMostWorkers = 4;
  const auto workers =
      static_cast<std::uint64_t>(isLong ? std::min(QThread::idealThreadCount(), kMostWorkers) : 1);
  std::vector<pid_t> others;
  for (std::uint64_t worker = 1; worker < workers; ++worker) {
    const pid_t other = ::fork();
    if (other == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::_exit(standAll(first + worker, first + count, workers) ? 0 : 1);
    }
    QVERIFY(other > 0);
    others.push_back(other);
  }
  bool stands = standAll(first, first + count, workers);
  for (const pid_t other : others) {
    int status = 0;
    stands = ::waitpid(other, &status, 0) == other && status == 0 && stands;
  }
  QVERIFY(stands);
}

QTEST_APPLESS_MAIN(MutationsTest)
#include "tst_Mutations.moc"
