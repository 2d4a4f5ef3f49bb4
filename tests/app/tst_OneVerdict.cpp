#include <algorithm>
#include <unistd.h>

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "editor/document/MapEdit.h"
#include "editor/run/SimulationRunner.h"
#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

const char kScenario[] = R"(hunav_loader:
  ros__parameters:
    yaml_base_name: s
    simulator: Gazebo Classic
    map: none
    publish_people: true
    global_goals:
      1:
        x: 2.0
        y: 1.5
      2:
        x: 17.5
        y: 8.25
    agents:
      - anna
      - ben
    anna:
      id: 1
      group_id: -1
      skin: 1
      max_vel: 1.5
      radius: 0.4
      goal_radius: 0.3
      cyclic_goals: true
      init_pose:
        x: 1.0
        y: 2.0
        z: 1.25
        h: 0.785
      behavior:
        type: Scared
        dist: 4.0
        duration: 40.0
        once: false
        vel: 0.6
        safe_distance: 5.0
        configuration: 1
        goal_force_factor: 2.0
        obstacle_force_factor: 10.0
        social_force_factor: 5.0
        other_force_factor: 20.0
      goals:
        - 1
        - 2
    ben:
      id: 2
      group_id: -1
      skin: 1
      max_vel: 1.5
      radius: 0.4
      goal_radius: 0.3
      cyclic_goals: true
      init_pose:
        x: 3.0
        y: 2.0
        z: 1.25
        h: 0.785
      behavior:
        type: Curious
        dist: 10.0
        duration: 40.0
        once: true
        vel: 1.0
        stop_dist: 1.5
        configuration: 1
        goal_force_factor: 2.0
        obstacle_force_factor: 10.0
        social_force_factor: 5.0
        other_force_factor: 20.0
      goals:
        - 2
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    seed: 7
    duration: 6.0
    dt: 0.02
    record_every: 5
    model: das
    route: direct
    obstacle_points: rays
    loop_trees: false
    anna:
      start_time: 2.5
      kind: child
      mass: 30.5
      at_end: leave
    robots:
      - robot1
    robot1:
      type: generic
      planner: pursuit
      planner_parameters:
        lookahead: 0.8
        stop_distance: 0.4
        slow_distance: 1.0
      start:
        x: 1.0
        y: 5.0
        h: 1.5
      goal:
        x: 8.0
        y: 3.5
      goal_radius: 0.25
      start_time: 3.0
      radius: 0.3
      mass: 40.0
      max_vel: 0.8
      max_acc: 0.5
      max_omega: 1.0
      max_alpha: 2.0
    obstacles:
      - crate
      - fence
    crate:
      kind: box
      x: 6.0
      y: 6.0
      h: 0.5
      length: 1.2
      width: 0.8
    fence:
      kind: wall
      xs:
        - 0.0
        - 3.0
      ys:
        - 9.0
        - 9.0
      thickness: 0.2
    doors:
      - gate
    gate:
      x1: 10.0
      y1: 0.0
      x2: 11.0
      y2: 0.0
      thickness: 0.08
      open: false
      toggles:
        - 5.0
    areas:
      - entry
    entry:
      kind: source
      xs:
        - 0.0
        - 1.0
        - 1.0
      ys:
        - 0.0
        - 0.0
        - 1.0
      like: anna
      rate: 0.5
      from: 1.0
      until: 30.0
      count: 12
    metrics:
      from: goal
      until: time 5.0
      frequency: 10.0
      tag: exp_2
      run_id: 3
      parameters:
        personal_distance: 1.25
)";

struct Row {
  QByteArray name;
  QString file;  // the scenario, in a folder of its own
};

QStringList sorted(QStringList lines) {
  lines.sort();
  return lines;
}

/// Without the places beside the program where a map was looked for: they depend on where it lies.
QString withoutShippedPlaces(QString line) {
  return line.remove(QRegularExpression(text(", " SOURCE_DIR "/maps/[^,)]*"))).trimmed();
}

