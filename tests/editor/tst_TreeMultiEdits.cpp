#include <QtTest>

#include "bt/tree/TreeXml.h"
#include "editor/trees/TreeEdits.h"

using editor::NodeLocation;
using editor::OptionalLocations;

/// Edits of several nodes of a tree at once.
class TreeMultiEditsTest : public QObject {
  Q_OBJECT

 private:
  /// A node "name" is `<Sequence name='name'>`, so that places and names are told apart.
  static bt::TreeFile plain() {
    return *bt::readTreeText(
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Fallback name='r'>"
        "<Sequence name='a'><AlwaysSuccess name='a0'/><AlwaysSuccess name='a1'/>"
        "<AlwaysSuccess name='a2'/></Sequence>"
        "<Inverter name='i'><AlwaysFailure name='i0'/></Inverter>"
        "<Sequence name='b'><AlwaysSuccess name='b0'/></Sequence>"
        "</Fallback></BehaviorTree></root>");
  }
  static QString shortOf(const bt::NodeSpec& node) {
    QStringList children;
    for (const bt::NodeSpec& child : node.children) {
      children << shortOf(child);
    }
    const QString label = QString::fromStdString(node.label());
    return children.isEmpty()
               ? label
               : QStringLiteral("%1(%2)").arg(label, children.join(QLatin1Char(' ')));
  }
  static QString shortOf(const bt::TreeFile& file) { return shortOf(file.trees.front().root); }
  static std::vector<NodeLocation> at(const std::vector<bt::NodePath>& paths) {
    std::vector<NodeLocation> places;
    places.reserve(paths.size());
    for (const bt::NodePath& path : paths) {
      places.push_back({"Main", path});
    }
    return places;
  }

 private Q_SLOTS:
  void inner_areLeftOut() {
    QVERIFY(editor::withoutDescendants(at({{2}, {0, 1}, {0}, {2, 0}, {1, 0}})) ==
            at({{0}, {1, 0}, {2}}));
    QVERIFY(editor::withoutDescendants(at({{0, 1}, {}})) == at({{}}));
    QVERIFY(editor::areSiblings(at({{0}, {2}})));
    QVERIFY(!editor::areSiblings(at({{0}, {2, 0}})));
    QVERIFY(!editor::areSiblings(at({{}})));
  }

  void remove_takesAllInAnyOrder() {
    bt::TreeFile file = plain();
    QVERIFY(editor::removeNodes(file, at({{2, 0}, {0, 0}, {0, 2}, {1}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a1) b)"));
    QVERIFY(!editor::removeNodes(file, at({{}})));
  }

  void move_data() {
    QTest::addColumn<QString>("nodes");
    QTest::addColumn<QString>("parent");
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* nodes, const char* parent, int index,
                        const char* result) {
      QTest::newRow(name) << nodes << parent << index << result;
    };
    row("to another parent", "0.0 0.2", "2", 0, "r(a(a1) i(i0) b(a0 a2 b0))");
    row("behind all there", "0.0 0.2", "2", 9, "r(a(a1) i(i0) b(b0 a0 a2))");
    row("forward in a row", "0 1", "", 3, "r(b(b0) a(a0 a1 a2) i(i0))");
    row("backward", "1 2", "", 0, "r(i(i0) b(b0) a(a0 a1 a2))");
    row("apart, together", "0.0 0.2", "0", 2, "r(a(a1 a0 a2) i(i0) b(b0))");
    row("from two parents", "0.1 2.0", "", 1, "r(a(a0 a2) a1 b0 i(i0) b)");
    row("parent after the gap", "0 1", "2", 1, "r(b(b0 a(a0 a1 a2) i(i0)))");
    row("where they are", "0 1", "", 1, "");
    row("into one of them", "0 1", "0", 0, "");
    row("no room", "0.0 0.1", "1", 1, "");
  }
  void move() {
    QFETCH(QString, nodes);
    QFETCH(QString, parent);
    QFETCH(int, index);
    QFETCH(QString, result);
    const auto pathOf = [](const QString& text) {
      bt::NodePath path;
      for (const QString& part : text.split(QLatin1Char('.'), Qt::SkipEmptyParts)) {
        path.push_back(part.toInt());
      }
      return path;
    };
    std::vector<bt::NodePath> paths;
    for (const QString& each : nodes.split(QLatin1Char(' '))) {
      paths.push_back(pathOf(each));
    }
    bt::TreeFile file = plain();
    const OptionalLocations moved =
        editor::moveNodes(file, at(paths), {"Main", pathOf(parent)}, index);
    QCOMPARE(moved.has_value(), !result.isEmpty());
    if (moved) {
      QCOMPARE(shortOf(file), result);
      QCOMPARE(moved->size(), paths.size());
      for (std::size_t k = 0; k < paths.size(); ++k) {
        const bt::TreeFile before = plain();
        QCOMPARE(editor::nodeAt(file, (*moved)[k])->label(),
                 editor::nodeAt(before, at(paths)[k])->label());
      }
    }
  }

  void wrap_siblings_standInOneNode() {
    bt::TreeFile file = plain();
    bt::NodeSpec around = editor::defaultNode("Sequence");
    around.name = "w";
    QVERIFY(editor::wrapNodes(file, at({{0}, {2}}), around) == OptionalLocations(at({{0}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(w(a(a0 a1 a2) b(b0)) i(i0))"));
    file = plain();
    QVERIFY(!editor::wrapNodes(file, at({{0}, {2, 0}}), around));
    file = plain();
    QVERIFY(!editor::wrapNodes(file, at({{0}, {2}}), editor::defaultNode("Inverter")));
    file = plain();
    QVERIFY(editor::wrapNodes(file, at({{}}), around));  // the root alone may be
    QCOMPARE(shortOf(file), QStringLiteral("w(r(a(a0 a1 a2) i(i0) b(b0)))"));
  }

  void duplicate_siblingsBehindTheLast_othersBehindThemselves() {
    bt::TreeFile file = plain();
    QVERIFY(editor::duplicateNodes(file, at({{0}, {1}})) == OptionalLocations(at({{2}, {3}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a0 a1 a2) i(i0) a(a0 a1 a2) i(i0) b(b0))"));
    file = plain();
    QVERIFY(editor::duplicateNodes(file, at({{0, 0}, {2}})) ==
            OptionalLocations(at({{0, 1}, {3}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a0 a0 a1 a2) i(i0) b(b0) b(b0))"));
    file = plain();
    QVERIFY(editor::duplicateNodes(file, at({{1}, {2, 0}})) ==
            OptionalLocations(at({{2}, {3, 1}})));
    QVERIFY(!editor::duplicateNodes(file, at({{1, 0}, {2}})));  // the inverter holds one
  }

  void text_ofSeveral_isReadBack() {
    const bt::TreeFile file = plain();
    const std::string text = editor::nodesText(
        {editor::nodeAt(file, at({{0}})[0]), editor::nodeAt(file, at({{1, 0}})[0])});
    bt::TreeFile into;
    const auto nodes = editor::nodesFromText(text, into);
    QVERIFY(nodes && nodes->size() == 2);
    QVERIFY((*nodes)[0] == *editor::nodeAt(file, at({{0}})[0]));
    QVERIFY((*nodes)[1] == *editor::nodeAt(file, at({{1, 0}})[0]));
    QVERIFY(!editor::nodesFromText("<Sequence><", into));
    QVERIFY(!editor::nodesFromText("words", into));
  }
};

QTEST_APPLESS_MAIN(TreeMultiEditsTest)
#include "tst_TreeMultiEdits.moc"
