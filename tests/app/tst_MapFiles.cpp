#include <QtTest>

#include "app/window/StartPage.h"
#include "app/window/files/FileDialogs.h"
#include "app/window/files/MapFiles.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/RunFiles.h"

using outside::text;

/// Maps by their images: a YAML file beside an image gives resolution and origin, however the image
/// is opened; without one the scale is asked for.
class MapFilesTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  /// A map with a resolution and an origin of its own, in a YAML file of this name.
  void writeMap(const char* image, const char* yaml) {
    QImage picture(60, 40, QImage::Format_Grayscale8);
    picture.fill(254);
    QVERIFY(picture.save(at(image)));
    const QByteArray values =
        "\nresolution: 0.2\norigin: [-3.0, 1.5, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.196\n";
    outside::writeText(at(yaml), QByteArray("image: ") + image + values);
  }
  void checkMap(const char* yaml) {
    QTRY_VERIFY(!window_->isOnStartPage());
    QTRY_COMPARE(document().mapPath(), at(yaml));
    QCOMPARE(document().map()->resolution(), 0.2);
    QVERIFY(document().map()->origin().position == base::Vec2(-3.0, 1.5));
  }
  /// The next file dialog gets this name.
  void answerFile(const QString& path) {
    quiet::answerDialog<QFileDialog>([path](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(text("fileNameEdit"));
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
  }
  void drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QDropEvent event(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
  }

 private Q_SLOTS:
  void init() {
    begin();
    writeMap("hall.png", "hall.yaml");
  }
  void cleanup() { end(); }

  void image_withYaml_newFromMap_asksNothing() {
    answerFile(at("hall.png"));
    window_->actions().newFromMap->trigger();
    checkMap("hall.yaml");
  }

  void image_withYaml_open_asksNothing() {
    answerFile(at("hall.png"));
    window_->actions().open->trigger();
    checkMap("hall.yaml");
  }

  void image_withYaml_startPage_asksNothing() {
    QVERIFY(window_->isOnStartPage());
    answerFile(at("hall.png"));
    auto* button = widgets::findIf<QAbstractButton>(*window_, [](const QAbstractButton* each) {
      return each->isVisible() && (each->text() == text("New from a map") ||
                                   each->accessibleName().startsWith(text("New from a map")));
    });
    QVERIFY(button != nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    checkMap("hall.yaml");
  }

  void image_withYaml_dropped_asksNothing() {
    drop(at("hall.png"));
    checkMap("hall.yaml");
    document().undoStack().setClean();
    document().clear();
    drop(at("hall.png"));  // also on an open document
    checkMap("hall.yaml");
  }

  void image_withYaml_opened_asksNothing() {  // as from the command line
    QVERIFY(window_->open(at("hall.png")));
    checkMap("hall.yaml");
  }

  void image_withYaml_changeMap_keepsTheScenario() {
    QVERIFY(window_->open(copyOfDemo()));
    const std::size_t people = document().scenario().humans.size();
    answerFile(at("hall.png"));
    window_->actions().openMap->trigger();
    checkMap("hall.yaml");
    QCOMPARE(document().scenario().humans.size(), people);
    document().undoStack().undo();
    QVERIFY(document().mapPath() != at("hall.yaml"));
  }

  void image_withYamlOfAnotherName_isFound() {
    writeMap("scan7.png", "warehouse.yaml");
    QCOMPARE(app::mapYamlOf(at("scan7.png")), at("warehouse.yaml"));
    QVERIFY(window_->open(at("scan7.png")));
    checkMap("warehouse.yaml");
  }

  void image_alone_changeMap_asksForTheScale() {
    QVERIFY(window_->open(copyOfDemo()));
    const std::size_t people = document().scenario().humans.size();
    QVERIFY(QFile::copy(at("hall.png"), at("plan.png")));
    QVERIFY(app::mapYamlOf(at("plan.png")).isEmpty());
    int asked = 0;
    const auto answerScale = [&asked] {
      quiet::answerDialog<app::ImageMapDialog>([&asked](app::ImageMapDialog& dialog) {
        ++asked;
        quiet::setResolution(dialog, 0.03);
        dialog.accept();
      });
    };
    quiet::answerDialog<QFileDialog>([&](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(text("fileNameEdit"));
      name->setText(at("plan.png"));
      answerScale();
      QTest::keyClick(name, Qt::Key_Return);
    });
    window_->actions().openMap->trigger();
    QCOMPARE(asked, 1);
    QCOMPARE(document().map()->resolution(), 0.03);
    QVERIFY(document().mapPath().isEmpty());
    QCOMPARE(document().scenario().humans.size(), people);
    document().undoStack().undo();
    QVERIFY(document().map()->resolution() != 0.03);
  }

  void dialog_ofMaps_listsNoScenarios() {
    QVERIFY(!copyOfDemo().isEmpty());  // demo.yaml, a scenario
    QVERIFY(window_->open(at("demo.yaml")));
    for (QAction* action : {window_->actions().newFromMap, window_->actions().openMap}) {
      QStringList names;
      quiet::answerDialog<QFileDialog>([&names](QFileDialog& dialog) {
        const auto leave = qScopeGuard([&dialog] { dialog.reject(); });
        const auto& files = *dialog.findChild<QTreeView*>(text("treeView"));
        const auto list = [&] {
          names.clear();
          for (int row = 0; row < files.model()->rowCount(files.rootIndex()); ++row) {
            names << files.model()->index(row, 0, files.rootIndex()).data().toString();
          }
          return names;
        };
        QTRY_VERIFY(list().contains(text("hall.yaml")));
        QTest::qWait(100);
        list();
      });
      action->trigger();
      QVERIFY2(names.contains(text("hall.png")), qPrintable(names.join(QLatin1Char(' '))));
      QVERIFY2(!names.contains(text("demo.yaml")), qPrintable(names.join(QLatin1Char(' '))));
    }
  }
};

QTEST_MAIN(MapFilesTest)
#include "tst_MapFiles.moc"