QStringList errorLines(const base::Diagnostics& problems) {
  QStringList lines;
  for (const base::Diagnostic& problem : problems) {
    if (problem.severity == base::Severity::Error) {
      lines << withoutShippedPlaces(QString::fromStdString(problem.text()));
    }
  }
  return sorted(lines);
}

QStringList errorLines(const QString& output, const QString& severity = text("error: ")) {
  QStringList lines;
  for (const QString& line : output.split(QLatin1Char('\n'))) {
    if (line.contains(text(": ") + severity) || line.startsWith(severity)) {
      lines << withoutShippedPlaces(line);
    }
  }
  return sorted(lines);
}

/// What `run`, `batch` and `check` say of the scenario.
QStringList verdictOf(const QString& file) {
  app::RunSpec options;
  options.scenario = file.toStdString();
  return errorLines(app::check(app::readBundle(options, {}, editor::loadMapImage)).problems);
}

QByteArray treeFile(const char* name) {
  return bytesOf(text(TEST_DATA_DIR "/bt/bad/") + text(name));
}

}  // namespace

/// A broken scenario, tree or map is refused by every way to run it, with the same lines.
class OneVerdictTest : public QObject {
  Q_OBJECT

 private:
  void add(const QByteArray& name, const QByteArray& scenario,
           const std::map<QString, QByteArray>& beside = {}) {
    const QString folder = folder_.filePath(QString::number(rows_.size()));
    rows_.push_back({name, folder + text("/s.yaml")});
    writeText(rows_.back().file, scenario);
    for (const auto& [file, content] : beside) {
      writeText(folder + QLatin1Char('/') + file, content);
    }
  }

  /// Every key with values of the wrong type or range, and without its line.
  void addKeys() {
    const QList<QByteArray> lines = QByteArray(kScenario).split('\n');
    for (int at = 0; at < lines.size(); ++at) {
      const int colon = lines[at].indexOf(": ");
      if (colon < 0) {
        continue;
      }
      const QByteArray key = lines[at].left(colon);
      std::vector<const char*> values = {"abc", "[[1]]", "-1000000000.0", ".nan", ""};
      if (key.endsWith(" x") || key.endsWith(" y1")) {  // places that no number of a cell reaches
        values.insert(values.end(), {"1.0e13", "1.0e308"});
      }
      for (const char* value : values) {
        QList<QByteArray> changed = lines;
        if (*value == '\0' && key.trimmed() == "map_file") {
          continue;  // what is searched then depends on where the program lies
        }
        if (*value == '\0') {
          changed.removeAt(at);
        } else {
          changed[at] = key + ": " + value;
        }
        add(QByteArray::number(at + 1) + key.trimmed().prepend(' ') + ": " + value,
            changed.join('\n'));
      }
    }
  }

  void addFiles() {
    for (const QFileInfo& bad :
         QDir(text(TEST_DATA_DIR "/scenario/bad")).entryInfoList({text("*.yaml")})) {
      add(bad.fileName().toUtf8(), bytesOf(bad.filePath()));
    }
    for (const QFileInfo& bad :
         QDir(text(TEST_DATA_DIR "/bt/bad")).entryInfoList({text("*.xml")})) {
      add(bad.fileName().toUtf8(), kScenario,
          {{text("s__agent_1_bt.xml"), bytesOf(bad.filePath())},
           {text("s__agent_2_bt.xml"), bytesOf(bad.filePath())}});
    }
    add("empty file", {});
    add("named tree is lost",
        QByteArray(kScenario).replace("      at_end: leave", "      tree: lost.xml"));
    add("named tree is broken",
        QByteArray(kScenario).replace("      at_end: leave", "      tree: own.xml"),
        {{text("own.xml"), treeFile("truncated.xml")}});
  }

