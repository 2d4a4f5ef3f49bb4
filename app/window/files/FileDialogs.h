#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QtWidgets>

#include "app/run/Export.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {

/// Recent files and other settings stored between sessions. Without a store (pictures, tests)
/// nothing is read or written.
class UserSettings {
 public:
  explicit UserSettings(bool storesSettings);
  QStringList recentFiles() const;
  void addRecentFile(const QString& path);        // call when a file is opened or saved
  QDateTime lastUsed(const QString& path) const;  // time of last use; invalid: unknown
  QVariant value(const char* key) const;
  void setValue(const char* key, const QVariant& value);

 private:
  std::unique_ptr<QSettings> store_;
};

/// Asks for a file or folder. Empty: cancelled. The dialog has its last size and state.
QString askFile(QFileDialog& dialog, UserSettings& userSettings);

/// A form with right-aligned labels.
QFormLayout* formRows();
/// Adds an accept and a cancel button at the bottom. Returns the accept button.
QPushButton* addButtons(QDialog* dialog, QVBoxLayout& rows, const QString& accept);

/// Asks for the size of a new empty room.
class RoomDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RoomDialog(const editor::Theme& theme, QWidget* parent = nullptr);
  QSizeF size() const { return {width_->value(), height_->value()}; }  // [m], inner size
  bool hasWalls() const { return walls_->isChecked(); }

 private:
  QRadioButton* walls_ = new QRadioButton(tr("Room with four walls"), this);
  QRadioButton* plane_ = new QRadioButton(tr("Open plane without a map"), this);
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
};

/// Shows a map image in which the user marks two points by clicking and dragging.
class ScaleView : public QWidget {
  Q_OBJECT
 public:
  ScaleView(QImage image, const editor::Theme& theme, QWidget* parent = nullptr);
  /// The points in image pixels from the lower left corner, in order of clicking.
  const std::vector<QPointF>& points() const { return points_; }
  void setPoints(std::vector<QPointF> points);
  QSize sizeHint() const override { return {560, 420}; }

 Q_SIGNALS:
  void pointsChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QRectF imageRect() const;  // in widget coordinates
  QPointF toImage(const QPointF& widget) const;
  QPointF toWidget(const QPointF& image) const;

  QImage image_;
  editor::Theme theme_;
  std::vector<QPointF> points_;
  int draggedPoint_ = -1;
};

/// Asks for the resolution and origin of an image that becomes a map: by two points with a known
/// distance, or by number.
class ImageMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `grid`: the cells of the image; `image`: the displayed image.
  ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                 const editor::Theme& theme, QWidget* parent = nullptr);
  ScaleView& view() { return *view_; }
  double resolution() const;  // [m/pixel]
  bool isMeasured() const;    // the input is complete and valid
  /// The map with this resolution. The first point has the entered coordinates; without points, the
  /// lower left corner of the image has them.
  std::shared_ptr<const sim2d::OccupancyGrid> map() const;

 private:
  QLayout* makeSide();
  void measure();          // updates the result
  double pixels() const;   // [pixels] between the points; 0: fewer than two
  bool isInRange() const;  // whether the resolution is valid
  QString hint() const;    // instruction for the user

  std::shared_ptr<const sim2d::OccupancyGrid> grid_;
  editor::Theme theme_;
  ScaleView* view_;
  QRadioButton* byPoints_ = new QRadioButton(tr("By two points in the image"), this);
  QRadioButton* byNumber_ = new QRadioButton(tr("By resolution"), this);
  QDoubleSpinBox* distance_;
  QDoubleSpinBox* resolution_;
  QDoubleSpinBox* firstX_;
  QDoubleSpinBox* firstY_;
  QLabel* hint_ = editor::secondaryLabel(QString(), this);
  QLabel* place_ = editor::headingLabel({}, theme_.font(9.5, QFont::DemiBold), this);
  QLabel* size_ = editor::secondaryLabel(QString(), this);
  QPushButton* create_ = nullptr;
};

/// Exports the scenario to another simulator: target, folder, the files to be written with their
/// state, and the information that the target does not support.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(Bundle source, const QString& folder, const editor::Theme& theme,
               QWidget* parent = nullptr);
  const ExportPlan& plan() const { return plan_; }
  QString folder() const { return folder_->text(); }

 private:
  void build();
  QLayout* makeForm();
  QWidget* makeStart();
  void fillTargets();
  void replan();
  void showFiles();
  void showReport();

  Bundle source_;
  ExportPlan plan_;
  editor::Theme theme_;
  QListWidget* targets_ = new QListWidget(this);
  QLineEdit* folder_;
  QComboBox* dialect_ = new QComboBox(this);
  QComboBox* style_ = new QComboBox(this);
  QLabel* summary_ = editor::secondaryLabel(QString(), this);
  QTreeWidget* files_ = new QTreeWidget(this);
  QLabel* reportTitle_ = editor::headingLabel({}, theme_.font(9.5, QFont::DemiBold), this);
  QListWidget* report_ = new QListWidget(this);
  QWidget* start_ = nullptr;  // the command that starts it in the simulator
  QPlainTextEdit* command_ = new QPlainTextEdit(this);
  QPushButton* copy_ = nullptr;
  QPushButton* export_ = nullptr;
};

class DiffView;

/// Asks before saving replaces manually edited trees: keep, replace, show differences. Closing the
/// dialog cancels saving.
class TreeChoiceDialog : public QDialog {
  Q_OBJECT
 public:
  TreeChoiceDialog(std::vector<editor::TreeConflict> questions, const editor::Theme& theme,
                   QWidget* parent = nullptr);
  const editor::TreeReplacements& replaced() const { return replaced_; }
  void choose(int question, bool isReplaced);
  void showDifferences(bool on);
  void moveOnScreen(const QPoint& corner);

  /// Nothing: cancelled.
  static std::optional<editor::TreeReplacements> ask(std::vector<editor::TreeConflict> questions,
                                                     const editor::Theme& theme, QWidget* parent);

 private:
  void build();
  void showQuestion(int index);
  void take(bool isReplaced);
  void updateRow(int index);

  std::vector<editor::TreeConflict> questions_;
  editor::TreeReplacements replaced_;
  editor::Theme theme_;
  QListWidget* list_ = new QListWidget(this);
  QLabel* why_ = new QLabel(this);
  QRadioButton* keep_ = new QRadioButton(this);
  QRadioButton* replace_ = new QRadioButton(this);
  QCheckBox* all_ = new QCheckBox(tr("Apply to all %1").arg(questions_.size()), this);
  QToolButton* differences_;
  QLabel* legend_ = editor::secondaryLabel(QString(), this);
  DiffView* diff_;
};

}  // namespace app
