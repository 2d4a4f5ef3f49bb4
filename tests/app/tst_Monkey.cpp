#include <cstdio>
#include <grp.h>
#include <malloc.h>
#include <unistd.h>

#include <QAbstractItemModelTester>

#include "app/window/study/StudyPanel.h"
#include "editor/look/AppStyle.h"
#include "editor/look/DeferredActions.h"
#include "editor/panels/runs/FuturesPanel.h"
#include "sim2d/base/Rng.h"
#include "tests/app/MonkeyHands.h"
#include "tests/app/QuietWindow.h"

namespace {

QStringList* heard = nullptr;  // what the libraries complain of

void listen(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qPrintable(text));  // the program ends here
  }
  const bool isOfInterest = type == QtWarningMsg || type == QtCriticalMsg || type == QtFatalMsg;
  const bool isOfPlatform =
      QByteArray(context.category).startsWith("qt.qpa") ||
      text.contains(QLatin1String("XDG_RUNTIME_DIR")) ||
      text.startsWith(QLatin1String("This plugin does not support")) ||
      text.startsWith(QLatin1String("inotify_add_watch")) ||  // others' folders
      // Qt looks for what is pasted into the name field of a file dialog.
      text.endsWith(QLatin1String("(File name too long)"));
  if (heard != nullptr && isOfInterest && !isOfPlatform) {
    *heard << text;
  }
}

int numberIn(const char* variable, int otherwise) {
  bool isNumber = false;
  const int number = qEnvironmentVariableIntValue(variable, &isNumber);
  return isNumber ? number : otherwise;
}

/// Lists and trees under Qt's model tester, those of dialogs too once they are there. Not Qt's own
/// of file dialogs, and not QTreeModel, which gives the children of a row to each of its columns.
class Testers {
 public:
  void meetAll() {
    for (const QWidget* top : QApplication::topLevelWidgets()) {
      for (QAbstractItemModel* model : top->findChildren<QAbstractItemModel*>()) {
        if (!model->inherits("QTreeModel") && !isOfFileDialog(model) && !testers_[model]) {
          testers_[model] = new QAbstractItemModelTester(
              model, QAbstractItemModelTester::FailureReportingMode::Warning, owner(*model));
        }
      }
    }
  }
  std::size_t size() const { return testers_.size(); }
  void leave() {
    for (const auto& [model, tester] : testers_) {
      delete tester;
    }
    testers_.clear();
  }

 private:
  /// Of the tester: gone before a list that takes its own model with it.
  static QObject* owner(QAbstractItemModel& model) {
    auto* view = qobject_cast<QAbstractScrollArea*>(model.parent());
    return view != nullptr ? static_cast<QObject*>(view->viewport()) : &model;
  }
  static bool isOfFileDialog(const QObject* each) {
    while (each != nullptr && qobject_cast<const QFileDialog*>(each) == nullptr) {
      each = each->parent();
    }
    return each != nullptr;
  }

  std::map<QAbstractItemModel*, QPointer<QAbstractItemModelTester>> testers_;  // gone: theirs too
};

