#pragma once

#include <map>
#include <memory>

#include <QAbstractScrollArea>
#include <QFile>
#include <QLibrary>
#include <QMetaEnum>
#include <QPointer>
#include <QtTest>

/// Log of the events, to be read after a crash: HUNAV_MONKEY_DIARY is the file of the last seed.
class MonkeyDiary {
 public:
  MonkeyDiary() : file_(qEnvironmentVariable("HUNAV_MONKEY_DIARY")) {
    if (file_.fileName().isEmpty()) {
      return;
    }
    isKept_ = file_.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered);
    if (!isKept_) {
      qWarning("cannot write the diary: %s", qPrintable(file_.errorString()));
    }
  }

  void begin(int left) { write(QByteArray("\n") + QByteArray::number(left)); }
  void note(const char* what) { write(QByteArray(" ") + what); }
  void note(const QWidget& part, const char* what, const QPoint& at) {
    write(QByteArray(" ") + what + ' ' + QByteArray::number(at.x()) + ',' +
          QByteArray::number(at.y()) + " on " + pathOf(part));
  }
  void note(const QWidget& part, int key, Qt::KeyboardModifiers modifiers) {
    write(" key " + QByteArray::number(static_cast<int>(modifiers) | key, 16) + " on " +
          pathOf(part));
  }

 private:
  static QByteArray pathOf(const QWidget& part) {
    QByteArray path;
    for (const QWidget* each = &part; each != nullptr; each = each->parentWidget()) {
      path +=
          QByteArray(each->metaObject()->className()) + '(' + each->objectName().toUtf8() + ")<";
    }
    return path;
  }
  void write(const QByteArray& text) {
    if (isKept_) {
      file_.write(text);
    }
  }

  QFile file_;
  bool isKept_ = false;
};

/// Mouse and keyboard of the monkey. The widget may be deleted by any call.
class MonkeyHands {
 public:
  MonkeyHands() = default;
  virtual ~MonkeyHands() = default;
  Q_DISABLE_COPY_MOVE(MonkeyHands)

  /// Position of a click, and the modifier keys held.
  struct Touch {
    QPointer<QWidget> part;
    QPoint at;
    Qt::KeyboardModifiers keys;
  };
  virtual void press(const Touch& touch, Qt::MouseButton button) = 0;
  virtual void move(const Touch& touch) = 0;  // the left button is held
  virtual void release(const Touch& touch, Qt::MouseButton button) = 0;
  virtual void clickAgain(const Touch& touch, Qt::MouseButton button) = 0;  // of a double click
  virtual void turnWheel(const Touch& touch, bool up) = 0;
  virtual void type(QWidget& top, Qt::Key key, Qt::KeyboardModifiers modifiers) = 0;
  virtual bool canDrop() const = 0;  // a release ends a drag of Qt
};

/// Events of Qt, on every platform.
class QtHands : public MonkeyHands {
 public:
  void press(const Touch& touch, Qt::MouseButton button) override {
    send(touch, QEvent::MouseButtonPress, button, button);
    if (touch.part && button == Qt::RightButton) {
      QContextMenuEvent menu(QContextMenuEvent::Mouse, touch.at, touch.part->mapToGlobal(touch.at));
      QApplication::sendEvent(touch.part, &menu);
    }
  }
  void move(const Touch& touch) override {
    send(touch, QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
  }
  void release(const Touch& touch, Qt::MouseButton button) override {
    send(touch, QEvent::MouseButtonRelease, button, {});
  }
  void clickAgain(const Touch& touch, Qt::MouseButton button) override {
    send(touch, QEvent::MouseButtonDblClick, button, button);
    send(touch, QEvent::MouseButtonRelease, button, {});
  }
  void turnWheel(const Touch& touch, bool up) override {
    if (touch.part) {
      QWheelEvent event(touch.at, touch.part->mapToGlobal(touch.at), {}, {0, up ? 120 : -120},
                        Qt::NoButton, touch.keys, Qt::NoScrollPhase, false);
      QApplication::sendEvent(touch.part, &event);
    }
  }
  void type(QWidget& top, Qt::Key key, Qt::KeyboardModifiers modifiers) override {
    const QPointer<QWindow> window = top.windowHandle();
    for (const bool isPress : {true, false}) {
      if (window) {  // it may close at the press
        QTest::simulateEvent(window, isPress, key, modifiers, {}, false, -1);
      }
    }
  }
  bool canDrop() const override { return false; }

 private:
  static void send(const Touch& touch, QEvent::Type type, Qt::MouseButton button,
                   Qt::MouseButtons buttons) {
    if (touch.part) {
      QMouseEvent event(type, touch.at, touch.part->mapToGlobal(touch.at), button, buttons,
                        touch.keys);
      QApplication::sendEvent(touch.part, &event);
    }
  }
};

/// Events of the X server, as a mouse and a keyboard make them: the topmost window receives them,
/// popups grab them, and they pass through all of Qt. Uses libXtst, which xdotool needs as well.
class XHands : public MonkeyHands {
 public:
  XHands() : x11_(QStringLiteral("X11"), 6), test_(QStringLiteral("Xtst"), 6) {
    const auto open = resolve<void*(const char*)>(x11_, "XOpenDisplay");
    sync_ = resolve<int(void*, int)>(x11_, "XSync");
    keycode_ = resolve<unsigned char(void*, unsigned long)>(x11_, "XKeysymToKeycode");
    fakeMotion_ = resolve<int(void*, int, int, int, unsigned long)>(test_, "XTestFakeMotionEvent");
    fakeButton_ = resolve<int(void*, unsigned, int, unsigned long)>(test_, "XTestFakeButtonEvent");
    fakeKey_ = resolve<int(void*, unsigned, int, unsigned long)>(test_, "XTestFakeKeyEvent");
    const bool isThere = open && sync_ && keycode_ && fakeMotion_ && fakeButton_ && fakeKey_;
    display_ = isThere ? open(nullptr) : nullptr;
  }
  bool isThere() const { return display_ != nullptr; }

