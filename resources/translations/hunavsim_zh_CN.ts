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
        <source>starts to be ticked</source>
        <translation>开始被 tick 时</translation>
    </message>
    <message>
        <source>starts to run</source>
        <translation>开始运行时</translation>
    </message>
    <message>
        <source>starts to succeed</source>
        <translation>开始成功时</translation>
    </message>
    <message>
        <source>starts to fail</source>
        <translation>开始失败时</translation>
    </message>
    <message>
        <source>starts to be skipped</source>
        <translation>开始被跳过时</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Yaml base name</source>
        <translation>YAML 基本名称</translation>
    </message>
    <message>
        <source>Base name of the file; part of the names of tree files</source>
        <translation>文件的基本名称；树文件名的一部分</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>仿真器</translation>
    </message>
    <message>
        <source>Simulator in which HuNavSim runs the file</source>
        <translation>HuNavSim 运行该文件所用的仿真器</translation>
    </message>
    <message>
        <source>Map name</source>
        <translation>地图名称</translation>
    </message>
    <message>
        <source>Name of the map, without folder and extension</source>
        <translation>地图的名称，不含文件夹和扩展名</translation>
    </message>
    <message>
        <source>ROS topics</source>
        <translation>ROS 话题</translation>
    </message>
    <message>
        <source>Publish people on ROS topics</source>
        <translation>在 ROS 话题上发布行人</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Id of the person; part of the name of the tree file</source>
        <translation>行人的 id；树文件名的一部分</translation>
    </message>
    <message>
        <source>Walks with</source>
        <translation>同行者</translation>
    </message>
    <message>
        <source>Group number; people of one group stay together; -1: no group</source>
        <translation>群组编号；同一群组的行人保持在一起；-1：无群组</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>人形</translation>
    </message>
    <message>
        <source>Appearance of the person in the simulator</source>
        <translation>行人在仿真器中的外观</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Desired walking speed</source>
        <translation>期望的行走速度</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the circular body; with the model das it is 0.20 m, except for wheelchairs</source>
        <translation>圆形身体的半径；使用模型 das 时为 0.20 m，轮椅除外</translation>
    </message>
    <message>
        <source>Arrival radius</source>
        <translation>到达半径</translation>
    </message>
    <message>
        <source>Distance within which a goal is reached; 0 counts as 0.1</source>
        <translation>在此距离内视为到达目标点；0 按 0.1 计</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Restart the route after the last goal</source>
        <translation>到达最后一个目标点后重新开始路线</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>行为</translation>
    </message>
    <message>
        <source>How the person reacts to the robot</source>
        <translation>行人对机器人的反应方式</translation>
    </message>
    <message>
        <source>Sees within</source>
        <translation>察觉距离</translation>
    </message>
    <message>
        <source>Distance within which the person notices the robot</source>
        <translation>行人察觉机器人的距离</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Duration of the reaction</source>
        <translation>反应的持续时间</translation>
    </message>
    <message>
        <source>Only once</source>
        <translation>仅一次</translation>
    </message>
    <message>
        <source>React only once</source>
        <translation>仅反应一次</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed during the reaction; absent: `max_vel`, or 2.0 if that is absent too</source>
        <translation>反应期间的速度；缺省：`max_vel`，若也缺省则为 2.0</translation>
    </message>
    <message>
        <source>Keeps away</source>
        <translation>保持距离</translation>
    </message>
    <message>
        <source>Distance to which the person retreats from the robot</source>
        <translation>行人退避到与机器人的此距离</translation>
    </message>
    <message>
        <source>Stops at</source>
        <translation>停止距离</translation>
    </message>
    <message>
        <source>Distance to the robot at which the person stops</source>
        <translation>行人停下时与机器人的距离</translation>
    </message>
    <message>
        <source>Blocks at</source>
        <translation>阻挡距离</translation>
    </message>
    <message>
        <source>Distance in front of the robot at which the person stands</source>
        <translation>行人站在机器人前方的距离</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Source of the force factors, see below</source>
        <translation>力系数的来源，见下文</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Factor of the attractive force of the goal</source>
        <translation>目标点吸引力的系数</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of walls and obstacles</source>
        <translation>墙和障碍物排斥力的系数</translation>
    </message>
    <message>
        <source>People</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of other people</source>
        <translation>其他行人排斥力的系数</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of the robot while scared; never randomised</source>
        <translation>害怕时机器人排斥力的系数；从不随机</translation>
    </message>
    <message>
        <source>Enters at</source>
        <translation>进入时间</translation>
    </message>
    <message>
        <source>Time at which the person enters the world</source>
        <translation>行人进入世界的时间</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>体型</translation>
    </message>
    <message>
        <source>Body type; determines the mass and the symbol on the map</source>
        <translation>体型类别；决定质量和地图上的符号</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Mass of the body; absent: 80, 32, 75, 100, 100 by kind</source>
        <translation>身体的质量；缺省：按类别为 80、32、75、100、100</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Pedestrian model; absent: that of the scenario</source>
        <translation>行人模型；缺省：场景的模型</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>路线</translation>
    </message>
    <message>
        <source>Paths planned around walls, or straight lines; absent: as in the scenario</source>
        <translation>绕墙规划的路径，或直线；缺省：与场景相同</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>结束时</translation>
    </message>
    <message>
        <source>What the person does after the last goal of a route that does not repeat</source>
        <translation>在不重复的路线的最后一个目标点之后行人的行为</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Waiting time at each goal of the route</source>
        <translation>路线上每个目标点的等待时间</translation>
    </message>
    <message>
        <source>Tree file</source>
        <translation>树文件</translation>
    </message>
    <message>
        <source>Behaviour tree file, relative to the scenario; several people may use the same one</source>
        <translation>行为树文件，相对于场景；多个行人可以使用同一文件</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Robot type</source>
        <translation>机器人类型</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Planner that drives the robot to its goals</source>
        <translation>将机器人驱动到目标点的规划器</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Planner external: the planner program with its arguments, or unix:PATH of a socket; runs only with --allow-code</source>
        <translation>规划器 external：规划器程序及其参数，或套接字的 unix:路径；仅在使用 --allow-code 时运行</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Parameters of the planner: name and value of each</source>
        <translation>规划器的参数：各参数的名称和值</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Nav2 参数</translation>
    </message>
    <message>
        <source>Planner nav2: the parameter file (`nav2_params.yaml`) or the name of a shipped one; a list: several files, of which later ones override earlier ones, and single values in ROS 2 syntax (`FollowPath.max_vel_x:=0.3`)</source>
        <translation>规划器 nav2：参数文件（`nav2_params.yaml`）或随附文件的名称；列表：多个文件（后面的覆盖前面的），以及 ROS 2 语法的单个值（`FollowPath.max_vel_x:=0.3`）</translation>
    </message>
    <message>
        <source>Nav2 tree</source>
        <translation>Nav2 树</translation>
    </message>
    <message>
        <source>Planner nav2: the navigator&apos;s behaviour tree file or the name of a shipped one</source>
        <translation>规划器 nav2：导航器的行为树文件或随附文件的名称</translation>
    </message>
    <message>
        <source>Nav2 branch</source>
        <translation>Nav2 分支</translation>
    </message>
    <message>
        <source>Planner nav2: Nav2 branch whose defaults and algorithms are used; absent: detected from the parameter file</source>
        <translation>规划器 nav2：使用其默认值和算法的 Nav2 分支；缺省：从参数文件中检测</translation>
    </message>
    <message>
        <source>Nav2 topics</source>
        <translation>Nav2 话题</translation>
    </message>
    <message>
        <source>Planner nav2: topic messages and service calls, separated by `;`, each with a time [s], a name and the message: `12 controller_selector FollowPath2; 20 /pause`</source>
        <translation>规划器 nav2：话题消息和服务调用，用 `;` 分隔，每项包含时间 [s]、名称和消息：`12 controller_selector FollowPath2; 20 /pause`</translation>
    </message>
    <message>
        <source>Nav2 values</source>
        <translation>Nav2 值</translation>
    </message>
    <message>
        <source>Planner nav2: values that override those of the parameter file, by node and name</source>
        <translation>规划器 nav2：覆盖参数文件的值，按节点和名称</translation>
    </message>
    <message>
        <source>Body from Nav2</source>
        <translation>机体取自 Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: true: radius or footprint are read from local_costmap in the parameter files</source>
        <translation>规划器 nav2：true：从参数文件的 local_costmap 读取半径或轮廓</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Start pose: `x`, `y` and heading `h`</source>
        <translation>起始位姿：`x`、`y` 和朝向 `h`</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Goal position: `x` and `y`</source>
        <translation>目标位置：`x` 和 `y`</translation>
    </message>
    <message>
        <source>Or route</source>
        <translation>或路线</translation>
    </message>
    <message>
        <source>Numbers of global goals in order, instead of `goal`</source>
        <translation>按顺序的全局目标点编号，代替 `goal`</translation>
    </message>
    <message>
        <source>Distance within which a goal is reached; with `nav2` the navigator decides</source>
        <translation>在此距离内视为到达目标点；使用 `nav2` 时由导航器决定</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>出发时间</translation>
    </message>
    <message>
        <source>Time at which the robot starts</source>
        <translation>机器人出发的时间</translation>
    </message>
    <message>
        <source>Radius of the robot&apos;s circular body</source>
        <translation>机器人圆形机体的半径</translation>
    </message>
    <message>
        <source>Mass of the robot</source>
        <translation>机器人的质量</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Maximum acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>转向速度</translation>
    </message>
    <message>
        <source>Maximum turn rate</source>
        <translation>最大转向速度</translation>
    </message>
    <message>
        <source>Turn accel.</source>
        <translation>转向加速度</translation>
    </message>
    <message>
        <source>Maximum angular acceleration</source>
        <translation>最大角加速度</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>X coordinates of the footprint&apos;s corners in the robot&apos;s frame; replaces the circular body</source>
        <translation>机器人坐标系中轮廓顶点的 X 坐标；取代圆形机体</translation>
    </message>
    <message>
        <source>Footprint y</source>
        <translation>轮廓 y</translation>
    </message>
    <message>
        <source>Y coordinates of these corners, as many as `footprint_x`</source>
        <translation>这些顶点的 Y 坐标，数量与 `footprint_x` 相同</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动方式</translation>
    </message>
    <message>
        <source>Kinematics of the drive</source>
        <translation>驱动的运动学</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>转弯半径</translation>
    </message>
    <message>
        <source>Minimum turning radius of a robot with Ackermann steering</source>
        <translation>阿克曼转向机器人的最小转弯半径</translation>
    </message>
    <message>
        <source>Lidar</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>Lidar of the robot, keys below; absent: that of the robot type</source>
        <translation>机器人的激光雷达，键见下文；缺省：机器人类型的激光雷达</translation>
    </message>
    <message>
        <source>Detector</source>
        <translation>检测器</translation>
    </message>
    <message>
        <source>Detection of people and other robots, keys below</source>
        <translation>行人和其他机器人的检测，键见下文</translation>
    </message>
    <message>
        <source>Odometry noise</source>
        <translation>里程计噪声</translation>
    </message>
    <message>
        <source>Odometry errors, which accumulate; absent: none</source>
        <translation>会累积的里程计误差；缺省：无</translation>
    </message>
    <message>
        <source>Localization</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>Errors and corrections of the localization (AMCL); absent: none</source>
        <translation>定位（AMCL）的误差和修正；缺省：无</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Battery of the robot; absent: it never runs low</source>
        <translation>机器人的电池；缺省：电量永不耗尽</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>光束数</translation>
    </message>
    <message>
        <source>Number of beams per scan; 0: no lidar; absent, here and below: that of the robot type</source>
        <translation>每次扫描的光束数；0：无激光雷达；缺省（此处及以下）：机器人类型的值</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>Maximum range</source>
        <translation>最大量程</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Scans per second</source>
        <translation>每秒扫描次数</translation>
    </message>
    <message>
        <source>Angle min</source>
        <translation>最小角度</translation>
    </message>
    <message>
        <source>Angle of the first beam</source>
        <translation>第一束的角度</translation>
    </message>
    <message>
        <source>Angle max</source>
        <translation>最大角度</translation>
    </message>
    <message>
        <source>Angle of the last beam; if it is a full turn after the first, the beams are spaced evenly</source>
        <translation>最后一束的角度；若与第一束相差一整圈，则光束均匀分布</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Position in the robot&apos;s frame: forward</source>
        <translation>机器人坐标系中的位置：向前</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Position in the robot&apos;s frame: to the left</source>
        <translation>机器人坐标系中的位置：向左</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Orientation in the robot&apos;s frame</source>
        <translation>机器人坐标系中的朝向</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Standard deviation of a measured distance</source>
        <translation>测量距离的标准差</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>双腿</translation>
    </message>
    <message>
        <source>The lidar detects people as two legs instead of discs</source>
        <translation>激光雷达将行人视为双腿，否则视为圆盘</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Write each scan to `scans.csv`</source>
        <translation>将每次扫描写入 `scans.csv`</translation>
    </message>
    <message>
        <source>People perception</source>
        <translation>行人感知</translation>
    </message>
    <message>
        <source>Detections of the sensors, or the exact state of all bodies everywhere, which ignores the keys below</source>
        <translation>传感器的检测，或所有物体在任意位置的精确状态（此时忽略以下键）</translation>
    </message>
    <message>
        <source>Maximum distance of a detected body&apos;s centre</source>
        <translation>被检测物体中心的最大距离</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>视场</translation>
    </message>
    <message>
        <source>Field of view, half of it to either side</source>
        <translation>视野，左右各一半</translation>
    </message>
    <message>
        <source>Detections per second; 0: one per time step</source>
        <translation>每秒检测次数；0：每个时间步一次</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Delay between detection and planner</source>
        <translation>检测与规划器之间的延迟</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate</source>
        <translation>每个坐标的标准差</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>漏检</translation>
    </message>
    <message>
        <source>Probability per detection of missing a visible body</source>
        <translation>每次检测漏掉可见物体的概率</translation>
    </message>
    <message>
        <source>Swaps</source>
        <translation>互换</translation>
    </message>
    <message>
        <source>Probability per detection of exchanging the ids of two people who are close</source>
        <translation>每次检测互换两个相近行人 id 的概率</translation>
    </message>
    <message>
        <source>Swap distance</source>
        <translation>互换距离</translation>
    </message>
    <message>
        <source>Distance below which the ids of two people may be exchanged</source>
        <translation>低于此距离时两个行人的 id 可能互换</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>遮挡</translation>
    </message>
    <message>
        <source>Walls and other bodies occlude</source>
        <translation>墙和其他物体会造成遮挡</translation>
    </message>
    <message>
        <source>Hidden share</source>
        <translation>遮挡比例</translation>
    </message>
    <message>
        <source>A body of which others occlude more than this share is not detected</source>
        <translation>被遮挡超过此比例的物体不会被检测到</translation>
    </message>
    <message>
        <source>Coast time</source>
        <translation>滑行时间</translation>
    </message>
    <message>
        <source>A track without detection is deleted after this time; until then it is extrapolated with constant velocity</source>
        <translation>没有检测的轨迹在此时间后删除；在此之前以恒定速度外推</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Measured, or estimated from positions by a Kalman filter; absent: `filtered` with `noise`, otherwise `measured`</source>
        <translation>测量值，或用卡尔曼滤波器由位置估计；缺省：有 `noise` 时为 `filtered`，否则为 `measured`</translation>
    </message>
    <message>
        <source>Acceleration noise</source>
        <translation>加速度噪声</translation>
    </message>
    <message>
        <source>Kalman filter: power of the acceleration noise of people</source>
        <translation>卡尔曼滤波器：行人加速度噪声的功率</translation>
    </message>
    <message>
        <source>Alpha1</source>
        <translation>Alpha1</translation>
    </message>
    <message>
        <source>Variance of the heading caused by rotation</source>
        <translation>由旋转引起的朝向方差</translation>
    </message>
    <message>
        <source>Alpha2</source>
        <translation>Alpha2</translation>
    </message>
    <message>
        <source>Variance of the heading caused by translation</source>
        <translation>由平移引起的朝向方差</translation>
    </message>
    <message>
        <source>Alpha3</source>
        <translation>Alpha3</translation>
    </message>
    <message>
        <source>Variance of the distance caused by translation</source>
        <translation>由平移引起的距离方差</translation>
    </message>
    <message>
        <source>Alpha4</source>
        <translation>Alpha4</translation>
    </message>
    <message>
        <source>Variance of the distance caused by rotation</source>
        <translation>由旋转引起的距离方差</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Rotation per metre driven forward that odometry does not measure</source>
        <translation>每前进一米里程计未测到的旋转</translation>
    </message>
    <message>
        <source>Std x</source>
        <translation>x 标准差</translation>
    </message>
    <message>
        <source>Standard deviation of the error in x, in the map</source>
        <translation>地图中 x 误差的标准差</translation>
    </message>
    <message>
        <source>Std y</source>
        <translation>y 标准差</translation>
    </message>
    <message>
        <source>Standard deviation of the error in y, in the map</source>
        <translation>地图中 y 误差的标准差</translation>
    </message>
    <message>
        <source>Std yaw</source>
        <translation>朝向标准差</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the heading</source>
        <translation>朝向误差的标准差</translation>
    </message>
    <message>
        <source>Correlation time</source>
        <translation>相关时间</translation>
    </message>
    <message>
        <source>Time constant of the errors; 0: corrections are independent</source>
        <translation>误差的时间常数；0：各次修正相互独立</translation>
    </message>
    <message>
        <source>Jump rate</source>
        <translation>跳变率</translation>
    </message>
    <message>
        <source>Mean number of jumps of the estimate per second</source>
        <translation>估计值每秒跳变的平均次数</translation>
    </message>
    <message>
        <source>Jump distance</source>
        <translation>跳变距离</translation>
    </message>
    <message>
        <source>Length of a jump</source>
        <translation>一次跳变的长度</translation>
    </message>
    <message>
        <source>Jump yaw</source>
        <translation>跳变角度</translation>
    </message>
    <message>
        <source>Rotation of a jump, in either direction</source>
        <translation>一次跳变的旋转，任意方向</translation>
    </message>
    <message>
        <source>Corrections of map -&gt; odom per second; 0: only the first one; absent: 2 with an error, otherwise 0</source>
        <translation>map -&gt; odom 每秒修正次数；0：仅第一次；缺省：有误差时为 2，否则为 0</translation>
    </message>
    <message>
        <source>Start x</source>
        <translation>起点 x</translation>
    </message>
    <message>
        <source>Error of the initial pose: x</source>
        <translation>初始位姿误差：x</translation>
    </message>
    <message>
        <source>Start y</source>
        <translation>起点 y</translation>
    </message>
    <message>
        <source>Error of the initial pose: y</source>
        <translation>初始位姿误差：y</translation>
    </message>
    <message>
        <source>Start yaw</source>
        <translation>起点朝向</translation>
    </message>
    <message>
        <source>Error of the initial pose: heading</source>
        <translation>初始位姿误差：朝向</translation>
    </message>
    <message>
        <source>Initial pose time</source>
        <translation>初始位姿时间</translation>
    </message>
    <message>
        <source>Time of the initial pose; there is no frame map before</source>
        <translation>初始位姿的时间；在此之前没有 map 坐标系</translation>
    </message>
    <message>
        <source>Global std</source>
        <translation>全局标准差</translation>
    </message>
    <message>
        <source>Standard deviation of x and y after a global localization</source>
        <translation>全局定位后 x 和 y 的标准差</translation>
    </message>
    <message>
        <source>Global std yaw</source>
        <translation>全局朝向标准差</translation>
    </message>
    <message>
        <source>Standard deviation of the heading after a global localization</source>
        <translation>全局定位后朝向的标准差</translation>
    </message>
    <message>
        <source>Capacity</source>
        <translation>容量</translation>
    </message>
    <message>
        <source>Stored energy when full; absent: the battery never runs low</source>
        <translation>充满时存储的能量；缺省：电量永不耗尽</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电量</translation>
    </message>
    <message>
        <source>State of charge at the start</source>
        <translation>起始时的荷电状态</translation>
    </message>
    <message>
        <source>Idle power</source>
        <translation>待机功率</translation>
    </message>
    <message>
        <source>Power consumption at standstill</source>
        <translation>静止时的功耗</translation>
    </message>
    <message>
        <source>Motion power</source>
        <translation>运动功率</translation>
    </message>
    <message>
        <source>Additional power consumption at top speed or top turn rate; proportional below</source>
        <translation>最大速度或最大转向速度时的附加功耗；低于此按比例计算</translation>
    </message>
    <message>
        <source>Charge power</source>
        <translation>充电功率</translation>
    </message>
    <message>
        <source>Charging power at a charging dock</source>
        <translation>在充电桩充电的功率</translation>
    </message>
    <message>
        <source>Empty voltage</source>
        <translation>空电电压</translation>
    </message>
    <message>
        <source>Voltage of the empty battery</source>
        <translation>电池耗尽时的电压</translation>
    </message>
    <message>
        <source>Full voltage</source>
        <translation>满电电压</translation>
    </message>
    <message>
        <source>Voltage of the full battery; linear in between</source>
        <translation>电池充满时的电压；其间为线性</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Shape; each shape uses some of the other keys</source>
        <translation>形状；每种形状使用部分其他键</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Direction of `length`</source>
        <translation>`length` 的方向</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Size along the heading</source>
        <translation>沿朝向的尺寸</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Size across the heading</source>
        <translation>垂直于朝向的尺寸</translation>
    </message>
    <message>
        <source>Radius of the circle</source>
        <translation>圆的半径</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>X coordinates of the corners</source>
        <translation>顶点的 X 坐标</translation>
    </message>
    <message>
        <source>Ys</source>
        <translation>Ys</translation>
    </message>
    <message>
        <source>Y coordinates of the corners, as many as `xs`</source>
        <translation>顶点的 Y 坐标，数量与 `xs` 相同</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>From X</source>
        <translation>起点 X</translation>
    </message>
    <message>
        <source>First end</source>
        <translation>第一端</translation>
    </message>
    <message>
        <source>From Y</source>
        <translation>起点 Y</translation>
    </message>
    <message>
        <source>To X</source>
        <translation>终点 X</translation>
    </message>
    <message>
        <source>Second end</source>
        <translation>第二端</translation>
    </message>
    <message>
        <source>To Y</source>
        <translation>终点 Y</translation>
    </message>
    <message>
        <source>Open at start</source>
        <translation>起始时打开</translation>
    </message>
    <message>
        <source>Whether the door is open at the start</source>
        <translation>门在起始时是否打开</translation>
    </message>
    <message>
        <source>Toggles at</source>
        <translation>切换时间</translation>
    </message>
    <message>
        <source>Times at which the door opens or closes</source>
        <translation>门打开或关闭的时间</translation>
    </message>
    <message>
        <source>Purpose of the area</source>
        <translation>区域的用途</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Source: the person that is copied</source>
        <translation>源：被复制的行人</translation>
    </message>
    <message>
        <source>Source: people per second</source>
        <translation>源：每秒行人数</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Source: people are spawned from this time on</source>
        <translation>源：从此时间起生成行人</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Source: no people are spawned after this time; absent: never ends</source>
        <translation>源：此时间之后不再生成行人；缺省：不结束</translation>
    </message>
    <message>
        <source>Max. people</source>
        <translation>最多人数</translation>
    </message>
    <message>
        <source>Source: maximum number of people; absent: no limit</source>
        <translation>源：最大行人数；缺省：不限</translation>
    </message>
    <message>
        <source>Speed factor</source>
        <translation>速度系数</translation>
    </message>
    <message>
        <source>Speed: factor of the walking speed of people inside</source>
        <translation>速度：区域内行人行走速度的系数</translation>
    </message>
    <message>
        <source>Carrying speed</source>
        <translation>运载速度</translation>
    </message>
    <message>
        <source>Speed: speed with which people inside are carried, as by a travelator</source>
        <translation>速度：运载区域内行人的速度，如自动步道</translation>
    </message>
    <message>
        <source>Carrying direction</source>
        <translation>运载方向</translation>
    </message>
    <message>
        <source>Speed: direction in which people inside are carried</source>
        <translation>速度：运载行人的方向</translation>
    </message>
    <message>
        <source>Whether the dock charges robots</source>
        <translation>充电桩是否为机器人充电</translation>
    </message>
    <message>
        <source>Centre of a docked robot</source>
        <translation>停靠机器人的中心</translation>
    </message>
    <message>
        <source>Heading of a robot that docks forward</source>
        <translation>向前停靠的机器人的朝向</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>卡片</translation>
    </message>
    <message>
        <source>Description of the scenario: what it tests, with its source</source>
        <translation>场景说明：测试内容及其来源</translation>
    </message>
    <message>
        <source>Map file</source>
        <translation>地图文件</translation>
    </message>
    <message>
        <source>Map file, relative to the scenario; `none`: open plane; absent: the file of `map` is searched</source>
        <translation>地图文件，相对于场景；`none`：开阔平面；缺省：查找 `map` 的文件</translation>
    </message>
    <message>
        <source>Map rule</source>
        <translation>地图规则</translation>
    </message>
    <message>
        <source>Nav2 branch whose rule for grey pixels is used</source>
        <translation>使用其灰色像素规则的 Nav2 分支</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Random seed; the same seed reproduces the run</source>
        <translation>随机种子；相同的种子可重现运行</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Time limit; absent: the run ends 1 s after the robot has arrived, at most 120 s; 60 s without a robot that has a goal</source>
        <translation>时间限制；缺省：机器人到达 1 s 后结束运行，最多 120 s；没有带目标的机器人时为 60 s</translation>
    </message>
    <message>
        <source>End on contact</source>
        <translation>接触时结束</translation>
    </message>
    <message>
        <source>Contacts of a robot on its route that end the run; `any`: with people, robots or walls</source>
        <translation>机器人在路线上结束运行的接触；`any`：与行人、机器人或墙</translation>
    </message>
    <message>
        <source>Stuck after</source>
        <translation>被困判定</translation>
    </message>
    <message>
        <source>A robot is stuck if it makes no progress for this long; the run ends if no other robot makes progress; 0: never</source>
        <translation>机器人在此时间内无进展即视为被困；若其他机器人也无进展则结束运行；0：从不</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>时间步</translation>
    </message>
    <message>
        <source>Record every</source>
        <translation>记录间隔</translation>
    </message>
    <message>
        <source>Time steps from one recorded sample to the next</source>
        <translation>两次记录的样本之间的时间步数</translation>
    </message>
    <message>
        <source>Pedestrian model, see `list models`</source>
        <translation>行人模型，见 `list models`</translation>
    </message>
    <message>
        <source>Model parameters</source>
        <translation>模型参数</translation>
    </message>
    <message>
        <source>Parameters of models, below the name of each, see `list models --format json`</source>
        <translation>各模型的参数，位于其名称之下，见 `list models --format json`</translation>
    </message>
    <message>
        <source>Paths planned around walls, or straight lines as in HuNavSim</source>
        <translation>绕墙规划的路径，或与 HuNavSim 相同的直线</translation>
    </message>
    <message>
        <source>Wall force from</source>
        <translation>墙力来源</translation>
    </message>
    <message>
        <source>Wall forces from the nearest points of walls, or from the hits of rays as of a lidar</source>
        <translation>由墙的最近点或类似激光雷达的射线命中点计算墙力</translation>
    </message>
    <message>
        <source>Loop trees</source>
        <translation>循环树</translation>
    </message>
    <message>
        <source>Restart a tree that has ended</source>
        <translation>重新开始已结束的树</translation>
    </message>
    <message>
        <source>Corridor</source>
        <translation>走廊</translation>
    </message>
    <message>
        <source>Periodic corridor: people who pass the second x re-enter at the first</source>
        <translation>周期性走廊：越过第二个 x 的行人从第一个 x 重新进入</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>群组</translation>
    </message>
    <message>
        <source>Names of groups by their numbers</source>
        <translation>按编号的群组名称</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Variation of people between seeds</source>
        <translation>行人在种子间的变化</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Name of the scenario in lists</source>
        <translation>场景在列表中的名称</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Group of scenarios that it belongs to</source>
        <translation>所属的场景组</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>目的</translation>
    </message>
    <message>
        <source>What the scenario tests</source>
        <translation>场景测试的内容</translation>
    </message>
    <message>
        <source>Task of the robot</source>
        <translation>机器人任务</translation>
    </message>
    <message>
        <source>What the robot has to do</source>
        <translation>机器人需要做什么</translation>
    </message>
    <message>
        <source>What people do</source>
        <translation>行人行为</translation>
    </message>
    <message>
        <source>Expected outcome</source>
        <translation>预期结果</translation>
    </message>
    <message>
        <source>What is expected of a good robot</source>
        <translation>对优秀机器人的期望</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Keys of the metrics to read, see `list metrics`; the first one compares planners</source>
        <translation>要查看的指标的键，见 `list metrics`；第一个用于比较规划器</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>难度</translation>
    </message>
    <message>
        <source>Difficulty for the robot</source>
        <translation>对机器人的难度</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Publication or standard that the scenario is taken from</source>
        <translation>所依据的出版物或标准</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>许可证</translation>
    </message>
    <message>
        <source>Licence of the scenario and its map</source>
        <translation>场景及其地图的许可证</translation>
    </message>
    <message>
        <source>Expected events</source>
        <translation>预期事件</translation>
    </message>
    <message>
        <source>What happens in a run without robots, see below; `check --certify` tests it</source>
        <translation>没有机器人的运行中发生的事件，见下文；`check --certify` 对其检验</translation>
    </message>
    <message>
        <source>Amount of variation of people between seeds; keys of a quantity take precedence</source>
        <translation>行人在种子间的变化程度；各量的键优先</translation>
    </message>
    <message>
        <source>Start time: kind</source>
        <translation>出发时间：类型</translation>
    </message>
    <message>
        <source>Added to the start time; absent: that of the preset</source>
        <translation>加到出发时间上；缺省：预设的值</translation>
    </message>
    <message>
        <source>Start time: deviation</source>
        <translation>出发时间：标准差</translation>
    </message>
    <message>
        <source>Normal: standard deviation</source>
        <translation>正态：标准差</translation>
    </message>
    <message>
        <source>Start time: half width</source>
        <translation>出发时间：半宽</translation>
    </message>
    <message>
        <source>Uniform: half of the width</source>
        <translation>均匀：宽度的一半</translation>
    </message>
    <message>
        <source>Start time: minimum</source>
        <translation>出发时间：最小值</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Start time: maximum</source>
        <translation>出发时间：最大值</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Start: kind</source>
        <translation>起点：类型</translation>
    </message>
    <message>
        <source>Added to x and y of the start; absent: that of the preset</source>
        <translation>加到起点的 x 和 y 上；缺省：预设的值</translation>
    </message>
    <message>
        <source>Start: deviation</source>
        <translation>起点：标准差</translation>
    </message>
    <message>
        <source>Start: half width</source>
        <translation>起点：半宽</translation>
    </message>
    <message>
        <source>Start: minimum</source>
        <translation>起点：最小值</translation>
    </message>
    <message>
        <source>Start: maximum</source>
        <translation>起点：最大值</translation>
    </message>
    <message>
        <source>Heading: kind</source>
        <translation>朝向：类型</translation>
    </message>
    <message>
        <source>Added to the heading at the start; absent: that of the preset</source>
        <translation>加到起始朝向上；缺省：预设的值</translation>
    </message>
    <message>
        <source>Heading: deviation</source>
        <translation>朝向：标准差</translation>
    </message>
    <message>
        <source>Heading: half width</source>
        <translation>朝向：半宽</translation>
    </message>
    <message>
        <source>Heading: minimum</source>
        <translation>朝向：最小值</translation>
    </message>
    <message>
        <source>Heading: maximum</source>
        <translation>朝向：最大值</translation>
    </message>
    <message>
        <source>Speed: kind</source>
        <translation>速度：类型</translation>
    </message>
    <message>
        <source>Factor of max_vel; absent: that of the preset</source>
        <translation>max_vel 的系数；缺省：预设的值</translation>
    </message>
    <message>
        <source>Speed: deviation</source>
        <translation>速度：标准差</translation>
    </message>
    <message>
        <source>Speed: half width</source>
        <translation>速度：半宽</translation>
    </message>
    <message>
        <source>Speed: minimum</source>
        <translation>速度：最小值</translation>
    </message>
    <message>
        <source>Speed: maximum</source>
        <translation>速度：最大值</translation>
    </message>
    <message>
        <source>Reaction time: kind</source>
        <translation>反应时间：类型</translation>
    </message>
    <message>
        <source>Factor of the reaction time; absent: that of the preset</source>
        <translation>反应时间的系数；缺省：预设的值</translation>
    </message>
    <message>
        <source>Reaction time: deviation</source>
        <translation>反应时间：标准差</translation>
    </message>
    <message>
        <source>Reaction time: half width</source>
        <translation>反应时间：半宽</translation>
    </message>
    <message>
        <source>Reaction time: minimum</source>
        <translation>反应时间：最小值</translation>
    </message>
    <message>
        <source>Reaction time: maximum</source>
        <translation>反应时间：最大值</translation>
    </message>
    <message>
        <source>First goal: kind</source>
        <translation>首个目标点：类型</translation>
    </message>
    <message>
        <source>Number of goals of a repeated route that are skipped at first; absent: that of the preset</source>
        <translation>重复路线起初跳过的目标点数；缺省：预设的值</translation>
    </message>
    <message>
        <source>First goal: deviation</source>
        <translation>首个目标点：标准差</translation>
    </message>
    <message>
        <source>First goal: half width</source>
        <translation>首个目标点：半宽</translation>
    </message>
    <message>
        <source>First goal: minimum</source>
        <translation>首个目标点：最小值</translation>
    </message>
    <message>
        <source>First goal: maximum</source>
        <translation>首个目标点：最大值</translation>
    </message>
    <message>
        <source>Start of the measurement: begin, goal, motion, time 5.0 or event contact</source>
        <translation>测量的开始：begin、goal、motion、time 5.0 或 event contact</translation>
    </message>
    <message>
        <source>End of the measurement: end, arrival, time 20.0 or event contact</source>
        <translation>测量的结束：end、arrival、time 20.0 或 event contact</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Sampling rate; 0: every recorded sample</source>
        <translation>采样率；0：每个记录的样本</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Name of the experiment in the results</source>
        <translation>结果中的实验名称</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>运行编号</translation>
    </message>
    <message>
        <source>Number of the run in the results</source>
        <translation>结果中的运行编号</translation>
    </message>
    <message>
        <source>Metrics file</source>
        <translation>指标文件</translation>
    </message>
    <message>
        <source>File that selects the metrics, relative to the scenario; absent: all metrics</source>
        <translation>选择指标的文件，相对于场景；缺省：所有指标</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Thresholds of metrics: name and value of each</source>
        <translation>指标的阈值：各阈值的名称和值</translation>
    </message>
    <message>
        <source>Dynamic window approach (Fox, Burgard &amp; Thrun 1997): scores the arcs that the robot can drive next.</source>
        <translation>动态窗口法（Fox、Burgard 和 Thrun 1997）：对机器人接下来可行驶的圆弧评分。</translation>
    </message>
    <message>
        <source>Linear samples</source>
        <translation>线速度样本</translation>
    </message>
    <message>
        <source>Sampled speeds; omnidirectional: the total number of samples is distributed evenly.</source>
        <translation>采样的速度数；全向：样本总数均匀分配。</translation>
    </message>
    <message>
        <source>Angular samples</source>
        <translation>角速度样本</translation>
    </message>
    <message>
        <source>Sampled turn rates for each speed.</source>
        <translation>每个速度采样的转向速度数。</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Time within which a sampled velocity must be reachable.</source>
        <translation>采样速度必须在此时间内可达。</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>时域</translation>
    </message>
    <message>
        <source>Time for which arcs are simulated; longer if braking takes longer.</source>
        <translation>模拟圆弧的时间；若制动时间更长则更长。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Time between two checks along an arc.</source>
        <translation>沿圆弧两次检查之间的时间。</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Minimum distance to walls and people.</source>
        <translation>与墙和行人的最小距离。</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Clearance above which more clearance does not improve the score of an arc.</source>
        <translation>超过此间隙后，更大的间隙不再提高圆弧的评分。</translation>
    </message>
    <message>
        <source>Goal weight</source>
        <translation>目标权重</translation>
    </message>
    <message>
        <source>Weight of the remaining path length at the end of an arc.</source>
        <translation>圆弧末端剩余路径长度的权重。</translation>
    </message>
    <message>
        <source>Heading weight</source>
        <translation>朝向权重</translation>
    </message>
    <message>
        <source>Weight of the remaining rotation at the position where the robot would stop if it braked.</source>
        <translation>机器人制动停下位置处剩余旋转的权重。</translation>
    </message>
    <message>
        <source>Clearance weight</source>
        <translation>间隙权重</translation>
    </message>
    <message>
        <source>Weight of missing clearance along an arc.</source>
        <translation>沿圆弧缺少的间隙的权重。</translation>
    </message>
    <message>
        <source>Velocity weight</source>
        <translation>速度权重</translation>
    </message>
    <message>
        <source>Weight of the difference to the maximum speed.</source>
        <translation>与最大速度之差的权重。</translation>
    </message>
    <message>
        <source>Smoothness weight</source>
        <translation>平滑权重</translation>
    </message>
    <message>
        <source>Weight of the difference from the last command.</source>
        <translation>与上一条指令之差的权重。</translation>
    </message>
    <message>
        <source>Slow distance</source>
        <translation>减速距离</translation>
    </message>
    <message>
        <source>Gap to a person ahead below which the robot slows down.</source>
        <translation>与前方行人的间距低于此值时机器人减速。</translation>
    </message>
    <message>
        <source>Slow share</source>
        <translation>慢速比例</translation>
    </message>
    <message>
        <source>Share of the maximum speed close to a person.</source>
        <translation>靠近行人时占最大速度的比例。</translation>
    </message>
    <message>
        <source>Standing speed</source>
        <translation>站立速度</translation>
    </message>
    <message>
        <source>People below this speed count as standing: the path leads around them.</source>
        <translation>低于此速度的行人视为站立：路径会绕过他们。</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>耐心</translation>
    </message>
    <message>
        <source>Time without progress after which the robot backs off and tries again.</source>
        <translation>无进展超过此时间后机器人后退并重试。</translation>
    </message>
    <message>
        <source>Reverse distance</source>
        <translation>后退距离</translation>
    </message>
    <message>
        <source>Distance that it backs off.</source>
        <translation>后退的距离。</translation>
    </message>
    <message>
        <source>An external planner: a program that is called in every time step.</source>
        <translation>外部规划器：每个时间步调用的程序。</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>Maximum response time of the program in the robot&apos;s `command`.</source>
        <translation>机器人 `command` 中程序的最长响应时间。</translation>
    </message>
    <message>
        <source>An external planner in a shared library.</source>
        <translation>共享库中的外部规划器。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Shared library of the planner (hunavsim_planner.h), relative to the scenario; needs permission to run code.</source>
        <translation>规划器的共享库（hunavsim_planner.h），相对于场景；需要运行代码的许可。</translation>
    </message>
    <message>
        <source>Model predictive path integral control (Williams et al. 2017): the weighted mean of many noisy trajectories.</source>
        <translation>模型预测路径积分控制（Williams 等 2017）：大量带噪声轨迹的加权平均。</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本数</translation>
    </message>
    <message>
        <source>Trajectories sampled in each cycle, rounded up to a multiple of 16.</source>
        <translation>每个周期采样的轨迹数，向上取整为 16 的倍数。</translation>
    </message>
    <message>
        <source>Time steps</source>
        <translation>时间步</translation>
    </message>
    <message>
        <source>Time steps of each trajectory.</source>
        <translation>每条轨迹的时间步数。</translation>
    </message>
    <message>
        <source>Model dt</source>
        <translation>模型 dt</translation>
    </message>
    <message>
        <source>Duration of a time step of the trajectories.</source>
        <translation>轨迹一个时间步的时长。</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>lambda: cost difference that changes the weight of a trajectory by the factor e.</source>
        <translation>lambda：使轨迹权重改变 e 倍的代价差。</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Weight of the control cost: lambda (1 - alpha).</source>
        <translation>控制代价的权重：lambda (1 - alpha)。</translation>
    </message>
    <message>
        <source>Linear noise</source>
        <translation>线速度噪声</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the forward speed.</source>
        <translation>前进速度噪声的标准差。</translation>
    </message>
    <message>
        <source>Angular noise</source>
        <translation>角速度噪声</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the turn rate.</source>
        <translation>转向速度噪声的标准差。</translation>
    </message>
    <message>
        <source>Lateral noise</source>
        <translation>横向噪声</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the lateral speed (omnidirectional).</source>
        <translation>横向速度噪声的标准差（全向）。</translation>
    </message>
    <message>
        <source>Noise time</source>
        <translation>噪声时间</translation>
    </message>
    <message>
        <source>Time in which the autocorrelation of the noise decays to 1/e; 0: white noise, as in Nav2.</source>
        <translation>噪声自相关衰减到 1/e 的时间；0：白噪声，与 Nav2 相同。</translation>
    </message>
    <message>
        <source>Cost of the mean remaining distance, around walls.</source>
        <translation>绕墙的平均剩余距离的代价。</translation>
    </message>
    <message>
        <source>End weight</source>
        <translation>末端权重</translation>
    </message>
    <message>
        <source>Cost of the remaining distance at the end of a trajectory.</source>
        <translation>轨迹末端剩余距离的代价。</translation>
    </message>
    <message>
        <source>Cost of a heading away from the path to the goal (not for omnidirectional robots).</source>
        <translation>朝向偏离通往目标路径的代价（全向机器人除外）。</translation>
    </message>
    <message>
        <source>Reverse weight</source>
        <translation>倒车权重</translation>
    </message>
    <message>
        <source>Cost of the mean reverse speed (not for omnidirectional robots).</source>
        <translation>平均倒车速度的代价（全向机器人除外）。</translation>
    </message>
    <message>
        <source>Stop weight</source>
        <translation>停车权重</translation>
    </message>
    <message>
        <source>Cost of the squared speed inside the goal region.</source>
        <translation>目标区域内速度平方的代价。</translation>
    </message>
    <message>
        <source>Wall weight</source>
        <translation>墙权重</translation>
    </message>
    <message>
        <source>Cost of contact with a wall, decreasing quadratically to 0 at wall_range.</source>
        <translation>与墙接触的代价，在 wall_range 处按二次方降至 0。</translation>
    </message>
    <message>
        <source>Wall range</source>
        <translation>墙范围</translation>
    </message>
    <message>
        <source>Gap to walls beyond which the cost is 0.</source>
        <translation>与墙的间距达到此值时代价为 0。</translation>
    </message>
    <message>
        <source>Person weight</source>
        <translation>行人权重</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing to 0 at person_range.</source>
        <translation>与行人接触的代价，在 person_range 处降至 0。</translation>
    </message>
    <message>
        <source>Person range</source>
        <translation>行人范围</translation>
    </message>
    <message>
        <source>Gap to a person beyond which the cost is 0.</source>
        <translation>与行人的间距达到此值时代价为 0。</translation>
    </message>
    <message>
        <source>Person margin</source>
        <translation>行人余量</translation>
    </message>
    <message>
        <source>A smaller gap to a person counts as a contact.</source>
        <translation>与行人的间距更小时视为接触。</translation>
    </message>
    <message>
        <source>Contact weight</source>
        <translation>接触权重</translation>
    </message>
    <message>
        <source>Cost of contact with a person or an obstacle along the whole trajectory.</source>
        <translation>整条轨迹上与行人或障碍物接触的代价。</translation>
    </message>
    <message>
        <source>Cost of accelerating at the limits of the drive along the whole trajectory.</source>
        <translation>始终以驱动极限改变速度的代价。</translation>
    </message>
    <message>
        <source>Learned policy in an ONNX file, computed on the CPU by OpenCV.</source>
        <translation>ONNX 文件中的学习策略，由 OpenCV 在 CPU 上计算。</translation>
    </message>
    <message>
        <source>ONNX file of a policy that was trained with hunavsim.env, with its options as metadata; relative to the scenario.</source>
        <translation>用 hunavsim.env 训练的策略的 ONNX 文件，其元数据包含环境选项；相对于场景的路径。</translation>
    </message>
    <message>
        <source>Optimal reciprocal collision avoidance (ORCA) for the kinematics of the robot (NH-ORCA).</source>
        <translation>适用于机器人运动学的最优互惠避碰 (ORCA)（NH-ORCA）。</translation>
    </message>
    <message>
        <source>tau: time for which the selected velocity is free of collisions with people and robots.</source>
        <translation>tau：所选速度与行人和机器人无碰撞的时间。</translation>
    </message>
    <message>
        <source>Wall horizon</source>
        <translation>墙时域</translation>
    </message>
    <message>
        <source>Time for which the selected velocity is free of collisions with walls.</source>
        <translation>所选速度与墙无碰撞的时间。</translation>
    </message>
    <message>
        <source>Tracking error</source>
        <translation>跟踪误差</translation>
    </message>
    <message>
        <source>epsilon: maximum distance of the robot from the position that results from the selected velocity; less beside people and walls. Its radius is enlarged by this. Not for omnidirectional robots.</source>
        <translation>epsilon：机器人与所选速度对应位置的最大距离；在行人和墙附近更小。其半径相应增大。全向机器人除外。</translation>
    </message>
    <message>
        <source>Turn time</source>
        <translation>转向时间</translation>
    </message>
    <message>
        <source>T: time in which the robot turns into the direction of the selected velocity, unless its angular acceleration takes longer.</source>
        <translation>T：机器人转到所选速度方向的时间，除非其角加速度需要更长时间。</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>份额</translation>
    </message>
    <message>
        <source>Share of the avoidance of a person that the robot takes: 0.5: people take the other half, 1: people do not avoid.</source>
        <translation>机器人承担的避让份额：0.5：行人承担另一半，1：行人不避让。</translation>
    </message>
    <message>
        <source>Robot share</source>
        <translation>机器人份额</translation>
    </message>
    <message>
        <source>Share of the avoidance of another robot that the robot takes.</source>
        <translation>机器人承担的对另一机器人的避让份额。</translation>
    </message>
    <message>
        <source>Distance to people and robots in addition to both radii.</source>
        <translation>除两者半径之外与行人和机器人的距离。</translation>
    </message>
    <message>
        <source>People and robots farther away are ignored.</source>
        <translation>忽略更远的行人和机器人。</translation>
    </message>
    <message>
        <source>Lookahead</source>
        <translation>前视距离</translation>
    </message>
    <message>
        <source>Distance along the route to the target point; at least 1.5 turning radii.</source>
        <translation>沿路线到目标位置的距离；至少为 1.5 倍转弯半径。</translation>
    </message>
    <message>
        <source>Side preference</source>
        <translation>侧向偏好</translation>
    </message>
    <message>
        <source>Rotation of the desired velocity to the right if people are in its way.</source>
        <translation>有行人挡路时期望速度向右的旋转。</translation>
    </message>
    <message>
        <source>Pure pursuit of the route (Coulter 1992); slows down for people ahead.</source>
        <translation>路线的纯追踪 (Coulter 1992)；前方有行人时减速。</translation>
    </message>
    <message>
        <source>Distance along the path to the target point.</source>
        <translation>沿路径到目标位置的距离。</translation>
    </message>
    <message>
        <source>Stop distance</source>
        <translation>停止距离</translation>
    </message>
    <message>
        <source>Gap to a person ahead at which the robot stops.</source>
        <translation>与前方行人的间距达到此值时机器人停下。</translation>
    </message>
    <message>
        <source>Replays recorded velocities and ignores obstacles.</source>
        <translation>重放录制的速度并忽略障碍物。</translation>
    </message>
    <message>
        <source>CSV with time,linear,angular and optionally lateral, or the trajectory.csv of a run; relative to the scenario.</source>
        <translation>包含 time,linear,angular（可选 lateral）的 CSV，或某次运行的 trajectory.csv；相对于场景。</translation>
    </message>
    <message>
        <source>Id of the robot whose velocities are read from a trajectory.csv.</source>
        <translation>从 trajectory.csv 读取其速度的机器人的 id。</translation>
    </message>
    <message>
        <source>Moves like a person of the social force model.</source>
        <translation>像社会力模型的行人一样移动。</translation>
    </message>
    <message>
        <source>Goal factor</source>
        <translation>目标系数</translation>
    </message>
    <message>
        <source>k_g: weight of the attractive force along the route.</source>
        <translation>k_g：沿路线吸引力的权重。</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>弛豫时间</translation>
    </message>
    <message>
        <source>tau: relaxation time of the velocity towards the desired one.</source>
        <translation>tau：速度趋于期望速度的弛豫时间。</translation>
    </message>
    <message>
        <source>Obstacle factor</source>
        <translation>障碍物系数</translation>
    </message>
    <message>
        <source>k_o: force of a wall in contact with the robot. It turns the robot aside, never back.</source>
        <translation>k_o：与机器人接触的墙的力。它使机器人转向侧面，从不后退。</translation>
    </message>
    <message>
        <source>Obstacle range</source>
        <translation>障碍物范围</translation>
    </message>
    <message>
        <source>sigma: distance over which the force of walls decays to 1/e.</source>
        <translation>sigma：墙力衰减到 1/e 的距离。</translation>
    </message>
    <message>
        <source>Social factor</source>
        <translation>社会系数</translation>
    </message>
    <message>
        <source>k_s: weight of the forces of people and robots.</source>
        <translation>k_s：行人和机器人的力的权重。</translation>
    </message>
    <message>
        <source>Lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Weight of the relative velocity in the direction of an interaction.</source>
        <translation>相互作用方向上相对速度的权重。</translation>
    </message>
    <message>
        <source>Range of an interaction per length of the interaction vector.</source>
        <translation>每单位相互作用矢量长度的作用范围。</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Angular width of the evasion term.</source>
        <translation>回避项的角宽度。</translation>
    </message>
    <message>
        <source>N prime</source>
        <translation>N&apos;</translation>
    </message>
    <message>
        <source>Angular width of the deceleration term.</source>
        <translation>减速项的角宽度。</translation>
    </message>
    <message>
        <source>Epsilon</source>
        <translation>Epsilon</translation>
    </message>
    <message>
        <source>Bias to one side for people who meet head-on.</source>
        <translation>迎面相遇的行人向一侧的偏置。</translation>
    </message>
    <message>
        <source>Desired speed</source>
        <translation>期望速度</translation>
    </message>
    <message>
        <source>v_0: desired speed, limited by the drive.</source>
        <translation>v_0：期望速度，受驱动限制。</translation>
    </message>
    <message>
        <source>T: time in which the robot turns into the direction of the desired velocity, unless its angular acceleration takes longer.</source>
        <translation>T：机器人转到期望速度方向的时间，除非其角加速度需要更长时间。</translation>
    </message>
    <message>
        <source>Gap to a person below which the robot does not approach.</source>
        <translation>与行人的间距低于此值时机器人不再靠近。</translation>
    </message>
    <message>
        <source>Slow time</source>
        <translation>减速时间</translation>
    </message>
    <message>
        <source>The approach speed to a person is at most the gap beyond the stop distance divided by this time.</source>
        <translation>接近行人的速度最多为超出停止距离的间距除以此时间。</translation>
    </message>
    <message>
        <source>Distance along the route to the attracting point; at least 1.5 turning radii.</source>
        <translation>沿路线到吸引点的距离；至少为 1.5 倍转弯半径。</translation>
    </message>
    <message>
        <source>MPPI that predicts people, yields to them and avoids groups.</source>
        <translation>预测行人、礼让行人并避开群组的 MPPI。</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Prediction of people: 0: constant velocity, 1: social force model with walls and the robot&apos;s plan.</source>
        <translation>行人预测：0：恒定速度，1：包含墙和机器人规划的社会力模型。</translation>
    </message>
    <message>
        <source>Intimate weight</source>
        <translation>亲密权重</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing linearly to 0 at a gap of 0.45 m.</source>
        <translation>与行人接触的代价，在间距 0.45 m 处线性降至 0。</translation>
    </message>
    <message>
        <source>Personal weight</source>
        <translation>个人权重</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing quadratically to 0 at a gap of 1.2 m.</source>
        <translation>与行人接触的代价，在间距 1.2 m 处按二次方降至 0。</translation>
    </message>
    <message>
        <source>Space weight</source>
        <translation>空间权重</translation>
    </message>
    <message>
        <source>Cost at the centre of the personal space: a Gaussian that is longer in front of walking people.</source>
        <translation>个人空间中心的代价：在行走的行人前方更长的高斯函数。</translation>
    </message>
    <message>
        <source>Group weight</source>
        <translation>群组权重</translation>
    </message>
    <message>
        <source>Cost at the centre of the space shared by two people who stand face to face.</source>
        <translation>面对面站立的两人共享空间中心的代价。</translation>
    </message>
    <message>
        <source>Ttc weight</source>
        <translation>TTC 权重</translation>
    </message>
    <message>
        <source>Cost of approaching a person nearby, with the square of ttc_limit / time - 1.</source>
        <translation>接近附近行人的代价，为 ttc_limit / 时间 - 1 的平方。</translation>
    </message>
    <message>
        <source>Ttc limit</source>
        <translation>TTC 限值</translation>
    </message>
    <message>
        <source>Time to collision at the current closing speed above which the cost is 0.</source>
        <translation>以当前接近速度计算的碰撞时间超过此值时代价为 0。</translation>
    </message>
    <message>
        <source>Relative speed weight</source>
        <translation>相对速度权重</translation>
    </message>
    <message>
        <source>Cost of the squared relative speed beside a person, decreasing to 0 at a gap of 1.2 m.</source>
        <translation>行人旁相对速度平方的代价，在间距 1.2 m 处降至 0。</translation>
    </message>
    <message>
        <source>Front weight</source>
        <translation>前方权重</translation>
    </message>
    <message>
        <source>Cost of a position where a person is about to walk; the robot passes behind people.</source>
        <translation>行人即将走过的位置的代价；机器人从行人身后通过。</translation>
    </message>
    <message>
        <source>Front time</source>
        <translation>前方时间</translation>
    </message>
    <message>
        <source>Walking time that this area extends in front of a person.</source>
        <translation>该区域在行人前方延伸的行走时间。</translation>
    </message>
    <message>
        <source>Legibility weight</source>
        <translation>可读性权重</translation>
    </message>
    <message>
        <source>Cost of not showing early on which side the robot will pass an oncoming person; the beginning of a trajectory has the largest weight.</source>
        <translation>未尽早表明机器人将从迎面行人的哪一侧通过的代价；轨迹开头的权重最大。</translation>
    </message>
    <message>
        <source>Patience weight</source>
        <translation>耐心权重</translation>
    </message>
    <message>
        <source>Cost of standing in a narrow passage that a person is about to use.</source>
        <translation>停在行人即将使用的狭窄通道中的代价。</translation>
    </message>
    <message>
        <source>Wait distance</source>
        <translation>等待距离</translation>
    </message>
    <message>
        <source>Distance from the narrow passage at which the robot waits.</source>
        <translation>机器人等待处与狭窄通道的距离。</translation>
    </message>
    <message>
        <source>Patience time</source>
        <translation>耐心时间</translation>
    </message>
    <message>
        <source>Waiting time after which the robot enters the passage anyway.</source>
        <translation>等待超过此时间后机器人仍会进入通道。</translation>
    </message>
    <message>
        <source>Drives straight to the goal and avoids nothing: a baseline that no test should accept.</source>
        <translation>直接驶向目标点且不避让任何物体：任何测试都不应接受的基准。</translation>
    </message>
    <message>
        <source>Manual drive: stands still until the user drives it. Ignores people.</source>
        <translation>手动操控：在用户操控之前保持静止。忽略行人。</translation>
    </message>
    <message>
        <source>Speed share</source>
        <translation>速度比例</translation>
    </message>
    <message>
        <source>Share of the maximum speed and turn rate that the robot uses at most.</source>
        <translation>机器人最多使用的最大速度和转向速度的比例。</translation>
    </message>
    <message>
        <source>Time after the last command after which the robot stops; 0: it continues.</source>
        <translation>最后一条指令后机器人停下的时间；0：继续。</translation>
    </message>
    <message>
        <source>Driven by the ROS 2 topic /cmd_vel with run --ros2; otherwise it stands still.</source>
        <translation>使用 run --ros2 时由 ROS 2 话题 /cmd_vel 驱动；否则静止。</translation>
    </message>
    <message>
        <source>Nav2 without ROS: uses your nav2_params.yaml and navigator tree.</source>
        <translation>无需 ROS 的 Nav2：使用您的 nav2_params.yaml 和导航器树。</translation>
    </message>
    <message>
        <source>Latency scan</source>
        <translation>扫描延迟</translation>
    </message>
    <message>
        <source>Time steps from the lidar to the costmaps.</source>
        <translation>从激光雷达到代价地图的时间步数。</translation>
    </message>
    <message>
        <source>Latency planner</source>
        <translation>规划延迟</translation>
    </message>
    <message>
        <source>Time steps from a request to its path.</source>
        <translation>从请求到路径的时间步数。</translation>
    </message>
    <message>
        <source>Latency command</source>
        <translation>指令延迟</translation>
    </message>
    <message>
        <source>Time steps from the last server to the wheels.</source>
        <translation>从最后一个服务器到车轮的时间步数。</translation>
    </message>
    <message>
        <source>Waypoint tasks</source>
        <translation>航点任务</translation>
    </message>
    <message>
        <source>1: the robot drives to several goals one by one and executes the task of waypoint_follower at each.</source>
        <translation>1：机器人逐个驶向多个目标点，并在每个点执行 waypoint_follower 的任务。</translation>
    </message>
    <message>
        <source>Crowd model of this program: social forces whose density, flow and lanes are close to measurements.</source>
        <translation>本程序的人群模型：密度、流量和成列现象接近实测的社会力。</translation>
    </message>
    <message>
        <source>Gaze factor</source>
        <translation>注视系数</translation>
    </message>
    <message>
        <source>Weight of the gaze force: turning back to group members behind.</source>
        <translation>注视力的权重：转向身后的群组成员。</translation>
    </message>
    <message>
        <source>Coherence factor</source>
        <translation>凝聚系数</translation>
    </message>
    <message>
        <source>Weight of the attraction to the centre of the group.</source>
        <translation>朝向群组中心的吸引力的权重。</translation>
    </message>
    <message>
        <source>Repulsion factor</source>
        <translation>排斥系数</translation>
    </message>
    <message>
        <source>Weight of the repulsion between group members.</source>
        <translation>群组成员之间排斥力的权重。</translation>
    </message>
    <message>
        <source>Time gap</source>
        <translation>时间间隔</translation>
    </message>
    <message>
        <source>T: time gap to the person straight ahead.</source>
        <translation>T：与正前方行人的时间间隔。</translation>
    </message>
    <message>
        <source>Cap width</source>
        <translation>前方宽度</translation>
    </message>
    <message>
        <source>Tangent of the angle from the walking direction that counts as ahead.</source>
        <translation>视为前方的、与行走方向夹角的正切。</translation>
    </message>
    <message>
        <source>Co moving weight</source>
        <translation>同向权重</translation>
    </message>
    <message>
        <source>Share of the force between people with equal velocities.</source>
        <translation>速度相等的行人之间力的比例。</translation>
    </message>
    <message>
        <source>Full weight at</source>
        <translation>全权重速度</translation>
    </message>
    <message>
        <source>Relative speed above which the force between people has full weight.</source>
        <translation>行人间的力达到全权重的相对速度。</translation>
    </message>
    <message>
        <source>Intent share</source>
        <translation>意图比例</translation>
    </message>
    <message>
        <source>Share of the desired velocity in the velocity that people react to.</source>
        <translation>行人所响应的速度中期望速度的比例。</translation>
    </message>
    <message>
        <source>Lane factor</source>
        <translation>成列系数</translation>
    </message>
    <message>
        <source>Strength of lane formation in counterflow.</source>
        <translation>对向流中成列的强度。</translation>
    </message>
    <message>
        <source>File share</source>
        <translation>跟随比例</translation>
    </message>
    <message>
        <source>Share of people with the same walking direction in the lane force.</source>
        <translation>成列力中同向行人的比例。</translation>
    </message>
    <message>
        <source>Crowd scale</source>
        <translation>人群尺度</translation>
    </message>
    <message>
        <source>Crowding ahead at which the crowd-only terms have half of their effect.</source>
        <translation>前方拥挤程度达到此值时，仅人群项的效果减半。</translation>
    </message>
    <message>
        <source>Braking share</source>
        <translation>制动比例</translation>
    </message>
    <message>
        <source>Share of the braking for oncoming people that remains in a crowd.</source>
        <translation>人群中对迎面行人保留的制动比例。</translation>
    </message>
    <message>
        <source>Yield speed</source>
        <translation>分离速度</translation>
    </message>
    <message>
        <source>Speed at which people in contact separate.</source>
        <translation>接触中的行人分开的速度。</translation>
    </message>
    <message>
        <source>Yield gap</source>
        <translation>分离间距</translation>
    </message>
    <message>
        <source>Gap up to which neighbours count as in contact.</source>
        <translation>邻近行人视为接触的间距。</translation>
    </message>
    <message>
        <source>Push back limit</source>
        <translation>后推限值</translation>
    </message>
    <message>
        <source>Maximum backward force of walls, as a share of the goal force.</source>
        <translation>墙的最大向后力，占目标力的比例。</translation>
    </message>
    <message>
        <source>Crowd wall share</source>
        <translation>人群墙比例</translation>
    </message>
    <message>
        <source>Share of the force of walls beside narrow passages that remains in a crowd.</source>
        <translation>人群中狭窄通道旁墙力保留的比例。</translation>
    </message>
    <message>
        <source>Mate turn width</source>
        <translation>同伴转角</translation>
    </message>
    <message>
        <source>Angle below which group members side by side evade each other less.</source>
        <translation>低于此角度时并排的群组成员相互回避较少。</translation>
    </message>
    <message>
        <source>Optimal reciprocal collision avoidance (van den Berg et al. 2011): the collision-free velocity closest to the desired one.</source>
        <translation>最优互惠避碰（van den Berg 等 2011）：最接近期望速度的无碰撞速度。</translation>
    </message>
    <message>
        <source>tau: time for which velocities are free of collisions with people.</source>
        <translation>tau：速度与行人无碰撞的时间。</translation>
    </message>
    <message>
        <source>Obstacle horizon</source>
        <translation>障碍物时域</translation>
    </message>
    <message>
        <source>Time for which velocities are free of collisions with walls.</source>
        <translation>速度与墙无碰撞的时间。</translation>
    </message>
    <message>
        <source>People farther away are ignored.</source>
        <translation>忽略更远的行人。</translation>
    </message>
    <message>
        <source>Braking time</source>
        <translation>制动时间</translation>
    </message>
    <message>
        <source>Time in which people without a goal come to a stop.</source>
        <translation>没有目标点的行人停下所需的时间。</translation>
    </message>
    <message>
        <source>Rotation of the desired velocity to the right if the path is not free.</source>
        <translation>路径不通畅时期望速度向右的旋转。</translation>
    </message>
    <message>
        <source>The social force model of HuNavSim (Moussaïd et al. 2009, 2010) with its errors corrected.</source>
        <translation>HuNavSim 的社会力模型（Moussaïd 等 2009、2010），已修正其错误。</translation>
    </message>
    <message>
        <source>The social force model of HuNavSim 2.0 unchanged, for comparison with its results.</source>
        <translation>未更改的 HuNavSim 2.0 社会力模型，用于与其结果比较。</translation>
    </message>
    <message>
        <source>Generic robot</source>
        <translation>通用机器人</translation>
    </message>
    <message>
        <source>Navigation Performance</source>
        <translation>导航性能</translation>
    </message>
    <message>
        <source>Social Behavior</source>
        <translation>社会行为</translation>
    </message>
    <message>
        <source>Motion Analysis</source>
        <translation>运动分析</translation>
    </message>
    <message>
        <source>Safety &amp; Collisions</source>
        <translation>安全与碰撞</translation>
    </message>
    <message>
        <source>Social Forces</source>
        <translation>社会力</translation>
    </message>
    <message>
        <source>Danger &amp; Surprise Metrics</source>
        <translation>危险与惊吓指标</translation>
    </message>
    <message>
        <source>Time to reach the goal</source>
        <translation>到达目标点的时间</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>路径长度</translation>
    </message>
    <message>
        <source>Cumulative heading changes</source>
        <translation>累计朝向变化</translation>
    </message>
    <message>
        <source>Mean distance to the closest person</source>
        <translation>与最近行人的平均距离</translation>
    </message>
    <message>
        <source>Smallest distance to people</source>
        <translation>与行人的最小距离</translation>
    </message>
    <message>
        <source>Largest distance to people</source>
        <translation>与行人的最大距离</translation>
    </message>
    <message>
        <source>Intrusions into the intimate space</source>
        <translation>侵入亲密空间</translation>
    </message>
    <message>
        <source>Intrusions into the personal space</source>
        <translation>侵入个人空间</translation>
    </message>
    <message>
        <source>Intrusions into the social space</source>
        <translation>侵入社交空间</translation>
    </message>
    <message>
        <source>Intrusions into the intimate space of groups</source>
        <translation>侵入群组的亲密空间</translation>
    </message>
    <message>
        <source>Intrusions into the personal space of groups</source>
        <translation>侵入群组的个人空间</translation>
    </message>
    <message>
        <source>Intrusions into the social space of groups</source>
        <translation>侵入群组的社交空间</translation>
    </message>
    <message>
        <source>Goal reached</source>
        <translation>已到达目标点</translation>
    </message>
    <message>
        <source>Smallest distance to the goal</source>
        <translation>与目标点的最小距离</translation>
    </message>
    <message>
        <source>Final distance to the goal</source>
        <translation>与目标点的最终距离</translation>
    </message>
    <message>
        <source>Robot runs into a person</source>
        <translation>机器人撞到行人</translation>
    </message>
    <message>
        <source>Person runs into the robot</source>
        <translation>行人撞到机器人</translation>
    </message>
    <message>
        <source>Time standing still</source>
        <translation>静止时间</translation>
    </message>
    <message>
        <source>Mean speed of the robot</source>
        <translation>机器人平均速度</translation>
    </message>
    <message>
        <source>Mean turn rate of the robot</source>
        <translation>机器人平均转向速度</translation>
    </message>
    <message>
        <source>Mean acceleration of the robot</source>
        <translation>机器人平均加速度</translation>
    </message>
    <message>
        <source>Mean jerk of the robot</source>
        <translation>机器人平均加加速度</translation>
    </message>
    <message>
        <source>Mean speed of people</source>
        <translation>行人平均速度</translation>
    </message>
    <message>
        <source>Mean speed of the closest person</source>
        <translation>最近行人的平均速度</translation>
    </message>
    <message>
        <source>Social force of the robot on people</source>
        <translation>机器人对行人的社会力</translation>
    </message>
    <message>
        <source>Social force of people on the robot</source>
        <translation>行人对机器人的社会力</translation>
    </message>
    <message>
        <source>Social work</source>
        <translation>社会功</translation>
    </message>
    <message>
        <source>Obstacle force on the robot</source>
        <translation>障碍物对机器人的力</translation>
    </message>
    <message>
        <source>Obstacle force on people</source>
        <translation>障碍物对行人的力</translation>
    </message>
    <message>
        <source>Danger: fear</source>
        <translation>危险：恐惧</translation>
    </message>
    <message>
        <source>Danger: panic</source>
        <translation>危险：恐慌</translation>
    </message>
    <message>
        <source>Surprise: visibility</source>
        <translation>惊吓：可见性</translation>
    </message>
    <message>
        <source>Surprise: shock</source>
        <translation>惊吓：震惊</translation>
    </message>
    <message>
        <source>Surprise: reaction</source>
        <translation>惊吓：反应</translation>
    </message>
    <message>
        <source>Smallest clearance</source>
        <translation>最小间隙</translation>
    </message>
    <message>
        <source>Mean clearance</source>
        <translation>平均间隙</translation>
    </message>
    <message>
        <source>Time too close to obstacles</source>
        <translation>过于靠近障碍物的时间</translation>
    </message>
    <message>
        <source>Winding around people</source>
        <translation>绕行人的圈数</translation>
    </message>
    <message>
        <source>Replans of the robot</source>
        <translation>机器人重新规划次数</translation>
    </message>
    <message>
        <source>Aggregated time to the goals</source>
        <translation>到达目标点的总时间</translation>
    </message>
    <message>
        <source>Mean distance to the goal while stopped</source>
        <translation>停止时与目标点的平均距离</translation>
    </message>
    <message>
        <source>Density around people</source>
        <translation>行人周围的密度</translation>
    </message>
    <message>
        <source>Voronoi density</source>
        <translation>Voronoi 密度</translation>
    </message>
    <message>
        <source>Voronoi density, largest sample</source>
        <translation>Voronoi 密度，最大样本</translation>
    </message>
    <message>
        <source>Specific flow of the crowd</source>
        <translation>人群的比流量</translation>
    </message>
    <message>
        <source>Crowd polarisation</source>
        <translation>人群极化度</translation>
    </message>
    <message>
        <source>Crowd lane order</source>
        <translation>人群成列有序度</translation>
    </message>
    <message>
        <source>Danger: fear, mean per sample</source>
        <translation>危险：恐惧，每样本均值</translation>
    </message>
    <message>
        <source>Danger: panic, mean per sample</source>
        <translation>危险：恐慌，每样本均值</translation>
    </message>
    <message>
        <source>Time facing people</source>
        <translation>面向行人的时间</translation>
    </message>
    <message>
        <source>Time seen by people</source>
        <translation>被行人看到的时间</translation>
    </message>
    <message>
        <source>Time facing people, 60 degrees</source>
        <translation>面向行人的时间，60 度</translation>
    </message>
    <message>
        <source>Time seen by people, 60 degrees</source>
        <translation>被行人看到的时间，60 度</translation>
    </message>
    <message>
        <source>Direction of the nearest person at the end</source>
        <translation>结束时最近行人的方向</translation>
    </message>
    <message>
        <source>Distance of the nearest person at the end</source>
        <translation>结束时最近行人的距离</translation>
    </message>
    <message>
        <source>Speed of the nearest person at the end</source>
        <translation>结束时最近行人的速度</translation>
    </message>
    <message>
        <source>People near the robot at the end</source>
        <translation>结束时机器人附近的行人</translation>
    </message>
    <message>
        <source>Line crossings by people</source>
        <translation>行人越线次数</translation>
    </message>
    <message>
        <source>Flow through the line</source>
        <translation>通过该线的流量</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space</source>
        <translation>侵入高斯个人空间</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space, smallest</source>
        <translation>侵入高斯个人空间，最小</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space, largest</source>
        <translation>侵入高斯个人空间，最大</translation>
    </message>
    <message>
        <source>Time inside the Gaussian personal space</source>
        <translation>处于高斯个人空间内的时间</translation>
    </message>
    <message>
        <source>Intrusion into the space of groups</source>
        <translation>侵入群组空间</translation>
    </message>
    <message>
        <source>Intrusion into the space of groups, largest</source>
        <translation>侵入群组空间，最大</translation>
    </message>
    <message>
        <source>Group crossings</source>
        <translation>穿越群组次数</translation>
    </message>
    <message>
        <source>Disturbance by the robot&apos;s heading</source>
        <translation>机器人朝向造成的干扰</translation>
    </message>
    <message>
        <source>Disturbance by the robot&apos;s heading, largest</source>
        <translation>机器人朝向造成的干扰，最大</translation>
    </message>
    <message>
        <source>Time hardly moving</source>
        <translation>几乎不动的时间</translation>
    </message>
    <message>
        <source>Time driving backwards</source>
        <translation>倒车时间</translation>
    </message>
    <message>
        <source>Time rotating in place</source>
        <translation>原地旋转时间</translation>
    </message>
    <message>
        <source>Success</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>Duration of the record</source>
        <translation>记录时长</translation>
    </message>
    <message>
        <source>Robot runs into an obstacle</source>
        <translation>机器人撞到障碍物</translation>
    </message>
    <message>
        <source>Success weighted by path length</source>
        <translation>按路径长度加权的成功率</translation>
    </message>
    <message>
        <source>Success weighted by time</source>
        <translation>按时间加权的成功率</translation>
    </message>
    <message>
        <source>Path efficiency</source>
        <translation>路径效率</translation>
    </message>
    <message>
        <source>Path irregularity</source>
        <translation>路径不规则度</translation>
    </message>
    <message>
        <source>Turning per metre</source>
        <translation>每米转角</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>平均曲率</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>最大曲率</translation>
    </message>
    <message>
        <source>Mean roughness</source>
        <translation>平均粗糙度</translation>
    </message>
    <message>
        <source>Smallest time to collision</source>
        <translation>最小碰撞时间</translation>
    </message>
    <message>
        <source>Personal space compliance</source>
        <translation>个人空间遵守度</translation>
    </message>
    <message>
        <source>Discomfort frequency</source>
        <translation>不适频率</translation>
    </message>
    <message>
        <source>Mean distance during discomfort</source>
        <translation>不适期间的平均距离</translation>
    </message>
    <message>
        <source>Time in personal space</source>
        <translation>处于个人空间内的时间</translation>
    </message>
    <message>
        <source>Mean speed in personal space</source>
        <translation>个人空间内的平均速度</translation>
    </message>
    <message>
        <source>Largest speed in intimate space</source>
        <translation>亲密空间内的最大速度</translation>
    </message>
    <message>
        <source>Steps away from the goal</source>
        <translation>远离目标点的步数</translation>
    </message>
    <message>
        <source>Time stalled</source>
        <translation>停滞时间</translation>
    </message>
    <message>
        <source>Remaining share of the distance</source>
        <translation>剩余距离比例</translation>
    </message>
    <message>
        <source>Final distance per path length</source>
        <translation>最终距离与路径长度之比</translation>
    </message>
    <message>
        <source>Mean displacement from the reference</source>
        <translation>与参考的平均位移</translation>
    </message>
    <message>
        <source>Final displacement from the reference</source>
        <translation>与参考的最终位移</translation>
    </message>
    <message>
        <source>DTW distance from the reference</source>
        <translation>与参考的 DTW 距离</translation>
    </message>
    <message>
        <source>Mean distance from the reference path</source>
        <translation>与参考路径的平均距离</translation>
    </message>
    <message>
        <source>Responsibility of the robot</source>
        <translation>机器人的责任</translation>
    </message>
    <message>
        <source>Engagement of the robot</source>
        <translation>机器人的参与度</translation>
    </message>
    <message>
        <source>Social force of the robot on people, mean per sample</source>
        <translation>机器人对行人的社会力，每样本均值</translation>
    </message>
    <message>
        <source>Social force of people on the robot, mean per sample</source>
        <translation>行人对机器人的社会力，每样本均值</translation>
    </message>
    <message>
        <source>Social work, mean per sample</source>
        <translation>社会功，每样本均值</translation>
    </message>
    <message>
        <source>Obstacle force on the robot, mean per sample</source>
        <translation>障碍物对机器人的力，每样本均值</translation>
    </message>
    <message>
        <source>Obstacle force on people, mean per sample</source>
        <translation>障碍物对行人的力，每样本均值</translation>
    </message>
    <message>
        <source>Smallest speed of the robot</source>
        <translation>机器人最小速度</translation>
    </message>
    <message>
        <source>Largest speed of the robot</source>
        <translation>机器人最大速度</translation>
    </message>
    <message>
        <source>Largest acceleration of the robot</source>
        <translation>机器人最大加速度</translation>
    </message>
    <message>
        <source>Largest jerk of the robot</source>
        <translation>机器人最大加加速度</translation>
    </message>
    <message>
        <source>Mean angular acceleration of the robot</source>
        <translation>机器人平均角加速度</translation>
    </message>
    <message>
        <source>Motion energy</source>
        <translation>运动能量</translation>
    </message>
    <message>
        <source>Surprise: visibility, mean per sample</source>
        <translation>惊吓：可见性，每样本均值</translation>
    </message>
    <message>
        <source>Surprise: shock, mean per sample</source>
        <translation>惊吓：震惊，每样本均值</translation>
    </message>
    <message>
        <source>Surprise: reaction, mean per sample</source>
        <translation>惊吓：反应，每样本均值</translation>
    </message>
    <message>
        <source>Mean time to collision</source>
        <translation>平均碰撞时间</translation>
    </message>
    <message>
        <source>Time exposed to collisions</source>
        <translation>暴露于碰撞的时间</translation>
    </message>
    <message>
        <source>Time-integrated threat of collisions</source>
        <translation>碰撞威胁的时间积分</translation>
    </message>
    <message>
        <source>Mean passing distance</source>
        <translation>平均通过距离</translation>
    </message>
    <message>
        <source>Largest approach speed</source>
        <translation>最大接近速度</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>最大横向加速度</translation>
    </message>
    <message>
        <source>Entries into the intimate zone</source>
        <translation>进入亲密区域的次数</translation>
    </message>
    <message>
        <source>Entries of the robot into the intimate zone</source>
        <translation>机器人进入亲密区域的次数</translation>
    </message>
    <message>
        <source>Entries of people into the intimate zone</source>
        <translation>行人进入亲密区域的次数</translation>
    </message>
    <message>
        <source>Entries into the personal zone</source>
        <translation>进入个人区域的次数</translation>
    </message>
    <message>
        <source>Entries of the robot into the personal zone</source>
        <translation>机器人进入个人区域的次数</translation>
    </message>
    <message>
        <source>Entries of people into the personal zone</source>
        <translation>行人进入个人区域的次数</translation>
    </message>
    <message>
        <source>so far</source>
        <translation>目前为止</translation>
    </message>
    <message>
        <source>per step</source>
        <translation>每步</translation>
    </message>
    <message>
        <source>count per step</source>
        <translation>每步计数</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>Runs the children in order until one fails; resumes at the running child.</source>
        <translation>按顺序运行子节点直到一个失败；从正在运行的子节点继续。</translation>
    </message>
    <message>
        <source>Runs the children in order until one succeeds; resumes at the running child.</source>
        <translation>按顺序运行子节点直到一个成功；从正在运行的子节点继续。</translation>
    </message>
    <message>
        <source>A sequence that restarts at the first child in every time step, so that conditions are checked again.</source>
        <translation>每个时间步都从第一个子节点重新开始的顺序节点，因此会重新检查条件。</translation>
    </message>
    <message>
        <source>A fallback that restarts at the first child in every time step, so that earlier children take precedence.</source>
        <translation>每个时间步都从第一个子节点重新开始的选择节点，因此靠前的子节点优先。</translation>
    </message>
    <message>
        <source>A sequence that resumes at the child that failed.</source>
        <translation>从失败的子节点继续的顺序节点。</translation>
    </message>
    <message>
        <source>A sequence that completes at most one child per time step.</source>
        <translation>每个时间步最多完成一个子节点的顺序节点。</translation>
    </message>
    <message>
        <source>A fallback that completes at most one child per time step.</source>
        <translation>每个时间步最多完成一个子节点的选择节点。</translation>
    </message>
    <message>
        <source>Runs all children in every time step until enough have succeeded or failed.</source>
        <translation>每个时间步运行所有子节点，直到足够多的成功或失败。</translation>
    </message>
    <message>
        <source>Number of successes after which the node succeeds; negative: counted from all children (-1: all).</source>
        <translation>使节点成功所需的成功数；负数：从全部子节点倒数（-1：全部）。</translation>
    </message>
    <message>
        <source>Number of failures after which the node fails; negative: counted from all children (-1: all).</source>
        <translation>使节点失败所需的失败数；负数：从全部子节点倒数（-1：全部）。</translation>
    </message>
    <message>
        <source>Runs all children and ends when all are completed.</source>
        <translation>运行所有子节点，全部完成后结束。</translation>
    </message>
    <message>
        <source>Number of failures after which the node fails.</source>
        <translation>达到此失败数时节点失败。</translation>
    </message>
    <message>
        <source>The first child is the condition, run once; if it succeeds, the second child is run, otherwise the third.</source>
        <translation>第一个子节点是条件，运行一次；若成功则运行第二个子节点，否则运行第三个。</translation>
    </message>
    <message>
        <source>The first child is the condition, run in every time step; while it succeeds, the second child is run, otherwise the third.</source>
        <translation>第一个子节点是条件，每个时间步运行；成功时运行第二个子节点，否则运行第三个。</translation>
    </message>
    <message>
        <source>Runs the child whose case equals the variable, for any other value the last child.</source>
        <translation>运行其 case 等于变量的子节点；其他值则运行最后一个子节点。</translation>
    </message>
    <message>
        <source>Value that is compared.</source>
        <translation>被比较的值。</translation>
    </message>
    <message>
        <source>Value for which child 1 is run.</source>
        <translation>运行子节点 1 的值。</translation>
    </message>
    <message>
        <source>Value for which child 2 is run.</source>
        <translation>运行子节点 2 的值。</translation>
    </message>
    <message>
        <source>Value for which child 3 is run.</source>
        <translation>运行子节点 3 的值。</translation>
    </message>
    <message>
        <source>Value for which child 4 is run.</source>
        <translation>运行子节点 4 的值。</translation>
    </message>
    <message>
        <source>Value for which child 5 is run.</source>
        <translation>运行子节点 5 的值。</translation>
    </message>
    <message>
        <source>Child 6 is run for this value.</source>
        <translation>此值时运行子节点 6。</translation>
    </message>
    <message>
        <source>Runs all children except the last as a sequence; if it fails, runs the last child.</source>
        <translation>将除最后一个以外的子节点作为顺序运行；若失败则运行最后一个子节点。</translation>
    </message>
    <message>
        <source>The last child is also ticked once when the node is halted.</source>
        <translation>节点被中止时，最后一个子节点也会被 tick 一次。</translation>
    </message>
    <message>
        <source>Decorator</source>
        <translation>装饰</translation>
    </message>
    <message>
        <source>Inverts success and failure of the child.</source>
        <translation>反转子节点的成功与失败。</translation>
    </message>
    <message>
        <source>Succeeds whatever the result of the child.</source>
        <translation>无论子节点结果如何都成功。</translation>
    </message>
    <message>
        <source>Fails whatever the result of the child.</source>
        <translation>无论子节点结果如何都失败。</translation>
    </message>
    <message>
        <source>Repeats the child until it fails.</source>
        <translation>重复子节点直到失败。</translation>
    </message>
    <message>
        <source>Repeats the child this number of times, or until it fails.</source>
        <translation>将子节点重复此次数，或直到失败。</translation>
    </message>
    <message>
        <source>Number of runs; -1: unlimited.</source>
        <translation>运行次数；-1：不限。</translation>
    </message>
    <message>
        <source>Repeats the child until it succeeds.</source>
        <translation>重复子节点直到成功。</translation>
    </message>
    <message>
        <source>Runs the child to completion once in the lifetime of the tree.</source>
        <translation>在树的生命周期内将子节点完整运行一次。</translation>
    </message>
    <message>
        <source>Afterwards: true: skipped, false: returns the same result.</source>
        <translation>之后：true：跳过，false：返回相同结果。</translation>
    </message>
    <message>
        <source>Waits before the child is run.</source>
        <translation>运行子节点前等待。</translation>
    </message>
    <message>
        <source>Duration in simulated time.</source>
        <translation>仿真时间中的时长。</translation>
    </message>
    <message>
        <source>Fails when the child takes longer.</source>
        <translation>子节点超时则失败。</translation>
    </message>
    <message>
        <source>Limit in simulated time; 0: none.</source>
        <translation>仿真时间中的限制；0：无。</translation>
    </message>
    <message>
        <source>Runs the child only if a script is true.</source>
        <translation>仅当脚本为真时运行子节点。</translation>
    </message>
    <message>
        <source>Script.</source>
        <translation>脚本。</translation>
    </message>
    <message>
        <source>Result if the script is false.</source>
        <translation>脚本为假时的结果。</translation>
    </message>
    <message>
        <source>Runs the child once for each element of a list.</source>
        <translation>对列表中的每个元素运行一次子节点。</translation>
    </message>
    <message>
        <source>Elements, separated by &apos;;&apos;.</source>
        <translation>元素，用 &apos;;&apos; 分隔。</translation>
    </message>
    <message>
        <source>Result at the end.</source>
        <translation>结束时的结果。</translation>
    </message>
    <message>
        <source>Current element.</source>
        <translation>当前元素。</translation>
    </message>
    <message>
        <source>Skips the child unless the blackboard entry was written.</source>
        <translation>除非黑板条目被写入，否则跳过子节点。</translation>
    </message>
    <message>
        <source>Blackboard entry.</source>
        <translation>黑板条目。</translation>
    </message>
    <message>
        <source>Waits until the blackboard entry is written, then runs the child.</source>
        <translation>等待黑板条目被写入，然后运行子节点。</translation>
    </message>
    <message>
        <source>SubTree</source>
        <translation>子树</translation>
    </message>
    <message>
        <source>Runs another tree.</source>
        <translation>运行另一棵树。</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Succeeds.</source>
        <translation>成功。</translation>
    </message>
    <message>
        <source>Fails.</source>
        <translation>失败。</translation>
    </message>
    <message>
        <source>Writes an entry of the blackboard.</source>
        <translation>写入黑板条目。</translation>
    </message>
    <message>
        <source>Text, or {key} of the entry that is copied.</source>
        <translation>文本，或要复制的条目的 {键}。</translation>
    </message>
    <message>
        <source>Name of the entry.</source>
        <translation>条目的名称。</translation>
    </message>
    <message>
        <source>Removes an entry of the blackboard.</source>
        <translation>移除黑板条目。</translation>
    </message>
    <message>
        <source>Runs a script.</source>
        <translation>运行脚本。</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Succeeds if a script is true.</source>
        <translation>脚本为真则成功。</translation>
    </message>
    <message>
        <source>Waits.</source>
        <translation>等待。</translation>
    </message>
    <message>
        <source>Succeeds if the entry was written since the last check.</source>
        <translation>若条目自上次检查后被写入则成功。</translation>
    </message>
    <message>
        <source>Walks to another person, slower with decreasing distance, and looks at them from the closest distance.</source>
        <translation>走向另一个行人，距离越近越慢，并在最近距离处注视对方。</translation>
    </message>
    <message>
        <source>Id of the person.</source>
        <translation>行人的 id。</translation>
    </message>
    <message>
        <source>Id of the other person.</source>
        <translation>另一个行人的 id。</translation>
    </message>
    <message>
        <source>Time step in HuNavSim; this program uses the simulation&apos;s time step.</source>
        <translation>HuNavSim 中的时间步；本程序使用仿真的时间步。</translation>
    </message>
    <message>
        <source>Ends after this time; 0: unlimited.</source>
        <translation>此时间后结束；0：不限。</translation>
    </message>
    <message>
        <source>Distance at which the person stops.</source>
        <translation>行人停下的距离。</translation>
    </message>
    <message>
        <source>Speed far from the other person.</source>
        <translation>远离另一行人时的速度。</translation>
    </message>
    <message>
        <source>Follows another person at the person&apos;s own speed, at most max_vel if given, and slower within the closest distance.</source>
        <translation>以自身速度跟随另一行人，若给出则不超过 max_vel，在最近距离内更慢。</translation>
    </message>
    <message>
        <source>Distance within which the person slows down.</source>
        <translation>行人减速的距离。</translation>
    </message>
    <message>
        <source>Maximum speed while following; absent or negative: the person&apos;s own.</source>
        <translation>跟随时的最大速度；缺省或为负：行人自身的速度。</translation>
    </message>
    <message>
        <source>Walks to a position in front of another person and faces them.</source>
        <translation>走到另一行人前方的位置并面向对方。</translation>
    </message>
    <message>
        <source>Distance in front of the other person.</source>
        <translation>另一行人前方的距离。</translation>
    </message>
    <message>
        <source>Another person is within the distance and the field of view, and no wall hides them.</source>
        <translation>另一行人在距离和视野之内，且没有墙遮挡。</translation>
    </message>
    <message>
        <source>Id of the person who looks.</source>
        <translation>观察者的 id。</translation>
    </message>
    <message>
        <source>Maximum distance of visible people.</source>
        <translation>可见行人的最大距离。</translation>
    </message>
    <message>
        <source>Half of the field of view: the angle to each side, pi: all around.</source>
        <translation>视野的一半：每侧的角度，pi：全方位。</translation>
    </message>
    <message>
        <source>Another person is nearer than the threshold.</source>
        <translation>另一行人比阈值更近。</translation>
    </message>
    <message>
        <source>Id of the first person.</source>
        <translation>第一个行人的 id。</translation>
    </message>
    <message>
        <source>Distance below which a person is close.</source>
        <translation>低于此距离视为靠近。</translation>
    </message>
    <message>
        <source>Gathers people in a circle around a goal, facing its centre, and keeps them there for the conversation. This node controls the members instead of their own trees.</source>
        <translation>将行人聚集在目标点周围的圆上，面向圆心，并在交谈期间保持。此节点代替成员自己的树进行控制。</translation>
    </message>
    <message>
        <source>Id of the person who gathers the others.</source>
        <translation>召集者的 id。</translation>
    </message>
    <message>
        <source>Id of the global goal that is the centre.</source>
        <translation>作为圆心的全局目标点的 id。</translation>
    </message>
    <message>
        <source>x of a point, if no goal_id is given.</source>
        <translation>未给出 goal_id 时点的 x。</translation>
    </message>
    <message>
        <source>y of a point, if no goal_id is given.</source>
        <translation>未给出 goal_id 时点的 y。</translation>
    </message>
    <message>
        <source>Duration after all members are in place.</source>
        <translation>所有成员就位后的时长。</translation>
    </message>
    <message>
        <source>Ids of the other members, separated by commas.</source>
        <translation>其他成员的 id，用逗号分隔。</translation>
    </message>
    <message>
        <source>At least this number of other people are near.</source>
        <translation>附近至少有此数量的其他行人。</translation>
    </message>
    <message>
        <source>Distance within which people are near.</source>
        <translation>视为附近的距离。</translation>
    </message>
    <message>
        <source>Number of other people.</source>
        <translation>其他行人的数量。</translation>
    </message>
    <message>
        <source>All other members of the person&apos;s group are near; fails without a group.</source>
        <translation>该行人群组的所有其他成员都在附近；没有群组则失败。</translation>
    </message>
    <message>
        <source>Stands until another person is near, including a person who has not entered yet.</source>
        <translation>站立直到另一行人靠近，包括尚未进入的行人。</translation>
    </message>
    <message>
        <source>Id of the person to wait for.</source>
        <translation>所等待行人的 id。</translation>
    </message>
    <message>
        <source>Fails after this time; 0: unlimited.</source>
        <translation>此时间后失败；0：不限。</translation>
    </message>
    <message>
        <source>Walks away from another person to the safe distance.</source>
        <translation>远离另一行人至安全距离。</translation>
    </message>
    <message>
        <source>Id of the person to flee from.</source>
        <translation>所逃离行人的 id。</translation>
    </message>
    <message>
        <source>Distance at which the node ends.</source>
        <translation>节点结束的距离。</translation>
    </message>
    <message>
        <source>Speed while fleeing.</source>
        <translation>逃离时的速度。</translation>
    </message>
    <message>
        <source>Writes the id of the nearest other person; fails if there is none.</source>
        <translation>写入最近的其他行人的 id；没有则失败。</translation>
    </message>
    <message>
        <source>Id of the nearest person.</source>
        <translation>最近行人的 id。</translation>
    </message>
    <message>
        <source>Walks to a global goal; the person&apos;s other goals are suspended.</source>
        <translation>走向一个全局目标点；该行人的其他目标点暂停。</translation>
    </message>
    <message>
        <source>Id of the global goal.</source>
        <translation>全局目标点的 id。</translation>
    </message>
    <message>
        <source>The goal is reached within this distance plus 0.1 m.</source>
        <translation>在此距离加 0.1 m 内视为到达目标点。</translation>
    </message>
    <message>
        <source>Accepted for existing files; has no effect.</source>
        <translation>为兼容现有文件而接受；无效果。</translation>
    </message>
    <message>
        <source>Removes the current goal from the list; with cyclic goals it is appended at the end. Fails without goals.</source>
        <translation>从列表中移除当前目标点；循环目标点会追加到末尾。没有目标点则失败。</translation>
    </message>
    <message>
        <source>Appends a global goal to the person&apos;s list; goals set in the first tick replace those of the scenario.</source>
        <translation>将全局目标点追加到行人的列表；第一个 tick 中设置的目标点取代场景的目标点。</translation>
    </message>
    <message>
        <source>One time step towards the current goal; without a goal the person comes to rest.</source>
        <translation>朝当前目标点走一个时间步；没有目标点时行人停下。</translation>
    </message>
    <message>
        <source>The person is within the radius of the current goal, plus 0.1 m; never without a goal.</source>
        <translation>行人在当前目标点半径加 0.1 m 内；没有目标点则永不成立。</translation>
    </message>
    <message>
        <source>The person is at a global goal.</source>
        <translation>行人位于某个全局目标点。</translation>
    </message>
    <message>
        <source>Id of any person.</source>
        <translation>任意行人的 id。</translation>
    </message>
    <message>
        <source>Maximum distance to the goal.</source>
        <translation>与目标点的最大距离。</translation>
    </message>
    <message>
        <source>Puts the person into a group.</source>
        <translation>将行人加入群组。</translation>
    </message>
    <message>
        <source>Number of the group; -1: no group.</source>
        <translation>群组编号；-1：无群组。</translation>
    </message>
    <message>
        <source>Forms a group with the goals of the main person, whom this node controls; the others follow their own trees. Groups and goals are restored at the end.</source>
        <translation>以主要行人的目标点组成群组，此节点控制该行人；其他人遵循自己的树。结束时恢复群组和目标点。</translation>
    </message>
    <message>
        <source>Id of the person who leads.</source>
        <translation>领头行人的 id。</translation>
    </message>
    <message>
        <source>The robot is within the distance and within 100 degrees to each side, and no wall hides it.</source>
        <translation>机器人在距离内且在左右各 100 度之内，没有墙遮挡。</translation>
    </message>
    <message>
        <source>Maximum distance at which the robot is visible.</source>
        <translation>机器人可见的最大距离。</translation>
    </message>
    <message>
        <source>Turns in place to a global goal.</source>
        <translation>原地转向全局目标点。</translation>
    </message>
    <message>
        <source>Heading error at which the node ends.</source>
        <translation>节点结束时的朝向误差。</translation>
    </message>
    <message>
        <source>Turns in place to another person.</source>
        <translation>原地转向另一行人。</translation>
    </message>
    <message>
        <source>Id of the person who turns.</source>
        <translation>转身行人的 id。</translation>
    </message>
    <message>
        <source>Id of the person to look at.</source>
        <translation>被注视行人的 id。</translation>
    </message>
    <message>
        <source>Turns in place to the robot.</source>
        <translation>原地转向机器人。</translation>
    </message>
    <message>
        <source>Waits until another person looks at the person; selects the nearest of several.</source>
        <translation>等待另一行人注视该行人；有多人时选择最近者。</translation>
    </message>
    <message>
        <source>Maximum distance of the other person.</source>
        <translation>另一行人的最大距离。</translation>
    </message>
    <message>
        <source>Maximum angle between the other person&apos;s heading and the line to the person.</source>
        <translation>另一行人的朝向与指向该行人连线的最大夹角。</translation>
    </message>
    <message>
        <source>Maximum wait; then the node fails.</source>
        <translation>最长等待；之后节点失败。</translation>
    </message>
    <message>
        <source>Waits until a certain person looks at this one.</source>
        <translation>等待特定行人注视该行人。</translation>
    </message>
    <message>
        <source>Id of the person who should look.</source>
        <translation>应注视的行人的 id。</translation>
    </message>
    <message>
        <source>Passes the robot ahead on the person&apos;s left or right; fails if there is none ahead.</source>
        <translation>从行人的左侧或右侧超过前方的机器人；前方没有机器人则失败。</translation>
    </message>
    <message>
        <source>left or right, seen by the person.</source>
        <translation>left 或 right，从行人角度看。</translation>
    </message>
    <message>
        <source>Distance to the robot at which the node starts.</source>
        <translation>节点开始时与机器人的距离。</translation>
    </message>
    <message>
        <source>Lateral distance to the robot.</source>
        <translation>与机器人的横向距离。</translation>
    </message>
    <message>
        <source>Walks between random points of an area.</source>
        <translation>在区域内的随机点之间行走。</translation>
    </message>
    <message>
        <source>Name of the area.</source>
        <translation>区域的名称。</translation>
    </message>
    <message>
        <source>Walks into the area of kind exit with the shortest path; fails without one.</source>
        <translation>走入路径最短的 exit 类区域；没有则失败。</translation>
    </message>
    <message>
        <source>Walks to a global goal and stays there for some time.</source>
        <translation>走向全局目标点并停留一段时间。</translation>
    </message>
    <message>
        <source>Id of the global goal at the object.</source>
        <translation>物体处的全局目标点的 id。</translation>
    </message>
    <message>
        <source>Time at the object.</source>
        <translation>在物体处的时间。</translation>
    </message>
    <message>
        <source>Selects a random child when it is started and runs it to completion.</source>
        <translation>启动时随机选择一个子节点并完整运行。</translation>
    </message>
    <message>
        <source>Relative probability of each child; absent: all equal.</source>
        <translation>各子节点的相对概率；缺省：全部相等。</translation>
    </message>
    <message>
        <source>Succeeds with the given probability, drawn again in every tick, so that the probability over n ticks is 1 - (1 - p)^n.</source>
        <translation>以给定概率成功，每个 tick 重新抽取，因此 n 个 tick 的概率为 1 - (1 - p)^n。</translation>
    </message>
    <message>
        <source>Probability per tick.</source>
        <translation>每个 tick 的概率。</translation>
    </message>
    <message>
        <source>Stands and turns to the robot.</source>
        <translation>站立并转向机器人。</translation>
    </message>
    <message>
        <source>One time step towards the robot, slower with decreasing distance; looks at it at rest.</source>
        <translation>朝机器人走一个时间步，距离越近越慢；静止时注视它。</translation>
    </message>
    <message>
        <source>Speed far from the robot.</source>
        <translation>远离机器人时的速度。</translation>
    </message>
    <message>
        <source>Distance to the robot at which the person stops.</source>
        <translation>行人停下时与机器人的距离。</translation>
    </message>
    <message>
        <source>One time step away from the robot. With scary_force_factor and without safe_distance: one time step to the goals while the robot repels the person.</source>
        <translation>远离机器人走一个时间步。有 scary_force_factor 且无 safe_distance 时：在机器人排斥行人的同时朝目标点走一个时间步。</translation>
    </message>
    <message>
        <source>Distance to which the person flees.</source>
        <translation>行人逃离到的距离。</translation>
    </message>
    <message>
        <source>Strength of the repulsive force of the robot.</source>
        <translation>机器人排斥力的强度。</translation>
    </message>
    <message>
        <source>One time step to the position in front of the robot; faces it there.</source>
        <translation>朝机器人前方的位置走一个时间步；在那里面向它。</translation>
    </message>
    <message>
        <source>Distance in front of the robot; values below 0.5 m are replaced by 1.5 m.</source>
        <translation>机器人前方的距离；低于 0.5 m 的值替换为 1.5 m。</translation>
    </message>
    <message>
        <source>Walks to the robot, slower with decreasing distance, and looks at it from the closest distance.</source>
        <translation>走向机器人，距离越近越慢，并在最近距离处注视它。</translation>
    </message>
    <message>
        <source>Flees from the robot to the safe distance and looks at it from there.</source>
        <translation>逃离机器人至安全距离，并从那里注视它。</translation>
    </message>
    <message>
        <source>Walks to the position in front of the robot and faces it there.</source>
        <translation>走到机器人前方的位置并在那里面向它。</translation>
    </message>
    <message>
        <source>The robot is nearer than the threshold.</source>
        <translation>机器人比阈值更近。</translation>
    </message>
    <message>
        <source>Distance below which the robot is close.</source>
        <translation>低于此距离视为机器人靠近。</translation>
    </message>
    <message>
        <source>The robot&apos;s heading points at the person within 0.3 rad.</source>
        <translation>机器人的朝向在 0.3 rad 内指向该行人。</translation>
    </message>
    <message>
        <source>Says a sentence, once.</source>
        <translation>说一句话，仅一次。</translation>
    </message>
    <message>
        <source>Text of the sentence.</source>
        <translation>句子的文本。</translation>
    </message>
    <message>
        <source>Waits until a person nearby is heard; walls block speech. The last speaker is selected.</source>
        <translation>等待听到附近行人的声音；墙会阻挡语音。选择最后的说话者。</translation>
    </message>
    <message>
        <source>Maximum distance at which speech is heard.</source>
        <translation>能听到语音的最大距离。</translation>
    </message>
    <message>
        <source>Id of the speaker.</source>
        <translation>说话者的 id。</translation>
    </message>
    <message>
        <source>Waits until a certain person is heard; walls block speech.</source>
        <translation>等待听到特定行人的声音；墙会阻挡语音。</translation>
    </message>
    <message>
        <source>The person stops walking to goals until ResumeMovement; reactions still move the person.</source>
        <translation>行人停止走向目标点，直到 ResumeMovement；反应仍会使其移动。</translation>
    </message>
    <message>
        <source>Ends the effect of StopMovement.</source>
        <translation>结束 StopMovement 的效果。</translation>
    </message>
    <message>
        <source>Stands still for some time.</source>
        <translation>站立不动一段时间。</translation>
    </message>
    <message>
        <source>Duration.</source>
        <translation>时长。</translation>
    </message>
    <message>
        <source>Fails until the delay is over, then runs the child; the delay restarts after each run of the child.</source>
        <translation>延迟结束前失败，之后运行子节点；每次运行子节点后延迟重新开始。</translation>
    </message>
    <message>
        <source>Time before the child is run.</source>
        <translation>运行子节点前的时间。</translation>
    </message>
    <message>
        <source>Adds `ts` in each tick and succeeds when the sum has reached `seconds`; then it restarts, or with only_once succeeds from then on.</source>
        <translation>每个 tick 累加 `ts`，总和达到 `seconds` 时成功；之后重新开始，或在 only_once 下此后一直成功。</translation>
    </message>
    <message>
        <source>Length of the timer.</source>
        <translation>计时器的时长。</translation>
    </message>
    <message>
        <source>Added per tick; usually {dt}.</source>
        <translation>每个 tick 累加；通常为 {dt}。</translation>
    </message>
    <message>
        <source>The timer stays expired.</source>
        <translation>计时器保持到期状态。</translation>
    </message>
    <message>
        <source>Runs the child; after its completion the node fails until the time has passed.</source>
        <translation>运行子节点；完成后，节点在此时间内失败。</translation>
    </message>
    <message>
        <source>Pause after each run of the child.</source>
        <translation>每次运行子节点后的暂停。</translation>
    </message>
    <message>
        <source>The simulated time lies in [from, until).</source>
        <translation>仿真时间位于 [from, until) 内。</translation>
    </message>
    <message>
        <source>Start of the interval.</source>
        <translation>区间的开始。</translation>
    </message>
    <message>
        <source>End of the interval.</source>
        <translation>区间的结束。</translation>
    </message>
    <message>
        <source>Joins the queue at a global goal, moves up in it and is served at its head.</source>
        <translation>加入全局目标点处的队列，向前移动并在队首接受服务。</translation>
    </message>
    <message>
        <source>Id of the global goal at the head of the queue.</source>
        <translation>队首全局目标点的 id。</translation>
    </message>
    <message>
        <source>Distance to the person in front.</source>
        <translation>与前面行人的距离。</translation>
    </message>
    <message>
        <source>Time at the head of the queue.</source>
        <translation>在队首的时间。</translation>
    </message>
    <message>
        <source>Maximum wait until service; then the node fails; 0: unlimited.</source>
        <translation>接受服务前的最长等待；之后节点失败；0：不限。</translation>
    </message>
    <message>
        <source>Stands and looks at an approaching robot until it has passed; fails if no robot approaches.</source>
        <translation>站立并注视靠近的机器人直到它通过；没有机器人靠近则失败。</translation>
    </message>
    <message>
        <source>Maximum distance of the robot.</source>
        <translation>机器人的最大距离。</translation>
    </message>
    <message>
        <source>Time after which the node ends if the robot stands still.</source>
        <translation>机器人静止时节点结束的时间。</translation>
    </message>
    <message>
        <source>Robot interaction</source>
        <translation>与机器人互动</translation>
    </message>
    <message>
        <source>Turns to the robot when it is in sight and approaches it</source>
        <translation>看到机器人时转向并走近它</translation>
    </message>
    <message>
        <source>Conversation</source>
        <translation>交谈</translation>
    </message>
    <message>
        <source>Stands together with others at a goal and talks</source>
        <translation>与他人一起站在目标点处交谈</translation>
    </message>
    <message>
        <source>With</source>
        <translation>与</translation>
    </message>
    <message>
        <source>Meets at goal</source>
        <translation>会合目标点</translation>
    </message>
    <message>
        <source>Closer than</source>
        <translation>近于</translation>
    </message>
    <message>
        <source>Robot awareness</source>
        <translation>注意机器人</translation>
    </message>
    <message>
        <source>Stops and looks while the robot is near, then walks on</source>
        <translation>机器人靠近时停下观看，然后继续行走</translation>
    </message>
    <message>
        <source>Stops within</source>
        <translation>停止距离</translation>
    </message>
    <message>
        <source>Follow a person</source>
        <translation>跟随行人</translation>
    </message>
    <message>
        <source>Follows another person for some time</source>
        <translation>跟随另一行人一段时间</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>行人</translation>
    </message>
    <message>
        <source>Starts within</source>
        <translation>开始距离</translation>
    </message>
    <message>
        <source>Keeps at</source>
        <translation>保持距离</translation>
    </message>
    <message>
        <source>Robot blocking</source>
        <translation>阻挡机器人</translation>
    </message>
    <message>
        <source>Steps into the path of the robot and stays there</source>
        <translation>走入机器人的路径并停在那里</translation>
    </message>
    <message>
        <source>Stands in front</source>
        <translation>站在前方</translation>
    </message>
    <message>
        <source>Walk together</source>
        <translation>结伴行走</translation>
    </message>
    <message>
        <source>Walks in a group with the nearest person</source>
        <translation>与最近的行人结伴行走</translation>
    </message>
    <message>
        <source>Answer a call</source>
        <translation>回应呼唤</translation>
    </message>
    <message>
        <source>Walks to a person who speaks and starts a conversation</source>
        <translation>走向说话的行人并开始交谈</translation>
    </message>
    <message>
        <source>Hears within</source>
        <translation>可听距离</translation>
    </message>
    <message>
        <source>Listens for</source>
        <translation>倾听时长</translation>
    </message>
    <message>
        <source>Approaches for</source>
        <translation>走近时长</translation>
    </message>
    <message>
        <source>Talks for</source>
        <translation>交谈时长</translation>
    </message>
    <message>
        <source>Answer a look</source>
        <translation>回应注视</translation>
    </message>
    <message>
        <source>Looks back at an observer and says something</source>
        <translation>回看观察者并说话</translation>
    </message>
    <message>
        <source>Looked at by</source>
        <translation>注视者</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>距离内</translation>
    </message>
    <message>
        <source>Waits for</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Says</source>
        <translation>说</translation>
    </message>
    <message>
        <source>Greeting</source>
        <translation>问候</translation>
    </message>
    <message>
        <source>Turns to the robot or a person in sight and greets</source>
        <translation>转向看到的机器人或行人并问候</translation>
    </message>
    <message>
        <source>Greets</source>
        <translation>问候</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>守护</translation>
    </message>
    <message>
        <source>Steps between the robot and a person that it approaches</source>
        <translation>站到机器人与它所靠近的行人之间</translation>
    </message>
    <message>
        <source>Guards</source>
        <translation>守护</translation>
    </message>
    <message>
        <source>Sees the robot</source>
        <translation>看到机器人</translation>
    </message>
    <message>
        <source>Sees people</source>
        <translation>看到行人</translation>
    </message>
    <message>
        <source>Robot nearer than</source>
        <translation>机器人近于</translation>
    </message>
    <message>
        <source>Blocks for</source>
        <translation>阻挡时长</translation>
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
        <source>Parameter tuning</source>
        <translation>参数整定</translation>
    </message>
    <message>
        <source>Share a study</source>
        <translation>共享研究</translation>
    </message>
    <message>
        <source>Leaderboard</source>
        <translation>排行榜</translation>
    </message>
    <message>
        <source>Find failures</source>
        <translation>查找失败</translation>
    </message>
    <message>
        <source>Tests on a build server</source>
        <translation>构建服务器上的测试</translation>
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
        <source>List of scenarios</source>
        <translation>场景列表</translation>
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
        <translation>次运行</translation>
    </message>
    <message>
        <source>Conditional breakpoint</source>
        <translation>条件断点</translation>
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
        <source>Enter text</source>
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
        <translation>运行记录</translation>
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
        <source>Another seed generates different people</source>
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
        <source>A tree can have only one root</source>
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
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Stop when the node starts to be ticked with this blackboard condition true, for example  id == 2:</source>
        <translation>当节点开始被 tick 且此黑板条件为真时停止，例如  id == 2：</translation>
    </message>
    <message>
        <source>A condition becomes true…</source>
        <translation>条件变为真时…</translation>
    </message>
    <message>
        <source>Discard the branches?</source>
        <translation>放弃分支？</translation>
    </message>
    <message>
        <source>The run and its branches (%1 runs in total) will be discarded.</source>
        <translation>运行及其分支（共 %1 个运行）将被放弃。</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
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
        <source>Random (Isaac Sim)</source>
        <translation>随机（Isaac Sim）</translation>
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
        <source>The scenario. The wheel zooms, the middle button or Space and drag move the map. The status bar shows what the mouse does with the active tool. During a run, click a person for details; right-click to push, stop or add people.</source>
        <translation>场景。滚轮缩放，鼠标中键或空格键加拖动可移动地图。状态栏说明当前工具的鼠标操作。运行期间，单击行人查看详情；右键单击可推动、停止或添加行人。</translation>
    </message>
    <message>
        <source>Runs scenarios with several planners and seeds and compares them with confidence intervals in a report. It also shows the results of tune, gate, sensitivity and search.</source>
        <translation>用多个规划器和种子运行场景，并在报告中用置信区间进行比较。还显示 tune、gate、sensitivity 和 search 的结果。</translation>
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
    <name>app::ContactNotes</name>
    <message>
        <source>Until here %1 could avoid the contact with %2 at %3 s: %4</source>
        <translation>在此之前 %1 可避免在 %3 s 与 %2 接触：%4</translation>
    </message>
