#include <algorithm>

#include <QtTest>

#include "app/studies/DeltaDebugging.h"

using app::ElementSet;

namespace {

/// Fails if the subset contains all of these elements.
app::SubsetTest containing(ElementSet cause, std::size_t& tests) {
  return [cause = std::move(cause), &tests](const std::vector<ElementSet>& subsets) {
    tests += subsets.size();
    std::vector<bool> results;
    for (const ElementSet& subset : subsets) {
      results.push_back(std::includes(subset.begin(), subset.end(), cause.begin(), cause.end()));
    }
    return base::Result<std::vector<bool>>(results);
  };
}

}  // namespace

/// The algorithm ddmin of Zeller & Hildebrandt (2002).
class DeltaDebuggingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cause_anyElements_isFound_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<QVector<int>>("cause");
    QTest::newRow("nothing is needed") << 5 << QVector<int>{};
    QTest::newRow("the paper's example: 1, 7 and 8 of 8") << 8 << QVector<int>{0, 6, 7};
    QTest::newRow("one of many") << 100 << QVector<int>{63};
    QTest::newRow("first and last") << 31 << QVector<int>{0, 30};
    QTest::newRow("all") << 6 << QVector<int>{0, 1, 2, 3, 4, 5};
    QTest::newRow("one alone") << 1 << QVector<int>{0};
    QTest::newRow("no elements") << 0 << QVector<int>{};
  }
  void cause_anyElements_isFound() {
    QFETCH(int, count);
    QFETCH(QVector<int>, cause);
    ElementSet expected;
    for (const int element : cause) {
      expected.push_back(static_cast<std::size_t>(element));
    }
    std::size_t tests = 0;
    const auto found =
        app::minimalFailure(static_cast<std::size_t>(count), containing(expected, tests));
    QVERIFY(bool(found));
    QCOMPARE(*found, expected);
    // Zeller & Hildebrandt: at most |c|^2 + 3 |c| tests, and here the empty set.
    QVERIFY(tests <= static_cast<std::size_t>(count) * static_cast<std::size_t>(count) +
                         3U * static_cast<std::size_t>(count) + 1U);
  }

  void interferingCauses_resultIsOneMinimal() {
    // Fails with an odd number of elements below 5, so that no half of the whole fails.
    const app::SubsetTest fails = [](const std::vector<ElementSet>& subsets) {
      std::vector<bool> results;
      for (const ElementSet& subset : subsets) {
        results.push_back(std::count_if(subset.begin(), subset.end(),
                                        [](std::size_t element) { return element < 5; }) %
                              2 ==
                          1);
      }
      return base::Result<std::vector<bool>>(results);
    };
    const auto found = app::minimalFailure(9, fails);
    QVERIFY(bool(found));
    QCOMPARE(found->size(), std::size_t{1});
    QVERIFY(found->front() < 5);
  }

  void error_endsTheMinimisation() {
    int calls = 0;
    const auto found = app::minimalFailure(
        4, [&calls](const std::vector<ElementSet>& subsets) -> base::Result<std::vector<bool>> {
          if (++calls == 2) {
            return base::error("study.stopped", {1});
          }
          return std::vector<bool>(subsets.size(), false);
        });
    QVERIFY(!found);
    QCOMPARE(calls, 2);
  }
};

QTEST_APPLESS_MAIN(DeltaDebuggingTest)
#include "tst_DeltaDebugging.moc"
