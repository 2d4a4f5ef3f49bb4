#include "tests/bt/TraceRows.h"

using traces::checkRow;
using traces::columns;
using traces::row;

namespace {

void rowsOfSequences() {
  row("sequence stops at failure", "<Sequence><S name='a'/><F/><S name='c'/></Sequence>",
      "a F -> FAILURE|a F -> FAILURE");
  row("sequence goes on at the running child",
      "<Sequence><S name='a'/><St/><S name='c'/></Sequence>",
      "a start -> RUNNING|run1 c -> SUCCESS|a start -> RUNNING");
  row("fallback stops at success", "<Fallback><F/><S name='b'/><S name='c'/></Fallback>",
      "F b -> SUCCESS|F b -> SUCCESS");
  row("fallback, all fail", "<Fallback><F name='a'/><F name='b'/></Fallback>", "a b -> FAILURE");
  row("fallback, one skipped and the rest failed",
      "<Fallback><RunOnce><F name='a'/></RunOnce><F name='b'/></Fallback>",
      "a b -> FAILURE|b -> FAILURE");
  row("fallback, all skipped",
      "<Fallback><RunOnce><F name='a'/></RunOnce><RunOnce><F name='b'/></RunOnce></Fallback>",
      "a b -> FAILURE|-> SKIPPED|-> SKIPPED");
  row("async sequence yields after each success",
      "<AsyncSequence><S name='a'/><S name='b'/></AsyncSequence>",
      "a -> RUNNING|b -> SUCCESS|a -> RUNNING");
  row("async sequence does not yield after a stateful child",
      "<AsyncSequence><St/><S name='b'/><S name='c'/></AsyncSequence>",
      "start -> RUNNING|run1 b -> RUNNING|c -> SUCCESS");
  row("async fallback yields after each failure",
      "<AsyncFallback><F name='a'/><F name='b'/><S name='c'/></AsyncFallback>",
      "a -> RUNNING|b -> RUNNING|c -> SUCCESS");
  row("sequence with memory resumes at the failed child, also halted",
      "<ReactiveFallback><Inverter><RunOnce then_skip='false'><S name='x'/></RunOnce></Inverter>"
      "<SequenceWithMemory><S name='a'/><F name='b'/></SequenceWithMemory></ReactiveFallback>",
      "x a -> RUNNING|b -> FAILURE|b -> FAILURE");
  row("sequence with memory goes over skipped children",
      "<SequenceWithMemory><RunOnce><S name='a'/></RunOnce><S name='b'/></SequenceWithMemory>",
      "a -> RUNNING|b -> SUCCESS|b -> SUCCESS");
  row("reactive sequence asks again and halts",
      "<ReactiveSequence><RetryUntilSuccessful num_attempts='1'><RunOnce><S name='c'/></RunOnce>"
      "</RetryUntilSuccessful><St runs='3'/></ReactiveSequence>",
      "c start -> RUNNING|run1 -> RUNNING|run2 -> RUNNING|run3 -> SUCCESS");
  row("reactive sequence halts later children",
      "<ReactiveSequence><Script code='n := 1'/><St name='a' runs='1' _while='n &gt; 5'/>"
      "</ReactiveSequence>",
      "-> SUCCESS|-> SUCCESS");
  row("reactive sequence, failing condition halts the running child",
      "<ReactiveSequence><Repeat num_cycles='1'><AlwaysSuccess _failureIf='@n &gt; 1'/></Repeat>"
      "<Script code='n := 2'/><St runs='9'/></ReactiveSequence>",
      "!no value");
  row("reactive sequence, all skipped",
      "<ReactiveSequence><RunOnce><S name='a'/></RunOnce><RunOnce><S name='b'/></RunOnce>"
      "</ReactiveSequence>",
      "a b -> SUCCESS|-> SKIPPED|-> SKIPPED");
  row("reactive fallback, an earlier success halts",
      "<ReactiveFallback><TD delay='0.2'><S name='t'/></TD><St runs='9'/></ReactiveFallback>",
      "start -> RUNNING|run1 -> RUNNING|t halt -> SUCCESS|t -> SUCCESS");
}

void rowsOfParallels() {
  row("parallel needs all", "<Parallel><S name='a'/><St/><S name='c'/></Parallel>",
      "a start c -> RUNNING|run1 -> SUCCESS|a start c -> RUNNING");
  row("parallel, one failure ends it", "<Parallel><St runs='9'/><F/><S name='c'/></Parallel>",
      "start F halt -> FAILURE|start F halt -> FAILURE");
  row("parallel, negative threshold", "<Parallel success_count='-2'><F/><S/><S/></Parallel>",
      "F -> FAILURE");
  row("parallel, negative thresholds, enough succeed",
      "<Parallel success_count='-2' failure_count='-1'><F/><S name='a'/><S name='b'/></Parallel>",
      "F a b -> SUCCESS");
  row("parallel, success is not possible any more",
      "<Parallel success_count='2' failure_count='3'><F name='a'/><F name='b'/><S name='c'/>"
      "</Parallel>",
      "a b -> FAILURE");
  row("parallel, all skipped and a positive threshold",
      "<Parallel success_count='1'><AlwaysSuccess _skipIf='1'/><AlwaysSuccess _skipIf='1'/>"
      "</Parallel>",
      "-> SKIPPED|-> SKIPPED");
  row("parallel, skipped counts as success when negative",
      "<Parallel><AlwaysSuccess _skipIf='1'/><S/></Parallel>", "S -> SUCCESS");
  row("parallel, threshold too large", "<Parallel success_count='3'><S/><S/></Parallel>",
      "!success_count");
  row("parallel, the counts are read before the first child",
      "<Parallel success_count='1' failure_count='2'><S/></Parallel>", "!failure_count");
  row("parallel forgets when halted",
      "<ReactiveFallback><TD delay='0.2'><S name='t'/></TD><Parallel><S name='a'/><St runs='9'/>"
      "</Parallel></ReactiveFallback>",
      "a start -> RUNNING|run1 -> RUNNING|t halt -> SUCCESS");
  row("parallel-all waits for all", "<ParallelAll><F/><St/><S name='c'/></ParallelAll>",
      "F start c -> RUNNING|run1 -> FAILURE|F start c -> RUNNING");
  row("parallel-all, failures allowed", "<ParallelAll max_failures='2'><F/><S/></ParallelAll>",
      "F S -> SUCCESS|F S -> SUCCESS");
  row("parallel-all, negative",
      "<ParallelAll max_failures='-1'><F name='a'/><F name='b'/></ParallelAll>", "a b -> FAILURE");
  row("parallel-all, too large", "<ParallelAll max_failures='3'><S/></ParallelAll>",
      "!max_failures");
  row("parallel-all, all skipped", "<ParallelAll><AlwaysSuccess _skipIf='1'/></ParallelAll>",
      "-> SKIPPED");
  row("parallel-all, one skipped", "<ParallelAll><AlwaysSuccess _skipIf='1'/><S/></ParallelAll>",
      "S -> SUCCESS");
}

void rowsOfConditions() {
  row("if, then", "<IfThenElse><S name='c'/><St/><S name='e'/></IfThenElse>",
      "c start -> RUNNING|run1 -> SUCCESS|c start -> RUNNING");
  row("if, else", "<IfThenElse><F name='c'/><S name='t'/><St/></IfThenElse>",
      "c start -> RUNNING|run1 -> SUCCESS");
  row("if, no else", "<IfThenElse><F name='c'/><S name='t'/></IfThenElse>",
      "c -> FAILURE|c -> FAILURE");
  row("if, running condition", "<IfThenElse><St/><S name='t'/></IfThenElse>",
      "start -> RUNNING|run1 t -> SUCCESS|start -> RUNNING");
  row("if, skipped condition", "<IfThenElse><AlwaysSuccess _skipIf='1'/><S/></IfThenElse>",
      "!SKIPPED");
  row("while, condition changes",
      "<WhileDoElse><Inverter><TD delay='0.2'><S name='t'/></TD></Inverter><St runs='9'/>"
      "<S name='e'/></WhileDoElse>",
      "start -> RUNNING|run1 -> RUNNING|t halt e -> SUCCESS");
  row("while, two children",
      "<WhileDoElse><Inverter><TD delay='0.2'><S name='t'/></TD></Inverter><St runs='9'/>"
      "</WhileDoElse>",
      "start -> RUNNING|run1 -> RUNNING|t halt -> FAILURE");
  row("while, two children, a stateful condition is asked anew",
      "<WhileDoElse><St result='FAILURE'/><S name='t'/></WhileDoElse>",
      "start -> RUNNING|run1 -> FAILURE|start -> RUNNING|run1 -> FAILURE");
  row("while, skipped condition", "<WhileDoElse><AlwaysSuccess _skipIf='1'/><S/></WhileDoElse>",
      "!SKIPPED");
}

void rowsOfSwitchAndTry() {
  row("switch by text",
      "<Sequence><Script code=\"v := 'b'\"/><Switch2 variable='{v}' case_1='a' case_2='b'>"
      "<S name='1'/><S name='2'/><S name='d'/></Switch2></Sequence>",
      "2 -> SUCCESS|2 -> SUCCESS");
  row("switch by number",
      "<Sequence><Script code='v := 2'/><Switch3 variable='{v}' case_1='1' case_2='2.0' case_3='3'>"
      "<S name='1'/><S name='2'/><S name='3'/><S name='d'/></Switch3></Sequence>",
      "2 -> SUCCESS");
  row("switch, no match",
      "<Switch2 variable='x' case_1='a' case_2='b'><S name='1'/><S name='2'/>"
      "<S name='d'/></Switch2>",
      "d -> SUCCESS");
  row("switch, no variable",
      "<Switch2 case_1='a' case_2='b'><S name='1'/><S name='2'/>"
      "<S name='d'/></Switch2>",
      "d -> SUCCESS");
  row("switch halts the child that ran before",
      "<Sequence><Script code='v := 1' _skipIf='@v == 1'/></Sequence>", "!no value");
  row("switch changes over",
      "<Parallel success_count='2'><Switch2 variable='{v}' case_1='1' case_2='2'><S name='1'/>"
      "<S name='2'/><St runs='9'/></Switch2><Script code='v := 2'/></Parallel>",
      "start -> RUNNING|halt 2 -> SUCCESS");
  row("try, no failure", "<TryCatch><S name='a'/><St/><S name='c'/></TryCatch>",
      "a start -> RUNNING|run1 -> SUCCESS|a start -> RUNNING");
  row("try, failure", "<TryCatch><S name='a'/><F/><S name='b'/><St/></TryCatch>",
      "a F start -> RUNNING|run1 -> FAILURE|a F start -> RUNNING");
  row("try, halted",
      "<ReactiveFallback><TD delay='0.1'><S name='t'/></TD><TryCatch catch_on_halt='true'>"
      "<St runs='9'/><S name='clean'/></TryCatch></ReactiveFallback>",
      "start -> RUNNING|t halt clean -> SUCCESS");
  row("try, halted without catch",
      "<ReactiveFallback><TD delay='0.1'><S name='t'/></TD><TryCatch><St runs='9'/>"
      "<S name='clean'/></TryCatch></ReactiveFallback>",
      "start -> RUNNING|t halt -> SUCCESS");
  row("try, all skipped", "<TryCatch><AlwaysSuccess _skipIf='1'/><S/></TryCatch>", "-> SKIPPED");
}

void rowsOfSetting() {
  row("always", "<Fallback><AlwaysFailure/><AlwaysSuccess/></Fallback>", "-> SUCCESS");
  row("set a constant",
      "<Sequence><SetBlackboard value='5' output_key='k'/><ReadInt value='{k}'/>"
      "</Sequence>",
      "5 -> SUCCESS");
  row("set, the key is in an entry",
      "<Sequence><SetBlackboard value='other' output_key='k'/>"
      "<SetBlackboard value='x y' output_key='{k}'/><ReadText value='{other}'/><ReadText "
      "value='{k}'/></Sequence>",
      "x y other -> SUCCESS");
  row("set, the key is in an entry, which nobody uses",
      "<Sequence><SetBlackboard value='other' output_key='k'/>"
      "<SetBlackboard value='x y' output_key='{k}'/></Sequence>",
      "-> SUCCESS");
  row("set, the key is in an entry without a value",
      "<SetBlackboard value='x y' output_key='{k}'/>", "!'output_key' is missing");
  row("set copies with the type",
      "<Sequence><Put value='{a}' number='7'/><SetBlackboard value='{a}' output_key='b'/>"
      "<ReadInt value='{b}'/></Sequence>",
      "7 -> SUCCESS");
  row("set, missing entry", "<SetBlackboard value='{nothing}' output_key='b'/>", "-> FAILURE");
  row("set, removed entry",
      "<Sequence><SetBlackboard value='1' output_key='a'/><UnsetBlackboard key='a'/>"
      "<SetBlackboard value='{a}' output_key='b'/></Sequence>",
      "!does not exist");
  row("set, true",
      "<Sequence><SetBlackboard value='true' output_key='flag'/>"
      "<ScriptCondition code='flag == true'/></Sequence>",
      "-> SUCCESS");
  row("set, empty entry",
      "<Sequence><SetBlackboard value='{a}' output_key='b'/><Put value='{a}'/></Sequence>",
      "-> FAILURE");
  row("set, wrong type",
      "<Sequence><SetBlackboard value='abc' output_key='k'/><ReadInt value='{k}'/></Sequence>",
      "!does not fit");
  row("set, no value", "<SetBlackboard output_key='k'/>", "!'value' is missing");
  row("unset",
      "<Sequence><SetBlackboard value='5' output_key='k'/><UnsetBlackboard key='k'/>"
      "<ReadInt value='{k}'/></Sequence>",
      "!'value' is missing");
  row("unset, the next one may have another type",
      "<Sequence><Put value='{k}' number='7'/><ReadInt value='{k}'/><UnsetBlackboard key='k'/>"
      "<Script code=\"k := 'abc'\"/><ScriptCondition code=\"k == 'abc'\"/></Sequence>",
      "7 -> SUCCESS");
  row("unset, the key is in an entry",
      "<Sequence><SetBlackboard value='5' output_key='a'/><SetBlackboard value='a' output_key='k'/>"
      "<UnsetBlackboard key='{k}'/><ReadText value='{k}'/><ReadInt value='{a}'/></Sequence>",
      "!'value' is missing");
  row("real to an empty entry for a whole number",
      "<Sequence><Script code='n := 2.5'/><ScriptCondition code='n == 2.5'/><ReadInt value='{n}'/>"
      "</Sequence>",
      "!does not fit");
}

/// As BehaviorTree.CPP 4.10 keeps the types of entries.
void rowsOfTypes() {
  row("a script's real for a port of whole numbers that is skipped",
      "<Sequence><Script code='d := 0.5'/><Repeat num_cycles='{d}' _skipIf='true'><S/></Repeat>"
      "</Sequence>",
      "-> SUCCESS|-> SUCCESS|-> SUCCESS");
  row("a whole number stays one", "<Script code='n := 1; n := 0.5'/>", "!does not fit");
  row("a whole number takes a whole real",
      "<Sequence><Script code='n := 1; n := 4.0 / 2'/><ReadText value='{n}'/></Sequence>",
      "2 -> SUCCESS");
  row("a real is text with six digits",
      "<Sequence><Script code='n := 0.5'/><ReadText value='{n}'/></Sequence>",
      "0.500000 -> SUCCESS");
  row("a real output to a whole number of a script",
      "<Sequence><Script code='n := 2'/><LoopDouble queue='0.5' value='{n}'><S/></LoopDouble>"
      "</Sequence>",
      "!does not fit");
  row("a whole output to a whole number of a script",
      "<Sequence><Script code='n := 2'/><LoopDouble queue='3' value='{n}'><ReadDouble value='{n}'/>"
      "</LoopDouble></Sequence>",
      "3 -> RUNNING");
  row("an output to an entry of text",
      "<Sequence><ForceSuccess><S _skipIf='true'/></ForceSuccess><ForceSuccess><Sequence>"
      "<AlwaysFailure/><ReadText value='{n}'/></Sequence></ForceSuccess><Put value='{n}'/>"
      "</Sequence>",
      "!does not fit");
  row("set, a number of a script is no int",
      "<Sequence><Script code='a := 3'/><SetBlackboard value='{a}' output_key='n'/>"
      "<ReadInt value='{n}'/></Sequence>",
      "!a different type");
  row("set, a real of a script is a double",
      "<Sequence><Script code='a := 0.5'/><SetBlackboard value='{a}' output_key='n'/>"
      "<ReadDouble value='{n}'/></Sequence>",
      "0.5 -> SUCCESS");
  row("set, a number of a script to a new entry",
      "<Sequence><Script code='a := 3'/><SetBlackboard value='{a}' output_key='n'/>"
      "<ScriptCondition code='n == 3'/></Sequence>",
      "-> SUCCESS|-> SUCCESS");
  row("set, text to an entry that a script made",
      "<Sequence><Script code=\"a := 'x'\"/><SetBlackboard value='5' output_key='a'/>"
      "<ScriptCondition code='a == 5'/></Sequence>",
      "-> SUCCESS");
  row("precondition, its other result is read first",
      "<Precondition if='true' else='{k}'><S/></Precondition>", "!'else' is missing");
}

void rowsOfOtherLeaves() {
  row("empty script", "<Script code=''/>", "-> SUCCESS");
  row("empty condition", "<ScriptCondition code=''/>", "!'code' is missing");
  row("condition of text", "<ScriptCondition code=\"'1'\"/>", "!text, not true or false");
  row("condition of no number", "<ScriptCondition code='0 / 0'/>", "-> SUCCESS");
  row("condition of a real", "<ScriptCondition code='0.5'/>", "-> SUCCESS");
  row("condition of a whole number", "<ScriptCondition code='2'/>", "!gives 2, not true or false");
  row("condition of what was computed", "<ScriptCondition code='1 + 1'/>", "-> SUCCESS");
  row("pre-condition of text", "<S _skipIf=\"'1'\"/>", "!text, not true or false");
  row("script",
      "<Sequence><Script code='n := 2; n *= 3'/><ScriptCondition code='n == 6'/>"
      "<ReadDouble value='{n}'/></Sequence>",
      "6 -> SUCCESS");
  row("script condition, false", "<ScriptCondition code='1 &gt; 2'/>", "-> FAILURE");
  row("script, no code", "<Script/>", "!'code' is missing");
  row("sleep", "<Sleep msec='200'/>", "-> RUNNING|-> RUNNING|-> SUCCESS|-> RUNNING");
  row("sleep between the steps", "<Sleep msec='150'/>", "-> RUNNING|-> RUNNING|-> SUCCESS");
  row("sleep 0", "<Sleep msec='0'/>", "-> SUCCESS|-> SUCCESS");
  row("entry updated",
      "<Sequence><RunOnce><SetBlackboard value='5' output_key='k'/></RunOnce>"
      "<WasEntryUpdated entry='{k}'/></Sequence>",
      "-> SUCCESS|-> FAILURE|-> FAILURE");
  row("missing input", "<ReadInt/>", "!'value' is missing");
  row("input of the wrong type",
      "<Sequence><Script code=\"k := 'abc'\"/><ReadInt value='{k}'/></Sequence>", "!does not fit");
  row("trailing characters", "<ReadInt value='5abc'/>", "5 -> SUCCESS");
  row("output without a reference", "<Put value='5'/>", "-> FAILURE");
  row("entry updated, declared and never written", "<WasEntryUpdated entry='{k}'/>",
      "-> SUCCESS|-> FAILURE");
  row("entry updated, no such entry", "<WasEntryUpdated entry='k'/>", "-> FAILURE|-> FAILURE");
  row("entry updated, removed and made again: written as often as before",
      "<Sequence><SetBlackboard value='5' output_key='k'/><WasEntryUpdated entry='k'/>"
      "<UnsetBlackboard key='k'/></Sequence>",
      "-> SUCCESS|-> FAILURE");
}

}  // namespace

