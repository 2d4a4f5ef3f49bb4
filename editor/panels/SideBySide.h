#pragma once

#include <memory>
#include <vector>

#include <QGridLayout>

#include "editor/panels/SideView.h"

namespace editor {

/// Other runs beside the canvas: one, two below each other, or up to four in two columns. All show
/// the same place and time.
class SideBySide : public QWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t kMost = 4;

  struct Run {
    QString title;
    std::shared_ptr<const sim2d::Recording> recording;
    bool isOfEdited = false;  // of the document that is open
  };
  SideBySide(MapView& canvas, const ScenarioDocument& edited, QWidget* parent = nullptr);

  /// The first of these; views of runs that were there already stay.
  void showRuns(const std::vector<Run>& runs);
  void showAt(double time);  // [s]
  void setTheme(const Theme& theme);
  int columns() const { return views_.size() > 2 ? 2 : 1; }
  const std::vector<std::unique_ptr<SideView>>& views() const { return views_; }

 private:
  MapView& canvas_;
  const ScenarioDocument& edited_;
  QGridLayout* grid_;
  std::vector<std::unique_ptr<SideView>> views_;
  std::vector<Run> runs_;  // of the views
};

}  // namespace editor
