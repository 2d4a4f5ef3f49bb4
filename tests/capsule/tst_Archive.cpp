#include <map>
#include <sys/stat.h>
#include <zip.h>

#include <QTemporaryDir>
#include <QtTest>

#include "app/capsule/Archive.h"
#include "tests/app/RunFiles.h"

using capsule::ArchiveMember;
using capsule::ArchiveReader;
using outside::text;

namespace {

QStringList codesOf(const base::Diagnostics& problems) {
  QStringList codes;
  for (const base::Diagnostic& problem : problems) {
    codes.append(QString::fromLatin1(problem.code.data(), static_cast<int>(problem.code.size())));
  }
  return codes;
}

/// An archive written by libzip alone, which accepts names that the program refuses.
void writeZip(const QString& path, const std::map<std::string, QByteArray>& files,
              mode_t mode = S_IFREG | 0644) {
  int code = 0;
  zip_t* const zip = zip_open(qPrintable(path), ZIP_CREATE | ZIP_TRUNCATE, &code);
  QVERIFY(zip != nullptr);
  for (const auto& [name, content] : files) {
    zip_source_t* const source =
        zip_source_buffer(zip, content.data(), static_cast<zip_uint64_t>(content.size()), 0);
    const zip_int64_t index = zip_file_add(zip, name.c_str(), source, 0);
    QVERIFY(index >= 0);
    QCOMPARE(
        zip_file_set_external_attributes(zip, static_cast<zip_uint64_t>(index), 0, ZIP_OPSYS_UNIX,
                                         static_cast<zip_uint32_t>(mode) << 16U),
        0);
  }
  QCOMPARE(zip_close(zip), 0);
}

}  // namespace