/// Control nodes, leaves and conditions: what is called and returned in each step.
class ControlsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_control_givesTrace_data() {
    columns();
    rowsOfSequences();
    rowsOfParallels();
    rowsOfConditions();
    rowsOfSwitchAndTry();
  }

  void tick_control_givesTrace() { checkRow(); }

  void tick_leaf_givesTrace_data() {
    columns();
    rowsOfSetting();
    rowsOfTypes();
    rowsOfOtherLeaves();
  }

  void tick_leaf_givesTrace() { checkRow(); }

  void tick_condition_givesTrace_data() {
    columns();
    row("failure first", "<S _failureIf='1' _successIf='1' _skipIf='1'/>", "-> FAILURE");
    row("success before skip", "<S _failureIf='0' _successIf='1' _skipIf='1'/>", "-> SUCCESS");
    row("skip", "<S _skipIf='1'/>", "-> SKIPPED|-> SKIPPED");
    row("nothing fires", "<S _skipIf='0'/>", "S -> SUCCESS");
    row("while, at the start", "<S _while='0'/>", "-> SKIPPED");
    row("while, running",
        "<Sequence><Script code='n := 0'/><ReactiveSequence><Script code='n += 1'/>"
        "<St runs='9' _while='n &lt; 3'/></ReactiveSequence></Sequence>",
        "start -> RUNNING|run1 -> RUNNING|halt -> SUCCESS");
    row("pre-conditions are asked only at the start",
        "<Sequence><Script code='n := 0'/><ReactiveSequence><Script code='n += 1'/>"
        "<St runs='2' _failureIf='n &gt; 1'/></ReactiveSequence></Sequence>",
        "start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS");
    row("post scripts",
        "<Sequence><Script code='a := 0; b := 0; c := 0'/>"
        "<S _onSuccess='a := 1' _onFailure='b := 1' _post='c := a + 1'/>"
        "<ScriptCondition code='a == 1 &amp;&amp; b == 0 &amp;&amp; c == 2'/></Sequence>",
        "S -> SUCCESS");
    row("post scripts of a failure",
        "<Sequence><Script code='a := 0; b := 0; c := 0'/>"
        "<ForceSuccess><F _onSuccess='a := 1' _onFailure='b := 1' _post='c := 1'/></ForceSuccess>"
        "<ScriptCondition code='a == 0 &amp;&amp; b == 1 &amp;&amp; c == 1'/></Sequence>",
        "F -> SUCCESS");
    row("script when halted",
        "<Sequence><Script code='h := 0'/><ForceSuccess><Timeout msec='100'>"
        "<St runs='9' _onHalted='h := 1'/></Timeout></ForceSuccess><ScriptCondition code='h == 1'/>"
        "</Sequence>",
        "start -> RUNNING|halt -> SUCCESS");
    row("post script after a pre-condition",
        "<Sequence><S _successIf='1' _onSuccess='a := 3'/><ReadDouble value='{a}'/></Sequence>",
        "3 -> SUCCESS");
    row("composite that skipped is halted by its parent",
        "<Sequence><Script code='h := 0'/><Sequence _onHalted='h := 1'><AlwaysSuccess _skipIf='1'/>"
        "</Sequence></Sequence>",
        "-> SUCCESS|-> SUCCESS");
    row("text as a condition", "<S _skipIf=\"'a'\"/>", "!text");
  }

  void tick_condition_givesTrace() { checkRow(); }

  void tick_faultyTree_staysIdle() {
    probe::Run run("<Parallel><St runs='9'/><Repeat><S/></Repeat></Parallel>");
    QVERIFY2(run.state, run.problems.c_str());
    QCOMPARE(QString::fromStdString(run.trace()), QStringLiteral("start halt -> IDLE"));
    QVERIFY(run.state->fault());
    QVERIFY(run.state->fault()->path == "Parallel/Repeat");
    for (const base::NodeStatus status : run.state->statuses()) {
      QVERIFY(status == base::NodeStatus::Idle);
    }
    QCOMPARE(run.trace(), std::string("-> IDLE"));
    run.state->reset();
    QVERIFY(!run.state->fault());
    QCOMPARE(run.trace(), std::string("start halt -> IDLE"));
  }
};

QTEST_APPLESS_MAIN(ControlsTest)
#include "tst_Controls.moc"