  void addMaps() {
    const QByteArray scenario = QByteArray(kScenario).replace("map_file: none", "map_file: m.yaml");
    const QByteArray map =
        "image: m.pgm\nresolution: 0.1\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    const QByteArray image = "P5\n200 100\n255\n" + QByteArray(200 * 100, '\xfe');
    const auto addMap = [&](const char* name, const QByteArray& yaml, const QByteArray& pixels) {
      add(name, scenario, {{text("m.yaml"), yaml}, {text("m.pgm"), pixels}});
    };
    add("map is lost", scenario);
    add("map has no image", scenario, {{text("m.yaml"), map}});
    addMap("map is whole", map, image);
    addMap("map is full", map, "P5\n200 100\n255\n" + QByteArray(200 * 100, '\0'));
    addMap("image is cut off", map, image.left(5000));
    addMap("image is no image", map, "nothing");
    addMap("image is empty", map, {});
    addMap("map is empty", {}, image);
    addMap("map is cut off", map.left(20), image);
    for (const char* key : {"image", "resolution", "origin", "occupied_thresh", "free_thresh"}) {
      for (const char* value : {"abc", "[1]", "-1", ".nan", "{}"}) {
        QList<QByteArray> lines = map.split('\n');
        for (QByteArray& line : lines) {
          line = line.startsWith(key) ? QByteArray(key) + ": " + value : line;
        }
        addMap((QByteArray("map ") + key + ": " + value).constData(), lines.join('\n'), image);
      }
    }
  }

