#include <QCryptographicHash>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OutputFolder.h"
#include "app/run/RunSpec.h"
#include "editor/document/MapEdit.h"
#include "tests/app/RunFiles.h"

using namespace outside;

/// `run --from RUN@SECONDS` from outside.
class RunFromTest : public QObject {
  Q_OBJECT

 private:
  static constexpr const char* kFiles[] = {"trajectory.csv", "events.csv",  "trees.csv",
                                           "metrics.json",   "metrics.csv", "steps.csv",
                                           "trace.json"};

  QTemporaryDir ground_;

  QString at(const char* name) const { return ground_.filePath(text(name)); }
  static void run(const QStringList& words) {
    const Finished found = runProgram(list("run -q") + words);
    QVERIFY2(found.exitCode == 0, qPrintable(words.join(QLatin1Char(' ')) + found.err));
  }
  static Finished refused(const QStringList& words) { return runProgram(list("run -q") + words); }
  static QString scene(const char* name) { return text(SOURCE_DIR "/maps/") + text(name); }

  /// Rows of the trajectory up to a step, or those behind it.
  static QByteArray rows(const QString& folder, int step, bool isBefore) {
    QByteArray found;
    const QList<QByteArray> lines = bytesOf(folder + text("/trajectory.csv")).split('\n');
    for (int k = 1; k < lines.size(); ++k) {
      if (!lines[k].isEmpty() && (lines[k].split(',').first().toInt() <= step) == isBefore) {
        found += lines[k] + '\n';
      }
    }
    return found;
  }
  static QJsonObject jsonOf(const QString& file) {
    return QJsonDocument::fromJson(bytesOf(file)).object();
  }

