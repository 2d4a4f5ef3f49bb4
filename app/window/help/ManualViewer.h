#pragma once

#include "app/window/help/ManualPages.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace app {

/// The Markdown that Qt displays, from a page written for Sphinx with MyST: figures become images,
/// notes become quotations, contents become lists of links, labels are left out. `folder`: of the
/// pages, for included files.
QString plainMarkdown(const QString& myst, const QString& folder);

/// A window that shows the manual from its Markdown files, without a browser and a network: list of
/// pages, search in all of them, back and forward.
class ManualViewer : public QWidget {
  Q_OBJECT
 public:
  ManualViewer(QString folder, const editor::Theme& theme, QWidget* parent);

  /// Shows a page, at a heading if `heading` is not empty, and brings the window to the front.
  void showPage(const QString& page, const QString& heading = {});
  QString page() const { return shown_ < 0 ? QString() : history_.at(shown_).first; }
  QTextBrowser& text() const { return *text_; }
  QListWidget& pages() const { return *pages_; }
  QLineEdit& search() const { return *search_; }
  void setTheme(const editor::Theme& theme);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeSide();
  QString textOf(const QString& page) const;  // null: no such file
  void display();                             // the page at `shown_` of the history
  void scrollTo(const QString& heading);
  void follow(const QUrl& link);
  void step(int by);
  void filter(const QString& typed);

  QString folder_;
  editor::SearchField* search_;
  QListWidget* pages_ = new QListWidget(this);
  editor::NoMatchesPlaceholder* nothing_ = nullptr;
  QTextBrowser* text_ = new QTextBrowser(this);
  QAction *back_, *forward_;
  QList<QPair<QString, QString>> history_;  // page, heading
  int shown_ = -1;
};

}  // namespace app
