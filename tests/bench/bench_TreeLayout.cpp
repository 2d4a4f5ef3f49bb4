#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "editor/trees/TreeGraph.h"
#include "editor/trees/TreeLayout.h"

/// How long a large tree takes to be laid out. The limit is that of the window: a tree of 300 nodes
/// within 10 ms, with the widths of its texts.
class TreeLayoutBench : public QObject {
  Q_OBJECT

 private:
  /// The node of this number and what is below it, three each, of 300.
  static bt::NodeSpec part(int number) {
    bt::NodeSpec node;
    node.id = number == 0 ? "Fallback" : "Sequence";
    node.name = "Part " + std::to_string(number);
    for (int child = 3 * number + 1; child <= 3 * number + 3 && child < 300; ++child) {
      node.children.push_back(part(child));
    }
    return node;
  }

 private Q_SLOTS:
  void places_300Nodes() {
    std::mt19937 draw(3);
    std::vector<editor::LayoutNode> nodes{{-1, 100.0, 46.0}};
    while (nodes.size() < 300) {
      const int last = static_cast<int>(nodes.size()) - 1;
      nodes.push_back({std::max(0, last - static_cast<int>(draw() % 6)), 120.0, 46.0});
    }
    QBENCHMARK {
      QVERIFY(editor::layOutTree(nodes, editor::TreeDirection::Down).width > 0.0);
    }
  }

  void graph_300Nodes_isReadyIn10Ms() {
    editor::PersonTree tree;
    bt::TreeSpec spec;
    spec.id = "Large";
    spec.root = part(0);
    tree.file.trees = {spec};
    tree.table.entries["Large"] = {spec, "large.xml"};
    tree.table.mainTree = "Large";
    editor::TreeGraph graph(editor::Theme::light());
    graph.setTree(tree);
    QCOMPARE(graph.shown().size(), std::size_t{300});
    qint64 best = 1000000000;
    for (int round = 0; round < 20; ++round) {
      QElapsedTimer clock;
      clock.start();
      graph.setDirection(round % 2 == 0 ? editor::TreeDirection::Right
                                        : editor::TreeDirection::Down);
      best = std::min(best, clock.nsecsElapsed());
    }
    qInfo("300 nodes with their texts: %.2f ms", 1e-6 * static_cast<double>(best));
    QVERIFY(best < 10000000);
    QBENCHMARK {
      graph.setDirection(editor::TreeDirection::Down);
    }
  }
};

QTEST_MAIN(TreeLayoutBench)
#include "bench_TreeLayout.moc"