/// Writing and reading archives, and malicious archives.
class ArchiveTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  QString path(const char* name) const { return folder_.filePath(text(name)); }
  base::Diagnostics problemsOf(const QString& file,
                               const capsule::ArchiveLimits& limits = {}) const {
    return ArchiveReader::open(file.toStdString(), limits).diagnostics();
  }
  /// An archive of two stored members, and its bytes.
  QByteArray writeGood(const QString& file) const {
    const std::vector<ArchiveMember> members = {{"mimetype", "application/x-test", {}, true},
                                                {"a/b.txt", "hello hello hello", {}, true}};
    return capsule::writeArchive(file.toStdString(), members).empty() ? outside::bytesOf(file)
                                                                      : QByteArray();
  }

 private Q_SLOTS:
  void write_twice_equalBytes() {
    outside::writeText(path("source.txt"), "of a file");
    const std::vector<ArchiveMember> members = {
        {"mimetype", "application/x-test", {}, true},
        {"a/b.txt", std::string(5000, 'x'), {}, false},
        {"a/c.txt", {}, path("source.txt").toStdString(), false}};
    QVERIFY(capsule::writeArchive(path("1.zip").toStdString(), members).empty());
    QVERIFY(capsule::writeArchive(path("2.zip").toStdString(), members).empty());
    const QByteArray bytes = outside::bytesOf(path("1.zip"));
    QCOMPARE(bytes, outside::bytesOf(path("2.zip")));
    QVERIFY(bytes.size() < 1000);
    QCOMPARE(bytes.mid(10, 4), QByteArray("\0\0\x21\0", 4));                // 1980-01-01 00:00
    QCOMPARE(bytes.mid(30, 26), QByteArray("mimetypeapplication/x-test"));  // for file(1)
    const QStringList left = QDir(folder_.path()).entryList(QDir::Files);
    QCOMPARE(left, QStringList({text("1.zip"), text("2.zip"), text("source.txt")}));

    const auto reader = ArchiveReader::open(path("1.zip").toStdString());
    QVERIFY(reader);
    QCOMPARE((*reader)->entries().size(), std::size_t{3});
    QCOMPARE((*reader)->text("a/b.txt", 5000).diagnostics().size(), std::size_t{0});
    QCOMPARE(codesOf((*reader)->text("a/b.txt", 4999).diagnostics()),
             QStringList(text("capsule.too-large")));
    QCOMPARE(codesOf((*reader)->text("a/d.txt", 10).diagnostics()),
             QStringList(text("capsule.missing")));
    std::map<std::string, std::string> hashes;
    const std::string out = path("out").toStdString();
    QVERIFY(
        (*reader)
            ->extract(out, "a/", [&](const auto& name, const auto& hash) { hashes[name] = hash; })
            .empty());
    QCOMPARE(outside::bytesOf(path("out/a/c.txt")), QByteArray("of a file"));
    QCOMPARE(hashes.at("a/c.txt"),  // of sha256sum
             std::string("e51ee4cf5f91a733798e3f679640b30f155fc67f21777a66b7c819c8686db182"));
    QVERIFY(!QFile::exists(path("out/mimetype")));
    QCOMPARE(codesOf((*reader)->extract(out)), QStringList(text("capsule.folder-not-empty")));
  }

  void names_ofAttacks_areRefused_data() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name : {"../up.txt", "/etc/passwd", "a/../../up.txt", "a//b", "./a", "a/.",
                             "a\\b", "C:\\x", "a\nb", "a\x1b[2Jb", "folder/"}) {
      QTest::newRow(QByteArray(name).replace('\n', 'n').replace('\x1b', 'e').constData())
          << QByteArray(name);
    }
  }
  void names_ofAttacks_areRefused() {
    QFETCH(QByteArray, name);
    QVERIFY(!capsule::isMemberName(name.toStdString()));
    writeZip(path("bad.zip"), {{"good.txt", "x"}, {name.toStdString(), "evil"}});
    const base::Diagnostics problems = problemsOf(path("bad.zip"));
    QCOMPARE(codesOf(problems), QStringList(text("capsule.bad-name")));
  }

  void kinds_otherThanFiles_areRefused_data() {
    QTest::addColumn<unsigned>("mode");
    QTest::newRow("link") << unsigned{S_IFLNK | 0777};
    QTest::newRow("pipe") << unsigned{S_IFIFO | 0644};
    QTest::newRow("device") << unsigned{S_IFBLK | 0644};
    QTest::newRow("folder") << unsigned{S_IFDIR | 0755};
  }
  void kinds_otherThanFiles_areRefused() {
    QFETCH(unsigned, mode);
    writeZip(path("kind.zip"), {{"passwd", "/etc/passwd"}}, mode);
    QCOMPARE(codesOf(problemsOf(path("kind.zip"))), QStringList(text("capsule.no-plain-file")));
  }

  void fileAndFolderOfOneName_isRefused() {
    writeZip(path("both.zip"), {{"a", "x"}, {"a-", "x"}, {"a/b", "y"}});
    QCOMPARE(codesOf(problemsOf(path("both.zip"))), QStringList(text("capsule.bad-name")));
  }

  void sameNameTwice_isRefused() {
    writeZip(path("twice.zip"), {{"name1", "x"}, {"name2", "y"}});
    QByteArray bytes = outside::bytesOf(path("twice.zip"));
    bytes.replace("name2", "name1");  // in both headers
    outside::writeText(path("twice.zip"), bytes);
    QCOMPARE(codesOf(problemsOf(path("twice.zip"))), QStringList(text("capsule.no-archive")));
  }

  void sizes_ofBombs_areRefused() {
    writeZip(path("bomb.zip"), {{"zeros", QByteArray(2'000'000, '\0')}});
    QVERIFY(QFileInfo(path("bomb.zip")).size() < 5000);
    QVERIFY(problemsOf(path("bomb.zip")).empty());  // 2 MB do no harm
    capsule::ArchiveLimits limits;
    limits.alwaysAllowed = 1'000'000;
    QCOMPARE(codesOf(problemsOf(path("bomb.zip"), limits)), QStringList(text("capsule.too-large")));
    limits = {};
    limits.total = 1'999'999;
    QCOMPARE(codesOf(problemsOf(path("bomb.zip"), limits)), QStringList(text("capsule.too-large")));
    limits = {};
    limits.members = 0;
    QCOMPARE(codesOf(problemsOf(path("bomb.zip"), limits)), QStringList(text("capsule.too-many")));
  }

  void size_thatIsALie_isDamage() {
    writeZip(path("lie.zip"), {{"zeros", QByteArray(100'000, '\0')}});
    QByteArray bytes = outside::bytesOf(path("lie.zip"));
    bytes.replace(QByteArray("\xa0\x86\x01\x00", 4), QByteArray("\x10\x00\x00\x00", 4));
    outside::writeText(path("lie.zip"), bytes);
    const auto reader = ArchiveReader::open(path("lie.zip").toStdString());
    if (reader) {  // libzip may have seen it
      std::size_t most = 0;
      const base::Diagnostics problems =
          (*reader)->read("zeros", [&most](std::string_view piece) { most += piece.size(); });
      QCOMPARE(codesOf(problems), QStringList(text("capsule.damaged")));
      QVERIFY(most <= 16);
    }
  }

  void truncated_anywhere_isNoArchive() {
    const QByteArray bytes = writeGood(path("good.zip"));
    QVERIFY(bytes.size() > 100);
    for (int size = 0; size < bytes.size(); ++size) {
      outside::writeText(path("cut.zip"), bytes.left(size));
      QCOMPARE(codesOf(problemsOf(path("cut.zip"))), QStringList(text("capsule.no-archive")));
    }
  }

  /// Each flipped bit is refused, is damage of a member, or changes nothing that is read.
  void bit_flipped_neverChangesContent() {
    const QByteArray bytes = writeGood(path("good.zip"));
    for (int place = 0; place < bytes.size(); ++place) {
      QByteArray changed = bytes;
      changed[place] = static_cast<char>(changed[place] ^ 1);
      outside::writeText(path("flip.zip"), changed);
      const auto reader = ArchiveReader::open(path("flip.zip").toStdString());
      if (!reader || !(*reader)->has("a/b.txt")) {
        continue;
      }
      const base::Result<std::string> content = (*reader)->text("a/b.txt", 1000);
      QVERIFY2(!content || *content == "hello hello hello", QByteArray::number(place).constData());
    }
  }

  void files_thatAreNone_areReported() {
    QCOMPARE(codesOf(problemsOf(path("absent.zip"))), QStringList(text("file.cannot-read")));
    QCOMPARE(codesOf(problemsOf(folder_.path())), QStringList(text("file.cannot-read")));
    outside::writeText(path("text.hnv"), "no archive");
    QCOMPARE(codesOf(problemsOf(path("text.hnv"))), QStringList(text("capsule.no-archive")));
    QCOMPARE(codesOf(capsule::writeArchive("/nowhere/x.zip", {{"a", "b", {}, false}})),
             QStringList(text("file.cannot-write")));
    QCOMPARE(codesOf(capsule::writeArchive(path("x.zip").toStdString(),
                                           {{"a", {}, "/nowhere/file", false}})),
             QStringList(text("file.cannot-write")));
    QVERIFY(!QFile::exists(path("x.zip")));
  }
};

QTEST_APPLESS_MAIN(ArchiveTest)
#include "tst_Archive.moc"
