#include <new>
#include <stdexcept>

#include <QtTest>

#include "app/window/KeyRules.h"

namespace {

/// What fails while it handles an event.
class Failing : public QObject {
 public:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::User) {
      throw std::runtime_error("the disk is gone");
    }
    if (event->type() == QEvent::User + 1) {
      throw std::bad_alloc();
    }
    return QObject::event(event);
  }
};

app::GuardedApplication& application() {
  return *static_cast<app::GuardedApplication*>(QCoreApplication::instance());
}

}  // namespace

class GuardedApplicationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { application().setExceptionHandler({}); }

  void thrown_inAnEvent_isToldAndTheLoopGoesOn() {
    QStringList told;
    application().setExceptionHandler(
        [&told](const std::string& why) { told += QString::fromStdString(why); });
    Failing failing;
    QCoreApplication::postEvent(&failing, new QEvent(QEvent::User));
    QCoreApplication::postEvent(&failing, new QEvent(static_cast<QEvent::Type>(QEvent::User + 1)));
    QTRY_COMPARE(told.size(), 2);
    const QStringList expected = {QStringLiteral("the disk is gone"),
                                  QStringLiteral("not enough memory")};
    QCOMPARE(told, expected);
  }

  void thrown_withNobodyToTell_goesOn() {
    Failing failing;
    QEvent event(QEvent::User);
    QVERIFY_EXCEPTION_THROWN(QCoreApplication::sendEvent(&failing, &event), std::runtime_error);
  }
};

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  app::GuardedApplication guarded(argc, argv);
  GuardedApplicationTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_GuardedApplication.moc"
