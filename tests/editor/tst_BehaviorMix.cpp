#include "CanvasTester.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorDialogs.h"
#include "editor/panels/properties/EntityPages.h"

using editor::BehaviorMixDialog;
using editor::CrowdRecipe;
using editor::EntityId;
using sim2d::BehaviorType;

/// A mix of behaviours for people who are there already.
class BehaviorMixTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<editor::ScenarioDocument> document_;

  std::vector<BehaviorType> types() const {
    std::vector<BehaviorType> result;
    for (const sim2d::Human& human : document_->scenario().humans) {
      result.push_back(*human.behavior.type);
    }
    return result;
  }
  static std::array<long, 6> countsOf(const std::vector<BehaviorType>& all) {
    std::array<long, 6> counts = {};
    for (const BehaviorType type : all) {
      ++counts[static_cast<std::size_t>(type) - 1];
    }
    return counts;
  }

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<editor::ScenarioDocument>();
    document_->load(small::scenario());
  }
  void cleanup() { document_.reset(); }

  void mixedBehaviors_shares_areKeptToWholePeople_data() {
    QTest::addColumn<int>("people");
    QTest::addColumn<QVector<int>>("mix");
    QTest::addColumn<QVector<int>>("counts");
    QTest::newRow("half") << 10 << QVector<int>{50, 50, 0, 0, 0, 0}
                          << QVector<int>{5, 5, 0, 0, 0, 0};
    QTest::newRow("usual") << 20 << QVector<int>{60, 10, 10, 5, 10, 5}
                           << QVector<int>{12, 2, 2, 1, 2, 1};
    QTest::newRow("parts of any sum")
        << 4 << QVector<int>{0, 0, 0, 0, 3, 1} << QVector<int>{0, 0, 0, 0, 3, 1};
    QTest::newRow("no shares") << 3 << QVector<int>{0, 0, 0, 0, 0, 0}
                               << QVector<int>{3, 0, 0, 0, 0, 0};
    QTest::newRow("nobody") << 0 << QVector<int>{1, 0, 0, 0, 0, 0}
                            << QVector<int>{0, 0, 0, 0, 0, 0};
  }
  void mixedBehaviors_shares_areKeptToWholePeople() {
    QFETCH(int, people);
    QFETCH(QVector<int>, mix);
    QFETCH(QVector<int>, counts);
    CrowdRecipe recipe;
    std::copy(mix.begin(), mix.end(), recipe.mix.begin());
    const auto found = countsOf(shuffledBehaviors(recipe, static_cast<std::size_t>(people)));
    QVERIFY(std::equal(counts.begin(), counts.end(), found.begin()));
  }

  void mixedBehaviors_seed_decidesTheOrder() {
    CrowdRecipe recipe;
    const std::vector<BehaviorType> first = shuffledBehaviors(recipe, 40);
    QVERIFY(shuffledBehaviors(recipe, 40) == first);
    recipe.seed = 2;
    const std::vector<BehaviorType> second = shuffledBehaviors(recipe, 40);
    QVERIFY(second != first);
    QVERIFY(countsOf(second) == countsOf(first));
  }

  void dialog_opened_mixesThoseSelectedAndCancelTakesItBack() {
    document_->setSelection({CanvasTester::person(1), CanvasTester::person(2)});
    const std::vector<BehaviorType> before = types();
    QWidget window;
    BehaviorMixDialog dialog(*document_, editor::Theme::light(), &window);
    for (editor::NumberField* field : dialog.findChildren<editor::NumberField*>()) {
      field->setValue(field->accessibleName() == QStringLiteral("Scared") ? 100.0 : 0.0);
    }
    QCOMPARE(document_->undoStack().count(), 1);
    QVERIFY(types()[0] == BehaviorType::Scared && types()[1] == BehaviorType::Scared);
    QVERIFY(document_->scenario().humans[0].behavior.safeDistance.has_value());
    QVERIFY(std::equal(before.begin() + 2, before.end(), types().begin() + 2));
    dialog.reject();
    QVERIFY(types() == before);
    QVERIFY(document_->scenario() == small::scenario());
  }

  void dialog_openedAndCancelled_keepsWhatCanBeRedone() {
    const EntityId person = CanvasTester::person(1);
    editor::pushMove(*document_, {person}, {1.0, 0.0});
    document_->undoStack().undo();
    QWidget window;
    BehaviorMixDialog dialog(*document_, editor::Theme::light(), &window);
    dialog.reject();
    QVERIFY(document_->undoStack().canRedo());
    document_->undoStack().redo();
    QVERIFY(document_->scenario() != small::scenario());
  }

  void dialog_cancelled_leavesWhatOthersChanged() {
    QWidget window;
    BehaviorMixDialog dialog(*document_, editor::Theme::light(), &window);
    for (editor::NumberField* field : dialog.findChildren<editor::NumberField*>()) {
      field->setValue(field->accessibleName() == QStringLiteral("Scared") ? 100.0 : 0.0);
    }
    editor::pushRemove(*document_, {CanvasTester::person(1)});
    dialog.reject();
    QCOMPARE(document_->scenario().humans.size(), std::size_t{5});
    BehaviorMixDialog again(*document_, editor::Theme::light(), &window);
    editor::pushRemove(*document_, {CanvasTester::person(2)});
    again.accept();  // without who has gone
    QCOMPARE(document_->scenario().humans.size(), std::size_t{4});
  }

  void menu_ofTheScenarioPanel_givesNoBehavioursInARun() {
    editor::ScenarioPanel panel(*document_, editor::Theme::light());
    document_->setSelection({CanvasTester::person(1)});
    for (const bool editing : {true, false}) {
      panel.setEditing(editing);
      QMenu menu;
      panel.fillMenu(menu, CanvasTester::person(1));
      const QList<QMenu*> below = menu.findChildren<QMenu*>();
      QCOMPARE(below.size(), 1);
      for (const QAction* each : below.front()->actions()) {
        QVERIFY(each->isSeparator() || each->isEnabled() == editing);
      }
    }
  }

  void dialog_nobodySelected_isForEverybody() {
    document_->setSelection(document_->entities(base::EntityKind::Goal));
    QCOMPARE(editor::selectedOrAllPeople(*document_).size(), std::size_t{6});
    QWidget window;
    BehaviorMixDialog dialog(*document_, editor::Theme::light(), &window);
    QCOMPARE(dialog.windowTitle(), QStringLiteral("Behaviours of 6 people"));
    QCOMPARE(document_->undoStack().index(), 0);
    dialog.accept();
    QVERIFY(types() == editor::shuffledBehaviors({}, 6));
    QCOMPARE(document_->undoStack().index(), 1);
    document_->undoStack().undo();
    QVERIFY(document_->scenario() == small::scenario());
  }

  void menu_entry_changesThoseSelected() {
    document_->setSelection({CanvasTester::person(1), CanvasTester::person(2)});
    QMenu menu;
    const editor::Theme theme = editor::Theme::light();
    editor::fillBehaviorMenu(menu, *document_, theme, &menu);
    QCOMPARE(menu.actions().size(), 8);  // with a line before the mix
    menu.actions()[3]->trigger();
    QVERIFY(types()[0] == BehaviorType::Scared && types()[1] == BehaviorType::Scared);
    QVERIFY(types()[2] == BehaviorType::Curious);
  }

  void page_ofSeveral_offersTheMix() {
    editor::PersonPage page(*document_, editor::Theme::light());
    const auto isOffered = [&page] {
      const QList<QToolButton*> buttons = page.findChildren<QToolButton*>();
      return std::any_of(buttons.begin(), buttons.end(), [&page](const QToolButton* button) {
        return button->text() == QString::fromUtf8("Mix…") && button->isVisibleTo(&page);
      });
    };
    page.setTargets({CanvasTester::person(1)});
    QVERIFY(!isOffered());
    page.setTargets({CanvasTester::person(1), CanvasTester::person(2)});
    QVERIFY(isOffered());
  }
};

QTEST_MAIN(BehaviorMixTest)
#include "tst_BehaviorMix.moc"
