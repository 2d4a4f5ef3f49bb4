#pragma once

#include "app/run/DataPaths.h"
#include "app/window/start/StartCards.h"
#include "app/window/start/Thumbnails.h"
#include "editor/look/Form.h"

namespace app {

/// The shipped scenarios as pictures, with search and filters. Pictures and cards come one after
/// the other while the window is used.
class ScenarioGallery : public QWidget {
  Q_OBJECT
 public:
  ScenarioGallery(const std::vector<ShippedScenario>& scenarios, const QString& thumbnailFolder,
                  const editor::Theme& theme, QWidget* parent);
  void showTheme();     // call after a theme change
  void loadPictures();  // those that are missing or have another size

  QLineEdit& search() const { return *search_; }
  QComboBox& family() const { return *family_; }
  QComboBox& difficulty() const { return *difficulty_; }
  std::vector<ScenarioCard*> shownCards() const;  // in their order
  const Thumbnails& thumbnails() const { return *thumbnails_; }

 Q_SIGNALS:
  void fileRequested(const QString& path);

 private:
  QLayout* makeTop();
  QWidget* makeNothing();
  void take(const QString& path, const QImage& picture, const ScenarioInfo& info);
  void fillFilters();
  void filter();
  bool isWanted(const ScenarioInfo& info) const;

  const editor::Theme& theme_;  // of the workspace
  Thumbnails* thumbnails_;
  editor::SearchField* search_;
  QComboBox* family_ = new QComboBox(this);
  QComboBox* difficulty_ = new QComboBox(this);
  QWidget* area_ = new QWidget(this);
  QGridLayout* grid_ = new QGridLayout(area_);
  QWidget* nothing_ = nullptr;
  std::vector<ScenarioCard*> cards_;
};

}  // namespace app
