#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QtWidgets>

#include "app/cli/RunExport.h"
#include "editor/document/LatestTask.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "sim2d/base/StopFlag.h"

namespace app {

/// What is saved as a picture or film: a run, or the start of a scenario that has not run.
struct ExportSource {
  QString name;  // proposed file name without extension
  /// Called in another thread. Errors: a scenario that cannot run.
  std::function<base::Result<sim2d::Trace>()> trace;
  bool isRun = true;                              // false: only the start
  bool hasForces = false;                         // its states contain forces
  double from = 0.0, to = 0.0;                    // [s], of the run
  double shown = 0.0;                             // [s], of the displayed state
  std::optional<std::pair<double, double>> loop;  // [s], section that is repeated
  FigureOptions options;                          // initial
};

/// Asks for the file. `suggestion`: its name; `ending`: ".png". Empty: cancelled.
using AskExportFile = std::function<QString(const QString& suggestion, const QString& ending)>;

/// An image of a figure of a run, computed in another thread.
class ExportPreview : public QWidget {
  Q_OBJECT
 public:
  explicit ExportPreview(const editor::Theme& theme, QWidget* parent = nullptr);
  ~ExportPreview() override;
  Q_DISABLE_COPY_MOVE(ExportPreview)

  /// Shows the figure with this layout at this time [s]; nullopt: the whole run.
  void show(std::shared_ptr<const sim2d::Trace> trace, const PictureLayout& layout,
            std::optional<double> time);
  void showText(const QString& text);
  const QImage& image() const { return image_; }
  bool isBusy() const { return task_.isBusy(); }
  QSize sizeHint() const override { return {560, 420}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void render();

  editor::Theme theme_;
  std::shared_ptr<const sim2d::Trace> trace_;
  PictureLayout layout_;
  std::optional<double> time_;
  QString text_;
  QImage image_;
  editor::LatestTask<QImage> task_;
};

/// The common part of the dialogs that save a run as a picture or film: live preview, format, size,
/// overlays and theme. Writing runs in another thread and can be stopped; then no file is written.
class RunExportDialog : public QDialog {
  Q_OBJECT
 public:
  ~RunExportDialog() override;
  Q_DISABLE_COPY_MOVE(RunExportDialog)

  QString savedFile() const { return savedFile_; }  // empty: none was written
  ExportPreview& preview() const { return *preview_; }
  bool isWriting() const { return isWriting_; }
  bool isReady() const { return trace_ != nullptr; }  // the run has been read
  void reject() override;  // while a file is written: stops that, and the dialog stays open

 protected:
  struct Format {
    QString name;
    std::string ending;  // ".png"
    bool isAvailable = true;
  };
  /// Sizes are those of the file; 0: the height that the map requires.
  struct SizePreset {
    QString name;
    double width = 0.0, height = 0.0;
    double scale = 1.0;  // pixels of the file per pixel of the figure
  };
  using Progress = std::function<bool(long long, long long)>;
  /// Writes the file; runs in another thread. False: stopped.
  using Job = std::function<base::Result<bool>(const sim2d::Trace&, const std::string& path,
                                               const Progress&)>;

  RunExportDialog(ExportSource source, AskExportFile askFile, const editor::Theme& theme,
                  QWidget* parent);
  void showEvent(QShowEvent* event) override;
  /// Creates the widgets, then reads the run.
  void build(const QString& title, const std::vector<Format>& formats);
  virtual void addTimeRows(QFormLayout& form) = 0;
  virtual void addFormatRows(QFormLayout& /*form*/) {}  // below the format
  virtual std::vector<SizePreset> presets() const = 0;
  virtual bool isInMillimetres() const { return false; }
  virtual QString suggestedName() const = 0;
  virtual std::optional<double> previewTime() const = 0;
  virtual Job job() const = 0;
  virtual bool isComplete() const { return true; }  // the input is valid
  virtual void followFormat() {}

  const ExportSource& source() const { return source_; }
  std::string ending() const;
  PictureLayout layoutOfFields() const;
  double scale() const { return scale_; }
  editor::NumberField* addNumber(QFormLayout& form, const QString& label,
                                 const editor::NumberField::Range& range, const QString& unit,
                                 double value);
  void updatePreview();
  void updateSave();

