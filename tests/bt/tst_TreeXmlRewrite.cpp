#include <QtTest/QtTest>

#include <QDirIterator>

#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "tests/support/Interop.h"

namespace {

/// A tree with things said within and before its nodes.
constexpr const char* kCommented =
    "<root BTCPP_format=\"4\">\n"
    "  <BehaviorTree ID=\"Main\">\n"
    "    <Fallback>\n"
    "      <!-- first this -->\n"
    "      <Sequence name='A'>\n"
    "        <!-- inside\n"
    "             in two lines -->\n"
    "        <GoTo   goal_id='1' agent_id='{id}'/> <!-- behind -->\n"
    "      </Sequence>\n"
    "      <Sequence name='B'>\n"
    "        <AlwaysSuccess/>\n"
    "      </Sequence>\n"
    "    </Fallback>\n"
    "  </BehaviorTree>\n"
    "</root>\n";

}  // namespace

/// Edits of a tree in the text that it was read from.
class TreeXmlRewriteTest : public QObject {
  Q_OBJECT

 private:
  const bt::NodeCatalogue catalogue_ = bt::builtinNodes();

  static constexpr const char* kText =
      "<?xml version='1.0'?>\n"
      "<!-- by hand -->\n"
      "<root   BTCPP_format=\"4\">\n"
      "    <BehaviorTree ID=\"Main\" _fullpath=\"\" x='10'>\n"
      "        <Sequence   name='Walk' _uid=\"3\">\n"
      "            <!-- who -->\n"
      "            <IsRobotVisible  distance='5.0'   agent_id=\"{id}\" _x=\"1\"/>\n"
      "            <Dance how=\"a &amp; b\"/>   <!-- nobody knows it -->\n"
      "            <Action ID=\"GoTo\"\n"
      "                    agent_id=\"{id}\"\n"
      "                    goal_id=\"3\"/>\n"
      "        </Sequence>\n"
      "    </BehaviorTree>\n"
      "</root>\n";

  static bt::TreeFile fileOf(const std::string& text) {
    const base::Result<bt::TreeFile> file = bt::readTreeText(text);
    return file ? *file : bt::TreeFile();
  }
  static bt::NodeSpec& rootOf(bt::TreeFile& file) { return file.trees.front().root; }
  std::string rewritten(const bt::TreeFile& file, const std::string& before = kText) const {
    return bt::rewriteTree(before, file, catalogue_);
  }
  /// `text` with `was`, which it holds once, replaced.
  static std::string with(std::string text, const std::string& was, const std::string& is) {
    const std::size_t at = text.find(was);
    return at == std::string::npos ? "not there: " + was : text.replace(at, was.size(), is);
  }

  /// The first node with a port, deepest first.
  static bt::NodeSpec* nodeWithPort(bt::NodeSpec& node) {
    for (bt::NodeSpec& child : node.children) {
      if (bt::NodeSpec* found = nodeWithPort(child)) {
        return found;
      }
    }
    return node.ports.empty() ? nullptr : &node;
  }

 private Q_SLOTS:
  void nothingChanged_everyByteStays() { QCOMPARE(rewritten(fileOf(kText)), std::string(kText)); }

  void port_changed_onlyItsValueIsAnother() {
    bt::TreeFile file = fileOf(kText);
    bt::setAttribute(rootOf(file).children[0].ports, "distance", "7.5 \"m\"");
    QCOMPARE(rewritten(file), with(kText, "'5.0'", "\"7.5 &quot;m&quot;\""));
  }

  void port_addedAndRemoved_otherAttributesStay() {
    bt::TreeFile file = fileOf(kText);
    bt::setAttribute(rootOf(file).children[2].ports, "tolerance", "0.2");
    QCOMPARE(rewritten(file), with(kText, "goal_id=\"3\"/>", "goal_id=\"3\" tolerance=\"0.2\"/>"));
    file = fileOf(kText);
    bt::removeAttribute(rootOf(file).children[0].ports, "distance");
    QCOMPARE(rewritten(file), with(kText, "  distance='5.0'", ""));
  }

  void name_changedAndGone_isOneAttribute() {
    bt::TreeFile file = fileOf(kText);
    rootOf(file).name = "Stroll";
    QCOMPARE(rewritten(file), with(kText, "'Walk'", "\"Stroll\""));
    rootOf(file).name.clear();
    QCOMPARE(rewritten(file), with(kText, "   name='Walk'", ""));
  }

