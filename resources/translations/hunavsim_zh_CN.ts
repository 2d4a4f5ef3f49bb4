<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Manual</name>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People and groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots and sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pedestrian models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare planners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own planner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ROS 2 and other simulators</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings and bags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes of behaviour trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File formats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies on a cluster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Forces on people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces on selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after the first step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spaces of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spaces of selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Personal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Social</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at 0.6, 0.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100° to either side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People per m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exp(−d²/R²)/πR², R = %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remaining path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>newest step only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Costs of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>newest step, Nav2 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inscribed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lethal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter masks of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter masks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none; newest step, Nav2 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1–%2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluated by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lookahead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lidar, %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detection, velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen trajectory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidate (pale: costly)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would collide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People&apos;s paths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>action and its reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lidar: newest only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caused by robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caused by person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caused by both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move out of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renumber people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renumber goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove goal %1 from the route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp to the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add these values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the start to 0, 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set one wait per goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set rate to 0.1 /s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap the times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set to &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dissolve group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals to %1 people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add block %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collapse or expand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LaTeX (*.tex)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the rows as text that spreadsheets understand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the rows as CSV, LaTeX or Markdown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set behaviour: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the behaviour of the selected people to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mix…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the shares of behaviours among the selected people, or among all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>subtree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is ticked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>succeeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditional breakpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop when the node is ticked and this blackboard condition holds, for example  id == 2:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>when it %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, for any person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, if %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A condition holds…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break when</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break for any person when</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove breakpoint %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A value (%1) or a blackboard entry in braces, such as {id}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A person by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Occurs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whenever possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability in each time step in which the block can start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a person to add or remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in an included file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Issues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x y [m], separated by semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least %1 corners x y, separated by semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric thresholds, such as name=value, name=value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name=number, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>omnidirectional</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template of people spawned by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all visited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners x y in the robot frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least three corners x y, separated by semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lidar %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until the robot arrives, at most %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mix behaviours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No space for people here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space for only %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Door</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another seed generates other people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All ages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheelchairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luggage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk to goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, default %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subtree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Success</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not ticked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tree has one root only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The node no longer exists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes no children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes one child only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes at most %2 children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tree needs a root: replace it instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only nodes with the same parent can be wrapped together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 has %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The root already has a tree of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a SubTree can be inlined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has its own blackboard entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has pre- or postconditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in an included file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 contains itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The root has no siblings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the only child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the first child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the last child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map file %1 cannot be used, so there are no walls: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scenario specifies no map, so there are no walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map file %1 not found, so there are no walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>*This part is generated; it is in the HTML pages of the manual.*
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs external code (%2) with your permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow for this file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The displayed run uses %1 of memory and %2 of disk space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The disk is full: the timeline starts at %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>easy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>just now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: restart (deletes them), or save as another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the results in %1 have no results.sqlite, which is required to resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the results in %1 belong to another experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 planners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers
Choose what the map shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select people first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scenario has no people yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All &amp;layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trail length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture of the tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Selects items on the map. Click an item, or drag over empty space to select several. Drag the selection to move it, its handles to resize or rotate it. Shift adds to the selection, Alt suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places a person. Click the position, or press and drag to set the heading. A person walks when it has goals: place them with the goal tool and assign them with the route tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places people along a line. Drag a line; spacing, width and the mix of behaviours are set in the bar at the top left of the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fills an area with people. Drag a rectangle or click the corners of an area; the number of people and their goals are set in the bar at the top left of the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places goals. Click free space to add a goal; drag a goal to move it. Several people can share a goal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assigns goals to a person or robot. Click the person, then its goals in visiting order, then press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws a wall as a line of segments. Click each corner; Enter or a double click ends the wall. People and robots cannot cross it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws a rectangular obstacle from corner to corner. Shift makes a square.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws an obstacle with any number of corners. Click each corner; Enter or a click on the first corner closes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws a round obstacle. Drag from its centre to its edge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws a door. Drag from the hinge to the other jamb. The properties set when it opens and closes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws an area, for example a source or sink of people, or a zone with a speed limit. Choose the kind in the bar at the top left of the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places the robot and its goal. Click the position (drag to set the heading), then click the goal. Shift adds another robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places a charging dock for robots with Nav2. Click the position of the docked robot and drag to set its heading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paints walls, free or unknown space into the cells of the map. Keys 1, 2 and 3 choose the kind, [ and ] the width.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures a distance and an angle. Drag from one point to another; the result is shown in the status bar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes items. Click them or drag over them. Routes of people are updated. Undo restores everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the map. With any other tool, drag with the middle button, or hold Space and drag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything in the scenario as a list: people, goals, robots, obstacles and areas. Select entries here or on the map. Double-click a name or press F2 to change it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The properties of the selected items. A value in the secondary colour is the default; right-click a field to restore it. With nothing selected, the settings of the scenario are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as an outline. During a run it shows which nodes are active. Click beside a node to set a breakpoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors and warnings of the scenario, checked while you edit. Double-click an entry to go to its place; many entries offer a fix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The metrics of the displayed run, updated while it runs. Select a metric to plot it over time; hover over it to read its definition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened in the run: contacts, arrivals, reactions. Click an entry to show that moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branches of the run and recorded runs. Check several to compare their metrics and paths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats the rest of the run many times from the displayed moment and shows how often a contact occurs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs scenarios with several planners and seeds and compares them with confidence intervals in a report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map shows: people, routes, sensor data, costmaps and other layers, each with its opacity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Nav2 parameters of the selected robot with defaults and explanations. Search by name, or show only what was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as a graph. Drag nodes from the palette, press F8 to use the whole window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the manual (F1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scenario. The wheel zooms, the middle button or Space and drag move the map. The status bar says what the mouse does with the active tool. During a run, click a person for details; right-click to push, stop or add people.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::CommandPalette</name>
    <message>
        <source>Not available at the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a command or a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::DiffView</name>
    <message>
        <source>Differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 equal line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 equal lines</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Docks</name>
    <message>
        <source>&amp;Map only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close all panels; select again to restore them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tree instead of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the behaviour tree instead of the map; select again to show the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open or close this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::DocumentGuard</name>
    <message>
        <source>Export failed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot save a copy for crash recovery: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier session cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an unnamed scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program ended unexpectedly. Unsaved changes to %1 were kept (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes to %1 were kept when the last session ended (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reloading discards unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. It is still open here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is also open in another window. The window that saves last overwrites the changes of the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be read. It will not be overwritten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is damaged and only partly loaded. It will not be overwritten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot open a file manager. The files are in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved: %2. Your changes are not lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be opened: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files to write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the simulator&apos;s package</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HuNavSim 2.0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HuNavSim (2024)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in HuNavSim 2.0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Launch command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HuNavSim folder layout, for any simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files: %1, none replaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files: %1, replaced: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the run…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::FigureCommands</name>
    <message>
        <source>Start a run first: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied the map at %1 s as PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::FileCommands</name>
    <message>
        <source>Assign tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply command-line options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add command-line robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenarios, maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New scenario from a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open run folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another program after it was opened; saving overwrites those changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has a comment, which is lost when you save.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2 comments, which are lost when you save.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save anyway?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenarios (*.yaml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file is a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a map or a map image. Saving the scenario there would overwrite it. Choose another name, such as %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was moved or deleted. Save it again first?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::GuidedTour</name>
    <message>
        <source>Place a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the person a goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a metric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You have run your first scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the map where the person should walk to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press %1 or click the goal tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the person, then the goal, then press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The goal is there; now assign it. Press %1 for the route tool, click the person, then the goal, then press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the map where the person should start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press %1 or click the person tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The person walks to the goal …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Space, or Play in the tool bar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a metric in the list to plot it over time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click Metrics in the status bar at the bottom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+R returns to editing, %1 finds every command, F1 opens the manual. The next chapter adds a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First scenario in the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the tour; the scenario stays open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::HistoryDialog</name>
    <message>
        <source>Run history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory per run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory per run
Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Older steps are stored in a temporary file until the run is closed. When the disk is full, the oldest are deleted and the timeline starts later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ImageMapDialog</name>
    <message>
        <source>Map from an image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance 1 – 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click two points with a known distance, such as the ends of a wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the second point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the distance between the two points. You can drag them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m per pixel is out of range (%2 to %3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of lower left corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of point 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map will be %1 × %2 m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By two points in the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By resolution</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::KeyMap</name>
    <message>
        <source>%1 is used by fields, lists and tools and cannot be assigned.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::KeyRules</name>
    <message>
        <source>While you edit a text, the text field handles all keys that it uses; number fields do not use Space. Enter accepts the text, Esc discards it; both return the keyboard focus to the map. Ctrl+Z undoes typing only while an edit is not accepted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A list handles the keys that move in it, Space in rows with a check box, and Delete if its rows can be removed. Only in the scenario list does Delete remove the selection on the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click on a button, check box or combo box does not move the keyboard focus. After you reach one with Tab, use Space and the arrow keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All other keys go to the commands of the window, such as Space to run and pause, then to the map tool. The arrow keys move items only while the map has the focus; while you drive a robot manually, they drive it, as do W, A, S and D.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recorded run cannot be edited: Ctrl+R closes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recorded run is shown: Ctrl+R closes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HuNavSim Desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (recorded run) – HuNavSim Desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The options of the command line replace values of %1. Saving writes them to the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the values of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About HuNavSim Desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;HuNavSim Desktop %1&lt;/b&gt;&lt;br&gt;Scenarios for human-aware navigation: draw, simulate, measure.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ManualViewer</name>
    <message>
        <source>Search the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HuNavSim Desktop manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the previous page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the next page again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source># Page not found

The manual has no file `%1.md` in `%2`. Reinstall the program, or read the manual on the project&apos;s page.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::NoticeBar</name>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vector picture (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved the plot of “%1” to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key&amp;board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used from the next start on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animations
Without them, the map changes at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run &amp;history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers have a decimal point (1.5) in every language, as in files. Fields also accept a comma.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the default folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where file dialogs start for a scenario that is not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the last used file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Default folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies of unsaved changes
After a crash, the program offers to restore them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The longest time between a change and its copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;opy after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scenario file itself is written only when you save it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;estore defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the defaults of all pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Animate zooming and fitting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep copies of unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RecentRow</name>
    <message>
        <source>File not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File not found in </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder not found: </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RoomDialog</name>
    <message>
        <source>New empty room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room with four walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open plane without a map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RunExportCommands</name>
    <message>
        <source>Open a scenario or a run first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save film</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RunExportDialog</name>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People per m² as a colour map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intimate, personal and social zone of each person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian personal space, longer in the walking direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity vector of each body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces on each person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where bodies touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – requires ffmpeg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval of dots with the time on each trajectory; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height
The lowest value is the height that the map requires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names below the bodies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces are not recorded: only a run of this window has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be drawn: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. No file was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RunSharing</name>
    <message>
        <source>Watch this run at %1 (Foxglove: Open connection)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy address</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::SaveFilmDialog</name>
    <message>
        <source>Save film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GIF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WebP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WebM (VP9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MP4, WebP and WebM require the program ffmpeg, which is not installed: sudo apt install ffmpeg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the section that is repeated on the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated seconds per second of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show another frame of the film in the preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1 for a GIF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames, %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The end must be after the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1280 px wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HD, 1280 × 720</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small, 640 px wide</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::SavePictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG – pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG – vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF – vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two columns, 170 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One column, 85 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slide, 16 : 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two columns, 170 mm at 300 dpi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One column, 85 mm at 300 dpi</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ScaleView</name>
    <message>
        <source>Map image</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ScenarioGallery</name>
    <message>
        <source>Find a scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the scenarios of one family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the scenarios of one difficulty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scenario matches the search and the filters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the search and the filters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All families</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any difficulty</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ShortcutsPage</name>
    <message>
        <source>Find a command or a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys
Press the keys for the selected command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give these keys to the selected command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the keys of the selected command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the default keys of the selected command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the default keys of all commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a command to change its keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys for &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key belongs to the active tool and cannot be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is used by &quot;%2&quot; (%3). Assigning removes it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore a&amp;ll defaults</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StartPage</name>
    <message>
        <source>Start page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place people and a robot on a map, then press Space to simulate them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a scenario or a map anywhere on this window to open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New from a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 map or floor plan image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New empty room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four walls, or an open plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario or map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your first run in two minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output folder of a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import trajectories…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded people: CSV, JuPedSim, TrajNet++, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recent files. Open a scenario on the right, or take the guided tour.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 after its start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has arrived, %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time limit reached, %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot collided, %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Navigation failed%1, %2 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Navigation succeeded, but not at the goal, %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is stuck, %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space pauses · End shows the last step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playback paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space plays from here · Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space resumes · End returns to the newest step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space plays and pauses · . and , step · Ctrl+R closes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space pauses · Click a person for details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space replays · Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped at %1 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space resumes · . steps · Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a scenario to open it · Space runs it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 px/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StudyForm</name>
    <message>
        <source>Other parameters, one per line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number or list of seeds: 30 or [3, 7, 11]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum duration of each run [s]; empty: as in the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metrics only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs with an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failures only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs whose files are kept in the results folder. Failures are runs with an error and runs whose robot did not succeed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A list tests each value. {normal: [mean, deviation, minimum, maximum]}, {uniform: [from, to]} and {choice: […]} are sampled for each seed, equally for all planners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the open scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add scenario files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Delete to remove the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scenario first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planners to compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenarios (*.yaml *.yml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scenarios: add or drop files here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StudyPanel</name>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an experiment file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the experiment as a file; its results are stored beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a page with tables, confidence intervals, tests and figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments (*.yaml *.yml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unsaved changes of %1 are not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the results in the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its runs start external programs: allow them above the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: stopped, finished runs are kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run %1 was not recorded, and its experiment can no longer be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying run %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StudyProcess</name>
    <message>
        <source>The batch process crashed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StudyResults</name>
    <message>
        <source>Comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose scenarios and planners on the left, then press Start.
For each seed, all planners run with the same people.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one scale per column. Rates: Wilson; other metrics: bootstrap (BCa).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a run to play it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>–</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::StudyRunsModel</name>
    <message>
        <source>failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ended</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::TreeChoiceDialog</name>
    <message>
        <source>Apply to all %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving would overwrite custom trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: the file %2 was changed by another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: behaviour or goals changed after this custom tree was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tree in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the custom tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace it with the tree in this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the generated tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>− in the file   + in this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>− custom   + generated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show differences (−%1 +%2 lines)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replaced</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::TreeCommands</name>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::WindowActions</name>
    <message>
        <source>Show or hide on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rou&amp;tes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ulers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tr&amp;ails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Past paths of people in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Personal spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall&apos;s zones around selected people; in a run around all if none is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For&amp;ces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces on selected people in a run; on all if none is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot pat&amp;hs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paths that robot planners follow in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lid&amp;ar scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lidar scans of robots in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Detections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions of people and of themselves as robots estimate them in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidate tra&amp;jectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories that robot planners evaluated in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Obstacles and doors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Areas and docks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gro&amp;ups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to p&amp;oints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap drawn items to corners, ends and centres of other items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap drawn items to corners and edges of map walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to the gr&amp;id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap drawn items to a grid of 0.5 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alignment guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align dragged items with edges, centres and distances of others; Alt suspends this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Density of people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People per m² as a colour map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area that the selected people see; walls block the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gaussian spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian personal space, longer in the walking direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity vector of each body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peopl&amp;e&apos;s paths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remaining path of each person; newest step only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;ontacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where bodies touched, and which body ran into the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;houghts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current action of each person and its reason, below the name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Speech</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What people say, and which people hear it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Local costmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local costmap that the controller of a robot with Nav2 uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gl&amp;obal costmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Global costmap that the planner of a robot with Nav2 uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ilter masks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keepout zones and speed limits of the costmap filters of a robot with Nav2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New open plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a scenario without a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New empty &amp;room…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a scenario in a room of a given size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New from a &amp;map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a scenario on a Nav2 map or a map image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open r&amp;un…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recorded run: the output folder of `run`</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scenario and its behaviour trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scenario under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export scenario, trees and map for another simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save p&amp;icture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the displayed step of the run, or the start of the scenario, as PNG, SVG or PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save fi&amp;lm…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the run as a GIF, MP4 or WebP film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to the start page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change &amp;map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another map for the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign &amp;goals…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario &amp;settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit seed, duration and other settings of the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run &amp;history…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the memory for the history of a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch in &amp;Foxglove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Publish new runs live at ws://localhost:8765</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Publish to &amp;ROS 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Publish new runs on ROS 2 topics; /cmd_vel, /initialpose and /goal_pose control the first robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import tra&amp;jectories…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show recorded trajectories of people: CSV, JuPedSim, TrajNet++, ETH/UCY and others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search all commands and run one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preference&amp;s…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme, folders, copies of unsaved work and keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place a person, run the simulation and read a metric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the manual page of what has the keyboard focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click anything in the window for an explanation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search and change all keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show version information</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selection and remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selection as YAML text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the displayed step of the run as a figure: PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy metric as plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy a plot of the selected metric over time: PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save metric as plot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a plot of the selected metric over time: PNG, SVG or PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert the copied items at the mouse pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the selection; references are updated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select everything on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N&amp;ext</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the next person, or the next item of the selected kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;vious</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the previous person, or the previous item of the selected kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enlarge the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduce the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the whole map in the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the la&amp;yout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the default panel layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light or dar&amp;k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch between the light and the dark theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow &amp;system theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the light or dark theme of the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;centres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;tops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;middles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align &amp;bottoms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align the selected items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute &amp;horizontally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute &amp;vertically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set equal gaps between the selected items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate 15° left	[</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate 15° right	]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate 90° left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate 90° right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate the selection about its centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select something first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select exactly one item first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard contains no items of a scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select at least %1 first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>items</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::AreaPage</name>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spawned people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No person has this name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::AreaTool</name>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag an area where people appear, or click its corners · 1 to 5 choose the kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag an area where people leave after their last goal, or click its corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a waiting area, or click its corners · trees refer to it by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag an exit that people flee to, or click its corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag stairs, a ramp or a travelator, or click its corners · the properties set factor and carrying speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add source</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BehaviorMixDialog</name>
    <message>
        <source>Behaviours of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BehaviorPanel</name>
    <message>
        <source>Blackboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Block…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a tree from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the tree to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from the tree of a behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regenerate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Generate the tree from behaviour and goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move before the block above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move after the block below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a person to see the behaviour tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · generated from behaviour and goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom tree; not affected by changes to the behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load tree %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a behaviour tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the behaviour tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the tree of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a node above to see its ports.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BlackboardView</name>
    <message>
        <source>Blackboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blackboard is available during a run: press Space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard. &quot;Branch here…&quot; (in the menu Run) replays the run with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recorded at this time: the blackboard is recorded from the step in which the person is selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tree has no entries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes effect in the next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click to change the value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 becomes %2 in the next step, as an input of the run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BlockDialog</name>
    <message>
        <source>Blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No people yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BoxTool</name>
    <message>
        <source>Drag a box from corner to corner · Shift makes a square</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BranchCommand</name>
    <message>
        <source>Continue the run from the displayed step in another way: another planner, other positions, another seed; the run itself is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maximum number of branches is reached: remove one first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The inputs of this run are unknown, so it cannot be repeated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A branch starts at an earlier step: go back on the timeline first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branch with this change…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue the run with %1 here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BranchDialog</name>
    <message>
        <source>Branch at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The branch repeats the run up to %1 and pauses there. Without changes it is identical to the displayed run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From then on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branch name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PATH = VALUE, one per line: robot1.goal_radius = 0.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planner of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top speed of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a person…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave %1 in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New random seed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::BrushTool</name>
    <message>
        <source>%1 · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to place people along the path; they face its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::CircleTool</name>
    <message>
        <source>Drag from the centre of the circle to its edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::CompareTable</name>
    <message>
        <source>Metrics of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branch from an earlier moment, or add a recorded run. Checked runs are compared with the displayed run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the whole runs, although they differ in length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has another scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 diverges at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is identical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared up to %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outcomes over whole runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Different lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to %1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ContactProbabilityPlot</name>
    <message>
        <source>Probability of contact over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower limit (95 % CI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::CornerDrawingTool</name>
    <message>
        <source>%1 · Backspace removes the last corner · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the next corner · Enter or double-click finishes · Backspace removes the last corner · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least three corners are required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edges cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too small</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::DockPage</name>
    <message>
        <source>Dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charges robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parking place</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::DockTool</name>
    <message>
        <source>Drag to set the heading of a docked robot · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the position of a docked robot; drag to set its heading</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::DoorPage</name>
    <message>
        <source>Door</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seconds, such as 5, 12.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times in seconds, ascending, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::DoorTool</name>
    <message>
        <source>Drag a door from its hinge to the other jamb · Shift: 15° steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::EntityFilter</name>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::EntityModel</name>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots and docks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in this run; %2 applies at the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::EraserTool</name>
    <message>
        <source>Release to remove it · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to remove %1 items · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click items to remove them, or drag over them · Click areas to remove them</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No events yet: press Space to run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 enters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reached %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has arrived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 touches %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hears %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 starts %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 joins group %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 plans a new path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is stuck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: navigation succeeded, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: navigation failed, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Door %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run ends: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes a photo at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: battery %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ExportablePlot</name>
    <message>
        <source>Copy plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the plot as PNG and SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the plot as PNG, SVG or PDF</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::FillTool</name>
    <message>
        <source>Drag or click the corners of an area to fill with %1 and %2 goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag or click the corners of an area to fill with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::FuturesPanel</name>
    <message>
        <source>seeds,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>long, people ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of simulated futures, each with its own seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration of each future</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity uncertainty: once a second each walking person is pushed by a random velocity of this standard deviation. 0: only the variation of the scenario applies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate from the displayed step, in the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates the run from the displayed step with other random values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run cannot be replayed: its inputs are not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a run and pause it to simulate its futures from there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 futures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 futures so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 futures, cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No contact in any run (%1, 95 % CI at most %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 have a contact (%2, 95 % CI %3 to %4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median time %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ended early.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::FuturesProcess</name>
    <message>
        <source>The futures simulation crashed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::GoalAssignment</name>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag goals to add and reorder them. Assign applies the changes; Undo reverts them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No people yet: press P and drag on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the end of the route (Return)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the route (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier (Alt+Up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later (Alt+Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the route of the selected people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route of %1 people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select people on the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These people have different routes. Added goals go to the end of each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No goals: people stand still. Add goals from the middle list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::GoalList</name>
    <message>
        <source>%1 (missing)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::GoalPage</name>
    <message>
        <source>Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several goals selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::GoalTool</name>
    <message>
        <source>Click to place goal %1 · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to add a goal · Click or drag a goal to move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move goal %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::IssuesPanel</name>
    <message>
        <source>Issues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information: click to show or hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: all %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No issues. Press P and click on the map to place a person.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No issues: %1, %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No issues.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::KindSwitch</name>
    <message>
        <source>Selected kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show and change the selected items of this kind</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::LayersPanel</name>
    <message>
        <source>Opacity of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::LegendStrip</name>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ManualDriveController</name>
    <message>
        <source>&amp;Drive manually</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive the selected robot with the arrow keys or W A S D; it brakes without a key. Esc returns control to its planner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MapInset</name>
    <message>
        <source>The map around the person</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MapPaintTool</name>
    <message>
        <source>No map to paint on: start with a room, a map or an image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to paint %1, %2 m wide · 1 wall, 2 free, 3 unknown · [ ] width · Shift: free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cell type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint the map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MapView</name>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MeasureTool</name>
    <message>
        <source>Drag from one point to another · Shift: 15° steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance %1 m · angle %2 · Δx %3 m · Δy %4 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MetricsDock</name>
    <message>
        <source>Metrics appear when a simulation runs: press Space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot whose metrics are shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MetricsTable</name>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only the metrics that are measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure all listed metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure no listed metric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the choice to the metrics file of the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As if %1 were the only person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No value: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 metrics are measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set metrics file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a metric</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::MixButton</name>
    <message>
        <source>Mix of behaviours and seed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::Nav2Form</name>
    <message>
        <source>Changed only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only values that differ from the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the value in the file (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a value to change it. The scenario keeps the change; the file is only changed by saving it as a new file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 default %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · in the file %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · not in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a Nav2 parameter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::Nav2Panel</name>
    <message>
        <source>No robot is driven by Nav2. Select a robot and choose the planner nav2 in its properties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot whose parameters are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all values to those in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset Nav2 parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a new file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the changed values into a copy of the parameter file, with its comments and order, and use that file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Nav2 parameters as a new file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 parameters (*.yaml *.yml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Nav2 parameters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::NoMatchesPlaceholder</name>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No matches for &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::NodeFields</name>
    <message>
        <source>Name and ports of the node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter applies, Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::NodePalette</name>
    <message>
        <source>Search by name or description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decorators</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subtrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Templates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs the tree %1 with all entries of this tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a node into the tree, or double-click it to add it to the selected node.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a node</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::NumberField</name>
    <message>
        <source>above %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above %1, at most %2%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ObstaclePage</name>
    <message>
        <source>Obstacle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several shapes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PanTool</name>
    <message>
        <source>Drag to move the map · Wheel zooms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PeopleInteraction</name>
    <message>
        <source>Spawn a person with the same tree and goals here, as an input of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a person like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push %1…	Shift+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then drag an arrow: 1 m is 1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The person brakes and stays until resumed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PersonPage</name>
    <message>
        <source>Pose and body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mix…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the shares of behaviours among these people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adult</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheelchair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With luggage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign ordered goals to several people (Ctrl+G)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>different routes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visited in order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seconds at each goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One time in seconds per goal, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random, by seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reaction to the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then continues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the random values of a run with this seed; the scenario keeps its seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample with another seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store these numbers as custom values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze random values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set it as the seed of the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id of the person; part of the name of the tree file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People in a group stay together while they walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walks with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Members</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all people from the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each other (new group)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>different groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appearance in the simulator of the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as in Gazebo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Generate the tree from behaviour, reaction and goals; Ctrl+Z restores the custom tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uses a custom tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 with custom trees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes made here do not affect it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes made here do not affect custom trees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect these trees.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PersonTool</name>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to place a person; drag to set the heading</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PlaybackActions</name>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the run and return to editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back one recorded step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step forward, then pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to newest step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the newest step of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Branch here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The newest step is already shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed
Simulated seconds per real second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PolygonTool</name>
    <message>
        <source>Click the corners of an obstacle; click the first one to close it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PropertyPage</name>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all to their default values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applies at the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name starts with a letter and contains only letters, digits and _</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This name is already in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name=value, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::PropertyPanel</name>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the run with the current settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes take effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dot marks values that differ from those of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes apply to these, not to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario · nothing selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spawned by a source in this run. To change such people, select the person that the source copies.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RobotPage</name>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters that are unknown to the planner or not numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body and limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc with the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Omnidirectional</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As robot type (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People perception</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All (ground truth)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lidar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Odometry errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Localisation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Published data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as generic robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not published</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Humble</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jazzy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kilted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lyrical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the file (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Nav2 panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the panel with all parameters of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use radius or footprint from local_costmap in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ordered global goals instead of a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change robot route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends the run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RobotPicture</name>
    <message>
        <source>Robot body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 long, %2 wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RobotTool</name>
    <message>
        <source>Click the goal of the robot · Esc keeps the current goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to place the robot; drag to set the heading · Shift adds another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set robot goal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RouteEditor</name>
    <message>
        <source>
Click for options, press Delete to remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a goal to the end of the route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select goal %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the route</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RouteTool</name>
    <message>
        <source>Click the person or robot that follows the route (Shift adds more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the goals in visiting order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route %1 · Enter applies · Backspace removes the last goal · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is selected: click a person or robot first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No goal here: click the pin of a goal, or press G to add goals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is already the last goal of the route</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RunEvents</name>
    <message>
        <source>%1 has arrived at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 touches a wall</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RunOverlayUpdater</name>
    <message>
        <source>says %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hears %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RunStateSection</name>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manual drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reacting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m away</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RunningNodes</name>
    <message>
        <source>Running nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running nodes are listed during a run: press Space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No node is running at this time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::RunsPanel</name>
    <message>
        <source>Add a recorded run to compare: the output folder of `run`</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show this run at the same time step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this run from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show up to four compared runs beside the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branched at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with a run folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press F2 to rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branch here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a run…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ScenarioDocument</name>
    <message>
        <source>Change map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tree file of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the generated tree of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ScenarioPanel</name>
    <message>
        <source>Show on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre the map on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the number of the goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename it; references are updated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it in the file, but not in the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Include it in the simulation again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all of this kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select everything of this kind to change it together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk as a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make these people walk together as a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A group needs two or more people: select more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This person is in no group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of these people is in a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter people, goals, areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing on the map yet.
Press P and click to place a person.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ScrubActions</name>
    <message>
        <source>&amp;Previous contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the previous contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the next contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat from A to B; drag the marks on the timeline, or Shift+drag a new section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions of all people 1, 2 and 3 s before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the time span of trails in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No contact before the displayed step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No contact after the displayed step</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::SearchField</name>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::SelectTool</name>
    <message>
        <source>The robot follows until you release the button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to branch with the person here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag an arrow: a longer arrow pushes harder · Esc cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a person for details · Drag a person to branch with another position · Space resumes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a person for details · Shift+drag to push · Drag a robot to lead it · Space pauses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a person for details · Space pauses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to select · Drag over empty space to select several</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the round handle to turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a corner to resize</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click an edge to add a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D duplicates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Del removes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::SettingsPage</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With anything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sfm (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight, as in HuNavSim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest wall points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rays, like a lidar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start over when done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no wrapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two x values in metres, ascending, separated by a comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variation between seeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Varied quantities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not varied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uniform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Easy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters that are unknown to the model or not numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulator and map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not specified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worlds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>humble (default)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Publish people</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::SimulationRunner</name>
    <message>
        <source>Branch %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TextViewer</name>
    <message>
        <source>Text of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open with…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the file with the default application</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too long to display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No application is available to open %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No longer stored: the disk is full</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ToolManager</name>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TreeCanvas</name>
    <message>
        <source>Behaviour tree as a graph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown node type; it is kept unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In an included file: read-only here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TreeEditor</name>
    <message>
        <source>Name of the node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tree of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person whose tree is shown; you can also select a person on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply edits to all people with the same tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign to…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign the same tree to other people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a new tree with an empty Sequence as its root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place the root on the left or at the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use node positions of the file or automatic layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expand all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all nodes or only the branches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the whole tree in the window (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout: automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout: from file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each node returned in the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nodes that are running at the displayed step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XML</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the XML file of the tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackboard of the person&apos;s tree at the displayed step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collapse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was picked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits change %1 people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits change only this person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the XML of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The node is in an included file, which cannot be edited here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrap %2 in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is copied as XML</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 are copied as XML</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard contains no node: copy a node or its XML first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrap %1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace %1 with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1, keep children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extract %1 as subtree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inline subtree %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the name of a node: Enter adds it below the selected one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the goal on the map, or in the scenario list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the person on the map, or in the scenario list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %2 of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regenerate the tree of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign the tree of %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick %1 on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrap in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate	Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut	Ctrl+X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as XML	Ctrl+C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete	Del</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste	Ctrl+V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit	F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove, keep children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inline subtree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extract as subtree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit ports	Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a node…	Ins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier	Alt+Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later	Alt+Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expand	+</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collapse	-</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TreeHistory</name>
    <message>
        <source>What the nodes returned over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run used another tree: run it again to see its nodes here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the scenario to see what each node returns over time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TreeOutline</name>
    <message>
        <source>Behaviour tree</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::TreeText</name>
    <message>
        <source>XML of the tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard the edit and show the current tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::ValueForm</name>
    <message>
        <source>Read %1 from a blackboard entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter %1 as a number</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>editor::WallTool</name>
    <message>
        <source>Drag a wall, or click its corners one by one · Shift: 15° steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least two corners are required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too short</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
