#include <algorithm>
#include <chrono>
#include <ctime>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "sim2d/base/Text.h"
#include "tests/app/StudyFiles.h"

namespace {

/// "6:22 error robot1.planner: …" of each problem.
QStringList linesOf(const base::Diagnostics& problems) {
  QStringList lines;
  for (const base::Diagnostic& problem : problems) {
    const char* const kind = problem.severity == base::Severity::Error ? "error" : "warning";
    lines.append(QStringLiteral("%1:%2 %3 %4")
                     .arg(problem.line)
                     .arg(problem.column)
                     .arg(QLatin1String(kind), QString::fromStdString(problem.message)));
  }
  return lines;
}

std::size_t errorsOf(const base::Diagnostics& problems) {
  return static_cast<std::size_t>(std::count_if(
      problems.begin(), problems.end(),
      [](const base::Diagnostic& problem) { return problem.severity == base::Severity::Error; }));
}

/// A row that is called as its text, in one line.
QTestData& newRow(const char* text) {
  return QTest::newRow(QByteArray(text).trimmed().replace('\n', " / ").constData());
}

}  // namespace

/// What is said of values before anything runs.
class ExperimentCheckTest : public QObject {
  Q_OBJECT

 private:
  outside::StudyFolder folder_;

  /// Of a study of the yard with these lines, from line 3 on.
  base::Result<app::Experiment> study(const QByteArray& more) const {
    const QString file = folder_.writeStudy("e.yaml", more);
    return app::readExperiment(file.toStdString());
  }
  void writeScenario(const char* name, const QByteArray& text) const {
    outside::writeText(folder_.path(QString::fromLatin1(name)), text);
  }

 private Q_SLOTS:
  void fileOfAnotherKind_isOneProblem() {
    for (const auto& [text, said] : {std::pair("hunav_loader:\n  ros__parameters:\n    map: yard\n",
                                               "1:1 error this is a scenario, not an experiment"),
                                     std::pair("image: yard.pgm\nresolution: 0.05\n",
                                               "1:1 error this is not an experiment")}) {
      const QStringList lines = linesOf(app::parseExperiment(text, "e.yaml").diagnostics());
      QVERIFY2(lines.size() == 1 && lines.front().startsWith(QLatin1String(said)),
               qPrintable(lines.join(QLatin1Char('\n'))));
    }
  }

  /// An option without a command has that of the scenario, not that of another option.
  void externalCode_ofMaps_isThatOfEachOption() {
    writeScenario("code.yaml",
                  QByteArray(outside::kYardText)
                      .replace("    robot1:\n", "    robot1:\n      command: ./own\n"));
    const std::string file =
        "hunavsim_experiment: 1\nscenarios: [code.yaml]\nvalues:\n  robot1: [{planner: external, "
        "command: ./first}, {planner: external}, {planner: dwa}]\n";
    const auto experiment =
        app::parseExperiment(file, folder_.path(QStringLiteral("e.yaml")).toStdString());
    QVERIFY2(bool(experiment),
             qPrintable(linesOf(experiment.diagnostics()).join(QLatin1Char('\n'))));
    std::vector<std::string> reported;
    for (const base::Diagnostic& problem : app::ExperimentRunner(*experiment, {}, {}).check()) {
      if (problem.code == "code.not-allowed") {
        reported.push_back(problem.value("command"));
      }
    }
    QCOMPARE(reported, (std::vector<std::string>{"./first", "./own"}));
    std::vector<std::string> commands;
    for (const app::ExternalCode& code : app::externalCodeOf(*experiment, 0)) {
      commands.push_back(code.words);
    }
    QCOMPARE(commands, (std::vector<std::string>{"./first", "./own"}));
  }

