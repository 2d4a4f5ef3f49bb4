#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/trees/TreeGraph.h"
#include "sim2d/base/Text.h"
#include "tests/support/Interop.h"

using editor::EntityId;
using editor::OutlineNode;
using editor::ScenarioDocument;

/// Trees of other programs: opened, edited in one place, saved with that change only.
class ForeignTreesTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  EntityId ana() const { return document_->scenario().humans.front().key; }

  std::string savedText(const QTemporaryDir& folder) {
    const QString scenario = folder.filePath(QStringLiteral("small.yaml"));
    [&] { QVERIFY(!base::hasErrors(document_->save(scenario, {ana()}))); }();
    const QString tree = folder.filePath(QStringLiteral("small__agent_1_bt.xml"));
    const base::Result<std::string> text = base::readTextFile(tree.toStdString());
    return text ? *text : "not there: " + tree.toStdString();
  }
  static std::string with(std::string text, const std::string& was, const std::string& is) {
    const std::size_t at = text.find(was);
    return at == std::string::npos ? "not there: " + was : text.replace(at, was.size(), is);
  }

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(small::scenario());
    document_->setMap(small::room());
  }
  void cleanup() { document_.reset(); }

  /// As Groot2 writes: explicit notation, its own attributes, a model; and nodes nobody knows.
  void grootFile_editedInOnePort_keepsAllElse() {
    const std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<root BTCPP_format=\"4\" project_name=\"Project\">\n"
        "  <!-- greets -->\n"
        "  <BehaviorTree ID=\"Greet\" _fullpath=\"\" editor_status=\"expanded\">\n"
        "    <Fallback _uid=\"1\" _x=\"120.5\" _y=\"40\">\n"
        "      <Condition ID=\"IsRobotVisible\" agent_id=\"{id}\" distance=\"5.0\" "
        "_uid=\"2\"/>\n"
        "      <Action ID=\"Juggle\"   balls=\"3\"  _uid=\"3\" _x=\"10\"/>\n"
        "    </Fallback>\n"
        "  </BehaviorTree>\n"
        "\n"
        "  <!-- Description of Node Models (used by Groot) -->\n"
        "  <TreeNodesModel>\n"
        "    <Action ID=\"Juggle\" editable=\"true\">\n"
        "      <input_port name=\"balls\" type=\"int\">how many</input_port>\n"
        "    </Action>\n"
        "  </TreeNodesModel>\n"
        "</root>\n";
    pushTreeText(*document_, ana(), text, QStringLiteral("take"));
    editor::TreeGraph graph(editor::Theme::light());
    graph.setTree(personTree(*document_, ana()));
    QCOMPARE(graph.nodes().size(), std::size_t{3});
    QVERIFY(graph.isUnknown(2));
    QVERIFY(!graph.problemsOf(2).empty());
    QVERIFY(graph.problemsOf(1).empty());
    const QTemporaryDir folder;
    QCOMPARE(savedText(folder), text);  // nothing was edited
    pushPort(*document_, ana(), graph.node(1), "distance", "7.5");
    QCOMPARE(savedText(folder), with(text, "\"5.0\"", "\"7.5\""));
    graph.setTree(personTree(*document_, ana()));
    pushPort(*document_, ana(), graph.node(2), "balls", "4");
    QCOMPARE(savedText(folder), with(with(text, "\"5.0\"", "\"7.5\""), "\"3\"", "\"4\""));
  }

  void severalTreesWithoutAMain_areShownToBeEdited() {
    pushTreeText(*document_, ana(),
                 std::string("<root BTCPP_format=\"4\"><BehaviorTree ID=\"A\"><AlwaysSuccess/>"
                             "</BehaviorTree><BehaviorTree ID=\"B\"><AlwaysFailure/>"
                             "</BehaviorTree></root>"),
                 QStringLiteral("take"));
    const editor::PersonTree tree = personTree(*document_, ana());
    QCOMPARE(outlineOf(tree).size(), std::size_t{1});
  }

  void interopFile_editedInOnePort_isSavedWithThatChangeOnly_data() {
    QTest::addColumn<QString>("path");
    if (interopFile(QStringLiteral("hunavsim2")).isEmpty()) {
      QTest::newRow("no files") << QString();
      return;
    }
    QDirIterator files(interopFile(QStringLiteral("hunavsim2")), {QStringLiteral("*.xml")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      QTest::newRow(qPrintable(path.mid(interopFolder().size() + 1))) << path;
    }
  }
  void interopFile_editedInOnePort_isSavedWithThatChangeOnly() {
    QFETCH(QString, path);
    if (path.isEmpty()) {
      QSKIP("the files of other programs are not there (HUNAV_INTEROP_DIR)");
    }
    const base::Result<std::string> text = base::readTextFile(path.toStdString());
    QVERIFY(text);
    pushTreeText(*document_, ana(), *text, QStringLiteral("take"));
    const editor::PersonTree tree = personTree(*document_, ana());
    const std::vector<OutlineNode> nodes = outlineOf(tree);
    const auto found = std::find_if(nodes.begin(), nodes.end(), [](const OutlineNode& node) {
      return node.isEditable && !node.node->ports.empty();
    });
    if (found == nodes.end()) {
      QVERIFY(tree.file.trees.empty());  // the file of models
      return;
    }
    const bt::Attribute port = found->node->ports.front();
    pushPort(*document_, ana(), *found, port.name, "{edited}");
    const QTemporaryDir folder;
    const std::string saved = savedText(folder);
    QCOMPARE(saved, *document_->tree(ana()));
    const auto begin = std::mismatch(text->begin(), text->end(), saved.begin(), saved.end());
    const auto end = std::mismatch(text->rbegin(), std::make_reverse_iterator(begin.first),
                                   saved.rbegin(), std::make_reverse_iterator(begin.second));
    const std::string was(begin.first, end.first.base()), is(begin.second, end.second.base());
    QVERIFY2(port.text.find(was) != std::string::npos || was == "\"" + port.text + "\"",
             was.c_str());
    QVERIFY2(std::string("\"{edited}\"").find(is) != std::string::npos, is.c_str());
    document_->undoStack().undo();
    QCOMPARE(savedText(folder), *text);
  }
};

QTEST_MAIN(ForeignTreesTest)
#include "tst_ForeignTrees.moc"
