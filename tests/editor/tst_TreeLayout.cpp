#include <cmath>
#include <random>

#include <QtTest>

#include "bt/tree/TreeXml.h"
#include "editor/trees/TreeGraph.h"
#include "editor/trees/TreeLayout.h"
#include "tests/support/Interop.h"

using editor::LayoutBox;
using editor::LayoutNode;
using editor::TreeDirection;
using editor::TreeLayoutResult;

class TreeLayoutTest : public QObject {
  Q_OBJECT

 private:
  static double middleX(const LayoutBox& box) { return box.x + 0.5 * box.width; }
  static bool overlap(const LayoutBox& a, const LayoutBox& b) {
    constexpr double kSlack = 1e-6;
    return a.x + a.width > b.x + kSlack && b.x + b.width > a.x + kSlack &&
           a.y + a.height > b.y + kSlack && b.y + b.height > a.y + kSlack;
  }
  /// Empty: all is as the header says.
  static QString problemOf(const std::vector<LayoutNode>& nodes, const TreeLayoutResult& places,
                           double gap) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const LayoutBox& a = places.boxes[i];
      if (a.x < -1e-9 || a.y < -1e-9 || a.x + a.width > places.width + 1e-9 ||
          a.y + a.height > places.height + 1e-9) {
        return QStringLiteral("%1 is outside").arg(i);
      }
      double first = 0.0, last = 0.0, before = 0.0;
      bool any = false;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const LayoutBox& b = places.boxes[k];
        if (k != i && overlap(a, b)) {
          return QStringLiteral("%1 lies on %2").arg(i).arg(k);
        }
        if (nodes[k].parent != static_cast<int>(i)) {
          continue;
        }
        if (any && b.x < before + gap - 1e-6) {
          return QStringLiteral("%1 is not right of its sibling").arg(k);
        }
        first = any ? first : middleX(b);
        last = middleX(b);
        before = b.x + b.width;
        any = true;
      }
      if (any && std::abs(middleX(a) - 0.5 * (first + last)) > 1e-6) {
        return QStringLiteral("%1 is not over the middle of its children").arg(i);
      }
    }
    return {};
  }
  static std::vector<LayoutNode> randomTree(std::mt19937& draw, int count) {
    std::vector<LayoutNode> nodes{{-1, 100.0, 40.0}};
    std::vector<int> open{0};  // the way from the root to the last node: parents stand first
    while (static_cast<int>(nodes.size()) < count) {
      const std::size_t level = draw() % open.size();
      open.resize(level + 1);
      nodes.push_back({open.back(), 60.0 + static_cast<int>(draw() % 140),
                       30.0 + static_cast<int>(draw() % 20)});
      open.push_back(static_cast<int>(nodes.size()) - 1);
    }
    return nodes;
  }
  static void addFiles(const QString& folder) {
    QDirIterator files(folder, {QStringLiteral("*.xml")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      if (!path.contains(QStringLiteral("/bad/"))) {
        QTest::newRow(qPrintable(path.mid(folder.size() + 1))) << path;
      }
    }
  }

 private Q_SLOTS:
  /// By hand: leaves of 100 with gaps of 8 side by side, the root over the middle one.
  void threeLeaves_standBesideEachOther() {
    const std::vector<LayoutNode> nodes = {
        {-1, 60.0, 20.0}, {0, 100.0, 30.0}, {0, 100.0, 40.0}, {0, 100.0, 30.0}};
    const TreeLayoutResult places = editor::layOutTree(nodes, TreeDirection::Down, {8.0, 44.0});
    QCOMPARE(places.boxes[1].x, 0.0);
    QCOMPARE(places.boxes[2].x, 108.0);
    QCOMPARE(places.boxes[3].x, 216.0);
    QCOMPARE(places.boxes[0].x, 128.0);
    QCOMPARE(places.boxes[0].y, 0.0);
    QCOMPARE(places.boxes[3].y, 64.0);  // below the root and a gap
    QCOMPARE(places.width, 316.0);
    QCOMPARE(places.height, 104.0);
  }

  void leftToRight_isTheSameTurned() {
    const std::vector<LayoutNode> nodes = {
        {-1, 60.0, 20.0}, {0, 100.0, 30.0}, {0, 80.0, 40.0}, {1, 50.0, 30.0}};
    const TreeLayoutResult places = editor::layOutTree(nodes, TreeDirection::Right, {8.0, 44.0});
    QCOMPARE(places.boxes[1].x, 104.0);
    QCOMPARE(places.boxes[2].x, 104.0);
    QCOMPARE(places.boxes[3].x, 248.0);  // behind the wider of the level before
    QCOMPARE(places.boxes[1].y, 0.0);
    QCOMPARE(places.boxes[2].y, 38.0);
    QCOMPARE(places.boxes[0].y, 26.5);  // its middle between 15 and 58
  }

  /// A small subtree between two wide ones stands in the middle of the room that they leave.
  void smallBetweenWide_isSpreadEvenly() {
    std::vector<LayoutNode> nodes = {{-1, 10.0, 10.0}, {0, 10.0, 10.0}};
    const auto addLeaves = [&nodes](int parent) {
      for (int k = 0; k < 9; ++k) {
        nodes.push_back({parent, 20.0, 10.0});
      }
    };
    addLeaves(1);
    nodes.push_back({0, 10.0, 10.0});  // 11
    nodes.push_back({0, 10.0, 10.0});  // 12
    addLeaves(12);
    const TreeLayoutResult places = editor::layOutTree(nodes, TreeDirection::Down, {8.0, 44.0});
    QCOMPARE(problemOf(nodes, places, 8.0), QString());
    QCOMPARE(middleX(places.boxes[11]),
             0.5 * (middleX(places.boxes[1]) + middleX(places.boxes[12])));
  }

  void equalSubtrees_lookEqual() {
    const std::vector<LayoutNode> nodes = {{-1, 50, 20}, {0, 50, 20}, {1, 90, 20}, {1, 30, 20},
                                           {0, 50, 20},  {4, 90, 20}, {4, 30, 20}};
    const TreeLayoutResult places = editor::layOutTree(nodes, TreeDirection::Down);
    const double shift = places.boxes[4].x - places.boxes[1].x;
    QCOMPARE(places.boxes[5].x - places.boxes[2].x, shift);
    QCOMPARE(places.boxes[6].x - places.boxes[3].x, shift);
  }

  void randomTrees_neverOverlap() {
    std::mt19937 draw(11);
    for (int round = 0; round < 300; ++round) {
      const std::vector<LayoutNode> nodes = randomTree(draw, 2 + static_cast<int>(draw() % 120));
      const TreeLayoutResult places = editor::layOutTree(nodes, TreeDirection::Down, {8.0, 44.0});
      QCOMPARE(problemOf(nodes, places, 8.0), QString());
    }
  }

  void severalRootsNoneAndDeepTrees_arePlaced() {
    QVERIFY(editor::layOutTree({}, TreeDirection::Down).boxes.empty());
    const std::vector<LayoutNode> roots = {{-1, 50, 20}, {0, 50, 20}, {-1, 50, 20}};
    const TreeLayoutResult two = editor::layOutTree(roots, TreeDirection::Down);
    QCOMPARE(two.boxes[2].y, 0.0);
    QCOMPARE(two.boxes[2].x, 58.0);
    std::vector<LayoutNode> chain;
    chain.reserve(100000);
    for (int k = 0; k < 100000; ++k) {  // nothing calls itself
      chain.push_back({k - 1, 10, 10});
    }
    QCOMPARE(editor::layOutTree(chain, TreeDirection::Down, {8, 5}).height, 100000 * 15.0 - 5.0);
  }

  void fileTree_inBothDirections_hasNoOverlap_data() {
    QTest::addColumn<QString>("path");
    addFiles(QStringLiteral(SOURCE_DIR "/maps"));
    addFiles(QStringLiteral(TEST_DATA_DIR));
    addFiles(interopFolder());
    if (interopFile(QStringLiteral("hunavsim2")).isEmpty()) {
      QTest::newRow("files of other programs") << QString();
    }
  }
  void fileTree_inBothDirections_hasNoOverlap() {
    QFETCH(QString, path);
    if (path.isEmpty()) {
      QSKIP("the files of other programs are not there (HUNAV_INTEROP_DIR)");
    }
    const base::Result<bt::TreeFile> file = bt::readTree(path.toStdString());
    if (!file) {
      return;  // no tree, or broken on purpose
    }
    editor::PersonTree tree;
    tree.file = *file;
    for (const bt::TreeSpec& each : file->trees) {
      tree.table.entries[each.id] = {each, path.toStdString()};
    }
    for (const bt::TreeSpec& each : file->trees) {
      tree.table.mainTree = each.id;
      editor::TreeGraph graph(editor::Theme::light());
      graph.setTree(tree);
      for (const TreeDirection direction : {TreeDirection::Down, TreeDirection::Right}) {
        graph.setDirection(direction);
        graph.unfoldAll();
        QCOMPARE(graph.shown().size(), graph.nodes().size());
        for (const int a : graph.shown()) {
          QVERIFY(graph.bounds().contains(graph.box(a)));
          for (const int b : graph.shown()) {
            QVERIFY2(a == b || !graph.box(a).intersects(graph.box(b)),
                     qPrintable(QStringLiteral("%1 %2").arg(a).arg(b)));
          }
        }
      }
    }
  }
};

QTEST_MAIN(TreeLayoutTest)
#include "tst_TreeLayout.moc"