  /// Relative files of options are beside the scenario: found in one folder, missing in the other.
  void filesOfAllOptions_areChecked() {
    outside::writeText(folder_.path(QStringLiteral("there.csv")),
                       "time,linear,angular\n0.0,0.1,0.0\n1.0,0.1,0.0\n");
    QVERIFY(QDir(folder_.path({})).mkpath(QStringLiteral("other")));
    writeScenario("other/yard.yaml", outside::kYardText);
    const QByteArray values =
        "values:\n  robot1:\n    - {planner: dwa}\n"
        "    - {planner: replay, planner_parameters: {file: gone.csv}}\n"
        "    - {planner: replay, planner_parameters: {file: there.csv}}\n"
        "    - {planner: replay}\n"
        "    - {planner: nav2, nav2_params: gone.yaml}\n"
        "    - {planner: orca}\n";
    const auto here = study(values);
    QVERIFY(here && here.diagnostics().empty());
    app::ExperimentRunner runner(*here, {}, {});
    QVERIFY(runner.check(base::Severity::Error, app::ExperimentRunner::Checked::FirstRuns).empty());
    const QStringList ofOne = linesOf(runner.check());
    QVERIFY2(ofOne.size() == 3, qPrintable(ofOne.join(QLatin1Char('\n'))));
    QVERIFY(ofOne[0].startsWith(QLatin1String("6:7 error ")) &&
            ofOne[0].contains(QLatin1String("/gone.csv: cannot read the file")));
    QVERIFY(ofOne[1].startsWith(QLatin1String("8:7 error robot 'robot1': planner 'replay' needs")));
    QVERIFY(ofOne[2].startsWith(QLatin1String("9:7 error there is no file 'gone.yaml'")));
    const auto both = app::parseExperiment(
        ("hunavsim_experiment: 1\nscenarios: [yard.yaml, other/yard.yaml]\n" + values)
            .toStdString(),
        here->path);
    const base::Diagnostics ofBoth = app::ExperimentRunner(*both, {}, {}).check();
    const QStringList lines = linesOf(ofBoth);
    QVERIFY2(lines.size() == 4 && lines.mid(0, 3) == ofOne,
             qPrintable(lines.join(QLatin1Char('\n'))));
    QVERIFY(lines[3].startsWith(QLatin1String("7:7 error ")) &&
            lines[3].contains(QLatin1String("/other/there.csv: cannot read the file")));
    for (const base::Diagnostic& problem : ofBoth) {
      QCOMPARE(problem.file, here->path);
    }
  }

  /// Four times the paths take about four times as long, whether there are such keys or not.
  void manyPaths_takeTimeInProportion_data() {
    QTest::addColumn<QByteArray>("scenario");
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<int>("few");  // and four times as many
    QTest::newRow("unknown") << QByteArray("yard.yaml") << QByteArray("robot1.key%1") << 750;
    QTest::newRow("known") << QByteArray("many.yaml") << QByteArray("p%1.max_vel") << 25;
  }
  void manyPaths_takeTimeInProportion() {
    QFETCH(QByteArray, scenario);
    QFETCH(QByteArray, path);
    QFETCH(int, few);
    QByteArray people = "hunav_loader:\n  ros__parameters:\n    agents: [p0";
    for (int k = 1; k < 100; ++k) {
      people += ", p" + QByteArray::number(k);
    }
    people += "]\n    global_goals: {1: {x: 1.0, y: 1.0}}\n";
    for (int k = 0; k < 100; ++k) {
      const QByteArray number = QByteArray::number(k);
      people += "    p" + number + ": {id: " + QByteArray::number(k + 1) +
                ", init_pose: {x: " + number + ".0, y: 0.0}, goals: [1]}\n";
    }
    writeScenario("many.yaml", people);
    const auto secondsFor = [&](int count) {
      QByteArray text = "hunavsim_experiment: 1\nscenarios: [" + scenario + "]\nvalues:\n";
      for (int k = 0; k < count; ++k) {
        text += "  " + QByteArray(path).replace("%1", QByteArray::number(k)) + ": [1.0]\n";
      }
      writeScenario("many_paths.yaml", text);
      const std::clock_t before = std::clock();
      const auto read =
          app::readExperiment(folder_.path(QStringLiteral("many_paths.yaml")).toStdString());
      const std::size_t wanted = path.startsWith('p') ? 0U : static_cast<std::size_t>(count);
      return errorsOf(read.diagnostics()) == wanted
                 ? static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC
                 : -1.0;
    };
    const double ofFew = secondsFor(few);
    const double ofMany = secondsFor(4 * few);
    QVERIFY(ofFew > 0.0 && ofMany > 0.0);
    QVERIFY2(ofMany < 7.0 * ofFew, QByteArray::number(ofMany / ofFew).constData());  // not 16
  }

