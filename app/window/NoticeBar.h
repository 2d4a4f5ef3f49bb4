#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QtWidgets>

#include "editor/look/Theme.h"

namespace app {

class StudyPanel;
class Workspace;

/// A non-modal message with optional choices.
struct Notice {
  QString id;  // a later notice with the same id replaces it
  bool isWarning = false;
  QString text;
  struct Choice {
    QString text;
    std::function<void()> action;
  };
  std::vector<Choice> choices;  // each closes the notice
};

/// Shows notices at the top of the canvas, one per row; hidden if there are none. They cover the
/// canvas, so that nothing moves under the pointer when a notice appears or disappears.
class NoticeBar : public QWidget {
  Q_OBJECT
 public:
  explicit NoticeBar(const editor::Theme& theme, QWidget* parent = nullptr);
  /// Covers the top of the widget, with its width.
  void coverTop(QWidget& widget);
  /// Takes its own row in a layout instead.
  void insertInto(QBoxLayout& layout);
  void post(Notice notice);
  using Choices = std::vector<Notice::Choice>;
  void inform(const QString& id, const QString& text, Choices choices) {
    post({id, false, text, std::move(choices)});
  }
  void warn(const QString& id, const QString& text, Choices choices = {}) {
    post({id, true, text, std::move(choices)});
  }
  void drop(const QString& id);
  bool has(const QString& id) { return find(id) != notices_.end(); }
  const std::vector<Notice>& notices() const { return notices_; }
  void choose(const QString& id, int choice);
  void setTheme(const editor::Theme& theme);

 Q_SIGNALS:
  void coverChanged(int height);  // of the covered top [px]
  void focusReleased();           // a focused button is about to be deleted

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  std::vector<Notice>::iterator find(const QString& id);
  void rebuild();
  void place();
  void setCover(int height);
  QWidget* rowOf(const Notice& notice);

  editor::Theme theme_;
  std::vector<Notice> notices_;
  QVBoxLayout* rows_;
  QPointer<QWidget> covered_;
  int cover_ = 0;  // height [px]
};

/// Asks for confirmation in a notice before a run starts programs or libraries named in the
/// scenario. If allowed, the run starts as requested. The workspace stores the answer.
void askBeforeExternalCode(Workspace& workspace, NoticeBar& notices);
inline QString codeNoticeId() {
  return QStringLiteral("code");
}
/// The same for the runs of a study; the panel stores the answer.
void askBeforeExternalCode(StudyPanel& study, NoticeBar& notices);
inline QString studyCodeNoticeId() {
  return QStringLiteral("study-code");
}

}  // namespace app
