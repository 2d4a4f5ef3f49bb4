#include "app/window/settings/Preferences.h"

#include <algorithm>

#include "app/window/RunCommands.h"

namespace app {

namespace {

constexpr const char* kAnimation = "window/animation";
constexpr const char* kAutosave = "files/autosave";
constexpr const char* kAutosaveSeconds = "files/autosaveSeconds";
constexpr int kMsPerSecond = 1000;
constexpr std::size_t kBytesPerMegabyte = 1U << 20U;

}  // namespace

Preferences::Preferences(Workspace& workspace, UserSettings& userSettings,
                         editor::Autosave* autosave, QObject* parent)
    : QObject(parent), workspace_(workspace), userSettings_(userSettings), autosave_(autosave) {
  apply();
}

bool Preferences::isAnimated() const {
  const QVariant stored = userSettings_.value(kAnimation);
  return !stored.isValid() || stored.toBool();
}

void Preferences::setAnimated(bool on) {
  userSettings_.setValue(kAnimation, on);
  apply();
}

bool Preferences::isAutosaved() const {
  const QVariant stored = userSettings_.value(kAutosave);
  return !stored.isValid() || stored.toBool();
}

int Preferences::autosaveSeconds() const {
  const int stored = userSettings_.value(kAutosaveSeconds).toInt();
  return stored == 0 ? editor::Autosave::kAutosaveMs / kMsPerSecond
                     : std::clamp(stored, kLeastSeconds, kMostSeconds);
}

void Preferences::setAutosave(bool on, int seconds) {
  userSettings_.setValue(kAutosave, on);
  userSettings_.setValue(kAutosaveSeconds, std::clamp(seconds, kLeastSeconds, kMostSeconds));
  apply();
}

int Preferences::historyMegabytes() const {
  return static_cast<int>(workspace_.runner().historyMemory() / kBytesPerMegabyte);
}

void Preferences::setHistoryMegabytes(int megabytes) {
  setHistoryMemory(userSettings_, workspace_.runner(), megabytes);
}

void Preferences::reset() {
  for (const char* key : {kAnimation, kAutosave, kAutosaveSeconds, kFolderKey, kLanguageKey}) {
    userSettings_.setValue(key, {});
  }
  setHistoryMegabytes(usualHistoryMegabytes());
  apply();
}

void Preferences::apply() {
  workspace_.view().setAnimated(isAnimated());
  if (autosave_ != nullptr) {
    autosave_->setDelay(isAutosaved() ? std::optional<int>(autosaveSeconds() * kMsPerSecond)
                                      : std::nullopt);
  }
}

}  // namespace app
