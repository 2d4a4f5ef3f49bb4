#include <QDir>
#include <QPixmapCache>
#include <QSpinBox>
#include <QTabBar>
#include <QtTest>

#include "editor/look/AppStyle.h"
#include "editor/look/Icons.h"

using editor::Theme;

namespace {

/// Pixels that are at all there, and their mean lightness.
struct Ink {
  int pixels = 0;
  double lightness = 0.0;
};
Ink inkOf(const QImage& image) {
  Ink ink;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      if (color.alphaF() > 0.5) {
        ++ink.pixels;
        ink.lightness += color.lightnessF();
      }
    }
  }
  ink.lightness /= std::max(1, ink.pixels);
  return ink;
}

/// Of all icons of the program; the first one asked for brings them along.
QStringList iconNames() {
  editor::tintedIcon(QStringLiteral("add"), Qt::black);
  QStringList names;
  for (const QString& file : QDir(QStringLiteral(":/icons")).entryList()) {
    names.push_back(file.chopped(4));
  }
  return names;
}

}  // namespace

class IconsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void names_areMany() { QVERIFY(iconNames().size() > 40); }

  void icon_ofEachName_isDrawnInBothThemes_data() {
    QTest::addColumn<QString>("name");
    for (const QString& name : iconNames()) {
      QTest::newRow(qPrintable(name)) << name;
    }
  }
  void icon_ofEachName_isDrawnInBothThemes() {
    QFETCH(QString, name);
    const QImage light = editor::themedIcon(name, Theme::light()).pixmap(24, 24).toImage();
    const QImage dark = editor::themedIcon(name, Theme::dark()).pixmap(24, 24).toImage();
    QVERIFY(inkOf(light).pixels > 12);
    QVERIFY(inkOf(dark).lightness > inkOf(light).lightness);
    // nothing is cut off at the edge
    for (int i = 0; i < 24; ++i) {
      QVERIFY(qAlpha(light.pixel(i, 0)) < 64 && qAlpha(light.pixel(i, 23)) < 64);
      QVERIFY(qAlpha(light.pixel(0, i)) < 64 && qAlpha(light.pixel(23, i)) < 64);
    }
  }

  void icon_disabled_isPaler() {
    const QIcon icon = editor::themedIcon(QStringLiteral("run-play"), Theme::light());
    const Ink normal = inkOf(icon.pixmap(24, 24, QIcon::Normal).toImage());
    const Ink disabled = inkOf(icon.pixmap(24, 24, QIcon::Disabled).toImage());
    QVERIFY(disabled.lightness > normal.lightness + 0.2);
  }

  void icon_large_isSharp() {
    const QIcon icon = editor::themedIcon(QStringLiteral("view-grid"), Theme::light());
    QCOMPARE(icon.pixmap(72, 72).size(), QSize(72, 72));
  }

  void icon_unknown_isNull() {
    QVERIFY(editor::themedIcon(QStringLiteral("nothing"), Theme::light()).isNull());
  }

  void style_fields_haveTheHeightOfTheHouse() {
    editor::AppStyle style(Theme::light());
    QDoubleSpinBox box;
    box.setStyle(&style);
    QCOMPARE(box.sizeHint().height(), 24);
    box.resize(88, 24);
    QVERIFY(!box.grab().isNull());
    QTabBar tabs;
    tabs.setStyle(&style);
    tabs.addTab(QStringLiteral("Issues"));
    QCOMPARE(tabs.sizeHint().height(), 32);
  }
};

QTEST_MAIN(IconsTest)
#include "tst_Icons.moc"
