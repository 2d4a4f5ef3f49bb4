#include <QTemporaryDir>
#include <QtTest>

#include "app/run/DataPaths.h"
#include "app/studies/StudyFolder.h"
#include "sim2d/base/Text.h"

using app::ExistingStudy;
using app::StudyFolder;

namespace {

std::string codeOf(const base::Diagnostics& problems) {
  return problems.empty() ? std::string() : std::string(problems.front().code);
}

std::string openProblem(const std::string& folder, ExistingStudy earlier) {
  return codeOf(StudyFolder::open(folder, {"gate.json"}, earlier).diagnostics());
}

std::string contentOf(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  return text ? *text : "missing";
}

void writeContent(const std::string& path, const std::string& text) {
  QVERIFY(base::writeFileAtomically(path, text).empty());
}

constexpr char kHeader[] = "{\"hunavsim_journal\":1}\n";

}  // namespace

class StudyFolderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void finish_writesFilesAndKeepsTheJournal() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("out")).toStdString();
    {
      const auto study = StudyFolder::open(path, {"gate.json"}, ExistingStudy::Refuse);
      QVERIFY(study);
      writeContent((*study)->journal(), kHeader);
      QVERIFY((*study)->finish({{"gate.json", "1"}, {"old.html", "2"}}, "gate").empty());
    }
    QCOMPARE(contentOf(path + "/gate.json"), std::string("1"));
    const std::string manifest = contentOf(path + "/manifest.json");
    QVERIFY(manifest.find("\"kind\": \"gate\"") != std::string::npos);
    QVERIFY(manifest.find("\"version\": \"" + app::programVersion() + "\"") != std::string::npos);
    QCOMPARE(contentOf(path + "/journal.jsonl"), std::string(kHeader));
    {  // resumed: the journal stays; files that are not written again are removed
      const auto study = StudyFolder::open(path, {"gate.json"}, ExistingStudy::Resume);
      QVERIFY(study);
      QCOMPARE(contentOf((*study)->journal()), std::string(kHeader));
      QVERIFY((*study)->finish({{"gate.json", "3"}}, "gate").empty());
    }
    QCOMPARE(contentOf(path + "/gate.json"), std::string("3"));
    QCOMPARE(contentOf(path + "/old.html"), std::string("missing"));
    const auto again = StudyFolder::open(path, {"gate.json"}, ExistingStudy::Refuse);
    QVERIFY(again);  // of a finished study: replaced
    QCOMPARE(contentOf((*again)->journal()), std::string("missing"));
  }

  void open_interruptedStudy_needsADecision() {
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    writeContent(path + "/journal.jsonl", kHeader);
    QCOMPARE(openProblem(path, ExistingStudy::Refuse), std::string("study.unfinished"));
    QCOMPARE(contentOf(path + "/journal.jsonl"), std::string(kHeader));
    QCOMPARE(openProblem(path, ExistingStudy::Resume), std::string());
    QCOMPARE(contentOf(path + "/journal.jsonl"), std::string(kHeader));
    QCOMPARE(openProblem(path, ExistingStudy::Replace), std::string());
    QCOMPARE(contentOf(path + "/journal.jsonl"), std::string("missing"));
  }

  void open_filesOfOtherPrograms_areNotOverwritten() {
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    writeContent(path + "/gate.json", "mine");
    QCOMPARE(openProblem(path, ExistingStudy::Refuse), std::string("file.is-in-the-way"));
    writeContent(path + "/journal.jsonl", "mine");
    QFile::remove(folder.filePath(QStringLiteral("gate.json")));
    QCOMPARE(openProblem(path, ExistingStudy::Refuse), std::string("file.is-in-the-way"));
    QCOMPARE(contentOf(path + "/journal.jsonl"), std::string("mine"));
  }
};

QTEST_APPLESS_MAIN(StudyFolderTest)
#include "tst_StudyFolder.moc"