  /// A program takes its time to start, a window more so: of those with errors all with
  /// HUNAV_ALL_TESTS, else one in so many, evenly.
  std::vector<Row> someBroken(std::size_t step) const {
    std::vector<Row> broken;
    std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(broken),
                 [this](const Row& row) { return !verdicts_.at(row.file).isEmpty(); });
    if (qEnvironmentVariableIsSet("HUNAV_ALL_TESTS")) {
      return broken;
    }
    std::vector<Row> some;
    for (std::size_t i = 0; i < broken.size(); i += step) {
      some.push_back(broken[i]);
    }
    return some;
  }

  QStringList allErrors() const {
    QStringList all;
    for (const auto& [file, lines] : verdicts_) {
      all << lines;
    }
    return sorted(all);
  }

  QTemporaryDir folder_;
  std::vector<Row> rows_;
  std::map<QString, QStringList> verdicts_;  // by file: the lines of its errors

 private Q_SLOTS:
  void initTestCase() {
    addKeys();
    addFiles();
    addMaps();
    int broken = 0;
    for (const Row& row : rows_) {
      verdicts_[row.file] = verdictOf(row.file);
      broken += verdicts_[row.file].isEmpty() ? 0 : 1;
    }
    QVERIFY2(broken >= 200, qPrintable(QString::number(broken)));
  }

  void unbroken_scenario_isRefusedByNone() {
    add("as it should be", kScenario);
    verdicts_[rows_.back().file] = verdictOf(rows_.back().file);
    QCOMPARE(verdicts_[rows_.back().file], QStringList());
  }

  /// One in its place beside the scenario, of nobody's choice.
  void unreadableTree_besideTheScenario_isRefusedByAll() {
    if (::geteuid() == 0) {
      QSKIP("the superuser may read everything");
    }
    add("tree is unreadable", kScenario, {{text("s__agent_1_bt.xml"), "<root/>"}});
    const QString file = rows_.back().file;
    const QString tree = QFileInfo(file).path() + text("/s__agent_1_bt.xml");
    QVERIFY(QFile::setPermissions(tree, QFile::WriteOwner));
    const QStringList wanted = verdictOf(file);
    QCOMPARE(wanted.size(), 1);
    verdicts_[file] = wanted;
    editor::ScenarioDocument document;
    document.open(file);
    document.checkNow();
    QCOMPARE(errorLines(document.issues()), wanted);
    QCOMPARE(errorLines(editor::runRequestOf(document).makeWorld().diagnostics()), wanted);
    const QString out = folder_.filePath(text("converted"));
    const Finished converted = runProgram("convert % -o % --target native", {file, out});
    QCOMPARE(converted.exitCode, 2);
    QCOMPARE(errorLines(converted.err), wanted);
    QVERIFY(!QDir(out).exists());
  }

  void window_issuesAndPlay_sayTheSame_data() {
    QTest::addColumn<QString>("file");
    for (const Row& row : rows_) {
      QTest::newRow(row.name.constData()) << row.file;
    }
  }
  void window_issuesAndPlay_sayTheSame() {
    QFETCH(QString, file);
    const QStringList& wanted = verdicts_.at(file);
    editor::ScenarioDocument document;
    document.setShippedMaps(QString::fromStdString(app::shippedMapsFolder()));
    const base::Diagnostics opening = document.open(file);
    if (document.path().isEmpty()) {  // nothing of it is shown
      QCOMPARE(errorLines(opening), wanted);
      return;
    }
    document.checkNow();
    QCOMPARE(errorLines(document.issues()), wanted);
    const auto world = editor::runRequestOf(document).makeWorld();
    QCOMPARE(bool(world), wanted.isEmpty());
    QCOMPARE(errorLines(world.diagnostics()), wanted);
  }

  void check_allAtOnce_saysTheSame() {
    QStringList words = list("check --quiet");
    for (const Row& row : rows_) {
      words << row.file;
    }
    const Finished found = runProgram(words);
    QCOMPARE(found.exitCode, 2);
    QCOMPARE(errorLines(found.err), allErrors());
  }

  void batch_allAtOnce_saysTheSame() {
    QByteArray experiment = "hunavsim_experiment: 1\nscenarios:\n";
    for (const Row& row : rows_) {
      experiment += "  - \"" + row.file.toUtf8() + "\"\n";
    }
    const QString file = folder_.filePath(text("all.yaml"));
    writeText(file, experiment);
    const QString out = folder_.filePath(text("out"));
    const Finished found = runProgram("batch % -o %", {file, out});
    QCOMPARE(found.exitCode, 2);
    QCOMPARE(errorLines(found.err), allErrors());
    QVERIFY(!QDir(out).exists());
  }

  /// Without its map a scenario is still converted: what is wrong with the map is a warning then.
  void convert_ofBroken_refusesTheSame() {
    for (const Row& row : someBroken(3)) {
      const QString out = folder_.filePath(text("converted"));
      const Finished found = runProgram("convert % -o % --target native", {row.file, out});
      QStringList wanted = verdicts_.at(row.file);
      if (row.name.contains("map") || row.name.contains("image") ||
          wanted.join(QLatin1Char(' ')).contains(text("error: map '"))) {
        for (QString warned : errorLines(found.err, text("warning: "))) {
          wanted.removeOne(warned.replace(text("warning: "), text("error: ")));
        }
      }
      QVERIFY2(errorLines(found.err) == wanted, row.name + found.err.toUtf8());
      QVERIFY2(found.exitCode == (wanted.isEmpty() ? 0 : 2), row.name.constData());
    }
  }

  void run_ofBroken_saysTheSame() {
    for (const Row& row : someBroken(3)) {
      const Finished run = runProgram("run %", {row.file});
      QVERIFY2(run.exitCode == 2, row.name.constData());
      QCOMPARE(errorLines(run.err), verdicts_.at(row.file));
    }
  }

  void screenshot_ofBroken_saysTheSame() {
    for (const Row& row : someBroken(10)) {
      const QString picture = folder_.filePath(text("a.png"));
      const Finished window = runProgram("% --screenshot % --at 0.1", {row.file, picture});
      QVERIFY2(window.exitCode == 2, row.name.constData());
      QCOMPARE(errorLines(window.err), verdicts_.at(row.file));
      QVERIFY(!QFile::exists(picture));
    }
  }
};

QTEST_MAIN(OneVerdictTest)
#include "tst_OneVerdict.moc"