  /// The option would win in every run, so rows would name what never counted.
  void optionsOfAllRuns_areNoValues_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("said");
    const auto add = [](const char* text, const char* said) {
      newRow(text) << QByteArray(text) << QString::fromLatin1(said);
    };
    add("planner: orca\nvalues:\n  robot1.planner: [pursuit, dwa]\n",
        "5:3 error 'robot1.planner' is also set by the experiment's key 'planner'");
    add("planner: orca\nvalues:\n  robot1.planner: {choice: [pursuit, dwa]}\n",
        "5:3 error 'robot1.planner' is also set by the experiment's key 'planner'");
    add("planner: orca\nvalues:\n  robot1: [{start: {x: 1.0, y: 1.0}, planner: dwa}]\n",
        "5:3 error 'robot1' is also set by the experiment's key 'planner'");
    add("robot: tiago\nvalues:\n  robot1.type: [generic, pmb2]\n",
        "5:3 error 'robot1.type' is also set by the experiment's key 'robot'");
    add("model: sfm\nvalues:\n  model: [orca]\n",
        "5:3 error 'model' is also set by the experiment's key 'model'");
    add("duration: 5.0\nvalues:\n  duration: [4.0]\n",
        "5:3 error 'duration' is also set by the experiment's key 'duration'");
    add("dt: 0.05\nvalues:\n  dt: {range: [0.01, 0.05, 0.01]}\n",
        "5:3 error 'dt' is also set by the experiment's key 'dt'");
    add("stuck_after: 0.0\nvalues:\n  stuck_after: [4.0]\n",
        "5:3 error 'stuck_after' is also set by the experiment's key 'stuck_after'");
    add("stop_on_collision: any\nvalues:\n  stop_on_collision: [none]\n",
        "5:3 error 'stop_on_collision' is also set by the experiment's key 'stop_on_collision'");
    add("seeds: 2\nvalues:\n  seed: [5, 9]\n", "5:3 error the seed cannot be one of the values");
  }
  void optionsOfAllRuns_areNoValues() {
    QFETCH(const QByteArray, text);
    QFETCH(const QString, said);
    const QStringList lines = linesOf(study(text).diagnostics());
    QVERIFY2(lines.size() == 1 && lines.front().startsWith(said),
             qPrintable(lines.join(QLatin1Char('\n'))));
  }

  /// The later value would win in the runs that have both.
  void valuesThatOverlap_areErrors_data() {
    QTest::addColumn<QByteArray>("values");
    QTest::addColumn<QString>("said");  // empty: none
    const auto add = [](const char* values, const char* said) {
      newRow(values) << QByteArray(values) << QString::fromLatin1(said);
    };
    add("  robot1: [{planner: dwa}, {planner: orca}]\n  robot1.planner: [pursuit]\n",
        "5:3 error 'robot1.planner' and 'robot1' both set 'robot1.planner'");
    add("  robot1.planner: [pursuit]\n  robot1: [{max_vel: 0.5}, {planner: dwa}]\n",
        "5:3 error 'robot1' and 'robot1.planner' both set 'robot1.planner'");
    add("  robot1: [{start: {x: 1.0, y: 1.0}}]\n  robot1.start.x: [2.0]\n",
        "5:3 error 'robot1.start.x' and 'robot1' both set 'robot1.start.x'");
    add("  robot1: [{start.x: 1.0}]\n  robot1.start.x: {range: [2.0, 3.0, 0.5]}\n",
        "5:3 error 'robot1.start.x' and 'robot1' both set 'robot1.start.x'");
    add("  robot1: [{planner: dwa, planner_parameters: {horizon: 1.0}}]\n"
        "  robot1.planner_parameters: [{horizon: 2.0}]\n",
        "5:3 error 'robot1.planner_parameters' and 'robot1' both set "
        "'robot1.planner_parameters.horizon'");
    add("  robot1.planner_parameters.horizon: [1.0]\n"
        "  robot1: [{planner: dwa, planner_parameters: {}}]\n",
        "5:3 error 'robot1' and 'robot1.planner_parameters.horizon' both set "
        "'robot1.planner_parameters.horizon'");
    add("  \"*.max_vel\": [1.0, 1.2]\n  anna.max_vel: [0.9]\n", "");  // all but one
    add("  ben: [{max_vel: 0.9}]\n  \"*\": [{max_vel: 1.0, radius: 0.3}]\n",
        "5:3 error '*' and 'ben' both set 'ben.max_vel'");
    add("  \"*.max_vel\": [1.0, 1.2]\n  robot1.max_vel: [0.9]\n", "");
    add("  \"*.max_vel\": [1.0, 1.2]\n  anna.radius: [0.3]\n", "");
    add("  robot1: [{planner: dwa, planner_parameters: {horizon: 1.0}}]\n"
        "  robot1.planner_parameters.clearance: [0.5]\n",
        "");
    add("  robot1.planner: [dwa, orca]\n  robot1.max_vel: [1.0]\n", "");
  }
  void valuesThatOverlap_areErrors() {
    QFETCH(const QByteArray, values);
    QFETCH(const QString, said);
    const QStringList lines = linesOf(study("values:\n" + values).diagnostics());
    QVERIFY2(lines.size() == (said.isEmpty() ? 0 : 1), qPrintable(lines.join(QLatin1Char('\n'))));
    QVERIFY2(said.isEmpty() || lines.front().startsWith(said), qPrintable(lines.value(0)));
  }

  void valuesBesideOtherOptions_areTaken_data() {
    QTest::addColumn<QByteArray>("text");
    for (const char* text :
         {"planner: orca\nvalues:\n  robot2.planner: [pursuit, dwa]\n",
          "planner: dwa\nvalues:\n  robot1.type: [generic, pmb2]\n",
          "planner: dwa\nvalues:\n  robot1: [{start: {x: 1.0, y: 1.0}, goal: {x: 3.0, y: 3.0}}]\n",
          "planner: dwa\nvalues:\n  robot1: [{max_vel: 0.5}, {max_vel: 0.8}]\n",
          "values:\n  robot1: [{planner: dwa}, {planner: orca, max_vel: 0.5}]\n",
          "values:\n  robot1: [{planner: pursuit, planner_parameters: {lookahead: 1.0}}, {planner: "
          "orca}]\n",
          "model: sfm\nvalues:\n  anna.model: [orca]\n",
          "values:\n  robot1.planner: [pursuit, dwa]\n  duration: [4.0]\n  model: [sfm, orca]\n"}) {
      newRow(text) << QByteArray(text);
    }
  }
  void valuesBesideOtherOptions_areTaken() {
    QFETCH(QByteArray, text);
    writeScenario(
        "two.yaml",
        QByteArray(outside::kYardText).replace("robots: [robot1]", "robots: [robot1, robot2]") +
            "    robot2:\n      start: {x: 4.0, y: -3.0, h: 1.5}\n");
    const QByteArray file = "hunavsim_experiment: 1\nscenarios: [two.yaml]\n" + text;
    const auto read = app::parseExperiment(file.toStdString(),
                                           folder_.path(QStringLiteral("e.yaml")).toStdString());
    QVERIFY2(read.diagnostics().empty(),
             qPrintable(linesOf(read.diagnostics()).join(QLatin1Char('\n'))));
  }

  /// A robot that is called otherwise has its planner elsewhere; told if one scenario has it so.
  void firstRobot_isThatOfTheScenario() {
    writeScenario("tiago.yaml", QByteArray(outside::kYardText).replace("robot1", "tiago"));
    const auto linesWith = [this](const std::string& path) {
      const auto read = app::parseExperiment(
          "hunavsim_experiment: 1\nscenarios: [tiago.yaml]\nplanner: orca\nvalues:\n  " + path +
              ": [dwa]\n",
          folder_.path(QStringLiteral("e.yaml")).toStdString());
      return linesOf(read.diagnostics());
    };
    QVERIFY(linesWith("tiago.planner")
                .value(0)
                .startsWith(QStringLiteral(
                    "5:3 error 'tiago.planner' is also set by the experiment's key 'planner'")));
    QVERIFY(linesWith("robot1.planner").value(0).contains(QStringLiteral("unknown path")));
  }

  /// Names, and all else that runs with these values would fail of, each at its place.
  void everyValue_isCheckedAtItsPlace_data() {
    QTest::addColumn<QByteArray>("values");
    QTest::addColumn<QStringList>("said");
    const auto add = [](const char* values, const QStringList& said) {
      newRow(values) << QByteArray(values) << said;
    };
    const auto line = [](const char* text) { return QString::fromLatin1(text); };
    add("  robot1.planner: [dwa, pursui]\n  model: [sfm, sfmm]\n  robot1.type: [generic, genric]\n",
        {line("4:25 error robot1: planner 'pursui' is unknown (did you mean 'pursuit'?"),
         line("5:16 error model 'sfmm' is unknown (did you mean 'sfm'?"),
         line("6:26 error robot1: type 'genric' is unknown (did you mean 'generic'?")});
    add("  robot1.planner: [pursui, dwa]\n  model: [sfmm]\n",
        {line("4:20 error robot1: planner 'pursui' is unknown"),
         line("5:11 error model 'sfmm' is unknown")});
    add("  robot1.planner: {choice: [pursuit, dva]}\n",
        {line("4:38 error robot1: planner 'dva' is unknown")});
    add("  anna.model: [sfm, orka]\n", {line("4:21 error anna: model 'orka' is unknown")});
    add("  \"*.behavior.type\": [Skared, Scared]\n",
        {line("4:23 warning anna.behavior.type: 'Skared' is not a HuNavSim behaviour")});
    add("  \"*.model\": [sfm, orka]\n", {line("4:20 error anna: model 'orka' is unknown")});
    add("  anna.behavior.type: [Scared, Skared]\n",
        {line("4:32 warning anna.behavior.type: 'Skared' is not a HuNavSim behaviour")});
    add("  anna.goals: [[1, 2], [2, 7]]\n", {line("4:24 error anna: goal 7 ")});
    add("  robot1.planner: [pursuit, dwa]\n  robot1.planner_parameters: [{lookahead: 1.0}]\n",
        {line("4:29 error robot1.planner_parameters.lookahead: ")});
    add("  robot1: [{planner: dwa}, {planner: dwaa, max_vel: 0.5}, {mas_vel: 1.0}]\n",
        {line("4:28 error robot1: planner 'dwaa' is unknown (did you mean 'dwa'?"),
         line("4:59 error unknown path 'robot1.mas_vel' (did you mean 'robot1.max_vel'?)")});
    add("  robot1.planner: [nav2, dwa, orca]\n  nav2.FollowPath.batch_size: [100]\n",
        {line("4:26 error nav2.FollowPath.batch_size: no robot is driven by planner nav2"),
         line("4:31 error nav2.FollowPath.batch_size: no robot is driven by planner nav2")});
  }
  void everyValue_isCheckedAtItsPlace() {
    QFETCH(const QByteArray, values);
    QFETCH(const QStringList, said);
    const QStringList lines = linesOf(study("values:\n" + values).diagnostics());
    QVERIFY2(lines.size() == said.size(), qPrintable(lines.join(QLatin1Char('\n'))));
    for (int k = 0; k < said.size(); ++k) {
      QVERIFY2(lines[k].startsWith(said[k]), qPrintable(lines[k]));
    }
  }

  /// As the run has them: the planner that an earlier path chose has the parameters.
  void values_areTriedBesideTheFirstOnes() {
    for (const char* values :
         {"planner: nav2\nvalues:\n  nav2.FollowPath.batch_size: [100, 200]\n",
          "values:\n  robot1.planner: [nav2]\n  nav2.FollowPath.batch_size: [100, 200]\n",
          "values:\n  robot1.planner: [dwa]\n  robot1.planner_parameters.horizon: [1.0, 2.0]\n",
          "values:\n  robot1.planner_parameters: [{horizon: 1.0}]\n  robot1.planner: [dwa]\n"}) {
      const auto read = study(values);
      QVERIFY2(read.diagnostics().empty(),
               qPrintable(linesOf(read.diagnostics()).join(QLatin1Char('\n'))));
    }
  }

  /// What the scenario says wrong by itself is told there, not of values.
  void errorsOfTheScenario_areNoneOfValues() {
    writeScenario("wrong.yaml",
                  QByteArray(outside::kYardText).replace("goals: [2, 1]", "goals: [9]"));
    const std::string file = folder_.path(QStringLiteral("e.yaml")).toStdString();
    const auto read = app::parseExperiment(
        "hunavsim_experiment: 1\nscenarios: [wrong.yaml]\nvalues:\n  anna.max_vel: [1.0, 1.1]\n",
        file);
    QVERIFY(read && read.diagnostics().empty());
    const base::Diagnostics said = app::ExperimentRunner(*read, {}, {}).check();
    QVERIFY(said.size() == 1 && said.front().file.find("wrong.yaml") != std::string::npos);
  }

  /// A range of many is tried at its ends and one step, by who looks for code that runs start too.
  void rangeOfMany_costsNoMoreThanAFew() {
    const auto start = std::chrono::steady_clock::now();
    const auto read = study("seeds: 1\nvalues:\n  robot1.max_vel: {range: [0.5, 1.5, 0.00001]}\n");
    QVERIFY(read && read->runCount() == 100001);
    QVERIFY(app::ExperimentRunner(*read, {}, {}).check().empty());
    QVERIFY(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  }
  void ends_ofARange_haveTheirPlaces() {
    const QStringList lines = linesOf(study("values:\n  anna.max_vel: {range: [-1.0, 2.0, 0.5]}\n"
                                            "  robot1.goal_radius: {range: [0.5, -0.5, -0.1]}\n"
                                            "  stuck_after: {range: [1, 2000000, 1999999]}\n")
                                          .diagnostics());
    QVERIFY2(lines.value(1).startsWith(QStringLiteral("4:26 error anna.max_vel")) ||
                 lines.value(0).startsWith(QStringLiteral("4:26 error anna.max_vel")),
             qPrintable(lines.join(QLatin1Char('\n'))));
    QVERIFY2(lines.last().startsWith(QStringLiteral("6:28 error stuck_after")),
             qPrintable(lines.join(QLatin1Char('\n'))));
  }

  void textsListedTwice_areWarnedOf_data() {
    QTest::addColumn<QByteArray>("values");
    QTest::addColumn<QStringList>("said");
    const auto add = [](const char* values, const QStringList& said) {
      newRow(values) << QByteArray(values) << said;
    };
    add("  robot1: [{planner: dwa}, {planner: orca}, { \"planner\": dwa }]\n",
        {QStringLiteral("4:45 warning '{planner: dwa}' is listed twice")});
    add("  anna.goals: [[1, 2], [2, 1], [1,2]]\n",
        {QStringLiteral("4:32 warning '[1, 2]' is listed twice")});
    add("  robot1: [{planner: dwa}, {planner: dwa, max_vel: 0.5}]\n", {});
    add("  robot1.planner: [dwa, dwa]\n", {QStringLiteral("4:25 warning 'dwa' is listed twice")});
  }
  void textsListedTwice_areWarnedOf() {
    QFETCH(const QByteArray, values);
    QFETCH(const QStringList, said);
    const QStringList lines = linesOf(study("values:\n" + values).diagnostics());
    QVERIFY2(lines.size() == said.size(), qPrintable(lines.join(QLatin1Char('\n'))));
    for (int k = 0; k < said.size(); ++k) {
      QVERIFY2(lines[k].startsWith(said[k]), qPrintable(lines[k]));
    }
  }

  /// Seeds that make no difference with any of the values.
  void seedsAlike_areWarnedOf_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isWarned");
    const auto add = [](const char* text, bool isWarned) {
      newRow(text) << QByteArray(text) << isWarned;
    };
    add("seeds: 3\n", true);
    add("seeds: 1\n", false);
    add("seeds: 3\nvalues:\n  variation.preset: [none]\n", true);
    add("seeds: 3\nvalues:\n  variation.preset: [none, light]\n", false);
    add("seeds: 3\nvalues:\n  variation.preset: [light]\n  robot1.planner: [dwa, orca]\n", false);
    add("seeds: 3\nvalues:\n  variation.speed.kind: [none]\n  variation.speed.sd: [0.1, 0.2]\n",
        true);
    add("seeds: 3\nvalues:\n  variation.speed.kind: [none, normal]\n"
        "  variation.speed.sd: [0.1, 0.2]\n",
        false);
    add("seeds: 3\nvalues:\n  anna.behavior.configuration: [0]\n", true);
    add("seeds: 3\nvalues:\n  anna.behavior.configuration: [0, 3]\n", false);
    add("seeds: 3\nvalues:\n  robot1.planner: [dwa, orca]\n  robot1.max_vel: [1.0, 1.1]\n", true);
    add("seeds: 3\nvalues:\n  anna.max_vel: {uniform: [1.0, 1.1]}\n", false);
  }
  void seedsAlike_areWarnedOf() {
    QFETCH(const QByteArray, text);
    QFETCH(const bool, isWarned);
    writeScenario("fixed.yaml",
                  QByteArray(outside::kYardText).replace("configuration: 2", "configuration: 0"));
    const auto read = app::parseExperiment(
        ("hunavsim_experiment: 1\nscenarios: [fixed.yaml]\n" + text).toStdString(),
        folder_.path(QStringLiteral("e.yaml")).toStdString());
    QVERIFY2(read, qPrintable(linesOf(read.diagnostics()).join(QLatin1Char('\n'))));
    base::Diagnostics alike;
    for (const base::Diagnostic& said : read.diagnostics()) {
      if (said.code == "experiment.seeds-alike") {
        alike.push_back(said);
      }
    }
    const QStringList lines = linesOf(alike);
    QCOMPARE(lines.size(), isWarned ? 1 : 0);
    if (isWarned) {
      QVERIFY2(lines.front().startsWith(QStringLiteral("3:8 warning")), qPrintable(lines.front()));
      QVERIFY2(lines.front().contains(QStringLiteral("'fixed.yaml'")), qPrintable(lines.front()));
    }
  }
};

QTEST_GUILESS_MAIN(ExperimentCheckTest)
#include "tst_ExperimentCheck.moc"
