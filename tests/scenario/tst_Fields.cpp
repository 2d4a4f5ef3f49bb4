#include <cmath>
#include <map>

#include "ScenarioTest.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioYaml.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

/// One value of one key put wrong: where it stands, what is put there, and what must be told where.
struct Fault {
  std::string node;               // of the file
  std::vector<std::string> path;  // below ros__parameters
  std::optional<YamlNode> value;  // nothing: the key is taken away
  bool isAtMap = false;           // told at the map that lacks the key
};

YamlNode at(const YamlNode& from, const std::vector<std::string>& path) {
  YamlNode node = from;
  for (const std::string& key : path) {
    const YamlNode* found = node.find(key);
    node = found != nullptr ? YamlNode(*found) : YamlNode();
  }
  return node;
}

/// A value of a type that no key of this type takes.
YamlNode wrongFor(const base::ParameterSpec& spec, bool isMap) {
  YamlNode list;
  list.kind = YamlNode::Kind::List;
  list.items.push_back(scalarNode("1"));
  const bool isText = spec.type == base::ParameterType::Text && spec.choices.empty();
  const bool isTextList = spec.key == "metrics" || spec.key == "expect";
  if (isTextList || spec.key == "nav2_params") {
    return YamlNode(YamlNode::Kind::Map);
  }
  return isText || (isMap && spec.key != "configuration") ? list : scalarNode("neither");
}

/// A number just outside of the range; nothing when every number is allowed.
std::optional<double> outside(const base::ParameterSpec& spec) {
  if (!std::isinf(spec.range.low)) {
    return spec.range.excludesLow ? spec.range.low : spec.range.low - 1.0;
  }
  return std::isinf(spec.range.high) ? std::nullopt : std::optional(spec.range.high + 1.0);
}

/// The faults of all keys of one thing of the file.
class FaultRows {
 public:
  FaultRows(std::map<std::string, Fault>& rows, std::string node, std::vector<std::string> path)
      : rows_(rows), node_(std::move(node)), path_(std::move(path)) {}

  template <class T>
  void addAll(const T& thing) {
    for (const Field<T>& field : fieldsOf<T>()) {
      if (field.belongsTo(thing)) {
        add(field.spec, field.isStructure() && field.spec.key != "xs" && field.spec.key != "ys",
            field.required);
      }
    }
  }

 private:
  void add(const base::ParameterSpec& spec, bool isMap, bool required) {
    put(spec.key, "wrong type", wrongFor(spec, isMap));
    const bool isList = spec.type == base::ParameterType::Numbers;
    const std::optional<double> value = isMap ? std::nullopt : outside(spec);
    if (value && isList) {
      YamlNode list;
      list.kind = YamlNode::Kind::List;
      list.items.push_back(decimals(*value));
      put(spec.key, "out of range", list);
    } else if (value) {
      put(spec.key, "out of range",
          spec.type == base::ParameterType::Integer ? number(std::llround(*value))
                                                    : decimals(*value));
    }
    if (required && spec.key != "xs") {  // told at ys, which has no partner then
      put(spec.key, "missing", std::nullopt);
    }
  }
  void put(const std::string& key, const std::string& what, std::optional<YamlNode> value) {
    std::vector<std::string> path = path_;
    path.push_back(key);
    rows_[node_ + ":" + base::join(path, ".") + " " + what] = {node_, path, std::move(value),
                                                               what == "missing"};
  }

  std::map<std::string, Fault>& rows_;
  std::string node_;
  std::vector<std::string> path_;
};

