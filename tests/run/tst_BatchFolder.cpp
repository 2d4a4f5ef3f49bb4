#include <memory>
#include <string>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/BatchFolder.h"
#include "sim2d/base/Text.h"
#include "tests/support/StruckCalls.h"

using app::BatchFolder;
using app::Earlier;

/// The folder of a batch, whatever ends the process that writes into it.
class BatchFolderTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> place_;

  std::string folder() const { return place_->path().toStdString() + "/out"; }
  std::string textOf(const char* name) const {
    const base::Result<std::string> text = base::readTextFile(folder() + "/" + name);
    return text ? *text : "";
  }
  /// Three runs that fail, which is told in the table.
  static app::Study study() {
    app::Study three;
    three.version = "1";
    three.experimentPath = "e.yaml";
    three.experiment = "hunavsim_experiment: 1\n";
    three.inputs = {{"e.yaml", "00"}};
    three.runs = 3;
    return three;
  }
  static app::StoredRun runOf(std::size_t number) {
    const std::string reason = "reason " + std::to_string(number);
    return {number, "scene", 1, {}, app::rowOf({base::error("batch.no-results", {}, reason)})};
  }
  /// Runs [first, end) and the end of the process that made them, as batch does it.
  bool work(std::size_t first, std::size_t end, Earlier earlier) const {
    const auto batch = BatchFolder::open(folder(), study(), earlier);
    if (!batch) {
      return false;
    }
    for (std::size_t run = first; run < end; ++run) {
      if (!(*batch)->store().has(run) && base::hasErrors((*batch)->add(runOf(run)))) {
        return false;
      }
    }
    return (*batch)->finish().empty();
  }

 private Q_SLOTS:
  void init() { place_ = std::make_unique<QTemporaryDir>(); }

  void finish_killed_canBeResumed_data() {
    QTest::addColumn<bool>("isResumed");
    QTest::newRow("at its first end") << false;
    QTest::newRow("after it was resumed") << true;
  }

  /// Killed at each call that changes the folder.
  void finish_killed_canBeResumed() {
    QFETCH(bool, isResumed);
    QVERIFY(work(0, 3, Earlier::Refuse));
    const std::string expected = textOf("results.csv");
    QCOMPARE(base::split(expected, '\n').size(), std::size_t{5});  // head, three rows, end
    int kills = 0;
    for (int code = 9; code == 9; ++kills) {
      init();
      QVERIFY(!isResumed || work(0, 1, Earlier::Refuse));
      code = struck::elsewhere([&] {
        struck::callsLeft = kills;
        return work(isResumed ? 1 : 0, 3, Earlier::Resume) ? 0 : 1;
      });
      QVERIFY(code == 0 || code == 9);
      const std::string where = "call " + std::to_string(kills);
      QVERIFY2(work(0, 3, Earlier::Resume), where.c_str());
      QVERIFY2(textOf("results.csv") == expected, where.c_str());
      QVERIFY2(textOf("manifest.json").find("\"finished\": 3") != std::string::npos, where.c_str());
      const QStringList left =
          QDir(QString::fromStdString(folder()))
              .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
      QCOMPARE(left.join(QLatin1Char(' ')),
               QStringLiteral("manifest.json results.csv results.sqlite"));
    }
    QVERIFY2(kills >= 10, QByteArray::number(kills));
  }

  void open_changedTable_isRefusedUntilReplaced() {
    QVERIFY(work(0, 3, Earlier::Refuse));
    const std::string path = folder() + "/results.csv";
    QVERIFY(base::writeFileAtomically(path, "my remarks\n").empty());
    for (const Earlier earlier : {Earlier::Refuse, Earlier::Resume}) {
      const auto refused = BatchFolder::open(folder(), study(), earlier);
      QVERIFY(!refused);
      QCOMPARE(refused.diagnostics().front().file, path);
      QCOMPARE(textOf("results.csv"), std::string("my remarks\n"));
    }
    QVERIFY(work(0, 3, Earlier::Replace));
  }
};

QTEST_APPLESS_MAIN(BatchFolderTest)
#include "tst_BatchFolder.moc"
