#include <cmath>

#include <QImage>
#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/LegendStrip.h"
#include "editor/canvas/RunOverlays.h"

using editor::CanvasOptions;
using editor::Theme;
using editor::Vec2;

namespace {

/// Luminance of a colour over a ground, 0 … 1 (Rec. 709 without gamma: an order is asked for).
double luminance(const QColor& color, const QColor& ground) {
  const double a = color.alphaF();
  const auto over = [a](double top, double below) { return a * top + (1.0 - a) * below; };
  return 0.2126 * over(color.redF(), ground.redF()) +
         0.7152 * over(color.greenF(), ground.greenF()) +
         0.0722 * over(color.blueF(), ground.blueF());
}

/// Ana (1) at (3, 4.5) looks and walks to the right; Ben (2) stands at (9, 2).
std::shared_ptr<sim2d::Frame> frameOfTwo() {
  auto frame = std::make_shared<sim2d::Frame>();
  frame->step = 20;
  frame->time = 1.0;
  frame->humans.add(1, {{3.0, 4.5}, 0.0}, {1.0, 0.0}, 0.0, sim2d::kNoGoal);
  frame->humans.add(2, {{9.0, 2.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
  frame->humans.group.assign(2, -1);
  frame->humans.state.assign(2, 0);
  frame->doorOpen = {1};
  return frame;
}

/// With a wall at x = 5, from y = 4 to 5, that Ana looks at; she notices within 6 m.
sim2d::TraceHeader headerOfTwo() {
  sim2d::TraceHeader header;
  header.humans.resize(2);
  header.humans[0].id = 1;
  header.humans[1].id = 2;
  header.humans[0].parameters = {{"dist", 6.0}};
  header.obstacles.resize(1);
  header.obstacles[0].outlines = {sim2d::boxOutline({{5.0, 4.5}, 0.0}, 0.1, 1.0)};
  return header;
}

}  // namespace

class RunOverlaysTest : public QObject, private CanvasTester {
  Q_OBJECT

 private:
  void showTwo(const std::shared_ptr<sim2d::Frame>& frame = frameOfTwo()) {
    scene_.showFrame(nullptr);
    start(small::scenario());
    recording_ = std::make_unique<sim2d::Recording>();
    recording_->setHeader(headerOfTwo());
    recording_->append(*frame);
    scene_.showFrame(frame, recording_.get());
  }
  void turnOn(bool CanvasOptions::*option, bool on = true) {
    CanvasOptions options;
    options.grid = options.trails = options.names = options.routes = options.groups = false;
    options.goals = options.areas = options.obstacles = false;
    if (option != nullptr) {
      options.*option = on;
    }
    scene_.setOptions(options);
    QCoreApplication::processEvents();
  }
  QImage shot() { return view_.viewport()->grab().toImage(); }
  QColor at(const QImage& image, const Vec2& world) {
    return image.pixelColor(view_.viewportFrom(world) * int(image.devicePixelRatio()));
  }
  /// How far the colour at a place is from that of the ground beside everything.
  int markedAt(const QImage& image, const Vec2& world) {
    const QColor a = at(image, world);
    const QColor b = Theme::light().color(editor::Role::MapFree);
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
  }
  std::vector<QString> titles() {
    std::vector<QString> all;
    for (const editor::LegendPart& part : editor::legendOf(scene_, view_.pixelsPerMetre())) {
      all.push_back(part.title);
    }
    return all;
  }
  editor::LegendStrip& strip() { return *view_.findChild<editor::LegendStrip*>(); }

  std::unique_ptr<sim2d::Recording> recording_;

 private Q_SLOTS:
  void cleanup() { scene_.showFrame(nullptr); }

  void options_atFirst_areOff() {
    const CanvasOptions first;
    for (const bool on : {first.velocities, first.gaussian, first.sight, first.density, first.plans,
                          first.contacts, first.thoughts, first.proxemics, first.forces}) {
      QVERIFY(!on);
    }
  }

  void densityColor_denser_isFartherFromTheGround_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }
  void densityColor_denser_isFartherFromTheGround() {
    QFETCH(bool, dark);
    const Theme theme(dark);
    const QColor ground = theme.color(editor::Role::MapFree);
    double before = luminance(editor::densityColor(theme, 0.0), ground);
    QVERIFY(std::abs(before - luminance(ground, ground)) < 1e-6);
    for (int k = 1; k <= 20; ++k) {
      const double now = luminance(editor::densityColor(theme, k / 20.0), ground);
      QVERIFY2(dark ? now > before : now < before, qPrintable(QString::number(k)));
      before = now;
    }
  }

  void densityScale_isAPowerOfTwoThatHolds() {
    QCOMPARE(editor::densityScale(0.0), 0.5);
    QCOMPARE(editor::densityScale(0.5), 0.5);
    QCOMPARE(editor::densityScale(0.51), 1.0);
    QCOMPARE(editor::densityScale(3.1), 4.0);
    QCOMPARE(editor::densityScale(0.2, 2.0), 2.0);  // it does not fall within a run
  }

  void densityImage_hasTheHighestRowFirst() {
    metrics::DensityField field;
    field.columns = 2;
    field.rows = 2;
    field.values = {0.0F, 0.0F, 1.0F, 0.0F};  // the upper left one
    const QImage image = editor::densityImage(field, Theme::light(), 1.0);
    QVERIFY(qAlpha(image.pixel(0, 0)) > 150);
    QCOMPARE(qAlpha(image.pixel(0, 1)), 0);
    QCOMPARE(qAlpha(image.pixel(1, 0)), 0);
  }

  void density_onTheMap_isAroundPeople() {
    showTwo();
    turnOn(&CanvasOptions::density);
    const QImage image = shot();
    QVERIFY(markedAt(image, {3.0, 5.3}) > 60);
    QVERIFY(markedAt(image, {3.0, 5.3}) > markedAt(image, {3.0, 5.9}) + 20);
    QCOMPARE(markedAt(image, {6.8, 7.5}), 0);
    QCOMPARE(scene_.overlays().densityScaleMax(), 0.5);
  }

  /// From (3, 4.5) the wall at x = 5 hides a trapezoid of half height 0.25 (x - 3) behind it.
  void sight_ofWhoIsSelected_endsAtWalls() {
    showTwo();
    turnOn(&CanvasOptions::sight);
    QCOMPARE(markedAt(shot(), {4.0, 5.0}), 0);  // nobody is selected
    document_.setSelection({person(1)});
    QCoreApplication::processEvents();
    const QImage image = shot();
    QVERIFY(markedAt(image, {4.0, 5.0}) > 20);
    QVERIFY(markedAt(image, {6.7, 6.0}) > 20);
    QCOMPARE(markedAt(image, {6.7, 4.6}), 0);   // hidden
    QCOMPARE(markedAt(image, {10.0, 6.5}), 0);  // too far
    QCOMPARE(markedAt(image, {1.6, 4.5}), 0);   // behind the back
  }

  void spaces_nobodySelected_areOfAll() {
    showTwo();
    turnOn(&CanvasOptions::gaussian);
    QImage image = shot();
    QVERIFY(markedAt(image, {3.8, 4.5}) > 10 && markedAt(image, {9.3, 2.5}) > 10);
    document_.setSelection({person(1)});
    QCoreApplication::processEvents();
    image = shot();
    QVERIFY(markedAt(image, {3.8, 4.5}) > 10);
    QCOMPARE(markedAt(image, {9.3, 2.5}), 0);
  }

  /// 1 m/s is 0.8 m beyond the body.
  void velocities_areArrowsAhead() {
    showTwo();
    turnOn(nullptr);
    const QImage without = shot();
    turnOn(&CanvasOptions::velocities);
    const QImage with = shot();
    const Vec2 onArrow(3.0 + 0.75, 4.5);
    QVERIFY(markedAt(with, onArrow) > markedAt(without, onArrow) + 60);
    QCOMPARE(markedAt(with, {2.2, 4.5}), 0);
    QCOMPARE(at(with, {9.6, 2.0}), at(without, {9.6, 2.0}));  // Ben stands
  }

  void plans_ofTheNewestMoment_areDrawn() {
    const auto frame = frameOfTwo();
    frame->humanPaths = std::make_shared<const std::vector<std::vector<Vec2>>>(
        std::vector<std::vector<Vec2>>{{{3.0, 7.5}, {6.5, 7.5}}, {}});
    showTwo(frame);
    turnOn(&CanvasOptions::plans);
    const QImage image = shot();
    int marked = 0;
    for (int k = 0; k < 60; ++k) {  // dashes
      marked += markedAt(image, {3.5 + 0.05 * k, 7.5}) > 30 ? 1 : 0;
    }
    QVERIFY(marked > 20 && marked < 58);
    showTwo();  // a state of the past, or a recorded one
    turnOn(&CanvasOptions::plans);
    const auto parts = editor::legendOf(scene_, 50.0);
    QVERIFY(parts.front().rows.front().isNote);
  }

  void contacts_untilNow_areMarked() {
    showTwo();
    sim2d::ContactMark now;
    now.time = 0.9;
    now.position = {4.0, 8.0};
    now.cause = editor::ContactCause::Robot;
    sim2d::ContactMark later = now;
    later.time = 1.5;
    later.position = {8.0, 4.0};
    scene_.overlays().setContacts({now, later});
    turnOn(&CanvasOptions::contacts);
    const QImage image = shot();
    const double aside = 3.6 / view_.pixelsPerMetre();  // Beside the white centre of the sign.
    QVERIFY(markedAt(image, {4.0 + aside, 8.0}) > 100);
    QCOMPARE(markedAt(image, {8.0 + aside, 4.0}), 0);
    QCOMPARE(scene_.overlays().contactsSoFar(editor::ContactCause::Robot), std::size_t{1});
    QCOMPARE(scene_.overlays().contactsSoFar(editor::ContactCause::Person), std::size_t{0});
  }

  void thoughts_areBelowNames() {
    showTwo();
    scene_.overlays().setThoughts({{1, QStringLiteral("walks to the goal")}});
    turnOn(nullptr);
    CanvasOptions options = scene_.options();
    options.names = true;
    scene_.setOptions(options);
    const auto detailOf = [this](const char* name) {
      for (const editor::Label& label : scene_.frameLayer().labels()) {
        if (label.text == QString::fromLatin1(name)) {
          return label.detail;
        }
      }
      return QStringLiteral("nobody");
    };
    QVERIFY(detailOf("Ana").isEmpty());
    options.thoughts = true;
    scene_.setOptions(options);
    QCOMPARE(detailOf("Ana"), QStringLiteral("walks to the goal"));
    QVERIFY(detailOf("Ben").isEmpty());
    const editor::Label one{QStringLiteral("Ana"), {}, {}};
    editor::Label two = one;
    two.detail = QStringLiteral("walks to the goal");
    const QSizeF small = editor::labelSize(Theme::light(), one);
    const QSizeF large = editor::labelSize(Theme::light(), two);
    QCOMPARE(large.height(), 2.0 * small.height());
    QVERIFY(large.width() > small.width());
  }

  void speech_heard_isALineThatFades() {
    showTwo();
    turnOn(nullptr);
    sim2d::Event heard;
    heard.kind = sim2d::EventKind::Heard;
    heard.id = 2;
    heard.other = 1;
    heard.hasOther = true;
    const auto dots = [this] {
      const QImage image = shot();
      int count = 0;
      for (int k = 20; k < 80; ++k) {
        count += markedAt(image, Vec2(3.0, 4.5) + 0.01 * k * Vec2(6.0, -2.5)) > 30 ? 1 : 0;
      }
      return count;
    };
    const int before = dots();
    scene_.frameLayer().addSpeech({heard}, 0.8);
    scene_.update();
    const int now = dots();
    QVERIFY2(now > before + 5, qPrintable(QStringLiteral("%1 %2").arg(before).arg(now)));
    auto later = frameOfTwo();
    later->time = 6.0;
    scene_.showFrame(later, recording_.get());
    QCOMPARE(dots(), before);
  }

  /// The map keeps its size and zoom, and receives the mouse below the legend.
  void legend_isOverTheMap() {
    showTwo();
    turnOn(nullptr);
    QVERIFY(!strip().isVisible());
    const QSize size = view_.viewport()->size();
    const QTransform place = view_.viewportTransform();
    turnOn(&CanvasOptions::density);
    QVERIFY(strip().isVisible());
    QVERIFY(view_.viewport()->geometry().contains(strip().geometry()));
    QVERIFY(view_.childAt(strip().geometry().center()) == view_.viewport());
    const QRect box = strip().geometry();
    for (const editor::ShownBody& body : scene_.frameLayer().shownBodies()) {
      QVERIFY(!box.contains(view_.viewportFrom(body.pose.position)));
    }
    document_.setSelection({person(1)});  // Nothing moves.
    QCoreApplication::processEvents();
    QCOMPARE(strip().geometry(), box);
    QCOMPARE(view_.viewport()->size(), size);
    QCOMPARE(view_.viewportTransform(), place);
    scene_.showFrame(nullptr);
    QCoreApplication::processEvents();
    QVERIFY(!strip().isVisible());
    QCOMPARE(view_.viewport()->size(), size);
    QCOMPARE(view_.viewportTransform(), place);
  }

  /// Only signs with their values: as wide as they need.
  void legend_brief_hasNoNames() {
    showTwo();
    turnOn(&CanvasOptions::contacts);
    const QSize whole = strip().size();
    turnOn(nullptr);
    view_.setLegendBrief(true);
    turnOn(&CanvasOptions::contacts);
    QVERIFY(strip().isVisible());
    QVERIFY2(strip().width() <= whole.width() / 2, qPrintable(QString::number(strip().width())));
    QVERIFY(strip().height() < whole.height());
    turnOn(&CanvasOptions::density);  // A colour bar has its scale in the other view.
    QVERIFY(!strip().isVisible());
    view_.setLegendBrief(false);
  }

  /// A partial repaint leaves no line at its edge.
  void ground_repaintedInPart_isTheSame() {
    showTwo();
    turnOn(nullptr);
    view_.zoomBy(1.037);  // Pixel edges are at odd places of the scene.
    QImage image(view_.viewport()->size(), QImage::Format_RGB32);
    image.fill(Qt::red);
    for (const int top : {0, 41, 64}) {
      const QRect part(0, top, image.width(),
                       (top == 0    ? 41
                        : top == 41 ? 64
                                    : image.height()) -
                           top);
      view_.viewport()->render(&image, part.topLeft(), part, QWidget::RenderFlags());
    }
    const QColor ground = scene_.groundColor();
    for (int y = 0; y < 100; ++y) {
      QCOMPARE(image.pixelColor(1, y), ground);
    }
    view_.fitAll(false);
  }

  void legend_ofEachOverlay_isThere() {
    showTwo();
    const std::vector<std::pair<bool CanvasOptions::*, QString>> overlays = {
        {&CanvasOptions::forces, QStringLiteral("Forces on people")},
        {&CanvasOptions::velocities, QStringLiteral("Velocities")},
        {&CanvasOptions::proxemics, QStringLiteral("Spaces")},
        {&CanvasOptions::gaussian, QStringLiteral("Spaces")},
        {&CanvasOptions::sight, QStringLiteral("Field of view")},
        {&CanvasOptions::density, QStringLiteral("People per m²")},
        {&CanvasOptions::plans, QStringLiteral("People's paths")},
        {&CanvasOptions::contacts, QStringLiteral("Contacts so far")},
        {&CanvasOptions::thoughts, QStringLiteral("Below names")}};
    for (const auto& [option, title] : overlays) {
      turnOn(option);
      QCOMPARE(titles(), std::vector<QString>{title});
    }
    turnOn(&CanvasOptions::sight);
    document_.setSelection({person(1)});
    QCOMPARE(titles(), std::vector<QString>{QStringLiteral("Seen by Ana")});
    QCOMPARE(editor::legendOf(scene_, 50.0).front().rows.front().value, QStringLiteral("6 m"));
  }

  /// Values of the terms, as hand calculation has them: |(3, 4)| = 5.
  void forces_ofWhoIsSelected_haveValues() {
    const auto frame = frameOfTwo();
    frame->forces.goal = {{3.0, 4.0}, {0.0, 0.0}};
    frame->forces.social = frame->forces.obstacle = frame->forces.group = {{0.0, 0.0}, {0.0, 0.0}};
    showTwo(frame);
    turnOn(&CanvasOptions::forces);
    document_.setSelection({person(1)});
    const editor::LegendPart part = editor::legendOf(scene_, 50.0).front();
    QCOMPARE(part.title, QStringLiteral("Forces on Ana"));
    QCOMPARE(part.rows.front().value, QStringLiteral("5.00"));
    QCOMPARE(part.rows[4].value, QStringLiteral("5.00"));  // total
    QVERIFY(part.rows.back().value.endsWith(QStringLiteral("m/s²")));
    showTwo();  // without forces
    turnOn(&CanvasOptions::forces);
    QCOMPARE(editor::legendOf(scene_, 50.0).front().rows.front().label,
             QStringLiteral("not recorded"));
  }
};

QTEST_MAIN(RunOverlaysTest)
#include "tst_RunOverlays.moc"
