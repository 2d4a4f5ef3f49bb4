#include <QtTest>

#include "QuietWindow.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/LayersPanel.h"

using editor::CanvasOptions;

/// The panel with the layers of the map, by real mouse and key events.
class LayersPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  const CanvasOptions& options() const { return window_->workspace().scene().options(); }
  editor::LayersPanel& panel() { return window_->docks().panel<editor::LayersPanel>(); }
  QToolButton& eye(const char* tip) {
    auto* found = widgets::findIf<QToolButton>(panel(), [tip](const QToolButton* each) {
      return each->accessibleName() == QString::fromUtf8(tip);
    });
    [&] { QVERIFY2(found != nullptr, tip); }();
    return *found;
  }
  QSlider& slider(const char* layer) {
    return *widgets::named<QSlider>(panel(),
                                    QStringLiteral("Opacity of ") + QString::fromUtf8(layer));
  }
  void openPanel() {
    QVERIFY(!panel().isVisible());
    QToolButton* button = widgets::named<QToolButton>(*window_, QStringLiteral("Layers"));
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(panel().isVisible());
    QVERIFY(button->isChecked());
  }
  /// The part of the canvas around a position, without labels.
  QImage around(const base::Vec2& place) {
    const editor::MapView& view = window_->workspace().view();
    QRect part(0, 0, 24, 24);
    part.moveCenter(view.viewportFrom(place));
    return view.viewport()->grab(part).toImage();
  }
  base::Vec2 firstPerson() {
    return window_->workspace().document().scenario().humans.front().initPose.position;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
    openPanel();
  }
  void cleanup() { quiet::leave(window_); }

  void eye_clicked_hidesAndShows() {
    const QImage with = around(firstPerson());
    QTest::mouseClick(&eye("Hide People"), Qt::LeftButton);
    QVERIFY(!options().people);
    QVERIFY(around(firstPerson()) != with);
    QVERIFY(!slider("People").isEnabled());
    QTest::mouseClick(&eye("Show People"), Qt::LeftButton);
    QVERIFY(options().people);
    QCOMPARE(around(firstPerson()), with);
  }

  void eye_ofAGroup_hidesAllAndRestoresThoseThatWereOn() {
    QTest::mouseClick(&eye("Hide Routes"), Qt::LeftButton);
    QTest::mouseClick(&eye("Hide all of Scenario"), Qt::LeftButton);
    for (bool CanvasOptions::*option :
         {&CanvasOptions::people, &CanvasOptions::robots, &CanvasOptions::goals,
          &CanvasOptions::obstacles, &CanvasOptions::areas, &CanvasOptions::groups,
          &CanvasOptions::names, &CanvasOptions::routes}) {
      QVERIFY(!(options().*option));
    }
    QVERIFY(options().map && options().grid);  // of another group
    QTest::mouseClick(&eye("Show all of Scenario"), Qt::LeftButton);
    QVERIFY(options().people && options().names);
    QVERIFY(!options().routes);
  }

  void opacity_byKeys_fadesTheLayerOnly() {
    const auto darkest = [this] {
      const QImage picture = around(firstPerson());
      int least = 255;
      for (int x = 0; x < picture.width(); ++x) {
        for (int y = 0; y < picture.height(); ++y) {
          least = std::min(least, qGray(picture.pixel(x, y)));
        }
      }
      return least;
    };
    window_->actions().names->setChecked(false);
    const int full = darkest();
    slider("People").setFocus();
    for (int i = 0; i < 5; ++i) {
      QTest::keyClick(&slider("People"), Qt::Key_Left);
    }
    QCOMPARE(options().opacityOf(&CanvasOptions::people), 0.5);
    QCOMPARE(options().opacityOf(&CanvasOptions::robots), 1.0);
    QVERIFY(darkest() > full + 40);  // half of the way to the light ground
    for (int i = 0; i < 5; ++i) {
      QTest::keyClick(&slider("People"), Qt::Key_Right);
    }
    QCOMPARE(darkest(), full);
    QVERIFY(options().opacities.empty());
  }

  void opacity_ofEachLayer_isItsOwn() {
    for (QSlider* each : panel().findChildren<QSlider*>()) {
      const std::size_t before = options().opacities.size();
      const bool isOn = each->isEnabled();
      if (isOn) {
        each->setFocus();
        QTest::keyClick(each, Qt::Key_Home);
        QCOMPARE(options().opacities.size(), before + 1);
        QCOMPARE(options().opacities.back().second, 0.1);
      }
    }
    QVERIFY(options().opacities.size() >= 12);
  }

  void opacity_inARun_fadesPeople() {
    app::Workspace& workspace = window_->workspace();
    workspace.runner().stepOnce();
    QTRY_VERIFY_WITH_TIMEOUT(workspace.scene().isRunMode(), 60000);
    window_->actions().names->setChecked(false);
    const QImage full = around(firstPerson());
    slider("People").setFocus();
    QTest::keyClick(&slider("People"), Qt::Key_Home);
    QVERIFY(around(firstPerson()) != full);
    workspace.runner().reset();
  }

  void keys_andMenu_stillSwitch() {
    window_->workspace().view().setFocus();
    QTest::keyClick(window_->windowHandle(), Qt::Key_G, Qt::ShiftModifier);
    QVERIFY(!options().grid);
    QVERIFY(eye("Show Grid").isVisible());
    QMenu* view = nullptr;
    for (QAction* each : window_->menuBar()->actions()) {
      view = each->text() == QStringLiteral("&View") ? each->menu() : view;
    }
    int toggles = 0;
    for (QAction* each : view->actions()) {
      toggles += window_->actions().overlays.contains(each) ||
                         window_->actions().layers.contains(each) ||
                         window_->actions().runOverlays.contains(each)
                     ? 1
                     : 0;
    }
    QVERIFY2(toggles <= 5, QByteArray::number(toggles).constData());
    QCOMPARE(panel().findChildren<QSlider*>().size(), window_->actions().overlays.size() +
                                                          window_->actions().layers.size() +
                                                          window_->actions().runOverlays.size());
  }

  void pictures_bothThemes() {
    QTest::mouseClick(&eye("Hide Routes"), Qt::LeftButton);
    slider("Map").setValue(40);
    for (const bool isDark : {false, true}) {
      window_->setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
      quiet::shoot(*window_, isDark ? "layers-dark" : "layers-light");
    }
    window_->setTheme(editor::Theme::light());
  }
};

QTEST_MAIN(LayersPanelTest)
#include "tst_LayersPanel.moc"
