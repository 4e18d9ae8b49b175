<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>option labels</name>
        <message>
            <source>Checkpoint</source>
            <translation>检查点</translation>
        </message>
        <message>
            <source>Bark</source>
            <translation>树皮</translation>
        </message>
        <message>
            <source>Extent</source>
            <translation>范围</translation>
        </message>
        <message>
            <source>Match distance</source>
            <translation>匹配距离</translation>
        </message>
        <message>
            <source>DBH gate</source>
            <translation>胸径差上限</translation>
        </message>
        <message>
            <source>Class width</source>
            <translation>径阶宽度</translation>
        </message>
        <message>
            <source>Distance step</source>
            <translation>距离环宽度</translation>
        </message>
        <message>
            <source>Align stems</source>
            <translation>单木对齐方式</translation>
        </message>
        <message>
            <source>Columns</source>
            <translation>列</translation>
        </message>
        <message>
            <source>Rows</source>
            <translation>参与的行</translation>
        </message>
        <message>
            <source>Rows</source>
            <comment>steering.simulate</comment>
            <translation>线数</translation>
        </message>
        <message>
            <source>Reference columns</source>
            <translation>参考数据的列</translation>
        </message>
        <message>
            <source>Reference rows</source>
            <translation>参考数据的行</translation>
        </message>
        <message>
            <source>Align trajectory</source>
            <translation>轨迹对齐方式</translation>
        </message>
        <message>
            <source>Max time gap</source>
            <translation>最大时间间隔</translation>
        </message>
        <message>
            <source>Rpe step</source>
            <translation>相对位姿误差的时间步长</translation>
        </message>
        <message>
            <source>Rpe distance</source>
            <translation>相对位姿误差的距离</translation>
        </message>
        <message>
            <source>Segment</source>
            <translation>轨迹段长</translation>
        </message>
        <message>
            <source>Loop radius</source>
            <translation>回环半径</translation>
        </message>
        <message>
            <source>Loop path</source>
            <translation>回环最小行程</translation>
        </message>
        <message>
            <source>Loop shift</source>
            <translation>回环位置误差上限</translation>
        </message>
        <message>
            <source>Loop turn</source>
            <translation>回环旋转误差上限</translation>
        </message>
        <message>
            <source>Published plot</source>
            <translation>已发表的样地</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>方向</translation>
        </message>
        <message>
            <source>Direction</source>
            <comment>geo.project</comment>
            <translation>换算方向</translation>
        </message>
        <message>
            <source>Direction</source>
            <comment>rows.from_stems</comment>
            <translation>行向</translation>
        </message>
        <message>
            <source>Direction</source>
            <comment>rows.hedges</comment>
            <translation>行向</translation>
        </message>
        <message>
            <source>Plane</source>
            <translation>投影平面</translation>
        </message>
        <message>
            <source>Ellipsoid</source>
            <translation>椭球</translation>
        </message>
        <message>
            <source>Zone</source>
            <translation>带号</translation>
        </message>
        <message>
            <source>South</source>
            <translation>南半球</translation>
        </message>
        <message>
            <source>Zone prefix</source>
            <translation>东坐标带号前缀</translation>
        </message>
        <message>
            <source>Central meridian</source>
            <translation>中央子午线</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>尺度比</translation>
        </message>
        <message>
            <source>False easting</source>
            <translation>东偏移</translation>
        </message>
        <message>
            <source>False northing</source>
            <translation>北偏移</translation>
        </message>
        <message>
            <source>Latitude of origin</source>
            <translation>原点纬度</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>方法</translation>
        </message>
        <message>
            <source>Cell</source>
            <translation>格网大小</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>随机数种子</translation>
        </message>
        <message>
            <source>Seed</source>
            <comment>ground.model</comment>
            <translation>起始格网大小</translation>
        </message>
        <message>
            <source>Max slope</source>
            <translation>最大坡度</translation>
        </message>
        <message>
            <source>Max angle</source>
            <translation>最大角度</translation>
        </message>
        <message>
            <source>Max angle</source>
            <comment>steering.errors</comment>
            <translation>最大夹角</translation>
        </message>
        <message>
            <source>Max distance</source>
            <translation>最大距离</translation>
        </message>
        <message>
            <source>Roughness</source>
            <translation>起伏</translation>
        </message>
        <message>
            <source>Roughness</source>
            <comment>ground.model</comment>
            <translation>粗糙度</translation>
        </message>
        <message>
            <source>Roughness</source>
            <comment>steering.simulate</comment>
            <translation>地面不平引起的倾斜</translation>
        </message>
        <message>
            <source>Roughness</source>
            <comment>steering.tune</comment>
            <translation>地面不平引起的倾斜</translation>
        </message>
        <message>
            <source>Band</source>
            <translation>点带高度</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>容差</translation>
        </message>
        <message>
            <source>Noise depth</source>
            <translation>低噪点深度</translation>
        </message>
        <message>
            <source>Fill distance</source>
            <translation>填补距离</translation>
        </message>
        <message>
            <source>Keep classes</source>
            <translation>保留类别</translation>
        </message>
        <message>
            <source>Form sd</source>
            <translation>干形标准差</translation>
        </message>
        <message>
            <source>File</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>Up</source>
            <translation>向上的轴</translation>
        </message>
        <message>
            <source>Axes</source>
            <translation>坐标系</translation>
        </message>
        <message>
            <source>Delimiter</source>
            <translation>分隔符</translation>
        </message>
        <message>
            <source>Drop withheld</source>
            <translation>舍去 withheld 点</translation>
        </message>
        <message>
            <source>Skip lines</source>
            <translation>跳过的行数</translation>
        </message>
        <message>
            <source>Sensor</source>
            <translation>传感器</translation>
        </message>
        <message>
            <source>Min range</source>
            <translation>最小距离</translation>
        </message>
        <message>
            <source>Min range</source>
            <comment>slam.run</comment>
            <translation>配准最小距离</translation>
        </message>
        <message>
            <source>Max range</source>
            <translation>最大距离</translation>
        </message>
        <message>
            <source>Max range</source>
            <comment>slam.run</comment>
            <translation>配准最大距离</translation>
        </message>
        <message>
            <source>Cut angle</source>
            <translation>分帧方位角</translation>
        </message>
        <message>
            <source>Keep partial frames</source>
            <translation>保留不完整的帧</translation>
        </message>
        <message>
            <source>Laser heights</source>
            <translation>激光器高度</translation>
        </message>
        <message>
            <source>Port</source>
            <translation>端口</translation>
        </message>
        <message>
            <source>Frame period</source>
            <translation>帧间隔</translation>
        </message>
        <message>
            <source>Rings</source>
            <translation>线数</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>格式</translation>
        </message>
        <message>
            <source>Min quality</source>
            <translation>最低定位质量</translation>
        </message>
        <message>
            <source>Gap</source>
            <translation>时间间断</translation>
        </message>
        <message>
            <source>Title</source>
            <translation>标题</translation>
        </message>
        <message>
            <source>Figure width</source>
            <translation>图件宽度</translation>
        </message>
        <message>
            <source>Dpi</source>
            <translation>分辨率</translation>
        </message>
        <message>
            <source>Point budget</source>
            <translation>点数上限</translation>
        </message>
        <message>
            <source>Backend</source>
            <translation>绘图后端</translation>
        </message>
        <message>
            <source>Tables</source>
            <translation>表格</translation>
        </message>
        <message>
            <source>Tables</source>
            <comment>report.plot</comment>
            <translation>写出表格</translation>
        </message>
        <message>
            <source>Cloud</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>Cloud</source>
            <comment>report.plot</comment>
            <translation>写出点云</translation>
        </message>
        <message>
            <source>Figure set</source>
            <translation>图件范围</translation>
        </message>
        <message>
            <source>Figures</source>
            <translation>图件</translation>
        </message>
        <message>
            <source>Hero</source>
            <translation>封面图</translation>
        </message>
        <message>
            <source>Vector figures</source>
            <translation>矢量图件</translation>
        </message>
        <message>
            <source>Page</source>
            <translation>报告页面</translation>
        </message>
        <message>
            <source>Edits</source>
            <translation>编辑</translation>
        </message>
        <message>
            <source>Reach</source>
            <translation>范围</translation>
        </message>
        <message>
            <source>Reach</source>
            <comment>rows.edit</comment>
            <translation>收入离群植株的距离</translation>
        </message>
        <message>
            <source>Reach</source>
            <comment>rows.trunks</comment>
            <translation>搜索范围</translation>
        </message>
        <message>
            <source>Angle tolerance</source>
            <translation>角度容差</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>直线拟合</translation>
        </message>
        <message>
            <source>Plant spacing</source>
            <translation>株距</translation>
        </message>
        <message>
            <source>Row spacing</source>
            <translation>行距</translation>
        </message>
        <message>
            <source>Max gap</source>
            <translation>最大连续缺株数</translation>
        </message>
        <message>
            <source>Min plants</source>
            <translation>最少株数</translation>
        </message>
        <message>
            <source>Lateral tolerance</source>
            <translation>横向容差</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>形状</translation>
        </message>
        <message>
            <source>Min row spacing</source>
            <translation>最小行距</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>宽度</translation>
        </message>
        <message>
            <source>Width</source>
            <comment>rows.hedges</comment>
            <translation>窗口宽度</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>步长</translation>
        </message>
        <message>
            <source>Step</source>
            <comment>rows.hedges</comment>
            <translation>分段长度</translation>
        </message>
        <message>
            <source>Min points</source>
            <translation>最少点数</translation>
        </message>
        <message>
            <source>Min share</source>
            <translation>最小峰值比例</translation>
        </message>
        <message>
            <source>Roll</source>
            <translation>横滚角</translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation>俯仰角</translation>
        </message>
        <message>
            <source>Yaw</source>
            <translation>航向角</translation>
        </message>
        <message>
            <source>Bandwidth</source>
            <translation>带宽</translation>
        </message>
        <message>
            <source>X</source>
            <translation>中心 x</translation>
        </message>
        <message>
            <source>X</source>
            <comment>rows.place</comment>
            <translation>传感器东坐标</translation>
        </message>
        <message>
            <source>Y</source>
            <translation>中心 y</translation>
        </message>
        <message>
            <source>Y</source>
            <comment>rows.place</comment>
            <translation>传感器北坐标</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>半径</translation>
        </message>
        <message>
            <source>Min neighbours</source>
            <translation>最少邻点数</translation>
        </message>
        <message>
            <source>Min x</source>
            <translation>最小 x</translation>
        </message>
        <message>
            <source>Max x</source>
            <translation>最大 x</translation>
        </message>
        <message>
            <source>Min y</source>
            <translation>最小 y</translation>
        </message>
        <message>
            <source>Max y</source>
            <translation>最大 y</translation>
        </message>
        <message>
            <source>Min z</source>
            <translation>最小 z</translation>
        </message>
        <message>
            <source>Max z</source>
            <translation>最大 z</translation>
        </message>
        <message>
            <source>Sector</source>
            <translation>扇区宽度</translation>
        </message>
        <message>
            <source>Sensor height</source>
            <translation>传感器高度</translation>
        </message>
        <message>
            <source>Max local slope</source>
            <translation>最大局部坡度</translation>
        </message>
        <message>
            <source>Max general slope</source>
            <translation>最大总体坡度</translation>
        </message>
        <message>
            <source>Height threshold</source>
            <translation>高差阈值</translation>
        </message>
        <message>
            <source>Reset distance</source>
            <translation>重置距离</translation>
        </message>
        <message>
            <source>Layer height</source>
            <translation>层高</translation>
        </message>
        <message>
            <source>Max extent x</source>
            <translation>x 方向最大宽度</translation>
        </message>
        <message>
            <source>Max extent y</source>
            <translation>y 方向最大宽度</translation>
        </message>
        <message>
            <source>Min layers</source>
            <translation>最少层数</translation>
        </message>
        <message>
            <source>Min ahead</source>
            <translation>最小前方距离</translation>
        </message>
        <message>
            <source>Centre</source>
            <translation>中心</translation>
        </message>
        <message>
            <source>Range sigma</source>
            <translation>测距标准差</translation>
        </message>
        <message>
            <source>Min diameter</source>
            <translation>最小直径</translation>
        </message>
        <message>
            <source>Min height</source>
            <translation>最小高度</translation>
        </message>
        <message>
            <source>Min filled</source>
            <translation>最小充满比例</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>体素边长</translation>
        </message>
        <message>
            <source>Preset</source>
            <translation>预设</translation>
        </message>
        <message>
            <source>Trajectory</source>
            <translation>轨迹</translation>
        </message>
        <message>
            <source>Features</source>
            <translation>特征</translation>
        </message>
        <message>
            <source>Occlusion</source>
            <translation>遮挡处理</translation>
        </message>
        <message>
            <source>Occlusion step</source>
            <translation>遮挡距离差</translation>
        </message>
        <message>
            <source>Query spacing</source>
            <translation>待配准点间距</translation>
        </message>
        <message>
            <source>Map spacing</source>
            <translation>关键帧点间距</translation>
        </message>
        <message>
            <source>First guess</source>
            <translation>初始估计</translation>
        </message>
        <message>
            <source>Deskew</source>
            <translation>运动畸变校正</translation>
        </message>
        <message>
            <source>Iterations</source>
            <translation>迭代次数</translation>
        </message>
        <message>
            <source>Neighbour keyframes</source>
            <translation>局部地图关键帧数</translation>
        </message>
        <message>
            <source>Local map</source>
            <translation>局部地图</translation>
        </message>
        <message>
            <source>Keyframe distance</source>
            <translation>关键帧距离</translation>
        </message>
        <message>
            <source>Keyframe angle</source>
            <translation>关键帧角度</translation>
        </message>
        <message>
            <source>Loops</source>
            <translation>回环</translation>
        </message>
        <message>
            <source>Context search</source>
            <translation>相似地点的选择</translation>
        </message>
        <message>
            <source>Loop registration</source>
            <translation>回环配准</translation>
        </message>
        <message>
            <source>Loop overlap</source>
            <translation>回环重叠比例</translation>
        </message>
        <message>
            <source>Weights</source>
            <translation>权</translation>
        </message>
        <message>
            <source>Solve</source>
            <translation>求解方式</translation>
        </message>
        <message>
            <source>Refine iterations</source>
            <translation>最终平差迭代次数</translation>
        </message>
        <message>
            <source>Angle sigma</source>
            <translation>角度标准差</translation>
        </message>
        <message>
            <source>Kernel sigmas</source>
            <translation>核函数尺度</translation>
        </message>
        <message>
            <source>Continuity sigma</source>
            <translation>连续性标准差</translation>
        </message>
        <message>
            <source>Continuity sigma angle</source>
            <translation>连续性角度标准差</translation>
        </message>
        <message>
            <source>Lost overlap</source>
            <translation>失败重叠比例</translation>
        </message>
        <message>
            <source>Lost frames</source>
            <translation>丢失帧数</translation>
        </message>
        <message>
            <source>Min observability</source>
            <translation>最小可观测性</translation>
        </message>
        <message>
            <source>Max speed</source>
            <translation>最大速度</translation>
        </message>
        <message>
            <source>Loop drift</source>
            <translation>回环漂移比例</translation>
        </message>
        <message>
            <source>Context rings</source>
            <translation>Scan Context 环数</translation>
        </message>
        <message>
            <source>Context sectors</source>
            <translation>Scan Context 扇区数</translation>
        </message>
        <message>
            <source>Context range</source>
            <translation>Scan Context 半径</translation>
        </message>
        <message>
            <source>Context tau</source>
            <translation>Scan Context 差异上限</translation>
        </message>
        <message>
            <source>Context candidates</source>
            <translation>Scan Context 候选数</translation>
        </message>
        <message>
            <source>Dense map</source>
            <translation>稠密地图</translation>
        </message>
        <message>
            <source>Map min range</source>
            <translation>地图最小距离</translation>
        </message>
        <message>
            <source>Map max range</source>
            <translation>地图最大距离</translation>
        </message>
        <message>
            <source>Map voxel</source>
            <translation>地图体素</translation>
        </message>
        <message>
            <source>Map points per voxel</source>
            <translation>每体素点数</translation>
        </message>
        <message>
            <source>Map max points</source>
            <translation>地图最大点数</translation>
        </message>
        <message>
            <source>Pass radius</source>
            <translation>分趟半径</translation>
        </message>
        <message>
            <source>Trajectory rate</source>
            <translation>轨迹频率</translation>
        </message>
        <message>
            <source>Row width</source>
            <translation>线间距</translation>
        </message>
        <message>
            <source>Run in</source>
            <translation>起始不测距离</translation>
        </message>
        <message>
            <source>Run out</source>
            <translation>末尾不测距离</translation>
        </message>
        <message>
            <source>Min length</source>
            <translation>最小行程长度</translation>
        </message>
        <message>
            <source>Speed step km h</source>
            <translation>速度分组步长 (km/h)</translation>
        </message>
        <message>
            <source>Speeds</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>Repeats</source>
            <translation>重复次数</translation>
        </message>
        <message>
            <source>Measured length</source>
            <translation>测量长度</translation>
        </message>
        <message>
            <source>Start offset</source>
            <translation>起始偏距</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>预瞄距离</translation>
        </message>
        <message>
            <source>Gain p</source>
            <translation>增益 P</translation>
        </message>
        <message>
            <source>Gain i</source>
            <translation>增益 I</translation>
        </message>
        <message>
            <source>Gain d</source>
            <translation>增益 D</translation>
        </message>
        <message>
            <source>Approach angle</source>
            <translation>接近角</translation>
        </message>
        <message>
            <source>Max command</source>
            <translation>最大指令轮角</translation>
        </message>
        <message>
            <source>Integral zone</source>
            <translation>积分区</translation>
        </message>
        <message>
            <source>Integral limit</source>
            <translation>积分上限</translation>
        </message>
        <message>
            <source>Rate</source>
            <translation>频率</translation>
        </message>
        <message>
            <source>White noise</source>
            <translation>白噪声</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>漂移</translation>
        </message>
        <message>
            <source>Drift time</source>
            <translation>漂移相关时间</translation>
        </message>
        <message>
            <source>Jumps per hour</source>
            <translation>每小时跳变次数</translation>
        </message>
        <message>
            <source>Jump size</source>
            <translation>跳变幅度</translation>
        </message>
        <message>
            <source>Jump time</source>
            <translation>跳变衰减时间</translation>
        </message>
        <message>
            <source>Outages per hour</source>
            <translation>每小时失锁次数</translation>
        </message>
        <message>
            <source>Outage length</source>
            <translation>失锁时长</translation>
        </message>
        <message>
            <source>Heading noise</source>
            <translation>航向噪声</translation>
        </message>
        <message>
            <source>Tilt noise</source>
            <translation>倾斜噪声</translation>
        </message>
        <message>
            <source>Antenna forward</source>
            <translation>天线前置距离</translation>
        </message>
        <message>
            <source>Antenna left</source>
            <translation>天线左置距离</translation>
        </message>
        <message>
            <source>Antenna up</source>
            <translation>天线高度</translation>
        </message>
        <message>
            <source>Position sigma</source>
            <translation>位置标准差</translation>
        </message>
        <message>
            <source>Acceleration sigma</source>
            <translation>加速度标准差</translation>
        </message>
        <message>
            <source>Gate</source>
            <translation>粗差阈值</translation>
        </message>
        <message>
            <source>Patience</source>
            <translation>等待时间</translation>
        </message>
        <message>
            <source>Max outage</source>
            <translation>最长失锁时间</translation>
        </message>
        <message>
            <source>Wheelbase</source>
            <translation>轴距</translation>
        </message>
        <message>
            <source>Max steering angle</source>
            <translation>最大转向角</translation>
        </message>
        <message>
            <source>Steering rate deg s</source>
            <translation>转向速率 (deg/s)</translation>
        </message>
        <message>
            <source>Steering lag</source>
            <translation>转向滞后</translation>
        </message>
        <message>
            <source>Steering delay</source>
            <translation>转向延迟</translation>
        </message>
        <message>
            <source>Steering deadband</source>
            <translation>转向死区</translation>
        </message>
        <message>
            <source>Steering offset</source>
            <translation>轮角零位误差</translation>
        </message>
        <message>
            <source>Wheel disturbance</source>
            <translation>轮角扰动</translation>
        </message>
        <message>
            <source>Side slope</source>
            <translation>横坡</translation>
        </message>
        <message>
            <source>Slip per slope</source>
            <translation>横坡侧滑系数</translation>
        </message>
        <message>
            <source>Turn radius</source>
            <translation>掉头半径</translation>
        </message>
        <message>
            <source>Speed km h</source>
            <translation>速度 (km/h)</translation>
        </message>
        <message>
            <source>First p</source>
            <translation>初始增益 P</translation>
        </message>
        <message>
            <source>First preview</source>
            <translation>初始预瞄距离</translation>
        </message>
        <message>
            <source>Oscillation</source>
            <translation>振荡幅度</translation>
        </message>
        <message>
            <source>Doubt</source>
            <translation>胸径变化容差</translation>
        </message>
        <message>
            <source>Min DBH</source>
            <translation>起测胸径</translation>
        </message>
        <message>
            <source>Max DBH</source>
            <translation>最大胸径</translation>
        </message>
        <message>
            <source>Search bottom</source>
            <translation>搜索下限</translation>
        </message>
        <message>
            <source>Search top</source>
            <translation>搜索上限</translation>
        </message>
        <message>
            <source>Max lean</source>
            <translation>最大倾斜</translation>
        </message>
        <message>
            <source>Min sections</source>
            <translation>最少断面数</translation>
        </message>
        <message>
            <source>Min section points</source>
            <translation>断面最少点数</translation>
        </message>
        <message>
            <source>Min arc</source>
            <translation>最小圆弧</translation>
        </message>
        <message>
            <source>Breast height from</source>
            <translation>胸高起算地面</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>拟合模型</translation>
        </message>
        <message>
            <source>Window</source>
            <translation>拟合范围</translation>
        </message>
        <message>
            <source>Section step</source>
            <translation>断面间距</translation>
        </message>
        <message>
            <source>Max sigma</source>
            <translation>残差尺度上限</translation>
        </message>
        <message>
            <source>Ray gate</source>
            <translation>射线阈值</translation>
        </message>
        <message>
            <source>Beam divergence</source>
            <translation>光束发散角</translation>
        </message>
        <message>
            <source>Beam divergence sd</source>
            <translation>光束发散角标准差</translation>
        </message>
        <message>
            <source>Beam aperture</source>
            <translation>光束出射宽度</translation>
        </message>
        <message>
            <source>Range noise</source>
            <translation>测距噪声</translation>
        </message>
        <message>
            <source>Bark relief</source>
            <translation>树皮裂缝深度</translation>
        </message>
        <message>
            <source>Bark relief sd</source>
            <translation>树皮起伏标准差</translation>
        </message>
        <message>
            <source>Estimate range offset</source>
            <translation>估计测距偏移</translation>
        </message>
        <message>
            <source>Range offset sd</source>
            <translation>测距偏移标准差</translation>
        </message>
        <message>
            <source>Range bias</source>
            <translation>测距偏差</translation>
        </message>
        <message>
            <source>Pass gap</source>
            <translation>分趟时间间隔</translation>
        </message>
        <message>
            <source>Max ray through</source>
            <translation>穿透射线最大比例</translation>
        </message>
        <message>
            <source>Crown radius</source>
            <translation>树冠半径</translation>
        </message>
        <message>
            <source>Bark tolerance</source>
            <translation>树皮容差</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>胸高</translation>
        </message>
        <message>
            <source>Thickness</source>
            <translation>厚度</translation>
        </message>
        <message>
            <source>Level</source>
            <translation>调平</translation>
        </message>
        <message>
            <source>Min intensity</source>
            <translation>最小强度</translation>
        </message>
        <message>
            <source>Min target points</source>
            <translation>标靶最少点数</translation>
        </message>
        <message>
            <source>Target size</source>
            <translation>标靶尺寸</translation>
        </message>
        <message>
            <source>Target views</source>
            <translation>标靶视点间距</translation>
        </message>
        <message>
            <source>Target distance</source>
            <translation>标靶间距</translation>
        </message>
        <message>
            <source>Target tolerance</source>
            <translation>标靶间距容差</translation>
        </message>
        <message>
            <source>North bearing</source>
            <translation>北标靶方位角</translation>
        </message>
        <message>
            <source>Max tilt</source>
            <translation>最大倾斜</translation>
        </message>
        <message>
            <source>Min stems</source>
            <translation>最少单木数</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>长度</translation>
        </message>
        <message>
            <source>Bearing</source>
            <translation>方位角</translation>
        </message>
        <message>
            <source>Inertial</source>
            <translation>惯性单元</translation>
        </message>
        <message>
            <source>Inertial trust</source>
            <translation>惯性单元的信任度</translation>
        </message>
        <message>
            <source>Inertial bridge</source>
            <translation>惯性单元的跨越限值</translation>
        </message>
        <message>
            <source>Inertial offset</source>
            <translation>惯性单元的时间偏移</translation>
        </message>
        <message>
            <source>IMU</source>
            <translation>惯性单元(IMU)</translation>
        </message>
        <message>
            <source>Bounds</source>
            <translation>范围</translation>
        </message>
        <message>
            <source>Topic</source>
            <translation>话题</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>分辨率</translation>
        </message>
        <message>
            <source>Scan positions</source>
            <translation>测站位置</translation>
        </message>
        <message>
            <source>CRS</source>
            <translation>坐标参考系</translation>
        </message>
        <message>
            <source>Time offset</source>
            <translation>时间差</translation>
        </message>
        <message>
            <source>Max gap</source>
            <comment>survey.join_trajectory</comment>
            <translation>最大时间间隔</translation>
        </message>
        <message>
            <source>Folder</source>
            <comment>io.read_views</comment>
            <translation>文件夹</translation>
        </message>
        <message>
            <source>Layout</source>
            <comment>io.read_views</comment>
            <translation>文件夹格式</translation>
        </message>
        <message>
            <source>Camera</source>
            <comment>io.read_views</comment>
            <translation>相机</translation>
        </message>
        <message>
            <source>Every</source>
            <comment>io.read_views</comment>
            <translation>抽取间隔</translation>
        </message>
        <message>
            <source>Max views</source>
            <comment>io.read_views</comment>
            <translation>最多视图数</translation>
        </message>
        <message>
            <source>Depth scale</source>
            <comment>io.read_views</comment>
            <translation>深度比例</translation>
        </message>
        <message>
            <source>Max depth</source>
            <comment>io.read_views</comment>
            <translation>最大深度</translation>
        </message>
        <message>
            <source>Board</source>
            <comment>rgbd.calibrate</comment>
            <translation>标定板</translation>
        </message>
        <message>
            <source>Columns</source>
            <comment>rgbd.calibrate</comment>
            <translation>横向方格数</translation>
        </message>
        <message>
            <source>Rows</source>
            <comment>rgbd.calibrate</comment>
            <translation>纵向方格数</translation>
        </message>
        <message>
            <source>Square</source>
            <comment>rgbd.calibrate</comment>
            <translation>方格边长</translation>
        </message>
        <message>
            <source>Marker</source>
            <comment>rgbd.calibrate</comment>
            <translation>标记边长</translation>
        </message>
        <message>
            <source>Dictionary</source>
            <comment>rgbd.calibrate</comment>
            <translation>标记字典</translation>
        </message>
        <message>
            <source>Distortion</source>
            <comment>rgbd.calibrate</comment>
            <translation>畸变系数</translation>
        </message>
        <message>
            <source>Bad view</source>
            <comment>rgbd.calibrate</comment>
            <translation>坏视图倍数</translation>
        </message>
        <message>
            <source>Depth</source>
            <comment>rgbd.calibrate</comment>
            <translation>标定深度</translation>
        </message>
        <message>
            <source>Width</source>
            <comment>rgbd.calibrate</comment>
            <translation>图像宽度</translation>
        </message>
        <message>
            <source>Height</source>
            <comment>rgbd.calibrate</comment>
            <translation>图像高度</translation>
        </message>
            <message>
            <source>Source</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>位姿来源</translation>
        </message>
        <message>
            <source>Max features</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>最多特征数</translation>
        </message>
        <message>
            <source>Max width</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>最大宽度</translation>
        </message>
        <message>
            <source>Max ratio</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>最大比值</translation>
        </message>
        <message>
            <source>Gms</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>网格运动统计</translation>
        </message>
        <message>
            <source>Max match error</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>最大匹配误差</translation>
        </message>
        <message>
            <source>Min matches</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>最少匹配数</translation>
        </message>
        <message>
            <source>Neighbours</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>相邻视图数</translation>
        </message>
        <message>
            <source>Depth noise</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>深度噪声</translation>
        </message>
        <message>
            <source>Use board</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>使用标定板</translation>
        </message>
        <message>
            <source>Turntable</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>转台</translation>
        </message>
        <message>
            <source>Refine focal</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>优化焦距</translation>
        </message>
        <message>
            <source>Allow unscaled</source>
            <comment>rgbd.estimate_poses</comment>
            <translation>允许无尺度</translation>
        </message>
        <message>
            <source>Voxel</source>
            <comment>plant.fuse_depth</comment>
            <translation>体素</translation>
        </message>
        <message>
            <source>Region</source>
            <comment>plant.fuse_depth</comment>
            <translation>区域</translation>
        </message>
        <message>
            <source>Mesh</source>
            <comment>plant.fuse_depth</comment>
            <translation>网格</translation>
        </message>
        <message>
            <source>Truncation</source>
            <comment>plant.fuse_depth</comment>
            <translation>截断距离</translation>
        </message>
        <message>
            <source>Depth sigma</source>
            <comment>plant.fuse_depth</comment>
            <translation>深度标准差</translation>
        </message>
        <message>
            <source>Min weight</source>
            <comment>plant.fuse_depth</comment>
            <translation>最小权重</translation>
        </message>
        <message>
            <source>Max memory</source>
            <comment>plant.fuse_depth</comment>
            <translation>最大内存</translation>
        </message>
        <message>
            <source>Encoder</source>
            <comment>plant.field</comment>
            <translation>编码方式</translation>
        </message>
        <message>
            <source>Voxel</source>
            <comment>plant.field</comment>
            <translation>体素</translation>
        </message>
        <message>
            <source>Region</source>
            <comment>plant.field</comment>
            <translation>区域</translation>
        </message>
        <message>
            <source>Background</source>
            <comment>plant.field</comment>
            <translation>背景</translation>
        </message>
        <message>
            <source>Max seconds</source>
            <comment>plant.field</comment>
            <translation>最长时间</translation>
        </message>
        <message>
            <source>Steps</source>
            <comment>plant.field</comment>
            <translation>步数</translation>
        </message>
        <message>
            <source>Rays</source>
            <comment>plant.field</comment>
            <translation>光线数</translation>
        </message>
        <message>
            <source>Hold out</source>
            <comment>plant.field</comment>
            <translation>检验视图间隔</translation>
        </message>
        <message>
            <source>Exposure</source>
            <comment>plant.field</comment>
            <translation>曝光</translation>
        </message>
        <message>
            <source>Refine poses</source>
            <comment>plant.field</comment>
            <translation>优化位姿</translation>
        </message>
        <message>
            <source>Depth weight</source>
            <comment>plant.field</comment>
            <translation>深度权重</translation>
        </message>
        <message>
            <source>Depth sigma</source>
            <comment>plant.field</comment>
            <translation>深度标准差</translation>
        </message>
        <message>
            <source>Cloud spacing</source>
            <comment>plant.field</comment>
            <translation>点云间距</translation>
        </message>
        <message>
            <source>Cloud min views</source>
            <comment>plant.field</comment>
            <translation>点云最少视图数</translation>
        </message>
        <message>
            <source>Cloud tolerance</source>
            <comment>plant.field</comment>
            <translation>点云容差</translation>
        </message>
        <message>
            <source>Max memory</source>
            <comment>plant.field</comment>
            <translation>最大内存</translation>
        </message>
        <message>
            <source>Paper layers</source>
            <comment>plant.field</comment>
            <translation>网络层数</translation>
        </message>
        <message>
            <source>Paper width</source>
            <comment>plant.field</comment>
            <translation>网络宽度</translation>
        </message>
        <message>
            <source>Paper frequencies</source>
            <comment>plant.field</comment>
            <translation>编码频率数</translation>
        </message>
        <message>
            <source>Paper integrated</source>
            <comment>plant.field</comment>
            <translation>积分编码</translation>
        </message>
        <message>
            <source>Pose</source>
            <comment>plant.render_view</comment>
            <translation>位姿</translation>
        </message>
        <message>
            <source>Region</source>
            <comment>plant.match_views</comment>
            <translation>区域</translation>
        </message>
        <message>
            <source>Max cost</source>
            <comment>plant.match_views</comment>
            <translation>最大代价</translation>
        </message>
        <message>
            <source>Min views</source>
            <comment>plant.match_views</comment>
            <translation>最少视图数</translation>
        </message>
        <message>
            <source>Spacing</source>
            <comment>plant.match_views</comment>
            <translation>点间距</translation>
        </message>
        <message>
            <source>Box</source>
            <comment>plant.separate</comment>
            <translation>范围框</translation>
        </message>
        <message>
            <source>Base</source>
            <comment>plant.separate</comment>
            <translation>茎基</translation>
        </message>
        <message>
            <source>Drop floaters</source>
            <comment>plant.separate</comment>
            <translation>删除漂浮点</translation>
        </message>
        <message>
            <source>Stem height</source>
            <comment>plant.traits</comment>
            <translation>测茎高度</translation>
        </message>
        <message>
            <source>Stem</source>
            <comment>plant.traits</comment>
            <translation>茎的测量方法</translation>
        </message>
        <message>
            <source>Stretch</source>
            <comment>plant.traits</comment>
            <translation>拟合长度</translation>
        </message>
        <message>
            <source>Light</source>
            <comment>plant.traits</comment>
            <translation>图像编码</translation>
        </message>
        <message>
            <source>Scale sd</source>
            <comment>plant.traits</comment>
            <translation>尺度标准误差</translation>
        </message>
        <message>
            <source>Surface sd</source>
            <comment>plant.traits</comment>
            <translation>表面误差</translation>
        </message>
        <message>
            <source>Tip reach</source>
            <comment>plant.traits</comment>
            <translation>叶尖搜索距离</translation>
        </message>
        <message>
            <source>Plant id</source>
            <comment>plant.traits</comment>
            <translation>植株编号</translation>
        </message>
        <message>
            <source>Scene</source>
            <translation>场景</translation>
        </message>
        <message>
            <source>File</source>
            <comment>survey.georeference</comment>
            <translation>控制点文件</translation>
        </message>
        <message>
            <source>CRS</source>
            <comment>survey.georeference</comment>
            <translation>坐标参考系</translation>
        </message>
        <message>
            <source>Control sd</source>
            <comment>survey.georeference</comment>
            <translation>控制点平面标准差</translation>
        </message>
        <message>
            <source>Height sd</source>
            <comment>survey.georeference</comment>
            <translation>控制点高程标准差</translation>
        </message>
        <message>
            <source>Map sd</source>
            <comment>survey.georeference</comment>
            <translation>地图点位标准差</translation>
        </message>
        <message>
            <source>Max residual</source>
            <comment>survey.georeference</comment>
            <translation>最大残差</translation>
        </message>
        <message>
            <source>Leave out blunders</source>
            <comment>survey.georeference</comment>
            <translation>剔除粗差点</translation>
        </message>
        <message>
            <source>Scale</source>
            <comment>survey.georeference</comment>
            <translation>比例尺</translation>
        </message>
        <message>
            <source>Height of</source>
            <comment>survey.georeference</comment>
            <translation>高程所指</translation>
        </message>
        <message>
            <source>Level</source>
            <comment>survey.georeference</comment>
            <translation>按控制高程整平</translation>
        </message>
        <message>
            <source>Level sd</source>
            <comment>survey.georeference</comment>
            <translation>原有水平的标准差</translation>
        </message>
        <message>
            <source>Easting</source>
            <comment>survey.georeference</comment>
            <translation>中心东坐标</translation>
        </message>
        <message>
            <source>Northing</source>
            <comment>survey.georeference</comment>
            <translation>中心北坐标</translation>
        </message>
        <message>
            <source>Latitude</source>
            <comment>survey.georeference</comment>
            <translation>中心纬度</translation>
        </message>
        <message>
            <source>Longitude</source>
            <comment>survey.georeference</comment>
            <translation>中心经度</translation>
        </message>
        <message>
            <source>Height</source>
            <comment>survey.georeference</comment>
            <translation>中心高程</translation>
        </message>
        <message>
            <source>Bearing</source>
            <comment>survey.georeference</comment>
            <translation>方位角</translation>
        </message>
        <message>
            <source>Bearing kind</source>
            <comment>survey.georeference</comment>
            <translation>方位角基准</translation>
        </message>
        <message>
            <source>Declination</source>
            <comment>survey.georeference</comment>
            <translation>磁偏角</translation>
        </message>
        <message>
            <source>Bearing sd</source>
            <comment>survey.georeference</comment>
            <translation>方位角标准差</translation>
        </message>
        <message>
            <source>Clock offset</source>
            <comment>survey.georeference</comment>
            <translation>时钟差</translation>
        </message>
        <message>
            <source>Clock window</source>
            <comment>survey.georeference</comment>
            <translation>时钟搜索范围</translation>
        </message>
        <message>
            <source>Lever x</source>
            <comment>survey.georeference</comment>
            <translation>天线偏移 x</translation>
        </message>
        <message>
            <source>Lever y</source>
            <comment>survey.georeference</comment>
            <translation>天线偏移 y</translation>
        </message>
        <message>
            <source>Lever z</source>
            <comment>survey.georeference</comment>
            <translation>天线偏移 z</translation>
        </message>
        <message>
            <source>Lever sd</source>
            <comment>survey.georeference</comment>
            <translation>天线偏移标准差</translation>
        </message>
        <message>
            <source>Track sd</source>
            <comment>survey.georeference</comment>
            <translation>轨迹共同误差</translation>
        </message>
        <message>
            <source>Min ground points</source>
            <translation>最少地面点数</translation>
        </message>
        <message>
            <source>Max unseen</source>
            <translation>未见地面上限</translation>
        </message>
        <message>
            <source>Walk again unseen</source>
            <translation>重走的未见地面</translation>
        </message>
        <message>
            <source>Max hole</source>
            <translation>最大空洞</translation>
        </message>
        <message>
            <source>Max walk gap</source>
            <translation>离行走路线的最大距离</translation>
        </message>
        <message>
            <source>Min view span</source>
            <translation>最小观测张角</translation>
        </message>
        <message>
            <source>Max one sided</source>
            <translation>单侧观测上限</translation>
        </message>
        <message>
            <source>Min density</source>
            <translation>最小密度</translation>
        </message>
        <message>
            <source>Max pass spread</source>
            <translation>各次经过的最大间距</translation>
        </message>
        <message>
            <source>Walk again spread</source>
            <translation>重走的间距</translation>
        </message>
        <message>
            <source>Max length error</source>
            <translation>最大长度误差</translation>
        </message>
        <message>
            <source>Max wall</source>
            <translation>最大树皮离散</translation>
        </message>
        <message>
            <source>Max loop residual</source>
            <translation>最大回环残差</translation>
        </message>
        <message>
            <source>Max loop turn</source>
            <translation>最大回环转角</translation>
        </message>
        <message>
            <source>Targets</source>
            <translation>靶标数</translation>
        </message>
        <message>
            <source>Boundary rule</source>
            <translation>边界木规则</translation>
        </message>
        <message>
            <source>Position se</source>
            <translation>位置标准误</translation>
        </message>
        <message>
            <source>Max doubtful</source>
            <translation>存疑断面积上限</translation>
        </message>
        <message>
            <source>Min missed DBH</source>
            <translation>漏测单木起测直径</translation>
        </message>
        <message>
            <source>Max without ground</source>
            <translation>无地面单木上限</translation>
        </message>
        <message>
            <source>Years</source>
            <translation>间隔年数</translation>
        </message>
        <message>
            <source>Max growth</source>
            <translation>最大年生长量</translation>
        </message>
        <message>
            <source>Max loss</source>
            <translation>最大变细量</translation>
        </message>
        <message>
            <source>Shared bias</source>
            <translation>共同偏差</translation>
        </message>
        <message>
            <source>Assumed se</source>
            <translation>假定标准误</translation>
        </message>
        <message>
            <source>Folders</source>
            <translation>文件夹</translation>
        </message>
        <message>
            <source>Names</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Systems</source>
            <translation>系统</translation>
        </message>
        <message>
            <source>Plots</source>
            <translation>样地</translation>
        </message>
        <message>
            <source>Min agreement</source>
            <translation>最小一致率</translation>
        </message>
        <message>
            <source>Published system</source>
            <translation>论文中的系统</translation>
        </message>
        <message>
            <source>Cloud figures</source>
            <translation>点云插图</translation>
        </message>
        <message>
            <source>Slices</source>
            <translation>横切面数</translation>
        </message>
        <message>
            <source>Enlarge</source>
            <translation>误差放大倍数</translation>
        </message>
        <message>
            <source>Radii</source>
            <translation>样圆半径</translation>
        </message>
        <message>
            <source>Distance bias</source>
            <translation>距离系统误差</translation>
        </message>
        <message>
            <source>Distance sd</source>
            <translation>距离标准差</translation>
        </message>
        <message>
            <source>Mark sigma</source>
            <translation>标志平面标准差</translation>
        </message>
        <message>
            <source>Mark height sigma</source>
            <translation>标志高程标准差</translation>
        </message>
        <message>
            <source>Direction sigma</source>
            <translation>方向标准差</translation>
        </message>
        <message>
            <source>Tilt sigma</source>
            <translation>调平标准差</translation>
        </message>
        <message>
            <source>Max heading sigma</source>
            <translation>航向标准误差上限</translation>
        </message>
        <message>
            <source>Heading</source>
            <translation>航向来源</translation>
        </message>
        <message>
            <source>Heading offset</source>
            <translation>航向偏置</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>采用的定位质量</translation>
        </message>
        <message>
            <source>Overlap</source>
            <translation>重叠宽度</translation>
        </message>
        <message>
            <source>Lines left</source>
            <translation>左侧行数</translation>
        </message>
        <message>
            <source>Lines right</source>
            <translation>右侧行数</translation>
        </message>
        <message>
            <source>Headland passes</source>
            <translation>地头行程数</translation>
        </message>
        <message>
            <source>Cloud format</source>
            <translation>点云格式</translation>
        </message>
        <message>
            <source>Context distance</source>
            <translation>场景描述距离</translation>
        </message>
        <message>
            <source>Loop stretch</source>
            <translation>回环配准的关键帧数</translation>
        </message>
        <message>
            <source>Loop acceptance</source>
            <translation>回环的接受条件</translation>
        </message>
        <message>
            <source>Loop fitness</source>
            <translation>回环最近点距离</translation>
        </message>
        <message>
            <source>Match frames</source>
            <translation>匹配帧数</translation>
        </message>
        <message>
            <source>Files</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Tile</source>
            <translation>分块</translation>
        </message>
        <message>
            <source>Buffer</source>
            <translation>缓冲区</translation>
        </message>
        <message>
            <source>Shift x</source>
            <translation>x 平移</translation>
        </message>
        <message>
            <source>Shift y</source>
            <translation>y 平移</translation>
        </message>
        <message>
            <source>Breast height</source>
            <translation>胸高</translation>
        </message>
        <message>
            <source>Core</source>
            <translation>核心区</translation>
        </message>
        <message>
            <source>Course</source>
            <comment>report.flythrough</comment>
            <translation>路线</translation>
        </message>
        <message>
            <source>Views</source>
            <comment>report.flythrough</comment>
            <translation>书签视图</translation>
        </message>
        <message>
            <source>Seconds</source>
            <comment>report.flythrough</comment>
            <translation>时长</translation>
        </message>
        <message>
            <source>Frame rate</source>
            <comment>report.flythrough</comment>
            <translation>帧率</translation>
        </message>
        <message>
            <source>Width</source>
            <comment>report.flythrough</comment>
            <translation>画面宽度</translation>
        </message>
        <message>
            <source>Height</source>
            <comment>report.flythrough</comment>
            <translation>画面高度</translation>
        </message>
        <message>
            <source>Color</source>
            <comment>report.flythrough</comment>
            <translation>着色</translation>
        </message>
        <message>
            <source>Point size</source>
            <comment>report.flythrough</comment>
            <translation>点的大小</translation>
        </message>
        <message>
            <source>Stems</source>
            <comment>report.flythrough</comment>
            <translation>树干</translation>
        </message>
        <message>
            <source>Walk</source>
            <comment>report.flythrough</comment>
            <translation>行走路径</translation>
        </message>
        <message>
            <source>Dark</source>
            <comment>report.flythrough</comment>
            <translation>深色背景</translation>
        </message>
        <message>
            <source>Above</source>
            <comment>report.flythrough</comment>
            <translation>相机高度</translation>
        </message>
        <message>
            <source>Ahead</source>
            <comment>report.flythrough</comment>
            <translation>前视距离</translation>
        </message>
        <message>
            <source>Video</source>
            <comment>report.flythrough</comment>
            <translation>视频</translation>
        </message>
        <message>
            <source>Beside color</source>
            <comment>report.flythrough</comment>
            <translation>旁置点云颜色</translation>
        </message>
        <message>
            <source>Beside opacity</source>
            <comment>report.flythrough</comment>
            <translation>旁置点云不透明度</translation>
        </message>
        <message>
            <source>Map</source>
            <comment>report.flythrough</comment>
            <translation>地图</translation>
        </message>
        <message>
            <source>Map opacity</source>
            <comment>report.flythrough</comment>
            <translation>地图不透明度</translation>
        </message>
        <message>
            <source>Terrain</source>
            <comment>report.flythrough</comment>
            <translation>地形</translation>
        </message>
        <message>
            <source>Map on terrain</source>
            <comment>report.flythrough</comment>
            <translation>地图随地形</translation>
        </message>
