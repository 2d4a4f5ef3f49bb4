#include "app/window/Docks.h"
#include "app/window/StartPage.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "tests/app/QuietWindow.h"

/// The start page: what it offers, found with keys and mouse, and its stored pictures.
class WindowStartTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  app::ScenarioGallery& gallery() { return window_->startPage().gallery(); }
  static std::vector<app::ShippedScenario> scenarios() {
    const std::string maps = SOURCE_DIR "/maps/";
    return {{"corner_cafe_agents", maps + "corner_cafe/corner_cafe_agents.yaml"},
            {"doorway_agents", maps + "planners/doorway_agents.yaml"},
            {"crossing_agents", maps + "planners/crossing_agents.yaml"},
            {"reaction_scared_agents", maps + "reactions/reaction_scared_agents.yaml"}};
  }
  void restart() {
    quiet::leave(window_);
    app::WindowSetup setup = quiet::setup();
    setup.demos = scenarios();
    setup.thumbnailFolder = at("thumbnails");
    window_ = quiet::shownWindow(setup);
  }
  void waitForPictures() {
    const auto haveAll = [this] {
      const std::vector<app::ScenarioCard*> cards = gallery().shownCards();
      return gallery().areCardsRead() && gallery().thumbnails().isIdle() &&
             std::all_of(cards.begin(), cards.end(),
                         [](const app::ScenarioCard* card) { return card->hasPicture(); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(haveAll(), 30000);
  }
  QStringList shown() {
    QStringList titles;
    for (const app::ScenarioCard* card : gallery().shownCards()) {
      titles << card->info().title;
    }
    return titles;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    restart();
  }
  void cleanup() { end(); }

  void cards_showWhatTheFilesContain() {
    waitForPictures();
    const app::ScenarioInfo& cafe = gallery().shownCards().front()->info();
    QCOMPARE(cafe.contents(), QStringLiteral("8 people · robot"));  // as maps/README.md says
    QCOMPARE(gallery().shownCards().size(), std::size_t(4));
    quiet::shoot(*window_, "start");
  }

  void cards_showTheCardOfTheFile() {
    const app::ScenarioInfo info =
        app::infoOfFile(QStringLiteral(SOURCE_DIR "/maps/planners/doorway_agents.yaml"));
    QCOMPARE(info.title, QStringLiteral("Doorway"));
    QCOMPARE(info.family, QStringLiteral("Planner comparison"));
    QCOMPARE(info.difficulty, QStringLiteral("hard"));
    QVERIFY(info.contains(QStringLiteral("turns door")));  // words of the purpose
  }

  void pictures_secondStart_areReadFromTheFolder() {
    waitForPictures();
    QCOMPARE(gallery().thumbnails().drawnCount(), 4);
    const QStringList before = shown();
    restart();
    waitForPictures();
    QCOMPARE(gallery().thumbnails().drawnCount(), 0);
    QCOMPARE(shown(), before);
    QCOMPARE(gallery().shownCards().front()->info().people, 8);
  }

  void search_typed_leavesWhatFits() {
    waitForPictures();
    QTest::keyClicks(&gallery().search(), QStringLiteral("door"));
    QCOMPARE(gallery().shownCards().size(), std::size_t(1));
    QVERIFY(gallery().shownCards().front()->path().endsWith(QStringLiteral("doorway_agents.yaml")));
    QTest::keyClicks(&gallery().search(), QStringLiteral("qq"));
    QVERIFY(gallery().shownCards().empty());
    auto* all = widgets::withText<QToolButton>(gallery(), QStringLiteral("Show all scenarios"));
    QVERIFY(all != nullptr && all->isVisible());
    QTest::mouseClick(all, Qt::LeftButton);
    QCOMPARE(gallery().shownCards().size(), std::size_t(4));
  }

  /// Enter opens the first scenario found, Down leads to it, and Ctrl+F back.
  void search_byKeys_leadsToAScenario() {
    waitForPictures();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_->windowHandle(), Qt::Key_F, Qt::ControlModifier);
    QVERIFY(gallery().search().hasFocus());
    QTest::keyClicks(&gallery().search(), QStringLiteral("cross"));
    QTest::keyClick(&gallery().search(), Qt::Key_Down);
    QVERIFY(gallery().shownCards().front()->hasFocus());
    QTest::keyClick(window_->windowHandle(), Qt::Key_F, Qt::ControlModifier);
    QVERIFY(gallery().search().hasFocus());
    QTest::keyClick(&gallery().search(), Qt::Key_Return);
    QVERIFY(document().path().endsWith(QStringLiteral("crossing_agents.yaml")));
  }

  /// Letters that are commands elsewhere would change what is not shown.
  void typing_anywhere_isSearchedForAndChangesNothing() {
    waitForPictures();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    const editor::Tool* tool = window_->workspace().tools().current();
    std::vector<bool> before;
    for (const QAction* layer : window_->actions().layers) {
      before.push_back(layer->isChecked());
    }
    gallery().shownCards().front()->setFocus();
    for (const char key : QByteArray("noxw")) {
      QTest::keyClick(window_->windowHandle(), key);
    }
    QCOMPARE(gallery().search().text(), QStringLiteral("noxw"));
    QVERIFY(window_->workspace().tools().current() == tool);
    std::vector<bool> after;
    for (const QAction* layer : window_->actions().layers) {
      after.push_back(layer->isChecked());
    }
    QVERIFY(before == after);
    QVERIFY(window_->isOnStartPage());
  }

  /// A scenario with the word in its title comes before those that only mention it.
  void search_word_titlesComeFirst() {
    waitForPictures();
    QTest::keyClicks(&gallery().search(), QStringLiteral("cross"));
    QVERIFY(gallery().shownCards().size() > 1);  // the café mentions it and comes first otherwise
    QCOMPARE(shown().front(), QStringLiteral("Crossing"));
    gallery().search().clear();
    QCOMPARE(shown().front(), QStringLiteral("Corner café"));
  }

  /// Its width does not depend on how many scenarios are found.
  void search_nothingFound_movesNothing() {
    waitForPictures();
    const auto place = [this] { return gallery().search().mapTo(window_.get(), QPoint(0, 0)).x(); };
    const int before = place();
    gallery().search().setText(QStringLiteral("no such scenario"));
    QTest::qWait(50);
    QCOMPARE(place(), before);
    gallery().search().clear();
    QTest::qWait(50);
    QCOMPARE(place(), before);
  }

  void order_ofAll_beginsWithTheCafe() {
    const auto all = app::galleryScenarios(
        {{"airport_agents", "m/library/airport_agents.yaml"},
         {"corner_cafe_agents", "m/corner_cafe/corner_cafe_agents.yaml"},
         {"crowd_agents", "m/planners/crowd_agents.yaml"},
         {"reaction_regular_agents", "m/reactions/reaction_regular_agents.yaml"},
         {"realism_door_agents", "m/realism/realism_door_agents.yaml"},
         {"zoo_agents", "m/library/zoo_agents.yaml"}});
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const app::ShippedScenario& each : all) {
      names.push_back(each.name);
    }
    QVERIFY(
        (names == std::vector<std::string>{"corner_cafe_agents", "crowd_agents", "airport_agents",
                                           "zoo_agents", "reaction_regular_agents"}));
  }

  void family_chosen_leavesItsScenarios() {
    waitForPictures();
    QComboBox& family = gallery().family();
    QVERIFY(family.isVisible() && family.count() >= 3);
    const QString wanted = gallery().shownCards()[1]->info().family;
    family.setCurrentText(wanted);
    QVERIFY(gallery().shownCards().size() < 4);
    for (const app::ScenarioCard* card : gallery().shownCards()) {
      QCOMPARE(card->info().family, wanted);
    }
  }

  void card_enter_opensTheScenario() {
    waitForPictures();
    app::ScenarioCard* card = gallery().shownCards()[1];
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    card->setFocus();
    QTest::keyClick(window_->windowHandle(), Qt::Key_Return);
    QVERIFY(!window_->isOnStartPage());
    QCOMPARE(document().path(), QFileInfo(card->path()).absoluteFilePath());
  }

  void pictures_whileTheyAreDrawn_thePageIsUsable() {
    QTest::keyClicks(&gallery().search(), QStringLiteral("caf"));  // before the first picture
    QCOMPARE(gallery().shownCards().size(), std::size_t(1));
    QTest::mouseClick(gallery().shownCards().front(), Qt::LeftButton);
    QVERIFY(!window_->isOnStartPage());
  }

  void actions_allSix_beginSomething() {
    QStringList titles;
    for (const app::ActionCard* card : window_->findChildren<app::ActionCard*>()) {
      titles << card->accessibleName();
    }
    QCOMPARE(titles.join(QLatin1Char('|')),
             QStringLiteral("New from a map|New empty room|Open…|Guided tour|Watch a recording…|"
                            "Import trajectories…"));
    auto* tour = widgets::named<app::ActionCard>(*window_, QStringLiteral("Guided tour"));
    QTest::mouseClick(tour, Qt::LeftButton);
    QVERIFY(window_->tour().isActive());
  }

  void import_csv_isShownAsARecordedRun() {
    QFile file(at("people.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time,id,x,y\n");
    for (int k = 0; k < 20; ++k) {
      file.write(QStringLiteral("%1,1,%2,0\n%1,2,%2,2\n").arg(0.1 * k).arg(0.12 * k).toUtf8());
    }
    file.close();
    QVERIFY(window_->open(at("people.csv")));
    QVERIFY(window_->workspace().isRecordedRun());
    QCOMPARE(window_->workspace().recordedName(), QStringLiteral("people.csv"));
    QCOMPARE(document().scenario().humans.size(), std::size_t(2));
    QCOMPARE(window_->workspace().runner().recording()->timeOf(19), 1.9);
  }

  /// People who come later and far from the origin are in view from the start, without a list of
  /// what a scenario of them would lack.
  void import_peopleFarAway_areInView() {
    QFile file(at("far.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time,id,x,y\n");
    for (int k = 0; k < 100; ++k) {
      const double time = 0.1 * k;
      file.write(QStringLiteral("%1,1,%2,40\n").arg(time).arg(90.0 + 0.1 * k).toUtf8());
      if (k > 50) {
        file.write(QStringLiteral("%1,2,95,%2\n").arg(time).arg(30.0 + 0.1 * k).toUtf8());
      }
    }
    file.close();
    QVERIFY(window_->open(at("far.csv")));
    QTest::qWait(100);
    const editor::MapView& view = window_->workspace().view();
    const QRectF seen = view.mapToScene(view.viewport()->rect()).boundingRect();
    for (const base::Vec2& place : {base::Vec2(90.0, 40.0), base::Vec2(99.9, 40.0),
                                    base::Vec2(95.0, 35.1), base::Vec2(95.0, 39.9)}) {
      QVERIFY(seen.contains(editor::toScene(place)));
    }
    QVERIFY2(seen.width() < 40.0, qPrintable(QString::number(seen.width())));
    QCOMPARE(window_->docks().panel<editor::IssuesPanel>().count(), 0);
    quiet::shoot(*window_, "imported");
    window_->actions().close->trigger();
    QVERIFY(window_->open(quiet::demoPath()));  // whose view is that of its map
    QTest::qWait(100);
    QVERIFY(!view.mapToScene(view.viewport()->rect())
                 .boundingRect()
                 .contains(editor::toScene(base::Vec2(90.0, 40.0))));
  }

  void import_brokenCsv_saysWhy() {
    QFile file(at("people.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("a,b\n1,2\n");
    file.close();
    QVERIFY(!window_->open(at("people.csv")));
    QVERIFY(window_->isOnStartPage());
    QVERIFY(window_->notices().has(QStringLiteral("unread")));
  }
};

QTEST_MAIN(WindowStartTest)
#include "tst_WindowStart.moc"