  void node_added_standsOnALineOfItsOwn() {
    bt::TreeFile file = fileOf(kText);
    bt::NodeSpec node;
    node.id = "StopMovement";
    node.ports = {{"agent_id", "{id}"}};
    std::vector<bt::NodeSpec>& children = rootOf(file).children;
    children.insert(children.begin() + 2, node);
    QCOMPARE(rewritten(file),
             with(kText, "/>   <!--", "/>\n            <StopMovement agent_id=\"{id}\"/>   <!--"));
  }

  void node_toAnotherParent_takesItsCommentsAlong() {
    bt::TreeFile file = fileOf(kCommented);
    bt::NodeSpec& root = rootOf(file);
    const bt::NodeSpec moved = root.children[0];
    root.children.erase(root.children.begin());
    root.children[0].children.push_back(moved);
    QCOMPARE(QString::fromStdString(rewritten(file, kCommented)),
             QStringLiteral("<root BTCPP_format=\"4\">\n"
                            "  <BehaviorTree ID=\"Main\">\n"
                            "    <Fallback>\n"
                            "      <Sequence name='B'>\n"
                            "        <AlwaysSuccess/>\n"
                            "        <!-- first this -->\n"
                            "        <Sequence name='A'>\n"
                            "          <!-- inside\n"
                            "               in two lines -->\n"
                            "          <GoTo   goal_id='1' agent_id='{id}'/> <!-- behind -->\n"
                            "        </Sequence>\n"
                            "      </Sequence>\n"
                            "    </Fallback>\n"
                            "  </BehaviorTree>\n"
                            "</root>\n"));
  }

  void node_wrappedUnwrappedOrExtracted_keepsWhatIsSaidInIt() {
    const auto hasAll = [](const std::string& text) {
      const auto has = [&text](const char* words) { return text.find(words) != text.npos; };
      return has("<!-- inside") && has("in two lines -->") && has("<!-- behind -->") &&
             has("<GoTo   goal_id='1'");
    };
    bt::TreeFile wrapped = fileOf(kCommented);
    bt::NodeSpec around;
    around.id = "Inverter";
    around.children = {rootOf(wrapped).children[0]};
    rootOf(wrapped).children[0] = around;
    QVERIFY(hasAll(rewritten(wrapped, kCommented)));
    bt::TreeFile unwrapped = fileOf(kCommented);
    const bt::NodeSpec inner = rootOf(unwrapped).children[0].children[0];
    rootOf(unwrapped).children[0] = inner;
    const std::string alone = rewritten(unwrapped, kCommented);
    QVERIFY(alone.find("<!-- inside") != alone.npos);
    bt::TreeFile extracted = fileOf(kCommented);
    bt::TreeSpec tree;
    tree.id = "Part";
    tree.root = rootOf(extracted).children[0];
    bt::NodeSpec& place = rootOf(extracted).children[0];
    place = {};
    place.id = "SubTree";
    place.subTree = "Part";
    place.autoRemap = true;
    extracted.mainTree = "Main";
    extracted.trees.push_back(tree);
    QVERIFY(hasAll(rewritten(extracted, kCommented)));
  }

  void node_removed_takesWhatStandsBeforeIt() {
    bt::TreeFile file = fileOf(kText);
    rootOf(file).children.erase(rootOf(file).children.begin());
    QCOMPARE(rewritten(file),
             with(kText,
                  "\n            <!-- who -->\n            <IsRobotVisible  distance='5.0'   "
                  "agent_id=\"{id}\" _x=\"1\"/>",
                  ""));
  }

  void child_ofAClosedElement_opensIt() {
    bt::TreeFile file = fileOf(kText);
    bt::NodeSpec node;
    node.id = "AlwaysSuccess";
    rootOf(file).children[1].children = {node};
    QCOMPARE(
        rewritten(file),
        with(kText, "<Dance how=\"a &amp; b\"/>",
             "<Dance how=\"a &amp; b\">\n              <AlwaysSuccess/>\n            </Dance>"));
    const std::string opened = rewritten(file);
    rootOf(file).children[1].children.clear();
    QCOMPARE(fileOf(rewritten(file, opened)), file);
  }

  void tree_added_standsBehindTheLast() {
    bt::TreeFile file = fileOf(kText);
    bt::TreeSpec more;
    more.id = "More";
    more.root.id = "AlwaysSuccess";
    file.trees.push_back(more);
    QCOMPARE(rewritten(file), with(kText, "</BehaviorTree>",
                                   "</BehaviorTree>\n    <BehaviorTree ID=\"More\">\n"
                                   "      <AlwaysSuccess/>\n    </BehaviorTree>"));
    const std::string two = rewritten(file);
    file.trees.pop_back();
    QCOMPARE(rewritten(file, two), std::string(kText));
  }

