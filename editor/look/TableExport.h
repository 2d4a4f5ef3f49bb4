#pragma once

#include <QtWidgets>

namespace editor {

/// Data role of a cell's exact value in saved tables; without it the displayed text is saved.
constexpr int kExactValueRole = Qt::UserRole + 102;

/// Data role of the key of the thing that a cell names, such as a metric; saved tables have it in a
/// column "Key" beside the label.
constexpr int kSavedKeyRole = Qt::UserRole + 103;

enum class TableFormat { Csv, Latex, Markdown };

/// The visible rows and columns of a list, tree or table as the text of a file. Rows of a tree that
/// only contain other rows become a column "Group". Numbers are written with all digits to CSV, and
/// as displayed to LaTeX and Markdown.
QString tableText(const QAbstractItemView& view, const QString& name, TableFormat format);

/// Adds "Copy table" and "Save table…" to a menu. Copying puts CSV with tabs on the clipboard, as
/// spreadsheets expect it. `name` is the caption of the table and the proposed file name.
void addTableActions(QMenu& menu, QAbstractItemView& view, const QString& name);
/// Adds a context menu with these actions to a view that has no context menu.
void makeTableSavable(QAbstractItemView& view, const QString& name);

/// Asks for a file in the user's folder (see kFolderProperty) and returns it with an ending of the
/// chosen filter, such as "Vector picture (*.svg)". Empty: cancelled.
QString askFileToSave(QWidget& parent, const QString& title, const QString& name,
                      const QStringList& filters);
/// A property of the window with the folder of the user's own files, where dialogs start.
constexpr const char* kFolderProperty = "hunavFolder";

}  // namespace editor