/// Random mouse, wheel and key events, in the window and in everything that it opens. Behind open
/// menus and dialogs runs begin and end, another person is selected, and the file changes on the
/// disk.
class Monkey {
 public:
  Monkey(app::MainWindow& window, MonkeyHands& hands, Testers& testers, int seed, int events)
      : window_(window),
        hands_(hands),
        testers_(testers),
        rng_(static_cast<std::uint64_t>(seed), 1),
        left_(events) {
    timer_.setInterval(numberIn("HUNAV_MONKEY_PAUSE", hands.canDrop() ? 4 : 0));  // [ms]
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { step(); });
  }

  void play() {
    timer_.start();
    loop_.exec();
    timer_.stop();
  }

 private:
  static constexpr int kBetweenLooks = 10;  // events

  int draw(int below) {
    const double share = rng_.uniform01(base::DrawPurpose::Test, draws_++);
    return std::min(static_cast<int>(share * below), below - 1);
  }

  void step() {
    if (left_-- <= 0) {
      leave();
      return;
    }
    if (!window_.isVisible()) {
      window_.show();  // it was closed: the program is started again
    }
    if (QApplication::activeWindow() == nullptr && topmost() == &window_) {
      window_.activateWindow();  // there is no window manager
    }
    if (left_ % kBetweenLooks == 0) {
      testers_.meetAll();
    }
    if (const int every = numberIn("HUNAV_MONKEY_MEMORY", 0); every > 0 && left_ % every == 0) {
      tellMemory();
    }
    // What opens a dialog does not come back before it is closed: later, so that the timer goes on.
    editor::later(timer_, [this, what = draw(11)] { act(what); });
  }

  void act(int what) {
    if (left_ < 0) {
      return;  // it is leaving: nobody would close what this opened
    }
    diary_.begin(left_);
    if (isDragging() && !hands_.canDrop() && what < 6) {
      drop();  // as long as something is dragged, no button of the mouse can be pressed
    } else if (what < 5) {
      click();
    } else if (what < 6) {
      drag();
    } else if (what < 7) {
      turnWheel();
    } else if (what < 10) {
      type();
    } else {
      changeBehind();
    }
  }

  /// For long plays: what is in use must not grow.
  void tellMemory() const {
    constexpr double kMega = 1e6;
    std::fprintf(stderr, "%d left: %.1f MB in use, %d widgets\n", left_,
                 static_cast<double>(::mallinfo2().uordblks) / kMega,
                 static_cast<int>(QApplication::allWidgets().size()));
  }

  void leave() {
    if (QWidget* top = topmost(); top != &window_) {
      top->close();
      return;
    }
    loop_.quit();  // and on: a dialog may be about to open
  }

  /// The popup or dialog that has the input, else the window.
  QWidget* topmost() {
    if (QWidget* popup = QApplication::activePopupWidget()) {
      return popup;
    }
    QWidget* modal = QApplication::activeModalWidget();
    return modal != nullptr ? modal : &window_;
  }

  /// Something to be seen, more often small parts than their ground.
  QWidget* target() {
    QWidget* top = topmost();
    QList<QWidget*> parts;
    for (QWidget* part : top->findChildren<QWidget*>()) {
      if (part->isVisible() && part->isEnabled() && part->window() == top &&
          !part->size().isEmpty()) {
        parts << part;
      }
    }
    return parts.isEmpty() || draw(12) == 0 ? top : parts.at(draw(parts.size()));
  }

  MonkeyHands::Touch touch() {
    QWidget* const part = target();
    return {part, placeIn(*part), modifiers()};
  }
  QPoint placeIn(const QWidget& part) { return {draw(part.width()), draw(part.height())}; }

  Qt::KeyboardModifiers modifiers() {
    static const Qt::KeyboardModifiers kAll[] = {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier,
                                                 Qt::ShiftModifier, Qt::ControlModifier};
    return kAll[draw(5)];
  }

  void click() {
    const MonkeyHands::Touch touch = this->touch();
    const Qt::MouseButton button = draw(6) == 0 ? Qt::RightButton : Qt::LeftButton;
    const bool isTwice = draw(8) == 0;
    diary_.note(*touch.part, isTwice ? "double click" : "click", touch.at);
    hands_.press(touch, button);
    hands_.release(touch, button);
    if (isTwice) {
      hands_.clickAgain(touch, button);
    }
  }

  /// Sometimes with a key press in the middle: of another tool, or one that removes the dragged
  /// entity.
  void drag() {
    MonkeyHands::Touch touch = this->touch();
    diary_.note(*touch.part, "drag", touch.at);
    hands_.press(touch, Qt::LeftButton);
    for (int k = 0; k < 4 && touch.part; ++k) {
      touch.at = placeIn(*touch.part);
      diary_.note(*touch.part, "to", touch.at);
      hands_.move(touch);
      if (draw(6) == 0) {
        type();
      }
    }
    hands_.release(touch, Qt::LeftButton);
  }

  static bool isDragging() {
    const QWidgetList windows = QApplication::topLevelWidgets();
    return std::any_of(windows.begin(), windows.end(), [](const QWidget* window) {
      return window->findChild<QDrag*>() != nullptr;
    });
  }

  void drop() {
    const MonkeyHands::Touch touch = this->touch();
    diary_.note(*touch.part, "drop", touch.at);
    hands_.release(touch, Qt::LeftButton);
  }

  void turnWheel() {
    const MonkeyHands::Touch touch = this->touch();
    diary_.note(*touch.part, "wheel", touch.at);
    hands_.turnWheel(touch, draw(2) == 0);
  }

  void type() {
    struct Key {
      Qt::Key key;
      Qt::KeyboardModifiers modifiers;
    };
    static const std::vector<Key> kKeys = {{Qt::Key_A, Qt::ControlModifier},
                                           {Qt::Key_D, Qt::ControlModifier},
                                           {Qt::Key_Z, Qt::ControlModifier},
                                           {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier},
                                           {Qt::Key_C, Qt::ControlModifier},
                                           {Qt::Key_V, Qt::ControlModifier},
                                           {Qt::Key_X, Qt::ControlModifier},
                                           {Qt::Key_R, Qt::ControlModifier},
                                           {Qt::Key_G, Qt::ControlModifier},
                                           {Qt::Key_S, Qt::ControlModifier},
                                           {Qt::Key_E, Qt::ControlModifier},
                                           {Qt::Key_N, Qt::ControlModifier},
                                           {Qt::Key_F2, {}},
                                           {Qt::Key_Delete, {}},
                                           {Qt::Key_Backspace, {}},
                                           {Qt::Key_Escape, {}},
                                           {Qt::Key_Escape, {}},
                                           {Qt::Key_Return, {}},
                                           {Qt::Key_Tab, {}},
                                           {Qt::Key_Space, {}},
                                           {Qt::Key_Space, {}},
                                           {Qt::Key_Left, {}},
                                           {Qt::Key_Right, {}},
                                           {Qt::Key_Up, {}},
                                           {Qt::Key_Down, {}},
                                           {Qt::Key_Home, {}},
                                           {Qt::Key_End, {}},
                                           {Qt::Key_PageDown, {}},
                                           {Qt::Key_Comma, {}},
                                           {Qt::Key_Period, {}},
                                           {Qt::Key_BracketLeft, {}}};
    Key key{};
    if (draw(2) == 0) {
      key = kKeys[static_cast<std::size_t>(draw(static_cast<int>(kKeys.size())))];
    } else {
      const int letter = draw(36);
      key.key = static_cast<Qt::Key>(letter < 26 ? Qt::Key_A + letter : Qt::Key_0 + letter - 26);
    }
    diary_.note(*topmost(), key.key, key.modifiers);
    hands_.type(*topmost(), key.key, key.modifiers);
  }

  /// Events without mouse and keys: observers control a run, a breakpoint selects a person, another
  /// program changes the file.
  void changeBehind() {
    editor::SimulationRunner& runner = window_.workspace().runner();
    if (window_.isOnStartPage()) {
      return;
    }
    switch (draw(8)) {
      case 0:
        diary_.note("plays");
        return runner.play();
      case 1:
        diary_.note("pauses");
        return runner.pause();
      case 2:
        diary_.note("resets");
        return runner.reset();
      case 3:
        diary_.note("steps");
        return runner.stepOnce();
      case 4:
        diary_.note("looks back");
        return runner.seek(draw(100));
      case 5:
        diary_.note("raises a dock");
        return raiseDock();
      case 6:
        diary_.note("touches the file");
        return touchFile();
      default:
        diary_.note("selects a person");
        return selectPerson();
    }
  }

  void selectPerson() {
    editor::ScenarioDocument& document = window_.workspace().document();
    const std::vector<base::EntityId> people = document.entities(base::EntityKind::Human);
    if (!people.empty()) {
      document.setSelection(
          {people[static_cast<std::size_t>(draw(static_cast<int>(people.size())))]});
    }
  }
  void raiseDock() {
    const QStringList names = window_.docks().names();
    QDockWidget* const dock = window_.docks().dock(names[draw(names.size())]);
    dock->show();
    dock->raise();
  }
  void touchFile() {
    QFile file(window_.workspace().document().path());
    if (file.exists() && QDir::current().exists(QFileInfo(file).fileName()) &&
        file.open(QIODevice::Append)) {
      file.write("# of another program\n");
    }
  }

  app::MainWindow& window_;
  MonkeyHands& hands_;
  Testers& testers_;
  const base::AgentRng rng_;
  std::uint32_t draws_ = 0;
  int left_;
  QTimer timer_;
  QEventLoop loop_;
  MonkeyDiary diary_;
};

