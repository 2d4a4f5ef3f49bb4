#include <set>

#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "bt/human/HumanNodes.h"
#include "bt/tree/TreeXml.h"
#include "tests/app/RunFiles.h"

/// `hunavsim list nodes --format xml` from outside: a model file for Groot2.
class ListProgramTest : public QObject {
  Q_OBJECT

 private:
  outside::Finished found_;

 private Q_SLOTS:
  void initTestCase() {
    found_ = outside::runProgram({QStringLiteral("list"), QStringLiteral("nodes"),
                                  QStringLiteral("--format"), QStringLiteral("xml")});
    QVERIFY2(found_.exitCode == 0, qPrintable(found_.err));
  }

  /// By a reader of the tests' own: well-formed, every node once, with the tag of its kind.
  void xml_nodes_areAllThatAreNotBuiltIn() {
    QXmlStreamReader xml(found_.out);
    std::set<std::string> seen;
    int depth = 0;
    while (!xml.atEnd()) {
      const QXmlStreamReader::TokenType token = xml.readNext();
      depth += token == QXmlStreamReader::StartElement ? 1 : 0;
      if (token == QXmlStreamReader::StartElement && depth == 1) {
        QCOMPARE(xml.name().toString(), QStringLiteral("root"));
        QCOMPARE(xml.attributes().value(QStringLiteral("BTCPP_format")).toString(),
                 QStringLiteral("4"));
      }
      if (token == QXmlStreamReader::StartElement && depth == 3) {
        const std::string entry =
            xml.name().toString().toStdString() + " " +
            xml.attributes().value(QStringLiteral("ID")).toString().toStdString();
        QVERIFY2(seen.insert(entry).second, entry.c_str());
      }
      depth -= token == QXmlStreamReader::EndElement ? 1 : 0;
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    std::set<std::string> expected;
    const bt::NodeLibrary library = bt::humanNodes();
    for (const bt::NodeManifest& node : library.catalogue().all()) {
      if (node.origin != bt::NodeOrigin::BehaviorTreeCpp) {
        expected.insert(std::string(bt::nodeKindName(node.kind)) + " " + node.id);
      }
    }
    QVERIFY(seen == expected);
    for (const char* id :
         {"Condition TimeExpiredCondition", "Action AvoidRobot", "Decorator TimeDelay",
          "Control ProbabilityChoice", "Action GoTo", "Condition IsSpeaking"}) {
      QVERIFY2(seen.count(id) == 1, id);
    }
  }

  void xml_isAModelFileForTheReader() {
    const base::Result<bt::TreeFile> file = bt::readTreeText(found_.out.toStdString(), "model.xml");
    QVERIFY(file && file->model);
    QVERIFY(file->trees.empty() && file.diagnostics().empty());
    QVERIFY(file->model->children.size() > 45);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("model.xml"));
    QFile out(path);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(found_.out.toUtf8());
    out.close();
    QVERIFY(bt::readTree(path.toStdString()));
  }

  void xml_ofOtherThings_isAWrongWord() {
    const outside::Finished wrong =
        outside::runProgram({QStringLiteral("list"), QStringLiteral("robots"),
                             QStringLiteral("--format"), QStringLiteral("xml")});
    QCOMPARE(wrong.exitCode, 64);
    QVERIFY(wrong.out.isEmpty());
  }
};

QTEST_GUILESS_MAIN(ListProgramTest)
#include "tst_ListProgram.moc"
