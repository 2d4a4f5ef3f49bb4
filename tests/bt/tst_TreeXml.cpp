#include <QtTest/QtTest>

#include <QDir>
#include <QDirIterator>

#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "tests/bt/TreeProbe.h"
#include "tests/support/Interop.h"

using probe::textOf;

class TreeXmlTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void writeRead_interopFile_isEqual_data();
  void writeRead_interopFile_isEqual();
  void writeRead_everythingInOneFile_isEqual();
  void read_explicitAndCompact_areEqual();
  void read_foreignKindInTag_isAccepted();
  void read_byteOrderMarkAndCrLf_isAccepted();
  void read_bareAmpersand_isText_data();
  void read_bareAmpersand_isText();
  void read_templateText_isNoted();
  void read_version3_isConverted();
  void read_version3BlackboardChecks_becomePreconditions();
  void read_version4_isNotConverted();
  void read_entityBomb_isNotExpanded();
  void read_tagsOfPieces_areWhatTheFileSays();
  void read_deepNesting_isRead();
  void read_deepBlock_isWhole();
  void read_deepNesting_isRefusedSoon();
  void read_manyDeepSiblings_takeLittle();
  void read_hundredThousandNodes_isRead();
  void include_ownDefinition_wins();
  void include_laterFile_winsOverEarlier();
  void include_relativePath_isOfTheIncludingFile();
  void include_rosPackage_needsItsFolder();
  void include_manyTimesDeep_endsSoon();
  void mainTree_rules_data();
  void mainTree_rules();
  void writeModel_catalogue_hasPortsAndDefaults();
  void write_reactiveSequence_hasCompactChildren();
};

namespace {

bt::TreeFile parsed(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(xml, "t.xml");
  if (!file) {
    qWarning("%s", textOf(file.diagnostics()).c_str());
    return {};
  }
  return *file;
}

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

std::string tree(const char* id, const char* body) {
  return std::string("<BehaviorTree ID=\"") + id + "\">" + body + "</BehaviorTree>";
}

std::string root(const std::string& body, const char* attributes = "BTCPP_format=\"4\"") {
  return std::string("<root ") + attributes + ">" + body + "</root>";
}

}  // namespace