  void press(const Touch& touch, Qt::MouseButton button) override {
    const Held held(*this, touch.keys);
    goTo(touch);
    push(button, true);
  }
  void move(const Touch& touch) override { goTo(touch); }
  void release(const Touch& touch, Qt::MouseButton button) override {
    const Held held(*this, touch.keys);
    push(button, false);
  }
  void clickAgain(const Touch& touch, Qt::MouseButton button) override {
    const Held held(*this, touch.keys);
    push(button, true);
    push(button, false);
  }
  void turnWheel(const Touch& touch, bool up) override {
    const Held held(*this, touch.keys);
    goTo(touch);
    const unsigned button = up ? 4 : 5;
    fakeButton_(display_, button, 1, 0);
    fakeButton_(display_, button, 0, 0);
    sync_(display_, 0);
  }
  void type(QWidget& /*top*/, Qt::Key key, Qt::KeyboardModifiers modifiers) override {
    const Held held(*this, modifiers);
    push(keysymOf(key), true);
    push(keysymOf(key), false);
  }
  bool canDrop() const override { return true; }

 private:
  /// Keys that are held down while another one, or a button, is pressed.
  class Held {
   public:
    Held(XHands& hands, Qt::KeyboardModifiers keys) : hands_(hands), keys_(keys) { push(true); }
    ~Held() { push(false); }
    Q_DISABLE_COPY_MOVE(Held)

   private:
    void push(bool down) {
      if (keys_.testFlag(Qt::ShiftModifier)) {
        hands_.push(0xffe1UL, down);
      }
      if (keys_.testFlag(Qt::ControlModifier)) {
        hands_.push(0xffe3UL, down);
      }
    }
    XHands& hands_;
    const Qt::KeyboardModifiers keys_;
  };

  template <class Function>
  static Function* resolve(QLibrary& library, const char* name) {
    return reinterpret_cast<Function*>(library.resolve(name));
  }
  static unsigned long keysymOf(Qt::Key key) {
    static const std::map<int, unsigned long> kOthers = {
        {Qt::Key_Delete, 0xffff}, {Qt::Key_Backspace, 0xff08}, {Qt::Key_Escape, 0xff1b},
        {Qt::Key_Return, 0xff0d}, {Qt::Key_Tab, 0xff09},       {Qt::Key_Left, 0xff51},
        {Qt::Key_Up, 0xff52},     {Qt::Key_Right, 0xff53},     {Qt::Key_Down, 0xff54},
        {Qt::Key_Home, 0xff50},   {Qt::Key_End, 0xff57},       {Qt::Key_PageDown, 0xff56},
        {Qt::Key_F2, 0xffbf}};
    const auto other = kOthers.find(key);
    const bool isLetter = key >= Qt::Key_A && key <= Qt::Key_Z;
    return other != kOthers.end() ? other->second
                                  : static_cast<unsigned long>(key) + (isLetter ? 32 : 0);
  }
  void goTo(const Touch& touch) {
    if (touch.part) {
      const QPoint at = touch.part->mapToGlobal(touch.at);
      fakeMotion_(display_, -1, at.x(), at.y(), 0);
      sync_(display_, 0);
    }
  }
  void push(Qt::MouseButton button, bool down) {
    fakeButton_(display_, button == Qt::RightButton ? 3 : 1, down ? 1 : 0, 0);
    sync_(display_, 0);
  }
  void push(unsigned long keysym, bool down) {
    if (const unsigned char code = keycode_(display_, keysym); code != 0) {
      fakeKey_(display_, code, down ? 1 : 0, 0);
      sync_(display_, 0);
    }
  }

  QLibrary x11_, test_;
  int (*sync_)(void*, int) = nullptr;
  unsigned char (*keycode_)(void*, unsigned long) = nullptr;
  int (*fakeMotion_)(void*, int, int, int, unsigned long) = nullptr;
  int (*fakeButton_)(void*, unsigned, int, unsigned long) = nullptr;
  int (*fakeKey_)(void*, unsigned, int, unsigned long) = nullptr;
  void* display_ = nullptr;  // one more connection to the server
};
