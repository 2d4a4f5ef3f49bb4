#include <csignal>
#include <map>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/OutputFolder.h"
#include "sim2d/base/Text.h"
#include "tests/support/StruckCalls.h"

using app::OutputFolder;
using Content = std::map<std::string, std::string>;  // by name, what the user would see

/// Outputs that are whole or not there, whatever happens.
class OutputFolderTest : public QObject {
  Q_OBJECT

 private:
  const Content before_ = {{"a.csv", "old a"}, {"b.csv", "old b"}, {"gone.csv", "old c"}};
  const Content after_ = {{"a.csv", "new a"}, {"b.csv", "old b"}, {"sub/d.csv", "new d"}};
  std::unique_ptr<QTemporaryDir> place_;

  std::string folder() const { return place_->path().toStdString() + "/out"; }
  std::string at(const std::string& name) const { return folder() + "/" + name; }
  void put(const std::string& name, const std::string& content) const {
    QVERIFY(base::writeFileAtomically(at(name), content).empty());
  }
  /// Without manifest.json and what is of the work on the folder.
  Content seen(bool withWork = false) const {
    Content found;
    QDirIterator files(QString::fromStdString(folder()),
                       QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const std::string path = files.next().toStdString();
      const std::string name = path.substr(folder().size() + 1);
      const bool isWork = app::isInternalEntry(name.substr(0, name.find('/')));
      if (!files.fileInfo().isDir() && (withWork || !isWork) && name != "manifest.json") {
        const base::Result<std::string> text = base::readTextFile(path);
        found[name] = text ? *text : "?";
      }
    }
    return found;
  }
  base::Diagnostics write(const Content& content, bool force = false) const {
    const auto output = OutputFolder::open(folder(), force);
    if (!output) {
      return output.diagnostics();
    }
    for (const auto& [name, text] : content) {
      base::Diagnostics problems = (*output)->write(name, text);
      if (!problems.empty()) {
        return problems;
      }
    }
    return (*output)->commit("{}", OutputFolder::EarlierFiles::Removed);
  }
  bool isOneOfBoth() const { return seen() == before_ || seen() == after_; }
  base::Diagnostics checked() const {
    return app::checkManifestFiles(folder(), {"a.csv", "b.csv", "gone.csv", "sub/d.csv"});
  }

 private Q_SLOTS:
  void init() { place_ = std::make_unique<QTemporaryDir>(); }