 private:
  struct Outcome {
    base::Result<bool> isComplete;
    QString path;
  };
  QLayout* makeForm(const std::vector<Format>& formats);
  QWidget* makeOverlays();
  void addSizeRows(QFormLayout& form);
  QLayout* makeFoot();
  void fillPresets();
  void choosePreset(int index);
  void customizeSize();
  void takeTrace(const std::shared_ptr<base::Result<sim2d::Trace>>& trace);
  void chooseFile();
  void write(const QString& path);
  void finishWriting(const Outcome& outcome);
  void setWriting(bool on);
  void showProgress();

  ExportSource source_;
  AskExportFile askFile_;
  editor::Theme theme_;
  ExportPreview* preview_;
  QWidget* side_ = new QWidget(this);
  QComboBox* format_ = new QComboBox(side_);
  QComboBox* size_ = new QComboBox(side_);
  QDoubleSpinBox* width_ = new QDoubleSpinBox(side_);
  QDoubleSpinBox* height_ = new QDoubleSpinBox(side_);
  QComboBox* colours_ = new QComboBox(side_);
  std::vector<std::pair<QCheckBox*, FigureOverlay>> overlays_;
  QCheckBox* names_ = new QCheckBox(tr("Names"), side_);
  editor::NumberField* timeMarks_ = nullptr;
  QProgressBar* bar_ = new QProgressBar(this);
  QLabel* note_ = new QLabel(this);
  QPushButton* save_ = nullptr;
  QPushButton* cancel_ = nullptr;
  std::vector<SizePreset> presets_;
  double scale_ = 1.0;
  bool isFilling_ = false, isWriting_ = false;
  QString savedFile_;
  std::shared_ptr<const sim2d::Trace> trace_;
  struct Shared {  // with the thread that writes
    std::atomic<bool> isStopped{false};
    std::atomic<long long> frame{0}, count{0};
  };
  std::shared_ptr<Shared> shared_;
  QTimer poll_;
  editor::LatestTask<std::shared_ptr<base::Result<sim2d::Trace>>> reading_;
  editor::LatestTask<std::shared_ptr<Outcome>> writing_;
};

/// Saves the displayed step of a run, or another one, or the start of a scenario as PNG, SVG or
/// PDF.
class SavePictureDialog : public RunExportDialog {
  Q_OBJECT
 public:
  SavePictureDialog(ExportSource source, AskExportFile askFile, const editor::Theme& theme,
                    QWidget* parent = nullptr);

 protected:
  void addTimeRows(QFormLayout& form) override;
  std::vector<SizePreset> presets() const override;
  bool isInMillimetres() const override { return ending() != ".png"; }
  QString suggestedName() const override;
  std::optional<double> previewTime() const override;
  Job job() const override;

 private:
  editor::NumberField* time_ = nullptr;  // null: the scenario has not run
};

/// Saves a section of a run as a GIF, or as MP4, WebP or WebM if ffmpeg is installed.
class SaveFilmDialog : public RunExportDialog {
  Q_OBJECT
 public:
  SaveFilmDialog(ExportSource source, AskExportFile askFile, const editor::Theme& theme,
                 QWidget* parent = nullptr);
  FilmTiming timing() const;

 protected:
  void addFormatRows(QFormLayout& form) override;
  void addTimeRows(QFormLayout& form) override;
  std::vector<SizePreset> presets() const override;
  QString suggestedName() const override { return source().name; }
  std::optional<double> previewTime() const override;
  Job job() const override;
  bool isComplete() const override { return from_->value() < to_->value(); }
  void followFormat() override { limitRate(); }

 private:
  void setRange(double from, double to);
  void followRange();
  void limitRate();

  editor::NumberField* from_ = nullptr;
  editor::NumberField* to_ = nullptr;
  editor::NumberField* rate_ = nullptr;
  editor::NumberField* speed_ = nullptr;
  QSlider* at_ = nullptr;  // time of the preview
  QLabel* length_ = nullptr;
};

}  // namespace app
