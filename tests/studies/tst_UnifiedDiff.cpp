#include <QtTest>

#include "app/studies/UnifiedDiff.h"

/// Expected texts are the output of GNU diff 3.8, `diff -u --label a --label b`.
class UnifiedDiffTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void equalTexts_areEmpty() {
    QVERIFY(app::unifiedDiff("a\n", "a\n", "a", "b").empty());
    QVERIFY(app::unifiedDiff("", "", "a", "b").empty());
  }

  void twoChangesFarApart_areTwoBlocks() {
    const std::string before = "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n";
    const std::string after = "1\nx\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\nnew\n";
    QCOMPARE(app::unifiedDiff(before, after, "a", "b"),
             std::string("--- a\n+++ b\n@@ -1,5 +1,5 @@\n 1\n-2\n+x\n 3\n 4\n 5\n"
                         "@@ -10,3 +10,4 @@\n 10\n 11\n 12\n+new\n"));
  }

  void lineWithoutEnd_isMarked() {
    QCOMPARE(
        app::unifiedDiff("a\nb", "a\nb\n", "a", "b"),
        std::string("--- a\n+++ b\n@@ -1,2 +1,2 @@\n a\n-b\n\\ No newline at end of file\n+b\n"));
  }

  void emptyText_hasLineZero() {
    QCOMPARE(app::unifiedDiff("", "a\n", "a", "b"),
             std::string("--- a\n+++ b\n@@ -0,0 +1 @@\n+a\n"));
  }
};

QTEST_APPLESS_MAIN(UnifiedDiffTest)
#include "tst_UnifiedDiff.moc"
