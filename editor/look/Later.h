#pragma once

#include <functional>

class QObject;

namespace editor {

/// Once the events that wait are through, or after some time, unless `context` is gone by then.
/// Thread: that of the window.
void later(QObject& context, const std::function<void()>& action, int milliseconds = 0);

}  // namespace editor