</context>
    <context>
        <name>option help</name>
        <message>
            <source>What is found as the region. standing: what stands on the largest plane, so that fine voxels are not spent on the table. common: all that the views see together.</source>
            <translation>把什么取为区域。standing：立在最大平面上的物体，细体素不耗费在桌面上。common：各视图共同看到的全部。</translation>
        </message>
        <message>
            <source>Maximum distance between a stem and its reference tree.</source>
            <translation>单木与其参考树之间的最大距离。</translation>
        </message>
        <message>
            <source>Maximum difference of matched diameters; 0 allows any.</source>
            <translation>匹配直径之间的最大差值;0 表示不限。</translation>
        </message>
        <message>
            <source>Width of the diameter classes.</source>
            <translation>径阶宽度。</translation>
        </message>
        <message>
            <source>Width of the rings around the plot centre in which trees are counted; needs a plot.</source>
            <translation>以样地中心为圆心、统计树木所用圆环的宽度;需要样地。</translation>
        </message>
        <message>
            <source>Alignment of the stems with the reference before errors are computed: none, shift, rigid (shift and rotation), or search (all rotations and shifts are tried, for maps with another origin and north).</source>
            <translation>计算误差前如何将单木移到参考数据上:不移动(none)、最佳平移(shift)、平移加旋转(rigid),或尝试所有旋转和平移(search),用于原点和北方向不同的地图。</translation>
        </message>
        <message>
            <source>Columns of the stems by other names or units, as NAME=SOURCE:UNIT with commas between: x_m=E, y_m=N, dbh_cm=DIAM:mm. Units: mm, cm, dm, m, in, ft, deg, gon; azimuth_deg and distance_m give places too.</source>
            <translation>单木表中名称或单位不同的列,写作 NAME=SOURCE:UNIT,以逗号分隔:x_m=E, y_m=N, dbh_cm=DIAM:mm。单位:mm、cm、dm、m、in、ft、deg、gon;也可用 azimuth_deg 和 distance_m 给出位置。</translation>
        </message>
        <message>
            <source>Stems that are evaluated, as COLUMN=VALUE: plot=3; empty for all.</source>
            <translation>参与评价的单木,写作 COLUMN=VALUE,例如 plot=3;留空表示全部。</translation>
        </message>
        <message>
            <source>Columns of the reference by other names or units, as in columns. Empty: as they are named, else guessed by their headings.</source>
            <translation>参考表中使用其他名称或单位的列,写法同“columns”。留空:按列名,否则按标题猜测。</translation>
        </message>
        <message>
            <source>Reference trees that are used, as in rows.</source>
            <translation>使用的参考树木,写法同 rows。</translation>
        </message>
        <message>
            <source>Moves the trajectory onto the reference by the best rigid motion (se3) before errors are taken, or not (none).</source>
            <translation>计算误差前,用最佳刚体运动(se3)将轨迹移到参考轨迹上,或不移动(none)。</translation>
        </message>
        <message>
            <source>A pose is compared where reference poses lie on both sides of it, no further apart than this. A larger value compares more poses, with less certain reference poses.</source>
            <translation>位姿两侧都有参考位姿、且二者时间间隔不超过此值时,才参与比较。值越大,比较的位姿越多,但参考位姿的可靠性越低。</translation>
        </message>
        <message>
            <source>Time between the two poses of a relative pose error.</source>
            <translation>计算相对位姿误差的两个位姿之间的时间。</translation>
        </message>
        <message>
            <source>Distance travelled between the two poses of a relative pose error by distance.</source>
            <translation>按距离计算相对位姿误差时,两个位姿之间的行进距离。</translation>
        </message>
        <message>
            <source>Segments of 1 to 8 times this length give the relative errors of KITTI.</source>
            <translation>以此长度的 1 至 8 倍为段长,给出 KITTI 相对误差。</translation>
        </message>
        <message>
            <source>A loop is right where the reference puts its two places no further apart than this.</source>
            <translation>参考轨迹上两处的距离不超过此值时,回环为正确。</translation>
        </message>
        <message>
            <source>Minimum distance travelled between two visits of a place that count as a chance for a loop.</source>
            <translation>两次到访同一处之间的最小行进距离,达到此值才算一次可能的回环。</translation>
        </message>
        <message>
            <source>Maximum position error of a loop whose relative pose counts as true.</source>
            <translation>相对位姿视为正确的回环所允许的最大位置误差。</translation>
        </message>
        <message>
            <source>Maximum rotation error of a loop whose relative pose counts as true.</source>
            <translation>相对位姿视为正确的回环所允许的最大旋转误差。</translation>
        </message>
        <message>
            <source>Plot of the improved-LOAM paper whose published figures are listed beside the results.</source>
            <translation>改进 LOAM 论文中的样地,其发表的数值与本次结果并列给出。</translation>
        </message>
        <message>
            <source>to_plane: latitude and longitude become x_m and y_m; to_geodetic: the reverse.</source>
            <translation>到平面坐标(to_plane):纬度和经度换算为 x_m 和 y_m;到经纬度(to_geodetic):反向换算。</translation>
        </message>
        <message>
            <source>Plane of the metres: Gauss-Krueger zones of 3 or 6 degrees, UTM, or any transverse Mercator plane.</source>
            <translation>米制坐标的平面:3 度或 6 度高斯-克吕格带、UTM,或任意横轴墨卡托平面。</translation>
        </message>
        <message>
            <source>Reference ellipsoid. Those named by a year belong to older datums: the degrees must be of that datum already.</source>
            <translation>参考椭球。以年份命名的椭球属于较早的大地基准:经纬度必须已属于该基准。</translation>
        </message>
        <message>
            <source>Number of the zone. auto: that of the mean longitude (to_plane only).</source>
            <translation>带号。自动(auto):取平均经度所在的带(仅 to_plane)。</translation>
        </message>
        <message>
            <source>The northings are those of the southern hemisphere.</source>
            <translation>北坐标属于南半球。</translation>
        </message>
        <message>
            <source>The zone number precedes the easting.</source>
            <translation>东坐标前带有带号。</translation>
        </message>
        <message>
            <source>Central meridian of the plane.</source>
            <translation>平面的中央子午线。</translation>
        </message>
        <message>
            <source>Scale on the central meridian.</source>
            <translation>中央子午线上的尺度比。</translation>
        </message>
        <message>
            <source>Easting of the central meridian.</source>
            <translation>中央子午线的东坐标。</translation>
        </message>
        <message>
            <source>Northing of the origin.</source>
            <translation>原点的北坐标。</translation>
        </message>
        <message>
            <source>Latitude at which the plane has its false northing.</source>
            <translation>北坐标等于北偏移值处的纬度。</translation>
        </message>
        <message>
            <source>tin: terrain from the ground points; lowest: a level plane at the lowest points, for a tree that was cut out without ground; normalised: z is the height above ground already. auto: normalised where that is certain, else tin.</source>
            <translation>三角网(tin):由地面点建立地形;最低点(lowest):取过最低点的水平面,用于裁出时不带地面的单株树;已归一化(normalised):z 已是离地高度。自动:能确定点云已归一化时取归一化,否则取三角网。</translation>
        </message>
        <message>
            <source>Cell size of the terrain model. auto: 0.25 m, more for sparse clouds; whatever else is auto follows the density likewise.</source>
            <translation>地形模型的格网大小。自动:0.25 米,稀疏点云取更大的值;其他取自动的参数同样随点云密度而定。</translation>
        </message>
        <message>
            <source>Cell size in which the lowest point starts the ground. Make it larger than the largest object that hides the ground (shrub, boulder, building).</source>
            <translation>以最低点作为地面起始点的格网大小。应大于遮挡地面的最大物体(灌木、巨石、建筑物)。</translation>
        </message>
        <message>
            <source>Steepest terrain to expect. Lowest points that lie steeper than this to their neighbours do not start the ground.</source>
            <translation>预期的最陡地形。与相邻最低点之间坡度更陡的最低点不作为地面起始点。</translation>
        </message>
        <message>
            <source>Greatest angle, seen from the nearest ground point, at which a further ground point may leave the triangulation.</source>
            <translation>从最近的地面点看,新的地面点偏离三角网的最大角度。</translation>
        </message>
        <message>
            <source>Greatest distance of a further ground point from the triangulation.</source>
            <translation>新的地面点到三角网的最大距离。</translation>
        </message>
        <message>
            <source>Points this close to the triangulation are ground at any angle: noise of the cloud and micro-relief.</source>
            <translation>与三角网的距离不超过此值的点,无论角度多大都是地面点:点云噪声和微地形。</translation>
        </message>
        <message>
            <source>Points up to this far above and below the first surface take part in the local fit of the terrain height.</source>
            <translation>在初始地面上下此范围内的点参与地形高度的局部拟合。</translation>
        </message>
        <message>
            <source>Points within this height of the terrain model are classified as ground.</source>
            <translation>与地形模型的高差在此范围内的点归为地面点。</translation>
        </message>
        <message>
            <source>Points deeper than this below the terrain model are classified as low noise.</source>
            <translation>比地形模型低出此值以上的点归为低噪点。</translation>
        </message>
        <message>
            <source>Cells without ground points are filled up to this far from the nearest cell with ground points. Beyond it the terrain model has no value.</source>
            <translation>没有地面点的格网,距最近的有地面点的格网在此距离内时予以填补。超出此距离,地形模型没有值。</translation>
        </message>
        <message>
            <source>Keep classes of the input other than unassigned, ground and low noise (water, building, vegetation).</source>
            <translation>保留输入中除未分类、地面和低噪点以外的类别(水体、建筑物、植被)。</translation>
        </message>
        <message>
            <source>Width of the diameter classes in tables and charts.</source>
            <translation>表格和图中径阶的宽度。</translation>
        </message>
        <message>
            <source>Standard deviation of the stem form, shared by all stems whose volume comes from diameter and height. A larger value widens the interval of the volume.</source>
            <translation>干形的标准差,为材积由直径和树高计算的全部单木所共有。值越大,材积区间越宽。</translation>
        </message>
        <message>
            <source>Point cloud to read: %1.</source>
            <translation>要读取的点云:%1。</translation>
        </message>
        <message>
            <source>Unit of the coordinates in the file. auto: metre, unless the coordinate system of the file or the stems in it show another one for certain.</source>
            <translation>文件中坐标的单位。自动(auto):米,除非文件的坐标系或其中的树干确切表明是其他单位。</translation>
        </message>
        <message>
            <source>Axis of the file that points up. It is z in most files, and y in most files from phones and cameras. auto: z, unless the stems show for certain that it is another one.</source>
            <translation>文件中向上的坐标轴。多数文件为 z,手机和相机生成的文件多为 y。自动(auto):z,除非树干确切表明是其他轴。</translation>
        </message>
        <message>
            <source>Turn a cloud that is not level. stems: until the mean direction of the stems is vertical; none: leave it as it is.</source>
            <translation>调平倾斜的点云。树干(stems):旋转到树干的平均方向竖直;无(none):保持原样。</translation>
        </message>
        <message>
            <source>Coordinate system of the file. global: projected coordinates; plot: x to the east and y to the north of the plot centre.</source>
            <translation>文件的坐标系。投影坐标(global);样地(plot):以样地中心为原点,x 向东,y 向北。</translation>
        </message>
        <message>
            <source>Columns of a text file in their order, for instance &quot;x y z intensity&quot;; _ skips a column. Empty: from the header line, or guessed from the number of columns.</source>
            <translation>文本文件各列的顺序,例如 &quot;x y z intensity&quot;;_ 表示跳过一列。留空:取自表头行,或按列数推测。</translation>
        </message>
        <message>
            <source>Character between the columns of a text file.</source>
            <translation>文本文件各列之间的分隔符。</translation>
        </message>
        <message>
            <source>Leave out LAS points that are flagged as withheld.</source>
            <translation>舍去标记为 withheld 的 LAS 点。</translation>
        </message>
        <message>
            <source>Number of lines to skip at the beginning of a text file.</source>
            <translation>文本文件开头要跳过的行数。</translation>
        </message>
        <message>
            <source>Scan to read: %1.</source>
            <translation>要读取的扫描数据:%1。</translation>
        </message>
        <message>
            <source>Sensor model: auto (from the packets), a name such as vlp16, vls128, os1_128, pandar_xt32 or mid360, or a file of your own unit: Ouster JSON, Hesai correction CSV, Velodyne calibration (db.xml, or YAML of ROS), or beams as JSON.</source>
            <translation>传感器型号:auto(由数据包识别),型号名称如 vlp16、vls128、os1_128、pandar_xt32 或 mid360,或您所用设备自己的文件:Ouster JSON、Hesai 校正 CSV、Velodyne 标定文件(db.xml,或 ROS 的 YAML),或以 JSON 给出的各光束。</translation>
        </message>
        <message>
            <source>Returns closer than this are ignored (they hit the operator or the housing).</source>
            <translation>忽略距离小于此值的回波(它们打在操作员或外壳上)。</translation>
        </message>
        <message>
            <source>Topic of a ROS bag that holds the scan. Empty takes the only one; bole info lists the topics.</source>
            <translation>ROS bag 中包含扫描数据的话题。留空则取唯一的一个;bole info 会列出所有话题。</translation>
        </message>
        <message>
            <source>Inertial unit: a topic of the ROS bag, or a file (.csv, .txt). Empty takes the one that comes with the scan; none leaves it out.</source>
            <translation>惯性单元:ROS bag 的话题,或文件 (.csv, .txt)。留空则取随扫描数据一起的那个;none 表示不使用。</translation>
        </message>
        <message>
            <source>Returns farther than this are ignored.</source>
            <translation>忽略距离大于此值的回波。</translation>
        </message>
        <message>
            <source>Azimuth at which one frame of a capture ends and the next begins, clockwise from forward. 180 is behind the sensor.</source>
            <translation>记录中一帧结束、下一帧开始处的方位角,从正前方起顺时针计。180 为传感器正后方。</translation>
        </message>
        <message>
            <source>Keep the first and last frame of a capture when they cover less than nine tenths of a revolution.</source>
            <translation>记录的首帧和末帧不足一圈的十分之九时也予保留。</translation>
        </message>
        <message>
            <source>Add the height of each laser on the sensor&apos;s axis, where its maker states one (VLP-16: up to 11 mm). Off gives the points of decoders that leave it out.</source>
            <translation>在厂家给出时,加上每个激光器在传感器轴线上的高度(VLP-16:最大 11 mm)。关闭时得到的点与不计此高度的解码程序相同。</translation>
        </message>
        <message>
            <source>UDP port of the sensor&apos;s data packets. auto takes that of the first one.</source>
            <translation>传感器数据包的 UDP 端口。自动(auto):取第一个数据包的端口。</translation>
        </message>
        <message>
            <source>Time between frames in a folder of frames without a file of times.</source>
            <translation>没有时间文件的帧文件夹中相邻帧的时间间隔。</translation>
        </message>
        <message>
            <source>Number of rings assumed in a folder of frames where neither the sensor, the files nor the order of the points give it.</source>
            <translation>帧文件夹的线数:传感器、文件和点的顺序都不能给出时采用此值。</translation>
        </message>
        <message>
            <source>Table to read: %1.</source>
            <translation>要读取的表格:%1。</translation>
        </message>
        <message>
            <source>Track to read: %1.</source>
            <translation>要读取的航迹:%1。</translation>
        </message>
        <message>
            <source>Format of the file. nmea: log of a receiver; csv: columns named in a header line; columns: numbers without names; auto: by the content.</source>
            <translation>文件格式。NMEA(nmea):接收机日志;CSV(csv):列名在表头行中;数字列(columns):没有列名;自动(auto):按内容判断。</translation>
        </message>
        <message>
            <source>Columns of a file without a header line, separated by commas: hhmmss, time_s, x_m, y_m, height_m, latitude_deg, longitude_deg. Leave the place of a column empty to skip it.</source>
            <translation>没有表头行的文件的各列,以逗号分隔:hhmmss、time_s、x_m、y_m、height_m、latitude_deg、longitude_deg。某列留空表示跳过。</translation>
        </message>
        <message>
            <source>Positions of a lower fix quality (as in GGA sentences) are left out.</source>
            <translation>舍去定位质量(如 GGA 语句中的)低于此值的位置。</translation>
        </message>
        <message>
            <source>Longer steps in time are counted as gaps.</source>
            <translation>超过此值的时间步长计为间断。</translation>
        </message>
        <message>
            <source>Trajectory to read: %1.</source>
            <translation>要读取的轨迹:%1。</translation>
        </message>
        <message>
            <source>Format of the file. auto decides by the header, else by the values in a line.</source>
            <translation>文件格式。自动(auto):按文件头判断,否则按一行中的数值判断。</translation>
        </message>
        <message>
            <source>Coordinate system of the poses.</source>
            <translation>位姿的坐标系。</translation>
        </message>
        <message>
            <source>Title of the report.</source>
            <translation>报告的标题。</translation>
        </message>
        <message>
            <source>Width of the large figures; charts are a little less than half as wide.</source>
            <translation>大图的宽度;图表宽度略小于其一半。</translation>
        </message>
        <message>
            <source>Resolution of the PNG figures for printing.</source>
            <translation>用于印刷的 PNG 图件的分辨率。</translation>
        </message>
        <message>
            <source>Points drawn at most in each map; the cloud is thinned evenly in space.</source>
            <translation>每幅图最多绘制的点数;点云在空间上均匀抽稀。</translation>
        </message>
        <message>
            <source>What draws the 3-D maps: osmesa in memory, egl on a graphics card, glx on an X display.</source>
            <translation>绘制三维图的方式:osmesa 在内存中,egl 在显卡上,glx 在 X 显示器上。</translation>
        </message>
        <message>
            <source>Write stems.csv and the other tables, trajectory.tum, dem.tif and plot.gpkg.</source>
            <translation>写出 stems.csv 及其他表格、trajectory.tum、dem.tif 和 plot.gpkg。</translation>
        </message>
        <message>
            <source>Write cloud.las.</source>
            <translation>写出 cloud.las。</translation>
        </message>
        <message>
            <source>Draw the figures.</source>
            <translation>绘制图件。</translation>
        </message>
        <message>
            <source>page: the figures of report.html; all: also other views of the map and the slice sheet, each figure as PNG, SVG and PDF for printing (takes much longer).</source>
            <translation>page:report.html 中的图件;all:另有点云图的其他视图和横切面图集,每幅图件均写成 PNG、SVG 和 PDF 供印刷(耗时长得多)。</translation>
        </message>
        <message>
            <source>Draw figures/hero.png too, a picture for a title page: the fitted stems and the walk on a dark ground, 1600 pixels wide.</source>
            <translation>另绘制 figures/hero.png,用于封面:深色背景上的拟合单木和行走轨迹,宽 1600 像素。</translation>
        </message>
        <message>
            <source>Write charts and plans as SVG and PDF too.</source>
            <translation>图表和平面图另写成 SVG 和 PDF。</translation>
        </message>
        <message>
            <source>Write report.html.</source>
            <translation>写出 report.html。</translation>
        </message>
        <message>
            <source>Maximum distance between a plant and its reference plant.</source>
            <translation>植株与其参考植株之间的最大距离。</translation>
        </message>
        <message>
            <source>Resolution of the PNG.</source>
            <translation>PNG 的分辨率。</translation>
        </message>
        <message>
            <source>Draw the error curves and write them as PNG, SVG and PDF.</source>
            <translation>绘制误差曲线并写成 PNG、SVG 和 PDF。</translation>
        </message>
        <message>
            <source>Width of the figures.</source>
            <translation>图件的宽度。</translation>
        </message>
        <message>
            <source>JSON list of edits, applied after those of the file.</source>
            <translation>编辑的 JSON 列表,在文件中的编辑之后应用。</translation>
        </message>
        <message>
            <source>File with a JSON list of edits.</source>
            <translation>含有编辑 JSON 列表的文件。</translation>
        </message>
        <message>
            <source>Largest distance between the place of an edit and the row that it changes.</source>
            <translation>编辑的位置与所更改的行之间的最大距离。</translation>
        </message>
        <message>
            <source>Largest distance of a stray plant from a drawn row that takes it in.</source>
            <translation>离群植株到收入它的手绘行的最大距离。</translation>
        </message>
        <message>
            <source>A row whose direction differs from was_angle_deg of an edit by more than this is reported.</source>
            <translation>行的方向与编辑的 was_angle_deg 相差超过此值时予以报告。</translation>
        </message>
        <message>
            <source>Line fit of changed rows, as in rows.from_stems.</source>
            <translation>更改后各行的直线拟合方法,同 rows.from_stems。</translation>
        </message>
        <message>
            <source>Line fit of a row. least_squares, as in the paper: y = a x + b, or x = a y + b for rows that run more north than east; orthogonal: smallest distances across the line.</source>
            <translation>行的直线拟合。普通最小二乘(least_squares),同论文:y = a x + b,行的走向偏南北时为 x = a y + b;正交(orthogonal):使垂直于直线的距离最小。</translation>
        </message>
        <message>
            <source>Distance between plants along the row. auto: found from the plants.</source>
            <translation>沿行的株距。自动(auto):由植株求得。</translation>
        </message>
        <message>
            <source>Distance between neighbouring rows. auto: found from the plants.</source>
            <translation>相邻行的行距。自动(auto):由植株求得。</translation>
        </message>
        <message>
            <source>Direction of the rows, from east to north. auto: found around every plant; give it where plants are as far apart along the row as across.</source>
            <translation>行的方向,从东向北计。自动(auto):在每株植株周围求得;株距与行距相同时请给定。</translation>
        </message>
        <message>
            <source>Largest number of consecutive missing plants within a row. A longer gap ends the row.</source>
            <translation>行内连续缺株的最大数量。缺口更长时该行结束。</translation>
        </message>
        <message>
            <source>Smallest number of plants in a row that is found. Rows named by a row_id column may be shorter.</source>
            <translation>查找到的行的最少株数。由 row_id 列指定的行可以更少。</translation>
        </message>
        <message>
            <source>Largest distance of the next plant from the line of its row, as a share of the plant spacing and of the row spacing. A larger value follows less regular rows.</source>
            <translation>下一株偏离所在行直线的最大距离,以株距和行距的比例表示。值越大,越能跟踪不规则的行。</translation>
        </message>
        <message>
            <source>auto: a clearly curved row gets a curve; straight: every row is a line.</source>
            <translation>自动(auto):明显弯曲的行用曲线;直线(straight):每行都是直线。</translation>
        </message>
        <message>
            <source>Direction of the rows, from east to north. auto: the direction across which the rows are most sharply separated.</source>
            <translation>行的方向,从东向北计。自动(auto):取各行分隔最清晰的方向。</translation>
        </message>
        <message>
            <source>Smallest distance between neighbouring rows. A larger value joins double rows.</source>
            <translation>相邻行之间的最小距离。值越大,双行越容易合并为一行。</translation>
        </message>
        <message>
            <source>Width of the window that follows a row. Canopy outside it does not move the row.</source>
            <translation>随行移动的窗口的宽度。窗口外的冠层不会移动该行。</translation>
        </message>
        <message>
            <source>Length of a piece of hedge. Each piece gives one point of the row&apos;s line.</source>
            <translation>树篱分段的长度。每段给出该行线上的一个点。</translation>
        </message>
        <message>
            <source>A piece of hedge with fewer points is a gap.</source>
            <translation>点数更少的树篱段为缺口。</translation>
        </message>
        <message>
            <source>Smallest height of a row&apos;s peak in the profile, as a share of the highest peak. A larger value drops weak rows.</source>
            <translation>剖面中行峰值的最小高度,以最高峰的比例表示。值越大,舍去的弱行越多。</translation>
        </message>
        <message>
            <source>Roll of the sensor about its x axis, from its IMU.</source>
            <translation>传感器绕其 x 轴的横滚角,取自其 IMU。</translation>
        </message>
        <message>
            <source>Pitch of the sensor about its y axis, from its IMU.</source>
            <translation>传感器绕其 y 轴的俯仰角,取自其 IMU。</translation>
        </message>
        <message>
            <source>Yaw of the sensor about the vertical axis.</source>
            <translation>传感器绕铅垂轴的航向角。</translation>
        </message>
        <message>
            <source>Horizontal radius of the mean shift. Choose less than half the plant spacing.</source>
            <translation>均值漂移的水平半径。应小于株距的一半。</translation>
        </message>
        <message>
            <source>Clusters with fewer points are not plants.</source>
            <translation>点数更少的聚类不是植株。</translation>
        </message>
        <message>
            <source>Easting of the sensor, from resection or a receiver.</source>
            <translation>传感器的东坐标,由后方交会或接收机得到。</translation>
        </message>
        <message>
            <source>Northing of the sensor.</source>
            <translation>传感器的北坐标。</translation>
        </message>
        <message>
            <source>Angle from east to the x axis of the frame, towards north. 0 when y points north.</source>
            <translation>从东向帧的 x 轴量取的角度,向北为正。y 指向北时为 0。</translation>
        </message>
        <message>
            <source>Radius of the sphere in which neighbours are counted.</source>
            <translation>统计邻点所用球的半径。</translation>
        </message>
        <message>
            <source>Points with fewer neighbours are removed.</source>
            <translation>邻点更少的点被去除。</translation>
        </message>
        <message>
            <source>Smallest x of the box.</source>
            <translation>长方体的最小 x。</translation>
        </message>
        <message>
            <source>Largest x of the box.</source>
            <translation>长方体的最大 x。</translation>
        </message>
        <message>
            <source>Smallest y of the box. y points ahead of the sensor.</source>
            <translation>长方体的最小 y。y 指向传感器前方。</translation>
        </message>
        <message>
            <source>Largest y of the box.</source>
            <translation>长方体的最大 y。</translation>
        </message>
        <message>
            <source>Smallest height of the box, counted from the sensor.</source>
            <translation>长方体的最小高度,从传感器起算。</translation>
        </message>
        <message>
            <source>Largest height of the box, counted from the sensor.</source>
            <translation>长方体的最大高度,从传感器起算。</translation>
        </message>
        <message>
            <source>Width of the sectors around the sensor.</source>
            <translation>传感器周围扇区的宽度。</translation>
        </message>
        <message>
            <source>Height of the sensor above the ground below it.</source>
            <translation>传感器距其下方地面的高度。</translation>
        </message>
        <message>
            <source>Steepest ground from one point to the next. A larger value removes more points.</source>
            <translation>相邻两点之间的最陡地面坡度。值越大,去除的点越多。</translation>
        </message>
        <message>
            <source>Steepest ground as seen from the sensor. A larger value removes more points.</source>
            <translation>从传感器看的最陡地面坡度。值越大,去除的点越多。</translation>
        </message>
        <message>
            <source>Points less than this above the last ground point are ground, whatever the slope.</source>
            <translation>比上一个地面点高出不足此值的点,无论坡度如何都是地面点。</translation>
        </message>
        <message>
            <source>After a horizontal step longer than this, the general slope alone decides.</source>
            <translation>水平步长超过此值后,仅由总体坡度判断。</translation>
        </message>
        <message>
            <source>Height of the layers into which a plant is cut.</source>
            <translation>植株被切成的层的高度。</translation>
        </message>
        <message>
            <source>Largest extent along x of a layer that is trunk only.</source>
            <translation>只含树干的层沿 x 方向的最大宽度。</translation>
        </message>
        <message>
            <source>Largest extent along y of a layer that is trunk only.</source>
            <translation>只含树干的层沿 y 方向的最大宽度。</translation>
        </message>
        <message>
            <source>Smallest number of trunk layers of a plant.</source>
            <translation>一株植株的最少树干层数。</translation>
        </message>
        <message>
            <source>Trunks less far ahead (y) are ignored: the edge of the view or of the region cuts them.</source>
            <translation>忽略前方距离(y)小于此值的树干:它们被视场或区域的边缘截断。</translation>
        </message>
        <message>
            <source>mean: the mean of the trunk points, as in the paper; face: the axis behind the side that the sensor sees, from the points of the input dense.</source>
            <translation>平均值(mean):树干点的平均值,同论文;轴心(face):传感器所见一侧背后的轴心,由输入 dense 的点求得。</translation>
        </message>
        <message>
            <source>Standard deviation of a single range.</source>
            <translation>单次测距的标准差。</translation>
        </message>
        <message>
            <source>Distance from the middle of a cluster within which its trunk is searched.</source>
            <translation>在聚类中心周围此距离内搜索其树干。</translation>
        </message>
        <message>
            <source>Thinner trunks are ignored: the edge of the view cuts them.</source>
            <translation>忽略更细的树干:它们被视场边缘截断。</translation>
        </message>
        <message>
            <source>Trunks lower than this are ignored (weeds).</source>
            <translation>更矮的树干视为杂草。</translation>
        </message>
        <message>
            <source>Smallest share of the layers between foot and top of a trunk that contain points.</source>
            <translation>树干根部到顶部之间含有点的层所占的最小比例。</translation>
        </message>
        <message>
            <source>Edge length of the voxels. A larger value keeps fewer points.</source>
            <translation>体素的边长。值越大,保留的点越少。</translation>
        </message>
        <message>
            <source>SLAM system: loam (baseline), forest (LOAM improved for forest plots), lego_loam (ground-aware baseline), orchard (plant rows and foliage), best (elastic frames and a final trajectory adjustment, with the inertial unit where the recording has one), or inertial (the same, and only with an inertial unit).</source>
            <translation>SLAM 系统:LOAM(loam,基准)、森林(forest,针对森林样地改进的 LOAM)、LeGO-LOAM(lego_loam,顾及地面的基准)、果园(orchard,种植行和枝叶)、最佳(best,弹性帧和最终轨迹平差,记录中有惯性单元时一并使用)或惯性(inertial,与最佳相同,但必须有惯性单元)。</translation>
        </message>
        <message>
            <source>TUM file with sensor poses. The map is made with these poses, and none are estimated; the times must be on the clock of the scan.</source>
            <translation>含传感器位姿的 TUM 文件。地图用这些位姿建立,不再估计位姿;其时间必须采用扫描数据的时钟。</translation>
        </message>
        <message>
            <source>Returns closer than this are ignored (they hit the operator).</source>
            <translation>忽略距离小于此值的回波(它们打在操作员身上)。</translation>
        </message>
        <message>
            <source>Returns farther than this are not used for registration.</source>
            <translation>距离大于此值的回波不用于配准。</translation>
        </message>
        <message>
            <source>Points used for registration: edges and planes by curvature (LOAM), the same with curvature measured within connected surfaces, planes on the ground and edges on objects (LeGO-LOAM), or all points thinned on a grid.</source>
            <translation>用于配准的点:按曲率的边缘和平面(LOAM,curvature),同上但曲率只在连通表面内计算(connected),地面上的平面和物体上的边缘(LeGO-LOAM,ground),或按格网抽稀的全部点(sampled)。</translation>
        </message>
        <message>
            <source>Where edges beside a step in range are rejected: nowhere, on the far side (LOAM), or on both sides, so that the outline of a trunk is never an edge.</source>
            <translation>在距离突变处的哪一侧舍去边缘:不舍去(none)、远侧(far_side,LOAM)或两侧(both_sides),使树干的轮廓不会成为边缘。</translation>
        </message>
        <message>
            <source>Difference in range between neighbours of a scan line that counts as an occlusion.</source>
            <translation>同一扫描线上相邻点的距离差达到此值时,视为遮挡。</translation>
        </message>
        <message>
            <source>Grid that thins the points to be registered. A larger value is faster and less accurate.</source>
            <translation>抽稀待配准点的格网。值越大,速度越快,精度越低。</translation>
        </message>
        <message>
            <source>Grid that thins the points of a keyframe. A larger value is faster and gives a coarser local map.</source>
            <translation>抽稀关键帧中点的格网。值越大,速度越快,局部地图越粗。</translation>
        </message>
        <message>
            <source>Motion before registration: constant velocity, or the frame matched against the last frame.</source>
            <translation>配准前的运动:匀速(velocity),或由本帧与上一帧匹配得到(last_frame)。</translation>
        </message>
        <message>
            <source>Correction of the motion within a frame: none, once with the first guess, twice (again after a first registration), or elastic (begin and end pose are estimated together).</source>
            <translation>帧内运动的校正:不校正(none);一次(once),用初始估计;两次(twice),初次配准后再校正一次;或弹性(elastic),同时估计帧首和帧尾位姿。</translation>
        </message>
        <message>
            <source>Maximum number of iterations of a registration.</source>
            <translation>一次配准的最大迭代次数。</translation>
        </message>
        <message>
            <source>Number of keyframes in the local map.</source>
            <translation>局部地图中的关键帧数量。</translation>
        </message>
        <message>
            <source>Keyframes in the local map: those nearest to the sensor, or the last ones (LeGO-LOAM), which leaves revisits to the loop closures.</source>
            <translation>局部地图中的关键帧:离传感器最近的(nearest),或最后的若干个(last,LeGO-LOAM),重访由回环处理。</translation>
        </message>
        <message>
            <source>Distance travelled after which a new keyframe is made.</source>
            <translation>行进此距离后建立新的关键帧。</translation>
        </message>
        <message>
            <source>Rotation after which a new keyframe is made.</source>
            <translation>旋转此角度后建立新的关键帧。</translation>
        </message>
        <message>
            <source>Where loop closures are looked for: nowhere, where the estimated trajectory comes close to itself, where the surroundings look similar (Scan Context), or both.</source>
            <translation>在何处查找回环:不查找(none)、估计轨迹接近自身处(odometry)、周围环境相似处(Scan Context,context),或两者(both)。</translation>
        </message>
        <message>
            <source>How the place is chosen by its surroundings: the most similar one (single), the best fit of the three most similar (placed), or the same over the last metres travelled and within the drift of the odometry (sequence).</source>
            <translation>如何按周围环境选择地点:最相似的一处(single),三处最相似中拟合最好的一处(placed),或同上但顾及最后几米行程并限于里程计漂移范围之内(sequence)。</translation>
        </message>
        <message>
            <source>How the relative pose of a loop closure is found: edges and planes, closest points (ICP), or normal distributions (NDT) and then ICP.</source>
            <translation>如何求回环的相对位姿:边缘和平面(features)、最近点(icp,ICP),或先正态分布(NDT)再 ICP(ndt_icp)。</translation>
        </message>
        <message>
            <source>Minimum share of points that agree for a loop closure to be accepted. A larger value rejects more.</source>
            <translation>接受回环所需的相符点的最小比例。值越大,舍去的回环越多。</translation>
        </message>
        <message>
            <source>Weight of a match: from the thickness of the surface and the range noise, or from the covariances of the points by sensor and poses (SPEC A7).</source>
            <translation>匹配的权:由表面厚度和测距噪声确定(thickness),或由传感器和位姿给出的点的协方差确定(priors,SPEC A7)。</translation>
        </message>
        <message>
            <source>All six unknowns from all features, or height, roll and pitch from planes and the rest from edges (LeGO-LOAM; not with elastic frames).</source>
            <translation>由全部特征求解全部六个未知数(joint),或由平面求高度、横滚和俯仰,其余由边缘求得(two_step,LeGO-LOAM;不可用于弹性帧)。</translation>
        </message>
        <message>
            <source>Iterations of the final trajectory adjustment; 0: no adjustment.</source>
            <translation>最终轨迹平差的迭代次数;0:不平差。</translation>
        </message>
        <message>
            <source>Finest cell of the map for registration; each coarser level doubles it.</source>
            <translation>用于配准的地图的最细格网;每粗一级,格网加倍。</translation>
        </message>
        <message>
            <source>Standard deviation of a range. It is added to the thickness of map surfaces.</source>
            <translation>测距的标准差。它与地图表面的厚度相加。</translation>
        </message>
        <message>
            <source>Standard deviation of the azimuth and elevation of a return.</source>
            <translation>回波方位角和高度角的标准差。</translation>
        </message>
        <message>
            <source>Scale of the robust kernel (Geman-McClure) in standard deviations. A larger value gives outliers more weight.</source>
            <translation>稳健核函数(Geman-McClure)的尺度,以标准差为单位。值越大,粗差的权越大。</translation>
        </message>
        <message>
            <source>Standard deviation of the distance between the end of a frame and the start of the next frame.</source>
            <translation>一帧末尾与下一帧开头之间距离的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the rotation between the end of a frame and the start of the next frame.</source>
            <translation>一帧末尾与下一帧开头之间旋转的标准差。</translation>
        </message>
        <message>
            <source>Minimum share of registered points that agree with the map. A frame with less counts as failed.</source>
            <translation>与地图相符的配准点的最小比例。低于此值的帧计为失败。</translation>
        </message>
        <message>
            <source>Number of consecutive failed frames after which the track is lost. The map ends there.</source>
            <translation>连续失败达到此帧数后,视为跟踪丢失。地图到此为止。</translation>
        </message>
        <message>
            <source>Minimum information about the weakest motion of a frame, as a multiple of what noise alone would give. A frame with less counts as failed; with weights equal or conditions one with less than 85 %, and the others are reported.</source>
            <translation>帧在最弱运动方向上的最小信息量,以仅有噪声时的倍数表示。低于此值的帧计为失败;权为 equal 或 conditions 时,低于其 85 % 才计为失败,其余的会报告。</translation>
        </message>
        <message>
            <source>Maximum speed of the sensor. A faster frame counts as failed.</source>
            <translation>传感器的最大速度。更快的帧计为失败。</translation>
        </message>
        <message>
            <source>Maximum distance between the two keyframes of a loop closure, before and after registration.</source>
            <translation>回环的两个关键帧之间的最大距离,配准前后均须满足。</translation>
        </message>
        <message>
            <source>Minimum distance travelled between the two keyframes of a loop closure.</source>
            <translation>回环的两个关键帧之间的最小行进距离。</translation>
        </message>
        <message>
            <source>Expected drift as a share of the distance travelled. A loop closure found by its surroundings may correct the trajectory by this much and 3 m.</source>
            <translation>预期漂移占行进距离的比例。按周围环境找到的回环,对轨迹的改正最多为此漂移加 3 m。</translation>
        </message>
        <message>
            <source>Number of rings of a scan context.</source>
            <translation>Scan Context 的环数。</translation>
        </message>
        <message>
            <source>Number of sectors of a scan context.</source>
            <translation>Scan Context 的扇区数。</translation>
        </message>
        <message>
            <source>Radius of a scan context.</source>
            <translation>Scan Context 的半径。</translation>
        </message>
        <message>
            <source>Maximum distance between two scan contexts to be tried as a loop closure. A larger value tries more.</source>
            <translation>两个 Scan Context 之间的最大差异,不超过此值才尝试作为回环。值越大,尝试越多。</translation>
        </message>
        <message>
            <source>Number of nearest ring keys whose scan contexts are compared.</source>
            <translation>按环键取最近的若干个,比较其 Scan Context;此为其数量。</translation>
        </message>
        <message>
            <source>Make the map. Without it only the trajectory is output, and the cloud is empty.</source>
            <translation>建立地图。关闭时只输出轨迹,点云为空。</translation>
        </message>
        <message>
            <source>Returns closer than this are left out of the map.</source>
            <translation>距离小于此值的回波不进入地图。</translation>
        </message>
        <message>
            <source>Returns farther than this are left out of the map.</source>
            <translation>距离大于此值的回波不进入地图。</translation>
        </message>
        <message>
            <source>Grid that thins the map, separately for each pass. A larger value gives a smaller map.</source>
            <translation>抽稀地图的格网,每趟分别抽稀。值越大,地图越小。</translation>
        </message>
        <message>
            <source>Maximum number of points of each pass in a voxel of the map.</source>
            <translation>地图的一个体素中每趟的最大点数。</translation>
        </message>
        <message>
            <source>Maximum number of points in the map, in millions. A larger map is thinned evenly at random.</source>
            <translation>地图的最大点数,以百万计。更大的地图会被均匀随机抽稀。</translation>
        </message>
        <message>
            <source>A new pass begins where the trajectory comes this close to an earlier part of the same pass, after at least three times this distance travelled.</source>
            <translation>轨迹在行进至少三倍于此的距离后,又接近同一趟的较早部分、相距不足此值时,开始新的一趟。</translation>
        </message>
        <message>
            <source>Poses per second in the output trajectory.</source>
            <translation>输出轨迹每秒的位姿数。</translation>
        </message>
        <message>
            <source>Distance between neighbouring lines. log: as the log gives it.</source>
            <translation>相邻线之间的距离。日志(log):按日志所给。</translation>
        </message>
        <message>
            <source>Distance at the start of each pass that is not measured.</source>
            <translation>每次行程起始处不测量的距离。</translation>
        </message>
        <message>
            <source>Distance at the end of each pass that is not measured, because the turn begins there.</source>
            <translation>每次行程末尾不测量的距离,因为掉头从那里开始。</translation>
        </message>
        <message>
            <source>Shorter passes are ignored.</source>
            <translation>忽略更短的行程。</translation>
        </message>
        <message>
            <source>Largest angle between the direction of motion and the line on a pass.</source>
            <translation>行程中运动方向与线之间的最大夹角。</translation>
        </message>
        <message>
            <source>Step, km/h, by which measured speeds are grouped when the log does not give them.</source>
            <translation>日志未给出速度时,实测速度分组的步长,km/h。</translation>
        </message>
        <message>
            <source>Speeds of the drives in km/h, as a list.</source>
            <translation>各次行驶的速度列表,单位 km/h。</translation>
        </message>
        <message>
            <source>Number of drives per speed.</source>
            <translation>每个速度的行驶次数。</translation>
        </message>
        <message>
            <source>Number of neighbouring lines per drive.</source>
            <translation>每次行驶的相邻线数。</translation>
        </message>
        <message>
            <source>Distance between neighbouring lines.</source>
            <translation>相邻线之间的距离。</translation>
        </message>
        <message>
            <source>Distance at the start of each line that is not measured.</source>
            <translation>每条线起始处不测量的距离。</translation>
        </message>
        <message>
            <source>Measured length of each line. The paper asks for 80 m.</source>
            <translation>每条线的测量长度。论文要求 80 m。</translation>
        </message>
        <message>
            <source>Direction from A to B, from east to north.</source>
            <translation>从 A 到 B 的方向,从东向北计。</translation>
        </message>
        <message>
            <source>Distance to the left of the line at which the drive starts.</source>
            <translation>行驶起点在线左侧的距离。</translation>
        </message>
        <message>
            <source>Preview distance ahead of the tractor. published: from the paper&apos;s table at the speed.</source>
            <translation>拖拉机前方的预瞄距离。已发表(published):按速度取自论文的表格。</translation>
        </message>
        <message>
            <source>Wheel angle per preview error, deg/m. published: from the paper&apos;s table.</source>
            <translation>单位预瞄误差对应的轮角,deg/m。已发表(published):取自论文的表格。</translation>
        </message>
        <message>
            <source>Wheel angle per integral of the error, deg/(m s). published: from the paper&apos;s table.</source>
            <translation>单位误差积分对应的轮角,deg/(m s)。已发表(published):取自论文的表格。</translation>
        </message>
        <message>
            <source>Wheel angle per speed across the line (V tan alpha), deg s/m. published: from the paper&apos;s table.</source>
            <translation>单位横向速度(V tan alpha)对应的轮角,deg s/m。已发表(published):取自论文的表格。</translation>
        </message>
        <message>
            <source>Largest angle at which the tractor approaches a distant line.</source>
            <translation>拖拉机接近远处作业线的最大角度。</translation>
        </message>
        <message>
            <source>Largest commanded wheel angle on a line. More than the wheels can follow makes the tractor oscillate.</source>
            <translation>在线上行驶时指令轮角的最大值。超出车轮的跟随能力会使拖拉机振荡。</translation>
        </message>
        <message>
            <source>Distance from the line within which the error is integrated.</source>
            <translation>与线的距离在此值以内时,才对误差积分。</translation>
        </message>
        <message>
            <source>Largest wheel angle of the integral part.</source>
            <translation>积分部分的最大轮角。</translation>
        </message>
        <message>
            <source>Position fixes and steering commands per second.</source>
            <translation>每秒的定位和转向指令次数。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of the noise from fix to fix.</source>
            <translation>各次定位间噪声的单轴标准差。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of the slow error of precise point positioning.</source>
            <translation>精密单点定位慢变误差的单轴标准差。</translation>
        </message>
        <message>
            <source>Correlation time of the slow error (first-order Gauss-Markov process).</source>
            <translation>慢变误差的相关时间(一阶高斯-马尔可夫过程)。</translation>
        </message>
        <message>
            <source>Position jumps per hour, as after a change of satellites.</source>
            <translation>每小时的位置跳变次数,例如卫星更换之后。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of a jump.</source>
            <translation>跳变的单轴标准差。</translation>
        </message>
        <message>
            <source>Time constant with which a jump decays.</source>
            <translation>跳变衰减的时间常数。</translation>
        </message>
        <message>
            <source>Losses of all fixes per hour.</source>
            <translation>每小时完全失锁的次数。</translation>
        </message>
        <message>
            <source>Mean duration of a loss.</source>
            <translation>一次失锁的平均时长。</translation>
        </message>
        <message>
            <source>Standard deviation of the heading from two antennas.</source>
            <translation>双天线航向的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the measured roll and pitch.</source>
            <translation>测得的横滚角和俯仰角的标准差。</translation>
        </message>
        <message>
            <source>Distance of the antenna ahead of the middle of the rear axle.</source>
            <translation>天线在后轴中点前方的距离。</translation>
        </message>
        <message>
            <source>Distance of the antenna to the left of the middle of the rear axle.</source>
            <translation>天线在后轴中点左侧的距离。</translation>
        </message>
        <message>
            <source>Height of the antenna above the ground.</source>
            <translation>天线距地面的高度。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of a fix, as the filter assumes it.</source>
            <translation>滤波器假定的单次定位的单轴标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the acceleration, as the filter assumes it, m/s2. A larger value follows the fixes more closely.</source>
            <translation>滤波器假定的加速度标准差,m/s2。值越大,越紧跟定位结果。</translation>
        </message>
        <message>
            <source>Distance from the prediction, in standard deviations, beyond which a fix is rejected.</source>
            <translation>与预测的距离超过此值(以标准差为单位)的定位被舍弃。</translation>
        </message>
        <message>
            <source>Time for which rejected fixes are ignored. Then the filter starts again at the new position.</source>
            <translation>在此时间内忽略被舍弃的定位。此后滤波器在新位置重新启动。</translation>
        </message>
        <message>
            <source>Time without a fix after which the tractor stops and waits.</source>
            <translation>无定位超过此时间后,拖拉机停车等待。</translation>
        </message>
        <message>
            <source>Distance between front and rear axle.</source>
            <translation>前后轴之间的距离。</translation>
        </message>
        <message>
            <source>Largest angle of the front wheels.</source>
            <translation>前轮的最大转角。</translation>
        </message>
        <message>
            <source>Largest turning rate of the front wheels, deg/s.</source>
            <translation>前轮的最大转动速率,deg/s。</translation>
        </message>
        <message>
            <source>Time constant of the hydraulic steering.</source>
            <translation>液压转向的时间常数。</translation>
        </message>
        <message>
            <source>Dead time between the command and the movement of the wheels.</source>
            <translation>从指令到车轮动作的延迟时间。</translation>
        </message>
        <message>
            <source>Deviation from the commanded angle below which the valve stays closed (Qiu et al. 2001).</source>
            <translation>与指令转角的偏差小于此值时,阀保持关闭(Qiu et al. 2001)。</translation>
        </message>
        <message>
            <source>Constant error of the wheel-angle sensor. The integral part must compensate for it.</source>
            <translation>轮角传感器的常值误差。须由积分部分补偿。</translation>
        </message>
        <message>
            <source>Standard deviation of the wheel angle caused by the ground, correlated over about 1.5 m.</source>
            <translation>地面引起的轮角标准差,相关长度约 1.5 m。</translation>
        </message>
        <message>
            <source>Standard deviation of roll and pitch on uneven ground.</source>
            <translation>不平地面上横滚角和俯仰角的标准差。</translation>
        </message>
        <message>
            <source>Side slope of the field. Positive: the ground falls to the right of the line from A to B.</source>
            <translation>田块的横坡。为正时,地面向 A 到 B 线的右侧下降。</translation>
        </message>
        <message>
            <source>Crab angle downhill per angle of side slope.</source>
            <translation>每单位横坡角引起的向坡下的偏航行驶角(蟹行角)。</translation>
        </message>
        <message>
            <source>Radius of the driver&apos;s turns on the headland.</source>
            <translation>驾驶员在地头掉头的半径。</translation>
        </message>
        <message>
            <source>Seed of all randomness. The same seed gives the same drive.</source>
            <translation>全部随机数的种子。种子相同,行驶过程相同。</translation>
        </message>
        <message>
            <source>Speed to tune for, km/h.</source>
            <translation>整定所针对的速度,km/h。</translation>
        </message>
        <message>
            <source>Medium gain P, deg/m, with which the preview distance is tuned.</source>
            <translation>整定预瞄距离时采用的中等增益 P,deg/m。</translation>
        </message>
        <message>
            <source>Large preview distance from which tuning starts.</source>
            <translation>整定开始时采用的较大预瞄距离。</translation>
        </message>
        <message>
            <source>Distance from the line at which each trial starts.</source>
            <translation>每次试验的起点到线的距离。</translation>
        </message>
        <message>
            <source>Smallest lasting swing that counts as oscillation.</source>
            <translation>算作振荡的最小持续摆幅。</translation>
        </message>
        <message>
            <source>The edits as a JSON list, applied after those of the file.</source>
            <translation>编辑的 JSON 列表,在文件中的编辑之后应用。</translation>
        </message>
        <message>
            <source>A file with a JSON list of edits.</source>
            <translation>含有编辑 JSON 列表的文件。</translation>
        </message>
        <message>
            <source>Maximum distance between an edit and the stem that it changes.</source>
            <translation>最近的单木与编辑的距离不超过此值时,编辑属于该单木。</translation>
        </message>
        <message>
            <source>A diameter that differs by more than this from was_dbh_cm of an edit has changed: an acceptance or rejection is not carried over, other edits are applied with a warning.</source>
            <translation>直径与编辑的 was_dbh_cm 相差超过此值时,视为已变化:接受或拒绝不再沿用,其他编辑照常应用并给出警告。</translation>
        </message>
        <message>
            <source>Thinner stems are listed as rejected.</source>
            <translation>更细的单木列入被拒绝的候选。</translation>
        </message>
        <message>
            <source>Thicker stems are not searched for.</source>
            <translation>不搜索更粗的单木。</translation>
        </message>
        <message>
            <source>Lowest height above ground at which stems are searched for. Raise it above shrubs.</source>
            <translation>搜索单木的最低离地高度。应高于灌木。</translation>
        </message>
        <message>
            <source>Greatest height above ground at which stems are searched for. Keep it below the crowns.</source>
            <translation>搜索单木的最大离地高度。应低于树冠。</translation>
        </message>
        <message>
            <source>Greatest lean of a stem from the vertical.</source>
            <translation>单木偏离铅垂方向的最大倾斜。</translation>
        </message>
        <message>
            <source>A stem must show a circle at this many heights. A larger value rejects more bushes, but also more hidden stems.</source>
            <translation>单木须在此数量的高度上都呈现圆形。值越大,排除的灌丛越多,但排除的被遮挡单木也越多。</translation>
        </message>
        <message>
            <source>Fewest points on the bark of a section that is used.</source>
            <translation>所用断面上树皮点的最少数量。</translation>
        </message>
        <message>
            <source>Smallest part of the circle that must be seen in a section that is used.</source>
            <translation>所用断面上须可见的最小圆弧比例。</translation>
        </message>
        <message>
            <source>Ground from which breast height is measured: the highest ground at the stem base, or the mean of the ground around it.</source>
            <translation>胸高的起算地面:树干基部的最高地面(uphill,坡上侧),或其周围地面的平均值(mean)。</translation>
        </message>
        <message>
            <source>Residual of the joint fit. ray: error along the ray of a beam of finite width, needs sensor positions; surface: distance from the bark; auto: ray where sensor positions are known.</source>
            <translation>联合拟合的残差。射线(ray):沿有宽度的光束的射线误差,需要传感器位置;表面(surface):到树皮的距离;自动(auto):传感器位置已知时采用射线。</translation>
        </message>
        <message>
            <source>Sections up to this far above and below breast height take part in the joint fit.</source>
            <translation>胸高上下此范围内的断面参与联合拟合。</translation>
        </message>
        <message>
            <source>Spacing and thickness of the sections.</source>
            <translation>断面的间距和厚度。</translation>
        </message>
        <message>
            <source>Upper limit of the robust scale of the residuals, so that outliers cannot swell the stem. It is raised to 1.25 times the range noise of a noisier sensor.</source>
            <translation>残差稳健尺度的上限,使粗差不会把单木撑大。传感器噪声较大时,提高到其测距噪声的 1.25 倍。</translation>
        </message>
        <message>
            <source>The ray model leaves out rays that pass the stem axis further away than this share of the radius.</source>
            <translation>射线模型舍去与树干轴线的距离超过半径此比例的射线。</translation>
        </message>
        <message>
            <source>Horizontal full angle of the beam (1/e^2) in milliradians; cloud: as the cloud says. A wide beam measures the mean of the round bark that it lights.</source>
            <translation>光束的水平全角(1/e^2),以毫弧度计;点云(cloud):按点云所给。宽光束测得的是它所照亮的圆形树皮的平均值。</translation>
        </message>
        <message>
            <source>Standard deviation of beam_divergence in milliradians; cloud: 0 where the maker of the sensor states its beam, 1 where it is that of a similar sensor, 1.5 where none is known. A larger value widens the intervals.</source>
            <translation>beam_divergence 的标准差,以毫弧度计;点云(cloud):传感器厂家给出光束时为 0,取自类似传感器时为 1,完全未知时为 1.5。值越大,区间越宽。</translation>
        </message>
        <message>
            <source>Horizontal width of the beam where it leaves the sensor; cloud: as the cloud says.</source>
            <translation>光束离开传感器处的水平宽度;点云(cloud):按点云所给。</translation>
        </message>
        <message>
            <source>Standard deviation of a single range; cloud: as the cloud says. It raises max_sigma for noisy sensors.</source>
            <translation>单次测距的标准差;点云(cloud):按点云所给。传感器噪声较大时,它会提高 max_sigma。</translation>
        </message>
        <message>
            <source>Bark of the stand, which the points do not show: mean adds nothing (a convention); smooth (beech), scaly (spruce), ridged (ash), plated (pine) and furrowed (oak) add what a tape over the ridges reads more, with wider intervals. Or the path of a JSON file.</source>
            <translation>林分的树皮，点云并不显示它：mean 不增加任何值（约定）；smooth（山毛榉）、scaly（云杉）、ridged（白蜡树）、plated（松树）和 furrowed（栎树）加上卷尺贴在棱脊上多读出的量，区间也更宽。也可以是 JSON 文件的路径。</translation>
        </message>
        <message>
            <source>Mean depth of the bark fissures below the ridges on which a tape lies; the ray model adds it to the radius. bark: as the option bark says.</source>
            <translation>树皮裂缝相对于卷尺所贴树皮棱脊的平均深度；射线模型将其加到半径上。bark：按选项 bark。</translation>
        </message>
        <message>
            <source>Standard deviation of bark_relief, which the intervals allow for. bark: as the option bark says.</source>
            <translation>bark_relief 的标准差，区间已将其计入。bark：按选项 bark。</translation>
        </message>
        <message>
            <source>Estimate the mean range error from all stems and remove it. It comes from the lasers, or from poses that lie too close to the stems.</source>
            <translation>由全部单木估计平均测距误差并消除。它来自激光器,或来自离单木过近的位姿。</translation>
        </message>
        <message>
            <source>Standard deviation of the range offset of calibrated sensors; cloud: 0.4 mm for 32 lasers or more, more for fewer (1.1 mm for four). The estimate is regularised towards zero with it; a larger value follows the stems more closely and widens the intervals.</source>
            <translation>已检校传感器测距偏移的标准差;点云(cloud):32 个及以上激光器为 0.4 mm,更少则更大(四个为 1.1 mm)。估计值据此向零正则化;值越大,越由单木决定,区间也越宽。</translation>
        </message>
        <message>
            <source>Standard deviation of the range error that all points of a stem share. A larger value widens the intervals.</source>
            <translation>同一单木所有点共有的测距误差的标准差。值越大,区间越宽。</translation>
        </message>
        <message>
            <source>A pause of this length between returns from a stem starts a new pass of the walk.</source>
            <translation>同一单木的回波中断达到此时长后,开始行走的新一趟。</translation>
        </message>
        <message>
            <source>The fits leave out returns from further away where ranges are known and enough nearer returns exist.</source>
            <translation>距离已知且有足够的较近回波时,拟合舍去距离大于此值的回波。</translation>
        </message>
        <message>
            <source>A candidate is rejected when more than this share of the rays towards its core pass through it.</source>
            <translation>指向候选核心的射线中,穿过它的比例超过此值时,该候选被拒绝。</translation>
        </message>
        <message>
            <source>Points further from every stem axis than this belong to no tree.</source>
            <translation>与每条树干轴线的距离都大于此值的点不属于任何树木。</translation>
        </message>
        <message>
            <source>Points closer to the fitted surface than this are marked as bark.</source>
            <translation>与拟合表面的距离小于此值的点标记为树皮。</translation>
        </message>
        <message>
            <source>Breast height above ground: the middle of the slice, and the height at which diameters are measured.</source>
            <translation>胸高(离地高度):横切面的中间高度,也是测定直径的高度。</translation>
        </message>
        <message>
            <source>Thickness of the slice.</source>
            <translation>横切面的厚度。</translation>
        </message>
        <message>
            <source>What gives the vertical. auto: gravity where the map was made with an inertial unit that tells it to 0.3 deg, else the stems; gravity: z is up, as the unit told; stems: their mean direction, the ground where there are too few; ground: its plane, for level plots only; none: z is up already.</source>
            <translation>由什么确定铅垂方向。自动(auto):若建图时惯性单元给出的重力方向精确到 0.3 度,则用重力,否则用单木;重力(gravity):z 已按惯性单元向上;单木(stems):单木的平均方向,单木太少时用地面;地面(ground):地面的平面,仅用于平坦样地;不调平(none):z 已经向上。</translation>
        </message>
        <message>
            <source>Returns stronger than this come from retro-reflective surfaces (Velodyne: above 100).</source>
            <translation>强度大于此值的回波来自反光表面(Velodyne:100 以上)。</translation>
        </message>
        <message>
            <source>Fewest strong returns on a target.</source>
            <translation>标靶上强回波的最少数量。</translation>
        </message>
        <message>
            <source>Greatest extent of a target as one position sees it. Larger groups of strong returns (signs, vehicles) are rejected.</source>
            <translation>从一个位置看到的标靶的最大尺寸。更大的强回波群(标志牌、车辆)被拒绝。</translation>
        </message>
        <message>
            <source>A target must be seen from sensor positions at least this far apart. This rejects reflective jackets and glints; it is not checked where the cloud has no sensor positions.</source>
            <translation>标靶须从相距至少此值的传感器位置都能看到;反光衣和反光点则不能。点云没有传感器位置时不检查。</translation>
        </message>
        <message>
            <source>Horizontal distance between the centre and the north target as set out in the field; 0: not known.</source>
            <translation>现场布设时中心标靶与北标靶之间的水平距离;0:未知。</translation>
        </message>
        <message>
            <source>Greatest difference between the measured distance of the targets and target_distance.</source>
            <translation>测得的标靶间距与 target_distance 之间的最大差值。</translation>
        </message>
        <message>
            <source>Bearing from the centre to the north target, clockwise from grid north.</source>
            <translation>从中心标靶到北标靶的方位角,从坐标北顺时针计。</translation>
        </message>
        <message>
            <source>Greatest tilt of the map that is searched.</source>
            <translation>搜索的地图最大倾斜。</translation>
        </message>
        <message>
            <source>Fewest stems that may give the vertical.</source>
            <translation>可用于确定铅垂方向的最少单木数。</translation>
        </message>
        <message>
            <source>Boundary of the plot. auto: a circle where a radius is given, a rectangle where a width, length or bearing is, the polygon where vertices are connected, the usual rectangle where the map lies in plot axes (targets were found), else none.</source>
            <translation>样地边界。自动(auto):给出半径时为圆;给出宽度、长度或方位时为矩形;连接了顶点时为多边形;地图位于样地坐标系中(已找到标靶)时为通常的矩形;否则无边界(none)。</translation>
        </message>
        <message>
            <source>Extent of a rectangle in x (east; across its bearing), horizontal. auto: the length, or 32 m where that is open too.</source>
            <translation>矩形沿 x 方向的尺寸(东;垂直于其方位),水平。自动(auto):与长度相同;长度也未给出时为 32 m。</translation>
        </message>
        <message>
            <source>Extent of a rectangle in y (north; along its bearing), horizontal. auto: the width, or 32 m where that is open too.</source>
            <translation>矩形沿 y 方向的尺寸(北;沿其方位),水平。自动(auto):与宽度相同;宽度也未给出时为 32 m。</translation>
        </message>
        <message>
            <source>Radius of a circle, horizontal. auto: 15 m.</source>
            <translation>圆的半径,水平。自动(auto):15 m。</translation>
        </message>
        <message>
            <source>x of the centre of a rectangle or circle, in the axes of the stems. auto: the centre target where it was found, else the middle of what was scanned.</source>
            <translation>矩形或圆的中心的 x 坐标,采用树干的坐标系。自动(auto):找到中心标靶时取其位置,否则取扫描范围的中央。</translation>
        </message>
        <message>
            <source>y of the centre of a rectangle or circle, in the axes of the stems. auto: as x.</source>
            <translation>矩形或圆的中心的 y 坐标,采用树干的坐标系。自动(auto):同 x。</translation>
        </message>
        <message>
            <source>Direction of a rectangle&apos;s length, clockwise from y (north). auto: 0.</source>
            <translation>矩形长边的方向,从 y(北)起顺时针。自动(auto):0。</translation>
        </message>
        <message>
            <source>Trees of this diameter at breast height and more count.</source>
            <translation>胸径达到此值的树木才计入。</translation>
        </message>
        <message>
            <source>Use of the inertial unit: off, auto (where the recording has one and frames are elastic), or required.</source>
            <translation>惯性单元的使用:不用(off)、自动(auto,记录中有惯性单元且帧为弹性时使用)或必须(required)。</translation>
        </message>
        <message>
            <source>Share of the points of a frame that count as independent against the inertial unit. A smaller value trusts the unit more.</source>
            <translation>一帧的点中相对惯性单元视为独立的比例。值越小,越信任惯性单元。</translation>
        </message>
        <message>
            <source>Standard deviation of the place up to which the inertial unit alone leads over open motions and frames without returns. Beyond it a frame counts as failed.</source>
            <translation>仅由惯性单元跨越未确定的运动和没有回波的帧时,位置标准差的上限。超过时该帧视为失败。</translation>
        </message>
        <message>
            <source>Time by which the clock of the inertial unit is ahead of that of the scanner. auto: estimated where the mount of the unit is not known, else 0.</source>
            <translation>惯性单元的时钟比扫描仪的时钟快多少。auto:安装关系未知时估计,否则为 0。</translation>
        </message>
        <message>
            <source>Part of the file to read: xmin,ymin,xmax,ymax in the coordinates of the file (or six numbers, with z). Of a COPC file only what lies there is decoded. Empty: all points.</source>
            <translation>要读取的部分:xmin,ymin,xmax,ymax,采用文件的坐标(或带 z 的六个数)。COPC 文件只解码该范围内的数据。留空:全部点。</translation>
        </message>
        <message>
            <source>Spacing of the points, in the unit of the file, that is fine enough: a COPC file is read down to the first level of its octree that has it. 0: all points. Other formats have no levels.</source>
            <translation>足够细的点间距,采用文件的单位:COPC 文件读到八叉树中达到该间距的第一层为止。0:全部点。其他格式没有分层。</translation>
        </message>
        <message>
            <source>Whether the poses of the scans of an E57 file are places of the scanner, from which rays go out. auto: where scans have angles, a grid, or poses that say something.</source>
            <translation>E57 文件各测站的位姿是否为扫描仪发出射线的位置。自动:测站带有角度、网格或有意义的位姿时采用。</translation>
        </message>
        <message>
            <source>Projected coordinate system of the points, for instance EPSG:25832, to which a path in longitude and latitude (SBET) is turned.</source>
            <translation>点云的投影坐标系,例如 EPSG:25832;经纬度路径(SBET)会转换到该坐标系。</translation>
        </message>
        <message>
            <source>Seconds to add to the times of the trajectory to get those of the points. auto: by the clocks that both can have (GPS, GPS less 1e9 s, GPS week, UTC).</source>
            <translation>轨迹时间加上该秒数即为点的时间。自动:按两者可能的时钟确定(GPS、减去 1e9 秒的 GPS、GPS 周内秒、UTC)。</translation>
        </message>
        <message>
            <source>Poses further apart than this are not connected: points between them get no ray.</source>
            <translation>时间间隔超过该值的位姿不相连:其间的点没有射线。</translation>
        </message>
        <message>
            <source>A new pass begins where the path comes this near to an earlier part of the pass. Passes are measured apart from one another.</source>
            <translation>路径与本趟较早的部分接近到该距离时开始新的一趟。各趟分别测量。</translation>
        </message>
        <message>
            <source>Greatest distance of the nearest hundredth of the points from the sensor. More means that path and points have different coordinate systems, and is refused.</source>
            <translation>距传感器最近的百分之一的点所允许的最大距离。超过则说明路径与点云的坐标系不同,会被拒绝。</translation>
        </message>
        <message>
            <source>Folder of views to read, or the file that describes them: %1.</source>
            <translation>要读取的视图文件夹,或描述它的文件:%1。</translation>
        </message>
        <message>
            <source>Layout of the folder. auto decides by the names of its files.</source>
            <translation>文件夹的组织格式。自动(auto):按其中的文件名判断。</translation>
        </message>
        <message>
            <source>Camera of the views: a file camera.json, fx,fy,cx,cy in pixels, or a name such as tum_freiburg1, icl_nuim or primesense; unknown for pictures of a calibration board. Empty takes the one of the folder.</source>
            <translation>视图的相机:文件 camera.json、以像素表示的 fx,fy,cx,cy,或名称,如 tum_freiburg1、icl_nuim、primesense;标定板图片用 unknown。留空则用文件夹中的相机。</translation>
        </message>
        <message>
            <source>Take one view of this many. A larger value is faster and has less overlap.</source>
            <translation>每隔这么多视图取一个。数值越大越快,重叠越少。</translation>
        </message>
        <message>
            <source>Largest number of views, spread evenly over the sequence.</source>
            <translation>最多取用的视图数,在序列中均匀分布。</translation>
        </message>
        <message>
            <source>Units of the depth images per metre: 1000 for millimetres, 5000 for TUM and ICL. auto takes what the folder says.</source>
            <translation>深度图像每米的单位数:毫米为 1000,TUM 和 ICL 为 5000。自动(auto):按文件夹中的说明。</translation>
        </message>
        <message>
            <source>Depth beyond this is ignored.</source>
            <translation>忽略大于此值的深度。</translation>
        </message>
        <message>
            <source>Kind of the board. auto takes the board that comes with the views (mat.json).</source>
            <translation>标定板的种类。自动(auto):取随视图给出的标定板(mat.json)。</translation>
        </message>
        <message>
            <source>Squares of the board across.</source>
            <translation>标定板横向的方格数。</translation>
        </message>
        <message>
            <source>Squares of the board downwards.</source>
            <translation>标定板纵向的方格数。</translation>
        </message>
        <message>
            <source>Side of a square.</source>
            <translation>一个方格的边长。</translation>
        </message>
        <message>
            <source>Side of a marker.</source>
            <translation>一个标记的边长。</translation>
        </message>
        <message>
            <source>Dictionary of the markers, for instance DICT_4X4_50.</source>
            <translation>标记所用的字典,例如 DICT_4X4_50。</translation>
        </message>
        <message>
            <source>Coefficients of the lens that are fitted. auto takes those that the corners support (Bayesian information criterion).</source>
            <translation>要拟合的镜头畸变系数。自动(auto):取角点所支持的系数(贝叶斯信息准则)。</translation>
        </message>
        <message>
            <source>Views whose residual is larger than the median by this factor are left out, up to a third of all.</source>
            <translation>残差大于中位数这么多倍的视图会被舍去,最多舍去三分之一。</translation>
        </message>
        <message>
            <source>Compare depth images with the board: the place of the depth camera, and how its depth is off.</source>
            <translation>将深度图像与标定板比较:求深度相机的位置和深度的偏差。</translation>
        </message>
        <message>
            <source>Width of the images; needed for a table of corners.</source>
            <translation>图像宽度;使用角点表时需要。</translation>
        </message>
        <message>
            <source>Height of the images; needed for a table of corners.</source>
            <translation>图像高度;使用角点表时需要。</translation>
        </message>
            <message>
            <source>slam: poses from features, depth and the board. given: poses that came with the views, checked against matches and depth.</source>
            <translation>slam:由特征、深度和标定板求位姿。given:采用随视图给出的位姿,并用匹配和深度检查。</translation>
        </message>
        <message>
            <source>Kind of features: sift finds more of them again, orb is faster.</source>
            <translation>特征的类型:sift 能更多地重新找到同一特征,orb 更快。</translation>
        </message>
        <message>
            <source>Largest number of features in a view, spread over the image. More features take longer to match and help where texture is poor.</source>
            <translation>每个视图中特征的最大数目,在图像上均匀分布。特征越多匹配越慢,纹理贫乏时有帮助。</translation>
        </message>
        <message>
            <source>Wider images are reduced to this width for features. A larger width finds finer texture and takes longer.</source>
            <translation>更宽的图像在提取特征前缩小到此宽度。宽度越大,能找到的纹理越细,耗时越长。</translation>
        </message>
        <message>
            <source>Largest distance to the best descriptor over that to the next best. A larger ratio keeps more matches, of which more are wrong.</source>
            <translation>最佳描述子距离与次佳描述子距离之比的上限。比值越大保留的匹配越多,其中错误也越多。</translation>
        </message>
        <message>
            <source>Drops matches that do not move along with their neighbours (grid-based motion statistics).</source>
            <translation>剔除不随邻近匹配一起移动的匹配(基于网格的运动统计)。</translation>
        </message>
        <message>
            <source>Largest distance of a match from the rigid motion of its pair, in an image 1280 pixels wide.</source>
            <translation>匹配偏离该视图对刚体运动的最大距离,按 1280 像素宽的图像计。</translation>
        </message>
        <message>
            <source>Two views are connected when at least this many matches agree with one rigid motion.</source>
            <translation>至少有这么多匹配符合同一刚体运动时,两个视图才相连。</translation>
        </message>
        <message>
            <source>Each view is matched with this many views after it.</source>
            <translation>每个视图与其后这么多个视图匹配。</translation>
        </message>
        <message>
            <source>Largest number of further views that each view is matched with because they show the same place. 0: no loops are closed.</source>
            <translation>每个视图因拍到同一处而另外匹配的视图的最大数目。0:不闭合回环。</translation>
        </message>
        <message>
            <source>Standard deviation of a depth of 1 m; it grows with the square of the depth. auto: learnt from the residuals.</source>
            <translation>1 m 处深度的标准差;它随深度的平方增大。auto:由残差估计。</translation>
        </message>
        <message>
            <source>Uses the ChArUco board under the plant for axes, scale and poses, where the views have one.</source>
            <translation>视图中有植株下的 ChArUco 标定板时,用它确定坐标轴、尺度和位姿。</translation>
        </message>
        <message>
            <source>Whether the camera stands still and the object turns, so that the still background is left out. auto: decided from the motions in the images.</source>
            <translation>相机静止而物体转动时,排除静止的背景。auto:由图像中的运动判断。</translation>
        </message>
        <message>
            <source>Estimates one factor of the focal lengths along with the poses. Needs a board or good depth.</source>
            <translation>与位姿一起估计焦距的一个系数。需要标定板或良好的深度。</translation>
        </message>
        <message>
            <source>Also finds poses where there is neither depth nor a board. Lengths are then in units of the median distance of the points, not in metres.</source>
            <translation>既无深度也无标定板时也求位姿。此时长度以各点距离的中位数为单位,而不是米。</translation>
        </message>
        <message>
            <source>Edge length of the voxels. Smaller voxels keep thinner parts and need more memory.</source>
            <translation>体素边长。较小的体素保留更细的部分，但占用更多内存。</translation>
        </message>
        <message>
            <source>Box in world axes: min x, y, z, max x, y, z in metres. Empty: found from the views.</source>
            <translation>世界坐标中的长方体：最小 x、y、z，最大 x、y、z，单位为米。留空：由视图自动确定。</translation>
        </message>
        <message>
            <source>Also make a mesh: outputs vertices and triangles.</source>
            <translation>同时生成网格：输出 vertices 和 triangles。</translation>
        </message>
        <message>
            <source>How far from a measured depth the distance is recorded. A larger value closes gaps and thickens thin parts. auto: 4 voxels, or 1.5 standard deviations of the depth.</source>
            <translation>在测得深度前后多远处记录距离。较大的值能填补空隙，但会使细部变粗。auto：4 个体素，或深度标准差的 1.5 倍。</translation>
        </message>
        <message>
            <source>Standard deviation of a depth at 0.5 m. It grows with the square of the distance.</source>
            <translation>0.5 m 处深度的标准差。它随距离的平方增大。</translation>
        </message>
        <message>
            <source>Weight that a surface needs: 1 is one straight view from 0.5 m. A larger value removes parts that few views saw.</source>
            <translation>表面所需的权重：1 表示从 0.5 m 处正对的一个视图。较大的值会去掉少数视图看到的部分。</translation>
        </message>
        <message>
            <source>Share of the views that must see a place for it to be in the region.</source>
            <translation>一处位置须被多大比例的视图看到，才属于测量区域。</translation>
        </message>
        <message>
            <source>Memory for voxels. Larger voxels are used where this is not enough.</source>
            <translation>体素可用的内存。不够时使用较大的体素。</translation>
        </message>
        <message>
            <source>What holds density and colour: grid is a voxel lattice, hash a multiresolution hash table with a small network, paper a network alone (slow).</source>
            <translation>密度和颜色的存储方式：grid 为体素格网，hash 为多分辨率哈希表加小型网络，paper 仅为网络（较慢）。</translation>
        </message>
        <message>
            <source>Finest detail of the field. Smaller values keep thinner parts and need more memory and time.</source>
            <translation>辐射场的最细尺度。较小的值保留更细的部分，但需要更多内存和时间。</translation>
        </message>
        <message>
            <source>What is behind the plant: a scene, or white or black in pictures of an object alone, or where masks show it.</source>
            <translation>植株背后是什么：真实场景，或白色、黑色（图片中只有物体，或有掩膜标出物体时）。</translation>
        </message>
        <message>
            <source>Time for the training. It is ended, with its schedule, when this is used up before steps are done.</source>
            <translation>训练时间。时间用完时即使步数未满，训练也会按计划结束。</translation>
        </message>
        <message>
            <source>File that keeps the state of the training, written every half minute. A training that was interrupted, or ended early, goes on from it.</source>
            <translation>保存训练状态的文件，每半分钟写一次。被中断或提前结束的训练从它继续。</translation>
        </message>
        <message>
            <source>Steps of the training. More steps give a sharper field.</source>
            <translation>训练步数。步数越多，辐射场越清晰。</translation>
        </message>
        <message>
            <source>Rays of each step.</source>
            <translation>每步的光线数。</translation>
        </message>
        <message>
            <source>Pictures much wider than this are made smaller by a whole number. Larger pictures show finer detail and need more steps.</source>
            <translation>比此宽得多的图片按整数倍缩小。较大的图片显示更细的细节，但需要更多步数。</translation>
        </message>
        <message>
            <source>Every n-th view is kept back to test the field, unless the data say which; 0 keeps none.</source>
            <translation>每隔 n 个视图保留一个用于检验，除非数据已指定；0 表示不保留。</translation>
        </message>
        <message>
            <source>Estimate the exposure of each view, for cameras that set it by themselves.</source>
            <translation>估计每个视图的曝光，适用于自动曝光的相机。</translation>
        </message>
        <message>
            <source>Refine the poses of the views together with the field. The scale of the given poses stays.</source>
            <translation>与辐射场一起优化视图的位姿。给定位姿的尺度保持不变。</translation>
        </message>
        <message>
            <source>Weight of measured depth beside colour. 0 uses colour alone.</source>
            <translation>实测深度相对于颜色的权重。0 表示只用颜色。</translation>
        </message>
        <message>
            <source>Spacing of the points of the cloud. 0 keeps all.</source>
            <translation>点云的点间距。0 表示保留全部点。</translation>
        </message>
        <message>
            <source>Views that must agree on a point of the cloud. A larger value removes more stray points.</source>
            <translation>点云中的点须有多少个视图一致。较大的值会去掉更多杂点。</translation>
        </message>
        <message>
            <source>Largest difference of depths that agree.</source>
            <translation>视为一致的深度之间的最大差值。</translation>
        </message>
        <message>
            <source>Memory for the field. Larger voxels are used where this is not enough.</source>
            <translation>辐射场可用的内存。不够时使用较大的体素。</translation>
        </message>
        <message>
            <source>Seed of the random choice of rays. The same seed gives the same field.</source>
            <translation>随机选取光线的种子。相同的种子得到相同的辐射场。</translation>
        </message>
        <message>
            <source>Hidden layers of the network. NeRF has 8; more take longer.</source>
            <translation>网络的隐藏层数。NeRF 为 8 层；层数越多越慢。</translation>
        </message>
        <message>
            <source>Width of the hidden layers. NeRF has 256; wider layers take longer.</source>
            <translation>隐藏层的宽度。NeRF 为 256；越宽越慢。</translation>
        </message>
        <message>
            <source>Frequencies of the positional encoding. More show finer detail and more noise.</source>
            <translation>位置编码的频率数。频率越多，细节越细，噪声也越多。</translation>
        </message>
        <message>
            <source>Integrate the encoding over the cone of a pixel (mip-NeRF).</source>
            <translation>在像素的视锥内对编码积分（mip-NeRF）。</translation>
        </message>
        <message>
            <source>Which of the poses connected, from 0. Without poses the first view is shown.</source>
            <translation>使用所连接位姿中的第几个，从 0 起。没有位姿时显示第一个视图。</translation>
        </message>
        <message>
            <source>Width of the picture.</source>
            <translation>图片的宽度。</translation>
        </message>
        <message>
            <source>Pictures much wider than this are made smaller by a whole number. Larger pictures take longer and show thinner parts.</source>
            <translation>比此宽得多的图片按整数倍缩小。较大的图片耗时更长，能显示更细的部分。</translation>
        </message>
        <message>
            <source>Views that each view is matched with.</source>
            <translation>每个视图与多少个视图匹配。</translation>
        </message>
        <message>
            <source>Iterations of the matching. More of them fill more pixels.</source>
            <translation>匹配的迭代次数。次数越多，填充的像素越多。</translation>
        </message>
        <message>
            <source>One minus the correlation that a match needs. A larger value keeps weaker matches.</source>
            <translation>匹配所需的 1 减相关系数。较大的值保留较弱的匹配。</translation>
        </message>
        <message>
            <source>Views that must agree on a point. A larger value removes more stray points.</source>
            <translation>一个点须有多少个视图一致。较大的值会去掉更多杂点。</translation>
        </message>
        <message>
            <source>Direction that is up. auto takes z where the axes come from a board, else the direction out of the largest plane (table, mat or soil), else z.</source>
            <translation>朝上的方向。auto：坐标轴来自标定板时取 z，否则取离开最大平面（桌面、标定垫或土壤）的方向，再否则取 z。</translation>
        </message>
        <message>
            <source>Unit of the cloud. auto: metres where a board, given poses or a depth camera fixed the scale, else unknown; traits are then in thousandths of the unit and flagged.</source>
            <translation>点云的单位。auto：由标定板、给定位姿或深度相机确定尺度时为米，否则未知；此时性状以单位的千分之一给出并作标记。</translation>
        </message>
        <message>
            <source>Box that is kept: min_x min_y min_z max_x max_y max_z in the axes of the cloud. Points outside of it become other.</source>
            <translation>保留的范围框：点云坐标轴中的 min_x min_y min_z max_x max_y max_z。框外的点归为其他。</translation>
        </message>
        <message>
            <source>Place where the stem leaves the soil: x y z in the axes of the cloud. Empty: it is found from the points.</source>
            <translation>茎离开土壤的位置：点云坐标轴中的 x y z。留空则由点求得。</translation>
        </message>
        <message>
            <source>Widest gap across which a part of the cloud still belongs to the plant. Larger values keep leaves whose stalks were not reconstructed, and floaters near the plant.</source>
            <translation>点云的一部分仍算作植株时允许的最大间隙。较大的值会保留叶柄未被重建的叶片，以及植株附近的漂浮点。</translation>
        </message>
        <message>
            <source>Distance from the surfaces of pot, soil and mat within which points belong to them. Raised by itself where the cloud is coarser.</source>
            <translation>点到花盆、土壤和标定垫表面的距离，在此之内的点归属它们。点云较粗时自动增大。</translation>
        </message>
        <message>
            <source>Removes floaters from the output instead of marking them.</source>
            <translation>从输出中删除漂浮点，而不是只作标记。</translation>
        </message>
        <message>
            <source>Height above the soil at which the diameter of the stem is measured.</source>
            <translation>测量茎直径处距土壤的高度。</translation>
        </message>
        <message>
            <source>contours: the edges of the stem in the pictures. cloud: the points about its axis, which are too wide for thin stems. auto: contours where pictures show them, else cloud.</source>
            <translation>contours：图像中茎的边缘。cloud：茎轴周围的点，对细茎偏宽。auto：图像能看到茎时用 contours，否则用 cloud。</translation>
        </message>
        <message>
            <source>Length of stem around stem_height that is fitted. A longer one takes more pictures of the edges, and more petioles.</source>
            <translation>在 stem_height 附近参与拟合的茎长。较长时图像中的边缘更多，叶柄也更多。</translation>
        </message>
        <message>
            <source>Most views whose pictures are used for the stem; they are chosen evenly.</source>
            <translation>用于测茎的视图的最大数目；均匀选取。</translation>
        </message>
        <message>
            <source>How the codes of the pictures become light. srgb undoes the usual curve, linear takes the codes as they are, auto takes what explains the edges better.</source>
            <translation>图像编码如何换算为光强。srgb 还原常用曲线，linear 直接使用编码，auto 选用更能解释边缘的一种。</translation>
        </message>
        <message>
            <source>Standard error of the scale of the poses. It widens all intervals.</source>
            <translation>位姿尺度的标准误差。它使所有区间变宽。</translation>
        </message>
        <message>
            <source>Error of the cloud's outermost surface that its points share, so that they cannot show it. It widens the intervals of height and breadth.</source>
            <translation>点云最外表面上各点共有、因而点自身无法显示的误差。它使高度和冠幅的区间变宽。</translation>
        </message>
        <message>
            <source>How far from the outermost points of the cloud the pictures are searched for the ends of leaves. A larger value finds tips that the cloud has lost, and more things behind them.</source>
            <translation>在图像中从点云最外侧的点向外搜索叶片末端的距离。较大的值能找到点云丢失的叶尖，也会碰到其后的更多物体。</translation>
        </message>
        <message>
            <source>Name of the plant in the table. Empty: the name of the folder of the views.</source>
            <translation>表中植株的名称。留空则取视图文件夹的名称。</translation>
        </message>
        <message>
            <source>List of edits as JSON, in the order in which they were made.</source>
            <translation>JSON 格式的编辑列表，按编辑的先后顺序。</translation>
        </message>
        <message>
            <source>File with such a list, applied before edits.</source>
            <translation>包含此类列表的文件，先于 edits 应用。</translation>
        </message>
        <message>
            <source>Draw the figures and write them as PNG, SVG and PDF.</source>
            <translation>绘制插图,并写成 PNG、SVG 和 PDF。</translation>
        </message>
        <message>
            <source>Write scene.ply: all points, with the part that each belongs to, beside cloud.ply, which has the plant alone.</source>
            <translation>除只含植株的 cloud.ply 外,另写 scene.ply:全部点及其所属部位。</translation>
        </message>
        <message>
            <source>Control points as CSV: name, easting_m, northing_m, height_m (or latitude_deg, longitude_deg). A point belongs to the target of its name (centre, north), or to x_m, y_m in the same row.</source>
            <translation>控制点 CSV 文件:name, easting_m, northing_m, height_m(或 latitude_deg, longitude_deg)。点对应同名标靶(centre, north),或对应同一行的 x_m, y_m。</translation>
        </message>
        <message>
            <source>Projected coordinate system of the control points and of all exports: an EPSG code (EPSG:25832) or WKT. Empty with latitude and longitude: the UTM zone.</source>
            <translation>控制点和所有导出文件的投影坐标系:EPSG 代码(EPSG:25832)或 WKT。给出经纬度而此项为空时:所在的 UTM 带。</translation>
        </message>
        <message>
            <source>Standard deviation of the easting and northing of a control point; a column sd_m of the file goes before it. auto: from the residuals, or 0.02 m where there are too few.</source>
            <translation>控制点东、北坐标的标准差;文件中的 sd_m 列优先。自动:由残差求得,点数不足时取 0.02 m。</translation>
        </message>
        <message>
            <source>Standard deviation of the height of a control point; a column height_sd_m goes before it. auto: from the residuals, or 0.03 m where there are too few.</source>
            <translation>控制点高程的标准差;文件中的 height_sd_m 列优先。自动:由残差求得,点数不足时取 0.03 m。</translation>
        </message>
        <message>
            <source>Standard deviation of a place in the map (drift of the SLAM): of targets and of stems.</source>
            <translation>地图中点位的标准差(SLAM 漂移),用于标靶和单木。</translation>
        </message>
        <message>
            <source>A greater residual of a control point that is used is an error: the points do not fit the plot.</source>
            <translation>所用控制点的残差超过此值即报错:控制点与样地不符。</translation>
        </message>
        <message>
            <source>Leave out a control point that all others contradict. It is reported in either case.</source>
            <translation>剔除与其余各点都矛盾的控制点。无论是否剔除都会报告。</translation>
        </message>
        <message>
            <source>one: a metre in the plot is a metre on the plane; grid: times the scale of the projection and the reduction of the height. auto: one, unless the residuals contradict it and agree with grid.</source>
            <translation>1:样地中的一米即平面上的一米;格网:再乘以投影比例和高程归化。自动:取 1,除非残差与之矛盾而与格网相符。</translation>
        </message>
        <message>
            <source>What the height of a control point with the name of a target was measured on: the target itself, or the ground below it.</source>
            <translation>以标靶命名的控制点,其高程测自何处:标靶本身,或其下方的地面。</translation>
        </message>
        <message>
            <source>Level the plot by the control heights, where there are three or more that are not on a line.</source>
            <translation>有三个以上不共线的控制高程时,按其整平样地。</translation>
        </message>
        <message>
            <source>Standard deviation of the level that the plot already has; 0.1 deg from stems. A larger value lets the control heights count more.</source>
            <translation>样地原有水平的标准差;由树干求得时为 0.1 度。数值越大,控制高程的作用越大。</translation>
        </message>
        <message>
            <source>Easting of the centre (the centre target, or the origin of the axes), in place of a file.</source>
            <translation>中心(中心标靶或坐标原点)的东坐标,代替文件。</translation>
        </message>
        <message>
            <source>Northing of the centre.</source>
            <translation>中心的北坐标。</translation>
        </message>
        <message>
            <source>Latitude of the centre, in place of easting and northing.</source>
            <translation>中心的纬度,代替东、北坐标。</translation>
        </message>
        <message>
            <source>Longitude of the centre, east positive.</source>
            <translation>中心的经度,东经为正。</translation>
        </message>
        <message>
            <source>Height of the centre.</source>
            <translation>中心的高程。</translation>
        </message>
        <message>
            <source>Bearing from the centre target to the north target, clockwise; without a north target that of the y axis of the map. Needed with one control point.</source>
            <translation>由中心标靶到北标靶的方位角,顺时针;没有北标靶时为地图 y 轴的方位角。只有一个控制点时必须给出。</translation>
        </message>
        <message>
            <source>North of the bearing: that of the compass, of the grid of the coordinate system, or true north. The convergence of the meridians is computed.</source>
            <translation>方位角所依据的北方向:磁北、坐标系格网北或真北。子午线收敛角自动计算。</translation>
        </message>
        <message>
            <source>Magnetic declination: bearing of magnetic north from true north, east positive.</source>
            <translation>磁偏角:磁北相对真北的方位角,东偏为正。</translation>
        </message>
        <message>
            <source>Standard deviation of the bearing.</source>
            <translation>方位角的标准差。</translation>
        </message>
        <message>
            <source>Time of the walk minus time of a GNSS track, about; it is adjusted. auto: by the usual clocks (UTC, GPS time, time of day) and the shape of the walk.</source>
            <translation>行走时间减去 GNSS 轨迹时间的概值,随后平差求定。自动:依据常用时钟(UTC、GPS 时、当日时间)和行走路线的形状。</translation>
        </message>
        <message>
            <source>How far from there the offset is searched.</source>
            <translation>在该值前后搜索时钟差的范围。</translation>
        </message>
        <message>
            <source>Antenna from the sensor along the sensor&apos;s x axis, about; it is adjusted.</source>
            <translation>天线相对传感器沿其 x 轴偏移的概值,随后平差求定。</translation>
        </message>
        <message>
            <source>The same along its y axis.</source>
            <translation>沿其 y 轴,同上。</translation>
        </message>
        <message>
            <source>The same along its z axis.</source>
            <translation>沿其 z 轴,同上。</translation>
        </message>
        <message>
            <source>Standard deviation of lever_x, lever_y and lever_z; small where they were measured.</source>
            <translation>lever_x, lever_y 和 lever_z 的标准差;实测过时取小值。</translation>
        </message>
        <message>
            <source>Standard deviation of an error that all positions of the track share, which residuals cannot show. auto: by their quality, 0.02 m for RTK fixed, 0.5 m for float, 1 m for differential, 3 m else.</source>
            <translation>轨迹所有点位共有、残差无法显示的误差的标准差。自动:按定位质量,RTK 固定解 0.02 m,浮点解 0.5 m,差分 1 m,其余 3 m。</translation>
        </message>
        <message>
            <source>Side of the cells of the maps. Larger cells overlook smaller holes.</source>
            <translation>各图单元的边长。单元越大,越容易漏掉小空洞。</translation>
        </message>
        <message>
            <source>Ground points from which the ground of a cell counts as seen.</source>
            <translation>单元的地面算作看到所需的地面点数。</translation>
        </message>
        <message>
            <source>Share of the plot whose ground may be unseen before the verdict is look.</source>
            <translation>结论变为查看之前,样地中允许未看到地面的比例。</translation>
        </message>
        <message>
            <source>Share of the plot whose ground may be unseen before the verdict is walk again.</source>
            <translation>结论变为重走之前,样地中允许未看到地面的比例。</translation>
        </message>
        <message>
            <source>Largest connected area of unseen ground that is accepted.</source>
            <translation>可接受的未见地面的最大连通面积。</translation>
        </message>
        <message>
            <source>Distance from the walk that is accepted everywhere. Farther places count as not walked when the rest of the plot was walked more closely.</source>
            <translation>处处可接受的离行走路线的距离。样地其余部分走得更密时,更远的地方算作没有走到。</translation>
        </message>
        <message>
            <source>Angle that the directions of view of a cell must span, or the cell counts as seen from one side.</source>
            <translation>单元的观测方向至少要张开的角度,否则算作只从一侧看到。</translation>
        </message>
        <message>
            <source>Share of the plot that may be seen from one side only.</source>
            <translation>样地中允许只从一侧看到的比例。</translation>
        </message>
        <message>
            <source>Ground points of a cell, as a share of the median cell, below which it counts as sparse. Sparse cells are reported where they are more than max_one_sided of the plot.</source>
            <translation>单元地面点数占中位单元的比例,低于此值算作稀疏。稀疏单元超过样地的 max_one_sided 时报告。</translation>
        </message>
        <message>
            <source>Distance between the surfaces of two passes that is accepted (median over the plot).</source>
            <translation>可接受的两次经过的表面间距(样地中位数)。</translation>
        </message>
        <message>
            <source>Distance between the surfaces of two passes from which the verdict is walk again.</source>
            <translation>两次经过的表面间距达到此值时结论为重走。</translation>
        </message>
        <message>
            <source>Scatter of the points about the bark that is accepted (median over the stems). Allow more for a sensor with more noise.</source>
            <translation>可接受的点相对树皮的离散(单木中位数)。噪声较大的传感器应放宽。</translation>
        </message>
        <message>
            <source>By how much the walk may be too long or too short, as a share of its length. Stems that were seen from near and from far tell it.</source>
            <translation>行走路径过长或过短的允许比例。由从近处和远处都看到的单木得出。</translation>
        </message>
        <message>
            <source>Disagreement between a loop closure and the final trajectory that is accepted.</source>
            <translation>可接受的回环与最终轨迹之差。</translation>
        </message>
        <message>
            <source>The same as an angle.</source>
            <translation>同上,以角度计。</translation>
        </message>
        <message>
            <source>Common lean of the stems that is accepted. More means a tilted frame, or a stand that leans.</source>
            <translation>可接受的单木共同倾斜。超过时说明坐标系倾斜或林分倾斜。</translation>
        </message>
        <message>
            <source>Number of targets that stood in the plot. 0: none was needed.</source>
            <translation>样地中设置的靶标数。0:不需要靶标。</translation>
        </message>
        <message>
            <source>Distance of the two targets by tape. 0: not known.</source>
            <translation>用卷尺量得的两靶标距离。0:未知。</translation>
        </message>
        <message>
            <source>Difference from target_distance that is accepted.</source>
            <translation>可接受的与 target_distance 之差。</translation>
        </message>
        <message>
            <source>Trees at the boundary that are in. centre: centre at breast height inside; base: centre of the foot inside; whole: the whole stem inside; any_part: any part of it; half: any part on the southern and western edges, the whole stem on the others.</source>
            <translation>哪些边界木算在内。centre:胸高处中心在内;base:树基中心在内;whole:整个树干在内;any_part:任一部分在内;half:南边和西边任一部分在内,其余两边整个树干在内。</translation>
        </message>
        <message>
            <source>Standard error of a stem's place against the boundary. Trees nearer than twice this are in doubt.</source>
            <translation>单木位置相对边界的标准误。距离小于其两倍的树存疑。</translation>
        </message>
        <message>
            <source>Share of the basal area that trees in doubt at the boundary may hold.</source>
            <translation>边界存疑的树允许占断面积的比例。</translation>
        </message>
        <message>
            <source>Diameter from which an upright round structure without a stem in the table is reported.</source>
            <translation>达到此直径的直立圆形结构若表中没有单木,则报告。</translation>
        </message>
        <message>
            <source>Share of the stems that may stand where no ground was seen within 1 m.</source>
            <translation>允许 1 m 内未看到地面的单木比例。</translation>
        </message>
        <message>
            <source>Axes of the two tables. search: not known, the trees bring the maps together; same: they lie in the same axes already, and only the rest is fitted.</source>
            <translation>两张表的坐标系。search:未知,由树木把两图合到一起;same:已在同一坐标系中,只拟合剩余的差。</translation>
        </message>
        <message>
            <source>Years between the two surveys. auto: from the fact date or recorded of both tables (2024-05-31); without one growth is given for the whole time only.</source>
            <translation>两次调查相隔的年数。auto:取自两张表的 date 或 recorded(2024-05-31);没有时只给出整个时段的生长量。</translation>
        </message>
        <message>
            <source>Distance at breast height up to which two stems are the same tree. Larger values match stems that were measured badly, and neighbours.</source>
            <translation>胸高处两株单木视为同一株的最大距离。较大的值会匹配测得不好的单木,也会匹配邻木。</translation>
        </message>
        <message>
            <source>Largest growth of a diameter per year. Thicker trees that are new were missed in the first survey, they did not grow in.</source>
            <translation>胸径每年的最大生长量。新出现而更粗的树是第一次调查漏掉的,不是进界木。</translation>
        </message>
        <message>
            <source>How much thinner a tree may seem in the second survey and still be the same.</source>
            <translation>一株树在第二次调查中可以显得细多少而仍视为同一株。</translation>
        </message>
        <message>
            <source>Diameter from which trees count. A tree that reaches it between the surveys is ingrowth.</source>
            <translation>计数的起测胸径。两次调查之间达到它的树为进界木。</translation>
        </message>
        <message>
            <source>Standard deviation of the error that all diameters of one survey share. It widens the interval of the mean growth, which more trees do not narrow.</source>
            <translation>一次调查中所有胸径共有误差的标准差。它加宽平均生长量的区间,树再多也不会使其变窄。</translation>
        </message>
        <message>
            <source>Standard error of diameters without an interval (dbh_lo_cm, dbh_hi_cm).</source>
            <translation>没有区间(dbh_lo_cm,dbh_hi_cm)的胸径的标准误。</translation>
        </message>
        <message>
            <source>Draw the map and the growth and write them as PNG, SVG and PDF.</source>
            <translation>绘制分布图和生长量图,写成 PNG,SVG 和 PDF。</translation>
        </message>
        <message>
            <source>Output folders of bole run or bole survey, with commas between.</source>
            <translation>bole run 或 bole survey 的输出文件夹，用逗号分隔。</translation>
        </message>
        <message>
            <source>Names of the runs in tables and figures, with commas between; empty: the names of the folders.</source>
            <translation>各次运行在表格和插图中的名称，用逗号分隔；留空：用文件夹名。</translation>
        </message>
        <message>
            <source>What made each run, with commas between. Runs of one system are pooled; empty: the preset of each run.</source>
            <translation>每次运行所用的系统，用逗号分隔。同一系统的运行合并统计；留空：用各次运行的预设。</translation>
        </message>
        <message>
            <source>Plot of each run, with commas between. plot1 to plot4 list the published figures of these plots; empty: runs whose stems agree share a plot.</source>
            <translation>每次运行的样地，用逗号分隔。plot1 至 plot4 会列出论文中这些样地的数值；留空：单木一致的运行视为同一样地。</translation>
        </message>
        <message>
            <source>Share of the stems of the shorter list that must agree before two lists count as one plot in the same axes. A larger value lets less certain ones fall apart.</source>
            <translation>较短列表中一致单木的最小比例，达到时两份列表才视为同一坐标系中的同一样地。值越大，不够确定的越会分开。</translation>
        </message>
        <message>
            <source>System of the paper whose published figures are listed. auto: that of the preset which made the trajectory, improved_loam where the paper has none.</source>
            <translation>列出论文中哪个系统的数值。auto：生成轨迹的预设所对应的系统；论文中没有时用 improved_loam。</translation>
        </message>
        <message>
            <source>Read the clouds of the runs and draw paths and slices on them. This takes the most time.</source>
            <translation>读取各次运行的点云，在其上绘制轨迹和横切面。这一步最费时。</translation>
        </message>
        <message>
            <source>Resolution of the PNG files.</source>
            <translation>PNG 文件的分辨率。</translation>
        </message>
        <message>
            <source>Trees whose slices are drawn.</source>
            <translation>绘制横切面的树木数量。</translation>
        </message>
        <message>
            <source>Factor by which the map of positions enlarges the errors. auto: so that they can be seen.</source>
            <translation>位置图中误差的放大倍数。auto：放大到可以看清。</translation>
        </message>
        <message>
            <source>Radii of the sample plots in metres, for instance "5 10 15".</source>
            <translation>样地的半径（米），例如 "5 10 15"。</translation>
        </message>
        <message>
            <source>Number of sample plots of each size. More plots give steadier means.</source>
            <translation>每种大小的样地数。样地越多，均值越稳定。</translation>
        </message>
        <message>
            <source>Seed of the places of the plots. The same seed gives the same plots.</source>
            <translation>样地位置的随机种子。相同的种子给出相同的样地。</translation>
        </message>
        <message>
            <source>Constant error of the distance from the centre of a plot to a tree. Negative: trees beyond the boundary count.</source>
            <translation>样地中心到树木距离的固定误差。负值：边界外的树木也被计入。</translation>
        </message>
        <message>
            <source>Standard deviation of the error of this distance from tree to tree.</source>
            <translation>该距离误差在树与树之间的标准差。</translation>
        </message>
        <message>
            <source>Draw the curves and write them as PNG, SVG and PDF.</source>
            <translation>绘制曲线并保存为 PNG、SVG 和 PDF。</translation>
        </message>
        <message>
            <source>Easting of the sensor, from a receiver. Leave 0 where its marks are connected.</source>
            <translation>传感器的东坐标，来自接收机。连接标志时保持为 0。</translation>
        </message>
        <message>
            <source>vectors: least squares over all coordinates of the marks as they are seen; ranges: the position from the ranges alone and the heading from directions, as in the paper.</source>
            <translation>vectors：对标志的全部可见坐标作最小二乘；ranges：位置仅由距离求得，航向由方向求得，与论文相同。</translation>
        </message>
        <message>
            <source>Roll of the sensor about its x axis. Leave 0 where the seen coordinates are levelled already.</source>
            <translation>传感器绕其 x 轴的横滚角。可见坐标已调平时保持为 0。</translation>
        </message>
        <message>
            <source>Pitch of the sensor about its y axis. Leave 0 where the seen coordinates are levelled already.</source>
            <translation>传感器绕其 y 轴的俯仰角。可见坐标已调平时保持为 0。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of the known positions in plan.</source>
            <translation>已知平面位置每轴的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the known heights.</source>
            <translation>已知高程的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the range to a mark.</source>
            <translation>到标志距离的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the direction to a mark.</source>
            <translation>到标志方向的标准差。</translation>
        </message>
        <message>
            <source>Standard deviation of the levelling, the same for all marks.</source>
            <translation>调平的标准差，对所有标志相同。</translation>
        </message>
        <message>
            <source>Largest standard error of the position in plan that is accepted.</source>
            <translation>可接受的平面位置标准误差上限。</translation>
        </message>
        <message>
            <source>Largest standard error of the heading that is accepted.</source>
            <translation>可接受的航向标准误差上限。</translation>
        </message>
        <message>
            <source>Distance between neighbouring lines. log: as the log or the lines give it.</source>
            <translation>相邻导航线的间距。log：取日志或导航线给出的值。</translation>
        </message>
        <message>
            <source>A longer step in time ends a pass.</source>
            <translation>时间间隔更长时，行程结束。</translation>
        </message>
        <message>
            <source>Distance of the antenna ahead of the control point (middle of the rear axle on the ground).</source>
            <translation>天线在控制点（后轴中点在地面上的位置）前方的距离。</translation>
        </message>
        <message>
            <source>Distance of the antenna to the left of the control point.</source>
            <translation>天线在控制点左侧的距离。</translation>
        </message>
        <message>
            <source>Height of the antenna above the control point. It counts where roll and pitch are known.</source>
            <translation>天线高出控制点的高度。仅在横滚和俯仰已知时起作用。</translation>
        </message>
        <message>
            <source>Heading that turns the lever arm: measured (two antennas or attitudes), course of the receiver, or direction of motion. auto: the first of these that a fix has.</source>
            <translation>用于旋转杆臂的航向：measured（双天线或姿态）、course（接收机航迹向）或 motion（运动方向）。auto：定位点所具有的第一种。</translation>
        </message>
        <message>
            <source>Angle by which the measured heading is turned clockwise from the vehicle's, as antennas mounted across it give.</source>
            <translation>测得的航向相对车辆航向顺时针偏转的角度，例如天线横向安装时。</translation>
        </message>
        <message>
            <source>Fix qualities that are used, as numbers of GGA sentences: 1 single, 2 differential, 4 RTK fixed, 5 RTK float.</source>
            <translation>采用的定位质量，即 GGA 语句中的数字：1 单点，2 差分，4 RTK 固定，5 RTK 浮动。</translation>
        </message>
        <message>
            <source>Standard deviation per axis of a fix. auto: as the receiver gives it, else by the fix quality, else 1 cm.</source>
            <translation>定位点每轴的标准差。auto：取接收机给出的值，否则按定位质量，否则为 1 厘米。</translation>
        </message>
        <message>
            <source>Standard deviation of the acceleration of the vehicle, m/s2. A larger value smooths less.</source>
            <translation>车辆加速度的标准差（m/s2）。值越大，平滑越少。</translation>
        </message>
        <message>
            <source>Distance from the prediction, in standard deviations, beyond which a fix is doubted.</source>
            <translation>与预测位置的距离超过此标准差倍数的定位点被怀疑。</translation>
        </message>
        <message>
            <source>Time for which doubted fixes are ignored. Then the filter starts again at the new position.</source>
            <translation>忽略被怀疑定位点的时间。此后滤波器在新位置重新开始。</translation>
        </message>
        <message>
            <source>The filter starts anew after a longer time without fixes.</source>
            <translation>无定位点的时间更长时，滤波器重新开始。</translation>
        </message>
        <message>
            <source>Width of the implement. none: only the line through A and B.</source>
            <translation>机具宽度。none：只有通过 A 和 B 的一条线。</translation>
        </message>
        <message>
            <source>Width that neighbouring passes share. Negative: a gap between them.</source>
            <translation>相邻行程共有的宽度。负值：两者之间留有间隙。</translation>
        </message>
        <message>
            <source>Lines to the left of A and B, where no boundary is given.</source>
            <translation>未给出边界时，A、B 线左侧的线数。</translation>
        </message>
        <message>
            <source>Lines to the right of A and B, where no boundary is given.</source>
            <translation>未给出边界时，A、B 线右侧的线数。</translation>
        </message>
        <message>
            <source>Width of the headland, in passes of the implement.</source>
            <translation>地头的宽度，以机具行程数计。</translation>
        </message>
        <message>
            <source>Shorter pieces of lines within a boundary are left out.</source>
            <translation>边界内更短的线段略去。</translation>
        </message>
        <message>
            <source>Write the map with all its columns: cloud.laz.</source>
            <translation>写出包含全部属性列的点云:cloud.laz。</translation>
        </message>
        <message>
            <source>laz: cloud.laz, compressed. las: cloud.las, for programs that do not read LAZ. copc: cloud.copc.laz, an octree of which programs load the part they show.</source>
            <translation>laz:cloud.laz,压缩格式。las:cloud.las,供不能读取 LAZ 的程序使用。copc:cloud.copc.laz,八叉树,程序只加载要显示的部分。</translation>
        </message>
        <message>
            <source>Distance from the walk that is accepted at the rim of the plot; three quarters of it between stretches of the walk. Farther places count as not walked when the rest of the plot was walked more closely.</source>
            <translation>样地边缘可接受的离行走路线的距离;行走路线之间为其四分之三。样地其余部分走得更密时,更远的地方算作没有走到。</translation>
        </message>
        <message>
            <source>SLAM system: loam (baseline), forest (LOAM improved for forest plots), lego_loam (ground-aware baseline), orchard (plant rows and foliage), best (elastic frames and a final trajectory adjustment, with the inertial unit where the recording has one), inertial (the same, and only with an inertial unit), or to the letter of a paper: loam_paper, forest_paper, lego_loam_orchard_paper.</source>
            <translation>SLAM 系统:LOAM(loam,基准)、森林(forest,针对森林样地改进的 LOAM)、LeGO-LOAM(lego_loam,顾及地面的基准)、果园(orchard,种植行和枝叶)、最佳(best,弹性帧和最终轨迹平差,记录中有惯性单元时一并使用)惯性(inertial,与最佳相同,但必须有惯性单元),或严格按照论文:loam_paper、forest_paper、lego_loam_orchard_paper。</translation>
        </message>
        <message>
            <source>Motion before registration: constant velocity, the frame matched as a whole against the last frame, or the motion within the frame matched point by point against the last frame, half way from constant velocity.</source>
            <translation>配准前的运动:匀速、将整帧与上一帧匹配,或将帧内运动逐点与上一帧匹配(自匀速运动起只取一半修正)。</translation>
        </message>
        <message>
            <source>Weight of a match: from the thickness of the surface and the range noise (thickness), from the covariances of the points by sensor and poses (priors), or without a robust kernel the same for all (equal) or with the covariance of every single point (conditions).</source>
            <translation>匹配的权:由表面厚度和测距噪声得出(thickness),由传感器和位姿给出的点协方差得出(priors);或不用稳健核,全部等权(equal)或采用每个点各自的协方差(conditions)。</translation>
        </message>
        <message>
            <source>All six unknowns from all features, or height, roll and pitch from planes and the rest from edges, always or only against the last frame (LeGO-LOAM; not with elastic frames).</source>
            <translation>由全部特征求六个未知数;或由平面求高程、横滚和俯仰,由线特征求其余,始终如此或仅在与上一帧匹配时如此(LeGO-LOAM;不能用于弹性帧)。</translation>
        </message>
        <message>
            <source>Sectors over which the distance of two scan contexts is the mean: those that both have, or all of them; a sector that one lacks then counts as different.</source>
            <translation>两个场景描述(scan context)的距离取哪些扇区的平均:双方都有的扇区,或全部扇区;后者中一方缺少的扇区视为不同。</translation>
        </message>
        <message>
            <source>Keyframes on each side of the earlier one that a loop closure is registered against. 0: that one alone.</source>
            <translation>回环配准时,较早关键帧两侧各取的关键帧数。0:只用该帧。</translation>
        </message>
        <message>
            <source>What makes a candidate a loop closure: points that agree at a place that the odometry allows (overlap), or similar scan contexts and near closest points (distance).</source>
            <translation>候选成为回环的条件:点云在里程计允许的位置上一致(overlap),或场景描述相似且最近点距离小(distance)。</translation>
        </message>
        <message>
            <source>Maximum distance between closest points (root mean square) of a loop closure that is accepted by distance.</source>
            <translation>按距离接受的回环,其最近点之间的最大距离(均方根)。</translation>
        </message>
        <message>
            <source>Largest difference between the frames of an edit and those of the loop closure that it means.</source>
            <translation>编辑所给的帧与所指回环的帧之间的最大差。</translation>
        </message>
        <message>
            <source>Point cloud to cut: LAS, LAZ or COPC files of one cloud, separated by commas.</source>
            <translation>要切分的点云:同一点云的 LAS、LAZ 或 COPC 文件,用逗号分隔。</translation>
        </message>
        <message>
            <source>Side of the core of a tile. Larger tiles repeat fewer points and take more memory.</source>
            <translation>分块核心区的边长。分块越大,重复的点越少,占用的内存越多。</translation>
        </message>
        <message>
            <source>Width of the strip around a core whose points belong to the tile too. It should be wider than a crown.</source>
            <translation>核心区周围同样属于该分块的带宽。应宽于树冠。</translation>
        </message>
        <message>
            <source>Shift of the grid of tiles to the east. Cores begin at multiples of tile plus this.</source>
            <translation>分块网格向东的平移。核心区从 tile 的整数倍加上此值处开始。</translation>
        </message>
        <message>
            <source>Shift of the grid of tiles to the north.</source>
            <translation>分块网格向北的平移。</translation>
        </message>
        <message>
            <source>Height above ground at which diameters are measured, noted in the tiles. auto: as the files say, else 1.3 m.</source>
            <translation>测量直径的离地高度,记入各分块。自动(auto):按文件所记,否则 1.3 m。</translation>
        </message>
        <message>
            <source>Raster to read: GeoTIFF with square cells, or a GDAL VRT of several (.vrt).</source>
            <translation>要读取的栅格:单元为正方形的 GeoTIFF,或由多个组成的 GDAL VRT(.vrt)。</translation>
        </message>
        <message>
            <source>Part to read: xmin,ymin,xmax,ymax in the coordinates of the file. Empty: all.</source>
            <translation>要读取的部分:文件坐标中的 xmin,ymin,xmax,ymax。留空:全部。</translation>
        </message>
        <message>
            <source>Core of the tile: xmin,ymin,xmax,ymax. Terrain and points outside of it are left to the tiles beside. Empty: everything.</source>
            <translation>分块的核心区:xmin,ymin,xmax,ymax。其外的地形和点归相邻分块。留空:全部。</translation>
        </message>
        <message>
            <source>Write the points with all their columns: cloud.laz.</source>
            <translation>写出带全部列的点:cloud.laz。</translation>
        </message>
        <message>
            <source>Standard deviation expected of the range offset, as in stems.measure; cloud: of the sensor, as the rows say. A larger value lets the stems say more.</source>
            <translation>预期的测距偏移标准差,与 stems.measure 相同;点云(cloud):按各行所给的传感器。值越大,树干自身的影响越大。</translation>
        </message>
        <message>
            <source>Where the camera flies: along the walk of the sensor, or through bookmarked views.</source>
            <translation>相机的飞行路线:沿传感器的行走路径,或经过书签视图。</translation>
        </message>
        <message>
            <source>File of bookmarked views that the window keeps beside a pipeline (plot.views.json).</source>
            <translation>窗口在流程旁保存的书签视图文件 (plot.views.json)。</translation>
        </message>
        <message>
            <source>Length of the film.</source>
            <translation>影片时长。</translation>
        </message>
        <message>
            <source>Frames for each second.</source>
            <translation>每秒帧数。</translation>
        </message>
        <message>
            <source>Width of a frame in pixels.</source>
            <translation>画面宽度(像素)。</translation>
        </message>
        <message>
            <source>Height of a frame in pixels.</source>
            <translation>画面高度(像素)。</translation>
        </message>
        <message>
            <source>What points are coloured by.</source>
            <translation>点的着色依据。</translation>
        </message>
        <message>
            <source>Size of a point in pixels of a frame 1080 pixels high.</source>
            <translation>点的大小,以 1080 像素高的画面中的像素计。</translation>
        </message>
        <message>
            <source>What the cloud beside the survey is coloured by: a column (intensity), z, photo, or one colour for all points (#rrggbb).</source>
            <translation>测量之外那幅点云的着色依据:一个字段(intensity)、z、photo,或所有点同一种颜色(#rrggbb)。</translation>
        </message>
        <message>
            <source>Opacity of the cloud beside the survey. 1: nothing shines through.</source>
            <translation>测量之外那幅点云的不透明度。1:完全不透明。</translation>
        </message>
        <message>
            <source>Picture of the place (orthophoto, scanned map) that is drawn below the survey: any raster with a place on the earth. The survey needs one too.</source>
            <translation>绘制在测量下方的当地图像(正射影像、扫描地图):任何带地理位置的栅格。测量也须有地理位置。</translation>
        </message>
        <message>
            <source>Opacity of the map.</source>
            <translation>地图的不透明度。</translation>
        </message>
        <message>
            <source>The map follows the ground below the points, else it is flat at the foot of the survey.</source>
            <translation>地图随点下方的地面起伏,否则为测量底部的平面。</translation>
        </message>
        <message>
            <source>Draw the ground below the points as a surface with contour lines. Over a map that follows it, the contour lines alone.</source>
            <translation>将点下方的地面画成带等高线的曲面。在随地面起伏的地图上只画等高线。</translation>
        </message>
        <message>
            <source>Draw the fitted stems.</source>
            <translation>绘制拟合的树干。</translation>
        </message>
        <message>
            <source>Draw the path of the sensor.</source>
            <translation>绘制传感器的路径。</translation>
        </message>
        <message>
            <source>Draw on a dark ground.</source>
            <translation>使用深色背景。</translation>
        </message>
        <message>
            <source>Height of the camera above the path of the sensor.</source>
            <translation>相机高于传感器路径的距离。</translation>
        </message>
        <message>
            <source>Distance along the walk at which the camera looks. A larger value turns more gently.</source>
            <translation>相机沿路径前视的距离。数值越大,转向越平缓。</translation>
        </message>
        <message>
            <source>Make a video of the frames where the program ffmpeg is installed: flythrough.mp4.</source>
            <translation>装有 ffmpeg 程序时由各帧生成视频:flythrough.mp4。</translation>
        </message>
</context>
    <context>
        <name>formats</name>
        <message>
            <source>folder of a ROS 2 bag</source>
            <translation>ROS 2 bag 文件夹</translation>
        </message>
        <message>
            <source>folder of frames</source>
            <translation>帧文件夹</translation>
        </message>
        <message>
            <source>columns</source>
            <translation>数字列</translation>
        </message>
        <message>
            <source>Images</source>
            <translation>仅有图片</translation>
        </message>
        <message>
            <source>ICL or Open3D</source>
            <translation>ICL 或 Open3D</translation>
        </message>
        <message>
            <source>Livox, .lvx and .lvx2</source>
            <translation>Livox,.lvx 与 .lvx2</translation>
        </message>
        <message>
            <source>with the JSON file of the sensor</source>
            <translation>附带传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>PandarXT-32, Pandar40P</source>
            <translation>PandarXT-32、Pandar40P</translation>
        </message>
        <message>
            <source>with a header line</source>
            <translation>带表头行</translation>
        </message>
        <message>
            <source>log of a receiver</source>
            <translation>接收机日志</translation>
        </message>
        <message>
            <source>of numbers, without names</source>
            <translation>没有列名</translation>
        </message>
        <message>
            <source>binary, longitude and latitude</source>
            <translation>二进制,经纬度</translation>
        </message>
        <message>
            <source>columns with a header line: GeoSLAM, HDMapping, CSV</source>
            <translation>带表头行的列:GeoSLAM、HDMapping、CSV</translation>
        </message>
        <message>
            <source>12 numbers per pose</source>
            <translation>每个位姿 12 个数字</translation>
        </message>
        <message>
            <source>color/, depth/, camera.json</source>
            <translation>color/、depth/、camera.json</translation>
        </message>
        <message>
            <source>rgb.txt, depth.txt, groundtruth.txt</source>
            <translation>rgb.txt、depth.txt、groundtruth.txt</translation>
        </message>
        <message>
            <source>color/, depth/, trajectory.log or pose.txt</source>
            <translation>color/、depth/、trajectory.log 或 pose.txt</translation>
        </message>
        <message>
            <source>frame-000000.color.png, .depth.png, .pose.txt</source>
            <translation>frame-000000.color.png、.depth.png、.pose.txt</translation>
        </message>
        <message>
            <source>color/, depth/, pose/, intrinsic/</source>
            <translation>color/、depth/、pose/、intrinsic/</translation>
        </message>
        <message>
            <source>NAME_Color_TIME.png, NAME_Depth_TIME.png</source>
            <translation>NAME_Color_TIME.png、NAME_Depth_TIME.png</translation>
        </message>
        <message>
            <source>cameras and images, .bin or .txt</source>
            <translation>cameras 和 images,.bin 或 .txt</translation>
        </message>
        <message>
            <source>images/, metadata/images/</source>
            <translation>images/、metadata/images/</translation>
        </message>
        <message>
            <source>pictures and camera.json</source>
            <translation>图片和 camera.json</translation>
        </message>
</context>
    <context>
        <name>choices</name>
        <message>
            <source>bark</source>
            <translation>按树皮</translation>
        </message>
        <message>
            <source>standing</source>
            <translation>直立物体</translation>
        </message>
        <message>
            <source>common</source>
            <translation>共同可见</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>occlusion</comment>
            <translation>不舍去</translation>
        </message>
        <message>
            <source>none</source>
            <comment>deskew</comment>
            <translation>不校正</translation>
        </message>
        <message>
            <source>none</source>
            <comment>loops</comment>
            <translation>不查找</translation>
        </message>
        <message>
            <source>none</source>
            <comment>level</comment>
            <translation>不调平</translation>
        </message>
        <message>
            <source>none</source>
            <comment>align_stems</comment>
            <translation>不移动</translation>
        </message>
        <message>
            <source>none</source>
            <comment>align_trajectory</comment>
            <translation>不移动</translation>
        </message>
        <message>
            <source>none</source>
            <comment>shape</comment>
            <translation>无边界</translation>
        </message>
        <message>
            <source>shift</source>
            <translation>平移</translation>
        </message>
        <message>
            <source>rigid</source>
            <translation>平移加旋转</translation>
        </message>
        <message>
            <source>search</source>
            <translation>全面搜索</translation>
        </message>
        <message>
            <source>se3</source>
            <translation>刚体运动 (se3)</translation>
        </message>
        <message>
            <source>1</source>
            <translation>样地 1</translation>
        </message>
        <message>
            <source>2</source>
            <translation>样地 2</translation>
        </message>
        <message>
            <source>3</source>
            <translation>样地 3</translation>
        </message>
        <message>
            <source>4</source>
            <translation>样地 4</translation>
        </message>
        <message>
            <source>overall</source>
            <translation>总体</translation>
        </message>
        <message>
            <source>to_plane</source>
            <translation>到平面坐标</translation>
        </message>
        <message>
            <source>to_geodetic</source>
            <translation>到经纬度</translation>
        </message>
        <message>
            <source>gauss_krueger_3</source>
            <translation>高斯-克吕格 3 度带</translation>
        </message>
        <message>
            <source>gauss_krueger_6</source>
            <translation>高斯-克吕格 6 度带</translation>
        </message>
        <message>
            <source>utm</source>
            <translation>UTM</translation>
        </message>
        <message>
            <source>transverse_mercator</source>
            <translation>横轴墨卡托</translation>
        </message>
        <message>
            <source>GRS80</source>
            <translation>GRS80</translation>
        </message>
        <message>
            <source>WGS84</source>
            <translation>WGS84</translation>
        </message>
        <message>
            <source>CGCS2000</source>
            <translation>CGCS2000</translation>
        </message>
        <message>
            <source>Airy1830</source>
            <translation>艾里 1830</translation>
        </message>
        <message>
            <source>Bessel1841</source>
            <translation>贝塞尔 1841</translation>
        </message>
        <message>
            <source>International1924</source>
            <translation>国际 1924</translation>
        </message>
        <message>
            <source>Krassovsky1940</source>
            <translation>克拉索夫斯基 1940</translation>
        </message>
        <message>
            <source>tin</source>
            <translation>三角网</translation>
        </message>
        <message>
            <source>lowest</source>
            <translation>最低点</translation>
        </message>
        <message>
            <source>normalised</source>
            <translation>已归一化</translation>
        </message>
        <message>
            <source>metre</source>
            <translation>米</translation>
        </message>
        <message>
            <source>centimetre</source>
            <translation>厘米</translation>
        </message>
        <message>
            <source>millimetre</source>
            <translation>毫米</translation>
        </message>
        <message>
            <source>foot</source>
            <translation>英尺</translation>
        </message>
        <message>
            <source>us_survey_foot</source>
            <translation>美国测量英尺</translation>
        </message>
        <message>
            <source>z</source>
            <translation>z</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>未知</translation>
        </message>
        <message>
            <source>sensor</source>
            <translation>传感器</translation>
        </message>
        <message>
            <source>map</source>
            <translation>地图</translation>
        </message>
        <message>
            <source>plot</source>
            <translation>样地</translation>
        </message>
        <message>
            <source>global</source>
            <translation>投影坐标</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>blank</source>
            <translation>空格</translation>
        </message>
        <message>
            <source>comma</source>
            <translation>逗号</translation>
        </message>
        <message>
            <source>semicolon</source>
            <translation>分号</translation>
        </message>
        <message>
            <source>tab</source>
            <translation>制表符</translation>
        </message>
        <message>
            <source>nmea</source>
            <translation>NMEA</translation>
        </message>
        <message>
            <source>csv</source>
            <translation>CSV</translation>
        </message>
        <message>
            <source>columns</source>
            <translation>数字列</translation>
        </message>
        <message>
            <source>tum</source>
            <translation>TUM</translation>
        </message>
        <message>
            <source>kitti</source>
            <translation>KITTI</translation>
        </message>
        <message>
            <source>osmesa</source>
            <translation>OSMesa</translation>
        </message>
        <message>
            <source>egl</source>
            <translation>EGL</translation>
        </message>
        <message>
            <source>glx</source>
            <translation>GLX</translation>
        </message>
        <message>
            <source>least_squares</source>
            <translation>普通最小二乘</translation>
        </message>
        <message>
            <source>orthogonal</source>
            <translation>正交</translation>
        </message>
        <message>
            <source>straight</source>
            <translation>直线</translation>
        </message>
        <message>
            <source>mean</source>
            <translation>平均值</translation>
        </message>
        <message>
            <source>face</source>
            <translation>轴心</translation>
        </message>
        <message>
            <source>loam</source>
            <translation>LOAM</translation>
        </message>
        <message>
            <source>forest</source>
            <translation>森林</translation>
        </message>
        <message>
            <source>lego_loam</source>
            <translation>LeGO-LOAM</translation>
        </message>
        <message>
            <source>orchard</source>
            <translation>果园</translation>
        </message>
        <message>
            <source>best</source>
            <translation>最佳</translation>
        </message>
        <message>
            <source>preset</source>
            <translation>按预设</translation>
        </message>
        <message>
            <source>curvature</source>
            <translation>曲率</translation>
        </message>
        <message>
            <source>connected</source>
            <translation>连通表面</translation>
        </message>
        <message>
            <source>ground</source>
            <translation>地面</translation>
        </message>
        <message>
            <source>ground</source>
            <comment>features</comment>
            <translation>地面与物体</translation>
        </message>
        <message>
            <source>sampled</source>
            <translation>格网抽稀</translation>
        </message>
        <message>
            <source>far_side</source>
            <translation>远侧</translation>
        </message>
        <message>
            <source>both_sides</source>
            <translation>两侧</translation>
        </message>
        <message>
            <source>velocity</source>
            <translation>匀速</translation>
        </message>
        <message>
            <source>last_frame</source>
            <translation>与上一帧匹配</translation>
        </message>
        <message>
            <source>once</source>
            <translation>一次</translation>
        </message>
        <message>
            <source>twice</source>
            <translation>两次</translation>
        </message>
        <message>
            <source>elastic</source>
            <translation>弹性</translation>
        </message>
        <message>
            <source>nearest</source>
            <translation>最近</translation>
        </message>
        <message>
            <source>last</source>
            <translation>最后</translation>
        </message>
        <message>
            <source>odometry</source>
            <translation>里程计</translation>
        </message>
        <message>
            <source>context</source>
            <translation>周围环境</translation>
        </message>
        <message>
            <source>both</source>
            <translation>两者</translation>
        </message>
        <message>
            <source>single</source>
            <translation>单个最相似</translation>
        </message>
        <message>
            <source>placed</source>
            <translation>拟合最好</translation>
        </message>
        <message>
            <source>sequence</source>
            <translation>序列</translation>
        </message>
        <message>
            <source>features</source>
            <translation>边缘和平面</translation>
        </message>
        <message>
            <source>icp</source>
            <translation>ICP</translation>
        </message>
        <message>
            <source>ndt_icp</source>
            <translation>NDT 加 ICP</translation>
        </message>
        <message>
            <source>thickness</source>
            <translation>表面厚度</translation>
        </message>
        <message>
            <source>priors</source>
            <translation>先验协方差</translation>
        </message>
        <message>
            <source>joint</source>
            <translation>联合</translation>
        </message>
        <message>
            <source>two_step</source>
            <translation>分两步</translation>
        </message>
        <message>
            <source>uphill</source>
            <translation>坡上侧</translation>
        </message>
        <message>
            <source>ray</source>
            <translation>射线</translation>
        </message>
        <message>
            <source>surface</source>
            <translation>表面</translation>
        </message>
        <message>
            <source>stems</source>
            <translation>单木</translation>
        </message>
        <message>
            <source>rectangle</source>
            <translation>矩形</translation>
        </message>
        <message>
            <source>circle</source>
            <translation>圆</translation>
        </message>
        <message>
            <source>polygon</source>
            <translation>多边形</translation>
        </message>
        <message>
            <source>cloud</source>
            <translation>按点云</translation>
        </message>
        <message>
            <source>log</source>
            <translation>按日志</translation>
        </message>
        <message>
            <source>published</source>
            <translation>已发表</translation>
        </message>
        <message>
            <source>page</source>
            <translation>仅页面</translation>
        </message>
        <message>
            <source>all</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>inertial</source>
            <translation>惯性</translation>
        </message>
        <message>
            <source>required</source>
            <translation>必须</translation>
        </message>
        <message>
            <source>off</source>
            <translation>不用</translation>
        </message>
        <message>
            <source>named</source>
            <translation>带列名的文本</translation>
        </message>
        <message>
            <source>sbet</source>
            <translation>SBET</translation>
        </message>
        <message>
            <source>given</source>
            <comment>scan_positions</comment>
            <translation>采用</translation>
        </message>
        <message>
            <source>none</source>
            <comment>scan_positions</comment>
            <translation>不采用</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>layout</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>bole</source>
            <comment>layout</comment>
            <translation>Bole</translation>
        </message>
        <message>
            <source>tum</source>
            <comment>layout</comment>
            <translation>TUM</translation>
        </message>
        <message>
            <source>icl</source>
            <comment>layout</comment>
            <translation>ICL 或 Open3D</translation>
        </message>
        <message>
            <source>7scenes</source>
            <comment>layout</comment>
            <translation>7-Scenes</translation>
        </message>
        <message>
            <source>scannet</source>
            <comment>layout</comment>
            <translation>ScanNet</translation>
        </message>
        <message>
            <source>realsense</source>
            <comment>layout</comment>
            <translation>RealSense</translation>
        </message>
        <message>
            <source>nerf</source>
            <comment>layout</comment>
            <translation>NeRF</translation>
        </message>
        <message>
            <source>colmap</source>
            <comment>layout</comment>
            <translation>COLMAP</translation>
        </message>
        <message>
            <source>romi</source>
            <comment>layout</comment>
            <translation>ROMI</translation>
        </message>
        <message>
            <source>images</source>
            <comment>layout</comment>
            <translation>仅有图片</translation>
        </message>
        <message>
            <source>all</source>
            <comment>max_views</comment>
            <translation>全部</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>depth_scale</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>none</source>
            <comment>max_depth</comment>
            <translation>不限</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>board</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>charuco</source>
            <comment>board</comment>
            <translation>ChArUco 板</translation>
        </message>
        <message>
            <source>chessboard</source>
            <comment>board</comment>
            <translation>棋盘格</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>distortion</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>none</source>
            <comment>distortion</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>k1</source>
            <comment>distortion</comment>
            <translation>k1</translation>
        </message>
        <message>
            <source>k1_k2</source>
            <comment>distortion</comment>
            <translation>k1_k2</translation>
        </message>
        <message>
            <source>k1_k2_p1_p2</source>
            <comment>distortion</comment>
            <translation>k1_k2_p1_p2</translation>
        </message>
        <message>
            <source>all</source>
            <comment>distortion</comment>
            <translation>全部</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>width</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>height</comment>
            <translation>自动</translation>
        </message>
            <message>
            <source>slam</source>
            <comment>source</comment>
            <translation>SLAM</translation>
        </message>
        <message>
            <source>sift</source>
            <comment>features</comment>
            <translation>SIFT</translation>
        </message>
        <message>
            <source>orb</source>
            <comment>features</comment>
            <translation>ORB</translation>
        </message>
        <message>
            <source>yes</source>
            <comment>turntable</comment>
            <translation>是</translation>
        </message>
        <message>
            <source>no</source>
            <comment>turntable</comment>
            <translation>否</translation>
        </message>
        <message>
            <source>grid</source>
            <comment>encoder</comment>
            <translation>体素格网</translation>
        </message>
        <message>
            <source>hash</source>
            <comment>encoder</comment>
            <translation>哈希表</translation>
        </message>
        <message>
            <source>paper</source>
            <comment>encoder</comment>
            <translation>网络（论文）</translation>
        </message>
        <message>
            <source>scene</source>
            <comment>background</comment>
            <translation>场景</translation>
        </message>
        <message>
            <source>white</source>
            <comment>background</comment>
            <translation>白色</translation>
        </message>
        <message>
            <source>black</source>
            <comment>background</comment>
            <translation>黑色</translation>
        </message>
        <message>
            <source>-y</source>
            <comment>up</comment>
            <translation>-y</translation>
        </message>
        <message>
            <source>metres</source>
            <comment>scale</comment>
            <translation>米</translation>
        </message>
        <message>
            <source>contours</source>
            <comment>stem</comment>
            <translation>图像轮廓</translation>
        </message>
        <message>
            <source>srgb</source>
            <comment>light</comment>
            <translation>sRGB</translation>
        </message>
        <message>
            <source>linear</source>
            <comment>light</comment>
            <translation>线性</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>control_sd</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>height_sd</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>scale</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>one</source>
            <comment>scale</comment>
            <translation>1</translation>
        </message>
        <message>
            <source>grid</source>
            <comment>scale</comment>
            <translation>格网</translation>
        </message>
        <message>
            <source>target</source>
            <comment>height_of</comment>
            <translation>标靶</translation>
        </message>
        <message>
            <source>ground</source>
            <comment>height_of</comment>
            <translation>地面</translation>
        </message>
        <message>
            <source>grid</source>
            <comment>bearing_kind</comment>
            <translation>格网北</translation>
        </message>
        <message>
            <source>magnetic</source>
            <comment>bearing_kind</comment>
            <translation>磁北</translation>
        </message>
        <message>
            <source>true</source>
            <comment>bearing_kind</comment>
            <translation>真北</translation>
        </message>
        <message>
            <source>none</source>
            <comment>easting</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>northing</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>latitude</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>longitude</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>height</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>bearing</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>none</source>
            <comment>declination</comment>
            <translation>无</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>clock_offset</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>auto</source>
            <comment>track_sd</comment>
            <translation>自动</translation>
        </message>
        <message>
            <source>centre</source>
            <translation>中心</translation>
        </message>
        <message>
            <source>base</source>
            <translation>树基</translation>
        </message>
        <message>
            <source>whole</source>
            <translation>整个树干</translation>
        </message>
        <message>
            <source>any_part</source>
            <translation>任一部分</translation>
        </message>
        <message>
            <source>half</source>
            <translation>半边</translation>
        </message>
        <message>
            <source>same</source>
            <comment>axes</comment>
            <translation>相同</translation>
        </message>
        <message>
            <source>improved_loam</source>
            <translation>改进的 LOAM</translation>
        </message>
        <message>
            <source>,</source>
            <translation>,</translation>
        </message>
        <message>
            <source>vectors</source>
            <translation>向量</translation>
        </message>
        <message>
            <source>ranges</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>实测</translation>
        </message>
        <message>
            <source>course</source>
            <translation>航迹向</translation>
        </message>
        <message>
            <source>motion</source>
            <translation>运动方向</translation>
        </message>
        <message>
            <source>loam_paper</source>
            <translation>LOAM(论文)</translation>
        </message>
        <message>
            <source>forest_paper</source>
            <translation>森林(论文)</translation>
        </message>
        <message>
            <source>lego_loam_orchard_paper</source>
            <translation>LeGO-LOAM 果园(论文)</translation>
        </message>
        <message>
            <source>matched_motion</source>
            <translation>帧内运动匹配</translation>
        </message>
        <message>
            <source>shared_sectors</source>
            <translation>共有扇区</translation>
        </message>
        <message>
            <source>all_sectors</source>
            <translation>全部扇区</translation>
        </message>
        <message>
            <source>overlap</source>
            <translation>重叠</translation>
        </message>
        <message>
            <source>distance</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>equal</source>
            <translation>等权</translation>
        </message>
        <message>
            <source>conditions</source>
            <translation>条件方程</translation>
        </message>
        <message>
            <source>two_step_guess</source>
            <translation>仅初始估计分两步</translation>
        </message>
        <message>
            <source>laz</source>
            <translation>LAZ</translation>
        </message>
        <message>
            <source>las</source>
            <translation>LAS</translation>
        </message>
        <message>
            <source>copc</source>
            <translation>COPC</translation>
        </message>
        <message>
            <source>gravity</source>
            <translation>重力</translation>
        </message>
        <message>
            <source>walk</source>
            <comment>course</comment>
            <translation>行走路径</translation>
        </message>
        <message>
            <source>views</source>
            <comment>course</comment>
            <translation>书签视图</translation>
        </message>
        <message>
            <source>height</source>
            <comment>color</comment>
            <translation>高度</translation>
        </message>
        <message>
            <source>intensity</source>
            <comment>color</comment>
            <translation>强度</translation>
        </message>
        <message>
            <source>tree</source>
            <comment>color</comment>
            <translation>单木</translation>
        </message>
        <message>
            <source>plain</source>
            <comment>color</comment>
            <translation>单色</translation>
        </message>
</context>
</TS>
