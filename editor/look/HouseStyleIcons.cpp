#include <map>

#include <QTransform>

#include "editor/look/HouseStyle.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

struct OwnIcon {
  const char* name;
  Role color;
};

/// Message boxes and file dialogs speak the language of the rest.
const std::map<QStyle::StandardPixmap, OwnIcon>& ownIcons() {
  static const std::map<QStyle::StandardPixmap, OwnIcon> kIcons = {
      {QStyle::SP_MessageBoxQuestion, {"info", Role::Accent}},
      {QStyle::SP_MessageBoxInformation, {"info", Role::Accent}},
      {QStyle::SP_MessageBoxWarning, {"warning", Role::WarningMark}},
      {QStyle::SP_MessageBoxCritical, {"error", Role::Error}},
      {QStyle::SP_DirIcon, {"file-open", Role::TextSecondary}},
      {QStyle::SP_DirClosedIcon, {"file-open", Role::TextSecondary}},
      {QStyle::SP_DirOpenIcon, {"file-open", Role::TextSecondary}},
      {QStyle::SP_DirHomeIcon, {"file-open", Role::TextSecondary}},
      {QStyle::SP_FileIcon, {"file", Role::TextSecondary}},
      {QStyle::SP_FileDialogNewFolder, {"add", Role::Text}},
      {QStyle::SP_FileDialogToParent, {"chevron-up", Role::Text}},
      {QStyle::SP_ArrowForward, {"chevron-right", Role::Text}},
      {QStyle::SP_ArrowBack, {"chevron-right", Role::Text}}};
  return kIcons;
}

/// Left and right exchanged.
QIcon mirrored(const QIcon& icon) {
  constexpr int kSize = 48;
  QIcon result;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Disabled}) {
    const QPixmap pixmap = icon.pixmap(QSize(kSize, kSize), mode);
    result.addPixmap(pixmap.transformed(QTransform().scale(-1.0, 1.0)), mode);
  }
  return result;
}

}  // namespace

QIcon HouseStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                               const QWidget* widget) const {
  const auto found = ownIcons().find(which);
  if (found == ownIcons().end()) {
    return QProxyStyle::standardIcon(which, option, widget);
  }
  const QIcon icon =
      tintedIcon(QString::fromLatin1(found->second.name), theme_.color(found->second.color));
  return which == SP_ArrowBack ? mirrored(icon) : icon;
}

}  // namespace editor
