#include <set>

#include <QtTest>

#include "sim2d/base/Result.h"

namespace {

using Texts = std::map<QString, QString>;  // of the product's sources by path

QString textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

const Texts& sources() {
  static const Texts kAll = [] {
    Texts all;
    for (const char* room : {"/sim2d", "/bt", "/metrics", "/editor", "/app"}) {
      QDirIterator files(QStringLiteral(SOURCE_DIR) + QLatin1String(room),
                         {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                         QDirIterator::Subdirectories);
      while (files.hasNext()) {
        const QString path = files.next();
        all[path] = textOf(path);
      }
    }
    return all;
  }();
  return kAll;
}

}  // namespace

class ProblemsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ids_areUniqueAndInAreas() {
    const QRegularExpression form(QStringLiteral("^[a-z][a-z0-9]*\\.[a-z][a-z0-9]*(-[a-z0-9]+)*$"));
    std::set<std::string_view> ids;
    for (const base::ProblemText& each : base::problemTexts()) {
      const QByteArray id(each.id.data(), static_cast<int>(each.id.size()));
      QVERIFY2(ids.insert(each.id).second, id);
      QVERIFY2(form.match(QString::fromLatin1(id)).hasMatch(), id);
      QVERIFY2(!each.text.empty(), id);
      QVERIFY2(base::problemText(each.id)->text == each.text, id);
    }
    QVERIFY(base::problemText("no.such-problem") == nullptr);
  }

  void ids_areSaidSomewhere() {
    QString all;
    for (const auto& [path, text] : sources()) {
      all += text;
    }
    QVERIFY(all.size() > 1000000);
    for (const base::ProblemText& each : base::problemTexts()) {
      const QByteArray id(each.id.data(), static_cast<int>(each.id.size()));
      QVERIFY2(all.contains(QStringLiteral("\"%1\"").arg(QString::fromLatin1(id))), id);
    }
  }

  void codesInSources_areInTheCatalogue() {
    const QRegularExpression said(
        QStringLiteral("\\b(?:error|warning|warn|problem|refuse|fail|missing|tell)\\("
                       "(?:[^\"();]|\\([^\"();]*\\))*\"([a-z][a-z0-9]*\\.[a-z0-9-]+)\"(?!, \")"));
    int count = 0;
    for (const auto& [path, text] : sources()) {
      for (auto match = said.globalMatch(text); match.hasNext(); ++count) {
        const QByteArray id = match.next().captured(1).toLatin1();
        QVERIFY2(base::problemText(id.constData()) != nullptr, path.toUtf8() + ": " + id);
      }
    }
    QVERIFY(count > 200);
  }

  void strict_onlySubstitutions_becomeErrors() {
    const base::Diagnostics strict = base::withStrictSubstitutions(
        {base::warning("nav2.left-out", {"layer", "a::B", "no such sensor"}),
         base::warning("nav2.unknown-key", {"a", "Jazzy", ""}), base::error("nav2.no-parameters")});
    QCOMPARE(strict[0].severity, base::Severity::Error);
    QCOMPARE(strict[0].message, std::string("layer: 'a::B' is ignored: no such sensor"));
    QCOMPARE(strict[1].severity, base::Severity::Warning);
    QCOMPARE(strict[2].severity, base::Severity::Error);
  }

  /// Programs go by the code: nobody looks into the words.
  void messages_areReadByNobody() {
    const QRegularExpression reading(
        QStringLiteral("(?:\\.|->)message\\)?(?:\\.(?:find|compare|substr|contains|starts?With|"
                       "remove)\\w*\\(| [=!]= )"));
    for (const auto& [path, text] : sources()) {
      const QRegularExpressionMatch match = reading.match(text);
      QVERIFY2(!match.hasMatch(), path.toUtf8() + ": " + match.captured().toUtf8());
    }
  }
};

QTEST_APPLESS_MAIN(ProblemsTest)
#include "tst_Problems.moc"
