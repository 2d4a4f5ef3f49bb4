#include <QDir>
#include <QHelpEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmapCache>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <QToolTip>
#include <QTreeWidget>
#include <QtTest>

#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"

using namespace editor;

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
  tintedIcon(QStringLiteral("add"), Qt::black);
  QStringList names;
  for (const QString& file : QDir(QStringLiteral(":/icons")).entryList()) {
    names.push_back(file.chopped(4));
  }
  return names;
}

}  // namespace

class ThemeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void contrastRatio_blackOnWhite_is21() {
    QVERIFY(std::abs(contrastRatio(Qt::black, Qt::white) - 21.0) < 1e-6);
    QVERIFY(std::abs(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white) - 4.48) < 0.01);
  }

  void text_onEveryGround_isReadable_data() {
    QTest::addColumn<int>("text");
    QTest::addColumn<int>("ground");
    const Role texts[] = {Role::Text, Role::TextSecondary};
    const Role grounds[] = {Role::Window, Role::Panel, Role::Field, Role::RowSelected,
                            Role::RowHover};
    for (const Role text : texts) {
      for (const Role ground : grounds) {
        QTest::addRow("%d on %d", int(text), int(ground)) << int(text) << int(ground);
      }
    }
    for (const Role text : {Role::AccentText, Role::Ok, Role::Warning, Role::Error}) {
      QTest::addRow("%d on panel", int(text)) << int(text) << int(Role::Panel);
    }
  }
  void text_onEveryGround_isReadable() {
    QFETCH(int, text);
    QFETCH(int, ground);
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const double ratio = contrastRatio(theme.color(Role(text)), theme.color(Role(ground)));
      QVERIFY2(ratio >= 4.5, qPrintable(QString::number(ratio)));
    }
  }

  void linesAndOutlines_onTheMap_standOut() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const QColor map = theme.color(Role::MapFree);
      for (int i = 0; i < kLookCount; ++i) {
        QVERIFY(contrastRatio(theme.line(Look(i)), map) >= 3.0);
        QVERIFY(contrastRatio(theme.outline(Look(i)), map) >= 3.0);
        QVERIFY(contrastRatio(theme.outline(Look(i)), theme.fill(Look(i))) >= 1.5);
      }
      for (const Role role :
           {Role::Accent, Role::MapOccupied, Role::RobotBody, Role::RobotLine, Role::ForceGoal,
            Role::ForceSocial, Role::ForceObstacle, Role::ForceGroup, Role::ForceTotal,
            Role::WarningMark, Role::Error, Role::ObstacleEdge, Role::Lidar, Role::Guide}) {
        QVERIFY2(contrastRatio(theme.color(role), map) >= 3.0,
                 qPrintable(QString::number(int(role))));
      }
    }
  }

  void looks_haveDistinctMarks() {
    QSet<int> marks;
    for (int i = 0; i < kLookCount; ++i) {
      marks.insert(int(markOf(Look(i))));
    }
    QCOMPARE(marks.size(), kLookCount);
  }

  void fromSystem_darkPalette_isDark() {
    QVERIFY(Theme::fromSystem(Theme::dark().palette()).isDark());
    QVERIFY(!Theme::fromSystem(Theme::light().palette()).isDark());
  }

  void names_areMany() { QVERIFY(iconNames().size() > 40); }

  void icon_ofEachName_isDrawnInBothThemes_data() {
    QTest::addColumn<QString>("name");
    for (const QString& name : iconNames()) {
      QTest::newRow(qPrintable(name)) << name;
    }
  }
  void icon_ofEachName_isDrawnInBothThemes() {
    QFETCH(QString, name);
    const QImage light = themedIcon(name, Theme::light()).pixmap(24, 24).toImage();
    const QImage dark = themedIcon(name, Theme::dark()).pixmap(24, 24).toImage();
    QVERIFY(inkOf(light).pixels > 12);
    QVERIFY(inkOf(dark).lightness > inkOf(light).lightness);
    // nothing is cut off at the edge
    for (int i = 0; i < 24; ++i) {
      QVERIFY(qAlpha(light.pixel(i, 0)) < 64 && qAlpha(light.pixel(i, 23)) < 64);
      QVERIFY(qAlpha(light.pixel(0, i)) < 64 && qAlpha(light.pixel(23, i)) < 64);
    }
  }

  void icon_disabled_isPaler() {
    const QIcon icon = themedIcon(QStringLiteral("run-play"), Theme::light());
    const Ink normal = inkOf(icon.pixmap(24, 24, QIcon::Normal).toImage());
    const Ink disabled = inkOf(icon.pixmap(24, 24, QIcon::Disabled).toImage());
    QVERIFY(disabled.lightness > normal.lightness + 0.2);
  }

  void icon_large_isSharp() {
    const QIcon icon = themedIcon(QStringLiteral("view-grid"), Theme::light());
    QCOMPARE(icon.pixmap(72, 72).size(), QSize(72, 72));
  }

  void icon_unknown_isNull() {
    QVERIFY(themedIcon(QStringLiteral("nothing"), Theme::light()).isNull());
  }

  /// Selected text in a field stands out from the field and can be read.
  void selectedText_inAField_isVisible() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const QPalette colors = theme.textPalette();
      const QColor& band = colors.color(QPalette::Highlight);
      QVERIFY(contrastRatio(colors.color(QPalette::HighlightedText), band) >= 4.5);
      QVERIFY(contrastRatio(band, colors.color(QPalette::Base)) >= 1.35);
      QCOMPARE(colors.color(QPalette::Text), theme.palette().color(QPalette::Text));
    }
    applyTheme(Theme::light());
    const QLineEdit field;
    field.ensurePolished();
    QCOMPARE(field.palette().color(QPalette::Highlight),
             Theme::light().textPalette().color(QPalette::Highlight));
  }

  /// Beside right-aligned numbers a text begins farther away; numbers and other texts stay.
  void columns_textBesideNumbers_hasAGap() {
    applyTheme(Theme::light());
    QTableWidget table(1, 3);
    for (int column = 0; column < 3; ++column) {
      table.setItem(0, column, new QTableWidgetItem(QStringLiteral("m")));
    }
    table.setColumnCount(4);  // the last column has an inset of its own
    table.item(0, 0)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const auto leftOf = [&table](int column) {
      QStyleOptionViewItem cell;
      cell.index = table.model()->index(0, column);
      cell.rect = QRect(0, 0, 100, 24);
      cell.features = QStyleOptionViewItem::HasDisplay;
      cell.displayAlignment = Qt::AlignLeft | Qt::AlignVCenter;
      cell.text = QStringLiteral("m");
      return table.style()->subElementRect(QStyle::SE_ItemViewItemText, &cell, &table).left();
    };
    QCOMPARE(leftOf(1) - leftOf(2), kColumnGap);
  }

  /// Numbers in the last column of a tree do not touch the edge or the scroll bar.
  void columns_lastNumbersOfATree_keepADistance() {
    applyTheme(Theme::light());
    QTreeWidget tree;
    tree.setColumnCount(3);
    new QTreeWidgetItem(&tree, {QStringLiteral("m"), QStringLiteral("1"), QStringLiteral("1")});
    const auto rightOf = [&tree](int column) {
      QStyleOptionViewItem cell;
      cell.index = tree.model()->index(0, column);
      cell.rect = QRect(0, 0, 100, 24);
      cell.features = QStyleOptionViewItem::HasDisplay;
      cell.displayAlignment = Qt::AlignRight | Qt::AlignVCenter;
      cell.text = QStringLiteral("1");
      return tree.style()->subElementRect(QStyle::SE_ItemViewItemText, &cell, &tree).right();
    };
    QCOMPARE(rightOf(1) - rightOf(2), kTableInset);
  }

  /// A tooltip of a widget and of a list row; a short one is left to Qt.
  void toolTip_long_isWrapped() {
    applyTheme(Theme::light());
    const QString words = QStringLiteral("Several words that explain a value. ");
    QListWidget list;
    list.resize(200, 100);
    list.addItem(QStringLiteral("row"));
    list.item(0)->setToolTip(words.repeated(8).trimmed());
    list.show();
    QVERIFY(QTest::qWaitForWindowExposed(&list));
    const auto hover = [](QWidget& widget, const QPoint& at) {
      QHelpEvent help(QEvent::ToolTip, at, widget.mapToGlobal(at));
      QApplication::sendEvent(&widget, &help);
      for (QWidget* each : QApplication::topLevelWidgets()) {
        if (each->inherits("QTipLabel") && each->isVisible()) {
          return each->width();
        }
      }
      return 0;
    };
    const int oneLine = list.fontMetrics().horizontalAdvance(words.repeated(8));
    const int wrapped = hover(*list.viewport(), list.visualItemRect(list.item(0)).center());
    QVERIFY2(wrapped > 100 && wrapped < oneLine / 2, qPrintable(QString::number(wrapped)));
    QVERIFY(QToolTip::text().contains(words.trimmed()));
    list.viewport()->setToolTip(QString());
    QPushButton button;
    button.setToolTip(words.repeated(8).trimmed());
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button));
    QToolTip::hideText();
    const int again = hover(button, button.rect().center());
    QVERIFY2(again > 100 && again < oneLine / 2, qPrintable(QString::number(again)));
    button.setToolTip(QStringLiteral("Short"));
    hover(button, button.rect().center());
    QCOMPARE(QToolTip::text(), QStringLiteral("Short"));
  }

  /// The filled part of a progress bar stands out from the rest of it in both themes.
  void style_progress_isVisible() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      AppStyle style(theme);
      QProgressBar bar;
      bar.setStyle(&style);
      bar.setTextVisible(false);
      bar.setRange(0, 100);
      bar.setValue(50);
      bar.resize(100, 8);
      const QImage picture = bar.grab().toImage();
      QCOMPARE(picture.pixelColor(25, 4), theme.color(Role::Accent));
      QCOMPARE(picture.pixelColor(75, 4), theme.color(Role::Line));
      QVERIFY(contrastRatio(picture.pixelColor(25, 4), picture.pixelColor(75, 4)) >= 3.0);
    }
  }

  /// A checked link is filled and framed; its text stays readable.
  void style_checkedLink_differsFromUncheckedInBothThemes() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      AppStyle style(theme);
      QWidget parent;
      QToolButton& link = *linkButton(QStringLiteral("Changed only"), QString(), &parent, [] {});
      link.setCheckable(true);
      link.setStyle(&style);
      link.resize(link.sizeHint());
      const QImage off = link.grab().toImage();
      link.setChecked(true);
      const QImage on = link.grab().toImage();
      QCOMPARE(on.pixelColor(3, on.height() / 2), theme.color(Role::RowSelected));
      QVERIFY(off.pixelColor(3, off.height() / 2) != theme.color(Role::RowSelected));
      QVERIFY(contrastRatio(theme.color(Role::Text), theme.color(Role::RowSelected)) >= 4.5);
    }
  }

  /// The button of a tool bar for the actions that do not fit is drawn in the colours of the theme.
  void style_extensionOfAToolBar_isVisibleInBothThemes() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      AppStyle style(theme);
      QToolButton button;
      button.setObjectName(QStringLiteral("qt_toolbar_ext_button"));
      button.setAutoRaise(true);
      button.setStyle(&style);
      button.setPalette(theme.palette());
      button.resize(16, 32);
      const QImage picture = button.grab().toImage();
      double best = 1.0;
      for (int x = 0; x < picture.width(); ++x) {
        best = std::max(best, contrastRatio(picture.pixelColor(x, 16), theme.color(Role::Window)));
      }
      QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
    }
  }

  void style_fields_haveTheHeightOfTheHouse() {
    AppStyle style(Theme::light());
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

QTEST_MAIN(ThemeTest)
#include "tst_Theme.moc"
