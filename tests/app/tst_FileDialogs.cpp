#include "app/window/files/FileDialogs.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/RunFiles.h"

using outside::text;

/// Where dialogs for files begin, and what can be done in them.
class FileDialogsTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  struct Seen {
    QString folder;
    bool isReadOnly = false;
    int count = 0;
  };
  /// The next dialog for files is looked at and left.
  static void look(Seen& seen) {
    seen = {};
    quiet::answerDialog<QFileDialog>([&seen](QFileDialog& dialog) {
      seen = {dialog.directory().absolutePath(), dialog.testOption(QFileDialog::ReadOnly), 1};
      dialog.reject();
    });
  }
  static QString ownFiles() {
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    return documents.exists() ? documents.absolutePath() : QDir::homePath();
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() { end(); }

  void folder_ofWhatTheProgramBrought_isTheUsersOwn() {
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(document().isShipped(quiet::demoPath()));
    QCOMPARE(QDir(window_->files().folder()).absolutePath(), ownFiles());
    QCOMPARE(window_->files().suggestedPath(),
             QDir(window_->files().folder()).filePath(text("corner_cafe_agents.yaml")));
    const QString own = copyOfDemo();
    QVERIFY(window_->open(own));
    QVERIFY(!document().isShipped(own));
    QCOMPARE(window_->files().folder(), QFileInfo(own).absolutePath());
    QCOMPARE(window_->files().suggestedPath(), own);
  }

  /// As for a user who has neither a folder for documents nor opened a file before.
  void open_withoutDocumentsFolder_beginsAtHomeWithoutName() {
    const QByteArray home = qgetenv("HOME");
    const QByteArray configuration = qgetenv("XDG_CONFIG_HOME");
    qputenv("HOME", folder_->path().toUtf8());
    qputenv("XDG_CONFIG_HOME", at("no-configuration").toUtf8());
    QString folder;
    QString name = QStringLiteral("not asked");
    quiet::answerDialog<QFileDialog>([&](QFileDialog& dialog) {
      folder = dialog.directory().absolutePath();
      name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
      dialog.reject();
    });
    window_->actions().open->trigger();
    QDir().mkpath(at("Documents"));
    const QString documents = window_->files().folder();
    qputenv("HOME", home);
    configuration.isEmpty() ? qunsetenv("XDG_CONFIG_HOME")
                            : qputenv("XDG_CONFIG_HOME", configuration);
    QCOMPARE(folder, QDir(folder_->path()).absolutePath());
    QCOMPARE(name, QString());
    QCOMPARE(documents, at("Documents"));
  }

  void dialogs_forReading_deleteNothing() {
    QVERIFY(window_->open(copyOfDemo()));
    Seen seen;
    look(seen);
    window_->actions().open->trigger();
    QCOMPARE(seen.count, 1);
    QVERIFY(seen.isReadOnly);
  }

  void dialogs_forWriting_makeNewFolders() {
    QVERIFY(window_->open(copyOfDemo()));
    Seen seen;
    look(seen);
    window_->actions().saveAs->trigger();
    QCOMPARE(seen.count, 1);
    QVERIFY(!seen.isReadOnly);
    app::Bundle source;
    source.scenario = std::make_shared<const sim2d::Scenario>(document().scenario());
    app::ExportDialog dialog(source, folder_->path(), editor::Theme::light());
    look(seen);
    widgets::withText<QPushButton>(dialog, QString::fromUtf8("C&hoose…"))->click();
    QCOMPARE(seen.count, 1);
    QVERIFY(!seen.isReadOnly);
  }

  void dialogs_forWriting_deleteNothing_data() {
    QTest::addColumn<QString>("view");
    QTest::newRow("list") << text("listView");
    QTest::newRow("details") << text("treeView");
  }
  void dialogs_forWriting_deleteNothing() {
    QFETCH(QString, view);
    const QString precious = folder_->filePath(text("precious.yaml"));
    outside::writeText(precious, "mine");
    QTimer yes;  // to the question that must not come
    connect(&yes, &QTimer::timeout, &yes, [] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        box->button(QMessageBox::Yes)->click();
      }
    });
    yes.start(20);
    bool isEdited = true;
    bool isDeleteOffered = true;
    quiet::answerDialog<QFileDialog>([&](QFileDialog& dialog) {
      const auto leave = qScopeGuard([&dialog] { dialog.reject(); });
      dialog.setViewMode(view == QLatin1String("listView") ? QFileDialog::List
                                                           : QFileDialog::Detail);
      auto& files = *dialog.findChild<QAbstractItemView*>(view);
      const auto rowOf = [&files](const QString& name) {  // the folder is read beside the window
        const QModelIndex first = files.model()->index(0, 0, files.rootIndex());
        return files.model()->match(first, Qt::DisplayRole, name, 1, Qt::MatchExactly).value(0);
      };
      QTRY_VERIFY(rowOf(QFileInfo(precious).fileName()).isValid());
      const QModelIndex row = rowOf(QFileInfo(precious).fileName());
      files.setFocus();
      files.setCurrentIndex(row);
      QTest::keyClick(&files, Qt::Key_F2);
      isEdited = files.indexWidget(row) != nullptr;
      QTest::keyClick(&files, Qt::Key_Delete);
      isDeleteOffered = dialog.findChild<QAction*>(text("qt_delete_action"))->isVisible();
    });
    QVERIFY(window_->open(copyOfDemo()));
    window_->actions().saveAs->trigger();
    QCOMPARE(outside::bytesOf(precious), QByteArray("mine"));
    QVERIFY(!isEdited && !isDeleteOffered);
  }

  /// The editor of the name is closed first: Qt would use it after it is gone.
  void dialogs_forWriting_leavingTheFolderWhileANewOneIsNamed() {
    for (const QFileDialog::ViewMode mode : {QFileDialog::Detail, QFileDialog::List}) {
      QTemporaryDir top;
      const QString below = top.filePath(text("below"));
      QVERIFY(QDir().mkpath(below));
      QFileDialog dialog(nullptr, {}, below);
      dialog.setOption(QFileDialog::DontUseNativeDialog);
      dialog.setAcceptMode(QFileDialog::AcceptSave);
      dialog.setViewMode(mode);
      editor::restrictFileDialog(dialog, true);
      dialog.show();
      const auto button = [&dialog](const char* name) {
        return dialog.findChild<QToolButton*>(QString::fromUtf8(name));
      };
      const auto* files = dialog.findChild<QAbstractItemView*>(
          mode == QFileDialog::Detail ? text("treeView") : text("listView"));
      const auto editors = [files] { return files->viewport()->findChildren<QLineEdit*>(); };
      QTest::mouseClick(button("newFolderButton"), Qt::LeftButton);
      QTRY_COMPARE(editors().size(), 1);
      editors().front()->setText(text("mine"));
      QTest::mousePress(button("toParentButton"), Qt::LeftButton);
      QTRY_VERIFY(editors().isEmpty());
      QTest::mouseRelease(button("toParentButton"), Qt::LeftButton);
      QCOMPARE(dialog.directory().canonicalPath(), QFileInfo(top.path()).canonicalFilePath());
      QVERIFY(QDir(below + text("/mine")).exists());
    }
  }

  /// The dialog that tells it runs when nothing uses the editor any more, which may be gone by
  /// then.
  void dialogs_forWriting_namesThatCannotBe_areToldAfterwards() {
    QTemporaryDir top;
    QFileDialog dialog(nullptr, {}, top.path());
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setViewMode(QFileDialog::Detail);
    editor::restrictFileDialog(dialog, true);
    dialog.show();
    const auto* files = dialog.findChild<QAbstractItemView*>(text("treeView"));
    const auto editors = [files] { return files->viewport()->findChildren<QLineEdit*>(); };
    QTest::mouseClick(dialog.findChild<QToolButton*>(text("newFolderButton")), Qt::LeftButton);
    QTRY_COMPARE(editors().size(), 1);
    editors().front()->setText(text("a/b"));
    bool isPressing = true;
    bool wasTold = false;
    bool wasInUse = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        wasTold = true;
        wasInUse = wasInUse || isPressing || !editors().isEmpty();
        box->accept();
      }
    });
    look.start(1);
    QTest::mousePress(dialog.findChild<QToolButton*>(text("toParentButton")), Qt::LeftButton);
    isPressing = false;
    QTRY_VERIFY(wasTold);
    QVERIFY(!wasInUse);
    QTest::mouseRelease(dialog.findChild<QToolButton*>(text("toParentButton")), Qt::LeftButton);
  }

  void treeDialogs_beginWithTheUsersFiles_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<bool>("isReading");
    QTest::newRow("open") << text("Load a tree from a file") << true;
    QTest::newRow("save") << text("Save the tree to a file") << false;
  }
  void treeDialogs_beginWithTheUsersFiles() {
    QFETCH(QString, button);
    QFETCH(bool, isReading);
    QVERIFY(window_->open(quiet::demoPath()));
    document().setSelection({document().entities(base::EntityKind::Human).front()});
    Seen seen;
    look(seen);
    quiet::part<QToolButton>(window_->docks().panel<editor::BehaviorPanel>(),
                             button.toUtf8().constData())
        .click();
    QCOMPARE(seen.count, 1);
    QVERIFY2(!document().isShipped(seen.folder + text("/tree.xml")), qPrintable(seen.folder));
    QCOMPARE(seen.isReadOnly, isReading);
  }

  void heightOnScreen_fitsTheScreen() {
    QCOMPARE(editor::limitedToScreen(*window_, 100), 100);
    QVERIFY(editor::limitedToScreen(*window_, 100000) <
            window_->screen()->availableGeometry().height());
  }
};

QTEST_MAIN(FileDialogsTest)
#include "tst_FileDialogs.moc"