std::map<std::string, Fault> allFaults(const Scenario& scenario) {
  std::map<std::string, Fault> rows;
  const Human& anna = scenario.humans.front();
  FaultRows(rows, kLoaderNode, {}).addAll<ScenarioSettings>(scenario);
  FaultRows(rows, kLoaderNode, {anna.name}).addAll(anna);
  FaultRows(rows, kLoaderNode, {anna.name, "behavior"}).addAll(anna.behavior);
  FaultRows(rows, kDesktopNode, {}).addAll(scenario.desktop);
  FaultRows(rows, kDesktopNode, {"metrics"}).addAll(scenario.desktop.metrics);
  FaultRows(rows, kDesktopNode, {"card"}).addAll(scenario.desktop.card);
  FaultRows(rows, kDesktopNode, {anna.name}).addAll(anna.ours);
  const Robot& robot = scenario.robots.front();
  FaultRows(rows, kDesktopNode, {robot.name}).addAll(robot);
  FaultRows(rows, kDesktopNode, {robot.name, "lidar"}).addAll(robot.lidar);
  FaultRows(rows, kDesktopNode, {robot.name, "detector"}).addAll(robot.detector);
  FaultRows(rows, kDesktopNode, {robot.name, "odometry_noise"}).addAll(robot.odometryNoise);
  FaultRows(rows, kDesktopNode, {robot.name, "localization"}).addAll(robot.localization);
  for (const Obstacle& obstacle : scenario.obstacles) {
    FaultRows(rows, kDesktopNode, {obstacle.name}).addAll(obstacle);
  }
  FaultRows(rows, kDesktopNode, {scenario.doors.front().name}).addAll(scenario.doors.front());
  FaultRows(rows, kDesktopNode, {scenario.areas.front().name}).addAll(scenario.areas.front());
  return rows;
}

std::string textWith(const Fault& fault, const YamlNode& file) {
  YamlNode changed = file;
  YamlNode* map = &changed.child(fault.node).child(kParameters);
  for (std::size_t i = 0; i + 1 < fault.path.size(); ++i) {
    map = &map->child(fault.path[i]);
  }
  if (fault.value) {
    setChild(*map, fault.path.back(), *fault.value);
  } else {
    map->items.erase(
        std::remove_if(map->items.begin(), map->items.end(),
                       [&](const auto& item) { return item.key == fault.path.back(); }),
        map->items.end());
  }
  return emitYaml(changed);
}

int lineOf(const Fault& fault, const std::string& text) {
  base::Diagnostics problems;
  std::vector<std::string> path = {fault.node, kParameters};
  path.insert(path.end(), fault.path.begin(), fault.path.end() - (fault.isAtMap ? 1 : 0));
  return at(base::parseYaml(text, "t", problems), path).line;
}

/// A key that no robot has, kept beside the robots by where they start.
struct Bumpers {
  std::map<double, double> depth;
};

FieldTables tablesWith(Bumpers& bumpers) {
  FieldTables tables = fieldTables();
  const auto get = [&bumpers](const Robot& robot, const base::ParameterSpec& /*spec*/) {
    const auto found = bumpers.depth.find(robot.start.position.x());
    return found == bumpers.depth.end() ? base::ParameterValue()
                                        : base::ParameterValue(found->second);
  };
  const auto set = [&bumpers](Robot& robot, const base::ParameterValue& value,
                              const base::ParameterSpec& /*spec*/) {
    bumpers.depth.erase(robot.start.position.x());
    if (const auto* depth = std::get_if<double>(&value)) {
      bumpers.depth[robot.start.position.x()] = *depth;
    }
  };
  std::get<Fields<Robot>>(tables).push_back(
      FieldBuilder<Robot>("bumper", "How far it stands out", {"Bumper"}, "m", {0.0, 1.0})
          .typed(base::ParameterType::Number)
          .with(&Field<Robot>::get, get)
          .with(&Field<Robot>::set, set)
          .defaultsTo(0.1));
  return tables;
}

YamlNode parsed(const std::string& text) {
  base::Diagnostics problems;
  return base::parseYaml(text, "t", problems);
}

const std::string kWithBumper =
    "hunav_loader:\n  ros__parameters:\n    agents: []\nhunavsim_desktop:\n  ros__parameters:\n"
    "    format: 1\n    robots:\n      - r\n    r:\n      start:\n        x: 1.0\n        y: 2.0\n"
    "        h: 0.0\n      bumper: ";

}  // namespace

class FieldsTest : public QObject {
  Q_OBJECT

  Scenario scenario_ = readScenario(dataFile("block.yaml")).scenario;
  YamlNode file_ = fileTree(scenario_);
  std::map<std::string, Fault> faults_ = allFaults(scenario_);

