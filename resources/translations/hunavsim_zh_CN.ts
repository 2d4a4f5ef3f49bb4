<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Behaviour</name>
    <message>
        <source>Regular</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Impassive</source>
        <translation>无反应</translation>
    </message>
    <message>
        <source>Surprised</source>
        <translation>惊讶</translation>
    </message>
    <message>
        <source>Scared</source>
        <translation>害怕</translation>
    </message>
    <message>
        <source>Curious</source>
        <translation>好奇</translation>
    </message>
    <message>
        <source>Threatening</source>
        <translation>威胁</translation>
    </message>
    <message>
        <source>Custom tree</source>
        <translation>自定义树</translation>
    </message>
</context>
<context>
    <name>Breakpoint</name>
    <message>
        <source>is ticked</source>
        <translation>被 tick 时</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>运行时</translation>
    </message>
    <message>
        <source>succeeds</source>
        <translation>成功时</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>失败时</translation>
    </message>
    <message>
        <source>is skipped</source>
        <translation>被跳过时</translation>
    </message>
</context>
<context>
    <name>EditCommand</name>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Add %1 items</source>
        <translation>添加 %1 个对象</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Remove %1 items</source>
        <translation>移除 %1 个对象</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Move %1 items</source>
        <translation>移动 %1 个对象</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>为 %1 创建副本</translation>
    </message>
    <message>
        <source>Duplicate %1 items</source>
        <translation>为 %1 个对象创建副本</translation>
    </message>
    <message>
        <source>Set route of %1</source>
        <translation>设置 %1 的路线</translation>
    </message>
    <message>
        <source>Set route of %1 items</source>
        <translation>设置 %1 个对象的路线</translation>
    </message>
    <message>
        <source>Reorder %1</source>
        <translation>重新排序 %1</translation>
    </message>
    <message>
        <source>Reorder %1 items</source>
        <translation>重新排序 %1 个对象</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>启用 %1</translation>
    </message>
    <message>
        <source>Switch on %1 items</source>
        <translation>启用 %1 个对象</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>停用 %1</translation>
    </message>
    <message>
        <source>Switch off %1 items</source>
        <translation>停用 %1 个对象</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Renumber goal %1</source>
        <translation>重新编号目标点 %1</translation>
    </message>
</context>
<context>
    <name>Entity</name>
    <message>
        <source>%1 goal</source>
        <translation>%1 的目标点</translation>
    </message>
    <message>
        <source>Goal %1</source>
        <translation>目标点 %1</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>个场景</translation>
    </message>
    <message>
        <source>person</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>people</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>个机器人</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>goals</source>
        <translation>个目标点</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>obstacles</source>
        <translation>个障碍物</translation>
    </message>
    <message>
        <source>door</source>
        <translation>门</translation>
    </message>
    <message>
        <source>doors</source>
        <translation>个门</translation>
    </message>
    <message>
        <source>area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>areas</source>
        <translation>个区域</translation>
    </message>
    <message>
        <source>dock</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>docks</source>
        <translation>个充电桩</translation>
    </message>
    <message>
        <source>box</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>source</source>
        <translation>源</translation>
    </message>
    <message>
        <source>sink</source>
        <translation>汇</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等候</translation>
    </message>
    <message>
        <source>exit</source>
        <translation>出口</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Counter-clockwise from the x axis</source>
        <translation>从 x 轴逆时针</translation>
    </message>
</context>
<context>
    <name>Force</name>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>群组</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>合力</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>安装</translation>
    </message>
    <message>
        <source>First scenario</source>
        <translation>第一个场景</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Your own map</source>
        <translation>使用自己的地图</translation>
    </message>
    <message>
        <source>People and groups</source>
        <translation>行人与群组</translation>
    </message>
    <message>
        <source>Behaviour trees</source>
        <translation>行为树</translation>
    </message>
    <message>
        <source>Robots and sensors</source>
        <translation>机器人与传感器</translation>
    </message>
    <message>
        <source>List of robots</source>
        <translation>机器人列表</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Pedestrian models</source>
        <translation>行人模型</translation>
    </message>
    <message>
        <source>Compare planners</source>
        <translation>比较规划器</translation>
    </message>
    <message>
        <source>Sensitivity analysis</source>
        <translation>敏感性分析</translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation>Nav2</translation>
    </message>
    <message>
        <source>Your own planner</source>
        <translation>自己的规划器</translation>
    </message>
    <message>
        <source>Python</source>
        <translation>Python</translation>
    </message>
    <message>
        <source>ROS 2 and other simulators</source>
        <translation>ROS 2 与其他仿真器</translation>
    </message>
    <message>
        <source>Recordings and bags</source>
        <translation>录制与 bag 文件</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Nodes of behaviour trees</source>
        <translation>行为树节点</translation>
    </message>
    <message>
        <source>File formats</source>
        <translation>文件格式</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Studies on a cluster</source>
        <translation>在集群上运行研究</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>故障排除</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>如何引用</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>术语表</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Forces on people</source>
        <translation>作用于行人的力</translation>
    </message>
    <message>
        <source>Forces on %1</source>
        <translation>作用于 %1 的力</translation>
    </message>
    <message>
        <source>Forces on selection</source>
        <translation>作用于所选对象的力</translation>
    </message>
    <message>
        <source>after the first step</source>
        <translation>第一步之后</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>Spaces</source>
        <translation>空间</translation>
    </message>
    <message>
        <source>Spaces of %1</source>
        <translation>%1 的空间</translation>
    </message>
    <message>
        <source>Spaces of selection</source>
        <translation>所选对象的空间</translation>
    </message>
    <message>
        <source>Intimate</source>
        <translation>亲密</translation>
    </message>
    <message>
        <source>Personal</source>
        <translation>个人</translation>
    </message>
    <message>
        <source>Social</source>
        <translation>社交</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>高斯</translation>
    </message>
    <message>
        <source>at 0.6, 0.2</source>
        <translation>值为 0.6、0.2</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>视野</translation>
    </message>
    <message>
        <source>Select a person</source>
        <translation>请选择一个行人</translation>
    </message>
    <message>
        <source>Seen by %1</source>
        <translation>%1 看到的</translation>
    </message>
    <message>
        <source>100° to either side</source>
        <translation>左右各 100°</translation>
    </message>
    <message>
        <source>People per m²</source>
        <translation>每平方米人数</translation>
    </message>
    <message>
        <source>exp(−d²/R²)/πR², R = %1 m</source>
        <translation>exp(−d²/R²)/πR², R = %1 m</translation>
    </message>
    <message>
        <source>Remaining path</source>
        <translation>剩余路径</translation>
    </message>
    <message>
        <source>newest step only</source>
        <translation>仅最新一步</translation>
    </message>
    <message>
        <source>Contacts so far</source>
        <translation>目前为止的接触</translation>
    </message>
    <message>
        <source>Costs of %1</source>
        <translation>%1 的代价</translation>
    </message>
    <message>
        <source>Costs</source>
        <translation>代价</translation>
    </message>
    <message>
        <source>newest step, Nav2 only</source>
        <translation>最新一步，仅 Nav2</translation>
    </message>
    <message>
        <source>Inscribed</source>
        <translation>内切</translation>
    </message>
    <message>
        <source>Lethal</source>
        <translation>致命</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Filter masks of %1</source>
        <translation>%1 的过滤掩膜</translation>
    </message>
    <message>
        <source>Filter masks</source>
        <translation>过滤掩膜</translation>
    </message>
    <message>
        <source>none; newest step, Nav2 only</source>
        <translation>无；最新一步，仅 Nav2</translation>
    </message>
    <message>
        <source>Keep out</source>
        <translation>禁入</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>限速</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>开关</translation>
    </message>
    <message>
        <source>%1–%2 %</source>
        <translation>%1–%2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Evaluated by %1</source>
        <translation>由 %1 评估</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>已舍弃</translation>
    </message>
    <message>
        <source>Lookahead</source>
        <translation>前视点</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>已选</translation>
    </message>
    <message>
        <source>Lidar, %1 m</source>
        <translation>激光雷达，%1 m</translation>
    </message>
    <message>
        <source>Detection, velocity</source>
        <translation>检测，速度</translation>
    </message>
    <message>
        <source>Chosen trajectory</source>
        <translation>选定轨迹</translation>
    </message>
    <message>
        <source>Candidate (pale: costly)</source>
        <translation>候选（浅色：代价高）</translation>
    </message>
    <message>
        <source>Would collide</source>
        <translation>会碰撞</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>People&apos;s paths</source>
        <translation>行人路径</translation>
    </message>
    <message>
        <source>Below names</source>
        <translation>名称下方</translation>
    </message>
    <message>
        <source>action and its reason</source>
        <translation>动作及其原因</translation>
    </message>
    <message>
        <source>lidar: newest only</source>
        <translation>激光雷达：仅最新</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Caused by robot</source>
        <translation>由机器人引起</translation>
    </message>
    <message>
        <source>Caused by person</source>
        <translation>由行人引起</translation>
    </message>
    <message>
        <source>Caused by both</source>
        <translation>双方引起</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>还有 %1 个</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Move out of the wall</source>
        <translation>移出墙体</translation>
    </message>
    <message>
        <source>Renumber people</source>
        <translation>重新编号行人</translation>
    </message>
    <message>
        <source>Renumber goals</source>
        <translation>重新编号目标点</translation>
    </message>
    <message>
        <source>Remove goal %1 from the route</source>
        <translation>从路线中移除目标点 %1</translation>
    </message>
    <message>
        <source>Remove the goal</source>
        <translation>移除目标点</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Clamp to the range</source>
        <translation>限制到有效范围</translation>
    </message>
    <message>
        <source>Add these values</source>
        <translation>添加这些值</translation>
    </message>
    <message>
        <source>Set the start to 0, 0</source>
        <translation>将起点设为 0, 0</translation>
    </message>
    <message>
        <source>Set one wait per goal</source>
        <translation>为每个目标点设置一个等待时间</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>分配目标点…</translation>
    </message>
    <message>
        <source>Use &apos;%1&apos;</source>
        <translation>使用“%1”</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>使用默认值</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>复制 %1</translation>
    </message>
    <message>
        <source>Set rate to 0.1 /s</source>
        <translation>将速率设为 0.1 /s</translation>
    </message>
    <message>
        <source>Swap the times</source>
        <translation>交换时间</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Open the wall</source>
        <translation>打通墙体</translation>
    </message>
    <message>
        <source>Set to &apos;%1&apos;</source>
        <translation>设为“%1”</translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation>使用开阔平面</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>添加机器人</translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation>使用 Nav2 文件中的机体</translation>
    </message>
    <message>
        <source>Change map</source>
        <translation>更换地图</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>群组 %1</translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation>离开群组</translation>
    </message>
    <message>
        <source>Join group %1</source>
        <translation>加入群组 %1</translation>
    </message>
    <message>
        <source>Dissolve group %1</source>
        <translation>解散群组 %1</translation>
    </message>
    <message>
        <source>Name group %1</source>
        <translation>命名群组 %1</translation>
    </message>
    <message>
        <source>Assign goals to %1</source>
        <translation>为 %1 分配目标点</translation>
    </message>
    <message>
        <source>Assign goals to %1 people</source>
        <translation>为 %1 名行人分配目标点</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> （以及另外 %1 个）</translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation>重新生成树</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>更改 %2 的%1</translation>
    </message>
    <message>
        <source>Change blocks</source>
        <translation>更改行为块</translation>
    </message>
    <message>
        <source>Add block %1</source>
        <translation>添加行为块 %1</translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation>将路线复制到树</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Collapse or expand</source>
        <translation>折叠或展开</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>群组</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>逗号分隔值 (*.csv)</translation>
    </message>
    <message>
        <source>LaTeX (*.tex)</source>
        <translation>LaTeX (*.tex)</translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation>Markdown (*.md)</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>复制表格</translation>
    </message>
    <message>
        <source>Copy the rows as text that spreadsheets understand</source>
        <translation>将各行复制为电子表格可识别的文本</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save the rows as CSV, LaTeX or Markdown</source>
        <translation>将各行保存为 CSV、LaTeX 或 Markdown</translation>
    </message>
    <message>
        <source>Set behaviour: %1</source>
        <translation>设置行为：%1</translation>
    </message>
    <message>
        <source>Set the behaviour of the selected people to %1</source>
        <translation>将所选行人的行为设为 %1</translation>
    </message>
    <message>
        <source>&amp;Mix…</source>
        <translation>混合(&amp;M)…</translation>
    </message>
    <message>
        <source>Set the shares of behaviours among the selected people, or among all</source>
        <translation>设置所选行人（或全部行人）中各行为的比例</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>行为</translation>
    </message>
    <message>
        <source>no goals</source>
        <translation>无目标点</translation>
    </message>
    <message>
        <source>subtree</source>
        <translation>子树</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>运行时</translation>
    </message>
    <message>
        <source>Conditional breakpoint</source>
        <translation>条件断点</translation>
    </message>
    <message>
        <source>Stop when the node is ticked and this blackboard condition holds, for example  id == 2:</source>
        <translation>当节点被 tick 且满足此黑板条件时停止，例如  id == 2：</translation>
    </message>
    <message>
        <source>when it %1</source>
        <translation>当其%1</translation>
    </message>
    <message>
        <source>, for any person</source>
        <translation>，适用于任何行人</translation>
    </message>
    <message>
        <source>, if %1</source>
        <translation>，条件：%1</translation>
    </message>
    <message>
        <source>It %1</source>
        <translation>当其%1</translation>
    </message>
    <message>
        <source>A condition holds…</source>
        <translation>满足条件时…</translation>
    </message>
    <message>
        <source>Break when</source>
        <translation>中断时机</translation>
    </message>
    <message>
        <source>Break for any person when</source>
        <translation>任何行人的中断时机</translation>
    </message>
    <message>
        <source>Remove breakpoint %1</source>
        <translation>移除断点 %1</translation>
    </message>
    <message>
        <source>Remove all breakpoints</source>
        <translation>移除所有断点</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（缺失）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>A value (%1) or a blackboard entry in braces, such as {id}</source>
        <translation>一个值（%1），或花括号中的黑板条目，例如 {id}</translation>
    </message>
    <message>
        <source>The nearest person</source>
        <translation>最近的行人</translation>
    </message>
    <message>
        <source>A person by name</source>
        <translation>按名称指定的行人</translation>
    </message>
    <message>
        <source>The robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Occurs</source>
        <translation>发生</translation>
    </message>
    <message>
        <source>Whenever possible</source>
        <translation>尽可能每次</translation>
    </message>
    <message>
        <source>Only once</source>
        <translation>仅一次</translation>
    </message>
    <message>
        <source>At random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>Probability in each time step in which the block can start</source>
        <translation>行为块可启动的每个时间步中的概率</translation>
    </message>
    <message>
        <source>Enter a text</source>
        <translation>请输入文本</translation>
    </message>
    <message>
        <source>Select a person to add or remove</source>
        <translation>选择要添加或移除的行人</translation>
    </message>
    <message>
        <source>unknown node</source>
        <translation>未知节点</translation>
    </message>
    <message>
        <source>no settings</source>
        <translation>无设置</translation>
    </message>
    <message>
        <source>in an included file</source>
        <translation>在包含的文件中</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation>Nav2</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>x y [m], separated by semicolons</source>
        <translation>x y [m]，用分号分隔</translation>
    </message>
    <message>
        <source>At least %1 corners x y, separated by semicolons</source>
        <translation>至少 %1 个顶点 x y，用分号分隔</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Metric thresholds, such as name=value, name=value</source>
        <translation>指标阈值，例如 名称=值, 名称=值</translation>
    </message>
    <message>
        <source>name=number, separated by commas</source>
        <translation>名称=数值，用逗号分隔</translation>
    </message>
    <message>
        <source>people</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>omnidirectional</source>
        <translation>全向</translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation>Ackermann</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>差速</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Numbers, separated by commas</source>
        <translation>用逗号分隔的数字</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>行人 %1</translation>
    </message>
    <message>
        <source> · switched off</source>
        <translation> · 已停用</translation>
    </message>
    <message>
        <source>Template of people spawned by %1</source>
        <translation>%1 所生成行人的模板</translation>
    </message>
    <message>
        <source> · stands still</source>
        <translation> · 站立不动</translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation> · 目标点 %1</translation>
    </message>
    <message>
        <source>Robot · %1</source>
        <translation>机器人 · %1</translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation> · 前往 %1</translation>
    </message>
    <message>
        <source>all visited</source>
        <translation>已全部到访</translation>
    </message>
    <message>
        <source>%1, reached</source>
        <translation>%1，已到达</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Corners x y in the robot frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2</source>
        <translation>机器人坐标系中的顶点 x y，例如 0.3 0.2; -0.3 0.2; -0.3 -0.2</translation>
    </message>
    <message>
        <source>At least three corners x y, separated by semicolons</source>
        <translation>至少三个顶点 x y，用分号分隔</translation>
    </message>
    <message>
        <source>lidar %1 m</source>
        <translation>激光雷达 %1 m</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1（默认）</translation>
    </message>
    <message>
        <source>Futures</source>
        <translation>未来</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>until the robot arrives, at most %1 s</source>
        <translation>直到机器人到达，最多 %1 s</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Mix behaviours</source>
        <translation>混合行为</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>No space for people here</source>
        <translation>此处没有放置行人的空间</translation>
    </message>
    <message>
        <source>Space for only %1 of %2</source>
        <translation>只能放下 %1 / %2</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>橡皮擦</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Paint map</source>
        <translation>绘制地图</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Dock</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路线</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>门</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>份</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Another seed generates other people</source>
        <translation>不同的种子会生成不同的行人</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>All ages</source>
        <translation>所有年龄</translation>
    </message>
    <message>
        <source>Adults</source>
        <translation>成人</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>儿童</translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation>老人</translation>
    </message>
    <message>
        <source>Wheelchairs</source>
        <translation>轮椅</translation>
    </message>
    <message>
        <source>Luggage</source>
        <translation>携带行李</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>体型</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>站立</translation>
    </message>
    <message>
        <source>Walk to goals</source>
        <translation>走向目标点</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>, default %1</source>
        <translation>，默认 %1</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>树</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>无法运行：%1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>个错误</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>个错误</translation>
    </message>
    <message>
        <source>Subtree</source>
        <translation>子树</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Success</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>not ticked</source>
        <translation>未 tick</translation>
    </message>
    <message>
        <source>An %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>A %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>one child</source>
        <translation>一个子节点</translation>
    </message>
    <message>
        <source>%1 children</source>
        <translation>%1 个子节点</translation>
    </message>
    <message>
        <source>A tree has one root only</source>
        <translation>一棵树只能有一个根节点</translation>
    </message>
    <message>
        <source>The node no longer exists</source>
        <translation>该节点已不存在</translation>
    </message>
    <message>
        <source>%1 takes no children</source>
        <translation>%1 不能有子节点</translation>
    </message>
    <message>
        <source>%1 takes one child only</source>
        <translation>%1 只能有一个子节点</translation>
    </message>
    <message>
        <source>%1 takes at most %2 children</source>
        <translation>%1 最多只能有 %2 个子节点</translation>
    </message>
    <message>
        <source>A tree needs a root: replace it instead</source>
        <translation>树需要根节点：请改为替换它</translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation>请先选择一个节点</translation>
    </message>
    <message>
        <source>Only nodes with the same parent can be wrapped together</source>
        <translation>只有父节点相同的节点才能一起包裹</translation>
    </message>
    <message>
        <source>%1: %2 has %3</source>
        <translation>%1：%2 有 %3</translation>
    </message>
    <message>
        <source>%1 has no children</source>
        <translation>%1 没有子节点</translation>
    </message>
    <message>
        <source>The root already has a tree of its own</source>
        <translation>根节点已有自己的树</translation>
    </message>
    <message>
        <source>Only a SubTree can be inlined</source>
        <translation>只有 SubTree 可以内联</translation>
    </message>
    <message>
        <source>%1 has its own blackboard entries</source>
        <translation>%1 有自己的黑板条目</translation>
    </message>
    <message>
        <source>%1 has pre- or postconditions</source>
        <translation>%1 有前置或后置条件</translation>
    </message>
    <message>
        <source>%1 is in an included file</source>
        <translation>%1 在包含的文件中</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 为空</translation>
    </message>
    <message>
        <source>%1 contains itself</source>
        <translation>%1 包含自身</translation>
    </message>
    <message>
        <source>The root has no siblings</source>
        <translation>根节点没有同级节点</translation>
    </message>
    <message>
        <source>%1 is the only child</source>
        <translation>%1 是唯一的子节点</translation>
    </message>
    <message>
        <source>%1 is the first child</source>
        <translation>%1 是第一个子节点</translation>
    </message>
    <message>
        <source>%1 is the last child</source>
        <translation>%1 是最后一个子节点</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 及另外 %2 个</translation>
    </message>
    <message>
        <source>Map file %1 cannot be used, so there are no walls: %2.</source>
        <translation>地图文件 %1 无法使用，因此没有墙：%2。</translation>
    </message>
    <message>
        <source>The scenario specifies no map, so there are no walls.</source>
        <translation>场景未指定地图，因此没有墙。</translation>
    </message>
    <message>
        <source>Map file %1 not found, so there are no walls.</source>
        <translation>找不到地图文件 %1，因此没有墙。</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>未更改</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>*This part is generated; it is in the HTML pages of the manual.*
