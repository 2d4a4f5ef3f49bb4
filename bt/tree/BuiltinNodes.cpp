#include "bt/tree/NodeCatalogue.h"

namespace bt {
namespace {

constexpr const char* kNodes = R"(
Control Sequence|Control|Runs the children in order until one fails; goes on at the one that was running.
Control Fallback|Control|Tries the children in order until one succeeds; goes on at the one that was running.
Control ReactiveSequence|Control|Starts at the first child in every step, so that conditions are checked again.
Control ReactiveFallback|Control|Starts at the first child in every step, so that better choices win.
Control SequenceWithMemory|Control|A sequence that goes on at the child that failed: waits until it succeeds.
Control AsyncSequence|Control|A sequence that completes at most one child per step.
Control AsyncFallback|Control|A fallback that completes at most one child per step.
Control Parallel|Control|Runs all children in every step until enough have succeeded or failed.
success_count int default -1|Successes that are enough; negative counts from all (-1).
failure_count int default 1|Failures that end it; negative counts from all (-1).
Control ParallelAll|Control|Runs all children and ends when every one of them is done.
max_failures int default 1|It fails with this many failures or more.
Control IfThenElse children 2 3|Control|First child: condition, asked once; second: if it succeeds; third: if not.
Control WhileDoElse children 2 3|Control|First child: condition, asked in every step; second: while it succeeds; third: while not.
Control Switch2 children 3 3|Control|Runs the child whose case equals the variable; the last child is for all other values.
variable text|What is compared.
case_1 text needed|Child 1 is run for this value.
case_2 text needed|Child 2 is run for this value.
Control Switch3 children 4 4|Control|Runs the child whose case equals the variable; the last child is for all other values.
variable case_1 case_2
case_3 text needed|Child 3 is run for this value.
Control Switch4 children 5 5|Control|Runs the child whose case equals the variable; the last child is for all other values.
variable case_1 case_2 case_3
case_4 text needed|Child 4 is run for this value.
Control Switch5 children 6 6|Control|Runs the child whose case equals the variable; the last child is for all other values.
variable case_1 case_2 case_3 case_4
case_5 text needed|Child 5 is run for this value.
Control Switch6 children 7 7|Control|Runs the child whose case equals the variable; the last child is for all other values.
variable case_1 case_2 case_3 case_4 case_5
case_6 text needed|Child 6 is run for this value.
Control TryCatch children 2 -1|Control|Runs all but the last child as a sequence; when it fails, the last one.
catch_on_halt bool default false|The last child also gets one step when it is halted.
Decorator Inverter|Decorator|Success becomes failure and the other way round.
Decorator ForceSuccess|Decorator|Succeeds however the child ends.
Decorator ForceFailure|Decorator|Fails however the child ends.
Decorator KeepRunningUntilFailure|Decorator|Runs the child again and again until it fails.
Decorator Repeat|Decorator|Runs the child several times, until it fails.
num_cycles int needed suggest 3|How often; -1 = for ever.
Decorator RetryUntilSuccessful|Decorator|Runs the child again when it fails.
num_attempts int needed suggest 3|How often; -1 = for ever.
Decorator RunOnce|Decorator|Runs the child to its end once in the life of the tree.
then_skip bool default true|Afterwards: true = skipped, false = the same result again.
Decorator Delay|Decorator|Waits before the child is run.
delay_msec milliseconds needed suggest 1000|How long, in simulated time.
Decorator Timeout|Decorator|Fails when the child takes longer.
msec milliseconds needed suggest 1000|The limit in simulated time; 0 = none.
Decorator Precondition|Decorator|Runs the child only if a script is true.
if text needed suggest true|The script.
else status default FAILURE|Result when it is false.
Decorator LoopInt|Decorator|Runs the child once for each element of a list.
queue queue needed inout suggest 1;2;3|The elements with ';' between them.
if_empty status default SUCCESS|Result at the end.
value int output suggest {value}|The element.
Decorator LoopBool|Decorator|Runs the child once for each element of a list.
queue if_empty
value bool output suggest {value}|The element.
Decorator LoopDouble|Decorator|Runs the child once for each element of a list.
queue if_empty
value number output suggest {value}|The element.
Decorator LoopString|Decorator|Runs the child once for each element of a list.
queue if_empty
value text output suggest {value}|The element.
Decorator SkipUnlessUpdated|Decorator|Skips the child unless the entry was written.
entry any needed suggest {key}|The entry.
Decorator WaitValueUpdate|Decorator|Waits until the entry was written, then runs the child.
entry
SubTree SubTree|SubTree|Runs another tree in this place.
Action AlwaysSuccess|Blackboard|Succeeds.
Action AlwaysFailure|Blackboard|Fails.
Action SetBlackboard|Blackboard|Writes an entry of the blackboard.
value any needed suggest 1|Text, or {key} of the entry to copy.
output_key any needed inout suggest key|Name of the entry.
Action UnsetBlackboard|Blackboard|Removes an entry of the blackboard.
key text needed suggest key|Name of the entry.
Action Script|Blackboard|Runs a script.
code text needed suggest x := 1|The script.
Condition ScriptCondition|Condition|Succeeds if a script is true.
code text needed suggest x == 1|The script.
Action Sleep|Blackboard|Waits.
msec milliseconds needed suggest 1000|How long, in simulated time.
Condition WasEntryUpdated|Condition|Succeeds if the entry was written since last asked.
entry
)";

}  // namespace

NodeCatalogue builtinNodes() {
  return nodesOf(kNodes, NodeOrigin::BehaviorTreeCpp);
}

}  // namespace bt
