#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QFrame>
#include <QVBoxLayout>

#include "editor/look/Theme.h"

namespace app {

/// Something that the user should know and may decide on, without a box in the way.
struct Notice {
  QString id;  // a later one of the same takes its place
  bool isWarning = false;
  QString text;
  struct Choice {
    QString text;
    std::function<void()> action;
  };
  std::vector<Choice> choices;  // each ends the notice
};

/// Notices above the canvas, one line each; takes no room when there are none.
class NoticeBar : public QWidget {
  Q_OBJECT
 public:
  explicit NoticeBar(const editor::Theme& theme, QWidget* parent = nullptr);
  void tell(Notice notice);
  using Choices = std::vector<Notice::Choice>;
  void inform(const QString& id, const QString& text, Choices choices) {
    tell({id, false, text, std::move(choices)});
  }
  void warn(const QString& id, const QString& text, Choices choices = {}) {
    tell({id, true, text, std::move(choices)});
  }
  void drop(const QString& id);
  bool isTold(const QString& id) { return find(id) != notices_.end(); }
  const std::vector<Notice>& notices() const { return notices_; }
  void choose(const QString& id, int choice);
  void setTheme(const editor::Theme& theme);

 Q_SIGNALS:
  void keyboardFree();  // it was on a button that goes now

 private:
  std::vector<Notice>::iterator find(const QString& id);
  void rebuild();
  QWidget* rowOf(const Notice& notice);

  editor::Theme theme_;
  std::vector<Notice> notices_;
  QVBoxLayout* rows_;
};

}  // namespace app