</source>
        <translation>*此部分为自动生成；请参见手册的 HTML 页面。*
</translation>
    </message>
    <message>
        <source>%1 runs external code (%2) with your permissions.</source>
        <translation>%1 将以您的权限运行外部代码（%2）。</translation>
    </message>
    <message>
        <source>Allow for this file</source>
        <translation>允许此文件</translation>
    </message>
    <message>
        <source>Do not run</source>
        <translation>不运行</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>The displayed run uses %1 of memory and %2 of disk space.</source>
        <translation>当前显示的运行占用 %1 内存和 %2 磁盘空间。</translation>
    </message>
    <message>
        <source> The disk is full: the timeline starts at %1.</source>
        <translation> 磁盘已满：时间轴从 %1 开始。</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>简单</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>hard</source>
        <translation>困难</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>机器人：%1</translation>
    </message>
    <message>
        <source>People: %1</source>
        <translation>行人：%1</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>预期：%1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>来源：%1</translation>
    </message>
    <message>
        <source>person</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>%1 robots</source>
        <translation>%1 个机器人</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>刚刚</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 分钟前</translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation>%1 小时前</translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation>昨天</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>%1: restart (deletes them), or save as another file</source>
        <translation>%1：重新开始（将删除结果），或另存为其他文件</translation>
    </message>
    <message>
        <source>the results in %1 have no results.sqlite, which is required to resume</source>
        <translation>%1 中的结果没有继续所需的 results.sqlite</translation>
    </message>
    <message>
        <source>the results in %1 belong to another experiment</source>
        <translation>%1 中的结果属于另一个实验</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>个场景</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>个场景</translation>
    </message>
    <message>
        <source>%1 planners</source>
        <translation>%1 个规划器</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>个种子</translation>
    </message>
    <message>
        <source>seeds</source>
        <translation>个种子</translation>
    </message>
    <message>
        <source>run</source>
        <translation>次运行</translation>
    </message>
    <message>
        <source>Layers
Choose what the map shows</source>
        <translation>图层
