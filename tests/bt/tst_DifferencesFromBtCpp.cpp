#include "tests/bt/TreeProbe.h"

/// Notes of `check` on a tree that BehaviorTree.CPP 4.10 runs differently: each row of the table in
/// bt/engine/README.md that a file can show.
class DifferencesFromBtCppTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void notes_tree_areThoseOfTheTable_data();
  void notes_tree_areThoseOfTheTable();
  void notes_areNoPartOfOtherCompilations();
};

namespace {

void row(const char* name, const std::string& xml, const char* notes) {
  QTest::newRow(name) << QString::fromStdString(xml) << QString::fromUtf8(notes);
}

std::string withSubTree(const char* call, const char* below) {
  return std::string("<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'>") +
         call + "</BehaviorTree><BehaviorTree ID='Sub'>" + below + "</BehaviorTree></root>";
}

/// "tree.there-stale:1 tree.there-clock:0"
QString notesOn(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(probe::fileOf(xml), "t.xml");
  const base::Result<bt::TreeTable> table = bt::resolveIncludes(*file);
  QStringList codes;
  for (const base::Diagnostic& note : bt::differencesFromBtCpp(*table, probe::library())) {
    codes << QString::fromStdString(std::string(note.code)) + QLatin1Char(':') +
                 QString::number(note.line);
  }
  return codes.join(QLatin1Char(' '));
}

}  // namespace

void DifferencesFromBtCppTest::notes_tree_areThoseOfTheTable_data() {
  QTest::addColumn<QString>("xml");
  QTest::addColumn<QString>("notes");
  row("if, a stateful condition", "<IfThenElse><St/><S/></IfThenElse>", "tree.there-stale:1");
  row("if, a condition with a pre-condition", "<IfThenElse><F _skipIf='0'/><S/></IfThenElse>",
      "tree.there-stale:1");
  row("if, a stateful node in the condition",
      "<IfThenElse>\n<Inverter><St/></Inverter><S/></IfThenElse>", "tree.there-stale:1");
  row("if, a plain condition", "<IfThenElse><Inverter><F/></Inverter><S/></IfThenElse>", "");
  row("if, three children", "<IfThenElse><St/><S/><S/></IfThenElse>", "");
  row("while, two children", "<WhileDoElse><St/><S/></WhileDoElse>", "");
  row("times, once for a file",
      "<Sequence><Sleep msec='5'/><Delay delay_msec='5'><S/></Delay></Sequence>",
      "tree.there-clock:0");
  row("constant of a SubTree for a real",
      withSubTree("<SubTree ID='Sub' x='7'/>", "<ReadDouble value='{x}'/>"),
      "tree.there-refused:1");
  row("constant of a SubTree, written as a real",
      withSubTree("<SubTree ID='Sub' x='7.0'/>", "<ReadDouble value='{x}'/>"), "");
  row("constant of a SubTree, whole",
      withSubTree("<SubTree ID='Sub' x='7'/>", "<ReadInt value='{x}'/>"), "");
  row("text to an entry of a script",
      "<Sequence><Script code='k := 1'/>\n<SetBlackboard value='5' output_key='k'/></Sequence>",
      "tree.there-emptied:2");
  row("text to an entry of a typed port",
      "<Sequence><Script code='k := 1'/><SetBlackboard value='5' output_key='k'/>"
      "<ReadInt value='{k}'/></Sequence>",
      "");
  row("text to an entry of its own", "<SetBlackboard value='5' output_key='k'/>", "");
  row("removed, and given to a SubTree",
      withSubTree("<Sequence><SubTree ID='Sub' x='{a}'/>\n<UnsetBlackboard key='a'/></Sequence>",
                  "<Script code='x := 1'/>"),
      "tree.there-kept:2");
  row("removed, and given to nothing", "<UnsetBlackboard key='a'/>", "");
  row("a queue is copied",
      "<Sequence><LoopInt queue='{q}' value='{v}'><S/></LoopInt>\n"
      "<SetBlackboard value='{q}' output_key='m'/></Sequence>",
      "tree.there-shared:2");
}

void DifferencesFromBtCppTest::notes_tree_areThoseOfTheTable() {
  QFETCH(QString, xml);
  QFETCH(QString, notes);
  QCOMPARE(notesOn(xml.toStdString()), notes);
}

/// They are for users who export a tree, not for users who run it.
void DifferencesFromBtCppTest::notes_areNoPartOfOtherCompilations() {
  const auto program = probe::compiled("<IfThenElse><St/><S/></IfThenElse>");
  QVERIFY(program);
  QVERIFY(program.diagnostics().empty());
}

QTEST_APPLESS_MAIN(DifferencesFromBtCppTest)
#include "tst_DifferencesFromBtCpp.moc"