/// As selected by HUNAV_MONKEY_HANDS; null: not available here.
std::unique_ptr<MonkeyHands> handsToUse() {
  if (qEnvironmentVariable("HUNAV_MONKEY_HANDS") != QLatin1String("x11")) {
    return std::make_unique<QtHands>();
  }
  auto hands = std::make_unique<XHands>();
  const bool isThere = QGuiApplication::platformName() == QLatin1String("xcb") && hands->isThere();
  return isThere ? std::move(hands) : nullptr;
}

}  // namespace

/// The window under random events: nothing crashes, no model and no library complains.
class MonkeyTest : public QObject {
  Q_OBJECT

 public Q_SLOTS:
  /// Other programs are not started.
  void showOutside(const QUrl& /*place*/) {}

 private:
  /// Every other time with all panels open.
  static void makeReady(app::MainWindow& window, int seed) {
    const QString program = QStringLiteral(HUNAVSIM_PROGRAM);
    window.docks().panel<editor::FuturesPanel>().process().setProgram(program);
    window.docks().panel<app::StudyPanel>().process().setProgram(program);
    if (seed % 2 == 0) {
      window.resize(window.screen()->availableSize());
      window.docks().show(window.docks().names());
    }
  }

 private Q_SLOTS:
  void initTestCase() {
    editor::applyTheme(editor::Theme::light());
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "showOutside");
  }

  void window_underRandomEvents_stands_data() {
    QTest::addColumn<int>("seed");
    const int first = numberIn("HUNAV_MONKEY_FIRST", 1);
    for (int seed = first; seed < first + numberIn("HUNAV_MONKEY_SEEDS", 2); ++seed) {
      QTest::newRow(QByteArray::number(seed).constData()) << seed;
    }
  }
  void window_underRandomEvents_stands() {
    QFETCH(int, seed);
    QTemporaryDir home;
    QVERIFY(QDir::setCurrent(home.path()));
    const QString file = quiet::copyOfDemo(home.filePath(QStringLiteral("demo.yaml")));
    QStringList complaints;
    auto window = quiet::shownWindow();
    QVERIFY(window->open(file));
    makeReady(*window, seed);
    const std::unique_ptr<MonkeyHands> hands = handsToUse();
    QVERIFY2(hands != nullptr, "no X server, or no libXtst.so.6");
    Testers testers;
    testers.meetAll();
    QVERIFY(testers.size() >= 3);
    heard = &complaints;
    const QtMessageHandler before = qInstallMessageHandler(listen);
    Monkey(*window, *hands, testers, seed, numberIn("HUNAV_MONKEY_EVENTS", 600)).play();
    window->workspace().runner().reset();
    qInstallMessageHandler(before);
    heard = nullptr;
    testers.leave();
    quiet::leave(window);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(QLatin1Char('\n'))));
  }
};

/// A file dialog reaches the whole machine: nobody in particular presses the keys. Home lies deep,
/// so that "up" leads to folders that stand still: Qt's list of files can fall over one that
/// vanishes while it sorts.
int main(int argc, char** argv) {
  QTemporaryDir ground(QStringLiteral("/tmp/monkey-XXXXXX"));
  constexpr uid_t kNobody = 65534;
  if (::geteuid() == 0 && ::chown(ground.path().toLocal8Bit().constData(), kNobody, kNobody) == 0) {
    const bool isNobody =
        ::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0;
    if (!isNobody) {
      return 1;
    }
  }
  const QString home = ground.filePath(QStringLiteral("a/house/of/nobody"));
  if (!QDir().mkpath(home)) {
    return 1;
  }
  for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME",
                            "XDG_RUNTIME_DIR", "TMPDIR"}) {
    qputenv(place, home.toLocal8Bit());
  }
  QApplication app(argc, argv);
  MonkeyTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "tst_Monkey.moc"
