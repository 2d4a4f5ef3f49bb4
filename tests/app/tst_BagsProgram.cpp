#include <cmath>
#include <limits>

#include <QDir>
#include <QRegularExpression>
#include <QtTest>

#include "tests/app/RunFiles.h"
#include "tests/bridge/WrapperBag.h"

using namespace outside;

namespace {

QString demo() {
  return text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

/// Keys of metrics that differ by more than 1e-9 (relative above 1), or are undefined in one alone.
QString different(const QJsonObject& a, const QJsonObject& b) {
  QString keys;
  for (const QString& key : a.keys()) {
    const QJsonValue x = a.value(key).toObject().value(text("value"));
    const QJsonValue y = b.value(key).toObject().value(text("value"));
    const double gap = std::fabs(x.toDouble() - y.toDouble());
    const bool isSame =
        x.type() == y.type() && (x == y || gap <= 1e-9 * std::max(1.0, std::fabs(x.toDouble())));
    keys += isSame ? QString() : key + text(" ");
  }
  return keys;
}

}  // namespace

/// Bags from outside: `run --record mcap`, `render -o x.mcap`, `evaluate BAG`.
class BagsProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const QStringList words = list("run % --duration 8 -q", {demo()});
    QCOMPARE(failureOf(words + list("--record mcap -o %", {path("run")})), QString());
    QCOMPARE(failureOf(words + list("-o %", {path("plain")})), QString());
  }

  void record_changesNothingOfTheRun() {
    for (const char* name : {"/trajectory.csv", "/events.csv", "/trees.csv", "/metrics.csv"}) {
      QVERIFY2(bytesOf(path("run") + text(name)) == bytesOf(path("plain") + text(name)), name);
    }
  }

  void record_again_takesTheBagAway() {
    QCOMPARE(failureOf("run % --duration 1 -o % -q --record mcap", {demo(), path("plain")}),
             QString());
    QVERIFY(QFile::exists(path("plain/bag/bag_0.mcap")));
    QCOMPARE(runProgram("run % --duration 1 -o % -q", {demo(), path("plain")}).exitCode, 0);
    QVERIFY(!QFile::exists(path("plain/bag/bag_0.mcap")));
  }

  void record_wrongWords_areTold() {
    QCOMPARE(runProgram("run % --record mcap", {demo()}).exitCode, 64);
    QCOMPARE(runProgram("run % --record bag -o %", {demo(), path("no")}).exitCode, 64);
    QCOMPARE(runProgram("run % --record mcap --totals -o %", {demo(), path("no")}).exitCode, 64);
    QVERIFY(!QFile::exists(path("no")));
  }

  void evaluate_bag_isAsEvaluateOfTheRun() {
    const Finished run = runProgram("evaluate % -o % -q", {path("run"), path("of_run")});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const Finished drawn = runProgram("render % -o % -q", {path("run"), path("drawn.mcap")});
    QVERIFY2(drawn.exitCode == 0, qPrintable(drawn.err));
    QCOMPARE(failureOf("render % -o % -q", {path("run"), path("drawn.db3")}), QString());
    for (const char* source : {"run/bag", "run/bag/bag_0.mcap", "drawn.mcap", "drawn.db3"}) {
      const Finished bag = runProgram("evaluate % -o % -q", {path(source), path("of_bag")});
      QVERIFY2(bag.exitCode == 0 && bag.err.isEmpty(), qPrintable(bag.err));
      const QJsonObject wanted = metricsOf(path("of_run"));
      QVERIFY(wanted.size() > 30);
      const QString keys = different(wanted, metricsOf(path("of_bag")));
      QVERIFY2(keys.isEmpty(), qPrintable(keys));
    }
  }

  void render_unknownEnding_namesThoseOfBags() {
    QCOMPARE(unexpected(runProgram("render % -o %", {path("run"), path("drawn.bag")}), 64,
                        ".mcap, .db3"),
             QString());
  }

  /// As yaml-cpp finds it, which rosbag2 reads the file with.
  void repeatedKey_isAWarningAndTheFirstCounts() {
    const QString bag = path("repeated");
    QVERIFY(QDir().mkpath(bag));
    QVERIFY(QFile::copy(path("run/bag/bag_0.mcap"), bag + text("/bag_0.mcap")));
    QFile source(path("run/bag/metadata.yaml"));
    QVERIFY(source.open(QIODevice::ReadOnly));
    const QByteArray names = "  relative_file_paths:\n    - absent.mcap\n";
    QFile metadata(bag + text("/metadata.yaml"));
    QVERIFY(metadata.open(QIODevice::WriteOnly));
    QVERIFY(metadata.write(source.readAll() + names) > 0);
    metadata.close();
    QCOMPARE(unexpected(runProgram("evaluate % -o % -q", {bag, path("of_repeated")}), 0,
                        "key 'relative_file_paths' is repeated"),
             QString());
    QVERIFY(different(metricsOf(path("of_run")), metricsOf(path("of_repeated"))).isEmpty());
  }

  /// Without metadata.yaml the files are read; a file that it names and that does not exist is an
  /// error.
  void evaluate_folders_areReadAsFarAsTheyGo() {
    const QString bag = path("folder");
    QVERIFY(QDir().mkpath(bag));
    QVERIFY(QFile::copy(path("run/bag/bag_0.mcap"), bag + text("/bag_0.mcap")));
    QCOMPARE(unexpected(runProgram("evaluate % -o % -q", {bag, path("of_folder")}), 0,
                        "has no metadata.yaml"),
             QString());
    QVERIFY(different(metricsOf(path("of_run")), metricsOf(path("of_folder"))).isEmpty());
    QVERIFY(QFile::copy(path("run/bag/metadata.yaml"), bag + text("/metadata.yaml")));
    QVERIFY(QFile::rename(bag + text("/bag_0.mcap"), bag + text("/other.mcap")));
    const Finished absent = runProgram("evaluate % -o % -q", {bag, path("no")});
    QCOMPARE(absent.exitCode, 2);
    QVERIFY2(absent.err.contains(text("lists bag_0.mcap, which is not in the folder (bag files "
                                      "there: other.mcap)")),
             qPrintable(absent.err));
    QVERIFY2(absent.err.contains(text("metadata.yaml:")), qPrintable(absent.err));
  }

  /// The written files can be read: the folder is measured again.
  void evaluate_badNumbers_areLeftOutAndTheResultIsRead() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(wrapper::writeWrapper(path("bad.mcap").toStdString(),
                                  [nan](int k, auto& people, auto& robot) {
                                    people.agents[0].position.position.x = k == 3 ? nan : 2.0;
                                    robot.velocity.linear.x = k == 7 ? 1e300 : 0.0;
                                  }));
    const Finished first = runProgram("evaluate % -o % -q", {path("bad.mcap"), path("of_bad")});
    QVERIFY2(first.exitCode == 0, qPrintable(first.err));
    QCOMPARE(first.err.count(text("are ignored:")), 2);
    const Finished second = runProgram("evaluate % -o % -q", {path("of_bad"), path("of_bad2")});
    QVERIFY2(second.exitCode == 0 && second.err.isEmpty(), qPrintable(second.err));
    const QString keys = different(metricsOf(path("of_bad")), metricsOf(path("of_bad2")));
    QVERIFY2(keys.isEmpty(), qPrintable(keys));
    const double force = valueOf(metricsOf(path("of_bad2")), text("obstacle_force_on_agents"));
    QVERIFY2(std::fabs(force - 20 * 3.6787944117) < 1e-6, qPrintable(QString::number(force)));
  }

  /// Each missing input once, with the keys of the metrics that need it.
  void evaluate_missingInputs_areNamedOnce_data() {
    QTest::addColumn<bool>("hasMap");
    QTest::addColumn<QStringList>("named");
    QTest::newRow("no map") << false
                            << QStringList{text("no obstacle points of people"),
                                           text("no obstacle points of the robot"),
                                           text("contains no map"),
                                           text("no goal of the robot"),
                                           text("no social_force_factor"),
                                           text("no new plans")};
    QTest::newRow("map") << true
                         << QStringList{
                                text("the nearest points of walls and obstacles are used for "
                                     "obstacle_force_on_agents"),
                                text("the nearest points of walls and obstacles are used for "
                                     "social_work, obstacle_force_on_robot")};
  }
  void evaluate_missingInputs_areNamedOnce() {
    QFETCH(bool, hasMap);
    QFETCH(QStringList, named);
    QVERIFY(wrapper::writeWrapper(path("poor.mcap").toStdString(),
                                  [](int /*k*/, auto& people, auto& robot) {
                                    robot.closestObs.clear();
                                    for (auto& agent : people.agents) {
                                      agent.closestObs.clear();
                                    }
                                  }));
    QStringList words = list("evaluate % -o % -q", {path("poor.mcap"), path("of_poor")});
    if (hasMap) {
      words << text("--map") << text(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml");
    }
    const Finished made = runProgram(words);
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    for (const QString& each : named) {
      QVERIFY2(made.err.count(each) == 1, qPrintable(made.err + each));
    }
  }

  void evaluate_compressedFile_saysSo() {
    for (const char* const name : {"whole.mcap.zstd", "whole.db3.zstd"}) {
      QFile file(path(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(QByteArray("\x28\xB5\x2F\xFD\x24\x10", 6));
      file.close();
      QCOMPARE(unexpected(runProgram("evaluate % -o % -q", {path(name), path("no")}), 2,
                          "is compressed as a whole with 'zstd'"),
               QString());
    }
  }

  /// For every kind of input, under any name.
  void lfsPointer_anyReader_saysSo_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* name, const QStringList& words) {
      QTest::newRow(name) << text(name) << words;
    };
    for (const char* const name :
         {"a.mcap", "a.db3", "a.csv", "a.h5", "a.sqlite", "a.xml", "a.txt"}) {
      row(name, {text("evaluate"), text("FILE"), text("-o"), text("no")});
    }
    row("scenario.yaml", {text("check"), text("FILE")});
    row("tree.xml", {text("check"), text("FILE")});
    row("params.yaml", {text("run"), demo(), text("--planner"), text("nav2"), text("--nav2-params"),
                        text("FILE"), text("--duration"), text("1"), text("-o"), text("no")});
    row("metrics.yaml",
        {text("evaluate"), path("run"), text("--metrics"), text("FILE"), text("-o"), text("no")});
    row("map.yaml",
        {text("evaluate"), path("run"), text("--map"), text("FILE"), text("-o"), text("no")});
  }
  void lfsPointer_anyReader_saysSo() {
    QFETCH(QString, name);
    QFETCH(QStringList, words);
    const QString file = folder_.filePath(name);
    QFile pointer(file);
    QVERIFY(pointer.open(QIODevice::WriteOnly));
    pointer.write("version https://git-lfs.github.com/spec/v1\noid sha256:0000\nsize 1613\n");
    pointer.close();
    words.replaceInStrings(QRegularExpression(text("^FILE$")), file);
    words.replaceInStrings(QRegularExpression(text("^no$")), path("no"));
    QCOMPARE(unexpected(runProgram(words), 2,
                        "the file is a Git LFS pointer: fetch its content with git lfs "
                        "pull"),
             QString());
    QFile::remove(file);
  }

  void evaluate_topics_areChosen() {
    const Finished bag = runProgram("evaluate % --topics people=/people,robot=/odom -o % -q",
                                    {path("run/bag"), path("chosen")});
    QVERIFY2(bag.exitCode == 0, qPrintable(bag.err));
    const double length = valueOf(metricsOf(path("chosen")), text("path_length"));
    QVERIFY(std::fabs(length - valueOf(metricsOf(path("run")), text("path_length"))) < 1e-6);
    const Finished wrong =
        runProgram("evaluate % --topics robot=/odm -o % -q", {path("run/bag"), path("no")});
    QCOMPARE(wrong.exitCode, 2);
    QVERIFY2(wrong.err.contains(text("/odom")), qPrintable(wrong.err));
    QCOMPARE(wrong.err.trimmed().count(QLatin1Char('\n')), 0);
    QCOMPARE(runProgram("evaluate % --topics robot=/odom -o %", {path("run"), path("no")}).exitCode,
             64);
  }
};

QTEST_APPLESS_MAIN(BagsProgramTest)
#include "tst_BagsProgram.moc"