 private Q_SLOTS:
  void read_everyKeyPutWrong_isErrorAtItsLine_data() {
    QTest::addColumn<QString>("fault");
    for (const auto& row : faults_) {
      QTest::newRow(row.first.c_str()) << QString::fromStdString(row.first);
    }
    QVERIFY(faults_.size() > 150);
  }
  void read_everyKeyPutWrong_isErrorAtItsLine() {
    QFETCH(QString, fault);
    const Fault& put = faults_.at(fault.toStdString());
    const std::string text = textWith(put, file_);
    const int line = lineOf(put, text);
    const ScenarioReading reading = readScenarioText(text, "t");
    const auto fits = [&](const base::Diagnostic& said) {
      return said.severity == base::Severity::Error && said.line >= line && said.line <= line + 1 &&
             said.message.find(put.path.back()) != std::string::npos;
    };
    const base::Diagnostics& all = reading.diagnostics;
    QVERIFY2(line > 0 && std::any_of(all.begin(), all.end(), fits),
             qPrintable(QString::number(line) + QLatin1Char('\n') + shown(all)));
  }

  void madeUpKey_isReadCheckedWrittenAndSet() {
    Bumpers bumpers;
    const FieldTables tables = tablesWith(bumpers);
    TreeReading reading = readTree(parsed(kWithBumper + "0.3"), "t", tables);
    QVERIFY2(reading.file.diagnostics.empty(), qPrintable(shown(reading.file.diagnostics)));
    QCOMPARE(bumpers.depth[1.0], 0.3);
    const std::string written = emitYaml(fileTree(reading.file.scenario, tables));
    QVERIFY2(written.find("      bumper: 0.3\n") != std::string::npos ||
                 written.find("      bumper: 0.3") == written.size() - 17,
             written.c_str());

    QVERIFY(setValue(reading.file.scenario, "r.bumper", "0.5", tables).empty());
    QCOMPARE(bumpers.depth[1.0], 0.5);
    QCOMPARE(shown(setValue(reading.file.scenario, "r.bumpr", "0.5", tables)),
             QStringLiteral("error: unknown path 'r.bumpr' (did you mean 'r.bumper'?)\n"));
    QCOMPARE(shown(setValue(reading.file.scenario, "r.bumper", "1.5", tables)),
             QStringLiteral("error: r.bumper: 1.5 must be from 0 to 1\n"));
  }

  void madeUpKey_outOfRange_isErrorAtItsLine() {
    Bumpers bumpers;
    const TreeReading reading = readTree(parsed(kWithBumper + "2.0"), "t", tablesWith(bumpers));
    QCOMPARE(shown(reading.file.diagnostics),
             QStringLiteral("t:14:15: error: r.bumper: 2.0 must be from 0 to 1\n"));
  }

  void madeUpKey_atItsDefault_isLeftOut() {
    Bumpers bumpers;
    const FieldTables tables = tablesWith(bumpers);
    const TreeReading reading = readTree(parsed(kWithBumper + "0.1"), "t", tables);
    QVERIFY(bumpers.depth.empty());
    QVERIFY(emitYaml(fileTree(reading.file.scenario, tables)).find("bumper") == std::string::npos);
  }

  void madeUpKey_isInTheTablesForPeople() {
    Bumpers bumpers;
    const std::string text = keysMarkdown(tablesWith(bumpers));
    QVERIFY(text.find("| `bumper` | number 0 to 1 | m | 0.1 | How far it stands out |\n") !=
            std::string::npos);
    QVERIFY(keysMarkdown().find("bumper") == std::string::npos);
  }

  void format_tables_areCurrent() {
    const std::string format = textOf(SOURCE_DIR "/sim2d/scenario/FORMAT.md");
    const std::string expected =
        "<!-- begin: list keys --format markdown -->\n" + keysMarkdown() + "<!-- end -->";
    QVERIFY2(format.find(expected) != std::string::npos, keysMarkdown().c_str());
  }
};

QTEST_APPLESS_MAIN(FieldsTest)
#include "tst_Fields.moc"
