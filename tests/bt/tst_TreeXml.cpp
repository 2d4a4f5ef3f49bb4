#include <QtTest/QtTest>

#include <QDir>
#include <QDirIterator>

#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "tests/bt/TreeTexts.h"
#include "tests/support/Interop.h"

using probe::parsed;
using probe::root;
using probe::textOf;
using probe::tree;

namespace {

/// Folder with files for the length of a test.
class Files {
 public:
  std::string write(const char* name, const std::string& text) {
    std::string path = (folder_.path() + QLatin1Char('/')).toStdString() + name;
    const base::Diagnostics problems = base::writeFileAtomically(path, text);
    if (!problems.empty()) {
      qFatal("%s", textOf(problems).c_str());
    }
    return path;
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace

class TreeXmlTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void writeRead_interopFile_isEqual_data() {
    QTest::addColumn<QString>("path");
    for (const QString& folder : {QStringLiteral(TEST_DATA_DIR "/interop"), interopFolder()}) {
      QDirIterator files(folder, {QStringLiteral("*.xml")}, QDir::Files,
                         QDirIterator::Subdirectories);
      while (files.hasNext()) {
        const QString path = files.next();
        QTest::newRow(qPrintable(path.section(QLatin1Char('/'), -3))) << path;
      }
    }
  }

  void writeRead_interopFile_isEqual() {
    QFETCH(QString, path);
    const base::Result<bt::TreeFile> file = bt::readTree(path.toStdString());
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    const std::string text = bt::writeTree(*file, bt::builtinNodes());
    const base::Result<bt::TreeFile> again = bt::readTreeText(text);
    QVERIFY2(again, textOf(again.diagnostics()).c_str());
    QVERIFY(*again == *file);
    QVERIFY(again->order == file->order);
    QVERIFY(bt::writeTree(*again, bt::builtinNodes()) == text);
  }

  void writeRead_everythingInOneFile_isEqual() {
    const bt::TreeFile file = parsed(
        "<?xml version='1.0'?><root main_tree_to_execute='A' BTCPP_format='4'>"
        "<include path='b.xml'/><include ros_pkg='p' path='c &amp; d.xml'/>"
        "<BehaviorTree ID='A' _description='two &lt; words'><Fallback name='a &quot;b&quot;'>"
        "<Action ID='GoTo' goal_id='3' x='{k}' _uid='7'/>"
        "<SubTree ID='B' name='n' id='{id}' _autoremap='true' _skipIf=\"a &lt; 'b'\"/>"
        "<Script code='x := 1;&#10;y := 2'/></Fallback></BehaviorTree>"
        "<Meta a='1'><b>text</b></Meta>"
        "<TreeNodesModel><Action ID='GoTo'><input_port name='x' type='int'>1 &lt; 2</input_port>"
        "</Action></TreeNodesModel>"
        "<BehaviorTree ID='B'><AlwaysSuccess/></BehaviorTree></root>");
    QCOMPARE(file.trees.size(), std::size_t(2));
    QCOMPARE(file.includes.size(), std::size_t(2));
    QVERIFY(file.includes[1].path == "c & d.xml" && file.includes[1].rosPackage == "p");
    const bt::NodeSpec& fallback = file.trees[0].root;
    QVERIFY(fallback.name == "a \"b\"");
    QVERIFY(fallback.children[0].id == "GoTo" && fallback.children[0].explicitNotation);
    QVERIFY(fallback.children[0].others == (bt::Attributes{{"_uid", "7"}}));
    QVERIFY(fallback.children[1].autoRemap && fallback.children[1].subTree == "B");
    QVERIFY(fallback.children[1].conditions == (bt::Attributes{{"_skipIf", "a < 'b'"}}));
    QVERIFY(*bt::findAttribute(fallback.children[2].ports, "code") == "x := 1;\ny := 2");
    QCOMPARE(file.blocks.size(), std::size_t(1));
    const std::string text = bt::writeTree(file, bt::builtinNodes());
    const bt::TreeFile again = parsed(text);
    QVERIFY(again == file);
    QVERIFY(again.order == file.order);
    QVERIFY(again.trees[0].root.children[0].explicitNotation);
  }

  void read_explicitAndCompact_areEqual() {
    const bt::TreeFile compact =
        parsed(root(tree("T",
                         "<Sequence><GoTo goal_id='3'/><IsSpeaking/><TimeDelay><X/></TimeDelay>"
                         "</Sequence>")));
    const bt::TreeFile full = parsed(root(
        tree("T",
             "<Control ID='Sequence'><Action ID='GoTo' goal_id='3'/><Condition ID='IsSpeaking'/>"
             "<Decorator ID='TimeDelay'><Action ID='X'/></Decorator></Control>")));
    QVERIFY(!full.trees.empty());
    QVERIFY(compact == full);
  }

  void read_foreignKindInTag_isAccepted() {
    probe::Run run("<Condition ID='Sequence'><Action ID='AlwaysSuccess'/></Condition>");
    QVERIFY2(run.state, run.problems.c_str());
    QCOMPARE(run.tick(), base::NodeStatus::Success);
  }

  void read_byteOrderMarkAndCrLf_isAccepted() {
    const bt::TreeFile plain = parsed(root("\n" + tree("T", "\n<AlwaysSuccess/>\n")));
    const bt::TreeFile windows =
        parsed("\xEF\xBB\xBF" + root("\r\n" + tree("T", "\r\n<AlwaysSuccess/>\r\n")));
    QVERIFY(!plain.trees.empty());
    QVERIFY(plain == windows);
    QCOMPARE(windows.trees[0].root.line, 3);
  }

  void read_bareAmpersand_isText_data() {
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<QByteArray>("meant");
    QTest::newRow("script") << QByteArray("a && b") << QByteArray("a && b");
    QTest::newRow("behind a reference") << QByteArray("1 &lt; a && b") << QByteArray("1 < a && b");
    QTest::newRow("unknown name") << QByteArray("&lt;&gross;") << QByteArray("<&gross;");
    QTest::newRow("surrogate") << QByteArray("&amp;&#xD800;") << QByteArray("&&#xD800;");
    QTest::newRow("nul") << QByteArray("&amp;&#0;x") << QByteArray("&&#0;x");
    QTest::newRow("characters") << QByteArray("&#65;&#x42;&#228;") << QByteArray("AB\xC3\xA4");
  }

  /// As the original reads it, and without what tinyxml2 makes of it behind a reference.
  void read_bareAmpersand_isText() {
    QFETCH(QByteArray, written);
    QFETCH(QByteArray, meant);
    const auto file =
        bt::readTreeText("<root BTCPP_format='4'><!-- & --><BehaviorTree ID='T'><S n='" +
                         written.toStdString() + "'/></BehaviorTree></root>");
    QVERIFY(file);
    QCOMPARE(QByteArray::fromStdString(file->trees[0].root.ports[0].text), meant);
  }

  void read_templateText_isNoted() {
    const bt::TreeFile file =
        parsed(root(tree("T", "<Fallback>\n\n  {GOAL_SEQUENCE}\n<AlwaysSuccess/></Fallback>")));
    QVERIFY(file.templateLine > 0);
    const auto program = bt::compile(file, bt::NodeLibrary());
    QVERIFY(program);
    QVERIFY(textOf(program.diagnostics()).find("template") != std::string::npos);
    const base::Result<bt::TreeTable> table = bt::resolveIncludes(file);
    QVERIFY(table);
    QVERIFY(base::hasErrors(bt::diagnosticsOf(bt::checkForImport(*table, bt::builtinNodes()))));
  }

  void read_version3_isConverted() {
    const bt::TreeFile file =
        parsed(root(tree("T",
                         "<SequenceStar><SubTree ID='R' id='agentid' dt='timestep'/>"
                         "<SubTreePlus ID='R' __autoremap='true' x='{y}' n='3'/>"
                         "<SubTree ID='R' __shared_blackboard='true'/>"
                         "<RetryUntilSuccesful num_attempts='2'><A/></RetryUntilSuccesful>"
                         "<Parallel success_threshold='1' failure_threshold='2'><A/><B/></Parallel>"
                         "</SequenceStar>"),
                    "main_tree_to_execute=\"T\""));
    QCOMPARE(file.format, 3);
    const bt::NodeSpec& top = file.trees.at(0).root;
    QVERIFY(top.id == "SequenceWithMemory");
    QVERIFY(top.children[0].ports == (bt::Attributes{{"id", "{agentid}"}, {"dt", "{timestep}"}}));
    QVERIFY(top.children[1].isSubTree() && top.children[1].autoRemap);
    QVERIFY(top.children[1].ports == (bt::Attributes{{"x", "{y}"}, {"n", "3"}}));
    QVERIFY(top.children[2].autoRemap && top.children[2].others.empty());
    QVERIFY(top.children[3].id == "RetryUntilSuccessful");
    QVERIFY(top.children[4].ports ==
            (bt::Attributes{{"success_count", "1"}, {"failure_count", "2"}}));
  }

  void read_version3BlackboardChecks_becomePreconditions() {
    const bt::TreeFile file = parsed(
        root(tree("T",
                  "<Sequence><BlackboardCheckInt value_A='{a}' value_B='3'"
                  " return_on_mismatch='SUCCESS'><A/></BlackboardCheckInt>"
                  "<BlackboardCheckString value_A='{a}' value_B='x y'><A/></BlackboardCheckString>"
                  "<BlackboardCheckBool value_A='{a}' value_B='True'><A/></BlackboardCheckBool>"
                  "</Sequence>"),
             "BTCPP_format=\"3\""));
    const std::vector<bt::NodeSpec>& nodes = file.trees.at(0).root.children;
    QVERIFY(nodes[0].id == "Precondition");
    QVERIFY(nodes[0].ports == (bt::Attributes{{"if", "a == 3"}, {"else", "SUCCESS"}}));
    QVERIFY(nodes[1].ports == (bt::Attributes{{"if", "a == 'x y'"}}));
    QVERIFY(nodes[2].ports == (bt::Attributes{{"if", "a == true"}}));
  }

  void read_version4_isNotConverted() {
    const bt::TreeFile file = parsed(root(tree("T", "<SubTree ID='R' id='agentid'/>")));
    QVERIFY(file.trees.at(0).root.ports == (bt::Attributes{{"id", "agentid"}}));
  }

  void include_ownDefinition_wins() {
    Files files;
    files.write("b.xml", root(tree("R", "<AlwaysFailure/>") + tree("Q", "<AlwaysFailure/>")));
    const std::string path =
        files.write("a.xml", root(tree("R", "<AlwaysSuccess/>") + "<include path='b.xml'/>",
                                  "BTCPP_format=\"4\" main_tree_to_execute=\"R\""));
    const base::Result<bt::TreeTable> table = bt::loadTrees(path);
    QVERIFY2(table, textOf(table.diagnostics()).c_str());
    QVERIFY(table->find("R")->tree.root.id == "AlwaysSuccess");
    QVERIFY(table->find("R")->file == path);
    QVERIFY(table->find("Q")->tree.root.id == "AlwaysFailure");
  }

  void include_laterFile_winsOverEarlier() {
    Files files;
    files.write("b.xml", root(tree("R", "<AlwaysFailure/>")));
    files.write("c.xml", root(tree("R", "<AlwaysSuccess/>")));
    const std::string path = files.write(
        "a.xml", root("<include path='b.xml'/><include path='c.xml'/>" + tree("T", "<X/>")));
    const base::Result<bt::TreeTable> table = bt::loadTrees(path);
    QVERIFY(table);
    QVERIFY(table->find("R")->tree.root.id == "AlwaysSuccess");
  }

  void include_relativePath_isOfTheIncludingFile() {
    Files files;
    files.write("sub/c.xml", root(tree("C", "<AlwaysSuccess/>")));
    files.write("sub/b.xml", root("<include path='c.xml'/>" + tree("B", "<AlwaysSuccess/>")));
    const std::string path =
        files.write("a.xml", root("<include path='sub/b.xml'/>" + tree("A", "<AlwaysSuccess/>")));
    const base::Result<bt::TreeTable> table = bt::loadTrees(path);
    QVERIFY2(table, textOf(table.diagnostics()).c_str());
    QCOMPARE(table->entries.size(), std::size_t(3));
    QVERIFY(table->mainTree == "A");
  }

  void include_rosPackage_needsItsFolder() {
    Files files;
    const std::string included = files.write("share/b.xml", root(tree("B", "<AlwaysSuccess/>")));
    const std::string path = files.write(
        "a.xml", root("<include ros_pkg='p' path='b.xml'/>" + tree("A", "<AlwaysSuccess/>")));
    QVERIFY(!bt::loadTrees(path));
    const base::Result<bt::TreeTable> table = bt::loadTrees(path, [&](const std::string& package) {
      return package == "p" ? included.substr(0, included.rfind('/')) : std::string();
    });
    QVERIFY2(table, textOf(table.diagnostics()).c_str());
    QVERIFY(table->find("B"));
  }

  void include_manyTimesDeep_endsSoon() {
    Files files;
    std::string last;
    for (int i = 0; i < 40; ++i) {  // each file includes the one before it twice
      const std::string name = "f" + std::to_string(i) + ".xml";
      const std::string below = "<include path='f" + std::to_string(i - 1) + ".xml'/>";
      const std::string id = "T" + std::to_string(i);
      last = files.write(name.c_str(), root((i == 0 ? std::string() : below + below) +
                                            tree(id.c_str(), "<AlwaysSuccess/>")));
    }
    QVERIFY(!bt::loadTrees(last));  // two to the fortieth files would never end
  }

  void mainTree_rules_data() {
    QTest::addColumn<QString>("attributes");
    QTest::addColumn<bool>("second");
    QTest::addColumn<QString>("main");
    const QString format = QStringLiteral("BTCPP_format='4'");
    const QString named = format + QStringLiteral(" main_tree_to_execute='B'");
    QTest::newRow("named") << named << true << QStringLiteral("B");
    QTest::newRow("only one") << format << false << QStringLiteral("A");
    QTest::newRow("not said") << format << true << QString();
  }

  void mainTree_rules() {
    QFETCH(QString, attributes);
    QFETCH(bool, second);
    QFETCH(QString, main);
    const std::string body =
        tree("A", "<AlwaysSuccess/>") + (second ? tree("B", "<AlwaysFailure/>") : std::string());
    const bt::TreeFile file = parsed(root(body, attributes.toUtf8().constData()));
    const base::Result<bt::TreeTable> table = bt::resolveIncludes(file);
    QVERIFY(table);
    QCOMPARE(QString::fromStdString(table->mainTree), main);
    const auto program = bt::compile(*table, bt::NodeLibrary());
    QCOMPARE(static_cast<bool>(program), !main.isEmpty());
    bt::CompileOptions chosen;
    chosen.mainTree = "A";
    QVERIFY(bt::compile(*table, bt::NodeLibrary(), chosen));
  }

  void writeModel_catalogue_hasPortsAndDefaults() {
    const base::Result<bt::TreeFile> file =
        bt::readTreeText(bt::writeModel(probe::library().catalogue()));
    QVERIFY(file && file->model);
    const auto& entries = file->model->children;
    const auto stateful = std::find_if(entries.begin(), entries.end(), [](const bt::XmlElement& e) {
      return *bt::findAttribute(e.attributes, "ID") == "St";
    });
    QVERIFY(stateful != entries.end());
    QVERIFY(stateful->tag == "Action");
    QVERIFY(stateful->children[0].tag == "input_port");
    QVERIFY(*bt::findAttribute(stateful->children[0].attributes, "type") == "int");
    QVERIFY(*bt::findAttribute(stateful->children[0].attributes, "default") == "1");
    for (const bt::XmlElement& entry : entries) {
      QVERIFY(*bt::findAttribute(entry.attributes, "ID") != "Sequence");
    }
  }

  void write_reactiveSequence_hasCompactChildren() {
    const bt::TreeFile file = parsed(root(
        tree("T", "<ReactiveSequence><Condition ID='A'/><Action ID='B'/></ReactiveSequence>")));
    const std::string text = bt::writeTree(file, bt::builtinNodes());
    QVERIFY(text.find("<A/>") != std::string::npos);
    QVERIFY(text.find("<Action") == std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TreeXmlTest)
#include "tst_TreeXml.moc"
