#include <limits>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Files.h"
#include "tests/support/FullDisk.h"

using base::ScratchFile;

namespace {

/// How many files of that folder this process has open, as Linux tells.
int openFilesIn(const QString& folder) {
  int count = 0;
  const QDir open(QStringLiteral("/proc/self/fd"));
  for (const QFileInfo& each : open.entryInfoList(QDir::Files | QDir::System)) {
    count += each.symLinkTarget().startsWith(folder) ? 1 : 0;
  }
  return count;
}

bool isEmpty(const QTemporaryDir& folder) {
  return QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

}  // namespace

/// Bytes put aside on the disk.
class ScratchFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void append_somePieces_areReadBack() {
    ScratchFile file;
    QVERIFY(!file.read({0, 1}));
    const auto first = file.append("one");
    const auto second = file.append(std::string(100000, 'x'));
    QVERIFY(first && second);
    file.prefetch(*second);
    QVERIFY(file.read(*first) == std::optional<std::string>("one"));
    QVERIFY(file.read(*second) == std::optional<std::string>(std::string(100000, 'x')));
    QCOMPARE(file.size(), 100003LL);
    QVERIFY(!file.read({100000, 4}));  // beyond its end
  }

  void overwrite_piece_leavesTheOthers() {
    ScratchFile file;
    const auto first = file.append("one");
    const auto second = file.append("two");
    QVERIFY(first && second && file.overwrite(*first, "ONE"));
    QVERIFY(file.read(*first) == std::optional<std::string>("ONE"));
    QVERIFY(file.read(*second) == std::optional<std::string>("two"));
    QCOMPARE(file.size(), 6LL);
  }

  void append_withTmpdir_liesThereWithoutAName() {
    const QTemporaryDir folder;
    const QByteArray before = qgetenv("TMPDIR");
    qputenv("TMPDIR", folder.path().toLocal8Bit());
    {
      ScratchFile file;
      QCOMPARE(openFilesIn(folder.path()), 0);  // not needed yet
      QVERIFY(file.append("bytes"));
      QCOMPARE(openFilesIn(folder.path()), 1);
      QVERIFY(isEmpty(folder));
    }
    QCOMPARE(openFilesIn(folder.path()), 0);
    qputenv("TMPDIR", (folder.path() + QStringLiteral("/none")).toLocal8Bit());
    ScratchFile elsewhere;
    QVERIFY(elsewhere.append("bytes"));
    before.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
  }

  void append_folderThatIsNone_tellsWhy() {
    ScratchFile missing("/nowhere/at/all");
    QVERIFY(!missing.append("bytes"));
    QVERIFY(missing.problem() == std::errc::no_such_file_or_directory);
    ScratchFile device("/dev/null");
    QVERIFY(!device.append("bytes"));
    QVERIFY(device.problem() == std::errc::not_a_directory);
  }

  void append_tooLittleIsLeftFree_isFull() {
    ScratchFile file({}, std::numeric_limits<long long>::max() / 2);
    QVERIFY(!file.append("bytes"));
    QVERIFY(file.problem() == std::errc::no_space_on_device);
    QCOMPARE(file.size(), 0LL);
  }

  void append_diskFillsUp_keepsWhatWasThere() {
    ScratchFile file;
    const auto first = file.append(std::string(1000, 'a'));
    QVERIFY(first);
    {
      const support::FullDisk disk(1500);
      QVERIFY(!file.append(std::string(1000, 'b')));
      QVERIFY(file.problem() == std::errc::file_too_large);
      QCOMPARE(file.size(), 1000LL);
      QVERIFY(file.append(std::string(500, 'c')));
    }
    const auto next = file.append(std::string(1000, 'd'));
    QVERIFY(next && next->place == 1500);
    QVERIFY(file.read(*first) == std::optional<std::string>(std::string(1000, 'a')));
    QVERIFY(file.read(*next) == std::optional<std::string>(std::string(1000, 'd')));
  }
};

QTEST_APPLESS_MAIN(ScratchFileTest)
#include "tst_ScratchFile.moc"
