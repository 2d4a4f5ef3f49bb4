#include <QTemporaryDir>
#include <QtTest>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"

/// Expected: the examples of FIPS 180-4, and of coreutils' sha256sum.
class Sha256Test : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sha256OfFile_bytes_asPublished_data();
  void sha256OfFile_bytes_asPublished();
  void sha256OfFile_noFile_isNothing();
};

void Sha256Test::sha256OfFile_bytes_asPublished_data() {
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

void Sha256Test::sha256OfFile_bytes_asPublished() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, expected);
  const QTemporaryDir folder;
  const std::string file = folder.filePath(QStringLiteral("bytes")).toStdString();
  QVERIFY(base::writeFileAtomically(file, bytes.toStdString()).empty());
  QCOMPARE(QString::fromStdString(app::sha256OfFile(file).value_or("")), expected);
}

void Sha256Test::sha256OfFile_noFile_isNothing() {
  QVERIFY(!app::sha256OfFile("/nowhere/at all").has_value());
}

QTEST_APPLESS_MAIN(Sha256Test)
#include "tst_Sha256.moc"