选择地图显示的内容</translation>
    </message>
    <message>
        <source>&amp;Behaviour</source>
        <translation>行为(&amp;B)</translation>
    </message>
    <message>
        <source>Select people first</source>
        <translation>请先选择行人</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>运行期间不可用：Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source>The scenario has no people yet</source>
        <translation>场景中还没有行人</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation>始终可见</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation>打开最近的文件(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>排列(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>All &amp;layers</source>
        <translation>所有图层(&amp;L)</translation>
    </message>
    <message>
        <source>Trail length</source>
        <translation>轨迹长度</translation>
    </message>
    <message>
        <source>&amp;Scenario</source>
        <translation>场景(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>粘贴到此处</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>Save the picture of the tree</source>
        <translation>保存树的图片</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>文档 (*.pdf)</translation>
    </message>
    <message>
        <source>Image (*.png)</source>
        <translation>图像 (*.png)</translation>
    </message>
    <message>
        <source>d MMM</source>
        <comment>format of a date</comment>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <comment>format of a date</comment>
        <translation>yyyy年M月d日</translation>
    </message>
    <message>
        <source>lidar: not side by side</source>
        <translation>激光雷达：并排视图中不显示</translation>
    </message>
</context>
<context>
    <name>Skin</name>
    <message>
        <source>Elegant man</source>
        <translation>优雅男士</translation>
    </message>
    <message>
        <source>Casual man</source>
        <translation>休闲男士</translation>
    </message>
    <message>
        <source>Elegant woman</source>
        <translation>优雅女士</translation>
    </message>
    <message>
        <source>Regular man</source>
        <translation>普通男士</translation>
    </message>
    <message>
        <source>Worker man</source>
        <translation>工人</translation>
    </message>
    <message>
        <source>Blue jeans</source>
        <translation>蓝色牛仔裤</translation>
    </message>
    <message>
        <source>Green t-shirt</source>
        <translation>绿色T恤</translation>
    </message>
    <message>
        <source>Blue t-shirt</source>
        <translation>蓝色T恤</translation>
    </message>
    <message>
        <source>Red t-shirt</source>
        <translation>红色T恤</translation>
    </message>
    <message>
        <source>Drawn by Isaac</source>
        <translation>由 Isaac 选择</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Selects items on the map. Click an item, or drag over empty space to select several. Drag the selection to move it, its handles to resize or rotate it. Shift adds to the selection, Alt suspends snapping.</source>
        <translation>选择地图上的对象。单击一个对象，或在空白处拖动以选择多个。拖动所选对象可移动它，拖动手柄可调整大小或旋转。Shift 追加选择，Alt 暂停吸附。</translation>
    </message>
    <message>
        <source>Places a person. Click the position, or press and drag to set the heading. A person walks when it has goals: place them with the goal tool and assign them with the route tool.</source>
        <translation>放置行人。单击位置，或按住并拖动以设置朝向。有目标点的行人才会行走：用目标点工具放置目标点，再用路线工具分配。</translation>
    </message>
    <message>
        <source>Places people along a line. Drag a line; spacing, width and the mix of behaviours are set in the bar at the top left of the map.</source>
        <translation>沿一条线放置行人。拖出一条线；间距、宽度和行为混合在地图左上角的栏中设置。</translation>
    </message>
    <message>
        <source>Fills an area with people. Drag a rectangle or click the corners of an area; the number of people and their goals are set in the bar at the top left of the map.</source>
        <translation>用行人填充一个区域。拖出一个矩形或单击区域的各个顶点；人数及其目标点在地图左上角的栏中设置。</translation>
    </message>
    <message>
        <source>Places goals. Click free space to add a goal; drag a goal to move it. Several people can share a goal.</source>
        <translation>放置目标点。单击空闲处添加目标点；拖动目标点可移动它。多个行人可以共用一个目标点。</translation>
    </message>
    <message>
        <source>Assigns goals to a person or robot. Click the person, then its goals in visiting order, then press Enter.</source>
        <translation>为行人或机器人分配目标点。单击行人，再按到访顺序单击其目标点，然后按 Enter。</translation>
    </message>
    <message>
        <source>Draws a wall as a line of segments. Click each corner; Enter or a double click ends the wall. People and robots cannot cross it.</source>
        <translation>用线段绘制墙。单击每个顶点；按 Enter 或双击结束。行人和机器人无法穿过墙。</translation>
    </message>
    <message>
        <source>Draws a rectangular obstacle from corner to corner. Shift makes a square.</source>
        <translation>从一角到对角绘制矩形障碍物。按住 Shift 绘制正方形。</translation>
    </message>
    <message>
        <source>Draws an obstacle with any number of corners. Click each corner; Enter or a click on the first corner closes it.</source>
        <translation>绘制任意顶点数的障碍物。单击每个顶点；按 Enter 或单击第一个顶点将其闭合。</translation>
    </message>
    <message>
        <source>Draws a round obstacle. Drag from its centre to its edge.</source>
        <translation>绘制圆形障碍物。从圆心拖动到边缘。</translation>
    </message>
    <message>
        <source>Draws a door. Drag from the hinge to the other jamb. The properties set when it opens and closes.</source>
        <translation>绘制门。从铰链拖动到另一侧门框。开关时间在属性中设置。</translation>
    </message>
    <message>
        <source>Draws an area, for example a source or sink of people, or a zone with a speed limit. Choose the kind in the bar at the top left of the map.</source>
        <translation>绘制区域，例如行人源、行人汇或限速区。在地图左上角的栏中选择类型。</translation>
    </message>
    <message>
        <source>Places the robot and its goal. Click the position (drag to set the heading), then click the goal. Shift adds another robot.</source>
        <translation>放置机器人及其目标点。单击位置（拖动以设置朝向），再单击目标点。Shift 添加另一个机器人。</translation>
    </message>
    <message>
        <source>Places a charging dock for robots with Nav2. Click the position of the docked robot and drag to set its heading.</source>
        <translation>为使用 Nav2 的机器人放置充电桩。单击停靠机器人的位置，拖动以设置其朝向。</translation>
    </message>
    <message>
        <source>Paints walls, free or unknown space into the cells of the map. Keys 1, 2 and 3 choose the kind, [ and ] the width.</source>
        <translation>在地图栅格中绘制墙、空闲或未知空间。按 1、2、3 选择类型，按 [ 和 ] 调整宽度。</translation>
    </message>
    <message>
        <source>Measures a distance and an angle. Drag from one point to another; the result is shown in the status bar.</source>
        <translation>测量距离和角度。从一点拖动到另一点；结果显示在状态栏中。</translation>
    </message>
    <message>
        <source>Removes items. Click them or drag over them. Routes of people are updated. Undo restores everything.</source>
        <translation>移除对象。单击或拖过它们。行人的路线会随之更新。撤销可全部恢复。</translation>
    </message>
    <message>
        <source>Moves the map. With any other tool, drag with the middle button, or hold Space and drag.</source>
        <translation>移动地图。使用其他工具时，可用鼠标中键拖动，或按住空格键拖动。</translation>
    </message>
    <message>
        <source>Everything in the scenario as a list: people, goals, robots, obstacles and areas. Select entries here or on the map. Double-click a name or press F2 to change it.</source>
        <translation>以列表显示场景中的所有内容：行人、目标点、机器人、障碍物和区域。可在此处或地图上选择条目。双击名称或按 F2 修改。</translation>
    </message>
    <message>
        <source>The properties of the selected items. A value in the secondary colour is the default; right-click a field to restore it. With nothing selected, the settings of the scenario are shown.</source>
        <translation>所选对象的属性。以次要颜色显示的值为默认值；右键单击字段可恢复默认值。未选择任何对象时显示场景设置。</translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as an outline. During a run it shows which nodes are active. Click beside a node to set a breakpoint.</source>
        <translation>以大纲显示所选行人的行为树。运行期间显示活动的节点。单击节点旁边可设置断点。</translation>
    </message>
    <message>
        <source>Errors and warnings of the scenario, checked while you edit. Double-click an entry to go to its place; many entries offer a fix.</source>
        <translation>场景的错误和警告，编辑时实时检查。双击条目可转到其位置；许多条目提供修复方法。</translation>
    </message>
    <message>
        <source>The metrics of the displayed run, updated while it runs. Select a metric to plot it over time; hover over it to read its definition.</source>
        <translation>当前显示的运行的指标，运行时实时更新。选择指标可绘制其随时间变化的曲线；悬停可查看定义。</translation>
    </message>
    <message>
        <source>What happened in the run: contacts, arrivals, reactions. Click an entry to show that moment.</source>
        <translation>运行中发生的事件：接触、到达、反应。单击条目可显示该时刻。</translation>
    </message>
    <message>
        <source>Branches of the run and recorded runs. Check several to compare their metrics and paths.</source>
        <translation>运行的分支和已录制的运行。勾选多个可比较其指标和路径。</translation>
    </message>
    <message>
        <source>Repeats the rest of the run many times from the displayed moment and shows how often a contact occurs.</source>
        <translation>从显示的时刻起多次重复剩余的运行，并显示接触发生的频率。</translation>
    </message>
    <message>
        <source>Runs scenarios with several planners and seeds and compares them with confidence intervals in a report.</source>
        <translation>用多个规划器和种子运行场景，并在报告中以置信区间进行比较。</translation>
    </message>
    <message>
        <source>What the map shows: people, routes, sensor data, costmaps and other layers, each with its opacity.</source>
        <translation>地图显示的内容：行人、路线、传感器数据、代价地图及其他图层，各有其不透明度。</translation>
    </message>
    <message>
        <source>The Nav2 parameters of the selected robot with defaults and explanations. Search by name, or show only what was changed.</source>
        <translation>所选机器人的 Nav2 参数及其默认值和说明。可按名称搜索，或仅显示已更改的参数。</translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as a graph. Drag nodes from the palette, press F8 to use the whole window.</source>
        <translation>以图形显示所选行人的行为树。从节点面板拖入节点，按 F8 使用整个窗口。</translation>
    </message>
    <message>
        <source>Open the manual (F1)</source>
        <translation>打开手册 (F1)</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>The scenario. The wheel zooms, the middle button or Space and drag move the map. The status bar says what the mouse does with the active tool. During a run, click a person for details; right-click to push, stop or add people.</source>
        <translation>场景。滚轮缩放，鼠标中键或空格键加拖动可移动地图。状态栏说明当前工具的鼠标操作。运行期间，单击行人查看详情；右键单击可推动、停止或添加行人。</translation>
    </message>
</context>
<context>
    <name>app::CommandPalette</name>
    <message>
        <source>Not available at the moment</source>
        <translation>当前不可用</translation>
    </message>
    <message>
        <source>Type a command or a key</source>
        <translation>输入命令或快捷键</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
</context>
<context>
    <name>app::DiffView</name>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>1 equal line</source>
        <translation>1 行相同</translation>
    </message>
    <message>
        <source>%1 equal lines</source>
        <translation>%1 行相同</translation>
    </message>
</context>
<context>
    <name>app::Docks</name>
    <message>
        <source>&amp;Map only</source>
        <translation>仅地图(&amp;M)</translation>
    </message>
    <message>
        <source>Close all panels; select again to restore them</source>
        <translation>关闭所有面板；再次选择可恢复</translation>
    </message>
    <message>
        <source>Tree instead of the map</source>
        <translation>以树代替地图</translation>
    </message>
    <message>
        <source>Show the behaviour tree instead of the map; select again to show the map</source>
        <translation>显示行为树代替地图；再次选择可显示地图</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation>始终可见</translation>
    </message>
    <message>
        <source>Open or close this panel</source>
        <translation>打开或关闭此面板</translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation>请先打开一个场景</translation>
    </message>
</context>
<context>
    <name>app::DocumentGuard</name>
    <message>
        <source>Export failed: %1.</source>
        <translation>导出失败：%1。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Cannot save a copy for crash recovery: %1</source>
        <translation>无法保存用于崩溃恢复的副本：%1</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier session cannot be read: %1</source>
        <translation>无法读取上次会话中未保存的更改：%1</translation>
    </message>
    <message>
        <source>an unnamed scenario</source>
        <translation>未命名的场景</translation>
    </message>
    <message>
        <source>The program ended unexpectedly. Unsaved changes to %1 were kept (%2).</source>
        <translation>程序意外退出。已保留对 %1 的未保存更改（%2）。</translation>
    </message>
    <message>
        <source>Unsaved changes to %1 were kept when the last session ended (%2).</source>
        <translation>上次会话结束时已保留对 %1 的未保存更改（%2）。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reloading discards unsaved changes.</source>
        <translation>%1 已被其他程序更改。重新加载会放弃未保存的更改。</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 已被其他程序更改。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. It is still open here.</source>
        <translation>%1 已被其他程序移动或删除。它在此处仍处于打开状态。</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>重新保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>%1 is also open in another window. The window that saves last overwrites the changes of the other.</source>
        <translation>%1 也在另一个窗口中打开。最后保存的窗口会覆盖另一个窗口的更改。</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be read. It will not be overwritten.</source>
        <translation>%1 已损坏，无法读取。不会覆盖该文件。</translation>
    </message>
    <message>
        <source>%1 is damaged and only partly loaded. It will not be overwritten.</source>
        <translation>%1 已损坏，仅部分加载。不会覆盖该文件。</translation>
    </message>
    <message>
        <source>Choose map…</source>
        <translation>选择地图…</translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation>使用开阔平面</translation>
    </message>
    <message>
        <source>Cannot open a file manager. The files are in %1.</source>
        <translation>无法打开文件管理器。文件位于 %1。</translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>已将 %1 导出到 %2。</translation>
    </message>
    <message>
        <source>file</source>
        <translation>个文件</translation>
    </message>
    <message>
        <source>files</source>
        <translation>个文件</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>显示文件夹</translation>
    </message>
    <message>
        <source>%1 was not saved: %2. Your changes are not lost.</source>
        <translation>%1 未保存：%2。您的更改没有丢失。</translation>
    </message>
    <message>
        <source>The file cannot be opened: %1</source>
        <translation>无法打开文件：%1</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>无法打开 %1：%2</translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>仿真器</translation>
    </message>
    <message>
        <source>Files to write</source>
        <translation>要写入的文件</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>Export folder</source>
        <translation>导出文件夹</translation>
    </message>
    <message>
        <source>For the simulator&apos;s package</source>
        <translation>用于仿真器的软件包</translation>
    </message>
    <message>
        <source>HuNavSim 2.0</source>
        <translation>HuNavSim 2.0</translation>
    </message>
    <message>
        <source>HuNavSim (2024)</source>
        <translation>HuNavSim (2024)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>已修正</translation>
    </message>
    <message>
        <source>As in HuNavSim 2.0</source>
        <translation>与 HuNavSim 2.0 相同</translation>
    </message>
    <message>
        <source>Missing trees</source>
        <translation>缺失的树</translation>
    </message>
    <message>
        <source>Launch command</source>
        <translation>启动命令</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>复制(&amp;P)</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>HuNavSim folder layout, for any simulator</source>
        <translation>HuNavSim 文件夹结构，适用于任何仿真器</translation>
    </message>
    <message>
        <source>For %1</source>
        <translation>用于 %1</translation>
    </message>
    <message>
        <source>Files: %1, none replaced</source>
        <translation>文件：%1 个，不替换任何文件</translation>
    </message>
    <message>
        <source>Files: %1, replaced: %2</source>
        <translation>文件：%1 个，替换：%2 个</translation>
    </message>
    <message>
        <source>Nothing is lost</source>
        <translation>没有任何丢失</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>信息</translation>
    </message>
</context>
<context>
    <name>app::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Reading the run…</source>
        <translation>正在读取运行…</translation>
    </message>
</context>
<context>
    <name>app::FigureCommands</name>
    <message>
        <source>Start a run first: Space</source>
        <translation>请先开始运行：空格键</translation>
    </message>
    <message>
        <source>Copied the map at %1 s as PNG and SVG</source>
        <translation>已将 %1 s 时的地图复制为 PNG 和 SVG</translation>
    </message>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation>已将“%1”的曲线图复制为 PNG 和 SVG</translation>
    </message>
</context>
<context>
    <name>app::FileCommands</name>
    <message>
        <source>Assign tree</source>
        <translation>分配树</translation>
    </message>
    <message>
        <source>Apply command-line options</source>
        <translation>应用命令行选项</translation>
    </message>
    <message>
        <source>Add command-line robot</source>
        <translation>添加命令行指定的机器人</translation>
    </message>
    <message>
        <source>Maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</source>
        <translation>地图、地图图像 (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation>打开场景或地图</translation>
    </message>
    <message>
        <source>Scenarios, maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</source>
        <translation>场景、地图、地图图像 (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>New scenario from a map</source>
        <translation>从地图新建场景</translation>
    </message>
    <message>
        <source>Change map</source>
        <translation>更换地图</translation>
    </message>
    <message>
        <source>Open run folder</source>
        <translation>打开运行文件夹</translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation>%1（已截断）</translation>
    </message>
    <message>
        <source>Import trajectories</source>
        <translation>导入轨迹</translation>
    </message>
    <message>
        <source>Trajectories (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;All files (*)</source>
        <translation>轨迹 (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 was changed by another program after it was opened; saving overwrites those changes.</source>
        <translation>%1 打开后已被其他程序更改；保存会覆盖这些更改。</translation>
    </message>
    <message>
        <source>%1 has a comment, which is lost when you save.</source>
        <translation>%1 有一条注释，保存时会丢失。</translation>
    </message>
    <message>
        <source>%1 has %2 comments, which are lost when you save.</source>
        <translation>%1 有 %2 条注释，保存时会丢失。</translation>
    </message>
    <message>
        <source>Save anyway?</source>
        <translation>仍要保存吗？</translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation>覆盖该文件吗？</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml)</source>
        <translation>场景 (*.yaml)</translation>
    </message>
    <message>
        <source>This file is a map</source>
        <translation>此文件是地图</translation>
    </message>
    <message>
        <source>%1 is a map or a map image. Saving the scenario there would overwrite it. Choose another name, such as %2.</source>
        <translation>%1 是地图或地图图像。将场景保存在那里会覆盖它。请选择其他名称，例如 %2。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>File not found</source>
        <translation>找不到文件</translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation>先保存对 %1 的更改吗？</translation>
    </message>
    <message>
        <source>%1 was moved or deleted. Save it again first?</source>
        <translation>%1 已被移动或删除。先重新保存吗？</translation>
    </message>
</context>
<context>
    <name>app::GuidedTour</name>
    <message>
        <source>Place a person</source>
        <translation>放置一个行人</translation>
    </message>
    <message>
        <source>Give the person a goal</source>
        <translation>给行人一个目标点</translation>
    </message>
    <message>
        <source>Run the simulation</source>
        <translation>运行仿真</translation>
    </message>
    <message>
        <source>Read a metric</source>
        <translation>查看一个指标</translation>
    </message>
    <message>
        <source>You have run your first scenario</source>
        <translation>您已运行第一个场景</translation>
    </message>
    <message>
        <source>Click on the map where the person should walk to.</source>
        <translation>在地图上单击行人应走到的位置。</translation>
    </message>
    <message>
        <source>Press %1 or click the goal tool.</source>
        <translation>按 %1 或单击目标点工具。</translation>
    </message>
    <message>
        <source>Click the person, then the goal, then press Enter.</source>
        <translation>单击行人，再单击目标点，然后按 Enter。</translation>
    </message>
    <message>
        <source>The goal is there; now assign it. Press %1 for the route tool, click the person, then the goal, then press Enter.</source>
        <translation>目标点已放置；现在分配它。按 %1 选择路线工具，单击行人，再单击目标点，然后按 Enter。</translation>
    </message>
    <message>
        <source>Click on the map where the person should start.</source>
        <translation>在地图上单击行人的起始位置。</translation>
    </message>
    <message>
        <source>Press %1 or click the person tool.</source>
        <translation>按 %1 或单击行人工具。</translation>
    </message>
    <message>
        <source>The person walks to the goal …</source>
        <translation>行人正走向目标点 …</translation>
    </message>
    <message>
        <source>Press Space, or Play in the tool bar.</source>
        <translation>按空格键，或单击工具栏中的“播放”。</translation>
    </message>
    <message>
        <source>Click a metric in the list to plot it over time.</source>
        <translation>单击列表中的指标以绘制其随时间变化的曲线。</translation>
    </message>
    <message>
        <source>Click Metrics in the status bar at the bottom.</source>
        <translation>单击底部状态栏中的“指标”。</translation>
    </message>
    <message>
        <source>Ctrl+R returns to editing, %1 finds every command, F1 opens the manual. The next chapter adds a robot.</source>
        <translation>Ctrl+R 返回编辑，%1 可查找所有命令，F1 打开手册。下一章将添加机器人。</translation>
    </message>
    <message>
        <source>First scenario in the manual</source>
        <translation>手册中的第一个场景</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>新手引导</translation>
    </message>
    <message>
        <source>Tour finished</source>
        <translation>引导已完成</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Skip tour</source>
        <translation>跳过引导</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>关闭引导</translation>
    </message>
    <message>
        <source>End the tour; the scenario stays open</source>
        <translation>结束引导；场景保持打开</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>打开手册</translation>
    </message>
</context>
<context>
    <name>app::HistoryDialog</name>
    <message>
        <source>Run history</source>
        <translation>运行历史</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory per run</source>
        <translation>每次运行的内存</translation>
    </message>
    <message>
        <source>Memory per run
Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation>每次运行的内存
用于存储时间轴可显示的运行步的内存。200 名行人每分钟约需 12 MB。</translation>
    </message>
    <message>
        <source>Older steps are stored in a temporary file until the run is closed. When the disk is full, the oldest are deleted and the timeline starts later.</source>
        <translation>较早的步存储在临时文件中，直到运行关闭。磁盘已满时，最早的步会被删除，时间轴的起点随之后移。</translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation>适用于从现在起开始的运行。</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设置</translation>
    </message>
</context>
<context>
    <name>app::ImageMapDialog</name>
    <message>
        <source>Map from an image</source>
        <translation>从图像创建地图</translation>
    </message>
    <message>
        <source> m per pixel</source>
        <translation> m/像素</translation>
    </message>
    <message>
        <source>Create map</source>
        <translation>创建地图</translation>
    </message>
    <message>
        <source>Map scale</source>
        <translation>地图比例</translation>
    </message>
    <message>
        <source>Distance 1 – 2</source>
        <translation>距离 1 – 2</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Click two points with a known distance, such as the ends of a wall.</source>
        <translation>单击两个距离已知的点，例如一面墙的两端。</translation>
    </message>
    <message>
        <source>Click the second point.</source>
        <translation>单击第二个点。</translation>
    </message>
    <message>
        <source>Enter the distance between the two points. You can drag them.</source>
        <translation>输入两点之间的距离。可以拖动这些点。</translation>
    </message>
    <message>
        <source>%1 m per pixel is out of range (%2 to %3).</source>
        <translation>%1 m/像素超出范围（%2 至 %3）。</translation>
    </message>
    <message>
        <source>Position of lower left corner</source>
        <translation>左下角的位置</translation>
    </message>
    <message>
        <source>Position of point 1</source>
        <translation>点 1 的位置</translation>
    </message>
    <message>
        <source>The map will be %1 × %2 m.</source>
        <translation>地图大小为 %1 × %2 m。</translation>
    </message>
    <message>
        <source>By two points in the image</source>
        <translation>通过图像中的两点</translation>
    </message>
    <message>
        <source>By resolution</source>
        <translation>按分辨率</translation>
    </message>
</context>
<context>
    <name>app::KeyMap</name>
    <message>
        <source>%1 is used by fields, lists and tools and cannot be assigned.</source>
        <translation>%1 由字段、列表和工具使用，无法分配。</translation>
    </message>
</context>
<context>
    <name>app::KeyRules</name>
    <message>
        <source>While you edit a text, the text field handles all keys that it uses; number fields do not use Space. Enter accepts the text, Esc discards it; both return the keyboard focus to the map. Ctrl+Z undoes typing only while an edit is not accepted.</source>
        <translation>编辑文本时，文本字段处理它使用的所有按键；数字字段不使用空格键。Enter 接受文本，Esc 放弃文本；两者都会将键盘焦点返回地图。仅在编辑尚未被接受时，Ctrl+Z 才撤销输入。</translation>
    </message>
    <message>
        <source>A list handles the keys that move in it, Space in rows with a check box, and Delete if its rows can be removed. Only in the scenario list does Delete remove the selection on the map.</source>
        <translation>列表处理在其中移动的按键、带复选框行中的空格键，以及可移除行的 Delete 键。只有在场景列表中，Delete 才会移除地图上的所选对象。</translation>
    </message>
    <message>
        <source>A click on a button, check box or combo box does not move the keyboard focus. After you reach one with Tab, use Space and the arrow keys.</source>
        <translation>单击按钮、复选框或组合框不会移动键盘焦点。用 Tab 键移到它们之后，可使用空格键和方向键。</translation>
    </message>
    <message>
        <source>All other keys go to the commands of the window, such as Space to run and pause, then to the map tool. The arrow keys move items only while the map has the focus; while you drive a robot manually, they drive it, as do W, A, S and D.</source>
        <translation>所有其他按键先交给窗口的命令（例如空格键用于运行和暂停），然后交给地图工具。只有地图拥有焦点时，方向键才移动对象；手动操控机器人时，方向键以及 W、A、S、D 用于操控机器人。</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>A recorded run cannot be edited: Ctrl+R closes it</source>
        <translation>无法编辑已录制的运行：Ctrl+R 将其关闭</translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation>请先打开一个场景</translation>
    </message>
    <message>
        <source>A recorded run is shown: Ctrl+R closes it</source>
        <translation>正在显示已录制的运行：Ctrl+R 将其关闭</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>运行期间不可用：Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source>HuNavSim Desktop</source>
        <translation>HuNavSim Desktop</translation>
    </message>
    <message>
        <source>%1 (recorded run) – HuNavSim Desktop</source>
        <translation>%1（已录制的运行）– HuNavSim Desktop</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>已录制的运行</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>Read only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>The options of the command line replace values of %1. Saving writes them to the file.</source>
        <translation>命令行选项替换了 %1 的值。保存会将其写入文件。</translation>
    </message>
    <message>
        <source>Use the values of the file</source>
        <translation>使用文件中的值</translation>
    </message>
    <message>
        <source>About HuNavSim Desktop</source>
        <translation>关于 HuNavSim Desktop</translation>
    </message>
    <message>
        <source>&lt;b&gt;HuNavSim Desktop %1&lt;/b&gt;&lt;br&gt;Scenarios for human-aware navigation: draw, simulate, measure.</source>
        <translation>&lt;b&gt;HuNavSim Desktop %1&lt;/b&gt;&lt;br&gt;面向人机共融导航的场景：绘制、仿真、测量。</translation>
    </message>
</context>
<context>
    <name>app::ManualViewer</name>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>HuNavSim Desktop manual</source>
        <translation>HuNavSim Desktop 手册</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Show the previous page</source>
        <translation>显示上一页</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Show the next page again</source>
        <translation>再次显示下一页</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source># Page not found

The manual has no file `%1.md` in `%2`. Reinstall the program, or read the manual on the project&apos;s page.</source>
        <translation># 找不到页面

手册在 `%2` 中没有文件 `%1.md`。请重新安装程序，或在项目页面上阅读手册。</translation>
    </message>
</context>
<context>
    <name>app::NoticeBar</name>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation>已将“%1”的曲线图复制为 PNG 和 SVG</translation>
    </message>
    <message>
        <source>Save plot</source>
        <translation>保存曲线图</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Vector picture (*.svg)</source>
        <translation>矢量图片 (*.svg)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved the plot of “%1” to %2</source>
        <translation>已将“%1”的曲线图保存到 %2</translation>
    </message>
</context>
<context>
    <name>app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>常规(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Key&amp;board</source>
        <translation>键盘(&amp;B)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>窗口的颜色</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>与系统一致</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>窗口的语言</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Used from the next start on.</source>
        <translation>下次启动时生效。</translation>
    </message>
    <message>
        <source>Animations
Without them, the map changes at once</source>
        <translation>动画
关闭后，地图立即变化</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Run history</source>
        <translation>运行历史</translation>
    </message>
    <message>
        <source>Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation>用于存储时间轴可显示的运行步的内存。200 名行人每分钟约需 12 MB。</translation>
    </message>
    <message>
        <source>Run &amp;history</source>
        <translation>运行历史(&amp;H)</translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation>适用于从现在起开始的运行。</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>Numbers have a decimal point (1.5) in every language, as in files. Fields also accept a comma.</source>
        <translation>在所有语言中，数字都使用小数点 (1.5)，与文件中一致。字段也接受逗号。</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>Choose the default folder</source>
        <translation>选择默认文件夹</translation>
    </message>
    <message>
        <source>Default folder</source>
        <translation>默认文件夹</translation>
    </message>
    <message>
        <source>Where file dialogs start for a scenario that is not saved yet</source>
        <translation>对于尚未保存的场景，文件对话框的起始位置</translation>
    </message>
    <message>
        <source>Folder of the last used file</source>
        <translation>上次使用的文件所在的文件夹</translation>
    </message>
    <message>
        <source>&amp;Default folder</source>
        <translation>默认文件夹(&amp;D)</translation>
    </message>
    <message>
        <source>Copies of unsaved changes
After a crash, the program offers to restore them</source>
        <translation>未保存更改的副本
崩溃后，程序会提示恢复</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Copy after</source>
        <translation>复制间隔</translation>
    </message>
    <message>
        <source>The longest time between a change and its copy</source>
        <translation>更改与其副本之间的最长时间</translation>
    </message>
    <message>
        <source>C&amp;opy after</source>
        <translation>复制间隔(&amp;O)</translation>
    </message>
    <message>
        <source>The scenario file itself is written only when you save it.</source>
        <translation>仅在您保存时才会写入场景文件本身。</translation>
    </message>
    <message>
        <source>R&amp;estore defaults</source>
        <translation>恢复默认设置(&amp;E)</translation>
    </message>
    <message>
        <source>Restore the defaults of all pages</source>
        <translation>恢复所有页面的默认设置</translation>
    </message>
    <message>
        <source>&amp;Animate zooming and fitting</source>
        <translation>缩放和适应窗口时显示动画(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Keep copies of unsaved changes</source>
        <translation>保留未保存更改的副本(&amp;K)</translation>
    </message>
    <message>
        <source>Like the desktop</source>
        <translation>与桌面一致</translation>
    </message>
</context>
<context>
    <name>app::RecentRow</name>
    <message>
        <source>File not found</source>
        <translation>找不到文件</translation>
    </message>
    <message>
        <source>File not found in </source>
        <translation>找不到文件，位置： </translation>
    </message>
    <message>
        <source>Folder not found: </source>
        <translation>找不到文件夹： </translation>
    </message>
</context>
<context>
    <name>app::RoomDialog</name>
    <message>
        <source>New empty room</source>
        <translation>新建空房间</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Room with four walls</source>
        <translation>四面有墙的房间</translation>
    </message>
    <message>
        <source>Open plane without a map</source>
        <translation>无地图的开阔平面</translation>
    </message>
</context>
<context>
    <name>app::RunExportCommands</name>
    <message>
        <source>Open a scenario or a run first</source>
        <translation>请先打开场景或运行</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>请先开始运行：空格键</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Save film</source>
        <translation>保存视频</translation>
    </message>
</context>
<context>
    <name>app::RunExportDialog</name>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>People per m² as a colour map</source>
        <translation>以色彩图显示每平方米人数</translation>
    </message>
    <message>
        <source>Hall zones</source>
        <translation>Hall 区域</translation>
    </message>
    <message>
        <source>Intimate, personal and social zone of each person</source>
        <translation>每个行人的亲密、个人和社交区域</translation>
    </message>
    <message>
        <source>Gaussian spaces</source>
        <translation>高斯空间</translation>
    </message>
    <message>
        <source>Gaussian personal space, longer in the walking direction</source>
        <translation>高斯个人空间，在行走方向上更长</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Velocity vector of each body</source>
        <translation>每个物体的速度矢量</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Forces on each person</source>
        <translation>作用于每个行人的力</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Where bodies touched</source>
        <translation>物体接触的位置</translation>
    </message>
    <message>
        <source>%1 – requires ffmpeg</source>
        <translation>%1 – 需要 ffmpeg</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Time marks</source>
        <translation>时间标记</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Interval of dots with the time on each trajectory; 0: none</source>
        <translation>每条轨迹上时间点的间隔；0：无</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Height
The lowest value is the height that the map requires</source>
        <translation>高度
最小值为地图所需的高度</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>叠加层</translation>
    </message>
    <message>
        <source>Names below the bodies</source>
        <translation>在物体下方显示名称</translation>
    </message>
    <message>
        <source>Forces are not recorded: only a run of this window has them</source>
        <translation>力未被记录：只有此窗口中的运行才有</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Nothing can be drawn: %1</source>
        <translation>无法绘制：%1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>Stopped. No file was written.</source>
        <translation>已停止。未写入任何文件。</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
</context>
<context>
    <name>app::RunSharing</name>
    <message>
        <source>Watch this run at %1 (Foxglove: Open connection)</source>
        <translation>在 %1 观看此运行（Foxglove：Open connection）</translation>
    </message>
    <message>
        <source>Copy address</source>
        <translation>复制地址</translation>
    </message>
</context>
<context>
    <name>app::SaveFilmDialog</name>
    <message>
        <source>Save film</source>
        <translation>保存视频</translation>
    </message>
    <message>
        <source>GIF</source>
        <translation>GIF</translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation>MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>WebM (VP9)</source>
        <translation>WebM (VP9)</translation>
    </message>
    <message>
        <source>MP4, WebP and WebM require the program ffmpeg, which is not installed: sudo apt install ffmpeg</source>
        <translation>MP4、WebP 和 WebM 需要 ffmpeg 程序，但尚未安装：sudo apt install ffmpeg</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>整个运行</translation>
    </message>
    <message>
        <source>Save all of the run</source>
        <translation>保存整个运行</translation>
    </message>
    <message>
        <source>Loop section</source>
        <translation>循环片段</translation>
    </message>
    <message>
        <source>Save the section that is repeated on the timeline</source>
        <translation>保存时间轴上循环的片段</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>fps</source>
        <translation>fps</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Simulated seconds per second of the film</source>
        <translation>视频每秒对应的仿真秒数</translation>
    </message>
    <message>
        <source>Time of the preview</source>
        <translation>预览的时间</translation>
    </message>
    <message>
        <source>Show another frame of the film in the preview</source>
        <translation>在预览中显示视频的另一帧</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>At most %1 for a GIF</source>
        <translation>GIF 最多 %1</translation>
    </message>
    <message>
        <source>%1 frames, %2 s</source>
        <translation>%1 帧，%2 s</translation>
    </message>
    <message>
        <source>The end must be after the start</source>
        <translation>结束时间必须晚于开始时间</translation>
    </message>
    <message>
        <source>1280 px wide</source>
        <translation>宽 1280 px</translation>
    </message>
    <message>
        <source>HD, 1280 × 720</source>
        <translation>高清，1280 × 720</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>全高清，1920 × 1080</translation>
    </message>
    <message>
        <source>Small, 640 px wide</source>
        <translation>小，宽 640 px</translation>
    </message>
</context>
<context>
    <name>app::SavePictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>PNG – pixels</source>
        <translation>PNG – 像素</translation>
    </message>
    <message>
        <source>SVG – vectors</source>
        <translation>SVG – 矢量</translation>
    </message>
    <message>
        <source>PDF – vectors</source>
        <translation>PDF – 矢量</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Time of the picture</source>
        <translation>图片的时间</translation>
    </message>
    <message>
        <source>Two columns, 170 mm</source>
        <translation>双栏，170 mm</translation>
    </message>
    <message>
        <source>One column, 85 mm</source>
        <translation>单栏，85 mm</translation>
    </message>
    <message>
        <source>Slide, 16 : 9</source>
        <translation>幻灯片，16 : 9</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>Two columns, 170 mm at 300 dpi</source>
        <translation>双栏，170 mm，300 dpi</translation>
    </message>
    <message>
        <source>One column, 85 mm at 300 dpi</source>
        <translation>单栏，85 mm，300 dpi</translation>
    </message>
</context>
<context>
    <name>app::ScaleView</name>
    <message>
        <source>Map image</source>
        <translation>地图图像</translation>
    </message>
</context>
<context>
    <name>app::ScenarioGallery</name>
    <message>
        <source>Find a scenario</source>
        <translation>查找场景</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Show the scenarios of one family</source>
        <translation>显示某一类别的场景</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>难度</translation>
    </message>
    <message>
        <source>Show the scenarios of one difficulty</source>
        <translation>显示某一难度的场景</translation>
    </message>
    <message>
        <source>No scenario matches the search and the filters.</source>
        <translation>没有与搜索和筛选条件匹配的场景。</translation>
    </message>
    <message>
        <source>Show all scenarios</source>
        <translation>显示所有场景</translation>
    </message>
    <message>
        <source>Clear the search and the filters</source>
        <translation>清除搜索和筛选条件</translation>
    </message>
    <message>
        <source>All families</source>
        <translation>所有类别</translation>
    </message>
    <message>
        <source>Any difficulty</source>
        <translation>任意难度</translation>
    </message>
</context>
<context>
    <name>app::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
</context>
<context>
    <name>app::ShortcutsPage</name>
    <message>
        <source>Find a command or a key</source>
        <translation>查找命令或按键</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>新按键</translation>
    </message>
    <message>
        <source>New keys
Press the keys for the selected command</source>
        <translation>新按键
按下要用于所选命令的按键</translation>
    </message>
    <message>
        <source>Press keys</source>
        <translation>按下按键</translation>
    </message>
    <message>
        <source>Give these keys to the selected command</source>
        <translation>将这些按键分配给所选命令</translation>
    </message>
    <message>
        <source>Remove the keys of the selected command</source>
        <translation>移除所选命令的按键</translation>
    </message>
    <message>
        <source>Restore the default keys of the selected command</source>
        <translation>恢复所选命令的默认按键</translation>
    </message>
    <message>
        <source>Restore the default keys of all commands</source>
        <translation>恢复所有命令的默认按键</translation>
    </message>
    <message>
        <source>Select a command to change its keys</source>
        <translation>选择一个命令以更改其按键</translation>
    </message>
    <message>
        <source>Keys for &quot;%1&quot;</source>
        <translation>“%1”的按键</translation>
    </message>
    <message>
        <source>This key belongs to the active tool and cannot be changed.</source>
        <translation>此按键属于当前工具，无法更改。</translation>
    </message>
    <message>
        <source>%1 is used by &quot;%2&quot; (%3). Assigning removes it there.</source>
        <translation>%1 已由“%2”（%3）使用。分配后会从那里移除。</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>分配(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>默认(&amp;D)</translation>
    </message>
    <message>
        <source>Restore a&amp;ll defaults</source>
        <translation>恢复所有默认设置(&amp;L)</translation>
    </message>
</context>
<context>
    <name>app::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Place people and a robot on a map, then press Space to simulate them.</source>
        <translation>在地图上放置行人和机器人，然后按空格键进行仿真。</translation>
    </message>
    <message>
        <source>Drop a scenario or a map anywhere on this window to open it.</source>
        <translation>将场景或地图拖放到此窗口的任意位置即可打开。</translation>
    </message>
    <message>
        <source>New from a map</source>
        <translation>从地图新建</translation>
    </message>
    <message>
        <source>Nav2 map or floor plan image</source>
        <translation>Nav2 地图或平面图图像</translation>
    </message>
    <message>
        <source>New empty room</source>
        <translation>新建空房间</translation>
    </message>
    <message>
        <source>Four walls, or an open plane</source>
        <translation>四面墙，或开阔平面</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Scenario or map</source>
        <translation>场景或地图</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>新手引导</translation>
    </message>
    <message>
        <source>Your first run in two minutes</source>
        <translation>两分钟完成第一次运行</translation>
    </message>
    <message>
        <source>Watch a recording…</source>
        <translation>观看录制…</translation>
    </message>
    <message>
        <source>Output folder of a run</source>
        <translation>运行的输出文件夹</translation>
    </message>
    <message>
        <source>Import trajectories…</source>
        <translation>导入轨迹…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>No recent files. Open a scenario on the right, or take the guided tour.</source>
        <translation>没有最近的文件。请打开右侧的场景，或参加新手引导。</translation>
    </message>
    <message>
        <source>CSV, JuPedSim, TrajNet++ and others</source>
        <translation>CSV、JuPedSim、TrajNet++ 等</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2 after its start</source>
        <translation>%1，出发后 %2</translation>
    </message>
    <message>
        <source>The robot has arrived, %1 · </source>
        <translation>机器人已到达，%1 · </translation>
    </message>
    <message>
        <source>Time limit reached, %1 · </source>
        <translation>已达到时间限制，%1 · </translation>
    </message>
    <message>
        <source>The robot collided, %1 · </source>
        <translation>机器人发生碰撞，%1 · </translation>
    </message>
    <message>
        <source>Navigation failed%1, %2 · </source>
        <translation>导航失败%1，%2 · </translation>
    </message>
    <message>
        <source>Navigation succeeded, but not at the goal, %1 · </source>
        <translation>导航成功，但不在目标点，%1 · </translation>
    </message>
    <message>
        <source>The robot is stuck, %1 · </source>
        <translation>机器人被困，%1 · </translation>
    </message>
    <message>
        <source>Playing back</source>
        <translation>正在回放</translation>
    </message>
    <message>
        <source>Space pauses · End shows the last step</source>
        <translation>空格键暂停 · End 显示最后一步</translation>
    </message>
    <message>
        <source>Playback paused</source>
        <translation>回放已暂停</translation>
    </message>
    <message>
        <source>Space plays from here · Ctrl+R returns to editing</source>
        <translation>空格键从此处播放 · Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source>Space resumes · End returns to the newest step</source>
        <translation>空格键继续 · End 返回最新一步</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>已录制的运行</translation>
    </message>
    <message>
        <source>Space plays and pauses · . and , step · Ctrl+R closes it</source>
        <translation>空格键播放和暂停 · . 和 , 单步 · Ctrl+R 关闭</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Space pauses · Click a person for details</source>
        <translation>空格键暂停 · 单击行人查看详情</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Space replays · Ctrl+R returns to editing</source>
        <translation>空格键重新播放 · Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source>Stopped at %1 · </source>
        <translation>停在 %1 · </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Space resumes · . steps · Ctrl+R returns to editing</source>
        <translation>空格键继续 · . 单步 · Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Click a scenario to open it · Space runs it</source>
        <translation>单击场景将其打开 · 空格键运行</translation>
    </message>
    <message>
        <source>open</source>
        <translation>开阔</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>free</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>%1 px/m</source>
        <translation>%1 px/m</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>种子 %1</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × 实时</translation>
    </message>
    <message>
        <source>%1, %2 m · %3</source>
        <translation>%1, %2 m · %3</translation>
    </message>
    <message>
        <source>F8 returns to the map</source>
        <translation>按 F8 返回地图</translation>
    </message>
</context>
<context>
    <name>app::StudyForm</name>
    <message>
        <source>Other parameters, one per line</source>
        <translation>其他参数，每行一个</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Number or list of seeds: 30 or [3, 7, 11]</source>
        <translation>种子的数量或列表：30 或 [3, 7, 11]</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>from scenario</source>
        <translation>取自场景</translation>
    </message>
    <message>
        <source>Maximum duration of each run [s]; empty: as in the scenario</source>
        <translation>每次运行的最长时间 [s]；留空：与场景相同</translation>
    </message>
    <message>
        <source>metrics only</source>
        <translation>仅指标</translation>
    </message>
    <message>
        <source>runs with an error</source>
        <translation>出错的运行</translation>
    </message>
    <message>
        <source>failures only</source>
        <translation>仅失败的运行</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>所有运行</translation>
    </message>
    <message>
        <source>Keep recordings</source>
        <translation>保留录制</translation>
    </message>
    <message>
        <source>Runs whose files are kept in the results folder. Failures are runs with an error and runs whose robot did not succeed.</source>
        <translation>其文件保留在结果文件夹中的运行。失败是指出错的运行以及机器人未成功的运行。</translation>
    </message>
    <message>
        <source>Other parameters</source>
        <translation>其他参数</translation>
    </message>
    <message>
        <source>A list tests each value. {normal: [mean, deviation, minimum, maximum]}, {uniform: [from, to]} and {choice: […]} are sampled for each seed, equally for all planners.</source>
        <translation>列表会测试每个值。{normal: [均值, 标准差, 最小值, 最大值]}、{uniform: [从, 到]} 和 {choice: […]} 对每个种子采样，对所有规划器相同。</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Add current</source>
        <translation>添加当前</translation>
    </message>
    <message>
        <source>Add the open scenario</source>
        <translation>添加打开的场景</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>Add scenario files</source>
        <translation>添加场景文件</translation>
    </message>
    <message>
        <source>Press Delete to remove the selection</source>
        <translation>按 Delete 移除所选项</translation>
    </message>
    <message>
        <source>Save the scenario first</source>
        <translation>请先保存场景</translation>
    </message>
    <message>
        <source>Planners to compare</source>
        <translation>要比较的规划器</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Add scenarios</source>
        <translation>添加场景</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml *.yml)</source>
        <translation>场景 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>No scenarios: add or drop files here</source>
        <translation>没有场景：在此处添加或拖放文件</translation>
    </message>
    <message>
        <source>Save the open scenario first, or add files</source>
        <translation>请先保存打开的场景，或添加文件</translation>
    </message>
</context>
<context>
    <name>app::StudyPanel</name>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open an experiment file</source>
        <translation>打开实验文件</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Save the experiment as a file; its results are stored beside it</source>
        <translation>将实验保存为文件；其结果保存在旁边</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Write a page with tables, confidence intervals, tests and figures</source>
        <translation>生成包含表格、置信区间、检验和图的页面</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>新建研究</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>保存研究</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>打开研究</translation>
    </message>
    <message>
        <source>Experiments (*.yaml *.yml)</source>
        <translation>实验 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation>已完成 %1 / %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Delete the results in the folder</source>
        <translation>删除文件夹中的结果</translation>
    </message>
    <message>
        <source>Its runs start external programs: allow them above the map</source>
        <translation>其运行会启动外部程序：请在地图上方允许</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在启动…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 / %2 次运行</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>，剩余 %1</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>，%1 次失败</translation>
    </message>
    <message>
        <source>: stopped, finished runs are kept</source>
        <translation>：已停止，已完成的运行会保留</translation>
    </message>
    <message>
        <source>Run %1 was not recorded, and its experiment can no longer be read</source>
        <translation>运行 %1 未录制，且其实验已无法读取</translation>
    </message>
    <message>
        <source>Replaying run %1…</source>
        <translation>正在重放运行 %1…</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>正在写入报告…</translation>
    </message>
    <message>
        <source>All seeds have the same people: to vary them, set &quot;Variation between seeds&quot; in the properties of the scenario</source>
        <translation>所有种子的行人都相同：要使其变化，请在场景属性中设置“种子间的变化”</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Begin a new study of the open scenario</source>
        <translation>为打开的场景新建研究</translation>
    </message>
    <message>
        <source>Save and start</source>
        <translation>保存并开始</translation>
    </message>
    <message>
        <source>Save the open scenario, then start</source>
        <translation>保存打开的场景，然后开始</translation>
    </message>
    <message>
        <source>Start without them</source>
        <translation>不保存，直接开始</translation>
    </message>
    <message>
        <source>Run the file as it was last saved</source>
        <translation>使用上次保存的文件</translation>
    </message>
    <message>
        <source>%1 has unsaved changes, which this study would not use</source>
        <translation>%1 有未保存的更改，本研究不会使用它们</translation>
    </message>
    <message>
        <source>Save %1 before the start: it has unsaved changes</source>
        <translation>开始前请保存 %1：它有未保存的更改</translation>
    </message>
</context>
<context>
    <name>app::StudyProcess</name>
    <message>
        <source>The batch process crashed.</source>
        <translation>批处理进程已崩溃。</translation>
    </message>
</context>
<context>
    <name>app::StudyResults</name>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Choose scenarios and planners on the left, then press Start.
For each seed, all planners run with the same people.</source>
        <translation>在左侧选择场景和规划器，然后按“开始”。
对于每个种子，所有规划器都与相同的行人一起运行。</translation>
    </message>
    <message>
        <source>Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one scale per column. Rates: Wilson; other metrics: bootstrap (BCa).</source>
        <translation>已完成运行的均值 [95 % 置信区间]。条形：相同的区间，每列使用同一比例尺。比率：Wilson；其他指标：bootstrap (BCa)。</translation>
    </message>
    <message>
        <source>Runs of the study</source>
        <translation>研究的运行</translation>
    </message>
    <message>
        <source>Double-click a run to play it</source>
        <translation>双击运行可播放</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
</context>
<context>
    <name>app::StudyRunsModel</name>
    <message>
        <source>failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>结束</translation>
    </message>
</context>
<context>
    <name>app::TreeChoiceDialog</name>
    <message>
        <source>Apply to all %1</source>
        <translation>应用于全部 %1 个</translation>
    </message>
    <message>
        <source>Custom trees</source>
        <translation>自定义树</translation>
    </message>
    <message>
        <source>Saving would overwrite custom trees</source>
        <translation>保存会覆盖自定义树</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: the file %2 was changed by another program.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;：文件 %2 已被其他程序更改。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: behaviour or goals changed after this custom tree was written.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;：写入此自定义树后，行为或目标点已更改。</translation>
    </message>
    <message>
        <source>Keep the tree in the file</source>
        <translation>保留文件中的树</translation>
    </message>
    <message>
        <source>Keep the custom tree</source>
        <translation>保留自定义树</translation>
    </message>
    <message>
        <source>Replace it with the tree in this window</source>
        <translation>用此窗口中的树替换</translation>
    </message>
    <message>
        <source>Use the generated tree</source>
        <translation>使用生成的树</translation>
    </message>
    <message>
        <source>− in the file   + in this window</source>
        <translation>− 文件中   + 此窗口中</translation>
    </message>
    <message>
        <source>− custom   + generated</source>
        <translation>− 自定义   + 生成</translation>
    </message>
    <message>
        <source>Hide differences</source>
        <translation>隐藏差异</translation>
    </message>
    <message>
        <source>Show differences (−%1 +%2 lines)</source>
        <translation>显示差异（−%1 +%2 行）</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>替换</translation>
    </message>
</context>
<context>
    <name>app::TreeCommands</name>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
</context>
<context>
    <name>app::WindowActions</name>
    <message>
        <source>Show or hide on the map</source>
        <translation>在地图上显示或隐藏</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Rou&amp;tes</source>
        <translation>路线(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>网格(&amp;G)</translation>
    </message>
    <message>
        <source>R&amp;ulers</source>
        <translation>标尺(&amp;U)</translation>
    </message>
    <message>
        <source>Tr&amp;ails</source>
        <translation>轨迹(&amp;A)</translation>
    </message>
    <message>
        <source>Past paths of people in a run</source>
        <translation>运行中行人走过的路径</translation>
    </message>
    <message>
        <source>&amp;Personal spaces</source>
        <translation>个人空间(&amp;P)</translation>
    </message>
    <message>
        <source>Hall&apos;s zones around selected people; in a run around all if none is selected</source>
        <translation>所选行人周围的 Hall 区域；运行中未选择时显示全部</translation>
    </message>
    <message>
        <source>For&amp;ces</source>
        <translation>力(&amp;C)</translation>
    </message>
    <message>
        <source>Forces on selected people in a run; on all if none is selected</source>
        <translation>运行中作用于所选行人的力；未选择时显示全部</translation>
    </message>
    <message>
        <source>Robot pat&amp;hs</source>
        <translation>机器人路径(&amp;H)</translation>
    </message>
    <message>
        <source>Paths that robot planners follow in a run</source>
        <translation>运行中机器人规划器所跟随的路径</translation>
    </message>
    <message>
        <source>Lid&amp;ar scans</source>
        <translation>激光雷达扫描(&amp;A)</translation>
    </message>
    <message>
        <source>Lidar scans of robots in a run</source>
        <translation>运行中机器人的激光雷达扫描</translation>
    </message>
    <message>
        <source>&amp;Detections</source>
        <translation>检测(&amp;D)</translation>
    </message>
    <message>
        <source>Positions of people and of themselves as robots estimate them in a run</source>
        <translation>运行中机器人估计的行人位置和自身位置</translation>
    </message>
    <message>
        <source>Candidate tra&amp;jectories</source>
        <translation>候选轨迹(&amp;J)</translation>
    </message>
    <message>
        <source>Trajectories that robot planners evaluated in a run</source>
        <translation>运行中机器人规划器评估过的轨迹</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>地图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;People</source>
        <translation>行人(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Goals</source>
        <translation>目标点(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Obstacles and doors</source>
        <translation>障碍物和门(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Areas and docks</source>
        <translation>区域和充电桩(&amp;A)</translation>
    </message>
    <message>
        <source>Gro&amp;ups</source>
        <translation>群组(&amp;U)</translation>
    </message>
    <message>
        <source>Snap to p&amp;oints</source>
        <translation>吸附到点(&amp;O)</translation>
    </message>
    <message>
        <source>Snap drawn items to corners, ends and centres of other items</source>
        <translation>将绘制的对象吸附到其他对象的角点、端点和中心</translation>
    </message>
    <message>
        <source>Snap to &amp;walls</source>
        <translation>吸附到墙(&amp;W)</translation>
    </message>
    <message>
        <source>Snap drawn items to corners and edges of map walls</source>
        <translation>将绘制的对象吸附到地图墙体的角点和边缘</translation>
    </message>
    <message>
        <source>Snap to the gr&amp;id</source>
        <translation>吸附到网格(&amp;I)</translation>
    </message>
    <message>
        <source>Snap drawn items to a grid of 0.5 m</source>
        <translation>将绘制的对象吸附到 0.5 m 的网格</translation>
    </message>
    <message>
        <source>Alignment guides</source>
        <translation>对齐参考线</translation>
    </message>
    <message>
        <source>Align dragged items with edges, centres and distances of others; Alt suspends this</source>
        <translation>将拖动的对象与其他对象的边缘、中心和间距对齐；Alt 暂停此功能</translation>
    </message>
    <message>
        <source>&amp;Density of people</source>
        <translation>行人密度(&amp;D)</translation>
    </message>
    <message>
        <source>People per m² as a colour map</source>
        <translation>以色彩图显示每平方米人数</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>视野(&amp;F)</translation>
    </message>
    <message>
        <source>Area that the selected people see; walls block the view</source>
        <translation>所选行人看到的区域；墙会遮挡视线</translation>
    </message>
    <message>
        <source>&amp;Gaussian spaces</source>
        <translation>高斯空间(&amp;G)</translation>
    </message>
    <message>
        <source>Gaussian personal space, longer in the walking direction</source>
        <translation>高斯个人空间，在行走方向上更长</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>速度(&amp;V)</translation>
    </message>
    <message>
        <source>Velocity vector of each body</source>
        <translation>每个物体的速度矢量</translation>
    </message>
    <message>
        <source>Peopl&amp;e&apos;s paths</source>
        <translation>行人路径(&amp;E)</translation>
    </message>
    <message>
        <source>Remaining path of each person; newest step only</source>
        <translation>每个行人的剩余路径；仅最新一步</translation>
    </message>
    <message>
        <source>C&amp;ontacts</source>
        <translation>接触(&amp;O)</translation>
    </message>
    <message>
        <source>Where bodies touched, and which body ran into the other</source>
        <translation>物体接触的位置，以及哪一方撞上另一方</translation>
    </message>
    <message>
        <source>T&amp;houghts</source>
        <translation>想法(&amp;H)</translation>
    </message>
    <message>
        <source>Current action of each person and its reason, below the name</source>
        <translation>名称下方显示每个行人的当前动作及其原因</translation>
    </message>
    <message>
        <source>&amp;Speech</source>
        <translation>语音(&amp;S)</translation>
    </message>
    <message>
        <source>What people say, and which people hear it</source>
        <translation>行人说的话，以及哪些行人听到</translation>
    </message>
    <message>
        <source>&amp;Local costmap</source>
        <translation>局部代价地图(&amp;L)</translation>
    </message>
    <message>
        <source>Local costmap that the controller of a robot with Nav2 uses</source>
        <translation>使用 Nav2 的机器人的控制器所用的局部代价地图</translation>
    </message>
    <message>
        <source>Gl&amp;obal costmap</source>
        <translation>全局代价地图(&amp;O)</translation>
    </message>
    <message>
        <source>Global costmap that the planner of a robot with Nav2 uses</source>
        <translation>使用 Nav2 的机器人的规划器所用的全局代价地图</translation>
    </message>
    <message>
        <source>F&amp;ilter masks</source>
        <translation>过滤掩膜(&amp;I)</translation>
    </message>
    <message>
        <source>Keepout zones and speed limits of the costmap filters of a robot with Nav2</source>
        <translation>使用 Nav2 的机器人的代价地图过滤器的禁入区和限速</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>People in a run</source>
        <translation>运行中的行人</translation>
    </message>
    <message>
        <source>Robots in a run</source>
        <translation>运行中的机器人</translation>
    </message>
    <message>
        <source>&amp;New open plane</source>
        <translation>新建开阔平面(&amp;N)</translation>
    </message>
    <message>
        <source>Create a scenario without a map</source>
        <translation>创建没有地图的场景</translation>
    </message>
    <message>
        <source>New empty &amp;room…</source>
        <translation>新建空房间(&amp;R)…</translation>
    </message>
    <message>
        <source>Create a scenario in a room of a given size</source>
        <translation>在给定大小的房间中创建场景</translation>
    </message>
    <message>
        <source>New from a &amp;map…</source>
        <translation>从地图新建(&amp;M)…</translation>
    </message>
    <message>
        <source>Create a scenario on a Nav2 map or a map image</source>
        <translation>在 Nav2 地图或地图图像上创建场景</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation>打开场景或地图</translation>
    </message>
    <message>
        <source>Open r&amp;un…</source>
        <translation>打开运行(&amp;U)…</translation>
    </message>
    <message>
        <source>Open a recorded run: the output folder of `run`</source>
        <translation>打开已录制的运行：`run` 的输出文件夹</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the scenario and its behaviour trees</source>
        <translation>保存场景及其行为树</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the scenario under another name</source>
        <translation>以其他名称保存场景</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Export scenario, trees and map for another simulator</source>
        <translation>为其他仿真器导出场景、树和地图</translation>
    </message>
    <message>
        <source>Save p&amp;icture…</source>
        <translation>保存图片(&amp;I)…</translation>
    </message>
    <message>
        <source>Save the displayed step of the run, or the start of the scenario, as PNG, SVG or PDF</source>
        <translation>将显示的运行步或场景的起始状态保存为 PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>Save fi&amp;lm…</source>
        <translation>保存视频(&amp;L)…</translation>
    </message>
    <message>
        <source>Save the run as a GIF, MP4 or WebP film</source>
        <translation>将运行保存为 GIF、MP4 或 WebP 视频</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Return to the start page</source>
        <translation>返回起始页</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Quit the program</source>
        <translation>退出程序</translation>
    </message>
    <message>
        <source>Change &amp;map…</source>
        <translation>更换地图(&amp;M)…</translation>
    </message>
    <message>
        <source>Choose another map for the scenario</source>
        <translation>为场景选择其他地图</translation>
    </message>
    <message>
        <source>Assign &amp;goals…</source>
        <translation>分配目标点(&amp;G)…</translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation>选择行人到访的目标点及其顺序</translation>
    </message>
    <message>
        <source>Scenario &amp;settings</source>
        <translation>场景设置(&amp;S)</translation>
    </message>
    <message>
        <source>Edit seed, duration and other settings of the scenario</source>
        <translation>编辑场景的种子、时长及其他设置</translation>
    </message>
    <message>
        <source>Run &amp;history…</source>
        <translation>运行历史(&amp;H)…</translation>
    </message>
    <message>
        <source>Set the memory for the history of a run</source>
        <translation>设置运行历史所用的内存</translation>
    </message>
    <message>
        <source>Watch in &amp;Foxglove</source>
        <translation>在 Foxglove 中观看(&amp;F)</translation>
    </message>
    <message>
        <source>Publish new runs live at ws://localhost:8765</source>
        <translation>在 ws://localhost:8765 实时发布新的运行</translation>
    </message>
    <message>
        <source>Publish to &amp;ROS 2</source>
        <translation>发布到 ROS 2(&amp;R)</translation>
    </message>
    <message>
        <source>Publish new runs on ROS 2 topics; /cmd_vel, /initialpose and /goal_pose control the first robot</source>
        <translation>在 ROS 2 话题上发布新的运行；/cmd_vel、/initialpose 和 /goal_pose 控制第一个机器人</translation>
    </message>
    <message>
        <source>Import tra&amp;jectories…</source>
        <translation>导入轨迹(&amp;J)…</translation>
    </message>
    <message>
        <source>Show recorded trajectories of people: CSV, JuPedSim, TrajNet++, ETH/UCY and others</source>
        <translation>显示已录制的行人轨迹：CSV、JuPedSim、TrajNet++、ETH/UCY 等</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>查找命令(&amp;F)…</translation>
    </message>
    <message>
        <source>Search all commands and run one</source>
        <translation>搜索所有命令并运行其中一个</translation>
    </message>
    <message>
        <source>Preference&amp;s…</source>
        <translation>首选项(&amp;S)…</translation>
    </message>
    <message>
        <source>Theme, folders, copies of unsaved work and keyboard shortcuts</source>
        <translation>主题、文件夹、未保存更改的副本和键盘快捷键</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>新手引导(&amp;G)</translation>
    </message>
    <message>
        <source>Place a person, run the simulation and read a metric</source>
        <translation>放置行人、运行仿真并查看指标</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>Open the manual page of what has the keyboard focus</source>
        <translation>打开与键盘焦点所在内容有关的手册页面</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>这是什么？(&amp;W)</translation>
    </message>
    <message>
        <source>Click anything in the window for an explanation</source>
        <translation>单击窗口中的任意内容查看说明</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>键盘快捷键(&amp;K)…</translation>
    </message>
    <message>
        <source>Search and change all keyboard shortcuts</source>
        <translation>搜索和更改所有键盘快捷键</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>关于(&amp;A)</translation>
    </message>
    <message>
        <source>Show version information</source>
        <translation>显示版本信息</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>撤销上一次更改</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>重做上一次撤销的更改</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the selection and remove it</source>
        <translation>复制所选对象并将其移除</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selection as YAML text</source>
        <translation>将所选对象复制为 YAML 文本</translation>
    </message>
    <message>
        <source>Copy as figure</source>
        <translation>复制为图</translation>
    </message>
    <message>
        <source>Copy the displayed step of the run as a figure: PNG and SVG</source>
        <translation>将显示的运行步复制为图：PNG 和 SVG</translation>
    </message>
    <message>
        <source>Copy metric as plot</source>
        <translation>将指标复制为曲线图</translation>
    </message>
    <message>
        <source>Copy a plot of the selected metric over time: PNG and SVG</source>
        <translation>复制所选指标随时间变化的曲线图：PNG 和 SVG</translation>
    </message>
    <message>
        <source>Save metric as plot…</source>
        <translation>将指标保存为曲线图…</translation>
    </message>
    <message>
        <source>Save a plot of the selected metric over time: PNG, SVG or PDF</source>
        <translation>保存所选指标随时间变化的曲线图：PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Insert the copied items at the mouse pointer</source>
        <translation>在鼠标指针处插入复制的对象</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>创建副本(&amp;L)</translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation>为所选对象创建副本</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>重命名(&amp;M)</translation>
    </message>
    <message>
        <source>Rename the selection; references are updated</source>
        <translation>重命名所选对象；引用会随之更新</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation>移除所选对象；路线会随之更新</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Select everything on the map</source>
        <translation>选择地图上的所有对象</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>取消选择(&amp;N)</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>清除选择</translation>
    </message>
    <message>
        <source>N&amp;ext</source>
        <translation>下一个(&amp;E)</translation>
    </message>
    <message>
        <source>Select the next person, or the next item of the selected kind</source>
        <translation>选择下一个行人，或所选类型的下一个对象</translation>
    </message>
    <message>
        <source>Pre&amp;vious</source>
        <translation>上一个(&amp;V)</translation>
    </message>
    <message>
        <source>Select the previous person, or the previous item of the selected kind</source>
        <translation>选择上一个行人，或所选类型的上一个对象</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Enlarge the map</source>
        <translation>放大地图</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>Reduce the map</source>
        <translation>缩小地图</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适应窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Fit the whole map in the window</source>
        <translation>使整个地图适应窗口</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>全屏(&amp;E)</translation>
    </message>
    <message>
        <source>Show only the map</source>
        <translation>仅显示地图</translation>
    </message>
    <message>
        <source>Reset the la&amp;yout</source>
        <translation>重置布局(&amp;Y)</translation>
    </message>
    <message>
        <source>Restore the default panel layout</source>
        <translation>恢复默认的面板布局</translation>
    </message>
    <message>
        <source>Light or dar&amp;k</source>
        <translation>浅色或深色(&amp;K)</translation>
    </message>
    <message>
        <source>Switch between the light and the dark theme</source>
        <translation>在浅色和深色主题之间切换</translation>
    </message>
    <message>
        <source>Follow &amp;system theme</source>
        <translation>跟随系统主题(&amp;S)</translation>
    </message>
    <message>
        <source>Use the light or dark theme of the desktop</source>
        <translation>使用桌面的浅色或深色主题</translation>
    </message>
    <message>
        <source>Align &amp;left</source>
        <translation>左对齐(&amp;L)</translation>
    </message>
    <message>
        <source>Align &amp;centres</source>
        <translation>水平居中对齐(&amp;C)</translation>
    </message>
    <message>
        <source>Align &amp;right</source>
        <translation>右对齐(&amp;R)</translation>
    </message>
    <message>
        <source>Align &amp;tops</source>
        <translation>顶部对齐(&amp;T)</translation>
    </message>
    <message>
        <source>Align &amp;middles</source>
        <translation>垂直居中对齐(&amp;M)</translation>
    </message>
    <message>
        <source>Align &amp;bottoms</source>
        <translation>底部对齐(&amp;B)</translation>
    </message>
    <message>
        <source>Align the selected items</source>
        <translation>对齐所选对象</translation>
    </message>
    <message>
        <source>Distribute &amp;horizontally</source>
        <translation>水平分布(&amp;H)</translation>
    </message>
    <message>
        <source>Distribute &amp;vertically</source>
        <translation>垂直分布(&amp;V)</translation>
    </message>
    <message>
        <source>Set equal gaps between the selected items</source>
        <translation>使所选对象之间的间距相等</translation>
    </message>
    <message>
        <source>Rotate 15° left	[</source>
        <translation>向左旋转 15°	[</translation>
    </message>
    <message>
        <source>Rotate 15° right	]</source>
        <translation>向右旋转 15°	]</translation>
    </message>
    <message>
        <source>Rotate 90° left</source>
        <translation>向左旋转 90°</translation>
    </message>
    <message>
        <source>Rotate 90° right</source>
        <translation>向右旋转 90°</translation>
    </message>
    <message>
        <source>Rotate the selection about its centre</source>
        <translation>使所选对象绕其中心旋转</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>运行期间不可用：Ctrl+R 返回编辑</translation>
    </message>
    <message>
        <source>Select something first</source>
        <translation>请先选择对象</translation>
    </message>
    <message>
        <source>Select exactly one item first</source>
        <translation>请先选择恰好一个对象</translation>
    </message>
    <message>
        <source>The clipboard contains no items of a scenario</source>
        <translation>剪贴板中没有场景对象</translation>
    </message>
    <message>
        <source>Select at least %1 first</source>
        <translation>请先选择至少 %1</translation>
    </message>
    <message>
        <source>item</source>
        <translation>个对象</translation>
    </message>
    <message>
        <source>items</source>
        <translation>个对象</translation>
    </message>
</context>
<context>
    <name>editor::AreaPage</name>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation>源：行人出现</translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation>汇：行人离开</translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation>等候区</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>出口</translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation>速度：楼梯、自动步道</translation>
    </message>
    <message>
        <source>Spawned people</source>
        <translation>生成的行人</translation>
    </message>
    <message>
        <source>name of a person</source>
        <translation>行人的名称</translation>
    </message>
    <message>
        <source>No person has this name</source>
        <translation>没有行人使用此名称</translation>
    </message>
    <message>
        <source>people</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>person</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>editor::AreaTool</name>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation>源：行人出现</translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation>汇：行人离开</translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation>等候区</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>出口</translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation>速度：楼梯、自动步道</translation>
    </message>
    <message>
        <source>Drag an area where people appear, or click its corners · 1 to 5 choose the kind</source>
        <translation>拖出行人出现的区域，或单击其顶点 · 按 1 至 5 选择类型</translation>
    </message>
    <message>
        <source>Drag an area where people leave after their last goal, or click its corners</source>
        <translation>拖出行人在最后一个目标点之后离开的区域，或单击其顶点</translation>
    </message>
    <message>
        <source>Drag a waiting area, or click its corners · trees refer to it by name</source>
        <translation>拖出等候区，或单击其顶点 · 树按名称引用它</translation>
    </message>
    <message>
        <source>Drag an exit that people flee to, or click its corners</source>
        <translation>拖出行人逃往的出口，或单击其顶点</translation>
    </message>
    <message>
        <source>Drag stairs, a ramp or a travelator, or click its corners · the properties set factor and carrying speed</source>
        <translation>拖出楼梯、坡道或自动步道，或单击其顶点 · 系数和运载速度在属性中设置</translation>
    </message>
    <message>
        <source>Add source</source>
        <translation>添加源</translation>
    </message>
</context>
<context>
    <name>editor::BehaviorMixDialog</name>
    <message>
        <source>Behaviours of %1</source>
        <translation>%1 的行为</translation>
    </message>
</context>
<context>
    <name>editor::BehaviorPanel</name>
    <message>
        <source>Blackboard</source>
        <translation>黑板</translation>
    </message>
    <message>
        <source>+ Block…</source>
        <translation>+ 行为块…</translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation>添加行为块</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Load a tree from a file</source>
        <translation>从文件加载树</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Save the tree to a file</source>
        <translation>将树保存到文件</translation>
    </message>
    <message>
        <source>Template…</source>
        <translation>模板…</translation>
    </message>
    <message>
        <source>Start from the tree of a behaviour</source>
        <translation>以某种行为的树为起点</translation>
    </message>
    <message>
        <source>Regenerate</source>
        <translation>重新生成</translation>
    </message>
    <message>
        <source>Generate the tree from behaviour and goals</source>
        <translation>根据行为和目标点生成树</translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation>将路线复制到树</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>前移</translation>
    </message>
    <message>
        <source>Move before the block above</source>
        <translation>移到上一个行为块之前</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>后移</translation>
    </message>
    <message>
        <source>Move after the block below</source>
        <translation>移到下一个行为块之后</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the block</source>
        <translation>移除行为块</translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation>还没有行人：按 P 并单击地图。</translation>
    </message>
    <message>
        <source>Select a person to see the behaviour tree.</source>
        <translation>选择一个行人以查看其行为树。</translation>
    </message>
    <message>
        <source>%1 · generated from behaviour and goals</source>
        <translation>%1 · 根据行为和目标点生成</translation>
    </message>
    <message>
        <source>%1 · with %2</source>
        <translation>%1 · 含 %2</translation>
    </message>
    <message>
        <source>block</source>
        <translation>个行为块</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>个行为块</translation>
    </message>
    <message>
        <source>Custom tree; not affected by changes to the behaviour</source>
        <translation>自定义树；不受行为更改的影响</translation>
    </message>
    <message>
        <source>Load tree %1</source>
        <translation>加载树 %1</translation>
    </message>
    <message>
        <source>Load a behaviour tree</source>
        <translation>加载行为树</translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml);;All files (*)</source>
        <translation>行为树 (*.xml);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save the behaviour tree</source>
        <translation>保存行为树</translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml)</source>
        <translation>行为树 (*.xml)</translation>
    </message>
    <message>
        <source>Use the tree of %1</source>
        <translation>使用 %1 的树</translation>
    </message>
    <message>
        <source>Select a node above to see its ports.</source>
        <translation>在上方选择一个节点以查看其端口。</translation>
    </message>
</context>
<context>
    <name>editor::BlackboardView</name>
    <message>
        <source>Blackboard</source>
        <translation>黑板</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>The blackboard is available during a run: press Space.</source>
        <translation>黑板在运行期间可用：按空格键。</translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard. &quot;Branch here…&quot; (in the menu Run) replays the run with it.</source>
        <translation>已录制的运行不包含黑板。“在此处分支…”（“运行”菜单）会带黑板重放该运行。</translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard.</source>
        <translation>已录制的运行不包含黑板。</translation>
    </message>
    <message>
        <source>Not recorded at this time: the blackboard is recorded from the step in which the person is selected.</source>
        <translation>此时刻未记录：黑板从选择该行人的那一步开始记录。</translation>
    </message>
    <message>
        <source>The tree has no entries.</source>
        <translation>该树没有条目。</translation>
    </message>
    <message>
        <source>Takes effect in the next step</source>
        <translation>在下一步生效</translation>
    </message>
    <message>
        <source>Double-click to change the value</source>
        <translation>双击以更改值</translation>
    </message>
    <message>
        <source>%1 becomes %2 in the next step, as an input of the run</source>
        <translation>%1 在下一步变为 %2，作为运行的输入</translation>
    </message>
</context>
<context>
    <name>editor::BlockDialog</name>
    <message>
        <source>Blocks</source>
        <translation>行为块</translation>
    </message>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation>添加行为块</translation>
    </message>
    <message>
        <source>No people yet</source>
        <translation>还没有行人</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>行为块</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
</context>
<context>
    <name>editor::BoxTool</name>
    <message>
        <source>Drag a box from corner to corner · Shift makes a square</source>
        <translation>从一角拖动到对角 · Shift 绘制正方形</translation>
    </message>
</context>
<context>
    <name>editor::BranchCommand</name>
    <message>
        <source>Continue the run from the displayed step in another way: another planner, other positions, another seed; the run itself is kept</source>
        <translation>从显示的步开始以其他方式继续运行：其他规划器、其他位置、其他种子；原运行会保留</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>请先开始运行：空格键</translation>
    </message>
    <message>
        <source>The maximum number of branches is reached: remove one first</source>
        <translation>已达到分支数量上限：请先移除一个</translation>
    </message>
    <message>
        <source>The inputs of this run are unknown, so it cannot be repeated</source>
        <translation>此运行的输入未知，因此无法重放</translation>
    </message>
    <message>
        <source>A branch starts at an earlier step: go back on the timeline first</source>
        <translation>分支从较早的步开始：请先在时间轴上后退</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>分支 %1</translation>
    </message>
    <message>
        <source>Branch with this change…</source>
        <translation>以此更改创建分支…</translation>
    </message>
    <message>
        <source>Continue the run with %1 here</source>
        <translation>在此处以%1继续运行</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>editor::BranchDialog</name>
    <message>
        <source>Branch at %1</source>
        <translation>在 %1 分支</translation>
    </message>
    <message>
        <source>The branch repeats the run up to %1 and pauses there. Without changes it is identical to the displayed run.</source>
        <translation>分支重放运行至 %1 并在那里暂停。不作更改时，它与显示的运行相同。</translation>
    </message>
    <message>
        <source>From then on</source>
        <translation>从那时起</translation>
    </message>
    <message>
        <source>Branch name</source>
        <translation>分支名称</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>PATH = VALUE, one per line: robot1.goal_radius = 0.4</source>
        <translation>路径 = 值，每行一个：robot1.goal_radius = 0.4</translation>
    </message>
    <message>
        <source>Other values</source>
        <translation>其他值</translation>
    </message>
    <message>
        <source>Create branch</source>
        <translation>创建分支</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Planner of %1</source>
        <translation>%1 的规划器</translation>
    </message>
    <message>
        <source>Top speed of %1</source>
        <translation>%1 的最大速度</translation>
    </message>
    <message>
        <source>Move a person</source>
        <translation>移动行人</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Move a person…</source>
        <translation>移动行人…</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>X of %1</source>
        <translation>%1 的 X</translation>
    </message>
    <message>
        <source>Y of %1</source>
        <translation>%1 的 Y</translation>
    </message>
    <message>
        <source>Heading of %1</source>
        <translation>%1 的朝向</translation>
    </message>
    <message>
        <source>Leave %1 in place</source>
        <translation>让 %1 留在原处</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>New random seed</source>
        <translation>新的随机种子</translation>
    </message>
</context>
<context>
    <name>editor::BrushTool</name>
    <message>
        <source>%1 · Esc cancels</source>
        <translation>%1 · Esc 取消</translation>
    </message>
    <message>
        <source>Drag to place people along the path; they face its direction</source>
        <translation>拖动以沿路径放置行人；他们朝向路径的方向</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
</context>
<context>
    <name>editor::CircleTool</name>
    <message>
        <source>Drag from the centre of the circle to its edge</source>
        <translation>从圆心拖动到边缘</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>半径 %1 m</translation>
    </message>
</context>
<context>
    <name>editor::CompareTable</name>
    <message>
        <source>Metrics of the runs</source>
        <translation>各运行的指标</translation>
    </message>
    <message>
        <source>Branch from an earlier moment, or add a recorded run. Checked runs are compared with the displayed run.</source>
        <translation>从较早的时刻创建分支，或添加已录制的运行。勾选的运行将与显示的运行进行比较。</translation>
    </message>
    <message>
        <source>Whole runs</source>
        <translation>完整运行</translation>
    </message>
    <message>
        <source>Compare the whole runs, although they differ in length</source>
        <translation>比较完整的运行，即使时长不同</translation>
    </message>
    <message>
        <source>%1 has another scenario</source>
        <translation>%1 使用另一个场景</translation>
    </message>
    <message>
        <source>%1 diverges at %2</source>
        <translation>%1 在 %2 处出现分歧</translation>
    </message>
    <message>
        <source>%1 is identical</source>
        <translation>%1 相同</translation>
    </message>
    <message>
        <source>%1 %2 s</source>
        <translation>%1 %2 s</translation>
    </message>
    <message>
        <source>Compared up to %1 s</source>
        <translation>比较至 %1 s</translation>
    </message>
    <message>
        <source>outcomes over whole runs</source>
        <translation>结果基于完整运行</translation>
    </message>
    <message>
        <source>Different lengths</source>
        <translation>时长不同</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>比较范围</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>完整运行</translation>
    </message>
    <message>
        <source>to %1 s</source>
        <translation>至 %1 s</translation>
    </message>
    <message>
        <source>Pause the run to compare it.</source>
        <translation>暂停运行以进行比较。</translation>
    </message>
    <message>
        <source>Comparing the runs…</source>
        <translation>正在比较各次运行…</translation>
    </message>
</context>
<context>
    <name>editor::ContactProbabilityPlot</name>
    <message>
        <source>Probability of contact over time</source>
        <translation>接触概率随时间的变化</translation>
    </message>
    <message>
        <source>share of the futures</source>
        <translation>占全部未来的比例</translation>
    </message>
    <message>
        <source>lower limit (95 % CI)</source>
        <translation>下限（95 % 置信区间）</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>上限</translation>
    </message>
</context>
<context>
    <name>editor::CornerDrawingTool</name>
    <message>
        <source>%1 · Backspace removes the last corner · Esc cancels</source>
        <translation>%1 · Backspace 移除最后一个顶点 · Esc 取消</translation>
    </message>
    <message>
        <source>Click the next corner · Enter or double-click finishes · Backspace removes the last corner · Esc cancels</source>
        <translation>单击下一个顶点 · Enter 或双击完成 · Backspace 移除最后一个顶点 · Esc 取消</translation>
    </message>
    <message>
        <source>At least three corners are required</source>
        <translation>至少需要三个顶点</translation>
    </message>
    <message>
        <source>The edges cross</source>
        <translation>边相交</translation>
    </message>
    <message>
        <source>Too small</source>
        <translation>太小</translation>
    </message>
</context>
<context>
    <name>editor::DockPage</name>
    <message>
        <source>Dock</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>Charges robots</source>
        <translation>为机器人充电</translation>
    </message>
    <message>
        <source>Parking place</source>
        <translation>停车位</translation>
    </message>
</context>
<context>
    <name>editor::DockTool</name>
    <message>
        <source>Drag to set the heading of a docked robot · Esc cancels</source>
        <translation>拖动以设置停靠机器人的朝向 · Esc 取消</translation>
    </message>
    <message>
        <source>Click the position of a docked robot; drag to set its heading</source>
        <translation>单击停靠机器人的位置；拖动以设置其朝向</translation>
    </message>
</context>
<context>
    <name>editor::DoorPage</name>
    <message>
        <source>Door</source>
        <translation>门</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>From X</source>
        <translation>起点 X</translation>
    </message>
    <message>
        <source>From Y</source>
        <translation>起点 Y</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>To X</source>
        <translation>终点 X</translation>
    </message>
    <message>
        <source>To Y</source>
        <translation>终点 Y</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>seconds, such as 5, 12.5</source>
        <translation>秒，例如 5, 12.5</translation>
    </message>
    <message>
        <source>Times in seconds, ascending, separated by commas</source>
        <translation>以秒为单位的时间，升序，用逗号分隔</translation>
    </message>
</context>
<context>
    <name>editor::DoorTool</name>
    <message>
        <source>Drag a door from its hinge to the other jamb · Shift: 15° steps</source>
        <translation>从铰链拖动到另一侧门框 · Shift：15° 步进</translation>
    </message>
</context>
<context>
    <name>editor::EntityFilter</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>editor::EntityModel</name>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Robots and docks</source>
        <translation>机器人和充电桩</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>%1 in this run; %2 applies at the next start</source>
        <translation>此次运行为 %1；%2 在下次启动时生效</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>行为</translation>
    </message>
</context>
<context>
    <name>editor::EraserTool</name>
    <message>
        <source>Release to remove it · Esc cancels</source>
        <translation>松开以移除 · Esc 取消</translation>
    </message>
    <message>
        <source>Release to remove %1 items · Esc cancels</source>
        <translation>松开以移除 %1 个对象 · Esc 取消</translation>
    </message>
    <message>
        <source>Click items to remove them, or drag over them · Click areas to remove them</source>
        <translation>单击对象将其移除，或拖过它们 · 单击区域将其移除</translation>
    </message>
</context>
<context>
    <name>editor::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>No events yet: press Space to run.</source>
        <translation>还没有事件：按空格键运行。</translation>
    </message>
    <message>
        <source>%1 enters</source>
        <translation>%1 进入</translation>
    </message>
    <message>
        <source>%1 leaves</source>
        <translation>%1 离开</translation>
    </message>
    <message>
        <source>%1 reached %2</source>
        <translation>%1 到达 %2</translation>
    </message>
    <message>
        <source>%1 has arrived</source>
        <translation>%1 已到达</translation>
    </message>
    <message>
        <source>%1 touches %2</source>
        <translation>%1 接触 %2</translation>
    </message>
    <message>
        <source>%1: “%2”</source>
        <translation>%1：“%2”</translation>
    </message>
    <message>
        <source>%1 hears %2</source>
        <translation>%1 听到 %2</translation>
    </message>
    <message>
        <source>%1 starts %2</source>
        <translation>%1 开始 %2</translation>
    </message>
    <message>
        <source>%1 ends %2</source>
        <translation>%1 结束 %2</translation>
    </message>
    <message>
        <source>%1 joins group %2</source>
        <translation>%1 加入群组 %2</translation>
    </message>
    <message>
        <source>%1 plans a new path</source>
        <translation>%1 重新规划路径</translation>
    </message>
    <message>
        <source>%1 is stuck</source>
        <translation>%1 被困</translation>
    </message>
    <message>
        <source>%1: navigation succeeded, %2</source>
        <translation>%1：导航成功，%2</translation>
    </message>
    <message>
        <source>%1: navigation failed, %2</source>
        <translation>%1：导航失败，%2</translation>
    </message>
    <message>
        <source>Door %2</source>
        <translation>门 %2</translation>
    </message>
    <message>
        <source>The run ends: %2</source>
        <translation>运行结束：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 takes a photo at %2</source>
        <translation>%1 在 %2 拍照</translation>
    </message>
    <message>
        <source>%1: battery %2</source>
        <translation>%1：电量 %2</translation>
    </message>
</context>
<context>
    <name>editor::ExportablePlot</name>
    <message>
        <source>Copy plot</source>
        <translation>复制曲线图</translation>
    </message>
    <message>
        <source>Copy the plot as PNG and SVG</source>
        <translation>将曲线图复制为 PNG 和 SVG</translation>
    </message>
    <message>
        <source>Save plot…</source>
        <translation>保存曲线图…</translation>
    </message>
    <message>
        <source>Save the plot as PNG, SVG or PDF</source>
        <translation>将曲线图保存为 PNG、SVG 或 PDF</translation>
    </message>
</context>
<context>
    <name>editor::FillTool</name>
    <message>
        <source>Drag or click the corners of an area to fill with %1 and %2 goals</source>
        <translation>拖动或单击区域的顶点，用 %1 和 %2 个目标点填充</translation>
    </message>
    <message>
        <source>Drag or click the corners of an area to fill with %1</source>
        <translation>拖动或单击区域的顶点，用 %1 填充</translation>
    </message>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
</context>
<context>
    <name>editor::FuturesPanel</name>
    <message>
        <source>seeds,</source>
        <translation>个种子，</translation>
    </message>
    <message>
        <source>long, people ±</source>
        <translation>时长，行人 ±</translation>
    </message>
    <message>
        <source>Number of futures</source>
        <translation>未来的数量</translation>
    </message>
    <message>
        <source>Number of simulated futures, each with its own seed</source>
        <translation>模拟的未来数量，每个使用各自的种子</translation>
    </message>
    <message>
        <source>Length of the futures</source>
        <translation>未来的时长</translation>
    </message>
    <message>
        <source>Duration of each future</source>
        <translation>每个未来的时长</translation>
    </message>
    <message>
        <source>Velocity uncertainty</source>
        <translation>速度不确定性</translation>
    </message>
    <message>
        <source>Velocity uncertainty: once a second each walking person is pushed by a random velocity of this standard deviation. 0: only the variation of the scenario applies</source>
        <translation>速度不确定性：每个行走中的行人每秒受到一次以此为标准差的随机速度扰动。0：仅应用场景的变化</translation>
    </message>
    <message>
        <source>Simulate from the displayed step, in the background</source>
        <translation>从显示的步开始在后台模拟</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Simulate futures</source>
        <translation>模拟未来</translation>
    </message>
    <message>
        <source>Simulates the run from the displayed step with other random values.</source>
        <translation>从显示的步开始用其他随机值模拟运行。</translation>
    </message>
    <message>
        <source>This run cannot be replayed: its inputs are not known.</source>
        <translation>此运行无法重放：其输入未知。</translation>
    </message>
    <message>
        <source>Start a run and pause it to simulate its futures from there.</source>
        <translation>开始运行并暂停，以便从那里模拟其未来。</translation>
    </message>
    <message>
        <source>%1 futures</source>
        <translation>%1 个未来</translation>
    </message>
    <message>
        <source>%1 of %2 futures so far</source>
        <translation>目前 %1 / %2 个未来</translation>
    </message>
    <message>
        <source>%1 of %2 futures, cancelled</source>
        <translation>%1 / %2 个未来，已取消</translation>
    </message>
    <message>
        <source>From %1: %2.</source>
        <translation>从 %1 起：%2。</translation>
    </message>
    <message>
        <source>No contact in any run (%1, 95 % CI at most %2).</source>
        <translation>没有任何运行发生接触（%1，95 % 置信区间上限 %2）。</translation>
    </message>
    <message>
        <source>%1 have a contact (%2, 95 % CI %3 to %4).</source>
        <translation>%1 个发生接触（%2，95 % 置信区间 %3 至 %4）。</translation>
    </message>
    <message>
        <source>Median time %1.</source>
        <translation>中位时间 %1。</translation>
    </message>
    <message>
        <source>%1 ended early.</source>
        <translation>%1 个提前结束。</translation>
    </message>
</context>
<context>
    <name>editor::FuturesProcess</name>
    <message>
        <source>The futures simulation crashed.</source>
        <translation>未来模拟进程已崩溃。</translation>
    </message>
</context>
<context>
    <name>editor::GoalAssignment</name>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路线</translation>
    </message>
    <message>
        <source>Assign goals</source>
        <translation>分配目标点</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>分配</translation>
    </message>
    <message>
        <source>Drag goals to add and reorder them. Assign applies the changes; Undo reverts them.</source>
        <translation>拖动目标点以添加和重新排序。“分配”应用更改；“撤销”还原更改。</translation>
    </message>
    <message>
        <source>No people yet: press P and drag on the map</source>
        <translation>还没有行人：按 P 并在地图上拖动</translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation>还没有目标点：按 G 并单击地图</translation>
    </message>
    <message>
        <source>Add to the end of the route (Return)</source>
        <translation>添加到路线末尾（Enter）</translation>
    </message>
    <message>
        <source>Remove from the route (Del)</source>
        <translation>从路线中移除（Del）</translation>
    </message>
    <message>
        <source>Earlier (Alt+Up)</source>
        <translation>前移（Alt+Up）</translation>
    </message>
    <message>
        <source>Later (Alt+Down)</source>
        <translation>后移（Alt+Down）</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Clear the route of the selected people</source>
        <translation>清空所选行人的路线</translation>
    </message>
    <message>
        <source>Route of %1</source>
        <translation>%1 的路线</translation>
    </message>
    <message>
        <source>Route of %1 people</source>
        <translation>%1 名行人的路线</translation>
    </message>
    <message>
        <source>Select people on the left</source>
        <translation>在左侧选择行人</translation>
    </message>
    <message>
        <source>These people have different routes. Added goals go to the end of each.</source>
        <translation>这些行人的路线不同。添加的目标点会放在每条路线的末尾。</translation>
    </message>
    <message>
        <source>No goals: people stand still. Add goals from the middle list.</source>
        <translation>没有目标点：行人站立不动。从中间的列表添加目标点。</translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation>到达最后一个后重复</translation>
    </message>
</context>
<context>
    <name>editor::GoalList</name>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（缺失）</translation>
    </message>
</context>
<context>
    <name>editor::GoalPage</name>
    <message>
        <source>Goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation>到访者</translation>
    </message>
    <message>
        <source>several goals selected</source>
        <translation>已选择多个目标点</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 及另外 %2 个</translation>
    </message>
</context>
<context>
    <name>editor::GoalTool</name>
    <message>
        <source>Click to place goal %1 · Esc cancels</source>
        <translation>单击以放置目标点 %1 · Esc 取消</translation>
    </message>
    <message>
        <source>Click to add a goal · Click or drag a goal to move it</source>
        <translation>单击以添加目标点 · 单击或拖动目标点可移动它</translation>
    </message>
    <message>
        <source>Move goal %1</source>
        <translation>移动目标点 %1</translation>
    </message>
</context>
<context>
    <name>editor::IssuesPanel</name>
    <message>
        <source>Issues</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>条提示</translation>
    </message>
    <message>
        <source>hints</source>
        <translation>条提示</translation>
    </message>
    <message>
        <source>Information: click to show or hide</source>
        <translation>信息：单击以显示或隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>%1: all %2</source>
        <translation>%1：全部 %2 个</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>复制文本</translation>
    </message>
    <message>
        <source>No issues. Press P and click on the map to place a person.</source>
        <translation>没有问题。按 P 并单击地图以放置行人。</translation>
    </message>
    <message>
        <source>No issues: %1, %2.</source>
        <translation>没有问题：%1，%2。</translation>
    </message>
    <message>
        <source>person</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>people</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>个目标点</translation>
    </message>
    <message>
        <source>goals</source>
        <translation>个目标点</translation>
    </message>
    <message>
        <source>No issues.</source>
        <translation>没有问题。</translation>
    </message>
</context>
<context>
    <name>editor::KindSwitch</name>
    <message>
        <source>Selected kinds</source>
        <translation>所选类型</translation>
    </message>
    <message>
        <source>Show and change the selected items of this kind</source>
        <translation>显示和更改所选的此类对象</translation>
    </message>
</context>
<context>
    <name>editor::LayersPanel</name>
    <message>
        <source>Opacity of %1</source>
        <translation>%1的不透明度</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏%1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示%1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>all of %1</source>
        <translation>全部%1</translation>
    </message>
</context>
<context>
    <name>editor::LegendStrip</name>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
</context>
<context>
    <name>editor::ManualDriveController</name>
    <message>
        <source>&amp;Drive manually</source>
        <translation>手动操控(&amp;D)</translation>
    </message>
    <message>
        <source>Drive the selected robot with the arrow keys or W A S D; it brakes without a key. Esc returns control to its planner</source>
        <translation>用方向键或 W A S D 操控所选机器人；不按键时制动。Esc 将控制权交还规划器</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>操控</translation>
    </message>
</context>
<context>
    <name>editor::MapInset</name>
    <message>
        <source>The map around the person</source>
        <translation>行人周围的地图</translation>
    </message>
</context>
<context>
    <name>editor::MapPaintTool</name>
    <message>
        <source>No map to paint on: start with a room, a map or an image</source>
        <translation>没有可绘制的地图：请从房间、地图或图像开始</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>空闲空间</translation>
    </message>
    <message>
        <source>unknown space</source>
        <translation>未知空间</translation>
    </message>
    <message>
        <source>Drag to paint %1, %2 m wide · 1 wall, 2 free, 3 unknown · [ ] width · Shift: free</source>
        <translation>拖动以绘制%1，宽 %2 m · 1 墙，2 空闲，3 未知 · [ ] 宽度 · Shift：空闲</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>空闲空间</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Cell type</source>
        <translation>栅格类型</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Paint the map</source>
        <translation>绘制地图</translation>
    </message>
</context>
<context>
    <name>editor::MapView</name>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
</context>
<context>
    <name>editor::MeasureTool</name>
    <message>
        <source>Drag from one point to another · Shift: 15° steps</source>
        <translation>从一点拖动到另一点 · Shift：15° 步进</translation>
    </message>
    <message>
        <source>Distance %1 m · angle %2 · Δx %3 m · Δy %4 m</source>
        <translation>距离 %1 m · 角度 %2 · Δx %3 m · Δy %4 m</translation>
    </message>
</context>
<context>
    <name>editor::MetricsDock</name>
    <message>
        <source>Metrics appear when a simulation runs: press Space.</source>
        <translation>运行仿真时显示指标：按空格键。</translation>
    </message>
    <message>
        <source>Metrics of</source>
        <translation>指标对象</translation>
    </message>
    <message>
        <source>Robot whose metrics are shown</source>
        <translation>显示其指标的机器人</translation>
    </message>
</context>
<context>
    <name>editor::MetricsTable</name>
    <message>
        <source>Measured</source>
        <translation>已测量</translation>
    </message>
    <message>
        <source>Show only the metrics that are measured</source>
        <translation>仅显示正在测量的指标</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Measure all listed metrics</source>
        <translation>测量列出的所有指标</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Measure no listed metric</source>
        <translation>不测量列出的任何指标</translation>
    </message>
    <message>
        <source>Save the choice to the metrics file of the scenario</source>
        <translation>将选择保存到场景的指标文件</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Since start</source>
        <translation>自开始</translation>
    </message>
    <message>
        <source>As if %1 were the only person</source>
        <translation>假设 %1 是唯一的行人</translation>
    </message>
    <message>
        <source>No value: %1</source>
        <translation>无值：%1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 of %2 metrics are measured</source>
        <translation>测量 %1 / %2 个指标</translation>
    </message>
    <message>
        <source>Set metrics file</source>
        <translation>设置指标文件</translation>
    </message>
    <message>
        <source>Find a metric</source>
        <translation>查找指标</translation>
    </message>
    <message>
        <source>Save choice</source>
        <translation>保存所选</translation>
    </message>
</context>
<context>
    <name>editor::MixButton</name>
    <message>
        <source>Mix of behaviours and seed</source>
        <translation>行为混合与种子</translation>
    </message>
</context>
<context>
    <name>editor::Nav2Form</name>
    <message>
        <source>Changed only</source>
        <translation>仅已更改</translation>
    </message>
    <message>
        <source>Show only values that differ from the file</source>
        <translation>仅显示与文件不同的值</translation>
    </message>
    <message>
        <source>Reset value</source>
        <translation>重置值</translation>
    </message>
    <message>
        <source>Reset to the value in the file (Delete)</source>
        <translation>重置为文件中的值（Delete）</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Nav2 参数</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>文件中</translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation>Nav2 默认值</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>已更改 %1 个</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>与文件相同</translation>
    </message>
    <message>
        <source>Double-click a value to change it. The scenario keeps the change; the file is only changed by saving it as a new file.</source>
        <translation>双击值以更改。更改保存在场景中；只有另存为新文件时才会更改文件。</translation>
    </message>
    <message>
        <source>Nav2 default %1</source>
        <translation>Nav2 默认值 %1</translation>
    </message>
    <message>
        <source> · in the file %1</source>
        <translation> · 文件中为 %1</translation>
    </message>
    <message>
        <source> · not in the file</source>
        <translation> · 文件中没有</translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Find a Nav2 parameter</source>
        <translation>查找 Nav2 参数</translation>
    </message>
    <message>
        <source>Applies at the next start</source>
        <translation>下次启动时生效</translation>
    </message>
    <message>
        <source>Changes take effect at the next start. A dot marks values that differ from those of the run.</source>
        <translation>更改在下次启动时生效。圆点标记与本次运行不同的值。</translation>
    </message>
    <message>
        <source> · applies at the next start</source>
        <translation> · 下次启动时生效</translation>
    </message>
</context>
<context>
    <name>editor::Nav2Panel</name>
    <message>
        <source>No robot is driven by Nav2. Select a robot and choose the planner nav2 in its properties.</source>
        <translation>没有由 Nav2 驱动的机器人。选择一个机器人，并在其属性中选择规划器 nav2。</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>The robot whose parameters are shown</source>
        <translation>显示其参数的机器人</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Reset all values to those in the file</source>
        <translation>将所有值重置为文件中的值</translation>
    </message>
    <message>
        <source>Reset Nav2 parameters</source>
        <translation>重置 Nav2 参数</translation>
    </message>
    <message>
        <source>Save as a new file…</source>
        <translation>另存为新文件…</translation>
    </message>
    <message>
        <source>Write the changed values into a copy of the parameter file, with its comments and order, and use that file</source>
        <translation>将更改的值写入参数文件的副本（保留注释和顺序），并使用该文件</translation>
    </message>
    <message>
        <source>Save the Nav2 parameters as a new file</source>
        <translation>将 Nav2 参数另存为新文件</translation>
    </message>
    <message>
        <source>Nav2 parameters (*.yaml *.yml)</source>
        <translation>Nav2 参数 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Save Nav2 parameters</source>
        <translation>保存 Nav2 参数</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Use another parameter file (nav2_params.yaml)</source>
        <translation>使用其他参数文件 (nav2_params.yaml)</translation>
    </message>
    <message>
        <source>Choose Nav2 parameters</source>
        <translation>选择 Nav2 参数</translation>
    </message>
</context>
<context>
    <name>editor::NoMatchesPlaceholder</name>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Show the whole list</source>
        <translation>显示完整列表</translation>
    </message>
    <message>
        <source>No matches for &apos;%1&apos;</source>
        <translation>没有与“%1”匹配的内容</translation>
    </message>
</context>
<context>
    <name>editor::NodeFields</name>
    <message>
        <source>Name and ports of the node</source>
        <translation>节点的名称和端口</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Enter applies, Esc cancels</source>
        <translation>Enter 应用，Esc 取消</translation>
    </message>
</context>
<context>
    <name>editor::NodePalette</name>
    <message>
        <source>Search by name or description</source>
        <translation>按名称或说明搜索</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>Decorators</source>
        <translation>装饰</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Subtrees</source>
        <translation>子树</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Runs the tree %1 with all entries of this tree.</source>
        <translation>使用此树的所有条目运行树 %1。</translation>
    </message>
    <message>
        <source>Drag a node into the tree, or double-click it to add it to the selected node.</source>
        <translation>将节点拖入树中，或双击将其添加到所选节点。</translation>
    </message>
    <message>
        <source>Find a node</source>
        <translation>查找节点</translation>
    </message>
</context>
<context>
    <name>editor::NumberField</name>
    <message>
        <source>above %1%2</source>
        <translation>大于 %1%2</translation>
    </message>
    <message>
        <source>at least %1%2</source>
        <translation>至少 %1%2</translation>
    </message>
    <message>
        <source>at most %1%2</source>
        <translation>最多 %1%2</translation>
    </message>
    <message>
        <source>above %1, at most %2%3</source>
        <translation>大于 %1，最多 %2%3</translation>
    </message>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 至 %2%3</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>使用默认值</translation>
    </message>
</context>
<context>
    <name>editor::ObstaclePage</name>
    <message>
        <source>Obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>several shapes</source>
        <translation>多种形状</translation>
    </message>
</context>
<context>
    <name>editor::PanTool</name>
    <message>
        <source>Drag to move the map · Wheel zooms</source>
        <translation>拖动以移动地图 · 滚轮缩放</translation>
    </message>
</context>
<context>
    <name>editor::PeopleInteraction</name>
    <message>
        <source>Spawn a person with the same tree and goals here, as an input of the run</source>
        <translation>在此处生成具有相同树和目标点的行人，作为运行的输入</translation>
    </message>
    <message>
        <source>Add a person like</source>
        <translation>添加行人，仿照</translation>
    </message>
    <message>
        <source>Push %1…	Shift+drag</source>
        <translation>推动 %1…	Shift+拖动</translation>
    </message>
    <message>
        <source>Then drag an arrow: 1 m is 1 m/s</source>
        <translation>然后拖出箭头：1 m 相当于 1 m/s</translation>
    </message>
    <message>
        <source>Resume %1</source>
        <translation>继续 %1</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>停止 %1</translation>
    </message>
    <message>
        <source>The person stops and stands still until resumed</source>
        <translation>此人停下并站立，直到被恢复</translation>
    </message>
</context>
<context>
    <name>editor::PersonPage</name>
    <message>
        <source>Pose and body</source>
        <translation>位姿与体型</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Mix…</source>
        <translation>混合…</translation>
    </message>
    <message>
        <source>Set the shares of behaviours among these people</source>
        <translation>设置这些行人中各行为的比例</translation>
    </message>
    <message>
        <source>Adult</source>
        <translation>成人</translation>
    </message>
    <message>
        <source>Child</source>
        <translation>儿童</translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation>老人</translation>
    </message>
    <message>
        <source>Wheelchair</source>
        <translation>轮椅</translation>
    </message>
    <message>
        <source>With luggage</source>
        <translation>携带行李</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路线</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>分配目标点…</translation>
    </message>
    <message>
        <source>Assign ordered goals to several people (Ctrl+G)</source>
        <translation>为多个行人分配有序的目标点（Ctrl+G）</translation>
    </message>
    <message>
        <source>different routes</source>
        <translation>路线不同</translation>
    </message>
    <message>
        <source>visited in order</source>
        <translation>按顺序到访</translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation>到达最后一个后重复</translation>
    </message>
    <message>
        <source>One time in seconds per goal, separated by commas</source>
        <translation>每个目标点一个时间（秒），用逗号分隔</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Random, by seed</source>
        <translation>随机，由种子决定</translation>
    </message>
    <message>
        <source>Reaction to the robot</source>
        <translation>对机器人的反应</translation>
    </message>
    <message>
        <source>Then continues</source>
        <translation>之后继续</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Show the random values of a run with this seed; the scenario keeps its seed</source>
        <translation>显示使用此种子运行时的随机值；场景保留其种子</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Sample with another seed</source>
        <translation>用另一个种子采样</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Store these numbers as custom values</source>
        <translation>将这些数值存储为自定义值</translation>
    </message>
    <message>
        <source>Freeze random values</source>
        <translation>固定随机值</translation>
    </message>
    <message>
        <source>Use this seed</source>
        <translation>使用此种子</translation>
    </message>
    <message>
        <source>Set it as the seed of the scenario</source>
        <translation>将其设为场景的种子</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>更改种子</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>As in scenario</source>
        <translation>与场景相同</translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation>绕墙而行</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停下</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Starts over</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Id of the person; part of the name of the tree file</source>
        <translation>行人的 id；树文件名的一部分</translation>
    </message>
    <message>
        <source>Change number</source>
        <translation>更改编号</translation>
    </message>
    <message>
        <source>Height z</source>
        <translation>高度 z</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>群组</translation>
    </message>
    <message>
        <source>People in a group stay together while they walk</source>
        <translation>同一群组的行人行走时保持在一起</translation>
    </message>
    <message>
        <source>Walks with</source>
        <translation>同行者</translation>
    </message>
    <message>
        <source>name of the group</source>
        <translation>群组名称</translation>
    </message>
    <message>
        <source>Group name</source>
        <translation>群组名称</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>成员</translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation>解散</translation>
    </message>
    <message>
        <source>Remove all people from the group</source>
        <translation>将所有行人移出群组</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Each other (new group)</source>
        <translation>彼此同行（新群组）</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>新群组</translation>
    </message>
    <message>
        <source>different groups</source>
        <translation>不同的群组</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Appearance in the simulator of the scenario</source>
        <translation>在场景仿真器中的外观</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>人形</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation>其他处</translation>
    </message>
    <message>
        <source>Change appearance</source>
        <translation>更改外观</translation>
    </message>
    <message>
        <source>as in Gazebo</source>
        <translation>与 Gazebo 相同</translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation>重新生成树</translation>
    </message>
    <message>
        <source>Generate the tree from behaviour, reaction and goals; Ctrl+Z restores the custom tree</source>
        <translation>根据行为、反应和目标点生成树；Ctrl+Z 恢复自定义树</translation>
    </message>
    <message>
        <source>Uses a custom tree.</source>
        <translation>使用自定义树。</translation>
    </message>
    <message>
        <source>%1 with custom trees.</source>
        <translation>%1使用自定义树。</translation>
    </message>
    <message>
        <source>person</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>people</source>
        <translation>名行人</translation>
    </message>
    <message>
        <source>Changes made here do not affect it.</source>
        <translation>此处的更改不影响它。</translation>
    </message>
    <message>
        <source>Changes made here do not affect custom trees.</source>
        <translation>此处的更改不影响自定义树。</translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect it.</source>
        <translation>行为、反应和目标点不影响它。</translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect these trees.</source>
        <translation>行为、反应和目标点不影响这些树。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Random strengths depend only on the seed and the person</source>
        <translation>随机强度仅取决于种子和行人</translation>
    </message>
    <message>
        <source>Custom values</source>
        <translation>自定义值</translation>
    </message>
    <message>
        <source>Random, normal</source>
        <translation>随机，正态</translation>
    </message>
    <message>
        <source>Random, uniform</source>
        <translation>随机，均匀</translation>
    </message>
    <message>
        <source>Height of the model in a 3D simulator; not used here</source>
        <translation>三维仿真器中模型的高度；此处不使用</translation>
    </message>
    <message>
        <source>one per goal: 2, 0</source>
        <translation>每个目标一个：2, 0</translation>
    </message>
</context>
<context>
    <name>editor::PersonTool</name>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation>拖动以设置朝向 · Esc 取消</translation>
    </message>
    <message>
        <source>Click to place a person; drag to set the heading</source>
        <translation>单击以放置行人；拖动以设置朝向</translation>
    </message>
</context>
<context>
    <name>editor::PlaybackActions</name>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>End the run and return to editing</source>
        <translation>结束运行并返回编辑</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>后退一步</translation>
    </message>
    <message>
        <source>Go back one recorded step</source>
        <translation>后退一个记录的步</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>运行或暂停仿真</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>One step forward, then pause</source>
        <translation>前进一步，然后暂停</translation>
    </message>
    <message>
        <source>Go to newest step</source>
        <translation>转到最新一步</translation>
    </message>
    <message>
        <source>Show the newest step of the run</source>
        <translation>显示运行的最新一步</translation>
    </message>
    <message>
        <source>&amp;Branch here…</source>
        <translation>在此处分支(&amp;B)…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>请先开始运行：空格键</translation>
    </message>
    <message>
        <source>The newest step is already shown</source>
        <translation>已显示最新一步</translation>
    </message>
    <message>
        <source>Speed
Simulated seconds per real second</source>
        <translation>速度
每秒实际时间对应的仿真秒数</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>editor::PolygonTool</name>
    <message>
        <source>Click the corners of an obstacle; click the first one to close it</source>
        <translation>单击障碍物的各个顶点；单击第一个顶点将其闭合</translation>
    </message>
</context>
<context>
    <name>editor::PropertyPage</name>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Reset all to their default values</source>
        <translation>将全部恢复为默认值</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>已更改 %1 个</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Applies at the next start</source>
        <translation>下次启动时生效</translation>
    </message>
    <message>
        <source>A name starts with a letter and contains only letters, digits and _</source>
        <translation>名称以字母开头，只包含字母、数字和 _</translation>
    </message>
    <message>
        <source>This name is already in use</source>
        <translation>此名称已被使用</translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation>已选择 %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>name=value, separated by commas</source>
        <translation>名称=值，用逗号分隔</translation>
    </message>
    <message>
        <source>In the scenario</source>
        <translation>在场景中</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>参与</translation>
    </message>
    <message>
        <source>Off: kept in the file, but not in the run</source>
        <translation>关闭：保留在文件中，但不参与运行</translation>
    </message>
</context>
<context>
    <name>editor::PropertyPanel</name>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Restart the run with the current settings</source>
        <translation>以当前设置重新开始运行</translation>
    </message>
    <message>
        <source>Changes take effect at the next start.</source>
        <translation>更改在下次启动时生效。</translation>
    </message>
    <message>
        <source>A dot marks values that differ from those of the run</source>
        <translation>圆点标记与此次运行不同的值</translation>
    </message>
    <message>
        <source>Person %1 · %2</source>
        <translation>行人 %1 · %2</translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation> · 目标点 %1</translation>
    </message>
    <message>
        <source>other</source>
        <translation>个其他对象</translation>
    </message>
    <message>
        <source>others</source>
        <translation>个其他对象</translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>更改应用于所有这些对象</translation>
    </message>
    <message>
        <source>Changes apply to these, not to %1</source>
        <translation>更改应用于这些对象，不应用于%1</translation>
    </message>
    <message>
        <source>Scenario · nothing selected</source>
        <translation>场景 · 未选择对象</translation>
    </message>
    <message>
        <source>%1 · and %2</source>
        <translation>%1 · 以及 %2</translation>
    </message>
    <message>
        <source>Spawned by a source in this run. To change such people, select the person that the source copies.</source>
        <translation>在此次运行中由源生成。要更改这类行人，请选择该源所复制的行人。</translation>
    </message>
</context>
<context>
    <name>editor::RobotPage</name>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Parameters that are unknown to the planner or not numbers</source>
        <translation>规划器不识别或不是数值的参数</translation>
    </message>
    <message>
        <source>Body and limits</source>
        <translation>机体与限制</translation>
    </message>
    <message>
        <source>disc with the radius</source>
        <translation>以半径为准的圆盘</translation>
    </message>
    <message>
        <source>Differential</source>
        <translation>差速</translation>
    </message>
    <message>
        <source>Omnidirectional</source>
        <translation>全向</translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation>Ackermann</translation>
    </message>
    <message>
        <source>As robot type (default)</source>
        <translation>与机器人类型相同（默认）</translation>
    </message>
    <message>
        <source>People perception</source>
        <translation>行人感知</translation>
    </message>
    <message>
        <source>Visible people</source>
        <translation>可见的行人</translation>
    </message>
    <message>
        <source>All (ground truth)</source>
        <translation>全部（真值）</translation>
    </message>
    <message>
        <source>(default)</source>
        <translation>（默认）</translation>
    </message>
    <message>
        <source>Ground truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>From positions</source>
        <translation>由位置推算</translation>
    </message>
    <message>
        <source>Lidar</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>Odometry errors</source>
        <translation>里程计误差</translation>
    </message>
    <message>
        <source>Localisation</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Published data</source>
        <translation>公布的数据</translation>
    </message>
    <message>
        <source>as generic robot</source>
        <translation>与通用机器人相同</translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation>Nav2 默认值</translation>
    </message>
    <message>
        <source>not published</source>
        <translation>未公布</translation>
    </message>
    <message>
        <source>Humble</source>
        <translation>Humble</translation>
    </message>
    <message>
        <source>Jazzy</source>
        <translation>Jazzy</translation>
    </message>
    <message>
        <source>Kilted</source>
        <translation>Kilted</translation>
    </message>
    <message>
        <source>Lyrical</source>
        <translation>Lyrical</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>As in the file (default)</source>
        <translation>与文件相同（默认）</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Nav2 参数</translation>
    </message>
    <message>
        <source>Open Nav2 panel</source>
        <translation>打开 Nav2 面板</translation>
    </message>
    <message>
        <source>Use body</source>
        <translation>使用机体</translation>
    </message>
    <message>
        <source>Use radius or footprint from local_costmap in the file</source>
        <translation>使用文件中 local_costmap 的半径或轮廓</translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation>使用 Nav2 文件中的机体</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>已更改 %1 个</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Goal X</source>
        <translation>目标 X</translation>
    </message>
    <message>
        <source>Goal Y</source>
        <translation>目标 Y</translation>
    </message>
    <message>
        <source>Ordered global goals instead of a point</source>
        <translation>用有序的全局目标点代替一个点</translation>
    </message>
    <message>
        <source>Or route</source>
        <translation>或路线</translation>
    </message>
    <message>
        <source>Change robot route</source>
        <translation>更改机器人路线</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>静止不动</translation>
    </message>
    <message>
        <source>ends the run</source>
        <translation>结束运行</translation>
    </message>
    <message>
        <source>Choose the parameter file, and see and change all parameters</source>
        <translation>选择参数文件，查看并更改所有参数</translation>
    </message>
</context>
<context>
    <name>editor::RobotPicture</name>
    <message>
        <source>Robot body</source>
        <translation>机器人机体</translation>
    </message>
    <message>
        <source>%1 long, %2 wide</source>
        <translation>长 %1，宽 %2</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>操控</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>转弯</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转向</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
</context>
<context>
    <name>editor::RobotTool</name>
    <message>
        <source>Click the goal of the robot · Esc keeps the current goal</source>
        <translation>单击机器人的目标点 · Esc 保留当前目标点</translation>
    </message>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation>拖动以设置朝向 · Esc 取消</translation>
    </message>
    <message>
        <source>Click to place the robot; drag to set the heading · Shift adds another</source>
        <translation>单击以放置机器人；拖动以设置朝向 · Shift 添加另一个</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>放置 %1</translation>
    </message>
    <message>
        <source>Set robot goal</source>
        <translation>设置机器人目标点</translation>
    </message>
</context>
<context>
    <name>editor::RouteEditor</name>
    <message>
        <source>
Click for options, press Delete to remove it</source>
        <translation>
单击查看选项，按 Delete 移除</translation>
    </message>
    <message>
        <source>+ Add</source>
        <translation>+ 添加</translation>
    </message>
    <message>
        <source>Add a goal to the end of the route</source>
        <translation>在路线末尾添加目标点</translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation>还没有目标点：按 G 并单击地图</translation>
    </message>
    <message>
        <source>Select goal %1</source>
        <translation>选择目标点 %1</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>前移</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>后移</translation>
    </message>
    <message>
        <source>Remove from the route</source>
        <translation>从路线中移除</translation>
    </message>
</context>
<context>
    <name>editor::RouteTool</name>
    <message>
        <source>Click the person or robot that follows the route (Shift adds more)</source>
        <translation>单击沿路线行走的行人或机器人（Shift 添加更多）</translation>
    </message>
    <message>
        <source>Click the goals in visiting order</source>
        <translation>按到访顺序单击目标点</translation>
    </message>
    <message>
        <source>Route %1 · Enter applies · Backspace removes the last goal · Esc cancels</source>
        <translation>路线 %1 · Enter 应用 · Backspace 移除最后一个目标点 · Esc 取消</translation>
    </message>
    <message>
        <source>Nothing is selected: click a person or robot first</source>
        <translation>未选择任何对象：请先单击行人或机器人</translation>
    </message>
    <message>
        <source>No goal here: click the pin of a goal, or press G to add goals</source>
        <translation>此处没有目标点：单击目标点的图钉，或按 G 添加目标点</translation>
    </message>
    <message>
        <source>%1 is already the last goal of the route</source>
        <translation>%1 已是路线的最后一个目标点</translation>
    </message>
</context>
<context>
    <name>editor::RunEvents</name>
    <message>
        <source>%1 has arrived at %2</source>
        <translation>%1 已到达 %2</translation>
    </message>
    <message>
        <source>the goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>机器人 %1</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>行人 %1</translation>
    </message>
    <message>
        <source>%1 touches a wall</source>
        <translation>%1 碰到墙</translation>
    </message>
</context>
<context>
    <name>editor::RunOverlayUpdater</name>
    <message>
        <source>says %1</source>
        <translation>说 %1</translation>
    </message>
    <message>
        <source>hears %1: %2</source>
        <translation>听到 %1：%2</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>行人 %1</translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation> · 前往 %1</translation>
    </message>
</context>
<context>
    <name>editor::RunStateSection</name>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Manual drive</source>
        <translation>手动操控</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>reacting</source>
        <translation>正在反应</translation>
    </message>
    <message>
        <source>%1 m away</source>
        <translation>距离 %1 m</translation>
    </message>
</context>
<context>
    <name>editor::RunningNodes</name>
    <message>
        <source>Running nodes</source>
        <translation>运行中的节点</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Running for</source>
        <translation>已运行</translation>
    </message>
    <message>
        <source>Running nodes are listed during a run: press Space.</source>
        <translation>运行期间列出运行中的节点：按空格键。</translation>
    </message>
    <message>
        <source>No node is running at this time.</source>
        <translation>此时没有节点在运行。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>editor::RunsPanel</name>
    <message>
        <source>Add a recorded run to compare: the output folder of `run`</source>
        <translation>添加已录制的运行以进行比较：`run` 的输出文件夹</translation>
    </message>
    <message>
        <source>Show this run at the same time step</source>
        <translation>在相同的时间步显示此运行</translation>
    </message>
    <message>
        <source>Remove this run from the list</source>
        <translation>从列表中移除此运行</translation>
    </message>
    <message>
        <source>Show up to four compared runs beside the map</source>
        <translation>在地图旁显示最多四个比较的运行</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Branched at</source>
        <translation>分支时刻</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Compare with a run folder</source>
        <translation>与运行文件夹比较</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Press F2 to rename</source>
        <translation>按 F2 重命名</translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation>%1（已截断）</translation>
    </message>
    <message>
        <source>Branch here…</source>
        <translation>在此处分支…</translation>
    </message>
    <message>
        <source>Add a run…</source>
        <translation>添加运行…</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>并排显示</translation>
    </message>
</context>
<context>
    <name>editor::ScenarioDocument</name>
    <message>
        <source>Change map</source>
        <translation>更换地图</translation>
    </message>
    <message>
        <source>Keep the tree file of %1</source>
        <translation>保留 %1 的树文件</translation>
    </message>
    <message>
        <source>Use the generated tree of %1</source>
        <translation>使用为 %1 生成的树</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>editor::ScenarioPanel</name>
    <message>
        <source>Show on the map</source>
        <translation>在地图上显示</translation>
    </message>
    <message>
        <source>Centre the map on it</source>
        <translation>将地图居中到该对象</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation>为所选对象创建副本</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation>移除所选对象；路线会随之更新</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Change the number of the goal</source>
        <translation>更改目标点的编号</translation>
    </message>
    <message>
        <source>Rename it; references are updated</source>
        <translation>将其重命名；引用会随之更新</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>停用</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>Keep it in the file, but not in the simulation</source>
        <translation>保留在文件中，但不参与仿真</translation>
    </message>
    <message>
        <source>Include it in the simulation again</source>
        <translation>重新加入仿真</translation>
    </message>
    <message>
        <source>Select all of this kind</source>
        <translation>选择所有此类对象</translation>
    </message>
    <message>
        <source>Select everything of this kind to change it together</source>
        <translation>选择所有此类对象以便一起更改</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>行为</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>分配目标点…</translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation>选择行人到访的目标点及其顺序</translation>
    </message>
    <message>
        <source>Walk as a group</source>
        <translation>结伴而行</translation>
    </message>
    <message>
        <source>Make these people walk together as a group</source>
        <translation>让这些行人作为群组一起行走</translation>
    </message>
    <message>
        <source>A group needs two or more people: select more</source>
        <translation>群组需要两名或更多行人：请选择更多</translation>
    </message>
    <message>
        <source>Walk alone</source>
        <translation>单独行走</translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation>离开群组</translation>
    </message>
    <message>
        <source>This person is in no group</source>
        <translation>此行人不在任何群组中</translation>
    </message>
    <message>
        <source>None of these people is in a group</source>
        <translation>这些行人都不在群组中</translation>
    </message>
    <message>
        <source>Filter people, goals, areas</source>
        <translation>筛选行人、目标点、区域</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Nothing on the map yet.
Press P and click to place a person.</source>
        <translation>地图上还没有任何对象。
按 P 并单击以放置行人。</translation>
    </message>
</context>
<context>
    <name>editor::ScrubActions</name>
    <message>
        <source>&amp;Previous contact</source>
        <translation>上一个接触(&amp;P)</translation>
    </message>
    <message>
        <source>Show the previous contact</source>
        <translation>显示上一个接触</translation>
    </message>
    <message>
        <source>Ne&amp;xt contact</source>
        <translation>下一个接触(&amp;X)</translation>
    </message>
    <message>
        <source>Show the next contact</source>
        <translation>显示下一个接触</translation>
    </message>
    <message>
        <source>Loop a section</source>
        <translation>循环片段</translation>
    </message>
    <message>
        <source>Repeat from A to B; drag the marks on the timeline, or Shift+drag a new section</source>
        <translation>从 A 到 B 重复；拖动时间轴上的标记，或 Shift+拖动选择新片段</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>洋葱皮(&amp;O)</translation>
    </message>
    <message>
        <source>Positions of all people 1, 2 and 3 s before and after</source>
        <translation>所有行人前后 1、2 和 3 s 的位置</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Set the time span of trails in a run</source>
        <translation>设置运行中轨迹的时间长度</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>请先开始运行：空格键</translation>
    </message>
    <message>
        <source>No contact before the displayed step</source>
        <translation>显示的步之前没有接触</translation>
    </message>
    <message>
        <source>No contact after the displayed step</source>
        <translation>显示的步之后没有接触</translation>
    </message>
</context>
<context>
    <name>editor::SearchField</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
</context>
<context>
    <name>editor::SelectTool</name>
    <message>
        <source>The robot follows until you release the button</source>
        <translation>机器人跟随，直到您松开按钮</translation>
    </message>
    <message>
        <source>Release to branch with the person here</source>
        <translation>松开以创建行人位于此处的分支</translation>
    </message>
    <message>
        <source>Drag an arrow: a longer arrow pushes harder · Esc cancels</source>
        <translation>拖出箭头：箭头越长推力越大 · Esc 取消</translation>
    </message>
    <message>
        <source>Click a person for details · Drag a person to branch with another position · Space resumes</source>
        <translation>单击行人查看详情 · 拖动行人以创建其位于其他位置的分支 · 空格键继续</translation>
    </message>
    <message>
        <source>Click a person for details · Shift+drag to push · Drag a robot to lead it · Space pauses</source>
        <translation>单击行人查看详情 · Shift+拖动以推动 · 拖动机器人以引导它 · 空格键暂停</translation>
    </message>
    <message>
        <source>Click a person for details · Space pauses</source>
        <translation>单击行人查看详情 · 空格键暂停</translation>
    </message>
    <message>
        <source>Click to select · Drag over empty space to select several</source>
        <translation>单击以选择 · 在空白处拖动以选择多个</translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation>拖动以移动</translation>
    </message>
    <message>
        <source>Drag the round handle to turn</source>
        <translation>拖动圆形手柄以旋转</translation>
    </message>
    <message>
        <source>Drag a corner to resize</source>
        <translation>拖动角点以调整大小</translation>
    </message>
    <message>
        <source>Double-click an edge to add a corner</source>
        <translation>双击边以添加顶点</translation>
    </message>
    <message>
        <source>Ctrl+D duplicates</source>
        <translation>Ctrl+D 创建副本</translation>
    </message>
    <message>
        <source>Del removes</source>
        <translation>Del 移除</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>移除顶点</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>添加顶点</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>半径 %1 m</translation>
    </message>
</context>
<context>
    <name>editor::SettingsPage</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>No (default)</source>
        <translation>否（默认）</translation>
    </message>
    <message>
        <source>With people</source>
        <translation>与行人</translation>
    </message>
    <message>
        <source>With anything</source>
        <translation>与任何物体</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>步</translation>
    </message>
    <message>
        <source>step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>sfm (default)</source>
        <translation>sfm（默认）</translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation>绕墙而行</translation>
    </message>
    <message>
        <source>Straight, as in HuNavSim</source>
        <translation>直线，与 HuNavSim 相同</translation>
    </message>
    <message>
        <source>Nearest wall points</source>
        <translation>最近的墙点</translation>
    </message>
    <message>
        <source>Rays, like a lidar</source>
        <translation>射线，类似激光雷达</translation>
    </message>
    <message>
        <source>Start over when done</source>
        <translation>完成后重新开始</translation>
    </message>
    <message>
        <source>no wrapping</source>
        <translation>不环绕</translation>
    </message>
    <message>
        <source>Two x values in metres, ascending, separated by a comma</source>
        <translation>两个以米为单位的 x 值，升序，用逗号分隔</translation>
    </message>
    <message>
        <source>Variation between seeds</source>
        <translation>种子间的变化</translation>
    </message>
    <message>
        <source>None (default)</source>
        <translation>无（默认）</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Strong</source>
        <translation>强</translation>
    </message>
    <message>
        <source>Varied quantities</source>
        <translation>变化的量</translation>
    </message>
    <message>
        <source>not varied</source>
        <translation>不变化</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>as above</source>
        <translation>同上</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>卡片</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>简单</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>困难</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>Model parameters</source>
        <translation>模型参数</translation>
    </message>
    <message>
        <source>Parameters that are unknown to the model or not numbers</source>
        <translation>模型不识别或不是数值的参数</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>all metrics</source>
        <translation>所有指标</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Simulator and map</source>
        <translation>仿真器与地图</translation>
    </message>
    <message>
        <source>not specified</source>
        <translation>未指定</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Worlds</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>humble (default)</source>
        <translation>humble（默认）</translation>
    </message>
    <message>
        <source>Publish people</source>
        <translation>发布行人</translation>
    </message>
</context>
<context>
    <name>editor::SimulationRunner</name>
    <message>
        <source>Branch %1</source>
        <translation>分支 %1</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>已录制的运行</translation>
    </message>
</context>
<context>
    <name>editor::TextField</name>
    <message>
        <source>Not used: %1</source>
        <translation>未采用：%1</translation>
    </message>
</context>
<context>
    <name>editor::TextViewer</name>
    <message>
        <source>Text of the file</source>
        <translation>文件文本</translation>
    </message>
    <message>
        <source>Open with…</source>
        <translation>打开方式…</translation>
    </message>
    <message>
        <source>Open the file with the default application</source>
        <translation>用默认应用程序打开文件</translation>
    </message>
    <message>
        <source>%1 is too long to display</source>
        <translation>%1 太长，无法显示</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>No application is available to open %1</source>
        <translation>没有可打开 %1 的应用程序</translation>
    </message>
</context>
<context>
    <name>editor::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>No longer stored: the disk is full</source>
        <translation>不再存储：磁盘已满</translation>
    </message>
</context>
<context>
    <name>editor::ToolManager</name>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>运行期间不可用：Ctrl+R 返回编辑</translation>
    </message>
</context>
<context>
    <name>editor::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>工具选项</translation>
    </message>
</context>
<context>
    <name>editor::TreeCanvas</name>
    <message>
        <source>Behaviour tree as a graph</source>
        <translation>行为树图</translation>
    </message>
    <message>
        <source>Unknown node type; it is kept unchanged.</source>
        <translation>未知节点类型；保持不变。</translation>
    </message>
    <message>
        <source>In an included file: read-only here</source>
        <translation>在包含的文件中：此处只读</translation>
    </message>
</context>
<context>
    <name>editor::TreeEditor</name>
    <message>
        <source>Name of the node</source>
        <translation>节点名称</translation>
    </message>
    <message>
        <source>Tree of</source>
        <translation>树所属行人</translation>
    </message>
    <message>
        <source>Person whose tree is shown; you can also select a person on the map</source>
        <translation>显示其树的行人；也可在地图上选择行人</translation>
    </message>
    <message>
        <source>Apply edits to all people with the same tree</source>
        <translation>将编辑应用于具有相同树的所有行人</translation>
    </message>
    <message>
        <source>Assign to…</source>
        <translation>分配给…</translation>
    </message>
    <message>
        <source>Assign the same tree to other people</source>
        <translation>将同一棵树分配给其他行人</translation>
    </message>
    <message>
        <source>New tree</source>
        <translation>新建树</translation>
    </message>
    <message>
        <source>Start a new tree with an empty Sequence as its root</source>
        <translation>以空的 Sequence 为根节点新建树</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>从左到右</translation>
    </message>
    <message>
        <source>Place the root on the left or at the top</source>
        <translation>将根节点放在左侧或顶部</translation>
    </message>
    <message>
        <source>Use node positions of the file or automatic layout</source>
        <translation>使用文件中的节点位置或自动布局</translation>
    </message>
    <message>
        <source>Expand all</source>
        <translation>全部展开</translation>
    </message>
    <message>
        <source>Show all nodes or only the branches</source>
        <translation>显示所有节点或仅显示分支</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应窗口</translation>
    </message>
    <message>
        <source>Fit the whole tree in the window (F)</source>
        <translation>使整棵树适应窗口（F）</translation>
    </message>
    <message>
        <source>Layout: automatic</source>
        <translation>布局：自动</translation>
    </message>
    <message>
        <source>Layout: from file</source>
        <translation>布局：来自文件</translation>
    </message>
    <message>
        <source>Top down</source>
        <translation>从上到下</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>What each node returned in the run</source>
        <translation>每个节点在运行中返回的结果</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>The nodes that are running at the displayed step</source>
        <translation>在显示的步中运行的节点</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>Edit the XML file of the tree</source>
        <translation>编辑树的 XML 文件</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>黑板</translation>
    </message>
    <message>
        <source>Blackboard of the person&apos;s tree at the displayed step</source>
        <translation>显示的步中该行人的树的黑板</translation>
    </message>
    <message>
        <source>Collapse</source>
        <translation>折叠</translation>
    </message>
    <message>
        <source>Nothing was picked</source>
        <translation>未选取任何对象</translation>
    </message>
    <message>
        <source>Edits change %1 people</source>
        <translation>编辑会更改 %1 名行人</translation>
    </message>
    <message>
        <source>Edits change only this person</source>
        <translation>编辑仅更改此行人</translation>
    </message>
    <message>
        <source>Edit the XML of %1</source>
        <translation>编辑 %1 的 XML</translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation>还没有行人：按 P 并单击地图。</translation>
    </message>
    <message>
        <source>The node is in an included file, which cannot be edited here</source>
        <translation>该节点在包含的文件中，无法在此处编辑</translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation>请先选择一个节点</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 个节点</translation>
    </message>
    <message>
        <source>Wrap %2 in %1</source>
        <translation>用 %1 包裹 %2</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>为 %1 创建副本</translation>
    </message>
    <message>
        <source>%1 is copied as XML</source>
        <translation>%1 已复制为 XML</translation>
    </message>
    <message>
        <source>%1 are copied as XML</source>
        <translation>%1已复制为 XML</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>剪切 %1</translation>
    </message>
    <message>
        <source>The clipboard contains no node: copy a node or its XML first</source>
        <translation>剪贴板中没有节点：请先复制节点或其 XML</translation>
    </message>
    <message>
        <source>Wrap %1 in %2</source>
        <translation>用 %2 包裹 %1</translation>
    </message>
    <message>
        <source>Replace %1 with %2</source>
        <translation>用 %2 替换 %1</translation>
    </message>
    <message>
        <source>Remove %1, keep children</source>
        <translation>移除 %1，保留子节点</translation>
    </message>
    <message>
        <source>Extract %1 as subtree</source>
        <translation>将 %1 提取为子树</translation>
    </message>
    <message>
        <source>Inline subtree %1</source>
        <translation>内联子树 %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>Type the name of a node: Enter adds it below the selected one</source>
        <translation>输入节点名称：按 Enter 将其添加到所选节点下方</translation>
    </message>
    <message>
        <source>Click the goal on the map, or in the scenario list</source>
        <translation>在地图或场景列表中单击目标点</translation>
    </message>
    <message>
        <source>Click the person on the map, or in the scenario list</source>
        <translation>在地图或场景列表中单击行人</translation>
    </message>
    <message>
        <source>Change %2 of %1</source>
        <translation>更改 %1 的 %2</translation>
    </message>
    <message>
        <source>Regenerate the tree of %1</source>
        <translation>重新生成 %1 的树</translation>
    </message>
    <message>
        <source>Assign the tree of %1 to %2</source>
        <translation>将 %1 的树分配给 %2</translation>
    </message>
    <message>
        <source>No other person</source>
        <translation>没有其他行人</translation>
    </message>
    <message>
        <source>Pick %1 on the map</source>
        <translation>在地图上选取 %1</translation>
    </message>
    <message>
        <source>Wrap in</source>
        <translation>包裹到</translation>
    </message>
    <message>
        <source>Duplicate	Ctrl+D</source>
        <translation>创建副本	Ctrl+D</translation>
    </message>
    <message>
        <source>Cut	Ctrl+X</source>
        <translation>剪切	Ctrl+X</translation>
    </message>
    <message>
        <source>Copy as XML	Ctrl+C</source>
        <translation>复制为 XML	Ctrl+C</translation>
    </message>
    <message>
        <source>Delete	Del</source>
        <translation>删除	Del</translation>
    </message>
    <message>
        <source>Paste	Ctrl+V</source>
        <translation>粘贴	Ctrl+V</translation>
    </message>
    <message>
        <source>Fit	F</source>
        <translation>适应窗口	F</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Remove, keep children</source>
        <translation>移除，保留子节点</translation>
    </message>
    <message>
        <source>Inline subtree</source>
        <translation>内联子树</translation>
    </message>
    <message>
        <source>Extract as subtree</source>
        <translation>提取为子树</translation>
    </message>
    <message>
        <source>Edit ports	Enter</source>
        <translation>编辑端口	Enter</translation>
    </message>
    <message>
        <source>Add a node…	Ins</source>
        <translation>添加节点…	Ins</translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation>重命名	F2</translation>
    </message>
    <message>
        <source>Earlier	Alt+Left</source>
        <translation>前移	Alt+Left</translation>
    </message>
    <message>
        <source>Later	Alt+Right</source>
        <translation>后移	Alt+Right</translation>
    </message>
    <message>
        <source>Expand	+</source>
        <translation>展开	+</translation>
    </message>
    <message>
        <source>Collapse	-</source>
        <translation>折叠	-</translation>
    </message>
</context>
<context>
    <name>editor::TreeHistory</name>
    <message>
        <source>What the nodes returned over time</source>
        <translation>节点随时间返回的结果</translation>
    </message>
    <message>
        <source>The run used another tree: run it again to see its nodes here.</source>
        <translation>该运行使用了另一棵树：请重新运行以在此处查看其节点。</translation>
    </message>
    <message>
        <source>Run the scenario to see what each node returns over time.</source>
        <translation>运行场景以查看每个节点随时间返回的结果。</translation>
    </message>
</context>
<context>
    <name>editor::TreeOutline</name>
    <message>
        <source>Behaviour tree</source>
        <translation>行为树</translation>
    </message>
</context>
<context>
    <name>editor::TreeText</name>
    <message>
        <source>XML of the tree</source>
        <translation>树的 XML</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Discard the edit and show the current tree</source>
        <translation>放弃编辑并显示当前的树</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
</context>
<context>
    <name>editor::ValueForm</name>
    <message>
        <source>Read %1 from a blackboard entry</source>
        <translation>从黑板条目读取 %1</translation>
    </message>
    <message>
        <source>Enter %1 as a number</source>
        <translation>以数值输入 %1</translation>
    </message>
</context>
<context>
    <name>editor::WallTool</name>
    <message>
        <source>Drag a wall, or click its corners one by one · Shift: 15° steps</source>
        <translation>拖出墙，或逐个单击其顶点 · Shift：15° 步进</translation>
    </message>
    <message>
        <source>At least two corners are required</source>
        <translation>至少需要两个顶点</translation>
    </message>
    <message>
        <source>Too short</source>
        <translation>太短</translation>
    </message>
</context>
</TS>