</context>
<context>
    <name>app::CoverPage</name>
    <message>
        <source>Trees</source>
        <translation>行为树</translation>
    </message>
    <message>
        <source>Never reached</source>
        <translation>从未到达</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>行为树</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>使用者</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Reached nodes</source>
        <translation>到达的节点</translation>
    </message>
    <message>
        <source>Unreachable</source>
        <translation>不可到达</translation>
    </message>
    <message>
        <source>Nodes of the behaviour trees of people and of Nav2 that at least one run has executed. Unreachable: the structure of the tree excludes them.</source>
        <translation>至少有一次运行执行过的人员和 Nav2 行为树的节点。不可到达：树的结构将其排除。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>All nodes that can be reached were reached.</source>
        <translation>所有可到达的节点均已到达。</translation>
    </message>
    <message>
        <source>No run has executed a node of a behaviour tree.</source>
        <translation>没有运行执行过行为树的节点。</translation>
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
        <translation>结束原因</translation>
    </message>
    <message>
        <source>New nodes</source>
        <translation>新节点</translation>
    </message>
    <message>
        <source>Double-click a run to play it</source>
        <translation>双击运行可播放</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>Runs that executed nodes which no earlier run had executed. Double-click or Enter plays a run.</source>
        <translation>执行了此前任何运行都未执行过的节点的运行。双击或 Enter 播放运行。</translation>
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
        <source>Preparing the preview…</source>
        <translation>正在准备预览…</translation>
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
    <message>
        <source>Scenarios, maps, map images, packed studies (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg *.hnv)</source>
        <translation>场景、地图、地图图像、打包的研究 (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg *.hnv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
</context>
<context>
    <name>app::GatePage</name>
    <message>
        <source>Base and candidate: means of the runs with a value. Difference candidate − base: mean over the pairs with its interval, which holds at all numbers of pairs; one pair counts at most 10 margins. The scale has 4 margins at both ends; the dotted line is the margin.</source>
        <translation>基准和候选：有数值的运行的平均值。候选 − 基准的差值：各对的平均值及其区间，该区间对任意对数都成立；每对最多计 10 倍裕度。刻度两端为 4 倍裕度；虚线为裕度。</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>There is no pair in which only the candidate failed, and all metrics passed.</source>
        <translation>没有任何一对中仅候选失败，且所有指标均通过。</translation>
    </message>
    <message>
        <source>Pairs in which the candidate is worse</source>
        <translation>候选较差的运行对</translation>
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
        <source>Candidate</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>Double-click a pair to play the run of the candidate</source>
        <translation>双击一对可播放候选的运行</translation>
    </message>
    <message>
        <source>Runs in which only the candidate fails, then the largest losses by metrics that are not passed. Double-click or Enter plays the run of the candidate, the context menu also that of the base.</source>
        <translation>仅候选未成功的运行，其后是未通过指标中损失最大的运行。双击或 Enter 播放候选的运行，上下文菜单也可播放基准的运行。</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1，种子 %2</translation>
    </message>
    <message>
        <source>the candidate in %1</source>
        <translation>%1 中的候选</translation>
    </message>
    <message>
        <source>the base in %1</source>
        <translation>%1 中的基准</translation>
    </message>
    <message>
        <source>Play the candidate</source>
        <translation>播放候选</translation>
    </message>
    <message>
        <source>Play the base</source>
        <translation>播放基准</translation>
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
        <source>The goal is placed; now assign it. Press %1 for the route tool, click the person, then the goal, then press Enter.</source>
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
        <source>Press Space, or Play in the tool bar.</source>
        <translation>按空格键，或单击工具栏中的“播放”。</translation>
    </message>
    <message>
        <source>Click Metrics in the status bar at the bottom.</source>
        <translation>单击底部状态栏中的“指标”。</translation>
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
    <message>
        <source>Place a robot</source>
        <translation>放置机器人</translation>
    </message>
    <message>
        <source>Click on the map where the robot should drive to.</source>
        <translation>在地图上单击机器人要前往的位置。</translation>
    </message>
    <message>
        <source>Click on the map where the robot should start.</source>
        <translation>在地图上单击机器人的起点。</translation>
    </message>
    <message>
        <source>The robot needs a goal. Press %1 for the robot tool, click where it should start, then where it should drive to.</source>
        <translation>机器人需要目标点。按 %1 选择机器人工具，先单击起点，再单击要前往的位置。</translation>
    </message>
    <message>
        <source>Press %1 or click the robot tool.</source>
        <translation>按 %1 或单击机器人工具。</translation>
    </message>
    <message>
        <source>Person and robot move to their goals …</source>
        <translation>行人和机器人正前往各自的目标点 …</translation>
    </message>
    <message>
        <source>Click a metric with a value, such as Path length, to plot it over time.</source>
        <translation>单击有值的指标（例如路径长度），绘制其随时间变化的曲线。</translation>
    </message>
    <message>
        <source>Ctrl+R returns to editing, %1 finds every command, F1 opens the manual.</source>
        <translation>Ctrl+R 返回编辑，%1 查找所有命令，F1 打开手册。</translation>
    </message>
</context>
<context>
    <name>app::HistoryDialog</name>
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
    <message>
        <source>Memory for runs</source>
        <translation>运行内存</translation>
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
        <source>While you edit text, the text field handles all keys that it uses; number fields do not use Space. Enter accepts the text, Esc discards it; both return the keyboard focus to the map. Ctrl+Z undoes typing only while an edit is not accepted.</source>
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
    <message>
        <source>New</source>
        <translation>新建</translation>
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
    <name>app::OutputPage</name>
    <message>
        <source>points</source>
        <translation>个百分点</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>较差</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
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
        <source>Base</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>Candidate</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>裕度</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Pass: %1 is not worse than %2</source>
        <translation>通过：%1 不比 %2 差</translation>
    </message>
    <message>
        <source>Worse: %1 is worse than %2 in %3</source>
        <translation>较差：%1 在 %3 上比 %2 差</translation>
    </message>
    <message>
        <source>Undecided: %1 pairs do not show whether %2 is worse than %3</source>
        <translation>未定：%1 对运行无法表明 %2 是否比 %3 差</translation>
    </message>
    <message>
        <source>%1 (more than %2)</source>
        <translation>%1（大于 %2）</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Standstill</source>
        <translation>停滞</translation>
    </message>
    <message>
        <source>Navigation failed</source>
        <translation>导航失败</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>Run aborted</source>
        <translation>运行中断</translation>
    </message>
    <message>
        <source>person in front</source>
        <translation>人在前方</translation>
    </message>
    <message>
        <source>person on the left</source>
        <translation>人在左侧</translation>
    </message>
    <message>
        <source>person on the right</source>
        <translation>人在右侧</translation>
    </message>
    <message>
        <source>person behind</source>
        <translation>人在后方</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>no person near</source>
        <translation>附近无人</translation>
    </message>
    <message>
        <source>before the end of the run</source>
        <translation>在运行结束之前</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>run</source>
        <translation>次运行</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>次运行</translation>
    </message>
    <message>
        <source>kind of failure</source>
        <translation>种失败</translation>
    </message>
    <message>
        <source>kinds of failures</source>
        <translation>种失败</translation>
    </message>
    <message>
        <source>Contacts that the robot could not have avoided since first sight do not count: %1</source>
        <translation>自首次看见起机器人无法避免的接触（不计入）：%1</translation>
    </message>
    <message>
        <source>Runs that could not start: %1</source>
        <translation>无法启动的运行：%1</translation>
    </message>
    <message>
        <source>the confidence interval of %1 is wider than its index</source>
        <translation>%1 的置信区间比其指数还宽</translation>
    </message>
    <message>
        <source>about %1 points would be needed instead of %2</source>
        <translation>大约需要 %1 个点，而不是 %2 个</translation>
    </message>
    <message>
        <source>the order of %1 and %2 is not certain</source>
        <translation>%1 与 %2 的顺序不确定</translation>
    </message>
    <message>
        <source>%1 of the variance between points is due to the choice of seeds</source>
        <translation>点间方差的 %1 来自种子的选择</translation>
    </message>
    <message>
        <source>points without a value, which are excluded: %1</source>
        <translation>无值而被排除的点：%1</translation>
    </message>
    <message>
        <source>Confidence interval: %1 to %2</source>
        <translation>置信区间：%1 至 %2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>个参数</translation>
    </message>
    <message>
        <source>values</source>
        <translation>个参数</translation>
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
        <source>Morris screening: %1 trajectories, %2</source>
        <translation>Morris 筛选：%1 条轨迹，%2</translation>
    </message>
    <message>
        <source>Sobol indices: %1 base points, %2</source>
        <translation>Sobol 指数：%1 个基点，%2</translation>
    </message>
    <message>
        <source>success %1 before, %2 after</source>
        <translation>成功率之前 %1，之后 %2</translation>
    </message>
    <message>
        <source>none (before)</source>
        <translation>无（之前）</translation>
    </message>
    <message>
        <source>Improved: %1</source>
        <translation>已改进：%1</translation>
    </message>
    <message>
        <source>No improvement found: on new runs the best candidate is not clearly better: %1</source>
        <translation>未找到改进：在新的运行中最佳候选并无明显优势：%1</translation>
    </message>
    <message>
        <source>No improvement found: none of %1 candidates was better than the current values</source>
        <translation>未找到改进：%1 个候选均不优于当前值</translation>
    </message>
    <message>
        <source>%1 of %2 nodes of behaviour trees were reached in %3</source>
        <translation>在 %3 中到达了行为树的 %1 / %2 个节点</translation>
    </message>
    <message>
        <source>Nodes that cannot be reached: %1</source>
        <translation>不可到达的节点：%1</translation>
    </message>
    <message>
        <source>Nothing tried: the limit of runs (--runs) is too small</source>
        <translation>未尝试任何值：运行次数上限（--runs）太小</translation>
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
        <source>System language</source>
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
        <source>Takes effect at the next start.</source>
        <translation>下次启动时生效。</translation>
    </message>
    <message>
        <source>Animations
Without animations, the map changes immediately</source>
        <translation>动画
关闭后，地图立即变化</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation>用于存储时间轴可显示的运行步的内存。200 名行人每分钟约需 12 MB。</translation>
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
        <source>Copy interval</source>
        <translation>复制间隔</translation>
    </message>
    <message>
        <source>The longest time between a change and its copy</source>
        <translation>更改与其副本之间的最长时间</translation>
    </message>
    <message>
        <source>C&amp;opy interval</source>
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
        <source>Follow system</source>
        <translation>与桌面一致</translation>
    </message>
    <message>
        <source>Memory for runs</source>
        <translation>运行内存</translation>
    </message>
    <message>
        <source>&amp;Memory for runs</source>
        <translation>运行内存(&amp;M)</translation>
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
        <source>Hall zones</source>
        <translation>Hall 区域</translation>
    </message>
    <message>
        <source>Gaussian spaces</source>
        <translation>高斯空间</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触</translation>
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
        <source>Overlays</source>
        <translation>叠加层</translation>
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
    <message>
        <source>People per m² as colours</source>
        <translation>以颜色显示每平方米人数</translation>
    </message>
    <message>
        <source>Intimate, personal and social zone around each person, after E. T. Hall: 0.45, 1.2 and 3.6 m</source>
        <translation>每个行人周围的亲密、个人和社交区域（E. T. Hall）：0.45、1.2 和 3.6 m</translation>
    </message>
    <message>
        <source>Personal space of each person as a Gaussian function, longer in the walking direction</source>
        <translation>以高斯函数表示的每个行人的个人空间，在行走方向上更长</translation>
    </message>
    <message>
        <source>Velocity of each person and robot as an arrow</source>
        <translation>以箭头显示每个行人和机器人的速度</translation>
    </message>
    <message>
        <source>Forces on each person as arrows</source>
        <translation>以箭头显示作用于每个行人的力</translation>
    </message>
    <message>
        <source>Places where people or robots touched</source>
        <translation>行人或机器人发生接触的位置</translation>
    </message>
    <message>
        <source>Marks each trajectory with the time at this interval; 0: no marks</source>
        <translation>按此间隔在每条轨迹上标出时间；0：不标</translation>
    </message>
    <message>
        <source>Height
The lowest value, “automatic”, is the height that the map needs at this width</source>
        <translation>高度
最小值“自动”是地图在此宽度下所需的高度</translation>
    </message>
    <message>
        <source>Names of people and robots</source>
        <translation>行人和机器人的名称</translation>
    </message>
    <message>
        <source>Recorded runs contain no forces: run the scenario to show them</source>
        <translation>已记录的运行不含力：请运行场景以显示</translation>
    </message>
    <message>
        <source>Only a run has this: run the scenario first</source>
        <translation>仅运行时才有：请先运行场景</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: %1</source>
        <translation>无法绘制图片：%1</translation>
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
        <source>Loop section</source>
        <translation>循环片段</translation>
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
        <source>The end must be after the start</source>
        <translation>结束时间必须晚于开始时间</translation>
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
        <source>From the start to the end of the run</source>
        <translation>从运行开始到结束</translation>
    </message>
    <message>
        <source>Only the section that the timeline repeats</source>
        <translation>仅时间轴循环的片段</translation>
    </message>
    <message>
        <source>Frames per second of the film; GIF viewers show at most %1</source>
        <translation>影片每秒帧数；GIF 查看器最多显示 %1</translation>
    </message>
    <message>
        <source>Frames per second of the film</source>
        <translation>影片每秒帧数</translation>
    </message>
    <message>
        <source>The film has %1 frames and lasts %2 s</source>
        <translation>影片共 %1 帧，时长 %2 s</translation>
    </message>
    <message>
        <source>Map, 1280 px wide</source>
        <translation>地图，宽 1280 px</translation>
    </message>
    <message>
        <source>Small map, 640 px wide</source>
        <translation>小地图，宽 640 px</translation>
    </message>
</context>
<context>
    <name>app::SavePictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
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
        <source>Slide, 16 : 9</source>
        <translation>幻灯片，16 : 9</translation>
    </message>
    <message>
        <source>PNG – pixel graphics</source>
        <translation>PNG – 像素图</translation>
    </message>
    <message>
        <source>SVG – vector graphics</source>
        <translation>SVG – 矢量图</translation>
    </message>
    <message>
        <source>PDF – vector graphics</source>
        <translation>PDF – 矢量图</translation>
    </message>
    <message>
        <source>Paper, two columns: 170 mm</source>
        <translation>论文，双栏：170 mm</translation>
    </message>
    <message>
        <source>Paper, one column: 85 mm</source>
        <translation>论文，单栏：85 mm</translation>
    </message>
    <message>
        <source>Screen, 1600 × 1000</source>
        <translation>屏幕，1600 × 1000</translation>
    </message>
    <message>
        <source>Slide, 1920 × 1080</source>
        <translation>幻灯片，1920 × 1080</translation>
    </message>
    <message>
        <source>Paper, two columns: 170 mm, 300 dpi</source>
        <translation>论文，双栏：170 mm，300 dpi</translation>
    </message>
    <message>
        <source>Paper, one column: 85 mm, 300 dpi</source>
        <translation>论文，单栏：85 mm，300 dpi</translation>
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
    <name>app::SearchPage</name>
    <message>
        <source>Failures</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>No run failed.</source>
        <translation>没有运行失败。</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>档案</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Found in</source>
        <translation>发现于</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>结束原因</translation>
    </message>
    <message>
        <source>End [s]</source>
        <translation>结束 [s]</translation>
    </message>
    <message>
        <source>Remaining changes</source>
        <translation>剩余更改</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>可重复</translation>
    </message>
    <message>
        <source>Double-click a failure to play it</source>
        <translation>双击失败可播放</translation>
    </message>
    <message>
        <source>One failure of each kind, with the fewest people and changes that still fail in the same way. Double-click or Enter plays it; its scenario is in the folder failures.</source>
        <translation>每种类型一个失败，保留仍以同样方式失败的最少人数和更改。双击或 Enter 播放；其场景位于文件夹 failures 中。</translation>
    </message>
    <message>
        <source>Worst run</source>
        <translation>最差运行</translation>
    </message>
    <message>
        <source>The run with the worst value of the metric. Double-click or Enter plays it.</source>
        <translation>指标值最差的运行。双击或 Enter 播放。</translation>
    </message>
    <message>
        <source>Worst run: %1 = %2</source>
        <translation>最差运行：%1 = %2</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
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
        <source>The scenario has the same end and metrics, bit for bit</source>
        <translation>该场景的结局和指标逐位相同</translation>
    </message>
    <message>
        <source>The scenario does not reproduce the run</source>
        <translation>该场景不能重复此运行</translation>
    </message>
    <message>
        <source>The limit of runs was reached before the scenario was minimal</source>
        <translation>在场景缩至最小之前已达到运行次数上限</translation>
    </message>
    <message>
        <source>The archive is empty: no run was simulated.</source>
        <translation>档案为空：没有模拟任何运行。</translation>
    </message>
    <message>
        <source>The best run in each cell. To the right: %1, upwards: %2; titles are the lower ends of the cells. Darker cells have a better run for the search; a dot marks a failure, and a double-click plays the failure of its kind.</source>
        <translation>每个单元格中的最佳运行。向右：%1，向上：%2；标题为单元格的下限。颜色越深，对搜索而言运行越好；圆点表示失败，双击播放该类型的失败。</translation>
    </message>
    <message>
        <source>%1, seed %2: %3</source>
        <translation>%1，种子 %2：%3</translation>
    </message>
</context>
<context>
    <name>app::SensitivityPage</name>
    <message>
        <source>μ*–σ plot</source>
        <translation>μ* 与 σ 平面</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要性</translation>
    </message>
    <message>
        <source>No metric varies in this study.</source>
        <translation>此研究中没有指标变化。</translation>
    </message>
    <message>
        <source>Uncertain results</source>
        <translation>不确定的结果</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>情形</translation>
    </message>
    <message>
        <source>Scenario and listed values</source>
        <translation>场景和列表中的值</translation>
    </message>
    <message>
        <source>μ*: mean size of the change of the metric if the value goes from one end of its range to the other. σ: standard deviation of these changes; on the dashed lines it is 0.1, 0.5 and 1 times μ*. Lines on the bars: bootstrap confidence intervals (%1).</source>
        <translation>μ*：参数从范围一端变到另一端时指标变化的平均大小。σ：这些变化的标准差；在虚线上为 μ* 的 0.1、0.5 和 1 倍。条形上的线：自助法置信区间（%1）。</translation>
    </message>
    <message>
        <source>Total: share of the variance of the metric that is due to the value and its interactions; first order (dark): due to the value alone. Lines on the bars: bootstrap confidence intervals (%1).</source>
        <translation>总效应：指标方差中由该参数及其交互作用引起的份额；一阶（深色）：仅由该参数引起。条形上的线：自助法置信区间（%1）。</translation>
    </message>
    <message>
        <source>Metrics that do not vary: %1</source>
        <translation>不变化的指标：%1</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>μ*</source>
        <translation>μ*</translation>
    </message>
    <message>
        <source>μ</source>
        <translation>μ</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>效应数</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>总效应</translation>
    </message>
    <message>
        <source>First order</source>
        <translation>一阶</translation>
    </message>
    <message>
        <source>Share of the bootstrap resamples in which the value is before the next one</source>
        <translation>该参数排在下一个之前的自助重采样份额</translation>
    </message>
    <message>
        <source>does not vary</source>
        <translation>不变化</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1: μ* %2, σ %3</source>
        <translation>%1：μ* %2，σ %3</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>All results are certain: points and seeds suffice.</source>
        <translation>所有结果都确定：点和种子足够。</translation>
    </message>
    <message>
        <source>More points or seeds make these results certain.</source>
        <translation>更多的点或种子可使这些结果确定。</translation>
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
    <message>
        <source>Goal not reached</source>
        <translation>未到达目标点</translation>
    </message>
    <message>
        <source>Goal reached</source>
        <translation>已到达目标点</translation>
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
        <source>Save %1 before the start: it has unsaved changes</source>
        <translation>开始前请保存 %1：它有未保存的更改</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 有未保存的更改。</translation>
    </message>
    <message>
        <source>Open an experiment, or the results of tune, gate, sensitivity or search</source>
        <translation>打开实验，或 tune、gate、sensitivity、search 的结果</translation>
    </message>
    <message>
        <source>Results are shown: New begins a study</source>
        <translation>正在显示结果：“新建”可开始研究</translation>
    </message>
    <message>
        <source>Studies (*.yaml *.yml tune.json gate.json sensitivity.json archive.json)</source>
        <translation>研究 (*.yaml *.yml tune.json gate.json sensitivity.json archive.json)</translation>
    </message>
    <message>
        <source>Replaying %1…</source>
        <translation>正在重放 %1…</translation>
    </message>
    <message>
        <source>%1 has changed since the study ran</source>
        <translation>%1 在研究运行之后已更改</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>报告已写入 %1</translation>
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
        <translation>运行记录</translation>
    </message>
    <message>
        <source>Choose scenarios and planners on the left, then press Start.
For each seed, all planners run with the same people.</source>
        <translation>在左侧选择场景和规划器，然后按“开始”。
对于每个种子，所有规划器都与相同的行人一起运行。</translation>
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
    <message>
        <source>Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one scale per column. Rates: Wilson; other metrics: bootstrap (BCa). n: runs that have a value, if not all have one. Success: the robot reached its goal in time, without contact with people or obstacles.</source>
        <translation>已完成运行的均值 [95 % 置信区间]。条形：相同的区间，每列使用同一比例尺。比率：Wilson；其他指标：bootstrap (BCa)。n：有值的运行数（若并非全部有值）。成功：机器人按时到达目标点，且未与人或障碍物接触。</translation>
    </message>
    <message>
        <source> (n = %1)</source>
        <translation> (n = %1)</translation>
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
    <name>app::TunePage</name>
    <message>
        <source>Evaluation</source>
        <translation>评估</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>No candidate was better in the search, so none was evaluated on new runs.</source>
        <translation>搜索中没有更好的候选，因此未在新的运行中评估。</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>相对</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>After − before with 95 % intervals, on runs that the search has not seen, paired by scenario and seed. Pairs in which a run failed are excluded from the objectives.</source>
        <translation>之后 − 之前及 95 % 区间，基于搜索未见过的运行，按场景和种子配对。含失败运行的对不计入目标。</translation>
    </message>
    <message>
        <source>%1: all seeds have the same results, so its runs are not independent.</source>
        <translation>%1：所有种子的结果相同，因此其运行不独立。</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>points</source>
        <translation>个百分点</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>在文件中</translation>
    </message>
    <message>
        <source>Effect on the score</source>
        <translation>对得分的影响</translation>
    </message>
    <message>
        <source>Effect on %1</source>
        <translation>对 %1 的影响</translation>
    </message>
    <message>
        <source>Effect on the score: what is lost without the change. Effects on metrics: with the change − without it, with 95 % intervals, on runs of the search. Changes that lose nothing when they are reverted together are not in the tuned file.</source>
        <translation>对得分的影响：没有该更改时的损失。对指标的影响：有更改 − 无更改，含 95 % 区间，基于搜索的运行。一起撤销而无损失的更改不在调好的文件中。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1, logarithmic</source>
        <translation>%1，对数</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>未更改</translation>
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
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Candidates on the front</source>
        <translation>前沿上的候选</translation>
    </message>
    <message>
        <source>%1 [%]</source>
        <translation>%1 [%]</translation>
    </message>
    <message>
        <source>Changed values</source>
        <translation>更改的值</translation>
    </message>
    <message>
        <source>Pareto-optimal candidates in the runs of the search, relative to the current values. The best of many candidates is selected, so these values are optimistic on average.</source>
        <translation>搜索运行中的帕累托最优候选，相对于当前值。由于从许多候选中选出最佳者，这些值平均而言偏乐观。</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>选定</translation>
    </message>
    <message>
        <source>Pareto front</source>
        <translation>帕累托前沿</translation>
    </message>
    <message>
        <source>The file is unchanged.</source>
        <translation>文件未更改。</translation>
    </message>
    <message>
        <source>From the current file to the tuned one.</source>
        <translation>从当前文件到调好的文件。</translation>
    </message>
    <message>
        <source>From the current file to the best candidate, which is not used: the tuned file is unchanged.</source>
        <translation>从当前文件到最佳候选，后者未被采用：调好的文件没有更改。</translation>
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
        <source>Positions of people and of the robots, as estimated by the robots in a run</source>
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
    <message>
        <source>Open a recorded run or the results of a study: the output folder of a command</source>
        <translation>打开已录制的运行或研究的结果：命令的输出文件夹</translation>
    </message>
    <message>
        <source>&amp;Memory for runs…</source>
        <translation>运行内存(&amp;M)…</translation>
    </message>
    <message>
        <source>Set the memory for the recorded steps of a run</source>
        <translation>设置运行记录步骤所用的内存</translation>
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
        <source>Continue the run from the displayed step with changes: another planner, other positions, another seed; the run itself is kept</source>
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
    <message>
        <source>The branch repeats the run up to %1 and pauses there.</source>
        <translation>分支将运行重复到 %1 并在该处暂停。</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>No changes yet: the branch will be identical to the displayed run.</source>
        <translation>尚无更改：该分支将与所示运行相同。</translation>
    </message>
    <message>
        <source>Changes: %1</source>
        <translation>更改：%1</translation>
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
    <message>
        <source>Start a run to branch from it or to compare it with recorded runs.</source>
        <translation>启动一个运行，以便从中创建分支或与已记录的运行进行比较。</translation>
    </message>
    <message>
        <source>Values of whole runs</source>
        <translation>完整运行的值</translation>
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
    <message>
        <source>No issues. A recorded run is shown.</source>
        <translation>没有问题。正在显示录制的运行。</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>个机器人</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>个机器人</translation>
    </message>
    <message>
        <source>No issues: %1.</source>
        <translation>没有问题：%1。</translation>
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
    <message>
        <source>Map around %1</source>
        <translation>%1 周围的地图</translation>
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
    <name>editor::MetricPlot</name>
    <message>
        <source>Curve: %1</source>
        <translation>曲线：%1</translation>
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
    <message>
        <source>%1 needs a robot: press B, then click its start and its goal.</source>
        <translation>%1 需要机器人：按 B，然后单击其起点和目标点。</translation>
    </message>
    <message>
        <source>%1 has no value: %2</source>
        <translation>%1 没有值：%2</translation>
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
    <message>
        <source>needs a robot</source>
        <translation>需要机器人</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>The value from the start of the run to the shown time</source>
        <translation>从运行开始到所示时刻的值</translation>
    </message>
    <message>
        <source>The curve of the values per step, or of the values since the start if the metric has none per step</source>
        <translation>每步值的曲线；若指标没有每步值，则为自开始以来的值的曲线</translation>
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
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show changed and unchanged values</source>
        <translation>显示已更改和未更改的值</translation>
    </message>
    <message>
        <source>No changed values</source>
        <translation>没有已更改的值</translation>
    </message>
    <message>
        <source>No changed values match the filter</source>
        <translation>没有与筛选条件匹配的已更改值</translation>
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
    <message>
        <source>must be %1</source>
        <translation>必须为 %1</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>not a number; must be %1</source>
        <translation>不是数字；必须为 %1</translation>
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
    <message>
        <source>Return to editing</source>
        <translation>返回编辑</translation>
    </message>
    <message>
        <source>End the run; the scenario can be edited again</source>
        <translation>结束运行；可以再次编辑场景</translation>
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
        <source>Choose the parameter file and view or change all parameters</source>
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
        <source>%1 m, surface to surface</source>
        <translation>%1 m，表面到表面</translation>
    </message>
    <message>
        <source>Distance between the bodies, not their centres, as in the metrics</source>
        <translation>物体表面之间（而非中心之间）的距离，与指标一致</translation>
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
        <translation>运行记录</translation>
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
    <message>
        <source>Add a recorded run to compare: the output folder of hunavsim run</source>
        <translation>添加要比较的已录制运行：hunavsim run 的输出文件夹</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1，来自 %2</translation>
    </message>
    <message>
        <source>%1 ended at %2 s</source>
        <translation>%1 于 %2 秒结束</translation>
    </message>
    <message>
        <source>ended at %1 s</source>
        <translation>于 %1 秒结束</translation>
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
        <source>Scenario card</source>
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
    <name>editor::SideView</name>
    <message>
        <source>ended at %1 s</source>
        <translation>于 %1 秒结束</translation>
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
        <translation>未使用：%1</translation>
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
    <message>
        <source>Use entry</source>
        <translation>使用条目</translation>
    </message>
    <message>
        <source>Use number</source>
        <translation>使用数值</translation>
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
