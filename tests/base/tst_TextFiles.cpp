#include <memory>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <QtTest>

#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"

class TextFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
  }

  void write_newFolders_areMade() {
    QVERIFY(base::writeFileAtomically(at("a/b/c.txt"), "x").empty());
    QVERIFY(*base::readTextFile(at("a/b/c.txt")) == "x");
  }

  void write_anyBytes_readBackEqual() {
    std::string content(300000, '\0');
    for (std::size_t i = 0; i < content.size(); ++i) {
      content[i] = static_cast<char>(i * 7 % 256);
    }
    QVERIFY(base::writeFileAtomically(at("bytes"), content).empty());
    QVERIFY(*base::readTextFile(at("bytes")) == content);
    QVERIFY(base::writeFileAtomically(at("bytes"), "").empty());
    QVERIFY(base::readTextFile(at("bytes"))->empty());
    QCOMPARE(fileCount(), 1);
  }

  void write_existingFile_isReplacedAndKeepsItsMode() {
    QVERIFY(base::writeFileAtomically(at("f"), "old").empty());
    QCOMPARE(::chmod(at("f").c_str(), 0640), 0);
    QVERIFY(base::writeFileAtomically(at("f"), "new").empty());
    struct stat status = {};
    QCOMPARE(::stat(at("f").c_str(), &status), 0);
    QCOMPARE(status.st_mode & 07777U, mode_t{0640});
    QVERIFY(*base::readTextFile(at("f")) == "new");
  }

  void write_symlink_replacesWhatItPointsAt() {
    QVERIFY(base::writeFileAtomically(at("real"), "old").empty());
    QCOMPARE(::symlink("real", at("link").c_str()), 0);
    QVERIFY(base::writeFileAtomically(at("link"), "new").empty());
    QVERIFY(*base::readTextFile(at("real")) == "new");
    QVERIFY(QFileInfo(folder_->filePath(QStringLiteral("link"))).isSymLink());
  }

  /// Each looks for what others left behind, and takes no file of one that lives.
  void write_byManyProcesses_allSucceed() {
    constexpr int kProcesses = 6, kTimes = 150;
    std::vector<pid_t> children;
    children.reserve(kProcesses);
    for (int k = 0; k < kProcesses; ++k) {
      children.push_back(::fork());
      if (children.back() == 0) {
        int failures = 0;
        for (int time = 0; time < kTimes; ++time) {
          failures += base::writeFileAtomically(at("shared"), "whole").empty() ? 0 : 1;
        }
        ::_exit(failures == 0 ? 0 : 1);
      }
    }
    for (const pid_t child : children) {
      int status = -1;
      QCOMPARE(::waitpid(child, &status, 0), child);
      QCOMPARE(status, 0);
    }
    QCOMPARE(*base::readTextFile(at("shared")), std::string("whole"));
    QCOMPARE(fileCount(), 1);
  }

  void write_directory_isAnError() {
    const base::Diagnostics errors = base::writeFileAtomically(folder_->path().toStdString(), "x");
    QCOMPARE(errors.size(), std::size_t{1});
    QVERIFY(base::hasErrors(errors));
    QVERIFY(errors[0].file == folder_->path().toStdString());
  }

  void write_parentIsAFile_isAnError() {
    QVERIFY(base::writeFileAtomically(at("f"), "x").empty());
    QVERIFY(base::hasErrors(base::writeFileAtomically(at("f/g"), "y")));
    QVERIFY(*base::readTextFile(at("f")) == "x");
    QCOMPARE(fileCount(), 1);
  }

  void write_emptyPath_isAnError() { QVERIFY(base::hasErrors(base::writeFileAtomically("", "x"))); }

  void write_noPermission_isAnErrorAndKeepsTheOldFile() {
    QVERIFY(base::hasErrors(base::writeFileAtomically("/proc/hunavsim-test", "x")));
    if (::geteuid() == 0) {
      return;  // permissions of folders do not bind root
    }
    QVERIFY(base::writeFileAtomically(at("f"), "old").empty());
    QCOMPARE(::chmod(folder_->path().toLocal8Bit().constData(), 0500), 0);
    const bool refused = base::hasErrors(base::writeFileAtomically(at("f"), "new"));
    QCOMPARE(::chmod(folder_->path().toLocal8Bit().constData(), 0700), 0);
    QVERIFY(refused);
    QVERIFY(*base::readTextFile(at("f")) == "old");
    QCOMPARE(fileCount(), 1);
  }

  void write_relativePath_goesToTheCurrentFolder() {
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder_->path()));
    const base::Diagnostics errors = base::writeFileAtomically("here.txt", "x");
    QVERIFY(QDir::setCurrent(before));
    QVERIFY(errors.empty());
    QVERIFY(*base::readTextFile(at("here.txt")) == "x");
  }

  void together_allFine_allAreWritten() {
    QVERIFY(base::writeFileAtomically(at("one"), "old").empty());
    QVERIFY(base::writeFilesAtomically({{at("one"), "1"}, {at("two"), "2"}, {at("a/three"), "3"}})
                .empty());
    QVERIFY(*base::readTextFile(at("one")) == "1");
    QVERIFY(*base::readTextFile(at("two")) == "2");
    QVERIFY(*base::readTextFile(at("a/three")) == "3");
    QCOMPARE(fileCount(), 3);
    QVERIFY(base::writeFilesAtomically({}).empty());
  }

  void together_oneCannotBeWritten_nothingChanges_data() {
    QTest::addColumn<QByteArray>("bad");
    QTest::newRow("folder") << QByteArray("folder");
    QTest::newRow("below a file") << QByteArray("old/below");
    QTest::newRow("twice the same, a folder by then") << QByteArray("new/below");
  }

  void together_oneCannotBeWritten_nothingChanges() {
    QFETCH(QByteArray, bad);
    QVERIFY(QDir(folder_->path()).mkdir(QStringLiteral("folder")));
    QVERIFY(base::writeFileAtomically(at("old"), "old").empty());
    const base::Diagnostics problems = base::writeFilesAtomically(
        {{at("old"), "changed"}, {at("new"), "new"}, {at(bad.constData()), "x"}});
    QVERIFY(base::hasErrors(problems));
    QVERIFY(*base::readTextFile(at("old")) == "old");
    QVERIFY(!QFile::exists(folder_->filePath(QStringLiteral("new"))) ||
            QFileInfo(folder_->filePath(QStringLiteral("new"))).isDir());
  }

  void growing_pieces_areThereWhenFinished() {
    QVERIFY(base::writeFileAtomically(at("f"), "old").empty());
    std::string expected;
    base::AtomicFileWriter file(at("f"));
    for (int k = 0; k < 30000; ++k) {  // many times what is written at once
      const std::string piece = std::to_string(k) + "\n";
      expected += piece;
      file.append(piece);
    }
    QVERIFY(*base::readTextFile(at("f")) == "old");
    QVERIFY(file.finish().empty());
    QVERIFY(*base::readTextFile(at("f")) == expected);
    QCOMPARE(fileCount(), 1);
  }

  void growing_complete_isStillBesideItsPlace() {
    QVERIFY(base::writeFileAtomically(at("f"), "old").empty());
    base::AtomicFileWriter file(at("f"));
    file.append("new");
    QVERIFY(file.complete().empty());
    QVERIFY(!file.hasFailed());
    QVERIFY(*base::readTextFile(at("f")) == "old");
    QVERIFY(file.finish().empty());
    QVERIFY(*base::readTextFile(at("f")) == "new");
    QCOMPARE(fileCount(), 1);
  }

  void growing_notFinished_leavesTheOldFile() {
    QVERIFY(base::writeFileAtomically(at("f"), "old").empty());
    {
      base::AtomicFileWriter file(at("f"));
      file.append(std::string(200000, 'x'));
      QCOMPARE(fileCount(), 2);
    }
    QVERIFY(*base::readTextFile(at("f")) == "old");
    QCOMPARE(fileCount(), 1);
  }

  void growing_cannotBeWritten_isToldByFinish() {
    base::AtomicFileWriter folder(folder_->path().toStdString());
    QVERIFY(folder.hasFailed());
    folder.append("x");
    QCOMPARE(folder.finish().size(), std::size_t{1});
    base::AtomicFileWriter full("/dev/full/none");
    QVERIFY(base::hasErrors(full.finish()));
    QCOMPARE(fileCount(), 0);
  }

  void read_missingOrDirectory_isAnErrorNamingTheFile() {
    const base::Result<std::string> missing = base::readTextFile(at("nothing"));
    QVERIFY(!missing);
    QCOMPARE(QByteArray::fromStdString(missing.diagnostics()[0].text()),
             QByteArray::fromStdString(at("nothing") +
                                       ": error: cannot read the file: No such file or directory"));
    const base::Result<std::string> directory = base::readTextFile(folder_->path().toStdString());
    QVERIFY(!directory);
    QVERIFY(directory.diagnostics()[0].message.find("Is a directory") != std::string::npos);
    QVERIFY(!base::readTextFile(""));
  }

  void read_pipeOrDevice_isAnErrorAtOnce() {
    QVERIFY(::mkfifo(at("pipe").c_str(), 0600) == 0);
    for (const std::string& path :
         {at("pipe"), std::string("/dev/zero"), std::string("/dev/tty")}) {
      const base::Result<std::string> text = base::readTextFile(path);
      QVERIFY2(!text, path.c_str());
      QCOMPARE(text.diagnostics().front().file, path);
    }
  }

  void read_moreThanAllowed_isAnError() {
    QVERIFY(base::writeFileAtomically(at("large"), std::string(3U << 20U, 'x')).empty());
    QVERIFY(base::readTextFile(at("large"), 3U << 20U));
    const base::Result<std::string> cut = base::readTextFile(at("large"), (3U << 20U) - 1U);
    QVERIFY(!cut);
    QCOMPARE(cut.diagnostics().front().code, std::string("file.too-large"));
    // A file without end, though its size says nothing.
    QVERIFY(::truncate(at("large").c_str(), off_t{1} << 40U) == 0);
    QVERIFY(!base::readTextFile(at("large")));
  }

 private:
  std::string at(const char* name) const {
    return folder_->filePath(QLatin1String(name)).toStdString();
  }

  /// Of all files in the folder, hidden and temporary ones too.
  int fileCount() const {
    return QDir(folder_->path())
        .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot)
        .size();
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TextFilesTest)
#include "tst_TextFiles.moc"
