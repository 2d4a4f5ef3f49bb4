#include "app/window/GuardedApplication.h"

#include <exception>

#include "app/run/Reason.h"

namespace app {

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& problem) {
    if (!act_) {
      throw;
    }
    act_(reasonOf(problem));
    return false;
  }
}

}  // namespace app