void TreeXmlTest::writeRead_interopFile_isEqual_data() {
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

void TreeXmlTest::writeRead_interopFile_isEqual() {
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

void TreeXmlTest::writeRead_everythingInOneFile_isEqual() {
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
  QVERIFY(*bt::findText(fallback.children[2].ports, "code") == "x := 1;\ny := 2");
  QCOMPARE(file.blocks.size(), std::size_t(1));
  const std::string text = bt::writeTree(file, bt::builtinNodes());
  const bt::TreeFile again = parsed(text);
  QVERIFY(again == file);
  QVERIFY(again.order == file.order);
  QVERIFY(again.trees[0].root.children[0].explicitNotation);
}

void TreeXmlTest::read_explicitAndCompact_areEqual() {
  const bt::TreeFile compact =
      parsed(root(tree("T",
                       "<Sequence><GoTo goal_id='3'/><IsSpeaking/><TimeDelay><X/></TimeDelay>"
                       "</Sequence>")));
  const bt::TreeFile full = parsed(
      root(tree("T",
                "<Control ID='Sequence'><Action ID='GoTo' goal_id='3'/><Condition ID='IsSpeaking'/>"
                "<Decorator ID='TimeDelay'><Action ID='X'/></Decorator></Control>")));
  QVERIFY(!full.trees.empty());
  QVERIFY(compact == full);
}

void TreeXmlTest::read_foreignKindInTag_isAccepted() {
  probe::Run run("<Condition ID='Sequence'><Action ID='AlwaysSuccess'/></Condition>");
  QVERIFY2(run.state, run.problems.c_str());
  QCOMPARE(run.tick(), base::NodeStatus::Success);
}

void TreeXmlTest::read_byteOrderMarkAndCrLf_isAccepted() {
  const bt::TreeFile plain = parsed(root("\n" + tree("T", "\n<AlwaysSuccess/>\n")));
  const bt::TreeFile windows =
      parsed("\xEF\xBB\xBF" + root("\r\n" + tree("T", "\r\n<AlwaysSuccess/>\r\n")));
  QVERIFY(!plain.trees.empty());
  QVERIFY(plain == windows);
  QCOMPARE(windows.trees[0].root.line, 3);
}

void TreeXmlTest::read_bareAmpersand_isText_data() {
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
void TreeXmlTest::read_bareAmpersand_isText() {
  QFETCH(QByteArray, written);
  QFETCH(QByteArray, meant);
  const auto file =
      bt::readTreeText("<root BTCPP_format='4'><!-- & --><BehaviorTree ID='T'><S n='" +
                       written.toStdString() + "'/></BehaviorTree></root>");
  QVERIFY(file);
  QCOMPARE(QByteArray::fromStdString(file->trees[0].root.ports[0].text), meant);
}

void TreeXmlTest::read_templateText_isNoted() {
  const bt::TreeFile file =
      parsed(root(tree("T", "<Fallback>\n\n  {GOAL_SEQUENCE}\n<AlwaysSuccess/></Fallback>")));
  QVERIFY(file.templateLine > 0);
  const auto program = bt::compile(file, bt::NodeLibrary());
  QVERIFY(program);
  QVERIFY(textOf(program.diagnostics()).find("template") != std::string::npos);
  const base::Result<bt::TreeTable> table = bt::resolveIncludes(file);
  QVERIFY(table);
  QVERIFY(base::hasErrors(bt::diagnosticsOf(bt::checkTable(*table, bt::builtinNodes()))));
}

void TreeXmlTest::read_version3_isConverted() {
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

void TreeXmlTest::read_version3BlackboardChecks_becomePreconditions() {
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

void TreeXmlTest::read_version4_isNotConverted() {
  const bt::TreeFile file = parsed(root(tree("T", "<SubTree ID='R' id='agentid'/>")));
  QVERIFY(file.trees.at(0).root.ports == (bt::Attributes{{"id", "agentid"}}));
}

void TreeXmlTest::read_entityBomb_isNotExpanded() {
  std::string bomb = "<!DOCTYPE r [<!ENTITY a 'aaaaaaaaaa'>";
  for (char c = 'b'; c < 'k'; ++c) {
    const std::string before = std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += std::string("<!ENTITY ") + c + " '";
    for (int i = 0; i < 10; ++i) {
      bomb += before;
    }
    bomb += "'>";
  }
  bomb += "]>" + root(tree("T", "<AlwaysSuccess name='&j;'/>"));
  const base::Result<bt::TreeFile> file = bt::readTreeText(bomb, "t.xml");
  if (file) {
    QVERIFY(file->trees.at(0).root.name.size() < 10);
  } else {
    QVERIFY(base::hasErrors(file.diagnostics()));
  }
}

namespace {

int nodesIn(const bt::NodeSpec& node) {
  int count = 1;
  for (const bt::NodeSpec& child : node.children) {
    count += nodesIn(child);
  }
  return count;
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) {
    result += text;
  }
  return result;
}

}  // namespace

/// Deep files are read in pieces: an element of the file never stands for one of them.
void TreeXmlTest::read_tagsOfPieces_areWhatTheFileSays() {
  constexpr int kCalls = 60;  // of pieces, in each of three pieces
  const std::string calls = repeated("<piece-of-this-file n='0'/>", kCalls);
  const std::string one = "<Sequence>" + calls + repeated("<Inverter>", 70);
  const std::string ends = repeated(repeated("</Inverter>", 70) + "</Sequence>", 3);
  const base::Result<bt::TreeFile> file = bt::readTreeText(
      root(tree("T", (repeated(one, 3) + "<AlwaysSuccess/>" + ends).c_str())), "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec& top = file->trees.at(0).root;
  QCOMPARE(nodesIn(top), 3 * (1 + kCalls + 70) + 1);
  QCOMPARE(top.children.at(0).id, std::string("piece-of-this-file"));
  QVERIFY(top.children.at(0).children.empty());
  const auto program = bt::compile(*file, bt::NodeLibrary());
  QVERIFY(textOf(program.diagnostics()).find("piece-of-this-file") != std::string::npos);
  // The mark of a piece is no text.
  QVERIFY(!bt::readTreeText(root(tree("T", "<\xFFpiece n='0'/>")), "t.xml"));
}

/// The model block of a file is as deep as its trees may be.
void TreeXmlTest::read_deepBlock_isWhole() {
  for (const int depth : {200, 300}) {
    const std::string block = "<TreeNodesModel>" + repeated("<a>", depth) + "<b c='d'/>" +
                              repeated("</a>", depth) + "</TreeNodesModel>";
    const base::Result<bt::TreeFile> file =
        bt::readTreeText(root(tree("T", "<AlwaysSuccess/>") + block), "t.xml");
    QCOMPARE(bool(file), depth < bt::kMaxNesting);
    if (!file) {
      QVERIFY(textOf(file.diagnostics()).find("nested") != std::string::npos);
      continue;
    }
    const bt::XmlBlock* last = &*file->model;
    for (int i = 0; i < depth; ++i) {
      QCOMPARE(last->children.size(), std::size_t(1));
      last = &last->children[0];
      QCOMPARE(last->tag, std::string("a"));
    }
    QCOMPARE(last->children.at(0).attributes, (bt::Attributes{{"c", "d"}}));
    const std::string written = bt::writeTree(*file, bt::NodeLibrary().catalogue());
    QVERIFY(*parsed(written).model == *file->model);
  }
}

void TreeXmlTest::read_deepNesting_isRead() {
  constexpr int kDeep = 250;
  QString text = QStringLiteral("<root BTCPP_format='4'>\n<BehaviorTree ID='T'>\n");
  for (int i = 0; i < kDeep; ++i) {
    text += QStringLiteral("<Inverter name='i%1'>\n").arg(i);
  }
  text += QStringLiteral("<AlwaysSuccess name='a > \"b'/><!-- <x> -->\n");
  text += QStringLiteral("</Inverter>\n").repeated(kDeep);
  const QString end = QStringLiteral("</BehaviorTree>\n</root>");
  const base::Result<bt::TreeFile> file = bt::readTreeText((text + end).toStdString(), "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec* node = &file->trees[0].root;
  for (int i = 0; i < kDeep; ++i) {
    QCOMPARE(node->name, "i" + std::to_string(i));
    QCOMPARE(node->line, 3 + i);
    QCOMPARE(node->children.size(), std::size_t(1));
    node = &node->children[0];
  }
  QCOMPARE(node->name, std::string("a > \"b"));
  // An error behind the pieces has its line.
  const base::Result<bt::TreeFile> broken =
      bt::readTreeText((text + QStringLiteral("<x a=/>") + end).toStdString(), "t.xml");
  QVERIFY(!broken);
  QCOMPARE(broken.diagnostics().front().line, 4 + 2 * kDeep);
}

/// 100 000 siblings, each on a line of its own, at a depth where the file is cut.
void TreeXmlTest::read_manyDeepSiblings_takeLittle() {
  constexpr int kDeep = 78;  // below root and BehaviorTree
  constexpr int kMany = 100000;
  std::string text = "<root BTCPP_format='4'>\n<BehaviorTree ID='T'>\n";
  for (int i = 0; i < kDeep; ++i) {
    text += i + 1 < kDeep ? "<Inverter>\n" : "<Sequence>\n";
  }
  for (int i = 0; i < kMany; ++i) {
    text += "<AlwaysSuccess/>\n";
  }
  text += "</Sequence>\n";
  for (int i = 1; i < kDeep; ++i) {
    text += "</Inverter>\n";
  }
  const base::Result<bt::TreeFile> file =
      bt::readTreeText(text + "</BehaviorTree>\n</root>", "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec* node = &file->trees[0].root;
  while (node->children.size() == 1) {
    node = &node->children[0];
  }
  QCOMPARE(node->children.size(), std::size_t{kMany});
  QCOMPARE(node->children.front().line, 3 + kDeep);
  QCOMPARE(node->children.back().line, 2 + kDeep + kMany);
}

void TreeXmlTest::read_deepNesting_isRefusedSoon() {
  for (const int depth : {300, 10000}) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
      text += "<Inverter>";
    }
    text += "<AlwaysSuccess/>";
    for (int i = 0; i < depth; ++i) {
      text += "</Inverter>";
    }
    const base::Result<bt::TreeFile> file =
        bt::readTreeText(root(tree("T", text.c_str())), "t.xml");
    QVERIFY(!file);
    QVERIFY(textOf(file.diagnostics()).find("nested") != std::string::npos);
  }
}

void TreeXmlTest::read_hundredThousandNodes_isRead() {
  std::string text = "<Sequence>";
  for (int i = 0; i < 100000; ++i) {
    text += "<AlwaysSuccess name='n'/>\n";
  }
  text += "</Sequence>";
  const bt::TreeFile file = parsed(root(tree("T", text.c_str())));
  QCOMPARE(file.trees.at(0).root.children.size(), std::size_t(100000));
  const auto program = bt::compile(file, bt::NodeLibrary());
  QVERIFY2(program, textOf(program.diagnostics()).c_str());
  QCOMPARE((*program)->nodeCount(), 100001);
  bt::TreeState state(*program);
  QCOMPARE(state.tickOnce({1, 0.1, nullptr}), base::NodeStatus::Success);
}

void TreeXmlTest::include_ownDefinition_wins() {
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

void TreeXmlTest::include_laterFile_winsOverEarlier() {
  Files files;
  files.write("b.xml", root(tree("R", "<AlwaysFailure/>")));
  files.write("c.xml", root(tree("R", "<AlwaysSuccess/>")));
  const std::string path = files.write(
      "a.xml", root("<include path='b.xml'/><include path='c.xml'/>" + tree("T", "<X/>")));
  const base::Result<bt::TreeTable> table = bt::loadTrees(path);
  QVERIFY(table);
  QVERIFY(table->find("R")->tree.root.id == "AlwaysSuccess");
}

void TreeXmlTest::include_relativePath_isOfTheIncludingFile() {
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

void TreeXmlTest::include_rosPackage_needsItsFolder() {
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

void TreeXmlTest::include_manyTimesDeep_endsSoon() {
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

void TreeXmlTest::mainTree_rules_data() {
  QTest::addColumn<QString>("attributes");
  QTest::addColumn<bool>("second");
  QTest::addColumn<QString>("main");
  const QString format = QStringLiteral("BTCPP_format='4'");
  const QString named = format + QStringLiteral(" main_tree_to_execute='B'");
  QTest::newRow("named") << named << true << QStringLiteral("B");
  QTest::newRow("only one") << format << false << QStringLiteral("A");
  QTest::newRow("not said") << format << true << QString();
}

void TreeXmlTest::mainTree_rules() {
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

void TreeXmlTest::writeModel_catalogue_hasPortsAndDefaults() {
  const base::Result<bt::TreeFile> file =
      bt::readTreeText(bt::writeModel(probe::library().catalogue()));
  QVERIFY(file && file->model);
  const auto& entries = file->model->children;
  const auto stateful = std::find_if(entries.begin(), entries.end(), [](const bt::XmlBlock& e) {
    return *bt::findText(e.attributes, "ID") == "St";
  });
  QVERIFY(stateful != entries.end());
  QVERIFY(stateful->tag == "Action");
  QVERIFY(stateful->children[0].tag == "input_port");
  QVERIFY(*bt::findText(stateful->children[0].attributes, "type") == "int");
  QVERIFY(*bt::findText(stateful->children[0].attributes, "default") == "1");
  for (const bt::XmlBlock& entry : entries) {
    QVERIFY(*bt::findText(entry.attributes, "ID") != "Sequence");
  }
}

void TreeXmlTest::write_reactiveSequence_hasCompactChildren() {
  const bt::TreeFile file = parsed(
      root(tree("T", "<ReactiveSequence><Condition ID='A'/><Action ID='B'/></ReactiveSequence>")));
  const std::string text = bt::writeTree(file, bt::builtinNodes());
  QVERIFY(text.find("<A/>") != std::string::npos);
  QVERIFY(text.find("<Action") == std::string::npos);
}

QTEST_APPLESS_MAIN(TreeXmlTest)
#include "tst_TreeXml.moc"
