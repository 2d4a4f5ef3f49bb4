#include "tests/bt/TraceRows.h"

/// Decorators: what is called and returned in each step.
class DecoratorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_decorator_givesTrace_data();
  void tick_decorator_givesTrace();
};

using traces::row;

namespace {

void rowsOfRepetition() {
  row("inverter", "<Inverter><St result='FAILURE'/></Inverter>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("force success", "<ForceSuccess><F/></ForceSuccess>", "F -> SUCCESS");
  row("force failure", "<ForceFailure><St/></ForceFailure>", "start -> RUNNING|run1 -> FAILURE");
  row("force, skipped", "<ForceSuccess><AlwaysSuccess _skipIf='1'/></ForceSuccess>", "-> SKIPPED");
  row("repeat 0", "<Repeat num_cycles='0'><S/></Repeat>", "-> SUCCESS");
  row("repeat, failure", "<Repeat num_cycles='3'><F/></Repeat>", "F -> FAILURE");
  row("repeat a stateful child", "<Repeat num_cycles='2'><St/></Repeat>",
      "start -> RUNNING|run1 start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("repeat for ever", "<Repeat num_cycles='-1'><S/></Repeat>", "S -> RUNNING|S -> RUNNING");
  row("repeat, skipped", "<Repeat num_cycles='2'><RunOnce><S/></RunOnce></Repeat>",
      "S -> RUNNING|-> SKIPPED|-> SKIPPED");
  row("repeat, no port", "<Repeat><S/></Repeat>", "!'num_cycles' is missing");
  row("repeat forgets when halted",
      "<ReactiveFallback><TD delay='0.1'><F name='t'/></TD><Repeat num_cycles='2'><S/></Repeat>"
      "</ReactiveFallback>",
      "S -> RUNNING|t S -> SUCCESS|t S -> RUNNING");
  row("retry 0", "<RetryUntilSuccessful num_attempts='0'><S/></RetryUntilSuccessful>",
      "-> FAILURE");
  row("retry, success", "<RetryUntilSuccessful num_attempts='5'><S/></RetryUntilSuccessful>",
      "S -> SUCCESS");
  row("retry, skipped",
      "<RetryUntilSuccessful num_attempts='5'><AlwaysSuccess _skipIf='1'/></RetryUntilSuccessful>",
      "-> SKIPPED");
  row("keep running, failure",
      "<KeepRunningUntilFailure><St result='FAILURE'/>"
      "</KeepRunningUntilFailure>",
      "start -> RUNNING|run1 -> FAILURE|start -> RUNNING");
  row("keep running, skipped",
      "<KeepRunningUntilFailure><AlwaysSuccess _skipIf='1'/></KeepRunningUntilFailure>",
      "-> RUNNING|-> RUNNING");
}

void rowsOfDelays() {
  row("delay", "<Delay delay_msec='200'><S/></Delay>",
      "-> RUNNING|-> RUNNING|S -> SUCCESS|-> RUNNING|-> RUNNING|S -> SUCCESS");
  row("delay of a stateful child", "<Delay delay_msec='100'><St/></Delay>",
      "-> RUNNING|start -> RUNNING|run1 -> SUCCESS|-> RUNNING");
  row("delay 0", "<Delay delay_msec='0'><S/></Delay>", "S -> SUCCESS");
  row("delay, halted while it waits",
      "<ReactiveFallback><TD delay='0.1'><S name='t'/></TD><Delay delay_msec='200'><S/></Delay>"
      "</ReactiveFallback>",
      "-> RUNNING|t -> SUCCESS|t -> SUCCESS");
  row("timeout", "<Timeout msec='200'><St runs='9'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|halt -> FAILURE|start -> RUNNING");
  row("timeout, soon enough", "<Timeout msec='300'><St runs='2'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS|start -> RUNNING");
  row("timeout 0", "<Timeout msec='0'><St runs='2'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS");
  row("run once, halted before it was done",
      "<ReactiveFallback><TD delay='0.1'><F name='t'/></TD><RunOnce><St runs='2'/></RunOnce>"
      "<S name='e'/></ReactiveFallback>",
      "start -> RUNNING|t run1 -> RUNNING|t run2 -> SUCCESS|t e -> SUCCESS");
  row("run once, interrupted",
      "<ReactiveSequence><Repeat num_cycles='1'><Script code='n += "
      "1'/></Repeat></ReactiveSequence>",
      "!does not exist");
  row("precondition, true", "<Precondition if='1 == 1'><St/></Precondition>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("precondition, false", "<Precondition if='1 == 2'><S/></Precondition>", "-> FAILURE");
  row("precondition, else", "<Precondition if='1 == 2' else='SKIPPED'><S/></Precondition>",
      "-> SKIPPED");
  row("precondition is not asked again",
      "<Sequence><Script code='n := 1' _onSuccess='n := 1'/><Precondition if='n == 1'>"
      "<Sequence><Script code='n := 2'/><St/></Sequence></Precondition></Sequence>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
}

void rowsOfEntries() {
  row("loop over a constant", "<LoopInt queue='4;5' value='{v}'><ReadInt value='{v}'/></LoopInt>",
      "4 -> RUNNING|5 -> RUNNING|-> SUCCESS|4 -> RUNNING|5 -> RUNNING|-> SUCCESS");
  row("loop, halted",
      "<Timeout msec='200'><LoopInt queue='4;5;6' value='{v}'><Sequence><ReadInt value='{v}'/>"
      "<St runs='2'/></Sequence></LoopInt></Timeout>",
      "4 start -> RUNNING|run1 -> RUNNING|halt -> FAILURE|4 start -> RUNNING");
  row("loop over an entry, from which the elements are taken",
      "<Sequence><RunOnce><Script code=\"q := '1;2'\"/></RunOnce>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|-> SUCCESS");
  row("loop over an entry that is written again",
      "<Sequence><Script code=\"q := '1;2'\"/>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|1 -> RUNNING");
  row("loop over an entry that SetBlackboard fills",
      "<Sequence><SetBlackboard value='1;2;' output_key='q'/>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|1 -> RUNNING");
  row("loop over an entry that was never written",
      "<LoopDouble queue='{q}' value='{v}'><S/></LoopDouble>", "!has no value");
  row("loop over a text in an entry of any type",
      "<Sequence><ForceSuccess><SetBlackboard value='{q}' output_key='m'/></ForceSuccess>"
      "<Script code=\"q := '1;2'\"/><LoopInt queue='{q}' value='{v}'><S/></LoopInt></Sequence>",
      "!is not a queue of this type");
  row("loop over an entry",
      "<Sequence><RunOnce><Script code=\"q := '1.5;2'\"/></RunOnce>"
      "<LoopDouble queue='{q}' value='{v}' if_empty='FAILURE'><ReadDouble "
      "value='{v}'/></LoopDouble>"
      "</Sequence>",
      "1.5 -> RUNNING|2 -> RUNNING|-> FAILURE");
  row("loop, text, child fails",
      "<LoopString queue='a;b' value='{v}'><Sequence><ReadText value='{v}'/><F/></Sequence>"
      "</LoopString>",
      "a F -> FAILURE|a F -> FAILURE");
  row("loop, stateful child", "<LoopBool queue='1;0' value='{v}'><St/></LoopBool>",
      "start -> RUNNING|run1 -> RUNNING|start -> RUNNING|run1 -> RUNNING|-> SUCCESS|start -> "
      "RUNNING");
  row("precondition, child is skipped",
      "<Sequence><Precondition if='1 == 1'><S _skipIf='1 == 1'/></Precondition></Sequence>",
      "-> SKIPPED|-> SKIPPED");
  row("run once, port without a value",
      "<Sequence><RunOnce then_skip='{unset}'><S name='a'/></RunOnce><S name='b'/></Sequence>",
      "a b -> SUCCESS|b -> SUCCESS");
  row("skip unless updated",
      "<Sequence><RunOnce><SetBlackboard value='1' output_key='k'/></RunOnce>"
      "<SkipUnlessUpdated entry='{k}'><S/></SkipUnlessUpdated></Sequence>",
      "S -> SUCCESS|-> SKIPPED|-> SKIPPED");
  row("skip unless updated, never written",
      "<SkipUnlessUpdated entry='{k}'><S/></SkipUnlessUpdated>", "S -> SUCCESS|-> SKIPPED");
  row("skip unless updated, no such entry", "<SkipUnlessUpdated entry='k'><S/></SkipUnlessUpdated>",
      "-> SKIPPED|-> SKIPPED");
  row("wait for an update",
      "<Parallel success_count='1' failure_count='-1'><WaitValueUpdate entry='{k}'><St/>"
      "</WaitValueUpdate><Inverter><TD delay='0.1'><SetBlackboard value='1' output_key='k'/></TD>"
      "</Inverter></Parallel>",
      "start halt -> SUCCESS");
  row("custom decorator forgets when halted",
      "<Timeout msec='300'><TD delay='0.1'><St runs='9'/></TD></Timeout>",
      "-> FAILURE|start -> RUNNING|run1 -> RUNNING|run2 -> RUNNING|halt -> FAILURE|-> FAILURE");
}

}  // namespace

void DecoratorsTest::tick_decorator_givesTrace_data() {
  traces::columns();
  rowsOfRepetition();
  rowsOfDelays();
  rowsOfEntries();
}

void DecoratorsTest::tick_decorator_givesTrace() {
  traces::checkRow();
}

QTEST_APPLESS_MAIN(DecoratorsTest)
#include "tst_Decorators.moc"