 private Q_SLOTS:
  void unchanged_isTheOriginal_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* name, const QString& scenario, const char* words) {
      QTest::newRow(name) << QStringList{scenario} +
                                 text(words).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    const QString crossing = scene("planners/crossing_agents.yaml");
    row("sampling planner", crossing, "--duration 4 --seed 3 --planner mppi");
    row("errors of sensors", crossing,
        "--duration 4 --planner dwa --set *.max_vel=0.9 --set robot1.lidar.noise=0.02 "
        "--set robot1.odometry_noise.alpha1=0.1");
    row("errors of a localiser", crossing,
        "--duration 4 --planner nav2 --nav2-params turtlebot4 --set robot1.localization.std_x=0.1 "
        "--set robot1.localization.std_yaw=0.05 --set robot1.localization.jump_rate=0.5 "
        "--set robot1.localization.jump_distance=0.2");
    row("every fifth step", crossing, "--duration 4 --record-every 5 --planner orca");
    row("forces of the original", crossing, "--duration 4 --compat hunav2");
    row("end of a navigator", crossing,
        "--duration 4 --planner nav2 --nav2-params " SOURCE_DIR
        "/maps/planners/nav2_rpp.yaml --set robot1.goal.x=2.2");
    row("people alone", scene("two_workers/two_workers_agents.yaml"), "--duration 4 --exact");
  }
  void unchanged_isTheOriginal() {
    QFETCH(QStringList, words);
    QTemporaryDir ground;
    const QString first = ground.filePath(text("first"));
    const QString again = ground.filePath(text("again"));
    run(words + list("-o %", {first}));
    for (const char* time : {"0", "1.73", "4"}) {
      run({text("--from"), first + QLatin1Char('@') + text(time), text("-o"), again});
      for (const char* file : kFiles) {
        QVERIFY2(!bytesOf(first + QLatin1Char('/') + text(file)).isEmpty() ||
                     !QFile::exists(first + QLatin1Char('/') + text(file)),
                 file);
        QCOMPARE(bytesOf(again + QLatin1Char('/') + text(file)),
                 bytesOf(first + QLatin1Char('/') + text(file)));
      }
    }
    const QJsonObject from = jsonOf(again + text("/manifest.json"))[text("from")].toObject();
    QCOMPARE(from[text("run")].toString(), first);
    QCOMPARE(from[text("time")].toDouble(), 4.0);
    QCOMPARE(from[text("step")].toInt(), 80);
  }

  void ofABatch_isTheOriginal() {
    writeText(at("e.yaml"), "hunavsim_experiment: 1\nscenarios: [" +
                                scene("planners/doorway_agents.yaml").toUtf8() +
                                "]\nduration: 2\nseeds: 2\nrecord: all\n"
                                "values:\n  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n");
    QCOMPARE(runProgram("batch % -q -o %", {at("e.yaml"), at("batch")}).exitCode, 0);
    run({text("--from"), at("batch/runs/1@1"), text("-o"), at("ofBatch")});
    for (const char* file : kFiles) {
      QCOMPARE(bytesOf(at("ofBatch/") + text(file)), bytesOf(at("batch/runs/1/") + text(file)));
    }
  }

  void anotherPlanner_drivesFromThere() {
    const QString crossing = scene("planners/crossing_agents.yaml");
    run({crossing, text("--duration"), text("6"), text("-o"), at("straight")});
    run({text("--from"), at("straight@2"), text("--planner"), text("social_force"), text("--set"),
         text("robot1.max_vel=0.4"), text("-o"), at("other")});
    QCOMPARE(rows(at("other"), 40, true), rows(at("straight"), 40, true));
    QVERIFY(rows(at("other"), 40, false) != rows(at("straight"), 40, false));
    const QJsonObject robot =
        jsonOf(at("other/trace.json"))[text("robots")].toArray().first().toObject();
    QCOMPARE(robot[text("planner")].toString(), text("social_force"));
    double fastest = 0.0;  // after it has had time to slow down
    for (const auto& row : readCsv(at("other/trajectory.csv"))) {
      if (row.at(text("kind")) == text("robot") && row.at(text("step")).toInt() > 80) {
        fastest = std::max(
            fastest, std::hypot(row.at(text("vx")).toDouble(), row.at(text("vy")).toDouble()));
      }
    }
    QVERIFY2(fastest > 0.1 && fastest <= 0.4 + 1e-6, qPrintable(QString::number(fastest)));
    // and on from there, as it was
    run({text("--from"), at("other@3"), text("-o"), at("third")});
    QCOMPARE(bytesOf(at("third/trajectory.csv")), bytesOf(at("other/trajectory.csv")));
    QCOMPARE(bytesOf(at("third/trace.json")), bytesOf(at("other/trace.json")));
    // the later word wins, whatever it is called
    run({text("--from"), at("third@4"), text("--set"), text("robot1.planner=orca"), text("-o"),
         at("fourth")});
    QVERIFY(rows(at("fourth"), 80, false) != rows(at("third"), 80, false));
    const QJsonObject last =
        jsonOf(at("fourth/trace.json"))[text("robots")].toArray().first().toObject();
    QCOMPARE(last[text("planner")].toString(), text("orca"));
    for (const char* older : {"straight", "other", "third"}) {
      const QByteArray before = bytesOf(at(older) + text("/trajectory.csv"));
      QCOMPARE(unexpected(refused({text("--from"), at("fourth@1"), text("-o"), at(older)}), 2,
                          "would be overwritten"),
               QString());
      QCOMPARE(bytesOf(at(older) + text("/trajectory.csv")), before);
    }
  }

  /// A navigation that has ended stays ended in a run that continues from there, also with another
  /// file; one that is under way continues, or restarts.
  void navigatorsEnd_isKept() {
    const auto ends = [this](const char* folder) {
      std::vector<double> times;
      for (const auto& row : readCsv(at(folder) + text("/events.csv"))) {
        if (row.at(text("kind")) == text("navigation_succeeded")) {
          times.push_back(row.at(text("time")).toDouble());
        }
      }
      return times;
    };
    run({scene("planners/crossing_agents.yaml"), text("--duration"), text("8"), text("--planner"),
         text("nav2"), text("--nav2-params"), scene("planners/nav2_rpp.yaml"), text("--set"),
         text("robot1.goal.x=2.2"), text("-o"), at("navigated")});
    const std::vector<double> original = ends("navigated");
    QCOMPARE(original.size(), std::size_t{1});
    QVERIFY(original.front() > 1.0 && original.front() < 6.0);
    const QString slower = text("nav2.FollowPath.desired_linear_vel=0.3");
    run({text("--from"), at("navigated@7"), text("--set"), slower, text("-o"), at("after")});
    QCOMPARE(ends("after"), original);
    QCOMPARE(bytesOf(at("after/trajectory.csv")), bytesOf(at("navigated/trajectory.csv")));
    run({text("--from"), at("navigated@0.5"), text("--set"), slower, text("-o"), at("within")});
    QCOMPARE(ends("within").size(), std::size_t{1});
    QVERIFY(ends("within").front() > original.front() + 0.5);
  }

  void anotherSeed_drawsAnewFromThere() {
    const QStringList words =
        list("% --duration 8 --planner mppi --seed 5", {scene("planners/crowd_agents.yaml")});
    run(words + list("-o %", {at("five")}));
    for (const char* seed : {"5", "6"}) {
      const QString folder = at("seed") + text(seed);
      run({text("--from"), at("five@2"), text("--seed"), text(seed), text("-o"), folder});
      QCOMPARE(rows(folder, 40, true), rows(at("five"), 40, true));
      QCOMPARE(rows(folder, 40, false) == rows(at("five"), 40, false), text(seed) == text("5"));
      const QJsonObject manifest = jsonOf(folder + text("/manifest.json"));
      QCOMPARE(manifest[text("seed")].toInt(), 5);  // of the people
      QCOMPARE(manifest[text("from")].toObject()[text("seed")].toInt(), text(seed).toInt());
    }
  }

  /// As the window gives them: each kind of hand on a person, and an entry of a blackboard.
  static sim2d::StepInputs byHand(std::int64_t step, const sim2d::TraceHeader& header) {
    sim2d::Input input;
    input.id = header.humans.front().id;
    switch (step) {
      case 10:
        input.kind = sim2d::InputKind::Push;
        input.velocity = {1.0 / 3.0, -0.7};
        return {input};
      case 20:
        input.kind = sim2d::InputKind::Stop;
        return {input};
      case 30:
        input.kind = sim2d::InputKind::Add;
        input.id = 0;
        input.name = header.humans.front().name;
        input.pose = {{static_cast<double>(header.humans.size()) * 0.1 - 1.0, 1.0 / 7.0}, 0.3};
        return {input};
      case 40:
        input.kind = sim2d::InputKind::Resume;
        return {input};
      case 50:
        input.kind = sim2d::InputKind::Entry;
        input.name = "mood=4";
        return {input};
      default:
        return {};
    }
  }

  void hands_areRepeatedByteForByte() {
    app::RunSpec options;
    options.scenario = scene("two_workers/two_workers_agents.yaml").toStdString();
    options.duration = 4.0;
    const auto settings = app::runSettingsOf(options);
    QVERIFY(bool(settings));
    const app::Bundle bundle = app::readBundle(options, *settings, editor::loadMapImage);
    app::Verdict verdict = app::check(bundle);
    QVERIFY(verdict.ok() && verdict.world != nullptr);
    const std::string folder = at("hands").toStdString();
    auto output = app::OutputFolder::open(folder, false);
    QVERIFY(bool(output));
    const sim2d::TraceHeader header = verdict.world->header();
    app::RunWriter writer((*output)->staging(), *verdict.world, header, verdict.metrics.selection,
                          verdict.metrics.parameters);
    app::Session session(sim2d::stopRuleOf(*bundle.scenario));
    session.steer([&header](const sim2d::Frame& frame) { return byHand(frame.step, header); });
    app::FinishedRun made = app::simulate(session, *verdict.world, verdict.scenarioMetrics, writer,
                                          [](const sim2d::Frame&) { return false; });
    QVERIFY(app::writeRunFolder(**output, made, writer, bundle,
                                {"hunavsim", "run", options.scenario, "--duration", "4"})
                .empty());
    output = std::unique_ptr<app::OutputFolder>();
    QStringList kinds;
    for (const auto& row : readCsv(at("hands/inputs.csv"))) {
      kinds << row.at(text("input"));
    }
    QVERIFY2(kinds.size() >= 4, qPrintable(kinds.join(QLatin1Char(' '))));
    for (const char* kind : {"push", "stop", "add", "resume"}) {
      QVERIFY2(kinds.contains(text(kind)), kind);
    }
    for (const char* time : {"0", "2.5", "4"}) {
      run({text("--from"), at("hands@") + text(time), text("-o"), at("handsAgain")});
      for (const char* file : {"trajectory.csv", "events.csv", "trees.csv", "inputs.csv",
                               "trace.json", "metrics.csv"}) {
        QCOMPARE(bytesOf(at("handsAgain/") + text(file)), bytesOf(at("hands/") + text(file)));
      }
    }
  }

  void moved_standsThere() {
    const QString workers = scene("two_workers/two_workers_agents.yaml");
    run({workers, text("--duration"), text("2"), text("-o"), at("workers")});
    const QString name = jsonOf(at("workers/trace.json"))[text("humans")]
                             .toArray()
                             .first()
                             .toObject()[text("name")]
                             .toString();
    const auto first = readCsv(at("workers/trajectory.csv")).front();
    const double x = first.at(text("x")).toDouble() + 0.4, y = first.at(text("y")).toDouble();
    run({text("--from"), at("workers@1"), text("--move"),
         text("%1 %2 %3 0.5").arg(name).arg(x, 0, 'g', 17).arg(y, 0, 'g', 17), text("-o"),
         at("moved")});
    QCOMPARE(rows(at("moved"), 20, true), rows(at("workers"), 20, true));
    const auto inputs = readCsv(at("moved/inputs.csv"));
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs.front().at(text("step")).toInt(), 21);
    for (const auto& row : readCsv(at("moved/trajectory.csv"))) {
      if (row.at(text("step")).toInt() == 21 && row.at(text("id")) == first.at(text("id"))) {
        QVERIFY(std::hypot(row.at(text("x")).toDouble() - x, row.at(text("y")).toDouble() - y) <
                0.15);  // a step from standing
      }
    }
    // the input is part of the run
    run({text("--from"), at("moved@1.5"), text("-o"), at("movedAgain")});
    QCOMPARE(bytesOf(at("movedAgain/trajectory.csv")), bytesOf(at("moved/trajectory.csv")));
  }

  void ofTheStandardInput_isRefusedAndDoesNotWait() {
    QProcess process;
    process.setStandardInputFile(scene("planners/crossing_agents.yaml"));
    process.start(text(HUNAVSIM_PROGRAM), {text("run"), text("-q"), text("-"), text("--duration"),
                                           text("1"), text("-o"), at("said")});
    const Finished first = finishedOf(process);
    QVERIFY2(first.exitCode == 0, qPrintable(first.err));
    QCOMPARE(
        unexpected(refused({text("--from"), at("said@0.5")}), 2, "was read from standard input"),
        QString());
  }

  void wrong_isSaid_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* words, int code, const char* says) {
      QTest::newRow(words) << text(words) << code << text(says);
    };
    row("--from @/run", 64, "--from takes RUN@SECONDS");
    row("--from @/run@-1", 64, "--from takes RUN@SECONDS");
    row("--from @/run@nan", 64, "--from takes RUN@SECONDS");
    row("--from @/run@1 --dt 0.1", 64, "--dt cannot change in a run that continues another");
    row("--from @/run@1 --model sfm --map none", 64, "--model cannot change");
    row("@/s.yaml --from @/run@1", 64, "the scenario cannot change");
    row("@/s.yaml --move anna,1,1,0", 64, "--move requires --from");
    row("--from @/run@1 --move anna,1", 64, "--move takes a name and three numbers");
    row("--from @/run@1 --move nobody,1,1,0", 2, "there is no person 'nobody'");
    row("--from @/nothing@1", 2, "nothing");
    row("--from @/run@9", 2, "the run ends at 2 s, before 9 s");
    row("--from @/run@1 --set *.radius=0.2", 2, "--set *.radius=0.2: this cannot change");
    row("--from @/run@1 --planner nonsense", 64, "nonsense");
    row("--from @/run@1 --duration 0.5", 2, "the run ends at 0.5 s, before 1 s");
    row("--from @/run@1 -o @/run", 2, "would be overwritten");
    row("--from @/foreign@1", 2, "no record of how the run was created");
    row("--from @/older@1", 2, "no longer the input of the run");
    row("--from @/damaged@1", 2, "replay diverges from the recording at 0.5 s");
  }
  void wrong_isSaid() {
    QFETCH(QString, words);
    QFETCH(int, code);
    QFETCH(QString, says);
    QTemporaryDir ground;
    const auto in = [&ground](const char* name) { return ground.filePath(text(name)); };
    QVERIFY(QFile::copy(scene("planners/crossing_agents.yaml"), in("s.yaml")));
    run({in("s.yaml"), text("--duration"), text("2"), text("-o"), in("run")});
    copyFolder(in("run"), in("foreign"));
    QJsonObject manifest = jsonOf(in("run/manifest.json"));
    QJsonObject foreign = manifest;
    foreign[text("command_line")] = QJsonArray{text("hunavsim"), text("evaluate"), text("x")};
    writeText(in("foreign/manifest.json"), QJsonDocument(foreign).toJson());
    copyFolder(in("run"), in("damaged"));
    QByteArray trajectory = bytesOf(in("damaged/trajectory.csv"));
    const int row = trajectory.indexOf("\n10,0.5,");
    const int number = trajectory.indexOf(",human,", row) + 7;
    QVERIFY(row > 0 && number > 7);
    trajectory.insert(number, trajectory[number] == '-' ? "-1" : "1");
    writeText(in("damaged/trajectory.csv"), trajectory);
    const QString sum = QString::fromLatin1(
        QCryptographicHash::hash(trajectory, QCryptographicHash::Sha256).toHex());
    QJsonArray outputs = manifest[text("outputs")].toArray();
    for (int k = 0; k < outputs.size(); ++k) {
      QJsonObject output = outputs[k].toObject();
      if (output[text("path")].toString() == text("trajectory.csv")) {
        output[text("sha256")] = sum;
        outputs[k] = output;
      }
    }
    manifest[text("outputs")] = outputs;
    writeText(in("damaged/manifest.json"), QJsonDocument(manifest).toJson());
    if (words.contains(text("older"))) {
      QVERIFY(QDir().rename(in("run"), in("older")));
      writeText(in("s.yaml"), bytesOf(in("s.yaml")) + "# another one\n");
    }
    QStringList given = words.replace(QLatin1Char('@') + text("/"), ground.path() + text("/"))
                            .split(QLatin1Char(' '));
    if (!given.contains(text("-o"))) {
      given << text("-o") << in("new");
    }
    const QByteArray before = bytesOf(in("run/trajectory.csv"));
    const Finished found = refused(given);
    QCOMPARE(found.exitCode, code);
    QVERIFY2(found.err.contains(says), qPrintable(found.err));
    QVERIFY(!QFile::exists(in("new")));
    QCOMPARE(bytesOf(in("run/trajectory.csv")), before);
  }
};

QTEST_GUILESS_MAIN(RunFromTest)
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "tst_RunFrom.moc"
