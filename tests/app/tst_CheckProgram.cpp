#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// `hunavsim check` from outside.
class CheckProgramTest : public QObject {
  Q_OBJECT

 private:
  static QStringList filesIn(const QString& folder, const char* pattern) {
    QStringList paths;
    for (const QFileInfo& info : QDir(folder).entryInfoList({QString::fromLatin1(pattern)})) {
      paths << info.filePath();
    }
    return paths;
  }

 private Q_SLOTS:
  void check_badFiles_sameLinesAsReaders_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("pattern");
    QTest::newRow("scenarios") << text(TEST_DATA_DIR "/scenario/bad") << text("*.yaml");
    QTest::newRow("trees") << text(TEST_DATA_DIR "/bt/bad") << text("*.xml");
  }
  /// All at once: exit code 2, every line names a file of the folder, and each file with an error
  /// of its own has exit code 2 when checked alone.
  void check_badFiles_sameLinesAsReaders() {
    QFETCH(QString, folder);
    QFETCH(QString, pattern);
    const QStringList files = filesIn(folder, pattern.toLatin1().constData());
    QVERIFY(files.size() > 20);
    const Finished all = runProgram(list("check") + files + list("--map none"));
    QCOMPARE(all.exitCode, 2);
    const QStringList lines = all.err.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QRegularExpression shape(text("^[^:]+(:[1-9][0-9]*){0,2}: (info|warning|error): \\S"));
    int errors = 0;
    for (const QString& line : lines) {
      QVERIFY2(shape.match(line).hasMatch(), qPrintable(line));
      errors += line.contains(text(": error: ")) ? 1 : 0;
    }
    QVERIFY2(errors >= files.size() / 2, qPrintable(QString::number(errors)));
  }

  void check_strict_substitutionsAreErrors() {
    QTemporaryDir folder;
    const QByteArray pursuit =
        "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: "
        "\"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\"\n";
    writeText(folder.filePath(text("plain.yaml")), pursuit);
    writeText(folder.filePath(text("layer.yaml")),
              "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
              "      plugins: [sonar]\n"
              "      sonar: {plugin: \"my_layers::SonarLayer\"}\n");
    const auto externalCodeOfStudy = [&folder](const char* words) {
      return runProgram(QString::fromLatin1(words).split(QLatin1Char(' ')), folder.path()).exitCode;
    };
    QCOMPARE(externalCodeOfStudy("check plain.yaml layer.yaml"), 0);
    QCOMPARE(externalCodeOfStudy("check plain.yaml --strict"), 0);
    QCOMPARE(externalCodeOfStudy("check layer.yaml --strict"), 2);
    QCOMPARE(externalCodeOfStudy("check --nav2-params plain.yaml --nav2-params layer.yaml"), 0);
    QCOMPARE(
        externalCodeOfStudy("check --nav2-params plain.yaml --nav2-params layer.yaml --strict"), 2);
    QCOMPARE(externalCodeOfStudy(
                 "check --nav2-params plain.yaml --nav2-params FollowPath.lookahead_dist:=1"),
             2);
    QCOMPARE(externalCodeOfStudy(
                 "check --nav2-params plain.yaml --nav2-params FollowPath.lookahead_dist:=1.0"),
             0);
    QCOMPARE(externalCodeOfStudy("check"), 64);
    QCOMPARE(
        externalCodeOfStudy(
            "run crossing_agents --planner nav2 --nav2-params plain.yaml --nav2-params layer.yaml "
            "--strict --duration 0.1"),
        2);
  }

  void check_nav2Distro_readsItsKeys_data() {
    QTest::addColumn<QString>("distro");
    QTest::addColumn<QStringList>("read");     // keys that it has
    QTest::addColumn<QStringList>("refused");  // sentences about the others
    const auto of = [](const char* title, const std::vector<const char*>& keys) {
      QStringList sentences;
      for (const char* const key : keys) {
        sentences << text(key) + text(": ") + text(title) + text(" does not read it");
      }
      return sentences;
    };
    const char* const jazzyTimeout =
        "planner_server.action_server_result_timeout is a key of Jazzy";
    const char* const services = "planner_server.service_introspection_mode is a key of Kilted";
    const char* const filter = "bt_navigator.filter_duration is a key of Kilted, Lyrical and main";
    const char* const partial =
        "planner_server.allow_partial_planning is a key of Lyrical and main";
    QTest::newRow("jazzy") << "jazzy" << QStringList{text("action_server_result_timeout")}
                           << of("Jazzy", {services, filter, partial});
    QTest::newRow("kilted") << "kilted"
                            << QStringList{text("service_introspection_mode"),
                                           text("filter_duration")}
                            << of("Kilted", {jazzyTimeout, partial});
    QTest::newRow("lyrical") << "lyrical"
                             << QStringList{text("filter_duration"), text("allow_partial_planning")}
                             << of("Lyrical", {jazzyTimeout, services});
  }

  /// The distribution is used, reported, and rejects keys of others. The manifest names it too.
  void check_nav2Distro_readsItsKeys() {
    QFETCH(QString, distro);
    QFETCH(QStringList, read);
    QFETCH(QStringList, refused);
    QTemporaryDir folder;
    const QString file = folder.filePath(text("p.yaml"));
    writeText(file,
              "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: "
              "\"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\"\n"
              "planner_server:\n  ros__parameters:\n    action_server_result_timeout: 10.0\n"
              "    service_introspection_mode: \"disabled\"\n"
              "    allow_partial_planning: true\n"
              "bt_navigator:\n  ros__parameters:\n    filter_duration: 0.3\n");
    const Finished checked = runProgram("check % --nav2-distro %", {file, distro});
    QCOMPARE(checked.exitCode, 0);
    for (const QString& sentence : std::as_const(refused)) {
      QVERIFY2(checked.err.contains(sentence), qPrintable(checked.err));
    }
    for (const QString& key : std::as_const(read)) {
      QVERIFY2(!checked.err.contains(key + text(" is a key of")), qPrintable(checked.err));
    }
    QCOMPARE(checked.err.count(text("does not read it")), refused.size());
    QVERIFY2(!checked.err.contains(text("read as a file of")),
             qPrintable(checked.err));  // no guess

    const QString out = folder.filePath(text("out"));
    QCOMPARE(failureOf("run crossing_agents --planner nav2 --nav2-params % --nav2-distro % "
                       "--duration 0.1 -q -o %",
                       {file, distro, out}),
             QString());
    const QJsonObject manifest =
        QJsonDocument::fromJson(bytesOf(out + text("/manifest.json"))).object();
    const QJsonObject nav2 =
        manifest[text("robots")].toArray().at(0).toObject()[text("nav2")].toObject();
    QCOMPARE(nav2[text("distro")].toString(), distro);
    QCOMPARE(nav2[text("distro_guessed")].toBool(true), false);
    QCOMPARE(runProgram("check % --nav2-distro iron", {file}).exitCode, 64);
  }

  void check_nav2DistroGuessed_isReported_data() {
    QTest::addColumn<QByteArray>("node");
    QTest::addColumn<QString>("message");
    QTest::newRow("kilted") << QByteArray(
                                   "bt_navigator:\n  ros__parameters: {filter_duration: 0.3}\n")
                            << "read as a file of kilted: line 6: key filter_duration";
    QTest::newRow("lyrical")
        << QByteArray("planner_server:\n  ros__parameters: {allow_partial_planning: true}\n")
        << "read as a file of lyrical: line 6: key allow_partial_planning";
  }

  void check_nav2DistroGuessed_isReported() {
    QFETCH(QByteArray, node);
    QFETCH(QString, message);
    QTemporaryDir folder;
    const QString file = folder.filePath(text("p.yaml"));
    writeText(file,
              "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: "
              "\"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\"\n" +
                  node);
    QCOMPARE(unexpected(runProgram("check %", {file}), 0, message), QString());
  }

  void check_experiment_itsScenariosAreChecked() {
    QTemporaryDir folder;
    const QByteArray scenario = bytesOf(text(SOURCE_DIR "/maps/planners/doorway_agents.yaml"));
    const QString file = folder.filePath(text("wrong_agents.yaml"));
    writeText(file, QByteArray(scenario).replace("max_vel: 1", "max_vel: -1"));
    const QString experiment = folder.filePath(text("e.yaml"));
    writeText(experiment, "hunavsim_experiment: 1\nscenarios: [wrong_agents.yaml]\nseeds: 2\n");
    const QStringList words = list("check %", {experiment});
    const Finished wrong = runProgram(words);
    QCOMPARE(wrong.exitCode, 2);
    QVERIFY2(wrong.err.contains(
                 QRegularExpression(text("wrong_agents.yaml:[0-9]+:[0-9]+: error: .*max_vel"))),
             qPrintable(wrong.err));
    writeText(file, scenario);
    QCOMPARE(failureOf(words), QString());
  }

  /// No row names a planner that never drove: neither one that an option of all runs would replace,
  /// nor one that does not exist.
  void check_valuesThatCannotCount_areErrors() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [doorway_agents]\nduration: 1.0\n"
              "values:\n  robot1.planner: [pursuit, dva]\n  duration: [4.0, 6.0]\n"
              "  seed: [5, 9]\n");
    const QString out = folder.filePath(text("out"));
    for (const QStringList& words :
         {list("check %", {experiment}), list("batch % -o %", {experiment, out})}) {
      const Finished found = runProgram(words);
      QCOMPARE(found.exitCode, 2);
      for (const char* place :
           {"e.yaml:5:29: error: robot1: planner 'dva'", "e.yaml:6:3: error: 'duration'",
            "e.yaml:7:3: error: the seed cannot be one of the values"}) {
        QVERIFY2(found.err.contains(QLatin1String(place)), qPrintable(found.err));
      }
    }
    QVERIFY(!QDir(out).exists());
  }

  /// libpng writes to the standard error by itself.
  void check_damagedImage_isToldByUsAlone() {
    QTemporaryDir folder;
    writeText(folder.filePath(text("room.yaml")),
              "image: room.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
              "occupied_thresh: 0.65\nfree_thresh: 0.2\n");
    QImage image(64, 64, QImage::Format_Grayscale8);
    image.fill(255);
    const QString png = folder.filePath(text("room.png"));
    QVERIFY(image.save(png));
    writeText(png, bytesOf(png).left(50));
    const Finished found = runProgram("check %", {folder.filePath(text("room.yaml"))});
    QCOMPARE(found.exitCode, 2);
    QCOMPARE(found.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(found.err.contains(text("room.png': cannot read the image")), qPrintable(found.err));
  }

  void check_aMillionPeople_isRefusedWithOnePlace() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("many.yaml"));
    QByteArray text = "hunav_loader:\n  ros__parameters:\n    agents:\n";
    for (int i = 1; i <= 1000000; ++i) {
      text += "      - agent" + QByteArray::number(i) + "\n";
    }
    writeText(file, text);
    for (const char* command : {"check", "run"}) {
      const Finished refused = runProgram("% % --map none", {QString::fromLatin1(command), file});
      QCOMPARE(refused.exitCode, 2);
      QCOMPARE(refused.err.trimmed(),
               file + QStringLiteral(":100004:9: error: more than 100000 people in agents, which "
                                     "is the limit"));
    }
  }

  /// Also what is wrong in meaning has line and column, and a missing map hides nothing.
  void check_meaning_hasPlaces() {
    QTemporaryDir folder;
    const QString file = folder.filePath(text("s.yaml"));
    writeText(file,
              "hunav_loader:\n"
              "  ros__parameters:\n"
              "    map: nowhere\n"
              "    global_goals:\n"
              "      1: {x: 0.0, y: 0.0}\n"
              "    agents: [anna]\n"
              "    anna:\n"
              "      id: 1\n"
              "      skin: 0\n"
              "      group_id: -1\n"
              "      max_vel: 1.0\n"
              "      radius: 0.4\n"
              "      behavior: {type: Regular, configuration: 0}\n"
              "      init_pose: {x: 1.0, y: 1.0, z: 1.0, h: 0.0}\n"
              "      goal_radius: 0.3\n"
              "      cyclic_goals: true\n"
              "      goals: [1, 9]\n"
              "hunavsim_desktop:\n"
              "  ros__parameters:\n"
              "    areas:\n"
              "      - {name: in, kind: source, polygon: [[0, 0], [1, 0], [1, 1]], like: bob}\n");
    const Finished found = runProgram("check %", {file});
    QCOMPARE(found.exitCode, 2);
    const QStringList starts = {text(":3:5: error: map 'nowhere' not found"),
                                text(":6:5: info: no tree file for 1 person"),
                                text(":7:5: error: anna: goal 9 is not defined")};
    for (const QString& start : starts) {
      QVERIFY2(found.err.contains(file + start), qPrintable(found.err));
    }
    for (const QString& line : found.err.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
      static const QRegularExpression place(text(":[1-9][0-9]*:[1-9][0-9]*: "));
      QVERIFY2(line.contains(place), qPrintable(line));
    }
  }

  void check_tree_saysEachThingOnce_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("lines");
    QTest::newRow("of the check") << text("unknown_port.xml") << 1;
    QTest::newRow("of the check and the compiler") << text("placeholders.xml") << 2;
  }
  void check_tree_saysEachThingOnce() {
    QFETCH(QString, file);
    QFETCH(int, lines);
    const Finished found = runProgram("check %", {text(TEST_DATA_DIR "/bt/bad/") + file});
    QCOMPARE(found.err.split(QLatin1Char('\n'), Qt::SkipEmptyParts).size(), lines);
    QVERIFY2(found.out.contains(text(" 0 errors, %1 warning").arg(lines)), qPrintable(found.out));
  }

  void check_json_knownFields() {
    const Finished found =
        runProgram("check % --json", {text(TEST_DATA_DIR "/scenario/bad/duplicate_key.yaml")});
    QCOMPARE(found.exitCode, 2);
    const QJsonArray all = QJsonDocument::fromJson(found.out.toUtf8()).array();
    QVERIFY(!all.isEmpty());
    const QJsonObject first = all[0].toObject();
    for (const char* key : {"file", "line", "column", "severity", "message"}) {
      QVERIFY2(first.contains(QString::fromLatin1(key)), key);
    }
    QVERIFY(first[text("line")].toInt() > 0);
  }

  void check_shippedFiles_areFine() {
    const Finished found =
        runProgram({text("check"), text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"),
                    text(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml")});
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    // Its trees are those of the behaviours, which is told; nothing that is told is a warning.
    QVERIFY2(found.err.contains(text("info: no tree file for 8 people")), qPrintable(found.err));
    QVERIFY2(found.out.contains(text("2 files checked: 0 errors, 0 warnings")),
             qPrintable(found.out));
  }

  /// Whoever runs what comes with the program is warned of nothing.
  void check_everyShippedScenario_hasNoWarning() {
    const Finished listed = runProgram("list scenarios --json");
    QStringList words = list("check --json");
    const QJsonArray scenarios = QJsonDocument::fromJson(listed.out.toUtf8()).array();
    QVERIFY(scenarios.size() > 8);
    for (const auto& scenario : scenarios) {
      words << scenario.toObject()[text("path")].toString();
    }
    const Finished found = runProgram(words);
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    for (const auto& said : QJsonDocument::fromJson(found.out.toUtf8()).array()) {
      const QJsonObject problem = said.toObject();
      QVERIFY2(problem[text("severity")] == text("info"),
               qPrintable(problem[text("message")].toString()));
    }
  }

  /// People of HuNavSim come with trees, and of some of ours without the others' a file is lost.
  void check_lostTrees_areAWarning() {
    QTemporaryDir folder;
    const QString plain = folder.filePath(text("people_only.yaml"));
    QVERIFY(QFile::copy(text(TEST_DATA_DIR "/scenario/people_only.yaml"), plain));
    const auto toldOf = [](const QString& file) {
      return runProgram("check % --map none", {file}).err;
    };
    QVERIFY2(toldOf(plain).contains(text("warning: no tree file for")), qPrintable(toldOf(plain)));
    const QString ours = folder.filePath(text("corner_cafe_agents.yaml"));
    QVERIFY(QFile::copy(text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"), ours));
    QVERIFY(toldOf(ours).contains(text("info: no tree file for 8 people")));
    QCOMPARE(runProgram("trees % -o %", {ours, folder.path()}).exitCode, 0);
    QVERIFY(!toldOf(ours).contains(text("no tree file")));
    QVERIFY(QFile::remove(folder.filePath(text("corner_cafe_agents__agent_2_bt.xml"))));
    QVERIFY2(toldOf(ours).contains(text("warning: no tree file for 1 person (Ben)")),
             qPrintable(toldOf(ours)));
  }

  void check_strangeFiles_clearLines_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("zeros") << QByteArray(1000, '\0');
    QTest::newRow("cut") << QByteArray("hunav_loader:\n  ros__parameters:\n    agents: [a, ");
    QTest::newRow("cut tree") << QByteArray("<root><BehaviorTree ID=\"A\"><Sequence>");
    QTest::newRow("map without image") << QByteArray(
        "image: nothing.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    QTest::newRow("nested") << QByteArray(100000, '[');
  }
  void check_strangeFiles_clearLines() {
    QFETCH(QByteArray, content);
    QTemporaryDir folder;
    const QString path = folder.filePath(text("strange.yaml"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    QCOMPARE(unexpected(runProgram("check %", {path}), 2, "error: "), QString());
  }
};

QTEST_GUILESS_MAIN(CheckProgramTest)
#include "tst_CheckProgram.moc"