  void commit_newFolder_listsItsFiles() {
    QVERIFY(write({{"x.csv", "abc"}}).empty());
    QCOMPARE(seen(true), (Content{{"x.csv", "abc"}}));
    const auto manifest = nlohmann::json::parse(*base::readTextFile(at("manifest.json")));
    QCOMPARE(manifest["outputs"].size(), std::size_t{1});
    QCOMPARE(manifest["outputs"][0]["path"].get<std::string>(), std::string("x.csv"));
    // FIPS 180-2, appendix B.1
    QCOMPARE(manifest["outputs"][0]["sha256"].get<std::string>(),
             std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
  }

  void commit_overEarlier_takesItsOtherFilesAway() {
    QVERIFY(write(before_).empty());
    QVERIFY(base::writeFileAtomically(at("mine.txt"), "mine").empty());
    QVERIFY(write(after_).empty());
    Content all = after_;
    all["mine.txt"] = "mine";
    QCOMPARE(seen(true), all);
  }

  void commit_keepingEarlier_listsBoth() {
    QVERIFY(write({{"a.csv", "a"}}).empty());
    {
      const auto output = OutputFolder::open(folder(), false);
      QVERIFY((*output)->write("b.csv", "b").empty());
      QVERIFY((*output)->commit("{}", OutputFolder::EarlierFiles::Kept).empty());
    }
    QCOMPARE(seen(), (Content{{"a.csv", "a"}, {"b.csv", "b"}}));
    QVERIFY(checked().empty());
  }

  void commit_droppedNames_goThoughOthersStay() {
    QVERIFY(write(before_).empty());
    put("b.csv", "edited");
    {
      const auto output = OutputFolder::open(folder(), false);
      QVERIFY((*output)->write("a.csv", "new a").empty());
      (*output)->removeOnCommit({"a.csv", "b.csv", "gone.csv"});
      QVERIFY((*output)->commit("{}", OutputFolder::EarlierFiles::Kept).empty());
    }
    QCOMPARE(seen(), (Content{{"a.csv", "new a"}, {"b.csv", "edited"}}));  // not ours any more
  }

  void write_nameThatLeavesTheFolder_isRefused() {
    const auto output = OutputFolder::open(folder(), true);
    for (const char* name : {"../a.csv", "sub/../../a.csv", "/tmp/a.csv", ""}) {
      QVERIFY2(base::hasErrors((*output)->write(name, "x")), name);
    }
    QVERIFY((*output)->write("a..b/c..csv", "x").empty());
  }

  /// Whatever a user keeps beside the results, hidden or not.
  void commit_filesBesideIt_stay() {
    const Content mine = {{".lock", "a"},          {".commit/b", "b"},     {".new-ideas/c", "c"},
                          {".manifest.json", "d"}, {"a.csv.new-1-1", "e"}, {".new-1/f", "f"}};
    for (const auto& [name, text] : mine) {
      put(name, text);
    }
    QVERIFY(write(before_).empty());
    QVERIFY(write(after_).empty());
    QVERIFY(app::completeCommit(folder()).empty());
    Content all = after_;
    all.insert(mine.begin(), mine.end());
    QCOMPARE(seen(true), all);
  }

  void open_notCommitted_changesNothing() {
    { QVERIFY((*OutputFolder::open(folder(), false))->write("a.csv", "a").empty()); }
    QVERIFY(!QFile::exists(QString::fromStdString(folder())));  // it was made for this
    QVERIFY(write(before_).empty());
    { QVERIFY((*OutputFolder::open(folder(), false))->write("a.csv", "other").empty()); }
    QCOMPARE(seen(true), before_);
  }

  void inTheWay_filesOfOthers_areToldAndStay() {
    QVERIFY(write(before_).empty());
    put("a.csv", "edited");       // ours, but changed
    put("sub/d.csv", "by hand");  // never ours
    QVERIFY(::unlink(at("b.csv").c_str()) == 0);
    QVERIFY(::symlink("/etc/hostname", at("b.csv").c_str()) == 0);  // a link
    const Content there = seen(true);
    const base::Diagnostics told = write(after_);
    QCOMPARE(told.size(), std::size_t{3});
    for (const base::Diagnostic& problem : told) {
      QCOMPARE(problem.code, std::string("file.is-in-the-way"));
    }
    QCOMPARE(told[0].file, at("a.csv"));
    QCOMPARE(seen(true), there);
    QVERIFY(write(after_, true).empty());
    QCOMPARE(seen(true), after_);
  }

  void inTheWay_equalContent_isNot() {
    put("x.csv", "same");
    QVERIFY(write({{"x.csv", "same"}}).empty());
  }

  void inTheWay_folderOfThatName_isEvenWithForce() {
    put("x.csv/y", "mine");
    QCOMPARE(write({{"x.csv", "x"}}, true).size(), std::size_t{1});
    QCOMPARE(seen(true), (Content{{"x.csv/y", "mine"}}));
  }

  void inTheWay_manifestOfOthers_isTold() {
    put("manifest.json", "{\"name\": \"of a web page\"}");
    QCOMPARE(write({{"x.csv", "x"}}).size(), std::size_t{1});
  }

  void open_whileAnotherHasIt_namesIt() {
    const auto first = OutputFolder::open(folder(), false);
    QVERIFY(first);
    const int code = struck::elsewhere([this] {
      const auto second = OutputFolder::open(folder(), false);
      const bool isTold = !second && second.diagnostics().front().code == "batch.locked" &&
                          second.diagnostics().front().text().find(std::to_string(::getppid())) !=
                              std::string::npos;
      return isTold ? 0 : 1;
    });
    QCOMPARE(code, 0);
  }

  /// At each call that changes the folder.
  void commit_killed_isAllOrNothing() {
    int kills = 0;
    int wasNew = 0;
    for (int calls = 0;; ++calls) {
      init();
      QVERIFY(write(before_).empty());
      const int code = struck::elsewhere([&] {
        struck::callsLeft = calls;
        struck::fault = 0;
        return write(after_).empty() ? 0 : 1;
      });
      QVERIFY(code == 0 || code == 9);
      QVERIFY(app::completeCommit(folder()).empty());
      QVERIFY2(isOneOfBoth(), QByteArray::number(calls));
      QVERIFY(checked().empty());
      wasNew += seen() == after_ ? 1 : 0;
      QVERIFY(write(after_).empty());  // and it goes on
      QCOMPARE(seen(true), after_);
      if (code == 0) {
        break;
      }
      ++kills;
    }
    QVERIFY2(kills >= 12 && wasNew >= 4, QByteArray::number(kills));
  }

  void commit_diskFails_isAllOrNothingAndTold() {
    int faults = 0;
    for (int calls = 0;; ++calls) {
      init();
      QVERIFY(write(before_).empty());
      const int code = struck::elsewhere([&] {
        struck::callsLeft = calls;
        struck::fault = calls % 2 == 0 ? EIO : ENOSPC;
        const bool isFine = write(after_).empty();
        const bool isStruckYet = struck::callsLeft < 0;
        struck::callsLeft = -1;
        return (isFine ? 0 : 1) + (isStruckYet ? 2 : 0);
      });
      if (code == 0) {
        break;
      }
      ++faults;
      QVERIFY(app::completeCommit(folder()).empty());
      QVERIFY2(isOneOfBoth(), QByteArray::number(calls));
      QVERIFY((code & 1) == 1 || seen() == after_);  // success is success
      QVERIFY(checked().empty());
    }
    QVERIFY2(faults >= 12, QByteArray::number(faults));
  }

  void write_diskFull_changesNothingAndIsTold() {
    Content large = after_;
    large["b.csv"] = std::string(200000, 'x');
    for (rlim_t limit = 0; limit < 200000; limit += 16384) {
      init();
      QVERIFY(write(before_).empty());
      const int code = struck::elsewhere([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit most = {limit, limit};
        ::setrlimit(RLIMIT_FSIZE, &most);
        return write(large).empty() ? 0 : 1;
      });
      QCOMPARE(code, 1);
      QCOMPARE(seen(), before_);
      QVERIFY(write(large).empty());
    }
  }

  void nameOfUnfinished_otherNames_haveNone() {
    QCOMPARE(app::targetOfTemporary("a.csv.new-1-20").value_or(""), std::string("a.csv"));
    QCOMPARE(app::targetOfTemporary("a.new-1-2.new-30-4").value_or(""), std::string("a.new-1-2"));
    for (const char* const other :
         {"", "a", ".new-1-2", "a.new-", "a.new-1", "a.new-1-", "a.new--1", "a.new-1-2x",
          "a.new-x-2", "a.new-1_2", "a.new-1-2-3"}) {
      QVERIFY2(!app::targetOfTemporary(other), other);
    }
  }

  void checkListed_partsOfAnotherRun_areTold() {
    QVERIFY(write(before_).empty());
    QVERIFY(checked().empty());
    put("b.csv", "of another");
    QCOMPARE(checked().size(), std::size_t{1});
    put("b.csv", before_.at("b.csv"));
    put("sub/d.csv", "not listed");
    QCOMPARE(checked().size(), std::size_t{1});
    QVERIFY(::unlink(at("sub/d.csv").c_str()) == 0 && ::unlink(at("a.csv").c_str()) == 0);
    QCOMPARE(checked().size(), std::size_t{1});
    QVERIFY(::unlink(at("manifest.json").c_str()) == 0);  // nothing to compare with
    QVERIFY(checked().empty());
  }

  /// Expected: the examples of FIPS 180-4, and of coreutils' sha256sum.
  void sha256OfFile_bytes_asPublished_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const QByteArray& bytes, const char* expected) {
      QTest::newRow(name) << bytes << QString::fromLatin1(expected);
    };
    row("empty", {}, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    row("abc", "abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    row("two blocks", "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    row("a million", QByteArray(1000000, 'a'),
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    row("55 bytes", QByteArray(55, 'x'),
        "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
    row("64 bytes", QByteArray(64, 'x'),
        "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
  }

  void sha256OfFile_bytes_asPublished() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, expected);
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("bytes")).toStdString();
    QVERIFY(base::writeFileAtomically(file, bytes.toStdString()).empty());
    QCOMPARE(QString::fromStdString(app::sha256OfFile(file).value_or("")), expected);
  }

  void sha256OfFile_noFile_isNothing() {
    QVERIFY(!app::sha256OfFile("/nowhere/at all").has_value());
  }
};

QTEST_APPLESS_MAIN(OutputFolderTest)
#include "tst_OutputFolder.moc"