  void mainTree_saidChangedAndGone_isOneAttribute() {
    bt::TreeFile file = fileOf(kText);
    file.mainTree = "Main";
    const std::string said = rewritten(file);
    QCOMPARE(said, with(kText, "<root ", "<root main_tree_to_execute=\"Main\" "));
    file.mainTree = "Other";
    QCOMPARE(rewritten(file, said), with(said, "\"Main\" ", "\"Other\" "));
    file.mainTree.clear();
    QCOMPARE(fileOf(rewritten(file, said)), file);
  }

  void otherFile_orNoXml_isWrittenAnew() {
    bt::TreeFile file = fileOf(kText);
    QCOMPARE(rewritten(file, "no xml"), bt::writeTree(file, catalogue_));
    file.includes.push_back({"x.xml", "", 0});
    QCOMPARE(rewritten(file), bt::writeTree(file, catalogue_));
  }

  /// Whatever becomes of the nodes, reading gives it back.
  void randomEdits_areReadAsTheyWereMade() {
    std::uint32_t state = 7;
    const auto draw = [&state](std::size_t below) {
      state = state * 1664525U + 1013904223U;
      return static_cast<int>((state >> 8U) % static_cast<std::uint32_t>(below));
    };
    std::string text = kText;
    bt::TreeFile file = fileOf(text);
    int kept = 0;
    for (int round = 0; round < 400; ++round) {
      bt::NodeSpec* node = &rootOf(file);
      while (!node->children.empty() && draw(3) != 0) {
        node = &node->children[static_cast<std::size_t>(draw(node->children.size()))];
      }
      bt::NodeSpec fresh;
      fresh.id = draw(2) == 0 ? "Sequence" : "GoTo";
      fresh.name = "n" + std::to_string(round);
      const int way = draw(4);
      if (way == 0) {
        node->children.insert(node->children.begin() + draw(node->children.size() + 1), fresh);
      } else if (way == 1 && !node->children.empty()) {
        node->children.erase(node->children.begin() + draw(node->children.size()));
      } else if (way == 2) {
        bt::setAttribute(node->ports, "p" + std::to_string(draw(3)),
                         std::to_string(round) + "<&\"'>");
      } else {
        std::reverse(node->children.begin(), node->children.end());
      }
      text = rewritten(file, text);
      QCOMPARE(fileOf(text), file);
      kept += text.find("<!-- by hand -->") != std::string::npos ? 1 : 0;
    }
    QCOMPARE(kept, 400);  // never written anew
  }

  void interopFile_onePortEdited_nothingElseChanges_data() {
    QTest::addColumn<QString>("path");
    QDirIterator files(interopFolder(), {QStringLiteral("*.xml")}, QDir::Files,
                       QDirIterator::Subdirectories);
    if (!files.hasNext()) {
      QTest::newRow("no files") << QString();
    }
    while (files.hasNext()) {
      const QString path = files.next();
      QTest::newRow(qPrintable(path.mid(interopFolder().size() + 1))) << path;
    }
  }
  void interopFile_onePortEdited_nothingElseChanges() {
    QFETCH(QString, path);
    if (path.isEmpty()) {
      QSKIP("the files of other programs are not there (HUNAV_INTEROP_DIR)");
    }
    const base::Result<std::string> text = base::readTextFile(path.toStdString());
    QVERIFY(text);
    const base::Result<bt::TreeFile> read = bt::readTreeText(*text);
    QVERIFY(read);
    bt::TreeFile file = *read;
    QCOMPARE(rewritten(file, *text), *text);
    bt::NodeSpec* node = nullptr;
    for (bt::TreeSpec& tree : file.trees) {
      node = node == nullptr ? nodeWithPort(tree.root) : node;
    }
    if (node == nullptr) {
      return;  // the file of models
    }
    const std::string was = node->ports.front().text;
    node->ports.front().text = "{edited}";
    const std::string edited = rewritten(file, *text);
    QCOMPARE(fileOf(edited), file);
    // What differs is one stretch, and with the old value in place of the new one it is the file.
    const auto [a, b] = std::mismatch(text->begin(), text->end(), edited.begin(), edited.end());
    const auto [c, d] = std::mismatch(text->rbegin(), std::make_reverse_iterator(a),
                                      edited.rbegin(), std::make_reverse_iterator(b));
    QVERIFY(std::string(a, c.base()).size() <= was.size());
    QVERIFY(std::string(b, d.base()).size() <= std::string("{edited}").size());
    node->ports.front().text = was;
    QCOMPARE(rewritten(file, edited).size(), text->size());
  }
};

QTEST_APPLESS_MAIN(TreeXmlRewriteTest)
#include "tst_TreeXmlRewrite.moc"
